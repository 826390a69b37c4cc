// The extremes, case by case and technique by technique, as a table in Markdown:
//   xvfb-run -a build/bin/vtkshadows_extremes_table [--heavy] [--pictures FOLDER] [--kind TEXT]
//     [--technique NAME] [--json FILE]
//
// `--json FILE` writes the same figures for programs: an array with one object a case and
// technique, case by case in the order of the table, techniques in the order of its columns. Their
// names are in Scenes/ExtremeFigures.h. The file is written anew after each case, so that it is
// whole if the run is ended early.
#include "ExtremeFigures.h"
#include "VtkMessages.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace vtkshadows;

namespace
{

struct Options
{
  bool heavy = false;
  std::string pictures;
  std::string kind;      // only cases with this in their name
  std::string technique; // only this one
  std::string json;      // a file for the figures
  bool isWrong = false;
};

Options Parse(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    std::string* text = argument == "--pictures" ? &options.pictures
      : argument == "--kind"                     ? &options.kind
      : argument == "--technique"                ? &options.technique
      : argument == "--json"                     ? &options.json
                                                 : nullptr;
    if (argument == "--heavy")
    {
      options.heavy = true;
    }
    else if (text && i + 1 < argc)
    {
      *text = argv[++i];
    }
    else
    {
      std::fprintf(stderr,
        "\"%s\" is no option, or has no value: --heavy, --pictures FOLDER, --kind TEXT, "
        "--technique NAME or --json FILE.\n",
        argument.c_str());
      options.isWrong = true;
    }
  }
  return options;
}

std::vector<std::string> TakeMessages()
{
  std::vector<std::string> messages = TakeVtkWarnings();
  const std::string error = TakeVtkError();
  if (!error.empty())
  {
    messages.push_back(error);
  }
  return messages;
}

// "99.999 / 0.012 / 3": agreement with the plain picture, mismatch, gross pixels.
std::string Cell(const ExtremeOutcome& outcome)
{
  if (!outcome.made)
  {
    return "none";
  }
  if (outcome.receivers == 0 && outcome.agreement < 0.0)
  {
    return outcome.openGLError ? "OpenGL error" : "drawn";
  }
  char text[96];
  char* end = text;
  if (outcome.agreement >= 0.0)
  {
    end += std::snprintf(text, sizeof text, "%.3f / ", outcome.agreement);
  }
  std::snprintf(end, sizeof text - static_cast<std::size_t>(end - text), "%.3f / %lld%s",
    outcome.MismatchPercent(), static_cast<long long>(outcome.gross),
    outcome.openGLError ? ", OpenGL error" : "");
  return text;
}

std::string Share(double percent)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", percent);
  return percent < 0.0 ? "" : text;
}

void WriteJson(const nlohmann::ordered_json& list, const std::string& file)
{
  std::ofstream out(file);
  out << list.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
  if (!out.flush())
  {
    throw std::runtime_error(
      "--json \"" + file + "\" cannot be written; name a file in a folder that is there");
  }
}

void Print(const Options& options)
{
  std::vector<std::string> techniques = ExtremeTechniques();
  if (!options.technique.empty())
  {
    techniques = { options.technique };
  }
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  ExtremeMeasure measure(window);
  measure.Pictures = options.pictures;

  std::printf(
    "| case | VTK's frame, unlike % | truth, alike % | receivers, in shadow, uncertain |");
  std::string line = "|---|---|---|---|";
  for (const std::string& technique : techniques)
  {
    std::printf(" %s |", technique.c_str());
    line += "---|";
  }
  std::printf("\n%s\n", line.c_str());
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  if (!options.json.empty())
  {
    WriteJson(list, options.json); // a wrong name is told before the hours, not after
  }
  for (const ExtremeCase& extreme : ExtremeCases())
  {
    if ((extreme.isHeavy && !options.heavy) ||
      extreme.Name().find(options.kind) == std::string::npos)
    {
      continue;
    }
    const double unlike = measure.UnshadowedDifference(extreme);
    std::vector<std::string> said;
    for (const std::string& message : TakeMessages())
    {
      said.push_back("VTK: " + message);
    }
    std::string cells;
    ExtremeOutcome last;
    for (const std::string& technique : techniques)
    {
      last = measure.Measure(extreme, technique);
      cells += " " + Cell(last) + " |";
      const std::vector<std::string> messages = TakeMessages();
      for (const std::string& message : messages)
      {
        said.push_back(technique + ": " + message);
      }
      list.push_back(ExtremeFigures(extreme, technique, unlike, last, messages));
    }
    if (!options.json.empty())
    {
      WriteJson(list, options.json);
    }
    std::printf("| %s | %s | %s | %lld, %lld, %lld |%s\n", extreme.Name().c_str(),
      Share(unlike).c_str(), Share(last.truthAgreement).c_str(),
      static_cast<long long>(last.receivers), static_cast<long long>(last.shadowed),
      static_cast<long long>(last.uncertain), cells.c_str());
    std::fflush(stdout);
    for (const std::string& message : said)
    {
      std::fprintf(stderr, "%s: %s\n", extreme.Name().c_str(), message.c_str());
    }
  }
}

}

//------------------------------------------------------------------------------
int main(int argc, char** argv)
{
  const Options options = Parse(argc, argv);
  if (options.isWrong)
  {
    return 2;
  }
  CollectVtkMessages();
  try
  {
    Print(options);
  }
  catch (const std::exception& e)
  {
    std::fprintf(stderr, "The table ends here: %s.\n", e.what());
    return 1;
  }
  return 0;
}
