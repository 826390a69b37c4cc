// Ways to the same mask: which faces are counted, in what, and what is left out. Those that are
// right must agree with the default; those that are kept for comparison are wrong where theory
// says so, and nowhere else. And the views that explain.
#include "TestScenes.h"
#include "VolumeTest.h"

#include <vtkPolyData.h>

#include <cmath>
#include <cstdlib>

using namespace shadowtest;

namespace
{

using Pass = vtkStencilShadowVolumePass;

class StencilVolumeVariants : public VolumeTest
{
protected:
  // In each of several views of a still life, by a sun, a spot and a lamp amid: the most pixels
  // that the mask has otherwise once `change` is made (and undone by `undo`). It is held against
  // the truth, too.
  void CheckSame(const std::string& what, const std::function<void()>& change,
    const std::function<void()>& undo, double pixels);
};

void StencilVolumeVariants::CheckSame(const std::string& what, const std::function<void()>& change,
  const std::function<void()>& undo, double pixels)
{
  this->Renderer->RemoveAllViewProps();
  this->Renderer->RemoveAllLights();
  const Subject subject = AddStillLife(this->Renderer);
  AddActor(this->Renderer, ToPolyData(MoebiusStrip()))->SetPosition(0.0, 0.0, 2.4);
  const vtkSmartPointer<vtkLight> lights[] = { AddSun(this->Renderer, -Toward(60.0, 40.0)),
    AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0),
    AddLamp(this->Renderer, { 0.1, 0.2, 0.7 }) };
  const auto compare = [&](const std::string& view)
  {
    for (int light = 0; light < 3; ++light)
    {
      CheckAtMost(what + ", " + view + ", light " + std::to_string(light) + ": pixels changed",
        static_cast<double>(this->CountChanged(lights[light], change)), pixels);
      if (this->Shadows->GetRayCastShadowPass())
      {
        this->CheckTruth(what + ", " + view + ", light " + std::to_string(light), lights[light]);
      }
      undo();
    }
  };
  AimCamera(this->Renderer, subject, -15.0, 28.0, 320, 240);
  compare("from outside");
  this->Renderer->GetActiveCamera()->SetViewAngle(75.0);
  LookAt(this->Renderer, { 0.3, -1.7, 0.6 }, { -0.4, 1.2, 0.5 });
  compare("amid the things");
  this->Renderer->GetActiveCamera()->SetViewAngle(30.0);
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Renderer->GetActiveCamera()->SetParallelScale(3.0);
  AimCamera(this->Renderer, subject, 40.0, 50.0, 320, 240);
  compare("parallel");
  this->Renderer->GetActiveCamera()->ParallelProjectionOff();
}

}

//------------------------------------------------------------------------------
// Which faces are counted. Two ways round the same edge differ in pixels whose sample lies on it.
TEST_F(StencilVolumeVariants, ZFailIsTheSame)
{
  this->CheckSame(
    "z-fail", [&]() { this->Volumes()->SetVariant(Pass::Z_FAIL); },
    [&]() { this->Volumes()->SetVariant(Pass::AUTOMATIC); }, 5.0);
}

TEST_F(StencilVolumeVariants, CountersAreTheSame)
{
  this->CheckSame(
    "floats", [&]() { this->Volumes()->SetCounter(Pass::FLOAT_COUNTER); },
    [&]() { this->Volumes()->SetCounter(Pass::AUTOMATIC_COUNTER); }, 5.0);
  this->CheckSame(
    "wrapping", [&]() { this->Volumes()->SetCounter(Pass::WRAPPING_STENCIL); },
    [&]() { this->Volumes()->SetCounter(Pass::AUTOMATIC_COUNTER); }, 5.0);
}

