#include "vtkPVShadowView.h"

#include "vtkDepthShadowMapPass.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkObjectFactory.h"
#include "vtkObjectIDShadowPass.h"
#include "vtkPVSynchronizedRenderer.h"
#include "vtkRenderer.h"
#include "vtkShadowPass.h"
#include "vtkShadowTexturePass.h"

#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPVShadowView);

namespace
{

std::vector<vtkLight*> LightsOf(vtkRenderer* renderer)
{
  std::vector<vtkLight*> lights;
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(it))
  {
    lights.push_back(light);
  }
  return lights;
}

}

//----------------------------------------------------------------------------
vtkPVShadowView::vtkPVShadowView()
{
  this->SynchronizedRenderers->SetRenderPass(this->Shadows);
}

//----------------------------------------------------------------------------
vtkPVShadowView::~vtkPVShadowView() = default;

//----------------------------------------------------------------------------
void vtkPVShadowView::SetTechnique(const char* name)
{
  if (this->Shadows->SetTechnique(name ? name : ""))
  {
    this->Modified();
  }
}

//----------------------------------------------------------------------------
void vtkPVShadowView::SetMaximumError(double percent)
{
  this->Shadows->SetMaximumError(percent);
  this->Modified();
}

//----------------------------------------------------------------------------
void vtkPVShadowView::SetMaximumFrameTime(double milliseconds)
{
  this->Shadows->SetMaximumFrameTime(milliseconds);
  this->Modified();
}

//----------------------------------------------------------------------------
const char* vtkPVShadowView::GetExplanation()
{
  this->Explanation.clear();
  int number = 0;
  for (vtkLight* light : LightsOf(this->GetRenderer()))
  {
    ++number;
    const std::string sentence = this->Shadows->GetExplanation(light);
    if (!sentence.empty())
    {
      this->Explanation += (this->Explanation.empty() ? "light " : "\nlight ") +
        std::to_string(number) + ": " + sentence;
    }
  }
  return this->Explanation.c_str();
}

//----------------------------------------------------------------------------
void vtkPVShadowView::SetLightRadius(double radius)
{
  if (!std::isfinite(radius) || radius < 0.0)
  {
    vtkErrorMacro("LightRadius " << radius << ": give 0 or more; it stays " << this->LightRadius);
    return;
  }
  this->LightRadius = radius;
  this->Modified();
}

//----------------------------------------------------------------------------
void vtkPVShadowView::SetShadowStrength(double strength)
{
  if (!(strength >= 0.0 && strength <= 1.0))
  {
    vtkErrorMacro(
      "ShadowStrength " << strength << ": give 0 to 1; it stays " << this->ShadowStrength);
    return;
  }
  this->ShadowStrength = strength;
  this->Modified();
}

//----------------------------------------------------------------------------
// Lights come and go with the light kit and the user.
void vtkPVShadowView::AboutToRenderOnLocalProcess(bool interactive)
{
  for (vtkLight* light : LightsOf(this->GetRenderer()))
  {
    this->Shadows->SetLightRadius(light, this->LightRadius);
    this->Shadows->SetLightStrength(light, this->ShadowStrength);
  }
  this->Superclass::AboutToRenderOnLocalProcess(interactive);
}

//----------------------------------------------------------------------------
void vtkPVShadowView::SetResolution(int resolution)
{
  this->Shadows->GetDepthShadowMapPass()->SetResolution(resolution);
  this->Shadows->GetObjectIDShadowPass()->SetResolution(resolution);
  this->Shadows->GetShadowTexturePass()->SetResolution(resolution);
  this->Modified();
}

//----------------------------------------------------------------------------
void vtkPVShadowView::SetFilter(const char* name)
{
  this->Shadows->GetDepthShadowMapPass()->SetFilter(std::string(name ? name : ""));
  this->Modified();
}

//----------------------------------------------------------------------------
void vtkPVShadowView::SetNumberOfCascades(int number)
{
  this->Shadows->GetDepthShadowMapPass()->SetNumberOfCascades(number);
  this->Shadows->GetObjectIDShadowPass()->SetNumberOfCascades(number);
  this->Modified();
}

//----------------------------------------------------------------------------
void vtkPVShadowView::SetObjectDepths(bool combine)
{
  this->Shadows->GetObjectIDShadowPass()->SetCombineDepth(combine);
  this->Modified();
}

//----------------------------------------------------------------------------
void vtkPVShadowView::SetObjectType(const char* name)
{
  this->Shadows->GetObjectIDShadowPass()->SetObjectType(std::string(name ? name : ""));
  this->Modified();
}

//----------------------------------------------------------------------------
void vtkPVShadowView::SetTranslucentCasting(int how)
{
  this->Shadows->SetTranslucentCasting(how);
  this->Modified();
}

//----------------------------------------------------------------------------
void vtkPVShadowView::SetTexturePerCaster(bool each)
{
  this->Shadows->GetShadowTexturePass()->SetTexturePerCaster(each);
  this->Modified();
}

//----------------------------------------------------------------------------
void vtkPVShadowView::SetCullHiddenFaces(bool culled)
{
  this->Shadows->SetCullHiddenFaces(culled);
  this->Modified();
}

//----------------------------------------------------------------------------
void vtkPVShadowView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shadows: " << endl;
  this->Shadows->PrintSelf(os, indent.GetNextIndent());
}
