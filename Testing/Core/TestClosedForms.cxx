// The closed forms, at places worked out by hand, tangents included, and against a walk along the
// way to the light that knows of no formula.
#include "ClosedForms.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

using namespace vtkshadows;

namespace
{

const glm::dvec3 Origin(0.0);
const glm::dvec3 Up(0.0, 0.0, 1.0);

// Just inside and just outside a limit, in units of its rounding.
constexpr double Below = 1.0 - 1e-14;
constexpr double Above = 1.0 + 1e-14;

ShadowLight Sun(const glm::dvec3& direction = -Up)
{
  ShadowLight light;
  light.kind = LightKind::Directional;
  light.direction = glm::normalize(direction);
  return light;
}

ShadowLight Lamp(const glm::dvec3& position, LightKind kind = LightKind::Point)
{
  ShadowLight light;
  light.kind = kind;
  light.position = position;
  return light;
}

std::string MessageOf(const std::function<void()>& call)
{
  try
  {
    call();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "nothing was thrown";
}

void ExpectRefusal(
  const std::string& object, const std::string& value, const std::function<void()>& call)
{
  const std::string message = MessageOf(call);
  EXPECT_NE(message.find(object), std::string::npos) << "got: " << message;
  EXPECT_NE(message.find(value), std::string::npos) << "got: " << message;
  EXPECT_NE(message.find("; give "), std::string::npos) << "no remedy in: " << message;
}

// Holds the closed form against a walk in small steps: the light is hidden if `signedDistance`
// (of a solid, negative within) changes its sign underway. Walks that nearly touch are left out.
void ExpectAsWalked(const std::function<bool(const glm::dvec3&, const ShadowLight&)>& seesLight,
  const std::function<double(const glm::dvec3&)>& signedDistance)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(-3.0, 3.0);
  const auto anyPoint = [&]()
  { return glm::dvec3(coordinate(random), coordinate(random), coordinate(random)); };
  const int steps = 800;
  int seen = 0, hidden = 0;
  for (int trial = 0; trial < 1500; ++trial)
  {
    const glm::dvec3 point = anyPoint();
    const bool sun = trial % 3 == 0;
    const ShadowLight light = sun ? Sun(anyPoint()) : Lamp(anyPoint());
    const glm::dvec3 end = sun ? point - 15.0 * light.direction : light.position;

    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    double closest = lowest;
    for (int i = 0; i <= steps; ++i)
    {
      const double distance = signedDistance(glm::mix(point, end, i / double(steps)));
      lowest = std::min(lowest, distance);
      highest = std::max(highest, distance);
      closest = std::min(closest, std::abs(distance));
    }
    const bool crossed = lowest < 0.0 && highest > 0.0;
    const bool nearlyTouched = !crossed && closest < 0.02;
    if (nearlyTouched)
    {
      continue;
    }
    EXPECT_EQ(seesLight(point, light), !crossed)
      << "trial " << trial << ", point " << point.x << " " << point.y << " " << point.z;
    ++(crossed ? hidden : seen);
  }
  EXPECT_GT(seen, 300);
  EXPECT_GT(hidden, 300);
}

}

// --- Sphere --------------------------------------------------------------------------------------

TEST(SphereClosedForm, SunCastsACircleWhoseRimSees)
{
  const glm::dvec3 centre(0.0, 0.0, 5.0);
  EXPECT_FALSE(SeesLightPastSphere(Origin, Sun(), centre, 1.0));
  EXPECT_FALSE(SeesLightPastSphere({ Below, 0, 0 }, Sun(), centre, 1.0));
  EXPECT_TRUE(SeesLightPastSphere({ 1, 0, 0 }, Sun(), centre, 1.0));
  EXPECT_TRUE(SeesLightPastSphere({ 0, -1, 0 }, Sun(), centre, 1.0));
  EXPECT_TRUE(SeesLightPastSphere({ Above, 0, 0 }, Sun(), centre, 1.0));
}

// Light 5 above the centre of a sphere of radius 3: sin = 3/5, tan = 3/4, and 8 down the circle's
// radius is 6.
TEST(SphereClosedForm, LampCastsACircleWhoseRimSees)
{
  const glm::dvec3 centre(0.0, 0.0, 3.0);
  for (const LightKind kind : { LightKind::Spot, LightKind::Point })
  {
    const ShadowLight lamp = Lamp({ 0, 0, 8 }, kind);
    EXPECT_FALSE(SeesLightPastSphere({ 6 * Below, 0, 0 }, lamp, centre, 3.0));
    EXPECT_TRUE(SeesLightPastSphere({ 6, 0, 0 }, lamp, centre, 3.0));
    EXPECT_TRUE(SeesLightPastSphere({ 6 * Above, 0, 0 }, lamp, centre, 3.0));
  }
}

