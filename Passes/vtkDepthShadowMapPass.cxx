#include "vtkDepthShadowMapPass.h"

#include "ShadowReach.h"
#include "vtkDepthShadowMapPassLookup.h"
#include "vtkShadowDrawScope.h"
#include "vtkShadowHiddenFaces.h"
#include "vtkShadowMatrix.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowedShadingPass.h"

#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp3D.h"
#include "vtkShaderProgram.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

vtkStandardNewMacro(vtkDepthShadowMapPass);

namespace
{

using vtkshadows::BoxCorners;
using vtkshadows::LightKind;
using vtkshadows::LightView;
using vtkshadows::ShadowLight;

// Texels left free on each side of a map, so that the four around any receiver lie in it.
constexpr double MarginTexels = 2.0;

// A layer is a few columns wider than its map where the driver lets it: rows of a power of two
// would fall on the same few lines of a processor's cache.
constexpr int PaddingTexels = 16;

constexpr double RiseTexels = 0.5;

int LayerWidth(int resolution)
{
  return std::min(resolution + PaddingTexels, vtkShadowTextureArray::LargestSide());
}

// A matrix as GLSL takes it.
using ShaderMatrix = std::array<float, 16>;

// Takes every point nearer to the light than any caster.
const ShaderMatrix LitEverywhere = { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 1 };

// From the clip space of a view to a map of width x height texels.
glm::dmat4 MapFromClip(int width, int height)
{
  const glm::dvec3 half(0.5 * width, 0.5 * height, 0.5);
  return glm::scale(glm::translate(glm::dmat4(1.0), half), half);
}

// What a receiver's depth is less by in a map of `width` texels, over w.
//
// First a bound of its rounding on the casters, on which a rounding could show as acne: a depth is
// a sum of terms, each rounded, that may be far larger than itself (an eye far from a small scene).
// In a perspective map w has its share, by the largest depth, 1. `map` takes it there from the
// eye's view coordinates, which are what floats get.
//
// Then a share of a texel's own width, as depth: beside the receiver's triangle the surface may
// rise out of its plane. In a perspective map both the width and the depth's step go with w, so
// that it is a constant here, too.
double DepthSlack(const glm::dmat4& map, const LightView& view, const glm::dmat4& viewFromWorld,
  int width, const std::vector<BoxCorners>& castersWC)
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
    RiseTexels * std::abs(step) / (view.clipFromView[0][0] * width);
}

// From the eye's view coordinates to a map of width x height texels, all in double.
glm::dmat4 MapFromView(const LightView& view, const glm::dmat4& viewFromWorld, int width,
  int height, const std::vector<BoxCorners>& castersWC)
{
  glm::dmat4 map = MapFromClip(width, height) * view.clipFromView *
    (view.viewFromWorld * glm::inverse(viewFromWorld));
  map[3][2] -= DepthSlack(map, view, viewFromWorld, width, castersWC);
  return map;
}

// A face of a cube as the lookup takes it.
using FaceParameters = std::array<float, 4>;

// A face on which nothing casts: every depth is nearer to the light.
constexpr FaceParameters LitFace = { -1.0f, 0.0f, 0.0f, 1.0f };

// In a cube of which `unit` is 1.
FaceParameters ParametersOf(const LightView& view, const glm::dmat4& viewFromWorld, int layer,
  int side, double unit, const std::vector<BoxCorners>& castersWC)
{
  const glm::dmat4 map = MapFromClip(side, side) * view.clipFromView;
  const double slack = DepthSlack(
    map * (view.viewFromWorld * glm::inverse(viewFromWorld)), view, viewFromWorld, side, castersWC);
  return { static_cast<float>(-map[2][2]), static_cast<float>((map[3][2] - slack) / unit),
    static_cast<float>(layer), static_cast<float>(0.5 * side * view.clipFromView[0][0]) };
}

// Texels of a side that is `share` of the longest; never none.
int TexelsOf(int resolution, double share)
{
  return std::clamp(static_cast<int>(std::ceil(resolution * share)), 1, resolution);
}

// What a map was drawn from: equal states give equal maps.
struct MapState
{
  bool Drawn = false;
  LightView View;
  vtkMTimeType CasterStamp = 0;
  std::vector<std::size_t> Casters;

