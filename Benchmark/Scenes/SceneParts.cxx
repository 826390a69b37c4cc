#include "SceneParts.h"

#include <vtkAlgorithm.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace vtkshadows::scenes
{

namespace
{

vtkSmartPointer<vtkActor> AddActorOf(vtkRenderer* renderer, vtkPolyDataMapper* mapper)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  return actor;
}

}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> AddActor(vtkRenderer* renderer, vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  return AddActorOf(renderer, mapper);
}

vtkSmartPointer<vtkActor> AddActor(vtkRenderer* renderer, vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  return AddActorOf(renderer, mapper);
}

vtkSmartPointer<vtkActor> AddSmooth(vtkRenderer* renderer, vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SplittingOff();
  normals->ConsistencyOff();
  return AddActor(renderer, normals);
}

vtkSmartPointer<vtkActor> AddFloor(vtkRenderer* renderer, double halfSide, double height)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-halfSide, -halfSide, height);
  plane->SetPoint1(halfSide, -halfSide, height);
  plane->SetPoint2(-halfSide, halfSide, height);
  return AddActor(renderer, plane);
}

vtkSmartPointer<vtkActor> AddSphere(
  vtkRenderer* renderer, const glm::dvec3& centre, double radius, int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(centre.x, centre.y, centre.z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  return AddActor(renderer, sphere);
}

vtkSmartPointer<vtkActor> AddBox(
  vtkRenderer* renderer, const glm::dvec3& minimum, const glm::dvec3& maximum)
{
  vtkNew<vtkCubeSource> box;
  box->SetBounds(minimum.x, maximum.x, minimum.y, maximum.y, minimum.z, maximum.z);
  return AddActor(renderer, box);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLight> AddSun(vtkRenderer* renderer, const glm::dvec3& along)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetPosition(-along.x, -along.y, -along.z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->AddLight(light);
  return light;
}

vtkSmartPointer<vtkLight> AddSpot(
  vtkRenderer* renderer, const glm::dvec3& position, const glm::dvec3& focus, double cone)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->PositionalOn();
  light->SetPosition(position.x, position.y, position.z);
  light->SetFocalPoint(focus.x, focus.y, focus.z);
  light->SetConeAngle(cone);
  renderer->AddLight(light);
  return light;
}

vtkSmartPointer<vtkLight> AddLamp(vtkRenderer* renderer, const glm::dvec3& position)
{
  return AddSpot(renderer, position, glm::dvec3(0.0), 180.0);
}

//------------------------------------------------------------------------------
void LookAt(vtkRenderer* renderer, const glm::dvec3& position, const glm::dvec3& focus)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(position.x, position.y, position.z);
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
}

void AimCamera(vtkRenderer* renderer, const Subject& subject, double azimuth, double elevation,
  int width, int height)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double narrow = std::min(1.0, double(width) / height);
  const double half = glm::radians(0.5 * camera->GetViewAngle());
  const double distance = subject.radius / std::sin(std::atan(narrow * std::tan(half)));
  LookAt(renderer, subject.centre + distance * Toward(azimuth, elevation), subject.centre);
}

glm::dvec3 Toward(double azimuth, double elevation)
{
  const double a = glm::radians(azimuth), e = glm::radians(elevation);
  return { std::cos(e) * std::sin(a), -std::cos(e) * std::cos(a), std::sin(e) };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSurface(
  int uCells, int vCells, const std::function<glm::dvec3(double, double)>& position)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  for (int v = 0; v <= vCells; ++v)
  {
    for (int u = 0; u <= uCells; ++u)
    {
      const glm::dvec3 p = position(double(u) / uCells, double(v) / vCells);
      const vtkIdType id = points->InsertNextPoint(p.x, p.y, p.z);
      if (u > 0 && v > 0)
      {
        const vtkIdType below = id - (uCells + 1);
        polys->InsertNextCell({ below - 1, below, id });
        polys->InsertNextCell({ below - 1, id, id - 1 });
      }
    }
  }
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

vtkSmartPointer<vtkPolyData> MakeTriangles(
  const std::vector<glm::dvec3>& points, const std::vector<glm::ivec3>& triangles)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  places->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    places->SetPoint(static_cast<vtkIdType>(i), &points[i].x);
  }
  vtkNew<vtkCellArray> polys;
  polys->AllocateEstimate(static_cast<vtkIdType>(triangles.size()), 3);
  for (const glm::ivec3& corners : triangles)
  {
    polys->InsertNextCell({ corners.x, corners.y, corners.z });
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(places);
  mesh->SetPolys(polys);
  return mesh;
}

int ScaledCells(int cells, double detail, int fewest)
{
  return std::max(fewest, static_cast<int>(std::lround(cells * std::sqrt(detail))));
}

}
