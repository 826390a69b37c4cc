// What shadows cost: the times of frames with and without them, taken turn by turn.
#ifndef vtkshadows_FrameTimings_h
#define vtkshadows_FrameTimings_h

#include <functional>
#include <string>
#include <vector>

namespace vtkshadows
{

class Progress;
class Stage;

// Medians over the rounds. Static: the camera moves and the lights do not; moving: the lights move
// every frame. A ratio is the median of each round's own, over its unshadowed frame, and a cost the
// median of each round's own difference from it. A spread is half the distance between the
// quartiles.
struct FrameTimings
{
  double unshadowedMilliseconds = 0.0;
  double staticMilliseconds = 0.0;
  double movingMilliseconds = 0.0;
  double staticRatio = 0.0;
  double movingRatio = 0.0;
  double staticCost = 0.0; // milliseconds, as the following
  double movingCost = 0.0;
  double staticSpread = 0.0;
  double movingSpread = 0.0;
  int rounds = 0;
};

// How often. `rounds` 0: as many as take `seconds`, 3 to 15; 0 of both: 15, or fewer (at least 3)
// where a frame takes longer than a second. With `seconds`, where one frame takes longer than that,
// a single one of each kind is the answer.
struct TimingPlan
{
  int rounds = 0;
  double seconds = 0.0;
};

// Draws frames until "auto" has chosen; `move` comes before each.
void SettleChoice(Stage& stage, const std::function<void()>& move);

// The camera, the lights and the pass are afterwards what they were.
FrameTimings TimeFrames(Stage& stage, const TimingPlan& plan, Progress& progress);

// Of a stage of the frame, milliseconds, medians of a few frames; below 0 what the driver does not
// tell.
struct StageTimings
{
  std::string name;
  double staticMilliseconds = 0.0;
  double movingMilliseconds = 0.0;
  double staticGpuMilliseconds = -1.0;
  double movingGpuMilliseconds = -1.0;
};

// Where the shadow pass's time goes; the same holds of the camera and the lights.
std::vector<StageTimings> TimeStages(Stage& stage);

}

#endif
