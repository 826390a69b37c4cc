// How vtkShadowedShadingPass has casters and receivers drawn, into whatever is bound.
#include "vtkShadowedShadingPass.h"

#include "LightView.h"
#include "vtkShadowCasterCamera.h"
#include "vtkShadowCatchers.h"
#include "vtkShadowMergedCasters.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowTechniquePass.h"
#include "vtkShadowWideFloors.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp3D.h"
#include "vtkSmartPointer.h"

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::DrawCasters(const vtkShadowFrame& frame,
  const std::vector<std::size_t>& props, const vtkshadows::LightView& view,
  const std::unordered_map<vtkProp*, unsigned int>& culled, bool writesDepth,
  vtkShadowTechniquePass* writer)
{
  this->Culled = culled;
  this->CastersWriteDepth = writesDepth;
  this->Writer = writer;
  this->DrawFromLight(frame, props, view, writer ? TEXELS : CASTERS);
}

void vtkShadowedShadingPass::DrawTransmittance(const vtkShadowFrame& frame,
  const std::vector<std::size_t>& props, const vtkshadows::LightView& view, bool writesDepth)
{
  this->Culled.clear();
  this->CastersWriteDepth = writesDepth;
  this->DrawFromLight(frame, props, view, TRANSMITTANCE);
}

void vtkShadowedShadingPass::DrawFromLight(const vtkShadowFrame& frame,
  const std::vector<std::size_t>& props, const vtkshadows::LightView& view, Stage stage)
{
  // What lies before the near plane still casts.
  glEnable(GL_DEPTH_CLAMP);
  this->DrawByMappers(frame,
    stage == CASTERS
      ? this->MergedCasters->Draw(frame, props, view, this->Culled, this->CastersWriteDepth)
      : props,
    view, stage);
  glDisable(GL_DEPTH_CLAMP);
}

void vtkShadowedShadingPass::DrawByMappers(const vtkShadowFrame& frame,
  const std::vector<std::size_t>& props, const vtkshadows::LightView& view, Stage stage)
{
  if (props.empty())
  {
    return; // stages would be changed for nothing
  }
  vtkRenderer* renderer = frame.Renderer;
  const vtkSmartPointer<vtkCamera> eye = renderer->GetActiveCamera();
  this->CasterCamera->SetView(view);
  renderer->SetActiveCamera(this->CasterCamera);
  this->SetStage(stage);
  for (const std::size_t i : props)
  {
    const vtkShadowScene::Prop& prop = frame.Scene->GetProps()[i];
    // Only impostors look at this flag while drawing depth; for the others a change of it would
    // mean another shader.
    this->CasterCamera->SetParallelProjection(
      prop.Impostors ? view.parallel : eye->GetParallelProjection() != 0);
    if (prop.Translucent)
    {
      prop.Source->RenderTranslucentPolygonalGeometry(renderer);
    }
    else
    {
      prop.Source->RenderOpaqueGeometry(renderer);
    }
  }
  this->SetStage(SHADE);
  renderer->SetActiveCamera(eye);
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::DrawReceivers(
  const vtkShadowFrame& frame, Stage stage, const std::vector<std::size_t>* props)
{
  this->SetStage(stage);
  const std::vector<vtkShadowScene::Prop>& all = frame.Scene->GetProps();
  for (std::size_t i = 0; i < (props ? props->size() : all.size()); ++i)
  {
    const vtkShadowScene::Prop& prop = all[props ? (*props)[i] : i];
    if (prop.StandsInFor || !this->Catchers->IsDrawn(prop))
    {
      continue;
    }
    if (prop.Catches)
    {
      prop.Source->RenderTranslucentPolygonalGeometry(frame.Renderer);
    }
    else
    {
      prop.Source->RenderOpaqueGeometry(frame.Renderer);
    }
  }
  this->ClampDepth(false);
  this->SetStage(SHADE);
}

//------------------------------------------------------------------------------
bool vtkShadowedShadingPass::BeginCatcherMasks()
{
  const bool apart = this->HasMasks && this->Catchers->NeedMasks();
  if (apart)
  {
    this->Catchers->Drawn = vtkShadowCatchers::Round::Catchers;
  }
  return apart;
}

void vtkShadowedShadingPass::EndCatcherMasks()
{
  for (vtkShadowTechniquePass* technique : this->Techniques)
  {
    if (technique->GetVisibilityForm() == vtkShadowTechniquePass::MASK)
    {
      this->Catchers->KeepMasks(technique, *technique->GetTextures());
    }
  }
  this->Catchers->Drawn = vtkShadowCatchers::Round::Others;
}

void vtkShadowedShadingPass::DrawAllReceivers()
{
  this->Catchers->Drawn = vtkShadowCatchers::Round::All;
}

//------------------------------------------------------------------------------
// A catcher may reach beyond the camera's clipping range: its bounds need not count in it. Nothing
// of it is cut off then, and since it leaves no depth behind, nothing else is the worse for it.
void vtkShadowedShadingPass::ClampDepth(bool clamped)
{
  if (clamped != this->DepthClamped)
  {
    this->DepthClamped = clamped;
    (clamped ? glEnable : glDisable)(GL_DEPTH_CLAMP);
  }
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::DrawDepths(const vtkShadowFrame& frame,
  const vtkshadows::LightView& view, const std::vector<std::size_t>* props, Stage stage)
{
  const vtkSmartPointer<vtkCamera> eye = frame.Renderer->GetActiveCamera();
  this->CasterCamera->SetView(view);
  this->CasterCamera->SetParallelProjection(eye->GetParallelProjection());
  frame.Renderer->SetActiveCamera(this->CasterCamera);
  this->WideFloors->SetProjection(view.clipFromView);
  this->DrawReceivers(frame, stage, props);
  this->WideFloors->SetProjection(frame.ClipFromView);
  frame.Renderer->SetActiveCamera(eye);
}
