// Shadow textures: held against the truth where they claim it, what they leave lit, when they are
// drawn again, and what they are not made for.
#include "ShadowTest.h"
#include "TestScenes.h"

#include "vtkPlanarShadowPass.h"
#include "vtkShadowErrorMeasure.h"
#include "vtkShadowScene.h"
#include "vtkShadowTexturePass.h"

#include <vtkActorCollection.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace shadowtest;

namespace
{

// In percent of the receiver pixels, at 2048 texels.
constexpr double Mismatch = 0.03;
// Where light grazes what is round, a texel is as long as several pixels.
constexpr double GrossOnRoundThings = 0.005;

class ShadowTextures : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetPass(this->Shadows);
    this->Shadows->SetTechnique("shadow-texture");
    LookAt(this->Renderer, { 0.0, -9.0, 6.0 }, { 0.0, 0.0, 0.5 });
  }

  // One body flies over a floor.
  void AddFlyer()
  {
    this->Floor = AddFloor(this->Renderer, 5.0);
    this->Ball = AddSphere(this->Renderer, { 0.0, 0.0, 1.6 }, 0.7);
  }
  // One of three kinds of light above it.
  vtkSmartPointer<vtkLight> AddLight(int kind)
  {
    return kind == 0 ? AddSun(this->Renderer, { 0.4, 0.3, -1.0 })
      : kind == 1    ? AddSpot(this->Renderer, { -2.0, -1.5, 6.0 }, { 0.0, 0.0, 1.0 }, 30.0)
                     : AddLamp(this->Renderer, { -2.0, -1.5, 6.0 });
  }

  double Drawn()
  {
    const vtkIdType before = this->Pass()->GetNumberOfMapBuilds();
    this->Render();
    return static_cast<double>(this->Pass()->GetNumberOfMapBuilds() - before);
  }
  // What the last frame shows is what a pass shows that has drawn nothing before.
  void CheckFresh(const std::string& what)
  {
    const Frame frame = this->Render();
    vtkNew<vtkShadowPass> fresh;
    fresh->SetTechnique("shadow-texture");
    fresh->GetShadowTexturePass()->SetTexturePerCaster(this->Pass()->GetTexturePerCaster());
    this->Renderer->SetPass(fresh);
    const Frame expected = this->Render();
    this->Renderer->SetPass(this->Shadows);
    Check(what + ": pixels unlike a fresh pass's",
      static_cast<double>(CountDifferent(frame, expected)), 0.0);
  }
  double Difference(vtkLight* light)
  {
    vtkNew<vtkShadowErrorMeasure> error;
    EXPECT_TRUE(error->Measure(this->Renderer, light));
    return error->GetMeanAbsoluteDifference();
  }
  void CheckDifference(const std::string& what, vtkLight* light, double limit)
  {
    CheckAtMost(what + ": mean absolute difference", this->Difference(light), limit);
  }
  double Shadowed(vtkLight* light)
  {
    return static_cast<double>(this->VisibilityOf(light).CountShadowed());
  }

  vtkShadowTexturePass* Pass() { return this->Shadows->GetShadowTexturePass(); }

  vtkSmartPointer<vtkActor> Floor;
  vtkSmartPointer<vtkActor> Ball;
};

const char* const Kinds[] = { "directional", "spot", "point" };

}

//------------------------------------------------------------------------------
TEST_F(ShadowTextures, FlyingBodyOverAFloor)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->AddFlyer();
  for (int kind = 0; kind < 3; ++kind)
  {
    auto light = this->AddLight(kind);
    for (const bool each : { false, true })
    {
      this->Pass()->SetTexturePerCaster(each);
      this->Render();
      this->CheckMeasure(
        std::string(Kinds[kind]) + (each ? ", one each" : ", one for all"), light, Mismatch, 0.0);
      CheckAtLeast("pixels in shadow", this->Shadowed(light), 500.0);
    }
    this->Renderer->RemoveLight(light);
  }
}

