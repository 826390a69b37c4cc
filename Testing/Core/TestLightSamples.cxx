// Sample lights of an area light: where they lie, and that they lie evenly.
#include "LightSamples.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

using namespace vtkshadows;

namespace
{

// Rounding of coordinates near 10, several operations of it.
constexpr double Rounding = 1e-13;

const glm::dvec3 Toward(4.0, -1.0, 0.5);

ShadowLight Light(LightKind kind, double radius)
{
  ShadowLight light;
  light.kind = kind;
  light.position = { 1.0, 2.0, 8.0 };
  light.direction = glm::normalize(glm::dvec3(0.3, -0.5, -1.0));
  light.coneAngle = 25.0;
  light.radius = radius;
  return light;
}

void ExpectNear(const glm::dvec3& got, const glm::dvec3& expected, double tolerance)
{
  EXPECT_NEAR(got.x, expected.x, tolerance);
  EXPECT_NEAR(got.y, expected.y, tolerance);
  EXPECT_NEAR(got.z, expected.z, tolerance);
}

std::vector<glm::dvec3> OffsetsOnDisc(const ShadowLight& light, int count)
{
  std::vector<glm::dvec3> offsets;
  for (const ShadowLight& sample : SampleAreaLight(light, count, Toward))
  {
    offsets.push_back(sample.position - light.position);
  }
  return offsets;
}

std::string MessageOf(const ShadowLight& light, int count)
{
  try
  {
    SampleAreaLight(light, count, Toward);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "nothing was thrown";
}

}

TEST(ShadowLight, TowardLightIsUnitAndPointsAtTheLight)
{
  const ShadowLight directional = Light(LightKind::Directional, 0.0);
  ExpectNear(directional.TowardLight(Toward), -directional.direction, 0.0);

  for (const LightKind kind : { LightKind::Spot, LightKind::Point })
  {
    ShadowLight light = Light(kind, 0.0);
    light.position = { 3.0, 4.0, 13.0 };
    ExpectNear(light.TowardLight({ 0.0, 0.0, 1.0 }), glm::dvec3(3.0, 4.0, 12.0) / 13.0, Rounding);
    ExpectNear(light.TowardLight(light.position), -light.direction, 0.0);
  }
}

TEST(LightSamples, ALightWithoutRadiusIsItsOwnSample)
{
  for (const LightKind kind : { LightKind::Directional, LightKind::Spot, LightKind::Point })
  {
    const ShadowLight light = Light(kind, 0.0);
    const std::vector<ShadowLight> samples = SampleAreaLight(light, 16, Toward);
    ASSERT_EQ(samples.size(), 1u);
    EXPECT_EQ(samples[0].kind, kind);
    ExpectNear(samples[0].position, light.position, 0.0);
    ExpectNear(samples[0].direction, light.direction, 0.0);
    EXPECT_EQ(samples[0].coneAngle, light.coneAngle);
  }
}

TEST(LightSamples, OneSampleIsTheCentre)
{
  const ShadowLight light = Light(LightKind::Spot, 2.0);
  const std::vector<ShadowLight> samples = SampleAreaLight(light, 1, Toward);
  ASSERT_EQ(samples.size(), 1u);
  ExpectNear(samples[0].position, light.position, Rounding);
  EXPECT_EQ(samples[0].radius, 0.0);
}

TEST(LightSamples, ThereAreCountPointLikeLightsOfTheSameKind)
{
  for (const LightKind kind : { LightKind::Directional, LightKind::Spot, LightKind::Point })
  {
    for (const int count : { 1, 2, 5, 64 })
    {
      const std::vector<ShadowLight> samples = SampleAreaLight(Light(kind, 0.25), count, Toward);
      EXPECT_EQ(samples.size(), static_cast<std::size_t>(count));
      for (const ShadowLight& sample : samples)
      {
        EXPECT_EQ(sample.kind, kind);
        EXPECT_EQ(sample.radius, 0.0);
        EXPECT_EQ(sample.coneAngle, 25.0);
      }
    }
  }
}

TEST(LightSamples, SpotSamplesKeepTheirDirection)
{
  const ShadowLight light = Light(LightKind::Spot, 2.0);
  for (const ShadowLight& sample : SampleAreaLight(light, 20, Toward))
  {
    ExpectNear(sample.direction, light.direction, 0.0);
  }
}

TEST(LightSamples, PositionsLieOnTheDiscAndAverageToItsCentre)
{
  for (const LightKind kind : { LightKind::Spot, LightKind::Point })
  {
    const ShadowLight light = Light(kind, 2.0);
    const glm::dvec3 axis =
      kind == LightKind::Spot ? light.direction : glm::normalize(Toward - light.position);
    for (const int count : { 1, 2, 3, 4, 7, 16, 100, 2000 })
    {
      SCOPED_TRACE("count " + std::to_string(count));
      glm::dvec3 sum(0.0);
      for (const glm::dvec3& offset : OffsetsOnDisc(light, count))
      {
        EXPECT_LE(glm::length(offset), 2.0);
        EXPECT_NEAR(glm::dot(offset, axis), 0.0, Rounding);
        sum += offset;
      }
      ExpectNear(sum / static_cast<double>(count), glm::dvec3(0.0), Rounding);
    }
  }
}

// A uniform disc of radius r has a mean squared radius of r^2/2, half of it along each axis.
TEST(LightSamples, SecondMomentIsThatOfAUniformDisc)
{
  const ShadowLight light = Light(LightKind::Spot, 3.0);
  const glm::dvec3 u = glm::normalize(glm::cross(light.direction, glm::dvec3(0.0, 1.0, 0.0)));
  const glm::dvec3 v = glm::cross(light.direction, u);
  const int count = 1000;
  double uu = 0.0, vv = 0.0, uv = 0.0;
  for (const glm::dvec3& offset : OffsetsOnDisc(light, count))
  {
    uu += glm::dot(offset, u) * glm::dot(offset, u) / count;
    vv += glm::dot(offset, v) * glm::dot(offset, v) / count;
    uv += glm::dot(offset, u) * glm::dot(offset, v) / count;
  }
  EXPECT_NEAR(uu + vv, 4.5, 1e-4);
  EXPECT_NEAR(uu, 2.25, 0.01);
  EXPECT_NEAR(vv, 2.25, 0.01);
  EXPECT_NEAR(uv, 0.0, 0.01);
}

// Each half of the disc, whichever way it is cut, holds half of the samples.
TEST(LightSamples, EveryHalfDiscHoldsHalfTheSamples)
{
  ShadowLight light = Light(LightKind::Spot, 1.0);
  light.direction = { 0.0, 0.0, -1.0 };
  const std::vector<glm::dvec3> offsets = OffsetsOnDisc(light, 256);
  for (int degrees = 0; degrees < 180; degrees += 5)
  {
    const double angle = degrees * std::acos(-1.0) / 180.0;
    int before = 0;
    for (const glm::dvec3& offset : offsets)
    {
      before += offset.x * std::cos(angle) + offset.y * std::sin(angle) > 0.0;
    }
    EXPECT_NEAR(before, 128, 6) << "cut at " << degrees << " degrees";
  }
}

TEST(LightSamples, DirectionalSamplesFillACone)
{
  const double tangent = 0.2;
  const ShadowLight light = Light(LightKind::Directional, tangent);
  const int count = 400;
  glm::dvec3 sumOnPlane(0.0);
  double widest = 0.0;
  for (const ShadowLight& sample : SampleAreaLight(light, count, Toward))
  {
    EXPECT_NEAR(glm::length(sample.direction), 1.0, Rounding);
    ExpectNear(sample.position, light.position, 0.0);
    // Back onto the disc one unit ahead of the light.
    const glm::dvec3 onPlane = sample.direction / glm::dot(sample.direction, light.direction);
    widest = std::max(widest, glm::length(onPlane - light.direction));
    sumOnPlane += onPlane;
  }
  EXPECT_LE(widest, tangent);
  EXPECT_GT(widest, 0.99 * tangent);
  ExpectNear(sumOnPlane / static_cast<double>(count), light.direction, Rounding);
}

// The disc's axes are found for every direction, the poles of the construction included.
TEST(LightSamples, EveryAxisGivesARoundDisc)
{
  const glm::dvec3 axes[] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
    { 0, 0, -1 }, { -1, 0, -0.0 }, { 1e-9, 0, -1 }, { 0, 1e-9, 1 }, { 1, 1, 1e-20 } };
  for (glm::dvec3 axis : axes)
  {
    axis = glm::normalize(axis);
    SCOPED_TRACE("axis " + std::to_string(axis.x) + " " + std::to_string(axis.y) + " " +
      std::to_string(axis.z));
    ShadowLight light = Light(LightKind::Spot, 1.0);
    light.direction = axis;
    double squares = 0.0;
    for (const glm::dvec3& offset : OffsetsOnDisc(light, 100))
    {
      EXPECT_NEAR(glm::dot(offset, axis), 0.0, Rounding);
      squares += glm::dot(offset, offset) / 100;
    }
    EXPECT_NEAR(squares, 0.5, 1e-3);
  }
}

