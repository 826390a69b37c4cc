#include "vtkPVShadowView.h"

#include "vtkDepthShadowMapPass.h"
#include "vtkObjectFactory.h"
#include "vtkObjectIDShadowPass.h"
#include "vtkPVSynchronizedRenderer.h"
#include "vtkShadowPass.h"
#include "vtkShadowTexturePass.h"

vtkStandardNewMacro(vtkPVShadowView);

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
