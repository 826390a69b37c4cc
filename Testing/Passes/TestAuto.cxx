// Technique "auto": what it takes for which scene, that it keeps to its budgets, says why, and
// neither flickers nor builds what is not required.
#include "AutoTest.h"

#include <vtkCellArray.h>
#include <vtkLineSource.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

using namespace shadowtest;

namespace
{

using Auto = AutoTest;

}

//------------------------------------------------------------------------------
TEST_F(Auto, IsTheDefault)
{
  vtkNew<vtkShadowPass> fresh;
  EXPECT_EQ(fresh->GetTechnique(), "auto");
  EXPECT_EQ(fresh->GetMaximumError(), 0.0);
  EXPECT_EQ(fresh->GetMaximumFrameTime(), 0.0);
}

//------------------------------------------------------------------------------
// One frame of a script is right already, by every kind of light.
TEST_F(Auto, FirstFrame)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->MakeStillLife();
  vtkLight* spot = AddSpot(this->Renderer, { 3.0, -3.0, 6.0 }, { 0.0, 0.0, 0.0 }, 35.0);
  vtkLight* lamp = AddLamp(this->Renderer, { 0.8, -0.4, 2.4 });
  this->Render();
  for (vtkLight* light : { this->Sun.Get(), spot, lamp })
  {
    this->ExpectChosen(light, { "depth-map", "stencil-volume", "ray-cast" });
    this->CheckMeasure(this->Chosen(light), light, 0.5, 0.001);
  }
}

//------------------------------------------------------------------------------
TEST_F(Auto, SettlesAndDoesNotFlicker)
{
  this->MakeStillLife();
  this->Settle();
  const std::string settled = this->Chosen(this->Sun);
  const vtkIdType builds = this->Builds();
  for (int i = 0; i < 30; ++i)
  {
    this->Renderer->GetActiveCamera()->Azimuth(0.1);
    this->Render();
    EXPECT_EQ(this->Chosen(this->Sun), settled) << "frame " << i;
  }
  Check("maps drawn once it has settled", static_cast<double>(this->Builds() - builds), 0.0);
}

//------------------------------------------------------------------------------
// Whatever the budget of error, it is kept to, in scenes by lot.
TEST_F(Auto, ErrorBudgetHolds)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->MakeStillLife();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  for (int i = 0; i < 40; ++i)
  {
    AddSphere(this->Renderer, { 4.0 * share(random), 4.0 * share(random), 1.5 + share(random) },
      0.05 + 0.1 * std::abs(share(random)), 12);
  }
  std::set<std::string> explanations;
  for (const double percent : { 2.0, 0.3, 0.1, 0.03, 0.01, 0.001 })
  {
    this->Shadows->SetMaximumError(percent);
    for (int view = 0; view < 3; ++view)
    {
      const double angle = 25.0 + 70.0 * view + 1.0e3 * percent;
      LookAt(this->Renderer, { 8.0 * std::cos(angle), 8.0 * std::sin(angle), 2.0 + 2.0 * view },
        { 0.0, 0.0, 0.5 });
      this->Render();
      this->CheckMeasure(this->Shadows->GetExplanation(this->Sun), this->Sun, percent, 100.0);
    }
    this->Settle();
    explanations.insert(this->Chosen(this->Sun) +
      std::to_string(this->Shadows->GetDepthShadowMapPass()->GetResolution()) +
      std::to_string(this->Shadows->GetDepthShadowMapPass()->GetFilter()));
    this->CheckMeasure(
      "settled, " + this->Shadows->GetExplanation(this->Sun), this->Sun, percent, 100.0);
  }
  // The budget matters: a loose one has another setting than a strict one.
  CheckAtLeast("settings taken", static_cast<double>(explanations.size()), 2.0);
}

//------------------------------------------------------------------------------
TEST_F(Auto, FrameTimeBudget)
{
  this->MakeStillLife();
  // Time for anything: what is exact.
  this->Shadows->SetMaximumFrameTime(1.0e5);
  this->Settle();
  this->ExpectChosen(this->Sun, { "stencil-volume", "ray-cast" }, { "within", "asked for" });
  // None: the fastest, and it says that it is too slow.
  this->Shadows->SetMaximumFrameTime(1.0e-3);
  this->Settle();
  this->ExpectChosen(this->Sun, { "depth-map", "stencil-volume" }, { "more than the" });
}

