#include "ExtremeCaseList.h"
#include "ExtremeMeshes.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <limits>

namespace vtkshadows
{

void AddMeshes(ExtremeCaseList& cases)
{
  for (const double aspect : { 1e2, 1e4, 1e6 })
  {
    cases.Add("slivers of aspect", Text(aspect), false,
      [=](ExtremeScene& scene)
      {
        scene.parts[Box].mesh =
          MakeSlivers({ -1.3, 0.6, 0.9 }, 1.0 / aspect, static_cast<int>(std::min(aspect, 4096.0)));
      });
  }
  cases.Add("fan of slivers", "1e6", true,
    [](ExtremeScene& scene) { scene.parts[Floor].mesh = MakeFan(FloorHalf, 2e-6); });
  cases.Add("triangles of no area", "a third of all", true,
    [](ExtremeScene& scene)
    {
      for (std::size_t i = Ball; i <= Ring; ++i)
      {
        vtkPolyData* mesh = scene.parts[i].mesh;
        std::vector<std::array<vtkIdType, 3>> none;
        for (vtkIdType p = 0; p + 2 < mesh->GetNumberOfPoints(); p += 3)
        {
          none.push_back({ p, p, p + 1 });
          none.push_back({ p, p, p });
        }
        scene.parts[i].mesh = WithTriangles(mesh, {}, none);
      }
    });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  cases.Add("coordinates", "NaN", false,
    [=](ExtremeScene& scene)
    {
      vtkPolyData* ball = scene.parts[Ball].mesh;
      const vtkIdType next = ball->GetNumberOfPoints();
      scene.parts[Ball].mesh = WithTriangles(ball, { glm::dvec3(nan) }, { { 0, 1, next } });
    });
  cases.Add("coordinates", "NaN, one in a hundred", false,
    [=](ExtremeScene& scene)
    {
      vtkPolyData* ball = scene.parts[Ball].mesh;
      for (vtkIdType p = 7; p < ball->GetNumberOfPoints(); p += 100)
      {
        ball->GetPoints()->SetPoint(p, nan, nan, nan);
      }
    });
  cases.Add("coordinates", "infinite", false,
    [=](ExtremeScene& scene)
    {
      vtkPolyData* ball = scene.parts[Ball].mesh;
      const vtkIdType next = ball->GetNumberOfPoints();
      scene.parts[Ball].mesh = WithTriangles(ball, { { infinity, 0.0, 0.0 } }, { { 0, 1, next } });
    });
  for (const double far : { 1e12, 1e30 })
  {
    cases.Add("coordinates", (far < 1e20 ? "1e12" : "1e30") + std::string(" among others"), false,
      [=](ExtremeScene& scene)
      {
        vtkPolyData* ball = scene.parts[Ball].mesh;
        const vtkIdType next = ball->GetNumberOfPoints();
        scene.parts[Ball].mesh = WithTriangles(ball, { { 0.0, 0.0, far } }, { { 0, 1, next } });
      });
  }
  cases.Add("triangles", "0", false,
    [](ExtremeScene& scene)
    {
      for (ExtremePart& part : scene.parts)
      {
        part.mesh = vtkSmartPointer<vtkPolyData>::New();
      }
    });
  cases.Add("triangles", "1", false,
    [](ExtremeScene& scene)
    {
      auto empty = vtkSmartPointer<vtkPolyData>::New();
      vtkNew<vtkPoints> none;
      none->SetDataTypeToDouble();
      empty->SetPoints(none);
      vtkNew<vtkCellArray> polys;
      empty->SetPolys(polys);
      scene.parts.resize(2);
      scene.parts[Ball].mesh = WithTriangles(
        empty, { { -1.0, 0.0, 1.0 }, { 1.0, 0.2, 1.4 }, { 0.0, 0.5, 1.9 } }, { { 0, 1, 2 } });
    });
  cases
    .Add("triangles", "20 million", false,
      [](ExtremeScene& scene) { scene.parts[Ball].mesh = MakeBall(BallCentre, BallRadius, 3164); })
    .isHeavy = true;
}

}
