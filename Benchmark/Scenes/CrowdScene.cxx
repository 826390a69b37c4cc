#include "SceneList.h"

#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace vtkshadows::scenes
{

namespace
{

const double Pi = std::acos(-1.0);
constexpr int Around = 24, Upward = 40;

// A figure turned on a lathe, 1.7 m high: what the radius is at each height.
double Girth(double height)
{
  const double body = 0.26 * std::sqrt(std::max(0.0, 1.0 - std::pow((height - 0.62) / 0.66, 2.0)));
  const double foot = 0.24 * std::sqrt(std::max(0.0, 1.0 - std::pow((height - 0.06) / 0.06, 2.0)));
  const double head = std::sqrt(std::max(0.0, 0.0196 - std::pow(height - 1.56, 2.0)));
  const double neck = height > 1.2 && height < 1.5 ? 0.06 : 0.0;
  return std::max({ body, foot, head, neck });
}

vtkSmartPointer<vtkPolyData> MakeFigure()
{
  return MakeSurface(Around, Upward,
    [](double u, double v)
    {
      // Finer where the figure ends, above and below.
      const double height = 0.85 * (1.0 - std::cos(Pi * v));
      const double girth = Girth(height), angle = 2.0 * Pi * u;
      return glm::dvec3(girth * std::cos(angle), girth * std::sin(angle), height);
    });
}

}

// Metres. All figures are instances of one mesh, as vtkGlyph3DMapper draws them.
void MakeCrowd(SceneInMaking& scene)
{
  constexpr double Pitch = 0.9;
  const vtkIdType each = 2 * Around * Upward;
  const vtkIdType figures = std::max<vtkIdType>(1, scene.size.triangles / each);
  const vtkIdType rows = static_cast<vtkIdType>(std::ceil(std::sqrt(double(figures))));
  const double half = 0.5 * Pitch * static_cast<double>(rows);
  Lot any(11);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> heights;
  heights->SetName("height");
  for (vtkIdType i = 0; i < figures; ++i)
  {
    const double row = static_cast<double>(i / rows), column = static_cast<double>(i % rows);
    points->InsertNextPoint(
      Pitch * (column + any(0.3, 0.7)) - half, Pitch * (row + any(0.3, 0.7)) - half, 0.0);
    heights->InsertNextValue(static_cast<float>(any(0.85, 1.15)));
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  places->GetPointData()->AddArray(heights);

  vtkNew<vtkPolyDataNormals> figure;
  figure->SetInputData(MakeFigure());
  figure->SplittingOff();
  figure->ConsistencyOff();
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceConnection(figure->GetOutputPort());
  mapper->SetScaleArray("height");
  mapper->SetScaleModeToScaleByMagnitude();
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.75, 0.6, 0.5);
  scene.renderer->AddActor(actor);
  AddFloor(scene.renderer, half + 2.0)->GetProperty()->SetColor(0.8, 0.8, 0.78);

  scene.facts.closedCasters = true;
  scene.facts.planes = 1;
  scene.facts.facts.push_back({ "figures", static_cast<double>(figures), "" });
  scene.facts.facts.push_back({ "triangles of a figure", static_cast<double>(each), "" });
  scene.Add(AddSun(scene.renderer, -Toward(-60.0, 35.0)), 0.00465);
  scene.Show({ { 0.0, 0.0, 0.8 }, std::max(1.2, 0.9 * half) }, 20.0, 22.0);
}

}
