// What scenes are put together from: actors of simple shapes, lights, a camera. World units are the
// scene's own; up is +z, where nothing else is said.
#ifndef vtkshadows_SceneParts_h
#define vtkshadows_SceneParts_h

#include <vtkActor.h>
#include <vtkLight.h>
#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>

#include <functional>
#include <random>
#include <vector>

class vtkAlgorithm;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;

namespace vtkshadows::scenes
{

// What a camera or a light should aim at.
struct Subject
{
  glm::dvec3 centre{ 0.0 };
  double radius = 1.0;
};

vtkSmartPointer<vtkActor> AddActor(vtkRenderer* renderer, vtkAlgorithm* source);
vtkSmartPointer<vtkActor> AddActor(vtkRenderer* renderer, vtkPolyData* mesh);
// With normals at its points, none of them split.
vtkSmartPointer<vtkActor> AddSmooth(vtkRenderer* renderer, vtkPolyData* mesh);
// A square in the plane z = height about the z axis.
vtkSmartPointer<vtkActor> AddFloor(vtkRenderer* renderer, double halfSide, double height = 0.0);
vtkSmartPointer<vtkActor> AddSphere(
  vtkRenderer* renderer, const glm::dvec3& centre, double radius, int resolution = 48);
vtkSmartPointer<vtkActor> AddBox(
  vtkRenderer* renderer, const glm::dvec3& minimum, const glm::dvec3& maximum);

// `along`: the way the light travels.
vtkSmartPointer<vtkLight> AddSun(vtkRenderer* renderer, const glm::dvec3& along);
// `cone` as VTK's ConeAngle: from the axis to the side.
vtkSmartPointer<vtkLight> AddSpot(
  vtkRenderer* renderer, const glm::dvec3& position, const glm::dvec3& focus, double cone);
vtkSmartPointer<vtkLight> AddLamp(vtkRenderer* renderer, const glm::dvec3& position);

void LookAt(vtkRenderer* renderer, const glm::dvec3& position, const glm::dvec3& focus);

// Fills the frame with the subject, seen from `azimuth` (0: from -y; 90: from +x) and `elevation`
// above the horizon, in degrees.
void AimCamera(vtkRenderer* renderer, const Subject& subject, double azimuth, double elevation,
  int width, int height);

// Unit vector from the subject toward that place in the sky.
glm::dvec3 Toward(double azimuth, double elevation);

// The surface position(u, v), u and v from 0 to 1, of uCells x vCells quads cut in two.
vtkSmartPointer<vtkPolyData> MakeSurface(
  int uCells, int vCells, const std::function<glm::dvec3(double, double)>& position);

// Triangles; points in double, as coordinates far from the origin need them.
vtkSmartPointer<vtkPolyData> MakeTriangles(
  const std::vector<glm::dvec3>& points, const std::vector<glm::ivec3>& triangles);

// `cells` along a side, times the square root of a factor on their area; at least `fewest`.
int ScaledCells(int cells, double detail, int fewest = 3);

// Numbers by lot, the same on every machine.
class Lot
{
public:
  explicit Lot(unsigned int seed)
    : random(seed)
  {
  }
  double operator()(double low, double high)
  {
    return low + (high - low) * (this->random() / double(this->random.max()));
  }

private:
  std::mt19937 random;
};

}

#endif
