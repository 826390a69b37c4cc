// The filters, formats and biases of the depth map against the truth, soft ones against a converged
// ray cast; the classic faults of depth maps, made on purpose, and not there without; wrong
// settings.
#include "ShadowTest.h"
#include "TestScenes.h"

#include "vtkShadowErrorMeasure.h"

#include <vtkImageData.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

using namespace shadowtest;

namespace
{

using Pass = vtkDepthShadowMapPass;

class DepthMapFilters : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetPass(this->Shadows);
    this->Resize(640, 480);
    this->Maps()->SetResolution(1024);
  }
  Pass* Maps() { return this->Shadows->GetDepthShadowMapPass(); }

  // A still life with this light; what it shows is in view.
  void AddScene(bool isSpot)
  {
    const Subject subject = AddStillLife(this->Renderer);
    this->Light = isSpot ? AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0)
                         : AddSun(this->Renderer, -Toward(60.0, 40.0));
    AimCamera(this->Renderer, subject, -15.0, 28.0, 640, 480);
  }

  // A lamp amid what stands in a closed room.
  void AddRoom()
  {
    AddBox(this->Renderer, { -3.0, -3.0, 0.0 }, { 3.0, 3.0, 4.0 });
    AddSphere(this->Renderer, { 1.5, 1.5, 1.0 }, 0.6);
    AddSphere(this->Renderer, { -1.6, 0.2, 2.0 }, 0.4);
    AddBox(this->Renderer, { 0.5, -1.8, 0.0 }, { 1.3, -0.9, 0.9 });
    this->Light = AddLamp(this->Renderer, { 0.1, 0.2, 3.0 });
    this->Renderer->GetActiveCamera()->SetViewAngle(80.0);
    LookAt(this->Renderer, { 2.5, -2.6, 2.5 }, { -1.0, 1.0, 0.5 });
  }

  void Measure(const std::string& what, vtkShadowErrorMeasure* error)
  {
    this->Render();
    ASSERT_TRUE(error->Measure(this->Renderer, this->Light)) << what;
    std::printf("%-40s mismatch %.4f %% gross %lld false, %lld missed, mean difference %.5f\n",
      what.c_str(), error->GetMismatchPercent(),
      static_cast<long long>(error->GetGrossFalsePixels()),
      static_cast<long long>(error->GetGrossMissedPixels()), error->GetMeanAbsoluteDifference());
    EXPECT_GT(error->GetShadowPixels(), error->GetReceiverPixels() / 100)
      << what << ": few shadows";
  }

  // The mean difference from a ray cast of 256 sample lights.
  void CheckSoft(const std::string& what, double radius, double limit)
  {
    this->Shadows->SetLightRadius(this->Light, radius);
    this->Shadows->GetRayCastShadowPass()->SetLightSamples(256);
    vtkNew<vtkShadowErrorMeasure> error;
    this->Measure(what + ", radius " + std::to_string(radius), error);
    CheckAtMost(what + ": mean difference", error->GetMeanAbsoluteDifference(), limit);
  }

  vtkSmartPointer<vtkLight> Light;
};

}

//------------------------------------------------------------------------------
TEST_F(DepthMapFilters, HardLights)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  // Mismatch and gross as percent of the receiver pixels. Variance and exponential are no better:
  // what was measured is 0.35 and 0.24 % mismatch, and 0.87 and 0.51 %, since blurs leak light
  // where casters touch.
  const struct
  {
    int filter;
    double mismatch;
    double gross;
  } filters[] = { { Pass::PERCENTAGE_CLOSER, 0.1, 0.005 }, { Pass::NONE, 0.12, 0.005 },
    { Pass::HARDWARE, 0.1, 0.005 }, { Pass::DISC, 0.1, 0.005 }, { Pass::SOFT, 0.1, 0.005 },
    { Pass::SAMPLE_LIGHTS, 0.1, 0.005 }, { Pass::VARIANCE, 0.4, 0.005 },
    { Pass::EXPONENTIAL, 1.0, 0.035 }, { Pass::EXACT, 0.06, 0.005 } };
  for (const bool isSpot : { true, false })
  {
    this->Renderer->RemoveAllViewProps();
    this->Renderer->RemoveAllLights();
    this->AddScene(isSpot);
    for (const auto& row : filters)
    {
      this->Maps()->SetFilter(row.filter);
      const std::string what = Pass::GetFilterName(row.filter) + (isSpot ? ", spot" : ", sun");
      vtkNew<vtkShadowErrorMeasure> error;
      this->Measure(what, error);
      CheckAtMost(what + ": mismatch %", error->GetMismatchPercent(), row.mismatch);
      CheckAtMost(what + ": gross %", error->GetGrossPercent(), row.gross);
    }
  }
}