// Sun at 45 degrees: an ellipse of half axes sqrt(2) and 1, shifted by the centre's height.
TEST(SphereClosedForm, SlantedSunCastsAnEllipse)
{
  const ShadowLight sun = Sun({ 1, 0, -1 });
  const glm::dvec3 centre(0.0, 0.0, 4.0);
  const double half = std::sqrt(2.0);
  EXPECT_FALSE(SeesLightPastSphere({ 4 + half * 0.999, 0, 0 }, sun, centre, 1.0));
  EXPECT_TRUE(SeesLightPastSphere({ 4 + half * 1.001, 0, 0 }, sun, centre, 1.0));
  EXPECT_FALSE(SeesLightPastSphere({ 4 - half * 0.999, 0, 0 }, sun, centre, 1.0));
  EXPECT_TRUE(SeesLightPastSphere({ 4 - half * 1.001, 0, 0 }, sun, centre, 1.0));
  EXPECT_FALSE(SeesLightPastSphere({ 4, 0.999, 0 }, sun, centre, 1.0));
  EXPECT_TRUE(SeesLightPastSphere({ 4, 1.001, 0 }, sun, centre, 1.0));
}

TEST(SphereClosedForm, OnlyWhatLiesBetweenHides)
{
  const ShadowLight lamp = Lamp({ 0, 0, 5 });
  const glm::dvec3 between(0, 0, 2), beyondTheLight(0, 0, 8), behindThePoint(0, 0, -3);
  EXPECT_FALSE(SeesLightPastSphere(Origin, lamp, between, 1.0));
  EXPECT_TRUE(SeesLightPastSphere(Origin, lamp, beyondTheLight, 1.0));
  EXPECT_TRUE(SeesLightPastSphere(Origin, lamp, behindThePoint, 1.0));
  EXPECT_FALSE(SeesLightPastSphere(Origin, Sun(), beyondTheLight, 1.0));
  EXPECT_TRUE(SeesLightPastSphere(Origin, Sun(), behindThePoint, 1.0));
}

TEST(SphereClosedForm, FromWithinTheSurfaceHides)
{
  const ShadowLight within = Lamp({ 0, 0, 0.5 });
  EXPECT_FALSE(SeesLightPastSphere({ 0, 0, -4 }, within, Origin, 1.0)) << "light within";
  EXPECT_FALSE(SeesLightPastSphere({ 0.2, 0, 0 }, Lamp({ 0, 0, 4 }), Origin, 1.0))
    << "point within";
  EXPECT_FALSE(SeesLightPastSphere({ 0.2, 0, 0 }, Sun(), Origin, 1.0)) << "point within, sun";
  EXPECT_TRUE(SeesLightPastSphere({ 0.2, 0, 0 }, within, Origin, 1.0)) << "both within";
}

TEST(SphereClosedForm, ASurfaceThatHoldsAnEndDoesNotCount)
{
  EXPECT_TRUE(SeesLightPastSphere({ 0, 0, 1 }, Sun(), Origin, 1.0)) << "top";
  EXPECT_FALSE(SeesLightPastSphere({ 0, 0, -1 }, Sun(), Origin, 1.0)) << "bottom";
  EXPECT_TRUE(SeesLightPastSphere({ 1, 0, 0 }, Sun(), Origin, 1.0)) << "equator, a tangent";
  EXPECT_TRUE(SeesLightPastSphere(Origin, Lamp({ 0, 0, 5 }), { 0, 0, 6 }, 1.0)) << "light on it";
  EXPECT_TRUE(SeesLightPastSphere(Origin, Lamp(Origin), { 0, 0, 0.5 }, 1.0)) << "point at light";
}

// A ball of radius 1 seen past its side from 10^8 away: a^2 - b c would have no digit left.
TEST(SphereClosedForm, FarSmallSpheresKeepTheirRim)
{
  const glm::dvec3 along = glm::normalize(glm::dvec3(1, 2, 3));
  const glm::dvec3 side = glm::normalize(glm::cross(along, Up));
  const glm::dvec3 start = -1e8 * along;
  EXPECT_FALSE(SeesLightPastSphere(start + 0.999999 * side, Sun(-along), Origin, 1.0));
  EXPECT_TRUE(SeesLightPastSphere(start + 1.000001 * side, Sun(-along), Origin, 1.0));
}