//------------------------------------------------------------------------------
TEST_F(Auto, BadBudgets)
{
  this->Shadows->SetMaximumError(0.5);
  this->Shadows->SetMaximumFrameTime(20.0);
  const double bad[] = { -1.0, std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity() };
  for (const double value : bad)
  {
    this->Shadows->SetMaximumError(value);
    ExpectOneMessage({ "vtkShadowPass", "MaximumError", "give percent", "stays 0.5" });
    this->Shadows->SetMaximumFrameTime(value);
    ExpectOneMessage({ "vtkShadowPass", "MaximumFrameTime", "give milliseconds", "stays 20" });
  }
  this->Shadows->SetMaximumError(100.5);
  ExpectOneMessage({ "MaximumError 100.5" });
  EXPECT_EQ(this->Shadows->GetMaximumError(), 0.5);
  EXPECT_EQ(this->Shadows->GetMaximumFrameTime(), 20.0);
}

//------------------------------------------------------------------------------
// Casters that only maps draw, and casters that rays hit and volumes do not stand on.
TEST_F(Auto, KindsOfCasters)
{
  this->MakeStillLife();
  vtkNew<vtkOpenGLSphereMapper> spheres;
  vtkNew<vtkPolyData> centres;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-1.5, -0.5, 0.6);
  centres->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0 });
  centres->SetVerts(cells);
  spheres->SetInputData(centres);
  spheres->SetRadius(0.4);
  vtkNew<vtkActor> impostors;
  impostors->SetMapper(spheres);
  this->Renderer->AddActor(impostors);
  this->Settle();
  this->ExpectChosen(
    this->Sun, { "depth-map", "ray-cast" }, { "not", "stencil-volume: sphere impostors cast" });

  vtkNew<vtkLineSource> line;
  line->SetPoint1(-2.0, 1.0, 1.0);
  line->SetPoint2(-1.0, 2.0, 2.0);
  AddActor(this->Renderer, line);
  this->Settle();
  this->ExpectChosen(this->Sun, { "depth-map" },
    { "not measured", "stencil-volume: lines and points cast",
      this->Shadows->GetRayCastShadowPass() ? "ray-cast: lines and points cast"
                                            : "ray-cast: this build has none" });
}

//------------------------------------------------------------------------------
TEST_F(Auto, TranslucentReceiversAskForLookups)
{
  this->MakeStillLife();
  auto pane = AddFloor(this->Renderer, 1.0, 0.3);
  pane->GetProperty()->SetOpacity(0.5);
  this->Settle();
  this->ExpectChosen(this->Sun, { "depth-map" }, { "translucent props receive" });
}

//------------------------------------------------------------------------------
TEST_F(Auto, FlatReceiversMayBePlanar)
{
  this->MakeStillLife();
  vtkPropCollection* props = this->Renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    auto* prop = vtkProp::SafeDownCast(props->GetItemAsObject(i));
    vtkShadowPass::SetReceivesShadows(prop, prop == this->Floor);
  }
  this->Settle();
  this->ExpectChosen(this->Sun, { "planar", "depth-map", "stencil-volume" });
  const std::string explanation = this->Shadows->GetExplanation(this->Sun);
  EXPECT_EQ(explanation.find("not all that receives"), std::string::npos) << explanation;
  EXPECT_NE(explanation.find("planar"), std::string::npos) << "it was tried: " << explanation;
}

//------------------------------------------------------------------------------
// What a scene does not require is neither built nor drawn.
TEST_F(Auto, NothingIsBuiltThatIsNotRequired)
{
  this->MakeStillLife();
  // Behind a wall that has everything on its lit side, a spot that looks away from it all.
  vtkLight* away = AddSpot(this->Renderer, { 0.0, 0.0, 20.0 }, { 0.0, 0.0, 40.0 }, 20.0);
  this->Renderer->RemoveLight(this->Sun);
  this->Render();
  this->ExpectChosen(away, { "none" }, { "can fall on anything in view" });
  Check("maps", static_cast<double>(this->Builds()), 0.0);
  Check("texture memory of maps",
    static_cast<double>(this->Shadows->GetDepthShadowMapPass()->GetTextureMemory()), 0.0);
  Check("texture memory of volumes",
    static_cast<double>(this->Shadows->GetStencilShadowVolumePass()->GetTextureMemory()), 0.0);
  if (this->Shadows->GetRayCastShadowPass())
  {
    Check("trees", this->Shadows->GetRayCastShadowPass()->GetNumberOfTreeBuilds(), 0.0);
  }

  // Beside one that is seen it has no map.
  this->Renderer->AddLight(this->Sun);
  this->Settle();
  EXPECT_EQ(this->Chosen(away), "none");
  if (this->Chosen(this->Sun) == "depth-map")
  {
    Check("views", this->Shadows->GetDepthShadowMapPass()->GetNumberOfViews(), 1.0);
    Check("cascades of a small scene",
      this->Shadows->GetDepthShadowMapPass()->GetNumberOfCascades(), 1.0);
    Check("texture memory of volumes that were tried",
      static_cast<double>(this->Shadows->GetStencilShadowVolumePass()->GetTextureMemory()), 0.0);
  }
}

