// A setting among those of one scene, which are timed in turn, in short visits.
#ifndef vtkshadows_BenchEntrant_h
#define vtkshadows_BenchEntrant_h

#include "BenchPlan.h"
#include "TimingRounds.h"

#include <nlohmann/json.hpp>

#include <vtkSmartPointer.h>

#include <cstdint>

class vtkRenderPass;
class vtkShadowPass;

namespace vtkshadows
{

class Stage;

using BenchJson = nlohmann::ordered_json;

class BenchEntrant
{
public:
  BenchEntrant(Stage& stage, const BenchRun& run);
  // Lets go of the GPU, as Drop does.
  ~BenchEntrant();
  BenchEntrant(const BenchEntrant&) = delete;
  BenchEntrant& operator=(const BenchEntrant&) = delete;

  const BenchRun& Run() const { return this->run; }
  // The peer, or nullptr where it is a setting of the shadow pass.
  vtkRenderPass* Peer() const { return this->peer; }

  // Its pass on the stage, as it was left; made anew after Drop.
  void Show();
  // Lets go of its pass; the next Show makes it anew, which takes a visit longer, but not its
  // times.
  void Drop();
  // What its pass holds, bytes, as far as it tells.
  std::int64_t Memory() const;

  // A single frame of each kind after one that is not timed, for what is slow: what the first of
  // them costs more than another counts little there. `still`: that one, which was timed before.
  void TimeOnce(double still);
  // A visit: after frames that warm up, so many of each kind; a round of their medians. Throws
  // Failure.
  void Visit(const TimingPlan& plan);
  // Whether another visit would tell little, or cost too much.
  bool IsTimed(const TimingPlan& plan) const;

  const TimingRounds& Rounds() const { return this->rounds; }

  // Of all visits, but for what "auto" settled in, in the first of them.
  double VisitSeconds() const { return this->visitSeconds; }
  double SettlingSeconds() const { return this->settlingSeconds; }

  BenchJson row;      // what is known of it so far
  bool isKept = true; // whether its pass stays from visit to visit

private:
  Stage& stage;
  BenchRun run;
  vtkSmartPointer<vtkShadowPass> pass;
  vtkSmartPointer<vtkRenderPass> peer;
  TimingRounds rounds;
  double visitSeconds = 0.0; // as WorkClock counts them
  double settlingSeconds = 0.0;
  bool isTimedOnce = false;
};

// Why "auto" chose what it did in the last frame, a text a light.
BenchJson ExplanationsOf(Stage& stage);

}

#endif
