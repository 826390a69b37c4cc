// What shadows cost: the times of frames with and without them, taken turn by turn.
#ifndef vtkshadows_FrameTimings_h
#define vtkshadows_FrameTimings_h

namespace vtkshadows
{

class Progress;
class Stage;

// Medians over the rounds. Static: the camera moves and the lights do not; moving: the lights move
// every frame. A ratio is the median of each round's own, over its unshadowed frame.
struct FrameTimings
{
  double unshadowedMilliseconds = 0.0;
  double staticMilliseconds = 0.0;
  double movingMilliseconds = 0.0;
  double staticRatio = 0.0;
  double movingRatio = 0.0;
};

// `rounds` 0: 15, or fewer (at least 3) where a frame takes longer than a second. The camera, the
// lights and the pass are afterwards what they were.
FrameTimings TimeFrames(Stage& stage, int rounds, Progress& progress);

}

#endif
