#include "vtkShadowMapViews.h"

#include "ShadowReach.h"
#include "vtkShadowMatrix.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

const vtkShadowMapViews::ShaderMatrix vtkShadowMapViews::LitEverywhere = { 0, 0, 0, 0, 0, 0, 0, 0,
  0, 0, 0, 0, 0, 0, -1, 1 };

namespace
{

using vtkshadows::BoxCorners;
using vtkshadows::LightKind;
using vtkshadows::LightView;
using FaceParameters = vtkShadowMapViews::FaceParameters;

constexpr int NoLayer = vtkShadowMapView::NoLayer;

// From the eye's view coordinates to a map of width x height texels, all in double.
glm::dmat4 MapFromView(const LightView& view, const glm::dmat4& viewFromWorld, int width,
  int height, double riseTexels, const std::vector<BoxCorners>& castersWC)
{
  glm::dmat4 map = vtkShadowMatrix::MapFromClip(width, height) * view.clipFromView *
    (view.viewFromWorld * glm::inverse(viewFromWorld));
  map[3][2] -=
    vtkShadowMapViews::DepthSlack(map, view, viewFromWorld, width, riseTexels, castersWC);
  return map;
}

// A face on which nothing casts: every depth is nearer to the light.
constexpr FaceParameters LitFace = { -1.0f, 0.0f, 0.0f, 1.0f };

// In a cube of which `unit` is 1.
FaceParameters ParametersOf(const LightView& view, const glm::dmat4& viewFromWorld, int layer,
  int side, double unit, double riseTexels, const std::vector<BoxCorners>& castersWC)
{
  const glm::dmat4 map = vtkShadowMatrix::MapFromClip(side, side) * view.clipFromView;
  const double slack =
    vtkShadowMapViews::DepthSlack(map * (view.viewFromWorld * glm::inverse(viewFromWorld)), view,
      viewFromWorld, side, riseTexels, castersWC);
  return { static_cast<float>(-map[2][2]), static_cast<float>((map[3][2] - slack) / unit),
    static_cast<float>(layer), static_cast<float>(0.5 * side * view.clipFromView[0][0]) };
}

// Texels of a side that is `share` of the longest; never none.
int TexelsOf(int resolution, double share)
{
  return std::clamp(static_cast<int>(std::ceil(resolution * share)), 1, resolution);
}

// Who can cast on any of the receivers.
vtkShadowMapSlot SlotOf(const vtkShadowScene& scene, const vtkShadowScene::Light& light,
  const std::vector<BoxCorners>& receivers, double margin)
{
  vtkShadowMapSlot slot;
  slot.Light = light.Ray;
  std::vector<std::size_t> owners; // of the casters, among the props
  slot.Casters = vtkShadowMapViews::CastersOf(scene, light.Ray, receivers, owners);

  const vtkshadows::LightViews fitted =
    vtkshadows::FitLightViews(light.Ray, slot.Casters, receivers, margin);
  slot.IsCube = fitted.isCube;
  slot.CubeFromWorld = fitted.cubeFromWorld;
  for (const vtkshadows::FittedLightView& view : fitted.views)
  {
    vtkShadowMapView placed;
    placed.Face = view.face;
    placed.View = view.view;
    placed.CasterStamp = scene.GetCasterStamp();
    for (const std::size_t caster : view.casters)
    {
      placed.Casters.push_back(owners[caster]);
    }
    std::vector<std::size_t>& drawn = placed.Casters; // in ascending order
    drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
    slot.Views.push_back(placed);
  }
  return slot;
}

}

