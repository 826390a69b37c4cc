// Cascades of a directional light, views confined to what is seen, lights that need no map, and the
// views that explain maps. Against the truth, and steady while the eye turns.
#include "ShadowTest.h"
#include "TestScenes.h"

#include "vtkObjectIDShadowPass.h"
#include "vtkShadowErrorMeasure.h"

#include <vtkOpenGLSphereMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace shadowtest;

namespace
{

class Cascades : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetPass(this->Shadows);
    this->Maps()->SetResolution(1024);
    this->Resize(400, 300);
  }

  vtkDepthShadowMapPass* Maps() { return this->Shadows->GetDepthShadowMapPass(); }

  const glm::dvec3 LowSunlight{ 0.6, 0.5, -0.2 }; // 14 degrees high

  // Low hills, `width` wide about the origin.
  static double Height(double x, double y)
  {
    return 12.0 * std::sin(0.011 * x + 1.0) * std::cos(0.013 * y) +
      40.0 * std::sin(0.0031 * x + 0.0027 * y);
  }
  static glm::dvec3 OnGround(double x, double y) { return { x, y, Height(x, y) }; }
  void AddHills(double width)
  {
    AddActor(this->Renderer,
      MakeSurface(200, 200,
        [width](double u, double v) { return OnGround((u - 0.5) * width, (v - 0.5) * width); }));
  }
  // Posts, houses and towers, the nearer to the origin the denser.
  void AddThings(int count)
  {
    std::mt19937 random(7);
    const auto any = [&random](double low, double high)
    { return low + (high - low) * (random() / double(random.max())); };
    for (int i = 0; i < count; ++i)
    {
      const double r = 6.0 * std::pow(300.0, i / double(count)), turn = any(0.0, 6.283);
      const double size = any(0.05, 0.12) * r;
      const glm::dvec3 place = OnGround(r * std::cos(turn), r * std::sin(turn));
      AddBox(this->Renderer, place - glm::dvec3(size, size, size),
        place + glm::dvec3(size, size, any(1.0, 3.0) * size));
    }
  }
  vtkSmartPointer<vtkLight> AddCountry(const glm::dvec3& sunlight = { 0.6, 0.5, -0.3 })
  {
    this->AddHills(4000.0);
    this->AddThings(150);
    return AddSun(this->Renderer, sunlight);
  }

  // At the origin, 2 above the ground.
  static void Turn(vtkCamera* camera, double azimuth, double angle = 40.0)
  {
    const double a = azimuth * 0.017453292519943295;
    const glm::dvec3 eye = OnGround(0.0, 0.0) + glm::dvec3(0.0, 0.0, 2.0);
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetFocalPoint(eye.x + std::cos(a), eye.y + std::sin(a), eye.z - 0.05);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(angle);
    camera->SetClippingRange(0.5, 1.0e4);
  }
  void Turn(double azimuth, double angle = 40.0)
  {
    Turn(this->Renderer->GetActiveCamera(), azimuth, angle);
  }

  double MismatchOf(vtkLight* light)
  {
    this->Render();
    vtkNew<vtkShadowErrorMeasure> error;
    EXPECT_TRUE(error->Measure(this->Renderer, light));
    EXPECT_GT(error->GetShadowPixels(), 500) << "few shadows";
    return error->GetMismatchPercent();
  }
  // What is shown and the light stand still, and cascades are fitted to a camera that turns, or
  // goes: what differs from one step to the next is theirs.
  void CheckSteady(const glm::dvec3& sunlight)
  {
    auto sun = this->AddCountry(sunlight);
    this->Maps()->SetNumberOfCascades(4);
    this->Turn(110.0, 20.0);
    vtkNew<vtkCamera> fitted;
    Turn(fitted, 98.0, 50.0);
    this->Maps()->SetFitCamera(fitted);
    EXPECT_EQ(this->Maps()->GetFitCamera(), fitted.Get());
    for (const bool walks : { false, true })
    {
      this->Render();
      const vtkIdType built = this->Maps()->GetNumberOfMapBuilds();
      Visibility before = this->VisibilityOf(sun);
      CheckAtLeast("pixels in shadow", static_cast<double>(before.CountShadowed()), 5000.0);
      std::size_t most = 0;
      const int steps = 24;
      for (int step = 0; step < steps; ++step)
      {
        if (walks)
        {
          double place[3];
          fitted->GetPosition(place);
          fitted->SetPosition(place[0], place[1] + 0.3, place[2]);
          fitted->GetFocalPoint(place);
          fitted->SetFocalPoint(place[0], place[1] + 0.3, place[2]);
        }
        else
        {
          fitted->Yaw(1.0); // to the left
        }
        this->Render();
        const Visibility now = this->VisibilityOf(sun);
        most = std::max(most, CountDifferent(before, now));
        before = now;
      }
      CheckAtMost(
        std::string(walks ? "walking" : "turning") + ": % of the pixels that flip in a step",
        100.0 * most / before.values.size(), 0.1);
      const auto maps = static_cast<double>(this->Maps()->GetNumberOfMapBuilds() - built);
      CheckAtLeast("maps drawn on the way", maps, 1.0);
      CheckAtMost("maps drawn on the way", maps, steps);
    }
  }
  vtkIdType Drawn()
  {
    const vtkIdType before = this->Maps()->GetNumberOfMapBuilds();
    this->Render();
    return this->Maps()->GetNumberOfMapBuilds() - before;
  }
};

}

