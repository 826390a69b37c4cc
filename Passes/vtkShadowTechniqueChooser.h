// Chooses techniques for the lights of the technique "auto": gathers what the scene asks, has
// errors measured where they are not known, and times the ways that meet the budget
// (TechniqueChoice.h).
#ifndef vtkShadowTechniqueChooser_h
#define vtkShadowTechniqueChooser_h

#include "DrawingTimes.h"
#include "FrameTrials.h"
#include "vtkShadowChosenSettings.h"
#include "vtkShadowMeasuredErrors.h"
#include "vtkShadowSceneNeeds.h"

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

class vtkShadowTechniqueChooser
{
public:
  // Measures a technique, whose settings are applied already, for `lights` (indices into the
  // scene's); one error a light, none where the light shines on nothing that could be measured; and
  // the seconds that it drew their visibility in. false if it cannot.
  using Measure = std::function<bool(const std::string& technique, const std::vector<int>& lights,
    std::vector<std::optional<vtkshadows::ErrorPercents>>& errors, double& drawingSeconds)>;

  struct Request
  {
    const vtkShadowFrame* Frame = nullptr;
    std::vector<int> Lights;                // that are to be given a technique
    vtkShadowChosenSettings::FindPass Pass; // whose settings may be chosen
    std::set<std::string> Named;            // but not of these, which other lights name
    bool HasRays = false;
    int Planes = 0;      // that may receive, at most
    bool IsDrawn = true; // for a frame, and not for a read-back
    Measure MeasureErrors;
  };
  // The technique of each of the lights, empty for one of which no shadow can be seen; the settings
  // that were chosen are applied.
  std::vector<std::string> Choose(const Request& request);

  // No light is to be given a technique: put settings back as they were found.
  void Rest();
  // Sample lights of a technique, as the user has them.
  int OwnSamples(const std::string& technique) const
  {
    return this->Settings.OwnSamples(technique);
  }

  void SetBudget(const vtkshadows::ShadowBudget& budget);
  const vtkshadows::ShadowBudget& GetBudget() const { return this->Budget; }

  // Around the drawing of a frame. BeginFrame says whether it is to be timed; `seconds` without
  // what measuring took.
  bool WantsTime() const { return this->IsChosen && !this->Holds && this->Trials().WantsTime(); }
  // Frames that make one picture are drawn alike: each as the last one, as long as that is right.
  void SetHolds(bool holds) { this->Holds = holds; }
  bool GetHolds() const { return this->Holds; }
  void FrameDrawn(std::optional<double> seconds);
  // A technique lost what it kept with the driver.
  void NoteReleased(const std::string& technique);
  double SecondsMeasuring() const { return this->MeasuringSeconds; } // in the last Choose
  // Whether a choice that is made already, for lights that stand or that move, has a technique.
  bool MayUse(const std::string& technique) const;
  // The last frame was drawn by what is chosen, and so is the next.
  bool IsSettled() const
  {
    return !this->IsChosen ||
      (!this->MeasuresWait && this->WasDrawnSettled && this->Trials().IsSettled());
  }

  // Why the light has what it has; empty if it was given none.
  std::string Explain(const vtkLight* light) const;

private:
  using Setting = vtkshadows::ShadowSetting;

  struct ChosenLight
  {
    int Index = 0;
    const vtkLight* Source = nullptr;
    vtkshadows::LightNeeds Needs;
    vtkShadowMeasuredErrors::Circumstances Now;
    double Step = 0.0; // drift of the eye in the last frame that was drawn
  };
  // What a setting is for a light.
  struct Verdict
  {
    vtkshadows::Standing Standing;
    std::optional<vtkshadows::ErrorPercents> Error;
    bool IsRight = false;
    double Figure() const;
    bool Soft = false;
  };

