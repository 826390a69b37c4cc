// Shadow volumes against the truth: scenes and views by lot, every kind of mesh, eyes and lights in
// awkward places, many lights, lights with a radius.
#include "Lot.h"
#include "TestScenes.h"
#include "VolumeTest.h"

#include "vtkShadowErrorMeasure.h"

#include <vtkActorCollection.h>
#include <vtkConeSource.h>
#include <vtkCylinderSource.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <functional>

using namespace shadowtest;
using testinglot::Lot;

namespace
{

const double Pi = std::acos(-1.0);

class StencilVolumes : public VolumeTest
{
protected:
  // A sun, a spot, a lamp outside and one at `amid`, each in three views.
  void CheckLightsByLot(
    const std::string& what, const Subject& subject, const glm::dvec3& amid, int seed);
  // The mesh over a floor, by a sun and a lamp.
  void CheckMesh(const std::string& what, vtkPolyData* mesh, double mismatchPercent = 0.1);
  void LookFrom(const glm::dvec3& position, const glm::dvec3& focus)
  {
    LookAt(this->Renderer, position, focus);
  }
};

void StencilVolumes::CheckLightsByLot(
  const std::string& what, const Subject& subject, const glm::dvec3& amid, int seed)
{
  Lot lot(seed);
  const char* kinds[] = { "sun", "spot", "lamp outside", "lamp amid" };
  for (int kind = 0; kind < 4; ++kind)
  {
    this->Renderer->RemoveAllLights();
    const glm::dvec3 toward = Toward(lot.Any(0.0, 360.0), lot.Any(25.0, 80.0));
    const glm::dvec3 place = subject.centre + lot.Any(2.0, 5.0) * subject.radius * toward;
    vtkSmartPointer<vtkLight> light = kind == 0 ? AddSun(this->Renderer, -toward)
      : kind == 1 ? AddSpot(this->Renderer, place, subject.centre, lot.Any(25.0, 50.0))
                  : AddLamp(this->Renderer, kind == 2 ? place : amid);
    for (int view = 0; view < 3; ++view)
    {
      AimCamera(this->Renderer, subject, lot.Any(0.0, 360.0), lot.Any(10.0, 70.0), 320, 240);
      this->CheckTruth(what + ", " + kinds[kind] + ", view " + std::to_string(view), light);
    }
  }
}

void StencilVolumes::CheckMesh(const std::string& what, vtkPolyData* mesh, double mismatchPercent)
{
  this->Renderer->RemoveAllViewProps();
  this->Renderer->RemoveAllLights();
  AddFloor(this->Renderer, 6.0);
  AddActor(this->Renderer, mesh)->SetPosition(0.0, 0.0, 1.8);
  auto sun = AddSun(this->Renderer, { 0.37, 0.29, -1.0 });
  auto lamp = AddLamp(this->Renderer, { 1.9, -1.7, 5.3 });
  this->LookFrom({ 1.0, -7.0, 4.5 }, { 0.0, 0.3, 1.0 });
  this->CheckTruth(what + ", sun", sun, mismatchPercent);
  this->CheckTruth(what + ", lamp", lamp, mismatchPercent);
}

}

//------------------------------------------------------------------------------
// Scenes, lights and views by lot.
TEST_F(StencilVolumes, ScenesLightsAndViewsByLot)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->CheckLightsByLot("still life", AddStillLife(this->Renderer), { 0.1, 0.2, 0.7 }, 1);
  this->Renderer->RemoveAllViewProps();
  // In a corner of the mesh's bounds, outside of the mesh.
  this->CheckLightsByLot("bumpy mesh", AddBumpyMesh(this->Renderer), { 0.8, -0.8, 1.9 }, 2);
  this->Renderer->RemoveAllViewProps();
  this->CheckLightsByLot(
    "tubes and glyphs", AddTubesAndGlyphs(this->Renderer), { 0.1, 0.1, 1.3 }, 3);
  this->CheckMeanMismatch(0.005);
}

