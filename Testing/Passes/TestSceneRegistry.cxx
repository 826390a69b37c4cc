// The registry's scenes: each is built, drawn and held against its own facts.
#include "ShadowTest.h"
#include "TestScenes.h"

#include "Scenes.h"

#include <vtkActorCollection.h>
#include <vtkCellLocator.h>
#include <vtkLightCollection.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRayCastShadowPass.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

using namespace shadowtest;
using vtkshadows::BuildScene;
using vtkshadows::LightKind;
using vtkshadows::SceneFacts;
using vtkshadows::SceneNames;
using vtkshadows::SceneSize;

namespace
{

// Small, so that eleven of them are quick.
SceneSize SmallSize()
{
  SceneSize size;
  size.width = 400;
  size.height = 300;
  size.triangles = 200'000;
  return size;
}

double FactOf(const SceneFacts& facts, const std::string& what)
{
  for (const auto& fact : facts.facts)
  {
    if (fact.what == what)
    {
      return fact.value;
    }
  }
  ADD_FAILURE() << facts.name << " has no fact " << what;
  return std::nan("");
}

double Share(const Visibility& visibility)
{
  return double(visibility.CountShadowed()) / double(visibility.values.size());
}

// Of what a user would call the ground.
vtkPolyData* FirstMesh(vtkRenderer* renderer)
{
  vtkActor* first = vtkActor::SafeDownCast(renderer->GetActors()->GetItemAsObject(0));
  first->GetMapper()->Update();
  return vtkPolyData::SafeDownCast(first->GetMapper()->GetInputDataObject(0, 0));
}

std::string WhyRefused(const std::string& name, vtkRenderer* renderer, const SceneSize& size)
{
  try
  {
    BuildScene(name, renderer, size);
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return "";
}

}

class SceneRegistry : public ShadowTest
{
};

//------------------------------------------------------------------------------
TEST_F(SceneRegistry, EachIsDrawnAndIsWhatItsFactsSay)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Renderer->SetPass(this->Shadows);
  this->Shadows->SetTechnique("ray-cast");
  const char* folder = std::getenv("VTKSHADOWS_TEST_OUTPUT");
  for (const std::string& name : SceneNames())
  {
    SCOPED_TRACE(name);
    const SceneFacts facts = BuildScene(name, this->Renderer, SmallSize());
    this->Shadows->ClearLightSettings(nullptr);
    const Frame frame = this->Render();
    if (folder)
    {
      WritePng(frame, std::string(folder) + "/Scene-" + name + ".png");
    }
    std::printf("%s: %lld triangles, %lld impostors, %d planes\n", name.c_str(),
      static_cast<long long>(facts.triangles), static_cast<long long>(facts.impostors),
      facts.planes);

    // The truth's tree holds every opaque triangle, and the spheres; of the molecule's impostors
    // those are the atoms. Not in it are the triangles without area at the made statue's one pole
    // that is a point to the last bit.
    if (!facts.translucents)
    {
      const double spheres = facts.impostors ? FactOf(facts, "atoms") : 0.0;
      const double pole = name == "statue" ? 240.0 : 0.0;
      Check(name + ": primitives of the tree",
        double(this->Shadows->GetRayCastShadowPass()->GetNumberOfPrimitives()),
        double(facts.triangles) + spheres - pole);
    }
    Check(name + ": lights", this->Renderer->GetLights()->GetNumberOfItems(),
      double(facts.lights.size()));
    double bounds[6];
    this->Renderer->ComputeVisiblePropBounds(bounds);
    for (int i = 0; i < 6; ++i)
    {
      Check(name + ": bounds", facts.bounds[i], bounds[i]);
    }
    for (const auto& light : facts.lights)
    {
      EXPECT_EQ(light.kind == LightKind::Directional, !light.light->GetPositional());
      EXPECT_EQ(light.kind == LightKind::Point,
        light.light->GetPositional() && light.light->GetConeAngle() >= 90.0);
      CheckAtLeast(name + ": radius of the light", light.radius, 1e-9);
      const Visibility truth = this->VisibilityOf(light.light);
      CheckAtLeast(name + ": share of the picture in shadow", Share(truth), 0.02);
      CheckAtMost(name + ": share of the picture in shadow", Share(truth), 0.75);
    }
    // What casts nothing for the truth is told, and no other message is there.
    for (const std::string& message : TakeMessages())
    {
      EXPECT_NE(message.find("vtkOpenGLStickMapper"), std::string::npos) << message;
      EXPECT_GT(facts.impostors, 0);
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(SceneRegistry, CountsFollowFromHowScenesAreMade)
{
  // Floor 2; sphere 96 round, 96 from pole to pole; torus; cone's side and base; box.
  const double sphere = 2.0 * 96 * (96 - 2), torus = 2.0 * 96 * 48, cone = 64 + 62;
  Check("triangles of the still life",
    double(BuildScene("still-life", this->Renderer, SmallSize()).triangles),
    2 + sphere + torus + cone + 12);
  Check("triangles of the made statue",
    double(BuildScene("statue", this->Renderer, SmallSize()).triangles), 2 + 2.0 * 240 * 240);
  const SceneFacts crowd = BuildScene("crowd", this->Renderer, SmallSize());
  Check("triangles of the crowd", double(crowd.triangles),
    2 + FactOf(crowd, "figures") * FactOf(crowd, "triangles of a figure"));
  Check("triangles of the crowd, asked for", double(crowd.triangles), 200'000.0, 2000.0);
  const SceneFacts city = BuildScene("city", this->Renderer, SmallSize());
  Check("triangles of the city", double(city.triangles), 2 + 12 * FactOf(city, "houses"));
  const SceneFacts grass = BuildScene("grass", this->Renderer, SmallSize());
  Check("triangles of the grass", double(grass.triangles),
    2 + 5 * FactOf(grass, "blades") + 2.0 * 64 * (64 - 2));
}

TEST_F(SceneRegistry, TheEyeStandsTwoMetresAboveTheTerrain)
{
  const SceneFacts facts = BuildScene("terrain", this->Renderer, SmallSize());
  double eye[3];
  this->Renderer->GetActiveCamera()->GetPosition(eye);
  vtkNew<vtkCellLocator> locator;
  locator->SetDataSet(FirstMesh(this->Renderer));
  locator->BuildLocator();
  const double above[3] = { eye[0], eye[1], 1e4 }, below[3] = { eye[0], eye[1], -1e4 };
  double t, hit[3], parametric[3];
  int part;
  ASSERT_TRUE(locator->IntersectWithLine(above, below, 1e-9, t, hit, parametric, part));
  Check("height of the eye, metres", eye[2] - hit[2], FactOf(facts, "camera above ground"), 1e-6);
  CheckAtLeast("easting of its western rim", facts.bounds[0], 4e5);
  CheckAtLeast("northing of its southern rim", facts.bounds[2], 5.4e6);
  Check("width", facts.bounds[1] - facts.bounds[0], 10'000.0, 1e-6);

  glm::dvec3 position;
  facts.lights[0].light->GetPosition(&position.x);
  const double elevation =
    std::atan2(position.z, std::hypot(position.x, position.y)) * 180.0 / std::acos(-1.0);
  Check("sun above the horizon", elevation, FactOf(facts, "sun above horizon"), 1e-9);
}

//------------------------------------------------------------------------------
TEST_F(SceneRegistry, SizesScale)
{
  for (const std::string& name : SceneNames())
  {
    SceneSize size = SmallSize();
    const SceneFacts whole = BuildScene(name, this->Renderer, size);
    const SceneFacts again = BuildScene(name, this->Renderer, size);
    Check(name + ": triangles of the same scene", double(again.triangles), double(whole.triangles));
    if (name == "crowd")
    {
      size.triangles = 800'000;
    }
    size.detail = 4.0;
    const SceneFacts larger = BuildScene(name, this->Renderer, size);
    // Rounded numbers of cells, parts that do not grow, and surfaces that grow with the square of a
    // volume's cells.
    CheckAtLeast(
      name + ": times the triangles", double(larger.triangles) / double(whole.triangles), 2.0);
    CheckAtMost(
      name + ": times the triangles", double(larger.triangles) / double(whole.triangles), 5.0);
  }
}

TEST_F(SceneRegistry, LightsAreAsManyAsAskedFor)
{
  for (const std::string& name : { "flow", "closed-box" })
  {
    SceneSize size = SmallSize();
    const auto brightness = [](const SceneFacts& facts)
    {
      double sum = 0.0;
      for (const auto& light : facts.lights)
      {
        sum += light.light->GetIntensity();
      }
      return sum;
    };
    const SceneFacts own = BuildScene(name, this->Renderer, size);
    for (const int lights : { 2, 16 })
    {
      size.lights = lights;
      const SceneFacts more = BuildScene(name, this->Renderer, size);
      Check(std::string(name) + ": lights", double(more.lights.size()), lights);
      Check(std::string(name) + ": lights of the renderer",
        this->Renderer->GetLights()->GetNumberOfItems(), lights);
      Check(std::string(name) + ": brightness of all", brightness(more), brightness(own), 1e-9);
    }
    size.lights = 1;
    Check(std::string(name) + ": one light",
      double(BuildScene(name, this->Renderer, size).lights.size()), 1.0);
  }
}

//------------------------------------------------------------------------------
TEST_F(SceneRegistry, FilesAreRead)
{
  const std::string folder = std::getenv("VTKSHADOWS_TEST_OUTPUT");
  std::ofstream(folder + "/scan.off") << "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                         "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  std::ofstream(folder + "/scan.ply")
    << "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
       "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
       "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  for (const char* file : { "/scan.off", "/scan.ply" })
  {
    SceneSize size = SmallSize();
    size.mesh = folder + file;
    const SceneFacts facts = BuildScene("statue", this->Renderer, size);
    Check(size.mesh + ": triangles", double(facts.triangles), 6.0);
    Check(size.mesh + ": notes", double(facts.notes.size()), 0.0);
  }
  Check("notes of a made statue",
    double(BuildScene("statue", this->Renderer, SmallSize()).notes.size()), 1.0);
}

TEST_F(SceneRegistry, WhatIsRefusedChangesNothing)
{
  BuildScene("still-life", this->Renderer, SmallSize());
  const int props = this->Renderer->GetActors()->GetNumberOfItems();
  const auto refused =
    [&](const std::string& name, const SceneSize& size, const std::vector<std::string>& parts)
  {
    const std::string why = WhyRefused(name, this->Renderer, size);
    std::printf("     %s\n", why.c_str());
    for (const std::string& part : parts)
    {
      EXPECT_NE(why.find(part), std::string::npos) << "no \"" << part << "\" in: " << why;
    }
    Check("props", this->Renderer->GetActors()->GetNumberOfItems(), props);
    Check("lights", this->Renderer->GetLights()->GetNumberOfItems(), 1.0);
  };
  refused("stil-life", SmallSize(), { "stil-life", "still-life" });
  SceneSize size = SmallSize();
  size.detail = std::nan("");
  refused("city", size, { "detail", "nan", "0.01" });
  size = SmallSize();
  size.lights = 65;
  refused("city", size, { "lights 65", "64" });
  size = SmallSize();
  size.triangles = 1;
  refused("crowd", size, { "triangles 1", "10000" });
  size = SmallSize();
  size.mesh = "/no/such/mesh.off";
  refused("statue", size, { "/no/such/mesh.off" });
  size.mesh = "/no/such/mesh.ply";
  refused("statue", size, { "/no/such/mesh.ply" });
  size.volume = "/no/such/volume.vti";
  refused("anatomy", size, { "/no/such/volume.vti" });
}