TEST_F(Cascades, CountryFromTwoAboveTheGround)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto sun = this->AddCountry();
  for (const double azimuth : { 20.0, 110.0, 200.0, 290.0 })
  {
    const std::string what = "azimuth " + std::to_string(azimuth) + ": mismatch %, ";
    this->Turn(azimuth);
    this->Maps()->SetNumberOfCascades(4);
    const double four = this->MismatchOf(sun);
    Check("views", this->Maps()->GetNumberOfViews(), 4.0);
    this->Maps()->SetNumberOfCascades(1);
    this->Maps()->SetResolution(2048);
    const double one = this->MismatchOf(sun);
    Check("views", this->Maps()->GetNumberOfViews(), 1.0);
    this->Maps()->SetResolution(1024);
    CheckAtMost(what + "four cascades of 1024", four, 1.0);
    CheckAtLeast(what + "one map of 2048, to that", one / four, 3.0);
  }
}

// Ground is foreshortened fourfold, and far texels have one side shorter: by every lookup.
TEST_F(Cascades, LowSun)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto sun = this->AddCountry(LowSunlight);
  for (const double azimuth : { 20.0, 110.0, 200.0, 290.0 })
  {
    const std::string what = "azimuth " + std::to_string(azimuth) + ": mismatch %, ";
    this->Turn(azimuth);
    this->Shadows->SetTechnique("depth-map");
    this->Maps()->SetNumberOfCascades(4);
    const double four = this->MismatchOf(sun);
    CheckAtMost(what + "four cascades of 1024", four, 1.0);
    this->Maps()->SetFilter("exact");
    CheckAtMost(what + "by \"exact\"", this->MismatchOf(sun), four);
    this->Maps()->SetFilter("percentage-closer");
    this->Shadows->SetTechnique("object-id");
    this->Shadows->GetObjectIDShadowPass()->SetResolution(1024);
    this->Shadows->GetObjectIDShadowPass()->SetNumberOfCascades(4);
    CheckAtMost(what + "by object-id", this->MismatchOf(sun), 1.0);
  }
}

// A penumbra is as wide along a texel's longer side as along its shorter one: against 64 sample
// lights.
TEST_F(Cascades, SoftShadows)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto sun = this->AddCountry(LowSunlight);
  this->Shadows->SetLightRadius(sun, 0.005);
  this->Shadows->GetRayCastShadowPass()->SetLightSamples(64);
  this->Maps()->SetNumberOfCascades(4);
  this->Maps()->SetFilter("soft");
  for (const double azimuth : { 20.0, 110.0, 200.0, 290.0 })
  {
    this->Turn(azimuth);
    this->Render();
    vtkNew<vtkShadowErrorMeasure> error;
    ASSERT_TRUE(error->Measure(this->Renderer, sun));
    CheckAtMost("azimuth " + std::to_string(azimuth) + ": mean difference",
      error->GetMeanAbsoluteDifference(), 0.004);
  }
}

