#include "ShadowReach.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

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
glm::dvec4 PlaneThrough(
  const glm::dvec3& a, const glm::dvec3& b, const glm::dvec4& light, const glm::dvec3& inside)
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
bool CastsOnNothing(const glm::dvec4& planeWC, const ShadowLight& light,
  const std::vector<BoxCorners>& receivers, double rounding)
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
      const double side = glm::dot(normal, corner) - planeWC.w;
      if (side * (height > 0.0 ? 1.0 : -1.0) < -rounding)
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
glm::dvec4 FarPlane(
  const glm::dvec4& light, const BoxCorners& caster, const Box& kept, const glm::dvec3& backward)
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
      if (sign * backward[axis] > 0.0)
      {
        continue;
      }
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
  const std::array<glm::dvec4, 6> planes = ViewPlanes(clipFromWorld);
  return std::none_of(planes.begin(), planes.end(),
    [&](const glm::dvec4& plane) { return ShadowLiesBehind(plane, light, caster); });
}

//------------------------------------------------------------------------------
// The light is taken for a cube around it. What lies behind a plane of the view for its corners
// does so for all in it, since they throw the caster on one far plane, or none.
bool SoftShadowMayBeSeen(const glm::dmat4& clipFromWorld, const glm::dvec4& light, double radius,
  const BoxCorners& caster, const Box& receivers)
{
  std::vector<glm::dvec4> lights;
  for (int corner = 0; corner < (radius > 0.0 ? 8 : 1); ++corner)
  {
    const glm::dvec3 side(
      corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
    lights.push_back(light + glm::dvec4(radius * side, 0.0));
  }
  const glm::dvec4 farPlane = FarPlane(light, caster, receivers);
  const glm::dvec3 outward(farPlane);
  const bool ends = std::all_of(lights.begin(), lights.end(),
    [&](const glm::dvec4& from)
    {
      return std::all_of(caster.begin(), caster.end(),
        [&](const glm::dvec3& p) { return glm::dot(outward, Along(from, p)) > 0.0; });
    });
  const auto liesBehind = [&](const glm::dvec4& plane)
  {
    const auto isBehind = [&plane](const glm::dvec3& p)
    { return glm::dot(plane, glm::dvec4(p, 1.0)) < 0.0; };
    return std::all_of(lights.begin(), lights.end(),
      [&](const glm::dvec4& from)
      {
        return !ends ? ShadowLiesBehind(plane, from, caster)
                     : std::all_of(caster.begin(), caster.end(),
                         [&](const glm::dvec3& p)
                         { return isBehind(p) && isBehind(ImageOnPlane(from, farPlane, p)); });
      });
  };
  const std::array<glm::dvec4, 6> planes = ViewPlanes(clipFromWorld);
  return std::none_of(planes.begin(), planes.begin() + SidePlanes, liesBehind);
}

//------------------------------------------------------------------------------
std::vector<glm::dvec4> SidesTowardLight(
  const glm::dvec4& light, double radius, const BoxCorners& box)
{
  const glm::dvec3 axes[3] = { box[1] - box[0], box[2] - box[0], box[4] - box[0] };
  const double size = glm::length(axes[0]) + glm::length(axes[1]) + glm::length(axes[2]);
  std::vector<glm::dvec4> sides;
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 across = glm::cross(axes[(axis + 1) % 3], axes[(axis + 2) % 3]);
    const double area = glm::length(across);
    if (!(area > SideTolerance * SideTolerance * size * size))
    {
      continue; // as thin as this, it points nowhere
    }
    for (const glm::dvec3& normal : { across / area, -across / area })
    {
      double farthest = -Infinity;
      for (const glm::dvec3& p : box)
      {
        farthest = std::max(farthest, glm::dot(normal, p));
      }
      if (glm::dot(normal, glm::dvec3(light)) - radius > light.w * farthest)
      {
        sides.emplace_back(normal, farthest);
      }
    }
  }
  return sides;
}

