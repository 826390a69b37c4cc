// What is measured of which settings, when, and what they are worth for the lights.
#include "vtkShadowTechniqueChooser.h"

#include "ShadowCandidates.h"
#include "vtkShadowSeconds.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace
{

using vtkshadows::ShadowSetting;
using vtkshadows::Standing;

const char* const ExactTechniques[] = { "planar", "stencil-volume", "ray-cast" };

// Drift (vtkShadowMeasuredErrors) from which on a picture is another one, and up to which it is the
// same; and how many times as long as a measure took is waited for the next between the two.
constexpr double OtherPicture = 0.3;
constexpr double SamePicture = 0.02;
// Drift of one frame up to which the eye goes rather than jumps, and waits for a measure of another
// picture, too: that many times as long as one took. Amid what receives each step is such a one.
constexpr double OneStep = 1.0;
constexpr double MeasuringShareOnTheWay = 8.0;
constexpr double MeasuringShare = 20.0;
// The same for each setting that is not in use, as long as what is serves and something moves; and
// MeasuringShare between two of them, or several would be due in a row.
constexpr double MeasuringShareOfOthers = 100.0;
// A setting expected to cost this many times the cheapest that is right is not measured.
constexpr double NotPromising = 4.0;
// Instead of ErrorMargin, of what was drawn by and found wrong.
constexpr double MarginOfRefused = 1.25;

// Sample lights from which on one more or less hardly counts.
constexpr int FewestTellingSamples = 16;

// What an error counts as at least that was measured, percent: less is not told from none.
constexpr double LeastMeasured = 1.0e-4;

}

//------------------------------------------------------------------------------
double vtkShadowTechniqueChooser::Verdict::Figure() const
{
  // One without an error that was found is not yet exact.
  return this->Standing.kind == Standing::Exact ? 0.0
    : this->Error                               ? this->Error->Figure(this->Soft) + LeastMeasured
                                                : 100.0;
}

//------------------------------------------------------------------------------
bool vtkShadowTechniqueChooser::IsInUse(const Setting& setting, const ChosenLight& light) const
{
  const auto known = this->InUse.find(light.Source);
  return known != this->InUse.end() && known->second == setting;
}

// Times the error of a record that it may be after a drift.
double vtkShadowTechniqueChooser::MarginOf(const Setting& setting, const ChosenLight& light,
  const vtkShadowMeasuredErrors::Record& record, double drift) const
{
  return (record.WasRefused && !this->IsInUse(setting, light) ? MarginOfRefused
                                                              : vtkshadows::ErrorMargin) +
    record.Rate * drift;
}

// What the last frame was drawn by and this one may not be, so that it does not come and go.
void vtkShadowTechniqueChooser::NoteRefusals()
{
  for (std::size_t i = 0; i < this->Chosen.size(); ++i)
  {
    const auto used = this->InUse.find(this->Chosen[i].Source);
    const auto known =
      used == this->InUse.end() ? this->Verdicts.end() : this->Verdicts.find(used->second.Text());
    if (known != this->Verdicts.end() && !known->second[i].IsRight)
    {
      this->Errors.Refuse(used->second, this->Chosen[i].Now);
    }
  }
}

void vtkShadowTechniqueChooser::SetBudget(const vtkshadows::ShadowBudget& budget)
{
  this->Budget = budget;
  this->Errors.ForgiveAll();
}

// Whether the eye goes by steps, and the next measure of a setting waits.
bool vtkShadowTechniqueChooser::IsOnTheWay(
  const ChosenLight& light, const vtkShadowMeasuredErrors::Record& record, bool isInUse)
{
  const double share = isInUse ? MeasuringShareOnTheWay : MeasuringShareOfOthers;
  return light.Step > 0.0 && light.Step <= OneStep && record.Elapsed < share * record.Cost;
}