  void NoteTime(bool isDrawn);
  void NoteMotion(const Request& request);
  void NoteSteps(bool isDrawn);
  std::vector<ChosenLight> LightsOf(const Request& request, const std::vector<bool>& reach) const;
  std::vector<Setting> SettingsToTry(const Request& request) const;
  Verdict Judge(const Request& request, const Setting& setting, const ChosenLight& light) const;
  bool MeasureFor(const Request& request, const Setting& setting,
    const std::function<bool(const ChosenLight&)>& isUrgent);
  void NoteDrawing(const Setting& setting, double secondsOfLight);
  double SecondsAtLeast(const Setting& setting) const;
  // What is expected of a setting before it is judged.
  struct Prospect
  {
    double Cost = 0.0;      // in frames without shadows
    double AtLeast = 0.0;   // seconds; 0 if nothing is known
    bool IsUnknown = false; // some light's error
    bool IsHopeless = true; // each of those
  };
  Prospect ProspectOf(const Setting& setting) const;
  bool IsServingAll(const Setting& setting) const;
  double SumOfCosts(const Setting& setting) const;
  std::vector<Setting>::iterator SoonestOf(std::vector<Setting>& settings) const;
  bool NeedsMeasure(const Setting& setting, const ChosenLight& light, bool isUrgent) const;
  bool IsInUse(const Setting& setting, const ChosenLight& light) const;
  bool IsHopeless(const Setting& setting, const ChosenLight& light) const;
  double MarginOf(const Setting& setting, const ChosenLight& light,
    const vtkShadowMeasuredErrors::Record& record, double drift) const;
  static bool IsOnTheWay(
    const ChosenLight& light, const vtkShadowMeasuredErrors::Record& record, bool isInUse);
  void NoteRefusals();
  // What was found of the settings of a frame so far.
  struct Judgement
  {
    std::vector<Setting> Candidates; // that were judged
    std::vector<Setting> Right;      // for all lights that they fit
    std::vector<bool> Served;        // lights that one of them is right for
    double Cheapest = std::numeric_limits<double>::infinity(); // expected, of what is right for all
    bool IsServed() const;
  };
  void JudgeFor(const Request& request, const Setting& setting, Judgement& found);
  std::vector<Setting> JudgeSettings(const Request& request);
  std::vector<vtkshadows::FrameWay> WaysFor(const Request& request);
  double CostOf(const Setting& setting, const ChosenLight& light) const;
  vtkshadows::FrameTrials& Trials() { return this->IsMoving ? this->Moving : this->Static; }
  const vtkshadows::FrameTrials& Trials() const
  {
    return this->IsMoving ? this->Moving : this->Static;
  }

  vtkshadows::ShadowBudget Budget;
  vtkShadowSceneNeeds Needs;
  vtkShadowMeasuredErrors Errors;
  vtkshadows::FrameTrials Static, Moving;
  vtkshadows::DrawingTimes StaticTimes, MovingTimes;
  vtkshadows::DrawingTimes Efforts; // of what was measured, with all that was made for it
  // What casters were when a technique with a filter was made for them.
  std::map<std::pair<std::string, std::string>, vtkMTimeType> Made;

  vtkshadows::SceneNeeds Scene;
  std::vector<ChosenLight> Chosen;     // of the last Choose, those that reach something
  std::vector<const vtkLight*> Unseen; // and those that do not
  // Of the last frame that was drawn.
  struct Place
  {
    vtkShadowMeasuredErrors::Circumstances Now;
    double Step = 0.0;
  };
  std::map<const vtkLight*, Place> LastDrawn;
  std::map<std::string, std::vector<Verdict>> Verdicts; // by setting, one a light
  bool IsChosen = false;
  bool WasDrawnSettled = false; // the last frame
  bool MeasuresWait = false;    // for the next frames, of settings that nothing is known of
  std::size_t Drawn = 0;        // among the ways: the last Choose's
  std::vector<Setting> LastSettings;
  bool Holds = false;
  std::map<const vtkLight*, Setting> InUse; // the same, by light
  double MeasuringSeconds = 0.0;
  double LastCost = 0.0;       // seconds of the last measure
  double LastMeasured = 0.0;   // and when, of DrawingSeconds
  double DrawingSeconds = 0.0; // while frames were drawn one after another, without measures
  double FrameStart = 0.0;     // of the last frame, by the clock
  double FrameSeconds = 0.0;   // that it took
  double TimedFor[3] = { 0.0, 0.0, 0.0 }; // triangles, pixels and lights that times are of

  bool IsMoving = false;
  int FramesOfOtherMotion = 0;
  bool WasJustMoved = false;
  vtkMTimeType CasterStamp = 0;
  double CasterChanges = 0.0;
  std::vector<vtkshadows::ShadowLight> LightsBefore;

  vtkShadowChosenSettings Settings;
};

#endif
