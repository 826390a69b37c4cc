// Shadow catchers: their alpha against the light's visibility and closed forms, what is seen
// through them, before them and from below, among VTK's other means; the fitted floor; pictures
// with alpha.
#include "ShadowTest.h"

#include "vtkShadowFloor.h"
#include "vtkShadowMatte.h"
#include "vtkShadowOpenGL.h"

#include <vtkCubeSource.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLFXAAPass.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkSSAAPass.h>
#include <vtkStringArray.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace shadowtest;

namespace
{

const glm::dvec3 SunAlong(0.6, 0.3, -1.0);
const glm::dvec3 LitPlace(-0.9, -1.2, 0.0), ShadowPlace(0.95, 0.4, 0.0);

std::vector<std::string> Techniques()
{
  vtkNew<vtkStringArray> array;
  vtkShadowPass::GetTechniqueNames(array);
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    if (array->GetValue(i) != "none")
    {
      names.push_back(array->GetValue(i));
    }
  }
  return names;
}

// A box in the sun over a catcher, on white.
class Catcher : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    this->Floor = AddFloor(this->Renderer, 5.0);
    vtkShadowPass::SetShadowCatcher(this->Floor, true);
    this->Box = AddBox(this->Renderer, { -0.6, -0.6, 1.0 }, { 0.6, 0.6, 1.6 });
    this->Sun = AddSun(this->Renderer, SunAlong);
    LookAt(this->Renderer, { 0.0, -6.0, 6.0 }, { 0.0, 0.0, 0.3 });
    this->Renderer->SetPass(this->Shadows);
  }

  Frame Without(vtkProp* prop)
  {
    prop->VisibilityOff();
    Frame frame = this->Render();
    prop->VisibilityOn();
    return frame;
  }

  int RedAt(const Frame& frame, const glm::dvec3& placeWC)
  {
    const Pixel p = PixelOf(this->Renderer, placeWC);
    return frame.rgb[3 * (std::size_t(p.y) * frame.width + p.x)];
  }

  vtkSmartPointer<vtkActor> Floor, Box;
  vtkSmartPointer<vtkLight> Sun;
};

// The largest difference, over all pixels, of `frame` from `over` with `colour` laid on by `alpha`.
double LargestDifference(const Frame& frame, const Frame& over, const double colour[3],
  const std::function<double(std::size_t)>& alpha)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < frame.rgb.size(); ++i)
  {
    const double a = alpha(i / 3);
    const double expected = (1.0 - a) * over.rgb[i] + a * 255.0 * colour[i % 3];
    largest = std::max(largest, std::abs(frame.rgb[i] - expected));
  }
  return largest;
}

}

//------------------------------------------------------------------------------
TEST_F(Catcher, AlphaIsOneMinusVisibility)
{
  const double black[3] = { 0.0, 0.0, 0.0 };
  for (const std::string& technique : Techniques())
  {
    this->Shadows->SetTechnique(technique);
    const Frame plain = this->Without(this->Floor);
    const Frame frame = this->Render();
    const Visibility seen = this->VisibilityOf(this->Sun);
    std::size_t inShadow = 0;
    const double largest = LargestDifference(frame, plain, black,
      [&](std::size_t i)
      {
        const bool isFloor = plain.rgb[3 * i] == 255 && plain.rgb[3 * i + 1] == 255;
        inShadow += isFloor && seen.values[i] < 0.5f ? 1 : 0;
        return isFloor ? 1.0 - seen.values[i] : 0.0;
      });
    CheckAtLeast(technique + ": values in shadow", static_cast<double>(inShadow), 3000.0);
    CheckAtMost(technique + ": largest difference, of 255", largest, 1.0);
  }
}

// A soft light, colour and strength.
TEST_F(Catcher, ColourAndStrength)
{
  const double colour[3] = { 0.9, 0.4, 0.1 };
  vtkShadowPass::SetCatcherColor(this->Floor, colour[0], colour[1], colour[2]);
  vtkShadowPass::SetCatcherStrength(this->Floor, 0.6);
  this->Shadows->SetLightRadius(this->Sun, 0.15);
  for (const std::string& technique : Techniques())
  {
    this->Shadows->SetTechnique(technique);
    const Frame plain = this->Without(this->Floor);
    const Frame frame = this->Render();
    const Visibility seen = this->VisibilityOf(this->Sun);
    CheckAtMost(technique + ": largest difference, of 255",
      LargestDifference(frame, plain, colour,
        [&](std::size_t i)
        { return plain.rgb[3 * i] == 255 ? 0.6 * (1.0 - seen.values[i]) : 0.0; }),
      1.25); // VTK blends in half floats
  }
}