//------------------------------------------------------------------------------
// Meshes that are wrong in every way there is.
TEST_F(StencilVolumes, MadeMeshes)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  for (const TestMesh& mesh : SmallMeshes())
  {
    this->CheckMesh(mesh.name, ToPolyData(mesh));
  }
  TestMesh triangle{ "one triangle", { { -1, -1, 0 }, { 1, -0.6, 0.3 }, { 0, 1, -0.2 } },
    { { 0, 1, 2 } } };
  this->CheckMesh(triangle.name, ToPolyData(triangle));
  TestMesh turned = Torus(24, 16);
  for (std::size_t i = 0; i < turned.triangles.size(); i += 3)
  {
    std::swap(turned.triangles[i].y, turned.triangles[i].z);
  }
  this->CheckMesh("torus, every third turned", ToPolyData(turned));
  TestMesh twice = Torus(24, 16);
  Append(twice, turned);
  this->CheckMesh("torus twice, once with turned", ToPolyData(twice));
  this->CheckMeanMismatch(0.005);
}

// Where a long edge meets two short ones, a pixel may fall through, as light does between surfaces
// that only nearly touch.
TEST_F(StencilVolumes, TJunctions)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  TestMesh mesh{ "T-junctions", {}, {} };
  const int strips = 12;
  for (int s = 0; s < strips; ++s)
  {
    // Strip s is cut into s + 1 quads.
    for (int q = 0; q <= s; ++q)
    {
      const auto base = static_cast<unsigned int>(mesh.points.size());
      for (int i = 0; i < 4; ++i)
      {
        const double x = 3.0 * (q + (i & 1)) / (s + 1) - 1.5,
                     y = 3.0 * (s + (i >> 1)) / strips - 1.5;
        mesh.points.emplace_back(x, y, 0.2 * std::sin(0.7 * y));
      }
      mesh.triangles.emplace_back(base, base + 1, base + 3);
      mesh.triangles.emplace_back(base, base + 3, base + 2);
    }
  }
  this->CheckMesh(mesh.name, ToPolyData(mesh));
}

//------------------------------------------------------------------------------
// Eyes.
TEST_F(StencilVolumes, EyeInAShadow)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddStillLife(this->Renderer);
  AddBox(this->Renderer, { -3.0, -9.0, 4.0 }, { 3.0, -3.0, 4.2 });
  auto sun = AddSun(this->Renderer, { 0.1, 0.15, -1.0 });
  auto lamp = AddLamp(this->Renderer, { 0.2, -6.0, 9.0 });
  this->LookFrom({ 0.2, -5.5, 1.5 }, { 0.0, 0.0, 0.5 });
  this->CheckTruth("under a roof, sun", sun);
  this->CheckTruth("under a roof, lamp", lamp);
  EXPECT_GT(this->Volumes()->GetNumberOfZFailCasters(), 0) << "the roof's must be counted behind";
  this->CheckMeanMismatch(0.005);
}

TEST_F(StencilVolumes, EyeInACaster)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddFloor(this->Renderer, 6.0);
  // Out of an open tube, on a ball and the floor.
  vtkNew<vtkCylinderSource> tube;
  tube->CappingOff();
  tube->SetResolution(60);
  tube->SetHeight(2.0);
  tube->SetRadius(0.8);
  tube->SetCenter(0.0, -3.0, 1.2);
  AddActor(this->Renderer, tube);
  AddSphere(this->Renderer, { 0.2, 0.5, 0.8 }, 0.6);
  auto sun = AddSun(this->Renderer, { 0.4, 0.6, -1.0 });
  auto lamp = AddLamp(this->Renderer, { -2.0, -4.5, 5.0 });
  this->LookFrom({ 0.1, -3.4, 1.2 }, { 0.0, 0.5, 0.6 });
  this->CheckTruth("in a tube, sun", sun);
  this->CheckTruth("in a tube, lamp", lamp);
  // Within a closed ball all is dark.
  AddSphere(this->Renderer, { 0.1, -3.4, 1.2 }, 0.3);
  this->Renderer->ResetCameraClippingRange();
  this->Renderer->GetActiveCamera()->SetClippingRange(0.01, 30.0);
  this->CheckTruth("in a ball, sun", sun);
  this->CheckTruth("in a ball, lamp", lamp);
}

TEST_F(StencilVolumes, NearPlaneCutsACaster)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Subject subject = AddStillLife(this->Renderer);
  auto sun = AddSun(this->Renderer, -Toward(-60.0, 40.0));
  auto lamp = AddLamp(this->Renderer, { -2.5, -3.0, 4.0 });
  AimCamera(this->Renderer, subject, -30.0, 25.0, 320, 240);
  const double distance = this->Renderer->GetActiveCamera()->GetDistance();
  for (const double share : { 0.8, 0.9, 1.0 })
  {
    this->Renderer->GetActiveCamera()->SetClippingRange(share * distance, 3.0 * distance);
    this->CheckTruth("cut at " + std::to_string(share) + ", sun", sun);
    this->CheckTruth("cut at " + std::to_string(share) + ", lamp", lamp);
  }
}

