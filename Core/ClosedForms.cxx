#include "ClosedForms.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace vtkshadows
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

// The points origin + t * direction, 0 < t < end, between a point and a light.
struct WayToLight
{
  glm::dvec3 origin;
  glm::dvec3 direction; // not of unit length
  double end;

  WayToLight(const glm::dvec3& pointWC, const ShadowLight& light)
    : origin(pointWC)
    , direction(light.position - pointWC)
    , end(1.0)
  {
    if (light.kind == LightKind::Directional)
    {
      this->direction = -light.direction;
      this->end = Infinity;
    }
  }

  bool Holds(double t) const { return 0.0 < t && t < this->end; }
};

void RequireRadius(const char* function, double radius)
{
  if (!(radius > 0.0 && radius < Infinity))
  {
    throw std::invalid_argument(std::string(function) + ": radius is " + std::to_string(radius) +
      "; give a finite length above 0.");
  }
}

void RequireExtent(const glm::dvec3& minimum, const glm::dvec3& maximum)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(minimum[axis] < maximum[axis]))
    {
      throw std::invalid_argument("SeesLightPastBox: on axis " + std::to_string(axis) +
        " minimum is " + std::to_string(minimum[axis]) + " and maximum " +
        std::to_string(maximum[axis]) + "; give a minimum below the maximum.");
    }
  }
}

void RequireNormal(const glm::dvec3& normal)
{
  const double length = glm::length(normal);
  if (!(length > 0.0 && length < Infinity))
  {
    throw std::invalid_argument("SeesLightPastDisc: the normal's length is " +
      std::to_string(length) + "; give a finite vector other than zero.");
  }
}

}

bool SeesLightPastSphere(
  const glm::dvec3& pointWC, const ShadowLight& light, const glm::dvec3& centreWC, double radius)
{
  RequireRadius("SeesLightPastSphere", radius);
  const WayToLight way(pointWC, light);
  const glm::dvec3 toCentre = centreWC - way.origin;
  const double squaredLength = glm::dot(way.direction, way.direction);

  // The discriminant from the distance between line and centre (a cross product) loses no digits
  // where the sphere is far and small: Haines et al., Ray Tracing Gems, chapter 7, 2019.
  const glm::dvec3 across = glm::cross(toCentre, way.direction);
  const double discriminant = radius * radius * squaredLength - glm::dot(across, across);
  if (!(discriminant > 0.0))
  {
    return true;
  }

  // The root farther from zero directly; the nearer one, that would cancel, from their product.
  const double along = glm::dot(toCentre, way.direction);
  const double sum = along + std::copysign(std::sqrt(discriminant), along);
  const double centreDistance = glm::length(toCentre);
  const double product = (centreDistance - radius) * (centreDistance + radius);
  return !way.Holds(sum / squaredLength) && !way.Holds(product / sum);
}

bool SeesLightPastBox(const glm::dvec3& pointWC, const ShadowLight& light,
  const glm::dvec3& minimum, const glm::dvec3& maximum, const glm::dmat4& boxFromWorld)
{
  RequireExtent(minimum, maximum);
  const WayToLight way(pointWC, light);
  // An affine map moves points along the way but leaves their t as it is.
  const glm::dvec3 origin(boxFromWorld * glm::dvec4(way.origin, 1.0));
  const glm::dvec3 direction(boxFromWorld * glm::dvec4(way.direction, 0.0));

  double enter = -Infinity;
  double leave = Infinity;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (direction[axis] == 0.0)
    {
      const bool inSlab = minimum[axis] < origin[axis] && origin[axis] < maximum[axis];
      if (!inSlab)
      {
        return true;
      }
      continue;
    }
    double low = (minimum[axis] - origin[axis]) / direction[axis];
    double high = (maximum[axis] - origin[axis]) / direction[axis];
    if (low > high)
    {
      std::swap(low, high);
    }
    enter = std::max(enter, low);
    leave = std::min(leave, high);
  }
  return !(enter < leave && (way.Holds(enter) || way.Holds(leave)));
}

bool SeesLightPastDisc(const glm::dvec3& pointWC, const ShadowLight& light,
  const glm::dvec3& centreWC, const glm::dvec3& normalWC, double radius)
{
  RequireRadius("SeesLightPastDisc", radius);
  RequireNormal(normalWC);
  const WayToLight way(pointWC, light);
  const glm::dvec3 toCentre = centreWC - way.origin;
  const double approach = glm::dot(normalWC, way.direction);
  if (approach == 0.0)
  {
    return true; // along the disc's plane: seen edge-on, it has no width
  }
  const double t = glm::dot(normalWC, toCentre) / approach;
  return !(way.Holds(t) && glm::length(t * way.direction - toCentre) < radius);
}

}