TEST_F(Cascades, NumbersAndSchemes)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto sun = this->AddCountry();
  this->Turn(110.0);
  const double one = this->MismatchOf(sun);
  for (const std::string scheme : { "practical", "logarithmic", "uniform" })
  {
    this->Maps()->SetCascadeScheme(scheme);
    EXPECT_EQ(vtkMapShadowPass::GetCascadeSchemeName(this->Maps()->GetCascadeScheme()), scheme);
    for (int number = 2; number <= 8; ++number)
    {
      this->Maps()->SetNumberOfCascades(number);
      const double mismatch = this->MismatchOf(sun);
      const std::string what = scheme + ", " + std::to_string(number) + " cascades: mismatch %";
      CheckAtMost(what, mismatch, one);
      if (scheme != "uniform" && number >= 3)
      {
        CheckAtMost(what, mismatch, one / 3.0);
      }
      CheckAtMost("views", this->Maps()->GetNumberOfViews(), number);
    }
  }
}

// Object-ID maps have them by the same views.
TEST_F(Cascades, OfObjectIDs)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto sun = this->AddCountry();
  this->Shadows->SetTechnique("object-id");
  vtkObjectIDShadowPass* objects = this->Shadows->GetObjectIDShadowPass();
  for (const int bits : { 16, 24, 32 })
  {
    objects->SetDepthBits(bits);
    for (const double azimuth : { 20.0, 200.0 })
    {
      const std::string what =
        std::to_string(bits) + " bits, azimuth " + std::to_string(azimuth) + ": mismatch %, ";
      this->Turn(azimuth);
      objects->SetResolution(1024);
      objects->SetNumberOfCascades(4);
      const double four = this->MismatchOf(sun);
      Check("views", objects->GetNumberOfViews(), 4.0);
      objects->SetNumberOfCascades(1);
      objects->SetResolution(2048);
      const double one = this->MismatchOf(sun);
      Check("views", objects->GetNumberOfViews(), 1.0);
      CheckAtMost(what + "four cascades of 1024", four, 1.0);
      CheckAtLeast(what + "one map of 2048, to that", one / four, 3.0);
    }
  }

  // On bare hills, which truly are lit, no seam is seen.
  this->Renderer->RemoveAllViewProps();
  this->AddHills(4000.0);
  objects->SetResolution(1024);
  objects->SetDepthBits(16);
  sun->SetPosition(-0.3, -0.2, 1.0);
  for (const double blend : { 0.0, 0.1, 1.0 })
  {
    objects->SetCascadeBlend(blend);
    for (const int number : { 2, 4, 8 })
    {
      objects->SetNumberOfCascades(number);
      this->Turn(77.0);
      this->Render();
      const Visibility visibility = this->VisibilityOf(sun);
      const auto dark = std::count_if(visibility.values.begin(), visibility.values.end(),
        [](float value) { return value < 0.99f; });
      Check("blend " + std::to_string(blend) + ", " + std::to_string(number) +
          " cascades: darkened pixels",
        static_cast<double>(dark), 0.0);
    }
  }
}

