#include "ShadowCandidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace
{

using vtkshadows::CandidateScope;
using vtkshadows::LightNeeds;
using vtkshadows::SceneNeeds;
using vtkshadows::ShadowSetting;

ShadowSetting Map(int resolution, const std::string& filter = "percentage-closer", int cascades = 1)
{
  return ShadowSetting::Map(resolution, filter, cascades);
}

ShadowSetting Sampled(const std::string& technique, int samples)
{
  return ShadowSetting::By(technique, samples);
}

SceneNeeds Plain()
{
  SceneNeeds scene;
  scene.hasRays = true;
  scene.pixels = 4.8e5;
  scene.triangles = 1.0e4;
  return scene;
}

std::set<int> SamplesOf(const std::vector<ShadowSetting>& settings, const std::string& technique)
{
  std::set<int> samples;
  for (const ShadowSetting& setting : settings)
  {
    if (setting.technique == technique)
    {
      samples.insert(setting.samples);
    }
  }
  return samples;
}

bool Has(const std::vector<ShadowSetting>& settings, const ShadowSetting& one)
{
  return std::find(settings.begin(), settings.end(), one) != settings.end();
}

}

//------------------------------------------------------------------------------
TEST(ShadowCandidates, OfHardLights)
{
  const std::vector<ShadowSetting> settings = vtkshadows::CandidateSettings({}, Plain());
  for (const int texels : { 512, 1024, 2048 })
  {
    EXPECT_TRUE(Has(settings, Map(texels)));
    EXPECT_TRUE(Has(settings, Map(texels, "exact")));
  }
  EXPECT_FALSE(Has(settings, Map(1024, "percentage-closer", 4))); // of a scene that is near
  EXPECT_EQ(SamplesOf(settings, "ray-cast"), std::set<int>{ 0 });
  CandidateScope far;
  far.anyCascaded = true;
  EXPECT_TRUE(Has(vtkshadows::CandidateSettings(far, Plain()), Map(1024, "percentage-closer", 4)));
}

//------------------------------------------------------------------------------
// Fewer samples than a technique has by itself are taken only where their error is measured, and
// none has more than the truth.
TEST(ShadowCandidates, OfSoftLights)
{
  CandidateScope soft;
  soft.anyHard = false;
  soft.anySoft = true;
  const std::vector<ShadowSetting> settings = vtkshadows::CandidateSettings(soft, Plain());
  EXPECT_EQ(SamplesOf(settings, "ray-cast"), (std::set<int>{ 4, 8, 16, 32, 64 }));
  EXPECT_EQ(SamplesOf(settings, "stencil-volume"), (std::set<int>{ 4, 8, 16, 32 }));
  EXPECT_FALSE(Has(settings, Map(1024)));
  for (const ShadowSetting& setting : settings)
  {
    EXPECT_LT(setting.samples, vtkshadows::TruthSamples) << setting.Text();
  }
  SceneNeeds noTruth = Plain();
  noTruth.hasRays = false;
  const std::vector<ShadowSetting> blind = vtkshadows::CandidateSettings(soft, noTruth);
  EXPECT_EQ(SamplesOf(blind, "stencil-volume"), std::set<int>{ vtkshadows::UsualVolumeSamples });
}

//------------------------------------------------------------------------------
TEST(ShadowCandidates, WhatNeedNotBeTried)
{
  using vtkshadows::IsNoFaster;
  EXPECT_TRUE(IsNoFaster(Map(2048), Map(1024)));
  EXPECT_FALSE(IsNoFaster(Map(1024), Map(2048)));
  EXPECT_TRUE(IsNoFaster(Map(1024, "exact"), Map(1024)));
  EXPECT_FALSE(IsNoFaster(Map(1024, "exact"), Map(1024), true));
  EXPECT_TRUE(IsNoFaster(Map(2048, "exact"), Map(1024, "exact"), true));
  // Drawn with less, looked up with more: time tells.
  EXPECT_FALSE(IsNoFaster(Map(512, "exact"), Map(1024)));
  EXPECT_FALSE(IsNoFaster(Map(1024), Map(512, "exact")));
  EXPECT_TRUE(IsNoFaster(Map(4096), Map(512, "exact")));
  EXPECT_TRUE(IsNoFaster(Map(1024, "percentage-closer", 4), Map(2048)));
  EXPECT_FALSE(IsNoFaster(Map(2048), Map(1024, "soft")));
  EXPECT_TRUE(IsNoFaster(Sampled("ray-cast", 16), Sampled("ray-cast", 8)));
  EXPECT_FALSE(IsNoFaster(Sampled("ray-cast", 8), Sampled("ray-cast", 16)));
  EXPECT_FALSE(IsNoFaster(Sampled("ray-cast", 16), Sampled("stencil-volume", 8)));
  ShadowSetting textured = Sampled("planar", 0);
  textured.resolution = 2048;
  EXPECT_FALSE(IsNoFaster(textured, Sampled("planar", 0)));
  EXPECT_FALSE(IsNoFaster(Sampled("planar", 0), textured));
}

//------------------------------------------------------------------------------
TEST(ShadowCandidates, WhatIsExpectedToCostMore)
{
  const SceneNeeds scene = Plain();
  const auto cost = [&](const ShadowSetting& setting, bool moving, bool isSoft = false)
  {
    LightNeeds light;
    light.isSoft = isSoft;
    return vtkshadows::ExpectedCost(setting, scene, light, moving);
  };
  EXPECT_LT(cost(Map(1024), true), cost(Map(2048), true));
  EXPECT_LT(cost(Map(2048), false), cost(Map(2048), true)); // it is drawn again
  EXPECT_LT(cost(Map(512, "exact"), true), cost(Map(4096), true));
  EXPECT_LT(cost(Map(2048), false), cost(Sampled("stencil-volume", 0), false));
  EXPECT_LT(cost(Sampled("ray-cast", 8), false, true), cost(Sampled("ray-cast", 16), false, true));
  // Six views of a lamp amid its casters.
  LightNeeds amid;
  amid.views = 6;
  EXPECT_LT(cost(Map(2048), true), vtkshadows::ExpectedCost(Map(2048), scene, amid, true));
  EXPECT_EQ(cost(Sampled("stencil-volume", 0), true),
    vtkshadows::ExpectedCost(Sampled("stencil-volume", 0), scene, amid, true));
  // A light without a radius has one sample, whatever others have.
  EXPECT_EQ(cost(Sampled("ray-cast", 8), false), cost(Sampled("ray-cast", 64), false));
}
