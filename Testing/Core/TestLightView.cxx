// A light's view must hold every caster that can shadow a receiver, be tight, and say what it
// cannot do.
#include "LightView.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec4.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace vtkshadows;

namespace
{

constexpr double Margin = 2.0 / 2048.0;

BoxCorners Box(const glm::dvec3& centre, const glm::dvec3& half)
{
  BoxCorners corners;
  for (int i = 0; i < 8; ++i)
  {
    corners[i] = centre + half * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  }
  return corners;
}

ShadowLight Directional(const glm::dvec3& along)
{
  ShadowLight light;
  light.kind = LightKind::Directional;
  light.direction = glm::normalize(along);
  return light;
}

ShadowLight Spot(const glm::dvec3& position, const glm::dvec3& toward, double coneAngle)
{
  ShadowLight light;
  light.kind = LightKind::Spot;
  light.position = position;
  light.direction = glm::normalize(toward - position);
  light.coneAngle = coneAngle;
  return light;
}

ShadowLight Point(const glm::dvec3& position)
{
  ShadowLight light = Spot(position, position - glm::dvec3(0, 0, 1), 0.0);
  light.kind = LightKind::Point;
  return light;
}

glm::dvec3 ToNdc(const LightView& view, const glm::dvec3& pointWC)
{
  const glm::dvec4 clip = view.clipFromView * view.viewFromWorld * glm::dvec4(pointWC, 1.0);
  return glm::dvec3(clip) / clip.w;
}

// Largest |x|, |y| and |z| of the corners in normalised device coordinates.
glm::dvec3 Reach(const LightView& view, const BoxCorners& corners)
{
  glm::dvec3 reach(0.0);
  for (const glm::dvec3& corner : corners)
  {
    reach = glm::max(reach, glm::abs(ToNdc(view, corner)));
  }
  return reach;
}

const BoxCorners Caster = Box({ 0.0, 0.0, 1.0 }, { 1.0, 0.5, 0.4 });
const BoxCorners Floor = Box({ 0.0, 0.0, -1.0 }, { 50.0, 50.0, 0.0 });

}

TEST(LightView, DirectionalHoldsItsCasterTightly)
{
  const LightViewResult result =
    FitLightView(Directional({ 0.3, -0.2, -1.0 }), { Caster }, { Caster, Floor }, Margin);
  ASSERT_EQ(result.fit, LightViewFit::Fitted);
  EXPECT_TRUE(result.view.parallel);
  const glm::dvec3 reach = Reach(result.view, Caster);
  EXPECT_LE(reach.x, 1.0);
  EXPECT_LE(reach.y, 1.0);
  EXPECT_LE(reach.z, 1.0);
  // The longer side is full but for its margin of 2 texels of 2048 on each side.
  EXPECT_NEAR(std::max(reach.x, reach.y), 1.0 - 4.0 / 2048.0, 1e-9);
}

TEST(LightView, TheRectangleIsTurnedToTheCaster)
{
  // A plank across the axes, seen from above: a rectangle along the axes would waste half of the
  // map.
  BoxCorners plank = Box({ 0.0, 0.0, 1.0 }, { 4.0, 0.2, 0.1 });
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(0, 0, 1));
  for (glm::dvec3& corner : plank)
  {
    corner = glm::dvec3(turn * glm::dvec4(corner, 1.0));
  }
  const LightViewResult result =
    FitLightView(Directional({ 0, 0, -1 }), { plank }, { plank, Floor }, 0.0);
  ASSERT_EQ(result.fit, LightViewFit::Fitted);
  const double width = 2.0 / result.view.clipFromView[0][0];
  const double height = 2.0 / result.view.clipFromView[1][1];
  EXPECT_NEAR(std::max(width, height), 8.0, 1e-9);
  EXPECT_NEAR(std::min(width, height), 0.4, 1e-9);
}

