// Every technique at the extremes: against its own picture of the plain still life, and against the
// truth. `vtkshadows_extremes_table` prints the figures, Docs/Extremes.md has them.
#include "ShadowTest.h"

#include "ExtremeMeasure.h"

#include <algorithm>
#include <cstdio>
#include <map>

using namespace shadowtest;
using vtkshadows::ExtremeCase;
using vtkshadows::ExtremeOutcome;

namespace
{

// Against the truth: share of pixels in percent, and pixels more than 2 px from a true edge.
struct Limits
{
  double mismatch;
  double gross;
};

// Techniques for planes and textures alone leave self-shadows out, and have no limits here.
const std::map<std::string, Limits> LimitsOf = { { "depth-map", { 0.5, 2 } },
  { "depth-map exact", { 0.05, 0 } }, { "object-id", { 0.5, 2 } },
  { "stencil-volume", { 0.02, 0 } }, { "ray-cast", { 0.0, 0 } } };

// Volumes are counted at the depths of planes, which choose another wall than VTK's own where two
// meet that it draws 0.3 units off.
const Limits OfVolumesInRoomsDrawnOff = { 0.1, 40 };

// What "shadow-texture" says of scenes in which it darkens nothing.
const char* const NoTextures = "All that receives casts, too";

// What "planar" says of scenes that are one mesh or one data set.
const char* const NoPlanes = "No receiver lies in a plane";

class Extremes : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Window->RemoveRenderer(this->Renderer); // the measure has its own
  }

  // All that is not heavy and of one of these kinds.
  void CheckKinds(const std::vector<std::string>& kinds)
  {
    vtkshadows::ExtremeMeasure measure(this->Window);
    int cases = 0;
    for (const ExtremeCase& extreme : vtkshadows::ExtremeCases())
    {
      const bool isWanted = std::any_of(kinds.begin(), kinds.end(),
        [&](const std::string& kind) { return extreme.kind.compare(0, kind.size(), kind) == 0; });
      if (!isWanted || extreme.isHeavy)
      {
        continue;
      }
      ++cases;
      for (const std::string& technique : vtkshadows::ExtremeTechniques())
      {
        const ExtremeOutcome outcome = measure.Measure(extreme, technique);
        this->CheckMessages(extreme, technique);
        this->CheckOutcome(extreme, technique, outcome);
      }
    }
    CheckAtLeast("cases", cases, 1);
  }

private:
  void CheckMessages(const ExtremeCase& extreme, const std::string& technique)
  {
    const std::string what = extreme.Name() + ", " + technique;
    const std::vector<std::string> messages = TakeMessages();
    // One of the case, and one of what it is held against.
    CheckAtMost(what + ": messages", static_cast<double>(messages.size()), extreme.plain ? 2 : 1);
    for (const std::string& message : messages)
    {
      const bool isExpected = extreme.isBroken ||
        (technique == "shadow-texture" && message.find(NoTextures) != std::string::npos) ||
        (technique == "planar" && message.find(NoPlanes) != std::string::npos);
      EXPECT_TRUE(isExpected) << what << " said: " << message;
    }
  }

  void CheckOutcome(
    const ExtremeCase& extreme, const std::string& technique, const ExtremeOutcome& outcome)
  {
    const std::string what = extreme.Name() + ", " + technique;
    EXPECT_TRUE(outcome.made) << what << ": no visibility";
    Check(what + ": OpenGL error", outcome.openGLError, 0);
    if (extreme.isBeyond)
    {
      std::printf("       %s: alike %.4g %%, mismatch %.4g %%, gross %lld\n", what.c_str(),
        outcome.agreement, outcome.MismatchPercent(), static_cast<long long>(outcome.gross));
      return;
    }
    if (extreme.looksPlain)
    {
      // A matrix moves vertices by the rounding of floats. What is 1e6 times as wide VTK draws up
      // to 0.3 units off, each mesh by itself: it shows other pixels of feet and of a room's
      // corners.
      const bool isOff = extreme.plain && extreme.value == "1e+06";
      const double least = isOff ? 99.8 : extreme.kind == "matrix" ? 99.98 : 99.99;
      // Rays start off a face by what all positions in the scene are rounded by. A wide floor is
      // none of their casters, which makes that less: pixels of grazing light differ.
      const double ofRays = extreme.kind == "floor wider by" ? 99.98 : least;
      CheckAtLeast(what + ": alike %", outcome.agreement, technique == "ray-cast" ? ofRays : least);
      if (outcome.truthAgreement >= 0.0)
      {
        CheckAtLeast(what + ": truth alike %", outcome.truthAgreement, ofRays);
      }
    }
    const auto known = LimitsOf.find(technique);
    if (outcome.receivers > 0 && known != LimitsOf.end())
    {
      const bool isRoomOff =
        extreme.value == "1e+06" && extreme.kind.find("wall") != std::string::npos;
      const Limits& limits =
        isRoomOff && technique == "stencil-volume" ? OfVolumesInRoomsDrawnOff : known->second;
      CheckAtMost(what + ": mismatch %", outcome.MismatchPercent(), limits.mismatch);
      CheckAtMost(what + ": gross", static_cast<double>(outcome.gross), limits.gross);
    }
  }
};

}