  bool operator==(const MapState& other) const
  {
    return this->Drawn == other.Drawn && this->CasterStamp == other.CasterStamp &&
      this->View.viewFromWorld == other.View.viewFromWorld &&
      this->View.clipFromView == other.View.clipFromView && this->Casters == other.Casters;
  }
};

constexpr int NoLayer = -1;

// One view of a light, in this frame.
struct PlacedView
{
  MapState Wanted;
  int Face = vtkshadows::NoFace;
  int Layer = NoLayer;
};

// What a slot's light needs of this frame.
struct SlotMaps
{
  vtkshadows::LightKind Kind = LightKind::Directional;
  bool IsCube = false;
  glm::dmat4 CubeFromWorld{ 1.0 };
  std::vector<BoxCorners> Casters; // that can cast on a receiver
  std::vector<PlacedView> Views;
};

// What a shader is written with for a slot.
struct SlotLookup
{
  std::string Function;
  int Index = 0; // of its layer, or of its cube

  bool operator==(const SlotLookup& other) const
  {
    return this->Function == other.Function && this->Index == other.Index;
  }
};

// Who can cast on any of the receivers.
SlotMaps MapsOf(const vtkShadowScene& scene, const vtkShadowScene::Light& light,
  const std::vector<BoxCorners>& receivers, double margin)
{
  const std::vector<vtkShadowScene::Prop>& props = scene.GetProps();
  SlotMaps maps;
  std::vector<std::size_t> owners; // of the casters, among the props
  for (std::size_t i = 0; i < props.size(); ++i)
  {
    for (const vtkShadowScene::Piece& piece : props[i].Pieces)
    {
      if (props[i].Casts && !vtkshadows::CastsOnNothing(piece.PlaneWC, light.Ray, receivers))
      {
        maps.Casters.push_back(piece.CornersWC);
        owners.push_back(i);
      }
    }
  }

  const vtkshadows::LightViews fitted =
    vtkshadows::FitLightViews(light.Ray, maps.Casters, receivers, margin);
  maps.Kind = light.Ray.kind;
  maps.IsCube = fitted.isCube;
  maps.CubeFromWorld = fitted.cubeFromWorld;
  for (const vtkshadows::FittedLightView& view : fitted.views)
  {
    PlacedView placed;
    placed.Face = view.face;
    placed.Wanted.Drawn = true;
    placed.Wanted.View = view.view;
    placed.Wanted.CasterStamp = scene.GetCasterStamp();
    for (const std::size_t caster : view.casters)
    {
      placed.Wanted.Casters.push_back(owners[caster]);
    }
    std::vector<std::size_t>& drawn = placed.Wanted.Casters; // in ascending order
    drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
    maps.Views.push_back(placed);
  }
  return maps;
}

}

//------------------------------------------------------------------------------
class vtkDepthShadowMapPass::Internals
{
public:
  vtkShadowTextureArray Maps;
  std::vector<MapState> States; // one a layer
  std::vector<SlotMaps> Slots;
  std::vector<SlotLookup> Lookups;    // one a slot
  std::vector<ShaderMatrix> Matrices; // one a slot
  std::vector<FaceParameters> Faces;  // six a cube
  vtkShadowHiddenFaces HiddenFaces;
  int UsedResolution = 0;

  void PlaceViews(std::vector<SlotMaps>&& slots);
  bool UpdateLookups(const glm::dmat4& viewFromWorld);
  // Square texels: the shorter side of a map has fewer.
  int WidthOf(const LightView& view) const
  {
    return TexelsOf(this->UsedResolution, view.clipFromView[1][1] / view.clipFromView[0][0]);
  }
  int HeightOf(const LightView& view) const
  {
    return TexelsOf(this->UsedResolution, view.clipFromView[0][0] / view.clipFromView[1][1]);
  }
};

