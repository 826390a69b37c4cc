// vtkshadows: pictures of meshes with shadows, and how far each technique is from the truth.
// Exit status: 0 done, 1 failed, 2 the command line cannot be read.
#include "CommandLine.h"
#include "Jobs.h"
#include "Progress.h"
#include "VtkMessages.h"

#include <exception>
#include <iostream>

namespace
{

void Run(const vtkshadows::CommandLine& commandLine)
{
  vtkshadows::Progress progress(commandLine.options.quiet);
  switch (commandLine.job)
  {
    case vtkshadows::Job::Nothing:
      return;
    case vtkshadows::Job::Render:
      return vtkshadows::RunRender(commandLine.options, progress);
    case vtkshadows::Job::Compare:
      return vtkshadows::RunCompare(commandLine.options, progress);
    case vtkshadows::Job::Bench:
      return vtkshadows::RunBench(commandLine.options, progress);
  }
}

}

int main(int argc, char** argv)
{
  vtkshadows::CollectVtkMessages();
  try
  {
    Run(vtkshadows::ParseCommandLine(argc, argv));
    return 0;
  }
  catch (const vtkshadows::UsageError& error)
  {
    std::cerr << "vtkshadows: " << error.what() << std::endl;
    return 2;
  }
  catch (const std::bad_alloc&)
  {
    std::cerr << "vtkshadows: memory: is used up; make the window or the meshes smaller"
              << std::endl;
  }
  catch (const std::exception& error)
  {
    std::cerr << "vtkshadows: " << error.what() << std::endl;
  }
  return 1;
}