// Where shadows end at some distance, cascades reach no farther: near to the eye they are finer.
// What is read back knows nothing of distances, so frames are compared.
TEST_F(Cascades, ShortenedByAMaximumDistance)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto sun = this->AddCountry();
  this->Maps()->SetNumberOfCascades(3);
  const double distances[] = { 0.0, 100.0 };
  std::size_t near = 0, wrong[2] = { 0, 0 };
  for (const double azimuth : { 20.0, 110.0, 200.0, 290.0 })
  {
    this->Turn(azimuth);
    Frame truth[2], got[2];
    for (int i = 0; i < 2; ++i)
    {
      this->Shadows->SetLightMaximumDistance(sun, distances[i]);
      this->Shadows->SetTechnique("ray-cast");
      truth[i] = this->Render();
      this->Shadows->SetTechnique("depth-map");
      got[i] = this->Render();
      const Visibility seen = this->VisibilityOf(sun);
      CheckAtLeast(
        "pixels in shadow, read back", static_cast<double>(seen.CountShadowed()), 1000.0);
      Check("pixels unlike, after reading back",
        static_cast<double>(CountDifferent(got[i], this->Render(), 2)), 0.0);
    }
    // Where the distance changes nothing.
    for (int y = 0; y < truth[0].height; ++y)
    {
      for (int x = 0; x < truth[0].width; ++x)
      {
        const int expected = truth[0].Brightness(x, y);
        if (truth[1].Brightness(x, y) == expected)
        {
          ++near;
          for (int i = 0; i < 2; ++i)
          {
            wrong[i] += std::abs(got[i].Brightness(x, y) - expected) > 100 ? 1 : 0;
          }
        }
      }
    }
  }
  CheckAtLeast("pixels whose shadow does not end", static_cast<double>(near), 200000.0);
  CheckAtMost("wrong ones of them by shortened cascades, over those by whole ones",
    static_cast<double>(wrong[1]) / static_cast<double>(wrong[0]), 0.8);
}

// Whatever blends, and where nothing blends, no seam is seen: on bare hills, which truly are lit.
TEST_F(Cascades, SeamsAreLit)
{
  this->AddHills(4000.0);
  auto sun = AddSun(this->Renderer, { 0.3, 0.2, -1.0 });
  for (const double blend : { 0.0, 0.1, 0.5, 1.0 })
  {
    this->Maps()->SetCascadeBlend(blend);
    for (const int number : { 2, 4, 8 })
    {
      this->Maps()->SetNumberOfCascades(number);
      for (const double azimuth : { 0.0, 77.0, 190.0 })
      {
        this->Turn(azimuth);
        this->Render();
        const Visibility visibility = this->VisibilityOf(sun);
        const auto dark = std::count_if(visibility.values.begin(), visibility.values.end(),
          [](float value) { return value < 0.99f; });
        Check("blend " + std::to_string(blend) + ", " + std::to_string(number) +
            " cascades: darkened pixels",
          static_cast<double>(dark), 0.0);
      }
    }
  }
}

TEST_F(Cascades, SeamsAgainstTheTruth)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto sun = this->AddCountry();
  this->Maps()->SetNumberOfCascades(4);
  this->Turn(290.0);
  Visibility sharp;
  for (const double blend : { 0.0, 0.1, 0.5, 1.0 })
  {
    this->Maps()->SetCascadeBlend(blend);
    CheckAtMost("blend " + std::to_string(blend) + ": mismatch %", this->MismatchOf(sun),
      blend < 0.5 ? 1.0 : 1.5);
    const Visibility visibility = this->VisibilityOf(sun);
    if (blend == 0.0)
    {
      sharp = visibility;
      continue;
    }
    std::size_t changed = 0;
    for (std::size_t i = 0; i < sharp.values.size(); ++i)
    {
      changed += std::abs(sharp.values[i] - visibility.values[i]) > 0.01f ? 1 : 0;
    }
    CheckAtLeast("pixels that the blend changes", static_cast<double>(changed), 50.0);
  }
}

TEST_F(Cascades, NoShimmer)
{
  this->CheckSteady({ 0.6, 0.5, -0.3 });
}

TEST_F(Cascades, NoShimmerUnderALowSun)
{
  this->CheckSteady(LowSunlight);
}

