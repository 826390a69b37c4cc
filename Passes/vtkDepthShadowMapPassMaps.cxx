#include "vtkDepthShadowMapPassInternals.h"

#include "ShadowReach.h"
#include "vtkDepthShadowMapPassBlurFS.h"
#include "vtkDepthShadowMapPassRampFS.h"
#include "vtkShadowDrawScope.h"
#include "vtkShadowFullScreen.h"
#include "vtkShadowMapViews.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowedShadingPass.h"

#include <iterator>

namespace
{

// Texels between a kernel and the side of its map.
constexpr double BesideKernel = 2.0;

// The widest kernel of a soft shadow on a face of a cube, as a share of the face.
constexpr double KernelShare = 1.0 / 16.0;

// What a map that repeats or clamps has of the fitted one, along each axis.
constexpr double TightShare = 0.75;

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
    my.Sampled.Release();
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
  my.Sampled.UploadRows(frame.Window);
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
  bool hasPlain = true;
  if (this->Filter == EXACT)
  {
    byMappers.Casters = my.Triangles.PlainCasters(view);
    hasPlain = !byMappers.Casters.empty();
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
    my.Triangles.Draw(frame, drawn, layer, number, view, hasPlain, width, height);
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
