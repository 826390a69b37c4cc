#include "vtkShadowPassInternals.h"

#include "vtkDepthShadowMapPass.h"
#include "vtkObjectIDShadowPass.h"
#include "vtkPlanarShadowPass.h"
#include "vtkShadowChecks.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowSeconds.h"
#include "vtkShadowTexturePass.h"
#include "vtkStencilShadowVolumePass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <iterator>
#include <optional>

using vtkshadows::AutoTechnique;
using vtkshadows::NoTechnique;
using vtkshadows::NoView;
using vtkshadows::ShadingStage;

vtkStandardNewMacro(vtkShadowPass);

namespace
{

const std::vector<std::string> DebugViews = { "volumes", "silhouette", "counts", "cascades",
  "texel-density", "map", "lit-part" };

// By TranslucentCastingType.
const char* const TranslucentCastingNames[] = { "none", "opaque", "stochastic", "transmittance" };

// VTK blends translucent props in a framebuffer of its own, with a copy of the depth, which fails
// where another pass's framebuffer has depth of another format (vtkSSAAPass's has): they would show
// through what hides them.
bool MustBlendInPlace(const vtkRenderState* s)
{
  return s->GetFrameBuffer() && !s->GetRenderer()->GetUseDepthPeeling() &&
    std::any_of(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount(),
      [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry() != 0; });
}

// As vtkRenderStepsPass draws, but for what the renderer does with opaque props.
void DrawBlendingInPlace(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  vtkProp** const begin = s->GetPropArray();
  vtkProp** const end = begin + s->GetPropArrayCount();
  renderer->DeviceRenderOpaqueGeometry(s->GetFrameBuffer());
  std::for_each(
    begin, end, [&](vtkProp* prop) { prop->RenderTranslucentPolygonalGeometry(renderer); });
  std::for_each(begin, end, [&](vtkProp* prop) { prop->RenderVolumetricGeometry(renderer); });
  std::for_each(begin, end, [&](vtkProp* prop) { prop->RenderOverlay(renderer); });
}

}

//------------------------------------------------------------------------------
vtkShadowPass::vtkShadowPass()
  : Internal(new Internals)
{
  this->Internal->Owned.push_back(vtk::TakeSmartPointer(vtkDepthShadowMapPass::New()));
  this->Internal->Owned.push_back(vtk::TakeSmartPointer(vtkObjectIDShadowPass::New()));
  this->Internal->Owned.push_back(vtk::TakeSmartPointer(vtkPlanarShadowPass::New()));
  this->Internal->Owned.push_back(vtk::TakeSmartPointer(vtkShadowTexturePass::New()));
  this->Internal->Owned.push_back(vtk::TakeSmartPointer(vtkStencilShadowVolumePass::New()));
#ifdef VTKSHADOWS_WITH_EMBREE
  this->Internal->Owned.push_back(vtk::TakeSmartPointer(vtkRayCastShadowPass::New()));
#endif
  for (const auto& technique : this->Internal->Owned)
  {
    this->Internal->Techniques.push_back(technique);
  }
  this->Internal->FramePass->Owner = this;
  this->Internal->CameraPass->SetDelegatePass(this->Internal->FramePass);
}

vtkShadowPass::~vtkShadowPass() = default;

//------------------------------------------------------------------------------
void vtkShadowPass::UseTechnique(vtkShadowTechniquePass* technique)
{
  this->Internal->Owned.clear();
  this->Internal->Techniques = { technique };
  this->Internal->Default = technique->GetTechniqueName();
}

//------------------------------------------------------------------------------
void vtkShadowPass::Render(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    vtkErrorMacro("The renderer " << renderer
                                  << " is in no OpenGL window: nothing is drawn. Add it to a "
                                     "vtkRenderWindow made by VTK's OpenGL2 backend.");
    return;
  }
  this->NumberOfRenderedProps = 0;
  window->MakeCurrent();
  if (s->GetFrameBuffer())
  {
    this->Internal->CameraPass->Render(s);
  }
  else
  {
    // As vtkOpenGLRenderer does it for itself, stereo and tiles included.
    this->UpdateCamera(renderer);
    this->RenderFrame(s);
  }
}

