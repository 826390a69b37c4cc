// Cascades of a directional light: what the eye sees up to a cascade's reach lies in its map,
// texels stay where they are in the world while the eye turns and moves, and a scene that does not
// need several has one.
#include "LightCascades.h"

#include "ShadowReach.h"

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

constexpr int Resolution = 1024;
constexpr double Margin = 2.0;

BoxCorners BoxOf(const glm::dvec3& low, const glm::dvec3& high)
{
  Box box;
  box.AddPoint(low);
  box.AddPoint(high);
  return box.Corners();
}

// A country 10 km wide with a thousand houses, and the sun, about 20 degrees high.
struct Country
{
  ShadowLight sun;
  std::vector<BoxCorners> boxes;
  Box everyone;
  LightView whole;

  explicit Country(double size = 1.0e4, const glm::dvec3& offset = glm::dvec3(0.0),
    const glm::dvec3& sunlight = glm::dvec3(0.7, 0.4, -0.3))
  {
    this->sun.kind = LightKind::Directional;
    this->sun.direction = glm::normalize(sunlight);
    const double half = 0.5 * size;
    this->boxes.push_back(
      BoxOf(offset - glm::dvec3(half, half, 0.01 * size), offset + glm::dvec3(half, half, 0.0)));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-0.45 * size, 0.45 * size);
    for (int i = 0; i < 1000; ++i)
    {
      const glm::dvec3 place = offset + glm::dvec3(any(random), any(random), 0.0);
      this->boxes.push_back(BoxOf(place, place + 0.001 * size * glm::dvec3(1.0)));
    }
    for (const BoxCorners& box : this->boxes)
    {
      this->everyone.Add(box);
    }
    const LightViewResult fitted =
      FitLightView(this->sun, this->boxes, this->boxes, Margin / Resolution);
    EXPECT_EQ(fitted.fit, LightViewFit::Fitted);
    this->whole = fitted.view;
  }

  LightCascades Fit(const CascadeEye& eye, const CascadeSettings& settings,
    const LightCascades* before = nullptr) const
  {
    return FitLightCascades(
      this->sun, this->whole, this->boxes, this->boxes, eye, settings, Resolution, Margin, before);
  }
};

CascadeEye EyeAt(const glm::dvec3& place, double azimuth, double nearPlane = 0.5)
{
  CascadeEye eye;
  eye.viewFromWorld = glm::lookAt(place,
    place + glm::dvec3(std::cos(azimuth), std::sin(azimuth), -0.05), glm::dvec3(0.0, 0.0, 1.0));
  eye.clipFromView = glm::perspective(0.5236, 4.0 / 3.0, nearPlane, 1.0e7 * nearPlane);
  return eye;
}

CascadeSettings Cascades(int count)
{
  CascadeSettings settings;
  settings.count = count;
  return settings;
}

glm::dvec3 Texel(const LightView& view, const glm::dvec3& pointWC)
{
  const glm::dvec3 ndc(view.clipFromView * view.viewFromWorld * glm::dvec4(pointWC, 1.0));
  return 0.5 * Resolution * (ndc + 1.0);
}

// A point that the eye sees at `distance`.
glm::dvec3 Seen(const CascadeEye& eye, double x, double y, double distance)
{
  const glm::dvec4 corner = glm::inverse(eye.clipFromView) * glm::dvec4(x, y, -1.0, 1.0);
  const glm::dvec3 ray = glm::normalize(glm::dvec3(corner) / corner.w);
  return glm::dvec3(glm::inverse(eye.viewFromWorld) * glm::dvec4(distance * ray, 1.0));
}

}