//------------------------------------------------------------------------------
TEST_F(Auto, WhatNeedsNoShadow)
{
  this->Sun = AddSun(this->Renderer, { 0.0, 0.0, -1.0 });
  this->Render();
  this->ExpectChosen(this->Sun, { "none" }, { "nothing casts" });
  this->MakeStillLife();
  vtkNew<vtkLight> headlight;
  headlight->SetLightTypeToHeadlight();
  this->Renderer->AddLight(headlight);
  this->Shadows->SetLightStrength(this->Sun, 0.0);
  this->Render();
  this->ExpectChosen(headlight, { "none" }, { "from the eye" });
  this->ExpectChosen(this->Sun, { "none" }, { "strength" });
  EXPECT_EQ(this->Shadows->GetExplanation(nullptr), "none: the last frame had no such light.");
}

//------------------------------------------------------------------------------
// A light begins to move, then rests: each has a choice of its own, and both stay right.
TEST_F(Auto, MovingLight)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->MakeStillLife();
  this->Settle();
  const std::string atRest = this->Shadows->GetExplanation(this->Sun).substr(0, 20);
  int changes = 0;
  std::string before = this->Chosen(this->Sun);
  for (int i = 0; i < 60; ++i)
  {
    this->Sun->SetPosition(-0.4 + 0.01 * i, -0.3, 1.0);
    this->Render();
    changes += this->Chosen(this->Sun) != before ? 1 : 0;
    before = this->Chosen(this->Sun);
    if (i % 20 == 19)
    {
      this->CheckMeasure("moving: " + before, this->Sun, 0.5, 0.001);
    }
  }
  // A machine with much else to do draws a strange frame now and then, which begins the trials
  // anew.
  for (int i = 0; i < 180 && !this->Shadows->GetChoiceIsSettled(); ++i)
  {
    this->Sun->SetPosition(0.19 + 0.01 * (i % 2), -0.3, 1.0);
    this->Render();
  }
  EXPECT_TRUE(this->Shadows->GetChoiceIsSettled());
  // Three ways are timed twice each, and then one is taken.
  CheckAtMost("changes of technique in 60 frames", changes, 7.0);
  // Where it stands now measures of before may be of another picture, and new ones wait until
  // frames have taken 20 times as long as they did.
  const auto now = [this]() { return this->Shadows->GetExplanation(this->Sun).substr(0, 20); };
  for (int i = 0; i < 3 || (i < 2000 && now() != atRest); ++i)
  {
    this->Render();
  }
  EXPECT_EQ(now(), atRest) << this->Shadows->GetExplanation(this->Sun);
}

//------------------------------------------------------------------------------
// One of two lights turns fast, and what was measured of it is soon of another picture: what each
// has does not go to and fro.
TEST_F(Auto, OneOfTwoLightsTurns)
{
  this->MakeStillLife();
  vtkLight* second = AddSun(this->Renderer, { -0.5, 0.2, -1.0 });
  second->SetIntensity(0.4);
  this->Settle();
  std::string before;
  int changes = 0;
  for (int i = 0; i < 100; ++i)
  {
    const double angle = 0.05 * i;
    this->Sun->SetPosition(0.5 * std::cos(angle), 0.5 * std::sin(angle), 1.0);
    this->Render();
    const std::string now = this->Shadows->GetExplanation(this->Sun).substr(0, 30) +
      this->Shadows->GetExplanation(second).substr(0, 30);
    changes += i > 0 && now != before ? 1 : 0;
    before = now;
  }
  // Ways are timed in rows: a change a frame would be 99.
  CheckAtMost("changes in 100 frames", changes, 25.0);
}

//------------------------------------------------------------------------------
// A caster comes that the map in use is too coarse for.
TEST_F(Auto, CasterAdded)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->MakeStillLife();
  this->Shadows->SetMaximumError(0.05);
  this->Settle();
  this->CheckMeasure("before", this->Sun, 0.05, 100.0);
  for (int i = 0; i < 30; ++i)
  {
    AddBox(this->Renderer, { -3.0 + 0.2 * i, -3.0, 0.0 }, { -2.96 + 0.2 * i, -2.96, 1.0 });
  }
  this->Render();
  this->ExpectChosen(this->Sun, { "depth-map", "stencil-volume", "ray-cast" });
  this->CheckMeasure("with a fence", this->Sun, 0.05, 100.0);
  this->Settle();
  this->CheckMeasure("settled", this->Sun, 0.05, 100.0);
}