TEST(LightView, OnlyWhatShadowsAReceiverFillsTheMap)
{
  // Of two casters one stands above the receiver.
  const BoxCorners aside = Box({ 100.0, 0.0, 1.0 }, { 1.0, 1.0, 1.0 });
  const BoxCorners tile = Box({ 0.0, 0.0, -1.0 }, { 1.0, 0.5, 0.0 });
  const LightViewResult result =
    FitLightView(Directional({ 0, 0, -1 }), { Caster, aside }, { tile }, 0.0);
  ASSERT_EQ(result.fit, LightViewFit::Fitted);
  EXPECT_NEAR(
    2.0 / result.view.clipFromView[0][0] * 2.0 / result.view.clipFromView[1][1], 2.0, 1e-9);
}

TEST(LightView, NothingToCastOnIsEmpty)
{
  const ShadowLight down = Directional({ 0, 0, -1 });
  const BoxCorners above = Box({ 0.0, 0.0, 9.0 }, { 1.0, 1.0, 0.1 });
  EXPECT_EQ(FitLightView(down, { Caster }, { above }, Margin).fit, LightViewFit::Empty);
  EXPECT_EQ(FitLightView(down, {}, { Floor }, Margin).fit, LightViewFit::Empty);
  EXPECT_EQ(FitLightView(down, { Caster }, {}, Margin).fit, LightViewFit::Empty);
  // The caster lies behind the spot, or beside its cone.
  const ShadowLight away = Spot({ 0, 0, 5 }, { 0, 0, 9 }, 20.0);
  EXPECT_EQ(FitLightView(away, { Caster }, { Caster, Floor }, Margin).fit, LightViewFit::Empty);
}

TEST(LightView, SpotHoldsItsCastersAndLooksAtThem)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int i = 0; i < 200; ++i)
  {
    const glm::dvec3 away(any(random), any(random), any(random));
    const glm::dvec3 position = glm::dvec3(0, 0, 1) + (3.0 + i) * glm::normalize(away);
    const LightViewResult result =
      FitLightView(Spot(position, { 0, 0, 1 }, 60.0), { Caster }, { Caster, Floor }, Margin);
    ASSERT_EQ(result.fit, LightViewFit::Fitted) << "light " << i;
    EXPECT_FALSE(result.view.parallel);
    const glm::dvec3 reach = Reach(result.view, Caster);
    EXPECT_LE(std::max({ reach.x, reach.y, reach.z }), 1.0) << "light " << i;
    EXPECT_GT(std::max(reach.x, reach.y), 0.9) << "light " << i;
  }
}

TEST(LightView, ANarrowConeConfinesTheMap)
{
  const LightViewResult wide =
    FitLightView(Spot({ 0, 0, 9 }, { 0, 0, 1 }, 60.0), { Caster }, { Caster, Floor }, 0.0);
  const LightViewResult narrow =
    FitLightView(Spot({ 0, 0, 9 }, { 0, 0, 1 }, 1.0), { Caster }, { Caster, Floor }, 0.0);
  ASSERT_EQ(wide.fit, LightViewFit::Fitted);
  ASSERT_EQ(narrow.fit, LightViewFit::Fitted);
  // Its half-angle's tangent, circumscribed by a polygon of 64 sides.
  const double tangent = std::tan(glm::radians(1.0));
  const double nearDepth = narrow.view.clipFromView[3][2] / (narrow.view.clipFromView[2][2] - 1.0);
  EXPECT_GT(nearDepth, 0.0);
  EXPECT_NEAR(1.0 / narrow.view.clipFromView[0][0], tangent, 0.002 * tangent);
  EXPECT_NEAR(1.0 / narrow.view.clipFromView[1][1], tangent, 0.002 * tangent);
  EXPECT_LT(wide.view.clipFromView[0][0], narrow.view.clipFromView[0][0]);
}

