// The small languages of the command line: --light, --camera, --floor, --size, --up.
// Each parser checks what it reads; what it refuses is a Failure that names the option.
#ifndef vtkshadows_Specs_h
#define vtkshadows_Specs_h

#include "ShadowLight.h"

#include <glm/vec3.hpp>

#include <string>

namespace vtkshadows
{

struct LightSpec
{
  LightKind kind = LightKind::Directional;
  glm::dvec3 position{ 0.0 };             // world; spot, point
  glm::dvec3 focalPoint{ 0.0 };           // world; spot
  glm::dvec3 direction{ 0.0, 0.0, -1.0 }; // world, unit, the way the light travels; directional
  double coneAngle = 30.0;                // degrees from the axis, as vtkLight's; spot
  glm::dvec3 color{ 1.0 };                // 0 to 1
  double intensity = 1.0;
  double radius = 0.0;   // see vtkShadowPass::SetLightRadius
  double strength = 1.0; // 0 to 1
  double distance = 0.0; // from the eye, of its shadows; 0: any
  double fade = 0.1;     // share of it, 0 to 1
  double falloff = 0.0;  // share of the cone's angle, see vtkShadowPass::SetLightSmoothCone; spot
  std::string texture;   // an image that it projects, .png; spot; empty: none
  std::string technique; // empty: the default one
};

struct CameraSpec
{
  glm::dvec3 position{ 0.0 };   // world
  glm::dvec3 focalPoint{ 0.0 }; // world
  glm::dvec3 up{ 0.0, 0.0, 1.0 };
  double viewAngle = 30.0; // degrees, from the window's bottom to its top
};

struct FloorSpec
{
  enum class Kind
  {
    Auto,    // under the scene
    Catcher, // the same, but it shows nothing but shadow, and pictures have alpha
    None,
    Plane // the points x with normal.x = offset
  };
  Kind kind = Kind::Auto;
  glm::dvec3 normal{ 0.0, 0.0, 1.0 }; // unit
  double offset = 0.0;
};

struct WindowSize
{
  int width = 1024;
  int height = 768;
};

LightSpec ParseLight(const std::string& text);
CameraSpec ParseCamera(const std::string& text);
FloorSpec ParseFloor(const std::string& text);
WindowSize ParseSize(const std::string& text);
glm::dvec3 ParseUp(const std::string& text); // unit

}

#endif
