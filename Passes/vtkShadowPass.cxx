#include "vtkShadowPass.h"

#include "ShadowCandidates.h"
#include "vtkDepthShadowMapPass.h"
#include "vtkObjectIDShadowPass.h"
#include "vtkPlanarShadowPass.h"
#include "vtkShadowLightFalloffs.h"
#include "vtkShadowMatrix.h"
#include "vtkShadowMeasured.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowReceiverBuffer.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowStageClock.h"
#include "vtkShadowTechniqueChooser.h"
#include "vtkShadowTexturePass.h"
#include "vtkShadowedShadingPass.h"
#include "vtkStencilShadowVolumePass.h"
#ifdef VTKSHADOWS_WITH_EMBREE
#include "vtkRayCastShadowPass.h"
#endif

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkFloatArray.h"
#include "vtkFrameBufferObjectBase.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkStringArray.h"
#include "vtkTexture.h"
#include "vtkWeakPointer.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>

vtkStandardNewMacro(vtkShadowPass);

vtkInformationKeyMacro(vtkShadowPass, CASTS_SHADOWS, Integer);
vtkInformationKeyMacro(vtkShadowPass, RECEIVES_SHADOWS, Integer);
vtkInformationKeyRestrictedMacro(vtkShadowPass, SHADOW_CATCHER, DoubleVector, 5);
vtkInformationKeyRestrictedMacro(vtkShadowPass, CASTER_STAND_IN, ObjectBase, "vtkPolyData");

namespace
{

const char* const NoTechnique = "none";
const char* const AutoTechnique = "auto";

const char* const NoView = "none";

// Beside the techniques' names.
const char* const SceneStage = "scene";
const char* const ShadingStage = "shading";
const std::vector<std::string> DebugViews = { "volumes", "silhouette", "counts", "cascades",
  "texel-density", "map", "lit-part" };

// Faces nearer to edge-on than this are not measured: there, a rounding decides what is in shadow.
constexpr double GrazingCosine = 0.02;

// Pixels from a true edge beyond which a mismatch is gross.
constexpr double GrossDistance = 2.0;

// Rays that a choice traces for one measure: enough for one gross pixel in 100 000 to be seen, and
// a small part of a second. Lights share them, down to so many pixels each.
constexpr double MeasuredRays = 1.0e6;
constexpr double MeasuredRaysOfBudget = 4.0e6; // where a budget of error is held against it
constexpr double LeastMeasuredPixels = 3.0e4;

// Sample lights that tell whether the truth of a light with a radius hangs on the ray epsilon.
constexpr int SamplesOfUncertainty = 16;

struct LightSettings
{
  vtkWeakPointer<vtkLight> Light;
  std::string Technique; // empty: the default one
  double Strength = 1.0;
  double Radius = 0.0;
  double MaximumDistance = 0.0; // 0: any
  double Fade = 0.1;
  double SmoothCone = 0.0; // share of the cone's angle
  vtkSmartPointer<vtkTexture> Texture;
  double TextureUp[3] = { 0.0, 0.0, 1.0 };

  bool FallsOff() const { return this->SmoothCone > 0.0 || this->Texture; }
};

// A spot, as VTK has them.
bool IsSpot(vtkLight* light)
{
  return light->GetPositional() && light->GetConeAngle() > 0.0 && light->GetConeAngle() < 90.0;
}

// Bring a renderer's window and its props into a render state outside of a frame.
class StateOfRenderer
{
public:
  explicit StateOfRenderer(vtkRenderer* renderer)
    : State(renderer)
  {
    vtkCollectionSimpleIterator it;
    renderer->GetViewProps()->InitTraversal(it);
    while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(it))
    {
      if (prop->GetVisibility())
      {
        this->Props.push_back(prop);
      }
    }
    this->State.SetPropArrayAndCount(this->Props.data(), static_cast<int>(this->Props.size()));
    this->State.SetFrameBuffer(nullptr);
  }
  const vtkRenderState* Get() const { return &this->State; }

private:
  vtkRenderState State;
  std::vector<vtkProp*> Props;
};