// Anywhere among the things, with any near plane, by any projection and every setting.
TEST_F(StencilVolumes, EyesAmidTheThingsByLot)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddStillLife(this->Renderer);
  AddActor(this->Renderer, ToPolyData(KleinBottle()))->SetPosition(0.3, 0.2, 2.6);
  const std::pair<std::string, std::function<void()>> settings[] = {
    { "default", []() {} },
    { "confinement off", [&]() { this->Volumes()->ConfinementOff(); } },
    { "infinite projection",
      [&]()
      {
        this->Volumes()->ConfinementOn();
        this->Volumes()->InfiniteProjectionOn();
      } },
    { "z-fail",
      [&]()
      {
        this->Volumes()->InfiniteProjectionOff();
        this->Volumes()->SetVariant(vtkStencilShadowVolumePass::Z_FAIL);
      } },
  };
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  double shadow = 0.0;
  for (const auto& setting : settings)
  {
    setting.second();
    Lot lot(4);
    const int views = 40;
    for (int view = 0; view < views; ++view)
    {
      this->Renderer->RemoveAllLights();
      const glm::dvec3 place(lot.Any(-2.5, 2.5), lot.Any(-2.5, 2.5), lot.Any(0.1, 3.5));
      auto light = view % 2
        ? AddLamp(this->Renderer, place)
        : AddSun(this->Renderer, -Toward(lot.Any(0.0, 360.0), lot.Any(15.0, 80.0)));
      const glm::dvec3 eye(lot.Any(-2.5, 2.5), lot.Any(-2.5, 2.5), lot.Any(0.2, 3.0));
      this->LookFrom(eye, { lot.Any(-1.5, 1.5), lot.Any(-1.5, 1.5), lot.Any(0.0, 1.5) });
      camera->SetParallelProjection(view % 3 == 2);
      camera->SetParallelScale(lot.Any(0.5, 3.0));
      camera->SetViewAngle(lot.Any(20.0, 110.0));
      camera->SetClippingRange(lot.Any(0.01, 1.5), 30.0);
      shadow += this->CheckTruthIfAny(setting.first + ", view " + std::to_string(view), light);
    }
  }
  CheckAtLeast("pixels in shadow, of all views", shadow, 1.0e6);
  this->CheckMeanMismatch(0.005);
}

TEST_F(StencilVolumes, WideAngles)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddStillLife(this->Renderer);
  auto sun = AddSun(this->Renderer, -Toward(40.0, 35.0));
  auto lamp = AddLamp(this->Renderer, { 0.2, 0.1, 0.9 });
  for (const double angle : { 1.0, 100.0, 150.0, 170.0 })
  {
    this->Renderer->GetActiveCamera()->SetViewAngle(angle);
    const double distance = std::min(120.0, 2.6 / std::tan(glm::radians(0.5 * angle)) + 0.9);
    this->LookFrom(distance * Toward(-20.0, 35.0) + glm::dvec3(0, 0, 0.6), { 0.0, 0.0, 0.6 });
    this->CheckTruth(std::to_string(angle) + " degrees, sun", sun);
    this->CheckTruth(std::to_string(angle) + " degrees, lamp", lamp);
  }
}

TEST_F(StencilVolumes, ParallelEyes)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Subject subject = AddStillLife(this->Renderer);
  AddBox(this->Renderer, { -4.0, 2.6, 0.0 }, { 4.0, 2.8, 3.0 });
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(3.2);
  AimCamera(this->Renderer, subject, -25.0, 35.0, 320, 240);
  auto sun = AddSun(this->Renderer, -Toward(50.0, 40.0));
  this->CheckTruth("sun", sun);
  // No plane ends its shadows: they reach to infinity, and so does the eye's way.
  auto amid = AddLamp(this->Renderer, { 0.1, 0.1, 0.7 });
  this->CheckTruth("lamp amid casters", amid);
  amid->SetPosition(-1.1, -0.9, 0.9);
  this->CheckTruth("lamp in the ball", amid);
  amid->SetPosition(3.0, -2.0, 5.0);
  this->CheckTruth("lamp outside", amid);
  // The light shines along the view: every shadow hides behind its caster. One sees it across
  // concave corners at most, so that no truth is shadow.
  const glm::dvec3 view = Toward(-25.0, 35.0);
  sun->SetPosition(view.x, view.y, view.z);
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  this->Render();
  vtkNew<vtkShadowErrorMeasure> error;
  ASSERT_TRUE(error->Measure(this->Renderer, sun));
  CheckAtMost("sun along the view: mismatch %", error->GetMismatchPercent(), 0.1);
  CheckAtMost("sun along the view: gross", static_cast<double>(error->GetGrossPixels()), 5.0);
  // Against the view, low over what it sees.
  sun->SetPosition(-0.95 * view.x, -0.95 * view.y, 0.1);
  this->CheckTruth("sun nearly ahead", sun);
}

