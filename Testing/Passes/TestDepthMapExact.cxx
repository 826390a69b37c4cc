// The depth map's filter "exact" against the truth: on what DepthMapAccuracy has, for every kind of
// light, and where only some of the casters are triangles.
#include "ShadowTest.h"
#include "TestScenes.h"

#include "vtkShadowErrorMeasure.h"

#include <vtkLightCollection.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

using namespace shadowtest;

namespace
{

// What the filter is meant to keep at its default resolution, 2048.
constexpr double MostMismatch = 0.06; // percent of the receiver pixels
constexpr vtkIdType MostGross = 5;    // pixels

struct WindowSize
{
  int width;
  int height;
};
const WindowSize Windows[] = { { 1024, 768 }, { 768, 768 }, { 333, 1000 } };

class DepthMapExact : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetPass(this->Shadows);
    this->Maps()->SetFilter("exact");
  }

  vtkDepthShadowMapPass* Maps() { return this->Shadows->GetDepthShadowMapPass(); }

  // Holds every light against the truth.
  void CheckLights(const std::string& what)
  {
    this->Render();
    vtkCollectionSimpleIterator it;
    this->Renderer->GetLights()->InitTraversal(it);
    vtkNew<vtkShadowErrorMeasure> error;
    while (vtkLight* light = this->Renderer->GetLights()->GetNextLight(it))
    {
      ASSERT_TRUE(error->Measure(this->Renderer, light)) << what;
      std::printf(
        "%s, %s: receivers %lld, shadow %lld, uncertain %lld | mismatch %.4f %% (limit %g), "
        "gross %lld (limit %lld): false %lld, missed %lld\n",
        what.c_str(), light->GetPositional() ? "spot or point" : "directional",
        static_cast<long long>(error->GetReceiverPixels()),
        static_cast<long long>(error->GetShadowPixels()),
        static_cast<long long>(error->GetUncertainPixels()), error->GetMismatchPercent(),
        MostMismatch, static_cast<long long>(error->GetGrossPixels()),
        static_cast<long long>(MostGross), static_cast<long long>(error->GetGrossFalsePixels()),
        static_cast<long long>(error->GetGrossMissedPixels()));
      EXPECT_LE(error->GetMismatchPercent(), MostMismatch) << what << ": mismatch %";
      EXPECT_LE(error->GetGrossPixels(), MostGross) << what << ": gross pixels";
      EXPECT_GT(error->GetShadowPixels(), error->GetReceiverPixels() / 50)
        << what << ": few shadows";
    }
  }

  void CheckWindows(
    const std::string& what, const Subject& subject, double azimuth, double elevation)
  {
    for (const WindowSize& size : Windows)
    {
      this->Resize(size.width, size.height);
      AimCamera(this->Renderer, subject, azimuth, elevation, size.width, size.height);
      this->CheckLights(what);
    }
  }
};

}

TEST_F(DepthMapExact, StillLifeWithASpot)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Subject subject = AddStillLife(this->Renderer);
  AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0);
  this->CheckWindows("still life", subject, -15.0, 28.0);
}

TEST_F(DepthMapExact, BumpyMeshWithASun)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Subject subject = AddBumpyMesh(this->Renderer);
  AddSun(this->Renderer, -Toward(60.0, 40.0));
  this->CheckWindows("bumpy mesh", subject, 10.0, 20.0);
}

TEST_F(DepthMapExact, TubesAndGlyphsWithTwoLights)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Subject subject = AddTubesAndGlyphs(this->Renderer);
  AddSpot(this->Renderer, { 4.0, -3.0, 7.0 }, { 0.0, 0.0, 0.8 }, 30.0);
  AddSun(this->Renderer, -Toward(-50.0, 50.0));
  this->CheckWindows("tubes and glyphs", subject, 5.0, 25.0);
}

// Light and camera are drawn by lot, from fixed seeds; in turn on each of the scenes.
TEST_F(DepthMapExact, TwentyUnseenViews)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(1024, 768);
  for (int seed = 101; seed <= 120; ++seed)
  {
    const LotScene scene = AddSceneByLot(this->Renderer, seed, 25.0, 1024, 768);
    this->CheckLights(scene.name + ", seed " + std::to_string(seed));
  }
}