// Bodies, lights and views by lot; nothing casts but what flies above all that receives.
TEST_F(ShadowTextures, ByLot)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  std::mt19937 random(7);
  const auto any = [&random](double low, double high)
  { return low + (high - low) * (random() / double(random.max())); };
  for (int round = 0; round < 12; ++round)
  {
    this->Renderer->RemoveAllViewProps();
    this->Renderer->RemoveAllLights();
    vtkShadowPass::SetCastsShadows(AddFloor(this->Renderer, 6.0), false);
    auto hill = AddSphere(this->Renderer, { any(-2.0, 2.0), any(-2.0, 2.0), -1.0 }, 1.6);
    vtkShadowPass::SetCastsShadows(hill, false);
    for (int body = 0; body < 3; ++body)
    {
      const glm::dvec3 place(-2.4 + 2.4 * body, any(-1.0, 1.0), any(1.8, 2.4));
      if (any(0.0, 1.0) < 0.5)
      {
        AddSphere(this->Renderer, place, any(0.3, 0.7));
      }
      else
      {
        AddBox(this->Renderer, place - any(0.3, 0.5), place + any(0.2, 0.5))->RotateX(any(0., 9.));
      }
    }
    // So steep that no body shadows another.
    const glm::dvec3 toward = Toward(any(0.0, 360.0), any(70.0, 88.0));
    auto light = round % 2 == 0
      ? AddSun(this->Renderer, -toward)
      : AddSpot(this->Renderer, 14.0 * toward, { 0.0, 0.0, 0.0 }, any(25.0, 60.0));
    AimCamera(
      this->Renderer, { { 0.0, 0.0, 0.8 }, 3.0 }, any(0.0, 360.0), any(15.0, 70.0), 400, 300);
    this->Pass()->SetTexturePerCaster(round % 3 == 0);
    this->Render();
    this->CheckMeasure("round " + std::to_string(round), light, Mismatch, GrossOnRoundThings);
  }
}

// A point light between floor and ceiling: the picture that is thrown down is not thrown up.
TEST_F(ShadowTextures, BehindTheProjector)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->AddFlyer();
  auto ceiling = AddFloor(this->Renderer, 5.0, 4.5);
  auto lamp = AddLamp(this->Renderer, { 0.1, 0.0, 3.0 });
  LookAt(this->Renderer, { 0.0, -12.0, 2.2 }, { 0.0, 0.0, 2.2 });
  for (const bool each : { false, true })
  {
    this->Pass()->SetTexturePerCaster(each);
    this->Render();
    this->CheckMeasure(each ? "one each" : "one for all", lamp, Mismatch, 0.0);
    CheckAtLeast("pixels in shadow, of the floor", this->Shadowed(lamp), 300.0);
    this->Floor->VisibilityOff();
    this->Render();
    Check("pixels in shadow, of the ceiling", this->Shadowed(lamp), 0.0);
    this->Floor->VisibilityOn();
  }
}

// A plate that receives alone, between the light and the caster, takes no shadow from it.
TEST_F(ShadowTextures, BetweenLightAndCaster)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->AddFlyer();
  auto plate = AddBox(this->Renderer, { -1.0, -1.0, 2.6 }, { 1.0, 1.0, 2.7 });
  vtkShadowPass::SetCastsShadows(plate, false);
  LookAt(this->Renderer, { 0.0, -5.0, 9.0 }, { 0.0, 0.0, 1.5 });
  for (int kind = 0; kind < 3; ++kind)
  {
    auto light = this->AddLight(kind);
    for (const bool each : { false, true })
    {
      this->Pass()->SetTexturePerCaster(each);
      this->Floor->VisibilityOn();
      this->Render();
      CheckAtLeast("pixels in shadow", this->Shadowed(light), 100.0);
      this->Floor->VisibilityOff();
      this->Render();
      Check(std::string(Kinds[kind]) + ": pixels in shadow without the floor",
        this->Shadowed(light), 0.0);
    }
    this->Renderer->RemoveLight(light);
  }
}

// A torus would shadow itself. That it does not is a limit, and not acne.
TEST_F(ShadowTextures, NothingShadowsItself)
{
  AddStillLife(this->Renderer);
  auto sun = AddSun(this->Renderer, { 1.0, 0.3, -0.6 });
  this->Render();
  const double all = this->Shadowed(sun);
  CheckAtLeast("pixels in shadow, with the floor", all, 500.0);
  vtkActorCollection* actors = this->Renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    auto* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
    const double* bounds = actor->GetBounds();
    if (bounds[5] - bounds[4] < 1e-9)
    {
      vtkShadowPass::SetReceivesShadows(actor, false);
    }
  }
  // One more receiver, out of reach, so that it is not told that nothing receives.
  auto away = AddSphere(this->Renderer, { -20.0, 0.0, 0.0 }, 0.2);
  vtkShadowPass::SetCastsShadows(away, false);
  this->Render();
  Check("pixels in shadow, of the casters", this->Shadowed(sun), 0.0);
  EXPECT_NE(vtkShadowTexturePass::GetLimits().find("Nothing shadows itself"), std::string::npos);
}