// The one direction in which a shadow without end meets a parallel eye.
TEST_F(StencilVolumes, ParallelEyeThatLooksAtTheSun)
{
  AddStillLife(this->Renderer);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(3.2);
  this->LookFrom({ 0.0, -8.0, 0.8 }, { 0.0, 0.0, 0.8 });
  auto sun = AddSun(this->Renderer, { 0.0, -1.0, 0.0 });
  for (const bool confined : { true, false })
  {
    this->Volumes()->SetConfinement(confined);
    this->Render();
    EXPECT_GT(this->VisibilityOf(sun).CountShadowed(), 0u) << "what it sees turns from the sun";
    EXPECT_GT(this->Volumes()->GetNumberOfZFailCasters(), 0);
  }
}

//------------------------------------------------------------------------------
// Lights.
TEST_F(StencilVolumes, LightInACaster)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddFloor(this->Renderer, 6.0);
  AddSphere(this->Renderer, { 0.0, 0.0, 1.2 }, 0.5);
  AddBox(this->Renderer, { 1.4, -0.4, 0.0 }, { 2.0, 0.4, 1.5 });
  vtkNew<vtkConeSource> cup; // open below
  cup->CappingOff();
  cup->SetResolution(40);
  cup->SetHeight(1.2);
  cup->SetRadius(0.7);
  cup->SetDirection(0.0, 0.0, 1.0);
  auto shade = AddActor(this->Renderer, cup);
  shade->SetPosition(-2.0, 0.0, 2.2);
  this->LookFrom({ 0.5, -7.0, 4.0 }, { 0.0, 0.0, 0.6 });
  auto lamp = AddLamp(this->Renderer, { 0.1, 0.05, 1.3 });
  this->CheckTruth("in a ball: all is dark", lamp);
  lamp->SetPosition(-2.0, 0.0, 1.9);
  this->CheckTruth("in a lampshade", lamp);
}

TEST_F(StencilVolumes, LightInAClosedRoom)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddBox(this->Renderer, { -3.0, -3.0, 0.0 }, { 3.0, 3.0, 3.0 });
  AddSphere(this->Renderer, { -1.0, 0.6, 0.7 }, 0.6);
  AddBox(this->Renderer, { 0.6, 0.2, 0.0 }, { 1.4, 1.0, 1.6 });
  auto lamp = AddLamp(this->Renderer, { 0.1, -0.4, 2.3 });
  this->LookFrom({ 0.5, -2.6, 1.8 }, { 0.0, 1.0, 0.8 });
  this->CheckTruth("perspective", lamp);
  lamp->SetPosition(0.0, 0.4, 0.6);
  this->CheckTruth("perspective, amid the things", lamp);
  // Looked at from outside, through a wall that is cut away by the near plane.
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(2.2);
  this->LookFrom({ 0.0, -9.0, 3.0 }, { 0.0, 0.0, 1.4 });
  camera->SetClippingRange(6.6, 20.0);
  this->CheckTruth("parallel, cut open", lamp);
}

TEST_F(StencilVolumes, SpotShinesOnNothingOutsideItsCone)
{
  AddStillLife(this->Renderer);
  const glm::dvec3 place(0.0, 0.0, 6.0);
  AddSpot(this->Renderer, place, { 0.0, 0.0, 0.0 }, 14.0);
  this->LookFrom({ 0.0, -8.0, 6.0 }, { 0.0, 0.0, 0.3 });
  const Frame frame = this->Render(), plain = this->RenderWithoutPass();
  CheckAtLeast("pixels in shadow within the cone",
    static_cast<double>(CountDifferent(frame, plain, 30)), 100.0);
  int outside = 0, unlike = 0;
  for (double x = -3.0; x <= 3.0; x += 0.1)
  {
    for (double y = -3.0; y <= 3.0; y += 0.1)
    {
      const Pixel p = PixelOf(this->Renderer, { x, y, 0.0 });
      const bool isOutside = std::hypot(x, y) > 6.0 * std::tan(glm::radians(14.5));
      if (isOutside && p.x >= 0 && p.y >= 0 && p.x < frame.width && p.y < frame.height)
      {
        ++outside;
        unlike += frame.Brightness(p.x, p.y) != plain.Brightness(p.x, p.y) ? 1 : 0;
      }
    }
  }
  CheckAtLeast("places outside of the cone", outside, 500.0);
  Check("of those, unlike the unshadowed frame", unlike, 0.0);
}

