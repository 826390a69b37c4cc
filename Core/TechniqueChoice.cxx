#include "TechniqueChoice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

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
constexpr double HasLost = 1.6;
// How much faster a way must be than one that is expected to cost less.
constexpr double ClearlyFaster = 0.9;
// A way expected to cost more than this times the fastest known is not tried.
constexpr double NotPromising = 4.0;
// Once settled, one frame in so many is timed; that many strange ones in a row begin it all anew.
constexpr int FramesBetweenChecks = 32;
constexpr int StrangeChecks = 2;
constexpr double StrangeRatio = 1.7;
// Ways whose times are kept though they are not there now.
constexpr std::size_t MostPastWays = 32;

std::string NumberText(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, value >= 100.0 ? "%.0f" : "%.2g", value);
  return text;
}

std::string JoinedText(const std::vector<std::string>& parts, const char* last)
{
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 == parts.size() ? last : ", ") + parts[i];
  }
  return text;
}

bool SoftensBy(const ShadowSetting& setting)
{
  return setting.technique != "depth-map" || setting.filter == "soft" ||
    setting.filter == "sample-lights";
}

// Why rays and volumes, which stand on surfaces, do not cast as the scene does; empty: they do.
std::string BeyondSurfaces(const SceneNeeds& scene, const std::string& notTheirs)
{
  return !notTheirs.empty() ? notTheirs + " cast"
    : scene.hasHoles        ? "casters have holes by texture or shader"
    : scene.castsByOpacity  ? "translucent props cast by their opacity"
                            : "";
}

}

//------------------------------------------------------------------------------
std::string ShadowSetting::Text() const
{
  if (!this->IsMap())
  {
    return this->technique;
  }
  return this->technique + " (" + std::to_string(this->resolution) + " texels" +
    (this->cascades > 1 ? ", " + std::to_string(this->cascades) + " cascades" : "") +
    (this->filter.empty() || this->filter == "percentage-closer" ? ""
                                                                 : ", filter " + this->filter) +
    ")";
}

//------------------------------------------------------------------------------
bool HasTruth(const SceneNeeds& scene, std::string* why)
{
  std::string reason =
    scene.hasRays ? BeyondSurfaces(scene, scene.notHitByRays) : "this build has no ray cast";
  if (reason.empty() && scene.hasStandIns)
  {
    reason = "stand-ins cast, which the truth does not know";
  }
  if (why)
  {
    *why = reason;
  }
  return reason.empty();
}

//------------------------------------------------------------------------------
Standing StandingOf(const ShadowSetting& setting, const SceneNeeds& scene, const LightNeeds& light)
{
  const std::string& name = setting.technique;
  if (name == "depth-map")
  {
    if (light.isSoft && !SoftensBy(setting))
    {
      return { Standing::Unfit, "the light has a radius" };
    }
    Standing standing;
    standing.kind = HasTruth(scene, &standing.why) ? Standing::Measured : Standing::Assumed;
    return standing;
  }
  if (scene.receivesTranslucent)
  {
    return { Standing::Unfit, "translucent props receive" };
  }
  if (name == "planar")
  {
    return !scene.receivesFlat ? Standing{ Standing::Unfit, "not all that receives is flat" }
                               : Standing{ Standing::Exact, "" };
  }
  const bool byRays = name == "ray-cast";
  if (byRays && (!scene.hasRays || scene.hasStandIns))
  {
    return { Standing::Unfit,
      scene.hasRays ? "stand-ins cast, which rays do not know" : "this build has none" };
  }
  const std::string beyond =
    BeyondSurfaces(scene, byRays ? scene.notHitByRays : scene.notTriangles);
  if (!beyond.empty())
  {
    return { Standing::Unfit, beyond };
  }
  return { Standing::Exact, "" };
}

//------------------------------------------------------------------------------
ErrorPercents ErrorPercents::Of(const VisibilityError& error, bool isSampled)
{
  return { error.MismatchPercent(), error.GrossPercent(), 100.0 * error.MeanAbsoluteDifference(),
    isSampled ? static_cast<double>(error.receiverPixels) : 0.0 };
}

//------------------------------------------------------------------------------
bool IsWithin(const ShadowBudget& budget, const ErrorPercents& error, bool isSoft, double margin)
{
  if (budget.maximumError)
  {
    // Of a count of pixels, whose variance is the count.
    const double percentOfOne = error.sampled > 0.0 && !isSoft ? 100.0 / error.sampled : 0.0;
    const double figure = error.Figure(isSoft);
    return margin * figure + 2.0 * std::sqrt(figure * percentOfOne) <= *budget.maximumError;
  }
  return margin * error.gross <= MostGrossPercent &&
    (!isSoft || margin * error.meanDifference <= MostSoftDifferencePercent);
}

