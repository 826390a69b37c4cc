#include "vtkShadowPassInternals.h"

#include "vtkDepthShadowMapPass.h"
#include "vtkPlanarShadowPass.h"
#include "vtkShadowLightFalloffs.h"
#include "vtkShadowMatrix.h"

#include "vtkCamera.h"
#include "vtkFrameBufferObjectBase.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRenderState.h"

#include <map>
#include <utility>

using vtkshadows::AutoTechnique;
using vtkshadows::NoTechnique;
using vtkshadows::SceneStage;

vtkStandardNewMacro(vtkShadowFramePass);

namespace
{

// VTK keeps matrices of a camera, and lights as it sees them, until it is modified. What
// vtkCamera::DeepCopy does not tell of is told here: else mappers draw what the camera no longer
// shows, under shadows of what it does.
void TellOfCopiedCamera(const vtkShadowFrame& frame)
{
  auto* camera = vtkOpenGLCamera::SafeDownCast(frame.Renderer->GetActiveCamera());
  if (!camera)
  {
    return;
  }
  vtkMatrix4x4 *viewFromWorld, *clipFromView, *clipFromWorld; // transposed
  vtkMatrix3x3* normals;
  camera->GetKeyMatrices(frame.Renderer, viewFromWorld, normals, clipFromView, clipFromWorld);
  if (glm::transpose(vtkShadowMatrix::ToGlm(viewFromWorld)) != frame.ViewFromWorld ||
    glm::transpose(vtkShadowMatrix::ToGlm(clipFromView)) != frame.ClipFromView)
  {
    camera->Modified();
  }
}

}

//------------------------------------------------------------------------------
vtkShadowFrame vtkShadowPass::Internals::FrameOf(const vtkRenderState* s)
{
  vtkShadowFrame frame;
  frame.State = s;
  frame.Renderer = vtkOpenGLRenderer::SafeDownCast(s->GetRenderer());
  frame.Window = vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
  frame.Scene = this->Scene;
  frame.Shading = this->Shading;
  frame.Receivers = &this->Receivers;
  if (s->GetFrameBuffer())
  {
    s->GetFrameBuffer()->GetLastSize(frame.Size);
  }
  else
  {
    frame.Renderer->GetTiledSizeAndOrigin(
      &frame.Size[0], &frame.Size[1], &frame.Origin[0], &frame.Origin[1]);
  }
  frame.HasDelegate = this->Delegate != nullptr;
  vtkCamera* camera = frame.Renderer->GetActiveCamera();
  frame.ViewFromWorld = vtkShadowMatrix::ViewFromWorld(camera);
  frame.ClipFromView = vtkShadowMatrix::ClipFromView(camera, frame.Renderer);
  TellOfCopiedCamera(frame);
  return frame;
}

//------------------------------------------------------------------------------
std::vector<vtkShadowedShadingPass::LightPlan> vtkShadowPass::Internals::PlanLights(
  const vtkShadowFrame& frame, bool withStrength)
{
  std::vector<vtkShadowedShadingPass::LightPlan> plan;
  for (vtkShadowTechniquePass* technique : this->Techniques)
  {
    technique->NumberOfSlots = 0;
  }
  const bool anyCaster = this->Scene->GetNumberOfCasters() > 0;
  const bool anyReceiver = this->Scene->GetNumberOfReceivers() > 0;
  const std::vector<vtkShadowScene::Light>& lights = this->Scene->GetLights();
  std::vector<int> toChoose;
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    const vtkShadowLightSettings settings = this->SettingsOf(lights[i].Source);
    this->Scene->SetLightRadius(i, settings.Radius);
    this->Scene->SetLightMaximumDistance(i, withStrength ? settings.MaximumDistance : 0.0);
    vtkShadowedShadingPass::LightPlan entry;
    entry.Light = &lights[i].Ray;
    entry.Strength = static_cast<float>(withStrength ? settings.Strength : 1.0);
    entry.MaximumDistance = static_cast<float>(withStrength ? settings.MaximumDistance : 0.0);
    entry.Fade = static_cast<float>(settings.Fade);
    if (anyCaster && anyReceiver && !lights[i].AtEye && entry.Strength > 0.0f)
    {
      const std::string& name = settings.Technique.empty() ? this->Default : settings.Technique;
      entry.Technique = this->Find(name);
      if (name == AutoTechnique)
      {
        toChoose.push_back(static_cast<int>(i));
      }
    }
    plan.push_back(entry);
  }
  this->ChooseTechniques(frame, plan, toChoose, withStrength);
  for (vtkShadowedShadingPass::LightPlan& entry : plan)
  {
    if (entry.Technique)
    {
      entry.Slot = entry.Technique->NumberOfSlots++;
    }
  }
  return plan;
}

