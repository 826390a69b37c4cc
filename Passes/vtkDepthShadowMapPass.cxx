#include "vtkDepthShadowMapPass.h"

#include "ShadowReach.h"
#include "vtkDepthShadowMapPassBlurFS.h"
#include "vtkDepthShadowMapPassDisc.h"
#include "vtkDepthShadowMapPassExact.h"
#include "vtkDepthShadowMapPassGather.h"
#include "vtkDepthShadowMapPassHardware.h"
#include "vtkDepthShadowMapPassKernel.h"
#include "vtkDepthShadowMapPassLookup.h"
#include "vtkDepthShadowMapPassMoments.h"
#include "vtkDepthShadowMapPassNone.h"
#include "vtkDepthShadowMapPassRampFS.h"
#include "vtkDepthShadowMapPassReceiver.h"
#include "vtkDepthShadowMapPassSoft.h"
#include "vtkMapShadowPassTexels.h"
#include "vtkShadowDrawScope.h"
#include "vtkShadowFullScreen.h"
#include "vtkShadowHiddenFaces.h"
#include "vtkShadowMapViews.h"
#include "vtkShadowSampledLights.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowText.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowTransmittance.h"
#include "vtkShadowTriangleMaps.h"
#include "vtkShadowedShadingPass.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

vtkStandardNewMacro(vtkDepthShadowMapPass);

namespace
{

// By FilterType.
const char* const FilterNames[] = { "percentage-closer", "none", "hardware", "disc", "soft",
  "sample-lights", "variance", "exponential", "exact" };

// Texels between a kernel and the side of its map.
constexpr double BesideKernel = 2.0;

// The widest kernel of a soft shadow on a face of a cube, as a share of the face.
constexpr double KernelShare = 1.0 / 16.0;

// Far beyond all depths, and a float in the shader.
constexpr double LargestBias = 1e9;

// What a map that repeats or clamps has of the fitted one, along each axis.
constexpr double TightShare = 0.75;

// What a format can tell apart, as depth, or as a share of the way from the near plane to the far
// one.
double StepOf(int depthBits)
{
  return depthBits == 8 ? 1.0 / 255.0 : std::ldexp(1.0, -std::min(depthBits, 24));
}

vtkShadowTextureArray::Format DepthFormatOf(int depthBits)
{
  using Format = vtkShadowTextureArray::Format;
  return depthBits == 16 ? Format::Depth16 : depthBits == 24 ? Format::Depth24 : Format::Depth32F;
}

// The near plane's distance over the far one's; of a directional light, whose depth is linear, 1.
double NearOverFar(const vtkshadows::LightView& view)
{
  const glm::dmat4& clip = view.clipFromView;
  return view.parallel ? 1.0 : (clip[2][2] + 1.0) / (clip[2][2] - 1.0);
}

// Texels along the second side of a map for one along its first: 1, unless it is filled.
double TexelsAlong(const vtkshadows::LightView& view)
{
  const glm::dmat4& clip = view.clipFromView;
  return view.fillsMap ? clip[1][1] / clip[0][0] : 1.0;
}

// Texels that the light's disc spans from its middle to its rim, along the side that has more, per
// depth between what blocks and what receives, in a map of `width` texels: the same at every depth,
// for in the map the cone to the disc is straight.
double PenumbraOf(const vtkshadows::LightView& view, double radius, int width)
{
  const glm::dmat4& clip = view.clipFromView;
  const double texels = 0.5 * clip[0][0] * width * std::max(TexelsAlong(view), 1.0);
  const double depth = 0.5 * std::abs(view.parallel ? clip[2][2] : clip[3][2]);
  return radius * texels / depth;
}

// From depths to a layer of distances, in another format.
void ToDistances(const vtkShadowFrame& frame, vtkShadowTextureArray& from, double nearOverFar,
  vtkShadowTextureArray& to, int layer, bool toDepth)
{
  vtkShadowDrawScope target(
    frame.Window, toDepth ? &to : nullptr, layer, toDepth ? nullptr : &to, layer);
  frame.Window->GetState()->vtkglDepthFunc(GL_ALWAYS);
  vtkShaderProgram* program = vtkShadowFullScreen::Ready(frame.Window, vtkDepthShadowMapPassRampFS);
  from.Activate();
  program->SetUniformi("shadowDepths", from.Unit());
  program->SetUniformf("shadowNearOverFar", static_cast<float>(nearOverFar));
  vtkShadowFullScreen::Draw();
  from.Deactivate();
}

// One axis of it; nearOverFar 0: `from` holds moments.
void Blur(const vtkShadowFrame& frame, vtkShadowTextureArray& from, int fromLayer,
  vtkShadowTextureArray& to, int toLayer, int axis, double nearOverFar, double radius,
  double exponent)
{
  vtkShadowDrawScope target(frame.Window, nullptr, 0, &to, toLayer);
  vtkShaderProgram* program = vtkShadowFullScreen::Ready(frame.Window, vtkDepthShadowMapPassBlurFS);
  const int along[2] = { axis == 0 ? 1 : 0, axis == 0 ? 0 : 1 };
  from.Activate();
  program->SetUniformi("shadowSource", from.Unit());
  program->SetUniformi("shadowLayer", fromLayer);
  program->SetUniform2i("shadowAxis", along);
  program->SetUniformf("shadowRadius", static_cast<float>(radius));
  program->SetUniformf("shadowNearOverFar", static_cast<float>(nearOverFar));
  program->SetUniformf("shadowExponent", static_cast<float>(exponent));
  vtkShadowFullScreen::Draw();
  from.Deactivate();
}

// For uniform arrays: not each layer more needs another shader.
int RoomFor(int layers)
{
  int room = 8;
  while (room < layers)
  {
    room *= 2;
  }
  return room;
}

}