// Filters differ where they should: one texel has no values between, a kernel has many.
TEST_F(DepthMapFilters, EachIsAnother)
{
  this->AddScene(false);
  this->Render();
  std::vector<std::size_t> between;
  for (int filter = 0; filter < Pass::GetNumberOfFilters(); ++filter)
  {
    this->Maps()->SetFilter(filter);
    const Visibility visibility = this->VisibilityOf(this->Light);
    std::size_t count = 0;
    for (const float value : visibility.values)
    {
      count += value > 0.01f && value < 0.99f ? 1 : 0;
    }
    between.push_back(count);
    std::printf("%-18s %zu pixels between\n", Pass::GetFilterName(filter).c_str(), count);
  }
  Check("none: pixels between", static_cast<double>(between[Pass::NONE]), 0.0);
  CheckAtLeast("hardware", static_cast<double>(between[Pass::HARDWARE]), 1000.0);
  CheckAtLeast("disc over percentage-closer",
    static_cast<double>(between[Pass::DISC]) / between[Pass::PERCENTAGE_CLOSER], 2.0);
  CheckAtLeast("variance", static_cast<double>(between[Pass::VARIANCE]), 1000.0);
  CheckAtLeast("exponential", static_cast<double>(between[Pass::EXPONENTIAL]), 1000.0);
  Check("soft without a radius over percentage-closer",
    static_cast<double>(between[Pass::SOFT]) / between[Pass::PERCENTAGE_CLOSER], 1.0);
}

//------------------------------------------------------------------------------
TEST_F(DepthMapFilters, SoftLights)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(320, 240);
  for (const bool isSpot : { true, false })
  {
    this->Renderer->RemoveAllViewProps();
    this->Renderer->RemoveAllLights();
    this->AddScene(isSpot);
    for (const double radius : { 0.1, 0.3, 0.9 })
    {
      const double size = isSpot ? radius : 0.2 * radius;
      this->Maps()->SetFilter(Pass::SOFT);
      this->CheckSoft(isSpot ? "soft, spot" : "soft, sun", size, 0.02);
      this->Maps()->SetFilter(Pass::SAMPLE_LIGHTS);
      this->CheckSoft(isSpot ? "sample lights, spot" : "sample lights, sun", size, 0.01);
    }
  }
}

// Lights and views by lot. Of percentage-closer soft shadows the bound is the one that is aimed at.
TEST_F(DepthMapFilters, SoftLightsByLot)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(240, 180);
  for (int seed = 1; seed <= 8; ++seed)
  {
    std::mt19937 random(seed);
    const auto any = [&random](double low, double high)
    { return low + (high - low) * (random() / double(random.max())); };
    this->Renderer->RemoveAllViewProps();
    this->Renderer->RemoveAllLights();
    const Subject subject =
      seed % 2 == 0 ? AddStillLife(this->Renderer) : AddBumpyMesh(this->Renderer);
    const glm::dvec3 toward = Toward(any(0.0, 360.0), any(35.0, 80.0));
    const double distance = any(2.5, 5.0) * subject.radius;
    const glm::dvec3 place = subject.centre + distance * toward;
    const int kind = seed % 3;
    this->Light = kind == 0 ? AddSun(this->Renderer, -toward)
      : kind == 1           ? AddSpot(this->Renderer, place, subject.centre, any(25.0, 50.0))
                            : AddLamp(this->Renderer, place);
    AimCamera(this->Renderer, subject, any(0.0, 360.0), any(15.0, 70.0), 240, 180);
    const double size = any(0.01, 0.12) * (kind == 0 ? 1.0 : distance);
    const std::string what = "seed " + std::to_string(seed);
    this->Maps()->SetFilter(Pass::SOFT);
    this->CheckSoft(what + ", soft", size, 0.04);
    this->Maps()->SetFilter(Pass::SAMPLE_LIGHTS);
    this->CheckSoft(what + ", sample lights", size, 0.01);
  }
}

