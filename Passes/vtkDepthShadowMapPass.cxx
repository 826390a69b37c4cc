#include "vtkDepthShadowMapPass.h"

#include "vtkDepthShadowMapPassLookup.h"
#include "vtkShadowDrawScope.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowedShadingPass.h"

#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
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

// Whether the flat piece has every receiver on the light's side of its plane, or on it: then nothing can
// lie in its shadow.
bool CastsOnNothing(const vtkShadowScene::Piece& piece, const ShadowLight& light,
  const std::vector<BoxCorners>& receivers)
{
  const glm::dvec3 normal(piece.PlaneWC);
  if (normal == glm::dvec3(0.0))
  {
    return false;
  }
  const double height = light.kind == LightKind::Directional
    ? -glm::dot(normal, light.direction)
    : glm::dot(normal, light.position) - piece.PlaneWC.w;
  for (const BoxCorners& corners : receivers)
  {
    for (const glm::dvec3& corner : corners)
    {
      // On the plane to the rounding of the floats that points are kept in.
      const double side = glm::dot(normal, corner) - piece.PlaneWC.w;
      const double rounding =
        std::ldexp(std::max(glm::length(corner), std::abs(piece.PlaneWC.w)), -21);
      if (side * (height > 0.0 ? 1.0 : -1.0) < -rounding)
      {
        return false;
      }
    }
  }
  return true;
}

// A matrix that maps every point to w = -1, the lookup's sign for "lit".
glm::dmat4 LitEverywhere()
{
  glm::dmat4 m(0.0);
  m[3][3] = -1.0;
  return m;
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
  std::vector<MapState> States;  // one a slot
  std::vector<float> Matrices;   // one a slot, from the eye's view to the map, column-major
  int UsedResolution = 0;
  int RefusedResolution = 0;

  void SetMatrix(int slot, const glm::dmat4& mapFromView);
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
    vtkErrorMacro("Resolution " << resolution << " is no size of a map: give 1 or more texels. It stays "
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
int vtkDepthShadowMapPass::ResolutionOfDriver()
{
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (this->Resolution <= limit)
  {
    return this->Resolution;
  }
  if (this->Internal->RefusedResolution != this->Resolution)
  {
    this->Internal->RefusedResolution = this->Resolution;
    vtkErrorMacro("Resolution " << this->Resolution << " is above this OpenGL driver's limit of " << limit
                                << " texels, which is used instead. Set it to " << limit
                                << " or less.");
  }
  return limit;
}

//------------------------------------------------------------------------------
bool vtkDepthShadowMapPass::UpdateVisibility(
  const vtkShadowFrame& frame, const std::vector<int>& lights)
{
  Internals& my = *this->Internal;
  const int slots = static_cast<int>(lights.size());
  my.UsedResolution = this->ResolutionOfDriver();
  if (my.Maps.Reserve(frame.Window, vtkShadowTextureArray::Format::Depth32F, my.UsedResolution,
        my.UsedResolution, slots))
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
  my.Matrices.resize(std::size_t(16) * slots);
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

  // Who can be in shadow, and who can cast it.
  std::vector<BoxCorners> receivers, casters;
  for (const vtkShadowScene::Prop& prop : props)
  {
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      if (prop.Receives)
      {
        receivers.push_back(piece.CornersWC);
      }
    }
  }
  MapState wanted;
  for (std::size_t i = 0; i < props.size(); ++i)
  {
    const std::size_t before = casters.size();
    for (const vtkShadowScene::Piece& piece : props[i].Pieces)
    {
      if (props[i].Casts && !CastsOnNothing(piece, light.Ray, receivers))
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
    my.SetMatrix(slot, LitEverywhere());
    my.States[slot] = MapState();
    return;
  }

  wanted.Drawn = true;
  wanted.View = fitted.view;
  wanted.CasterStamp = frame.Scene->GetCasterStamp();
  if (!(my.States[slot] == wanted))
  {
    vtkShadowDrawScope target(frame.Window, my.Maps, slot);
    target.Clear(nullptr);
    frame.Shading->DrawCasters(frame, wanted.Casters, fitted.view);
    ++this->NumberOfMapBuilds;
    my.States[slot] = wanted;
  }

  // Clip space -1..1 to the map's 0..1, all in double; the eye's view coordinates are what floats get.
  const glm::dmat4 mapFromClip =
    glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(0.5)), glm::dvec3(0.5));
  my.SetMatrix(slot,
    mapFromClip * fitted.view.clipFromView *
      (fitted.view.viewFromWorld * glm::inverse(frame.ViewFromWorld)));
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::Internals::SetMatrix(int slot, const glm::dmat4& mapFromView)
{
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 4; ++row)
    {
      this->Matrices[std::size_t(16) * slot + 4 * column + row] =
        static_cast<float>(mapFromView[column][row]);
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkDepthShadowMapPass::GetLookupDeclarations() const
{
  // Asked for before the maps are drawn, so by the slots that are planned.
  return "#define SHADOW_DEPTH_MAP_SLOTS " + std::to_string(this->GetNumberOfSlots()) + "\n" +
    vtkDepthShadowMapPassLookup;
}

std::string vtkDepthShadowMapPass::GetLookupFunction() const
{
  return "shadowDepthMapVisibility";
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::SetLookupUniforms(vtkShaderProgram* program)
{
  Internals& my = *this->Internal;
  program->SetUniformMatrix4x4v("shadowDepthMapFromView",
    static_cast<int>(my.Matrices.size() / 16), my.Matrices.data());
  program->SetUniformf("shadowDepthMapResolution", static_cast<float>(my.UsedResolution));
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
