#include "VtkMessages.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <mutex>
#include <regex>
#include <utility>

namespace vtkshadows
{
namespace
{

constexpr std::size_t LongestMessage = 240;

// "ERROR: In file.cxx, line 12\nvtkClass (0x55d0): the message\n\n" to "the message". Bytes of a
// damaged file may be in it: what is not ASCII becomes '?'. The pipeline's own complaint, a dump of
// its request, says nothing more than that there was an error.
std::string OneLine(const std::string& text)
{
  static const std::regex place(
    R"(^\s*((Generic )?Warning|ERROR|WARNING|Error|GENERIC WARNING): In [^\n]*, line \d+\n)");
  static const std::regex object(R"(^\s*\w+ \((0x)?[0-9a-fA-F]+\): )");
  static const std::regex blanks(R"(\s+)");
  std::string line = std::regex_replace(text, place, "");
  line = std::regex_replace(line, object, "");
  line = std::regex_replace(line, blanks, " ");
  line.erase(0, line.find_first_not_of(' '));
  line.erase(line.find_last_not_of(" .;") + 1);
  std::replace_if(
    line.begin(), line.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  if (line.size() > LongestMessage)
  {
    line = line.substr(0, LongestMessage) + "...";
  }
  return line.compare(0, 10, "Algorithm ") == 0 ? "error without a message" : line;
}

// VTK's threads may report at once, so every access is locked.
struct Collected
{
  std::mutex mutex;
  std::string firstError;
  std::vector<std::string> warnings;
};

Collected& Messages()
{
  static Collected messages;
  return messages;
}

class CollectingWindow : public vtkOutputWindow
{
public:
  static CollectingWindow* New();
  vtkTypeMacro(CollectingWindow, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    const std::lock_guard<std::mutex> lock(Messages().mutex);
    if (Messages().firstError.empty())
    {
      Messages().firstError = OneLine(text);
    }
  }
  void DisplayWarningText(const char* text) override { this->AddWarning(text); }
  void DisplayGenericWarningText(const char* text) override { this->AddWarning(text); }

private:
  void AddWarning(const char* text)
  {
    const std::string line = OneLine(text);
    const std::lock_guard<std::mutex> lock(Messages().mutex);
    std::vector<std::string>& warnings = Messages().warnings;
    if (std::find(warnings.begin(), warnings.end(), line) == warnings.end())
    {
      warnings.push_back(line);
    }
  }
};
vtkStandardNewMacro(CollectingWindow);

}

void CollectVtkMessages()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(vtkSmartPointer<CollectingWindow>::New());
}

std::string TakeVtkError()
{
  const std::lock_guard<std::mutex> lock(Messages().mutex);
  return std::exchange(Messages().firstError, {});
}

std::vector<std::string> TakeVtkWarnings()
{
  const std::lock_guard<std::mutex> lock(Messages().mutex);
  return std::exchange(Messages().warnings, {});
}

}
