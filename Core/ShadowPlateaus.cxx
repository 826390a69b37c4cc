#include "ShadowPlateaus.h"

#include "PlanarProjection.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace vtkshadows
{
namespace
{

constexpr int ConeSides = 24;

struct Peak
{
  glm::dvec3 place{ 0.0 };
  double radius = 0.0;
};

}

//------------------------------------------------------------------------------
double PlateauRadius(
  const glm::dvec4& plane, const glm::dvec4& light, double radius, const glm::dvec3& point)
{
  const double height = HeightOver(plane, glm::dvec4(point, 1.0));
  const double left = HeightOver(plane, light) - height * light.w;
  return height > 0.0 && left > 0.0 ? radius * height / left : 0.0;
}

//------------------------------------------------------------------------------
void BuildPlateaus(const glm::dvec4& plane, const glm::dvec4& light, double radius,
  const std::vector<std::pair<glm::dvec3, glm::dvec3>>& edges, const glm::dvec3& origin,
  std::vector<PlateauVertex>& triangles)
{
  const glm::dmat4 projection = PlanarProjection(plane, light);
  const PlaneFrame frame(plane);
  const glm::dvec3 normal(plane);
  const auto add = [&](const glm::dvec3& place, float visibility) {
    triangles.push_back({ glm::vec3(place - origin), visibility });
  };

  for (auto [first, second] : edges)
  {
    // What lies beneath the plane casts nothing; what reaches up to the light has no end.
    const double low = HeightOver(plane, glm::dvec4(first, 1.0));
    const double high = HeightOver(plane, glm::dvec4(second, 1.0));
    const double most = HeightOver(plane, light) - std::max(low, high) * light.w;
    if (!(std::max(low, high) > 0.0 && most > 0.0))
    {
      continue;
    }
    const glm::dvec3 onPlane = first + (second - first) * (low / (low - high));
    first = low < 0.0 ? onPlane : first;
    second = high < 0.0 ? onPlane : second;
    Peak peaks[2];
    for (int i = 0; i < 2; ++i)
    {
      const glm::dvec3& point = i == 0 ? first : second;
      const glm::dvec4 thrown = projection * glm::dvec4(point, 1.0);
      peaks[i] = { glm::dvec3(thrown) / thrown.w, PlateauRadius(plane, light, radius, point) };
    }
    const Peak &a = peaks[0], &b = peaks[1];
    // A silhouette is closed: each of its vertices begins an edge.
    for (int side = 0; a.radius > 0.0 && side < ConeSides; ++side)
    {
      add(a.place, 0.0f);
      for (const int next : { side, side + 1 })
      {
        const double angle = next * glm::two_pi<double>() / ConeSides;
        add(a.place + a.radius * (std::cos(angle) * frame.u + std::sin(angle) * frame.v), 1.0f);
      }
    }
    const glm::dvec3 along = b.place - a.place;
    const double length = glm::length(along);
    if (!(length > 0.0))
    {
      continue;
    }
    const glm::dvec3 across = glm::cross(normal, along) / length;
    for (const double side : { -1.0, 1.0 })
    {
      const glm::dvec3 rimA = a.place + side * a.radius * across;
      const glm::dvec3 rimB = b.place + side * b.radius * across;
      add(a.place, 0.0f);
      add(b.place, 0.0f);
      add(rimB, 1.0f);
      add(a.place, 0.0f);
      add(rimB, 1.0f);
      add(rimA, 1.0f);
    }
  }
}

}