TEST(LightView, AmidItsCasters)
{
  const BoxCorners room = Box({ 0, 0, 0 }, { 5.0, 5.0, 5.0 });
  // A cone fits one view up to 78.6 degrees; beyond that, and for a point light, it takes several.
  for (const double cone : { 10.0, 60.0, 78.0, 78.5 })
  {
    const ShadowLight light = Spot({ 0, 0, 1 }, { 0, 0, 0 }, cone);
    const LightViewResult result = FitLightView(light, { room }, { room }, Margin);
    ASSERT_EQ(result.fit, LightViewFit::Fitted) << "cone " << cone;
    EXPECT_TRUE(std::isfinite(result.view.clipFromView[0][0])) << "cone " << cone;
    EXPECT_GT(result.view.clipFromView[0][0], 0.1) << "cone " << cone;
    const LightViews views = FitLightViews(light, { room }, { room }, Margin);
    EXPECT_FALSE(views.isCube) << "cone " << cone;
    EXPECT_EQ(views.views.size(), 1u) << "cone " << cone;
  }
  for (const double cone : { 78.68, 80.0, 89.0, 89.5 })
  {
    const ShadowLight light = Spot({ 0, 0, 1 }, { 0, 0, 0 }, cone);
    EXPECT_EQ(FitLightView(light, { room }, { room }, Margin).fit, LightViewFit::Refused);
    // None behind it.
    const LightViews views = FitLightViews(light, { room }, { room }, Margin);
    EXPECT_TRUE(views.isCube) << "cone " << cone;
    EXPECT_EQ(views.views.size(), 5u) << "cone " << cone;
  }
  const ShadowLight point = Point({ 0, 0, 1 });
  EXPECT_EQ(FitLightView(point, { room }, { room }, Margin).fit, LightViewFit::Refused);
  const LightViews views = FitLightViews(point, { room }, { room }, Margin);
  EXPECT_TRUE(views.isCube);
  EXPECT_EQ(views.views.size(), 6u);
}

// Where one view holds the light, it is the only one, with every caster.
TEST(LightViews, OneWhereOneWillDo)
{
  const BoxCorners other = Box({ 0.5, 0.0, 2.0 }, { 0.2, 0.2, 0.2 });
  for (const ShadowLight& light :
    { Directional({ 0.3, -0.2, -1.0 }), Spot({ 0, 0, 9 }, { 0, 0, 1 }, 89.0), Point({ 2, -3, 6 }) })
  {
    const std::vector<BoxCorners> casters = { Caster, other };
    const LightViewResult one = FitLightView(light, casters, { Floor }, Margin);
    const LightViews views = FitLightViews(light, casters, { Floor }, Margin);
    EXPECT_FALSE(views.isCube);
    ASSERT_EQ(views.views.size(), 1u);
    EXPECT_EQ(views.views[0].face, NoFace);
    EXPECT_EQ(views.views[0].view.clipFromView, one.view.clipFromView);
    EXPECT_EQ(views.views[0].view.viewFromWorld, one.view.viewFromWorld);
    EXPECT_EQ(views.views[0].casters, (std::vector<std::size_t>{ 0, 1 }));
  }
  EXPECT_TRUE(FitLightViews(Point({ 0, 0, 9 }), {}, { Floor }, Margin).views.empty());
  EXPECT_TRUE(FitLightViews(Point({ 0, 0, 9 }), { Caster }, {}, Margin).views.empty());
}