// Maps are kept while the camera moves within the guard band, and a moved caster is seen at once.
TEST_F(Cascades, DrawnWhenStale)
{
  this->AddCountry();
  auto ball = AddSphere(this->Renderer, OnGround(12.0, 1.0) + glm::dvec3(0.0, 0.0, 1.0), 1.0);
  this->Maps()->SetNumberOfCascades(4);
  this->Turn(0.0);
  Check("maps drawn at first", static_cast<double>(this->Drawn()), 4.0);
  Check("maps drawn by the next frame", static_cast<double>(this->Drawn()), 0.0);
  this->Turn(1.0);
  Check("maps drawn after a small turn", static_cast<double>(this->Drawn()), 0.0);
  this->Turn(90.0);
  Check("maps drawn after a quarter turn", static_cast<double>(this->Drawn()), 3.0);
  const Frame turned = this->Render();
  vtkNew<vtkShadowPass> fresh;
  fresh->SetTechnique("depth-map");
  fresh->GetDepthShadowMapPass()->SetResolution(1024);
  fresh->GetDepthShadowMapPass()->SetNumberOfCascades(4);
  this->Renderer->SetPass(fresh);
  CheckAtMost("pixels unlike a fresh pass's",
    static_cast<double>(CountDifferent(turned, this->Render(), 2)), 20.0);
  // The map of all casters is filled as a cascade, and not as the one view.
  fresh->GetDepthShadowMapPass()->SetNumberOfCascades(1);
  fresh->GetDepthShadowMapPass()->ReleaseGraphicsResources(this->Window);
  const Frame single = this->Render();
  this->Renderer->SetPass(this->Shadows);
  this->Maps()->SetNumberOfCascades(1);
  Check("one map instead: pixels unlike a fresh pass's",
    static_cast<double>(CountDifferent(single, this->Render())), 0.0);
  this->Maps()->SetNumberOfCascades(4);
  this->Turn(0.0);
  const Frame before = this->Render();
  ball->SetPosition(0.0, 1.0, 0.0);
  CheckAtLeast("maps drawn once a caster moved", static_cast<double>(this->Drawn()), 4.0);
  CheckAtLeast(
    "pixels changed", static_cast<double>(CountDifferent(before, this->Render(), 20)), 50.0);
}

// A scene that the eye sees whole has one map; a parallel eye sees everything at one scale.
TEST_F(Cascades, OnlyWhereTheyPay)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Subject subject = AddStillLife(this->Renderer);
  auto sun = AddSun(this->Renderer, -Toward(-60.0, 40.0));
  this->Maps()->SetNumberOfCascades(8);
  AimCamera(this->Renderer, subject, -15.0, 28.0, 400, 300);
  CheckAtMost("still life: mismatch %", this->MismatchOf(sun), 0.3);
  Check("views", this->Maps()->GetNumberOfViews(), 1.0);
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Renderer->GetActiveCamera()->SetParallelScale(0.3);
  CheckAtMost("parallel close-up: mismatch %", this->MismatchOf(sun), 0.3);
  Check("views", this->Maps()->GetNumberOfViews(), 1.0);
}

TEST_F(Cascades, OffsetsAndScales)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  for (const Placement& placement : Placements)
  {
    this->Renderer->RemoveAllViewProps();
    this->Renderer->RemoveAllLights();
    auto sun = this->AddCountry();
    PlaceActors(this->Renderer, placement, true);
    this->Turn(20.0);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const glm::dvec3 place = placement.Of(glm::make_vec3(camera->GetPosition()));
    const glm::dvec3 focus = placement.Of(glm::make_vec3(camera->GetFocalPoint()));
    camera->SetPosition(place.x, place.y, place.z);
    camera->SetFocalPoint(focus.x, focus.y, focus.z);
    camera->SetClippingRange(0.5 * placement.scale, 1.0e4 * placement.scale);
    this->Maps()->SetNumberOfCascades(4);
    CheckAtMost(std::string(placement.name) + ": mismatch %", this->MismatchOf(sun), 1.0);
    Check("views", this->Maps()->GetNumberOfViews(), 4.0);
  }
}

