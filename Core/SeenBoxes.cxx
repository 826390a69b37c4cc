#include "SeenBoxes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vtkshadows
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

// By which share of its length a range of depths stands off what is seen.
constexpr double DepthMargin = 1.0e-3;

// Among ViewPlanes.
constexpr std::size_t NearPlane = SidePlanes, FarPlaneOfView = SidePlanes + 1;

// Corner i has its axes' upper ends in the bits of i.
constexpr int BoxFaces[6][4] = { { 0, 2, 6, 4 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 },
  { 0, 1, 3, 2 }, { 4, 5, 7, 6 } };

// Calls use(p) for the corners of what of the box's faces lies within the first `count` planes.
template <typename Use>
void ForEachSeenCorner(
  const BoxCorners& box, const std::array<glm::dvec4, 6>& planes, std::size_t count, const Use& use)
{
  for (std::vector<glm::dvec3> polygon : FacesOf(box))
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      ClipPolygon(polygon, planes[i]);
    }
    std::for_each(polygon.begin(), polygon.end(), use);
  }
}

// Whether, within the four sides of the view, a face of the box has a part beyond a plane of it.
bool SeenFacesCross(const glm::dmat4& clipFromWorld, std::size_t plane, const BoxCorners& box)
{
  const std::array<glm::dvec4, 6> planes = ViewPlanes(clipFromWorld);
  const auto isBeyond = [&](const glm::dvec3& p)
  { return glm::dot(planes[plane], glm::dvec4(p, 1.0)) < 0.0; };
  if (std::none_of(box.begin(), box.end(), isBeyond))
  {
    return false; // as nearly all of them
  }
  bool any = false;
  ForEachSeenCorner(
    box, planes, SidePlanes, [&](const glm::dvec3& p) { any = any || isBeyond(p); });
  return any;
}

// Whether the eye's near plane reaches into the box, by its bounds.
bool HoldsNearPlane(const std::array<glm::dvec3, 4>& nearQuad, const BoxCorners& box)
{
  Box bounds;
  bounds.Add(box);
  return std::any_of(
    nearQuad.begin(), nearQuad.end(), [&bounds](const glm::dvec3& p) { return bounds.Holds(p); });
}

}

//------------------------------------------------------------------------------
void Box::AddPoint(const glm::dvec3& p)
{
  this->minimum = this->isEmpty ? p : glm::min(this->minimum, p);
  this->maximum = this->isEmpty ? p : glm::max(this->maximum, p);
  this->isEmpty = false;
}

BoxCorners Box::Corners() const
{
  BoxCorners corners;
  for (int i = 0; i < 8; ++i)
  {
    corners[i] = { i & 1 ? this->maximum.x : this->minimum.x,
      i & 2 ? this->maximum.y : this->minimum.y, i & 4 ? this->maximum.z : this->minimum.z };
  }
  return corners;
}

Box Box::Grown(double margin) const
{
  Box box = *this;
  box.minimum -= margin;
  box.maximum += margin;
  return box;
}

bool Box::Holds(const glm::dvec3& p) const
{
  return !this->isEmpty && glm::all(glm::greaterThanEqual(p, this->minimum)) &&
    glm::all(glm::lessThanEqual(p, this->maximum));
}

//------------------------------------------------------------------------------
std::array<std::vector<glm::dvec3>, 6> FacesOf(const BoxCorners& box)
{
  std::array<std::vector<glm::dvec3>, 6> faces;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (const int corner : BoxFaces[i])
    {
      faces[i].push_back(box[corner]);
    }
  }
  return faces;
}

//------------------------------------------------------------------------------
void ClipPolygon(std::vector<glm::dvec3>& polygon, const glm::dvec4& plane)
{
  std::vector<glm::dvec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec3 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double a = glm::dot(plane, glm::dvec4(from, 1.0));
    const double b = glm::dot(plane, glm::dvec4(to, 1.0));
    if (a >= 0.0)
    {
      kept.push_back(from);
    }
    if ((a >= 0.0) != (b >= 0.0))
    {
      kept.push_back(glm::mix(from, to, a / (a - b)));
    }
  }
  polygon.swap(kept);
}

