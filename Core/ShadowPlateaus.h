// Soft planar shadows by plateaus (Haines 2001): around the hard shadow of a light's middle every
// silhouette vertex gets a cone, and every silhouette edge the sheets between two of them, whose
// height is visibility: 0 along the hard shadow's edge, 1 where the penumbra ends. The least of all
// is the shadow. Outer penumbra only: the umbra stays as large as the hard shadow.
//
// @par Reference: E. Haines: Soft planar shadows using plateaus, Journal of Graphics Tools 6(1),
// 2001.
#ifndef vtkshadows_ShadowPlateaus_h
#define vtkshadows_ShadowPlateaus_h

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <utility>
#include <vector>

namespace vtkshadows
{

// How wide the penumbra of a point is on the plane n.x = d, (n, d): for a lamp of `radius` at
// height H over it, radius h / (H - h) for a point at height h; for a directional light, whose
// `radius` is the tangent of its half-angle and which stands at an angle with sine s over the
// plane, radius h / s. 0 for what lies on the plane, beneath it or not below the light.
double PlateauRadius(
  const glm::dvec4& plane, const glm::dvec4& light, double radius, const glm::dvec3& point);

struct PlateauVertex
{
  glm::vec3 place{ 0.0f }; // on the plane, less `origin`
  float visibility = 0.0f;
};

// Appends the triangles of cones and sheets of a closed silhouette, three vertices each: `edges`
// are pairs of world points, each point the first of some edge. Parts of which a point has no
// shadow on the plane are left out.
void BuildPlateaus(const glm::dvec4& plane, const glm::dvec4& light, double radius,
  const std::vector<std::pair<glm::dvec3, glm::dvec3>>& edges, const glm::dvec3& origin,
  std::vector<PlateauVertex>& triangles);

}

#endif
