#include "vtkShadowSceneInternals.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkShadowScene);

//------------------------------------------------------------------------------
vtkShadowScene::vtkShadowScene()
  : Internal(new Internals)
{
}

vtkShadowScene::~vtkShadowScene() = default;

//------------------------------------------------------------------------------
void vtkShadowScene::Gather(vtkRenderer* renderer)
{
  this->Internal->GatherLights(renderer);
  this->Internal->GatherProps(renderer);
  this->Internal->FindWideFloors(renderer);
  this->Internal->FindCoarse();
  this->Internal->StampCasters();
  for (vtkProp* prop : this->Internal->Unbounded)
  {
    if (this->Internal->UnboundedBefore.count(prop) == 0)
    {
      vtkWarningMacro("The prop "
        << prop->GetClassName() << " (" << prop
        << ") has bounds that are not finite, or too large for OpenGL's floats (from 1.8e19 on): "
           "what of it has none casts no shadow. Remove its points that are so far, or repair its "
           "matrix.");
    }
  }
  if (vtkProp* prop = this->Internal->Coarse; prop && prop != this->Internal->CoarseBefore)
  {
    vtkWarningMacro("The prop "
      << prop->GetClassName() << " (" << prop << ") reaches to " << this->Internal->CoarseReach
      << ", where floats are known to " << this->Internal->CoarseRounding
      << ", more than all other props together are large: most techniques can tell nothing of "
         "their shadows. Remove its points that are so far, or give it no part in shadows "
         "(CASTS_SHADOWS and RECEIVES_SHADOWS 0).");
  }
  for (vtkProp* prop : this->Internal->Unfit)
  {
    if (this->Internal->UnfitBefore.count(prop) == 0)
    {
      vtkWarningMacro("The prop "
        << prop->GetClassName() << " (" << prop
        << ") has a stand-in without triangles, or one that is infinite: it casts itself. Give "
           "SetStandIn a mesh with polygons or strips, or nullptr to remove it.");
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowScene::SetTranslucentCasting(int how)
{
  this->Internal->TranslucentCasting = how;
}

int vtkShadowScene::GetTranslucentCasting() const
{
  return this->Internal->TranslucentCasting;
}

//------------------------------------------------------------------------------
void vtkShadowScene::SetLightRadius(std::size_t light, double radius)
{
  this->Internal->Lights[light].Ray.radius = radius;
}

void vtkShadowScene::SetLightMaximumDistance(std::size_t light, double distance)
{
  this->Internal->Lights[light].MaximumDistance = distance;
}

//------------------------------------------------------------------------------
const std::vector<vtkShadowScene::Light>& vtkShadowScene::GetLights() const
{
  return this->Internal->Lights;
}

const std::vector<vtkShadowScene::Prop>& vtkShadowScene::GetProps() const
{
  return this->Internal->Props;
}

int vtkShadowScene::GetNumberOfLights() const
{
  return static_cast<int>(this->Internal->Lights.size());
}

int vtkShadowScene::GetNumberOfCasters() const
{
  int count = 0;
  for (const Prop& prop : this->Internal->Props)
  {
    count += prop.CastsRays ? 1 : 0; // one with a stand-in once
  }
  return count;
}

int vtkShadowScene::GetNumberOfReceivers() const
{
  int count = 0;
  for (const Prop& prop : this->Internal->Props)
  {
    count += prop.Receives ? 1 : 0;
  }
  return count;
}

vtkMTimeType vtkShadowScene::GetCasterStamp() const
{
  return this->Internal->CasterTime.GetMTime();
}

//------------------------------------------------------------------------------
void vtkShadowScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLights: " << this->GetNumberOfLights() << "\n";
  os << indent << "NumberOfCasters: " << this->GetNumberOfCasters() << "\n";
  os << indent << "NumberOfReceivers: " << this->GetNumberOfReceivers() << "\n";
  os << indent << "CasterStamp: " << this->GetCasterStamp() << "\n";
}
