#include "Stage.h"

#include "Failure.h"
#include "Pictures.h"
#include "Techniques.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDepthShadowMapPass.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkObjectIDShadowPass.h>
#include <vtkPlanarShadowPass.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRayCastShadowPass.h>
#include <vtkRenderer.h>
#include <vtkShadowFloor.h>
#include <vtkShadowPass.h>
#include <vtkShadowTexturePass.h>
#include <vtkStencilShadowVolumePass.h>
#include <vtkTexture.h>

#include <algorithm>

namespace vtkshadows
{
namespace
{

// Muted tones that leave a shadow room below and a highlight above; in turn for several inputs.
constexpr double MeshColors[][3] = { { 0.60, 0.73, 0.84 }, { 0.90, 0.63, 0.46 },
  { 0.65, 0.78, 0.57 }, { 0.77, 0.66, 0.82 }, { 0.88, 0.80, 0.52 } };
constexpr double FloorColor[3] = { 0.96, 0.93, 0.87 };

// What shadow leaves of a surface's colour: dark, but not black.
constexpr double Ambient = 0.28;

// Over which share of a catcher, from its rim, its shadow rises to its whole strength.
constexpr double CatcherFade = 0.25;

// Frames after which a choice is taken as it is, though others might turn out faster.
constexpr int MostFramesOfChoice = 60;

void AddActor(vtkRenderer* renderer, vtkActor* actor, const double color[3])
{
  vtkProperty* property = actor->GetProperty();
  property->SetColor(color[0], color[1], color[2]);
  property->SetAmbient(Ambient);
  property->SetDiffuse(1.0 - Ambient);
  renderer->AddActor(actor);
}

}

Stage::Stage(const std::vector<Mesh>& meshes, const StageSettings& settings)
  : shadows(vtkSmartPointer<vtkShadowPass>::New())
  , axes(ChooseAxes(settings.up, settings.camera, meshes))
  , extent(MeasureExtent(meshes, this->axes))
  , translucentCasters(settings.translucentCasters)
  , cullHiddenFaces(settings.cullHiddenFaces)
{
  this->OpenWindow(settings.size);
  this->GiveFrameSettings(this->shadows);
  this->SetMapResolution(settings.resolution);
  if (settings.cascades)
  {
    this->shadows->GetDepthShadowMapPass()->SetNumberOfCascades(*settings.cascades);
    this->shadows->GetObjectIDShadowPass()->SetNumberOfCascades(*settings.cascades);
  }
  this->SetLightSamples(settings.lightSamples);
  this->shadows->GetDepthShadowMapPass()->SetFilter(settings.filter);
  this->shadows->GetDepthShadowMapPass()->SetDepthBits(settings.depthBits);
  vtkObjectIDShadowPass* objects = this->shadows->GetObjectIDShadowPass();
  objects->SetObjectType(settings.objectType);
  objects->SetCombineDepth(settings.objectDepths);
  objects->SetDepthBits(settings.objectDepthBits);
  objects->SetTaps(settings.objectTaps);
  this->shadows->GetShadowTexturePass()->SetTexturePerCaster(settings.texturePerCaster);
  this->shadows->SetMaximumError(settings.maximumError);
  this->shadows->SetMaximumFrameTime(settings.maximumFrameTime);
  this->AddMeshes(meshes, settings.opacities);
  if (settings.floor.kind != FloorSpec::Kind::None)
  {
    this->AddFloor(settings.floor);
  }

  this->renderer->AutomaticLightCreationOff();
  for (const LightSpec& light : settings.lights)
  {
    this->AddLight(light);
  }
  if (settings.lights.empty())
  {
    this->AddLight(DefaultLight(this->axes));
  }
  const double aspect = static_cast<double>(settings.size.width) / settings.size.height;
  this->PlaceCamera(settings.camera ? *settings.camera : FitCamera(meshes, this->axes, aspect));
  this->ShowShadows(true);
}

Stage::Stage(const StageSettings& settings)
  : shadows(vtkSmartPointer<vtkShadowPass>::New())
  , translucentCasters(settings.translucentCasters)
  , cullHiddenFaces(settings.cullHiddenFaces)
{
  this->OpenWindow(settings.size);
  this->GiveFrameSettings(this->shadows);
  this->renderer->AutomaticLightCreationOff();
  this->ShowShadows(true);
}

Stage::~Stage() = default;

void Stage::OpenWindow(const WindowSize& size)
{
  this->windowSize = size;
  this->window.Open(size.width, size.height);
  this->window.Add(this->renderer);
  this->renderer->SetBackground(0.74, 0.77, 0.81);
  this->renderer->SetBackground2(0.93, 0.95, 0.97);
  this->renderer->GradientBackgroundOn();
}

void Stage::Resize(const WindowSize& size)
{
  this->window.Resize(size.width, size.height);
  this->windowSize = size;
}

SceneFacts Stage::ShowScene(const std::string& name, SceneSize size)
{
  size.width = this->windowSize.width;
  size.height = this->windowSize.height;
  SceneFacts facts;
  try
  {
    facts = BuildScene(name, this->renderer, size);
  }
  catch (const std::exception& error)
  {
    throw Failure("scene", name, error.what(), "give another file or size, or leave the scene out");
  }
  this->lights.clear();
  this->lightSpecs.clear();
  for (const SceneLight& light : facts.lights)
  {
    LightSpec spec;
    spec.kind = light.kind;
    spec.radius = light.radius;
    this->lights.push_back(light.light);
    this->lightSpecs.push_back(spec);
  }
  const double* b = facts.bounds;
  this->axes = SceneAxes();
  this->extent.low = { b[0], b[2], b[4] };
  this->extent.high = { b[1], b[3], b[5] };
  this->extent.center = 0.5 * (this->extent.low + this->extent.high);
  this->numberOfTriangles = facts.triangles;
  return facts;
}

vtkSmartPointer<vtkShadowPass> Stage::MakeShadows(bool soft)
{
  auto pass = vtkSmartPointer<vtkShadowPass>::New();
  this->GiveFrameSettings(pass);
  for (std::size_t light = 0; light < this->lights.size(); ++light)
  {
    this->GiveLightSettings(pass, light, soft);
  }
  return pass;
}

void Stage::UseShadows(vtkShadowPass* pass)
{
  this->shadows = pass;
  this->UsePass(nullptr);
}

void Stage::RenewShadows(bool soft)
{
  this->shadows->ReleaseGraphicsResources(this->renderer->GetVTKWindow());
  this->UseShadows(this->MakeShadows(soft));
}

void Stage::UsePass(vtkRenderPass* pass)
{
  this->shownPass = pass;
  this->ShowShadows(true);
}

void Stage::SetMapResolution(std::optional<int> resolution)
{
  if (!resolution)
  {
    return;
  }
  const int limit = this->window.LargestTexture();
  if (*resolution > limit)
  {
    throw Failure("--resolution", std::to_string(*resolution),
      "is more texels than a map of this OpenGL driver can have",
      "choose at most " + std::to_string(limit));
  }
  this->shadows->GetDepthShadowMapPass()->SetResolution(*resolution);
  this->shadows->GetObjectIDShadowPass()->SetResolution(*resolution);
  this->shadows->GetShadowTexturePass()->SetResolution(*resolution);
}

void Stage::SetLightSamples(std::optional<int> samples)
{
  if (!samples)
  {
    return;
  }
  this->shadows->GetDepthShadowMapPass()->SetLightSamples(
    std::min(*samples, vtkDepthShadowMapPass::MostLightSamples));
  this->shadows->GetPlanarShadowPass()->SetLightSamples(*samples);
  this->shadows->GetStencilShadowVolumePass()->SetLightSamples(*samples);
  if (vtkRayCastShadowPass* rayCast = this->shadows->GetRayCastShadowPass())
  {
    rayCast->SetLightSamples(*samples);
  }
}

void Stage::AddMeshes(const std::vector<Mesh>& meshes, const std::vector<double>& opacities)
{
  const std::size_t colors = sizeof(MeshColors) / sizeof(MeshColors[0]);
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(meshes[i].triangles);
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    AddActor(this->renderer, actor, MeshColors[i % colors]);
    if (!opacities.empty())
    {
      actor->GetProperty()->SetOpacity(opacities[i % opacities.size()]);
    }
    this->numberOfTriangles += meshes[i].triangles->GetNumberOfPolys();
  }
}