//------------------------------------------------------------------------------
// First a bound of its rounding on the casters, on which a rounding could show as acne: a depth is
// a sum of terms, each rounded, that may be far larger than itself (an eye far from a small scene).
// In a perspective map w has its share, by the largest depth, 1. `map` takes it there from the
// eye's view coordinates, which are what floats get.
//
// Then a share of a texel's own width, as depth: beside the receiver's triangle the surface may
// rise out of its plane. In a perspective map both the width and the depth's step go with w, so
// that it is a constant here, too.
double vtkShadowMapViews::DepthSlack(const glm::dmat4& map, const LightView& view,
  const glm::dmat4& viewFromWorld, int width, double riseTexels,
  const std::vector<BoxCorners>& castersWC)
{
  double farthest = 0.0;
  for (const BoxCorners& corners : castersWC)
  {
    for (const glm::dvec3& corner : corners)
    {
      farthest =
        std::max(farthest, glm::length(glm::dvec3(viewFromWorld * glm::dvec4(corner, 1.0))));
    }
  }
  const glm::dvec4 z = glm::row(map, 2), w = glm::row(map, 3);
  const double zTerms = glm::length(glm::dvec3(z)) * farthest + std::abs(z.w);
  const double wTerms = glm::length(glm::dvec3(w)) * farthest + std::abs(w.w);
  const double step = view.parallel ? view.clipFromView[2][2] : view.clipFromView[3][2];
  return std::ldexp(2.0 * zTerms + 10.0 * wTerms, -24) +
    riseTexels * std::abs(step) / (view.clipFromView[0][0] * width);
}

//------------------------------------------------------------------------------
std::vector<BoxCorners> vtkShadowMapViews::CastersOf(const vtkShadowScene& scene,
  const vtkshadows::ShadowLight& light, const std::vector<BoxCorners>& receivers,
  std::vector<std::size_t>& owners)
{
  const std::vector<vtkShadowScene::Prop>& props = scene.GetProps();
  std::vector<BoxCorners> casters;
  for (std::size_t i = 0; i < props.size(); ++i)
  {
    for (const vtkShadowScene::Piece& piece : props[i].Pieces)
    {
      if (props[i].Casts && !vtkshadows::CastsOnNothing(piece.PlaneWC, light, receivers))
      {
        casters.push_back(piece.CornersWC);
        owners.push_back(i);
      }
    }
  }
  return casters;
}

//------------------------------------------------------------------------------
int vtkShadowMapViews::WidthOf(const LightView& view) const
{
  return TexelsOf(this->Resolution, view.clipFromView[1][1] / view.clipFromView[0][0]);
}

int vtkShadowMapViews::HeightOf(const LightView& view) const
{
  return TexelsOf(this->Resolution, view.clipFromView[0][0] / view.clipFromView[1][1]);
}

//------------------------------------------------------------------------------
void vtkShadowMapViews::Fit(
  const vtkShadowFrame& frame, const std::vector<int>& lights, int resolution, double margin)
{
  this->Resolution = resolution;
  const vtkShadowScene& scene = *frame.Scene;
  const std::vector<BoxCorners> receivers = vtkShadowReceiverCorners(scene);
  this->SlotsBefore = std::move(this->Slots);
  this->Slots.clear();
  for (const int light : lights)
  {
    // A map narrower than its margins is all margin.
    const double share = margin / std::max(static_cast<double>(resolution), 4.0 * margin);
    this->Slots.push_back(SlotOf(scene, scene.GetLights()[light], receivers, share));
  }
}

//------------------------------------------------------------------------------
int vtkShadowMapViews::NumberOfViews() const
{
  std::size_t views = 0;
  for (const vtkShadowMapSlot& slot : this->Slots)
  {
    views += slot.Views.size();
  }
  return static_cast<int>(views);
}

