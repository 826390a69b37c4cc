#include "vtkShadowTransmittance.h"

#include "vtkDepthShadowMapPassTransmittance.h"
#include "vtkShadowDrawScope.h"
#include "vtkShadowMapViews.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowText.h"
#include "vtkShadowedShadingPass.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
bool vtkShadowTransmittance::Reserve(
  vtkOpenGLRenderWindow* window, int width, int height, int layers)
{
  using Format = vtkShadowTextureArray::Format;
  const bool isLost = this->Depths.Reserve(window, Format::Depth32F, width, height, layers);
  return this->Shares.Reserve(window, Format::R8, width, height, layers) || isLost;
}

//------------------------------------------------------------------------------
void vtkShadowTransmittance::Release()
{
  this->Depths.Release();
  this->Shares.Release();
}

//------------------------------------------------------------------------------
void vtkShadowTransmittance::Draw(const vtkShadowFrame& frame, const vtkShadowMapView& view,
  const std::vector<std::size_t>& casters, const vtkShadowTextureArray& opaque, int layer,
  int width, int height)
{
  const float all[4] = { 1.0f, 1.0f, 1.0f, 1.0f };
  {
    vtkShadowDrawScope depths(frame.Window, this->Depths, view.Layer);
    depths.Clear(nullptr);
    depths.Confine(width, height, 1);
    if (!casters.empty())
    {
      frame.Shading->DrawTransmittance(frame, casters, view.View, true);
    }
  }
  // What lies behind something opaque attenuates nothing that is lit.
  vtkShadowDrawScope shares(frame.Window, opaque, layer, &this->Shares, view.Layer);
  shares.ClearColour(all);
  shares.Confine(width, height, 1);
  if (!casters.empty())
  {
    frame.Shading->DrawTransmittance(frame, casters, view.View, false);
  }
}

//------------------------------------------------------------------------------
std::string vtkShadowTransmittance::Declarations(const std::string& opaque)
{
  return vtkShadowText::Replaced(opaque, "shadowDepthMapCompare(", "shadowDepthMapCompareOpaque(") +
    vtkDepthShadowMapPassTransmittance;
}

//------------------------------------------------------------------------------
void vtkShadowTransmittance::SetParameters(vtkShaderProgram* program) const
{
  if (program->IsUniformUsed("shadowDepthMapTranslucents"))
  {
    program->SetUniformi("shadowDepthMapTranslucents", this->Depths.Unit());
    program->SetUniformi("shadowDepthMapShares", this->Shares.Unit());
  }
}

//------------------------------------------------------------------------------
void vtkShadowTransmittance::Activate()
{
  if (this->IsReady())
  {
    this->Depths.Activate();
    this->Shares.Activate();
  }
}

void vtkShadowTransmittance::Deactivate()
{
  this->Depths.Deactivate();
  this->Shares.Deactivate();
}