//------------------------------------------------------------------------------
namespace
{

// Whether the shadow, up to where no receiver of the box lies farther on, is beside the box or one
// of the four sides of the view.
bool EndsBeside(const std::array<glm::dvec4, 6>& viewPlanes, const Box& receivers,
  const glm::dvec4& light, const BoxCorners& caster)
{
  const glm::dvec4 farPlane = FarPlane(light, caster, receivers);
  if (glm::dvec3(farPlane) == glm::dvec3(0.0))
  {
    return false;
  }
  std::vector<glm::dvec3> hull(caster.begin(), caster.end());
  for (const glm::dvec3& corner : caster)
  {
    hull.push_back(ImageOnPlane(light, farPlane, corner));
  }
  const auto isBehind = [&hull](const glm::dvec4& plane)
  {
    return std::all_of(hull.begin(), hull.end(),
      [&plane](const glm::dvec3& p) { return glm::dot(plane, glm::dvec4(p, 1.0)) < 0.0; });
  };
  Box bounds;
  bounds.Add(hull);
  return std::any_of(viewPlanes.begin(), viewPlanes.begin() + SidePlanes, isBehind) ||
    glm::any(glm::greaterThan(bounds.minimum, receivers.maximum)) ||
    glm::any(glm::lessThan(bounds.maximum, receivers.minimum));
}

}

//------------------------------------------------------------------------------
bool LightMayBeSeen(const glm::dmat4& clipFromWorld, const Box& seen, const ShadowLight& light,
  const std::vector<BoxCorners>& casters)
{
  const std::array<glm::dvec4, 6> planes = ViewPlanes(clipFromWorld);
  const auto sidesEnd = planes.begin() + SidePlanes;
  if (light.kind == LightKind::Spot)
  {
    const double cone = glm::radians(light.coneAngle);
    for (auto plane = planes.begin(); plane != sidesEnd; ++plane)
    {
      // The ray of the cone that turns most toward the plane's inner side does not reach it.
      const glm::dvec3 normal(*plane);
      const double toward = glm::dot(glm::normalize(normal), light.direction);
      const double nearest = std::max(std::acos(glm::clamp(toward, -1.0, 1.0)) - cone, 0.0);
      if (glm::dot(*plane, glm::dvec4(light.position, 1.0)) < 0.0 && std::cos(nearest) <= 0.0)
      {
        return false;
      }
    }
  }
  const glm::dvec4 place = HomogeneousLight(light);
  return std::any_of(casters.begin(), casters.end(),
    [&](const BoxCorners& caster)
    {
      return std::none_of(planes.begin(), sidesEnd,
               [&](const glm::dvec4& plane) { return ShadowLiesBehind(plane, place, caster); }) &&
        ShadowMayReach(seen, place, caster) && !EndsBeside(planes, seen, place, caster) &&
        !(light.kind == LightKind::Spot && IsOutsideCone(light, { caster }));
    });
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
bool EyeMayBeShadowed(const glm::dvec4& eye, const glm::dvec4& light, const BoxCorners& caster)
{
  if (eye.w == 0.0 && light.w == 0.0)
  {
    // Two points at infinity: only a light straight ahead shadows the eye.
    return glm::dot(glm::normalize(glm::dvec3(eye)), glm::normalize(glm::dvec3(light))) < -0.999;
  }
  // The way between eye and light, from the end that is not at infinity, against the slabs of the
  // caster's bounds (Kay and Kajiya 1986).
  const glm::dvec4& from = eye.w != 0.0 ? eye : light;
  const glm::dvec4& to = eye.w != 0.0 ? light : eye;
  const glm::dvec3 origin = glm::dvec3(from) / from.w;
  const glm::dvec3 along = to.w != 0.0 ? glm::dvec3(to) / to.w - origin : glm::dvec3(to);
  Box box;
  box.Add(caster);
  const double tolerance = SideTolerance *
    (glm::length(box.maximum - box.minimum) +
      glm::length(0.5 * (box.minimum + box.maximum) - origin));
  double enter = 0.0, leave = to.w != 0.0 ? 1.0 : Infinity;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = box.minimum[axis] - tolerance - origin[axis];
    const double high = box.maximum[axis] + tolerance - origin[axis];
    if (along[axis] == 0.0)
    {
      leave = low > 0.0 || high < 0.0 ? -Infinity : leave;
      continue;
    }
    enter = std::max(enter, std::min(low / along[axis], high / along[axis]));
    leave = std::min(leave, std::max(low / along[axis], high / along[axis]));
  }
  return enter <= leave;
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
