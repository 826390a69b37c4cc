#include "vtkShadowedShadingPass.h"

#include "ShadowLight.h"
#include "vtkShadowCasterCamera.h"
#include "vtkShadowCatchers.h"
#include "vtkShadowEyeFaces.h"
#include "vtkShadowLightFalloffs.h"
#include "vtkShadowMergedCasters.h"
#include "vtkShadowPass.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowTechniquePass.h"
#include "vtkShadowWideFloors.h"

#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp3D.h"

#include <algorithm>
#include <sstream>

vtkStandardNewMacro(vtkShadowedShadingPass);

//------------------------------------------------------------------------------
vtkShadowedShadingPass::vtkShadowedShadingPass()
  : Catchers(new vtkShadowCatchers)
  , Falloffs(new vtkShadowLightFalloffs)
  , EyeFaces(new vtkShadowEyeFaces)
  , MergedCasters(new vtkShadowMergedCasters)
  , WideFloors(new vtkShadowWideFloors)
{
}

vtkShadowedShadingPass::~vtkShadowedShadingPass() = default;

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::SetPlan(const std::vector<LightPlan>& plan)
{
  this->Plan = plan;
  this->Techniques.clear();
  this->Lookups.clear();
  this->HasMasks = false;
  std::ostringstream shape;
  for (std::size_t i = 0; i < plan.size(); ++i)
  {
    const LightPlan& light = plan[i];
    shape << (light.Technique ? light.Technique->GetTechniqueName() : "-") << light.Slot
          << static_cast<int>(light.Light->kind) << (light.Strength < 1.0f)
          << (light.MaximumDistance > 0.0f) << (light.SmoothCone > 0.0)
          << (light.Texture != nullptr) << ' ';
    if (!light.Technique)
    {
      continue;
    }
    if (light.Technique->GetVisibilityForm() == vtkShadowTechniquePass::LOOKUP)
    {
      this->Lookups.push_back(i);
    }
    else
    {
      this->HasMasks = true;
    }
    if (std::find(this->Techniques.begin(), this->Techniques.end(), light.Technique) ==
      this->Techniques.end())
    {
      this->Techniques.push_back(light.Technique);
    }
  }
  for (vtkShadowTechniquePass* technique : this->Techniques)
  {
    shape << technique->GetLookupDeclarations();
  }
  if (shape.str() != this->PlanShape)
  {
    this->PlanShape = shape.str();
    this->ShaderStage.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::Attach(const vtkShadowFrame& frame)
{
  this->State = frame.Window->GetState();
  this->MaskSize[0] = static_cast<float>(frame.Size[0]);
  this->MaskSize[1] = static_cast<float>(frame.Size[1]);
  // With a delegate, the frame may be drawn at another size than the viewport's.
  const bool isPixels = frame.Origin[0] == 0 && frame.Origin[1] == 0 && !frame.HasDelegate;
  if (isPixels != this->MaskIsPixels)
  {
    this->MaskIsPixels = isPixels;
    this->ShaderStage.Modified();
  }
  this->ParallelEye = frame.Renderer->GetActiveCamera()->GetParallelProjection() ? 1 : 0;
  std::vector<bool> casting;
  for (const LightPlan& light : this->Plan)
  {
    casting.push_back(light.Technique != nullptr);
  }
  if (this->Catchers->Gather(frame, casting))
  {
    this->ShaderStage.Modified();
  }
  this->Falloffs->Gather(frame, this->Plan);
  this->MergedCasters->BeginFrame(frame);
  if (this->CullHiddenFaces)
  {
    this->EyeFaces->LeaveOut(frame);
  }
  std::unordered_set<vtkProp*> dithered;
  for (const vtkShadowScene::Prop& prop : frame.Scene->GetProps())
  {
    this->AttachTo(prop.Source, prop.Receives);
    if (prop.Dithers)
    {
      dithered.insert(prop.Source);
    }
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      if (prop.Dithers)
      {
        dithered.insert(piece.Prop);
      }
      this->AttachTo(piece.Prop, prop.Receives);
      this->Users.emplace(
        static_cast<vtkAbstractMapper*>(piece.Mapper), static_cast<vtkProp*>(piece.Prop));
    }
  }
  if (this->WideFloors->Gather(frame))
  {
    this->ShaderStage.Modified();
  }
  if (dithered != this->Dithered)
  {
    this->Dithered.swap(dithered);
    this->ShaderStage.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::AttachTo(vtkProp* prop, bool receives)
{
  this->Receives[prop] = receives;
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  // Parts of an assembly share its keys.
  vtkInformation* keys = prop->GetPropertyKeys();
  if (this->Attached.emplace(keys, keys).second)
  {
    keys->Append(vtkOpenGLRenderPass::RenderPasses(), this);
  }
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::ActivateTextures()
{
  std::vector<vtkMTimeType> stamps;
  for (vtkShadowTechniquePass* technique : this->Techniques)
  {
    technique->ActivateTextures();
    stamps.push_back(technique->GetReceiverStamp());
  }
  this->Catchers->ActivateMasks();
  if (this->Falloffs->Activate())
  {
    this->ShaderStage.Modified();
  }
  if (!this->Falloffs->GetFault().empty() && this->Falloffs->GetFault() != this->FalloffFault)
  {
    vtkWarningMacro("No texture unit of this OpenGL driver is left for the image of light "
      << this->Falloffs->GetFault()
      << " (of those that are on, from 0): it falls off without it. Give lights the same "
         "vtkTexture, or fewer of them one.");
  }
  this->FalloffFault = this->Falloffs->GetFault();
  if (stamps != this->ReceiverStamps)
  {
    this->ReceiverStamps = stamps;
    this->ShaderStage.Modified();
  }
}

//------------------------------------------------------------------------------
int vtkShadowedShadingPass::GetNumberOfMergedCasters() const
{
  return this->MergedCasters->GetNumberDrawn();
}

std::size_t vtkShadowedShadingPass::GetMergedCasterBytes() const
{
  return this->MergedCasters->Bytes();
}

//------------------------------------------------------------------------------
int vtkShadowedShadingPass::GetNumberOfCulledReceivers() const
{
  return this->CullHiddenFaces ? this->EyeFaces->NumberOfActors() : 0;
}

bool vtkShadowedShadingPass::IsCullingUndecided() const
{
  return this->CullHiddenFaces && this->EyeFaces->IsUndecided();
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::Detach()
{
  this->EyeFaces->Restore();
  for (vtkShadowTechniquePass* technique : this->Techniques)
  {
    technique->DeactivateTextures();
  }
  this->Catchers->DeactivateMasks();
  this->Falloffs->Deactivate();
  this->ClampDepth(false);
  for (const auto& attached : this->Attached)
  {
    vtkInformation* keys = attached.second;
    keys->Remove(vtkOpenGLRenderPass::RenderPasses(), this);
    if (keys->Length(vtkOpenGLRenderPass::RenderPasses()) == 0)
    {
      keys->Remove(vtkOpenGLRenderPass::RenderPasses());
    }
  }
  this->Attached.clear();
  this->Receives.clear();
  this->Users.clear();
  this->State = nullptr;
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::SetStage(Stage stage)
{
  if (stage != this->CurrentStage)
  {
    this->CurrentStage = stage;
    this->ShaderStage.Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkShadowedShadingPass::IsReceiver(vtkProp* prop) const
{
  const auto known = this->Receives.find(prop);
  if (known != this->Receives.end())
  {
    return known->second;
  }
  // A copy that a mapper made of its actor for a block: it has the actor's keys.
  vtkInformation* keys = prop->GetPropertyKeys();
  return !keys || !keys->Has(vtkShadowPass::RECEIVES_SHADOWS()) ||
    keys->Get(vtkShadowPass::RECEIVES_SHADOWS()) != 0;
}

//------------------------------------------------------------------------------
bool vtkShadowedShadingPass::IsCatcher(vtkProp* prop) const
{
  return this->Receives.count(prop) != 0 ? this->Catchers->Has(prop)
                                         : vtkShadowPass::IsShadowCatcher(prop);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkShadowedShadingPass::GetShaderStageMTime()
{
  return this->ShaderStage.GetMTime();
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::ReleaseGraphicsResources(vtkWindow* w)
{
  this->Catchers->ReleaseMasks();
  this->Falloffs->Release(w);
  this->MergedCasters->Release();
  this->Superclass::ReleaseGraphicsResources(w);
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lights in plan: " << this->Plan.size() << "\n";
}
