#include "TechniqueChoice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vtkshadows
{
namespace
{

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

// All pixels were measured, and a single one is gross.
bool IsOnePixel(const ErrorPercents& error)
{
  static_assert(MostGrossPixels == 1, "several are not told of as one");
  return !error.isSampled && error.gross > 0.0 &&
    error.gross * error.pixels < 100.0 * (MostGrossPixels + 0.5);
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
  std::vector<std::string> parts;
  if (this->resolution > 0)
  {
    parts.push_back(std::to_string(this->resolution) + " texels");
  }
  if (this->cascades > 1)
  {
    parts.push_back(std::to_string(this->cascades) + " cascades");
  }
  if (!this->filter.empty() && this->filter != "percentage-closer")
  {
    parts.push_back("filter " + this->filter);
  }
  if (this->samples > 0)
  {
    parts.push_back(std::to_string(this->samples) + " samples");
  }
  return this->technique + (parts.empty() ? "" : " (" + JoinedText(parts, ", ") + ")");
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
  else if (reason.empty() && scene.isTooLarge)
  {
    reason = "the casters are too many triangles to trace for it";
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
  Standing measured;
  measured.kind = HasTruth(scene, &measured.why) ? Standing::Measured : Standing::Assumed;
  if (name == "depth-map")
  {
    return light.isSoft && !SoftensBy(setting)
      ? Standing{ Standing::Unfit, "the light has a radius" }
      : measured;
  }
  const bool byRays = name == "ray-cast";
  if (byRays && !scene.hasRays)
  {
    return { Standing::Unfit, "this build has none" };
  }
  const bool isTextured = name == "planar" && setting.resolution > 0;
  if (scene.receivesTranslucent && !isTextured)
  {
    return { Standing::Unfit, "translucent props receive" };
  }
  if (name == "planar" && !scene.receivesFlat)
  {
    return { Standing::Unfit, "not all that receives is flat" };
  }
  if (byRays && scene.hasStandIns)
  {
    return { Standing::Unfit, "stand-ins cast, which rays do not know" };
  }
  const std::string beyond =
    name == "planar" ? "" : BeyondSurfaces(scene, byRays ? scene.notHitByRays : scene.notTriangles);
  if (!beyond.empty())
  {
    return { Standing::Unfit, beyond };
  }
  if (isTextured)
  {
    return measured;
  }
  // Each sample light is exact: how far so many of them are from all is measured, where it can be.
  return light.isSoft && measured.kind == Standing::Measured ? measured
                                                             : Standing{ Standing::Exact, "" };
}

//------------------------------------------------------------------------------
ErrorPercents ErrorPercents::Of(const VisibilityError& error, bool isSampled)
{
  return { error.MismatchPercent(), error.GrossPercent(), 100.0 * error.MeanAbsoluteDifference(),
    100.0 * error.MeanPenumbraDifference(), static_cast<double>(error.receiverPixels), isSampled,
    100.0 * error.penumbraDeviation };
}

//------------------------------------------------------------------------------
bool IsGross(const ErrorPercents& error, double margin)
{
  return !IsOnePixel(error) && margin * error.gross > MostGrossPercent;
}

bool IsWithin(const ShadowBudget& budget, const ErrorPercents& error, bool isSoft, double margin)
{
  if (budget.maximumError)
  {
    // Of a count of pixels, whose variance is the count.
    const double percentOfOne =
      error.isSampled && error.pixels > 0.0 && !isSoft ? 100.0 / error.pixels : 0.0;
    const double figure = error.Figure(isSoft);
    return margin * figure + 2.0 * std::sqrt(figure * percentOfOne) <= *budget.maximumError;
  }
  if (IsGross(error, margin))
  {
    return false;
  }
  const double penumbraMargin = error.isBySampleLights ? 1.0 : margin;
  return isSoft ? margin * error.meanDifference <= MostSoftDifferencePercent &&
      penumbraMargin * error.penumbraDifference <= MostPenumbraDifferencePercent
                : margin * error.mismatch <= MostMismatchPercent;
}

bool HangsOnFewPixels(const ErrorPercents& error, bool isSoft)
{
  constexpr double Few = 4.5;
  const bool hangsOnGross = IsGross(error) && 0.01 * error.gross * error.pixels < Few;
  const bool hangsOnPenumbra = isSoft &&
    std::abs(error.penumbraDifference - MostPenumbraDifferencePercent) <
      SureDeviations * error.penumbraDeviation;
  // If these were in its favour.
  ErrorPercents atBest = error;
  atBest.gross = hangsOnGross ? 0.0 : error.gross;
  atBest.penumbraDifference = hangsOnPenumbra ? 0.0 : error.penumbraDifference;
  return error.isSampled && (hangsOnGross || hangsOnPenumbra) &&
    IsWithin({}, atBest, isSoft, ErrorMargin);
}

std::string BudgetText(const ShadowBudget& budget)
{
  return budget.maximumError ? "at most " + NumberText(*budget.maximumError) + " % wrong"
                             : "no gross error";
}

std::string ErrorText(const ErrorPercents& error, const ShadowBudget& budget, bool isSoft)
{
  const bool isOfGross = !budget.maximumError && IsGross(error);
  const bool isOfPenumbra = !budget.maximumError &&
    error.penumbraDifference / MostPenumbraDifferencePercent >=
      error.meanDifference / MostSoftDifferencePercent;
  return isOfGross ? NumberText(error.gross) + " % gross"
    : isSoft && isOfPenumbra
    ? NumberText(error.penumbraDifference) + " % mean difference in the penumbra"
    : isSoft ? NumberText(error.meanDifference) + " % mean difference"
             : NumberText(error.mismatch) + " % wrong";
}

std::string SecondsText(double seconds)
{
  char text[32];
  std::snprintf(text, sizeof text, seconds < 0.0995 ? "%.1f ms" : "%.0f ms", 1000.0 * seconds);
  return text;
}

//------------------------------------------------------------------------------
std::string Explain(const Reasons& reasons, const ShadowBudget& budget)
{
  std::string text = reasons.setting.Text() + ": ";
  if (reasons.standing.kind == Standing::Exact)
  {
    text += reasons.isSoft ? "each sample light is exact for what casts and receives here"
      : reasons.setting.technique == "ray-cast" ? "traced, which is the truth"
                                                : "exact for what casts and receives here";
  }
  else if (reasons.error && reasons.error->isOfNothing)
  {
    text += "nothing in view that it lights could be measured";
  }
  else if (reasons.error)
  {
    const ErrorPercents& error = *reasons.error;
    text += (reasons.isSoft ? NumberText(error.meanDifference) + " % mean difference (" +
                  NumberText(error.penumbraDifference) + " % in the penumbra)"
                            : NumberText(error.mismatch) + " % wrong") +
      (IsOnePixel(error)      ? " and one gross pixel"
          : error.gross > 0.0 ? " and " + NumberText(error.gross) + " % gross"
                              : " and no gross error") +
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
