// Which of several ways to draw a frame is the fastest, told by drawing by them. Plain C++, no VTK,
// no OpenGL.
#ifndef vtkshadows_FrameTrials_h
#define vtkshadows_FrameTrials_h

#include "TechniqueChoice.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace vtkshadows
{

// A way to draw the frame: a setting for each light.
struct FrameWay
{
  std::vector<ShadowSetting> settings;
  double error = 0.0;   // percent, the worst of the lights; of exact ones 0
  bool isRight = true;  // every light within the budget
  double cost = 0.0;    // expected, in frames without shadows: for the order, and until it is timed
  double atLeast = 0.0; // seconds that it is known to take at least
};

// Which of several ways the coming frame is drawn by. The cheapest to be expected is first; each of
// those that may be the fastest then draws a few frames, which are timed (one that is far slower
// than another only the first of them), and those that are near to the fastest a few more, later,
// so that what else a machine does for a while decides nothing. It stays until the ways change, or
// until a frame now and then takes far longer or shorter.
class FrameTrials
{
public:
  // Times of ways that there were already, and the choice among them, are kept.
  void SetWays(const std::vector<FrameWay>& ways, const ShadowBudget& budget);
  // Forget all times.
  void Restart();
  // Whether the fastest is to be timed though it is the only way.
  void SetTimesOnlyWay(bool times);

  std::size_t Current() const { return this->Chosen; }
  const FrameWay& Way() const { return this->Ways[this->Chosen]; }
  // Whether the coming frame is to be timed.
  bool WantsTime() const;
  // A frame by the current way is drawn, in so many seconds if it was timed.
  void FrameDrawn(std::optional<double> seconds);
  bool IsSettled() const { return this->Settled; }
  // The least that was timed.
  std::optional<double> SecondsOf(std::size_t way) const;
  // Of the ways that were timed; infinite, if none was.
  double LeastSeconds() const;
  // Whether what takes so long at least has lost already: against the fastest that was timed, or,
  // with a budget of time alone, against that.
  bool HasLost(double seconds) const;
  const std::vector<FrameWay>& GetWays() const { return this->Ways; }

private:
  struct Timing
  {
    int frames = 0; // drawn in a row, the first of which are not counted
    int timed = 0;  // in this row
    int rows = 0;   // that are done
    double seconds = 0.0;
  };
  bool IsDone(std::size_t way) const;
  double CostOfFastest() const;
  bool IsPromising(std::size_t way) const;
  std::size_t Best() const;
  void Advance();

  std::vector<FrameWay> Ways;
  std::vector<Timing> Timings; // of each way
  // Of ways that there were, for when they are there again.
  std::vector<std::pair<std::vector<ShadowSetting>, Timing>> Past;
  ShadowBudget Budget;
  std::size_t Chosen = 0;
  std::vector<ShadowSetting> InUse; // what was settled on last
  bool Settled = false;
  bool TimesOnlyWay = false;
  int SinceSettled = 0; // frames
  int Strange = 0;      // timed frames in a row that took far longer or shorter
};

}

#endif
