#include "FrameTimings.h"

#include "Progress.h"
#include "Stage.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace vtkshadows
{
namespace
{

constexpr int DefaultRounds = 15;
constexpr int FewestRounds = 3;

// Of one frame. The camera swings to and fro by degrees; lights circle by a share of the scene.
constexpr double CameraStep = 0.4;
constexpr int CameraSteps = 10;
constexpr double LightCircle = 0.01;
constexpr double LightStep = 0.7; // radians

struct Placement
{
  glm::dvec3 position{ 0.0 };
  glm::dvec3 focalPoint{ 0.0 };
};

// Moves the camera and the lights of a stage, and puts all back when it goes.
class MovingStage
{
public:
  explicit MovingStage(Stage& stage);
  ~MovingStage();
  MovingStage(const MovingStage&) = delete;
  MovingStage& operator=(const MovingStage&) = delete;

  void SwingCamera();
  void RestCamera();
  void CircleLights();
  void RestLights();

private:
  Stage& stage;
  vtkNew<vtkCamera> camera;
  std::vector<Placement> lights;
  int cameraFrame = 0;
  int lightFrame = 0;
};

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
  this->stage.Renderer()->GetActiveCamera()->DeepCopy(this->camera);
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

double Median(std::vector<double> values)
{
  const std::size_t middle = values.size() / 2;
  std::sort(values.begin(), values.end());
  return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

// One frame of each kind, milliseconds. Turning the pass on or off has VTK look its shaders up
// again, so the frame after it is not timed.
struct Round
{
  double unshadowed = 0.0;
  double still = 0.0;
  double moving = 0.0;
};

Round TimeRound(Stage& stage, MovingStage& motion)
{
  Round round;
  stage.ShowShadows(false);
  motion.SwingCamera();
  stage.Window().Render();
  motion.SwingCamera();
  round.unshadowed = RenderMilliseconds(stage);

  stage.ShowShadows(true);
  motion.SwingCamera();
  stage.Window().Render();
  motion.SwingCamera();
  round.still = RenderMilliseconds(stage);

  motion.RestCamera();
  motion.CircleLights();
  round.moving = RenderMilliseconds(stage);
  motion.RestLights();
  return round;
}

int RoundsFor(const Round& warmUp)
{
  const double slowest = std::max({ warmUp.unshadowed, warmUp.still, warmUp.moving });
  const int affordable = static_cast<int>(DefaultRounds * 1000.0 / std::max(slowest, 1000.0));
  return std::max(affordable, FewestRounds);
}

}

FrameTimings TimeFrames(Stage& stage, int rounds, Progress& progress)
{
  MovingStage motion(stage);
  TimeRound(stage, motion);
  const Round warmUp = TimeRound(stage, motion);
  const int count = rounds > 0 ? rounds : RoundsFor(warmUp);

  std::vector<double> unshadowed, still, moving, stillRatio, movingRatio;
  for (int i = 0; i < count; ++i)
  {
    progress.Update(static_cast<double>(i) / count);
    const Round round = TimeRound(stage, motion);
    unshadowed.push_back(round.unshadowed);
    still.push_back(round.still);
    moving.push_back(round.moving);
    stillRatio.push_back(round.still / round.unshadowed);
    movingRatio.push_back(round.moving / round.unshadowed);
  }
  return { Median(unshadowed), Median(still), Median(moving), Median(stillRatio),
    Median(movingRatio) };
}

}