// Nor does what casts in its place: a larger ball around it.
TEST_F(ShadowTextures, AStandInShadowsItsPropNot)
{
  this->AddFlyer();
  auto sun = this->AddLight(0);
  this->Render();
  const double before = this->Shadowed(sun);
  vtkNew<vtkSphereSource> hull;
  hull->SetCenter(0.0, 0.0, 1.6);
  hull->SetRadius(1.0);
  hull->Update();
  vtkShadowPass::SetStandIn(this->Ball, hull->GetOutput());
  for (const bool each : { false, true })
  {
    this->Pass()->SetTexturePerCaster(each);
    this->Render();
    CheckAtLeast("pixels in shadow, over those without", this->Shadowed(sun) / before, 1.2);
    vtkShadowPass::SetReceivesShadows(this->Floor, false);
    auto away = AddSphere(this->Renderer, { -20.0, 0.0, 0.0 }, 0.2);
    vtkShadowPass::SetCastsShadows(away, false);
    this->Render();
    Check("pixels in shadow, of the ball", this->Shadowed(sun), 0.0);
    this->Renderer->RemoveActor(away);
    vtkShadowPass::SetReceivesShadows(this->Floor, true);
  }
}

// Each with a texture of its own: a ball shadows the box under it, and the box not the ball.
TEST_F(ShadowTextures, OneEachShadowsOtherCasters)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->AddFlyer();
  AddBox(this->Renderer, { -0.8, -0.8, 0.0 }, { 1.2, 1.2, 0.5 });
  for (int kind = 0; kind < 3; ++kind)
  {
    auto light = this->AddLight(kind);
    this->Pass()->TexturePerCasterOn();
    this->Render();
    this->CheckMeasure(std::string(Kinds[kind]) + ", one each", light, Mismatch, 0.0);
    Check("textures", this->Pass()->GetNumberOfTextures(), 2.0);
    const double each = this->Shadowed(light);
    this->Pass()->TexturePerCasterOff();
    this->Render();
    Check("textures", this->Pass()->GetNumberOfTextures(), 1.0);
    CheckAtLeast(
      "pixels in shadow more than with one for all", each - this->Shadowed(light), 500.0);
    this->Renderer->RemoveLight(light);
  }
}

// A lamp amid what casts has the faces of a cube.
TEST_F(ShadowTextures, AmidTheCasters)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto room = AddBox(this->Renderer, { -3.0, -3.0, 0.0 }, { 3.0, 3.0, 4.0 });
  vtkShadowPass::SetCastsShadows(room, false);
  AddSphere(this->Renderer, { 1.5, 1.5, 1.0 }, 0.6);
  AddSphere(this->Renderer, { -1.6, 0.2, 2.0 }, 0.4);
  AddSphere(this->Renderer, { 0.3, 1.8, 3.2 }, 0.3);
  AddBox(this->Renderer, { 0.5, -1.8, 0.0 }, { 1.3, -0.9, 0.9 });
  auto lamp = AddLamp(this->Renderer, { 0.1, -0.2, 1.9 });
  this->Renderer->GetActiveCamera()->SetViewAngle(80.0);
  LookAt(this->Renderer, { -2.8, -2.5, 0.5 }, { 1.0, 1.0, 2.0 });
  for (const bool each : { false, true })
  {
    this->Pass()->SetTexturePerCaster(each);
    this->Render();
    // Four casters in directions of their own.
    this->CheckMeasure(each ? "one each" : "faces of a cube", lamp, 0.1, 0.0);
    CheckAtLeast("pixels in shadow", this->Shadowed(lamp), 2000.0);
  }
}

//------------------------------------------------------------------------------
TEST_F(ShadowTextures, DrawnAgainOnlyIfStale)
{
  this->AddFlyer();
  auto cone = AddBox(this->Renderer, { 1.4, 0.6, 1.0 }, { 2.2, 1.2, 1.5 });
  auto sun = this->AddLight(0);
  auto spot = this->AddLight(1);
  for (const bool each : { false, true })
  {
    const std::string mode = each ? "one each, " : "one for all, ";
    const double perLight = each ? 2.0 : 1.0;
    this->Pass()->SetTexturePerCaster(each);
    Check(mode + "first frame", this->Drawn(), 2.0 * perLight);
    this->Renderer->GetActiveCamera()->Azimuth(5.0);
    Check(mode + "camera moved", this->Drawn(), 0.0);
    this->Floor->GetProperty()->SetColor(0.5, 0.6, 0.7);
    Check(mode + "colour of a receiver", this->Drawn(), 0.0);
    this->CheckFresh(mode + "camera moved");
    sun->SetPosition(-0.5, each ? -0.1 : -0.2, 1.0);
    Check(mode + "one light moved", this->Drawn(), perLight);
    cone->AddPosition(0.1, 0.0, 0.0);
    Check(mode + "one caster moved", this->Drawn(), 2.0);
    this->CheckFresh(mode + "caster moved");
    cone->VisibilityOff();
    this->Render();
    this->CheckFresh(mode + "caster hidden");
    cone->VisibilityOn();
    this->Render();
    spot->SwitchOff();
    Check(mode + "a light off", this->Drawn(), 0.0);
    this->CheckFresh(mode + "a light off");
    spot->SwitchOn();
    this->Render();
    this->CheckFresh(mode + "a light on");
  }
}