// Where nothing is in shadow beyond some distance, the last cascade need not reach farther, and all
// are finer.
TEST(LightCascades, EndAtADistance)
{
  const Country country;
  const CascadeEye eye = EyeAt(glm::dvec3(100.0, -200.0, 2.0), 0.7);
  const LightCascades whole = country.Fit(eye, Cascades(3));
  CascadeSettings settings = Cascades(3);
  settings.farthest = 150.0;
  const LightCascades ending = country.Fit(eye, settings);
  ASSERT_EQ(ending.cascades.size(), 3u);
  ASSERT_EQ(whole.cascades.size(), 3u);
  for (int i = 0; i < 3; ++i)
  {
    std::printf("cascade %d: texels got %g, expected at most %g\n", i, ending.cascades[i].texel,
      0.7 * whole.cascades[i].texel);
    EXPECT_LT(ending.cascades[i].texel, 0.7 * whole.cascades[i].texel);
  }
  // Receivers that the eye sees within the distance lie in the last map.
  for (const double x : { -1.0, 0.0, 1.0 })
  {
    for (const double y : { -1.0, -0.5, 0.0 })
    {
      const glm::dvec3 seen = Seen(eye, x, y, 149.0);
      ASSERT_TRUE(country.everyone.Holds(seen));
      const glm::dvec3 texel = Texel(ending.cascades[2].view, seen);
      EXPECT_GE(std::min(texel.x, texel.y), Margin) << x << ", " << y;
      EXPECT_LE(std::max(texel.x, texel.y), Resolution - Margin) << x << ", " << y;
    }
  }
}

TEST(LightCascades, Schemes)
{
  const auto even = CascadeReaches(4, 1.0, 81.0, CascadeScheme::Uniform, 1.0);
  const auto steep = CascadeReaches(4, 1.0, 81.0, CascadeScheme::Logarithmic, 0.0);
  const auto blended = CascadeReaches(4, 1.0, 81.0, CascadeScheme::Practical, 0.25);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(even[i], 1.0 + 20.0 * (i + 1), 1e-9);
    EXPECT_NEAR(steep[i], std::pow(3.0, i + 1), 1e-9);
    EXPECT_NEAR(blended[i], 0.25 * steep[i] + 0.75 * even[i], 1e-9);
  }
  // No cascade is spent on what is too near to matter.
  const auto far = CascadeReaches(4, 1.0e-3, 700.0, CascadeScheme::Practical, 1.0);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(far[i] / std::pow(700.0, 0.25 * (i + 1)), 1.0, 1e-9);
  }
}

// The smallest ball about an axis, by trial.
TEST(LightCascades, BallsOfSlices)
{
  for (const double angle : { 0.05, 0.4, 0.9, 1.4 })
  {
    for (const double nearest : { 0.0, 1.0, 9.0 })
    {
      const double farthest = 10.0;
      const auto radiusAt = [&](double c)
      {
        const auto rim = [&](double r)
        { return std::sqrt(r * r + c * c - 2.0 * r * c * std::cos(angle)); };
        return std::max(
          { rim(nearest), rim(farthest), std::abs(farthest - c), std::abs(c - nearest) });
      };
      double least = 1.0e9;
      for (double c = 0.0; c < 20.0; c += 1.0e-3)
      {
        least = std::min(least, radiusAt(c));
      }
      const SliceBall ball = BallOfSlice(nearest, farthest, angle);
      EXPECT_NEAR(ball.radius, least, 1e-3) << angle << ' ' << nearest;
      EXPECT_GE(ball.radius, radiusAt(ball.centre) - 1e-9) << angle << ' ' << nearest;
    }
  }
}

// Of the points that a ball and a box share none lies farther; and along a direction to a side of
// the box, or where the box does not cut the ball, one lies as far.
TEST(LightCascades, ReachInBalls)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto place = [&]() { return glm::dvec3(any(random), any(random), any(random)); };
  int shared = 0, apart = 0;
  for (int round = 0; round < 300; ++round)
  {
    const glm::dvec3 a = 1.5 * place(), b = 1.5 * place();
    const glm::dvec3 low = glm::min(a, b), high = glm::max(a, b), way = glm::normalize(place());
    const double reach = ReachInBall(way, 1.0, low, high);
    for (int i = 0; i < 200; ++i)
    {
      const glm::dvec3 p = glm::mix(low, high, 0.5 * (place() + 1.0));
      if (glm::length(p) <= 1.0)
      {
        ++shared;
        EXPECT_LE(glm::dot(way, p), reach + 1e-12);
      }
    }
    apart += std::isinf(reach) ? 1 : 0;
  }
  EXPECT_GT(shared, 5000);
  EXPECT_GT(apart, 10);

  const glm::dvec3 wide(9.0), slab(9.0, 9.0, 0.3),
    slant = glm::normalize(glm::dvec3(1.0, 2.0, 5.0));
  EXPECT_NEAR(ReachInBall(slant, 2.0, -wide, wide), 2.0, 1e-12);
  EXPECT_NEAR(ReachInBall({ 0.0, 0.0, 1.0 }, 2.0, -slab, slab), 0.3, 1e-12);
  EXPECT_NEAR(ReachInBall({ 1.0, 0.0, 0.0 }, 2.0, -slab, slab), 2.0, 1e-12);
  const double beside = std::sqrt(5.0 / 30.0), up = std::sqrt(25.0 / 30.0);
  EXPECT_NEAR(
    ReachInBall(slant, 2.0, -slab, slab), beside * std::sqrt(4.0 - 0.3 * 0.3) + up * 0.3, 1e-12);
  EXPECT_NEAR(ReachInBall(slant, 20.0, -slab, slab), glm::dot(slant, slab), 1e-12);
}