// Of two suns the one that is not seen counts by its luminance and its height; ambient light
// counts, and so does a light's own shadow strength.
TEST_F(Catcher, ShareOfTheLight)
{
  const glm::dvec3 otherAlong(-0.6, -0.5, -1.0);
  auto other = AddSun(this->Renderer, otherAlong);
  this->Sun->SetColor(1.0, 0.5, 0.25);
  other->SetColor(0.1, 0.4, 1.0);
  other->SetIntensity(0.8);
  const auto arriving = [](vtkLight* light, const glm::dvec3& along)
  {
    const double* c = light->GetDiffuseColor();
    return light->GetIntensity() * (0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]) *
      -glm::normalize(along).z;
  };
  const double first = arriving(this->Sun, SunAlong), second = arriving(other, otherAlong);
  this->Shadows->SetTechnique("stencil-volume");
  const auto expected = [&](double ambient, double diffuse, double strength)
  { return 255.0 * (1.0 - strength * diffuse * first / (ambient + diffuse * (first + second))); };
  Check("two lights", this->RedAt(this->Render(), ShadowPlace), expected(0.0, 1.0, 1.0), 1.0);
  this->Shadows->SetLightStrength(this->Sun, 0.5);
  Check("strength 0.5", this->RedAt(this->Render(), ShadowPlace), expected(0.0, 1.0, 0.5), 1.0);
  this->Shadows->SetLightStrength(this->Sun, 1.0);
  this->Floor->GetProperty()->SetAmbient(0.3);
  this->Floor->GetProperty()->SetDiffuse(0.7);
  Check("ambient 0.3", this->RedAt(this->Render(), ShadowPlace), expected(0.3, 0.7, 1.0), 1.0);
  this->Floor->GetProperty()->SetAmbient(0.0);
  this->Floor->GetProperty()->SetDiffuse(1.0);
  this->Shadows->SetLightTechnique(other, "none");
  Check(
    "other light by none", this->RedAt(this->Render(), ShadowPlace), expected(0.0, 1.0, 1.0), 1.0);
  Check("lit place", this->RedAt(this->Render(), LitPlace), 255.0);

  // Physically based, it is another surface, but much the same share.
  this->Floor->GetProperty()->SetInterpolationToPBR();
  this->Floor->GetProperty()->SetRoughness(1.0);
  Check("physically based", this->RedAt(this->Render(), ShadowPlace), expected(0.0, 1.0, 1.0), 8.0);
  this->Floor->GetProperty()->LightingOff();
  Check("without lighting", this->RedAt(this->Render(), ShadowPlace), 255.0);
}

// All of the floor in shadow: alpha is the fade alone.
TEST_F(Catcher, Fade)
{
  AddBox(this->Renderer, { -40.0, -40.0, 20.0 }, { 40.0, 40.0, 21.0 });
  this->Floor->SetScale(0.4, 0.2, 1.0); // 2 and 1 from the middle to the rim
  this->Box->VisibilityOff();
  LookAt(this->Renderer, { 0.0, -0.01, 8.0 }, { 0.0, 0.0, 0.0 });
  for (const std::string& technique : Techniques())
  {
    if (technique == "depth-map")
    {
      continue; // by the other test; here its floor is all inside
    }
    this->Shadows->SetTechnique(technique);
    vtkShadowPass::SetCatcherFade(this->Floor, 0.5);
    const Frame frame = this->Render();
    Check(technique + ": middle", this->RedAt(frame, { 0.0, 0.0, 0.0 }), 0.0, 1.0);
    // The steepest slope is 1.5 over half of 2 world units: 3 of 255 a pixel.
    Check(
      technique + ": half of the fade along x", this->RedAt(frame, { 1.5, 0.0, 0.0 }), 127.5, 4.0);
    Check(
      technique + ": half of it along both", this->RedAt(frame, { -1.5, 0.75, 0.0 }), 191.25, 6.0);
    CheckAtLeast(technique + ": rim along x", this->RedAt(frame, { 1.98, 0.0, 0.0 }), 253.0);
    CheckAtLeast(technique + ": rim along y", this->RedAt(frame, { 0.0, -0.98, 0.0 }), 251.0);
    vtkShadowPass::SetCatcherFade(this->Floor, 0.0);
    Check(technique + ": rim without fade", this->RedAt(this->Render(), { 1.98, 0.0, 0.0 }), 0.0);
  }
}