// What is urgent may be needed for this frame.
bool vtkShadowTechniqueChooser::NeedsMeasure(
  const Setting& setting, const ChosenLight& light, bool isUrgent) const
{
  const auto record = this->Errors.Find(setting, light.Now);
  if (!record)
  {
    return true;
  }
  if (!isUrgent)
  {
    const bool isAtRest = light.Step == 0.0 && !this->IsMoving;
    const double share = isAtRest ? MeasuringShare : MeasuringShareOfOthers;
    return record->Drift > OtherPicture && record->Elapsed >= share * record->Cost &&
      this->DrawingSeconds - this->LastMeasured >= MeasuringShare * this->LastCost;
  }
  const bool mayWait = record->Elapsed < MeasuringShare * record->Cost;
  const bool soft = light.Needs.isSoft;
  if (!vtkshadows::IsWithin(
        this->Budget, record->Error, soft, this->MarginOf(setting, light, *record, 0.0)))
  {
    return record->Drift > OtherPicture && !mayWait;
  }
  const bool isOnTheWay = IsOnTheWay(light, *record, true);
  const bool isClose = !vtkshadows::IsWithin(
    this->Budget, record->Error, soft, this->MarginOf(setting, light, *record, record->Drift));
  if (this->IsMoving)
  {
    return (isClose || record->Drift > SamePicture) && !mayWait;
  }
  return ((isClose || record->Drift > OtherPicture) && !isOnTheWay) ||
    (record->Drift > SamePicture && !mayWait);
}

//------------------------------------------------------------------------------
// Whether anything was measured.
bool vtkShadowTechniqueChooser::MeasureFor(const Request& request, const Setting& setting,
  const std::function<bool(const ChosenLight&)>& isUrgent)
{
  std::vector<int> indices;
  for (const ChosenLight& light : this->Chosen)
  {
    if (vtkshadows::StandingOf(setting, this->Scene, light.Needs).kind == Standing::Measured &&
      this->NeedsMeasure(setting, light, isUrgent(light)))
    {
      indices.push_back(light.Index);
    }
  }
  if (indices.empty() || !request.MeasureErrors)
  {
    return false;
  }
  this->Settings.Apply(setting);
  const double start = vtkShadowSeconds();
  std::vector<std::optional<vtkshadows::ErrorPercents>> errors;
  double drawing = 0.0;
  if (request.MeasureErrors(setting.technique, indices, errors, drawing))
  {
    const double drawingOfOne = drawing / static_cast<double>(indices.size());
    this->NoteDrawing(setting, drawingOfOne);
    this->Efforts.Note(setting, drawingOfOne);
    const double cost = vtkShadowSeconds() - start;
    for (const ChosenLight& light : this->Chosen)
    {
      const auto found = std::find(indices.begin(), indices.end(), light.Index);
      if (found != indices.end())
      {
        vtkshadows::ErrorPercents error =
          errors[found - indices.begin()].value_or(vtkshadows::ErrorPercents::OfNothing());
        error.isBySampleLights = setting.IsSampled();
        this->Errors.Keep(setting, light.Now, error, cost);
      }
    }
  }
  this->LastCost = vtkShadowSeconds() - start;
  this->LastMeasured = this->DrawingSeconds;
  this->MeasuringSeconds += this->LastCost;
  return true;
}

//------------------------------------------------------------------------------
// What a technique makes once, for its casters, is no part of what each frame takes; nor is a map
// that is drawn again only as its light or casters move.
void vtkShadowTechniqueChooser::NoteDrawing(const Setting& setting, double secondsOfLight)
{
  const auto key = std::make_pair(setting.technique, setting.filter);
  const auto made = this->Made.find(key);
  const bool wasMade =
    made != this->Made.end() && (this->IsMoving || made->second == this->CasterStamp);
  this->Made[key] = this->CasterStamp;
  if (wasMade && (this->IsMoving || setting.resolution == 0))
  {
    (this->IsMoving ? this->MovingTimes : this->StaticTimes).Note(setting, secondsOfLight);
  }
}

void vtkShadowTechniqueChooser::NoteReleased(const std::string& technique)
{
  for (auto it = this->Made.begin(); it != this->Made.end();)
  {
    it = it->first.first == technique ? this->Made.erase(it) : std::next(it);
  }
}

// Seconds for one light; 0 if nothing is known. What moves takes no less than what stands.
double vtkShadowTechniqueChooser::SecondsAtLeast(const Setting& setting) const
{
  const double still = this->StaticTimes.AtLeast(setting).value_or(0.0);
  return this->IsMoving ? std::max(still, this->MovingTimes.AtLeast(setting).value_or(0.0)) : still;
}

