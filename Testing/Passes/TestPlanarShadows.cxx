// Planar shadows: on their plane held against the truth, wherever plane, light and eye are; and
// what takes none.
#include "ShadowTest.h"
#include "TestScenes.h"

#include "vtkPlanarShadowPass.h"
#include "vtkShadowErrorMeasure.h"

#include <vtkAssembly.h>
#include <vtkCompositePolyDataMapper.h>
#include <vtkConeSource.h>
#include <vtkDiskSource.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

using namespace shadowtest;

namespace
{

// The issue's own figures for a hard shadow on its plane.
constexpr double MostMismatchPercent = 0.05;

class PlanarShadows : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Renderer->SetPass(this->Shadows);
    this->Shadows->SetTechnique("planar");
  }
  vtkPlanarShadowPass* Planar() { return this->Shadows->GetPlanarShadowPass(); }

  // Sphere, torus, cone and box that take no shadows, over a floor that does.
  Subject AddCasters()
  {
    const Subject subject = AddStillLife(this->Renderer);
    this->EachProp([](vtkProp* prop) { vtkShadowPass::SetReceivesShadows(prop, false); });
    vtkProp* floor = this->FlatProp();
    vtkShadowPass::SetReceivesShadows(floor, true);
    return subject;
  }

  template <typename Use>
  void EachProp(const Use& use)
  {
    vtkCollectionSimpleIterator it;
    this->Renderer->GetViewProps()->InitTraversal(it);
    while (vtkProp* prop = this->Renderer->GetViewProps()->GetNextProp(it))
    {
      use(prop);
    }
  }

  vtkProp* FlatProp()
  {
    vtkProp* flat = nullptr;
    this->EachProp(
      [&flat](vtkProp* prop)
      {
        const double* b = prop->GetBounds();
        flat = b[4] == b[5] ? prop : flat;
      });
    return flat;
  }

  void CheckHard(const std::string& what, vtkLight* light)
  {
    this->Render();
    this->CheckMeasure(what, light, MostMismatchPercent, 0.0);
  }

  // Against the ray cast itself, also where light grazes so that no error is measured.
  void CheckLikeRayCast(const std::string& what, vtkLight* light, double mostPixels)
  {
    const Visibility truth = this->VisibilityBy("ray-cast", light);
    const Visibility mask = this->VisibilityBy("planar", light);
    CheckAtMost(what + ": pixels unlike the ray cast's, of " +
        std::to_string(truth.CountShadowed()) + " in shadow",
      static_cast<double>(CountDifferent(mask, truth)), mostPixels);
  }
};

}

//------------------------------------------------------------------------------
// Lights.
TEST_F(PlanarShadows, FromOverheadToGrazing)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  Subject subject = this->AddCasters();
  AimCamera(this->Renderer, subject, -20.0, 35.0, 400, 300);
  for (const double angle : { 0.0, 25.0, 50.0, 70.0, 80.0, 85.0, 88.0 })
  {
    auto sun = AddSun(this->Renderer, -Toward(50.0, 90.0 - angle));
    this->CheckHard("sun " + std::to_string(angle) + " degrees from the normal", sun);
    this->Renderer->RemoveLight(sun);
  }
  for (const double angle : { 88.0, 89.0, 89.9 })
  {
    auto sun = AddSun(this->Renderer, -Toward(50.0, 90.0 - angle));
    this->CheckLikeRayCast("sun " + std::to_string(angle) + " degrees from the normal", sun, 20.0);
    this->Renderer->RemoveLight(sun);
  }
  for (const double height : { 0.3, 1.0, 2.0, 6.0, 60.0 })
  {
    auto lamp = AddLamp(this->Renderer, { 2.1, 1.4, height });
    this->CheckHard("lamp " + std::to_string(height) + " above", lamp);
    this->Renderer->RemoveLight(lamp);
  }
  auto spot = AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 25.0);
  this->CheckHard("spot", spot);
}

// Lamps where a matrix has no inverse, or nothing casts.
TEST_F(PlanarShadows, LightsInOddPlaces)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddFloor(this->Renderer, 4.0);
  auto box = AddBox(this->Renderer, { -0.5, -0.5, 0.0 }, { 0.5, 0.5, 1.0 });
  vtkShadowPass::SetReceivesShadows(box, false);
  LookAt(this->Renderer, { 3.0, -7.0, 5.0 }, { 0.0, 0.0, 0.3 });
  const struct
  {
    const char* name;
    glm::dvec3 place;
    double mostShadowed;
  } lamps[] = { { "in the plane", { 2.0, 1.0, 0.0 }, 0.0 },
    { "beneath the plane", { 0.3, 0.2, -2.0 }, 0.0 } };
  for (const auto& lamp : lamps)
  {
    auto light = AddLamp(this->Renderer, lamp.place);
    this->Render();
    CheckAtMost(std::string("pixels in shadow, lamp ") + lamp.name,
      static_cast<double>(this->VisibilityOf(light).CountShadowed()), lamp.mostShadowed);
    this->Renderer->RemoveLight(light);
  }
  // The truth is not defined on a vertex; a hair outside and a hair inside of it it is.
  for (const double hair : { 1.0e-5, -1.0e-5 })
  {
    const glm::dvec3 corner(-0.5 - hair, -0.5 - hair, 1.0 + hair);
    auto light = AddLamp(this->Renderer, corner);
    this->CheckHard("lamp at a vertex, off by " + std::to_string(hair), light);
    this->Renderer->RemoveLight(light);
  }
  auto onVertex = AddLamp(this->Renderer, { -0.5, -0.5, 1.0 });
  this->Render();
  const Visibility exact = this->VisibilityOf(onVertex);
  onVertex->SetPosition(-0.5 - 1.0e-5, -0.5 - 1.0e-5, 1.0 + 1.0e-5);
  this->Render();
  CheckAtMost("pixels unlike those a hair outside",
    static_cast<double>(CountDifferent(exact, this->VisibilityOf(onVertex))), 20.0);
}