TEST_F(StencilVolumeVariants, SettingsAreTheSame)
{
  this->CheckSame(
    "both sides of closed pieces", [&]() { this->Volumes()->OneSidedClosedPiecesOff(); },
    [&]() { this->Volumes()->OneSidedClosedPiecesOn(); }, 5.0);
  this->CheckSame(
    "culling off", [&]() { this->Volumes()->CullingOff(); },
    [&]() { this->Volumes()->CullingOn(); }, 5.0);
  // Points at infinity, and other steps of depth, round otherwise. The pixels that it shows in are
  // those whose face stands edge-on to the light: no truth is asked there. 7 and 11 were measured.
  this->CheckSame(
    "confinement off", [&]() { this->Volumes()->ConfinementOff(); },
    [&]() { this->Volumes()->ConfinementOn(); }, 12.0);
  this->CheckSame(
    "a call for each kind of faces", [&]() { this->Volumes()->MergedDrawsOff(); },
    [&]() { this->Volumes()->MergedDrawsOn(); }, 0.0);
  this->CheckSame(
    "infinite projection", [&]() { this->Volumes()->InfiniteProjectionOn(); },
    [&]() { this->Volumes()->InfiniteProjectionOff(); }, 12.0);
}

// With the near plane in the shadow of a roof.
TEST_F(StencilVolumeVariants, ZPassIsWrongWhereTheNearPlaneLiesInAShadow)
{
  const Subject subject = AddStillLife(this->Renderer);
  auto roof = AddBox(this->Renderer, { -3.0, -9.0, 4.0 }, { 3.0, -3.0, 4.2 });
  auto sun = AddSun(this->Renderer, { 0.1, 0.15, -1.0 });
  LookAt(this->Renderer, { 0.2, -5.5, 1.5 }, { 0.0, -1.5, 0.0 });
  const auto changedBy = [&](int variant)
  {
    const std::size_t changed =
      this->CountChanged(sun, [&]() { this->Volumes()->SetVariant(variant); });
    this->Volumes()->SetVariant(Pass::AUTOMATIC);
    return static_cast<double>(changed);
  };
  CheckAtLeast("z-pass under a roof: pixels changed", changedBy(Pass::Z_PASS), 1000.0);
  CheckAtLeast("parity under a roof: pixels changed", changedBy(Pass::PARITY), 1000.0);
  CheckAtMost(
    "z-pass with caps under a roof: pixels changed", changedBy(Pass::Z_PASS_CAPPED), 20.0);
  this->Renderer->RemoveActor(roof);
  CheckAtMost("z-pass in the open: pixels changed", changedBy(Pass::Z_PASS), 5.0);
  CheckAtMost("z-pass with caps in the open: pixels changed", changedBy(Pass::Z_PASS_CAPPED), 5.0);
}

TEST_F(StencilVolumeVariants, ParityIsWrongWhereShadowsOverlap)
{
  AddStillLife(this->Renderer);
  AddBox(this->Renderer, { -1.5, -1.5, 3.0 }, { 1.0, 1.0, 3.1 });
  auto sun = AddSun(this->Renderer, -Toward(60.0, 50.0));
  LookAt(this->Renderer, { 1.0, -8.0, 6.0 }, { 0.0, 0.0, 0.5 });
  this->Render();
  const Visibility right = this->VisibilityOf(sun), counts = this->CountsOf(sun);
  this->Volumes()->SetVariant(Pass::PARITY);
  this->Render();
  const Visibility parity = this->VisibilityOf(sun);
  double even = 0.0, missed = 0.0, otherwise = 0.0;
  for (std::size_t i = 0; i < counts.values.size(); ++i)
  {
    const bool isEven = counts.values[i] > 0.0f && std::fmod(counts.values[i], 2.0f) == 0.0f;
    const bool differs = (right.values[i] < 0.5f) != (parity.values[i] < 0.5f);
    even += isEven ? 1.0 : 0.0;
    missed += isEven && differs ? 1.0 : 0.0;
    otherwise += !isEven && differs ? 1.0 : 0.0;
  }
  CheckAtLeast("pixels in an even number of volumes", even, 500.0);
  Check("of those, lit by parity", missed, even, 10.0);
  CheckAtMost("pixels that it has wrong elsewhere", otherwise, 10.0);
}

