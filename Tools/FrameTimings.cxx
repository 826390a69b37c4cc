#include "FrameTimings.h"

#include "MovingStage.h"
#include "Progress.h"
#include "Stage.h"

#include <vtkNew.h>
#include <vtkShadowPass.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace vtkshadows
{
namespace
{

constexpr int DefaultRounds = 15;
constexpr int FewestRounds = 3;

// Turning the pass on or off has VTK look its shaders up again, so the frame after it is not timed.
TimingRound TimeRound(Stage& stage, MovingStage& motion)
{
  TimingRound round;
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

int CountOf(int rounds, const TimingRound& warmUp)
{
  if (rounds > 0)
  {
    return rounds;
  }
  const double slowest = std::max({ warmUp.unshadowed, warmUp.still, warmUp.moving });
  const int affordable = static_cast<int>(DefaultRounds * 1000.0 / std::max(slowest, 1000.0));
  return std::max(affordable, FewestRounds);
}

// "auto" chooses otherwise while lights move: frames of each kind in a row of their own, once the
// choice is made, and turn by turn with those without shadows.
void TimeChoice(
  Stage& stage, MovingStage& motion, int wanted, TimingRounds& rounds, Progress& progress)
{
  const auto swing = [&motion]() { motion.SwingCamera(); };
  const auto circle = [&motion]() { motion.CircleLights(); };
  const auto pair = [&stage, &motion, &swing](const std::function<void()>& move)
  {
    TimingRound round;
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
  SettleChoice(stage, swing);
  const int count = CountOf(wanted, pair(swing));
  for (int i = 0; i < count; ++i)
  {
    progress.Update(0.5 * i / count);
    const TimingRound round = pair(swing);
    rounds.AddStill(round.unshadowed, round.still);
  }
  motion.RestCamera();
  SettleChoice(stage, circle);
  for (int i = 0; i < count; ++i)
  {
    progress.Update(0.5 + 0.5 * i / count);
    const TimingRound round = pair(circle);
    rounds.AddMoving(round.unshadowed, round.moving);
  }
  motion.RestLights();
}

}

FrameTimings TimeFrames(Stage& stage, int wantedRounds, Progress& progress)
{
  MovingStage motion(stage);
  TimingRounds rounds;
  if (stage.IsChosen())
  {
    TimeChoice(stage, motion, wantedRounds, rounds, progress);
    return rounds.Medians();
  }
  TimeRound(stage, motion);
  const int count = CountOf(wantedRounds, TimeRound(stage, motion));
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

std::vector<StageTimings> TimeStages(Stage& stage, int frames)
{
  MovingStage motion(stage);
  SamplesByStage still, moving;
  std::vector<std::string> names;
  stage.ShowShadows(true);
  for (int i = 0; i < frames; ++i)
  {
    motion.RestLights();
    motion.SwingCamera();
    stage.Shadows()->SetTimeStages(false);
    stage.Window().Render();
    stage.Shadows()->SetTimeStages(true);
    motion.SwingCamera();
    SampleFrame(stage, still, names);
    motion.CircleLights();
    if (i == 0)
    {
      stage.Window().Render(); // some things are made once a caster is drawn again
      motion.CircleLights();
    }
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