TEST_F(PlanarShadows, CasterThroughThePlaneAndAboveTheLight)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddFloor(this->Renderer, 6.0);
  auto ball = AddSphere(this->Renderer, { -1.0, 0.3, 0.2 }, 0.8);
  auto tower = AddBox(this->Renderer, { 0.8, 0.2, -1.0 }, { 1.2, 0.8, 5.0 });
  auto beneath = AddSphere(this->Renderer, { 1.0, -1.0, -0.6 }, 0.5);
  for (vtkActor* actor : { ball.Get(), tower.Get(), beneath.Get() })
  {
    vtkShadowPass::SetReceivesShadows(actor, false);
  }
  LookAt(this->Renderer, { 4.0, -9.0, 6.0 }, { 0.0, 0.0, 0.3 });
  this->CheckHard("lamp lower than a caster", AddLamp(this->Renderer, { 2.5, 2.0, 2.0 }));
  this->CheckHard("sun", AddSun(this->Renderer, { -0.6, 0.4, -0.5 }));
  // Through the eye's own place, and behind it.
  auto behind = AddSphere(this->Renderer, { 4.3, -9.6, 6.0 }, 0.5);
  vtkShadowPass::SetReceivesShadows(behind, false);
  this->CheckHard("caster behind the eye", AddLamp(this->Renderer, { 5.0, -11.0, 7.0 }));
}

//------------------------------------------------------------------------------
// Planes.
TEST_F(PlanarShadows, TiltedFarAndScaled)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const struct
  {
    const char* name;
    double offset, scale, turn;
  } placements[] = { { "tilted", 0.0, 1.0, 63.0 }, { "1e6 away", 1.0e6, 1.0, 0.0 },
    { "1e6 away and tilted", 1.0e6, 1.0, 117.0 }, { "3e3 away and tilted", 3.0e3, 1.0, 31.0 },
    { "scale 1e-9", 0.0, 1.0e-9, 20.0 }, { "scale 1e9", 0.0, 1.0e9, 20.0 } };
  for (const auto& placement : placements)
  {
    for (const bool byActor : { true, false })
    {
      this->Renderer->RemoveAllViewProps();
      this->Renderer->RemoveAllLights();
      Subject subject = this->AddCasters();
      vtkNew<vtkTransform> worldFromScene;
      worldFromScene->Translate(placement.offset, -0.7 * placement.offset, placement.offset);
      worldFromScene->Scale(placement.scale, placement.scale, placement.scale);
      worldFromScene->RotateWXYZ(placement.turn, 0.3, 0.8, -0.5);
      PlaceActors(this->Renderer, worldFromScene, byActor);
      const auto place = [&worldFromScene](const glm::dvec3& p)
      {
        const double* q = worldFromScene->TransformDoublePoint(p.x, p.y, p.z);
        return glm::dvec3(q[0], q[1], q[2]);
      };
      auto spot =
        AddSpot(this->Renderer, place({ 3.5, -3.0, 6.5 }), place({ 0.0, 0.0, 0.3 }), 40.0);
      LookAt(this->Renderer, place({ -2.5, -8.0, 6.0 }), place(subject.centre));
      const glm::dvec3 up = place({ 0.0, 0.0, 1.0 }) - place({ 0.0, 0.0, 0.0 });
      this->Renderer->GetActiveCamera()->SetViewUp(up.x, up.y, up.z);
      this->Renderer->ResetCameraClippingRange();
      const std::string what =
        std::string(placement.name) + (byActor ? ", by actor" : ", by points");
      this->CheckHard(what + ", spot", spot);
      auto sun = AddSun(this->Renderer, place({ -0.4, 0.5, -1.0 }) - place({ 0.0, 0.0, 0.0 }));
      this->CheckHard(what + ", sun", sun);
    }
  }
}

