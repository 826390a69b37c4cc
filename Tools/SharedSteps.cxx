#include "SharedSteps.h"

#include "Display.h"
#include "Measurement.h"
#include "Progress.h"
#include "VtkMessages.h"

namespace vtkshadows
{

std::unique_ptr<Stage> PrepareStage(const Options& options, Progress& progress)
{
  const std::vector<Mesh> meshes = LoadMeshes(options.inputs, options.isovalue, progress);
  const bool ownDisplay = ProvideDisplay();
  auto stage = std::make_unique<Stage>(meshes, options.stage);
  if (ownDisplay)
  {
    progress.Note("there is no X display: rendering on an Xvfb of its own");
  }
  NoteVtkWarnings(progress);
  return stage;
}

void NoteVtkWarnings(Progress& progress)
{
  for (const std::string& warning : TakeVtkWarnings())
  {
    progress.Note("note: " + warning);
  }
}

void NoteLimitsOfErrors(Stage& stage, Progress& progress)
{
  const int how = stage.Shadows()->GetTranslucentCasting();
  if (!CanMeasureErrors(stage))
  {
    progress.Note(
      "note: errors are not measured: this build has no ray cast; build it with Embree");
  }
  else if (how == vtkShadowPass::TRANSLUCENT_STOCHASTIC ||
    how == vtkShadowPass::TRANSLUCENT_TRANSMITTANCE)
  {
    progress.Note("note: rays take translucent casters for opaque, so errors say nothing of their "
                  "shadows by opacity");
  }
}

}
