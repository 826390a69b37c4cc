#include "Stage.h"

#include "Failure.h"
#include "VtkMessages.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDepthShadowMapPass.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPlaneSource.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkShadowPass.h>
#include <vtkTextureObject.h>
#include <vtkWindowToImageFilter.h>

#include <sstream>

namespace vtkshadows
{
namespace
{

// Muted tones that leave a shadow room below and a highlight above; in turn for several inputs.
constexpr double MeshColors[][3] = { { 0.60, 0.73, 0.84 }, { 0.90, 0.63, 0.46 },
  { 0.65, 0.78, 0.57 }, { 0.77, 0.66, 0.82 }, { 0.88, 0.80, 0.52 } };
constexpr double FloorColor[3] = { 0.96, 0.93, 0.87 };

// What shadow leaves of a surface's colour: dark, but not black.
constexpr double Ambient = 0.24;

void AddActor(vtkRenderer* renderer, vtkPolyData* mesh, const double color[3])
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(color[0], color[1], color[2]);
  property->SetAmbient(Ambient);
  property->SetDiffuse(1.0 - Ambient);
  renderer->AddActor(actor);
}

void FailAtVtkError(const std::string& object)
{
  const std::string error = TakeVtkError();
  if (!error.empty())
  {
    throw Failure(object, "", error, "change what it names, or the OpenGL driver");
  }
}

}

Stage::Stage(const std::vector<Mesh>& meshes, const StageSettings& settings)
  : axes(ChooseAxes(settings.up, settings.camera, meshes))
  , extent(MeasureExtent(meshes, this->axes))
{
  this->OpenWindow(settings.size);
  this->AddMeshes(meshes);
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
  if (settings.resolution)
  {
    this->shadows->GetDepthShadowMapPass()->SetResolution(*settings.resolution);
  }

  const double aspect = static_cast<double>(settings.size.width) / settings.size.height;
  this->PlaceCamera(settings.camera ? *settings.camera : FitCamera(meshes, this->axes, aspect));
  this->ShowShadows(true);
}

Stage::~Stage() = default;

void Stage::OpenWindow(const WindowSize& size)
{
  // Small at first, for the context that tells how large it may be.
  this->window->SetOffScreenRendering(true);
  this->window->SetMultiSamples(0);
  this->window->SetSize(16, 16);
  this->window->AddRenderer(this->renderer);
  auto* openGL = vtkOpenGLRenderWindow::SafeDownCast(this->window);
  if (!openGL)
  {
    throw Failure("OpenGL", "", "this VTK has no OpenGL window", "use a VTK with RenderingOpenGL2");
  }
  openGL->Initialize();
  FailAtVtkError("OpenGL");
  openGL->MakeCurrent();
  const int limit = vtkTextureObject::GetMaximumTextureSize(openGL);
  if (size.width > limit || size.height > limit)
  {
    throw Failure("--size", std::to_string(size.width) + "x" + std::to_string(size.height),
      "is more than this OpenGL driver can draw",
      "choose at most " + std::to_string(limit) + "x" + std::to_string(limit));
  }
  this->window->SetSize(size.width, size.height);

  this->renderer->SetBackground(0.74, 0.77, 0.81);
  this->renderer->SetBackground2(0.93, 0.95, 0.97);
  this->renderer->GradientBackgroundOn();
}

void Stage::AddMeshes(const std::vector<Mesh>& meshes)
{
  const std::size_t colors = sizeof(MeshColors) / sizeof(MeshColors[0]);
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    AddActor(this->renderer, meshes[i].triangles, MeshColors[i % colors]);
    this->numberOfTriangles += meshes[i].triangles->GetNumberOfPolys();
  }
}

void Stage::AddFloor(const FloorSpec& floor)
{
  const FloorCorners corners = PlaceFloor(floor, this->extent, this->axes);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->SetOrigin(corners.origin.x, corners.origin.y, corners.origin.z);
  plane->SetPoint1(corners.end1.x, corners.end1.y, corners.end1.z);
  plane->SetPoint2(corners.end2.x, corners.end2.y, corners.end2.z);
  plane->Update();
  AddActor(this->renderer, plane->GetOutput(), FloorColor);
  this->numberOfTriangles += 2;
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

  this->shadows->SetLightRadius(light, spec.radius);
  this->shadows->SetLightStrength(light, spec.strength);
  if (!spec.technique.empty())
  {
    this->shadows->SetLightTechnique(light, spec.technique);
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

void Stage::ShowShadows(bool shown)
{
  this->renderer->SetPass(shown ? this->shadows.Get() : nullptr);
}

void Stage::Render()
{
  this->window->Render();
  this->window->WaitForCompletion();
  FailAtVtkError("rendering");
}

vtkSmartPointer<vtkImageData> Stage::Picture()
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(this->window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  FailAtVtkError("picture");
  return grab->GetOutput();
}

vtkIdType Stage::NumberOfTriangles() const
{
  return this->numberOfTriangles;
}

std::string Stage::OpenGLRenderer()
{
  const std::string heading = "OpenGL renderer string:";
  std::istringstream capabilities(this->window->ReportCapabilities());
  for (std::string line; std::getline(capabilities, line);)
  {
    if (line.compare(0, heading.size(), heading) == 0)
    {
      const std::size_t begin = line.find_first_not_of(' ', heading.size());
      return begin == std::string::npos ? "" : line.substr(begin);
    }
  }
  return "unknown";
}

}
