// What shadows cost: the times of frames with and without them, taken turn by turn.
#ifndef vtkshadows_FrameTimings_h
#define vtkshadows_FrameTimings_h

#include "TimingRounds.h"

#include <string>
#include <vector>

namespace vtkshadows
{

class Progress;
class Stage;

// Of what the stage shows, in so many rounds of one frame of each kind; 0: 15, or fewer (at least
// 3) where a frame takes longer than a second. The camera, the lights and the pass are afterwards
// what they were.
FrameTimings TimeFrames(Stage& stage, int wantedRounds, Progress& progress);

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

// Where the shadow pass's time goes, of so many frames of each kind; the same holds of the camera
// and the lights.
std::vector<StageTimings> TimeStages(Stage& stage, int frames);

}

#endif