//------------------------------------------------------------------------------
// Gives each view a layer: one that holds its map already, else that of the frame before, else any.
void vtkDepthShadowMapPass::Internals::PlaceViews(std::vector<SlotMaps>&& slots)
{
  std::vector<bool> taken(this->States.size(), false);
  const auto before = [this](std::size_t slot, int face)
  {
    if (slot < this->Slots.size())
    {
      for (const PlacedView& view : this->Slots[slot].Views)
      {
        if (view.Face == face && view.Layer < static_cast<int>(this->States.size()))
        {
          return view.Layer;
        }
      }
    }
    return NoLayer;
  };
  const auto place = [&](const auto& layerOf)
  {
    for (std::size_t slot = 0; slot < slots.size(); ++slot)
    {
      for (PlacedView& view : slots[slot].Views)
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
      if (!taken[layer] && isWanted(this->States[layer]))
      {
        return static_cast<int>(layer);
      }
    }
    return NoLayer;
  };

  place(
    [&](std::size_t slot, const PlacedView& view)
    {
      const int layer = before(slot, view.Face);
      return layer != NoLayer && this->States[layer] == view.Wanted ? layer : NoLayer;
    });
  place([&](std::size_t, const PlacedView& view)
    { return find([&view](const MapState& state) { return state == view.Wanted; }); });
  place([&](std::size_t slot, const PlacedView& view) { return before(slot, view.Face); });
  place([&](std::size_t, const PlacedView&) { return find([](const MapState&) { return true; }); });
  this->Slots = std::move(slots);
}

//------------------------------------------------------------------------------
// What the lookup is told of each slot; whether other shaders are needed for it.
bool vtkDepthShadowMapPass::Internals::UpdateLookups(const glm::dmat4& viewFromWorld)
{
  std::vector<SlotLookup> lookups;
  this->Matrices.clear();
  this->Faces.clear();
  for (const SlotMaps& slot : this->Slots)
  {
    SlotLookup lookup;
    lookup.Function =
      slot.Kind == LightKind::Directional ? "shadowDepthMapParallel" : "shadowDepthMapPerspective";
    ShaderMatrix matrix = LitEverywhere;
    if (slot.IsCube && !slot.Views.empty())
    {
      lookup.Function = "shadowDepthMapCube";
      lookup.Index = static_cast<int>(this->Faces.size() / 6);
      this->Faces.resize(this->Faces.size() + 6, LitFace);
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
      for (const PlacedView& view : slot.Views)
      {
        this->Faces[6 * lookup.Index + view.Face] = ParametersOf(
          view.Wanted.View, viewFromWorld, view.Layer, this->UsedResolution, unit, slot.Casters);
      }
      glm::dmat4 cube = slot.CubeFromWorld * glm::inverse(viewFromWorld) / unit;
      cube[3][3] = 0.0; // a direction, and not lit everywhere
      matrix = vtkShadowMatrix::ToFloats(cube);
    }
    else if (!slot.IsCube && !slot.Views.empty())
    {
      const LightView& view = slot.Views.front().Wanted.View;
      lookup.Index = slot.Views.front().Layer;
      matrix = vtkShadowMatrix::ToFloats(
        MapFromView(view, viewFromWorld, this->WidthOf(view), this->HeightOf(view), slot.Casters));
    }
    lookups.push_back(lookup);
    this->Matrices.push_back(matrix);
  }
  const bool changed = !(lookups == this->Lookups);
  this->Lookups = lookups;
  return changed;
}

//------------------------------------------------------------------------------
vtkDepthShadowMapPass::vtkDepthShadowMapPass()
  : Internal(new Internals)
{
}