TEST(LightSamples, APointLightLookedAtFromItsCentreStillHasADisc)
{
  const ShadowLight light = Light(LightKind::Point, 1.0);
  for (const ShadowLight& sample : SampleAreaLight(light, 9, light.position))
  {
    const glm::dvec3 offset = sample.position - light.position;
    EXPECT_NEAR(glm::dot(offset, light.direction), 0.0, Rounding);
    EXPECT_LE(glm::length(offset), 1.0);
  }
}

TEST(LightSamples, SamplesDifferAndAreTheSameEachTime)
{
  const ShadowLight light = Light(LightKind::Spot, 1.0);
  const std::vector<glm::dvec3> first = OffsetsOnDisc(light, 50);
  const std::vector<glm::dvec3> second = OffsetsOnDisc(light, 50);
  std::set<std::pair<double, double>> distinct;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    ExpectNear(second[i], first[i], 0.0);
    distinct.emplace(first[i].x, first[i].y);
  }
  EXPECT_EQ(distinct.size(), 50u);
}

TEST(LightSamples, BadInputIsNamedWithItsRemedy)
{
  const std::string count = MessageOf(Light(LightKind::Spot, 1.0), 0);
  EXPECT_NE(count.find("count is 0; give"), std::string::npos) << "got: " << count;
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double radius : { -1.0, infinity, std::nan("") })
  {
    const std::string message = MessageOf(Light(LightKind::Spot, radius), 4);
    EXPECT_NE(message.find("ShadowLight: radius is "), std::string::npos) << "got: " << message;
    EXPECT_NE(message.find("; give "), std::string::npos) << "got: " << message;
  }
}
