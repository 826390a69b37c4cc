#include "vtkDepthShadowMapPass.h"

#include "ShadowReach.h"
#include "vtkDepthShadowMapPassLookup.h"
#include "vtkShadowDrawScope.h"
#include "vtkShadowHiddenFaces.h"
#include "vtkShadowMapViews.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowedShadingPass.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <iterator>

vtkStandardNewMacro(vtkDepthShadowMapPass);

namespace
{

// By FilterType.
const char* const FilterNames[] = { "percentage-closer" };

}

//------------------------------------------------------------------------------
class vtkDepthShadowMapPass::Internals
{
public:
  vtkShadowTextureArray Maps;
  vtkShadowHiddenFaces HiddenFaces;
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

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::SetFilter(int filter)
{
  if (filter < 0 || filter >= GetNumberOfFilters())
  {
    vtkErrorMacro("Filter " << filter << " is none of vtkDepthShadowMapPass::FilterType (0 to "
                            << GetNumberOfFilters() - 1 << "). It stays " << this->Filter << ".");
    return;
  }
  if (filter != this->Filter)
  {
    this->Filter = filter;
    this->Modified();
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
bool vtkDepthShadowMapPass::ReserveMaps(
  const vtkShadowFrame& frame, int width, int height, int layers)
{
  return this->Internal->Maps.Reserve(
    frame.Window, vtkShadowTextureArray::Format::Depth32F, width, height, layers);
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::BeginMaps(const vtkShadowFrame& frame)
{
  this->Internal->HiddenFaces.BeginFrame(frame.Scene->GetProps());
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::DrawMap(const vtkShadowFrame& frame, const vtkShadowMapSlot& slot,
  const vtkShadowMapView& view, int width, int height)
{
  Internals& my = *this->Internal;
  vtkShadowDrawScope target(frame.Window, my.Maps, view.Layer);
  // All of the layer is cleared, and its outermost texels stay so: what lies off the map is lit.
  target.Clear(nullptr);
  target.Confine(width, height, 1);
  frame.Shading->DrawCasters(frame, view.Casters, view.View,
    my.HiddenFaces.CulledOf(
      frame.Scene->GetProps(), view.Casters, vtkshadows::HomogeneousLight(slot.Light)));
}

//------------------------------------------------------------------------------
std::string vtkDepthShadowMapPass::GetCompareDeclarations() const
{
  return vtkDepthShadowMapPassLookup;
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
  this->Superclass::ReleaseGraphicsResources(w);
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Filter: " << GetFilterName(this->Filter) << "\n";
}
