#include "FrameTimings.h"

#include "Progress.h"
#include "Stage.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkShadowPass.h>
#include <vtkStringArray.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <vector>

namespace vtkshadows
{
namespace
{

constexpr int DefaultRounds = 15;
constexpr int FewestRounds = 3;

// For "auto" to notice what moves, and to make its choice.
constexpr int FewestFramesOfChoice = 4;
constexpr int MostFramesOfChoice = 200;
// Frames in a row that it has stayed as it is: a measure may unsettle it.
constexpr int FramesOfRest = 10;

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

double Quantile(std::vector<double> values, double share)
{
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const std::size_t low = static_cast<std::size_t>(at);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (at - static_cast<double>(low)) * (values[high] - values[low]);
}

double Spread(const std::vector<double>& values)
{
  return 0.5 * (Quantile(values, 0.75) - Quantile(values, 0.25));
}

int RoundsFor(const Round& warmUp)
{
  const double slowest = std::max({ warmUp.unshadowed, warmUp.still, warmUp.moving });
  const int affordable = static_cast<int>(DefaultRounds * 1000.0 / std::max(slowest, 1000.0));
  return std::max(affordable, FewestRounds);
}

// One frame of each kind, for what is slow: what the first of them costs more than another counts
// little there.
Round TimeFewFrames(Stage& stage, MovingStage& motion)
{
  Round round;
  stage.ShowShadows(false);
  stage.Window().Render();
  motion.SwingCamera();
  round.unshadowed = RenderMilliseconds(stage);
  stage.ShowShadows(true);
  motion.SwingCamera();
  round.still = RenderMilliseconds(stage);
  motion.CircleLights();
  round.moving = RenderMilliseconds(stage);
  return round;
}

// All that a round draws, the frames that are not timed included.
double RoundSeconds(const Round& round)
{
  return 0.001 * (2.0 * round.unshadowed + 2.0 * round.still + round.moving);
}

int CountOf(const TimingPlan& plan, const Round& warmUp)
{
  if (plan.rounds > 0)
  {
    return plan.rounds;
  }
  return plan.seconds > 0.0 ? static_cast<int>(std::clamp(plan.seconds / RoundSeconds(warmUp),
                                double(FewestRounds), double(DefaultRounds)))
                            : RoundsFor(warmUp);
}

class Rounds
{
public:
  void Add(const Round& round)
  {
    this->unshadowed.push_back(round.unshadowed);
    this->AddStill(round);
    this->AddMoving(round);
  }

  void AddStill(const Round& round)
  {
    this->still.push_back(round.still);
    this->stillRatio.push_back(round.still / round.unshadowed);
    this->stillCost.push_back(round.still - round.unshadowed);
  }

  void AddMoving(const Round& round)
  {
    this->moving.push_back(round.moving);
    this->movingRatio.push_back(round.moving / round.unshadowed);
    this->movingCost.push_back(round.moving - round.unshadowed);
  }

  void AddUnshadowed(double milliseconds) { this->unshadowed.push_back(milliseconds); }