TEST_F(PlanarShadows, EyesAndWindows)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Subject subject = this->AddCasters();
  auto lamp = AddLamp(this->Renderer, { 2.5, -3.0, 5.0 });
  for (const bool parallel : { false, true })
  {
    this->Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    for (const auto& size : { std::make_pair(1, 1), { 1, 700 }, { 900, 2 }, { 333, 500 } })
    {
      this->Resize(size.first, size.second);
      AimCamera(this->Renderer, subject, 40.0, 30.0, size.first, size.second);
      this->CheckLikeRayCast(std::to_string(size.first) + " x " + std::to_string(size.second) +
          (parallel ? ", parallel" : ", perspective"),
        lamp, 60.0);
    }
    this->Resize(400, 300);
    // Low over the floor, in it, and beneath it.
    for (const double height : { 0.05, 1.0e-5, 0.0 })
    {
      LookAt(this->Renderer, { 4.0, -6.0, height }, { 0.0, 0.0, height });
      this->CheckLikeRayCast("eye at height " + std::to_string(height), lamp, 60.0);
    }
    // From beneath no light is seen on it.
    LookAt(this->Renderer, { 4.0, -6.0, -2.0 }, { 0.0, 0.0, 0.0 });
    this->Render();
    CheckAtMost("eye beneath: pixels in shadow",
      static_cast<double>(this->VisibilityOf(lamp).CountShadowed()), 0.0);
  }
}

// Each receiver its own plane: a floor, two walls, a table, and boxes that receive on their sides.
TEST_F(PlanarShadows, SeveralPlanes)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddFloor(this->Renderer, 3.0);
  for (const bool isLeft : { true, false })
  {
    vtkNew<vtkPlaneSource> wall;
    wall->SetOrigin(-3.0, 3.0, 0.0);
    wall->SetPoint1(isLeft ? -3.0 : 3.0, isLeft ? -3.0 : 3.0, 0.0);
    wall->SetPoint2(-3.0, 3.0, 4.0);
    AddActor(this->Renderer, wall);
  }
  AddBox(this->Renderer, { -2.0, -0.5, 0.0 }, { 0.0, 1.5, 0.8 });
  auto turned = AddBox(this->Renderer, { -0.4, -0.4, -0.3 }, { 0.4, 0.4, 0.3 });
  turned->SetPosition(1.2, 0.2, 0.8);
  turned->SetOrientation(20.0, 35.0, 50.0);
  auto ball = AddSphere(this->Renderer, { -0.8, 0.6, 1.6 }, 0.4);
  vtkShadowPass::SetReceivesShadows(ball, false);
  LookAt(this->Renderer, { 7.0, -8.0, 6.0 }, { 0.0, 0.5, 1.0 });
  auto sun = AddSun(this->Renderer, { -0.7, 0.8, -0.9 });
  this->CheckHard("sun", sun);
  this->CheckHard("lamp", AddLamp(this->Renderer, { 2.0, -2.0, 3.5 }));
  CheckAtLeast("planes", this->Planar()->GetNumberOfPlanes(), 10.0);
  // With textures the same, to their texels.
  this->Planar()->PlaneTexturesOn();
  this->Render();
  vtkNew<vtkShadowErrorMeasure> error;
  ASSERT_TRUE(error->Measure(this->Renderer, sun));
  CheckAtMost("by textures: mismatch %", error->GetMismatchPercent(), 0.2);
  CheckAtMost("by textures: gross %", error->GetGrossPercent(), 0.02);
}

TEST_F(PlanarShadows, NamedPlanes)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddBox(this->Renderer, { -3.0, -3.0, -1.0 }, { 3.0, 3.0, 0.0 });
  auto ball = AddSphere(this->Renderer, { 0.0, 0.0, 1.2 }, 0.7);
  vtkShadowPass::SetReceivesShadows(ball, false);
  LookAt(this->Renderer, { 3.0, -9.0, 6.0 }, { 0.0, 0.0, 0.0 });
  auto sun = AddSun(this->Renderer, { -0.5, 0.3, -1.0 });
  this->Planar()->AutomaticPlanesOff();
  this->Render();
  ExpectOneMessage({ "No receiver lies in a plane", "AddPlane" });
  CheckAtMost("pixels in shadow without a plane",
    static_cast<double>(this->VisibilityOf(sun).CountShadowed()), 0.0);
  EXPECT_TRUE(this->Planar()->AddPlane(0.0, 0.0, 2.0, 0.0)); // of any length
  this->CheckHard("named plane", sun);
  Check("planes", this->Planar()->GetNumberOfPlanes(), 1.0);
  double plane[4];
  EXPECT_TRUE(this->Planar()->GetPlane(0, plane));
  Check("its normal", plane[2], 1.0);
  EXPECT_FALSE(this->Planar()->GetPlane(1, plane));

  for (const auto& bad :
    { std::make_pair(0.0, 1.0), std::make_pair(std::numeric_limits<double>::quiet_NaN(), 0.0),
      std::make_pair(1.0, std::numeric_limits<double>::infinity()) })
  {
    EXPECT_FALSE(this->Planar()->AddPlane(0.0, 0.0, bad.first, bad.second));
    ExpectOneMessage({ "AddPlane(0, 0, " });
  }
  this->CheckHard("named plane, still", sun);
  this->Planar()->RemoveAllPlanes();
  this->Planar()->AutomaticPlanesOn();
  this->CheckHard("found plane", sun);
}

