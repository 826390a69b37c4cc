#include "ShadowCandidates.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace vtkshadows
{
namespace
{

constexpr int ChosenCascades = 4;

// Times the texels of a map with exact lookups from which on a plain one is not tried.
constexpr double HugeRatio = 16.0;

// The order of filters by their work at a pixel; those that are not here are not compared.
int RankOf(const std::string& filter)
{
  return filter == "percentage-closer" ? 0 : filter == "exact" ? 1 : -1;
}

}

//------------------------------------------------------------------------------
std::vector<ShadowSetting> CandidateSettings(const CandidateScope& scope, const SceneNeeds& scene)
{
  std::vector<ShadowSetting> settings;
  const bool isMeasured = HasTruth(scene);
  const auto add = [&](const char* technique, const std::vector<int>& samples, int usual)
  {
    if (!scope.anySoft)
    {
      settings.push_back(ShadowSetting::By(technique));
      return;
    }
    for (const int count : isMeasured ? samples : std::vector<int>{ usual })
    {
      settings.push_back(ShadowSetting::By(technique, count));
    }
  };
  add("planar", { 8, 16, 32, 64 }, UsualPlanarSamples);
  add("stencil-volume", { 4, 8, 16, 32 }, UsualVolumeSamples);
  add("ray-cast", { 4, 8, 16, 32, 64 }, UsualRaySamples);
  if (scope.anyTextured && !scope.anySoft)
  {
    ShadowSetting textured = ShadowSetting::By("planar");
    textured.resolution = UsualPlanarTexels;
    settings.push_back(textured);
  }

  if (scope.anyHard)
  {
    for (const int texels : { 512, 1024, 2048, 4096 })
    {
      settings.push_back(ShadowSetting::Map(texels, "percentage-closer"));
    }
    for (const int texels : { 512, 1024, 2048 })
    {
      settings.push_back(ShadowSetting::Map(texels, "exact"));
    }
    if (scope.anyCascaded)
    {
      settings.push_back(ShadowSetting::Map(1024, "percentage-closer", ChosenCascades));
      settings.push_back(ShadowSetting::Map(1024, "exact", ChosenCascades));
      settings.push_back(ShadowSetting::Map(2048, "exact", ChosenCascades));
    }
  }
  if (scope.anySoft)
  {
    for (const int texels : { 512, 1024, 2048 })
    {
      settings.push_back(ShadowSetting::Map(texels, "soft"));
    }
    for (const int samples :
      isMeasured ? std::vector<int>{ 8, 16, 32, 64 } : std::vector<int>{ UsualMapSamples })
    {
      settings.push_back(ShadowSetting::Map(UsualMapTexels, "sample-lights", 1, samples));
    }
  }
  return settings;
}

//------------------------------------------------------------------------------
bool IsNoFaster(const ShadowSetting& setting, const ShadowSetting& than, bool lightsMove)
{
  const auto texels = [](const ShadowSetting& s)
  { return static_cast<double>(s.resolution) * s.resolution * s.cascades; };
  if (setting.technique != than.technique || (setting.resolution > 0) != (than.resolution > 0))
  {
    return false;
  }
  const bool sameFilter = setting.filter == than.filter ||
    (!lightsMove && RankOf(than.filter) >= 0 && RankOf(than.filter) <= RankOf(setting.filter));
  // What an exact lookup costs more does not pay for a map so much larger.
  const bool isHuge = RankOf(setting.filter) >= 0 && RankOf(than.filter) >= 0 &&
    texels(setting) > HugeRatio * texels(than);
  return (sameFilter || isHuge) && texels(setting) >= texels(than) &&
    setting.cascades >= than.cascades && setting.samples >= than.samples;
}

//------------------------------------------------------------------------------
double ExpectedCost(
  const ShadowSetting& setting, const SceneNeeds& scene, const LightNeeds& light, bool lightsMove)
{
  const double millions = 1.0e-6 * scene.triangles;
  const double samples = light.isSoft ? std::max(setting.samples, 1) : 1;
  if (setting.technique == "depth-map")
  {
    const bool isSampled = setting.filter == "sample-lights" && light.isSoft;
    const double lookup = setting.filter == "exact" ? 0.4
      : setting.filter == "soft"                    ? 5.0
      : isSampled                                   ? 0.4 * samples
                                                    : 0.2;
    // A map costs its texels, beside the window's pixels, and its casters.
    const double texels = static_cast<double>(setting.resolution) * setting.resolution *
      setting.cascades * light.views / std::max(scene.pixels, 1.0e5);
    const double drawn =
      isSampled ? samples * light.views * (0.3 + millions) : 0.5 + 0.03 * texels + millions;
    return lookup + 0.1 * (setting.cascades - 1) + (lightsMove ? drawn : 0.003 * texels);
  }
  return setting.technique == "planar"
    ? samples * (setting.resolution == 0 || lightsMove ? 0.5 + millions : 0.2)
    : setting.technique == "stencil-volume"
    ? 0.5 + samples * (0.6 + 2.0 * millions)
    : 1.2 + 0.3 * samples + (lightsMove ? 2.0 : 0.5) * millions;
}

}
