#include "Scenes.h"

#include "SceneList.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkOpenGLStickMapper.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace vtkshadows
{

namespace
{

using scenes::SceneInMaking;

constexpr int MostLights = 64;

// What shadow leaves of a surface's colour: dark, but not black.
constexpr double Ambient = 0.25;

struct RegisteredScene
{
  const char* name;
  const char* description;
  SceneReceivers receivers;
  void (*make)(SceneInMaking&);
};

const std::vector<RegisteredScene>& Registry()
{
  static const std::vector<RegisteredScene> registry = {
    { "still-life", "a sphere, a torus, a cone and a box on a floor, under a directional light",
      SceneReceivers::Mixed, scenes::MakeStillLife },
    { "statue", "a scanned mesh on a floor, under a spot light", SceneReceivers::Mixed,
      scenes::MakeStatue },
    { "anatomy", "isosurfaces of organs in a translucent body, under a spot light",
      SceneReceivers::Mixed, scenes::MakeAnatomy },
    { "flow", "stream tubes among glyphs over a floor, with two lights", SceneReceivers::Mixed,
      scenes::MakeFlow },
    { "terrain", "ten kilometres of hills, houses and trees in UTM coordinates, under a low sun",
      SceneReceivers::Mixed, scenes::MakeTerrain },
    { "molecule", "balls and sticks, drawn as impostors, over a floor", SceneReceivers::Mixed,
      scenes::MakeMolecule },
    { "city", "blocks of houses: flat receivers alone", SceneReceivers::Planar, scenes::MakeCity },
    { "grass", "blades of grass, long slivers, about a ball", SceneReceivers::Mixed,
      scenes::MakeGrass },
    { "crowd", "figures that are instances of one glyph", SceneReceivers::Mixed,
      scenes::MakeCrowd },
    { "closed-box", "a room with a lamp in its midst", SceneReceivers::Mixed,
      scenes::MakeClosedBox },
    { "fence", "thin bars on a roof, whose shadows fall on the ground far below",
      SceneReceivers::Planar, scenes::MakeFence },
  };
  return registry;
}

const RegisteredScene& Find(const std::string& name)
{
  std::string known;
  for (const RegisteredScene& scene : Registry())
  {
    if (name == scene.name)
    {
      return scene;
    }
    known += (known.empty() ? "" : ", ") + std::string(scene.name);
  }
  throw std::invalid_argument(
    "scene " + (name.empty() ? "''" : name) + ": is none of the registry; choose one of " + known);
}

template <typename T>
void Require(const char* what, T value, T low, T high)
{
  if (!(value >= low && value <= high))
  {
    std::ostringstream message;
    message << "scene size: " << what << " " << value << " is outside " << low << " to " << high
            << "; give one within";
    throw std::invalid_argument(message.str());
  }
}

void RequireSize(const SceneSize& size)
{
  Require("detail", size.detail, 0.01, 100.0);
  Require<vtkIdType>("triangles", size.triangles, 10'000, 50'000'000);
  Require("lights", size.lights, 0, MostLights);
  Require("width", size.width, 1, 65536);
  Require("height", size.height, 1, 65536);
}

LightKind KindOf(vtkLight* light)
{
  return !light->GetPositional()   ? LightKind::Directional
    : light->GetConeAngle() < 90.0 ? LightKind::Spot
                                   : LightKind::Point;
}

glm::dvec3 Turned(const glm::dvec3& p, const glm::dvec3& axis, double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  const glm::dvec3 d = p - axis;
  return axis + glm::dvec3(c * d.x - s * d.y, s * d.x + c * d.y, d.z);
}

// As many lights as asked for: the first of the scene's own, and copies of them turned about the
// vertical by the golden angle, so that no two come near. Together they are as bright as before.
void SpreadLights(SceneInMaking& scene)
{
  std::vector<SceneLight>& lights = scene.facts.lights;
  const std::size_t own = lights.size();
  const std::size_t wanted = scene.size.lights;
  if (wanted == 0 || wanted == own)
  {
    return;
  }
  while (lights.size() > wanted)
  {
    scene.renderer->RemoveLight(lights.back().light);
    lights.pop_back();
  }
  const double goldenAngle = glm::pi<double>() * (3.0 - std::sqrt(5.0));
  for (std::size_t i = own; i < wanted; ++i)
  {
    const SceneLight original = lights[i % own];
    SceneLight turned = original;
    turned.light = vtkSmartPointer<vtkLight>::New();
    turned.light->DeepCopy(original.light);
    const bool directional = original.kind == LightKind::Directional;
    const glm::dvec3 axis = directional ? glm::dvec3(0.0) : scene.facts.centre;
    const double angle = goldenAngle * static_cast<double>(i);
    glm::dvec3 position, focus;
    original.light->GetPosition(&position.x);
    original.light->GetFocalPoint(&focus.x);
    position = Turned(position, axis, angle);
    focus = Turned(focus, axis, angle);
    turned.light->SetPosition(position.x, position.y, position.z);
    turned.light->SetFocalPoint(focus.x, focus.y, focus.z);
    scene.renderer->AddLight(turned.light);
    lights.push_back(turned);
  }
  for (const SceneLight& light : lights)
  {
    light.light->SetIntensity(
      light.light->GetIntensity() * static_cast<double>(own) / static_cast<double>(wanted));
  }
}

vtkIdType TrianglesOf(vtkPolyData* mesh)
{
  vtkIdType count = 0;
  for (vtkCellArray* cells : { mesh->GetPolys(), mesh->GetStrips() })
  {
    count += cells->GetNumberOfConnectivityIds() - 2 * cells->GetNumberOfCells();
  }
  return count;
}

// The sum of `count` over the mappers of visible actors.
template <typename Count>
vtkIdType SumOverMappers(vtkRenderer* renderer, const Count& count)
{
  vtkIdType sum = 0;
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator it;
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    if (actor->GetVisibility() && actor->GetMapper())
    {
      actor->GetMapper()->Update();
      sum += count(actor->GetMapper());
    }
  }
  return sum;
}

bool IsImpostors(vtkMapper* mapper)
{
  return vtkOpenGLSphereMapper::SafeDownCast(mapper) || vtkOpenGLStickMapper::SafeDownCast(mapper);
}

bool HasTranslucents(vtkRenderer* renderer)
{
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator it;
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    if (actor->GetProperty()->GetOpacity() < 1.0)
    {
      return true;
    }
  }
  return false;
}

void MoveInto(vtkRenderer* target, vtkRenderer* made)
{
  target->RemoveAllViewProps();
  target->RemoveAllLights();
  target->AutomaticLightCreationOff();
  vtkActorCollection* actors = made->GetActors();
  vtkCollectionSimpleIterator it;
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    actor->GetProperty()->SetAmbient(Ambient);
    actor->GetProperty()->SetDiffuse(1.0 - Ambient);
    target->AddActor(actor);
  }
  vtkLightCollection* lights = made->GetLights();
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    target->AddLight(light);
  }
  target->SetBackground(0.93, 0.95, 0.97);
  target->GetActiveCamera()->DeepCopy(made->GetActiveCamera());
  target->GetActiveCamera()->Modified(); // which a copy is not, for the matrices it keeps
  target->SetNearClippingPlaneTolerance(made->GetNearClippingPlaneTolerance());
  target->ResetCameraClippingRange();
}

}

