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

// What errors that are measured cannot tell, if anything, as a note; or that there are none.
void NoteLimitsOfErrors(Stage& stage, Progress& progress);

}

#endif