// A point of a caster that can shadow a receiver lies in the view of the face that the receiver's
// direction chooses, wherever light, casters and receivers are.
TEST(LightViews, HoldWhatCanShadowAReceiver)
{
  std::mt19937 random(11);
  const auto any = [&random](double low, double high)
  { return low + (high - low) * (random() / double(random.max())); };
  const auto anyBox = [&any]()
  {
    BoxCorners box = Box({ 0, 0, 0 }, { any(0.1, 2.0), any(0.1, 2.0), any(0.0, 0.5) });
    const glm::dmat4 turn =
      glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(any(-5, 5), any(-5, 5), any(-5, 5))),
        any(0.0, 6.0), glm::normalize(glm::dvec3(any(-1, 1), any(-1, 1), any(0.1, 1))));
    for (glm::dvec3& corner : box)
    {
      corner = glm::dvec3(turn * glm::dvec4(corner, 1.0));
    }
    return box;
  };
  const auto inBox = [&any](const BoxCorners& box)
  {
    return box[0] + any(0, 1) * (box[1] - box[0]) + any(0, 1) * (box[2] - box[0]) +
      any(0, 1) * (box[4] - box[0]);
  };
  int cubes = 0, asked = 0;
  for (int round = 0; round < 300; ++round)
  {
    std::vector<BoxCorners> casters, receivers;
    for (int i = 0; i < 4; ++i)
    {
      casters.push_back(anyBox());
      receivers.push_back(anyBox());
    }
    // Anywhere, at a caster's corner, inside of one.
    const glm::dvec3 place = round % 3 == 0 ? glm::dvec3(any(-2, 2), any(-2, 2), any(-2, 2))
      : round % 3 == 1                      ? casters[0][round % 8]
                                            : inBox(casters[0]);
    const glm::dvec3 toward = place + glm::dvec3(any(-1, 1), any(-1, 1), any(-1, 1));
    const double cone = any(5.0, 89.5);
    const ShadowLight light = round % 2 == 0 ? Point(place) : Spot(place, toward, cone);
    for (std::size_t i = 0; i < 24; ++i)
    {
      const std::size_t caster = i % casters.size();
      const glm::dvec3 p = inBox(casters[caster]);
      const glm::dvec3 ray = glm::normalize(p - place);
      const bool isOut = light.kind == LightKind::Spot &&
        glm::dot(ray, light.direction) < std::cos(glm::radians(light.coneAngle));
      if (isOut || glm::distance(p, place) < 0.05)
      {
        continue;
      }
      receivers.back() = Box(p + 1e-9 * ray, glm::dvec3(0.0)); // it falls on its own far side
      const LightViews views = FitLightViews(light, casters, receivers, Margin);
      cubes += views.isCube ? 1 : 0;
      ++asked;
      int holders = 0;
      const glm::dvec3 q = glm::dvec3(views.cubeFromWorld * glm::dvec4(p, 1.0));
      const glm::dvec3 a = glm::abs(q);
      const int axis = a.x >= std::max(a.y, a.z) ? 0 : a.y >= a.z ? 1 : 2;
      const int face = 2 * axis + (q[axis] < 0.0 ? 1 : 0);
      for (const FittedLightView& fitted : views.views)
      {
        const glm::dvec3 ndc = glm::abs(ToNdc(fitted.view, p));
        const bool lists = std::count(fitted.casters.begin(), fitted.casters.end(), caster) == 1;
        holders += lists && (!views.isCube || fitted.face == face) &&
            std::max({ ndc.x, ndc.y, ndc.z }) <= 1.0
          ? 1
          : 0;
      }
      EXPECT_EQ(holders, 1) << "round " << round << ", point " << i;
    }
  }
  EXPECT_GT(cubes, 2000);
  EXPECT_GT(asked, 3000);
  EXPECT_LT(cubes, asked);
}

// As the lookup has it: depth |m|, tangents -s/m to the right and t/|m| up.
TEST(LightViews, FacesLieAsTheyAreSaidTo)
{
  const BoxCorners room = Box({ 0, 0, 0 }, { 5.0, 4.0, 3.0 });
  for (const ShadowLight& light :
    { Point({ 1, -2, 0.5 }), Spot({ 1, -2, 0.5 }, { -3, 1, 2 }, 89.0) })
  {
    const LightViews views = FitLightViews(light, { room }, { room }, Margin);
    ASSERT_TRUE(views.isCube);
    EXPECT_NEAR(glm::determinant(glm::dmat3(views.cubeFromWorld)), 1.0, 1e-12);
    for (const FittedLightView& fitted : views.views)
    {
      const int axis = fitted.face / 2;
      glm::dvec3 q;
      q[axis] = fitted.face % 2 == 0 ? 2.0 : -2.0;
      q[(axis + 1) % 3] = 0.7;
      q[(axis + 2) % 3] = -1.1;
      const glm::dvec3 p = glm::dvec3(glm::inverse(views.cubeFromWorld) * glm::dvec4(q, 1.0));
      const glm::dvec3 seen = glm::dvec3(fitted.view.viewFromWorld * glm::dvec4(p, 1.0));
      EXPECT_NEAR(seen.x, -0.7 * 2.0 / q[axis], 1e-12) << "face " << fitted.face;
      EXPECT_NEAR(seen.y, -1.1, 1e-12) << "face " << fitted.face;
      EXPECT_NEAR(seen.z, -2.0, 1e-12) << "face " << fitted.face;
      // 45 degrees, and the margin.
      const double side = (1.0 - 2.0 * Margin) * 1.0;
      EXPECT_NEAR(fitted.view.clipFromView[0][0], side, 1e-12);
      EXPECT_NEAR(fitted.view.clipFromView[1][1], side, 1e-12);
    }
  }
}