// One rounding above the surface, under any sun above its tangent plane: nothing lies between.
TEST(SphereClosedForm, PointsJustOffTheLitSideSeeTheSun)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  const auto anyDirection = [&]() {
    return glm::normalize(glm::dvec3(coordinate(random), coordinate(random), coordinate(random)));
  };
  int asked = 0;
  for (int trial = 0; trial < 5000; ++trial)
  {
    const glm::dvec3 point = (1.0 + std::numeric_limits<double>::epsilon()) * anyDirection();
    const glm::dvec3 towardSun = anyDirection();
    if (glm::length(point) > 1.0 && glm::dot(point, towardSun) > 0.01)
    {
      EXPECT_TRUE(SeesLightPastSphere(point, Sun(-towardSun), Origin, 1.0)) << "trial " << trial;
      ++asked;
    }
  }
  EXPECT_GT(asked, 500);
}

TEST(SphereClosedForm, AgreesWithAWalk)
{
  const glm::dvec3 centre(0.3, -0.2, 0.1);
  ExpectAsWalked([&](const glm::dvec3& p, const ShadowLight& light)
    { return SeesLightPastSphere(p, light, centre, 1.7); },
    [&](const glm::dvec3& p) { return glm::length(p - centre) - 1.7; });
}

// --- Box -----------------------------------------------------------------------------------------

namespace
{
const glm::dvec3 BoxLow(-1, -1, 1), BoxHigh(1, 1, 2);
}

TEST(BoxClosedForm, SunCastsASquareWhoseRimSees)
{
  EXPECT_FALSE(SeesLightPastBox(Origin, Sun(), BoxLow, BoxHigh));
  EXPECT_FALSE(SeesLightPastBox({ Below, -Below, 0 }, Sun(), BoxLow, BoxHigh));
  EXPECT_TRUE(SeesLightPastBox({ 1, 0, 0 }, Sun(), BoxLow, BoxHigh));
  EXPECT_TRUE(SeesLightPastBox({ 0, -1, 0 }, Sun(), BoxLow, BoxHigh));
  EXPECT_TRUE(SeesLightPastBox({ 1, 1, 0 }, Sun(), BoxLow, BoxHigh));
  EXPECT_TRUE(SeesLightPastBox({ 0, Above, 0 }, Sun(), BoxLow, BoxHigh));
}

// At 45 degrees the shadow runs from under the lower left edge (x = 0) to the upper right (x = 3).
TEST(BoxClosedForm, SlantedSunTouchesTheEdges)
{
  const ShadowLight sun = Sun({ 1, 0, -1 });
  EXPECT_TRUE(SeesLightPastBox({ 0, 0, 0 }, sun, BoxLow, BoxHigh));
  EXPECT_FALSE(SeesLightPastBox({ 1e-12, 0, 0 }, sun, BoxLow, BoxHigh));
  EXPECT_FALSE(SeesLightPastBox({ 3 * Below, 0, 0 }, sun, BoxLow, BoxHigh));
  EXPECT_TRUE(SeesLightPastBox({ 3, 0, 0 }, sun, BoxLow, BoxHigh));
}

// From 4 up, the top face, 2 up, is doubled: half width 2.
TEST(BoxClosedForm, LampCastsTheTopFace)
{
  for (const LightKind kind : { LightKind::Spot, LightKind::Point })
  {
    const ShadowLight lamp = Lamp({ 0, 0, 4 }, kind);
    EXPECT_FALSE(SeesLightPastBox({ 2 * Below, 0, 0 }, lamp, BoxLow, BoxHigh));
    EXPECT_TRUE(SeesLightPastBox({ 2, 0, 0 }, lamp, BoxLow, BoxHigh));
    EXPECT_TRUE(SeesLightPastBox({ 0, 2 * Above, 0 }, lamp, BoxLow, BoxHigh));
  }
}

