#include "BenchSettings.h"

#include "SpecText.h"
#include "Techniques.h"

#include <vtkDepthShadowMapPass.h>
#include <vtkObjectIDShadowPass.h>
#include <vtkPlanarShadowPass.h>
#include <vtkRayCastShadowPass.h>
#include <vtkShadowPass.h>
#include <vtkShadowTexturePass.h>
#include <vtkStencilShadowVolumePass.h>

#include <algorithm>

namespace vtkshadows
{

const char* const PeerTechnique = "vtk-shadow-map";

namespace
{

using Apply = std::function<void(vtkShadowPass*)>;

BenchSetting Setting(const std::string& technique, const std::string& rest, const Apply& apply)
{
  BenchSetting setting;
  setting.technique = technique;
  setting.name = technique + (rest.empty() ? "" : "/" + rest);
  setting.apply = [technique, apply](vtkShadowPass* shadows)
  {
    shadows->SetTechnique(technique);
    apply(shadows);
  };
  return setting;
}

BenchSetting Plain(const std::string& technique)
{
  return Setting(technique, "", [](vtkShadowPass*) {});
}

BenchSetting Fast(BenchSetting setting)
{
  setting.fast = true;
  return setting;
}

BenchSetting Soft(BenchSetting setting, int samples = 0)
{
  setting.name = "soft/" + setting.name;
  setting.soft = true;
  setting.samples = samples;
  return setting;
}

BenchSetting DepthMap(const std::string& filter, int resolution, const std::string& rest = "",
  const std::function<void(vtkDepthShadowMapPass*)>& more = {})
{
  BenchSetting setting = Setting("depth-map",
    filter + "/" + std::to_string(resolution) + (rest.empty() ? "" : "/" + rest),
    [filter, resolution, more](vtkShadowPass* shadows)
    {
      vtkDepthShadowMapPass* maps = shadows->GetDepthShadowMapPass();
      maps->SetFilter(filter);
      maps->SetResolution(resolution);
      if (more)
      {
        more(maps);
      }
    });
  setting.resolution = resolution;
  return setting;
}

BenchSetting DepthMapOfBits(int bits)
{
  return DepthMap("percentage-closer", 2048, "depth-bits-" + std::to_string(bits),
    [bits](vtkDepthShadowMapPass* maps) { maps->SetDepthBits(bits); });
}

BenchSetting Cascades(int number)
{
  BenchSetting setting = DepthMap("percentage-closer", 2048, "cascades-" + std::to_string(number),
    [number](vtkDepthShadowMapPass* maps) { maps->SetNumberOfCascades(number); });
  setting.directional = true;
  return setting;
}

BenchSetting ObjectID(int resolution, bool depths)
{
  BenchSetting setting =
    Setting("object-id", std::to_string(resolution) + (depths ? "" : "/without-depths"),
      [resolution, depths](vtkShadowPass* shadows)
      {
        shadows->GetObjectIDShadowPass()->SetResolution(resolution);
        shadows->GetObjectIDShadowPass()->SetCombineDepth(depths);
      });
  setting.resolution = resolution;
  return setting;
}

BenchSetting ShadowTexture(int resolution)
{
  BenchSetting setting = Setting("shadow-texture", std::to_string(resolution),
    [resolution](vtkShadowPass* shadows)
    { shadows->GetShadowTexturePass()->SetResolution(resolution); });
  setting.resolution = resolution;
  return setting;
}

BenchSetting PlanarTextures(int resolution)
{
  BenchSetting setting = Setting("planar", "textures-" + std::to_string(resolution),
    [resolution](vtkShadowPass* shadows)
    {
      shadows->GetPlanarShadowPass()->PlaneTexturesOn();
      shadows->GetPlanarShadowPass()->SetTextureResolution(resolution);
    });
  setting.resolution = resolution;
  return setting;
}

BenchSetting Stencil(
  const std::string& rest, const std::function<void(vtkStencilShadowVolumePass*)>& more)
{
  return Setting("stencil-volume", rest,
    [more](vtkShadowPass* shadows) { more(shadows->GetStencilShadowVolumePass()); });
}

BenchSetting StencilVariant(const std::string& name, int variant)
{
  return Stencil(
    name, [variant](vtkStencilShadowVolumePass* volumes) { volumes->SetVariant(variant); });
}

BenchSetting Peer(int resolution)
{
  BenchSetting setting;
  setting.technique = PeerTechnique;
  setting.name = setting.technique + "/" + std::to_string(resolution);
  setting.resolution = resolution;
  return setting;
}

// Techniques that make a soft shadow of sample lights.
BenchSetting SoftDepthMap(int samples)
{
  return Soft(DepthMap("sample-lights", 2048, std::to_string(samples) + "-samples",
                [samples](vtkDepthShadowMapPass* maps) { maps->SetLightSamples(samples); }),
    samples);
}

BenchSetting SoftPlanar(int samples)
{
  return Soft(Setting("planar", std::to_string(samples) + "-samples",
                [samples](vtkShadowPass* shadows)
                { shadows->GetPlanarShadowPass()->SetLightSamples(samples); }),
    samples);
}

BenchSetting SoftPlanarMethod(const std::string& name, int method)
{
  return Soft(Setting("planar", name,
    [method](vtkShadowPass* shadows) { shadows->GetPlanarShadowPass()->SetSoftMethod(method); }));
}

BenchSetting SoftStencil(int samples)
{
  return Soft(
    Stencil(std::to_string(samples) + "-samples",
      [samples](vtkStencilShadowVolumePass* volumes) { volumes->SetLightSamples(samples); }),
    samples);
}

BenchSetting SoftRayCast(int samples)
{
  return Soft(Setting("ray-cast", std::to_string(samples) + "-samples",
                [samples](vtkShadowPass* shadows)
                { shadows->GetRayCastShadowPass()->SetLightSamples(samples); }),
    samples);
}

// Without those of techniques that this build has not.
std::vector<BenchSetting> InThisBuild(std::vector<BenchSetting> settings)
{
  const std::vector<std::string> known = TechniqueNames();
  const auto isMissing = [&known](const BenchSetting& setting)
  {
    return !setting.IsPeer() &&
      std::find(known.begin(), known.end(), setting.technique) == known.end();
  };
  settings.erase(std::remove_if(settings.begin(), settings.end(), isMissing), settings.end());
  return settings;
}

bool MatchesGlob(const char* name, const char* pattern)
{
  if (*pattern == '\0')
  {
    return *name == '\0';
  }
  if (*pattern == '*')
  {
    return MatchesGlob(name, pattern + 1) || (*name != '\0' && MatchesGlob(name + 1, pattern));
  }
  return *name != '\0' && (*pattern == '?' || *pattern == *name) &&
    MatchesGlob(name + 1, pattern + 1);
}

}

bool BenchSetting::IsPeer() const
{
  return this->technique == PeerTechnique;
}

//------------------------------------------------------------------------------
std::vector<BenchSetting> BenchSettings()
{
  using Stencils = vtkStencilShadowVolumePass;
  return InThisBuild({
    Fast(Plain("none")),
    DepthMap("percentage-closer", 512),
    Fast(DepthMap("percentage-closer", 1024)),
    Fast(DepthMap("percentage-closer", 2048)),
    DepthMap("percentage-closer", 4096),
    DepthMap("none", 2048),
    DepthMap("hardware", 2048),
    DepthMap("disc", 2048),
    DepthMap("variance", 2048),
    DepthMap("exponential", 2048),
    DepthMap("exact", 512),
    DepthMap("exact", 1024),
    Fast(DepthMap("exact", 2048)),
    DepthMapOfBits(8),
    DepthMapOfBits(16),
    DepthMapOfBits(24),
    Cascades(2),
    Cascades(4),
    ObjectID(1024, true),
    Fast(ObjectID(2048, true)),
    ObjectID(4096, true),
    ObjectID(2048, false),
    ShadowTexture(1024),
    Fast(ShadowTexture(2048)),
    Fast(Plain("auto")),
    Fast(Plain("planar")),
    PlanarTextures(2048),
    Fast(Plain("stencil-volume")),
    StencilVariant("z-fail", Stencils::Z_FAIL),
    StencilVariant("z-pass", Stencils::Z_PASS),
    StencilVariant("z-pass-capped", Stencils::Z_PASS_CAPPED),
    StencilVariant("parity", Stencils::PARITY),
    Stencil(
      "float-counter", [](Stencils* volumes) { volumes->SetCounter(Stencils::FLOAT_COUNTER); }),
    Fast(Plain("ray-cast")),
    Peer(512),
    Peer(1024),
    Fast(Peer(2048)),
    Peer(4096),
    Soft(DepthMap("percentage-closer", 2048)),
    Soft(Plain("auto")),
    Fast(Soft(DepthMap("soft", 2048))),
    SoftDepthMap(16),
    SoftDepthMap(64),
    Soft(ShadowTexture(2048)),
    SoftPlanar(16),
    Fast(SoftPlanar(64)),
    SoftPlanarMethod("offset-planes", vtkPlanarShadowPass::OFFSET_PLANES),
    SoftPlanarMethod("plateaus", vtkPlanarShadowPass::PLATEAUS),
    Fast(SoftStencil(8)),
    SoftStencil(32),
    SoftRayCast(4),
    Fast(SoftRayCast(16)),
    SoftRayCast(64),
  });
}

std::vector<BenchSetting> SweepSettings()
{
  return InThisBuild({ DepthMap("percentage-closer", 2048), DepthMap("exact", 2048),
    ObjectID(2048, true), ShadowTexture(2048), Plain("planar"), Plain("stencil-volume"),
    Plain("ray-cast"), Peer(2048) });
}

std::vector<BenchSetting> SampledSettings(int samples)
{
  return InThisBuild(
    { SoftDepthMap(samples), SoftPlanar(samples), SoftStencil(samples), SoftRayCast(samples) });
}

bool MatchesPatterns(const std::string& name, const std::string& patterns)
{
  if (patterns.empty())
  {
    return true;
  }
  for (const std::string& pattern : Split(patterns, ','))
  {
    const bool isGlob = pattern.find_first_of("*?") != std::string::npos;
    if (isGlob ? MatchesGlob(name.c_str(), pattern.c_str())
               : name.find(pattern) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

}