//------------------------------------------------------------------------------
TEST_F(Catcher, ShowsNothingWithoutShadows)
{
  this->Renderer->SetPass(nullptr);
  const Frame without = this->Without(this->Floor);
  Check("without the pass", static_cast<double>(CountDifferent(without, this->Render())), 0.0);
  this->Renderer->SetPass(this->Shadows);
  this->Shadows->SetTechnique("none");
  Check("by none", static_cast<double>(CountDifferent(without, this->Render())), 0.0);
  this->Shadows->SetTechnique("depth-map");
  CheckAtLeast(
    "by depth map", static_cast<double>(CountDifferent(without, this->Render())), 1000.0);
  this->Sun->SetLightTypeToHeadlight();
  const Frame byHeadlight = this->Render();
  Check("by a headlight",
    static_cast<double>(CountDifferent(this->Without(this->Floor), byHeadlight)), 0.0);
  this->Renderer->SetPass(nullptr);
  Check("after all",
    static_cast<double>(CountDifferent(this->Without(this->Floor), this->Render())), 0.0);

  // And made an ordinary floor again.
  vtkShadowPass::SetShadowCatcher(this->Floor, false);
  Check("opacity", this->Floor->GetProperty()->GetOpacity(), 1.0);
  CheckAtLeast(
    "plain floor", static_cast<double>(CountDifferent(without, this->Render())), 10000.0);
}

// From below, the light is on the other side: nothing is shown, nothing hidden, and what is seen is
// shadowed as without the catcher.
TEST_F(Catcher, FromBelow)
{
  AddBox(this->Renderer, { 0.5, -0.2, 2.0 }, { 1.5, 0.6, 2.5 });
  AddBox(this->Renderer, { -0.3, -0.3, -1.0 }, { 0.3, 0.3, -0.7 });
  LookAt(this->Renderer, { 2.0, -6.0, -3.0 }, { 0.0, 0.0, 0.3 });
  for (const std::string& technique : Techniques())
  {
    if (technique == "depth-map")
    {
      continue; // its fit sees the receivers: below, to the texel
    }
    this->Shadows->SetTechnique(technique);
    const Frame without = this->Without(this->Floor);
    Check(technique + ": pixels changed",
      static_cast<double>(CountDifferent(without, this->Render())), 0.0);
  }
  this->Shadows->SetTechnique("depth-map");
  CheckAtMost("depth-map: pixels changed",
    static_cast<double>(CountDifferent(this->Without(this->Floor), this->Render(), 8)), 60.0);
}

// A light from below shines on the side that is seen then: what is beneath casts on it, and what is
// above, seen through it, keeps its own shadows.
TEST_F(Catcher, FromBelowInALightFromBelow)
{
  AddBox(this->Renderer, { -0.3, -0.3, -1.3 }, { 0.3, 0.3, -1.0 });
  AddSun(this->Renderer, { -0.5, 0.0, 1.0 });
  LookAt(this->Renderer, { 2.0, -6.0, -5.0 }, { 0.0, 0.0, 0.0 });
  const glm::dvec3 caught(-0.6, 0.0, 0.0), elsewhere(0.9, -0.5, 0.0);
  for (const std::string& technique : Techniques())
  {
    this->Shadows->SetTechnique(technique);
    const Frame without = this->Without(this->Floor);
    const Frame frame = this->Render();
    Check(technique + ": caught", this->RedAt(frame, caught), 0.0, 1.0);
    Check(
      technique + ": elsewhere", this->RedAt(frame, elsewhere), this->RedAt(without, elsewhere));
  }
}

