#include "ExtremeCaseList.h"
#include "ExtremeMeshes.h"

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkCamera.h>
#include <vtkCompositePolyDataMapper.h>
#if __has_include(<vtkCompositePolyDataMapper2.h>)
#include <vtkCompositePolyDataMapper2.h>
#endif
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProp3DCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <utility>

namespace vtkshadows
{
namespace
{

vtkSmartPointer<vtkLight> LightOf(const ShadowLight& light, const glm::dvec3& offset, double scale)
{
  auto made = vtkSmartPointer<vtkLight>::New();
  // A light's direction is its focal point's: as far away as the light is large in the world.
  const glm::dvec3 position = light.kind == LightKind::Directional
    ? offset - scale * light.direction
    : offset + scale * light.position;
  const glm::dvec3 focus = light.kind == LightKind::Directional
    ? offset
    : offset + scale * (light.position + light.direction);
  made->SetPositional(light.kind != LightKind::Directional);
  made->SetPosition(position.x, position.y, position.z);
  made->SetFocalPoint(focus.x, focus.y, focus.z);
  made->SetConeAngle(light.kind == LightKind::Point ? 180.0 : light.coneAngle);
  return made;
}

vtkSmartPointer<vtkActor> ActorOf(
  const ExtremePart& part, const glm::dmat4& worldFromScene, bool byMatrix)
{
  const bool isPlain = byMatrix || worldFromScene == glm::dmat4(1.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(
    isPlain || !part.mesh->GetPoints() ? part.mesh.Get() : Moved(part.mesh, worldFromScene).Get());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(part.colour.x, part.colour.y, part.colour.z);
  const glm::dmat4 worldFromModel =
    byMatrix ? worldFromScene * part.sceneFromModel : part.sceneFromModel;
  if (worldFromModel != glm::dmat4(1.0))
  {
    vtkNew<vtkMatrix4x4> matrix;
    for (int row = 0; row < 4; ++row)
    {
      for (int column = 0; column < 4; ++column)
      {
        matrix->SetElement(row, column, worldFromModel[column][row]);
      }
    }
    actor->SetUserMatrix(matrix);
  }
  return actor;
}

vtkSmartPointer<vtkMapper> MapperOf(vtkDataObject* blocks, ExtremeGrouping grouping)
{
  auto mapper = vtkSmartPointer<vtkMapper>::Take(vtkCompositePolyDataMapper::New());
#if __has_include(<vtkCompositePolyDataMapper2.h>)
  if (grouping == ExtremeGrouping::Blocks)
  {
    mapper = vtkSmartPointer<vtkMapper>::Take(vtkCompositePolyDataMapper2::New());
  }
#else
  static_cast<void>(grouping); // later versions have the one
#endif
  mapper->SetInputDataObject(blocks);
  return mapper;
}

}

//------------------------------------------------------------------------------
std::string Text(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

//------------------------------------------------------------------------------
ShadowLight SpotFrom(const glm::dvec3& position, const glm::dvec3& focus, double cone)
{
  ShadowLight light;
  light.kind = cone < 90.0 ? LightKind::Spot : LightKind::Point;
  light.position = position;
  light.direction = glm::normalize(focus - position);
  light.coneAngle = cone;
  return light;
}

//------------------------------------------------------------------------------
ShadowLight Sun(const glm::dvec3& along)
{
  ShadowLight light;
  light.direction = glm::normalize(along);
  return light;
}

//------------------------------------------------------------------------------
ShadowLight Lamp(const glm::dvec3& position)
{
  return SpotFrom(position, position - glm::dvec3(0.0, 0.0, 1.0), 180.0);
}

//------------------------------------------------------------------------------
ExtremeCase& ExtremeCaseList::Add(const std::string& kind, const std::string& value,
  bool looksPlain, const std::function<void(ExtremeScene&)>& change)
{
  ExtremeCase added;
  added.kind = kind;
  added.value = value;
  added.looksPlain = looksPlain;
  added.change = change;
  this->all.push_back(added);
  return this->all.back();
}

//------------------------------------------------------------------------------
ExtremeScene PlainExtremeScene()
{
  ExtremeScene scene;
  const auto add = [&scene](const vtkSmartPointer<vtkPolyData>& mesh, const glm::dvec3& colour)
  {
    ExtremePart part;
    part.mesh = mesh;
    part.colour = colour;
    scene.parts.push_back(part);
  };
  add(MakeFloor(FloorHalf), { 0.85, 0.85, 0.8 });
  add(MakeBall(BallCentre, BallRadius), { 0.8, 0.3, 0.25 });
  add(MakeBox(), { 0.4, 0.7, 0.4 });
  add(MakePillar(), { 0.9, 0.75, 0.3 });
  add(MakeRing(), { 0.3, 0.5, 0.8 });
  scene.lights = { SpotFrom(Middle + 7.0 * TowardSpot, Middle, 35.0) };
  scene.eye = { -1.5, -8.5, 6.5 };
  scene.focus = Middle;
  scene.clipping[0] = 2.0;
  scene.clipping[1] = 60.0;
  return scene;
}

//------------------------------------------------------------------------------
std::vector<ExtremeCase> ExtremeCases()
{
  ExtremeCaseList cases;
  AddPlacements(cases);
  AddViews(cases);
  AddLights(cases);
  AddOtherLights(cases);
  AddCellars(cases);
  AddFloors(cases);
  AddMeshes(cases);
  AddMatrices(cases);
  for (ExtremeCase& extreme : cases.all)
  {
    const std::string name = extreme.Name();
    const auto isOneOf = [&name](std::initializer_list<const char*> names)
    { return std::find(names.begin(), names.end(), name) != names.end(); };
    extreme.isBeyond = isOneOf({ "near:far 1:1e+07", "coordinates 1e12 among others",
      "matrix sheared by 1000", "floor with all else in composite data wider by 10000",
      "floor with all else in composite data wider by 1e+06",
      "floor with all else in composite data, block by block, wider by 10000",
      "floor with all else in composite data, block by block, wider by 1e+06" });
    extreme.isBroken = extreme.kind == "coordinates" || extreme.kind == "matrix";
  }
  return std::move(cases.all);
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkLight>> Build(const ExtremeScene& scene, vtkRenderer* renderer)
{
  renderer->RemoveAllViewProps();
  renderer->RemoveAllLights();
  renderer->AutomaticLightCreationOff();
  const glm::dmat4 worldFromScene =
    glm::scale(glm::translate(glm::dmat4(1.0), scene.offset), glm::dvec3(scene.scale));
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkAssembly> assembly;
  for (const ExtremePart& part : scene.parts)
  {
    const vtkSmartPointer<vtkActor> actor = ActorOf(part, worldFromScene, scene.byMatrix);
    if (!part.isGrouped)
    {
      renderer->AddActor(actor);
    }
    else if (scene.grouping == ExtremeGrouping::Assembly)
    {
      assembly->AddPart(actor);
    }
    else
    {
      blocks->SetBlock(blocks->GetNumberOfBlocks(), actor->GetMapper()->GetInputDataObject(0, 0));
    }
  }
  if (assembly->GetParts()->GetNumberOfItems() > 0)
  {
    renderer->AddActor(assembly);
  }
  if (blocks->GetNumberOfBlocks() > 0)
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(MapperOf(blocks, scene.grouping));
    renderer->AddActor(actor);
  }

  std::vector<vtkSmartPointer<vtkLight>> lights;
  for (const ShadowLight& light : scene.lights)
  {
    lights.push_back(LightOf(light, scene.offset, scene.scale));
    renderer->AddLight(lights.back());
  }

  const glm::dvec3 eye = scene.offset + scene.scale * scene.eye;
  const glm::dvec3 focus = scene.offset + scene.scale * scene.focus;
  vtkNew<vtkCamera> camera;
  camera->SetPosition(eye.x, eye.y, eye.z);
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(scene.viewAngle);
  camera->SetParallelProjection(scene.parallelScale > 0.0);
  camera->SetParallelScale(scene.scale * std::max(scene.parallelScale, 1e-3));
  camera->SetClippingRange(scene.scale * scene.clipping[0], scene.scale * scene.clipping[1]);
  renderer->SetActiveCamera(camera);
  return lights;
}

}
