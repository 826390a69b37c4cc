// Scenes that several suites draw. Each stands on the plane z = 0, about the z axis, with a floor
// under it.
#ifndef vtkshadows_TestScenes_h
#define vtkshadows_TestScenes_h

#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>

#include <functional>
#include <string>

class vtkPolyData;
class vtkRenderer;
class vtkTransform;

namespace shadowtest
{

// What a camera or a light should aim at.
struct Subject
{
  glm::dvec3 centre{ 0.0 };
  double radius = 1.0;
};

// A sphere, a torus, a cone and a box, in four colours. No light.
Subject AddStillLife(vtkRenderer* renderer);

// A closed mesh of 115 000 triangles with large and fine bumps: a made stand-in for a scan.
Subject AddBumpyMesh(vtkRenderer* renderer);

// A scanned mesh, y up, set on the floor; from an OFF file. Throws std::runtime_error if it cannot
// be read.
Subject AddScannedMesh(vtkRenderer* renderer, const std::string& file);

// Thin tubes among small glyphs: 330 000 triangles.
Subject AddTubesAndGlyphs(vtkRenderer* renderer);

// In place of what the renderer has: a still life, a bumpy mesh, or tubes and glyphs, in turn by
// the seed, with a directional or spot light at least `lowest` degrees above the horizon, and a
// camera, by lot.
struct LotScene
{
  std::string name;
  int kind = 0; // 0 the still life, 1 the bumpy mesh, 2 tubes and glyphs
};
LotScene AddSceneByLot(vtkRenderer* renderer, int seed, double lowest, int width, int height);

// The surface position(u, v), u and v from 0 to 1, of uCells x vCells quads cut in two.
vtkSmartPointer<vtkPolyData> MakeSurface(
  int uCells, int vCells, const std::function<glm::dvec3(double, double)>& position);

// Moves what stands in the scene: by matrices, or by giving it other coordinates, in double.
void PlaceActors(vtkRenderer* renderer, vtkTransform* worldFromScene, bool byActor);

// Fills the frame with the subject, seen from `azimuth` (0: from -y; 90: from +x) and `elevation`
// above the horizon, in degrees.
void AimCamera(vtkRenderer* renderer, const Subject& subject, double azimuth, double elevation,
  int width, int height);

// Unit vector from the subject toward that place in the sky.
glm::dvec3 Toward(double azimuth, double elevation);

}

#endif