// A light amid its casters, whose triangles lie on all sides of it.
TEST_F(DepthMapExact, PointLightInAClosedRoom)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddBox(this->Renderer, { -3.0, -3.0, 0.0 }, { 3.0, 3.0, 4.0 });
  AddSphere(this->Renderer, { 1.5, 1.5, 1.0 }, 0.6);
  AddSphere(this->Renderer, { -1.6, 0.2, 2.0 }, 0.4);
  AddBox(this->Renderer, { 0.5, -1.8, 0.0 }, { 1.3, -0.9, 0.9 });
  AddBox(this->Renderer, { -0.95, -1.15, 0.0 }, { -0.65, -0.85, 3.0 });
  this->Renderer->GetActiveCamera()->SetViewAngle(80.0);
  this->Resize(800, 600);
  LookAt(this->Renderer, { 2.5, 2.5, 3.5 }, { -1.0, -1.0, 0.5 });
  AddLamp(this->Renderer, { 0.2, 0.3, 2.1 });
  this->CheckLights("point light in a room");
  this->Renderer->RemoveAllLights();
  // One map, amid its casters: what it must not be told is where its triangles lie on the map.
  AddSpot(this->Renderer, { 0.2, 0.3, 2.1 }, { -1.0, -1.0, 0.0 }, 60.0);
  this->CheckLights("spot in a room");
}

// A long row, near to the eye and far from it: each cascade's map has texels of its own size.
TEST_F(DepthMapExact, Cascades)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddFloor(this->Renderer, 400.0);
  for (int i = 0; i < 60; ++i)
  {
    const double y = 0.02 * i * i + 1.5 * i, side = i % 2 == 0 ? -1.2 : 1.2;
    AddSphere(this->Renderer, { side, y, 0.7 }, 0.5);
    AddBox(this->Renderer, { side + 1.0, y, 0.0 }, { side + 1.3, y + 0.6, 1.4 });
  }
  AddSun(this->Renderer, { 1.0, 0.6, -0.7 });
  this->Resize(800, 600);
  LookAt(this->Renderer, { 0.4, -4.0, 1.6 }, { 0.0, 20.0, 0.0 });
  this->Maps()->SetResolution(1024);
  this->Maps()->SetNumberOfCascades(4);
  this->CheckLights("four cascades");
  EXPECT_GE(this->Maps()->GetNumberOfViews(), 3);
}

// Large meshes of which a map holds a part: a country under cascades, and a room with a lamp in it.
TEST_F(DepthMapExact, PartsOfLargeMeshes)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const auto ground = [](double u, double v) -> glm::dvec3
  {
    const double x = 200.0 * (u - 0.5), y = 200.0 * (v - 0.5);
    return { x, y, 3.0 * std::sin(0.11 * x + 1.0) * std::cos(0.13 * y) + 0.7 * std::sin(x + y) };
  };
  vtkActor* country = AddActor(this->Renderer, MakeSurface(160, 160, ground));
  AddSun(this->Renderer, { 1.0, 0.6, -0.4 });
  this->Resize(800, 600);
  LookAt(this->Renderer, { 0.4, -90.0, 12.0 }, { 0.0, -40.0, 0.0 });
  this->Maps()->SetNumberOfCascades(4);
  this->CheckLights("a country, four cascades");
  EXPECT_GE(this->Maps()->GetNumberOfViews(), 3);
  // The list is kept, and its parts are other ones.
  LookAt(this->Renderer, { -3.0, 90.0, 12.0 }, { 0.0, 40.0, 0.0 });
  this->CheckLights("the same from the other side");
  country->SetPosition(3.0, 1.0, 0.0);
  this->CheckLights("moved, four cascades");

  this->Renderer->RemoveAllLights();
  this->Renderer->RemoveAllViewProps();
  vtkNew<vtkSphereSource> shell;
  shell->SetRadius(5.0);
  shell->SetThetaResolution(160);
  shell->SetPhiResolution(160);
  AddActor(this->Renderer, shell);
  AddSphere(this->Renderer, { 1.5, 1.5, 0.0 }, 0.6);
  AddBox(this->Renderer, { -2.0, -1.0, -1.0 }, { -1.2, -0.2, 1.0 });
  this->Renderer->GetActiveCamera()->SetViewAngle(80.0);
  LookAt(this->Renderer, { 3.0, 3.0, 1.5 }, { -1.0, -1.0, 0.0 });
  AddLamp(this->Renderer, { 0.2, 0.3, 0.4 });
  this->CheckLights("a lamp in a shell");
}