// Two suns with cascades, a spot with one view and a lamp in a cube, on meshes, impostors and
// glass.
TEST_F(Cascades, AmongOtherLights)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto sun = this->AddCountry();
  auto moon = AddSun(this->Renderer, { -0.5, 0.7, -0.6 });
  const glm::dvec3 here = OnGround(15.0, 0.0);
  auto spot = AddSpot(this->Renderer, here + glm::dvec3(-5.0, -8.0, 12.0), here, 20.0);
  auto lamp = AddLamp(this->Renderer, here + glm::dvec3(0.0, 4.0, 3.0));
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(here.x, here.y, here.z + 1.0);
  points->InsertNextPoint(here.x + 3.0, here.y - 2.0, here.z + 0.8);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetRadius(0.9f);
  vtkNew<vtkActor> balls;
  balls->SetMapper(mapper);
  this->Renderer->AddActor(balls);
  this->Turn(0.0);
  this->Maps()->SetNumberOfCascades(4);
  CheckAtMost("sun: mismatch %", this->MismatchOf(sun), 1.0);
  CheckAtMost("moon: mismatch %", this->MismatchOf(moon), 1.0);
  this->CheckMeasure("spot", spot, 0.5, 0.1);
  this->CheckMeasure("lamp", lamp, 1.0, 0.5);
  CheckAtLeast("views", this->Maps()->GetNumberOfViews(), 10.0);
  CheckAtLeast("casters left out", this->Maps()->GetNumberOfCastersLeftOut(), 100.0);

  auto pane = AddFloor(this->Renderer, 40.0, here.z + 0.5);
  vtkShadowPass::SetCastsShadows(pane, false);
  pane->GetProperty()->SetOpacity(0.999);
  const Frame translucent = this->Render();
  pane->GetProperty()->SetOpacity(1.0);
  CheckAtMost("pixels unlike the opaque pane's",
    static_cast<double>(CountDifferent(translucent, this->Render(), 2)), 0.0);
}

//------------------------------------------------------------------------------
// Lights of which no shadow can be seen.
TEST_F(Cascades, LightsOutOfSightHaveNoMap)
{
  AddFloor(this->Renderer, 50.0);
  AddSphere(this->Renderer, { 0.0, 0.0, 1.0 }, 0.5);
  AddSphere(this->Renderer, { 30.0, 0.0, 1.0 }, 0.5);
  auto here = AddSpot(this->Renderer, { 0.0, -3.0, 6.0 }, { 0.0, 0.0, 0.0 }, 20.0);
  auto there = AddSpot(this->Renderer, { 30.0, -3.0, 6.0 }, { 30.0, 0.0, 0.0 }, 20.0);
  LookAt(this->Renderer, { 0.0, -8.0, 3.0 }, { 0.0, 0.0, 0.5 });
  const Frame first = this->Render();
  Check("lights skipped", this->Maps()->GetNumberOfSkippedLights(), 1.0);
  Check("views", this->Maps()->GetNumberOfViews(), 1.0);
  Check("maps drawn", static_cast<double>(this->Maps()->GetNumberOfMapBuilds()), 1.0);
  CheckAtLeast("shadow here", static_cast<double>(this->VisibilityOf(here).CountShadowed()), 200.0);
  Check("shadow there", static_cast<double>(this->VisibilityOf(there).CountShadowed()), 0.0);

  LookAt(this->Renderer, { 30.0, -8.0, 3.0 }, { 30.0, 0.0, 0.5 });
  this->Render();
  Check("lights skipped, seen from there", this->Maps()->GetNumberOfSkippedLights(), 1.0);
  CheckAtLeast(
    "shadow there, seen", static_cast<double>(this->VisibilityOf(there).CountShadowed()), 200.0);
  LookAt(this->Renderer, { 0.0, -8.0, 3.0 }, { 0.0, 0.0, 0.5 });
  Check("pixels changed on the way back",
    static_cast<double>(CountDifferent(first, this->Render())), 0.0);

  // All of it.
  LookAt(this->Renderer, { 15.0, -60.0, 20.0 }, { 15.0, 0.0, 0.5 });
  this->Render();
  Check("lights skipped of all in sight", this->Maps()->GetNumberOfSkippedLights(), 0.0);
  LookAt(this->Renderer, { 0.0, -60.0, 3.0 }, { 0.0, -90.0, 0.0 });
  this->Render();
  Check("lights skipped, looking away", this->Maps()->GetNumberOfSkippedLights(), 2.0);
  Check("views, looking away", this->Maps()->GetNumberOfViews(), 0.0);
}

