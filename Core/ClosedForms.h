// Exact visibility past the simplest occluders: does a point see a light past a sphere, a box or a
// disc? In double and from formulas, without triangles: what guards the ray-cast reference itself.
//
// Common to all:
// - Points, lengths and normals are in world units and finite. The light is its centre:
//   `light.radius` is not looked at, nor is `light.coneAngle`, since the light's falloff is
//   shading's.
// - An occluder is its surface, as a closed mesh is its triangles: it hides the light if the way
//   from the point to the light crosses it. The way is open at both ends: a surface that holds the
//   point or the light itself does not count. So a point on the side of a sphere that turns to the
//   light sees it, one on the other side does not; point and light within one sphere see each
//   other.
// - To touch is not to cross: a ray along a tangent, a box's face or edge, or a disc's rim or plane
//   sees the light.
// - A spot or point light lies at the end of the way (what is behind it hides nothing), a
//   directional one infinitely far off.
// - A point on the surface up to rounding may be answered either way; ask beside it.
// - std::invalid_argument is thrown for an occluder that has no extent.
#ifndef vtkshadows_ClosedForms_h
#define vtkshadows_ClosedForms_h

#include "ShadowLight.h"

#include <glm/mat4x4.hpp>

namespace vtkshadows
{

// `radius` above 0.
bool SeesLightPastSphere(
  const glm::dvec3& pointWC, const ShadowLight& light, const glm::dvec3& centreWC, double radius);

// The box is axis-aligned in its own frame, and `minimum` is below `maximum` in every coordinate.
// `boxFromWorld` is affine and invertible (a rigid frame turns the box, a scale stretches it).
// @par Reference: T. Kay and J. Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986 (slabs).
bool SeesLightPastBox(const glm::dvec3& pointWC, const ShadowLight& light,
  const glm::dvec3& minimum, const glm::dvec3& maximum,
  const glm::dmat4& boxFromWorld = glm::dmat4(1.0));

// A flat round disc, seen from both sides. `normalWC` is perpendicular to it, of any length above
// 0; `radius` above 0.
bool SeesLightPastDisc(const glm::dvec3& pointWC, const ShadowLight& light,
  const glm::dvec3& centreWC, const glm::dvec3& normalWC, double radius);

}

#endif