// A slab beneath, seen through the catcher, keeps its own shadows; a ball that reaches through is
// right on both sides.
TEST_F(Catcher, BeneathAndThrough)
{
  auto slab = AddBox(this->Renderer, { -4.0, -4.0, -1.2 }, { 4.0, 4.0, -1.0 });
  vtkShadowPass::SetCastsShadows(slab, false);
  AddSphere(this->Renderer, { -1.8, -0.8, 0.0 }, 0.5);
  vtkShadowPass::SetCatcherStrength(this->Floor, 0.5);
  for (const std::string& technique : Techniques())
  {
    this->Shadows->SetTechnique(technique);
    const Frame without = this->Without(this->Floor);
    const Frame alone = this->Without(slab); // the figures' part is `without`'s own
    slab->VisibilityOff();
    const Frame figures = this->Without(this->Floor);
    slab->VisibilityOn();
    const Frame frame = this->Render();
    std::size_t caught = 0, wrong = 0;
    for (std::size_t i = 0; i < frame.rgb.size(); ++i)
    {
      // What the catcher takes of white where no figure is before it; of the ball's lower half it
      // takes nothing, as no light falls there but from above.
      const bool isFree = figures.rgb[i] == 255;
      const double share = isFree ? alone.rgb[i] / 255.0 : 1.0;
      caught += isFree && share < 0.9 ? 1 : 0;
      wrong += isFree && std::abs(frame.rgb[i] - share * without.rgb[i]) > 2.0 ? 1 : 0;
    }
    CheckAtLeast(
      technique + ": values with a catcher's shadow", static_cast<double>(caught), 10000.0);
    // A map is fitted to the receivers: without the slab it is another.
    const double limit = technique == "depth-map" ? 0.01 * static_cast<double>(caught) : 0.0;
    CheckAtMost(technique + ": of them wrong", static_cast<double>(wrong), limit);
  }
}

// One round of masks serves a floor under a figure; a prop beneath, though it is not seen, asks for
// two.
TEST_F(Catcher, OneRoundOfMasksOrTwoAreTheSame)
{
  this->Shadows->SetTechnique("ray-cast");
  SHADOWTEST_NEEDS_RAY_CAST();
  const Frame shared = this->Render();
  auto below = AddBox(this->Renderer, { 20.0, 20.0, -3.0 }, { 21.0, 21.0, -2.0 }); // out of view
  vtkShadowPass::SetCastsShadows(below, false);
  Check("pixels that differ between one round of masks and two",
    static_cast<double>(CountDifferent(shared, this->Render())), 0.0);
}

//------------------------------------------------------------------------------
TEST_F(Catcher, AmongOtherMeans)
{
  this->Window->SetAlphaBitPlanes(1);
  const std::vector<std::pair<std::string, std::function<void(bool)>>> means = {
    { "depth peeling", [this](bool on) { this->Renderer->SetUseDepthPeeling(on); } },
    { "FXAA", [this](bool on) { this->Renderer->SetUseFXAA(on); } },
    { "SSAO", [this](bool on) { this->Renderer->SetUseSSAO(on); } },
    { "MSAA", [this](bool on) { this->Window->SetMultiSamples(on ? 4 : 0); } },
    { "viewport",
      [this](bool on)
      { this->Renderer->SetViewport(on ? 0.2 : 0.0, 0.0, on ? 0.8 : 1.0, on ? 0.9 : 1.0); } },
    { "parallel",
      [this](bool on)
      {
        this->Renderer->GetActiveCamera()->SetParallelProjection(on);
        this->Renderer->GetActiveCamera()->SetParallelScale(3.0);
      } },
  };
  for (const std::string& technique : Techniques())
  {
    this->Shadows->SetTechnique(technique);
    for (const auto& each : means)
    {
      each.second(true);
      const Frame frame = this->Render();
      const int* origin = this->Renderer->GetOrigin();
      const Pixel lit = PixelOf(this->Renderer, LitPlace);
      const Pixel dark = PixelOf(this->Renderer, ShadowPlace);
      Check(technique + ", " + each.first + ": lit",
        frame.Brightness(origin[0] + lit.x, origin[1] + lit.y), 765.0);
      Check(technique + ", " + each.first + ": shadow",
        frame.Brightness(origin[0] + dark.x, origin[1] + dark.y), 0.0, 3.0);
      each.second(false);
    }
  }
}

TEST_F(Catcher, UnderAndOverOtherPasses)
{
  vtkNew<vtkRenderStepsPass> steps, stepsOfFxaa, alone;
  vtkNew<vtkSSAAPass> over, under;
  under->SetDelegatePass(steps);
  vtkNew<vtkOpenGLFXAAPass> fxaa;
  fxaa->SetDelegatePass(stepsOfFxaa);
  over->SetDelegatePass(this->Shadows);
  const auto check = [this](const std::string& what)
  {
    const Frame frame = this->Render();
    Check(what + ": lit", this->RedAt(frame, LitPlace), 255.0, 1.0);
    Check(what + ": shadow", this->RedAt(frame, ShadowPlace), 0.0, 1.0);
  };
  for (const std::string& technique : Techniques())
  {
    this->Shadows->SetTechnique(technique);
    this->Renderer->SetPass(over);
    check(technique + ", under SSAA");
    this->Renderer->SetPass(this->Shadows);
    for (vtkRenderPass* delegate : { static_cast<vtkRenderPass*>(under.Get()),
           static_cast<vtkRenderPass*>(fxaa), static_cast<vtkRenderPass*>(alone) })
    {
      this->Shadows->SetDelegatePass(delegate);
      check(technique + ", over " + delegate->GetClassName());
    }
    this->Shadows->SetDelegatePass(nullptr);
  }
}

