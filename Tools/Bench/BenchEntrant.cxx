#include "BenchEntrant.h"

#include "MovingStage.h"
#include "PeerShadows.h"
#include "Stage.h"
#include "Techniques.h"

#include <vtkLight.h>
#include <vtkRenderPass.h>
#include <vtkRenderer.h>
#include <vtkShadowPass.h>
#include <vtkShadowTechniquePass.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace vtkshadows
{
namespace
{

// Fewest: where the ratios are steady, where they are not.
constexpr int FewestSteadyVisits = 3;
constexpr int FewestVisits = 5;
constexpr int MostVisits = 15;
constexpr int MostFramesOfKind = 5;
constexpr int FramesOfChoice = 3; // of "auto", at least: it has few visits where it settles slowly
// Without shadows, at least: what is slow has a single visit, in which one disturbed frame would
// make the ratio.
constexpr int FramesUnshadowed = 3;

// Shares of the time of a setting: what a visit shall take, about, and how much longer than that
// time the fewest visits may.
constexpr double VisitShare = 0.3;
constexpr double FewestVisitsShare = 4.0;

// To which a ratio is to be known: less than what a figure tells.
constexpr double SteadyShare = 0.02;

// The median of so many frames, after others that are not timed.
double TimeFramesOf(Stage& stage, int warmUp, int frames, const std::function<void()>& move)
{
  for (int i = 0; i < warmUp; ++i)
  {
    move();
    stage.Window().Render();
  }
  std::vector<double> times;
  for (int i = 0; i < frames; ++i)
  {
    move();
    times.push_back(RenderMilliseconds(stage));
  }
  return Median(times);
}

}

BenchEntrant::BenchEntrant(Stage& usedStage, const BenchRun& givenRun)
  : stage(usedStage)
  , run(givenRun)
{
}

BenchEntrant::~BenchEntrant()
{
  this->Drop();
}

void BenchEntrant::Show()
{
  if (this->run.setting.IsPeer())
  {
    if (!this->peer)
    {
      this->peer = MakePeerPass(this->run.setting.resolution);
    }
    this->stage.UsePass(this->peer);
    return;
  }
  const bool isNew = !this->pass;
  if (isNew)
  {
    this->pass = this->stage.MakeShadows(this->run.setting.soft);
    this->run.setting.apply(this->pass);
  }
  this->stage.UseShadows(this->pass);
  if (isNew)
  {
    this->stage.SettleCulling();
  }
}

void BenchEntrant::Drop()
{
  vtkWindow* window = this->stage.Renderer()->GetVTKWindow();
  if (this->pass)
  {
    this->pass->ReleaseGraphicsResources(window);
    this->pass = nullptr;
  }
  if (this->peer)
  {
    this->stage.UsePass(nullptr);
    this->peer->ReleaseGraphicsResources(window);
    this->peer = nullptr;
  }
}

std::int64_t BenchEntrant::Memory() const
{
  constexpr std::int64_t BytesOfDepth = 4;
  if (this->peer)
  {
    const std::int64_t side = this->run.setting.resolution;
    return side * side * BytesOfDepth * static_cast<std::int64_t>(this->stage.Lights().size());
  }
  if (!this->pass)
  {
    return 0;
  }
  std::int64_t bytes = this->pass->GetMergedCasterMemory();
  for (const std::string& name : TechniqueNames())
  {
    vtkShadowTechniquePass* technique = this->pass->GetTechniquePass(name);
    bytes += technique ? technique->GetTextureMemory() + technique->GetCasterMemory() : 0;
  }
  return bytes;
}

void BenchEntrant::TimeOnce(double still)
{
  MovingStage motion(this->stage);
  TimingRound round;
  round.still = still;
  this->stage.ShowShadows(true);
  motion.CircleLights();
  round.moving = RenderMilliseconds(this->stage);
  motion.RestLights();
  this->stage.ShowShadows(false);
  round.unshadowed =
    TimeFramesOf(this->stage, 1, FramesUnshadowed, [&motion]() { motion.SwingCamera(); });
  this->rounds.Add(round);
  this->isTimedOnce = true;
}

void BenchEntrant::Visit(const TimingPlan& plan)
{
  const WorkClock clock;
  double settling = 0.0;
  const bool chooses = this->run.setting.technique == "auto";
  MovingStage motion(this->stage);
  const auto swing = [&motion]() { motion.SwingCamera(); };
  const auto circle = [&motion]() { motion.CircleLights(); };
  int frames = 1;
  if (plan.rounds == 0 && this->rounds.Count() > 0)
  {
    const FrameTimings before = this->rounds.Medians();
    const double each = 0.001 *
      (before.unshadowedMilliseconds + before.staticMilliseconds + before.movingMilliseconds);
    frames =
      static_cast<int>(std::clamp(VisitShare * plan.seconds / each, 1.0, double(MostFramesOfKind)));
  }

  frames = chooses ? std::max(frames, FramesOfChoice) : frames;
  const auto settle = [&](const std::function<void()>& move)
  {
    const WorkClock own;
    SettleChoice(this->stage, move);
    settling += own.Seconds();
  };

  // The first frame of each kind looks its shaders up again, or draws what is kept for a light that
  // stands.
  TimingRound round;
  this->Show();
  this->stage.ShowShadows(false);
  round.unshadowed = TimeFramesOf(this->stage, 1, std::max(frames, FramesUnshadowed), swing);
  this->stage.ShowShadows(true);
  if (chooses)
  {
    settle(swing);
  }
  round.still = TimeFramesOf(this->stage, 1, frames, swing);
  motion.RestCamera();
  if (chooses)
  {
    settle(circle);
  }
  round.moving = TimeFramesOf(this->stage, 1, frames, circle);
  if (chooses)
  {
    this->row["explanations_moving"] = ExplanationsOf(this->stage);
  }
  motion.RestLights();
  this->rounds.Add(round);
  // What it took to settle is of the first visit alone.
  if (this->rounds.Count() == 1)
  {
    this->settlingSeconds = settling;
  }
  this->visitSeconds += clock.Seconds() - (this->rounds.Count() == 1 ? settling : 0.0);
}

//------------------------------------------------------------------------------
BenchJson ExplanationsOf(Stage& stage)
{
  BenchJson explanations = BenchJson::array();
  for (vtkLight* light : stage.Lights())
  {
    explanations.push_back(stage.Shadows()->GetExplanation(light));
  }
  return explanations;
}

//------------------------------------------------------------------------------
bool BenchEntrant::IsTimed(const TimingPlan& plan) const
{
  const int count = this->rounds.Count();
  if (plan.rounds > 0 || this->isTimedOnce || count == 0)
  {
    return this->isTimedOnce || (plan.rounds > 0 && count >= plan.rounds);
  }
  const double visit = this->visitSeconds / count;
  const int fewest = static_cast<int>(
    std::clamp(FewestVisitsShare * plan.seconds / visit, 1.0, double(FewestVisits)));
  const bool isSteady =
    count >= std::min(fewest, FewestSteadyVisits) && this->rounds.AreSteady(SteadyShare);
  const bool isSpent = count >= MostVisits || this->visitSeconds + visit > plan.seconds;
  return isSteady || (count >= fewest && isSpent);
}

}