TEST_F(StencilVolumeVariants, UnknownVariantsAndCounters)
{
  this->Volumes()->SetVariant(5);
  ExpectOneMessage({ "vtkStencilShadowVolumePass", "Variant 5", "0 to 4" });
  this->Volumes()->SetVariant(-1);
  ExpectOneMessage({ "vtkStencilShadowVolumePass", "Variant -1" });
  Check("variant", this->Volumes()->GetVariant(), Pass::AUTOMATIC);
  this->Volumes()->SetCounter(3);
  ExpectOneMessage({ "vtkStencilShadowVolumePass", "Counter 3", "0 to 2" });
  Check("counter", this->Volumes()->GetCounter(), Pass::AUTOMATIC_COUNTER);
}

//------------------------------------------------------------------------------
// What need not be drawn.
TEST_F(StencilVolumeVariants, CullingLeavesOutWhatFallsElsewhere)
{
  AddFloor(this->Renderer, 5.0);
  AddSphere(this->Renderer, { 0.0, 0.0, 1.0 }, 0.5);
  AddSphere(this->Renderer, { 3.0, 0.0, -2.0 }, 0.5); // under the floor
  auto sun = AddSun(this->Renderer, { 0.2, 0.1, -1.0 });
  LookAt(this->Renderer, { 0.0, -6.0, 5.0 }, { 0.0, 0.0, 0.5 });
  this->Render();
  const vtkIdType faces = this->Volumes()->GetNumberOfFaces();
  // The floor has nothing below it that receives but the ball.
  EXPECT_GT(this->VisibilityOf(sun).CountShadowed(), 0u);
  // One has no receiver under it, the other's shadow falls behind the eye.
  vtkShadowPass::SetReceivesShadows(AddSphere(this->Renderer, { 60.0, 0.0, 1.0 }, 0.5), false);
  AddSphere(this->Renderer, { 0.0, -30.0, 1.0 }, 0.5);
  this->Render();
  Check("casters left out", static_cast<double>(this->Volumes()->GetNumberOfCulledCasters()), 2.0);
  Check("faces drawn, with two more casters out of sight",
    static_cast<double>(this->Volumes()->GetNumberOfFaces()), static_cast<double>(faces));
  this->Volumes()->CullingOff();
  this->Render();
  Check("casters left out", static_cast<double>(this->Volumes()->GetNumberOfCulledCasters()), 0.0);
  CheckAtLeast("faces drawn without culling",
    static_cast<double>(this->Volumes()->GetNumberOfFaces()), static_cast<double>(faces + 1));
}

// Additions and subtractions are drawn by calls of their own; behind the receiver caps at the far
// end go the other way.
TEST_F(StencilVolumeVariants, FacesByFewCalls)
{
  AddFloor(this->Renderer, 5.0);
  AddSphere(this->Renderer, { 0.0, 0.0, 1.0 }, 0.5);
  AddLamp(this->Renderer, { 1.0, 1.0, 4.0 });
  LookAt(this->Renderer, { 0.0, -6.0, 5.0 }, { 0.0, 0.0, 0.5 });
  const auto check = [this](const std::string& what, double draws)
  {
    this->Render();
    Check(what + ": calls", static_cast<double>(this->Volumes()->GetNumberOfDraws()), draws);
  };
  check("before the receiver", 2.0);
  this->Volumes()->SetVariant(Pass::Z_FAIL);
  check("behind it", 4.0);
  const double faces = static_cast<double>(this->Volumes()->GetNumberOfFaces());
  this->Volumes()->MergedDrawsOff();
  check("behind it, each kind by its own", 6.0);
  Check("faces", static_cast<double>(this->Volumes()->GetNumberOfFaces()), faces);
}

//------------------------------------------------------------------------------
// Views that explain.
TEST_F(StencilVolumeVariants, DebugViewsLeaveNoTrace)
{
  const Subject subject = AddStillLife(this->Renderer);
  auto lamp = AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0);
  AimCamera(this->Renderer, subject, -15.0, 28.0, 320, 240);
  EXPECT_EQ(this->Shadows->GetDebugView(), "none");
  const Frame plain = this->Render();
  for (const std::string view : { "volumes", "silhouette", "counts" })
  {
    EXPECT_TRUE(this->Shadows->SetDebugView(view));
    const Frame explained = this->Render();
    CheckAtLeast(
      view + ": pixels changed", static_cast<double>(CountDifferent(plain, explained, 20)), 500.0);
    Check(view + ": pixels changed by the next frame",
      static_cast<double>(CountDifferent(explained, this->Render())), 0.0);
    const Visibility shown = this->VisibilityOf(lamp);
    EXPECT_TRUE(this->Shadows->SetDebugView("none"));
    Check(view + ": pixels of the next plain frame that it left otherwise",
      static_cast<double>(CountDifferent(plain, this->Render())), 0.0);
    Check(view + ": visibility otherwise",
      static_cast<double>(CountDifferent(shown, this->VisibilityOf(lamp))), 0.0);
  }
}