void FillImage(vtkImageData* image, const vtkShadowFrame& frame, const std::vector<float>& values,
  const char* name)
{
  image->SetDimensions(frame.Size[0], frame.Size[1], 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  std::copy(values.begin(), values.end(), static_cast<float*>(image->GetScalarPointer()));
  image->GetPointData()->GetScalars()->SetName(name);
  image->Modified();
}

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

std::string Named(const vtkObject* object)
{
  std::ostringstream text;
  text << object;
  return text.str();
}

// By the clock, once OpenGL has worked off all that it was given.
double SecondsOnceDrawn()
{
  glFinish();
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

vtkInformation* KeysOf(vtkProp* prop)
{
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  return prop->GetPropertyKeys();
}

template <typename Key, typename Value>
void SetKey(vtkProp* prop, Key* key, Value value)
{
  if (prop)
  {
    KeysOf(prop)->Set(key, value);
  }
}

// What SHADOW_CATCHER holds, in its order.
enum CatcherSetting
{
  CatcherColor = 0,
  CatcherStrength = 3,
  CatcherFade = 4,
  CatcherSettings = 5
};
const double DefaultCatcher[CatcherSettings] = { 0.0, 0.0, 0.0, 1.0, 0.0 };

// Make `actor` a catcher if it is none, and give it `count` settings from `first` on.
void EditCatcher(vtkActor* actor, const char* what, int first, const double* values, int count)
{
  if (!actor || !std::all_of(values, values + count, [](double v) { return std::isfinite(v); }))
  {
    vtkGenericWarningMacro(<< what << " of actor " << actor << ": give a vtkActor and 0 to 1, not "
                           << values[0] << (count == 3 ? ", ..." : "") << ".");
    return;
  }
  vtkShadowPass::SetShadowCatcher(actor, true);
  vtkInformation* keys = actor->GetPropertyKeys();
  double settings[CatcherSettings];
  std::copy_n(keys->Get(vtkShadowPass::SHADOW_CATCHER()), int(CatcherSettings), settings);
  std::transform(values, values + count, settings + first,
    [](double v) { return std::min(std::max(v, 0.0), 1.0); });
  keys->Set(vtkShadowPass::SHADOW_CATCHER(), settings, CatcherSettings);
  actor->Modified();
}

}

//------------------------------------------------------------------------------
// Calls vtkShadowPass back from under its camera pass.
class vtkShadowFramePass : public vtkRenderPass
{
public:
  static vtkShadowFramePass* New();
  vtkTypeMacro(vtkShadowFramePass, vtkRenderPass);
  void Render(const vtkRenderState* s) override { this->Owner->RenderFrame(s); }
  vtkShadowPass* Owner = nullptr;
};
vtkStandardNewMacro(vtkShadowFramePass);

//------------------------------------------------------------------------------
class vtkShadowPass::Internals
{
public:
  std::vector<vtkSmartPointer<vtkShadowTechniquePass>> Owned;
  std::vector<vtkShadowTechniquePass*> Techniques; // owned ones, or one that is borrowed
  std::string Default = AutoTechnique;
  std::vector<LightSettings> Lights;
  std::string DebugView = NoView;
  std::string DebugFault;                 // as it was last told
  std::vector<std::string> FalloffFaults; // the same, of the lights in their order
  vtkWeakPointer<vtkLight> DebugLight;
  vtkSmartPointer<vtkRenderPass> Delegate;
  vtkNew<vtkShadowScene> Scene;
  vtkNew<vtkShadowedShadingPass> Shading;
  vtkNew<vtkCameraPass> CameraPass;
  vtkNew<vtkShadowFramePass> FramePass;
  vtkShadowReceiverBuffer Receivers;
  vtkShadowStageClock Clock;
  bool TimeStages = false;
  vtkShadowTechniqueChooser Chooser; // for the lights of "auto"
  bool WasSettled = true;            // its choice, in the last frame

  vtkShadowTechniquePass* Find(const std::string& name) const
  {
    for (vtkShadowTechniquePass* technique : this->Techniques)
    {
      if (name == technique->GetTechniqueName())
      {
        return technique;
      }
    }
    return nullptr;
  }

  std::string KnownNames() const
  {
    std::string names;
    for (vtkShadowTechniquePass* technique : this->Techniques)
    {
      names += std::string(technique->GetTechniqueName()) + ", ";
    }
    return names + AutoTechnique + ", " + NoTechnique;
  }

#ifdef VTKSHADOWS_WITH_EMBREE
  // The owned one, or, for a pass that is another technique's, one of its own.
  vtkRayCastShadowPass* GetRayCast()
  {
    if (!this->RayCast)
    {
      this->RayCast = vtkRayCastShadowPass::SafeDownCast(this->Find("ray-cast"));
    }
    if (!this->RayCast)
    {
      this->RayCast = vtkSmartPointer<vtkRayCastShadowPass>::New();
    }
    return this->RayCast;
  }
  vtkSmartPointer<vtkRayCastShadowPass> RayCast;
#endif

  bool IsKnown(const std::string& name) const
  {
    // A technique that stands alone has no others to choose among.
    return name == NoTechnique || (name == AutoTechnique && !this->Owned.empty()) ||
      this->Find(name);
  }

  // The techniques that a view explains.
  std::vector<std::string> ExplainedBy(const std::string& view) const
  {
    std::vector<std::string> names;
    for (vtkShadowTechniquePass* technique : this->Techniques)
    {
      const std::vector<std::string> views = technique->GetDebugViews();
      if (std::find(views.begin(), views.end(), view) != views.end())
      {
        names.push_back(technique->GetTechniqueName());
      }
    }
    return names;
  }

  LightSettings SettingsOf(const vtkLight* light) const
  {
    for (const LightSettings& settings : this->Lights)
    {
      if (settings.Light == light)
      {
        return settings;
      }
    }
    return {};
  }

  LightSettings& EditSettings(vtkLight* light)
  {
    // Lights that are gone take their settings with them.
    this->Lights.erase(std::remove_if(this->Lights.begin(), this->Lights.end(),
                         [](const LightSettings& s) { return !s.Light; }),
      this->Lights.end());
    for (LightSettings& settings : this->Lights)
    {
      if (settings.Light == light)
      {
        return settings;
      }
    }
    this->Lights.emplace_back();
    this->Lights.back().Light = light;
    return this->Lights.back();
  }

  vtkShadowFrame FrameOf(const vtkRenderState* s);
  std::vector<vtkShadowedShadingPass::LightPlan> PlanLights(
    const vtkShadowFrame& frame, bool withStrength);
  void ChooseTechniques(const vtkShadowFrame& frame,
    std::vector<vtkShadowedShadingPass::LightPlan>& plan, const std::vector<int>& lights,
    bool isDrawn);
  // A view that errors are measured in, of fewer pixels than the frame's, and the truth there.
  struct MeasuredView
  {
    vtkShadowFrame Frame;
    double Scale = 1.0; // its pixels are so many of the frame's along an axis
    vtkShadowReceiverBuffer Receivers;
    std::map<int, Measured> Truths; // of lights
  };
  void Reduce(MeasuredView& view, const vtkShadowFrame& frame, const std::vector<int>& lights);
  bool MeasureErrors(MeasuredView& view, const std::vector<vtkShadowedShadingPass::LightPlan>& plan,
    const std::string& name, const std::vector<int>& lights,
    std::vector<std::optional<vtkshadows::ErrorPercents>>& errors);
  bool TraceTruth(const vtkShadowFrame& frame, vtkShadowReceiverBuffer& receivers, int light,
    int samples, Measured& measured);
  int SamplesOfTruth();
  void ReleaseWhatWasTried(vtkWindow* window);
  bool Begin(const vtkShadowFrame& frame, bool withStrength, bool always);
  void UpdateTechniques(
    const vtkShadowFrame& frame, std::vector<vtkShadowedShadingPass::LightPlan>& plan, bool masks);
  void End();
  std::string DrawDebugView(const vtkShadowFrame& frame);
  void TellFalloffs(const std::vector<std::string>& faults);
  std::vector<std::string> PlanFalloffs(std::vector<vtkShadowedShadingPass::LightPlan>& plan);
  std::vector<vtkShadowedShadingPass::LightPlan> Plan; // of this frame
};

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
  frame.ViewFromWorld = vtkShadowMatrix::ToGlm(camera->GetModelViewTransformMatrix());
  frame.ClipFromView = vtkShadowMatrix::ToGlm(
    camera->GetProjectionTransformMatrix(frame.Renderer->GetTiledAspectRatio(), -1.0, 1.0));
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
    const LightSettings settings = this->SettingsOf(lights[i].Source);
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
    const LightSettings settings = this->SettingsOf(light);
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
  std::optional<MeasuredView> view; // all that is measured in this frame shares it
  request.MeasureErrors = [&](const std::string& name, const std::vector<int>& measured,
                            std::vector<std::optional<vtkshadows::ErrorPercents>>& errors)
  {
    if (!view)
    {
      view.emplace();
      this->Reduce(*view, frame, lights);
    }
    return this->MeasureErrors(*view, plan, name, measured, errors);
  };
  const std::vector<std::string> names = this->Chooser.Choose(request);
  if (view)
  {
    view->Receivers.Release();
  }
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    plan[lights[i]].Technique = this->Find(names[i]);
  }
}

