#include "ShadowReach.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vtkshadows
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

// A point counts as on one side of a plane if it is by more than this share of the scene's size
// there: far more than the rounding of the floats that it is drawn in.
constexpr double SideTolerance = 1.0e-5;

// A far plane stands off by this share of the scene's size.
constexpr double FarMargin = 1.0e-3;

// From the light through p, in homogeneous coordinates: a direction.
glm::dvec3 Along(const glm::dvec4& light, const glm::dvec3& p)
{
  return p * light.w - glm::dvec3(light);
}

// Whether all of the shadow lies where plane.x < 0.
bool ShadowLiesBehind(const glm::dvec4& plane, const glm::dvec4& light, const BoxCorners& caster)
{
  return std::all_of(caster.begin(), caster.end(),
    [&](const glm::dvec3& p)
    {
      return glm::dot(plane, glm::dvec4(p, 1.0)) < 0.0 &&
        glm::dot(glm::dvec3(plane), Along(light, p)) <= 0.0;
    });
}

// The plane through a, b and the light, with `inside` on its negative side.
glm::dvec4 PlaneThrough(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec4& light,
  const glm::dvec3& inside)
{
  const glm::dvec3 normal = glm::cross(b - a, glm::dvec3(light) - a * light.w);
  const double length = glm::length(normal);
  if (!(length > 0.0))
  {
    return glm::dvec4(0.0);
  }
  const glm::dvec4 plane = glm::dvec4(normal, -glm::dot(normal, a)) / length;
  return glm::dot(plane, glm::dvec4(inside, 1.0)) > 0.0 ? -plane : plane;
}

}

//------------------------------------------------------------------------------
glm::dvec4 HomogeneousLight(const ShadowLight& light)
{
  return light.kind == LightKind::Directional ? glm::dvec4(-light.direction, 0.0)
                                              : glm::dvec4(light.position, 1.0);
}

//------------------------------------------------------------------------------
void Box::AddPoint(const glm::dvec3& p)
{
  this->minimum = this->isEmpty ? p : glm::min(this->minimum, p);
  this->maximum = this->isEmpty ? p : glm::max(this->maximum, p);
  this->isEmpty = false;
}

//------------------------------------------------------------------------------
std::array<glm::dvec3, 4> NearQuad(const glm::dmat4& clipFromWorld)
{
  const glm::dmat4 worldFromClip = glm::inverse(clipFromWorld);
  const glm::dvec2 turns[4] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
  std::array<glm::dvec3, 4> quad;
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec4 corner = worldFromClip * glm::dvec4(turns[i], -1.0, 1.0);
    quad[i] = glm::dvec3(corner) / corner.w;
  }
  return quad;
}

