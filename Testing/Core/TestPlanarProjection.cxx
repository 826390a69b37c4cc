// Shadows flattened onto a plane: held against the classical matrices, and against lines met with
// planes point by point.
#include "PlanarProjection.h"

#include "LightSamples.h"
#include "ShadowReach.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace vtkshadows;

namespace
{

std::mt19937 Lot(7);

double Uniform(double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(Lot);
}

glm::dvec3 PointIn(double half)
{
  return { Uniform(-half, half), Uniform(-half, half), Uniform(-half, half) };
}

glm::dvec4 SomePlane()
{
  return { glm::normalize(PointIn(1.0)), Uniform(-2.0, 2.0) };
}

// A light over the plane, at a point or at infinity.
glm::dvec4 SomeLight(const glm::dvec4& plane, bool directional)
{
  const glm::dvec3 normal(plane);
  if (directional)
  {
    const glm::dvec3 toward = glm::normalize(PointIn(1.0));
    return { glm::dot(toward, normal) < 0.0 ? -toward : toward, 0.0 };
  }
  const glm::dvec3 p = PointIn(4.0);
  return { p + (Uniform(1.0, 8.0) - HeightOver(plane, { p, 1.0 })) * normal, 1.0 };
}

// Where the line from the light through p meets the plane.
glm::dvec3 Meet(const glm::dvec4& plane, const glm::dvec4& light, const glm::dvec3& p)
{
  const glm::dvec3 along = light.w == 0.0 ? glm::dvec3(light) : glm::dvec3(light) - p;
  return p - along * (HeightOver(plane, { p, 1.0 }) / glm::dot(glm::dvec3(plane), along));
}

glm::dmat4 SomeView(bool parallel)
{
  const glm::dmat4 look = glm::lookAt(PointIn(1.0) + glm::dvec3(0.0, 0.0, 9.0), PointIn(1.0),
    glm::normalize(glm::dvec3(0.1, 1.0, 0.2)));
  return (parallel ? glm::ortho(-6.0, 6.0, -5.0, 5.0, 1.0, 30.0)
                   : glm::perspective(0.7, 1.3, 1.0, 30.0)) *
    look;
}

BoxCorners CornersOf(const glm::dvec3& centre, double half)
{
  BoxCorners corners;
  for (int i = 0; i < 8; ++i)
  {
    corners[i] = centre + half * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  }
  return corners;
}

void ExpectSame(const glm::dmat4& a, const glm::dmat4& b)
{
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 4; ++row)
    {
      EXPECT_NEAR(a[column][row], b[column][row], 1.0e-12) << "row " << row << " column " << column;
    }
  }
}

}

// The forms in textbooks, up to their common factor: onto z = 0 from a light at l, x' = (l.z x -
// l.x z) / (l.z - z); along d, x' = x - z d.x / d.z; and so for the other axes.
TEST(PlanarProjection, ClassicalMatrices)
{
  const glm::dvec3 l(2.0, -3.0, 5.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec4 plane(0.0);
    plane[axis] = 1.0;
    glm::dmat4 point(0.0), parallel(1.0);
    for (int i = 0; i < 4; ++i)
    {
      point[i][i] = l[axis];
    }
    for (int row = 0; row < 4; ++row)
    {
      point[axis][row] -= row < 3 ? l[row] : 1.0;
      parallel[axis][row] -= row < 3 ? l[row] / l[axis] : 0.0;
    }
    ExpectSame(PlanarProjection(plane, { l, 1.0 }), point / l[axis]);
    ExpectSame(PlanarProjection(plane, { glm::normalize(l), 0.0 }), parallel);
  }
}

// Parallel to an axis plane, d away: the same, moved.
TEST(PlanarProjection, AxisParallelPlanes)
{
  const glm::dvec4 light(1.0, 2.0, 9.0, 1.0);
  const double d = -1.5;
  const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, d)) *
    PlanarProjection({ 0.0, 0.0, 1.0, 0.0 }, light - glm::dvec4(0.0, 0.0, d, 0.0)) *
    glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -d));
  ExpectSame(PlanarProjection({ 0.0, 0.0, 1.0, d }, light), moved);
}

