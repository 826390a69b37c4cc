// What rounds of timing say together.
#ifndef vtkshadows_TimingRounds_h
#define vtkshadows_TimingRounds_h

#include <vector>

namespace vtkshadows
{

double Median(std::vector<double> values);
// Half the distance between the quartiles.
double Spread(std::vector<double> values);

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
  double staticRatioSpread = 0.0;
  double movingRatioSpread = 0.0;
  int rounds = 0;
};

// One frame of each kind, or the medians of a few, milliseconds.
struct TimingRound
{
  double unshadowed = 0.0;
  double still = 0.0;
  double moving = 0.0;

  double Sum() const { return this->unshadowed + this->still + this->moving; }
};

class TimingRounds
{
public:
  void Add(const TimingRound& round);
  // Of rounds that have no frame of the other kind.
  void AddStill(double unshadowed, double still);
  void AddMoving(double unshadowed, double moving);

  int Count() const { return static_cast<int>(this->still.size()); }
  FrameTimings Medians() const; // of one round at least
  // Whether the medians of both ratios are known to a share of their own: their standard errors, as
  // their spreads tell them, are at most that. Not of less than three rounds.
  bool AreSteady(double share) const;

private:
  std::vector<double> unshadowed, still, moving;
  std::vector<double> stillRatio, movingRatio, stillCost, movingCost;
};

}

#endif
