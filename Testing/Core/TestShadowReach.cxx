// Where a shadow can fall, told from bounds: held against points of boxes, shadows and frusta drawn
// by lot. An answer may err on the side of drawing more, never on the other; and where the case is
// plain it must not err at all.
#include "ShadowReach.h"

#include "BoxesByLot.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace vtkshadows;
using namespace coretest;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

// Where the way from `origin` along `along` (to its end at 1 if it `ends`) meets a solid: exact.
bool Meets(const Solid& solid, const glm::dvec3& origin, const glm::dvec3& along, bool ends)
{
  const glm::dmat3 inverse = glm::inverse(solid.axes);
  const glm::dvec3 o = inverse * (origin - solid.centre), d = inverse * along;
  double enter = 0.0, leave = ends ? 1.0 : Infinity;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double a = (-1.0 - o[axis]) / d[axis], b = (1.0 - o[axis]) / d[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

// Whether the caster stands between a place and the light.
bool IsShadowed(const Solid& caster, const glm::dvec4& light, const glm::dvec3& place)
{
  return Meets(caster, place, glm::dvec3(light) - place * light.w, light.w != 0.0);
}

}

//------------------------------------------------------------------------------
TEST(ShadowReach, HomogeneousLight)
{
  ShadowLight sun;
  sun.direction = { 0.0, 0.6, -0.8 };
  EXPECT_EQ(HomogeneousLight(sun), glm::dvec4(0.0, -0.6, 0.8, 0.0));
  ShadowLight lamp;
  lamp.position = { 1.0, 2.0, 3.0 };
  for (const LightKind kind : { LightKind::Spot, LightKind::Point })
  {
    lamp.kind = kind;
    EXPECT_EQ(HomogeneousLight(lamp), glm::dvec4(1.0, 2.0, 3.0, 1.0));
  }
}

//------------------------------------------------------------------------------
// Flat casters.

// Of doubles about 1.
constexpr double Rounding = 1.0e-15;

TEST(ShadowReach, FlatCasterInPlainCases)
{
  const glm::dvec4 floor(0.0, 0.0, 1.0, 0.5); // z = 0.5
  const BoxCorners above = CornersOf({ 0, 0, 2 }, 1.0), below = CornersOf({ 0, 0, -2 }, 1.0);
  const BoxCorners standing = CornersOf({ 0, 0, 1.5 }, 1.0), across = CornersOf({ 0, 0, 0 }, 1.0);
  ShadowLight sun;
  sun.direction = glm::normalize(glm::dvec3(0.2, 0.1, -1.0));
  ShadowLight lamp;
  lamp.kind = LightKind::Point;
  lamp.position = { 1.0, 1.0, 4.0 };
  for (const glm::dvec4& plane : { floor, -floor })
  {
    for (const ShadowLight& light : { sun, lamp })
    {
      EXPECT_TRUE(CastsOnNothing(plane, light, { above, standing }, Rounding));
      EXPECT_FALSE(CastsOnNothing(plane, light, { above, below }, Rounding));
      EXPECT_FALSE(CastsOnNothing(plane, light, { across }, Rounding));
      EXPECT_TRUE(CastsOnNothing(plane, light, {}, Rounding));
      EXPECT_FALSE(CastsOnNothing(glm::dvec4(0.0), light, { above }, Rounding)) << "it is not flat";
    }
  }
  sun.direction = -sun.direction;
  lamp.position.z = -4.0;
  for (const ShadowLight& light : { sun, lamp })
  {
    EXPECT_TRUE(CastsOnNothing(floor, light, { below }, Rounding)) << "lit from below";
    EXPECT_FALSE(CastsOnNothing(floor, light, { above }, Rounding)) << "lit from below";
  }
}

// A light ahead of the plane, and a receiver that a ray through the plane reaches.
TEST(ShadowReach, FlatCasterNeverMissesAReceiver)
{
  Lot lot(1);
  int onNothing = 0;
  for (int scene = 0; scene < Scenes; ++scene)
  {
    const glm::dvec3 normal = lot.Direction();
    const double height = lot.Any(-2.0, 2.0);
    ShadowLight light;
    light.kind = lot.Flip() ? LightKind::Directional : LightKind::Point;
    light.direction = lot.Direction();
    light.position = lot.Within(6.0);
    const Solid receiver = lot.AnySolid();
    const glm::dvec4 lightWC = HomogeneousLight(light);
    const double ofLight = glm::dot(normal, glm::dvec3(lightWC)) - height * lightWC.w;
    bool isReached = false;
    for (int i = 0; i < Samples; ++i)
    {
      const double side = glm::dot(normal, receiver.At(lot.Within(1.0))) - height;
      isReached = isReached || side * ofLight < -1.0e-4;
    }
    const bool says = CastsOnNothing({ normal, height }, light, { receiver.Corners() }, Rounding);
    EXPECT_FALSE(isReached && says) << "scene " << scene;
    onNothing += says ? 1 : 0;
  }
  EXPECT_GT(onNothing, Scenes / 10) << "it must say so sometimes";
}

//------------------------------------------------------------------------------
// Far planes.
TEST(ShadowReach, FarPlaneEndsEveryRayBeyondAllThatIsKept)
{
  Lot lot(2);
  int found = 0;
  for (int scene = 0; scene < Scenes; ++scene)
  {
    const Solid caster = lot.AnySolid(), receiver = lot.AnySolid();
    const glm::dvec4 light = lot.AnyLight();
    const Box kept = BoxOf(receiver.Corners());
    const glm::dvec4 plane = FarPlane(light, caster.Corners(), kept);
    const glm::dvec3 normal(plane);
    if (normal == glm::dvec3(0.0))
    {
      continue;
    }
    ++found;
    for (int i = 0; i < Samples; ++i)
    {
      const glm::dvec3 p = caster.At(lot.Within(1.0)), q = receiver.At(lot.Within(1.0));
      const glm::dvec3 image = ImageOnPlane(light, plane, p);
      const glm::dvec3 along = p * light.w - glm::dvec3(light);
      EXPECT_LT(glm::dot(normal, p), plane.w) << "the caster, scene " << scene;
      EXPECT_LT(glm::dot(normal, q), plane.w) << "what is kept, scene " << scene;
      EXPECT_NEAR(glm::dot(normal, image), plane.w, 1.0e-9 * glm::length(image));
      EXPECT_GT(glm::dot(image - p, along), 0.0) << "away from the light, scene " << scene;
      EXPECT_GT(glm::dot(normal, along), 0.0) << "beyond it lies nothing kept, scene " << scene;
      EXPECT_LT(glm::length(glm::cross(image - p, along)),
        1.0e-9 * glm::length(image - p) * glm::length(along));
    }
  }
  EXPECT_GT(found, Scenes * 3 / 4);
}

TEST(ShadowReach, FarPlaneIsThereForALightPlainlyOutside)
{
  Lot lot(3);
  for (int scene = 0; scene < Scenes; ++scene)
  {
    const Solid caster = lot.AnySolid(), receiver = lot.AnySolid();
    const glm::dvec4 light = lot.AnyLight();
    const Box box = BoxOf(caster.Corners());
    const glm::dvec3 away =
      glm::max(box.minimum - glm::dvec3(light), glm::dvec3(light) - box.maximum);
    if (light.w == 0.0 || std::max({ away.x, away.y, away.z }) > 0.1)
    {
      EXPECT_NE(
        glm::dvec3(FarPlane(light, caster.Corners(), BoxOf(receiver.Corners()))), glm::dvec3(0.0))
        << "scene " << scene;
    }
    // Amid the caster's bounds its rays go everywhere.
    EXPECT_EQ(glm::dvec3(FarPlane(glm::dvec4(0.5 * (box.minimum + box.maximum), 1.0),
                caster.Corners(), BoxOf(receiver.Corners()))),
      glm::dvec3(0.0));
  }
}

TEST(ShadowReach, FarPlaneIsTheNearest)
{
  const BoxCorners caster = CornersOf({ 0, 0, 3 }, 0.5);
  const Box kept = BoxOf(Upright({ 0, 0, 0 }, { 5, 5, 1 }).Corners());
  const glm::dvec4 straight = FarPlane({ 0, 0, 1, 0 }, caster, kept);
  EXPECT_EQ(glm::dvec3(straight), glm::dvec3(0, 0, -1));
  EXPECT_NEAR(straight.w, 1.0, 0.05) << "just under what is kept";
  EXPECT_GT(straight.w, 1.0);
  const glm::dvec4 lamp = FarPlane({ 0, 0.2, 6, 1 }, caster, kept);
  EXPECT_EQ(glm::dvec3(lamp), glm::dvec3(0, 0, -1));
  // Flat along x: the side that is left soonest is the one ahead.
  const glm::dvec4 low =
    FarPlane(glm::dvec4(glm::normalize(glm::dvec3(-1, 0, 0.05)), 0), caster, kept);
  EXPECT_EQ(glm::dvec3(low), glm::dvec3(1, 0, 0));
}

// No way from a receiver back to a parallel eye leaves by the plane.
TEST(ShadowReach, FarPlaneIsNeverBetweenAParallelEyeAndWhatItSees)
{
  Lot lot(4);
  int found = 0;
  for (int scene = 0; scene < Scenes; ++scene)
  {
    const Solid caster = lot.AnySolid(), receiver = lot.AnySolid();
    const glm::dvec4 light = lot.AnyLight();
    const glm::dvec3 backward = lot.Direction();
    const glm::dvec4 plane = FarPlane(light, caster.Corners(), BoxOf(receiver.Corners()), backward);
    if (glm::dvec3(plane) == glm::dvec3(0.0))
    {
      continue;
    }
    ++found;
    const glm::dvec3 q = receiver.At(lot.Within(1.0));
    for (const double way : { 0.0, 1.0, 1000.0 })
    {
      EXPECT_LE(glm::dot(glm::dvec3(plane), q + way * backward), plane.w) << "scene " << scene;
    }
  }
  EXPECT_GT(found, Scenes / 3);
}

//------------------------------------------------------------------------------
// Shadows in a view, and on receivers.
TEST(ShadowReach, AShadowThatIsSeenMayBeSeen)
{
  Lot lot(5);
  int seen = 0, refused = 0;
  for (int scene = 0; scene < Scenes; ++scene)
  {
    const Solid caster = lot.AnySolid();
    const glm::dvec4 light = lot.AnyLight();
    const View view = lot.AnyView();
    bool isSeen = false;
    for (int i = 0; i < Samples; ++i)
    {
      const glm::dvec3 place = lot.InShadow(caster, light);
      isSeen = isSeen || IsInView(view.ClipFromWorld() * glm::dvec4(place, 1.0));
    }
    const bool says = ShadowMayBeSeen(view.ClipFromWorld(), light, caster.Corners());
    EXPECT_TRUE(says || !isSeen) << "scene " << scene;
    seen += isSeen ? 1 : 0;
    refused += says ? 0 : 1;
  }
  EXPECT_GT(seen, Scenes / 5);
  EXPECT_GT(refused, Scenes / 10);
}

TEST(ShadowReach, AShadowPlainlyElsewhereIsNotSeen)
{
  for (const bool parallel : { false, true })
  {
    // Along +x.
    const glm::dmat4 clip = LookFrom({ 0, 0, 0 }, { 1, 0, 0 }, parallel).ClipFromWorld();
    const glm::dvec4 sunAhead(1, 0, 0, 0), sunBehind(-1, 0, 0, 0);
    const glm::dvec4 sunAbove(0, 0, 1, 0), lamp(-5, 0, 0, 1);
    EXPECT_FALSE(ShadowMayBeSeen(clip, sunAhead, CornersOf({ -5, 0, 0 }, 1.0))) << "behind the eye";
    EXPECT_TRUE(ShadowMayBeSeen(clip, sunBehind, CornersOf({ -5, 0, 0 }, 1.0)))
      << "behind the eye, its shadow thrown ahead";
    EXPECT_FALSE(ShadowMayBeSeen(clip, sunAbove, CornersOf({ 5, 0, -9 }, 1.0))) << "below";
    EXPECT_TRUE(ShadowMayBeSeen(clip, sunAbove, CornersOf({ 5, 0, 9 }, 1.0))) << "above";
    EXPECT_FALSE(ShadowMayBeSeen(clip, lamp, CornersOf({ -7, 0, 0 }, 1.0))) << "behind the lamp";
    EXPECT_FALSE(ShadowMayBeSeen(clip, sunBehind, CornersOf({ 60, 0, 0 }, 1.0)))
      << "beyond the far plane";
  }
}

// Of a light with a size, on receivers, whatever the view's depths.
TEST(ShadowReach, ASoftShadowThatIsSeenMayBeSeen)
{
  Lot lot(7);
  int seen = 0, refused = 0;
  for (int scene = 0; scene < Scenes; ++scene)
  {
    const Solid caster = lot.AnySolid();
    const glm::dvec4 light = lot.AnyLight();
    const double radius = lot.Flip() ? 0.0 : lot.Any(0.0, light.w != 0.0 ? 1.0 : 0.3);
    const Box receivers = BoxOf(lot.AnySolid(5.0).Corners()).Grown(lot.Any(0.0, 5.0));
    const View view = lot.AnyView();
    bool isSeen = false;
    for (int i = 0; i < Samples; ++i)
    {
      const glm::dvec4 sample = light + glm::dvec4(lot.Within(radius), 0.0);
      const glm::dvec3 place = lot.InShadow(caster, sample);
      const glm::dvec4 clip = view.ClipFromWorld() * glm::dvec4(place, 1.0);
      isSeen = isSeen ||
        (clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w &&
          receivers.Holds(place));
    }
    const bool says =
      SoftShadowMayBeSeen(view.ClipFromWorld(), light, radius, caster.Corners(), receivers);
    EXPECT_TRUE(says || !isSeen) << "scene " << scene;
    seen += isSeen ? 1 : 0;
    refused += says ? 0 : 1;
  }
  EXPECT_GT(seen, Scenes / 20);
  EXPECT_GT(refused, Scenes / 10);
}

TEST(ShadowReach, ASoftShadowEndsBehindTheReceivers)
{
  const Box floor = BoxOf(Upright({ 0, 0, 0 }, { 50, 50, 0 }).Corners());
  const glm::dvec4 sun(-1, 0, 1, 0); // its shadows go toward +x, down
  const BoxCorners ball = CornersOf({ 0, 0, 2 }, 0.5);
  const auto looksAt = [](double x) {
    return LookFrom({ x, -4, 4 }, { x, 0, 0 }, false).ClipFromWorld();
  };
  EXPECT_TRUE(SoftShadowMayBeSeen(looksAt(2.0), sun, 0.0, ball, floor));
  EXPECT_FALSE(SoftShadowMayBeSeen(looksAt(9.0), sun, 0.0, ball, floor)) << "farther on, below it";
  EXPECT_TRUE(SoftShadowMayBeSeen(looksAt(9.0), sun, 0.8, ball, floor))
    << "a wide light's penumbra";
}

// What a box shadows, or holds, is beyond no side that the light is beyond; and of what it does not
// shadow, a good part is.
TEST(ShadowReach, SidesTowardLight)
{
  Lot lot(8);
  int shadowed = 0, beyond = 0, lit = 0;
  for (int scene = 0; scene < Scenes; ++scene)
  {
    Solid caster = lot.AnySolid();
    if (scene % 4 == 0)
    {
      caster.axes[scene / 4 % 3] *= 1.0e-15; // flat
    }
    const glm::dvec4 light = lot.AnyLight();
    const double radius = lot.Flip() ? 0.0 : lot.Any(0.0, light.w != 0.0 ? 1.0 : 0.3);
    const std::vector<glm::dvec4> sides = SidesTowardLight(light, radius, caster.Corners());
    EXPECT_LE(sides.size(), 3u);
    for (int i = 0; i < Samples; ++i)
    {
      const glm::dvec4 sample =
        light + glm::dvec4(radius * lot.Any(0.0, 1.0) * lot.Direction(), 0.0);
      const glm::dvec3 place = i % 2 == 0 ? lot.InShadow(caster, sample) : lot.Within(6.0);
      const bool isBeyond = std::any_of(sides.begin(), sides.end(),
        [&](const glm::dvec4& side)
        { return glm::dot(glm::dvec3(side), place) > side.w + 1.0e-12; });
      const bool isShadowed = i % 2 == 0 || IsShadowed(caster, sample, place);
      EXPECT_FALSE(isBeyond && isShadowed) << "scene " << scene;
      shadowed += isShadowed ? 1 : 0;
      beyond += isBeyond ? 1 : 0;
      lit += isShadowed ? 0 : 1;
    }
  }
  EXPECT_GT(shadowed, 1000);
  EXPECT_GT(beyond, lit / 3);
}

TEST(ShadowReach, AShadowOnReceiversMayReachThem)
{
  Lot lot(6);
  int reached = 0, refused = 0;
  for (int scene = 0; scene < Scenes; ++scene)
  {
    const Solid caster = lot.AnySolid();
    const glm::dvec4 light = lot.AnyLight();
    const Box receivers = BoxOf(lot.AnySolid(5.0).Corners());
    bool isReached = false;
    for (int i = 0; i < Samples; ++i)
    {
      const glm::dvec3 place = lot.InShadow(caster, light);
      isReached = isReached ||
        (glm::all(glm::greaterThanEqual(place, receivers.minimum)) &&
          glm::all(glm::lessThanEqual(place, receivers.maximum)));
    }
    const bool says = ShadowMayReach(receivers, light, caster.Corners());
    EXPECT_TRUE(says || !isReached) << "scene " << scene;
    reached += isReached ? 1 : 0;
    refused += says ? 0 : 1;
  }
  EXPECT_GT(reached, Scenes / 50);
  EXPECT_GT(refused, Scenes / 10);
}

TEST(ShadowReach, AShadowPlainlyElsewhereReachesNothing)
{
  const Box receivers = BoxOf(CornersOf({ 0, 0, 0 }, 1.0));
  const glm::dvec4 sun(0, 0, 1, 0), lamp(0, 0, 5, 1);
  for (const glm::dvec4& light : { sun, lamp })
  {
    EXPECT_TRUE(ShadowMayReach(receivers, light, CornersOf({ 0, 0, 3 }, 0.5)));
    EXPECT_FALSE(ShadowMayReach(receivers, light, CornersOf({ 0, 0, -3 }, 0.5))) << "below";
    EXPECT_FALSE(ShadowMayReach(receivers, light, CornersOf({ 9, 0, 3 }, 0.5))) << "beside";
    EXPECT_FALSE(ShadowMayReach(Box(), light, CornersOf({ 0, 0, 3 }, 0.5))) << "no receivers";
  }
  EXPECT_FALSE(ShadowMayReach(receivers, lamp, CornersOf({ 0, 0, 8 }, 0.5))) << "above the lamp";
}

//------------------------------------------------------------------------------
// The eye and its near plane.
TEST(ShadowReach, ANearPlaneInShadowMayBeShadowed)
{
  Lot lot(7);
  int shadowed = 0, refused = 0;
  for (int scene = 0; scene < Scenes; ++scene)
  {
    const Solid caster = lot.AnySolid();
    const glm::dvec4 light = lot.AnyLight();
    const View view = lot.AnyView();
    const std::array<glm::dvec3, 4> quad = NearQuad(view.ClipFromWorld());
    bool isShadowed = false;
    for (int i = 0; i < Samples; ++i)
    {
      const double u = lot.Any(0.0, 1.0), v = lot.Any(0.0, 1.0);
      const glm::dvec3 place = quad[0] + u * (quad[1] - quad[0]) + v * (quad[3] - quad[0]);
      isShadowed = isShadowed || IsShadowed(caster, light, place);
    }
    const bool says = NearPlaneMayBeShadowed(view.ClipFromWorld(), light, caster.Corners());
    EXPECT_TRUE(says || !isShadowed) << "scene " << scene;
    shadowed += isShadowed ? 1 : 0;
    refused += says ? 0 : 1;
  }
  EXPECT_GT(shadowed, Scenes / 10);
  EXPECT_GT(refused, Scenes / 3);
}

TEST(ShadowReach, ANearPlanePlainlyLitIsNotShadowed)
{
  for (const bool parallel : { false, true })
  {
    // Along +x; the near plane at x = 0.5, at most 1.3 wide.
    const glm::dmat4 clip = LookFrom({ 0, 0, 0 }, { 1, 0, 0 }, parallel).ClipFromWorld();
    const glm::dvec4 sun(1, 0, 1, 0), lamp(9, 0, 9, 1), behind(-9, 0, 0, 1);
    for (const glm::dvec4& light : { sun, lamp })
    {
      EXPECT_TRUE(NearPlaneMayBeShadowed(clip, light, CornersOf({ 4.5, 0, 4 }, 0.5)));
      EXPECT_FALSE(NearPlaneMayBeShadowed(clip, light, CornersOf({ 9, 0, 4 }, 0.5))) << "ahead";
      EXPECT_FALSE(NearPlaneMayBeShadowed(clip, light, CornersOf({ 0.5, 0, -4 }, 0.5))) << "below";
      EXPECT_FALSE(NearPlaneMayBeShadowed(clip, light, CornersOf({ 4.5, 4, 4 }, 0.5))) << "beside";
    }
    EXPECT_FALSE(NearPlaneMayBeShadowed(clip, lamp, CornersOf({ 12, 0, 12 }, 0.5)))
      << "above the lamp";
    EXPECT_TRUE(NearPlaneMayBeShadowed(clip, behind, CornersOf({ -4, 0, 0 }, 0.5)));
    EXPECT_FALSE(NearPlaneMayBeShadowed(clip, behind, CornersOf({ 4, 0, 0 }, 0.5)))
      << "ahead of the eye, the lamp behind";
    EXPECT_TRUE(NearPlaneMayBeShadowed(clip, sun, CornersOf({ 0.5, 0, 0 }, 0.1))) << "cut";
  }
}

TEST(ShadowReach, AnEyeInShadowMayBeShadowed)
{
  Lot lot(8);
  int shadowed[2] = { 0, 0 }, refused[2] = { 0, 0 };
  for (int scene = 0; scene < 10 * Scenes; ++scene)
  {
    const Solid caster = lot.AnySolid();
    const glm::dvec4 light = lot.AnyLight();
    const bool parallel = lot.Flip();
    const glm::dvec4 eye =
      parallel ? glm::dvec4(lot.Direction(), 0.0) : glm::dvec4(lot.Within(5.0), 1.0);
    if (parallel && light.w == 0.0)
    {
      continue;
    }
    // From the one that has a place.
    const auto isHit = [&](const Solid& solid)
    {
      return parallel ? Meets(solid, glm::dvec3(light), glm::dvec3(eye), false)
                      : IsShadowed(solid, light, glm::dvec3(eye));
    };
    const bool says = EyeMayBeShadowed(eye, light, caster.Corners());
    EXPECT_TRUE(says || !isHit(caster)) << "scene " << scene;
    // It knows the bounds alone, and adds a little.
    const Box box = BoxOf(caster.Corners());
    const bool isNear = isHit(Upright(
      0.5 * (box.minimum + box.maximum), 0.5 * (box.maximum - box.minimum) + glm::dvec3(0.01)));
    EXPECT_TRUE(isNear || !says) << "scene " << scene;
    shadowed[parallel] += isHit(caster) ? 1 : 0;
    refused[parallel] += says ? 0 : 1;
  }
  for (const int parallel : { 0, 1 })
  {
    EXPECT_GT(shadowed[parallel], Scenes / 100);
    EXPECT_GT(refused[parallel], Scenes / 2);
  }
}

// Both at infinity: the shadow of what has an end reaches the eye only where the light shines
// straight at it.
TEST(ShadowReach, AParallelEyeAndASun)
{
  const glm::dvec4 eye(0, 0, 1, 0); // looks down
  const BoxCorners caster = CornersOf({ 0, 0, 0 }, 1.0);
  const auto lightAt = [](double degrees)
  { return glm::dvec4(std::sin(glm::radians(degrees)), 0.0, -std::cos(glm::radians(degrees)), 0); };
  EXPECT_TRUE(EyeMayBeShadowed(eye, lightAt(0.0), caster)) << "straight ahead";
  EXPECT_FALSE(EyeMayBeShadowed(eye, lightAt(10.0), caster)) << "10 degrees from straight ahead";
  EXPECT_FALSE(EyeMayBeShadowed(eye, lightAt(90.0), caster)) << "from the side";
  EXPECT_FALSE(EyeMayBeShadowed(eye, lightAt(180.0), caster)) << "from the eye";
}

// An axis along which the way does not lead at all.
TEST(ShadowReach, AnEyeInLineWithAnAxis)
{
  const glm::dvec4 eye(0, 0, 0, 1), light(0, 0, 9, 1), sun(0, 0, 1, 0);
  for (const glm::dvec4& toward : { light, sun })
  {
    EXPECT_TRUE(EyeMayBeShadowed(eye, toward, CornersOf({ 0, 0, 4 }, 1.0)));
    EXPECT_FALSE(EyeMayBeShadowed(eye, toward, CornersOf({ 2, 0, 4 }, 1.0)));
    EXPECT_FALSE(EyeMayBeShadowed(eye, toward, CornersOf({ 0, 0, -4 }, 1.0)));
  }
  EXPECT_FALSE(EyeMayBeShadowed(eye, light, CornersOf({ 0, 0, 12 }, 1.0))) << "beyond the lamp";
}

//------------------------------------------------------------------------------
// Bounds of volumes in the viewport.
TEST(ShadowReach, BoundsHoldAllOfAVolumeThatIsSeen)
{
  Lot lot(10);
  int seen = 0, bounded = 0;
  for (int scene = 0; scene < Scenes; ++scene)
  {
    const Solid caster = lot.AnySolid(), receiver = lot.AnySolid();
    const glm::dvec4 light = lot.AnyLight();
    const View view = lot.AnyView();
    const glm::dvec4 plane = FarPlane(light, caster.Corners(), BoxOf(receiver.Corners()));
    const ViewBounds bounds = BoundsInView(view.ClipFromWorld(), light, caster.Corners(), plane);
    bounded += bounds.minimum != glm::dvec3(-1.0) || bounds.maximum != glm::dvec3(1.0) ? 1 : 0;
    if (glm::dvec3(plane) == glm::dvec3(0.0))
    {
      EXPECT_EQ(bounds.minimum, glm::dvec3(-1.0)) << "to infinity: all of the view";
      EXPECT_EQ(bounds.maximum, glm::dvec3(1.0)) << "to infinity: all of the view";
      continue;
    }
    for (int i = 0; i < Samples; ++i)
    {
      const glm::dvec3 p = caster.At(lot.Within(1.0));
      const glm::dvec3 place = glm::mix(p, ImageOnPlane(light, plane, p), lot.Any(0.0, 1.0));
      const glm::dvec4 clip = view.ClipFromWorld() * glm::dvec4(place, 1.0);
      if (IsInView(clip))
      {
        ++seen;
        const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(ndc, bounds.minimum - 1.0e-9)))
          << "scene " << scene;
        EXPECT_TRUE(glm::all(glm::lessThanEqual(ndc, bounds.maximum + 1.0e-9)))
          << "scene " << scene;
      }
    }
  }
  EXPECT_GT(seen, Scenes);
  EXPECT_GT(bounded, Scenes / 20);
}