//------------------------------------------------------------------------------
// No more pixels than a part of a second allows.
void vtkShadowPass::Internals::Reduce(
  MeasuredView& view, const vtkShadowFrame& frame, const std::vector<int>& lights)
{
  double rays = 0.0;
  for (const int i : lights)
  {
    rays += this->Scene->GetLights()[i].Ray.radius > 0.0 ? vtkshadows::TruthSamples : 1.0;
  }
  const double pixels = static_cast<double>(frame.Size[0]) * frame.Size[1];
  const double budget =
    this->Chooser.GetBudget().maximumError ? MeasuredRaysOfBudget : MeasuredRays;
  view.Scale = std::min(1.0, std::sqrt(std::max(budget / rays, LeastMeasuredPixels) / pixels));
  view.Frame = frame;
  for (int axis = 0; axis < 2; ++axis)
  {
    view.Frame.Size[axis] =
      std::max(1, static_cast<int>(std::lround(view.Scale * frame.Size[axis])));
    view.Frame.Origin[axis] = 0;
  }
  view.Frame.Receivers = &view.Receivers;
}

//------------------------------------------------------------------------------
// Hold what a technique makes of `lights`, as it is set, against the truth, in this view.
bool vtkShadowPass::Internals::MeasureErrors(MeasuredView& view,
  const std::vector<vtkShadowedShadingPass::LightPlan>& plan, const std::string& name,
  const std::vector<int>& lights, std::vector<std::optional<vtkshadows::ErrorPercents>>& errors)
{
#ifdef VTKSHADOWS_WITH_EMBREE
  vtkShadowTechniquePass* technique = this->Find(name);
  std::vector<vtkShadowedShadingPass::LightPlan> measuredPlan = plan;
  for (vtkShadowedShadingPass::LightPlan& entry : measuredPlan)
  {
    entry.Technique = nullptr;
    entry.Strength = 1.0f;
    entry.MaximumDistance = 0.0f;
  }
  technique->NumberOfSlots = 0;
  for (const int i : lights)
  {
    measuredPlan[i].Technique = technique;
    measuredPlan[i].Slot = technique->NumberOfSlots++;
  }
  const vtkShadowFrame& frame = view.Frame;
  this->Shading->SetPlan(measuredPlan);
  this->Shading->Attach(frame);
  view.Receivers.Invalidate();
  bool done = technique->UpdateVisibility(frame, lights);
  this->Shading->ActivateTextures();
  for (std::size_t i = 0; done && i < lights.size(); ++i)
  {
    auto known = view.Truths.find(lights[i]);
    if (known == view.Truths.end())
    {
      known = view.Truths.emplace(lights[i], Measured()).first;
      done = this->TraceTruth(frame, view.Receivers, lights[i],
        std::max(vtkshadows::TruthSamples, this->SamplesOfTruth()), known->second);
    }
    Measured& measured = known->second;
    done = done && view.Receivers.DrawVisibility(frame, lights[i], measured.Visibility);
    if (!done)
    {
      view.Truths.erase(known);
      break;
    }
    vtkshadows::VisibilityImages images;
    images.width = frame.Size[0];
    images.height = frame.Size[1];
    images.visibility = measured.Visibility.data();
    images.truth = measured.Truth.data();
    images.role = measured.Roles.data();
    const vtkshadows::VisibilityError error =
      vtkshadows::MeasureVisibility(images, GrossDistance * view.Scale);
    errors.push_back(error.receiverPixels > 0
        ? std::optional<vtkshadows::ErrorPercents>(
            vtkshadows::ErrorPercents::Of(error, view.Scale < 1.0))
        : std::nullopt);
  }
  this->Shading->Detach();
  technique->NumberOfSlots = 0;
  return done;
#else
  return false;
#endif
}

