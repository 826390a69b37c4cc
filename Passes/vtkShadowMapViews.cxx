#include "vtkShadowMapViews.h"

#include "vtkShadowMatrix.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

const double vtkShadowMapViews::PerspectiveRounding = std::ldexp(12.0, -24);

const vtkShadowMapViews::ShaderMatrix vtkShadowMapViews::LitEverywhere = { 0, 0, 0, 0, 0, 0, 0, 0,
  0, 0, 0, 0, 0, 0, -2, 1 };

namespace
{

using vtkshadows::BoxCorners;
using vtkshadows::LightKind;
using vtkshadows::LightView;
using Row = vtkShadowMapViews::Row;

constexpr int NoLayer = vtkShadowMapView::NoLayer;

// A face on which nothing casts: every depth is nearer to the light.
constexpr Row LitFace = { -1.0f, 0.0f, 0.0f, 1.0f };

// Of a sum, how large its terms may be.
double TermsOf(const glm::dvec4& row, double farthest)
{
  return glm::length(glm::dvec3(row)) * farthest + std::abs(row.w);
}

// In a cube of which `unit` is 1.
Row ParametersOf(const LightView& view, const glm::dmat4& viewFromWorld, int layer, int side,
  double unit, double riseTexels, double farthest)
{
  const glm::dmat4 map = vtkShadowMatrix::MapFromClip(side, side) * view.clipFromView;
  const double slack = vtkShadowMapViews::DepthSlack(
    map * (view.viewFromWorld * glm::inverse(viewFromWorld)), view, side, riseTexels, farthest);
  return { static_cast<float>(
             -map[2][2] - vtkShadowMapViews::PerspectiveRounding * std::abs(map[2][2])),
    static_cast<float>((map[3][2] - slack) / unit), static_cast<float>(layer),
    static_cast<float>(0.5 * side * view.clipFromView[0][0]) };
}

// Cells of the grain by which cascades blend, to a unit of length: about one a pixel where the
// first cascade ends, in a window of a thousand pixels; a power of two, which seldom changes while
// the eye moves. Not so many that floats have no digits left for what lies within one.
double CellsOfGrain(double reach, const vtkshadows::CascadeEye& eye, double unit)
{
  const double pixel = 2.0e-3 / eye.clipFromView[1][1];
  const double cells = std::min(1.0 / (pixel * reach), std::ldexp(1.0, 21) / unit);
  return cells > 0.0 && std::isfinite(cells) ? std::ldexp(1.0, std::ilogb(cells)) : 0.0;
}

// Texels of a side that is `share` of the longest; never none.
int TexelsOf(int resolution, double share)
{
  return std::clamp(static_cast<int>(std::ceil(resolution * share)), 1, resolution);
}

}

//------------------------------------------------------------------------------
double vtkShadowMapViews::FarthestIn(
  const glm::dmat4& spaceFromWorld, const std::vector<BoxCorners>& castersWC)
{
  double farthest = 0.0;
  for (const BoxCorners& corners : castersWC)
  {
    for (const glm::dvec3& corner : corners)
    {
      farthest =
        std::max(farthest, glm::length(glm::dvec3(spaceFromWorld * glm::dvec4(corner, 1.0))));
    }
  }
  return farthest;
}

//------------------------------------------------------------------------------
// A bound of its rounding on the casters, on which a rounding could show as acne: a depth is a sum
// of terms, each rounded, that may be far larger than itself (an eye far from a small scene). `map`
// takes it there from the eye's view coordinates, which are what floats get. In a perspective map
// the depth less w, which is what is looked up with, is all but a constant.
//
// And a share of a texel's own width, as depth: beside the receiver's triangle the surface may rise
// out of its plane. In a perspective map both the width and the depth's step go with w, so that it
// is a constant here, too.
double vtkShadowMapViews::DepthSlack(
  const glm::dmat4& map, const LightView& view, int width, double riseTexels, double farthest)
{
  const glm::dvec4 z = glm::row(map, 2) - (view.parallel ? 0.0 : 1.0) * glm::row(map, 3);
  const double rounding =
    std::ldexp(2.0 * TermsOf(z, farthest) + (view.parallel ? 10.0 : 0.0), -24);
  const double step = view.parallel ? view.clipFromView[2][2] : view.clipFromView[3][2];
  // A map that is filled has as many texels on its other side.
  const double perSide = view.fillsMap ? std::min(view.clipFromView[0][0], view.clipFromView[1][1])
                                       : view.clipFromView[0][0];
  return rounding + riseTexels * std::abs(step) / (perSide * width);
}

