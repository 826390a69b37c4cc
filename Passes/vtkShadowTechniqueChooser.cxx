#include "vtkShadowTechniqueChooser.h"

#include "ShadowCandidates.h"
#include "vtkShadowSeconds.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderer.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using vtkshadows::FrameWay;
using vtkshadows::ShadowSetting;
using vtkshadows::Standing;

const char* const Maps = "depth-map";

constexpr double ReachOfCascades = 0.3;
constexpr int FacesOfCube = 6;

// Above this many triangles no tree is built only to measure, unless a budget of error asks for it.
constexpr double MostTrianglesMeasured = 5.0e6;

// Seconds between two frames that may be a pause between two motions.
constexpr double ShortestPause = 0.1;
// Frames in a row that move, or that do not, before the choice is that of the other.
constexpr int FramesOfMotion = 2;
// What a change of casters counts as drift, by itself and in a motion.
constexpr double DriftOfChange = 0.35;
constexpr double DriftOfMotion = 0.02;

// Times the triangles, pixels or lights that times of frames hold for.
constexpr double OtherScene = 1.5;

bool IsSameLight(const vtkshadows::ShadowLight& a, const vtkshadows::ShadowLight& b)
{
  return a.kind == b.kind && a.position == b.position && a.direction == b.direction &&
    a.coneAngle == b.coneAngle && a.radius == b.radius;
}

double DistanceTo(const vtkshadows::Box& box, const glm::dvec3& p)
{
  return glm::length(glm::max(glm::max(box.minimum - p, p - box.maximum), glm::dvec3(0.0)));
}

}

//------------------------------------------------------------------------------
void vtkShadowTechniqueChooser::Rest()
{
  this->Settings.PutBack();
  this->IsChosen = false;
  this->Chosen.clear();
  this->Unseen.clear();
}

//------------------------------------------------------------------------------
// Measures are paid for by the time that frames take: a pause makes none of them due.
void vtkShadowTechniqueChooser::NoteTime(bool isDrawn)
{
  if (isDrawn)
  {
    const double now = vtkShadowSeconds();
    const double pause = std::max(ShortestPause, 2.0 * this->FrameSeconds);
    this->DrawingSeconds +=
      std::max(std::min(now - this->FrameStart, pause) - this->MeasuringSeconds, 0.0);
    this->FrameStart = now;
    this->Errors.SetTime(this->DrawingSeconds);
  }
  this->MeasuringSeconds = 0.0;
}

//------------------------------------------------------------------------------
void vtkShadowTechniqueChooser::NoteMotion(const Request& request)
{
  std::vector<vtkshadows::ShadowLight> lights;
  for (const vtkShadowScene::Light& light : request.Frame->Scene->GetLights())
  {
    if (!light.AtEye)
    {
      lights.push_back(light.Ray);
    }
  }
  const vtkMTimeType stamp = request.Frame->Scene->GetCasterStamp();
  const bool castersChanged = this->CasterStamp != 0 && stamp != this->CasterStamp;
  const bool lightsMoved = lights.size() == this->LightsBefore.size() &&
    !std::equal(lights.begin(), lights.end(), this->LightsBefore.begin(), IsSameLight);
  this->CasterStamp = stamp;
  this->LightsBefore = lights;
  if (castersChanged)
  {
    this->CasterChanges += this->IsMoving ? DriftOfMotion : DriftOfChange;
  }
  if (!request.IsDrawn)
  {
    return;
  }
  this->WasJustMoved = castersChanged || lightsMoved;
  this->FramesOfOtherMotion =
    this->WasJustMoved != this->IsMoving ? this->FramesOfOtherMotion + 1 : 0;
  if (this->FramesOfOtherMotion >= FramesOfMotion)
  {
    this->IsMoving = !this->IsMoving;
    this->FramesOfOtherMotion = 0;
  }
}

