#include "LightView.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vtkshadows
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

// Beyond this tangent (79 degrees off the axis) a perspective map spends its texels at the rim.
constexpr double WidestTangent = 5.0;

// Smallest near plane as a share of the far one: keeps the depth's relative step below 2^-12 of the
// float's own at the far end. What is nearer to the light is clamped, and still casts.
constexpr double NearestShare = 1.0 / 4096.0;

struct Rectangle
{
  glm::dvec2 low{ Infinity };
  glm::dvec2 high{ -Infinity };

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
  bool IsEmpty() const { return !(this->low.x <= this->high.x && this->low.y <= this->high.y); }
  double Area() const { return (this->high.x - this->low.x) * (this->high.y - this->low.y); }
};

struct Depths
{
  double nearest = Infinity;
  double farthest = -Infinity;

  void Add(double depth)
  {
    this->nearest = std::min(this->nearest, depth);
    this->farthest = std::max(this->farthest, depth);
  }
};

// The projection with these tangents as its sides, a little deeper than `depths`: by a share of the
// distance or, from a far light, of what lies there, which else would have few depths.
glm::dmat4 Frustum(const Rectangle& tangents, const Depths& depths)
{
  const glm::dvec2 size = tangents.high - tangents.low;
  const double spread =
    std::max(depths.farthest - depths.nearest, depths.farthest * std::max(size.x, size.y));
  const double share = 1.0 / 1024.0;
  const double farDepth = depths.farthest + share * std::min(depths.farthest, spread);
  const double nearDepth =
    std::max(depths.nearest - share * std::min(depths.nearest, spread), farDepth * NearestShare);
  return glm::frustum(tangents.low.x * nearDepth, tangents.high.x * nearDepth,
    tangents.low.y * nearDepth, tangents.high.y * nearDepth, nearDepth, farDepth);
}

// A frame whose z axis points against `forward`; rows of the rotation are its axes.
struct Frame
{
  glm::dvec3 x, y, z;

  explicit Frame(const glm::dvec3& forward)
    : z(-forward)
  {
    const glm::dvec3 a = glm::abs(this->z);
    const glm::dvec3 least = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
      : a.y <= a.z                                    ? glm::dvec3(0, 1, 0)
                                                      : glm::dvec3(0, 0, 1);
    this->x = glm::normalize(glm::cross(least, this->z));
    this->y = glm::cross(this->z, this->x);
  }

  void TurnTo(const glm::dvec2& xAxis)
  {
    const glm::dvec3 newX = xAxis.x * this->x + xAxis.y * this->y;
    this->y = -xAxis.y * this->x + xAxis.x * this->y;
    this->x = newX;
  }

  glm::dvec3 ToView(const glm::dvec3& v) const
  {
    return { glm::dot(this->x, v), glm::dot(this->y, v), glm::dot(this->z, v) };
  }

  glm::dmat4 ViewFromWorld(const glm::dvec3& eyeWC) const
  {
    glm::dmat4 m(1.0);
    for (int i = 0; i < 3; ++i)
    {
      m[i] = glm::dvec4(this->x[i], this->y[i], this->z[i], 0.0);
    }
    m[3] = glm::dvec4(-this->ToView(eyeWC), 1.0);
    return m;
  }
};

