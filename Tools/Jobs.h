// What the subcommands do. Each throws Failure, and then has written nothing.
#ifndef vtkshadows_Jobs_h
#define vtkshadows_Jobs_h

#include "Options.h"

namespace vtkshadows
{

class Progress;

void RunRender(const Options& options, Progress& progress);
void RunCompare(const Options& options, Progress& progress);

}

#endif