std::string BudgetText(const ShadowBudget& budget)
{
  return budget.maximumError ? "at most " + NumberText(*budget.maximumError) + " % wrong"
                             : "no gross error";
}

std::string ErrorText(const ErrorPercents& error, const ShadowBudget& budget, bool isSoft)
{
  const bool isOfGross = !budget.maximumError && error.gross > MostGrossPercent;
  return isOfGross ? NumberText(error.gross) + " % gross"
    : isSoft       ? NumberText(error.meanDifference) + " % mean difference"
                   : NumberText(error.mismatch) + " % wrong";
}

std::string SecondsText(double seconds)
{
  char text[32];
  std::snprintf(text, sizeof text, seconds < 0.0995 ? "%.1f ms" : "%.0f ms", 1000.0 * seconds);
  return text;
}

//------------------------------------------------------------------------------
// Of the ways that were timed.
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

bool FrameTrials::IsDone(std::size_t way) const
{
  const Timing& timing = this->Timings[way];
  return timing.rows >= MostRows ||
    (timing.rows > 0 && timing.seconds > HasLost * this->LeastSeconds());
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
  if (!this->Ways[way].isRight)
  {
    return false;
  }
  double cheapest = std::numeric_limits<double>::infinity();
  for (const FrameWay& other : this->Ways)
  {
    cheapest = other.isRight ? std::min(cheapest, other.cost) : cheapest;
  }
  return this->Ways[way].cost <= NotPromising * cheapest;
}

//------------------------------------------------------------------------------
// Of the ways within the budget of error, all that are known to be: the fastest; with a budget of
// time alone the most accurate that keeps to it.
std::size_t FrameTrials::Best() const
{
  const bool byAccuracy = this->Budget.maximumSeconds && !this->Budget.maximumError;
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
  const bool isOnly = this->Ways.size() == 1 && !this->Budget.maximumSeconds;
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
  // Of those nearly as fast the one that is expected to cost the least: a noise decides nothing.
  const std::size_t best = this->Best();
  std::size_t taken = best;
  for (std::size_t i = 0; !this->Budget.maximumSeconds && i < this->Ways.size(); ++i)
  {
    const std::optional<double> seconds = this->SecondsOf(i);
    const std::optional<double> least = this->SecondsOf(best);
    if (this->Ways[i].isRight && seconds && least && ClearlyFaster * *seconds <= *least &&
      this->Ways[i].cost < this->Ways[taken].cost)
    {
      taken = i;
    }
  }
  this->Chosen = taken;
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
    if (timing.timed >= FramesCounted)
    {
      ++timing.rows;
      timing.timed = 0;
      timing.frames = 0;
      this->Advance();
    }
  }
}

//------------------------------------------------------------------------------
std::string Explain(const Reasons& reasons, const ShadowBudget& budget)
{
  std::string text = reasons.setting.Text() + ": ";
  if (reasons.standing.kind == Standing::Exact)
  {
    text += reasons.setting.technique == "ray-cast" ? "traced, which is the truth"
                                                    : "exact for what casts and receives here";
  }
  else if (reasons.error && reasons.error->isOfNothing)
  {
    text += "nothing in view that it lights could be measured";
  }
  else if (reasons.error)
  {
    const ErrorPercents& error = *reasons.error;
    text += (reasons.isSoft ? NumberText(error.meanDifference) + " % mean difference"
                            : NumberText(error.mismatch) + " % wrong") +
      (error.gross > 0.0 ? " and " + NumberText(error.gross) + " % gross" : " and no gross error") +
      " as measured in this view";
  }
  else
  {
    text += "its error is not measured, since " + reasons.standing.why;
  }
  if (!reasons.isRight)
  {
    text += ", more than was asked for (" + BudgetText(budget) +
      "), but nothing that serves this light is nearer";
  }
  else if (reasons.standing.kind != Standing::Assumed)
  {
    text += budget.maximumError ? ", " + BudgetText(budget) + " was asked for" : "";
  }
  if (reasons.seconds)
  {
    text += "; " + SecondsText(*reasons.seconds) + " a frame";
    if (budget.maximumSeconds)
    {
      text += *reasons.seconds > *budget.maximumSeconds
        ? ", more than the " + SecondsText(*budget.maximumSeconds) +
          " asked for: nothing right is faster"
        : ", within the " + SecondsText(*budget.maximumSeconds) + " asked for";
    }
  }
  if (!reasons.others.empty())
  {
    text += reasons.seconds ? ", where " : "; ";
    text += JoinedText(reasons.others, " and ");
  }
  if (!reasons.refused.empty())
  {
    text += "; not " + JoinedText(reasons.refused, ", nor ");
  }
  return text + ".";
}

}
