#include "vtkDepthShadowMapPass.h"

#include "ShadowReach.h"
#include "vtkDepthShadowMapPassExact.h"
#include "vtkDepthShadowMapPassLookup.h"
#include "vtkDepthShadowMapPassPercentageCloser.h"
#include "vtkShadowDrawScope.h"
#include "vtkShadowHiddenFaces.h"
#include "vtkShadowMapViews.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowTriangleMaps.h"
#include "vtkShadowedShadingPass.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <iterator>

vtkStandardNewMacro(vtkDepthShadowMapPass);

namespace
{

// By FilterType.
const char* const FilterNames[] = { "percentage-closer", "exact" };

}

//------------------------------------------------------------------------------
class vtkDepthShadowMapPass::Internals
{
public:
  vtkShadowTextureArray Maps;
  vtkShadowHiddenFaces HiddenFaces;
  vtkShadowTriangleMaps Triangles; // of the filter EXACT
  int DrawnFor = PERCENTAGE_CLOSER;
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
  Internals& my = *this->Internal;
  bool isLost =
    my.Maps.Reserve(frame.Window, vtkShadowTextureArray::Format::Depth32F, width, height, layers);
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
  isLost = isLost || my.DrawnFor != this->Filter;
  my.DrawnFor = this->Filter;
  return isLost;
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
void vtkDepthShadowMapPass::DrawMap(const vtkShadowFrame& frame, const vtkShadowMapSlot& slot,
  const vtkShadowMapView& view, int width, int height)
{
  Internals& my = *this->Internal;
  const bool isExact = this->Filter == EXACT;
  const std::vector<std::size_t> casters = isExact ? my.Triangles.PlainCasters(view) : view.Casters;
  {
    vtkShadowDrawScope target(frame.Window, my.Maps, view.Layer);
    // All of the layer is cleared, and its outermost texels stay so: what lies off the map is lit.
    target.Clear(nullptr);
    target.Confine(width, height, 1);
    if (!casters.empty())
    {
      frame.Shading->DrawCasters(frame, casters, view.View,
        my.HiddenFaces.CulledOf(
          frame.Scene->GetProps(), casters, vtkshadows::HomogeneousLight(slot.Light)));
    }
  }
  if (isExact)
  {
    const auto number = static_cast<std::size_t>(&slot - this->GetViews().GetSlots().data());
    my.Triangles.Draw(frame, my.Maps, number, view, width, height);
  }
}

//------------------------------------------------------------------------------
bool vtkDepthShadowMapPass::UpdateVisibility(
  const vtkShadowFrame& frame, const std::vector<int>& lights)
{
  const bool done = this->Superclass::UpdateVisibility(frame, lights);
  if (this->Internal->Triangles.TakeShaderChange())
  {
    this->LookupChanged();
  }
  return done;
}

//------------------------------------------------------------------------------
std::string vtkDepthShadowMapPass::GetCompareDeclarations() const
{
  const std::string lookup = vtkDepthShadowMapPassLookup;
  return this->Filter == EXACT
    ? this->Internal->Triangles.Declarations() + lookup + vtkDepthShadowMapPassExact
    : lookup + vtkDepthShadowMapPassPercentageCloser;
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::ActivateTextures()
{
  this->Superclass::ActivateTextures();
  if (this->Filter == EXACT)
  {
    this->Internal->Triangles.Activate();
  }
}

void vtkDepthShadowMapPass::DeactivateTextures()
{
  this->Superclass::DeactivateTextures();
  this->Internal->Triangles.Deactivate();
}

void vtkDepthShadowMapPass::SetLookupParameters(vtkShaderProgram* program, vtkProp* prop)
{
  this->Superclass::SetLookupParameters(program, prop);
  if (this->Filter == EXACT)
  {
    this->Internal->Triangles.SetParameters(program);
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
  this->Internal->Triangles.Release();
  this->Superclass::ReleaseGraphicsResources(w);
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Filter: " << GetFilterName(this->Filter) << "\n";
}