// A wide scene seen close: the one view's texels are where they are seen.
TEST_F(Cascades, ConfinedToTheView)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddFloor(this->Renderer, 100.0);
  std::mt19937 random(3);
  const auto any = [&random]() { return 90.0 * (2.0 * (random() / double(random.max())) - 1.0); };
  for (int i = 0; i < 100; ++i)
  {
    AddSphere(this->Renderer, { any(), any(), 1.0 }, 0.8, 16);
  }
  AddSphere(this->Renderer, { 0.0, 0.0, 1.0 }, 0.7);
  AddSphere(this->Renderer, { 1.2, 1.0, 0.8 }, 0.4);
  const vtkSmartPointer<vtkLight> lights[] = { AddSun(this->Renderer, { 0.5, 0.4, -1.0 }),
    AddSpot(this->Renderer, { -40.0, -60.0, 200.0 }, { 0.0, 0.0, 0.0 }, 40.0) };
  LookAt(this->Renderer, { 1.0, -7.0, 4.0 }, { 0.3, 0.2, 0.4 });
  for (vtkLight* light : lights)
  {
    this->Maps()->ConfineToViewOff();
    const double whole = this->MismatchOf(light);
    this->Maps()->ConfineToViewOn();
    const double confined = this->MismatchOf(light);
    CheckAtLeast("mismatch, to that of confined views", whole / confined, 3.0);
  }
  CheckAtLeast("casters left out", this->Maps()->GetNumberOfCastersLeftOut(), 100.0);
  Check("maps drawn by the next frame", static_cast<double>(this->Drawn()), 0.0);
  LookAt(this->Renderer, { 1.02, -7.0, 4.0 }, { 0.31, 0.2, 0.4 });
  CheckAtMost("maps drawn after a small step", static_cast<double>(this->Drawn()), 1.0);
}

//------------------------------------------------------------------------------
TEST_F(Cascades, BadSettings)
{
  auto sun = this->AddCountry();
  this->Turn(20.0);
  this->Maps()->SetNumberOfCascades(3);
  const Frame before = this->Render();
  vtkDepthShadowMapPass* maps = this->Maps();
  for (const int number : { 0, 9, -1 })
  {
    maps->SetNumberOfCascades(number);
    ExpectOneMessage(
      { "vtkDepthShadowMapPass", "NumberOfCascades", std::to_string(number), "1 to 8" });
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double share : { nan, -0.1, 1.1, std::numeric_limits<double>::infinity() })
  {
    maps->SetCascadeWeight(share);
    ExpectOneMessage({ "CascadeWeight", "0 to 1", "stays 1" });
    maps->SetCascadeBlend(share);
    ExpectOneMessage({ "CascadeBlend", "0 to 1", "stays 0.1" });
  }
  maps->SetCascadeScheme(3);
  ExpectOneMessage({ "CascadeScheme", "3", "0 to 2" });
  maps->SetCascadeScheme("golden");
  ExpectOneMessage({ "CascadeScheme", "golden", "practical, logarithmic, uniform" });
  Check("pixels changed", static_cast<double>(CountDifferent(before, this->Render())), 0.0);
  Check("cascades", maps->GetNumberOfCascades(), 3.0);
  EXPECT_GT(this->VisibilityOf(sun).CountShadowed(), 500u);
}

