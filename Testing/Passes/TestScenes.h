// The studio scenes of the registry as several suites draw them: by lot, and moved elsewhere.
#ifndef vtkshadows_TestScenes_h
#define vtkshadows_TestScenes_h

#include "SceneParts.h"
#include "StudioScenes.h"

#include <string>

class vtkRenderer;
class vtkTransform;

namespace shadowtest
{

using vtkshadows::scenes::AddBumpyMesh;
using vtkshadows::scenes::AddScannedMesh;
using vtkshadows::scenes::AddStillLife;
using vtkshadows::scenes::AddTubesAndGlyphs;
using vtkshadows::scenes::AimCamera;
using vtkshadows::scenes::MakeSurface;
using vtkshadows::scenes::Subject;
using vtkshadows::scenes::Toward;

// In place of what the renderer has: a still life, a bumpy mesh, or tubes and glyphs, in turn by
// the seed, with a directional or spot light at least `lowest` degrees above the horizon, and a
// camera, by lot.
struct LotScene
{
  std::string name;
  int kind = 0; // 0 the still life, 1 the bumpy mesh, 2 tubes and glyphs
};
LotScene AddSceneByLot(vtkRenderer* renderer, int seed, double lowest, int width, int height);

// Moves what stands in the scene: by matrices, or by giving it other coordinates, in double.
void PlaceActors(vtkRenderer* renderer, vtkTransform* worldFromScene, bool byActor);

}

#endif
