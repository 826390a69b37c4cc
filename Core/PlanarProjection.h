// Shadows flattened onto a plane, by one matrix a light: the general form, for any plane and a
// light at a point or at infinity. The classical matrices for the planes x = 0, y = 0 and z = 0
// fall out of it. All in world coordinates and double.
//
// A plane n.x = d is (n, d), n of length 1. A light is a homogeneous vector: (position, 1), or
// (the unit direction toward it, 0).
//
// @par References: J. Blinn: Me and my (fake) shadow, IEEE Computer Graphics and Applications 8(1),
// 1988; P. Heckbert, M. Herf: Simulating soft shadows with graphics hardware, CMU-CS-97-104, 1997;
// B. Gooch, P.-P. Sloan, A. Gooch, P. Shirley, R. Riesenfeld: Interactive technical illustration,
// I3D 1999.
#ifndef vtkshadows_PlanarProjection_h
#define vtkshadows_PlanarProjection_h

#include "LightView.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace vtkshadows
{

// How far a homogeneous point lies over the plane, times its w.
double HeightOver(const glm::dvec4& plane, const glm::dvec4& point);

// The least and the most that a box lies over the plane.
void HeightsOver(
  const glm::dvec4& plane, const BoxCorners& corners, double& lowest, double& highest);

// The same plane, its normal toward the light.
glm::dvec4 TurnedToLight(const glm::dvec4& plane, const glm::dvec4& light);

// M p is where the line from the light through p meets the plane. Its w is that of p times the
// share of the light's height that is left above p: below 0 for what lies behind the light, which
// casts nothing; 1 for a light at infinity. The light must not lie in the plane.
glm::dmat4 PlanarProjection(const glm::dvec4& plane, const glm::dvec4& light);

// A projection onto a plane `offset` above the receiving one, dropped onto that along its normal:
// the light at another height, as it were (Gooch et al. 1999). offset 0: PlanarProjection.
glm::dmat4 OffsetPlanarProjection(const glm::dvec4& plane, const glm::dvec4& light, double offset);

// One shadow that is thrown on the plane. A hard light throws one; the mean of several is soft.
struct PlanarThrow
{
  glm::dvec4 light{ 0.0 };
  double offset = 0.0; // of the plane that it is thrown on
};

// The same plane for coordinates that begin at `origin`.
glm::dvec4 PlaneSeenFrom(const glm::dvec4& plane, const glm::dvec3& origin);

// Where a throw puts a point, homogeneous as by OffsetPlanarProjection. The plane's matrix has
// products of coordinates; this has none, and keeps its digits far from the world's origin.
glm::dvec4 ThrownOn(const glm::dvec4& plane, const PlanarThrow& thrown, const glm::dvec3& point);

// The view from which casters are drawn flattened onto the plane, as `clipFromWorld` sees that:
// its position in clip space has x, y and w of the flattened point, and for z what the point itself
// lies above the plane, beyond `lowest`, so that z > 0 tells what casts (z is not confined to
// -w..w). The view is rigid and looks from the light, as impostors want it. `towardWC` is a point
// among the casters, `highest` (above `lowest`) their height over the plane: they scale z.
LightView PlanarView(const glm::dvec4& plane, const PlanarThrow& thrown,
  const glm::dmat4& clipFromWorld, const glm::dvec3& towardWC, double lowest, double highest);

// A frame on the plane, fixed in the world: u and v unit, at right angles, with n = u x v.
struct PlaneFrame
{
  explicit PlaneFrame(const glm::dvec4& plane);
  glm::dvec3 origin, u, v, normal;

  glm::dvec2 ToPlane(const glm::dvec3& p) const;
  // From the world to clip space, of a view straight onto low..high of the plane.
  glm::dmat4 ClipFromWorld(const glm::dvec2& low, const glm::dvec2& high) const;
};

// Where receivers on a plane and the shadows of casters can meet, in its frame, widened by `margin`
// of its longer side. false if they meet nowhere.
bool BoundsOnPlane(const glm::dvec4& plane, const PlaneFrame& frame,
  const std::vector<BoxCorners>& receivers, const std::vector<BoxCorners>& casters,
  const std::vector<PlanarThrow>& throws, double margin, glm::dvec2& low, glm::dvec2& high);

// In the window, what lies on the plane has the depth a x + b y + c, pixels and depths as OpenGL
// has them (0..1 from near to far): (a, b, c). false if the plane is seen edge-on.
bool DepthOnPlane(const glm::dvec4& plane, const glm::dmat4& clipFromWorld, int width, int height,
  glm::dvec3& depth);

// How far apart two shadows of one point of `casters` are seen, in pixels, at the most: the width
// of the penumbra. The viewport's diagonal where it is not bounded.
double WidestPenumbra(const glm::dvec4& plane, const std::vector<PlanarThrow>& throws,
  const glm::dmat4& clipFromWorld, int width, int height, const std::vector<BoxCorners>& casters);

}

#endif