// It leaves no depth, no state, and is not cut by a clipping range that its bounds do not count in.
TEST_F(Catcher, LeavesNothingBehind)
{
  this->Floor->UseBoundsOff();
  this->Renderer->ResetCameraClippingRange();
  this->Box->SetScale(1.0, 1.0, 0.01); // a thin figure: a short range
  this->Box->SetPosition(0.0, 0.0, 1.0);
  LookAt(this->Renderer, { 0.0, -6.0, 6.0 }, { 0.0, 0.0, 0.3 });
  this->Renderer->GetActiveCamera()->SetClippingRange(6.5, 8.5);
  for (const std::string& technique : Techniques())
  {
    this->Shadows->SetTechnique(technique);
    const Frame frame = this->Render();
    Check(technique + ": shadow", this->RedAt(frame, ShadowPlace), 0.0, 1.0);
    // The floor's near and far parts are cut off by the camera, were it not for the clamp.
    const double lowest = *std::min_element(frame.rgb.begin(), frame.rgb.end());
    Check(technique + ": darkest", lowest, 0.0, 1.0);
    Check(technique + ": depth clamp", glIsEnabled(GL_DEPTH_CLAMP), 0.0);
    const Pixel p = PixelOf(this->Renderer, ShadowPlace);
    Check(technique + ": depth in the shadow", this->Renderer->GetZ(p.x, p.y), 1.0);
  }
}

TEST_F(Catcher, IsMeasuredAgainstTheTruth)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  for (const std::string& technique : Techniques())
  {
    this->Shadows->SetTechnique(technique);
    this->Render();
    this->CheckMeasure(technique + ", alone", this->Sun, 0.2, 0.0);
  }
  AddBox(this->Renderer, { -4.0, -4.0, -1.2 }, { 4.0, 4.0, -1.0 });
  for (const std::string& technique : Techniques())
  {
    this->Shadows->SetTechnique(technique);
    this->Render();
    this->CheckMeasure(technique + ", over a slab", this->Sun, 0.2, 0.0);
  }
}

TEST_F(Catcher, RefusesWhatIsNotFinite)
{
  vtkShadowPass::SetCatcherStrength(this->Floor, std::nan(""));
  ExpectOneMessage({ "SetCatcherStrength", "0 to 1", "nan" });
  vtkShadowPass::SetShadowCatcher(nullptr, true);
  ExpectOneMessage({ "SetShadowCatcher(nullptr", "vtkActor" });
  vtkShadowPass::SetCatcherStrength(this->Floor, 7.0);
  double color[3], strength = 0.0, fade = 0.0;
  EXPECT_TRUE(vtkShadowPass::GetCatcherSettings(this->Floor, color, strength, fade));
  Check("strength, clamped", strength, 1.0);
  EXPECT_FALSE(vtkShadowPass::GetCatcherSettings(this->Box, color, strength, fade));
}

//------------------------------------------------------------------------------
// The floor's centre, normal and side, in the world.
namespace
{

void CheckFloor(const std::string& what, vtkShadowFloor* floor, const glm::dvec3& centre,
  const glm::dvec3& normal, double side)
{
  const double* m = floor->GetActor()->GetUserMatrix()->GetData();
  const glm::dvec3 gotCentre(m[3], m[7], m[11]), gotNormal(m[2], m[6], m[10]);
  Check(what + ": distance of the centre", glm::length(gotCentre - centre), 0.0, 1e-5 * side);
  Check(what + ": side", glm::length(gotNormal), side, 1e-5 * side);
  Check(what + ": cosine of the normals", glm::dot(glm::normalize(gotNormal), normal), 1.0, 1e-9);
}

}

