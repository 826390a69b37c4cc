#include "vtkMapShadowPass.h"

#include "vtkMapShadowPassLookup.h"
#include "vtkShadowMapViews.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowText.h"
#include "vtkShadowTextureArray.h"

#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{

// A layer is a few columns wider than its map where the driver lets it: rows of a power of two
// would fall on the same few lines of a processor's cache.
constexpr int PaddingTexels = 16;

int LayerWidth(int resolution)
{
  return std::min(resolution + PaddingTexels, vtkShadowTextureArray::LargestSide());
}

}

//------------------------------------------------------------------------------
vtkMapShadowPass::vtkMapShadowPass()
  : Views(new vtkShadowMapViews)
{
}

vtkMapShadowPass::~vtkMapShadowPass() = default;

//------------------------------------------------------------------------------
void vtkMapShadowPass::SetResolution(int resolution)
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
bool vtkMapShadowPass::UpdateVisibility(const vtkShadowFrame& frame, const std::vector<int>& lights)
{
  const int side = this->WithinDriver("Resolution", this->Resolution);
  vtkShadowMapViews& views = *this->Views;
  views.Fit(frame, lights, side, this->GetMarginTexels());
  const int layers = std::max(views.NumberOfViews(), 1);
  if (this->ReserveMaps(frame, LayerWidth(side), side, layers))
  {
    views.ForgetLayers();
  }
  if (!this->GetTextures()->Id())
  {
    this->WarnOnce(this,
      "The driver has no memory for " + std::to_string(layers) + " shadow maps of " +
        std::to_string(side) + " x " + std::to_string(side) +
        " texels: their lights are lit. Lower the resolution.");
    return false;
  }
  this->WarnOnce(this, "");

  views.Place(layers);
  this->BeginMaps(frame);
  views.DrawStale(
    [&](const vtkShadowMapSlot& slot, const vtkShadowMapView& view)
    {
      this->DrawMap(frame, slot, view, views.WidthOf(view.View), views.HeightOf(view.View));
      ++this->NumberOfMapBuilds;
    });
  if (views.UpdateLookups(this->GetLookupPrefix(), frame.ViewFromWorld, this->GetRiseTexels()))
  {
    this->LookupStamp.Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkMapShadowPass::ForgetMaps()
{
  this->Views->ForgetLayers();
}

//------------------------------------------------------------------------------
std::string vtkMapShadowPass::GetLookupDeclarations() const
{
  const int side = this->WithinDriver("Resolution", this->Resolution);
  const std::size_t cubes = this->Views->Faces().size() / 6;
  const std::string define = "#define " + this->GetMacroPrefix();
  const std::string projection = vtkShadowText::Replaced(
    vtkShadowText::Replaced(vtkMapShadowPassLookup, "shadowMap", this->GetLookupPrefix()),
    "SHADOW_MAP", this->GetMacroPrefix());
  return define + "_WIDTH " + std::to_string(LayerWidth(side)) + "\n" + define + "_HEIGHT " +
    std::to_string(side) + "\n" +
    (cubes > 0 ? define + "_CUBES " + std::to_string(cubes) + "\n" : "") +
    this->GetCompareDeclarations() + projection;
}

std::string vtkMapShadowPass::GetLookupFunction(int slot, vtkProp*) const
{
  return this->Views->Function(slot);
}

int vtkMapShadowPass::GetLookupIndex(int slot) const
{
  return this->Views->Index(slot);
}

const float* vtkMapShadowPass::GetLookupMatrix(int slot, vtkProp*) const
{
  return this->Views->Matrix(slot);
}

const float* vtkMapShadowPass::GetLitMatrix() const
{
  return vtkShadowMapViews::LitEverywhere.data();
}

void vtkMapShadowPass::SetLookupParameters(vtkShaderProgram* program, vtkProp*)
{
  const std::vector<vtkShadowMapViews::FaceParameters>& faces = this->Views->Faces();
  if (!faces.empty())
  {
    program->SetUniform4fv((this->GetLookupPrefix() + "Faces").c_str(),
      static_cast<int>(faces.size()), reinterpret_cast<const float(*)[4]>(faces.data()));
  }
}

//------------------------------------------------------------------------------
void vtkMapShadowPass::ReleaseGraphicsResources(vtkWindow* w)
{
  this->ForgetMaps();
  this->Superclass::ReleaseGraphicsResources(w);
}

//------------------------------------------------------------------------------
void vtkMapShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "NumberOfMapBuilds: " << this->NumberOfMapBuilds << "\n";
}