//------------------------------------------------------------------------------
bool CastsOnNothing(const glm::dvec4& planeWC, const ShadowLight& light,
  const std::vector<BoxCorners>& receivers)
{
  const glm::dvec3 normal(planeWC);
  if (normal == glm::dvec3(0.0))
  {
    return false;
  }
  const double height = light.kind == LightKind::Directional
    ? -glm::dot(normal, light.direction)
    : glm::dot(normal, light.position) - planeWC.w;
  for (const BoxCorners& corners : receivers)
  {
    for (const glm::dvec3& corner : corners)
    {
      // On the plane to the rounding of the floats that points are kept in.
      const double side = glm::dot(normal, corner) - planeWC.w;
      const double rounding = std::ldexp(std::max(glm::length(corner), std::abs(planeWC.w)), -21);
      if (side * (height > 0.0 ? 1.0 : -1.0) < -rounding)
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
glm::dvec4 FarPlane(const glm::dvec4& light, const BoxCorners& caster, const Box& kept)
{
  Box all = kept;
  all.Add(caster);
  const double size = glm::length(all.maximum - all.minimum);
  glm::dvec4 best(0.0);
  double shortest = 1.0e3 * size; // beyond that, floats lose the plane
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double sign : { -1.0, 1.0 })
    {
      glm::dvec4 plane(0.0);
      plane[axis] = sign;
      plane.w = (sign > 0.0 ? all.maximum[axis] : -all.minimum[axis]) + FarMargin * size;
      double longest = 0.0;
      for (const glm::dvec3& p : caster)
      {
        const glm::dvec3 along = Along(light, p);
        const double steepness = sign * along[axis] / glm::length(along);
        const double length = (plane.w - sign * p[axis]) / steepness;
        longest = steepness > 0.0 ? std::max(longest, length) : Infinity;
      }
      if (longest < shortest)
      {
        shortest = longest;
        best = plane;
      }
    }
  }
  return best;
}

//------------------------------------------------------------------------------
glm::dvec3 ImageOnPlane(
  const glm::dvec4& light, const glm::dvec4& farPlane, const glm::dvec3& point)
{
  const glm::dvec3 along = Along(light, point), normal(farPlane);
  return point + along * ((farPlane.w - glm::dot(normal, point)) / glm::dot(normal, along));
}

//------------------------------------------------------------------------------
bool ShadowMayBeSeen(
  const glm::dmat4& clipFromWorld, const glm::dvec4& light, const BoxCorners& caster)
{
  const glm::dvec4 w = glm::row(clipFromWorld, 3);
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec4 side = glm::row(clipFromWorld, axis);
    if (ShadowLiesBehind(w + side, light, caster) || ShadowLiesBehind(w - side, light, caster))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool ShadowMayReach(const Box& receivers, const glm::dvec4& light, const BoxCorners& caster)
{
  const double size = glm::length(receivers.maximum - receivers.minimum);
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec4 low(0.0), high(0.0);
    low[axis] = 1.0;
    low.w = FarMargin * size - receivers.minimum[axis];
    high[axis] = -1.0;
    high.w = FarMargin * size + receivers.maximum[axis];
    if (ShadowLiesBehind(low, light, caster) || ShadowLiesBehind(high, light, caster))
    {
      return false;
    }
  }
  return !receivers.isEmpty;
}

//------------------------------------------------------------------------------
bool NearPlaneMayBeShadowed(
  const glm::dmat4& clipFromWorld, const glm::dvec4& light, const BoxCorners& caster)
{
  // What the eye sees of its near plane, and with the light's position a pyramid: a caster that is
  // outside of it shadows nothing of that plane.
  const std::array<glm::dvec3, 4> quad = NearQuad(clipFromWorld);
  const glm::dvec3 centre = 0.25 * (quad[0] + quad[1] + quad[2] + quad[3]);
  double size = 0.0;
  for (const glm::dvec3& p : caster)
  {
    size = std::max(size, glm::length(p - centre));
  }

  std::vector<glm::dvec4> sides;
  for (int i = 0; i < 4; ++i)
  {
    sides.push_back(PlaneThrough(quad[i], quad[(i + 1) % 4], light, centre));
  }
  // The base, with the light behind it; and for a light with a position the plane through that.
  const glm::dvec3 base = glm::cross(quad[1] - quad[0], quad[3] - quad[0]);
  const double length = glm::length(base);
  const double towardLight = glm::dot(base, glm::dvec3(light) - centre * light.w);
  const glm::dvec3 normal = towardLight > 0.0 ? -base / length : base / length;
  sides.emplace_back(normal, -glm::dot(normal, centre));
  if (light.w != 0.0)
  {
    sides.emplace_back(-normal, glm::dot(normal, glm::dvec3(light) / light.w));
  }
  const double tolerance = SideTolerance * size;
  for (const glm::dvec4& side : sides)
  {
    const bool isOutside = std::all_of(caster.begin(), caster.end(),
      [&](const glm::dvec3& p) { return glm::dot(side, glm::dvec4(p, 1.0)) > tolerance; });
    if (isOutside)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
ViewBounds BoundsInView(const glm::dmat4& clipFromWorld, const glm::dvec4& light,
  const BoxCorners& caster, const glm::dvec4& farPlane)
{
  if (glm::dvec3(farPlane) == glm::dvec3(0.0))
  {
    return {};
  }
  ViewBounds bounds{ glm::dvec3(Infinity), glm::dvec3(-Infinity) };
  for (const glm::dvec3& corner : caster)
  {
    for (const glm::dvec3& p : { corner, ImageOnPlane(light, farPlane, corner) })
    {
      const glm::dvec4 clip = clipFromWorld * glm::dvec4(p, 1.0);
      if (!(clip.w > 0.0))
      {
        return {};
      }
      bounds.minimum = glm::min(bounds.minimum, glm::dvec3(clip) / clip.w);
      bounds.maximum = glm::max(bounds.maximum, glm::dvec3(clip) / clip.w);
    }
  }
  bounds.minimum = glm::clamp(bounds.minimum, -1.0, 1.0);
  bounds.maximum = glm::clamp(bounds.maximum, -1.0, 1.0);
  return bounds;
}

}
