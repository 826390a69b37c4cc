// The studio scenes of the registry as several suites draw them: by lot, and moved elsewhere.
#ifndef vtkshadows_TestScenes_h
#define vtkshadows_TestScenes_h

#include "SceneParts.h"
#include "StudioScenes.h"

#include <glm/vec3.hpp>

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

// Where a scene stands, and how large it is.
struct Placement
{
  const char* name;
  double offset; // along each axis
  double scale;

  glm::dvec3 Of(const glm::dvec3& p) const { return glm::dvec3(this->offset) + this->scale * p; }
};
void PlaceActors(vtkRenderer* renderer, const Placement& placement, bool byActor);

// As scenes are made, and where absolute constants and floats of the world would fail.
inline constexpr Placement Placements[] = { { "plain", 0.0, 1.0 }, { "offset 1e6", 1e6, 1.0 },
  { "scale 1e-6", 0.0, 1e-6 }, { "scale 1e6", 0.0, 1e6 } };

// In place of what the renderer has: a still life, there, without a light, and a camera.
void AddStillLifeAt(
  vtkRenderer* renderer, const Placement& placement, bool byActor, int width, int height);

}

#endif
