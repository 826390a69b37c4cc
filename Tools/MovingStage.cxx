#include "MovingStage.h"

#include "Stage.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkRenderer.h>
#include <vtkShadowPass.h>

#include <algorithm>
#include <cmath>

namespace vtkshadows
{
namespace
{

// For "auto" to notice what moves, and to make its choice.
constexpr int FewestFramesOfChoice = 4;
constexpr int MostFramesOfChoice = 200;
// Frames in a row that it has stayed as it is: a measure may unsettle it. Of slow ones fewer, once
// they took so long.
constexpr int FramesOfRest = 10;
constexpr int FewestFramesOfRest = 2;
constexpr double SecondsOfRest = 2.0;

// Of one frame. The camera swings to and fro by degrees; lights circle by a share of the scene.
constexpr double CameraStep = 0.4;
constexpr int CameraSteps = 10;
constexpr double LightCircle = 0.01;
constexpr double LightStep = 0.7; // radians

}

MovingStage::MovingStage(Stage& movedStage)
  : stage(movedStage)
{
  this->camera->DeepCopy(this->stage.Renderer()->GetActiveCamera());
  for (vtkLight* light : this->stage.Lights())
  {
    Placement placement;
    light->GetPosition(&placement.position.x);
    light->GetFocalPoint(&placement.focalPoint.x);
    this->lights.push_back(placement);
  }
}

MovingStage::~MovingStage()
{
  this->RestCamera();
  this->RestLights();
  this->stage.ShowShadows(true);
}

void MovingStage::SwingCamera()
{
  this->RestCamera();
  const int phase = ++this->cameraFrame % (2 * CameraSteps);
  const double angle = CameraStep * (std::abs(phase - CameraSteps) - 0.5 * CameraSteps);
  this->stage.Renderer()->GetActiveCamera()->Azimuth(angle);
  this->stage.Renderer()->ResetCameraClippingRange();
}

void MovingStage::RestCamera()
{
  vtkCamera* shown = this->stage.Renderer()->GetActiveCamera();
  shown->DeepCopy(this->camera);
  shown->Modified(); // which a copy does not tell of
}

void MovingStage::CircleLights()
{
  const double angle = LightStep * ++this->lightFrame;
  const SceneAxes& axes = this->stage.Axes();
  for (std::size_t i = 0; i < this->lights.size(); ++i)
  {
    vtkLight* light = this->stage.Lights()[i];
    const double scale = light->GetPositional() ? this->stage.Extent().Size() : 1.0;
    const glm::dvec3 position = this->lights[i].position +
      LightCircle * scale * (std::cos(angle) * axes.right + std::sin(angle) * axes.forward);
    light->SetPosition(position.x, position.y, position.z);
  }
}

void MovingStage::RestLights()
{
  for (std::size_t i = 0; i < this->lights.size(); ++i)
  {
    const Placement& placement = this->lights[i];
    vtkLight* light = this->stage.Lights()[i];
    light->SetPosition(placement.position.x, placement.position.y, placement.position.z);
    light->SetFocalPoint(placement.focalPoint.x, placement.focalPoint.y, placement.focalPoint.z);
  }
}

double RenderMilliseconds(Stage& stage)
{
  const auto begin = std::chrono::steady_clock::now();
  stage.Window().Render();
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
  return taken.count();
}

double WorkClock::Seconds() const
{
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - this->begin;
  const double worked = static_cast<double>(std::clock() - this->processorBegin) / CLOCKS_PER_SEC;
  return std::min(taken.count(), worked);
}

void SettleChoice(Stage& stage, const std::function<void()>& move)
{
  stage.ShowShadows(true);
  int settled = 0;
  auto begin = std::chrono::steady_clock::now();
  const auto hasRested = [&]()
  {
    const std::chrono::duration<double> rest = std::chrono::steady_clock::now() - begin;
    return settled >= FramesOfRest ||
      (settled >= FewestFramesOfRest && rest.count() > SecondsOfRest);
  };
  for (int i = 0; i < MostFramesOfChoice && !hasRested(); ++i)
  {
    move();
    stage.Window().Render();
    const bool isSettled = i >= FewestFramesOfChoice && stage.Shadows()->GetChoiceIsSettled();
    begin = isSettled ? begin : std::chrono::steady_clock::now();
    settled = isSettled ? settled + 1 : 0;
  }
}

}
