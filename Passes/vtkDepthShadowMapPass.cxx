#include "vtkDepthShadowMapPassInternals.h"

#include "vtkShadowChecks.h"

#include "vtkObjectFactory.h"

#include <iterator>

vtkStandardNewMacro(vtkDepthShadowMapPass);

namespace
{

// By FilterType.
const char* const FilterNames[] = { "percentage-closer", "none", "hardware", "disc", "soft",
  "sample-lights", "variance", "exponential", "exact" };

// Far beyond all depths, and a float in the shader.
constexpr double LargestBias = 1e9;

}

//------------------------------------------------------------------------------
vtkDepthShadowMapPass::vtkDepthShadowMapPass()
  : Internal(new Internals)
{
}

vtkDepthShadowMapPass::~vtkDepthShadowMapPass() = default;

//------------------------------------------------------------------------------
int vtkDepthShadowMapPass::GetNumberOfFilters()
{
  return static_cast<int>(std::size(FilterNames));
}

std::string vtkDepthShadowMapPass::GetFilterName(int filter)
{
  return filter >= 0 && filter < GetNumberOfFilters() ? FilterNames[filter] : std::string();
}

bool vtkDepthShadowMapPass::HasDepthBits(const std::string& filter, int bits)
{
  // A ramp is no depth to the driver, and its steps leave nothing to blur.
  const bool isOfDepths = filter == FilterNames[HARDWARE] || filter == FilterNames[SAMPLE_LIGHTS] ||
    filter == FilterNames[VARIANCE] || filter == FilterNames[EXPONENTIAL] ||
    filter == FilterNames[EXACT];
  return bits == 16 || bits == 24 || bits == 32 || (bits == 8 && !isOfDepths);
}

//------------------------------------------------------------------------------
// What maps hold may depend on any setting: they are drawn again.
template <typename T>
void vtkDepthShadowMapPass::Change(T& setting, T value)
{
  if (value != setting)
  {
    setting = value;
    this->ForgetMaps();
    this->Internal->Sampled.ForgetMaps();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::SetFilter(int filter)
{
  if (!vtkShadowRefusesChoice(this, "Filter", "vtkDepthShadowMapPass::FilterType", filter,
        GetNumberOfFilters(), this->Filter))
  {
    this->Change(this->Filter, filter);
  }
}

void vtkDepthShadowMapPass::SetFilter(const std::string& name)
{
  this->SetFilter(
    vtkShadowChoiceOf(this, "Filter", FilterNames, name, this->Filter).value_or(this->Filter));
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::SetFilterRadius(double texels)
{
  if (!vtkShadowRefusesRange(this, "FilterRadius", texels, 0.5, 64.0, this->FilterRadius))
  {
    this->Change(this->FilterRadius, texels);
  }
}

void vtkDepthShadowMapPass::SetFilterTaps(int taps)
{
  if (!vtkShadowRefusesRange(this, "FilterTaps", taps, 1, 256, this->FilterTaps))
  {
    this->Change(this->FilterTaps, taps);
  }
}

void vtkDepthShadowMapPass::SetLightSamples(int samples)
{
  if (!vtkShadowRefusesRange(
        this, "LightSamples", samples, 1, int(MostLightSamples), this->LightSamples))
  {
    this->Change(this->LightSamples, samples);
  }
}

void vtkDepthShadowMapPass::SetSampleResolution(int resolution)
{
  if (!vtkShadowRefusesSize(this, "SampleResolution", "a map", resolution, this->SampleResolution))
  {
    this->Change(this->SampleResolution, resolution);
  }
}

void vtkDepthShadowMapPass::SetLightBleedingReduction(double reduction)
{
  if (!vtkShadowRefusesRange(
        this, "LightBleedingReduction", reduction, 0.0, 0.99, this->LightBleedingReduction))
  {
    this->Change(this->LightBleedingReduction, reduction);
  }
}

void vtkDepthShadowMapPass::SetExponentialConstant(double constant)
{
  if (!vtkShadowRefusesRange(
        this, "ExponentialConstant", constant, 1.0, 80.0, this->ExponentialConstant))
  {
    this->Change(this->ExponentialConstant, constant);
  }
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::SetDepthBits(int bits)
{
  if (!vtkShadowRefusesDepthBits(this, bits, this->DepthBits))
  {
    this->Change(this->DepthBits, bits);
  }
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::SetBiasMode(int mode)
{
  if (!vtkShadowRefusesChoice(
        this, "BiasMode", "vtkDepthShadowMapPass::BiasModeType", mode, 2, this->BiasMode))
  {
    this->Change(this->BiasMode, mode);
  }
}

void vtkDepthShadowMapPass::SetConstantBias(double steps)
{
  if (!vtkShadowRefusesRange(
        this, "ConstantBias", steps, -LargestBias, LargestBias, this->ConstantBias))
  {
    this->Change(this->ConstantBias, steps);
  }
}

void vtkDepthShadowMapPass::SetSlopeBias(double factor)
{
  if (!vtkShadowRefusesRange(this, "SlopeBias", factor, -LargestBias, LargestBias, this->SlopeBias))
  {
    this->Change(this->SlopeBias, factor);
  }
}

void vtkDepthShadowMapPass::SetBeyond(int beyond)
{
  if (!vtkShadowRefusesChoice(
        this, "Beyond", "vtkDepthShadowMapPass::BeyondType", beyond, 3, this->Beyond))
  {
    this->Change(this->Beyond, beyond);
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkDepthShadowMapPass::GetTextureMemory() const
{
  const Internals& my = *this->Internal;
  return static_cast<vtkIdType>(my.Maps.Bytes() + my.Depths.Bytes() + my.Moments.Bytes() +
    my.Sampled.Bytes() + my.Triangles.TextureBytes() + my.Transmittance.Bytes());
}

vtkIdType vtkDepthShadowMapPass::GetCasterMemory() const
{
  return static_cast<vtkIdType>(this->Internal->Triangles.CasterBytes());
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::ReleaseGraphicsResources(vtkWindow* w)
{
  Internals& my = *this->Internal;
  my.Maps.Release();
  my.Depths.Release();
  my.Moments.Release();
  my.Sampled.Release();
  my.Triangles.Release();
  my.Transmittance.Release();
  this->Superclass::ReleaseGraphicsResources(w);
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Filter: " << GetFilterName(this->Filter) << "\n";
  os << indent << "FilterRadius: " << this->FilterRadius << "\n";
  os << indent << "FilterTaps: " << this->FilterTaps << "\n";
  os << indent << "LightSamples: " << this->LightSamples << "\n";
  os << indent << "SampleResolution: " << this->SampleResolution << "\n";
  os << indent << "LightBleedingReduction: " << this->LightBleedingReduction << "\n";
  os << indent << "ExponentialConstant: " << this->ExponentialConstant << "\n";
  os << indent << "DepthBits: " << this->DepthBits << "\n";
  os << indent << "BiasMode: " << (this->BiasMode == AUTOMATIC_BIAS ? "automatic" : "manual")
     << "\n";
  os << indent << "ConstantBias: " << this->ConstantBias << "\n";
  os << indent << "SlopeBias: " << this->SlopeBias << "\n";
  os << indent << "Beyond: " << this->Beyond << "\n";
}