//------------------------------------------------------------------------------
vtkShadowTechniqueChooser::Verdict vtkShadowTechniqueChooser::Judge(
  const Request& request, const Setting& setting, const ChosenLight& light) const
{
  Verdict verdict;
  verdict.Soft = light.Needs.isSoft;
  verdict.Standing = vtkshadows::StandingOf(setting, this->Scene, light.Needs);
  if (verdict.Standing.kind == Standing::Measured)
  {
    if (const auto record = this->Errors.Find(setting, light.Now))
    {
      // Of another picture it says nothing, unless in a motion, where measures wait: or what is
      // tried in turn amid what receives would be no more right when its turn comes again.
      const bool isInUse = this->IsInUse(setting, light);
      const bool waits = IsOnTheWay(light, *record, isInUse);
      const bool isOfThis = this->IsMoving || record->Drift <= OtherPicture || isInUse || waits;
      verdict.Error = isOfThis ? std::make_optional(record->Error) : std::nullopt;
      // While a measure waits, what is in use is as it was measured last.
      const double drift = isInUse && waits && !this->IsMoving ? 0.0
        : this->IsMoving || waits ? std::min(record->Drift, OtherPicture)
                                  : record->Drift;
      verdict.IsRight = isOfThis &&
        vtkshadows::IsWithin(this->Budget, record->Error, verdict.Soft,
          this->MarginOf(setting, light, *record, drift));
    }
    else
    {
      verdict.Standing = { Standing::Assumed, "the driver gave no buffer to measure in" };
    }
  }
  if (verdict.Standing.kind == Standing::Exact)
  {
    verdict.IsRight = true;
  }
  else if (verdict.Standing.kind == Standing::Assumed)
  {
    // Where nothing better is known it is what serves, no coarser than it is by itself.
    const bool anyExact = std::any_of(std::begin(ExactTechniques), std::end(ExactTechniques),
      [&](const char* name)
      {
        return vtkshadows::StandingOf(ShadowSetting::By(name), this->Scene, light.Needs).kind ==
          Standing::Exact;
      });
    const bool isFixed = request.Named.count(setting.technique) > 0;
    const bool isFine = isFixed || setting.resolution == 0 ||
      setting.resolution >= vtkshadows::UsualMapTexels ||
      setting.resolution == this->Settings.OwnResolution(setting.technique);
    const bool isSampled = isFixed || setting.samples == 0 ||
      setting.samples >= this->Settings.OwnSamples(setting.technique);
    verdict.IsRight = isFine && isSampled && (!anyExact || this->Scene.isTooLarge);
  }
  return verdict;
}

