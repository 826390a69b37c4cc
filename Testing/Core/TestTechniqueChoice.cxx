#include "TechniqueChoice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace
{

using vtkshadows::FrameTrials;
using vtkshadows::FrameWay;
using vtkshadows::SceneNeeds;
using vtkshadows::ShadowBudget;
using vtkshadows::ShadowSetting;
using vtkshadows::Standing;

ShadowSetting Named(const std::string& technique)
{
  ShadowSetting setting;
  setting.technique = technique;
  return setting;
}

ShadowSetting Map(int resolution, const std::string& filter = "percentage-closer")
{
  ShadowSetting setting = Named("depth-map");
  setting.resolution = resolution;
  setting.filter = filter;
  return setting;
}

SceneNeeds Plain()
{
  SceneNeeds scene;
  scene.hasRays = true;
  return scene;
}

Standing::Kind KindOf(const ShadowSetting& setting, const SceneNeeds& scene, bool isSoft = false)
{
  vtkshadows::LightNeeds light;
  light.isSoft = isSoft;
  const Standing standing = vtkshadows::StandingOf(setting, scene, light);
  // What is unfit or assumed says why.
  EXPECT_EQ(
    standing.why.empty(), standing.kind == Standing::Exact || standing.kind == Standing::Measured);
  return standing.kind;
}

FrameWay Way(const std::string& technique, double cost, double error = 0.0)
{
  FrameWay way;
  way.settings = { Named(technique) };
  way.cost = cost;
  way.error = error;
  return way;
}

// Draws frames, each in what its way takes; what was drawn, in order.
std::vector<std::string> Draw(
  FrameTrials& trials, const std::map<std::string, double>& seconds, int frames)
{
  std::vector<std::string> drawn;
  for (int i = 0; i < frames; ++i)
  {
    const std::string name = trials.Way().settings[0].technique;
    drawn.push_back(name);
    trials.FrameDrawn(trials.WantsTime() ? std::optional<double>(seconds.at(name)) : std::nullopt);
  }
  return drawn;
}

int Changes(const std::vector<std::string>& drawn)
{
  int changes = 0;
  for (std::size_t i = 1; i < drawn.size(); ++i)
  {
    changes += drawn[i] != drawn[i - 1] ? 1 : 0;
  }
  return changes;
}

}

//------------------------------------------------------------------------------
TEST(TechniqueChoice, WhatASceneAsks)
{
  const SceneNeeds plain = Plain();
  EXPECT_EQ(KindOf(Map(1024), plain), Standing::Measured);
  EXPECT_EQ(KindOf(Named("stencil-volume"), plain), Standing::Exact);
  EXPECT_EQ(KindOf(Named("ray-cast"), plain), Standing::Exact);
  EXPECT_EQ(KindOf(Named("planar"), plain), Standing::Unfit);

  SceneNeeds flat = plain;
  flat.receivesFlat = true;
  EXPECT_EQ(KindOf(Named("planar"), flat), Standing::Exact);

  SceneNeeds spheres = plain;
  spheres.notTriangles = "sphere impostors";
  EXPECT_EQ(KindOf(Named("stencil-volume"), spheres), Standing::Unfit);
  EXPECT_EQ(KindOf(Named("ray-cast"), spheres), Standing::Exact);
  EXPECT_EQ(KindOf(Map(1024), spheres), Standing::Measured);

  SceneNeeds lines = spheres;
  lines.notHitByRays = lines.notTriangles = "lines and points";
  EXPECT_EQ(KindOf(Named("ray-cast"), lines), Standing::Unfit);
  EXPECT_EQ(KindOf(Map(1024), lines), Standing::Assumed);

  for (bool SceneNeeds::*beyond : { &SceneNeeds::hasHoles, &SceneNeeds::castsByOpacity })
  {
    SceneNeeds scene = flat;
    scene.*beyond = true;
    EXPECT_EQ(KindOf(Named("stencil-volume"), scene), Standing::Unfit);
    EXPECT_EQ(KindOf(Named("ray-cast"), scene), Standing::Unfit);
    EXPECT_EQ(KindOf(Map(1024), scene), Standing::Assumed);
  }

  SceneNeeds standIns = flat;
  standIns.hasStandIns = true;
  EXPECT_EQ(KindOf(Named("ray-cast"), standIns), Standing::Unfit);
  EXPECT_EQ(KindOf(Named("stencil-volume"), standIns), Standing::Exact);
  EXPECT_EQ(KindOf(Map(1024), standIns), Standing::Assumed);

  SceneNeeds glass = flat;
  glass.receivesTranslucent = true;
  for (const char* mask : { "planar", "stencil-volume", "ray-cast" })
  {
    EXPECT_EQ(KindOf(Named(mask), glass), Standing::Unfit) << mask;
  }
  EXPECT_EQ(KindOf(Map(1024), glass), Standing::Measured);

  SceneNeeds noRays = plain;
  noRays.hasRays = false;
  EXPECT_EQ(KindOf(Named("ray-cast"), noRays), Standing::Unfit);
  EXPECT_EQ(KindOf(Map(1024), noRays), Standing::Assumed);

  EXPECT_EQ(KindOf(Map(2048), plain, true), Standing::Unfit);
  EXPECT_EQ(KindOf(Map(2048, "exact"), plain, true), Standing::Unfit);
  EXPECT_EQ(KindOf(Map(2048, "soft"), plain, true), Standing::Measured);
}

