// What the subcommands do. Each throws Failure, and then has written nothing; but RunBench leaves
// what it had measured by then, to go on from.
#ifndef vtkshadows_Jobs_h
#define vtkshadows_Jobs_h

#include "Options.h"

namespace vtkshadows
{

class Progress;

void RunRender(const Options& options, Progress& progress);
void RunCompare(const Options& options, Progress& progress);
void RunBench(const Options& options, Progress& progress);

}

#endif
