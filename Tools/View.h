// Which way is up, where the camera stands and where the light comes from, when the user does not
// say: mathematics on the meshes' points, in double.
#ifndef vtkshadows_View_h
#define vtkshadows_View_h

#include "Specs.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vtkshadows
{

struct Mesh;

// The scene as someone stands before it; unit vectors, world.
struct SceneAxes
{
  glm::dvec3 right{ 1.0, 0.0, 0.0 };
  glm::dvec3 forward{ 0.0, 1.0, 0.0 }; // away from the viewer, level
  glm::dvec3 up{ 0.0, 0.0, 1.0 };
};

// The meshes' extent along the axes; coordinates are dot products with them.
struct SceneExtent
{
  glm::dvec3 low{ 0.0 };    // along right, forward, up
  glm::dvec3 high{ 0.0 };   // along right, forward, up
  glm::dvec3 center{ 0.0 }; // world

  double Size() const; // the longest of the three sides
};

// Up is `up` if given; else the axis nearest to `camera`'s up; else +y if every input is glTF, as
// that format has it; else +z.
SceneAxes ChooseAxes(const std::optional<glm::dvec3>& up, const std::optional<CameraSpec>& camera,
  const std::vector<Mesh>& meshes);

SceneExtent MeasureExtent(const std::vector<Mesh>& meshes, const SceneAxes& axes);

// A camera that sees every point of the meshes with a margin, and floor around them.
CameraSpec FitCamera(const std::vector<Mesh>& meshes, const SceneAxes& axes, double aspect);

// From above and the left, a little from the front.
LightSpec DefaultLight(const SceneAxes& axes);

}

#endif
