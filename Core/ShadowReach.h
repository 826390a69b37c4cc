// Where a caster's shadow can fall, told from bounds alone: what need not be drawn, how far a
// volume must reach, and whether the eye's near plane can lie in it. All in world coordinates and
// double; each answer errs on the side of drawing more.
//
// A light is a homogeneous vector: (position, 1), or (the unit direction toward it, 0).
#ifndef vtkshadows_ShadowReach_h
#define vtkshadows_ShadowReach_h

#include "SeenBoxes.h"

#include <glm/vec4.hpp>

#include <vector>

namespace vtkshadows
{

glm::dvec4 HomogeneousLight(const ShadowLight& light);

// Whether a flat caster, in the plane n.x = d given as (n, d), has every receiver on the light's
// side of its plane, or on it: then nothing can lie in its shadow. `rounding`: what lies that far
// beyond the plane may lie on it.
bool CastsOnNothing(const glm::dvec4& planeWC, const ShadowLight& light,
  const std::vector<BoxCorners>& receivers, double rounding);

// The half-space n.x <= d as (n, d) that holds the caster and all of `kept`, and that every ray
// from the light through the caster leaves; of six candidates the one that is left soonest. n = 0
// if there is none: the shadow must reach to infinity. `kept` holds the receivers. Where faces are
// counted before the receiver, no way from the eye to a receiver may cross the plane, lest the eye
// look in at the far end: then `kept` holds the eye, too, and for parallel eyes `backward` is
// against their direction (else 0).
glm::dvec4 FarPlane(const glm::dvec4& light, const BoxCorners& caster, const Box& kept,
  const glm::dvec3& backward = glm::dvec3(0.0));

// Where the ray from the light through `point` meets a FarPlane.
glm::dvec3 ImageOnPlane(
  const glm::dvec4& light, const glm::dvec4& farPlane, const glm::dvec3& point);

// Whether any shadow of the caster can lie in the view frustum of `clipFromWorld`.
bool ShadowMayBeSeen(
  const glm::dmat4& clipFromWorld, const glm::dvec4& light, const BoxCorners& caster);

// The same for what the four sides of the view hold at whatever depth, of a light whose luminous
// points lie within `radius` of `light`, in its coordinates, and of shadows that end behind
// `receivers`.
bool SoftShadowMayBeSeen(const glm::dmat4& clipFromWorld, const glm::dvec4& light, double radius,
  const BoxCorners& caster, const Box& receivers);

// The planes (n, d) of those sides of a box, at most three, n.x = d with n outward and unit, that
// the light is beyond, with all its luminous points within `radius` of it. What lies beyond one of
// them, too, has its whole way to the light there: the box cannot shadow it.
std::vector<glm::dvec4> SidesTowardLight(
  const glm::dvec4& light, double radius, const BoxCorners& box);

// Whether any shadow of the caster can lie in the box.
bool ShadowMayReach(const Box& receivers, const glm::dvec4& light, const BoxCorners& caster);

// Whether any of a light's shadows can lie within the four sides of the view, whatever its depths,
// and in the box `seen` of the receivers that lie there; of a spot, within its cone, too.
bool LightMayBeSeen(const glm::dmat4& clipFromWorld, const Box& seen, const ShadowLight& light,
  const std::vector<BoxCorners>& casters);

// Whether the eye's near plane, as far as it is seen, can lie in the caster's shadow or cut the
// caster: then faces of its volume between eye and near plane are missing, if what lies there is
// clipped (E. Lengyel: The mechanics of robust stencil shadows, Gamasutra 2002).
bool NearPlaneMayBeShadowed(
  const glm::dmat4& clipFromWorld, const glm::dvec4& light, const BoxCorners& caster);

// Whether the eye itself can lie in the caster's shadow. An eye is (position, 1), or for a parallel
// projection (the direction from which it looks, 0): the point at infinity there.
bool EyeMayBeShadowed(const glm::dvec4& eye, const glm::dvec4& light, const BoxCorners& caster);

// Bounds in the viewport, -1 to 1, and in depth, of the caster and its images on the far plane, cut
// to the view. All of the view if a part lies beside or behind the eye, or the plane is none.
struct ViewBounds
{
  glm::dvec3 minimum{ -1.0 }, maximum{ 1.0 };
};
ViewBounds BoundsInView(const glm::dmat4& clipFromWorld, const glm::dvec4& light,
  const BoxCorners& caster, const glm::dvec4& farPlane);

}

#endif