// The shadow lies to the right. An eye that looks to the left has no texture made.
TEST_F(ShadowTextures, NoTextureForWhatIsNotSeen)
{
  AddFloor(this->Renderer, 50.0);
  AddSphere(this->Renderer, { 20.0, 0.0, 1.6 }, 0.7);
  auto sun = AddSun(this->Renderer, { 0.4, 0.3, -1.0 });
  LookAt(this->Renderer, { -20.0, -9.0, 6.0 }, { -20.0, 0.0, 0.5 });
  Check("looking away: drawn", this->Drawn(), 0.0);
  Check("textures", this->Pass()->GetNumberOfTextures(), 0.0);
  Check("reached", this->Pass()->GetNumberOfReachedProps(), 0.0);
  LookAt(this->Renderer, { 20.0, -9.0, 6.0 }, { 20.0, 0.0, 0.5 });
  Check("looking there: drawn", this->Drawn(), 1.0);
  Check("textures", this->Pass()->GetNumberOfTextures(), 1.0);
  CheckAtLeast("pixels in shadow", this->Shadowed(sun), 500.0);
  LookAt(this->Renderer, { -20.0, -9.0, 6.0 }, { -20.0, 0.0, 0.5 });
  Check("away again: drawn", this->Drawn(), 0.0);
  LookAt(this->Renderer, { 20.0, -9.0, 6.0 }, { 20.0, 0.0, 0.5 });
  Check("and back: drawn, since it was kept", this->Drawn(), 0.0);
  this->CheckFresh("and back");

  // Of two lights, the one whose shadows are seen.
  AddSun(this->Renderer, { 1.0, 0.0, -0.05 });
  LookAt(this->Renderer, { 20.0, -9.0, 6.0 }, { 19.0, 0.0, 0.5 });
  this->Render();
  const double both = this->Pass()->GetNumberOfTextures();
  LookAt(this->Renderer, { 40.0, -3.0, 6.0 }, { 40.0, 0.0, 0.5 });
  this->Render();
  Check("of two lights, near", both, 2.0);
  Check("of two lights, far to the right", this->Pass()->GetNumberOfTextures(), 1.0);
}

// By lot: whether a texture is made or not, the picture is the same as when all are seen.
TEST_F(ShadowTextures, NothingSeenIsLeftOut)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  std::mt19937 random(3);
  const auto any = [&random](double low, double high)
  { return low + (high - low) * (random() / double(random.max())); };
  AddFloor(this->Renderer, 12.0);
  for (int i = 0; i < 6; ++i)
  {
    AddSphere(this->Renderer, { any(-8.0, 8.0), any(-8.0, 8.0), any(1.0, 2.0) }, 0.5, 16);
  }
  auto light = AddSun(this->Renderer, { 0.8, 0.5, -1.0 });
  this->Pass()->TexturePerCasterOn();
  double least = 6.0;
  for (int view = 0; view < 12; ++view)
  {
    this->Shadows->SetLightRadius(light, view % 3 == 2 ? 0.1 : 0.0);
    const glm::dvec3 focus(any(-8.0, 8.0), any(-8.0, 8.0), 0.0);
    LookAt(
      this->Renderer, focus + glm::dvec3(any(-3.0, 3.0), any(-3.0, 3.0), any(2.0, 5.0)), focus);
    this->Render();
    least = std::min(least, double(this->Pass()->GetNumberOfTextures()));
    vtkNew<vtkShadowErrorMeasure> error;
    ASSERT_TRUE(error->Measure(this->Renderer, light));
    Check("view " + std::to_string(view) + ": gross pixels", error->GetGrossPixels(), 0.0);
  }
  CheckAtMost("fewest textures of a view", least, 5.0);
}