//------------------------------------------------------------------------------
double vtkShadowMapViews::RoundingReach(const glm::dmat4& spaceFromView, double farthest)
{
  double reach = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    reach = std::max(reach, TermsOf(glm::row(spaceFromView, axis), farthest));
  }
  return reach;
}

//------------------------------------------------------------------------------
int vtkShadowMapViews::WidthOf(const LightView& view) const
{
  return view.fillsMap
    ? this->FittedTo.Resolution
    : TexelsOf(this->FittedTo.Resolution, view.clipFromView[1][1] / view.clipFromView[0][0]);
}

int vtkShadowMapViews::HeightOf(const LightView& view) const
{
  return view.fillsMap
    ? this->FittedTo.Resolution
    : TexelsOf(this->FittedTo.Resolution, view.clipFromView[0][0] / view.clipFromView[1][1]);
}

//------------------------------------------------------------------------------
glm::dmat4 vtkShadowMapViews::MapOf(const LightView& view) const
{
  return vtkShadowMatrix::MapFromClip(this->WidthOf(view), this->HeightOf(view)) *
    view.clipFromView;
}

glm::dmat4 vtkShadowMapViews::MapFromView(
  const LightView& view, const glm::dmat4& viewFromWorld) const
{
  return this->MapOf(view) * (view.viewFromWorld * glm::inverse(viewFromWorld));
}

glm::dmat4 vtkShadowMapViews::ReceiverMap(const vtkShadowMapSlot& slot, const LightView& view,
  const glm::dmat4& viewFromWorld, double riseTexels) const
{
  glm::dmat4 map = this->MapFromView(view, viewFromWorld);
  const double farthest = FarthestIn(viewFromWorld, slot.Casters);
  const double slack = DepthSlack(map, view, this->WidthOf(view), riseTexels, farthest);
  if (view.parallel)
  {
    map[3][2] -= slack;
    return map;
  }
  const glm::dvec4 w = glm::row(map, 3);
  map = glm::row(map, 2, glm::row(map, 2) - (1.0 + PerspectiveRounding) * w);
  map[3][2] -= slack;
  return map / TermsOf(w, farthest);
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
int vtkShadowMapViews::NumberOfLayers() const
{
  int layers = this->NumberOfViews();
  for (const vtkShadowMapSlot& slot : this->Slots)
  {
    layers += slot.FacesOutOfSight;
  }
  return layers;
}

//------------------------------------------------------------------------------
int vtkShadowMapViews::NumberOfSkippedLights() const
{
  return static_cast<int>(std::count_if(this->Slots.begin(), this->Slots.end(),
    [](const vtkShadowMapSlot& slot) { return slot.IsSkipped; }));
}

int vtkShadowMapViews::NumberOfCastersLeftOut() const
{
  int leftOut = 0;
  for (const vtkShadowMapSlot& slot : this->Slots)
  {
    for (const vtkShadowMapView& view : slot.Views)
    {
      leftOut += this->CastersInScene - static_cast<int>(view.Casters.size());
    }
  }
  return leftOut;
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
      const int layer = this->LayerBefore(slot, view);
      return layer != NoLayer && holds(this->Drawn[layer], view) ? layer : NoLayer;
    });
  place([&](std::size_t, const vtkShadowMapView& view)
    { return find([&](const Content& content) { return holds(content, view); }); });
  place(
    [&](std::size_t slot, const vtkShadowMapView& view) { return this->LayerBefore(slot, view); });
  // What other layers hold may be a face of a cube that the eye turns back to.
  place([&](std::size_t, const vtkShadowMapView&)
    { return find([](const Content& content) { return !content.Known; }); });
  place([&](std::size_t, const vtkShadowMapView&)
    { return find([](const Content&) { return true; }); });
}