TEST(LightCascades, WhatIsSeenLiesInItsCascade)
{
  const Country highSun, lowSun(1.0e4, glm::dvec3(0.0), { 0.7, 0.4, -0.1 });
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int following = 0;
  for (int round = 0; round < 50; ++round)
  {
    const Country& country = round % 2 == 0 ? highSun : lowSun;
    const CascadeEye eye =
      EyeAt({ 3000.0 * any(random), 3000.0 * any(random), 2.0 }, 3.1 * any(random));
    const CascadeSettings settings = Cascades(4);
    const LightCascades light = country.Fit(eye, settings);
    ASSERT_EQ(light.cascades.size(), 4u);
    double from = 0.0, texel = 0.0;
    int receivers = 0;
    for (const Cascade& cascade : light.cascades)
    {
      EXPECT_GT(cascade.texel, texel);
      texel = cascade.texel;
      if (!cascade.followsEye)
      {
        EXPECT_TRUE(std::isinf(cascade.reach));
        EXPECT_EQ(cascade.casters.size(), country.boxes.size());
        continue;
      }
      const double end = std::min(cascade.reach, 1.5e4); // the last one's is infinite
      for (int i = 0; i < 100; ++i)
      {
        const double distance = from + (end - from) * std::abs(any(random));
        const glm::dvec3 seen = Seen(eye, any(random), any(random), distance);
        if (!country.everyone.Holds(seen))
        {
          continue;
        }
        ++receivers;
        const glm::dvec3 p = Texel(cascade.view, seen);
        EXPECT_TRUE(p.x >= Margin && p.x <= Resolution - Margin && p.y >= Margin &&
          p.y <= Resolution - Margin)
          << "a receiver at " << distance << " lies at " << p.x << ", " << p.y;
        EXPECT_LE(p.z, Resolution) << "and beyond the map's depths";
      }
      from = cascade.reach * (1.0 - settings.blend);
    }
    EXPECT_GT(receivers, 100);
    // The last one is the view of all casters, unless its texels are finer by a fifth a side.
    const Cascade& last = light.cascades.back();
    EXPECT_TRUE(std::isinf(last.reach));
    if (last.followsEye)
    {
      ++following;
      const double whole = 4.0 /
        (country.whole.clipFromView[0][0] * country.whole.clipFromView[1][1] * Resolution *
          Resolution);
      EXPECT_LE(1.44 * last.sides.x * last.sides.y, whole * (1.0 + 1.0e-9));
    }
  }
  EXPECT_GT(following, 0);
  EXPECT_LT(following, 50);
}

// Every caster whose shadow can fall on what a cascade serves is drawn, at depths before its far
// end.
TEST(LightCascades, WhoCanCastIsDrawn)
{
  const Country country;
  const CascadeEye eye = EyeAt({ 100.0, -200.0, 2.0 }, 0.7);
  const LightCascades light = country.Fit(eye, Cascades(4));
  std::size_t leftOut = 0;
  for (const Cascade& cascade : light.cascades)
  {
    for (std::size_t i = 0; i < country.boxes.size(); ++i)
    {
      const bool isDrawn = std::binary_search(cascade.casters.begin(), cascade.casters.end(), i);
      leftOut += isDrawn ? 0 : 1;
      if (isDrawn || !cascade.followsEye)
      {
        continue;
      }
      glm::dvec3 low(1.0e9), high(-1.0e9);
      for (const glm::dvec3& corner : country.boxes[i])
      {
        low = glm::min(low, Texel(cascade.view, corner));
        high = glm::max(high, Texel(cascade.view, corner));
      }
      EXPECT_TRUE(low.x > Resolution || low.y > Resolution || high.x < 0.0 || high.y < 0.0 ||
        low.z > Resolution - 2.0)
        << "caster " << i;
    }
  }
  EXPECT_GT(leftOut, 1500u) << "few casters are left out";
}