// Curved things over the plane never pick up its mask.
TEST_F(PlanarShadows, CurvedReceiversAreLit)
{
  AddFloor(this->Renderer, 4.0);
  AddSphere(this->Renderer, { 0.0, 0.0, 0.9 }, 0.6);
  auto upper = AddSphere(this->Renderer, { 0.7, -0.6, 2.3 }, 0.4);
  auto sun = AddSun(this->Renderer, { -0.5, 0.4, -1.0 });
  LookAt(this->Renderer, { 2.0, -8.0, 5.0 }, { 0.0, 0.0, 0.8 });
  this->Render();
  const Visibility mask = this->VisibilityOf(sun);
  EXPECT_GT(mask.CountShadowed(), 1000u);
  const Pixel inShadowOfUpper = PixelOf(this->Renderer, { 0.1, -0.25, 1.4 });
  EXPECT_EQ(mask.At(inShadowOfUpper.x, inShadowOfUpper.y), 1.0f);
  // In front of shadowed floor, too.
  upper->SetPosition(-0.4, -2.2, -1.6);
  this->Render();
  const Visibility before = this->VisibilityOf(sun);
  const Pixel front = PixelOf(this->Renderer, { 0.3, -2.8, 0.7 });
  EXPECT_EQ(before.At(front.x, front.y), 1.0f);
}

//------------------------------------------------------------------------------
// Casters.
TEST_F(PlanarShadows, EveryKindOfCaster)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddFloor(this->Renderer, 5.0);
  LookAt(this->Renderer, { 3.0, -9.0, 6.0 }, { 0.0, 0.0, 0.6 });
  auto sun = AddSun(this->Renderer, { -0.5, 0.4, -1.0 });
  auto lamp = AddLamp(this->Renderer, { 2.0, -1.5, 4.0 });
  const auto check = [&](const std::string& what, vtkProp* prop)
  {
    vtkShadowPass::SetReceivesShadows(prop, false);
    this->CheckHard(what + ", sun", sun);
    this->CheckHard(what + ", lamp", lamp);
    this->Renderer->RemoveViewProp(prop);
  };

  vtkNew<vtkConeSource> cone;
  cone->SetResolution(24);
  cone->Update();
  auto mirrored = AddActor(this->Renderer, cone);
  mirrored->SetScale(-1.3, 0.6, 1.0);
  mirrored->RotateX(30.0);
  mirrored->SetPosition(0.0, 0.0, 1.0);
  check("mirrored and scaled", mirrored);

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkActor> part, other;
  part->SetMapper(mapper);
  part->SetPosition(-0.8, 0.0, 0.3);
  other->SetMapper(mapper);
  other->SetScale(-0.5, 0.5, 0.5);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(part);
  assembly->AddPart(other);
  assembly->SetPosition(0.0, 0.0, 1.2);
  assembly->RotateX(25.0);
  this->Renderer->AddViewProp(assembly);
  check("assembly", assembly);

  vtkNew<vtkPoints> places;
  for (int i = 0; i < 30; ++i)
  {
    places->InsertNextPoint(1.6 * std::cos(2.4 * i), 1.6 * std::sin(2.1 * i), 0.8 + 0.03 * i);
  }
  vtkNew<vtkPolyData> where;
  where->SetPoints(places);
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(where);
  glyphs->SetSourceConnection(cone->GetOutputPort());
  glyphs->SetScaleFactor(0.3);
  vtkNew<vtkActor> many;
  many->SetMapper(glyphs);
  this->Renderer->AddActor(many);
  check("glyphs", many);

  vtkNew<vtkOpenGLSphereMapper> spheres;
  spheres->SetInputData(where);
  spheres->SetRadius(0.2);
  vtkNew<vtkActor> impostors;
  impostors->SetMapper(spheres);
  this->Renderer->AddActor(impostors);
  check("sphere impostors", impostors);
  // Sunk into the floor they cast with what is above it.
  impostors->SetPosition(0.0, 0.0, -0.95);
  this->Renderer->AddActor(impostors);
  check("sphere impostors through the plane", impostors);

  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(1.3, 0.9, 0.2);
  ball->Update();
  blocks->SetBlock(0, cone->GetOutput());
  blocks->SetBlock(1, ball->GetOutput());
  vtkNew<vtkCompositePolyDataMapper> composite;
  composite->SetInputDataObject(blocks);
  vtkNew<vtkActor> whole;
  whole->SetMapper(composite);
  whole->SetPosition(0.0, 0.0, 1.3);
  this->Renderer->AddActor(whole);
  check("composite", whole);
}