TEST(ShadowReach, BoundsAreTight)
{
  // From above, 1 up and down is 1 unit; the shadow of a small box falls straight down.
  View view = LookFrom({ 0, 0, 10 }, { 0, 0, 0 }, true, 1.0, 21.0);
  view.viewFromWorld = glm::lookAt(glm::dvec3(0, 0, 10), glm::dvec3(0), glm::dvec3(0, 1, 0));
  const BoxCorners caster = CornersOf({ 0.2, 0.3, 1.0 }, 0.1);
  const Box kept = BoxOf(Upright({ 0, 0, 0 }, { 1, 1, 0.1 }).Corners());
  const glm::dvec4 sun(0, 0, 1, 0);
  const ViewBounds bounds =
    BoundsInView(view.ClipFromWorld(), sun, caster, FarPlane(sun, caster, kept));
  EXPECT_NEAR(bounds.minimum.x, 0.1 / 1.3, 1.0e-9);
  EXPECT_NEAR(bounds.maximum.x, 0.3 / 1.3, 1.0e-9);
  EXPECT_NEAR(bounds.minimum.y, 0.2, 1.0e-9);
  EXPECT_NEAR(bounds.maximum.y, 0.4, 1.0e-9);
  // Beside what is seen it is empty, behind a perspective eye it is all.
  const BoxCorners beside = CornersOf({ 5.0, 0.0, 1.0 }, 0.1);
  const ViewBounds none =
    BoundsInView(view.ClipFromWorld(), sun, beside, FarPlane(sun, beside, kept));
  EXPECT_EQ(none.minimum.x, none.maximum.x);
  const View eye = LookFrom({ 0, 0, 0.5 }, { 1, 0, 0.5 }, false);
  const BoxCorners behind = CornersOf({ 0.0, 0.0, 1.0 }, 0.1);
  const ViewBounds all =
    BoundsInView(eye.ClipFromWorld(), sun, behind, FarPlane(sun, behind, kept));
  EXPECT_EQ(all.minimum, glm::dvec3(-1.0));
  EXPECT_EQ(all.maximum, glm::dvec3(1.0));
}
