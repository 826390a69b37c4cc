// What render and compare begin with.
#ifndef vtkshadows_SharedSteps_h
#define vtkshadows_SharedSteps_h

#include "Options.h"

#include <memory>

namespace vtkshadows
{

class Progress;

// The meshes loaded and on a stage, with a display to draw on.
std::unique_ptr<Stage> PrepareStage(const Options& options, Progress& progress);

// VTK's warnings since the last call, each a note to the user.
void NoteVtkWarnings(Progress& progress);

// The note of a build without the truth to measure against.
void NoteNoErrors(Progress& progress);

}

#endif
