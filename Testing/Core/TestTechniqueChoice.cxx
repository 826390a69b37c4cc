#include "TechniqueChoice.h"

#include <gtest/gtest.h>

namespace
{

using vtkshadows::SceneNeeds;
using vtkshadows::ShadowBudget;
using vtkshadows::ShadowSetting;
using vtkshadows::Standing;

ShadowSetting Map(int resolution, const std::string& filter = "percentage-closer")
{
  return ShadowSetting::Map(resolution, filter);
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

}

//------------------------------------------------------------------------------
TEST(TechniqueChoice, WhatASceneAsks)
{
  const SceneNeeds plain = Plain();
  EXPECT_EQ(KindOf(Map(1024), plain), Standing::Measured);
  EXPECT_EQ(KindOf(ShadowSetting::By("stencil-volume"), plain), Standing::Exact);
  EXPECT_EQ(KindOf(ShadowSetting::By("ray-cast"), plain), Standing::Exact);
  EXPECT_EQ(KindOf(ShadowSetting::By("planar"), plain), Standing::Unfit);

  SceneNeeds flat = plain;
  flat.receivesFlat = true;
  EXPECT_EQ(KindOf(ShadowSetting::By("planar"), flat), Standing::Exact);

  SceneNeeds spheres = plain;
  spheres.notTriangles = "sphere impostors";
  EXPECT_EQ(KindOf(ShadowSetting::By("stencil-volume"), spheres), Standing::Unfit);
  EXPECT_EQ(KindOf(ShadowSetting::By("ray-cast"), spheres), Standing::Exact);
  EXPECT_EQ(KindOf(Map(1024), spheres), Standing::Measured);

  SceneNeeds lines = spheres;
  lines.notHitByRays = lines.notTriangles = "lines and points";
  EXPECT_EQ(KindOf(ShadowSetting::By("ray-cast"), lines), Standing::Unfit);
  EXPECT_EQ(KindOf(Map(1024), lines), Standing::Assumed);

  for (bool SceneNeeds::*beyond : { &SceneNeeds::hasHoles, &SceneNeeds::castsByOpacity })
  {
    SceneNeeds scene = flat;
    scene.*beyond = true;
    EXPECT_EQ(KindOf(ShadowSetting::By("stencil-volume"), scene), Standing::Unfit);
    EXPECT_EQ(KindOf(ShadowSetting::By("ray-cast"), scene), Standing::Unfit);
    EXPECT_EQ(KindOf(Map(1024), scene), Standing::Assumed);
  }

  SceneNeeds standIns = flat;
  standIns.hasStandIns = true;
  EXPECT_EQ(KindOf(ShadowSetting::By("ray-cast"), standIns), Standing::Unfit);
  EXPECT_EQ(KindOf(ShadowSetting::By("stencil-volume"), standIns), Standing::Exact);
  EXPECT_EQ(KindOf(Map(1024), standIns), Standing::Assumed);

  SceneNeeds glass = flat;
  glass.receivesTranslucent = true;
  for (const char* mask : { "planar", "stencil-volume", "ray-cast" })
  {
    EXPECT_EQ(KindOf(ShadowSetting::By(mask), glass), Standing::Unfit) << mask;
  }
  EXPECT_EQ(KindOf(Map(1024), glass), Standing::Measured);

  SceneNeeds noRays = plain;
  noRays.hasRays = false;
  EXPECT_EQ(KindOf(ShadowSetting::By("ray-cast"), noRays), Standing::Unfit);
  EXPECT_EQ(KindOf(Map(1024), noRays), Standing::Assumed);
  noRays.receivesTranslucent = true;
  EXPECT_EQ(
    vtkshadows::StandingOf(ShadowSetting::By("ray-cast"), noRays, {}).why, "this build has none");

  EXPECT_EQ(KindOf(Map(2048), plain, true), Standing::Unfit);
  EXPECT_EQ(KindOf(Map(2048, "exact"), plain, true), Standing::Unfit);
  EXPECT_EQ(KindOf(Map(2048, "soft"), plain, true), Standing::Measured);
}

//------------------------------------------------------------------------------
// Sample lights, each exact, are measured where there is a truth.
TEST(TechniqueChoice, SampleLightsAreMeasured)
{
  ShadowSetting volumes = ShadowSetting::By("stencil-volume");
  volumes.samples = 8;
  EXPECT_EQ(KindOf(volumes, Plain(), true), Standing::Measured);
  EXPECT_EQ(KindOf(volumes, Plain(), false), Standing::Exact);
  SceneNeeds noRays = Plain();
  noRays.hasRays = false;
  EXPECT_EQ(KindOf(volumes, noRays, true), Standing::Exact);
  SceneNeeds large = Plain();
  large.isTooLarge = true;
  EXPECT_EQ(KindOf(volumes, large, true), Standing::Exact);
  EXPECT_EQ(KindOf(Map(2048), large), Standing::Assumed);

  ShadowSetting textured = ShadowSetting::By("planar");
  textured.resolution = 2048;
  SceneNeeds flat = Plain();
  EXPECT_EQ(KindOf(textured, flat), Standing::Unfit);
  flat.receivesFlat = true;
  EXPECT_EQ(KindOf(textured, flat), Standing::Measured);
  flat.receivesTranslucent = true;
  EXPECT_EQ(KindOf(textured, flat), Standing::Measured);
  EXPECT_EQ(textured.Text(), "planar (2048 texels)");
  EXPECT_EQ(volumes.Text(), "stencil-volume (8 samples)");
}

//------------------------------------------------------------------------------
TEST(TechniqueChoice, Budgets)
{
  vtkshadows::ErrorPercents error;
  error.mismatch = 0.4;
  EXPECT_TRUE(vtkshadows::IsWithin({}, error, false, 1.0));
  error.gross = 2.0 * vtkshadows::MostGrossPercent;
  error.pixels = 1.0e6;
  EXPECT_FALSE(vtkshadows::IsWithin({}, error, false, 1.0));
  // A single pixel, be the picture small, is none, unless it stands for others.
  vtkshadows::ErrorPercents one;
  one.pixels = 2.0e4;
  one.gross = 100.0 / one.pixels;
  EXPECT_TRUE(vtkshadows::IsWithin({}, one, false, 1.25));
  EXPECT_FALSE(vtkshadows::HangsOnFewPixels(one, false));
  one.isSampled = true;
  EXPECT_FALSE(vtkshadows::IsWithin({}, one, false, 1.0));
  EXPECT_TRUE(vtkshadows::HangsOnFewPixels(one, false));
  one.gross *= 5.0;
  EXPECT_FALSE(vtkshadows::HangsOnFewPixels(one, false)) << "five are no chance";
  one.isSampled = false;
  one.gross = 2.0 * 100.0 / one.pixels;
  EXPECT_FALSE(vtkshadows::IsWithin({}, one, false, 1.0));
  // So is a penumbra of some pixels whose mean is too close to the limit to be told from it.
  vtkshadows::ErrorPercents blurred;
  blurred.pixels = 2.0e4;
  blurred.penumbraDifference = 1.02 * vtkshadows::MostPenumbraDifferencePercent;
  blurred.penumbraDeviation = 0.02 * vtkshadows::MostPenumbraDifferencePercent;
  EXPECT_FALSE(vtkshadows::HangsOnFewPixels(blurred, true)) << "of all pixels";
  blurred.isSampled = true;
  EXPECT_TRUE(vtkshadows::HangsOnFewPixels(blurred, true));
  blurred.penumbraDifference = 1.06 * vtkshadows::MostPenumbraDifferencePercent;
  EXPECT_FALSE(vtkshadows::HangsOnFewPixels(blurred, true)) << "three deviations off";
  blurred.penumbraDifference = 1.02 * vtkshadows::MostPenumbraDifferencePercent;
  blurred.meanDifference = 2.0 * vtkshadows::MostSoftDifferencePercent;
  EXPECT_FALSE(vtkshadows::HangsOnFewPixels(blurred, true)) << "refused whatever its penumbra is";
  blurred.meanDifference = 0.97 * vtkshadows::MostSoftDifferencePercent;
  EXPECT_FALSE(vtkshadows::HangsOnFewPixels(blurred, true)) << "refused by the margin of the mean";
  // What is told of it is what it is refused by.
  EXPECT_EQ(vtkshadows::ErrorText(blurred, {}, true), "4.1 % mean difference in the penumbra");
  blurred.penumbraDifference = 0.8 * vtkshadows::MostPenumbraDifferencePercent;
  EXPECT_EQ(vtkshadows::ErrorText(blurred, {}, true), "0.97 % mean difference");
  // Of thin things every pixel is near to an edge, and none is gross.
  vtkshadows::ErrorPercents thin;
  thin.mismatch = 2.0 * vtkshadows::MostMismatchPercent;
  EXPECT_FALSE(vtkshadows::IsWithin({}, thin, false, 1.0));

  ShadowBudget budget;
  budget.maximumError = 0.5;
  EXPECT_TRUE(vtkshadows::IsWithin(budget, error, false, 1.0)); // gross is not asked for
  EXPECT_FALSE(vtkshadows::IsWithin(budget, error, false, 1.5));
  // 0.4 % of 10 000 are 40 pixels, of which two deviations are 12.6.
  error.isSampled = true;
  error.pixels = 1.0e4;
  EXPECT_FALSE(vtkshadows::IsWithin(budget, error, false, 1.0));
  error.pixels = 1.0e6;
  EXPECT_TRUE(vtkshadows::IsWithin(budget, error, false, 1.0));

  vtkshadows::ErrorPercents soft;
  soft.meanDifference = 0.6;
  EXPECT_FALSE(vtkshadows::IsWithin(budget, soft, true, 1.0));
  EXPECT_TRUE(vtkshadows::IsWithin(budget, soft, false, 1.0));

  // Without a budget, steps in the penumbra count, however small it is.
  EXPECT_TRUE(vtkshadows::IsWithin({}, soft, true, 1.0));
  soft.penumbraDifference = 2.0 * vtkshadows::MostPenumbraDifferencePercent;
  EXPECT_FALSE(vtkshadows::IsWithin({}, soft, true, 1.0));
  EXPECT_TRUE(vtkshadows::IsWithin({}, soft, false, 1.0));
  // What the number of sample lights decides has no margin, other differences have.
  soft.penumbraDifference = 0.9 * vtkshadows::MostPenumbraDifferencePercent;
  EXPECT_FALSE(vtkshadows::IsWithin({}, soft, true, 1.25));
  soft.isBySampleLights = true;
  EXPECT_TRUE(vtkshadows::IsWithin({}, soft, true, 1.25));
  soft.penumbraDifference = 1.1 * vtkshadows::MostPenumbraDifferencePercent;
  EXPECT_FALSE(vtkshadows::IsWithin({}, soft, true, 1.25));
  soft.penumbraDifference = 0.0;
  soft.meanDifference = 2.0 * vtkshadows::MostSoftDifferencePercent;
  EXPECT_FALSE(vtkshadows::IsWithin({}, soft, true, 1.0));
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
  reasons.setting = ShadowSetting::By("stencil-volume");
  reasons.standing.kind = Standing::Exact;
  reasons.seconds = 0.0201;
  EXPECT_EQ(vtkshadows::Explain(reasons, budget),
    "stencil-volume: exact for what casts and receives here, at most 0.01 % wrong was asked for; "
    "20.1 ms a frame, more than the 10.0 ms asked for: nothing right is faster.");
}
