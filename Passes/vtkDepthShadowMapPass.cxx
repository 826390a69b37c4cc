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

// From the eye's view coordinates to a map of width x height texels, all in double; the eye's view
// coordinates are what floats get. Depth is less by a bound of its rounding on the casters, on
// which a rounding could show as acne: a depth is a sum of terms, each rounded, that may be far
// larger than itself (an eye far from a small scene). In a perspective map w has its share, by the
// largest depth, 1.
glm::dmat4 MapFromView(const LightView& view, const glm::dmat4& viewFromWorld, int width,
  int height, const std::vector<BoxCorners>& castersWC)
{
  const glm::dvec3 half(0.5 * width, 0.5 * height, 0.5);
  const glm::dmat4 mapFromClip = glm::scale(glm::translate(glm::dmat4(1.0), half), half);
  glm::dmat4 map =
    mapFromClip * view.clipFromView * (view.viewFromWorld * glm::inverse(viewFromWorld));

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
  map[3][2] -= std::ldexp(2.0 * zTerms + 10.0 * wTerms, -24);

  // A share of a texel's own width, as depth: beside the receiver's triangle the surface may rise
  // out of its plane. In a perspective map both the width and the depth's step go with w, so that
  // it is a constant here, too.
  const double step = view.parallel ? view.clipFromView[2][2] : view.clipFromView[3][2];
  map[3][2] -= RiseTexels * std::abs(step) / (view.clipFromView[0][0] * width);
  return map;
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

}

//------------------------------------------------------------------------------
class vtkDepthShadowMapPass::Internals
{
public:
  vtkShadowTextureArray Maps;
  std::vector<MapState> States;       // one a slot
  std::vector<ShaderMatrix> Matrices; // one a slot
  std::vector<BoxCorners> Receivers;  // of this frame, the same for every light
  vtkShadowHiddenFaces HiddenFaces;
  int UsedResolution = 0;
};

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
  const int slots = static_cast<int>(lights.size());
  my.UsedResolution = this->WithinDriver("Resolution", this->Resolution);
  if (my.Maps.Reserve(frame.Window, vtkShadowTextureArray::Format::Depth32F,
        LayerWidth(my.UsedResolution), my.UsedResolution, slots))
  {
    my.States.clear();
  }
  if (!my.Maps.Id())
  {
    this->WarnOnce(this,
      "The driver has no memory for " + std::to_string(slots) + " shadow maps of " +
        std::to_string(my.UsedResolution) + " x " + std::to_string(my.UsedResolution) +
        " texels: their lights are lit. Lower the resolution.");
    return false;
  }
  this->WarnOnce(this, "");

  my.States.resize(slots);
  my.Matrices.resize(slots);
  my.Receivers = vtkShadowReceiverCorners(*frame.Scene);
  my.HiddenFaces.BeginFrame(frame.Scene->GetProps());
  for (int slot = 0; slot < slots; ++slot)
  {
    this->UpdateMap(frame, lights[slot], slot);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::UpdateMap(const vtkShadowFrame& frame, int lightIndex, int slot)
{
  Internals& my = *this->Internal;
  const vtkShadowScene::Light& light = frame.Scene->GetLights()[lightIndex];
  const std::vector<vtkShadowScene::Prop>& props = frame.Scene->GetProps();

  // Who can cast on any of them.
  const std::vector<BoxCorners>& receivers = my.Receivers;
  std::vector<BoxCorners> casters;
  MapState wanted;
  for (std::size_t i = 0; i < props.size(); ++i)
  {
    const std::size_t before = casters.size();
    for (const vtkShadowScene::Piece& piece : props[i].Pieces)
    {
      if (props[i].Casts && !vtkshadows::CastsOnNothing(piece.PlaneWC, light.Ray, receivers))
      {
        casters.push_back(piece.CornersWC);
      }
    }
    if (casters.size() > before)
    {
      wanted.Casters.push_back(i);
    }
  }

  const vtkshadows::LightViewResult fitted = vtkshadows::FitLightView(
    light.Ray, casters, receivers, MarginTexels / std::max(my.UsedResolution, 8));
  this->WarnOnce(light.Source,
    fitted.fit == vtkshadows::LightViewFit::Refused
      ? "One depth map cannot hold this light, because " + fitted.reason +
        ": it is lit. Use the technique \"ray-cast\" for it."
      : "");
  if (fitted.fit != vtkshadows::LightViewFit::Fitted)
  {
    my.Matrices[slot] = LitEverywhere;
    my.States[slot] = MapState();
    return;
  }

  // Square texels: the shorter side has fewer.
  const double aspect = fitted.view.clipFromView[0][0] / fitted.view.clipFromView[1][1];
  const int width = TexelsOf(my.UsedResolution, 1.0 / aspect);
  const int height = TexelsOf(my.UsedResolution, aspect);

  wanted.Drawn = true;
  wanted.View = fitted.view;
  wanted.CasterStamp = frame.Scene->GetCasterStamp();
  if (!(my.States[slot] == wanted))
  {
    vtkShadowDrawScope target(frame.Window, my.Maps, slot);
    // All of the layer is cleared, and its outermost texels stay so: what lies off the map is lit.
    target.Clear(nullptr);
    target.Confine(width, height, 1);
    frame.Shading->DrawCasters(frame, wanted.Casters, fitted.view,
      my.HiddenFaces.CulledOf(props, wanted.Casters, vtkshadows::HomogeneousLight(light.Ray)));
    ++this->NumberOfMapBuilds;
    my.States[slot] = wanted;
  }

  my.Matrices[slot] = vtkShadowMatrix::ToFloats(
    MapFromView(fitted.view, frame.ViewFromWorld, width, height, casters));
}

//------------------------------------------------------------------------------
std::string vtkDepthShadowMapPass::GetLookupDeclarations() const
{
  const int side = this->WithinDriver("Resolution", this->Resolution);
  return "#define SHADOW_DEPTH_MAP_WIDTH " + std::to_string(LayerWidth(side)) +
    "\n#define SHADOW_DEPTH_MAP_HEIGHT " + std::to_string(side) + "\n" +
    vtkDepthShadowMapPassLookup;
}

std::string vtkDepthShadowMapPass::GetLookupFunction(
  const vtkshadows::ShadowLight& light, vtkProp*) const
{
  return light.kind == LightKind::Directional ? "shadowDepthMapParallel"
                                              : "shadowDepthMapPerspective";
}

const float* vtkDepthShadowMapPass::GetLookupMatrix(int slot, vtkProp*) const
{
  return this->Internal->Matrices[slot].data();
}

const float* vtkDepthShadowMapPass::GetLitMatrix() const
{
  return LitEverywhere.data();
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