void Stage::AddFloor(const FloorSpec& spec)
{
  const bool isGiven = spec.kind == FloorSpec::Kind::Plane;
  const glm::dvec3 normal = isGiven ? spec.normal : this->axes.up;
  vtkNew<vtkShadowFloor> floor;
  floor->SetNormal(normal.x, normal.y, normal.z);
  if (!(this->extent.Size() > 0.0))
  {
    return; // a point has no floor
  }
  isGiven ? floor->FitAt(this->renderer, spec.offset) : floor->Fit(this->renderer);
  this->catches = spec.kind == FloorSpec::Kind::Catcher;
  if (this->catches)
  {
    vtkShadowPass::SetShadowCatcher(floor->GetActor(), true);
    vtkShadowPass::SetCatcherFade(floor->GetActor(), CatcherFade);
  }
  AddActor(this->renderer, floor->GetActor(), FloorColor);
  this->numberOfTriangles += 2;
}

vtkSmartPointer<vtkImageData> Stage::Picture()
{
  return this->catches ? this->window.TransparentPicture() : this->window.Picture();
}

void Stage::AddLight(const LightSpec& spec)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetColor(spec.color.x, spec.color.y, spec.color.z);
  light->SetIntensity(spec.intensity);
  if (spec.kind == LightKind::Directional)
  {
    // About the origin, so that far-off scenes do not cost the direction its digits.
    light->SetPositional(false);
    light->SetPosition(-spec.direction.x, -spec.direction.y, -spec.direction.z);
    light->SetFocalPoint(0.0, 0.0, 0.0);
  }
  else
  {
    // 180 degrees: VTK takes 90 and more as no cone, and then has no use for the focal point.
    const bool spot = spec.kind == LightKind::Spot;
    const glm::dvec3 target = spot ? spec.focalPoint : this->extent.center;
    light->SetPositional(true);
    light->SetConeAngle(spot ? spec.coneAngle : 180.0);
    light->SetPosition(spec.position.x, spec.position.y, spec.position.z);
    light->SetFocalPoint(target.x, target.y, target.z);
  }
  this->renderer->AddLight(light);
  this->lights.push_back(light);
  this->lightSpecs.push_back(spec);
  this->GiveLightSettings(this->shadows, this->lights.size() - 1, true);
}