//------------------------------------------------------------------------------
// How the lights of a plan fall off; returns what is wrong with each, empty: nothing.
std::vector<std::string> vtkShadowPass::Internals::PlanFalloffs(
  std::vector<vtkShadowedShadingPass::LightPlan>& plan)
{
  std::vector<std::string> faults(plan.size());
  for (std::size_t i = 0; i < plan.size(); ++i)
  {
    vtkLight* light = this->Scene->GetLights()[i].Source;
    const vtkShadowLightSettings settings = this->SettingsOf(light);
    if (settings.FallsOff() && !IsSpot(light))
    {
      faults[i] =
        "is no spot any more, and so has no smooth cone and no texture: make it positional, "
        "with a cone angle below 90 degrees, or clear these settings";
      continue;
    }
    plan[i].SmoothCone = settings.SmoothCone;
    if (settings.Texture)
    {
      const std::string fault = vtkShadowLightFalloffs::FaultOf(settings.Texture);
      faults[i] = fault.empty() ? "" : "shines without its texture, which " + fault;
      plan[i].Texture = fault.empty() ? settings.Texture.Get() : nullptr;
      std::copy_n(settings.TextureUp, 3, plan[i].TextureUp);
    }
  }
  return faults;
}

//------------------------------------------------------------------------------
// Each fault once, as long as it lasts.
void vtkShadowPass::Internals::TellFalloffs(const std::vector<std::string>& faults)
{
  this->FalloffFaults.resize(faults.size());
  for (std::size_t i = 0; i < faults.size(); ++i)
  {
    if (!faults[i].empty() && faults[i] != this->FalloffFaults[i])
    {
      vtkWarningWithObjectMacro(this->FramePass->Owner,
        "Light " << i << " (" << this->Scene->GetLights()[i].Source << ") " << faults[i] << ".");
    }
  }
  this->FalloffFaults = faults;
}

//------------------------------------------------------------------------------
// Give `lights` of the plan techniques by choice.
void vtkShadowPass::Internals::ChooseTechniques(const vtkShadowFrame& frame,
  std::vector<vtkShadowedShadingPass::LightPlan>& plan, const std::vector<int>& lights,
  bool isDrawn)
{
  if (lights.empty() || frame.Size[0] < 1 || frame.Size[1] < 1)
  {
    this->Chooser.Rest();
    return;
  }
  vtkShadowTechniqueChooser::Request request;
  request.Frame = &frame;
  request.Lights = lights;
  request.Pass = [this](const std::string& name) { return this->Find(name); };
  for (const vtkShadowedShadingPass::LightPlan& entry : plan)
  {
    if (entry.Technique)
    {
      request.Named.insert(entry.Technique->GetTechniqueName());
    }
  }
  request.HasRays = this->Find("ray-cast") != nullptr;
  request.Planes =
    vtkPlanarShadowPass::SafeDownCast(this->Find("planar"))->GetMaximumNumberOfPlanes();
  request.IsDrawn = isDrawn;
  // All that is measured in this frame shares them: smaller views or some of the frame's pixels,
  // and all of these, for what hangs on a few.
  std::map<std::pair<bool, bool>, MeasuredView> views;
  request.MeasureErrors = [&](const std::string& name, const std::vector<int>& measured,
                            std::vector<std::optional<vtkshadows::ErrorPercents>>& errors,
                            double& drawingSeconds)
  {
    using Errors = std::vector<std::optional<vtkshadows::ErrorPercents>>;
    const auto measure = [&](const std::vector<int>& ofThese, bool allPixels, Errors& found)
    {
      const bool allDrawn = this->Find(name)->IsSoftByPixels();
      const auto [view, isNew] = views.try_emplace({ allPixels, allDrawn });
      if (isNew)
      {
        this->Reduce(view->second, frame,
          allPixels ? MostMeasuredPixels : this->PixelsToMeasure(lights), allDrawn);
      }
      return this->MeasureErrors(view->second, plan, name, ofThese, found, drawingSeconds);
    };
    errors.clear();
    if (!measure(measured, false, errors))
    {
      return false;
    }
    std::vector<std::size_t> unclear;
    std::vector<int> unclearLights;
    for (std::size_t i = 0; !this->Chooser.GetBudget().maximumError && i < errors.size(); ++i)
    {
      const bool isSoft = this->Scene->GetLights()[measured[i]].Ray.radius > 0.0;
      if (errors[i] && vtkshadows::HangsOnFewPixels(*errors[i], isSoft))
      {
        unclear.push_back(i);
        unclearLights.push_back(measured[i]);
      }
    }
    Errors again;
    if (!unclear.empty() && !measure(unclearLights, true, again))
    {
      return false;
    }
    for (std::size_t k = 0; k < unclear.size(); ++k)
    {
      errors[unclear[k]] = again[k];
    }
    return true;
  };
  const std::vector<std::string> names = this->Chooser.Choose(request);
  for (auto& view : views)
  {
    view.second.Receivers.Release();
  }
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    plan[lights[i]].Technique = this->Find(names[i]);
  }
}