TEST_F(Catcher, FloorFitsTheScene)
{
  vtkNew<vtkShadowFloor> floor;
  floor->SetSize(2.0);
  ASSERT_TRUE(floor->Fit(this->Renderer)); // the catcher does not count
  CheckFloor("up is z", floor, { 0.0, 0.0, 1.0 - 5e-4 * 1.2 }, { 0.0, 0.0, 1.0 }, 2.4);

  // By its points: the bounds of a turned ball reach lower than it does.
  auto ball = AddSphere(this->Renderer, { 0.0, 0.0, 0.0 }, 0.5, 96);
  ball->SetPosition(0.0, 0.0, -2.0);
  ball->RotateX(45.0);
  CheckAtMost("turned: lowest of the bounds", ball->GetBounds()[4], -2.7);
  ASSERT_TRUE(floor->Fit(this->Renderer));
  Check("turned: height", floor->GetActor()->GetUserMatrix()->GetElement(2, 3), -2.5 - 5e-4 * 4.1,
    1e-3);
  ball->VisibilityOff();

  floor->SetNormal(0.0, -3.0, 0.0);
  ASSERT_TRUE(floor->FitAt(this->Renderer, 7.0));
  CheckFloor("given plane", floor, { 0.0, -7.0, 1.3 }, { 0.0, -1.0, 0.0 }, 2.4);

  floor->SetSize(0.0);
  EXPECT_FALSE(floor->Fit(this->Renderer));
  ExpectOneMessage({ "Size 0", "above 0" });
  floor->SetSize(1.0);
  this->Box->VisibilityOff();
  EXPECT_FALSE(floor->Fit(this->Renderer));
  ExpectOneMessage({ "nothing with an extent", "add actors" });
  vtkNew<vtkRenderer> fresh;
  AddBox(fresh, { -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 });
  floor->SetNormal(0.0, 0.0, 0.0);
  ASSERT_TRUE(floor->Fit(fresh));
  CheckFloor(
    "without a camera, up is y", floor, { 0.0, -1.0 - 5e-4 * 2.0, 0.0 }, { 0.0, 1.0, 0.0 }, 2.0);
  EXPECT_FALSE(fresh->IsActiveCameraCreated()) << "VTK would not reset it in its first frame";
}

//------------------------------------------------------------------------------
TEST_F(Catcher, MatteIsRightOverAnyPage)
{
  vtkShadowPass::SetCatcherColor(this->Floor, 0.2, 0.1, 0.5);
  vtkShadowPass::SetCatcherStrength(this->Floor, 0.7);
  auto pane = AddBox(this->Renderer, { -3.0, -1.0, 0.5 }, { -2.0, 0.0, 0.6 });
  pane->GetProperty()->SetOpacity(0.4);
  pane->GetProperty()->SetColor(0.9, 0.3, 0.2);
  this->Shadows->SetTechnique("stencil-volume");
  this->Shadows->SetLightRadius(this->Sun, 0.1);
  this->Renderer->GradientBackgroundOn();
  this->Renderer->SetBackground(0.3, 0.2, 0.1);
  const Frame before = this->Render();

  vtkNew<vtkShadowMatte> matte;
  vtkNew<vtkImageData> image;
  ASSERT_TRUE(matte->Grab(this->Window, image));
  Check("components", image->GetNumberOfScalarComponents(), 4.0);
  Check(
    "pixels changed afterwards", static_cast<double>(CountDifferent(before, this->Render())), 0.0);

  this->Renderer->GradientBackgroundOff();
  const auto* rgba = static_cast<const unsigned char*>(image->GetScalarPointer());
  for (const auto& page : { glm::dvec3(1.0), glm::dvec3(0.0), glm::dvec3(1.0, 0.0, 1.0) })
  {
    this->Renderer->SetBackground(page.x, page.y, page.z);
    const Frame over = this->Render();
    double largest = 0.0;
    for (std::size_t i = 0; i < over.rgb.size(); ++i)
    {
      const std::size_t pixel = i / 3, c = i % 3;
      const double alpha = rgba[4 * pixel + 3] / 255.0;
      const double laid = alpha * rgba[4 * pixel + c] + (1.0 - alpha) * 255.0 * page[int(c)];
      largest = std::max(largest, std::abs(laid - over.rgb[i]));
    }
    CheckAtMost("largest difference, of 255, over " + std::to_string(page.x) + " " +
        std::to_string(page.y) + " " + std::to_string(page.z),
      largest, 1.5);
  }
  EXPECT_FALSE(matte->Grab(nullptr, image));
  ExpectOneMessage({ "Grab(", "vtkRenderWindow" });
}