  FrameTimings Medians() const
  {
    FrameTimings timings;
    timings.unshadowedMilliseconds = Median(this->unshadowed);
    timings.staticMilliseconds = Median(this->still);
    timings.movingMilliseconds = Median(this->moving);
    timings.staticRatio = Median(this->stillRatio);
    timings.movingRatio = Median(this->movingRatio);
    timings.staticCost = Median(this->stillCost);
    timings.movingCost = Median(this->movingCost);
    timings.staticSpread = Spread(this->still);
    timings.movingSpread = Spread(this->moving);
    timings.rounds = static_cast<int>(this->still.size());
    return timings;
  }

private:
  std::vector<double> unshadowed, still, moving;
  std::vector<double> stillRatio, movingRatio, stillCost, movingCost;
};

bool HasChoice(Stage& stage)
{
  vtkShadowPass* shadows = stage.Shadows();
  return std::any_of(stage.Lights().begin(), stage.Lights().end(),
    [shadows](vtkLight* light) { return shadows->GetLightTechnique(light) == "auto"; });
}

// "auto" chooses otherwise while lights move: frames of each kind in a row of their own, once the
// choice is made, and turn by turn with those without shadows.
void TimeChoice(
  Stage& stage, MovingStage& motion, const TimingPlan& plan, Rounds& rounds, Progress& progress)
{
  const auto swing = [&motion]() { motion.SwingCamera(); };
  const auto circle = [&motion]() { motion.CircleLights(); };
  const auto pair = [&stage, &motion, &swing](const std::function<void()>& move)
  {
    Round round;
    stage.ShowShadows(false);
    swing();
    stage.Window().Render();
    swing();
    round.unshadowed = RenderMilliseconds(stage);
    stage.ShowShadows(true);
    move();
    stage.Window().Render();
    move();
    round.still = round.moving = RenderMilliseconds(stage);
    return round;
  };
  vtkshadows::SettleChoice(stage, swing);
  const int count = CountOf(plan, pair(swing));
  for (int i = 0; i < count; ++i)
  {
    progress.Update(0.5 * i / count);
    const Round round = pair(swing);
    rounds.AddUnshadowed(round.unshadowed);
    rounds.AddStill(round);
  }
  motion.RestCamera();
  vtkshadows::SettleChoice(stage, circle);
  for (int i = 0; i < count; ++i)
  {
    progress.Update(0.5 + 0.5 * i / count);
    rounds.AddMoving(pair(circle));
  }
  motion.RestLights();
}

}

void SettleChoice(Stage& stage, const std::function<void()>& move)
{
  stage.ShowShadows(true);
  int settled = 0;
  for (int i = 0; i < MostFramesOfChoice && settled < FramesOfRest; ++i)
  {
    move();
    stage.Window().Render();
    settled = i >= FewestFramesOfChoice && stage.Shadows()->GetChoiceIsSettled() ? settled + 1 : 0;
  }
}

FrameTimings TimeFrames(Stage& stage, const TimingPlan& plan, Progress& progress)
{
  MovingStage motion(stage);
  Rounds rounds;
  if (HasChoice(stage))
  {
    TimeChoice(stage, motion, plan, rounds, progress);
    return rounds.Medians();
  }
  if (plan.rounds == 0 && plan.seconds > 0.0)
  {
    stage.ShowShadows(true);
    if (0.001 * RenderMilliseconds(stage) > plan.seconds)
    {
      rounds.Add(TimeFewFrames(stage, motion));
      return rounds.Medians();
    }
  }
  TimeRound(stage, motion);
  const Round warmUp = TimeRound(stage, motion);
  const int count = CountOf(plan, warmUp);
  for (int i = 0; i < count; ++i)
  {
    progress.Update(static_cast<double>(i) / count);
    rounds.Add(TimeRound(stage, motion));
  }
  return rounds.Medians();
}

//------------------------------------------------------------------------------
namespace
{

struct StageSamples
{
  std::vector<double> seconds;
  std::vector<double> gpuSeconds;
};

using SamplesByStage = std::map<std::string, StageSamples>;

// The stages of one frame that is drawn now; their names in order into `names`.
void SampleFrame(Stage& stage, SamplesByStage& samples, std::vector<std::string>& names)
{
  stage.Window().Render();
  vtkNew<vtkStringArray> stages;
  stage.Shadows()->GetStageNames(stages);
  names.clear();
  for (vtkIdType i = 0; i < stages->GetNumberOfValues(); ++i)
  {
    const std::string name = stages->GetValue(i);
    names.push_back(name);
    samples[name].seconds.push_back(stage.Shadows()->GetStageSeconds(name));
    samples[name].gpuSeconds.push_back(stage.Shadows()->GetStageGPUSeconds(name));
  }
}

double MedianMilliseconds(const std::vector<double>& seconds)
{
  if (seconds.empty())
  {
    return -1.0;
  }
  const double median = Median(seconds);
  return median < 0.0 ? -1.0 : 1000.0 * median;
}

}

std::vector<StageTimings> TimeStages(Stage& stage)
{
  constexpr int Frames = 3;
  MovingStage motion(stage);
  SamplesByStage still, moving;
  std::vector<std::string> names;
  stage.ShowShadows(true);
  stage.Window().Render();
  stage.Shadows()->SetTimeStages(true);
  for (int i = 0; i < Frames; ++i)
  {
    motion.RestLights();
    motion.SwingCamera();
    stage.Shadows()->SetTimeStages(false);
    stage.Window().Render();
    stage.Shadows()->SetTimeStages(true);
    motion.SwingCamera();
    SampleFrame(stage, still, names);
    motion.CircleLights();
    SampleFrame(stage, moving, names);
  }
  stage.Shadows()->SetTimeStages(false);

  std::vector<StageTimings> timings;
  for (const std::string& name : names)
  {
    timings.push_back(
      { name, MedianMilliseconds(still[name].seconds), MedianMilliseconds(moving[name].seconds),
        MedianMilliseconds(still[name].gpuSeconds), MedianMilliseconds(moving[name].gpuSeconds) });
  }
  return timings;
}

}