TEST(PlanarProjection, MeetsThePlane)
{
  for (int i = 0; i < 2000; ++i)
  {
    const glm::dvec4 plane = SomePlane(), light = SomeLight(plane, i % 2 == 0);
    const glm::dvec3 p = PointIn(3.0);
    const glm::dvec4 thrown = PlanarProjection(plane, light) * glm::dvec4(p, 1.0);
    const double left =
      light.w == 0.0 ? 1.0 : 1.0 - HeightOver(plane, { p, 1.0 }) / HeightOver(plane, light);
    EXPECT_NEAR(thrown.w, left, 1.0e-12);
    if (std::abs(thrown.w) > 1.0e-2)
    {
      const glm::dvec3 at = glm::dvec3(thrown) / thrown.w;
      EXPECT_NEAR(glm::length(at - Meet(plane, light, p)), 0.0, 1.0e-9);
      EXPECT_NEAR(HeightOver(plane, { at, 1.0 }), 0.0, 1.0e-10);
    }
  }
}

TEST(PlanarProjection, FarLightIsDirectional)
{
  const glm::dvec4 plane = SomePlane();
  const glm::dvec4 toward = SomeLight(plane, true);
  const glm::dmat4 atInfinity = PlanarProjection(plane, toward);
  const glm::dmat4 far = PlanarProjection(plane, { 1.0e9 * glm::dvec3(toward), 1.0 });
  for (int i = 0; i < 100; ++i)
  {
    const glm::dvec4 p(PointIn(2.0), 1.0);
    const glm::dvec4 a = atInfinity * p, b = far * p;
    EXPECT_NEAR(glm::length(glm::dvec3(a) / a.w - glm::dvec3(b) / b.w), 0.0, 1.0e-6);
  }
}

TEST(PlanarProjection, OffsetPlanesDropTheirShadow)
{
  for (int i = 0; i < 200; ++i)
  {
    const glm::dvec4 plane = SomePlane(), light = SomeLight(plane, i % 2 == 0);
    const double offset = Uniform(-0.4, 0.4);
    const glm::dvec3 p = PointIn(0.3) + glm::dvec3(plane) * plane.w;
    const glm::dvec4 raised(glm::dvec3(plane), plane.w + offset);
    const glm::dvec3 expected = Meet(raised, light, p) - offset * glm::dvec3(plane);
    const glm::dvec4 thrown = OffsetPlanarProjection(plane, light, offset) * glm::dvec4(p, 1.0);
    EXPECT_NEAR(glm::length(glm::dvec3(thrown) / thrown.w - expected), 0.0, 1.0e-9);
  }
}

// x, y and w of the flattened point, z of the point itself; and a rigid view from the light.
TEST(PlanarProjection, ViewTellsPlaceAndHeight)
{
  for (int i = 0; i < 500; ++i)
  {
    const glm::dvec4 plane = SomePlane(), light = SomeLight(plane, i % 2 == 0);
    const glm::dmat4 clipFromWorld = SomeView(i % 3 == 0);
    const double lowest = 1.0e-3;
    const LightView view =
      PlanarView(plane, { light, 0.0 }, clipFromWorld, PointIn(1.0), lowest, 3.0);
    const glm::dmat3 rotation(view.viewFromWorld);
    EXPECT_NEAR(glm::determinant(rotation), 1.0, 1.0e-12);
    if (light.w != 0.0)
    {
      EXPECT_NEAR(glm::length(glm::dvec3(view.viewFromWorld * light)), 0.0, 1.0e-9);
    }
    EXPECT_EQ(view.parallel, light.w == 0.0);
    for (int n = 0; n < 20; ++n)
    {
      const glm::dvec4 p(PointIn(3.0), 1.0);
      const glm::dvec4 got = view.clipFromView * view.viewFromWorld * p;
      const glm::dvec4 expected = clipFromWorld * PlanarProjection(plane, light) * p;
      EXPECT_NEAR(got.x, expected.x, 1.0e-8);
      EXPECT_NEAR(got.y, expected.y, 1.0e-8);
      EXPECT_NEAR(got.w, expected.w, 1.0e-8);
      const double height = HeightOver(plane, p);
      EXPECT_EQ(got.z > 0.0, height > lowest) << height;
    }
  }
}