//------------------------------------------------------------------------------
std::vector<vtkShadowTechniqueChooser::ChosenLight> vtkShadowTechniqueChooser::LightsOf(
  const Request& request, const std::vector<bool>& reach) const
{
  const vtkShadowFrame& frame = *request.Frame;
  vtkShadowMeasuredErrors::Circumstances now;
  now.ViewFromWorld = frame.ViewFromWorld;
  now.ClipFromView = frame.ClipFromView;
  now.Height = frame.Size[1];
  now.CasterChanges = this->CasterChanges;
  const glm::dvec3 eye(glm::inverse(frame.ViewFromWorld)[3]);
  vtkshadows::Box all;
  double nearest = std::numeric_limits<double>::infinity();
  for (const vtkshadows::BoxCorners& corners : vtkShadowReceiverCorners(*frame.Scene))
  {
    vtkshadows::Box box;
    box.Add(corners);
    all.Add(corners);
    nearest = std::min(nearest, DistanceTo(box, eye));
  }
  const double size = all.isEmpty ? 1.0 : all.Diagonal();
  now.Reach = size > 0.0 && std::isfinite(size) ? size : 1.0;
  // Amid what receives, a step is large that is so beside all of it.
  now.Distance = std::max(nearest, 0.02 * now.Reach);

  std::vector<ChosenLight> lights;
  for (std::size_t i = 0; i < request.Lights.size(); ++i)
  {
    if (reach[i])
    {
      const vtkShadowScene::Light& light = frame.Scene->GetLights()[request.Lights[i]];
      ChosenLight chosen;
      chosen.Index = request.Lights[i];
      chosen.Source = light.Source;
      chosen.Needs.isSoft = light.Ray.radius > 0.0;
      chosen.Needs.isDirectional = light.Ray.kind == vtkshadows::LightKind::Directional;
      chosen.Needs.views =
        light.Ray.kind == vtkshadows::LightKind::Point && DistanceTo(all, light.Ray.position) == 0.0
        ? FacesOfCube
        : 1;
      chosen.Now = now;
      chosen.Now.Source = light.Source;
      chosen.Now.Light = light.Ray;
      lights.push_back(chosen);
    }
  }
  return lights;
}

//------------------------------------------------------------------------------
// How far the eye went; another light or caster is no step of its. A read-back is of the last
// frame's.
void vtkShadowTechniqueChooser::NoteSteps(bool isDrawn)
{
  std::map<const vtkLight*, Place> now;
  for (ChosenLight& light : this->Chosen)
  {
    const auto before = this->LastDrawn.find(light.Source);
    if (before == this->LastDrawn.end() ||
      !IsSameLight(before->second.Now.Light, light.Now.Light) ||
      before->second.Now.CasterChanges != light.Now.CasterChanges)
    {
      light.Step = std::numeric_limits<double>::infinity();
    }
    else
    {
      light.Step = isDrawn ? vtkShadowMeasuredErrors::DriftOf(before->second.Now, light.Now)
                           : before->second.Step;
    }
    now[light.Source] = { light.Now, light.Step };
  }
  if (isDrawn)
  {
    this->LastDrawn.swap(now);
  }
}

//------------------------------------------------------------------------------
// The cheapest to be expected first. What the user has set, or what another light relies on, is not
// varied.
std::vector<ShadowSetting> vtkShadowTechniqueChooser::SettingsToTry(const Request& request) const
{
  const auto any = [&](const auto& says)
  { return std::any_of(this->Chosen.begin(), this->Chosen.end(), says); };
  vtkshadows::CandidateScope scope;
  scope.anySoft = any([](const ChosenLight& l) { return l.Needs.isSoft; });
  scope.anyHard = any([](const ChosenLight& l) { return !l.Needs.isSoft; });
  // Cascades are for what reaches much farther from the eye than its nearest part lies.
  scope.anyCascaded = !request.Frame->Renderer->GetActiveCamera()->GetParallelProjection() &&
    any([](const ChosenLight& l)
      { return l.Needs.isDirectional && l.Now.Distance < ReachOfCascades * l.Now.Reach; });
  scope.anyTextured = !this->IsMoving;

  std::vector<Setting> settings;
  for (Setting setting : vtkshadows::CandidateSettings(scope, this->Scene))
  {
    const bool fixed = request.Named.count(setting.technique) > 0;
    if (this->Settings.Confine(setting, fixed) &&
      std::find(settings.begin(), settings.end(), setting) == settings.end())
    {
      settings.push_back(setting);
    }
  }
  std::stable_sort(settings.begin(), settings.end(),
    [this](const Setting& a, const Setting& b)
    { return this->SumOfCosts(a) < this->SumOfCosts(b); });
  return settings;
}

