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
  // A cone fits one view up to 78.6 degrees; beyond that, and a point light, it is refused and says
  // why.
  for (const double cone : { 10.0, 60.0, 78.0, 78.5 })
  {
    const LightViewResult result =
      FitLightView(Spot({ 0, 0, 1 }, { 0, 0, 0 }, cone), { room }, { room }, Margin);
    ASSERT_EQ(result.fit, LightViewFit::Fitted) << "cone " << cone;
    EXPECT_TRUE(std::isfinite(result.view.clipFromView[0][0])) << "cone " << cone;
    EXPECT_GT(result.view.clipFromView[0][0], 0.1) << "cone " << cone;
  }
  for (const double cone : { 78.68, 80.0, 89.0 })
  {
    const LightViewResult result =
      FitLightView(Spot({ 0, 0, 1 }, { 0, 0, 0 }, cone), { room }, { room }, Margin);
    EXPECT_EQ(result.fit, LightViewFit::Refused) << "cone " << cone;
    EXPECT_NE(result.reason.find("cone"), std::string::npos) << result.reason;
  }
  const LightViewResult point = FitLightView(Point({ 0, 0, 1 }), { room }, { room }, Margin);
  EXPECT_EQ(point.fit, LightViewFit::Refused);
  EXPECT_NE(point.reason.find("point light"), std::string::npos) << point.reason;
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
