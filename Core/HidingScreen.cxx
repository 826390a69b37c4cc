#include "HidingScreen.h"

#include "EdgeTable.h"
#include "PlanarProjection.h"
#include "PointWelding.h"
#include "SeenBoxes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vtkshadows
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

// How far the areas of triangles may be from those of the rectangle that they cover once: the
// rounding of floats. Twice would be 1.
constexpr double AreaTolerance = 1.0e-3;

double Cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

// Of an edge, how often it is passed one way less how often the other way.
int NetPasses(const EdgeTable& edges, std::size_t edge)
{
  int net = 0;
  bool isFirst = true;
  edges.ForEachSide(edge,
    [&](HalfEdge side)
    {
      net += isFirst || (side & RunsAlike) != 0 ? 1 : -1;
      isFirst = false;
    });
  return net;
}

// A half-edge of the edge, without its bit.
HalfEdge FirstSide(const EdgeTable& edges, std::size_t edge)
{
  HalfEdge first = RunsAlike;
  edges.ForEachSide(edge, [&](HalfEdge side) { first = first == RunsAlike ? side : first; });
  return first & ~RunsAlike;
}

// Of a polygon before the eye.
double PixelsOf(const std::vector<glm::dvec3>& polygon, const PixelView& view)
{
  std::vector<glm::dvec2> pixels;
  for (const glm::dvec3& p : polygon)
  {
    const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(p, 1.0);
    pixels.push_back(0.5 * glm::dvec2(view.width, view.height) * glm::dvec2(clip) / clip.w);
  }
  double twice = 0.0;
  for (std::size_t i = 2; i < pixels.size(); ++i)
  {
    twice += Cross(pixels[i - 1] - pixels[0], pixels[i] - pixels[0]);
  }
  return 0.5 * std::abs(twice);
}

}

//------------------------------------------------------------------------------
std::optional<FlatBounds> FilledBounds(
  std::vector<glm::vec3> points, std::vector<glm::uvec3> triangles, int axis)
{
  const int right = (axis + 1) % 3, up = (axis + 2) % 3;
  for (glm::vec3& p : points)
  {
    p = { p[right], p[up], 0.0f };
  }
  Weld(points, triangles);
  glm::vec2 low(std::numeric_limits<float>::infinity()), high(-low);
  std::vector<glm::uvec3> turned;
  double area = 0.0;
  for (glm::uvec3 t : triangles)
  {
    const glm::dvec2 a(points[t.x]), b(points[t.y]), c(points[t.z]);
    const double twice = Cross(b - a, c - a);
    if (twice == 0.0)
    {
      continue;
    }
    area += 0.5 * std::abs(twice);
    turned.push_back(twice > 0.0 ? t : glm::uvec3(t.x, t.z, t.y));
    for (int corner = 0; corner < 3; ++corner)
    {
      low = glm::min(low, glm::vec2(points[t[corner]]));
      high = glm::max(high, glm::vec2(points[t[corner]]));
    }
  }
  const glm::dvec2 size(high - low);
  if (turned.empty() || !(std::abs(area - size.x * size.y) <= AreaTolerance * size.x * size.y))
  {
    return std::nullopt;
  }

  const EdgeTable edges = FindEdges(turned, points.size());
  for (std::size_t edge = 0; edge < edges.NumberOfEdges(); ++edge)
  {
    const HalfEdge side = FirstSide(edges, edge);
    const glm::uvec3& t = turned[side / 3];
    const glm::vec3 &a = points[t[side % 3]], &b = points[t[(side + 1) % 3]];
    const bool isOnSide = (a.x == b.x && (a.x == low.x || a.x == high.x)) ||
      (a.y == b.y && (a.y == low.y || a.y == high.y));
    if (!isOnSide && NetPasses(edges, edge) != 0)
    {
      return std::nullopt;
    }
  }
  return FlatBounds{ glm::dvec2(low), glm::dvec2(high) };
}

//------------------------------------------------------------------------------
double PixelsSeenPast(const ScreenCorners& screen, const glm::dvec4& plane, const BoxCorners& box,
  double rounding, const PixelView& view)
{
  double lowest = 0.0, highest = 0.0;
  HeightsOver(plane, box, lowest, highest);
  if (lowest >= -rounding)
  {
    return 0.0;
  }
  const std::array<glm::dvec4, 6> viewPlanes = ViewPlanes(view.clipFromWorld);
  std::vector<glm::dvec3> beforeNearPlane(screen.begin(), screen.end());
  for (std::size_t i = 0; i < SidePlanes; ++i)
  {
    ClipPolygon(beforeNearPlane, viewPlanes[i]);
  }
  ClipPolygon(beforeNearPlane, -viewPlanes[SidePlanes]);
  if (!(HeightOver(plane, view.eye) > 0.0) || !beforeNearPlane.empty())
  {
    return Infinity;
  }
  // Where row.p >= 0 for all of these, the eye sees p through the screen.
  const glm::dvec3 middle = 0.25 * (screen[0] + screen[1] + screen[2] + screen[3]);
  std::array<glm::dvec4, 4> sides;
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec3 &from = screen[i], &to = screen[(i + 1) % 4];
    const glm::dvec3 normal = glm::cross(to - from, glm::dvec3(view.eye) - from * view.eye.w);
    const glm::dvec4 row(normal, -glm::dot(normal, from));
    sides[i] = glm::dot(row, glm::dvec4(middle, 1.0)) < 0.0 ? -row : row;
  }
  const glm::dvec4 behind(-glm::dvec3(plane), plane.w - rounding);

  double pixels = 0.0;
  for (std::vector<glm::dvec3> face : FacesOf(box))
  {
    ClipPolygon(face, behind);
    for (const glm::dvec4& viewPlane : viewPlanes)
    {
      ClipPolygon(face, viewPlane);
    }
    for (const glm::dvec4& side : sides)
    {
      std::vector<glm::dvec3> past = face;
      ClipPolygon(past, -side);
      pixels += PixelsOf(past, view);
      ClipPolygon(face, side);
    }
  }
  return pixels;
}

}