TEST(LightViews, FacesWithoutCastersAreLeftOut)
{
  // Balls to both sides along x; a receiver on one side alone, behind its ball.
  const BoxCorners right = Box({ 3, 0, 0 }, { 0.5, 0.5, 0.5 });
  const BoxCorners left = Box({ -3, 0, 0 }, { 0.5, 0.5, 0.5 });
  const BoxCorners wall = Box({ 9, 0, 0 }, { 0.0, 2.0, 2.0 });
  const ShadowLight light = Point({ 0, 0, 0 });
  LightViews views = FitLightViews(light, { right, left }, { right, left, wall }, Margin);
  ASSERT_EQ(views.views.size(), 2u);
  EXPECT_EQ(views.views[0].face, 0);
  EXPECT_EQ(views.views[0].casters, std::vector<std::size_t>{ 0 });
  EXPECT_EQ(views.views[1].face, 1);
  EXPECT_EQ(views.views[1].casters, std::vector<std::size_t>{ 1 });

  views = FitLightViews(light, { right, left }, { wall }, Margin);
  ASSERT_EQ(views.views.size(), 1u);
  EXPECT_EQ(views.views[0].face, 0);

  // A caster behind every receiver is none.
  const BoxCorners behind = Box({ 12, 0, 0 }, { 0.5, 0.5, 0.5 });
  views = FitLightViews(light, { right, left, behind }, { wall }, Margin);
  ASSERT_EQ(views.views.size(), 1u);
  EXPECT_EQ(views.views[0].casters, std::vector<std::size_t>{ 0 });
}

TEST(LightViews, DepthsAreThoseOfTheCastersInTheFace)
{
  // Two walls and a long plank under the light, that reaches far beyond the face below.
  const BoxCorners right = Box({ 3, 0, 0 }, { 0.5, 0.5, 0.5 });
  const BoxCorners left = Box({ -4, 0, 0 }, { 0.5, 0.5, 0.5 });
  const BoxCorners plank = Box({ 0, 0, -2 }, { 100.0, 0.5, 0.25 });
  const LightViews views =
    FitLightViews(Point({ 0, 0, 0 }), { right, left, plank }, { right, left, plank }, Margin);
  const auto depthsOf = [&views](int face)
  {
    for (const FittedLightView& fitted : views.views)
    {
      const glm::dmat4& clip = fitted.view.clipFromView;
      if (fitted.face == face)
      {
        return glm::dvec2(clip[3][2] / (clip[2][2] - 1.0), clip[3][2] / (clip[2][2] + 1.0));
      }
    }
    return glm::dvec2(0.0);
  };
  const double slack = 1.0 / 1024.0;
  EXPECT_NEAR(depthsOf(5).x, 1.75 * (1.0 - slack), 1e-9);
  EXPECT_NEAR(depthsOf(5).y, 2.25 * (1.0 + slack), 1e-9);
  // To the right the plank comes in where it is as far right as down, but for the margin.
  EXPECT_NEAR(depthsOf(0).x, 1.75 * (1.0 - 2.0 * Margin) * (1.0 - slack), 1e-9);
  EXPECT_NEAR(depthsOf(0).y, 100.0 * (1.0 + slack), 1e-9);
  EXPECT_EQ(depthsOf(4), glm::dvec2(0.0));
}

// However far the light: the map's depths are those of the scene, not of the way to it.
TEST(LightViews, DepthsOfAFarLight)
{
  const BoxCorners box = Box({ 0, 0, 0 }, { 1, 1, 1 }), floor = Box({ 0, 0, -2 }, { 5, 5, 0 });
  for (const double distance : { 10.0, 1.0e3, 1.0e6, 1.0e9 })
  {
    const LightViewResult result =
      FitLightView(Point({ 0, 0, distance }), { box }, { box, floor }, Margin);
    ASSERT_EQ(result.fit, LightViewFit::Fitted) << distance;
    const double top = ToNdc(result.view, { 0, 0, 1 }).z,
                 bottom = ToNdc(result.view, { 0, 0, -1 }).z;
    // Of the 2 between near and far, nearly all.
    EXPECT_GT(bottom - top, 1.9) << distance;
    EXPECT_GE(top, -1.0) << distance;
    EXPECT_LE(bottom, 1.0) << distance;
  }
}

