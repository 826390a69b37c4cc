// Which technique a light has, and why: what a scene asks of a technique, which errors a budget
// allows, and the sentence that says why. Plain C++, no VTK, no OpenGL.
#ifndef vtkshadows_TechniqueChoice_h
#define vtkshadows_TechniqueChoice_h

#include "VisibilityError.h"

#include <optional>
#include <string>
#include <vector>

namespace vtkshadows
{

// A technique, with those of its settings that are chosen with it.
struct ShadowSetting
{
  std::string technique;
  int resolution = 0; // texels on the longer side of a map, or of a plane's texture; 0: it has none
  int cascades = 1;
  std::string filter; // of a depth map
  int samples = 0;    // lights that stand for one with a radius; 0: not its own to choose

  static ShadowSetting By(const std::string& technique, int samples = 0)
  {
    ShadowSetting setting;
    setting.technique = technique;
    setting.samples = samples;
    return setting;
  }
  static ShadowSetting Map(
    int resolution, const std::string& filter, int cascades = 1, int samples = 0)
  {
    ShadowSetting setting = By("depth-map", samples);
    setting.resolution = resolution;
    setting.cascades = cascades;
    setting.filter = filter;
    return setting;
  }
  bool IsMap() const { return this->technique == "depth-map"; }
  bool IsSampled() const { return this->samples > 0; }
  // "depth-map (2048 texels, 4 cascades, filter exact)", "ray-cast (16 samples)"
  std::string Text() const;
  bool operator==(const ShadowSetting& other) const
  {
    return this->technique == other.technique && this->resolution == other.resolution &&
      this->cascades == other.cascades && this->filter == other.filter &&
      this->samples == other.samples;
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
  bool isTooLarge = false;          // to be traced only for a measure
  double triangles = 0.0;           // that cast
  double pixels = 0.0;              // of the viewport
};

struct LightNeeds
{
  bool isSoft = false; // has a radius
  bool isDirectional = false;
  int views = 1; // that a map of it has, at most: a cube's faces about a light amid its casters
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

// Whether rays tell what casts in a scene, and may be asked.
bool HasTruth(const SceneNeeds& scene, std::string* why = nullptr);

// What is asked of the choice. Neither: no gross error, and the fastest.
struct ShadowBudget
{
  std::optional<double> maximumError;   // percent: mismatch; soft lights: mean absolute difference
  std::optional<double> maximumSeconds; // a frame

  // The most accurate is sought that keeps to it, and not the fastest.
  bool IsOfTimeAlone() const { return this->maximumSeconds && !this->maximumError; }
};

// What a measure found, in percent of the receiver pixels.
struct ErrorPercents
{
  double mismatch = 0.0;
  double gross = 0.0;
  double meanDifference = 0.0;
  double penumbraDifference = 0.0; // mean, of the penumbra's pixels
  double pixels = 0.0;             // that were measured
  bool isSampled = false;          // they stand for more of them
  double penumbraDeviation = 0.0;  // standard error of penumbraDifference then; 0: not known
  bool isBySampleLights = false;   // whose number decides about the penumbra, and hardly the view

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
// too, or a single one where every pixel was measured; and no more mismatch than passes for edges,
// where things are so thin that no pixel is far from one; of a soft light what is hard to see
// beside the truth: a mean difference over all pixels, and one over those of the penumbra, where
// few samples show as steps.
constexpr double MostGrossPercent = 0.001;
constexpr int MostGrossPixels = 1;
constexpr double MostMismatchPercent = 2.0;
constexpr double MostSoftDifferencePercent = 1.0;
constexpr double MostPenumbraDifferencePercent = 4.0;

// Times what was measured that an error may be at once, to be held against a limit.
constexpr double ErrorMargin = 1.05;

// `margin`: times the error that was measured that it may have become, at least 1; not of penumbrae
// by sample lights. What was measured on a sample of pixels has two standard deviations more.
bool IsWithin(const ShadowBudget& budget, const ErrorPercents& error, bool isSoft, double margin);
// Whether it has gross error, which no budget of error is held against.
bool IsGross(const ErrorPercents& error, double margin = 1.0);
// Whether chance decides, without a budget of error: it is gross by so few of a sample's pixels, or
// its penumbra is so close to the limit; and nothing else decides. All pixels are to be looked at
// then.
bool HangsOnFewPixels(const ErrorPercents& error, bool isSoft);
// "no gross error" or "at most 0.5 % wrong".
std::string BudgetText(const ShadowBudget& budget);
// The figure that a budget is about: "0.3 % gross".
std::string ErrorText(const ErrorPercents& error, const ShadowBudget& budget, bool isSoft);

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