//------------------------------------------------------------------------------
void scenes::SceneInMaking::Add(vtkLight* light, double radius)
{
  this->facts.lights.push_back({ light, KindOf(light), radius });
}

void scenes::SceneInMaking::Show(const scenes::Subject& subject, double azimuth, double elevation)
{
  this->facts.centre = subject.centre;
  this->facts.radius = subject.radius;
  scenes::AimCamera(
    this->renderer, subject, azimuth, elevation, this->size.width, this->size.height);
}

//------------------------------------------------------------------------------
std::vector<std::string> SceneNames()
{
  std::vector<std::string> names;
  for (const RegisteredScene& scene : Registry())
  {
    names.push_back(scene.name);
  }
  return names;
}

std::string SceneDescription(const std::string& name)
{
  return Find(name).description;
}

SceneFacts BuildScene(const std::string& name, vtkRenderer* renderer, const SceneSize& size)
{
  const RegisteredScene& registered = Find(name);
  RequireSize(size);
  SceneFacts facts;
  facts.name = registered.name;
  facts.description = registered.description;
  facts.receivers = registered.receivers;

  // Made aside, so that a file that cannot be read changes nothing.
  vtkNew<vtkRenderer> made;
  made->AutomaticLightCreationOff();
  SceneInMaking scene{ made, size, facts };
  registered.make(scene);
  SpreadLights(scene);
  facts.triangles = CountTriangles(made);
  facts.impostors = CountImpostors(made);
  facts.translucents = HasTranslucents(made);
  made->ComputeVisiblePropBounds(facts.bounds);
  MoveInto(renderer, made);
  return facts;
}

//------------------------------------------------------------------------------
vtkIdType CountTriangles(vtkRenderer* renderer)
{
  return SumOverMappers(renderer,
    [](vtkMapper* mapper) -> vtkIdType
    {
      if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
      {
        auto* places = vtkDataSet::SafeDownCast(glyphs->GetInputDataObject(0, 0));
        return places->GetNumberOfPoints() * TrianglesOf(glyphs->GetSource());
      }
      auto* mesh = vtkPolyDataMapper::SafeDownCast(mapper);
      return mesh && !IsImpostors(mapper) ? TrianglesOf(mesh->GetInput()) : 0;
    });
}

vtkIdType CountImpostors(vtkRenderer* renderer)
{
  return SumOverMappers(renderer,
    [](vtkMapper* mapper) -> vtkIdType
    {
      return IsImpostors(mapper)
        ? vtkPolyDataMapper::SafeDownCast(mapper)->GetInput()->GetNumberOfPoints()
        : 0;
    });
}

}