// A floor in four parts: those that no shadow can fall on have no code for it.
TEST_F(ShadowTextures, AppliedOnlyToWhatIsReached)
{
  vtkSmartPointer<vtkActor> parts[4];
  for (int i = 0; i < 4; ++i)
  {
    parts[i] = AddFloor(this->Renderer, 2.0);
    parts[i]->SetPosition(i % 2 == 0 ? -2.0 : 2.0, i < 2 ? -2.0 : 2.0, 0.0);
  }
  AddSphere(this->Renderer, { 1.5, 1.5, 1.0 }, 0.5);
  auto sun = AddSun(this->Renderer, { 0.0, 0.0, -1.0 });
  for (const bool each : { false, true })
  {
    this->Pass()->SetTexturePerCaster(each);
    this->Render();
    Check("parts that are reached", this->Pass()->GetNumberOfReachedProps(), 1.0);
    CheckAtLeast("pixels in shadow", this->Shadowed(sun), 500.0);
    for (const auto& part : parts)
    {
      part->SetVisibility(part != parts[3]);
    }
    this->Render();
    Check("without that part", this->Shadowed(sun), 0.0);
    parts[3]->VisibilityOn();
  }
}

//------------------------------------------------------------------------------
// What lies before the plane casts and takes no shadow; a ball beyond it receives and casts none.
TEST_F(ShadowTextures, ByNearPlane)
{
  this->AddFlyer();
  auto lower = AddSphere(this->Renderer, { 2.0, 0.0, 0.5 }, 0.4);
  this->Pass()->SetCasterSelection(vtkShadowTexturePass::BY_NEAR_PLANE);
  for (int kind = 0; kind < 3; ++kind)
  {
    // Straight above: depths are heights.
    auto light = kind == 0 ? AddSun(this->Renderer, { 0.0, 0.0, -1.0 })
      : kind == 1          ? AddSpot(this->Renderer, { 0.0, 0.0, 6.0 }, { 0.0, 0.0, 0.0 }, 50.0)
                           : AddLamp(this->Renderer, { 0.0, 0.0, 6.0 });
    light->SetPosition(0.0, 0.0, 6.0);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    const auto shadowOf = [&](double plane)
    {
      this->Pass()->SetNearPlane(plane);
      this->Render();
      return this->Shadowed(light);
    };
    const std::string name = std::string(Kinds[kind]) + ": ";
    Check(name + "nothing before the plane", shadowOf(2.0), 0.0);
    Check(name + "the plane cuts the ball", shadowOf(4.0), 0.0);
    const double one = shadowOf(5.25);
    CheckAtLeast(name + "a ball before it", one, 500.0);
    lower->VisibilityOff();
    Check(name + "the lower ball casts none", shadowOf(5.25), one, 250.0);
    lower->VisibilityOn();
    CheckAtLeast(name + "both balls before it", shadowOf(kind == 2 ? 6.5 : 5.97) - one, 200.0);
    this->Renderer->RemoveLight(light);
  }
  // All before the plane.
  auto sun = AddSun(this->Renderer, { 0.0, 0.0, -1.0 });
  sun->SetPosition(0.0, 0.0, 6.0);
  this->Pass()->SetNearPlane(50.0);
  this->Render();
  this->Render();
  ExpectOneMessage({ "vtkShadowTexturePass", "near plane, 50", "Set NearPlane" });
  this->Renderer->RemoveLight(sun);
  // Keys still hold.
  AddSun(this->Renderer, { 0.0, 0.0, -1.0 })->SetPosition(0.0, 0.0, 6.0);
  vtkShadowPass::SetCastsShadows(this->Ball, false);
  this->Pass()->SetNearPlane(5.25);
  this->Render();
  Check("a ball that shall not cast", this->Pass()->GetNumberOfTextures(), 0.0);
}

