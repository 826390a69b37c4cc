#include "SceneList.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <glm/geometric.hpp>

namespace vtkshadows::scenes
{

namespace
{

void AddWall(vtkRenderer* renderer, const glm::dvec3& corner, const glm::dvec3& along,
  const glm::dvec3& up, const glm::dvec3& color)
{
  const glm::dvec3 first = corner + along, second = corner + up;
  vtkNew<vtkPlaneSource> wall;
  wall->SetOrigin(corner.x, corner.y, corner.z);
  wall->SetPoint1(first.x, first.y, first.z);
  wall->SetPoint2(second.x, second.y, second.z);
  AddActor(renderer, wall)->GetProperty()->SetColor(color.x, color.y, color.z);
}

}

// Metres. Everything, the eye included, is in the room, so the light's shadows go all ways.
void MakeClosedBox(SceneInMaking& scene)
{
  constexpr double Half = 2.0, Ceiling = 3.0, LampHeight = 2.4;
  vtkRenderer* renderer = scene.renderer;
  const glm::dvec3 x(2.0 * Half, 0.0, 0.0), y(0.0, 2.0 * Half, 0.0), z(0.0, 0.0, Ceiling);
  const glm::dvec3 low(-Half, -Half, 0.0), white(0.85, 0.84, 0.8);
  AddWall(renderer, low, x, y, { 0.7, 0.6, 0.5 });
  AddWall(renderer, low + z, y, x, white);
  AddWall(renderer, low, z, x, white);
  AddWall(renderer, low + y, x, z, white);
  AddWall(renderer, low, y, z, { 0.8, 0.45, 0.4 });
  AddWall(renderer, low + x, z, y, { 0.45, 0.65, 0.45 });

  const int cells = ScaledCells(64, scene.size.detail, 8);
  AddSphere(renderer, { 0.7, 0.8, 0.5 }, 0.5, cells)->GetProperty()->SetColor(0.8, 0.8, 0.85);
  auto table = AddBox(renderer, { -0.5, -0.4, 0.0 }, { 0.5, 0.4, 0.7 });
  table->SetPosition(-0.9, 0.7, 0.0);
  table->RotateZ(20.0);
  table->GetProperty()->SetColor(0.75, 0.65, 0.4);
  AddSphere(renderer, { -0.9, 0.7, 0.95 }, 0.25, cells)->GetProperty()->SetColor(0.4, 0.55, 0.8);
  // Near the lamp, so that its shadow is large.
  AddSphere(renderer, { 0.55, 0.3, 2.0 }, 0.12, cells)->GetProperty()->SetColor(0.9, 0.7, 0.3);

  scene.facts.closedCasters = true;
  scene.facts.planes = 12;
  scene.facts.facts.push_back({ "lamp below ceiling", Ceiling - LampHeight, "m" });
  scene.Add(AddLamp(renderer, { 0.2, 0.1, LampHeight }), 0.08);
  scene.facts.centre = { 0.0, 0.0, 0.5 * Ceiling };
  scene.facts.radius = glm::length(glm::dvec3(Half, Half, 0.5 * Ceiling));
  renderer->GetActiveCamera()->SetViewAngle(60.0);
  LookAt(renderer, { 1.2, -1.9, 1.9 }, { -0.1, 0.8, 0.9 });
}

}