//------------------------------------------------------------------------------
// Once the choice is made, what was only tried gives back what it keeps with the driver.
void vtkShadowPass::Internals::ReleaseWhatWasTried(vtkWindow* window)
{
  const bool isSettled = this->Chooser.IsSettled();
  if (isSettled && !this->WasSettled)
  {
    for (vtkShadowTechniquePass* technique : this->Techniques)
    {
      const std::string name = technique->GetTechniqueName();
      const std::vector<vtkShadowScene::Light>& lights = this->Scene->GetLights();
      const bool isNamed = std::any_of(lights.begin(), lights.end(),
        [&](const vtkShadowScene::Light& light)
        {
          const std::string own = this->SettingsOf(light.Source).Technique;
          return (own.empty() ? this->Default : own) == name;
        });
      if (!isNamed && !this->Chooser.MayUse(name))
      {
        technique->ReleaseGraphicsResources(window);
        this->Chooser.NoteReleased(name);
      }
    }
  }
  this->WasSettled = isSettled;
}

//------------------------------------------------------------------------------
// Everything up to the shading: true if there is anything to shade with, and then End() must
// follow.
bool vtkShadowPass::Internals::Begin(const vtkShadowFrame& frame, bool withStrength, bool always)
{
  this->Receivers.Invalidate();
  this->Clock.Start(SceneStage);
  this->Scene->Gather(frame.Renderer);
  std::vector<vtkShadowedShadingPass::LightPlan> plan = this->PlanLights(frame, withStrength);
  if (withStrength)
  {
    this->TellFalloffs(this->PlanFalloffs(plan));
  }
  const bool any = std::any_of(plan.begin(), plan.end(),
    [](const vtkShadowedShadingPass::LightPlan& entry)
    { return entry.Technique != nullptr || entry.FallsOff(); });
  if ((!any && !always) || frame.Size[0] < 1 || frame.Size[1] < 1)
  {
    this->Plan = plan;
    return false;
  }

  this->Shading->SetPlan(plan);
  this->Shading->Attach(frame);
  if (this->Shading->BeginCatcherMasks())
  {
    this->UpdateTechniques(frame, plan, true);
    this->Shading->EndCatcherMasks();
    this->Receivers.Invalidate();
    this->UpdateTechniques(frame, plan, false);
    this->Shading->DrawAllReceivers();
    this->Receivers.Invalidate();
  }
  else
  {
    this->UpdateTechniques(frame, plan, false);
  }
  this->Plan = plan;
  this->Shading->ActivateTextures();
  return true;
}

//------------------------------------------------------------------------------
// Have the techniques of the plan, or those of them that make masks, serve their lights; the lights
// of one that fails lose it.
void vtkShadowPass::Internals::UpdateTechniques(
  const vtkShadowFrame& frame, std::vector<vtkShadowedShadingPass::LightPlan>& plan, bool masks)
{
  bool failed = false;
  for (vtkShadowTechniquePass* technique : this->Techniques)
  {
    std::vector<int> lights;
    if (masks && technique->GetVisibilityForm() != vtkShadowTechniquePass::MASK)
    {
      continue;
    }
    for (std::size_t i = 0; i < plan.size(); ++i)
    {
      if (plan[i].Technique == technique)
      {
        lights.push_back(static_cast<int>(i));
      }
    }
    if (lights.empty())
    {
      continue;
    }
    this->Clock.Start(technique->GetTechniqueName());
    if (!technique->UpdateVisibility(frame, lights))
    {
      failed = true;
      for (const int i : lights)
      {
        plan[i].Technique = nullptr;
      }
    }
  }
  if (failed)
  {
    this->Shading->SetPlan(plan);
  }
}

//------------------------------------------------------------------------------
// What is wrong with it; empty: nothing.
std::string vtkShadowPass::Internals::DrawDebugView(const vtkShadowFrame& frame)
{
  const std::vector<vtkShadowScene::Light>& lights = this->Scene->GetLights();
  for (std::size_t i = 0; i < this->Plan.size(); ++i)
  {
    const vtkShadowedShadingPass::LightPlan& entry = this->Plan[i];
    const bool isWanted =
      this->DebugLight ? lights[i].Source == this->DebugLight : entry.Technique != nullptr;
    if (isWanted && entry.Technique &&
      entry.Technique->DrawDebugView(frame, entry.Slot, this->DebugView))
    {
      return {};
    }
    if (isWanted)
    {
      return std::string("the light's technique is ") +
        (entry.Technique ? entry.Technique->GetTechniqueName() : NoTechnique);
    }
  }
  return "no such light casts shadows";
}

//------------------------------------------------------------------------------
void vtkShadowPass::Internals::End()
{
  this->Shading->Detach();
}