void Stage::GiveFrameSettings(vtkShadowPass* pass) const
{
  pass->SetTranslucentCasting(this->translucentCasters);
  pass->SetCullHiddenFaces(this->cullHiddenFaces);
}

void Stage::GiveLightSettings(vtkShadowPass* pass, std::size_t index, bool soft)
{
  vtkLight* light = this->lights[index];
  const LightSpec& spec = this->lightSpecs[index];
  pass->SetLightRadius(light, soft ? spec.radius : 0.0);
  pass->SetLightStrength(light, spec.strength);
  pass->SetLightMaximumDistance(light, spec.distance);
  pass->SetLightFade(light, spec.fade);
  if (spec.kind == LightKind::Spot)
  {
    pass->SetLightSmoothCone(light, spec.falloff);
  }
  if (!spec.texture.empty())
  {
    pass->SetLightTexture(light, ReadTexture("--light @texture", spec.texture));
    pass->SetLightTextureUp(light, this->axes.up.x, this->axes.up.y, this->axes.up.z);
  }
  if (!spec.technique.empty())
  {
    pass->SetLightTechnique(light, spec.technique);
  }
}

void Stage::PlaceCamera(const CameraSpec& spec)
{
  vtkCamera* camera = this->renderer->GetActiveCamera();
  camera->SetPosition(spec.position.x, spec.position.y, spec.position.z);
  camera->SetFocalPoint(spec.focalPoint.x, spec.focalPoint.y, spec.focalPoint.z);
  camera->SetViewUp(spec.up.x, spec.up.y, spec.up.z);
  camera->SetViewAngle(spec.viewAngle);
  this->renderer->ResetCameraClippingRange();
}

void Stage::UseTechnique(const std::string& technique)
{
  this->shadows->SetTechnique(technique);
}

std::string Stage::TechniqueOf(std::size_t light)
{
  const std::string own = this->shadows->GetLightTechnique(this->lights[light]);
  return own.empty() ? this->shadows->GetTechnique() : own;
}

bool Stage::IsChosen()
{
  for (std::size_t i = 0; i < this->lights.size(); ++i)
  {
    if (this->TechniqueOf(i) == "auto")
    {
      return true;
    }
  }
  return false;
}

void Stage::SettleChoice()
{
  for (int i = 0; this->IsChosen() && i < MostFramesOfChoice; ++i)
  {
    this->window.Render();
    if (this->shadows->GetChoiceIsSettled())
    {
      return;
    }
  }
}

// A shape is looked at in its second frame, and what is found of it is left out in the next.
void Stage::SettleCulling()
{
  constexpr int MostFrames = 64;
  for (int i = 0;
       this->cullHiddenFaces && i < MostFrames && (i < 2 || !this->shadows->GetCullingIsSettled());
       ++i)
  {
    this->window.Render();
  }
}

std::string Stage::ExplanationOf(std::size_t light)
{
  return this->shadows->GetExplanation(this->lights[light]);
}

void Stage::ShowDebugView(const std::string& view)
{
  const std::vector<std::string> explained = TechniquesExplainedBy(view);
  this->shadows->SetDebugLight(nullptr);
  for (std::size_t i = this->lights.size(); i-- > 0;)
  {
    if (std::find(explained.begin(), explained.end(), this->TechniqueOf(i)) != explained.end())
    {
      this->shadows->SetDebugLight(this->lights[i]);
    }
  }
  this->shadows->SetDebugView(view);
}

void Stage::ShowShadows(bool shown)
{
  vtkRenderPass* pass = this->shownPass ? this->shownPass.Get() : this->shadows.Get();
  this->renderer->SetPass(shown ? pass : nullptr);
}

vtkIdType Stage::NumberOfTriangles() const
{
  return this->numberOfTriangles;
}

}
