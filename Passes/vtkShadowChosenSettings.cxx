#include "vtkShadowChosenSettings.h"

#include "ShadowCandidates.h"
#include "vtkDepthShadowMapPass.h"
#include "vtkPlanarShadowPass.h"
#include "vtkStencilShadowVolumePass.h"
#ifdef VTKSHADOWS_WITH_EMBREE
#include "vtkRayCastShadowPass.h"
#endif

namespace
{

const char* const Resolution = "resolution";
const char* const Cascades = "cascades";
const char* const Filter = "filter";
const char* const Samples = "samples";
const char* const Textures = "textures";

int FilterNamed(const std::string& name)
{
  int filter = 0;
  while (filter < vtkDepthShadowMapPass::GetNumberOfFilters() &&
    vtkDepthShadowMapPass::GetFilterName(filter) != name)
  {
    ++filter;
  }
  return filter;
}

}

//------------------------------------------------------------------------------
void vtkShadowChosenSettings::Note(const FindPass& find)
{
  if (this->Knobs.empty())
  {
    const auto add = [this](const char* technique, const char* what, int usual,
                       const std::function<int()>& get, const std::function<void(int)>& set) {
      this->Knobs.push_back({ technique, what, usual, get, set });
    };
    if (auto* maps = vtkDepthShadowMapPass::SafeDownCast(find("depth-map")))
    {
      add(
        "depth-map", Resolution, vtkshadows::UsualMapTexels,
        [maps] { return maps->GetResolution(); }, [maps](int n) { maps->SetResolution(n); });
      add(
        "depth-map", Cascades, 1, [maps] { return maps->GetNumberOfCascades(); },
        [maps](int n) { maps->SetNumberOfCascades(n); });
      add(
        "depth-map", Filter, vtkDepthShadowMapPass::PERCENTAGE_CLOSER,
        [maps] { return maps->GetFilter(); }, [maps](int n) { maps->SetFilter(n); });
      add(
        "depth-map", Samples, vtkshadows::UsualMapSamples,
        [maps] { return maps->GetLightSamples(); }, [maps](int n) { maps->SetLightSamples(n); });
    }
    if (auto* planar = vtkPlanarShadowPass::SafeDownCast(find("planar")))
    {
      add(
        "planar", Samples, vtkshadows::UsualPlanarSamples,
        [planar] { return planar->GetLightSamples(); },
        [planar](int n) { planar->SetLightSamples(n); });
      add(
        "planar", Resolution, vtkshadows::UsualPlanarTexels,
        [planar] { return planar->GetTextureResolution(); },
        [planar](int n) { planar->SetTextureResolution(n); });
      add(
        "planar", Textures, 0, [planar] { return planar->GetPlaneTextures() ? 1 : 0; },
        [planar](int n) { planar->SetPlaneTextures(n != 0); });
    }
    if (auto* volumes = vtkStencilShadowVolumePass::SafeDownCast(find("stencil-volume")))
    {
      add(
        "stencil-volume", Samples, vtkshadows::UsualVolumeSamples,
        [volumes] { return volumes->GetLightSamples(); },
        [volumes](int n) { volumes->SetLightSamples(n); });
    }
#ifdef VTKSHADOWS_WITH_EMBREE
    if (auto* rays = vtkRayCastShadowPass::SafeDownCast(find("ray-cast")))
    {
      add(
        "ray-cast", Samples, vtkshadows::UsualRaySamples,
        [rays] { return rays->GetLightSamples(); }, [rays](int n) { rays->SetLightSamples(n); });
    }
#endif
  }
  this->Pass = find;
  for (Knob& knob : this->Knobs)
  {
    const int now = knob.Get();
    if (!knob.IsApplied || now != knob.Applied)
    {
      knob.Own = now;
      knob.IsApplied = false;
    }
  }
}

//------------------------------------------------------------------------------
const vtkShadowChosenSettings::Knob* vtkShadowChosenSettings::Find(
  const std::string& technique, const char* what) const
{
  for (const Knob& knob : this->Knobs)
  {
    if (knob.Technique == technique && knob.What == what)
    {
      return &knob;
    }
  }
  return nullptr;
}

void vtkShadowChosenSettings::Set(const std::string& technique, const char* what, int value)
{
  for (Knob& knob : this->Knobs)
  {
    if (knob.Technique == technique && knob.What == what)
    {
      knob.IsApplied = true;
      knob.Applied = value;
      if (knob.Get() != value)
      {
        knob.Set(value);
      }
    }
  }
}

int vtkShadowChosenSettings::OwnResolution(const std::string& technique) const
{
  const Knob* knob = this->Find(technique, Resolution);
  return knob ? knob->Own : 0;
}

int vtkShadowChosenSettings::OwnSamples(const std::string& technique) const
{
  const Knob* knob = this->Find(technique, Samples);
  return knob ? knob->Own : 0;
}

//------------------------------------------------------------------------------
bool vtkShadowChosenSettings::Confine(vtkshadows::ShadowSetting& setting, bool fixed) const
{
  const auto ownOf = [&](const char* what) -> const Knob*
  {
    const Knob* knob = this->Find(setting.technique, what);
    return knob && (fixed || knob->Own != knob->Usual) ? knob : nullptr;
  };
  if (const Knob* samples = ownOf(Samples))
  {
    setting.samples = setting.samples > 0 ? samples->Own : 0;
  }
  if (setting.technique == "planar")
  {
    // Textures are tried beside masks; who sets them has them always.
    const Knob* textures = ownOf(Textures);
    const Knob* texels = ownOf(Resolution);
    if (textures && textures->Own == 0)
    {
      setting.resolution = 0;
    }
    else if (textures || (texels && setting.resolution > 0))
    {
      setting.resolution = this->OwnResolution(setting.technique);
    }
  }
  if (setting.IsMap())
  {
    const Knob* filter = ownOf(Filter);
    setting.filter = filter ? vtkDepthShadowMapPass::GetFilterName(filter->Own) : setting.filter;
    const Knob* cascades = ownOf(Cascades);
    setting.cascades = cascades ? cascades->Own : setting.cascades;
    const Knob* resolution = ownOf(Resolution);
    setting.resolution = resolution ? resolution->Own : setting.resolution;
    if (setting.filter != "sample-lights")
    {
      setting.samples = 0;
    }
    else if (setting.samples == 0)
    {
      setting.samples = this->OwnSamples(setting.technique);
    }
    // Filters differ in the depths that they have.
    auto* maps = vtkDepthShadowMapPass::SafeDownCast(this->Pass(setting.technique));
    return maps && vtkDepthShadowMapPass::HasDepthBits(setting.filter, maps->GetDepthBits());
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowChosenSettings::Apply(const vtkshadows::ShadowSetting& setting)
{
  if (setting.samples > 0)
  {
    this->Set(setting.technique, Samples, setting.samples);
  }
  if (setting.technique == "planar")
  {
    this->Set(setting.technique, Textures, setting.resolution > 0 ? 1 : 0);
    if (setting.resolution > 0)
    {
      this->Set(setting.technique, Resolution, setting.resolution);
    }
  }
  if (setting.IsMap())
  {
    this->Set(setting.technique, Resolution, setting.resolution);
    this->Set(setting.technique, Cascades, setting.cascades);
    this->Set(setting.technique, Filter, FilterNamed(setting.filter));
  }
}

void vtkShadowChosenSettings::PutBack()
{
  for (Knob& knob : this->Knobs)
  {
    if (knob.IsApplied && knob.Get() == knob.Applied)
    {
      knob.Set(knob.Own);
    }
    knob.IsApplied = false;
  }
}