//------------------------------------------------------------------------------
// The higher the caster, the wider the edge; and right for a plate that faces the light.
TEST_F(ShadowTextures, EdgesSoftenWithDistance)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddFloor(this->Renderer, 6.0);
  auto plate = AddBox(this->Renderer, { -1.0, -1.0, 0.0 }, { 1.0, 1.0, 0.02 });
  LookAt(this->Renderer, { 0.0, -6.0, 9.0 }, { 0.0, 0.0, 0.0 });
  for (int kind = 0; kind < 3; ++kind)
  {
    auto light = kind == 0 ? AddSun(this->Renderer, { 0.0, 0.0, -1.0 })
      : kind == 1          ? AddSpot(this->Renderer, { 0.0, 0.0, 9.0 }, { 0.0, 0.0, 0.0 }, 50.0)
                           : AddLamp(this->Renderer, { 0.0, 0.0, 9.0 });
    this->Shadows->SetLightRadius(light, kind == 0 ? 0.06 : 0.5);
    double before[2] = { 0.0, 0.0 }; // by mode
    for (const double height : { 0.3, 0.8, 1.6, 3.0 })
    {
      for (const bool each : { false, true })
      {
        this->Pass()->SetTexturePerCaster(each);
        plate->SetPosition(0.0, 0.0, height);
        this->Render();
        const std::string name = std::string(Kinds[kind]) + ", height " + std::to_string(height);
        const double soft = this->Difference(light);
        CheckAtMost(name + ": mean absolute difference", soft, 0.002);
        this->Shadows->SetTechnique("depth-map");
        this->Render();
        CheckAtMost(name + ": of that of a hard shadow", soft / this->Difference(light), 0.12);
        this->Shadows->SetTechnique("shadow-texture");
        this->Render();
        const Visibility seen = this->VisibilityOf(light);
        const auto between = static_cast<double>(std::count_if(seen.values.begin(),
          seen.values.end(), [](float value) { return value > 0.1f && value < 0.9f; }));
        CheckAtLeast(
          name + ": pixels half in shadow, over those before", between / before[each], 1.15);
        before[each] = between;
      }
    }
    this->Renderer->RemoveLight(light);
  }
}

// What lies beside a caster is softened by that caster's own distance.
TEST_F(ShadowTextures, EachCasterHasItsOwnSoftness)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->AddFlyer();
  AddBox(this->Renderer, { -3.0, -0.5, 0.3 }, { -2.0, 0.5, 0.4 });
  auto spot = AddSpot(this->Renderer, { -1.0, -1.0, 8.0 }, { -1.0, 0.0, 0.0 }, 50.0);
  this->Shadows->SetLightRadius(spot, 0.5);
  for (const bool each : { false, true })
  {
    this->Pass()->SetTexturePerCaster(each);
    this->Render();
    this->CheckDifference(each ? "one each" : "one for all", spot, 0.005);
  }
}

//------------------------------------------------------------------------------
// Sixteen lights, some by other techniques: each is as it is alone.
TEST_F(ShadowTextures, SixteenLightsAmongOthers)
{
  this->Resize(200, 150);
  this->AddFlyer();
  AddBox(this->Renderer, { 1.4, 0.6, 1.0 }, { 2.2, 1.2, 1.5 });
  std::vector<vtkSmartPointer<vtkLight>> lights;
  for (int i = 0; i < 16; ++i)
  {
    const glm::dvec3 toward = Toward(22.5 * i, 55.0);
    lights.push_back(i % 3 == 0 ? AddSun(this->Renderer, -toward)
        : i % 3 == 1            ? AddSpot(this->Renderer, 7.0 * toward, { 0.0, 0.0, 1.0 }, 40.0)
                                : AddLamp(this->Renderer, 7.0 * toward));
    lights.back()->SetIntensity(0.1);
    if (i % 4 == 3)
    {
      this->Shadows->SetLightTechnique(lights[i], i % 8 == 3 ? "depth-map" : "planar");
    }
  }
  for (const bool each : { false, true })
  {
    this->Pass()->SetTexturePerCaster(each);
    for (const std::size_t i : { 0u, 1u, 2u, 10u, 15u })
    {
      for (const auto& light : lights)
      {
        light->SwitchOn();
      }
      this->Render();
      const Visibility together = this->VisibilityOf(lights[i]);
      for (const auto& light : lights)
      {
        light->SetSwitch(light == lights[i]);
      }
      this->Render();
      // Beyond eight lookups positions are transformed where pixels are shaded: another rounding.
      Check("light " + std::to_string(i) + ": pixels unlike it alone",
        static_cast<double>(CountDifferent(together, this->VisibilityOf(lights[i]))), 0.0, 2.0);
      EXPECT_GT(together.CountShadowed(), 70u);
    }
  }
}