double Cross(const glm::dvec2& o, const glm::dvec2& a, const glm::dvec2& b)
{
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

// Andrew's monotone chain (Andrew 1979); counter-clockwise, without collinear points.
std::vector<glm::dvec2> ConvexHull(std::vector<glm::dvec2> points)
{
  std::sort(points.begin(), points.end(),
    [](const glm::dvec2& a, const glm::dvec2& b)
    { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<glm::dvec2> hull;
  for (int pass = 0; pass < 2; ++pass)
  {
    const std::size_t start = hull.size();
    for (const glm::dvec2& p : points)
    {
      while (hull.size() >= start + 2 && Cross(hull[hull.size() - 2], hull.back(), p) <= 0.0)
      {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

// The x axis of the rectangle of least area around `points`: one side lies on a hull edge
// (Freeman and Shapira 1975).
glm::dvec2 LeastAreaAxis(const std::vector<glm::dvec2>& points)
{
  const std::vector<glm::dvec2> hull = ConvexHull(points);
  glm::dvec2 best(1.0, 0.0);
  double bestArea = Infinity;
  for (std::size_t i = 0; i < hull.size(); ++i)
  {
    const glm::dvec2 edge = hull[(i + 1) % hull.size()] - hull[i];
    const double length = glm::length(edge);
    if (!(length > 0.0))
    {
      continue;
    }
    const glm::dvec2 axis = edge / length;
    Rectangle box;
    for (const glm::dvec2& p : hull)
    {
      box.Add({ glm::dot(axis, p), axis.x * p.y - axis.y * p.x });
    }
    if (box.Area() < bestArea)
    {
      bestArea = box.Area();
      best = axis;
    }
  }
  return best;
}

// Sides of the map: `margin` of the longer one beyond the rectangle on every side, and never of
// width zero.
Rectangle WithMargin(const Rectangle& box, double margin)
{
  const glm::dvec2 centre = 0.5 * (box.low + box.high);
  glm::dvec2 half = 0.5 * (box.high - box.low);
  const double thinnest = std::max(std::max(half.x, half.y) / 1024.0,
    std::numeric_limits<double>::epsilon() * 16.0 *
      std::max({ std::abs(centre.x), std::abs(centre.y), std::numeric_limits<double>::min() }));
  half = glm::max(half, glm::dvec2(thinnest));
  half += 2.0 * margin / (1.0 - 2.0 * margin) * std::max(half.x, half.y);
  return { centre - half, centre + half };
}

LightViewResult FitDirectional(const ShadowLight& light, const std::vector<BoxCorners>& casters,
  const std::vector<BoxCorners>& receivers, double margin)
{
  const glm::dvec3 centreWC = casters.front()[0];
  Frame frame(light.direction);
  std::vector<glm::dvec2> flat;
  for (const BoxCorners& box : casters)
  {
    for (const glm::dvec3& corner : box)
    {
      flat.push_back(glm::dvec2(frame.ToView(corner - centreWC)));
    }
  }
  frame.TurnTo(LeastAreaAxis(flat));

  // Rectangles and depths (along the light) of both, in the turned frame.
  Rectangle box, receiverBox;
  double nearDepth = Infinity, farDepth = -Infinity, receiverFar = -Infinity;
  for (const BoxCorners& corners : casters)
  {
    for (const glm::dvec3& corner : corners)
    {
      const glm::dvec3 p = frame.ToView(corner - centreWC);
      box.Add(glm::dvec2(p));
      nearDepth = std::min(nearDepth, -p.z);
      farDepth = std::max(farDepth, -p.z);
    }
  }
  for (const BoxCorners& corners : receivers)
  {
    for (const glm::dvec3& corner : corners)
    {
      const glm::dvec3 p = frame.ToView(corner - centreWC);
      receiverBox.Add(glm::dvec2(p));
      receiverFar = std::max(receiverFar, -p.z);
    }
  }
  box.Intersect(receiverBox);
  LightViewResult result;
  if (box.IsEmpty() || receiverFar <= nearDepth)
  {
    return result;
  }

  box = WithMargin(box, margin);
  const glm::dvec2 half = 0.5 * (box.high - box.low);
  const glm::dvec2 middle = 0.5 * (box.low + box.high);
  const double size = std::max(half.x, half.y);
  const double slack = size / 1024.0; // so that a flat caster has a depth range, too
  const glm::dvec3 eyeWC =
    centreWC + middle.x * frame.x + middle.y * frame.y - (nearDepth - slack) * frame.z;
  result.fit = LightViewFit::Fitted;
  result.view.parallel = true;
  result.view.viewFromWorld = frame.ViewFromWorld(eyeWC);
  result.view.clipFromView =
    glm::ortho(-half.x, half.x, -half.y, half.y, 0.0, farDepth - nearDepth + 2.0 * slack);
  return result;
}

// Tangents x/depth, y/depth of points as seen from the light; whole only if every point lies in
// front of it and within WidestTangent of the axis.
struct Tangents
{
  std::vector<glm::dvec2> points;
  double nearDepth = Infinity;
  double farDepth = -Infinity;
  bool whole = true;

  void Add(const glm::dvec3& positionVC)
  {
    const double depth = -positionVC.z;
    this->farDepth = std::max(this->farDepth, depth);
    const glm::dvec2 side(positionVC);
    if (depth <= 0.0 || glm::length(side) > WidestTangent * depth)
    {
      this->whole = false;
      return;
    }
    this->nearDepth = std::min(this->nearDepth, depth);
    this->points.push_back(side / depth);
  }
  Rectangle Bounds() const
  {
    Rectangle box;
    for (const glm::dvec2& p : this->points)
    {
      box.Add(p);
    }
    return box;
  }
};

Tangents TangentsOf(
  const std::vector<BoxCorners>& boxes, const Frame& frame, const glm::dvec3& lightWC)
{
  Tangents tangents;
  for (const BoxCorners& corners : boxes)
  {
    for (const glm::dvec3& corner : corners)
    {
      tangents.Add(frame.ToView(corner - lightWC));
    }
  }
  return tangents;
}

// The cone's tangents: its rim sampled, circumscribed so that no part of the disc is cut off.
Tangents TangentsOfCone(const ShadowLight& light, const Frame& frame)
{
  constexpr int Steps = 64;
  const Frame cone(light.direction);
  const double tangent =
    std::tan(glm::radians(light.coneAngle)) / std::cos(glm::pi<double>() / Steps);
  Tangents rim;
  for (int i = 0; i < Steps; ++i)
  {
    const double angle = glm::two_pi<double>() * i / Steps;
    rim.Add(frame.ToView(
      light.direction + tangent * (std::cos(angle) * cone.x + std::sin(angle) * cone.y)));
  }
  return rim;
}

glm::dvec3 CentreOf(const std::vector<BoxCorners>& boxes)
{
  glm::dvec3 low(Infinity), high(-Infinity);
  for (const BoxCorners& corners : boxes)
  {
    for (const glm::dvec3& corner : corners)
    {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
  }
  return 0.5 * (low + high);
}

LightViewResult FitPositional(const ShadowLight& light, const std::vector<BoxCorners>& casters,
  const std::vector<BoxCorners>& receivers, double margin)
{
  const bool isSpot = light.kind == LightKind::Spot;
  LightViewResult result;
  if (isSpot && IsOutsideCone(light, casters))
  {
    return result;
  }

  // First choice: look at the casters. If they surround the light, look along the spot's axis.
  const glm::dvec3 toCasters = CentreOf(casters) - light.position;
  const double distance = glm::length(toCasters);
  Frame frame(distance > 0.0 ? toCasters / distance : light.direction);
  Tangents seen = TangentsOf(casters, frame, light.position);
  Rectangle box;
  if (seen.whole)
  {
    frame.TurnTo(LeastAreaAxis(seen.points));
    seen = TangentsOf(casters, frame, light.position);
    box = seen.Bounds();
  }
  else if (isSpot && TangentsOfCone(light, Frame(light.direction)).whole)
  {
    frame = Frame(light.direction);
    seen = TangentsOf(casters, frame, light.position);
    box = { glm::dvec2(-Infinity), glm::dvec2(Infinity) }; // the cone's own sides follow below
  }
  else
  {
    result.fit = LightViewFit::Refused;
    return result;
  }
  if (seen.farDepth <= 0.0)
  {
    return result; // every caster is behind the light
  }

  const Tangents receiverTangents = TangentsOf(receivers, frame, light.position);
  if (receiverTangents.whole)
  {
    box.Intersect(receiverTangents.Bounds());
  }
  if (isSpot)
  {
    const Tangents rim = TangentsOfCone(light, frame);
    if (rim.whole)
    {
      box.Intersect(rim.Bounds());
    }
  }
  if (box.IsEmpty())
  {
    return result;
  }

  result.fit = LightViewFit::Fitted;
  result.view.parallel = false;
  result.view.viewFromWorld = frame.ViewFromWorld(light.position);
  result.view.clipFromView =
    Frustum(WithMargin(box, margin), { seen.whole ? seen.nearDepth : 0.0, seen.farDepth });
  return result;
}

// The corners of one side of a box, in turn.
constexpr int SidesOfBox[6][4] = { { 0, 2, 6, 4 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 },
  { 0, 1, 3, 2 }, { 4, 5, 7, 6 } };

// What of a polygon lies where n.p >= 0 (Sutherland and Hodgman 1974).
std::vector<glm::dvec3> ClippedBy(const glm::dvec3& normal, const std::vector<glm::dvec3>& polygon)
{
  std::vector<glm::dvec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec3& a = polygon[i];
    const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
    const double heightA = glm::dot(normal, a), heightB = glm::dot(normal, b);
    if (heightA >= 0.0)
    {
      kept.push_back(a);
    }
    if ((heightA < 0.0) != (heightB < 0.0))
    {
      kept.push_back(a + heightA / (heightA - heightB) * (b - a));
    }
  }
  return kept;
}

bool HoldsOrigin(const BoxCorners& box)
{
  const glm::dmat3 axes(box[1] - box[0], box[2] - box[0], box[4] - box[0]);
  const double volume = glm::determinant(axes);
  const glm::dvec3 place = volume != 0.0 ? glm::inverse(axes) * -box[0] : glm::dvec3(-1.0);
  return glm::all(glm::greaterThanEqual(place, glm::dvec3(0.0))) &&
    glm::all(glm::lessThanEqual(place, glm::dvec3(1.0)));
}

// Depths, along `forward`, of what of a box lies in the pyramid n.p >= 0 with the light, the
// origin, at its tip.
Depths DepthsIn(
  const std::vector<glm::dvec3>& pyramid, const glm::dvec3& forward, const BoxCorners& box)
{
  // Each corner of that part lies on the box, or is the tip.
  Depths depths;
  for (const auto& side : SidesOfBox)
  {
    std::vector<glm::dvec3> polygon = { box[side[0]], box[side[1]], box[side[2]], box[side[3]] };
    for (const glm::dvec3& normal : pyramid)
    {
      polygon = ClippedBy(normal, polygon);
    }
    for (const glm::dvec3& p : polygon)
    {
      depths.Add(glm::dot(forward, p));
    }
  }
  if (HoldsOrigin(box))
  {
    depths.Add(0.0);
  }
  return depths;
}

std::vector<BoxCorners> SeenFrom(const glm::dvec3& lightWC, std::vector<BoxCorners> boxes)
{
  for (BoxCorners& corners : boxes)
  {
    for (glm::dvec3& corner : corners)
    {
      corner -= lightWC;
    }
  }
  return boxes;
}

// All boxes relative to the light.
FittedLightView FitFace(int face, const glm::dmat3& cubeAxes, const ShadowLight& light,
  const std::vector<BoxCorners>& casters, const std::vector<BoxCorners>& receivers, double margin)
{
  const int axis = face / 2;
  const double sign = face % 2 == 0 ? 1.0 : -1.0;
  const glm::dvec3 s = cubeAxes[(axis + 1) % 3], t = cubeAxes[(axis + 2) % 3];
  const glm::dvec3 forward = sign * cubeAxes[axis];
  const Rectangle sides = WithMargin({ glm::dvec2(-1.0), glm::dvec2(1.0) }, margin);
  const double wide = sides.high.x;
  std::vector<glm::dvec3> pyramid = { wide * forward - s, wide * forward + s, wide * forward - t,
    wide * forward + t };
  if (light.kind == LightKind::Spot)
  {
    pyramid.push_back(light.direction); // no cone reaches behind it
  }

  FittedLightView fitted;
  double receiverFar = 0.0;
  for (const BoxCorners& box : receivers)
  {
    receiverFar = std::max(receiverFar, DepthsIn(pyramid, forward, box).farthest);
  }
  Depths all;
  for (std::size_t i = 0; i < casters.size(); ++i)
  {
    const Depths depths = DepthsIn(pyramid, forward, casters[i]);
    if (depths.farthest > 0.0 && depths.nearest < receiverFar)
    {
      fitted.casters.push_back(i);
      all.Add(depths.nearest);
      all.Add(depths.farthest);
    }
  }
  if (!fitted.casters.empty())
  {
    Frame frame(forward);
    frame.x = -sign * s;
    frame.y = t;
    fitted.face = face;
    fitted.view.parallel = false;
    fitted.view.viewFromWorld = frame.ViewFromWorld(light.position);
    fitted.view.clipFromView = Frustum(sides, all);
  }
  return fitted;
}

}

glm::dmat4 ViewAlong(const glm::dvec3& forward, const glm::dvec3& eyeWC)
{
  return Frame(forward).ViewFromWorld(eyeWC);
}

LightViewResult FitLightView(const ShadowLight& light, const std::vector<BoxCorners>& casters,
  const std::vector<BoxCorners>& receivers, double margin)
{
  if (casters.empty() || receivers.empty())
  {
    return {};
  }
  return light.kind == LightKind::Directional ? FitDirectional(light, casters, receivers, margin)
                                              : FitPositional(light, casters, receivers, margin);
}

bool IsOutsideCone(const ShadowLight& light, const std::vector<BoxCorners>& casters)
{
  const glm::dvec3 centre = CentreOf(casters);
  double radius = 0.0;
  for (const BoxCorners& corners : casters)
  {
    for (const glm::dvec3& corner : corners)
    {
      radius = std::max(radius, glm::length(corner - centre));
    }
  }
  const glm::dvec3 toCentre = centre - light.position;
  const double distance = glm::length(toCentre);
  if (distance <= radius)
  {
    return false;
  }
  const double offAxis =
    std::acos(glm::clamp(glm::dot(toCentre / distance, light.direction), -1.0, 1.0));
  return offAxis - std::asin(radius / distance) > glm::radians(light.coneAngle);
}

LightViews FitLightViews(const ShadowLight& light, const std::vector<BoxCorners>& casters,
  const std::vector<BoxCorners>& receivers, double margin)
{
  LightViews result;
  const LightViewResult one = FitLightView(light, casters, receivers, margin);
  if (one.fit == LightViewFit::Fitted)
  {
    FittedLightView fitted;
    fitted.view = one.view;
    fitted.casters.resize(casters.size());
    std::iota(fitted.casters.begin(), fitted.casters.end(), std::size_t(0));
    result.views.push_back(fitted);
  }
  if (one.fit != LightViewFit::Refused)
  {
    return result;
  }

  glm::dmat3 axes(1.0);
  if (light.kind == LightKind::Spot)
  {
    const Frame frame(light.direction);
    axes = { light.direction, frame.y, frame.x };
  }
  result.isCube = true;
  result.cubeFromWorld = glm::translate(glm::dmat4(glm::transpose(axes)), -light.position);
  const std::vector<BoxCorners> castersAround = SeenFrom(light.position, casters);
  const std::vector<BoxCorners> receiversAround = SeenFrom(light.position, receivers);
  for (int face = 0; face < 6; ++face)
  {
    const FittedLightView fitted =
      FitFace(face, axes, light, castersAround, receiversAround, margin);
    if (fitted.face != NoFace)
    {
      result.views.push_back(fitted);
    }
  }
  return result;
}

}