//------------------------------------------------------------------------------
// Where fewer sample lights are grossly wrong, more than half of them are so: more are no better,
// from some number on.
bool vtkShadowTechniqueChooser::IsHopeless(const Setting& setting, const ChosenLight& light) const
{
  Setting fewer = setting;
  for (fewer.samples = FewestTellingSamples; fewer.IsMap() && fewer.samples < setting.samples;
       fewer.samples *= 2)
  {
    const auto record = this->Errors.Find(fewer, light.Now);
    if (record && record->Drift <= OtherPicture && !this->Budget.maximumError &&
      vtkshadows::IsGross(record->Error))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
double vtkShadowTechniqueChooser::CostOf(const Setting& setting, const ChosenLight& light) const
{
  return vtkshadows::ExpectedCost(setting, this->Scene, light.Needs, this->IsMoving);
}

//------------------------------------------------------------------------------
bool vtkShadowTechniqueChooser::IsServingAll(const Setting& setting) const
{
  return std::all_of(this->Chosen.begin(), this->Chosen.end(),
    [&](const ChosenLight& light) { return this->IsInUse(setting, light); });
}

vtkShadowTechniqueChooser::Prospect vtkShadowTechniqueChooser::ProspectOf(
  const Setting& setting) const
{
  Prospect prospect;
  prospect.Cost = this->SumOfCosts(setting);
  int fits = 0;
  for (const ChosenLight& light : this->Chosen)
  {
    const Standing::Kind kind = vtkshadows::StandingOf(setting, this->Scene, light.Needs).kind;
    fits += kind != Standing::Unfit ? 1 : 0;
    if (kind == Standing::Measured && !this->Errors.Find(setting, light.Now))
    {
      prospect.IsUnknown = true;
      prospect.IsHopeless = prospect.IsHopeless && this->IsHopeless(setting, light);
    }
  }
  // Where lights have several settings it may be the best for one of them alone.
  const auto first = this->InUse.find(this->Chosen.front().Source);
  const bool isOne = first != this->InUse.end() && this->IsServingAll(first->second);
  prospect.AtLeast = this->SecondsAtLeast(setting) * (isOne ? fits : 1);
  return prospect;
}

double vtkShadowTechniqueChooser::SumOfCosts(const Setting& setting) const
{
  return std::accumulate(this->Chosen.begin(), this->Chosen.end(), 0.0,
    [&](double sum, const ChosenLight& light) { return sum + this->CostOf(setting, light); });
}

// The one that is measured in the least time, as far as those before it tell.
std::vector<ShadowSetting>::iterator vtkShadowTechniqueChooser::SoonestOf(
  std::vector<Setting>& settings) const
{
  const auto costOf = [this](const Setting& setting) { return this->SumOfCosts(setting); };
  const auto effortOf = [&](const Setting& setting)
  { return this->Efforts.About(setting, costOf).value_or(costOf(setting)); };
  return std::min_element(settings.begin(), settings.end(),
    [&](const Setting& a, const Setting& b) { return effortOf(a) < effortOf(b); });
}

//------------------------------------------------------------------------------
bool vtkShadowTechniqueChooser::Judgement::IsServed() const
{
  return std::all_of(this->Served.begin(), this->Served.end(), [](bool is) { return is; });
}

void vtkShadowTechniqueChooser::JudgeFor(
  const Request& request, const Setting& setting, Judgement& found)
{
  std::vector<Verdict>& verdicts = this->Verdicts[setting.Text()];
  bool isRight = true, isRightForAll = true, anyFit = false;
  for (std::size_t i = 0; i < this->Chosen.size(); ++i)
  {
    verdicts.push_back(this->Judge(request, setting, this->Chosen[i]));
    const Verdict& verdict = verdicts.back();
    const bool isFit = verdict.Standing.kind != Standing::Unfit;
    found.Served[i] = found.Served[i] || verdict.IsRight;
    isRight = isRight && (verdict.IsRight || !isFit);
    isRightForAll = isRightForAll && verdict.IsRight;
    anyFit = anyFit || isFit;
  }
  found.Candidates.push_back(setting);
  if (isRight && anyFit)
  {
    found.Right.push_back(setting);
  }
  if (isRightForAll && anyFit)
  {
    found.Cheapest = std::min(found.Cheapest, this->SumOfCosts(setting));
  }
}

//------------------------------------------------------------------------------
// Verdicts on all that may be of use: what is in use at first; then, until something serves each
// light, what is measured the soonest; then, the cheapest first, what may be faster than what is
// right already.
std::vector<ShadowSetting> vtkShadowTechniqueChooser::JudgeSettings(const Request& request)
{
  const std::vector<ChosenLight>& lights = this->Chosen;
  const bool byAccuracy = this->Budget.IsOfTimeAlone();
  Judgement found;
  found.Served.assign(lights.size(), false);
  this->Verdicts.clear();
  this->MeasuresWait = false;

  std::vector<Setting> open;
  for (const Setting& setting : this->SettingsToTry(request))
  {
    const auto isInUse = [&](const ChosenLight& light) { return this->IsInUse(setting, light); };
    if (std::any_of(lights.begin(), lights.end(), isInUse))
    {
      this->MeasureFor(request, setting, isInUse);
      this->JudgeFor(request, setting, found);
    }
    else
    {
      open.push_back(setting);
    }
  }
  bool hasMeasured = this->MeasuringSeconds > 0.0, waitsForTimes = false;
  while (!open.empty())
  {
    const bool isServed = found.IsServed();
    const auto next = isServed ? open.begin() : this->SoonestOf(open);
    const Setting setting = *next;
    open.erase(next);
    const auto covers = [&](const Setting& known)
    { return vtkshadows::IsNoFaster(setting, known, this->IsMoving); };
    const Prospect prospect = this->ProspectOf(setting);
    if ((!byAccuracy &&
          (std::any_of(found.Right.begin(), found.Right.end(), covers) ||
            (prospect.IsUnknown && prospect.Cost > NotPromising * found.Cheapest))) ||
      (prospect.IsUnknown && (prospect.IsHopeless || this->Trials().HasLost(prospect.AtLeast))))
    {
      continue;
    }
    // Once something serves, the others are measured one a frame: those of which nothing is known
    // in turn, the known ones once in a while.
    if (isServed && prospect.IsUnknown && prospect.AtLeast > 0.0 &&
      std::isinf(this->Trials().LeastSeconds()))
    {
      // Whether it is too slow to be measured is told once what serves is timed.
      waitsForTimes = true;
      continue;
    }
    if (!isServed || !hasMeasured)
    {
      const bool did =
        this->MeasureFor(request, setting, [isServed](const ChosenLight&) { return !isServed; });
      hasMeasured = hasMeasured || did;
    }
    else if (prospect.IsUnknown)
    {
      this->MeasuresWait = true;
      continue;
    }
    this->JudgeFor(request, setting, found);
  }
  this->Trials().SetTimesOnlyWay(waitsForTimes);
  this->MeasuresWait = this->MeasuresWait || waitsForTimes;
  return found.Candidates;
}