// Among thin things blockers lie at many depths: a bundle of tubes and arrows, and bars by lot.
TEST_F(DepthMapFilters, SoftOnThinThings)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(320, 240);
  this->Maps()->SetResolution(2048);
  this->Maps()->SetFilter(Pass::SOFT);
  for (const bool isSpot : { true, false })
  {
    this->Renderer->RemoveAllViewProps();
    this->Renderer->RemoveAllLights();
    const Subject subject = AddTubesAndGlyphs(this->Renderer);
    this->Light = isSpot ? AddSpot(this->Renderer, { 4.0, -4.0, 7.0 }, { 0.0, 0.0, 0.4 }, 32.0)
                         : AddSun(this->Renderer, { -0.5, 0.6, -1.0 });
    AimCamera(this->Renderer, subject, -15.0, 28.0, 320, 240);
    const double radii[] = { isSpot ? 0.3 : 0.05, isSpot ? 1.0 : 0.2 };
    for (const double size : radii)
    {
      this->CheckSoft(isSpot ? "tubes, spot" : "tubes, sun", size, 0.04);
    }
  }
  for (int seed = 1; seed <= 4; ++seed)
  {
    std::mt19937 random(seed);
    const auto any = [&random](double low, double high)
    { return low + (high - low) * (random() / double(random.max())); };
    this->Renderer->RemoveAllViewProps();
    this->Renderer->RemoveAllLights();
    AddFloor(this->Renderer, 6.0);
    for (int bar = 0; bar < 40; ++bar)
    {
      const glm::dvec3 low{ any(-2.0, 1.0), any(-2.0, 1.0), any(0.1, 2.5) };
      glm::dvec3 size(any(0.02, 0.08));
      size[bar % 3] = any(0.3, 2.0);
      AddBox(this->Renderer, low, low + size);
    }
    const glm::dvec3 toward = Toward(any(0.0, 360.0), any(40.0, 80.0));
    const bool isSun = seed % 2 == 0;
    this->Light = isSun ? AddSun(this->Renderer, -toward) : AddLamp(this->Renderer, 9.0 * toward);
    LookAt(this->Renderer, { 3.0, -8.0, 5.0 }, { 0.0, 0.0, 0.5 });
    for (const double widest : { 0.1, 0.25 })
    {
      const double size = any(0.02, widest) * (isSun ? 1.0 : 9.0);
      this->CheckSoft("bars, seed " + std::to_string(seed), size, 0.04);
    }
  }
}

// A lamp with a radius amid its casters: by the faces of a cube.
TEST_F(DepthMapFilters, SoftLampInARoom)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(400, 300);
  this->Maps()->SetResolution(512);
  this->Maps()->SetSampleResolution(256);
  this->AddRoom();
  this->Maps()->SetFilter(Pass::SOFT);
  this->CheckSoft("room, soft", 0.1, 0.04);
  this->Maps()->SetFilter(Pass::SAMPLE_LIGHTS);
  this->CheckSoft("room, sample lights", 0.1, 0.02);
}

// A map of a sample light is drawn again only if its light or a caster moved.
TEST_F(DepthMapFilters, SampleMapsAreKept)
{
  this->AddScene(true);
  this->Shadows->SetLightRadius(this->Light, 0.2);
  this->Maps()->SetFilter(Pass::SAMPLE_LIGHTS);
  this->Maps()->SetLightSamples(9);
  this->Render();
  const auto builds = [this]()
  { return static_cast<double>(this->Maps()->GetNumberOfMapBuilds()); };
  const double first = builds();
  CheckAtLeast("maps of the first frame", first, 9.0);
  this->Renderer->GetActiveCamera()->Azimuth(3.0);
  this->Render();
  Check("maps once the camera moved", builds(), first);
  this->Light->SetPosition(3.4, -3.0, 6.5);
  this->Render();
  Check("maps once the light moved", builds(), first + 9.0);
}