//------------------------------------------------------------------------------
class vtkDepthShadowMapPass::Internals
{
public:
  using Vector = std::array<float, 4>;

  // Of an ordinary map, or of a light in Sampled.
  struct Slot
  {
    bool IsSampled = false;
    int Index = 0;
  };

  vtkShadowTextureArray Maps;    // what is sampled
  vtkShadowTextureArray Depths;  // one layer, where what is sampled is made of it
  vtkShadowTextureArray Moments; // one layer, between the axes of a blur
  vtkShadowSampledLights Sampled;
  vtkShadowHiddenFaces HiddenFaces;
  vtkShadowTriangleMaps Triangles; // of the filter EXACT
  vtkShadowTransmittance Transmittance;
  bool Transmits = false; // some caster of this frame attenuates
  std::vector<Slot> Slots;
  double SoftTexels = 0.0; // the widest kernel on a face of a cube, this frame
  int Room = 8;
  std::vector<Vector> Views;
  std::vector<Vector> Sides;
  std::string SampledShape;
  std::vector<bool> SampledSlots;
  vtkTimeStamp Stamp; // of what shaders are written with, beyond the superclass
};

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

// Written so that NaN is refused.
template <typename T>
bool vtkDepthShadowMapPass::Refuses(const char* name, T value, T low, T high, T setting)
{
  if (value >= low && value <= high)
  {
    return false;
  }
  vtkErrorMacro(<< name << " " << value << " is out of range: give " << low << " to " << high
                << ". It stays " << setting << ".");
  return true;
}