TEST(LightViews, DegenerateThings)
{
  const ShadowLight light = Point({ 0, 0, 0 });
  const BoxCorners point = Box({ 0, 0, 0 }, { 0, 0, 0 });
  const BoxCorners room = Box({ 0, 0, 0 }, { 5.0, 5.0, 5.0 });
  // A caster that is a point, at the light: it is in no face.
  EXPECT_TRUE(FitLightViews(light, { point }, { room }, Margin).views.empty());
  // The light in a sheet's plane, within it.
  const BoxCorners sheet = Box({ 0, 0, 0 }, { 5.0, 5.0, 0.0 });
  // A needle through the light, and a box with the light on its side, edge and corner.
  const BoxCorners needle = Box({ 0, 0, 0 }, { 0.0, 0.0, 5.0 });
  for (const BoxCorners& box : { sheet, needle, Box({ 1, 0, 0 }, { 1, 1, 1 }),
         Box({ 1, 1, 0 }, { 1, 1, 1 }), Box({ 1, 1, 1 }, { 1, 1, 1 }) })
  {
    const LightViews views = FitLightViews(light, { box }, { box, room }, 0.25);
    EXPECT_FALSE(views.views.empty());
    for (const FittedLightView& fitted : views.views)
    {
      for (int i = 0; i < 16; ++i)
      {
        EXPECT_TRUE(std::isfinite(fitted.view.clipFromView[i / 4][i % 4]));
        EXPECT_TRUE(std::isfinite(fitted.view.viewFromWorld[i / 4][i % 4]));
      }
    }
  }
}

TEST(LightView, APointLightOutsideItsCastersFits)
{
  const LightViewResult result =
    FitLightView(Point({ 2, -3, 6 }), { Caster }, { Caster, Floor }, Margin);
  ASSERT_EQ(result.fit, LightViewFit::Fitted);
  EXPECT_LE(Reach(result.view, Caster).x, 1.0);
}

TEST(LightView, FarAwayAndOfAnySize)
{
  // The same scene, moved and scaled, has the same map.
  const ShadowLight light = Directional({ 0.3, -0.2, -1.0 });
  const LightViewResult plain = FitLightView(light, { Caster }, { Caster, Floor }, Margin);
  for (const double scale : { 1e-12, 1e-6, 1e6, 1e12 })
  {
    const glm::dvec3 offset = 1e6 * scale * glm::dvec3(1.0, -2.0, 3.0);
    const auto place = [&](const BoxCorners& corners)
    {
      BoxCorners placed;
      for (int i = 0; i < 8; ++i)
      {
        placed[i] = offset + scale * corners[i];
      }
      return placed;
    };
    const LightViewResult moved =
      FitLightView(light, { place(Caster) }, { place(Caster), place(Floor) }, Margin);
    ASSERT_EQ(moved.fit, LightViewFit::Fitted) << "scale " << scale;
    for (int i = 0; i < 8; ++i)
    {
      const glm::dvec3 difference =
        ToNdc(moved.view, place(Caster)[i]) - ToNdc(plain.view, Caster[i]);
      EXPECT_LT(glm::length(difference), 1e-7) << "scale " << scale << ", corner " << i;
    }
  }
}

TEST(LightView, AFlatCasterEdgeOnHasAMap)
{
  const BoxCorners sheet = Box({ 0, 0, 1 }, { 1.0, 0.0, 0.5 });
  const LightViewResult result =
    FitLightView(Directional({ 0, 0, -1 }), { sheet }, { sheet, Floor }, Margin);
  ASSERT_EQ(result.fit, LightViewFit::Fitted);
  EXPECT_TRUE(std::isfinite(result.view.clipFromView[0][0] + result.view.clipFromView[1][1]));
}
