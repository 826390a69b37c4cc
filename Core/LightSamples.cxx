// References: H. Vogel, "A better way to construct the sunflower head", Mathematical Biosciences
// 44, 1979. T. Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
#include "LightSamples.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace vtkshadows
{
namespace
{

void RequireValid(const ShadowLight& light, int count)
{
  if (count < 1)
  {
    throw std::invalid_argument("SampleAreaLight: count is " + std::to_string(count) +
      "; give the number of sample lights, at least 1.");
  }
  if (!(light.radius >= 0.0 && light.radius < std::numeric_limits<double>::infinity()))
  {
    throw std::invalid_argument("ShadowLight: radius is " + std::to_string(light.radius) +
      "; give a finite length, at least 0 (0: a point-like light).");
  }
}

// `count` points of the unit disc. Their mean is subtracted: about 0.6/count long, it would shift
// the whole penumbra. They stay within the disc (tried for every count up to 3000).
std::vector<glm::dvec2> SunflowerDisc(int count)
{
  const double goldenAngle = glm::pi<double>() * (3.0 - std::sqrt(5.0));
  std::vector<glm::dvec2> points(count);
  glm::dvec2 sum(0.0);
  for (int i = 0; i < count; ++i)
  {
    const double radius = std::sqrt((i + 0.5) / count);
    points[i] = radius * glm::dvec2(std::cos(i * goldenAngle), std::sin(i * goldenAngle));
    sum += points[i];
  }
  for (glm::dvec2& point : points)
  {
    point -= sum / static_cast<double>(count);
  }
  return points;
}

struct DiscAxes
{
  glm::dvec3 u, v; // unit, perpendicular to each other and to the disc's normal

  // `n` is the disc's unit normal. No direction is singular (Duff et al. 2017).
  explicit DiscAxes(const glm::dvec3& n)
  {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    const double b = n.x * n.y * a;
    this->u = glm::dvec3(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x);
    this->v = glm::dvec3(b, sign + n.y * n.y * a, -n.y);
  }

  glm::dvec3 At(const glm::dvec2& p) const { return p.x * this->u + p.y * this->v; }
};

glm::dvec3 DiscNormal(const ShadowLight& light, const glm::dvec3& towardWC)
{
  return light.kind == LightKind::Point ? light.TowardLight(towardWC) : light.direction;
}

ShadowLight SampleAt(const ShadowLight& light, const glm::dvec3& offsetWC)
{
  ShadowLight sample = light;
  sample.radius = 0.0;
  if (light.kind == LightKind::Directional)
  {
    sample.direction = glm::normalize(light.direction + offsetWC);
  }
  else
  {
    sample.position += offsetWC;
  }
  return sample;
}

}

// At the light itself, where any direction would do, it is the one against the light's own.
glm::dvec3 ShadowLight::TowardLight(const glm::dvec3& pointWC) const
{
  const glm::dvec3 toLight = this->position - pointWC;
  const double distance = glm::length(toLight);
  if (this->kind == LightKind::Directional || distance == 0.0)
  {
    return -this->direction;
  }
  return toLight / distance;
}

std::vector<ShadowLight> SampleAreaLight(
  const ShadowLight& light, int count, const glm::dvec3& towardWC)
{
  RequireValid(light, count);
  if (light.radius == 0.0)
  {
    return { light };
  }
  const DiscAxes axes(DiscNormal(light, towardWC));
  std::vector<ShadowLight> samples;
  samples.reserve(count);
  for (const glm::dvec2& point : SunflowerDisc(count))
  {
    samples.push_back(SampleAt(light, light.radius * axes.At(point)));
  }
  return samples;
}

}