TEST(PlanarProjection, DepthIsLinearInTheWindow)
{
  for (int i = 0; i < 200; ++i)
  {
    const glm::dvec4 plane = SomePlane();
    const glm::dmat4 clipFromWorld = SomeView(i % 2 == 0);
    const PlaneFrame frame(plane);
    glm::dvec3 depth;
    ASSERT_TRUE(DepthOnPlane(plane, clipFromWorld, 640, 480, depth));
    for (int n = 0; n < 20; ++n)
    {
      const glm::dvec3 p =
        frame.origin + Uniform(-2.0, 2.0) * frame.u + Uniform(-2.0, 2.0) * frame.v;
      const glm::dvec4 clip = clipFromWorld * glm::dvec4(p, 1.0);
      const glm::dvec3 pixel(
        640 * (0.5 + 0.5 * clip.x / clip.w), 480 * (0.5 + 0.5 * clip.y / clip.w), 1.0);
      EXPECT_NEAR(glm::dot(depth, pixel), 0.5 + 0.5 * clip.z / clip.w,
        1.0e-9 * (1.0 + glm::length(depth * pixel)));
    }
  }
}

TEST(PlanarProjection, EdgeOnPlaneHasNoDepth)
{
  const glm::dmat4 clipFromWorld = glm::perspective(0.7, 1.3, 1.0, 30.0);
  glm::dvec3 depth;
  EXPECT_FALSE(DepthOnPlane({ 0.0, 1.0, 0.0, 0.0 }, clipFromWorld, 640, 480, depth));
}

TEST(PlanarProjection, FrameLiesOnThePlane)
{
  for (int i = 0; i < 200; ++i)
  {
    const glm::dvec4 plane = SomePlane();
    const PlaneFrame frame(plane);
    EXPECT_NEAR(HeightOver(plane, { frame.origin, 1.0 }), 0.0, 1.0e-12);
    EXPECT_NEAR(glm::length(glm::cross(frame.u, frame.v) - frame.normal), 0.0, 1.0e-12);
    const glm::dvec2 low(-1.0, -2.0), high(3.0, 1.0);
    const glm::dvec3 p = frame.origin + 3.0 * frame.u - 2.0 * frame.v + 5.0 * frame.normal;
    const glm::dvec4 clip = frame.ClipFromWorld(low, high) * glm::dvec4(p, 1.0);
    EXPECT_NEAR(glm::length(glm::dvec2(clip) - glm::dvec2(1.0, -1.0)), 0.0, 1.0e-12);
    EXPECT_NEAR(clip.w, 1.0, 1.0e-12);
  }
}

// A lamp of radius R at height H, seen straight from above: a point at height h has a penumbra of
// 2 R h / (H - h).
TEST(PlanarProjection, PenumbraOfALamp)
{
  const glm::dvec4 plane(0.0, 0.0, 1.0, 0.0);
  ShadowLight lamp;
  lamp.kind = LightKind::Spot;
  lamp.position = { 0.0, 0.0, 6.0 };
  lamp.direction = { 0.0, 0.0, -1.0 };
  const BoxCorners box = CornersOf({ 0.0, 0.0, 1.5 }, 0.5);
  const glm::dmat4 clipFromWorld = glm::ortho(-4.0, 4.0, -4.0, 4.0, -1.0, 10.0);
  double before = 0.0;
  for (const double radius : { 0.1, 0.2, 0.4, 0.8 })
  {
    lamp.radius = radius;
    std::vector<PlanarThrow> throws;
    for (const ShadowLight& sample : SampleAreaLight(lamp, 64, glm::dvec3(0.0)))
    {
      throws.push_back({ HomogeneousLight(sample), 0.0 });
    }
    const double pixels = WidestPenumbra(plane, throws, clipFromWorld, 800, 800, { box });
    const double expected = 100.0 * 2.0 * radius * 2.0 / (6.0 - 2.0);
    // The diagonal of the square around the disc.
    EXPECT_GE(pixels, 0.95 * expected);
    EXPECT_LE(pixels, std::sqrt(2.0) * expected);
    EXPECT_GT(pixels, 1.9 * before);
    before = pixels;
  }
  // What reaches up to the lamp has no end.
  EXPECT_NEAR(WidestPenumbra(plane, { { { 0.0, 0.0, 1.9, 1.0 }, 0.0 } }, clipFromWorld, 800, 600,
                { CornersOf({ 0.0, 0.0, 1.5 }, 0.5) }),
    1000.0, 1.0e-9);
}