// A translucent floor, and one of spheres by impostors; a shadow catcher; half strength.
TEST_F(ShadowTextures, ReceiversOfEveryKind)
{
  this->AddFlyer();
  auto sun = this->AddLight(0);
  const Frame lit = this->RenderWithoutPass();
  const Frame whole = this->Render();
  const Pixel dark = PixelOf(this->Renderer, { 0.64, 0.48, 0.0 });
  const auto brightness = [&](const Frame& frame)
  { return static_cast<double>(frame.Brightness(dark.x, dark.y)); };
  Check("whole strength", brightness(whole), 0.0);
  this->Shadows->SetLightStrength(sun, 0.5);
  Check("half strength", brightness(this->Render()), 0.5 * brightness(lit), 3.0);
  this->Shadows->SetLightStrength(sun, 1.0);
  for (const bool each : { false, true })
  {
    this->Pass()->SetTexturePerCaster(each);
    this->Floor->GetProperty()->SetOpacity(0.5);
    Check("translucent", brightness(this->Render()), 0.0, 3.0);
    CheckAtLeast("translucent, unshadowed", brightness(this->RenderWithoutPass()), 200.0);
    vtkShadowPass::SetShadowCatcher(this->Floor, true);
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    Check("caught on white", brightness(this->Render()), 0.0, 3.0);
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    vtkShadowPass::SetShadowCatcher(this->Floor, false);
    this->Floor->GetProperty()->SetOpacity(1.0);
  }

  this->Floor->VisibilityOff();
  vtkNew<vtkPoints> points;
  vtkNew<vtkPolyData> grid;
  for (int i = -12; i <= 12; ++i)
  {
    for (int j = -12; j <= 12; ++j)
    {
      points->InsertNextPoint(0.2 * i, 0.2 * j, 0.0);
    }
  }
  grid->SetPoints(points);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(grid);
  mapper->SetRadius(0.14);
  vtkNew<vtkActor> balls;
  balls->SetMapper(mapper);
  vtkShadowPass::SetCastsShadows(balls, false);
  vtkShadowPass::SetReceivesShadows(this->Ball, false);
  this->Renderer->AddActor(balls);
  for (const bool each : { false, true })
  {
    this->Pass()->SetTexturePerCaster(each);
    this->Render();
    const double textures = this->Shadowed(sun);
    this->Shadows->SetTechnique("depth-map");
    this->Render();
    Check("on impostors: pixels in shadow, beside the depth map's", textures, this->Shadowed(sun),
      0.03 * textures);
    CheckAtLeast("pixels", textures, 300.0);
    this->Shadows->SetTechnique("shadow-texture");
  }
  // And they cast.
  this->Floor->VisibilityOn();
  this->Floor->SetPosition(0.0, 0.0, -2.0);
  vtkShadowPass::SetCastsShadows(balls, true);
  vtkShadowPass::SetCastsShadows(this->Ball, false);
  this->Render();
  const Visibility cast = this->VisibilityOf(sun);
  this->Shadows->SetTechnique("depth-map");
  vtkShadowPass::SetReceivesShadows(balls, false);
  this->Render();
  const Visibility expected = this->VisibilityOf(sun);
  CheckAtMost("by impostors: share of pixels unlike the depth map's",
    static_cast<double>(CountDifferent(cast, expected)) / expected.CountShadowed(), 0.03);
}