//------------------------------------------------------------------------------
// Each by one setting for as many lights as it is right for, the others by what else is right.
std::vector<FrameWay> vtkShadowTechniqueChooser::WaysFor(const Request& request)
{
  const std::vector<ChosenLight>& lights = this->Chosen;
  const std::vector<Setting> candidates = this->JudgeSettings(request);

  // What a light has where the way's own setting is not right for it.
  const auto verdictOf = [&](const Setting& setting, std::size_t light) -> const Verdict&
  { return this->Verdicts[setting.Text()][light]; };
  const auto elseOf = [&](std::size_t i, const Setting& own, const std::vector<Setting>& others)
  {
    const Setting* best = nullptr;
    const auto rank = [&](const Setting& setting)
    {
      const Verdict& verdict = verdictOf(setting, i);
      return std::make_pair(
        verdict.IsRight ? 0.0 : verdict.Figure(), this->CostOf(setting, lights[i]));
    };
    for (const Setting& setting : candidates)
    {
      // The settings of a technique are those of all lights.
      const auto isOther = [&](const Setting& one)
      { return one.technique == setting.technique && !(one == setting); };
      if (!isOther(own) && std::none_of(others.begin(), others.end(), isOther) &&
        verdictOf(setting, i).Standing.kind != Standing::Unfit &&
        (!best || rank(setting) < rank(*best)))
      {
        best = &setting;
      }
    }
    return best ? *best : Setting();
  };

  std::vector<FrameWay> ways;
  for (const Setting& setting : candidates)
  {
    FrameWay way;
    way.cost = 1.0;
    bool isUsed = false;
    for (std::size_t i = 0; i < lights.size(); ++i)
    {
      const bool isRight = verdictOf(setting, i).IsRight;
      const Setting own = isRight ? setting : elseOf(i, setting, way.settings);
      const Verdict& verdict = own.technique.empty() ? verdictOf(setting, i) : verdictOf(own, i);
      isUsed = isUsed || own == setting;
      way.settings.push_back(own);
      way.cost += this->CostOf(own, lights[i]);
      way.atLeast += this->SecondsAtLeast(own);
      way.error = std::max(way.error, verdict.Figure());
      way.isRight = way.isRight && verdict.IsRight;
    }
    const bool isKnown = std::any_of(ways.begin(), ways.end(),
      [&](const FrameWay& other) { return other.settings == way.settings; });
    if (isUsed && !isKnown)
    {
      ways.push_back(way);
    }
  }
  // Where nothing is right for a light, the ways nearest to it are what there is.
  if (!ways.empty() &&
    std::none_of(ways.begin(), ways.end(), [](const FrameWay& way) { return way.isRight; }))
  {
    double least = std::numeric_limits<double>::infinity();
    for (const FrameWay& way : ways)
    {
      least = std::min(least, way.error);
    }
    for (FrameWay& way : ways)
    {
      way.isRight = way.error <= least;
    }
  }
  ways.erase(
    std::remove_if(ways.begin(), ways.end(), [](const FrameWay& way) { return !way.isRight; }),
    ways.end());
  std::stable_sort(
    ways.begin(), ways.end(), [](const FrameWay& a, const FrameWay& b) { return a.cost < b.cost; });
  return ways;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkShadowTechniqueChooser::Choose(const Request& request)
{
  this->NoteTime(request.IsDrawn);
  this->NoteMotion(request);
  this->Settings.Note(request.Pass);
  this->Scene = this->Needs.Of(*request.Frame, request.HasRays, request.Planes);
  this->Scene.isTooLarge =
    this->Scene.triangles > MostTrianglesMeasured && !this->Budget.maximumError;
  const std::vector<bool> reach = this->Needs.Reach(*request.Frame, request.Lights);
  this->Chosen = this->LightsOf(request, reach);
  this->NoteSteps(request.IsDrawn);
  this->Unseen.clear();
  std::vector<const vtkLight*> sources;
  for (std::size_t i = 0; i < request.Lights.size(); ++i)
  {
    const vtkLight* source = request.Frame->Scene->GetLights()[request.Lights[i]].Source;
    sources.push_back(source);
    if (!reach[i])
    {
      this->Unseen.push_back(source);
    }
  }
  this->Errors.KeepOnly(sources);
  this->IsChosen = !this->Chosen.empty();
  std::vector<std::string> techniques(request.Lights.size());
  if (!this->IsChosen)
  {
    return techniques;
  }

  const double counts[3] = { this->Scene.triangles, this->Scene.pixels,
    static_cast<double>(this->Chosen.size()) };
  const auto isOther = [](double now, double before)
  { return now > OtherScene * before || before > OtherScene * now; };
  if (isOther(counts[0], this->TimedFor[0]) || isOther(counts[1], this->TimedFor[1]) ||
    counts[2] != this->TimedFor[2])
  {
    this->Static.Restart();
    this->Moving.Restart();
    this->StaticTimes.Forget();
    this->MovingTimes.Forget();
    this->Efforts.Forget();
    std::copy_n(counts, 3, this->TimedFor);
  }
  const std::vector<FrameWay> ways = this->WaysFor(request);
  this->NoteRefusals();
  if (ways.empty())
  {
    this->IsChosen = false;
    return techniques;
  }
  this->Trials().SetWays(ways, this->Budget);

  // A read-back, and a frame that is held, is of the last frame's way, as long as that is right.
  const std::vector<FrameWay>& there = this->Trials().GetWays();
  const auto last = std::find_if(there.begin(), there.end(),
    [&](const FrameWay& way) { return way.settings == this->LastSettings; });
  this->Drawn = (this->Holds || !request.IsDrawn) && last != there.end()
    ? static_cast<std::size_t>(last - there.begin())
    : this->Trials().Current();
  const std::vector<Setting>& settings = there[this->Drawn].settings;
  this->LastSettings = settings;
  this->InUse.clear();
  for (std::size_t i = 0; i < this->Chosen.size(); ++i)
  {
    this->InUse[this->Chosen[i].Source] = settings[i];
  }
  for (std::size_t i = 0, k = 0; i < request.Lights.size(); ++i)
  {
    if (reach[i])
    {
      const Setting& setting = settings[k++];
      techniques[i] = setting.technique;
      this->Settings.Apply(setting);
    }
  }
  return techniques;
}

//------------------------------------------------------------------------------
void vtkShadowTechniqueChooser::FrameDrawn(std::optional<double> seconds)
{
  this->FrameSeconds = vtkShadowSeconds() - this->FrameStart;
  this->WasDrawnSettled = this->Trials().IsSettled(); // else it was one that is timed
  if (this->IsChosen && !this->Holds && this->WasJustMoved == this->IsMoving)
  {
    // A measure disturbs what is timed after it, too: caches, and the driver's queue.
    this->Trials().FrameDrawn(this->MeasuringSeconds > 0.0 ? std::nullopt : seconds);
  }
}

bool vtkShadowTechniqueChooser::MayUse(const std::string& technique) const
{
  const auto uses = [&](const vtkshadows::FrameTrials& trials)
  {
    const std::vector<FrameWay>& ways = trials.GetWays();
    return !ways.empty() && trials.IsSettled() &&
      std::any_of(trials.Way().settings.begin(), trials.Way().settings.end(),
        [&](const Setting& setting) { return setting.technique == technique; });
  };
  return uses(this->Static) || uses(this->Moving);
}

//------------------------------------------------------------------------------
std::string vtkShadowTechniqueChooser::Explain(const vtkLight* light) const
{
  if (std::find(this->Unseen.begin(), this->Unseen.end(), light) != this->Unseen.end())
  {
    return "none: no shadow of this light can fall on anything in view.";
  }
  const auto found = std::find_if(this->Chosen.begin(), this->Chosen.end(),
    [&](const ChosenLight& one) { return one.Source == light; });
  if (!this->IsChosen || found == this->Chosen.end())
  {
    return {};
  }
  const std::size_t index = found - this->Chosen.begin();
  const vtkshadows::FrameTrials& trials = this->Trials();
  vtkshadows::Reasons reasons;
  reasons.setting = trials.GetWays()[this->Drawn].settings[index];
  reasons.isSoft = found->Needs.isSoft;
  reasons.seconds = trials.SecondsOf(this->Drawn);
  const auto own = this->Verdicts.find(reasons.setting.Text());
  if (own != this->Verdicts.end())
  {
    const Verdict& verdict = own->second[index];
    reasons.setting.samples = reasons.isSoft ? reasons.setting.samples : 0;
    reasons.standing = verdict.Standing;
    reasons.error = verdict.Error;
    reasons.isRight = verdict.IsRight;
  }
  std::vector<std::string> told = { trials.GetWays()[this->Drawn].settings[index].Text() };
  for (std::size_t i = 0; i < trials.GetWays().size(); ++i)
  {
    Setting other = trials.GetWays()[i].settings[index];
    other.samples = reasons.isSoft ? other.samples : 0;
    const std::optional<double> seconds = trials.SecondsOf(i);
    if (i != this->Drawn && seconds &&
      std::find(told.begin(), told.end(), other.Text()) == told.end())
    {
      told.push_back(other.Text());
      reasons.others.push_back(other.Text() + " takes " + vtkshadows::SecondsText(*seconds));
    }
  }
  std::vector<std::string> unfit; // as it is whatever the setting
  for (const auto& known : this->Verdicts)
  {
    const Verdict& verdict = known.second[index];
    const std::string technique = known.first.substr(0, known.first.find(' '));
    if (std::find(told.begin(), told.end(), known.first) != told.end() || verdict.IsRight)
    {
      continue;
    }
    if (verdict.Error)
    {
      reasons.refused.push_back(
        known.first + ": " + vtkshadows::ErrorText(*verdict.Error, this->Budget, reasons.isSoft));
    }
    else if (verdict.Standing.kind == Standing::Unfit && technique != Maps &&
      std::find(unfit.begin(), unfit.end(), technique) == unfit.end())
    {
      unfit.push_back(technique);
      reasons.refused.push_back(technique + ": " + verdict.Standing.why);
    }
  }
  return vtkshadows::Explain(reasons, this->Budget);
}
