#include "Progress.h"

#include <cstdio>
#include <iostream>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace vtkshadows
{
namespace
{

bool StderrIsTerminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(STDERR_FILENO) != 0;
#endif
}

}

Progress::Progress(bool isQuiet)
  : quiet(isQuiet)
  , terminal(StderrIsTerminal())
{
}

Progress::~Progress()
{
  this->End();
}

void Progress::Begin(const std::string& nextStep)
{
  this->End();
  this->step = nextStep;
  this->lastShown = Clock::now();
  if (this->terminal)
  {
    this->Show(this->step);
  }
}

void Progress::Update(double fraction)
{
  const auto patience =
    this->terminal ? std::chrono::milliseconds(100) : std::chrono::milliseconds(5000);
  if (this->step.empty() || Clock::now() - this->lastShown < patience)
  {
    return;
  }
  this->Show(this->step + ", " + std::to_string(static_cast<int>(100.0 * fraction)) + " %");
  this->lastShown = Clock::now();
}

void Progress::End()
{
  if (this->terminal && !this->quiet && !this->step.empty())
  {
    std::cerr << "\r\033[K" << std::flush;
  }
  this->step.clear();
}

void Progress::Note(const std::string& text)
{
  if (!this->quiet)
  {
    std::cerr << (this->terminal ? "\r\033[K" : "") << "vtkshadows: " << text << std::endl;
  }
}

void Progress::Show(const std::string& text)
{
  if (!this->quiet)
  {
    std::cerr << (this->terminal ? "\r\033[K" : "") << "vtkshadows: " << text
              << (this->terminal ? "" : "\n") << std::flush;
  }
}

}