//------------------------------------------------------------------------------
// Lights that name their technique keep it, and its settings are theirs.
TEST_F(Auto, BesideNamedTechniques)
{
  this->MakeStillLife();
  vtkLight* spot = AddSpot(this->Renderer, { 3.0, -3.0, 6.0 }, { 0.0, 0.0, 0.0 }, 35.0);
  vtkLight* lamp = AddLamp(this->Renderer, { 0.0, -3.0, 4.0 });
  this->Shadows->SetLightTechnique(spot, "depth-map");
  this->Shadows->SetLightTechnique(lamp, "ray-cast");
  if (!this->Shadows->GetRayCastShadowPass())
  {
    this->Shadows->SetLightTechnique(lamp, "stencil-volume");
    TakeMessages();
  }
  vtkDepthShadowMapPass* maps = this->Shadows->GetDepthShadowMapPass();
  this->Shadows->SetMaximumError(0.001);
  for (int i = 0; i < 30; ++i)
  {
    this->Render();
    EXPECT_EQ(maps->GetResolution(), 2048);
    EXPECT_EQ(maps->GetFilter(), static_cast<int>(vtkDepthShadowMapPass::PERCENTAGE_CLOSER));
  }
  this->ExpectChosen(spot, { "depth-map" }, { "named" });
  this->ExpectChosen(this->Sun, { "depth-map", "stencil-volume", "ray-cast" });
}

//------------------------------------------------------------------------------
TEST_F(Auto, UsersSettingsStay)
{
  this->MakeStillLife();
  vtkDepthShadowMapPass* maps = this->Shadows->GetDepthShadowMapPass();
  maps->SetResolution(700);
  for (int i = 0; i < 30; ++i)
  {
    this->Render();
    EXPECT_EQ(maps->GetResolution(), 700);
  }
  // What was chosen is put back once nothing is chosen.
  maps->SetResolution(2048);
  this->Settle();
  this->Shadows->SetTechnique("depth-map");
  this->Render();
  EXPECT_EQ(maps->GetResolution(), 2048);
  EXPECT_EQ(maps->GetFilter(), static_cast<int>(vtkDepthShadowMapPass::PERCENTAGE_CLOSER));
  // Also one that the user sets while another is in use.
  this->Shadows->SetTechniqueToAuto();
  this->Render();
  maps->SetResolution(600);
  this->Render();
  EXPECT_EQ(maps->GetResolution(), 600);
  this->Shadows->SetTechnique("depth-map");
  this->Render();
  EXPECT_EQ(maps->GetResolution(), 600);
}

//------------------------------------------------------------------------------
// Frames that make one picture are drawn alike, though trials are not done; they go on afterwards.
TEST_F(Auto, HeldFramesAreAlike)
{
  this->MakeStillLife();
  this->Render();
  this->Render();
  ASSERT_FALSE(this->Shadows->GetChoiceIsSettled());
  const std::string drawn = this->Chosen(this->Sun);
  this->Shadows->HoldChoiceOn();
  for (int i = 0; i < 30; ++i)
  {
    this->Render();
    EXPECT_EQ(this->Chosen(this->Sun), drawn) << "frame " << i;
  }
  EXPECT_FALSE(this->Shadows->GetChoiceIsSettled());
  this->Shadows->HoldChoiceOff();
  this->Settle();
  EXPECT_TRUE(this->Shadows->GetChoiceIsSettled());
}

//------------------------------------------------------------------------------
// A read-back is that of the frame before it, and does not disturb what is being told.
TEST_F(Auto, ReadBackIsOfTheFrame)
{
  this->MakeStillLife();
  // How many frames it takes hangs on the clock: a busy machine makes one of a fast way slow.
  for (int i = 0; i < 60 && (i < 20 || !this->Shadows->GetChoiceIsSettled()); ++i)
  {
    this->Render();
    const std::string drawn = this->Chosen(this->Sun);
    this->VisibilityOf(this->Sun);
    EXPECT_EQ(this->Chosen(this->Sun), drawn) << "frame " << i;
  }
  EXPECT_TRUE(this->Shadows->GetChoiceIsSettled());
}
