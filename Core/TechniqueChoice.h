// Which technique a light has, and why: what a scene asks of a technique, which errors a budget
// allows, and which of several ways to draw a frame is the fastest. Plain C++, no VTK, no OpenGL.
#ifndef vtkshadows_TechniqueChoice_h
#define vtkshadows_TechniqueChoice_h

#include "VisibilityError.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vtkshadows
{

// A technique, with those of its settings that are chosen with it.
struct ShadowSetting
{
  std::string technique;
  int resolution = 0; // texels on the longer side of a map; 0: it has none
  int cascades = 1;
  std::string filter; // of a depth map

  bool IsMap() const { return this->resolution > 0; }
  std::string Text() const; // "depth-map (2048 texels, 4 cascades, filter exact)"
  bool operator==(const ShadowSetting& other) const
  {
    return this->technique == other.technique && this->resolution == other.resolution &&
      this->cascades == other.cascades && this->filter == other.filter;
  }
};

// What a scene asks of a technique.
struct SceneNeeds
{
  bool hasRays = false;     // there is a ray cast, which is the truth
  std::string notTriangles; // what casts and is not triangles: "sphere impostors"; empty: nothing
  std::string notHitByRays; // what casts and rays pass through; empty: nothing
  bool hasHoles = false;    // casters are cut by textures or by a user's shaders
  bool castsByOpacity = false;      // translucent casters, each texel holding or letting through
  bool hasStandIns = false;         // other meshes cast in the place of props
  bool receivesTranslucent = false; // what is behind other things in a pixel receives, too
  bool receivesFlat = false;        // all that receives lies in planes that are found
  double triangles = 0.0;           // that cast
  double pixels = 0.0;              // of the viewport
};

struct LightNeeds
{
  bool isSoft = false; // has a radius
  bool isDirectional = false;
};

// Whether a setting gives a light its shadows in a scene, and what is known of its error.
struct Standing
{
  enum Kind
  {
    Unfit,    // some of what casts or receives is beyond it
    Exact,    // right to the pixel by construction
    Measured, // as the truth says in the view
    Assumed   // it serves, but there is no truth to hold it against
  };
  Kind kind = Unfit;
  std::string why; // it is unfit, or assumed
};
Standing StandingOf(const ShadowSetting& setting, const SceneNeeds& scene, const LightNeeds& light);

// Whether rays tell what casts in a scene.
bool HasTruth(const SceneNeeds& scene, std::string* why = nullptr);

// What is asked of the choice. Neither: no gross error, and the fastest.
struct ShadowBudget
{
  std::optional<double> maximumError;   // percent: mismatch; soft lights: mean absolute difference
  std::optional<double> maximumSeconds; // a frame
};

// What a measure found, in percent of the receiver pixels.
struct ErrorPercents
{
  double mismatch = 0.0;
  double gross = 0.0;
  double meanDifference = 0.0;
  double sampled = 0.0; // pixels that stand for more of them; 0: every pixel was measured

  bool isOfNothing = false; // no pixel could be measured: the light falls on none in view

  static ErrorPercents OfNothing()
  {
    ErrorPercents error;
    error.isOfNothing = true;
    return error;
  }
  static ErrorPercents Of(const VisibilityError& error, bool isSampled = false);
  // What a budget's maximum is held against.
  double Figure(bool isSoft) const { return isSoft ? this->meanDifference : this->mismatch; }
};

// Without a budget of error: at most one gross pixel in 100 000, which the exact techniques have,
// too; and of a soft light a mean difference that is seen beside the truth only.
constexpr double MostGrossPercent = 0.001;
constexpr double MostSoftDifferencePercent = 4.0;

// `margin`: times the error that was measured that it may have become, at least 1. What was
// measured on a sample of pixels has two standard deviations more.
bool IsWithin(const ShadowBudget& budget, const ErrorPercents& error, bool isSoft, double margin);
// "no gross error" or "at most 0.5 % wrong".
std::string BudgetText(const ShadowBudget& budget);
// The figure that a budget is about: "0.3 % gross".
std::string ErrorText(const ErrorPercents& error, const ShadowBudget& budget, bool isSoft);

// A way to draw the frame: a setting for each light.
struct FrameWay
{
  std::vector<ShadowSetting> settings;
  double error = 0.0;  // percent, the worst of the lights; of exact ones 0
  bool isRight = true; // every light within the budget
  double cost = 0.0;   // expected, in frames without shadows: for the order, and until it is timed
};

// Which of several ways the coming frame is drawn by. The cheapest to be expected is first; each of
// those that may be the fastest then draws a few frames, which are timed, and those that are near
// to the fastest a few more, later, so that what else a machine does for a while decides nothing.
// It stays until the ways change, or until a frame now and then takes far longer or shorter.
class FrameTrials
{
public:
  // Times of ways that there were already, and the choice among them, are kept.
  void SetWays(const std::vector<FrameWay>& ways, const ShadowBudget& budget);
  // Forget all times.
  void Restart();

  std::size_t Current() const { return this->Chosen; }
  const FrameWay& Way() const { return this->Ways[this->Chosen]; }
  // Whether the coming frame is to be timed.
  bool WantsTime() const;
  // A frame by the current way is drawn, in so many seconds if it was timed.
  void FrameDrawn(std::optional<double> seconds);
  bool IsSettled() const { return this->Settled; }
  // The least that was timed.
  std::optional<double> SecondsOf(std::size_t way) const;
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
  double LeastSeconds() const;
  bool IsPromising(std::size_t way) const;
  std::size_t Best() const;
  void Advance();

  std::vector<FrameWay> Ways;
  std::vector<Timing> Timings; // of each way
  // Of ways that there were, for when they are there again.
  std::vector<std::pair<std::vector<ShadowSetting>, Timing>> Past;
  ShadowBudget Budget;
  std::size_t Chosen = 0;
  bool Settled = false;
  int SinceSettled = 0; // frames
  int Strange = 0;      // timed frames in a row that took far longer or shorter
};

// Why a light has its technique, in a sentence.
struct Reasons
{
  ShadowSetting setting;
  Standing standing;
  std::optional<ErrorPercents> error; // measured
  bool isSoft = false;
  bool isRight = true;
  std::optional<double> seconds;    // of a frame
  std::vector<std::string> others;  // "stencil-volume takes 20.1 ms"
  std::vector<std::string> refused; // "planar: a receiver is not flat"
};
std::string Explain(const Reasons& reasons, const ShadowBudget& budget);

// Seconds as a user reads them: "12.3 ms".
std::string SecondsText(double seconds);

}

#endif