TEST(BoxClosedForm, OnlyWhatLiesBetweenHides)
{
  EXPECT_TRUE(SeesLightPastBox(Origin, Lamp({ 0, 0, 0.5 }), BoxLow, BoxHigh)) << "beyond the light";
  EXPECT_TRUE(SeesLightPastBox(Origin, Lamp({ 0, 0, 1 }), BoxLow, BoxHigh)) << "light on it";
  EXPECT_FALSE(SeesLightPastBox(Origin, Lamp({ 0, 0, 1.5 }), BoxLow, BoxHigh)) << "light within";
  EXPECT_FALSE(SeesLightPastBox({ 0, 0, 1.2 }, Sun(), BoxLow, BoxHigh)) << "point within";
  EXPECT_TRUE(SeesLightPastBox({ 0, 0, 1.2 }, Lamp({ 0, 0, 1.5 }), BoxLow, BoxHigh)) << "both";
  EXPECT_TRUE(SeesLightPastBox({ 0, 0, 2 }, Sun(), BoxLow, BoxHigh)) << "point on the top face";
  EXPECT_FALSE(SeesLightPastBox({ 0, 0, 1 }, Sun(), BoxLow, BoxHigh)) << "on the bottom face";
  EXPECT_TRUE(SeesLightPastBox({ 0, 0, 3 }, Sun(), BoxLow, BoxHigh)) << "behind the point";
  EXPECT_TRUE(SeesLightPastBox({ 0, 0, 1.5 }, Lamp({ 0, 0, 1.5 }), BoxLow, BoxHigh)) << "at light";
}

TEST(BoxClosedForm, AFrameTurnsTheBox)
{
  const glm::dmat4 worldFromBox = glm::rotate(glm::dmat4(1.0), std::acos(-1.0) / 4, Up);
  const glm::dmat4 boxFromWorld = glm::affineInverse(worldFromBox);
  const glm::dvec3 corner(0.9, 0.9, 0.0), beside(1.3, 0.0, 0.0);
  EXPECT_FALSE(SeesLightPastBox(corner, Sun(), BoxLow, BoxHigh));
  EXPECT_TRUE(SeesLightPastBox(beside, Sun(), BoxLow, BoxHigh));
  EXPECT_TRUE(SeesLightPastBox(corner, Sun(), BoxLow, BoxHigh, boxFromWorld));
  EXPECT_FALSE(SeesLightPastBox(beside, Sun(), BoxLow, BoxHigh, boxFromWorld));
}

TEST(BoxClosedForm, AgreesWithAWalkInATurnedFrame)
{
  glm::dmat4 worldFromBox = glm::translate(glm::dmat4(1.0), glm::dvec3(0.4, 0.1, -0.3));
  worldFromBox = glm::rotate(worldFromBox, 0.8, glm::normalize(glm::dvec3(1, 2, -1)));
  const glm::dmat4 boxFromWorld = glm::affineInverse(worldFromBox);
  const glm::dvec3 half(2.0, 1.0, 1.5);
  ExpectAsWalked([&](const glm::dvec3& p, const ShadowLight& light)
    { return SeesLightPastBox(p, light, -half, half, boxFromWorld); },
    [&](const glm::dvec3& p)
    {
      const glm::dvec3 outside = glm::abs(glm::dvec3(boxFromWorld * glm::dvec4(p, 1.0))) - half;
      return std::max({ outside.x, outside.y, outside.z });
    });
}

// --- Disc ----------------------------------------------------------------------------------------

TEST(DiscClosedForm, SunCastsACircleWhoseRimSees)
{
  const glm::dvec3 centre(0, 0, 2);
  EXPECT_FALSE(SeesLightPastDisc(Origin, Sun(), centre, Up, 1.0));
  EXPECT_FALSE(SeesLightPastDisc({ Below, 0, 0 }, Sun(), centre, Up, 1.0));
  EXPECT_TRUE(SeesLightPastDisc({ 1, 0, 0 }, Sun(), centre, Up, 1.0));
  EXPECT_TRUE(SeesLightPastDisc({ 0, Above, 0 }, Sun(), centre, Up, 1.0));
}

// Halfway between plane and lamp: the shadow's radius is twice the disc's. Both faces cast.
TEST(DiscClosedForm, LampDoublesItHalfway)
{
  const glm::dvec3 centre(0, 0, 2);
  for (const LightKind kind : { LightKind::Spot, LightKind::Point })
  {
    for (const glm::dvec3& normal : { Up, -Up })
    {
      const ShadowLight lamp = Lamp({ 0, 0, 4 }, kind);
      EXPECT_FALSE(SeesLightPastDisc({ 2 * Below, 0, 0 }, lamp, centre, normal, 1.0));
      EXPECT_TRUE(SeesLightPastDisc({ 2, 0, 0 }, lamp, centre, normal, 1.0));
      EXPECT_TRUE(SeesLightPastDisc({ 2 * Above, 0, 0 }, lamp, centre, normal, 1.0));
    }
  }
}