vtkDepthShadowMapPass::~vtkDepthShadowMapPass() = default;

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::SetResolution(int resolution)
{
  if (resolution < 1)
  {
    vtkErrorMacro("Resolution " << resolution
                                << " is no size of a map: give 1 or more texels. It stays "
                                << this->Resolution << ".");
    return;
  }
  if (resolution != this->Resolution)
  {
    this->Resolution = resolution;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkDepthShadowMapPass::UpdateVisibility(
  const vtkShadowFrame& frame, const std::vector<int>& lights)
{
  Internals& my = *this->Internal;
  const vtkShadowScene& scene = *frame.Scene;
  my.UsedResolution = this->WithinDriver("Resolution", this->Resolution);
  const std::vector<BoxCorners> receivers = vtkShadowReceiverCorners(scene);
  std::vector<SlotMaps> slots;
  std::size_t views = 0;
  for (const int light : lights)
  {
    slots.push_back(MapsOf(
      scene, scene.GetLights()[light], receivers, MarginTexels / std::max(my.UsedResolution, 8)));
    views += slots.back().Views.size();
  }

  const int layers = std::max(static_cast<int>(views), 1);
  if (my.Maps.Reserve(frame.Window, vtkShadowTextureArray::Format::Depth32F,
        LayerWidth(my.UsedResolution), my.UsedResolution, layers))
  {
    my.States.clear();
  }
  if (!my.Maps.Id())
  {
    this->WarnOnce(this,
      "The driver has no memory for " + std::to_string(layers) + " shadow maps of " +
        std::to_string(my.UsedResolution) + " x " + std::to_string(my.UsedResolution) +
        " texels: their lights are lit. Lower the resolution.");
    return false;
  }
  this->WarnOnce(this, "");

  my.States.resize(std::max(my.States.size(), static_cast<std::size_t>(layers)));
  my.PlaceViews(std::move(slots));
  my.HiddenFaces.BeginFrame(scene.GetProps());
  for (std::size_t slot = 0; slot < lights.size(); ++slot)
  {
    const ShadowLight& light = scene.GetLights()[lights[slot]].Ray;
    for (const PlacedView& view : my.Slots[slot].Views)
    {
      if (!(my.States[view.Layer] == view.Wanted))
      {
        vtkShadowDrawScope target(frame.Window, my.Maps, view.Layer);
        // All of the layer is cleared, and its outermost texels stay so: what lies off the map is
        // lit.
        target.Clear(nullptr);
        target.Confine(my.WidthOf(view.Wanted.View), my.HeightOf(view.Wanted.View), 1);
        frame.Shading->DrawCasters(frame, view.Wanted.Casters, view.Wanted.View,
          my.HiddenFaces.CulledOf(
            scene.GetProps(), view.Wanted.Casters, vtkshadows::HomogeneousLight(light)));
        ++this->NumberOfMapBuilds;
        my.States[view.Layer] = view.Wanted;
      }
    }
  }
  if (my.UpdateLookups(frame.ViewFromWorld))
  {
    this->LookupStamp.Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkDepthShadowMapPass::GetLookupDeclarations() const
{
  const int side = this->WithinDriver("Resolution", this->Resolution);
  const std::size_t cubes = this->Internal->Faces.size() / 6;
  return "#define SHADOW_DEPTH_MAP_WIDTH " + std::to_string(LayerWidth(side)) +
    "\n#define SHADOW_DEPTH_MAP_HEIGHT " + std::to_string(side) + "\n" +
    (cubes > 0 ? "#define SHADOW_DEPTH_MAP_CUBES " + std::to_string(cubes) + "\n" : "") +
    vtkDepthShadowMapPassLookup;
}

std::string vtkDepthShadowMapPass::GetLookupFunction(int slot, vtkProp*) const
{
  return this->Internal->Lookups[slot].Function;
}

int vtkDepthShadowMapPass::GetLookupIndex(int slot) const
{
  return this->Internal->Lookups[slot].Index;
}

const float* vtkDepthShadowMapPass::GetLookupMatrix(int slot, vtkProp*) const
{
  return this->Internal->Matrices[slot].data();
}

const float* vtkDepthShadowMapPass::GetLitMatrix() const
{
  return LitEverywhere.data();
}

void vtkDepthShadowMapPass::SetLookupParameters(vtkShaderProgram* program, vtkProp*)
{
  const std::vector<FaceParameters>& faces = this->Internal->Faces;
  if (!faces.empty())
  {
    program->SetUniform4fv("shadowDepthMapFaces", static_cast<int>(faces.size()),
      reinterpret_cast<const float(*)[4]>(faces.data()));
  }
}

//------------------------------------------------------------------------------
vtkShadowTextureArray* vtkDepthShadowMapPass::GetTextures()
{
  return &this->Internal->Maps;
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::ReleaseGraphicsResources(vtkWindow* w)
{
  this->Internal->Maps.Release();
  this->Internal->States.clear();
  this->Superclass::ReleaseGraphicsResources(w);
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "NumberOfMapBuilds: " << this->NumberOfMapBuilds << "\n";
}