// Their samplers are declared all the same, beside a picture's in the first unit.
TEST_F(DepthMapFilters, SampleLightsWhoseCastersReachNothing)
{
  vtkSmartPointer<vtkActor> floor = AddFloor(this->Renderer, 4.0);
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 12, 200);
  vtkNew<vtkTexture> picture;
  picture->SetInputData(image);
  floor->SetTexture(picture);
  vtkSmartPointer<vtkActor> behind = AddSphere(this->Renderer, { 0.0, 0.0, -30.0 }, 0.5);
  vtkShadowPass::SetReceivesShadows(behind, false);
  vtkShadowPass::SetCastsShadows(floor, false);
  this->Light = AddSun(this->Renderer, { 0.3, 0.4, -1.0 });
  LookAt(this->Renderer, { 1.0, -6.0, 4.5 }, { 0.0, 0.0, 0.5 });
  this->Shadows->SetLightRadius(this->Light, 0.05);
  this->Maps()->SetFilter(Pass::SAMPLE_LIGHTS);
  const Frame frame = this->Render();
  Check("pixels beside a frame without shadows",
    static_cast<double>(CountDifferent(frame, this->RenderWithoutPass())), 0.0);
}

//------------------------------------------------------------------------------
TEST_F(DepthMapFilters, DepthBits)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  for (const bool isSpot : { true, false })
  {
    this->Renderer->RemoveAllViewProps();
    this->Renderer->RemoveAllLights();
    this->AddScene(isSpot);
    double fine = 0.0;
    for (const int bits : { 32, 24, 16, 8 })
    {
      this->Maps()->SetDepthBits(bits);
      const std::string what = std::to_string(bits) + (isSpot ? " bits, spot" : " bits, sun");
      vtkNew<vtkShadowErrorMeasure> error;
      this->Measure(what, error);
      fine = bits == 32 ? error->GetMismatchPercent() : fine;
      if (bits > 8)
      {
        CheckAtMost(what + ": mismatch over that of 32", error->GetMismatchPercent() / fine, 1.5);
      }
      // A ramp misses contacts; it darkens nothing that is lit.
      CheckAtMost(what + ": gross false", static_cast<double>(error->GetGrossFalsePixels()), 5.0);
    }
  }
}

// A face of a cube has a long range of depths, of which the far end is coarse.
TEST_F(DepthMapFilters, DepthBitsOfACube)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->AddRoom();
  for (const int filter :
    { Pass::PERCENTAGE_CLOSER, Pass::NONE, Pass::HARDWARE, Pass::DISC, Pass::EXACT })
  {
    const std::string name = Pass::GetFilterName(filter);
    this->Maps()->SetDepthBits(32);
    this->Maps()->SetFilter(filter);
    double fine = 0.0;
    vtkIdType grossOfFine = 0;
    for (const int bits : { 32, 24, 16, 8 })
    {
      if (!Pass::HasDepthBits(name, bits))
      {
        continue;
      }
      this->Maps()->SetDepthBits(bits);
      const std::string what = name + ", " + std::to_string(bits) + " bits, room";
      vtkNew<vtkShadowErrorMeasure> error;
      this->Measure(what, error);
      fine = bits == 32 ? error->GetMismatchPercent() : fine;
      grossOfFine = bits == 32 ? error->GetGrossPixels() : grossOfFine;
      CheckAtMost(what + ": mismatch over that of 32", error->GetMismatchPercent() / fine, 1.5);
      CheckAtMost(
        what + ": gross", static_cast<double>(error->GetGrossPixels()), grossOfFine + 5.0);
      CheckAtMost(what + ": gross false", static_cast<double>(error->GetGrossFalsePixels()), 5.0);
    }
  }
}