//------------------------------------------------------------------------------
TEST(TechniqueChoice, Budgets)
{
  vtkshadows::ErrorPercents error;
  error.mismatch = 0.4;
  EXPECT_TRUE(vtkshadows::IsWithin({}, error, false, 1.0));
  error.gross = 2.0 * vtkshadows::MostGrossPercent;
  EXPECT_FALSE(vtkshadows::IsWithin({}, error, false, 1.0));

  ShadowBudget budget;
  budget.maximumError = 0.5;
  EXPECT_TRUE(vtkshadows::IsWithin(budget, error, false, 1.0)); // gross is not asked for
  EXPECT_FALSE(vtkshadows::IsWithin(budget, error, false, 1.5));
  // 0.4 % of 10 000 are 40 pixels, of which two deviations are 12.6.
  error.sampled = 1.0e4;
  EXPECT_FALSE(vtkshadows::IsWithin(budget, error, false, 1.0));
  error.sampled = 1.0e6;
  EXPECT_TRUE(vtkshadows::IsWithin(budget, error, false, 1.0));

  vtkshadows::ErrorPercents soft;
  soft.meanDifference = 0.6;
  EXPECT_FALSE(vtkshadows::IsWithin(budget, soft, true, 1.0));
  EXPECT_TRUE(vtkshadows::IsWithin(budget, soft, false, 1.0));
}

//------------------------------------------------------------------------------
TEST(TechniqueChoice, TheFastestIsFoundAndStays)
{
  FrameTrials trials;
  trials.SetWays({ Way("a", 1.3), Way("b", 2.0), Way("c", 2.6) }, {});
  const std::map<std::string, double> seconds = { { "a", 0.030 }, { "b", 0.020 }, { "c", 0.050 } };
  const std::vector<std::string> drawn = Draw(trials, seconds, 30);
  EXPECT_EQ(drawn.front(), "a"); // what is expected to be the cheapest
  EXPECT_TRUE(trials.IsSettled());
  EXPECT_EQ(drawn.back(), "b");
  EXPECT_LE(Changes(drawn), 5); // each was tried twice at most
  // Then it never changes, though the same ways are named in every frame.
  for (int i = 0; i < 300; ++i)
  {
    trials.SetWays({ Way("a", 1.3), Way("b", 2.0), Way("c", 2.6) }, {});
    EXPECT_EQ(Draw(trials, seconds, 1).front(), "b");
  }
}

//------------------------------------------------------------------------------
// A machine that is busy for a few frames does not decide.
TEST(TechniqueChoice, ABusyMachineDoesNotDecide)
{
  for (int busy = 0; busy < 8; ++busy)
  {
    FrameTrials trials;
    trials.SetWays({ Way("a", 1.3), Way("b", 2.0) }, {});
    for (int i = 0; i < 30; ++i)
    {
      const double seconds = trials.Way().settings[0].technique == "a" ? 0.010 : 0.015;
      trials.FrameDrawn(trials.WantsTime()
          ? std::optional<double>(i >= busy && i < busy + 3 ? 1.55 * seconds : seconds)
          : std::nullopt);
    }
    EXPECT_EQ(trials.Way().settings[0].technique, "a") << "busy from frame " << busy;
  }
}

//------------------------------------------------------------------------------
TEST(TechniqueChoice, ALittleDecidesNothing)
{
  FrameTrials trials;
  trials.SetWays({ Way("a", 1.3), Way("b", 2.0) }, {});
  Draw(trials, { { "a", 0.0200 }, { "b", 0.0195 } }, 30);
  EXPECT_TRUE(trials.IsSettled());
  EXPECT_EQ(trials.Way().settings[0].technique, "a"); // which is expected to cost less
}