// Sixteen lights in a ring, in turn by each technique, each of its own colour.
TEST_F(StencilVolumes, SixteenLightsOfThreeTechniques)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Subject subject = AddStillLife(this->Renderer);
  AimCamera(this->Renderer, subject, -15.0, 28.0, 320, 240);
  const std::string techniques[] = { "stencil-volume", "depth-map", "ray-cast" };
  std::vector<vtkSmartPointer<vtkLight>> lights;
  for (int i = 0; i < 16; ++i)
  {
    const glm::dvec3 toward = Toward(22.5 * i, 35.0 + 2.0 * i);
    auto light = i % 2 == 0 ? AddSun(this->Renderer, -toward)
                            : AddSpot(this->Renderer, 8.0 * toward, { 0.0, 0.0, 0.5 }, 40.0);
    light->SetIntensity(0.15);
    light->SetColor(0.5 + 0.5 * std::sin(1.0 * i), 0.6, 0.5 + 0.5 * std::cos(2.0 * i));
    this->Shadows->SetLightTechnique(light, techniques[i % 3]);
    lights.push_back(light);
  }
  const Frame mixed = this->Render();
  for (int i = 0; i < 16; ++i)
  {
    // A depth map's own bound is in its own suite; here, that it is the right light's.
    this->CheckTruth("light " + std::to_string(i) + ", " + techniques[i % 3], lights[i],
      techniques[i % 3] == "depth-map" ? 0.1 : 0.05);
  }
  // All at once: every change of techniques has the shaders compiled anew.
  for (const auto& light : lights)
  {
    this->Shadows->SetLightTechnique(light, "ray-cast");
  }
  CheckAtMost("pixels unlike 16 ray casts by more than 12",
    static_cast<double>(CountDifferent(mixed, this->Render(), 12)), 150.0);
}

TEST_F(StencilVolumes, ColoursAndStrength)
{
  AddFloor(this->Renderer, 5.0);
  AddBox(this->Renderer, { -0.6, -0.6, 1.0 }, { 0.6, 0.6, 1.2 });
  auto red = AddSun(this->Renderer, { 1.0, 0.0, -1.0 });
  auto blue = AddSun(this->Renderer, { -1.0, 0.0, -1.0 });
  red->SetColor(0.8, 0.0, 0.0);
  blue->SetColor(0.0, 0.0, 0.8);
  this->LookFrom({ 0.0, -6.0, 6.0 }, { 0.0, 0.0, 0.0 });
  const Frame plain = this->RenderWithoutPass();
  // The box's middle, 1.1 above the floor, is thrown 1.1 to the side.
  const Pixel ofRed = PixelOf(this->Renderer, { 1.1, 0.0, 0.0 });
  const Pixel ofBlue = PixelOf(this->Renderer, { -1.1, 0.0, 0.0 });
  const auto part = [](const Frame& frame, const Pixel& p, int component)
  { return double(frame.rgb[3 * (std::size_t(p.y) * frame.width + p.x) + component]); };
  for (const double strength : { 1.0, 0.5, 0.0 })
  {
    this->Shadows->SetLightStrength(red, strength);
    const Frame frame = this->Render();
    const std::string what = "strength " + std::to_string(strength) + ", ";
    Check(what + "red in red's shadow", part(frame, ofRed, 0),
      (1.0 - strength) * part(plain, ofRed, 0), 1.0);
    Check(what + "blue in red's shadow", part(frame, ofRed, 2), part(plain, ofRed, 2));
    Check(what + "red in blue's shadow", part(frame, ofBlue, 0), part(plain, ofBlue, 0));
    Check(what + "blue in blue's shadow", part(frame, ofBlue, 2), 0.0);
  }
}