// A plate a hundredth of the map's depth range above the floor, whose range a distant post opens:
// the ramp of eight bits has it in one step with the floor here and there, finer formats have not.
TEST_F(DepthMapFilters, ARampLosesWhatIsClose)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddFloor(this->Renderer, 5.0);
  AddBox(this->Renderer, { -2.0, -2.0, 0.0025 }, { 2.0, 2.0, 0.003 });
  AddBox(this->Renderer, { 3.0, 3.0, 0.0 }, { 3.2, 3.2, 3.0 });
  this->Light = AddSun(this->Renderer, { 0.9, 0.0, -0.3 });
  LookAt(this->Renderer, { 2.3, -0.5, 0.4 }, { 2.0, 0.0, 0.0 });
  std::vector<double> shadowed;
  for (const int bits : { 32, 16, 8 })
  {
    this->Maps()->SetDepthBits(bits);
    this->Maps()->SetResolution(4096);
    this->Render();
    shadowed.push_back(static_cast<double>(this->VisibilityOf(this->Light).CountShadowed()));
    std::printf("%d bits: %.0f pixels in shadow\n", bits, shadowed.back());
  }
  CheckAtLeast("32 bits: in shadow", shadowed[0], 100.0);
  CheckAtLeast("16 bits, of that", shadowed[1] / shadowed[0], 0.8);
  CheckAtMost("8 bits, of that", shadowed[2] / shadowed[0], 0.8);
}

//------------------------------------------------------------------------------
// Acne without bias, detached shadows with too much of it, jagged edges, and what lies beyond a map
// that repeats or clamps; and by the default settings none of it.
TEST_F(DepthMapFilters, Artefacts)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->AddScene(false);
  vtkNew<vtkShadowErrorMeasure> none, error;
  this->Measure("by default", none);
  CheckAtMost("by default: gross false", static_cast<double>(none->GetGrossFalsePixels()), 5.0);
  CheckAtMost("by default: gross missed", static_cast<double>(none->GetGrossMissedPixels()), 5.0);

  this->Maps()->SetBiasMode(Pass::MANUAL_BIAS);
  this->Maps()->SetConstantBias(0.0);
  this->Maps()->SetSlopeBias(0.0);
  this->Measure("acne: no bias", error);
  CheckAtLeast("acne: gross false", static_cast<double>(error->GetGrossFalsePixels()), 2000.0);
  this->Maps()->SetConstantBias(4.0);
  this->Maps()->SetSlopeBias(2.0);
  this->Measure("a bias of 4 and 2", error);
  CheckAtMost("with bias: gross false", static_cast<double>(error->GetGrossFalsePixels()), 50.0);
  this->Maps()->SetConstantBias(0.15 * std::ldexp(1.0, 24));
  this->Measure("detached shadows: 15 % of the range", error);
  CheckAtLeast("detached: gross missed", static_cast<double>(error->GetGrossMissedPixels()), 300.0);
  this->Maps()->SetBiasMode(Pass::AUTOMATIC_BIAS);

  for (const int beyond : { Pass::REPEAT_BEYOND, Pass::CLAMP_BEYOND })
  {
    const bool repeats = beyond == Pass::REPEAT_BEYOND;
    this->Maps()->SetBeyond(beyond);
    this->Measure(repeats ? "repetition" : "bars", error);
    CheckAtLeast(
      "beyond the map: gross false", static_cast<double>(error->GetGrossFalsePixels()), 1000.0);
  }
  this->Maps()->SetBeyond(Pass::LIT_BEYOND);

  this->Maps()->SetFilter(Pass::NONE);
  this->Maps()->SetResolution(64);
  this->Measure("jagged edges: 64 texels", error);
  CheckAtLeast("jagged: mismatch over the default's",
    error->GetMismatchPercent() / none->GetMismatchPercent(), 5.0);
}

