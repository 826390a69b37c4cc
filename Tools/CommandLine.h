// The command line, by CLI11, to Options.
#ifndef vtkshadows_CommandLine_h
#define vtkshadows_CommandLine_h

#include "Options.h"

namespace vtkshadows
{

enum class Job
{
  Nothing, // help or version was printed
  Render,
  Compare,
  Bench
};

struct CommandLine
{
  Job job = Job::Nothing;
  Options options;
};

// Throws UsageError for what CLI11 refuses, Failure for values that make no sense.
CommandLine ParseCommandLine(int argc, char** argv);

// A command line that cannot be read; its message has the remedy.
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

}

#endif
