#include "FrameTrials.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vtkshadows
{
namespace
{

// Frames of a way that are drawn before one is counted (shaders are compiled, maps drawn), and that
// are counted. The least of them is kept: what else runs on a machine only ever adds.
constexpr int FramesBefore = 1;
constexpr int FramesCounted = 3;
// Rows of such frames, and times the fastest from which on a way has lost after one.
constexpr int MostRows = 2;
constexpr double LosingRatio = 1.6;
// Times the fastest from which on the first frame that is timed ends a row: its way has lost.
constexpr double LosingRatioAtOnce = 2.0;
// The same for one that is known to take so long at least, and need not be drawn for it.
constexpr double LosingRatioUnseen = 2.0;
// How much faster a way must be than one that is expected to cost less, or that is in use.
constexpr double ClearlyFaster = 0.95;
// A way expected to cost more than this times the fastest is not tried.
constexpr double NotPromising = 4.0;
// Once settled, one frame in so many is timed; that many strange ones in a row begin it all anew.
constexpr int FramesBetweenChecks = 32;
constexpr int StrangeChecks = 2;
constexpr double StrangeRatio = 1.7;
// Ways whose times are kept though they are not there now.
constexpr std::size_t MostPastWays = 32;

}

//------------------------------------------------------------------------------
double FrameTrials::LeastSeconds() const
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < this->Ways.size(); ++i)
  {
    if (this->Ways[i].isRight && this->Timings[i].rows > 0)
    {
      least = std::min(least, this->Timings[i].seconds);
    }
  }
  return least;
}

// Expected, of the fastest that was timed; of all, if none was.
double FrameTrials::CostOfFastest() const
{
  const double least = this->LeastSeconds();
  double cost = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < this->Ways.size(); ++i)
  {
    const Timing& timing = this->Timings[i];
    const bool isIt = std::isinf(least) || (timing.rows > 0 && timing.seconds <= least);
    cost = this->Ways[i].isRight && isIt ? std::min(cost, this->Ways[i].cost) : cost;
  }
  return cost;
}

bool FrameTrials::IsDone(std::size_t way) const
{
  const Timing& timing = this->Timings[way];
  const bool byAccuracy = this->Budget.IsOfTimeAlone();
  const double limit = byAccuracy ? *this->Budget.maximumSeconds : 0.0;
  if (timing.rows == 0 || timing.rows >= MostRows)
  {
    return timing.rows > 0;
  }
  // What was expected to be no dearer than the fastest has another chance: the machine may have
  // been busy. How far a time is within a limit does not matter.
  const bool hasLost = timing.seconds > LosingRatio * std::max(this->LeastSeconds(), limit);
  return LosingRatio * timing.seconds < limit ||
    (hasLost && (byAccuracy || this->Ways[way].cost > this->CostOfFastest()));
}

//------------------------------------------------------------------------------
void FrameTrials::SetWays(const std::vector<FrameWay>& ways, const ShadowBudget& budget)
{
  const bool sameBudget = budget.maximumError == this->Budget.maximumError &&
    budget.maximumSeconds == this->Budget.maximumSeconds;
  this->Budget = budget;
  const auto sameSettings = [](const FrameWay& a, const FrameWay& b)
  { return a.settings == b.settings; };
  if (sameBudget && this->Ways.size() == ways.size() &&
    std::equal(ways.begin(), ways.end(), this->Ways.begin(), sameSettings))
  {
    this->Ways = ways; // errors may be others
    if (!this->Way().isRight)
    {
      this->Settled = false;
      this->Chosen = this->Best();
      this->Advance();
    }
    return;
  }

  const std::vector<ShadowSetting> chosen =
    this->Ways.empty() ? std::vector<ShadowSetting>() : this->Way().settings;
  for (std::size_t i = 0; i < this->Ways.size(); ++i)
  {
    const auto past = std::find_if(this->Past.begin(), this->Past.end(),
      [&](const auto& known) { return known.first == this->Ways[i].settings; });
    if (past != this->Past.end())
    {
      past->second = this->Timings[i];
    }
    else if (this->Past.size() < MostPastWays)
    {
      this->Past.emplace_back(this->Ways[i].settings, this->Timings[i]);
    }
  }
  this->Ways = ways;
  this->Timings.assign(ways.size(), {});
  this->Settled = false;
  bool isKept = false;
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    const auto past = std::find_if(this->Past.begin(), this->Past.end(),
      [&](const auto& known) { return known.first == ways[i].settings; });
    this->Timings[i] = past != this->Past.end() ? past->second : Timing();
    if (ways[i].isRight && ways[i].settings == chosen)
    {
      this->Chosen = i;
      isKept = true;
    }
  }
  if (!isKept)
  {
    this->Chosen = this->Best();
  }
  this->Advance();
}

void FrameTrials::Restart()
{
  this->Timings.assign(this->Ways.size(), {});
  this->Past.clear();
  this->Settled = false;
  this->SinceSettled = 0;
  this->Strange = 0;
}

//------------------------------------------------------------------------------
std::optional<double> FrameTrials::SecondsOf(std::size_t way) const
{
  const Timing& timing = this->Timings[way];
  return timing.seconds > 0.0 ? std::optional<double>(timing.seconds) : std::nullopt;
}

//------------------------------------------------------------------------------
// Whether a way that has not been timed may turn out the best.
bool FrameTrials::IsPromising(std::size_t way) const
{
  return this->Ways[way].isRight &&
    (this->Timings[way].rows > 0 ||
      (this->Ways[way].cost <= NotPromising * this->CostOfFastest() &&
        !this->HasLost(this->Ways[way].atLeast)));
}