// Whatever the order of drawing and however often it is covered, shadow is shadow; and the ambient
// part of a colour stays.
TEST_F(PlanarShadows, NoDoubleDarkening)
{
  auto floor = AddFloor(this->Renderer, 4.0);
  floor->GetProperty()->SetAmbient(0.3);
  floor->GetProperty()->SetDiffuse(0.7);
  for (int i = 0; i < 6; ++i)
  {
    AddSphere(this->Renderer, { 0.1 * i, 0.0, 0.8 + 0.5 * i }, 0.4)->VisibilityOn();
  }
  auto sun = AddSun(this->Renderer, { 0.5, 0.0, -1.0 });
  LookAt(this->Renderer, { 0.0, -9.0, 7.0 }, { 0.0, 0.5, 0.0 });
  this->Render();
  const Visibility mask = this->VisibilityOf(sun);
  for (const float value : mask.values)
  {
    ASSERT_TRUE(value == 0.0f || value == 1.0f) << value;
  }
  const Frame frame = this->Render();
  const Pixel shaded = PixelOf(this->Renderer, { 2.15, 0.0, 0.0 });
  EXPECT_EQ(mask.At(shaded.x, shaded.y), 0.0f);
  Check("brightness in shadow, of 765", frame.Brightness(shaded.x, shaded.y), 0.3 * 765, 3.0);
  // Coincident with the floor, a mat would fight for depth if shadows were geometry.
  AddFloor(this->Renderer, 3.0);
  this->Render();
  EXPECT_LE(CountDifferent(this->VisibilityOf(sun), mask), 2u);
}

//------------------------------------------------------------------------------
// Soft light.
TEST_F(PlanarShadows, SoftAgainstTheTruth)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  Subject subject = this->AddCasters();
  AimCamera(this->Renderer, subject, -20.0, 35.0, 400, 300);
  auto lamp = AddLamp(this->Renderer, { 3.0, -2.0, 6.0 });
  auto sun = AddSun(this->Renderer, { -0.5, 0.4, -1.0 });
  this->Shadows->GetRayCastShadowPass()->SetLightSamples(256);
  for (const double radius : { 0.1, 0.5, 1.0 })
  {
    this->Shadows->SetLightRadius(lamp, radius);
    this->Shadows->SetLightRadius(sun, 0.2 * radius);
    this->Render();
    for (vtkLight* light : { lamp.Get(), sun.Get() })
    {
      vtkNew<vtkShadowErrorMeasure> error;
      ASSERT_TRUE(error->Measure(this->Renderer, light));
      CheckAtMost("mean absolute difference, radius " + std::to_string(radius),
        error->GetMeanAbsoluteDifference(), 0.01);
    }
  }
}

TEST_F(PlanarShadows, SamplesGrowWithTheLight)
{
  Subject subject = this->AddCasters();
  AimCamera(this->Renderer, subject, -20.0, 35.0, 400, 300);
  auto lamp = AddLamp(this->Renderer, { 3.0, -2.0, 6.0 });
  this->Planar()->SetLightSamples(1000);
  this->Render();
  Check("shadows of a hard light", this->Planar()->GetNumberOfThrows(), 1.0);
  double before = 1.0;
  for (const double radius : { 0.05, 0.1, 0.2, 0.4 })
  {
    this->Shadows->SetLightRadius(lamp, radius);
    this->Render();
    const double throws = static_cast<double>(this->Planar()->GetNumberOfThrows());
    CheckAtLeast("shadows at radius " + std::to_string(radius), throws, 1.7 * before);
    CheckAtMost("shadows at radius " + std::to_string(radius), throws, 1000.0);
    before = throws;
  }
  this->Planar()->SetLightSamples(30);
  this->Render();
  Check("shadows within the budget", this->Planar()->GetNumberOfThrows(), 30.0);
  // More than the stencil tells apart in one go.
  this->Planar()->SetLightSamples(600);
  this->Shadows->SetLightRadius(lamp, 3.0);
  this->Render();
  CheckAtLeast("shadows", static_cast<double>(this->Planar()->GetNumberOfThrows()), 300.0);
  const Visibility mask = this->VisibilityOf(lamp);
  for (const float value : mask.values)
  {
    ASSERT_TRUE(value >= 0.0f && value <= 1.0f) << value;
  }
}

TEST_F(PlanarShadows, OffsetPlanesSoftenAlongTheLight)
{
  Subject subject = this->AddCasters();
  AimCamera(this->Renderer, subject, -20.0, 35.0, 400, 300);
  auto sun = AddSun(this->Renderer, { -0.8, 0.4, -1.0 });
  this->Shadows->SetLightRadius(sun, 0.1);
  this->Planar()->SetSoftMethod(vtkPlanarShadowPass::OFFSET_PLANES);
  this->Render();
  const Visibility soft = this->VisibilityOf(sun);
  const auto between = [](const Visibility& mask)
  {
    return static_cast<double>(std::count_if(mask.values.begin(), mask.values.end(),
      [](float value) { return value > 0.05f && value < 0.95f; }));
  };
  CheckAtLeast("pixels in penumbra", between(soft), 500.0);
  this->Planar()->SetSoftMethod(3);
  ExpectOneMessage({ "SoftMethod 3" });
  Check("method", this->Planar()->GetSoftMethod(), vtkPlanarShadowPass::OFFSET_PLANES);
}