TEST_F(Extremes, Scales)
{
  this->CheckKinds({ "scale" });
}

TEST_F(Extremes, Offsets)
{
  this->CheckKinds({ "offset", "small and far" });
}

TEST_F(Extremes, OtherLightsAndCellars)
{
  this->CheckKinds({ "sun plain", "sun", "lamp within", "cellar" });
}

TEST_F(Extremes, Views)
{
  this->CheckKinds({ "near:far", "view", "window" });
}

TEST_F(Extremes, PlacesOfLights)
{
  this->CheckKinds({ "light distance", "light" });
}

TEST_F(Extremes, Cones)
{
  this->CheckKinds({ "cone" });
}

TEST_F(Extremes, Floors)
{
  this->CheckKinds({ "floor" });
}

TEST_F(Extremes, Meshes)
{
  this->CheckKinds({ "slivers", "fan", "triangles" });
}

TEST_F(Extremes, MatricesAndBrokenCoordinates)
{
  this->CheckKinds({ "matrix", "coordinates" });
}

// Against the same as wide as a floor is in the plain still life, where it is a caster.
TEST_F(Extremes, WideFloorsHaveTheTruthOfOthers)
{
  vtkshadows::ExtremeMeasure measure(this->Window);
  int cases = 0;
  for (ExtremeCase extreme : vtkshadows::ExtremeCases())
  {
    if (extreme.plain && extreme.value == "12" &&
      extreme.kind.find("all else") == std::string::npos)
    {
      ++cases;
      extreme.looksPlain = true;
      CheckAtLeast(extreme.Name() + ": truth alike %",
        measure.Measure(extreme, "ray-cast").truthAgreement, 99.98);
    }
  }
  CheckAtLeast("cases", cases, 6);
}

// It is no caster for an eye before it. Behind it, all that is seen of the floor is in its shadow.
TEST_F(Extremes, AWideWallCastsForAnEyeBehindIt)
{
  vtkshadows::ExtremeMeasure measure(this->Window);
  int cases = 0;
  for (ExtremeCase extreme : vtkshadows::ExtremeCases())
  {
    if (extreme.Name() != "floor and wall wider by 100")
    {
      continue;
    }
    ++cases;
    const auto widen = extreme.change;
    extreme.looksPlain = false;
    extreme.change = [widen](vtkshadows::ExtremeScene& scene)
    {
      widen(scene);
      scene.eye = { -2.0, 12.0, 6.0 };
      scene.focus = { -2.0, 5.0, 0.0 };
    };
    for (const char* technique : { "depth-map", "stencil-volume", "ray-cast" })
    {
      const ExtremeOutcome outcome = measure.Measure(extreme, technique);
      CheckAtLeast("receivers", static_cast<double>(outcome.receivers), 10000);
      CheckAtLeast(std::string(technique) + ": shadowed % by the truth",
        100.0 * static_cast<double>(outcome.shadowed) / static_cast<double>(outcome.receivers),
        99.9);
      CheckAtMost(std::string(technique) + ": mismatch %", outcome.MismatchPercent(), 0.5);
    }
  }
  Check("cases", cases, 1);
}

// The measure itself: a technique that draws nothing is told from one that draws shadows.
TEST_F(Extremes, TheMeasureSeesALostShadow)
{
  vtkshadows::ExtremeMeasure measure(this->Window);
  ExtremeCase lost;
  lost.kind = "no shadows";
  lost.looksPlain = true;
  lost.change = [](vtkshadows::ExtremeScene& scene) { scene.parts.resize(1); };
  const ExtremeOutcome outcome = measure.Measure(lost, "stencil-volume");
  CheckAtMost("alike %", outcome.agreement, 90.0);
  lost.change = [](vtkshadows::ExtremeScene&) {};
  Check("the plain still life, alike %", measure.Measure(lost, "stencil-volume").agreement, 100.0);
}