// Sample lights of the truth as the user asked for: the choice may have set the ray cast otherwise.
int vtkShadowPass::Internals::SamplesOfTruth()
{
#ifdef VTKSHADOWS_WITH_EMBREE
  const int own = this->Chooser.OwnSamples("ray-cast");
  return own > 0 ? own : this->GetRayCast()->GetLightSamples();
#else
  return 1;
#endif
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
  const double start = isTimed ? SecondsOnceDrawn() : 0.0;
  const bool shadowed = !renderer->GetSelector() && this->Internal->Begin(frame, true, false);
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
      isTimed ? std::optional<double>(SecondsOnceDrawn() - start) : std::nullopt);
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

int vtkShadowPass::GetNumberOfCulledReceivers() const
{
  return this->Internal->Shading->GetNumberOfCulledReceivers();
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
  for (const vtkShadowStageClock::Stage& stage : this->Internal->Clock.GetStages())
  {
    if (stage.Name == name)
    {
      return stage.Seconds;
    }
  }
  return 0.0;
}

double vtkShadowPass::GetStageGPUSeconds(const std::string& name) const
{
  for (const vtkShadowStageClock::Stage& stage : this->Internal->Clock.GetStages())
  {
    if (stage.Name == name)
    {
      return stage.GPUSeconds;
    }
  }
  return -1.0;
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
void vtkShadowPass::SetMaximumError(double percent)
{
  if (!std::isfinite(percent) || percent < 0.0 || percent > 100.0)
  {
    vtkErrorMacro(
      "MaximumError " << percent
                      << " is no share of the pixels: give percent, above 0 to 100, or 0 "
                         "for no limit. It stays "
                      << this->GetMaximumError() << ".");
    return;
  }
  if (percent != this->GetMaximumError())
  {
    vtkshadows::ShadowBudget budget = this->Internal->Chooser.GetBudget();
    budget.maximumError = percent > 0.0 ? std::optional<double>(percent) : std::nullopt;
    this->Internal->Chooser.SetBudget(budget);
    this->Modified();
  }
}

double vtkShadowPass::GetMaximumError() const
{
  return this->Internal->Chooser.GetBudget().maximumError.value_or(0.0);
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetMaximumFrameTime(double milliseconds)
{
  if (!std::isfinite(milliseconds) || milliseconds < 0.0)
  {
    vtkErrorMacro("MaximumFrameTime " << milliseconds
                                      << " is no time of a frame: give milliseconds, above 0, or 0 "
                                         "for no limit. It stays "
                                      << this->GetMaximumFrameTime() << ".");
    return;
  }
  if (milliseconds != this->GetMaximumFrameTime())
  {
    vtkshadows::ShadowBudget budget = this->Internal->Chooser.GetBudget();
    budget.maximumSeconds =
      milliseconds > 0.0 ? std::optional<double>(0.001 * milliseconds) : std::nullopt;
    this->Internal->Chooser.SetBudget(budget);
    this->Modified();
  }
}

double vtkShadowPass::GetMaximumFrameTime() const
{
  return 1000.0 * this->Internal->Chooser.GetBudget().maximumSeconds.value_or(0.0);
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetExplanation(vtkLight* light) const
{
  const Internals& my = *this->Internal;
  const std::vector<vtkShadowScene::Light>& lights = my.Scene->GetLights();
  const auto found = std::find_if(lights.begin(), lights.end(),
    [light](const vtkShadowScene::Light& one) { return one.Source == light; });
  if (!light || found == lights.end())
  {
    return "none: the last frame had no such light.";
  }
  const std::string name = this->GetLightTechnique(light);
  return name != AutoTechnique ? name + ": named, not chosen."
    : found->AtEye             ? "none: from the eye, where the light is, no shadow is seen."
    : this->GetLightStrength(light) <= 0.0 ? "none: the strength of its shadows is 0."
    : my.Scene->GetNumberOfCasters() < 1   ? "none: nothing casts."
    : my.Scene->GetNumberOfReceivers() < 1 ? "none: nothing receives."
                                           : my.Chooser.Explain(light);
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetChosenTechnique(vtkLight* light) const
{
  const Internals& my = *this->Internal;
  const std::vector<vtkShadowScene::Light>& lights = my.Scene->GetLights();
  for (std::size_t i = 0; i < lights.size() && i < my.Plan.size(); ++i)
  {
    if (lights[i].Source == light && my.Plan[i].Technique)
    {
      return my.Plan[i].Technique->GetTechniqueName();
    }
  }
  return NoTechnique;
}

bool vtkShadowPass::GetChoiceIsSettled() const
{
  return this->Internal->Chooser.IsSettled();
}

//------------------------------------------------------------------------------
bool vtkShadowPass::SetLightTechnique(vtkLight* light, const std::string& name)
{
  if (!light)
  {
    vtkErrorMacro("SetLightTechnique(nullptr, \"" << name << "\"): give a vtkLight.");
    return false;
  }
  if (!name.empty() && !this->Internal->IsKnown(name))
  {
    vtkErrorMacro("Technique \"" << name << "\" of light " << light << " is not known: use one of "
                                 << this->Internal->KnownNames() << ".");
    return false;
  }
  this->Internal->EditSettings(light).Technique = name;
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetLightTechnique(vtkLight* light) const
{
  const std::string own = this->Internal->SettingsOf(light).Technique;
  return own.empty() ? this->Internal->Default : own;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightStrength(vtkLight* light, double strength)
{
  if (!light || !std::isfinite(strength))
  {
    vtkErrorMacro(
      "SetLightStrength(" << light << ", " << strength << "): give a vtkLight and 0 to 1.");
    return;
  }
  this->Internal->EditSettings(light).Strength = std::min(std::max(strength, 0.0), 1.0);
  this->Modified();
}

//------------------------------------------------------------------------------
double vtkShadowPass::GetLightStrength(vtkLight* light) const
{
  return this->Internal->SettingsOf(light).Strength;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightRadius(vtkLight* light, double radius)
{
  if (!light || !std::isfinite(radius) || radius < 0.0)
  {
    vtkErrorMacro(
      "SetLightRadius(" << light << ", " << radius << "): give a vtkLight and 0 or more.");
    return;
  }
  this->Internal->EditSettings(light).Radius = radius;
  this->Modified();
}

//------------------------------------------------------------------------------
double vtkShadowPass::GetLightRadius(vtkLight* light) const
{
  return this->Internal->SettingsOf(light).Radius;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightMaximumDistance(vtkLight* light, double distance)
{
  if (!light || !std::isfinite(distance) || distance < 0.0)
  {
    vtkErrorMacro("SetLightMaximumDistance("
      << light << ", " << distance
      << "): give a vtkLight and a distance in world units, or 0 for no limit.");
    return;
  }
  this->Internal->EditSettings(light).MaximumDistance = distance;
  this->Modified();
}

double vtkShadowPass::GetLightMaximumDistance(vtkLight* light) const
{
  return this->Internal->SettingsOf(light).MaximumDistance;
}

void vtkShadowPass::SetLightFade(vtkLight* light, double fade)
{
  if (!light || !(fade >= 0.0 && fade <= 1.0))
  {
    vtkErrorMacro("SetLightFade(" << light << ", " << fade
                                  << "): give a vtkLight and a share of its distance, 0 to 1.");
    return;
  }
  this->Internal->EditSettings(light).Fade = fade;
  this->Modified();
}

double vtkShadowPass::GetLightFade(vtkLight* light) const
{
  return this->Internal->SettingsOf(light).Fade;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightSmoothCone(vtkLight* light, double share)
{
  if (!light || !(share >= 0.0 && share <= 1.0))
  {
    vtkErrorMacro("SetLightSmoothCone("
      << light << ", " << share
      << "): give a vtkLight and the share of its cone's angle that it falls off over, 0 to 1.");
    return;
  }
  if (share > 0.0 && !IsSpot(light))
  {
    vtkErrorMacro("SetLightSmoothCone(" << light << ", " << share
                                        << "): the light is no spot. Make it positional, with a "
                                           "cone angle above 0 and below 90 degrees.");
    return;
  }
  this->Internal->EditSettings(light).SmoothCone = share;
  this->Modified();
}

double vtkShadowPass::GetLightSmoothCone(vtkLight* light) const
{
  return this->Internal->SettingsOf(light).SmoothCone;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightTexture(vtkLight* light, vtkTexture* texture)
{
  const std::string call = "SetLightTexture(" + Named(light) + ", " + Named(texture) + "): ";
  if (!light)
  {
    vtkErrorMacro(<< call << "give a vtkLight.");
    return;
  }
  if (texture && !IsSpot(light))
  {
    vtkErrorMacro(<< call
                  << "the light is no spot, and has no cone to project an image through. Make it "
                     "positional, with a cone angle above 0 and below 90 degrees.");
    return;
  }
  if (texture && texture->GetCubeMap())
  {
    vtkErrorMacro(<< call << "the texture " << vtkShadowLightFalloffs::FaultOf(texture) << ".");
    return;
  }
  this->Internal->EditSettings(light).Texture = texture;
  this->Modified();
}

vtkTexture* vtkShadowPass::GetLightTexture(vtkLight* light) const
{
  return this->Internal->SettingsOf(light).Texture;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightTextureUp(vtkLight* light, double x, double y, double z)
{
  // Of a length that neither tiny nor huge vectors lose.
  const double size = std::max({ std::abs(x), std::abs(y), std::abs(z) });
  if (!light || !std::isfinite(x + y + z) || !(size > 0.0) || !std::isfinite(size))
  {
    vtkErrorMacro("SetLightTextureUp("
      << light << ", " << x << ", " << y << ", " << z
      << "): give a vtkLight and a finite vector that is not zero.");
    return;
  }
  const double up[3] = { x / size, y / size, z / size };
  std::copy_n(up, 3, this->Internal->EditSettings(light).TextureUp);
  this->Modified();
}

void vtkShadowPass::GetLightTextureUp(vtkLight* light, double up[3]) const
{
  const LightSettings settings = this->Internal->SettingsOf(light);
  std::copy_n(settings.TextureUp, 3, up);
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetTranslucentCasting(int how)
{
  if (how < TRANSLUCENT_NONE || how > TRANSLUCENT_TRANSMITTANCE)
  {
    vtkErrorMacro("TranslucentCasting "
      << how << " is none of vtkShadowPass::TranslucentCastingType (0 to "
      << TRANSLUCENT_TRANSMITTANCE << "). It stays " << this->GetTranslucentCasting() << ".");
    return;
  }
  if (how != this->GetTranslucentCasting())
  {
    this->Internal->Scene->SetTranslucentCasting(how);
    this->Modified();
  }
}

int vtkShadowPass::GetTranslucentCasting() const
{
  return this->Internal->Scene->GetTranslucentCasting();
}

//------------------------------------------------------------------------------
void vtkShadowPass::ClearLightSettings(vtkLight* light)
{
  std::vector<LightSettings>& all = this->Internal->Lights;
  all.erase(std::remove_if(all.begin(), all.end(),
              [light](const LightSettings& s) { return !light || s.Light == light; }),
    all.end());
  this->Modified();
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
void vtkShadowPass::SetCastsShadows(vtkProp* prop, bool casts)
{
  SetKey(prop, vtkShadowPass::CASTS_SHADOWS(), casts ? 1 : 0);
}

void vtkShadowPass::SetReceivesShadows(vtkProp* prop, bool receives)
{
  SetKey(prop, vtkShadowPass::RECEIVES_SHADOWS(), receives ? 1 : 0);
}

void vtkShadowPass::SetStandIn(vtkProp* prop, vtkPolyData* mesh)
{
  SetKey(prop, vtkShadowPass::CASTER_STAND_IN(), mesh); // nullptr removes the key
}

vtkPolyData* vtkShadowPass::GetStandIn(vtkProp* prop)
{
  vtkInformation* keys = prop ? prop->GetPropertyKeys() : nullptr;
  return keys ? vtkPolyData::SafeDownCast(keys->Get(vtkShadowPass::CASTER_STAND_IN())) : nullptr;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetShadowCatcher(vtkActor* actor, bool catches)
{
  if (!actor)
  {
    vtkGenericWarningMacro("SetShadowCatcher(nullptr, " << catches << "): give a vtkActor.");
  }
  else if (catches && !vtkShadowPass::IsShadowCatcher(actor))
  {
    KeysOf(actor)->Set(vtkShadowPass::SHADOW_CATCHER(), DefaultCatcher, CatcherSettings);
    actor->GetProperty()->SetOpacity(0.0);
    actor->Modified();
  }
  else if (!catches && vtkShadowPass::IsShadowCatcher(actor))
  {
    actor->GetPropertyKeys()->Remove(vtkShadowPass::SHADOW_CATCHER());
    actor->GetProperty()->SetOpacity(1.0);
    actor->Modified();
  }
}

bool vtkShadowPass::IsShadowCatcher(vtkProp* prop)
{
  vtkInformation* keys = prop ? prop->GetPropertyKeys() : nullptr;
  return keys && keys->Has(vtkShadowPass::SHADOW_CATCHER());
}

void vtkShadowPass::SetCatcherColor(vtkActor* actor, double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  EditCatcher(actor, "SetCatcherColor", CatcherColor, color, 3);
}

void vtkShadowPass::SetCatcherStrength(vtkActor* actor, double strength)
{
  EditCatcher(actor, "SetCatcherStrength", CatcherStrength, &strength, 1);
}

void vtkShadowPass::SetCatcherFade(vtkActor* actor, double fade)
{
  EditCatcher(actor, "SetCatcherFade", CatcherFade, &fade, 1);
}

bool vtkShadowPass::GetCatcherSettings(
  vtkProp* prop, double color[3], double& strength, double& fade)
{
  const bool catches = vtkShadowPass::IsShadowCatcher(prop);
  const double* settings =
    catches ? prop->GetPropertyKeys()->Get(vtkShadowPass::SHADOW_CATCHER()) : DefaultCatcher;
  std::copy_n(settings + CatcherColor, 3, color);
  strength = settings[CatcherStrength];
  fade = settings[CatcherFade];
  return catches;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::FindLight(vtkRenderer* renderer, vtkLight* light, int& index)
{
  auto* window =
    renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) : nullptr;
  if (!window || window->GetNeverRendered())
  {
    vtkErrorMacro(
      "The renderer " << renderer
                      << " has no OpenGL window that has rendered: call Render() on its "
                         "window first.");
    return false;
  }
  window->MakeCurrent();
  index = 0;
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* other = renderer->GetLights()->GetNextLight(it))
  {
    if (other == light && light->GetSwitch())
    {
      this->UpdateLightGeometry(renderer);
      this->UpdateLights(renderer);
      return true;
    }
    index += other->GetSwitch() ? 1 : 0;
  }
  vtkErrorMacro("The light " << light << " is not among the switched-on lights of renderer "
                             << renderer << ": add it, or switch it on.");
  return false;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetVisibility(vtkRenderer* renderer, vtkLight* light, vtkImageData* visibility)
{
  int index = 0;
  if (!visibility)
  {
    vtkErrorMacro(
      "GetVisibility(" << renderer << ", " << light << ", nullptr): give a vtkImageData to fill.");
    return false;
  }
  if (!this->FindLight(renderer, light, index))
  {
    return false;
  }
  Internals& my = *this->Internal;
  const StateOfRenderer state(renderer);
  const vtkShadowFrame frame = my.FrameOf(state.Get());
  std::vector<float> values(static_cast<std::size_t>(frame.Size[0]) * frame.Size[1], 1.0f);
  bool drawn = true;
  if (my.Begin(frame, false, false))
  {
    drawn = my.Receivers.DrawVisibility(frame, index, values);
    my.End();
  }
  if (!drawn)
  {
    vtkErrorMacro("The driver cannot hold a buffer of "
      << frame.Size[0] << " x " << frame.Size[1]
      << " float pixels to read visibility from. Use a smaller window.");
    return false;
  }
  FillImage(visibility, frame, values, "Visibility");
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetVolumeCounts(vtkRenderer* renderer, vtkLight* light, vtkImageData* counts)
{
  int index = 0;
  if (!counts)
  {
    vtkErrorMacro("GetVolumeCounts(" << renderer << ", " << light
                                     << ", nullptr): give a vtkImageData to fill.");
    return false;
  }
  if (!this->FindLight(renderer, light, index))
  {
    return false;
  }
  Internals& my = *this->Internal;
  const StateOfRenderer state(renderer);
  const vtkShadowFrame frame = my.FrameOf(state.Get());
  std::vector<float> values;
  bool done = false;
  if (my.Begin(frame, false, false))
  {
    const vtkShadowedShadingPass::LightPlan& entry = my.Plan[index];
    auto* volumes = vtkStencilShadowVolumePass::SafeDownCast(entry.Technique);
    done = volumes && volumes->CountAgain(frame, entry.Slot, values);
    my.End();
  }
  if (!done)
  {
    vtkErrorMacro("Light " << light << " has no volumes to count: its technique is \""
                           << this->GetLightTechnique(light)
                           << "\", or nothing casts. Give it \"stencil-volume\".");
    return false;
  }
  FillImage(counts, frame, values, "VolumeCounts");
  return true;
}

//------------------------------------------------------------------------------
double vtkShadowPass::TimeBareTracing(vtkRenderer* renderer)
{
  double seconds = 0.0;
#ifdef VTKSHADOWS_WITH_EMBREE
  vtkRayCastShadowPass* reference = this->GetRayCastShadowPass();
  if (!reference || !renderer || !renderer->GetRenderWindow() ||
    renderer->GetRenderWindow()->GetNeverRendered())
  {
    vtkErrorMacro("TimeBareTracing(" << renderer << "): call Render() on its window first.");
    return seconds;
  }
  renderer->GetRenderWindow()->MakeCurrent();
  const StateOfRenderer state(renderer);
  const vtkShadowFrame frame = this->Internal->FrameOf(state.Get());
  if (this->Internal->Begin(frame, true, true))
  {
    seconds = reference->TimeBareTracing(frame);
    this->Internal->End();
  }
#endif
  return seconds;
}

//------------------------------------------------------------------------------
// The truth of light `light` at every pixel, and what each pixel is to the measure.
bool vtkShadowPass::Internals::TraceTruth(const vtkShadowFrame& frame,
  vtkShadowReceiverBuffer& receivers, int light, int samples, Measured& measured)
{
#ifdef VTKSHADOWS_WITH_EMBREE
  const std::size_t pixels = static_cast<std::size_t>(frame.Size[0]) * frame.Size[1];
  measured.Size[0] = frame.Size[0];
  measured.Size[1] = frame.Size[1];
  const vtkshadows::ShadowLight ray = this->Scene->GetLights()[light].Ray;
  vtkRayCastShadowPass* reference = this->GetRayCast();
  std::vector<float> nearby;
  if (!receivers.Draw(frame) ||
    !reference->TraceVisibility(frame, receivers, ray, 1.0, samples, measured.Truth) ||
    !reference->TraceVisibility(
      frame, receivers, ray, 4.0, std::min(samples, SamplesOfUncertainty), nearby))
  {
    return false;
  }
  const glm::dmat4 worldFromView = glm::inverse(frame.ViewFromWorld);
  const double coneCosine = std::cos(glm::radians(ray.coneAngle));
  measured.Roles.assign(pixels, vtkshadows::PixelRole::Background);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    vtkShadowReceiverBuffer::Receiver receiver;
    if (!receivers.At(i, receiver))
    {
      continue;
    }
    const glm::dvec3 pointWC(worldFromView * glm::dvec4(receiver.PositionVC, 1.0));
    const glm::dvec3 normalWC(worldFromView * glm::dvec4(receiver.NormalVC, 0.0));
    const glm::dvec3 towardLight = ray.TowardLight(pointWC);
    // A spot shines on nothing outside its cone.
    const bool reached = ray.kind != vtkshadows::LightKind::Spot ||
      -glm::dot(towardLight, ray.direction) >= coneCosine;
    measured.Roles[i] = !reached || glm::dot(normalWC, towardLight) <= GrazingCosine
      ? vtkshadows::PixelRole::Grazing
      : std::abs(measured.Truth[i] - nearby[i]) > 0.5f ? vtkshadows::PixelRole::Uncertain
                                                       : vtkshadows::PixelRole::Measured;
  }
  // A headlight is lit everywhere by definition, and its truth with it.
  if (this->Scene->GetLights()[light].AtEye)
  {
    std::fill(measured.Truth.begin(), measured.Truth.end(), 1.0f);
  }
  return true;
#else
  return false;
#endif
}

//------------------------------------------------------------------------------
bool vtkShadowPass::MeasureLight(vtkRenderer* renderer, vtkLight* light, Measured& measured)
{
#ifndef VTKSHADOWS_WITH_EMBREE
  vtkErrorMacro("This build has no Embree, so there is no truth to measure light "
    << light << " against: configure with -DVTKSHADOWS_WITH_EMBREE=ON.");
  return false;
#else
  int index = 0;
  if (!this->FindLight(renderer, light, index))
  {
    return false;
  }
  Internals& my = *this->Internal;
  const StateOfRenderer state(renderer);
  const vtkShadowFrame frame = my.FrameOf(state.Get());
  const std::size_t pixels = static_cast<std::size_t>(frame.Size[0]) * frame.Size[1];
  if (!my.Begin(frame, false, true))
  {
    vtkErrorMacro("The renderer " << renderer << " has a viewport of " << frame.Size[0] << " x "
                                  << frame.Size[1] << " pixels: nothing to measure. Enlarge it.");
    return false;
  }

  const bool done = my.TraceTruth(frame, my.Receivers, index, my.SamplesOfTruth(), measured) &&
    my.Receivers.DrawVisibility(frame, index, measured.Visibility);
  my.End();
  if (!done)
  {
    vtkErrorMacro(
      "Light " << light << " could not be measured: the driver or Embree gave no buffer of "
               << frame.Size[0] << " x " << frame.Size[1] << " pixels. Use a smaller window.");
  }
  return done;
#endif
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
  os << indent << "DelegatePass: " << this->Internal->Delegate.Get() << "\n";
}