//------------------------------------------------------------------------------
// Textures.
TEST_F(PlanarShadows, TexturesAreDrawnWhenStale)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  Subject subject = this->AddCasters();
  AimCamera(this->Renderer, subject, -20.0, 35.0, 400, 300);
  auto lamp = AddLamp(this->Renderer, { 3.0, -2.0, 6.0 });
  this->Planar()->PlaneTexturesOn();
  this->Render();
  this->CheckMeasure("by texture", lamp, 0.1, 0.01);
  const auto builds = [this]()
  { return static_cast<double>(this->Planar()->GetNumberOfTextureBuilds()); };
  Check("builds", builds(), 1.0);
  this->Renderer->GetActiveCamera()->Azimuth(20.0);
  this->Render();
  Check("builds, camera moved", builds(), 1.0);
  Check("casters drawn", this->Planar()->GetNumberOfDrawnCasters(), 0.0);
  lamp->SetPosition(3.2, -2.0, 6.0);
  this->Render();
  Check("builds, light moved", builds(), 2.0);
  vtkActor* caster = nullptr;
  this->EachProp([&](vtkProp* prop)
    { caster = prop == this->FlatProp() ? caster : vtkActor::SafeDownCast(prop); });
  caster->AddPosition(0.0, 0.0, 0.3);
  this->Render();
  Check("builds, caster moved", builds(), 3.0);
  this->CheckMeasure("by texture, again", lamp, 0.1, 0.01);
  caster->GetProperty()->SetColor(1.0, 0.0, 0.0);
  this->Render();
  Check("builds, colour changed", builds(), 3.0);
  this->Planar()->SetTextureResolution(300);
  this->Render();
  Check("builds, resolution changed", builds(), 4.0);
  this->Planar()->SetTextureResolution(0);
  ExpectOneMessage({ "TextureResolution 0" });
  this->Planar()->SetTextureResolution(1 << 20);
  this->Render();
  ExpectOneMessage({ "TextureResolution 1048576 is above" });
  this->Planar()->PlaneTexturesOff();
  this->CheckHard("by mask", lamp);
}

// What bakes it gets it where it lies: the shadow of a disc has its area, and its middle.
TEST_F(PlanarShadows, TextureIsPlacedInTheWorld)
{
  vtkNew<vtkTransform> tilt;
  tilt->Translate(5.0, 6.0, 7.0);
  tilt->RotateWXYZ(40.0, 1.0, 2.0, 0.5);
  const auto place = [&tilt](const glm::dvec3& p)
  {
    const double* q = tilt->TransformDoublePoint(p.x, p.y, p.z);
    return glm::dvec3(q[0], q[1], q[2]);
  };
  auto floor = AddFloor(this->Renderer, 4.0);
  floor->SetUserTransform(tilt);
  vtkNew<vtkDiskSource> disc;
  disc->SetInnerRadius(0.0);
  disc->SetOuterRadius(0.5);
  disc->SetCircumferentialResolution(200);
  auto actor = AddActor(this->Renderer, disc);
  actor->SetUserTransform(tilt);
  actor->SetPosition(0.0, 0.0, 0.0);
  vtkNew<vtkTransform> raised;
  raised->SetMatrix(tilt->GetMatrix());
  raised->Translate(0.4, 0.3, 1.0);
  actor->SetUserTransform(raised);
  const glm::dvec3 lampWC = place({ 0.4, 0.3, 3.0 });
  auto lamp = AddLamp(this->Renderer, lampWC);
  LookAt(this->Renderer, place({ 2.0, -8.0, 6.0 }), place({ 0.0, 0.0, 0.0 }));
  vtkNew<vtkImageData> texture;
  this->Render();
  EXPECT_FALSE(this->Planar()->GetPlaneTexture(lamp, 0, texture));
  ExpectOneMessage({ "GetPlaneTexture", "PlaneTextures" });

  this->Planar()->PlaneTexturesOn();
  this->Render();
  ASSERT_TRUE(this->Planar()->GetPlaneTexture(lamp, 0, texture));
  int size[3];
  texture->GetDimensions(size);
  double sum = 0.0;
  glm::dvec3 middle(0.0);
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const double shadow = 1.0 - texture->GetScalarComponentAsDouble(x, y, 0, 0) / 255.0;
      double p[3];
      texture->TransformIndexToPhysicalPoint(x, y, 0, p);
      sum += shadow;
      middle += shadow * glm::dvec3(p[0], p[1], p[2]);
    }
  }
  const double area = sum * texture->GetSpacing()[0] * texture->GetSpacing()[1];
  const double expected = 3.14159265358979 * 0.75 * 0.75; // half as large again
  Check("area of a disc's shadow", area, expected, 0.002 * expected);
  Check("its middle's distance from where it should be",
    glm::length(middle / sum - place({ 0.4, 0.3, 0.0 })), 0.0, 0.002);
  EXPECT_FALSE(this->Planar()->GetPlaneTexture(lamp, 1, texture));
  TakeMessages();
}