TEST_F(DepthMapExact, OffsetsAndScales)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(640, 480);
  for (const Placement& placement : Placements)
  {
    AddStillLifeAt(this->Renderer, placement, true, 640, 480);
    AddSpot(
      this->Renderer, placement.Of({ 3.5, -3.0, 6.5 }), placement.Of({ 0.0, 0.0, 0.3 }), 35.0);
    this->CheckLights(placement.name);
  }
}

// Of impostors only the depth is known: they cast as by "percentage-closer", and the triangles
// beside them exactly.
TEST_F(DepthMapExact, ImpostorsAmongTriangles)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(800, 600);
  const Subject subject = AddStillLife(this->Renderer);
  vtkNew<vtkPoints> centres;
  centres->InsertNextPoint(0.6, -0.9, 1.9);
  centres->InsertNextPoint(-0.4, 0.9, 2.1);
  vtkNew<vtkPolyData> balls;
  balls->SetPoints(centres);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(balls);
  mapper->SetRadius(0.35);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  auto sun = AddSun(this->Renderer, -Toward(40.0, 50.0));
  AimCamera(this->Renderer, subject, -15.0, 28.0, 800, 600);
  this->Render();
  this->CheckMeasure("impostors among triangles", sun, 0.1, 0.005);
}

// Numbers of triangles that change, since lights come and go, are drawn anew.
TEST_F(DepthMapExact, LightsThatComeAndGo)
{
  this->Resize(400, 300);
  const Subject subject = AddStillLife(this->Renderer);
  AimCamera(this->Renderer, subject, -15.0, 28.0, 400, 300);
  auto first = AddSun(this->Renderer, -Toward(40.0, 50.0));
  auto second = AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0);
  auto amid = AddLamp(this->Renderer, { 0.1, 0.1, 0.7 });
  const auto compare = [this](const std::string& what)
  {
    const Frame frame = this->Render();
    vtkNew<vtkShadowPass> fresh;
    fresh->SetTechnique("depth-map");
    fresh->GetDepthShadowMapPass()->SetFilter("exact");
    this->Renderer->SetPass(fresh);
    const Frame expected = this->Render();
    this->Renderer->SetPass(this->Shadows);
    Check(what + ": pixels unlike a fresh pass's",
      static_cast<double>(CountDifferent(frame, expected)), 0.0);
  };
  compare("three lights");
  first->SwitchOff();
  compare("first light off");
  amid->SwitchOff();
  compare("light amid the casters off");
  first->SwitchOn();
  compare("first light on");
  second->SetPosition(3.0, -3.5, 6.0);
  compare("spot moved");
  this->Maps()->SetFilter("percentage-closer");
  this->Render();
  this->Maps()->SetFilter("exact");
  compare("another filter in between");
  const vtkIdType builds = this->Maps()->GetNumberOfMapBuilds();
  this->Renderer->GetActiveCamera()->Azimuth(3.0);
  this->Render();
  Check("maps drawn while the camera moves",
    static_cast<double>(this->Maps()->GetNumberOfMapBuilds() - builds), 0.0);
}

TEST_F(DepthMapExact, UnknownFilters)
{
  this->Maps()->SetFilter("sharp");
  ExpectOneMessage({ "sharp", "percentage-closer", "exact" });
  this->Maps()->SetFilter(-1);
  ExpectOneMessage({ "-1", "FilterType" });
  EXPECT_EQ(this->Maps()->GetFilter(), vtkDepthShadowMapPass::EXACT);
}

// Apart, so that CTest shows it as skipped where the scan is not there.
class DepthMapExactOnAScan : public DepthMapExact
{
};

TEST_F(DepthMapExactOnAScan, ElephantWithASun)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const char* file = std::getenv("VTKSHADOWS_TEST_SCAN");
  if (!file || !std::ifstream(file))
  {
    GTEST_SKIP() << "the scanned mesh " << (file ? file : "(VTKSHADOWS_TEST_SCAN is not set)")
                 << " is not there; Scripts/demo unpacks it from Debian's libcgal-demo";
  }
  const Subject subject = AddScannedMesh(this->Renderer, file);
  AddSun(this->Renderer, -Toward(50.0, 45.0));
  this->CheckWindows("elephant", subject, 20.0, 15.0);
}