//------------------------------------------------------------------------------
// Views that explain.
TEST_F(Cascades, DebugViewsLeaveNoTrace)
{
  auto sun = this->AddCountry();
  auto lamp = AddLamp(this->Renderer, OnGround(15.0, 0.0) + glm::dvec3(0.0, 4.0, 3.0));
  this->Maps()->SetNumberOfCascades(4);
  this->Turn(20.0);
  const Frame plain = this->Render();
  for (vtkLight* light : { sun.Get(), lamp.Get() })
  {
    this->Shadows->SetDebugLight(light);
    for (const std::string view : { "cascades", "texel-density", "map", "lit-part" })
    {
      EXPECT_TRUE(this->Shadows->SetDebugView(view));
      const Frame explained = this->Render();
      CheckAtLeast(view + ": pixels changed",
        static_cast<double>(CountDifferent(plain, explained, 20)), 5000.0);
      Check(view + ": pixels changed by the next frame",
        static_cast<double>(CountDifferent(explained, this->Render())), 0.0);
      const Visibility shown = this->VisibilityOf(light);
      EXPECT_TRUE(this->Shadows->SetDebugView("none"));
      Check(view + ": pixels of the next plain frame that it left otherwise",
        static_cast<double>(CountDifferent(plain, this->Render())), 0.0);
      Check(view + ": visibility otherwise",
        static_cast<double>(CountDifferent(shown, this->VisibilityOf(light))), 0.0);
      WritePng(explained, "Explained-" + view + (light == lamp ? "-lamp.png" : ".png"));
    }
  }
}

// Colours say what they are said to: near the eye the first cascade's, far away the last's; more
// texels to a pixel with a larger map.
TEST_F(Cascades, DebugViewsTellTheTruth)
{
  AddFloor(this->Renderer, 2000.0);
  AddBox(this->Renderer, { 1000.0, -100.0, 0.0 }, { 1010.0, 100.0, 40.0 });
  AddBox(this->Renderer, { 8.0, 2.0, -1.0 }, { 9.0, 3.0, 1.0 });
  AddSun(this->Renderer, { 0.3, 0.2, -1.0 });
  this->Maps()->SetNumberOfCascades(4);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 2.0);
  camera->SetFocalPoint(1.0, 0.0, 1.9);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetClippingRange(0.5, 1.0e4);
  this->Shadows->SetDebugView("cascades");
  const Frame frame = this->Render();
  const auto at = [&frame](int x, int y) { return &frame.rgb[3 * (std::size_t(y) * 400 + x)]; };
  const unsigned char* near = at(200, 5);
  EXPECT_GT(near[0], near[2] + 40) << "orange is the first";
  const Pixel wall = PixelOf(this->Renderer, { 1000.0, 0.0, 30.0 });
  const unsigned char* far = at(wall.x, wall.y);
  EXPECT_GT(far[0] + far[1], 2 * far[2] + 60) << "yellow is the last";
  EXPECT_LT(std::abs(far[0] - far[1]), 40) << "yellow is the last";

  this->Shadows->SetDebugView("texel-density");
  const auto blueness = [this]()
  {
    const Frame shown = this->Render();
    double sum = 0.0;
    for (std::size_t i = 0; i < shown.rgb.size(); i += 3)
    {
      sum += shown.rgb[i + 2] - shown.rgb[i];
    }
    return sum / shown.rgb.size();
  };
  this->Maps()->SetResolution(256);
  const double coarse = blueness();
  this->Maps()->SetResolution(4096);
  CheckAtLeast("blue over red, 4096 texels over 256", blueness() - coarse, 10.0);
}

TEST_F(Cascades, DebugViewsOfOtherTechniques)
{
  AddFloor(this->Renderer, 5.0);
  AddSphere(this->Renderer, { 0.0, 0.0, 1.0 }, 0.5);
  AddSun(this->Renderer, { 0.3, 0.2, -1.0 });
  LookAt(this->Renderer, { 0.0, -8.0, 3.0 }, { 0.0, 0.0, 0.5 });
  this->Shadows->SetTechnique("stencil-volume");
  const Frame plain = this->Render();
  this->Shadows->SetDebugView("texel-density");
  const Frame frame = this->Render();
  ExpectOneMessage({ "vtkShadowPass", "\"texel-density\"", "stencil-volume", "\"depth-map\"" });
  Check("pixels changed", static_cast<double>(CountDifferent(plain, frame)), 0.0);
}