//------------------------------------------------------------------------------
// Together with others.
TEST_F(PlanarShadows, MixesWithOtherTechniques)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  Subject subject = this->AddCasters();
  AimCamera(this->Renderer, subject, -20.0, 35.0, 400, 300);
  auto lamp = AddLamp(this->Renderer, { 3.0, -2.0, 6.0 });
  auto sun = AddSun(this->Renderer, { -0.5, 0.4, -1.0 });
  auto spot = AddSpot(this->Renderer, { -3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 25.0);
  this->Shadows->SetLightTechnique(sun, "stencil-volume");
  this->Shadows->SetLightTechnique(spot, "depth-map");
  this->CheckHard("lamp, planar", lamp);
  this->CheckHard("sun, stencil-volume", sun);
  this->CheckMeasure("spot, depth-map", spot, 0.1, 0.005);
  this->Planar()->PlaneTexturesOn();
  this->Render();
  this->CheckMeasure("lamp, planar by texture", lamp, 0.1, 0.01);
  this->CheckMeasure("spot, depth-map", spot, 0.1, 0.005);
}

// As ParaView draws every surface. What lies in one plane is one, in however many blocks.
TEST_F(PlanarShadows, FlatComposites)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddSphere(this->Renderer, { 0.0, 0.0, 1.0 }, 0.5);
  this->EachProp([](vtkProp* prop) { vtkShadowPass::SetReceivesShadows(prop, false); });
  auto sun = AddSun(this->Renderer, { -0.5, 0.4, -1.0 });
  LookAt(this->Renderer, { 1.0, -7.0, 4.0 }, { 0.0, 0.0, 0.4 });
  for (const vtkSmartPointer<vtkMapper>& mapper : CompositeMappers())
  {
    const std::string name = mapper->GetClassName();
    vtkNew<vtkMultiBlockDataSet> blocks, inner;
    for (int i = 0; i < 3; ++i)
    {
      vtkNew<vtkPlaneSource> plane;
      plane->SetOrigin(i - 2.0, -2.0, 0.0);
      plane->SetPoint1(i - 1.0, -2.0, 0.0);
      plane->SetPoint2(i - 2.0, 2.0, 0.0);
      plane->SetResolution(60, 60); // more cells than sides are looked for among
      plane->Update();
      (i < 2 ? blocks : inner)->SetBlock(static_cast<unsigned int>(i), plane->GetOutput());
    }
    blocks->SetBlock(2, inner);
    mapper->SetInputDataObject(blocks);
    vtkNew<vtkActor> floor;
    floor->SetMapper(mapper);
    this->Renderer->AddActor(floor);
    this->CheckHard(name, sun);
    CheckAtLeast(
      name + ": pixels in shadow", double(this->VisibilityOf(sun).CountShadowed()), 500.0);
    this->Renderer->RemoveActor(floor);
  }
}

TEST_F(PlanarShadows, TooManyPlanes)
{
  for (int i = 0; i < 5; ++i)
  {
    AddFloor(this->Renderer, 3.0 - 0.4 * i, 0.3 * i);
  }
  auto ball = AddSphere(this->Renderer, { 0.0, 0.0, 2.5 }, 0.4);
  auto sun = AddSun(this->Renderer, { -0.5, 0.4, -1.0 });
  LookAt(this->Renderer, { 3.0, -9.0, 6.0 }, { 0.0, 0.0, 0.6 });
  this->Render();
  const std::size_t all = this->VisibilityOf(sun).CountShadowed();
  this->Planar()->SetMaximumNumberOfPlanes(2);
  this->Render();
  ExpectOneMessage({ "3 more planes than the 2" });
  this->Render();
  EXPECT_LT(this->VisibilityOf(sun).CountShadowed(), all);
}

// What casts on nothing is not drawn.
TEST_F(PlanarShadows, CastersThatCannotReach)
{
  AddFloor(this->Renderer, 2.0);
  auto above = AddSphere(this->Renderer, { 0.0, 0.0, 1.0 }, 0.4);
  AddSphere(this->Renderer, { 0.0, 0.0, -1.0 }, 0.4); // beneath
  AddSphere(this->Renderer, { 30.0, 0.0, 1.0 }, 0.4); // beside
  auto sun = AddSun(this->Renderer, { 0.0, 0.0, -1.0 });
  LookAt(this->Renderer, { 3.0, -9.0, 6.0 }, { 0.0, 0.0, 0.6 });
  this->Render();
  Check("casters drawn", this->Planar()->GetNumberOfDrawnCasters(), 1.0);
  Check("casters left out", this->Planar()->GetNumberOfCulledCasters(), 3.0); // the floor, too
  above->VisibilityOff();
  this->Render();
  Check("shadows drawn", this->Planar()->GetNumberOfThrows(), 0.0);
  CheckAtMost(
    "pixels in shadow", static_cast<double>(this->VisibilityOf(sun).CountShadowed()), 0.0);
}