TEST_F(StencilVolumeVariants, DebugViewOfOneLight)
{
  const Subject subject = AddStillLife(this->Renderer);
  auto lamp = AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0);
  auto sun = AddSun(this->Renderer, -Toward(-60.0, 40.0));
  AimCamera(this->Renderer, subject, -15.0, 28.0, 320, 240);
  this->Shadows->SetDebugView("silhouette");
  const Frame first = this->Render();
  this->Shadows->SetDebugLight(lamp);
  Check("the first light, told: pixels changed",
    static_cast<double>(CountDifferent(first, this->Render())), 0.0);
  this->Shadows->SetDebugLight(sun);
  CheckAtLeast("the other light: pixels changed",
    static_cast<double>(CountDifferent(first, this->Render())), 200.0);
}

TEST_F(StencilVolumeVariants, DebugViewsThatCannotBe)
{
  const Subject subject = AddStillLife(this->Renderer);
  AddSun(this->Renderer, -Toward(-60.0, 40.0));
  AimCamera(this->Renderer, subject, -15.0, 28.0, 320, 240);
  EXPECT_FALSE(this->Shadows->SetDebugView("volume"));
  ExpectOneMessage({ "vtkShadowPass", "\"volume\"", "volumes", "silhouette", "counts", "none" });
  EXPECT_EQ(this->Shadows->GetDebugView(), "none");
  this->Shadows->SetTechnique("depth-map");
  const Frame plain = this->Render();
  this->Shadows->SetDebugView("volumes");
  const Frame frame = this->Render();
  ExpectOneMessage({ "vtkShadowPass", "\"volumes\"", "depth-map", "\"stencil-volume\"" });
  Check("pixels changed", static_cast<double>(CountDifferent(plain, frame)), 0.0);
  this->Render();
  Check("messages by the next frame", static_cast<double>(TakeMessages().size()), 0.0);
}

// Where a driver can pass over pixels by the depth that is stored there, the mask is right all the
// same: before, in and behind the volumes. Run by a driver that can, too (see CMakeLists.txt).
TEST_F(StencilVolumeVariants, DepthBounds)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Subject subject = AddStillLife(this->Renderer);
  AddBox(this->Renderer, { -9.0, 14.0, 0.0 }, { 9.0, 15.0, 6.0 });
  AddBox(this->Renderer, { 1.2, -7.0, 0.0 }, { 1.8, -6.6, 1.0 });
  AddActor(this->Renderer, ToPolyData(MoebiusStrip()))->SetPosition(0.0, 0.0, 2.4);
  const vtkSmartPointer<vtkLight> lights[] = { AddSun(this->Renderer, { -0.5, 0.6, -1.0 }),
    AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 70.0) };
  for (const bool parallel : { false, true })
  {
    this->Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    AimCamera(this->Renderer, subject, -15.0, 28.0, 320, 240);
    for (const int variant : { Pass::AUTOMATIC, Pass::Z_FAIL })
    {
      this->Volumes()->SetVariant(variant);
      for (vtkLight* light : lights)
      {
        this->CheckTruth(std::string(parallel ? "parallel" : "perspective") +
            (variant == Pass::Z_FAIL ? ", z-fail" : ", automatic"),
          light, 0.02, 1.0);
      }
    }
  }
  if (std::getenv("VTKSHADOWS_TEST_DEPTH_BOUNDS"))
  {
    EXPECT_TRUE(this->Volumes()->GetHasDepthBounds()) << "this driver has no depth bounds";
  }
}