// Tilted by 45 degrees about y the circle becomes an ellipse of half axes 1/sqrt(2) and 1.
TEST(DiscClosedForm, TiltedDiscCastsAnEllipse)
{
  const glm::dvec3 centre(0, 0, 2), normal(1, 0, 1);
  const double half = std::sqrt(0.5);
  EXPECT_FALSE(SeesLightPastDisc({ 0.999 * half, 0, 0 }, Sun(), centre, normal, 1.0));
  EXPECT_TRUE(SeesLightPastDisc({ 1.001 * half, 0, 0 }, Sun(), centre, normal, 1.0));
  EXPECT_FALSE(SeesLightPastDisc({ 0, 0.999, 0 }, Sun(), centre, normal, 1.0));
  EXPECT_TRUE(SeesLightPastDisc({ 0, 1.001, 0 }, Sun(), centre, normal, 1.0));
}

TEST(DiscClosedForm, OnlyWhatLiesBetweenHides)
{
  const ShadowLight lamp = Lamp({ 0, 0, 5 });
  EXPECT_FALSE(SeesLightPastDisc(Origin, lamp, { 0, 0, 2 }, Up, 1.0));
  EXPECT_TRUE(SeesLightPastDisc(Origin, lamp, { 0, 0, 8 }, Up, 1.0)) << "beyond the light";
  EXPECT_FALSE(SeesLightPastDisc(Origin, Sun(), { 0, 0, 8 }, Up, 1.0)) << "the sun is farther";
  EXPECT_TRUE(SeesLightPastDisc(Origin, lamp, { 0, 0, -1 }, Up, 1.0)) << "behind the point";
  EXPECT_TRUE(SeesLightPastDisc(Origin, Sun(), { 0, 0, -1 }, Up, 1.0)) << "behind the point, sun";
  EXPECT_TRUE(SeesLightPastDisc(Origin, lamp, Origin, Up, 1.0)) << "point on it";
  EXPECT_TRUE(SeesLightPastDisc(Origin, lamp, { 0, 0, 5 }, Up, 1.0)) << "light on it";
  EXPECT_TRUE(SeesLightPastDisc(Origin, Sun(), { 0, 0, 2 }, { 1, 0, 0 }, 1.0)) << "edge-on";
}

// A disc hides a point from a lamp as the sphere does that touches the same cone from within: here
// the cone of the 3-4-5 sphere, cut at its circle of contact (radius 3 * 4/5, 16/5 below the lamp).
TEST(DiscClosedForm, AgreesWithTheSphereOfTheSameCone)
{
  const ShadowLight lamp = Lamp({ 0, 0, 8 });
  for (int i = 0; i <= 1000; ++i)
  {
    const glm::dvec3 point(0.0, 0.01005 * i, 0.0);
    EXPECT_EQ(SeesLightPastDisc(point, lamp, { 0, 0, 4.8 }, Up, 2.4),
      SeesLightPastSphere(point, lamp, { 0, 0, 3 }, 3.0))
      << "y " << point.y;
  }
}

TEST(ClosedForms, OccludersWithoutExtentAreRefused)
{
  ExpectRefusal(
    "SeesLightPastSphere: radius", "0.0", [] { SeesLightPastSphere(Origin, Sun(), Up, 0.0); });
  ExpectRefusal("SeesLightPastSphere: radius", "nan",
    [] { SeesLightPastSphere(Origin, Sun(), Up, std::nan("")); });
  ExpectRefusal(
    "SeesLightPastDisc: radius", "-1", [] { SeesLightPastDisc(Origin, Sun(), Up, Up, -1.0); });
  ExpectRefusal("SeesLightPastDisc: the normal", "0.0",
    [] { SeesLightPastDisc(Origin, Sun(), Up, Origin, 1.0); });
  ExpectRefusal("SeesLightPastBox: on axis 1", "minimum is 3",
    [] {
      SeesLightPastBox(Origin, Sun(), { 0, 3, 0 }, { 1, 3, 1 });
    });
}