//------------------------------------------------------------------------------
void vtkShadowPass::RenderFrame(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);

  // A selection shows ids, not light.
  const vtkShadowFrame frame = this->Internal->FrameOf(s);
  vtkShadowStageClock& clock = this->Internal->Clock;
  clock.BeginFrame(this->Internal->TimeStages);
  const bool isTimed = this->Internal->Chooser.WantsTime();
  const double start = isTimed ? vtkShadowSecondsOnceDrawn() : 0.0;
  const bool shadowed = !renderer->GetSelector() && this->Internal->Begin(frame, true, false);
  this->Internal->CulledReceivers =
    shadowed ? this->Internal->Shading->GetNumberOfCulledReceivers() : 0;
  this->Internal->MergedCasters =
    shadowed ? this->Internal->Shading->GetNumberOfMergedCasters() : 0;
  clock.Start(ShadingStage);
  if (this->Internal->Delegate)
  {
    this->Internal->Delegate->Render(s);
    this->NumberOfRenderedProps = this->Internal->Delegate->GetNumberOfRenderedProps();
  }
  else
  {
    if (MustBlendInPlace(s))
    {
      DrawBlendingInPlace(s);
    }
    else
    {
      this->UpdateGeometry(renderer, s->GetFrameBuffer());
    }
    this->NumberOfRenderedProps = s->GetPropArrayCount();
  }
  clock.EndFrame();
  // Frames will take less time once it is known what need not be shaded.
  if (!renderer->GetSelector() && !this->Internal->Shading->IsCullingUndecided())
  {
    this->Internal->Chooser.FrameDrawn(
      isTimed ? std::optional<double>(vtkShadowSecondsOnceDrawn() - start) : std::nullopt);
  }
  if (shadowed)
  {
    if (this->Internal->DebugView != NoView)
    {
      this->ShowDebugView(frame);
    }
    this->Internal->End();
    this->Internal->ReleaseWhatWasTried(frame.Window);
  }
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetCullHiddenFaces(bool culled)
{
  if (culled != this->GetCullHiddenFaces())
  {
    this->Internal->Shading->SetCullHiddenFaces(culled);
    this->Modified();
  }
}

bool vtkShadowPass::GetCullHiddenFaces() const
{
  return this->Internal->Shading->GetCullHiddenFaces();
}

bool vtkShadowPass::GetCullingIsSettled() const
{
  return !this->Internal->Shading->IsCullingUndecided();
}

int vtkShadowPass::GetNumberOfCulledReceivers() const
{
  return this->Internal->CulledReceivers;
}

int vtkShadowPass::GetNumberOfMergedCasters() const
{
  return this->Internal->MergedCasters;
}