// A map that is fitted anew has the texels that the one before had: their corners differ by whole
// texels.
TEST(LightCascades, TexelsStayInTheWorld)
{
  for (const glm::dvec3& offset : { glm::dvec3(0.0), { 1.0e6, -1.0e6, 1.0e6 } })
  {
    const Country country(1.0e4, offset);
    const LightCascades first = country.Fit(EyeAt(offset + glm::dvec3(0, 0, 2), 0.0), Cascades(4));
    int refitted = 0;
    for (double turn = 0.0; turn < 6.0; turn += 0.1)
    {
      const LightCascades other =
        country.Fit(EyeAt(offset + glm::dvec3(20.0 * turn, 0, 2), turn), Cascades(4));
      ASSERT_EQ(other.cascades.size(), first.cascades.size());
      for (std::size_t i = 0; i + 1 < first.cascades.size(); ++i)
      {
        EXPECT_NEAR(other.cascades[i].reach / first.cascades[i].reach, 1.0, 1e-9);
        EXPECT_NEAR(other.cascades[i].sides.x / first.cascades[i].sides.x, 1.0, 1e-9);
        EXPECT_NEAR(other.cascades[i].sides.y / first.cascades[i].sides.y, 1.0, 1e-9);
        const glm::dvec3 p = offset + glm::dvec3(17.0, 3.0, 1.0);
        const glm::dvec3 shift =
          Texel(other.cascades[i].view, p) - Texel(first.cascades[i].view, p);
        EXPECT_NEAR(shift.x, std::round(shift.x), 1e-3);
        EXPECT_NEAR(shift.y, std::round(shift.y), 1e-3);
        refitted += std::abs(shift.x) > 0.5 ? 1 : 0;
      }
    }
    EXPECT_GT(refitted, 100);
  }
}

// Ground is foreshortened by the sine of the sun's height: from where on it is wider than high, a
// texel has one side shorter. Alike at every offset and wherever the eye looks, and at scales that
// are powers of two, of which the steps are that sizes are rounded to.
TEST(LightCascades, TexelsHaveTwoSides)
{
  const glm::dvec3 sunlight(0.7, 0.4, -0.1); // 7 degrees high
  std::vector<glm::dvec3> expected;
  struct
  {
    double scale;
    glm::dvec3 offset;
  } const placements[] = { { 1.0, glm::dvec3(0.0) }, { std::exp2(-20.0), glm::dvec3(0.0) },
    { std::exp2(20.0), glm::dvec3(0.0) }, { 1.0, { 1.0e6, -1.0e6, 1.0e6 } } };
  for (const auto& placement : placements)
  {
    const Country country(1.0e4 * placement.scale, placement.offset, sunlight);
    for (double turn = 0.0; turn < 6.0; turn += 0.5)
    {
      const glm::dvec3 place =
        placement.offset + placement.scale * glm::dvec3(100.0 * turn, -200.0, 2.0 + turn);
      const LightCascades light =
        country.Fit(EyeAt(place, turn, 0.5 * placement.scale), Cascades(4));
      ASSERT_EQ(light.cascades.size(), 4u);
      for (std::size_t i = 0; i < 3; ++i)
      {
        const glm::dvec3 sides = light.cascades[i].sides / placement.scale;
        if (expected.size() < 3)
        {
          expected.push_back(sides);
          std::printf("cascade %zu: texels of %g by %g\n", i, sides.x, sides.y);
        }
        for (int axis = 0; axis < 2; ++axis)
        {
          EXPECT_NEAR(sides[axis] / expected[i][axis], 1.0, 1e-8) << i << ' ' << placement.scale;
        }
        EXPECT_EQ(
          light.cascades[i].texel, std::max(light.cascades[i].sides.x, light.cascades[i].sides.y));
      }
    }
  }
  EXPECT_EQ(expected[0].x, expected[0].y) << "a ball smaller than the receivers' heights";
  EXPECT_LT(std::min(expected[2].x, expected[2].y), 0.5 * std::max(expected[2].x, expected[2].y));
}