//------------------------------------------------------------------------------
void vtkShadowMapViews::MarkStale(std::size_t slot)
{
  for (const vtkShadowMapView& view : this->Slots[slot].Views)
  {
    this->Drawn[view.Layer].Known = false;
  }
}

//------------------------------------------------------------------------------
int vtkShadowMapViews::LayerBefore(std::size_t slot, const vtkShadowMapView& like) const
{
  if (slot < this->SlotsBefore.size())
  {
    for (const vtkShadowMapView& view : this->SlotsBefore[slot].Views)
    {
      if (view.Face == like.Face && view.Cascade == like.Cascade && view.Caster == like.Caster &&
        view.Layer < static_cast<int>(this->Drawn.size()))
      {
        return view.Layer;
      }
    }
  }
  return NoLayer;
}

//------------------------------------------------------------------------------
// A receiver goes into the light's axes with the eye as the origin, in which distances are what
// cascades are chosen by, and from there into a map by a factor and an offset an axis. The eye is
// moved to a corner of the grain's cells, less than a pixel away, so that the grain stays where it
// is in the world while the eye walks.
vtkShadowMapViews::ShaderMatrix vtkShadowMapViews::AddCascades(
  const vtkShadowMapSlot& slot, const glm::dmat4& viewFromWorld, double riseTexels, double farthest)
{
  const vtkshadows::LightCascades& light = slot.Cascades;
  const std::size_t first = this->CascadeRows.size();
  const std::size_t firstReach = this->CascadeReaches.size();
  // Nothing casts.
  this->CascadeRows.resize(first + 2 * this->FittedTo.Cascades.count, { 0.0f, 0.0f, -1.0f, 0.0f });
  for (std::size_t i = first + 1; i < this->CascadeRows.size(); i += 2)
  {
    this->CascadeRows[i] = { 1.0f, 1.0f, 0.0f, 0.0f };
  }
  const float noEnd = std::numeric_limits<float>::max();
  this->CascadeReaches.resize(firstReach + this->ReachesPerLight(), { noEnd, noEnd, noEnd, noEnd });
  if (slot.Views.empty())
  {
    return LitEverywhere;
  }

  // Of a size that squares are floats.
  double unit = light.cascades.front().texel * this->FittedTo.Resolution;
  for (const vtkshadows::Cascade& cascade : light.cascades)
  {
    unit = std::isfinite(cascade.reach) ? std::max(unit, cascade.reach) : unit;
  }
  const glm::dmat4 worldFromView = glm::inverse(viewFromWorld);
  const double cells = light.cascades.size() > 1
    ? CellsOfGrain(light.cascades.front().reach, this->FittedTo.Eye, unit)
    : 0.0;
  this->CascadeReaches.back().back() = static_cast<float>(cells * unit);
  glm::dvec3 eye = light.lightFromWorld * light.eyeWC;
  eye = cells > 0.0 ? glm::round(eye * cells) / cells : eye;
  const glm::dvec3 eyeWC = glm::transpose(light.lightFromWorld) * eye;
  const double moved = glm::distance(eyeWC, light.eyeWC);
  const double betweenEyes =
    glm::distance(light.eyeWC, glm::dvec3(worldFromView[3]) / worldFromView[3].w);
  const double viewPerWorld = glm::length(glm::dvec3(viewFromWorld[0]));
  for (std::size_t i = 0; i + 1 < light.cascades.size(); ++i)
  {
    const double reach = std::max(light.cascades[i].reach - moved, 0.0) / unit;
    this->CascadeReaches[firstReach + i / 4][i % 4] = static_cast<float>(reach * reach);
  }
  for (const vtkShadowMapView& placed : slot.Views)
  {
    const LightView& view = placed.View;
    const int width = this->WidthOf(view);
    const glm::dmat4 map = this->MapOf(view);
    const double reach = (light.cascades[placed.Cascade].reach + betweenEyes) * viewPerWorld;
    // Twice: there are two steps to it.
    const double slack = 2.0 *
      DepthSlack(map * (view.viewFromWorld * worldFromView), view, width, riseTexels,
        std::min(reach, farthest));
    const glm::dvec4 origin = map * (view.viewFromWorld * glm::dvec4(eyeWC, 1.0));
    const std::size_t row = first + 2 * placed.Cascade;
    this->CascadeRows[row] = { static_cast<float>(origin.x), static_cast<float>(origin.y),
      static_cast<float>(origin.z - slack), static_cast<float>(placed.Layer) };
    for (int axis = 0; axis < 3; ++axis)
    {
      this->CascadeRows[row + 1][axis] = static_cast<float>(map[axis][axis] * unit);
    }
  }
  glm::dmat4 fromWorld(light.lightFromWorld);
  fromWorld[3] = glm::dvec4(-eye, 1.0);
  glm::dmat4 axes = fromWorld * worldFromView / unit;
  axes[3][3] = 0.0; // a direction, and not lit everywhere
  return vtkShadowMatrix::ToFloats(axes);
}