//------------------------------------------------------------------------------
// Windows.
TEST_F(StencilVolumes, MaskStartsAtItsViewport)
{
  const Subject subject = AddStillLife(this->Renderer);
  auto sun = AddSun(this->Renderer, -Toward(50.0, 40.0));
  AimCamera(this->Renderer, subject, -15.0, 28.0, 320, 240);
  this->Render();
  const Visibility alone = this->VisibilityOf(sun);
  EXPECT_GT(alone.CountShadowed(), 1000u);

  // The same in a quarter of a larger window, and another scene and pass beside it.
  this->Resize(640, 480);
  this->Renderer->SetViewport(0.5, 0.5, 1.0, 1.0);
  vtkNew<vtkRenderer> beside;
  beside->SetViewport(0.0, 0.0, 0.5, 1.0);
  AddFloor(beside, 4.0);
  AddSphere(beside, { 0.0, 0.0, 1.5 }, 1.0);
  auto lamp = AddLamp(beside, { 0.5, -0.5, 6.0 });
  LookAt(beside, { 0.0, -8.0, 5.0 }, { 0.0, 0.0, 0.5 });
  vtkNew<vtkShadowPass> pass;
  pass->SetTechnique("stencil-volume");
  beside->SetPass(pass);
  this->Window->AddRenderer(beside);
  const Frame both = this->Render();
  const Visibility quarter = this->VisibilityOf(sun);
  Check("pixels unlike those of a window of its own",
    static_cast<double>(CountDifferent(alone, quarter)), 0.0);
  // And the picture has them where the mask is.
  const Frame plain = this->RenderWithoutPass();
  int shaded = 0, darker = 0;
  for (int y = 0; y < 240; ++y)
  {
    for (int x = 0; x < 320; ++x)
    {
      const bool isDarker = both.Brightness(320 + x, 240 + y) < plain.Brightness(320 + x, 240 + y);
      shaded += isDarker ? 1 : 0;
      darker += isDarker && quarter.At(x, y) < 0.5f ? 1 : 0;
    }
  }
  CheckAtLeast("pixels darkened", shaded, 1000.0);
  Check("of those, in shadow by the mask", darker, shaded);
  beside->SetPass(nullptr);
}

TEST_F(StencilVolumes, OddWindows)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Subject subject = AddStillLife(this->Renderer);
  auto sun = AddSun(this->Renderer, -Toward(50.0, 40.0));
  const int sizes[][2] = { { 1, 1 }, { 1, 400 }, { 400, 1 }, { 37, 211 } };
  for (const auto& size : sizes)
  {
    this->Resize(size[0], size[1]);
    AimCamera(this->Renderer, subject, -15.0, 28.0, 320, 240);
    const Visibility byRay = this->VisibilityBy("ray-cast", sun);
    const Visibility byVolume = this->VisibilityBy("stencil-volume", sun);
    const std::string what = std::to_string(size[0]) + " x " + std::to_string(size[1]);
    Check(what + ": pixels", double(byVolume.values.size()), double(size[0]) * size[1]);
    // What turns from the light is not measured elsewhere either: it is dark whatever is said.
    CheckAtMost(what + ": pixels unlike ray cast's",
      static_cast<double>(CountDifferent(byRay, byVolume)), 0.01 * size[0] * size[1]);
  }
}

//------------------------------------------------------------------------------
// A light with a radius is the mean over its samples. Against 256 rays a pixel it was off by
// 0.0031, 0.0014 and 0.0009.
TEST_F(StencilVolumes, AreaLights)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Subject subject = AddStillLife(this->Renderer);
  auto lamp = AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 40.0);
  this->Shadows->SetLightRadius(lamp, 0.6);
  this->Shadows->GetRayCastShadowPass()->SetLightSamples(256);
  AimCamera(this->Renderer, subject, -15.0, 28.0, 320, 240);
  const std::pair<int, double> bounds[] = { { 12, 0.004 }, { 32, 0.002 }, { 64, 0.0012 } };
  double before = 1.0;
  for (const auto& bound : bounds)
  {
    this->Volumes()->SetLightSamples(bound.first);
    this->Render();
    vtkNew<vtkShadowErrorMeasure> error;
    ASSERT_TRUE(error->Measure(this->Renderer, lamp));
    CheckAtMost(std::to_string(bound.first) + " samples: mean absolute difference",
      error->GetMeanAbsoluteDifference(), bound.second);
    CheckAtMost("less than with fewer", error->GetMeanAbsoluteDifference(), before);
    before = error->GetMeanAbsoluteDifference();
  }
}