// While the guard band lasts the views are the very same ones.
TEST(LightCascades, MapsAreKept)
{
  const Country country;
  LightCascades before = country.Fit(EyeAt({ 0.0, 0.0, 2.0 }, 0.0), Cascades(4));
  int fits = 0;
  const int steps = 360;
  for (int step = 1; step <= steps; ++step)
  {
    const CascadeEye eye = EyeAt({ 0.0, 0.0, 2.0 }, step * 6.283185307 / steps);
    const LightCascades now = country.Fit(eye, Cascades(4), &before);
    for (std::size_t i = 0; i < now.cascades.size(); ++i)
    {
      fits += now.cascades[i].view.viewFromWorld != before.cascades[i].view.viewFromWorld ||
          now.cascades[i].view.clipFromView != before.cascades[i].view.clipFromView
        ? 1
        : 0;
    }
    before = now;
  }
  EXPECT_GT(fits, 3 * 20);
  EXPECT_LT(fits, 3 * 70) << "of three that follow the eye once around, in " << steps << " steps";
}

TEST(LightCascades, SmallScenesHaveOne)
{
  const Country country(2.0);
  for (const double distance : { 3.0, 5.0, 100.0 })
  {
    CascadeEye eye;
    eye.viewFromWorld = glm::lookAt(glm::dvec3(distance, 0, 1), glm::dvec3(0), glm::dvec3(0, 0, 1));
    eye.clipFromView = glm::perspective(0.5236, 4.0 / 3.0, 0.5 * distance, 2.0 * distance);
    const LightCascades light = country.Fit(eye, Cascades(8));
    ASSERT_EQ(light.cascades.size(), 1u) << distance;
    EXPECT_EQ(light.cascades[0].view.viewFromWorld, country.whole.viewFromWorld);
    EXPECT_FALSE(light.cascades[0].followsEye);
  }
}

// From near to far as 1 to 1e7; and eyes, lights and maps that can have none.
TEST(LightCascades, Extremes)
{
  const Country country;
  for (const double nearPlane : { 1.0e-6, 1.0e-3, 10.0, 1.0e5 })
  {
    for (int count = 1; count <= MostCascades; ++count)
    {
      const LightCascades light = country.Fit(EyeAt({ 0, 0, 2 }, 1.0, nearPlane), Cascades(count));
      ASSERT_GE(light.cascades.size(), 1u);
      ASSERT_LE(light.cascades.size(), static_cast<std::size_t>(count));
      EXPECT_TRUE(std::isinf(light.cascades.back().reach));
      for (const Cascade& cascade : light.cascades)
      {
        EXPECT_TRUE(std::isfinite(cascade.texel) && cascade.texel > 0.0);
        EXPECT_TRUE(std::isfinite(cascade.view.clipFromView[0][0]));
      }
    }
  }
  CascadeEye parallel = EyeAt({ 0, 0, 2 }, 1.0);
  parallel.clipFromView = glm::ortho(-20.0, 20.0, -15.0, 15.0, 1.0, 1.0e4);
  const LightCascades confined = country.Fit(parallel, Cascades(4));
  ASSERT_EQ(confined.cascades.size(), 1u);
  EXPECT_GE(confined.cascades[0].view.clipFromView[1][1], country.whole.clipFromView[1][1]);
  EXPECT_EQ(FitLightCascades(country.sun, country.whole, country.boxes, country.boxes,
              EyeAt({ 0, 0, 2 }, 1.0), Cascades(4), 8, Margin, nullptr)
              .cascades.size(),
    1u);
}