//------------------------------------------------------------------------------
std::array<glm::dvec4, 6> ViewPlanes(const glm::dmat4& clipFromWorld)
{
  const glm::dvec4 x = glm::row(clipFromWorld, 0), y = glm::row(clipFromWorld, 1);
  const glm::dvec4 z = glm::row(clipFromWorld, 2), w = glm::row(clipFromWorld, 3);
  return { w + x, w - x, w + y, w - y, w + z, w - z };
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
std::vector<glm::dvec3> SeenCorners(
  const glm::dmat4& clipFromWorld, const std::vector<BoxCorners>& boxes)
{
  const std::array<glm::dvec4, 6> planes = ViewPlanes(clipFromWorld);
  std::vector<glm::dvec3> seen;
  for (const BoxCorners& box : boxes)
  {
    // Nearly all of them lie on one side of each plane.
    bool isOutside = false, isInside = true;
    for (std::size_t i = 0; i < SidePlanes; ++i)
    {
      const auto behind = std::count_if(box.begin(), box.end(),
        [&](const glm::dvec3& p) { return glm::dot(planes[i], glm::dvec4(p, 1.0)) < 0.0; });
      isOutside = isOutside || behind == 8;
      isInside = isInside && behind == 0;
    }
    if (isInside)
    {
      seen.insert(seen.end(), box.begin(), box.end());
    }
    else if (!isOutside)
    {
      ForEachSeenCorner(box, planes, SidePlanes, [&](const glm::dvec3& p) { seen.push_back(p); });
    }
  }
  // The sides meet in the eye, which may lie in a box.
  const glm::dmat4 worldFromClip = glm::inverse(clipFromWorld);
  const glm::dvec4 eye = worldFromClip[2];
  if (eye.w != 0.0)
  {
    const glm::dvec3 eyeWC = glm::dvec3(eye) / eye.w;
    Box bounds;
    for (const BoxCorners& box : boxes)
    {
      bounds.Add(box);
    }
    if (bounds.Holds(eyeWC))
    {
      seen.push_back(eyeWC);
    }
  }
  return seen;
}

//------------------------------------------------------------------------------
// What is seen of a box is convex: it misses the face if it lies beyond one of its sides.
bool FaceMayBeSeen(
  const glm::dmat4& clipFromWorld, const std::vector<BoxCorners>& receivers, const LightView& face)
{
  const std::array<glm::dvec4, 6> planes = ViewPlanes(face.clipFromView * face.viewFromWorld);
  return std::any_of(receivers.begin(), receivers.end(),
    [&](const BoxCorners& box)
    {
      const std::vector<glm::dvec3> seen = SeenCorners(clipFromWorld, { box });
      return !seen.empty() &&
        std::none_of(planes.begin(), planes.begin() + SidePlanes,
          [&seen](const glm::dvec4& plane)
          {
            return std::all_of(seen.begin(), seen.end(),
              [&plane](const glm::dvec3& p) { return glm::dot(plane, glm::dvec4(p, 1.0)) < 0.0; });
          });
    });
}

//------------------------------------------------------------------------------
bool NearPlaneMayCut(const glm::dmat4& clipFromWorld, const BoxCorners& box)
{
  // The eye within the box sees no face of it on the way to the near plane.
  return SeenFacesCross(clipFromWorld, NearPlane, box) ||
    HoldsNearPlane(NearQuad(clipFromWorld), box);
}

//------------------------------------------------------------------------------
bool FarPlaneMayCut(const glm::dmat4& clipFromWorld, const BoxCorners& box)
{
  return SeenFacesCross(clipFromWorld, FarPlaneOfView, box);
}

//------------------------------------------------------------------------------
DepthRange SeenDepths(const glm::dmat4& clipFromView, const glm::dmat4& viewFromWorld,
  const std::vector<BoxCorners>& boxes)
{
  const glm::dmat4 viewFromClip = glm::inverse(clipFromView);
  const auto depthAt = [&viewFromClip](double z)
  {
    const glm::dvec4 p = viewFromClip * glm::dvec4(0.0, 0.0, z, 1.0);
    return -p.z / p.w;
  };
  const DepthRange whole{ depthAt(-1.0), depthAt(1.0) };
  const glm::dmat4 clipFromWorld = clipFromView * viewFromWorld;
  const std::array<glm::dvec4, 6> planes = ViewPlanes(clipFromWorld);
  const glm::dvec4 depth = -glm::row(viewFromWorld, 2);
  const std::array<glm::dvec3, 4> nearQuad = NearQuad(clipFromWorld);

  DepthRange seen{ Infinity, -Infinity };
  for (const BoxCorners& box : boxes)
  {
    ForEachSeenCorner(box, planes, planes.size(),
      [&](const glm::dvec3& p)
      {
        const double d = glm::dot(depth, glm::dvec4(p, 1.0));
        seen.nearest = std::min(seen.nearest, d);
        seen.farthest = std::max(seen.farthest, d);
      });
    // An eye within the box may see something at once.
    seen.nearest = HoldsNearPlane(nearQuad, box) ? whole.nearest : seen.nearest;
  }
  const double margin = DepthMargin * (seen.farthest - seen.nearest) +
    1.0e-6 * std::max(std::abs(seen.nearest), std::abs(seen.farthest));
  seen.nearest = std::max(whole.nearest, seen.nearest - margin);
  seen.farthest = std::min(whole.farthest, seen.farthest + margin);
  return seen.nearest < seen.farthest ? seen : whole;
}

//------------------------------------------------------------------------------
glm::dmat4 WithDepthRange(glm::dmat4 clipFromView, const DepthRange& range)
{
  const double n = range.nearest, f = range.farthest;
  const bool isParallel = clipFromView[2][3] == 0.0;
  clipFromView[2][2] = isParallel ? -2.0 / (f - n) : -(f + n) / (f - n);
  clipFromView[3][2] = isParallel ? -(f + n) / (f - n) : -2.0 * f * n / (f - n);
  return clipFromView;
}

//------------------------------------------------------------------------------
glm::dmat4 WithInfiniteFarPlane(glm::dmat4 clipFromView)
{
  const double nearPlane = clipFromView[3][2] / (clipFromView[2][2] - 1.0);
  clipFromView[2][2] = -1.0;
  clipFromView[3][2] = -2.0 * nearPlane;
  return clipFromView;
}

}