//------------------------------------------------------------------------------
TEST_F(ShadowTextures, OffsetsAndScales)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  for (const Placement& placement : Placements)
  {
    for (const bool each : { false, true })
    {
      this->Renderer->RemoveAllViewProps();
      this->Renderer->RemoveAllLights();
      this->AddFlyer();
      PlaceActors(this->Renderer, placement, true);
      auto spot = AddSpot(
        this->Renderer, placement.Of({ -2.0, -1.5, 6.0 }), placement.Of({ 0.0, 0.0, 1.0 }), 30.0);
      LookAt(this->Renderer, placement.Of({ 0.0, -9.0, 6.0 }), placement.Of({ 0.0, 0.0, 0.5 }));
      this->Pass()->SetTexturePerCaster(each);
      this->Shadows->SetLightRadius(spot, 0.0);
      this->Render();
      this->CheckMeasure(
        std::string(placement.name) + (each ? ", one each" : ", one for all"), spot, Mismatch, 0.0);
      this->Shadows->SetLightRadius(spot, 0.4 * placement.scale);
      this->Render();
      this->CheckDifference(std::string(placement.name) + ", soft", spot, 0.005);
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(ShadowTextures, BadSettings)
{
  this->AddFlyer();
  auto sun = this->AddLight(0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double plane : { 0.0, -1.0, nan, infinity })
  {
    this->Pass()->SetNearPlane(plane);
    ExpectOneMessage({ "vtkShadowTexturePass", "NearPlane", "finite one above 0" });
    Check("near plane", this->Pass()->GetNearPlane(), 1.0);
  }
  for (const int selection : { -1, 2 })
  {
    this->Pass()->SetCasterSelection(selection);
    ExpectOneMessage({ "vtkShadowTexturePass", "CasterSelection", std::to_string(selection) });
    Check("caster selection", this->Pass()->GetCasterSelection(), 0.0);
  }
  this->Pass()->SetResolution(0);
  ExpectOneMessage({ "vtkShadowTexturePass", "Resolution 0", "1 or more" });
  Check("resolution", this->Pass()->GetResolution(), 2048.0);
  this->Render();
  CheckAtLeast("pixels in shadow", this->Shadowed(sun), 500.0);
  for (const int resolution : { 1, 2, 5, 16 })
  {
    for (const double radius : { 0.0, 0.2 })
    {
      this->Pass()->SetResolution(resolution);
      this->Shadows->SetLightRadius(sun, radius);
      this->Render(); // coarse, and without a message
    }
  }
  this->Pass()->SetResolution(64);
  this->Shadows->SetLightRadius(sun, 0.0);
  this->Render();
  CheckAtLeast("pixels in shadow, coarse", this->Shadowed(sun), 400.0);
}

// A lamp that touches what casts, and one inside of it.
TEST_F(ShadowTextures, LightsInImpossiblePlaces)
{
  this->AddFlyer();
  for (const glm::dvec3& place :
    { glm::dvec3(0.0, 0.0, 1.6), { 0.0, 0.0, 2.3 }, { 0.0, 0.0, 0.0 } })
  {
    auto lamp = AddLamp(this->Renderer, place);
    for (const bool each : { false, true })
    {
      this->Pass()->SetTexturePerCaster(each);
      this->Render();
      const Visibility seen = this->VisibilityOf(lamp);
      Check("values that are none",
        static_cast<double>(std::count_if(seen.values.begin(), seen.values.end(),
          [](float value) { return !(value >= 0.0f && value <= 1.0f); })),
        0.0);
    }
    this->Renderer->RemoveLight(lamp);
  }
}

// A floor in which things are sunk a bit receives; one that is told to cast does not.
TEST_F(ShadowTextures, AFloorReceives)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->AddFlyer();
  AddSphere(this->Renderer, { 1.8, 0.0, 0.3 }, 0.5);
  auto sun = this->AddLight(0);
  this->Render();
  this->CheckMeasure("sunk", sun, Mismatch, 0.0);
  CheckAtLeast("pixels in shadow", this->Shadowed(sun), 1000.0);
  vtkShadowPass::SetCastsShadows(this->Floor, true);
  this->Render();
  Check("told to cast: pixels in shadow", this->Shadowed(sun), 0.0);
  ExpectOneMessage({ "casts, too" });
}

// A caster that lies behind a receiver does not darken it, hard or soft.
TEST_F(ShadowTextures, BeforeACaster)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->AddFlyer();
  AddBox(this->Renderer, { -4.0, -4.0, -1.2 }, { 4.0, 4.0, -1.0 });
  vtkShadowPass::SetCastsShadows(this->Floor, false);
  auto column = AddBox(this->Renderer, { -2.0, -1.0, 0.0 }, { -1.8, -0.8, 2.5 });
  vtkShadowPass::SetCastsShadows(column, false);
  for (int kind = 0; kind < 3; ++kind)
  {
    auto light = this->AddLight(kind);
    for (const bool each : { false, true })
    {
      this->Pass()->SetTexturePerCaster(each);
      this->Shadows->SetLightRadius(light, 0.0);
      this->Render();
      this->CheckMeasure(std::string(Kinds[kind]), light, Mismatch, 0.0);
      this->Shadows->SetLightRadius(light, kind == 0 ? 0.06 : 0.4);
      this->Render();
      this->CheckDifference(std::string(Kinds[kind]) + ", soft", light, 0.006);
    }
    this->Renderer->RemoveLight(light);
  }
}

// Where all that receives casts, too, nothing can be darkened: said once, and the frame is lit.
TEST_F(ShadowTextures, NothingReceives)
{
  auto box = AddBox(this->Renderer, { -2.0, -2.0, 0.0 }, { 2.0, 2.0, 0.4 });
  AddSphere(this->Renderer, { 0.0, 0.0, 1.6 }, 0.7);
  auto sun = this->AddLight(0);
  this->Render();
  EXPECT_TRUE(TakeMessages().empty()) << "told of a single frame";
  const Frame frame = this->Render();
  ExpectOneMessage({ "vtkShadowTexturePass", "casts, too", "CASTS_SHADOWS", "TexturePerCaster" });
  Check("pixels unlike the unshadowed frame",
    static_cast<double>(CountDifferent(frame, this->RenderWithoutPass())), 0.0);
  this->Render(); // told once
  this->Pass()->TexturePerCasterOn();
  this->Render();
  CheckAtLeast("one each: pixels in shadow", this->Shadowed(sun), 300.0);
  this->Pass()->TexturePerCasterOff();
  vtkShadowPass::SetCastsShadows(box, false);
  this->Render();
  CheckAtLeast("a box that does not cast: pixels in shadow", this->Shadowed(sun), 300.0);
}