//------------------------------------------------------------------------------
// The one that holds its map already, else that of the frame before, else any.
void vtkShadowMapViews::Place(int layers)
{
  this->Drawn.resize(std::max(this->Drawn.size(), static_cast<std::size_t>(layers)));
  std::vector<bool> taken(this->Drawn.size(), false);
  const auto place = [&](const auto& layerOf)
  {
    for (std::size_t slot = 0; slot < this->Slots.size(); ++slot)
    {
      for (vtkShadowMapView& view : this->Slots[slot].Views)
      {
        const int layer = view.Layer == NoLayer ? layerOf(slot, view) : NoLayer;
        if (layer != NoLayer && !taken[layer])
        {
          view.Layer = layer;
          taken[layer] = true;
        }
      }
    }
  };
  const auto find = [&](const auto& isWanted)
  {
    for (std::size_t layer = 0; layer < taken.size(); ++layer)
    {
      if (!taken[layer] && isWanted(this->Drawn[layer]))
      {
        return static_cast<int>(layer);
      }
    }
    return NoLayer;
  };
  const auto holds = [](const Content& content, const vtkShadowMapView& view)
  { return content.Known && content.Of.DrawsAs(view); };

  place(
    [&](std::size_t slot, const vtkShadowMapView& view)
    {
      const int layer = this->LayerBefore(slot, view.Face);
      return layer != NoLayer && holds(this->Drawn[layer], view) ? layer : NoLayer;
    });
  place([&](std::size_t, const vtkShadowMapView& view)
    { return find([&](const Content& content) { return holds(content, view); }); });
  place([&](std::size_t slot, const vtkShadowMapView& view)
    { return this->LayerBefore(slot, view.Face); });
  place([&](std::size_t, const vtkShadowMapView&)
    { return find([](const Content&) { return true; }); });
}

//------------------------------------------------------------------------------
int vtkShadowMapViews::LayerBefore(std::size_t slot, int face) const
{
  if (slot < this->SlotsBefore.size())
  {
    for (const vtkShadowMapView& view : this->SlotsBefore[slot].Views)
    {
      if (view.Face == face && view.Layer < static_cast<int>(this->Drawn.size()))
      {
        return view.Layer;
      }
    }
  }
  return NoLayer;
}

//------------------------------------------------------------------------------
bool vtkShadowMapViews::UpdateLookups(
  const std::string& prefix, const glm::dmat4& viewFromWorld, double riseTexels)
{
  std::vector<Lookup> lookups;
  this->Matrices.clear();
  this->CubeFaces.clear();
  for (const vtkShadowMapSlot& slot : this->Slots)
  {
    Lookup lookup;
    lookup.Function =
      prefix + (slot.Light.kind == LightKind::Directional ? "Parallel" : "Perspective");
    ShaderMatrix matrix = LitEverywhere;
    if (slot.IsCube && !slot.Views.empty())
    {
      lookup.Function = prefix + "Cube";
      lookup.Index = static_cast<int>(this->CubeFaces.size() / 6);
      this->CubeFaces.resize(this->CubeFaces.size() + 6, LitFace);
      // Of a size that the squares and cubes of its coordinates are floats.
      double unit = 0.0;
      for (const BoxCorners& corners : slot.Casters)
      {
        for (const glm::dvec3& corner : corners)
        {
          unit =
            std::max(unit, glm::length(glm::dvec3(slot.CubeFromWorld * glm::dvec4(corner, 1.0))));
        }
      }
      for (const vtkShadowMapView& view : slot.Views)
      {
        this->CubeFaces[6 * lookup.Index + view.Face] = ParametersOf(
          view.View, viewFromWorld, view.Layer, this->Resolution, unit, riseTexels, slot.Casters);
      }
      glm::dmat4 cube = slot.CubeFromWorld * glm::inverse(viewFromWorld) / unit;
      cube[3][3] = 0.0; // a direction, and not lit everywhere
      matrix = vtkShadowMatrix::ToFloats(cube);
    }
    else if (!slot.IsCube && !slot.Views.empty())
    {
      const LightView& view = slot.Views.front().View;
      lookup.Index = slot.Views.front().Layer;
      matrix = vtkShadowMatrix::ToFloats(MapFromView(
        view, viewFromWorld, this->WidthOf(view), this->HeightOf(view), riseTexels, slot.Casters));
    }
    lookups.push_back(lookup);
    this->Matrices.push_back(matrix);
  }
  const bool changed = !(lookups == this->Lookups);
  this->Lookups = lookups;
  return changed;
}