//------------------------------------------------------------------------------
TEST(TechniqueChoice, WhatIsFarTooDearIsNotTried)
{
  FrameTrials trials;
  trials.SetWays({ Way("a", 1.3), Way("b", 30.0) }, {});
  const std::vector<std::string> drawn = Draw(trials, { { "a", 0.02 } }, 20);
  EXPECT_EQ(std::count(drawn.begin(), drawn.end(), "b"), 0);
  EXPECT_TRUE(trials.IsSettled());
}

//------------------------------------------------------------------------------
TEST(TechniqueChoice, AnotherTimeIsNoticed)
{
  FrameTrials trials;
  trials.SetWays({ Way("a", 1.3), Way("b", 2.0) }, {});
  Draw(trials, { { "a", 0.010 }, { "b", 0.015 } }, 20);
  EXPECT_EQ(trials.Way().settings[0].technique, "a");
  // One slow frame is none; for good, the other is found.
  const std::vector<std::string> drawn = Draw(trials, { { "a", 0.050 }, { "b", 0.015 } }, 100);
  EXPECT_EQ(drawn.back(), "b");
}

//------------------------------------------------------------------------------
TEST(TechniqueChoice, WhatIsNoLongerRightIsLeftAtOnce)
{
  FrameTrials trials;
  trials.SetWays({ Way("a", 1.3), Way("b", 2.0) }, {});
  Draw(trials, { { "a", 0.010 }, { "b", 0.015 } }, 20);
  EXPECT_EQ(trials.Way().settings[0].technique, "a");
  trials.SetWays({ Way("b", 2.0) }, {});
  EXPECT_EQ(trials.Way().settings[0].technique, "b");
  trials.SetWays({ Way("a", 1.3), Way("b", 2.0) }, {});
  EXPECT_EQ(trials.Way().settings[0].technique, "a"); // whose time is known
  EXPECT_TRUE(trials.IsSettled());
}

//------------------------------------------------------------------------------
TEST(TechniqueChoice, ATimeAloneBuysAccuracy)
{
  const std::vector<FrameWay> ways = { Way("coarse", 1.2, 0.5), Way("fine", 1.4, 0.1),
    Way("exact", 2.0), Way("slow", 2.5) };
  const std::map<std::string, double> seconds = { { "coarse", 0.010 }, { "fine", 0.012 },
    { "exact", 0.020 }, { "slow", 0.040 } };
  for (const auto& expected : std::map<double, std::string>{ { 0.011, "coarse" }, { 0.015, "fine" },
         { 0.025, "exact" }, { 0.100, "exact" }, { 0.001, "coarse" } })
  {
    FrameTrials trials;
    ShadowBudget budget;
    budget.maximumSeconds = expected.first;
    trials.SetWays(ways, budget);
    EXPECT_EQ(Draw(trials, seconds, 30).back(), expected.second) << expected.first;
  }
}

//------------------------------------------------------------------------------
TEST(TechniqueChoice, Explanations)
{
  vtkshadows::Reasons reasons;
  reasons.setting = Map(1024);
  reasons.standing.kind = Standing::Measured;
  reasons.error = vtkshadows::ErrorPercents{ 0.031, 0.0, 0.0 };
  reasons.seconds = 0.0123;
  reasons.others = { "stencil-volume takes 20.1 ms", "ray-cast takes 31.0 ms" };
  reasons.refused = { "planar: not all that receives is flat" };
  EXPECT_EQ(vtkshadows::Explain(reasons, {}),
    "depth-map (1024 texels): 0.031 % wrong and no gross error as measured in this view; 12.3 ms a "
    "frame, where stencil-volume takes 20.1 ms and ray-cast takes 31.0 ms; not planar: not all "
    "that receives is flat.");

  ShadowBudget budget;
  budget.maximumError = 0.01;
  budget.maximumSeconds = 0.010;
  reasons = {};
  reasons.setting = Named("stencil-volume");
  reasons.standing.kind = Standing::Exact;
  reasons.seconds = 0.0201;
  EXPECT_EQ(vtkshadows::Explain(reasons, budget),
    "stencil-volume: exact for what casts and receives here, at most 0.01 % wrong was asked for; "
    "20.1 ms a frame, more than the 10.0 ms asked for: nothing right is faster.");
}
