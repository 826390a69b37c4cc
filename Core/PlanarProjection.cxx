#include "PlanarProjection.h"

#include "ShadowReach.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vtkshadows
{
namespace
{

// z of the highest point, in units of w: so large that the steps of a depth buffer are far below
// what a height can be told from.
constexpr double HeightScale = 64.0;

struct Rectangle
{
  glm::dvec2 low{ std::numeric_limits<double>::infinity() };
  glm::dvec2 high{ -std::numeric_limits<double>::infinity() };
  void Add(const glm::dvec2& p)
  {
    this->low = glm::min(this->low, p);
    this->high = glm::max(this->high, p);
  }
  void Intersect(const Rectangle& other)
  {
    this->low = glm::max(this->low, other.low);
    this->high = glm::min(this->high, other.high);
  }
};

// What of `point` the plane's row of a matrix gives.
glm::dvec4 RowOf(const glm::dvec4& plane)
{
  return { glm::dvec3(plane), -plane.w };
}

}

//------------------------------------------------------------------------------
double HeightOver(const glm::dvec4& plane, const glm::dvec4& point)
{
  return glm::dot(RowOf(plane), point);
}

//------------------------------------------------------------------------------
void HeightsOver(
  const glm::dvec4& plane, const BoxCorners& corners, double& lowest, double& highest)
{
  lowest = std::numeric_limits<double>::infinity();
  highest = -lowest;
  for (const glm::dvec3& corner : corners)
  {
    const double height = HeightOver(plane, glm::dvec4(corner, 1.0));
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
}

//------------------------------------------------------------------------------
glm::dvec4 TurnedToLight(const glm::dvec4& plane, const glm::dvec4& light)
{
  return HeightOver(plane, light) < 0.0 ? -plane : plane;
}

//------------------------------------------------------------------------------
glm::dmat4 PlanarProjection(const glm::dvec4& plane, const glm::dvec4& light)
{
  return glm::dmat4(1.0) - glm::outerProduct(light / HeightOver(plane, light), RowOf(plane));
}

//------------------------------------------------------------------------------
glm::dmat4 OffsetPlanarProjection(const glm::dvec4& plane, const glm::dvec4& light, double offset)
{
  const glm::dvec3 normal(plane);
  return glm::translate(glm::dmat4(1.0), -offset * normal) *
    PlanarProjection(glm::dvec4(normal, plane.w + offset), light);
}

//------------------------------------------------------------------------------
glm::dvec4 PlaneSeenFrom(const glm::dvec4& plane, const glm::dvec3& origin)
{
  return { glm::dvec3(plane), plane.w - glm::dot(glm::dvec3(plane), origin) };
}

//------------------------------------------------------------------------------
glm::dvec4 ThrownOn(const glm::dvec4& plane, const PlanarThrow& thrown, const glm::dvec3& point)
{
  const glm::dvec3 normal(plane);
  const glm::dvec4 raised(normal, plane.w + thrown.offset), from(point, 1.0);
  const glm::dvec4 there =
    from - thrown.light * (HeightOver(raised, from) / HeightOver(raised, thrown.light));
  return there - glm::dvec4(thrown.offset * there.w * normal, 0.0);
}

//------------------------------------------------------------------------------
// Seen from among the casters: products of coordinates far from the world's origin would leave
// nothing of the shadow.
LightView PlanarView(const glm::dvec4& plane, const PlanarThrow& thrown,
  const glm::dmat4& clipFromWorld, const glm::dvec3& towardWC, double lowest, double highest)
{
  LightView view;
  view.parallel = thrown.light.w == 0.0;
  const glm::dvec3 lightWC(thrown.light);
  const glm::dvec3 along = view.parallel ? -lightWC : towardWC - lightWC;
  const double length = glm::length(along);
  view.viewFromWorld = ViewAlong(
    length > 0.0 ? along / length : -glm::dvec3(plane), view.parallel ? towardWC : lightWC);

  const glm::dmat4 one(1.0);
  const glm::dvec4 planeHere = PlaneSeenFrom(plane, towardWC);
  const glm::dvec4 lightHere = thrown.light - glm::dvec4(thrown.light.w * towardWC, 0.0);
  glm::dmat4 clip = clipFromWorld * glm::translate(one, towardWC) *
    OffsetPlanarProjection(planeHere, lightHere, thrown.offset);
  const double w = std::abs(glm::dot(glm::row(clipFromWorld, 3),
    glm::dvec4(towardWC - HeightOver(plane, glm::dvec4(towardWC, 1.0)) * glm::dvec3(plane), 1.0)));
  const double scale = HeightScale * (w > 0.0 ? w : 1.0) / (highest - lowest);
  clip = glm::row(clip, 2, scale * (RowOf(planeHere) - glm::dvec4(0.0, 0.0, 0.0, lowest)));
  view.clipFromView = clip * (glm::translate(one, -towardWC) * glm::inverse(view.viewFromWorld));
  return view;
}

//------------------------------------------------------------------------------
PlaneFrame::PlaneFrame(const glm::dvec4& plane)
  : origin(glm::dvec3(plane) * plane.w)
  , normal(plane)
{
  const glm::dmat4 view = ViewAlong(-this->normal, this->origin);
  this->u = glm::dvec3(glm::row(view, 0));
  this->v = glm::dvec3(glm::row(view, 1));
}

glm::dvec2 PlaneFrame::ToPlane(const glm::dvec3& p) const
{
  return { glm::dot(this->u, p - this->origin), glm::dot(this->v, p - this->origin) };
}

glm::dmat4 PlaneFrame::ClipFromWorld(const glm::dvec2& low, const glm::dvec2& high) const
{
  const glm::dvec2 scale = 2.0 / (high - low), centre = 0.5 * (low + high);
  const glm::dvec2 zero = this->ToPlane(glm::dvec3(0.0));
  glm::dmat4 clip(1.0);
  clip = glm::row(clip, 0, scale.x * glm::dvec4(this->u, zero.x - centre.x));
  clip = glm::row(clip, 1, scale.y * glm::dvec4(this->v, zero.y - centre.y));
  clip = glm::row(clip, 2, glm::dvec4(-this->normal, 0.0));
  return clip;
}

//------------------------------------------------------------------------------
bool BoundsOnPlane(const glm::dvec4& plane, const PlaneFrame& frame,
  const std::vector<BoxCorners>& receivers, const std::vector<BoxCorners>& casters,
  const std::vector<PlanarThrow>& throws, double margin, glm::dvec2& low, glm::dvec2& high)
{
  Rectangle lit, shadowed;
  for (const BoxCorners& corners : receivers)
  {
    for (const glm::dvec3& corner : corners)
    {
      lit.Add(frame.ToPlane(corner));
    }
  }
  bool isBounded = true;
  for (const BoxCorners& corners : casters)
  {
    double lowest = 0.0, highest = 0.0;
    HeightsOver(plane, corners, lowest, highest);
    for (const glm::dvec3& corner : corners)
    {
      if (lowest < 0.0)
      {
        // What crosses the plane does so within its own outline there.
        shadowed.Add(frame.ToPlane(corner));
      }
      for (const PlanarThrow& thrown : throws)
      {
        const glm::dvec4 point = ThrownOn(plane, thrown, corner);
        isBounded = isBounded && point.w > 0.0;
        if (HeightOver(plane, glm::dvec4(corner, 1.0)) >= 0.0 && point.w > 0.0)
        {
          shadowed.Add(frame.ToPlane(glm::dvec3(point) / point.w));
        }
      }
    }
  }
  if (isBounded)
  {
    lit.Intersect(shadowed);
  }
  low = lit.low;
  high = lit.high;
  const glm::dvec2 size = high - low;
  const double widened = margin * std::max(size.x, size.y);
  low -= widened;
  high += widened;
  return size.x > 0.0 && size.y > 0.0;
}

//------------------------------------------------------------------------------
bool DepthOnPlane(const glm::dvec4& plane, const glm::dmat4& clipFromWorld, int width, int height,
  glm::dvec3& depth)
{
  // A plane is a row; in clip space it is p.x x + p.y y + p.z z + p.w w = 0.
  const glm::dvec4 p = RowOf(plane) * glm::inverse(clipFromWorld);
  depth = { -p.x / p.z / width, -p.y / p.z / height, 0.5 * (1.0 + (p.x + p.y - p.w) / p.z) };
  return std::isfinite(depth.x) && std::isfinite(depth.y) && std::isfinite(depth.z);
}

//------------------------------------------------------------------------------
double WidestPenumbra(const glm::dvec4& plane, const std::vector<PlanarThrow>& throws,
  const glm::dmat4& clipFromWorld, int width, int height, const std::vector<BoxCorners>& casters)
{
  const glm::dvec2 half(0.5 * width, 0.5 * height);
  const double diagonal = 2.0 * glm::length(half);
  double widest = 0.0;
  for (const BoxCorners& corners : casters)
  {
    for (const glm::dvec3& corner : corners)
    {
      if (!(HeightOver(plane, glm::dvec4(corner, 1.0)) > 0.0))
      {
        continue;
      }
      glm::dvec2 low(0.0), high(0.0);
      for (std::size_t i = 0; i < throws.size(); ++i)
      {
        const glm::dvec4 point = ThrownOn(plane, throws[i], corner);
        const glm::dvec4 clip = clipFromWorld * point;
        if (!(point.w > 0.0 && clip.w > 0.0))
        {
          return diagonal;
        }
        const glm::dvec2 pixel = half * glm::dvec2(clip) / clip.w;
        low = i == 0 ? pixel : glm::min(low, pixel);
        high = i == 0 ? pixel : glm::max(high, pixel);
      }
      widest = std::max(widest, glm::length(high - low));
    }
  }
  return std::min(widest, diagonal);
}

}
