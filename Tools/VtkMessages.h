// Collects what VTK would print, so that the command can say it in one line.
#ifndef vtkshadows_VtkMessages_h
#define vtkshadows_VtkMessages_h

#include <string>
#include <vector>

namespace vtkshadows
{

// From here on VTK prints nothing; call once.
void CollectVtkMessages();

// The first error since the last call, in one line without VTK's file and line; empty if none.
std::string TakeVtkError();

// The warnings since the last call, each in one line, each once.
std::vector<std::string> TakeVtkWarnings();

}

#endif