//------------------------------------------------------------------------------
TEST_F(DepthMapFilters, WrongSettings)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  Pass* maps = this->Maps();
  this->AddScene(false);
  maps->SetFilter(std::string("gaussian"));
  ExpectOneMessage(
    { "vtkDepthShadowMapPass", "\"gaussian\"", "percentage-closer", "sample-lights" });
  for (const int filter : { -1, Pass::GetNumberOfFilters() })
  {
    maps->SetFilter(filter);
    ExpectOneMessage({ "vtkDepthShadowMapPass", "Filter", std::to_string(filter), "0 to" });
  }
  for (const double radius : { nan, infinity, -1.0, 0.0, 65.0 })
  {
    maps->SetFilterRadius(radius);
    ExpectOneMessage({ "vtkDepthShadowMapPass", "FilterRadius", "0.5 to 64" });
  }
  for (const int taps : { 0, -1, 257 })
  {
    maps->SetFilterTaps(taps);
    ExpectOneMessage({ "vtkDepthShadowMapPass", "FilterTaps", "1 to 256" });
    maps->SetLightSamples(taps);
    ExpectOneMessage({ "vtkDepthShadowMapPass", "LightSamples", "1 to 256" });
  }
  maps->SetSampleResolution(0);
  ExpectOneMessage({ "vtkDepthShadowMapPass", "SampleResolution 0", "1 or more texels" });
  for (const double value : { nan, -0.1, 1.0 })
  {
    maps->SetLightBleedingReduction(value);
    ExpectOneMessage({ "vtkDepthShadowMapPass", "LightBleedingReduction", "0 to 0.99" });
    maps->SetExponentialConstant(value * 0.1);
    ExpectOneMessage({ "vtkDepthShadowMapPass", "ExponentialConstant", "1 to 80" });
  }
  for (const double value : { nan, infinity, -infinity })
  {
    maps->SetConstantBias(value);
    ExpectOneMessage({ "vtkDepthShadowMapPass", "ConstantBias", "-1e+09 to 1e+09" });
    maps->SetSlopeBias(value);
    ExpectOneMessage({ "vtkDepthShadowMapPass", "SlopeBias", "-1e+09 to 1e+09" });
  }
  maps->SetDepthBits(12);
  ExpectOneMessage({ "vtkDepthShadowMapPass", "DepthBits 12", "8, 16, 24 or 32" });
  maps->SetBiasMode(2);
  ExpectOneMessage({ "vtkDepthShadowMapPass", "BiasMode 2" });
  maps->SetBeyond(-1);
  ExpectOneMessage({ "vtkDepthShadowMapPass", "Beyond -1" });
  EXPECT_EQ(maps->GetFilter(), Pass::PERCENTAGE_CLOSER);
  Check("radius", maps->GetFilterRadius(), 3.0);
  Check("taps", maps->GetFilterTaps(), 32.0);
  Check("samples", maps->GetLightSamples(), 64.0);
  Check("bits", maps->GetDepthBits(), 32.0);
  CheckAtLeast("after all that: pixels in shadow",
    static_cast<double>(CountDifferent(this->Render(), this->RenderWithoutPass(), 60)), 1000.0);

  // Eight bits are no depths to these: one message, and a lit frame.
  maps->SetDepthBits(8);
  for (const int filter :
    { Pass::HARDWARE, Pass::VARIANCE, Pass::EXPONENTIAL, Pass::SAMPLE_LIGHTS })
  {
    maps->SetFilter(filter);
    const Frame frame = this->Render();
    ExpectOneMessage({ "vtkDepthShadowMapPass", Pass::GetFilterName(filter), "16, 24 or 32" });
    Check("pixels unlike the unshadowed frame",
      static_cast<double>(CountDifferent(frame, this->RenderWithoutPass())), 0.0);
  }
}

// Several lights, hard and soft, in one frame: sixteen by the default filter; by each of the others
// fewer, since a software rasteriser takes long to compile a kernel for each light.
TEST_F(DepthMapFilters, ManyLights)
{
  this->Resize(160, 120);
  this->AddScene(true);
  this->Maps()->SetResolution(256);
  this->Maps()->SetSampleResolution(128);
  this->Maps()->SetLightSamples(4);
  const auto addLights = [this](int first, int last)
  {
    for (int i = first; i < last; ++i)
    {
      vtkLight* light = i % 2 == 0 ? AddSun(this->Renderer, -Toward(24.0 * i, 50.0))
                                   : AddLamp(this->Renderer, 8.0 * Toward(24.0 * i, 50.0));
      this->Shadows->SetLightRadius(light, i % 2 == 0 ? 0.05 : 0.0);
    }
  };
  addLights(1, 4);
  const auto check = [this](int filter)
  {
    this->Maps()->SetFilter(filter);
    this->Render();
    CheckAtLeast(Pass::GetFilterName(filter) + ": in the first light's shadow",
      static_cast<double>(this->VisibilityOf(this->Light).CountShadowed()), 100.0);
  };
  for (int filter = 0; filter < Pass::GetNumberOfFilters(); ++filter)
  {
    check(filter);
  }
  addLights(4, 16);
  check(Pass::PERCENTAGE_CLOSER);
}