bool FrameTrials::HasLost(double seconds) const
{
  const bool byAccuracy = this->Budget.IsOfTimeAlone();
  return seconds > LosingRatioUnseen * this->LeastSeconds() &&
    (!byAccuracy || seconds > *this->Budget.maximumSeconds);
}

void FrameTrials::SetTimesOnlyWay(bool times)
{
  if (times && !this->TimesOnlyWay && this->Ways.size() == 1 && this->Timings[0].rows == 0)
  {
    this->Settled = false;
  }
  this->TimesOnlyWay = times;
}

//------------------------------------------------------------------------------
// Of the ways within the budget of error, all that are known to be: the fastest; with a budget of
// time alone the most accurate that keeps to it.
std::size_t FrameTrials::Best() const
{
  const bool byAccuracy = this->Budget.IsOfTimeAlone();
  const auto rank = [&](std::size_t i)
  {
    const FrameWay& way = this->Ways[i];
    const std::optional<double> seconds = this->SecondsOf(i);
    const bool isSlow =
      seconds && this->Budget.maximumSeconds && *seconds > *this->Budget.maximumSeconds;
    struct Rank
    {
      bool isWrong, isSlow, isUnknown;
      double error, time;
      bool operator<(const Rank& other) const
      {
        return isWrong != other.isWrong  ? !isWrong
          : isSlow != other.isSlow       ? !isSlow
          : isUnknown != other.isUnknown ? !isUnknown
          : error != other.error         ? error < other.error
                                         : time < other.time;
      }
    };
    return Rank{ !way.isRight, isSlow, !seconds,
      way.isRight ? (byAccuracy && !isSlow ? way.error : 0.0) : way.error,
      seconds ? *seconds : way.cost };
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < this->Ways.size(); ++i)
  {
    best = rank(i) < rank(best) ? i : best;
  }
  return best;
}

//------------------------------------------------------------------------------
// Once a row of the current way is done, the next way to be timed, the one with the fewest rows; or
// the best, if all are done.
void FrameTrials::Advance()
{
  if (this->Settled)
  {
    return;
  }
  // What is the only way need not be timed.
  const bool isOnly = this->Ways.size() == 1 && !this->Budget.maximumSeconds &&
    (!this->TimesOnlyWay || this->Timings[0].rows > 0);
  std::optional<std::size_t> next;
  for (std::size_t i = 0; !isOnly && i < this->Ways.size(); ++i)
  {
    const auto rank = [&](std::size_t way)
    { return std::make_pair(this->Timings[way].rows, this->Ways[way].cost); };
    if (!this->IsDone(i) && this->IsPromising(i) && (!next || rank(i) < rank(*next)))
    {
      next = i;
    }
  }
  if (next)
  {
    this->Chosen = *next;
    this->Timings[*next].frames = 0;
    this->Timings[*next].timed = 0;
    return;
  }
  // Of those nearly as fast the one that was in use, or that is expected to cost the least: a noise
  // decides nothing.
  const std::size_t best = this->Best();
  std::size_t taken = best;
  bool wasInUse = false;
  for (std::size_t i = 0; !this->Budget.maximumSeconds && i < this->Ways.size(); ++i)
  {
    const std::optional<double> seconds = this->SecondsOf(i);
    const std::optional<double> least = this->SecondsOf(best);
    const bool isInUse = this->Ways[i].settings == this->InUse;
    if (this->Ways[i].isRight && seconds && least && ClearlyFaster * *seconds <= *least &&
      !wasInUse && (isInUse || this->Ways[i].cost < this->Ways[taken].cost))
    {
      taken = i;
      wasInUse = isInUse;
    }
  }
  this->Chosen = taken;
  this->InUse = this->Ways[taken].settings;
  this->Settled = true;
  this->SinceSettled = 0;
  this->Strange = 0;
}

//------------------------------------------------------------------------------
bool FrameTrials::WantsTime() const
{
  if (this->Ways.empty())
  {
    return false;
  }
  if (this->Settled)
  {
    return this->Timings[this->Chosen].seconds > 0.0 && this->Ways.size() > 1 &&
      this->SinceSettled % FramesBetweenChecks == FramesBetweenChecks - 1;
  }
  return this->Timings[this->Chosen].frames >= FramesBefore;
}

void FrameTrials::FrameDrawn(std::optional<double> seconds)
{
  if (this->Ways.empty())
  {
    return;
  }
  if (!this->WantsTime())
  {
    seconds.reset();
  }
  Timing& timing = this->Timings[this->Chosen];
  if (this->Settled)
  {
    // A strange frame is followed by another look at the next.
    ++this->SinceSettled;
    if (seconds && timing.seconds > 0.0)
    {
      const double ratio = *seconds / timing.seconds;
      const bool isStrange = ratio > StrangeRatio || ratio < 1.0 / StrangeRatio;
      this->Strange = isStrange ? this->Strange + 1 : 0;
      this->SinceSettled = isStrange ? FramesBetweenChecks - 1 : 0;
      if (this->Strange > StrangeChecks)
      {
        this->Restart();
      }
    }
    return;
  }
  ++timing.frames;
  if (seconds)
  {
    timing.seconds = timing.seconds > 0.0 ? std::min(timing.seconds, *seconds) : *seconds;
    ++timing.timed;
    const bool hasLost = timing.rows == 0 && *seconds > LosingRatioAtOnce * this->LeastSeconds();
    if (timing.timed >= FramesCounted || hasLost)
    {
      ++timing.rows;
      timing.timed = 0;
      timing.frames = 0;
      this->Advance();
    }
  }
}

}