bool vtkDepthShadowMapPass::RefusesChoice(
  const char* name, const char* type, int value, int choices, int setting)
{
  if (value >= 0 && value < choices)
  {
    return false;
  }
  vtkErrorMacro(<< name << " " << value << " is none of vtkDepthShadowMapPass::" << type
                << " (0 to " << choices - 1 << "). It stays " << setting << ".");
  return true;
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::SetFilter(int filter)
{
  if (!this->RefusesChoice("Filter", "FilterType", filter, GetNumberOfFilters(), this->Filter))
  {
    this->Change(this->Filter, filter);
  }
}

void vtkDepthShadowMapPass::SetFilter(const std::string& name)
{
  const auto found = std::find(std::begin(FilterNames), std::end(FilterNames), name);
  if (found == std::end(FilterNames))
  {
    std::string names;
    for (const char* known : FilterNames)
    {
      names += (names.empty() ? "" : ", ") + std::string(known);
    }
    vtkErrorMacro("Filter \"" << name << "\" is not known: use one of " << names << ". It stays \""
                              << GetFilterName(this->Filter) << "\".");
    return;
  }
  this->SetFilter(static_cast<int>(found - std::begin(FilterNames)));
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::SetFilterRadius(double texels)
{
  if (!this->Refuses("FilterRadius", texels, 0.5, 64.0, this->FilterRadius))
  {
    this->Change(this->FilterRadius, texels);
  }
}

void vtkDepthShadowMapPass::SetFilterTaps(int taps)
{
  if (!this->Refuses("FilterTaps", taps, 1, 256, this->FilterTaps))
  {
    this->Change(this->FilterTaps, taps);
  }
}

void vtkDepthShadowMapPass::SetLightSamples(int samples)
{
  if (!this->Refuses("LightSamples", samples, 1, int(MostLightSamples), this->LightSamples))
  {
    this->Change(this->LightSamples, samples);
  }
}

void vtkDepthShadowMapPass::SetSampleResolution(int resolution)
{
  if (!this->Refuses(
        "SampleResolution", resolution, 1, std::numeric_limits<int>::max(), this->SampleResolution))
  {
    this->Change(this->SampleResolution, resolution);
  }
}

void vtkDepthShadowMapPass::SetLightBleedingReduction(double reduction)
{
  if (!this->Refuses("LightBleedingReduction", reduction, 0.0, 0.99, this->LightBleedingReduction))
  {
    this->Change(this->LightBleedingReduction, reduction);
  }
}

void vtkDepthShadowMapPass::SetExponentialConstant(double constant)
{
  if (!this->Refuses("ExponentialConstant", constant, 1.0, 80.0, this->ExponentialConstant))
  {
    this->Change(this->ExponentialConstant, constant);
  }
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::SetDepthBits(int bits)
{
  if (bits != 8 && bits != 16 && bits != 24 && bits != 32)
  {
    vtkErrorMacro("DepthBits " << bits << " is no format of a depth map: give 8, 16, 24 or 32. It "
                               << "stays " << this->DepthBits << ".");
    return;
  }
  this->Change(this->DepthBits, bits);
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::SetBiasMode(int mode)
{
  if (!this->RefusesChoice("BiasMode", "BiasModeType", mode, 2, this->BiasMode))
  {
    this->Change(this->BiasMode, mode);
  }
}

void vtkDepthShadowMapPass::SetConstantBias(double steps)
{
  if (!this->Refuses("ConstantBias", steps, -LargestBias, LargestBias, this->ConstantBias))
  {
    this->Change(this->ConstantBias, steps);
  }
}

void vtkDepthShadowMapPass::SetSlopeBias(double factor)
{
  if (!this->Refuses("SlopeBias", factor, -LargestBias, LargestBias, this->SlopeBias))
  {
    this->Change(this->SlopeBias, factor);
  }
}

void vtkDepthShadowMapPass::SetBeyond(int beyond)
{
  if (!this->RefusesChoice("Beyond", "BeyondType", beyond, 3, this->Beyond))
  {
    this->Change(this->Beyond, beyond);
  }
}

//------------------------------------------------------------------------------
double vtkDepthShadowMapPass::GetMarginTexels() const
{
  switch (this->Filter)
  {
    case DISC:
    case VARIANCE:
    case EXPONENTIAL:
      return BesideKernel + this->FilterRadius;
    default:
      return BesideKernel + this->Internal->SoftTexels;
  }
}

double vtkDepthShadowMapPass::GetRiseTexels() const
{
  return this->BiasMode == AUTOMATIC_BIAS ? Superclass::GetRiseTexels() : 0.0;
}

//------------------------------------------------------------------------------
bool vtkDepthShadowMapPass::UpdateVisibility(
  const vtkShadowFrame& frame, const std::vector<int>& lights)
{
  Internals& my = *this->Internal;
  const bool hasBits = HasDepthBits(GetFilterName(this->Filter), this->DepthBits);
  this->WarnOnce(&this->DepthBits,
    hasBits ? std::string()
            : "Filter \"" + GetFilterName(this->Filter) + "\" has no maps of " +
        std::to_string(this->DepthBits) +
        " DepthBits: lights are lit. Set 16, 24 or 32, or another filter.");
  if (!hasBits)
  {
    return false;
  }

  const std::vector<vtkShadowScene::Prop>& props = frame.Scene->GetProps();
  const bool transmits = std::any_of(props.begin(), props.end(),
    [](const vtkShadowScene::Prop& prop) { return prop.Casts && prop.Transmits; });
  if (transmits != my.Transmits)
  {
    my.Transmits = transmits;
    my.Stamp.Modified();
    this->ForgetMaps();
  }

  // Lights that are sampled have maps of their own.
  std::vector<int> ordinary, sampled;
  std::vector<bool> areSampled;
  my.Slots.clear();
  my.SoftTexels = 0.0;
  for (const int light : lights)
  {
    const bool hasRadius = frame.Scene->GetLights()[light].Ray.radius > 0.0;
    const bool isSampled = hasRadius && this->Filter == SAMPLE_LIGHTS;
    std::vector<int>& kind = isSampled ? sampled : ordinary;
    my.Slots.push_back({ isSampled, static_cast<int>(kind.size()) });
    areSampled.push_back(isSampled);
    kind.push_back(light);
    if (hasRadius && this->Filter == SOFT)
    {
      my.SoftTexels = KernelShare * this->Resolution;
    }
  }
  if (!Superclass::UpdateVisibility(frame, ordinary) || !this->UpdateSampled(frame, sampled))
  {
    return false;
  }

  my.Views.assign(my.Room, {});
  my.Sides.assign(my.Room, {});
  for (const vtkShadowMapSlot& slot : this->GetViews().GetSlots())
  {
    // Beside what one view shows nothing casts; beside one of several another one tells.
    const bool isAlone = !slot.IsCube && slot.Views.size() == 1;
    for (const vtkShadowMapView& view : slot.Views)
    {
      const int width = this->GetViews().WidthOf(view.View);
      const int height = this->GetViews().HeightOf(view.View);
      const float reach = static_cast<float>(isAlone ? this->Resolution : my.SoftTexels);
      my.Views[view.Layer] = { static_cast<float>(PenumbraOf(view.View, slot.Light.radius, width)),
        reach, static_cast<float>(NearOverFar(view.View)),
        static_cast<float>(TexelsAlong(view.View)) };
      const float spare = static_cast<float>(0.5 - 0.5 * TightShare);
      if (isAlone)
      {
        my.Sides[view.Layer] = { spare * width, spare * height, (1.0f - spare) * width,
          (1.0f - spare) * height };
      }
    }
  }
  const std::string shape = std::to_string(my.Room) + my.Sampled.Shape();
  if (shape != my.SampledShape || areSampled != my.SampledSlots)
  {
    my.SampledShape = shape;
    my.SampledSlots = areSampled;
    my.Stamp.Modified();
  }
  if (my.Triangles.TakeShaderChange())
  {
    my.Stamp.Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkDepthShadowMapPass::UpdateSampled(
  const vtkShadowFrame& frame, const std::vector<int>& lights)
{
  Internals& my = *this->Internal;
  const int side = lights.empty() ? this->SampleResolution
                                  : this->WithinDriver("SampleResolution", this->SampleResolution);
  my.Sampled.Fit(frame, lights, this->LightSamples, side, BesideKernel);
  if (lights.empty())
  {
    my.Sampled.Textures.Release();
    my.Sampled.ForgetMaps();
    return true;
  }
  const int layers = std::max(my.Sampled.NumberOfMaps(), 1);
  if (my.Sampled.Textures.Reserve(frame.Window, DepthFormatOf(this->DepthBits), side, side, layers))
  {
    my.Sampled.ForgetMaps();
  }
  const bool isThere = my.Sampled.Textures.Id() != 0;
  this->WarnOnce(&my.Sampled,
    isThere ? std::string()
            : "The driver has no room for " + std::to_string(layers) +
        " maps of sample lights of " + std::to_string(side) + " x " + std::to_string(side) +
        " texels: lights are lit. Lower LightSamples or SampleResolution.");
  if (!isThere)
  {
    return false;
  }
  my.Sampled.DrawStale(
    [&](const vtkshadows::ShadowLight& light, const vtkShadowMapView& view)
    {
      this->DrawDepths(frame, light, view, my.Sampled.Textures, view.Layer, side, side);
      ++this->NumberOfMapBuilds;
    });
  return true;
}

//------------------------------------------------------------------------------
bool vtkDepthShadowMapPass::ReserveMaps(
  const vtkShadowFrame& frame, int width, int height, int layers)
{
  Internals& my = *this->Internal;
  my.Room = RoomFor(layers);
  if (!my.Transmits)
  {
    my.Transmittance.Release();
    return this->ReserveOpaque(frame, width, height, layers);
  }
  const bool isLost = this->ReserveOpaque(frame, width, height, layers);
  const bool areLost = my.Transmittance.Reserve(frame.Window, width, height, layers);
  if (!my.Transmittance.IsReady())
  {
    my.Maps.Release();
  }
  return isLost || areLost;
}

// All but what translucent casters have.
bool vtkDepthShadowMapPass::ReserveOpaque(
  const vtkShadowFrame& frame, int width, int height, int layers)
{
  using Format = vtkShadowTextureArray::Format;
  Internals& my = *this->Internal;
  const Format depths = DepthFormatOf(this->DepthBits);
  const bool isRamp = this->DepthBits == 8;
  if (!isRamp && !this->IsBlurred())
  {
    my.Moments.Release();
    // The map of a parallel view holds distances as it is drawn.
    const auto& slots = this->GetViews().GetSlots();
    const bool needsDepths = this->HasDistances() &&
      std::any_of(slots.begin(), slots.end(),
        [](const vtkShadowMapSlot& slot)
        {
          return std::any_of(slot.Views.begin(), slot.Views.end(),
            [](const vtkShadowMapView& view) { return !view.View.parallel; });
        });
    if (needsDepths)
    {
      my.Depths.Reserve(frame.Window, Format::Depth32F, width, height, 1);
    }
    else
    {
      my.Depths.Release();
    }
    bool isLost = my.Maps.Reserve(frame.Window, depths, width, height, layers);
    if (this->Filter == EXACT)
    {
      isLost = my.Triangles.Reserve(frame.Window, width, height, layers) || isLost;
      if (!my.Triangles.IsReady())
      {
        my.Maps.Release();
      }
    }
    else
    {
      my.Triangles.Release();
    }
    if (needsDepths && !my.Depths.Id())
    {
      my.Maps.Release();
    }
    return isLost;
  }
  my.Triangles.Release();
  const bool lost =
    my.Maps.Reserve(frame.Window, isRamp ? Format::R8 : Format::RG32F, width, height, layers);
  my.Depths.Reserve(frame.Window, depths, width, height, 1);
  if (this->IsBlurred())
  {
    my.Moments.Reserve(frame.Window, Format::RG32F, width, height, 1);
  }
  if (!my.Depths.Id() || (this->IsBlurred() && !my.Moments.Id()))
  {
    my.Maps.Release();
  }
  else if (my.Maps.Id() && this->IsBlurred())
  {
    my.Maps.Smooth();
  }
  return lost;
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::BeginMaps(const vtkShadowFrame& frame)
{
  Internals& my = *this->Internal;
  my.HiddenFaces.BeginFrame(frame.Scene->GetProps());
  if (this->Filter == EXACT)
  {
    for (const std::size_t slot : my.Triangles.Update(frame, this->GetViews()))
    {
      this->ForgetMaps(slot);
    }
    const std::string& fault = my.Triangles.GetFault();
    this->WarnOnce(&my.Triangles,
      fault.empty() ? fault
                    : "The filter \"exact\" has " + fault +
          ": shadows are as by \"percentage-closer\". Decimate the casters, or give fewer lights "
          "this filter.");
  }
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::DrawDepths(const vtkShadowFrame& frame,
  const vtkshadows::ShadowLight& light, const vtkShadowMapView& view,
  const vtkShadowTextureArray& maps, int layer, int width, int height)
{
  vtkShadowDrawScope target(frame.Window, maps, layer);
  // All of the layer is cleared, and its outermost texels stay so: what lies off the map is lit.
  target.Clear(nullptr);
  target.Confine(width, height, 1);
  if (view.Casters.empty())
  {
    return;
  }
  frame.Shading->DrawCasters(frame, view.Casters, view.View,
    this->Internal->HiddenFaces.CulledOf(
      frame.Scene->GetProps(), view.Casters, vtkshadows::HomogeneousLight(light)));
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::DrawMap(const vtkShadowFrame& frame, const vtkShadowMapSlot& slot,
  const vtkShadowMapView& view, int width, int height)
{
  Internals& my = *this->Internal;
  const bool isRamp = this->DepthBits == 8;
  // What is sampled is drawn at once where its depths are the driver's: parallel ones are
  // distances.
  const double ratio = NearOverFar(view.View);
  const bool isDirect =
    !isRamp && !this->IsBlurred() && (!this->HasDistances() || view.View.parallel);
  const vtkShadowTextureArray& drawn = isDirect ? my.Maps : my.Depths;
  const int layer = isDirect ? view.Layer : 0;
  vtkShadowMapView byMappers = view;
  if (this->Filter == EXACT)
  {
    byMappers.Casters = my.Triangles.PlainCasters(view);
  }
  std::vector<std::size_t> translucents;
  const auto transmits = [&frame](std::size_t i) { return frame.Scene->GetProps()[i].Transmits; };
  if (my.Transmits)
  {
    std::copy_if(
      view.Casters.begin(), view.Casters.end(), std::back_inserter(translucents), transmits);
    byMappers.Casters.erase(
      std::remove_if(byMappers.Casters.begin(), byMappers.Casters.end(), transmits),
      byMappers.Casters.end());
  }
  this->DrawDepths(frame, slot.Light, byMappers, drawn, layer, width, height);
  if (this->Filter == EXACT)
  {
    const auto number = static_cast<std::size_t>(&slot - this->GetViews().GetSlots().data());
    my.Triangles.Draw(frame, drawn, layer, number, view, width, height);
  }
  if (my.Transmits)
  {
    my.Transmittance.Draw(frame, view, translucents, drawn, layer, width, height);
  }
  if (this->HasDistances() && !isDirect)
  {
    ToDistances(frame, my.Depths, ratio, my.Maps, view.Layer, !isRamp);
  }
  if (!this->IsBlurred())
  {
    return;
  }
  const double exponent = this->Filter == EXPONENTIAL ? this->ExponentialConstant : 0.0;
  Blur(frame, my.Depths, 0, my.Moments, 0, 0, ratio, this->FilterRadius, exponent);
  Blur(frame, my.Moments, 0, my.Maps, view.Layer, 1, 0.0, this->FilterRadius, 0.0);
}

//------------------------------------------------------------------------------
// Settings as macros, and then the texts that the filter consists of.
std::string vtkDepthShadowMapPass::GetCompareDeclarations() const
{
  return this->Internal->Transmits
    ? vtkShadowTransmittance::Declarations(this->GetOpaqueDeclarations())
    : this->GetOpaqueDeclarations();
}

std::string vtkDepthShadowMapPass::GetOpaqueDeclarations() const
{
  using vtkShadowText::Define;
  using vtkShadowText::Float;
  std::string text = this->GetSharedDeclarations(this->HasDistances());
  if (this->Beyond != LIT_BEYOND)
  {
    text = Define(this->Beyond == REPEAT_BEYOND ? "SHADOW_DEPTH_MAP_REPEATS"
                                                : "SHADOW_DEPTH_MAP_CLAMPS") +
      text;
  }
  text += Define("SHADOW_DEPTH_MAP_TAPS", std::to_string(this->FilterTaps)) +
    Define("SHADOW_DEPTH_MAP_RADIUS", Float(this->FilterRadius));
  switch (this->Filter)
  {
    case NONE:
      return text + vtkDepthShadowMapPassGather + vtkDepthShadowMapPassNone;
    case HARDWARE:
      return text + vtkDepthShadowMapPassHardware;
    case DISC:
      return text + vtkDepthShadowMapPassGather + vtkDepthShadowMapPassKernel +
        vtkDepthShadowMapPassDisc;
    case SOFT:
      return text + vtkDepthShadowMapPassGather + vtkDepthShadowMapPassKernel +
        vtkDepthShadowMapPassSoft;
    case VARIANCE:
      return text + Define("SHADOW_DEPTH_MAP_BLEEDING", Float(this->LightBleedingReduction)) +
        vtkDepthShadowMapPassGather + vtkDepthShadowMapPassMoments;
    case EXPONENTIAL:
      return text + Define("SHADOW_DEPTH_MAP_EXPONENT", Float(this->ExponentialConstant)) +
        vtkDepthShadowMapPassGather + vtkDepthShadowMapPassMoments;
    case EXACT:
      return text + this->Internal->Triangles.Declarations() + vtkDepthShadowMapPassGather +
        vtkDepthShadowMapPassExact;
    default:
      return text + vtkDepthShadowMapPassGather + vtkDepthShadowMapPassLookup;
  }
}

// What every kind of depth map is compared by.
std::string vtkDepthShadowMapPass::GetSharedDeclarations(bool distances) const
{
  using vtkShadowText::Define;
  using vtkShadowText::Float;
  const double step = StepOf(this->DepthBits);
  // A float's rounding is bounded by the lookup's matrix, but for that of the way from distances
  // back to depths. A driver's formats round to either side, a colour to the nearest.
  const bool isFixed = this->DepthBits == 16 || this->DepthBits == 24;
  const double quantum = !isFixed ? 0.0 : distances ? 2.0 * StepOf(24) : step;
  std::string text = Define("SHADOW_DEPTH_MAP_LAYERS", std::to_string(this->Internal->Room)) +
    Define("SHADOW_DEPTH_MAP_QUANTUM", Float(quantum));
  if (distances)
  {
    const double reach = !isFixed ? 0.5 * step : this->BiasMode == MANUAL_BIAS ? 0.0 : step;
    text += Define("SHADOW_DEPTH_MAP_STEP", Float(reach));
  }
  if (this->BiasMode == MANUAL_BIAS)
  {
    text += Define("SHADOW_DEPTH_MAP_CONSTANT_BIAS", Float(this->ConstantBias * step)) +
      Define("SHADOW_DEPTH_MAP_SLOPE_BIAS", Float(this->SlopeBias));
  }
  return text + vtkDepthShadowMapPassReceiver;
}

std::string vtkDepthShadowMapPass::GetLookupDeclarations() const
{
  const std::string shared = this->Named(vtkMapShadowPassTexels) +
    this->GetSharedDeclarations(false) + vtkDepthShadowMapPassGather;
  return Superclass::GetLookupDeclarations() + this->Internal->Sampled.Declarations(shared);
}

//------------------------------------------------------------------------------
std::string vtkDepthShadowMapPass::GetLookupFunction(int slot, vtkProp* prop) const
{
  const Internals::Slot& own = this->Internal->Slots[slot];
  return own.IsSampled ? "shadowSampledLight" : Superclass::GetLookupFunction(own.Index, prop);
}

int vtkDepthShadowMapPass::GetLookupIndex(int slot) const
{
  const Internals::Slot& own = this->Internal->Slots[slot];
  return own.IsSampled ? own.Index : Superclass::GetLookupIndex(own.Index);
}

const float* vtkDepthShadowMapPass::GetLookupMatrix(int slot, vtkProp* prop) const
{
  const Internals::Slot& own = this->Internal->Slots[slot];
  return own.IsSampled ? this->Internal->Sampled.Matrix(own.Index)
                       : Superclass::GetLookupMatrix(own.Index, prop);
}

vtkMTimeType vtkDepthShadowMapPass::GetReceiverStamp() const
{
  return std::max(Superclass::GetReceiverStamp(), this->Internal->Stamp.GetMTime());
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::SetLookupParameters(vtkShaderProgram* program, vtkProp* prop)
{
  Superclass::SetLookupParameters(program, prop);
  const Internals& my = *this->Internal;
  const auto set = [program](const char* name, const std::vector<Internals::Vector>& values)
  {
    if (program->IsUniformUsed(name))
    {
      program->SetUniform4fv(
        name, static_cast<int>(values.size()), reinterpret_cast<const float(*)[4]>(values.data()));
    }
  };
  set("shadowDepthMapViews", my.Views);
  set("shadowDepthMapSides", my.Sides);
  my.Sampled.SetParameters(program);
  my.Transmittance.SetParameters(program);
  if (this->Filter == EXACT)
  {
    my.Triangles.SetParameters(program);
  }
}

//------------------------------------------------------------------------------
vtkShadowTextureArray* vtkDepthShadowMapPass::GetTextures()
{
  return &this->Internal->Maps;
}

void vtkDepthShadowMapPass::ActivateTextures()
{
  Internals& my = *this->Internal;
  if (this->Filter == HARDWARE && my.Maps.Id())
  {
    my.Maps.CompareDepths(true);
  }
  my.Maps.Activate();
  my.Sampled.Textures.Activate();
  my.Transmittance.Activate();
  if (this->Filter == EXACT)
  {
    my.Triangles.Activate();
  }
}

void vtkDepthShadowMapPass::DeactivateTextures()
{
  Internals& my = *this->Internal;
  my.Maps.Deactivate();
  my.Sampled.Textures.Deactivate();
  my.Transmittance.Deactivate();
  my.Triangles.Deactivate();
  if (this->Filter == HARDWARE && my.Maps.Id())
  {
    my.Maps.CompareDepths(false);
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkDepthShadowMapPass::GetTextureMemory() const
{
  const Internals& my = *this->Internal;
  return static_cast<vtkIdType>(my.Maps.Bytes() + my.Depths.Bytes() + my.Moments.Bytes() +
    my.Sampled.Textures.Bytes() + my.Triangles.TextureBytes() + my.Transmittance.Bytes());
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
  my.Sampled.Textures.Release();
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
