// The scenes that techniques are compared on, by name. Each fills a renderer with props, lights and
// a camera, and says what is known of it. It knows of no shadow pass: what a scene has for that
// (the radius of its lights) is among the facts.
#ifndef vtkshadows_Scenes_h
#define vtkshadows_Scenes_h

#include "ShadowLight.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <glm/vec3.hpp>

#include <string>
#include <vector>

class vtkLight;
class vtkRenderer;

namespace vtkshadows
{

struct SceneSize
{
  double detail = 1.0;             // times the triangles of what is made, about; 0.01 to 100
  vtkIdType triangles = 1'000'000; // of the crowd, about; 10 000 to 50 000 000
  int lights = 0;                  // 0: the scene's own; 1 to 64: that many, from its own on
  std::string mesh;                // statue: an OFF or PLY file, y up; empty: a made mesh
  std::string volume;              // anatomy: a .vti file of labels; empty: a made volume
  int width = 1024;                // pixels of the window that the camera is set for
  int height = 768;
};

struct SceneLight
{
  vtkSmartPointer<vtkLight> light;
  LightKind kind = LightKind::Directional;
  // What suits the scene where lights are to be soft; in the units of
  // vtkShadowPass::SetLightRadius. VTK's light has none: a scene casts hard shadows until a pass is
  // told of it.
  double radius = 0.0;
};

// Which surfaces receive shadows that are seen.
enum class SceneReceivers
{
  Planar, // flat ones alone: walls, floors, the sides of boxes
  Mixed,  // a floor and curved ones
  Curved  // no flat one
};

// A length or angle that follows from how the scene is made.
struct SceneFact
{
  std::string what; // "camera above ground"
  double value = 0.0;
  std::string unit; // "m", "degrees"; empty: a count
};

struct SceneFacts
{
  std::string name;
  std::string description;        // one line
  std::vector<std::string> notes; // what stands in for what was not given
  vtkIdType triangles = 0;        // as drawn: of a glyph each instance's
  vtkIdType impostors = 0;        // spheres and sticks that are drawn as such
  std::vector<SceneLight> lights; // as the renderer has them
  double bounds[6] = {};          // world, of all props
  glm::dvec3 centre{ 0.0 };       // world: what the camera shows, a sphere
  double radius = 1.0;
  SceneReceivers receivers = SceneReceivers::Mixed;
  int planes = 0;             // flat receivers, the sides of boxes counted
  bool closedCasters = false; // what casts, but for floors, is of closed surfaces
  bool selfShadows = true;    // casters shadow themselves or each other where it is seen
  bool translucents = false;  // some props are translucent
  std::vector<SceneFact> facts;
};

// In the order in which reports have them.
std::vector<std::string> SceneNames();

// One line on a scene.
std::string SceneDescription(const std::string& name);

// In place of what `renderer` has: props, lights, camera and background. Up is +z. The same sizes
// give the same scene. Throws std::invalid_argument for an unknown name or a size outside the
// ranges above, std::runtime_error for a file that cannot be read; then the renderer is as it was.
SceneFacts BuildScene(
  const std::string& name, vtkRenderer* renderer, const SceneSize& size = SceneSize());

// Triangles that the visible props of `renderer` are drawn with, and spheres and sticks.
vtkIdType CountTriangles(vtkRenderer* renderer);
vtkIdType CountImpostors(vtkRenderer* renderer);

}

#endif