// Around the hard shadow, never in it; and with a texture the same.
TEST_F(PlanarShadows, PlateausSoftenOutwards)
{
  Subject subject = this->AddCasters();
  AimCamera(this->Renderer, subject, -20.0, 35.0, 400, 300);
  auto lamp = AddLamp(this->Renderer, { 3.0, -2.0, 6.0 });
  this->Render();
  const Visibility hard = this->VisibilityOf(lamp);
  this->Shadows->SetLightRadius(lamp, 0.4);
  this->Planar()->SetSoftMethod(vtkPlanarShadowPass::PLATEAUS);
  this->Render();
  Check("shadows drawn", static_cast<double>(this->Planar()->GetNumberOfThrows()), 1.0);
  const Visibility soft = this->VisibilityOf(lamp);
  std::size_t lighter = 0, between = 0;
  for (std::size_t i = 0; i < soft.values.size(); ++i)
  {
    lighter += soft.values[i] > hard.values[i] ? 1 : 0;
    between += soft.values[i] > 0.05f && soft.values[i] < 0.95f ? 1 : 0;
  }
  Check("pixels of the hard shadow that are lighter", static_cast<double>(lighter), 0.0);
  CheckAtLeast("pixels in penumbra", static_cast<double>(between), 500.0);
  this->Planar()->PlaneTexturesOn();
  this->Render();
  const Visibility textured = this->VisibilityOf(lamp);
  double difference = 0.0;
  for (std::size_t i = 0; i < soft.values.size(); ++i)
  {
    difference += std::abs(soft.values[i] - textured.values[i]);
  }
  CheckAtMost("mean difference by texture", difference / soft.values.size(), 0.002);
  // Another radius is another texture.
  const auto builds = this->Planar()->GetNumberOfTextureBuilds();
  this->Shadows->SetLightRadius(lamp, 0.5);
  this->Render();
  Check("builds", static_cast<double>(this->Planar()->GetNumberOfTextureBuilds() - builds), 1.0);
}

// What VTK does to set lines off from polygons in a picture moves no shadow, on one plane or where
// receivers of several hide each other. Polygons with visible edges it draws half an edge larger,
// and with that every position on them is off by a part of a pixel, and its truth: those bounds are
// what was measured, not an aim.
TEST_F(PlanarShadows, EdgesAndPolygonOffsets)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  Subject subject = this->AddCasters();
  AimCamera(this->Renderer, subject, -20.0, 35.0, 400, 300);
  auto spot = AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 40.0);
  for (const bool isTwo : { false, true })
  {
    if (isTwo)
    {
      AddBox(this->Renderer, { -0.4, -2.6, 0.0 }, { 0.6, -1.8, 0.2 });
    }
    const std::string planes = isTwo ? ", several planes" : ", one plane";
    this->CheckHard("plain" + planes, spot);
    vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
    this->EachProp(
      [](vtkProp* prop)
      {
        vtkActor::SafeDownCast(prop)
          ->GetMapper()
          ->SetRelativeCoincidentTopologyPolygonOffsetParameters(2.0, 20.0);
      });
    this->Render();
    this->CheckMeasure("polygon offsets" + planes, spot, MostMismatchPercent, 0.0);
    vtkMapper::SetResolveCoincidentTopologyToDefault();
    const auto showEdges = [this](int shown)
    {
      this->EachProp([shown](vtkProp* prop)
        { vtkActor::SafeDownCast(prop)->GetProperty()->SetEdgeVisibility(shown); });
    };
    showEdges(1);
    this->Render();
    this->CheckMeasure("visible edges" + planes, spot, isTwo ? 0.3 : 0.2, isTwo ? 0.1 : 0.0);
    showEdges(0);
  }
}

// Far from the origin a small body is not flat.
TEST_F(PlanarShadows, SmallBodiesFarAway)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const glm::dvec3 far(1.0e6, -2.0e6, 1.0e6);
  AddFloor(this->Renderer, 2.0);
  for (int i = 0; i < 5; ++i)
  {
    auto ball = AddSphere(this->Renderer, { 0.3 * i - 0.6, 0.1 * i, 0.12 + 0.1 * i }, 0.08);
    vtkShadowPass::SetReceivesShadows(ball, false);
  }
  vtkNew<vtkTransform> away;
  away->Translate(far.x, far.y, far.z);
  PlaceActors(this->Renderer, away, false);
  auto sun = AddSun(this->Renderer, { -0.5, 0.4, -1.0 });
  LookAt(this->Renderer, far + glm::dvec3(1.0, -3.0, 2.0), far);
  this->CheckHard("small balls, planar", sun);
  EXPECT_GT(this->VisibilityOf(sun).CountShadowed(), 500u);
  this->Shadows->SetTechnique("stencil-volume");
  this->CheckHard("small balls, stencil-volume", sun);
}