//------------------------------------------------------------------------------
bool vtkShadowMapViews::UpdateLookups(
  const std::string& prefix, const glm::dmat4& viewFromWorld, double riseTexels)
{
  std::vector<Lookup> lookups;
  this->Matrices.clear();
  this->CubeFaces.clear();
  this->CascadeRows.clear();
  this->CascadeReaches.clear();
  for (std::size_t i = 0; i < this->Slots.size(); ++i)
  {
    const vtkShadowMapSlot& slot = this->Slots[i];
    const double farthest = FarthestIn(viewFromWorld, slot.Casters);
    Lookup lookup;
    lookup.Function =
      prefix + (slot.Light.kind == LightKind::Directional ? "Parallel" : "Perspective");
    ShaderMatrix matrix = LitEverywhere;
    // One that is skipped keeps the shaders it had.
    const bool wasCube = i < this->Lookups.size() && this->Lookups[i].Function == prefix + "Cube";
    if (slot.HasCascades)
    {
      lookup.Function = prefix + "Cascades";
      lookup.Index = static_cast<int>(this->NumberOfCascadedLights());
      matrix = this->AddCascades(slot, viewFromWorld, riseTexels, farthest);
    }
    else if (slot.IsSkipped && !wasCube && i < this->Lookups.size())
    {
      lookup.Index = this->Lookups[i].Index;
    }
    else if (slot.IsSkipped && wasCube)
    {
      lookup.Function = prefix + "Cube";
      lookup.Index = static_cast<int>(this->CubeFaces.size() / 6);
      this->CubeFaces.resize(this->CubeFaces.size() + 6, LitFace);
    }
    else if (slot.IsCube && !slot.Views.empty())
    {
      lookup.Function = prefix + "Cube";
      lookup.Index = static_cast<int>(this->CubeFaces.size() / 6);
      this->CubeFaces.resize(this->CubeFaces.size() + 6, LitFace);
      // Squares and cubes of its coordinates are floats then.
      const double unit = RoundingReach(slot.CubeFromWorld * glm::inverse(viewFromWorld), farthest);
      for (const vtkShadowMapView& view : slot.Views)
      {
        this->CubeFaces[6 * lookup.Index + view.Face] = ParametersOf(view.View, viewFromWorld,
          view.Layer, this->FittedTo.Resolution, unit, riseTexels, farthest);
      }
      glm::dmat4 cube = slot.CubeFromWorld * glm::inverse(viewFromWorld) / unit;
      cube[3][3] = 0.0; // a direction, and not lit everywhere
      matrix = vtkShadowMatrix::ToFloats(cube);
    }
    else if (!slot.IsCube && !slot.Views.empty())
    {
      const LightView& view = slot.Views.front().View;
      lookup.Index = slot.Views.front().Layer;
      matrix = vtkShadowMatrix::ToFloats(this->ReceiverMap(slot, view, viewFromWorld, riseTexels));
    }
    lookups.push_back(lookup);
    this->Matrices.push_back(matrix);
  }
  const bool changed = !(lookups == this->Lookups);
  this->Lookups = lookups;
  return changed;
}
