// A light as the mathematics of shadows sees it: no colour, no VTK.
#ifndef vtkshadows_ShadowLight_h
#define vtkshadows_ShadowLight_h

#include <glm/vec3.hpp>

namespace vtkshadows
{

enum class LightKind
{
  Directional, // parallel rays; only `direction` counts
  Spot,        // rays from `position` within `coneAngle` of `direction`
  Point        // rays from `position` to everywhere
};

struct ShadowLight
{
  LightKind kind = LightKind::Directional;
  glm::dvec3 position{ 0.0, 0.0, 0.0 };   // world
  glm::dvec3 direction{ 0.0, 0.0, -1.0 }; // world, unit, the way the light travels
  double coneAngle = 30.0; // degrees between the axis and the cone's side, below 90; as vtkLight's
  double radius = 0.0; // of the luminous disc (directional: tangent of its half-angle), world units

  // Unit vector from a world point toward the light's centre.
  glm::dvec3 TowardLight(const glm::dvec3& pointWC) const;
};

}

#endif