TEST(PlanarProjection, BoundsHoldEveryShadow)
{
  int unlike = 0;
  for (int i = 0; i < 300; ++i)
  {
    const glm::dvec4 plane = SomePlane(), light = SomeLight(plane, i % 2 == 0);
    const PlaneFrame frame(plane);
    const BoxCorners caster =
      CornersOf(frame.origin + PointIn(2.0) + glm::dvec3(plane), Uniform(0.1, 0.6));
    const BoxCorners floor = CornersOf(frame.origin, 6.0);
    glm::dvec2 low, high;
    const bool meets =
      BoundsOnPlane(plane, frame, { floor }, { caster }, { { light, 0.0 } }, 0.0, low, high);
    for (int n = 0; n < 200; ++n)
    {
      glm::dvec3 p(0.0);
      double sum = 0.0;
      for (const glm::dvec3& corner : caster)
      {
        const double weight = std::pow(Uniform(0.0, 1.0), 4.0);
        p += weight * corner;
        sum += weight;
      }
      p /= sum;
      const double height = HeightOver(plane, { p, 1.0 });
      if (height <= 0.0 || (light.w != 0.0 && height >= HeightOver(plane, light)))
      {
        continue;
      }
      const glm::dvec2 at = frame.ToPlane(Meet(plane, light, p));
      const bool onFloor = std::abs(at.x) < 3.0 && std::abs(at.y) < 3.0;
      if (onFloor)
      {
        EXPECT_TRUE(meets);
        EXPECT_TRUE(at.x >= low.x - 1e-9 && at.y >= low.y - 1e-9 && at.x <= high.x + 1e-9 &&
          at.y <= high.y + 1e-9);
        unlike += 1;
      }
    }
  }
  EXPECT_GT(unlike, 5000);
}

//------------------------------------------------------------------------------
// Far from the world's origin: what a scene of size 1 to 10 throws there is what it throws at the
// origin, to the rounding of its coordinates there.
TEST(PlanarProjection, FarFromTheOrigin)
{
  for (const double far : { 1.0e6, 1.0e8, 1.0e9 })
  {
    const glm::dvec3 offset = far * glm::dvec3(1.0, -0.7, 0.4);
    const double rounding = std::ldexp(far, -46);
    for (int scene = 0; scene < 100; ++scene)
    {
      const glm::dvec4 plane = SomePlane(), light = SomeLight(plane, scene % 2 == 0);
      const glm::dvec4 planeThere(glm::dvec3(plane), plane.w + glm::dot(glm::dvec3(plane), offset));
      const glm::dvec4 lightThere = light + glm::dvec4(light.w * offset, 0.0);
      const PlanarThrow thrown{ light, scene % 3 == 0 ? 0.1 : 0.0 };
      const PlanarThrow thrownThere{ lightThere, thrown.offset };
      const glm::dvec4 back = PlaneSeenFrom(planeThere, offset);
      EXPECT_NEAR(back.w, plane.w, rounding);

      const glm::dvec3 p = PointIn(2.0);
      const glm::dvec4 byMatrix =
        OffsetPlanarProjection(plane, light, thrown.offset) * glm::dvec4(p, 1.0);
      const glm::dvec4 here = ThrownOn(plane, thrown, p);
      EXPECT_LT(glm::length(byMatrix - here), 1.0e-9 * (1.0 + glm::length(here)));
      // Near the light's own height points go to infinity, and roundings with them.
      if (std::abs(here.w) < 0.1)
      {
        continue;
      }
      const glm::dvec4 there = ThrownOn(planeThere, thrownThere, p + offset);
      EXPECT_LT(glm::length(glm::dvec3(there) / there.w - offset - glm::dvec3(here) / here.w),
        1.0e3 * rounding)
        << far;

      // The view of the casters, from coordinates that begin at the middle of them.
      const glm::dvec3 towardWC(0.1, 0.2, 0.3);
      const glm::dmat4 clipFromWorld = SomeView(scene % 5 == 0);
      const glm::dmat4 clipFromThere = clipFromWorld * glm::translate(glm::dmat4(1.0), -offset);
      const LightView view = PlanarView(plane, thrown, clipFromWorld, towardWC, 0.0, 4.0);
      const LightView viewThere =
        PlanarView(planeThere, thrownThere, clipFromThere, towardWC + offset, 0.0, 4.0);
      const glm::dvec4 seen = view.clipFromView * (view.viewFromWorld * glm::dvec4(p, 1.0));
      const glm::dvec4 seenThere =
        viewThere.clipFromView * (viewThere.viewFromWorld * glm::dvec4(p + offset, 1.0));
      if (std::abs(seen.w) > 0.1)
      {
        EXPECT_LT(glm::length(glm::dvec2(seen) / seen.w - glm::dvec2(seenThere) / seenThere.w),
          1.0e3 * rounding)
          << far;
      }
    }
  }
}
