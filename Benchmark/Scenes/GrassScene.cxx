#include "SceneList.h"

#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cmath>

namespace vtkshadows::scenes
{

namespace
{

// Joints of a blade, from its foot to its tip: five triangles.
constexpr int Joints = 3;

void AppendBlade(
  Lot& any, double half, std::vector<glm::dvec3>& points, std::vector<glm::ivec3>& triangles)
{
  const glm::dvec3 foot(any(-half, half), any(-half, half), 0.0);
  const double turn = any(0.0, 2.0 * std::acos(-1.0)), height = any(0.08, 0.22);
  const double width = any(0.002, 0.004), bend = any(0.02, 0.12);
  const glm::dvec3 across(std::cos(turn), std::sin(turn), 0.0);
  const glm::dvec3 forth(-across.y, across.x, 0.0);
  const int first = static_cast<int>(points.size());
  for (int joint = 0; joint < Joints; ++joint)
  {
    const double t = double(joint) / Joints;
    const glm::dvec3 middle = foot + t * t * bend * forth + glm::dvec3(0.0, 0.0, t * height);
    const glm::dvec3 aside = 0.5 * width * (1.0 - 0.5 * t) * across;
    points.push_back(middle - aside);
    points.push_back(middle + aside);
    if (joint > 0)
    {
      const int at = first + 2 * joint;
      triangles.emplace_back(at - 2, at - 1, at + 1);
      triangles.emplace_back(at - 2, at + 1, at);
    }
  }
  points.push_back(foot + bend * forth + glm::dvec3(0.0, 0.0, height));
  const int tip = static_cast<int>(points.size()) - 1;
  triangles.emplace_back(tip - 2, tip - 1, tip);
}

}

// Metres. Blades are open sheets, 20 to 110 times as long as they are wide.
void MakeGrass(SceneInMaking& scene)
{
  constexpr double Half = 1.0;
  const int blades = ScaledCells(30'000, scene.size.detail * scene.size.detail, 1);
  Lot any(3);
  std::vector<glm::dvec3> points;
  std::vector<glm::ivec3> triangles;
  for (int i = 0; i < blades; ++i)
  {
    AppendBlade(any, Half, points, triangles);
  }
  AddActor(scene.renderer, MakeTriangles(points, triangles))
    ->GetProperty()
    ->SetColor(0.45, 0.65, 0.3);
  AddFloor(scene.renderer, 1.5 * Half)->GetProperty()->SetColor(0.55, 0.45, 0.35);
  AddSphere(scene.renderer, { 0.1, -0.1, 0.2 }, 0.2, 64)->GetProperty()->SetColor(0.85, 0.8, 0.75);

  scene.facts.planes = 1;
  scene.facts.facts.push_back({ "blades", double(blades), "" });
  scene.Add(AddSun(scene.renderer, -Toward(-60.0, 35.0)), 0.00465);
  scene.Show({ { 0.0, 0.0, 0.1 }, 0.85 * Half }, 10.0, 30.0);
}

}