// What is seen lies in a confined view, which is smaller, the same for nearly the same eye, and
// holds those who cast into it.
TEST(LightCascades, ConfinedViews)
{
  const Country country;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int confined = 0, changed = 0;
  for (int round = 0; round < 50; ++round)
  {
    const glm::dvec3 place(4000.0 * any(random), 4000.0 * any(random), 300.0);
    CascadeEye eye;
    eye.viewFromWorld =
      glm::lookAt(place, place + glm::dvec3(any(random), any(random), -1.0), glm::dvec3(0, 0, 1));
    eye.clipFromView = glm::perspective(0.5236, 4.0 / 3.0, 1.0, 1.0e5);
    LightView view = country.whole;
    if (!ConfineView(view, country.boxes, eye, Margin / Resolution))
    {
      EXPECT_EQ(view.clipFromView, country.whole.clipFromView);
      continue;
    }
    ++confined;
    for (const glm::dvec3& p : SeenCorners(eye.clipFromView * eye.viewFromWorld, country.boxes))
    {
      const glm::dvec3 texel = Texel(view, p);
      const glm::dvec3 inWhole = Texel(country.whole, p);
      const bool isInWhole =
        inWhole.x >= 0.0 && inWhole.x <= Resolution && inWhole.y >= 0.0 && inWhole.y <= Resolution;
      EXPECT_TRUE(!isInWhole ||
        (texel.x >= -1e-6 && texel.x <= Resolution + 1e-6 && texel.y >= -1e-6 &&
          texel.y <= Resolution + 1e-6));
    }
    const auto casters = CastersIn(view, country.boxes);
    EXPECT_LT(casters.size(), country.boxes.size());
    CascadeEye moved = eye;
    moved.viewFromWorld = glm::translate(eye.viewFromWorld, glm::dvec3(0.5, 0.5, 0.0));
    LightView after = country.whole;
    ConfineView(after, country.boxes, moved, Margin / Resolution);
    changed += after.clipFromView != view.clipFromView ? 1 : 0;
  }
  EXPECT_GT(confined, 30);
  EXPECT_LT(changed, confined / 4);
}

// A light is left out only if none of its shadows, and of a spot's cone nothing, lies in the view.
TEST(LightCascades, LightsOutOfSight)
{
  const std::vector<BoxCorners> caster = { BoxOf({ -1, -1, -1 }, { 1, 1, 1 }) };
  const auto seenFrom = [&](const ShadowLight& light, const glm::dvec3& place, const glm::dvec3& to)
  {
    const glm::dmat4 view = glm::lookAt(place, to, glm::dvec3(0, 0, 1));
    const glm::dmat4 clip = glm::perspective(0.5, 1.0, 0.1, 100.0);
    Box everywhere;
    everywhere.Add(BoxOf(glm::dvec3(-200.0), glm::dvec3(200.0)));
    return LightMayBeSeen(clip * view, everywhere, light, caster);
  };
  ShadowLight sun;
  sun.direction = { 0, 0, -1 };
  EXPECT_TRUE(seenFrom(sun, { 10, 0, 0 }, { 0, 0, 0 }));
  EXPECT_TRUE(seenFrom(sun, { 10, 0, -50 }, { 0, 0, -50 })); // below, where the shadow falls
  EXPECT_FALSE(seenFrom(sun, { 10, 0, 50 }, { 0, 0, 50 }));  // above
  EXPECT_FALSE(seenFrom(sun, { 10, 0, 0 }, { 20, 0, 0 }));   // away from it
  ShadowLight spot = sun;
  spot.kind = LightKind::Spot;
  spot.position = { 0, 0, 10 };
  spot.coneAngle = 10.0;
  EXPECT_TRUE(seenFrom(spot, { 10, 0, 0 }, { 0, 0, 0 }));
  EXPECT_FALSE(seenFrom(spot, { 10, 0, 15 }, { 0, 0, 17 })); // above the light
  Box receivers;
  receivers.Add(BoxOf({ 5, 5, -2 }, { 9, 9, -1 }));
  EXPECT_FALSE(LightMayBeSeen(glm::perspective(0.5, 1.0, 0.1, 100.0) *
      glm::lookAt(glm::dvec3(10, 0, 0), glm::dvec3(0), glm::dvec3(0, 0, 1)),
    receivers, spot, caster)); // no receiver where it falls
  spot.direction = { 0, 0, 1 };
  EXPECT_FALSE(seenFrom(spot, { 10, 0, -3 }, { 0, 0, -3 })); // the cone points away
}
