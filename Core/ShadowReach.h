// Where a caster's shadow can fall, told from bounds alone: what need not be drawn, how far a volume
// must reach, and whether the eye's near plane can lie in it. All in world coordinates and double;
// each answer errs on the side of drawing more.
//
// A light is a homogeneous vector: (position, 1), or (the unit direction toward it, 0).
#ifndef vtkshadows_ShadowReach_h
#define vtkshadows_ShadowReach_h

#include "LightView.h" // for BoxCorners

#include <glm/vec4.hpp>

#include <array>

namespace vtkshadows
{

glm::dvec4 HomogeneousLight(const ShadowLight& light);

struct Box
{
  glm::dvec3 minimum{ 0.0 }, maximum{ 0.0 };
  bool isEmpty = true;
  template <typename Points>
  void Add(const Points& points)
  {
    for (const glm::dvec3& p : points)
    {
      this->AddPoint(p);
    }
  }
  void AddPoint(const glm::dvec3& p);
};

// Whether a flat caster, in the plane n.x = d given as (n, d), has every receiver on the light's
// side of its plane, or on it: then nothing can lie in its shadow.
bool CastsOnNothing(const glm::dvec4& planeWC, const ShadowLight& light,
  const std::vector<BoxCorners>& receivers);

// What the eye sees of its near plane.
std::array<glm::dvec3, 4> NearQuad(const glm::dmat4& clipFromWorld);

// The half-space n.x <= d as (n, d) that holds the caster and all of `kept`, and that every ray from
// the light through the caster leaves; of six candidates the one that is left soonest. n = 0 if
// there is none: the shadow must reach to infinity. `kept` holds the receivers, and the near quad
// too where faces are counted before the receiver: else the eye might look in at the far end.
glm::dvec4 FarPlane(const glm::dvec4& light, const BoxCorners& caster, const Box& kept);

// Where the ray from the light through `point` meets a FarPlane.
glm::dvec3 ImageOnPlane(
  const glm::dvec4& light, const glm::dvec4& farPlane, const glm::dvec3& point);

// Whether any shadow of the caster can lie in the view frustum of `clipFromWorld`.
bool ShadowMayBeSeen(
  const glm::dmat4& clipFromWorld, const glm::dvec4& light, const BoxCorners& caster);

// Whether any shadow of the caster can lie in the box.
bool ShadowMayReach(const Box& receivers, const glm::dvec4& light, const BoxCorners& caster);

// Whether the eye's near plane, as far as it is seen, can lie in the caster's shadow or cut the
// caster: then faces of its volume between eye and near plane are missing (E. Lengyel: The mechanics
// of robust stencil shadows, Gamasutra 2002).
bool NearPlaneMayBeShadowed(
  const glm::dmat4& clipFromWorld, const glm::dvec4& light, const BoxCorners& caster);

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