vtkIdType vtkShadowPass::GetMergedCasterMemory() const
{
  return static_cast<vtkIdType>(this->Internal->Shading->GetMergedCasterBytes());
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetTimeStages(bool timed)
{
  this->Internal->TimeStages = timed;
}

bool vtkShadowPass::GetTimeStages() const
{
  return this->Internal->TimeStages;
}

//------------------------------------------------------------------------------
void vtkShadowPass::GetStageNames(vtkStringArray* names) const
{
  names->Initialize();
  for (const vtkShadowStageClock::Stage& stage : this->Internal->Clock.GetStages())
  {
    names->InsertNextValue(stage.Name);
  }
}

double vtkShadowPass::GetStageSeconds(const std::string& name) const
{
  const vtkShadowStageClock::Stage* stage = this->Internal->Clock.Find(name);
  return stage ? stage->Seconds : 0.0;
}

double vtkShadowPass::GetStageGPUSeconds(const std::string& name) const
{
  const vtkShadowStageClock::Stage* stage = this->Internal->Clock.Find(name);
  return stage ? stage->GPUSeconds : -1.0;
}

//------------------------------------------------------------------------------
void vtkShadowPass::ShowDebugView(const vtkShadowFrame& frame)
{
  const std::string fault = this->Internal->DrawDebugView(frame);
  if (!fault.empty() && fault != this->Internal->DebugFault)
  {
    std::string names;
    for (const std::string& name : this->Internal->ExplainedBy(this->Internal->DebugView))
    {
      names += (names.empty() ? "\"" : " or \"") + name + "\"";
    }
    vtkWarningMacro("The debug view \"" << this->Internal->DebugView
                                        << "\" cannot be drawn: " << fault
                                        << ". Give the light the technique " << names << ".");
  }
  this->Internal->DebugFault = fault;
}

//------------------------------------------------------------------------------
void vtkShadowPass::ReleaseGraphicsResources(vtkWindow* w)
{
  for (vtkShadowTechniquePass* technique : this->Internal->Techniques)
  {
    technique->ReleaseGraphicsResources(w);
  }
  this->Internal->Shading->ReleaseGraphicsResources(w);
  this->Internal->Receivers.Release();
  if (this->Internal->Delegate)
  {
    this->Internal->Delegate->ReleaseGraphicsResources(w);
  }
}

//------------------------------------------------------------------------------
bool vtkShadowPass::SetTechnique(const std::string& name)
{
  if (!this->Internal->IsKnown(name))
  {
    vtkErrorMacro("Technique \"" << name << "\" is not known: use one of "
                                 << this->Internal->KnownNames() << ". It stays \""
                                 << this->Internal->Default << "\".");
    return false;
  }
  if (name != this->Internal->Default)
  {
    this->Internal->Default = name;
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetTechnique() const
{
  return this->Internal->Default;
}

void vtkShadowPass::SetTechniqueToAuto()
{
  this->SetTechnique(AutoTechnique);
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetTranslucentCasting(int how)
{
  const int before = this->GetTranslucentCasting();
  if (!vtkShadowRefusesChoice(this, "TranslucentCasting", "vtkShadowPass::TranslucentCastingType",
        how, GetNumberOfTranslucentCastings(), before) &&
    how != before)
  {
    this->Internal->Scene->SetTranslucentCasting(how);
    this->Modified();
  }
}

void vtkShadowPass::SetTranslucentCasting(const std::string& name)
{
  const int before = this->GetTranslucentCasting();
  this->SetTranslucentCasting(
    vtkShadowChoiceOf(this, "TranslucentCasting", TranslucentCastingNames, name, before)
      .value_or(before));
}

int vtkShadowPass::GetTranslucentCasting() const
{
  return this->Internal->Scene->GetTranslucentCasting();
}

int vtkShadowPass::GetNumberOfTranslucentCastings()
{
  return static_cast<int>(std::size(TranslucentCastingNames));
}

std::string vtkShadowPass::GetTranslucentCastingName(int how)
{
  return how >= 0 && how < GetNumberOfTranslucentCastings() ? TranslucentCastingNames[how]
                                                            : std::string();
}

//------------------------------------------------------------------------------
void vtkShadowPass::GetTechniqueNames(vtkStringArray* names)
{
  vtkNew<vtkShadowPass> pass;
  names->Initialize();
  for (vtkShadowTechniquePass* technique : pass->Internal->Techniques)
  {
    names->InsertNextValue(technique->GetTechniqueName());
  }
  names->InsertNextValue(AutoTechnique);
  names->InsertNextValue(NoTechnique);
}

//------------------------------------------------------------------------------
vtkShadowTechniquePass* vtkShadowPass::GetTechniquePass(const std::string& name)
{
  return this->Internal->Find(name);
}

//------------------------------------------------------------------------------
vtkDepthShadowMapPass* vtkShadowPass::GetDepthShadowMapPass()
{
  return vtkDepthShadowMapPass::SafeDownCast(this->Internal->Find("depth-map"));
}

//------------------------------------------------------------------------------
vtkObjectIDShadowPass* vtkShadowPass::GetObjectIDShadowPass()
{
  return vtkObjectIDShadowPass::SafeDownCast(this->Internal->Find("object-id"));
}

//------------------------------------------------------------------------------
vtkPlanarShadowPass* vtkShadowPass::GetPlanarShadowPass()
{
  return vtkPlanarShadowPass::SafeDownCast(this->Internal->Find("planar"));
}

//------------------------------------------------------------------------------
vtkShadowTexturePass* vtkShadowPass::GetShadowTexturePass()
{
  return vtkShadowTexturePass::SafeDownCast(this->Internal->Find("shadow-texture"));
}

//------------------------------------------------------------------------------
vtkStencilShadowVolumePass* vtkShadowPass::GetStencilShadowVolumePass()
{
  return vtkStencilShadowVolumePass::SafeDownCast(this->Internal->Find("stencil-volume"));
}

//------------------------------------------------------------------------------
vtkRayCastShadowPass* vtkShadowPass::GetRayCastShadowPass()
{
#ifdef VTKSHADOWS_WITH_EMBREE
  return vtkRayCastShadowPass::SafeDownCast(this->Internal->Find("ray-cast"));
#else
  return nullptr;
#endif
}

//------------------------------------------------------------------------------
bool vtkShadowPass::SetDebugView(const std::string& view)
{
  if (view != NoView && std::find(DebugViews.begin(), DebugViews.end(), view) == DebugViews.end())
  {
    std::string names;
    for (const std::string& name : DebugViews)
    {
      names += name + ", ";
    }
    vtkErrorMacro("Debug view \"" << view << "\" is not known: use one of " << names << NoView
                                  << ". It stays \"" << this->Internal->DebugView << "\".");
    return false;
  }
  if (view != this->Internal->DebugView)
  {
    this->Internal->DebugView = view;
    this->Modified();
  }
  return true;
}

std::string vtkShadowPass::GetDebugView() const
{
  return this->Internal->DebugView;
}

//------------------------------------------------------------------------------
void vtkShadowPass::GetDebugViewNames(vtkStringArray* names)
{
  names->Initialize();
  names->InsertNextValue(NoView);
  for (const std::string& name : DebugViews)
  {
    names->InsertNextValue(name);
  }
}

//------------------------------------------------------------------------------
void vtkShadowPass::GetDebugViewTechniques(const std::string& view, vtkStringArray* names)
{
  vtkNew<vtkShadowPass> pass;
  names->Initialize();
  for (const std::string& name : pass->Internal->ExplainedBy(view))
  {
    names->InsertNextValue(name);
  }
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetDebugLight(vtkLight* light)
{
  if (light != this->Internal->DebugLight)
  {
    this->Internal->DebugLight = light;
    this->Modified();
  }
}

vtkLight* vtkShadowPass::GetDebugLight() const
{
  return this->Internal->DebugLight;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetDelegatePass(vtkRenderPass* delegate)
{
  if (delegate != this->Internal->Delegate)
  {
    this->Internal->Delegate = delegate;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkShadowPass::GetDelegatePass()
{
  return this->Internal->Delegate;
}

//------------------------------------------------------------------------------
vtkShadowScene* vtkShadowPass::GetScene()
{
  return this->Internal->Scene;
}

//------------------------------------------------------------------------------
void vtkShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Technique: " << this->Internal->Default << "\n";
  os << indent << "MaximumError: " << this->GetMaximumError() << "\n";
  os << indent << "MaximumFrameTime: " << this->GetMaximumFrameTime() << "\n";
  os << indent << "Known techniques: " << this->Internal->KnownNames() << "\n";
  os << indent << "Lights with settings: " << this->Internal->Lights.size() << "\n";
  os << indent << "DebugView: " << this->Internal->DebugView << "\n";
  os << indent << "DebugLight: " << this->Internal->DebugLight.GetPointer() << "\n";
  os << indent << "CullHiddenFaces: " << this->GetCullHiddenFaces() << "\n";
  os << indent << "NumberOfCulledReceivers: " << this->GetNumberOfCulledReceivers() << "\n";
  os << indent << "NumberOfMergedCasters: " << this->GetNumberOfMergedCasters() << "\n";
  os << indent << "DelegatePass: " << this->Internal->Delegate.Get() << "\n";
}
