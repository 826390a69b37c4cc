#include "TestScenes.h"

#include "ShadowTest.h"

#include <vtkActorCollection.h>
#include <vtkCellArray.h>
#include <vtkConeSource.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTubeFilter.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <stdexcept>

namespace shadowtest
{

namespace
{

const double Pi = std::acos(-1.0);

vtkSmartPointer<vtkActor> AddSmooth(vtkRenderer* renderer, vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SplittingOff();
  normals->ConsistencyOff();
  return AddActor(renderer, normals);
}

vtkSmartPointer<vtkPolyData> MakeTorus(double ring, double tube)
{
  return MakeSurface(96, 48,
    [=](double u, double v)
    {
      const double around = 2.0 * Pi * u, across = 2.0 * Pi * v;
      const double reach = ring + tube * std::cos(across);
      return glm::dvec3(
        reach * std::cos(around), reach * std::sin(around), tube * std::sin(across));
    });
}

double Bumps(const glm::dvec3& p)
{
  return 0.12 * std::sin(5.0 * p.x + 1.0) * std::sin(4.0 * p.y) * std::sin(6.0 * p.z + 0.5) +
    0.015 * std::sin(31.0 * p.x) * std::sin(29.0 * p.y + 0.3) * std::sin(37.0 * p.z);
}

vtkSmartPointer<vtkPolyData> ReadOff(const std::string& file)
{
  std::ifstream in(file);
  std::string magic;
  vtkIdType pointCount = 0, faceCount = 0, edgeCount = 0;
  in >> magic >> pointCount >> faceCount >> edgeCount;
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; in && i < pointCount; ++i)
  {
    double x, y, z;
    in >> x >> y >> z;
    points->InsertNextPoint(x, y, z);
  }
  vtkNew<vtkCellArray> faces;
  for (vtkIdType i = 0; in && i < faceCount; ++i)
  {
    int corners, a, b, c;
    in >> corners >> a >> b >> c;
    faces->InsertNextCell({ a, b, c });
  }
  if (!in || magic != "OFF" || faces->GetNumberOfCells() == 0)
  {
    throw std::runtime_error(file + " is no OFF file of triangles");
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(faces);
  return mesh;
}

vtkSmartPointer<vtkPolyData> MakeStrands(int count, int points)
{
  auto strands = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> where;
  vtkNew<vtkCellArray> lines;
  for (int strand = 0; strand < count; ++strand)
  {
    const double phase = 2.0 * Pi * strand / count;
    lines->InsertNextCell(points);
    for (int i = 0; i < points; ++i)
    {
      const double t = double(i) / (points - 1);
      // Wound so that neighbours come close and never touch, as streamlines do.
      const double angle = phase + 2.5 * Pi * t + 0.1 * std::sin(9.0 * t + 5.0 * phase);
      const double reach = 1.2 + 0.6 * std::sin(3.0 * t + 2.0 * phase);
      lines->InsertCellPoint(
        where->InsertNextPoint(reach * std::cos(angle), reach * std::sin(angle), 0.15 + 2.4 * t));
    }
  }
  strands->SetPoints(where);
  strands->SetLines(lines);
  return strands;
}

void AddGlyphs(vtkRenderer* renderer, int count)
{
  std::mt19937 random(7);
  const auto any = [&random](double low, double high)
  { return low + (high - low) * (random() / double(random.max())); };
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> directions;
  directions->SetName("direction");
  directions->SetNumberOfComponents(3);
  for (int i = 0; i < count; ++i)
  {
    points->InsertNextPoint(any(-2.2, 2.2), any(-2.2, 2.2), any(0.2, 2.8));
    directions->InsertNextTuple3(any(-1.0, 1.0), any(-1.0, 1.0), any(-1.0, 1.0));
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  places->GetPointData()->AddArray(directions);

  vtkNew<vtkConeSource> cone;
  cone->SetResolution(60);
  cone->SetHeight(1.0);
  cone->SetRadius(0.3);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceConnection(cone->GetOutputPort());
  mapper->SetOrientationArray("direction");
  mapper->SetScaleArray("direction");
  mapper->SetScaleModeToScaleByMagnitude();
  mapper->SetScaleFactor(0.12);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.6, 0.3);
  renderer->AddActor(actor);
}

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

//------------------------------------------------------------------------------
Subject AddStillLife(vtkRenderer* renderer)
{
  AddFloor(renderer, 6.0)->GetProperty()->SetColor(0.85, 0.85, 0.8);

  AddSphere(renderer, { -1.1, -0.9, 0.9 }, 0.9, 96)->GetProperty()->SetColor(0.8, 0.3, 0.25);

  auto torus = AddSmooth(renderer, MakeTorus(0.9, 0.32));
  torus->SetPosition(1.3, -0.9, 0.32);
  torus->GetProperty()->SetColor(0.3, 0.5, 0.8);

  vtkNew<vtkConeSource> source;
  source->SetHeight(2.4);
  source->SetRadius(0.8);
  source->SetResolution(64);
  source->SetDirection(0.0, 0.0, 1.0);
  auto cone = AddActor(renderer, source);
  cone->SetPosition(1.0, 1.3, 1.2);
  cone->GetProperty()->SetColor(0.9, 0.75, 0.3);

  auto box = AddBox(renderer, { -0.7, -0.6, 0.0 }, { 0.7, 0.6, 1.3 });
  box->RotateZ(25.0);
  box->SetPosition(-1.3, 1.3, 0.0);
  box->GetProperty()->SetColor(0.4, 0.7, 0.4);
  return { { 0.0, 0.0, 0.8 }, 2.6 };
}

Subject AddBumpyMesh(vtkRenderer* renderer)
{
  AddFloor(renderer, 5.0)->GetProperty()->SetColor(0.85, 0.85, 0.8);
  auto mesh = MakeSurface(240, 240,
    [](double u, double v)
    {
      const double azimuth = 2.0 * Pi * u, down = Pi * v;
      const glm::dvec3 p(
        std::sin(down) * std::cos(azimuth), std::sin(down) * std::sin(azimuth), -std::cos(down));
      return glm::dvec3(0.0, 0.0, 1.15) + (1.0 + Bumps(p)) * p;
    });
  AddSmooth(renderer, mesh)->GetProperty()->SetColor(0.8, 0.65, 0.5);
  return { { 0.0, 0.0, 1.0 }, 1.5 };
}

Subject AddScannedMesh(vtkRenderer* renderer, const std::string& file)
{
  const vtkSmartPointer<vtkPolyData> mesh = ReadOff(file);
  // Turned from y up to z up, to a height of about 2.
  const double* bounds = mesh->GetBounds();
  const double scale = 2.0 / (bounds[3] - bounds[2]);
  auto actor = AddSmooth(renderer, mesh);
  actor->SetScale(scale);
  actor->RotateX(90.0);
  actor->SetPosition(-0.5 * scale * (bounds[0] + bounds[1]), 0.5 * scale * (bounds[4] + bounds[5]),
    -scale * bounds[2]);
  actor->GetProperty()->SetColor(0.8, 0.7, 0.6);
  AddFloor(renderer, 5.0)->GetProperty()->SetColor(0.85, 0.85, 0.8);
  return { { 0.0, 0.0, 0.95 }, 1.05 };
}

Subject AddTubesAndGlyphs(vtkRenderer* renderer)
{
  AddFloor(renderer, 6.0)->GetProperty()->SetColor(0.85, 0.85, 0.8);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(MakeStrands(40, 300));
  tubes->SetRadius(0.02);
  tubes->SetNumberOfSides(8);
  AddActor(renderer, tubes)->GetProperty()->SetColor(0.4, 0.6, 0.8);
  AddGlyphs(renderer, 1200);
  return { { 0.0, 0.0, 1.3 }, 2.4 };
}

//------------------------------------------------------------------------------
void PlaceActors(vtkRenderer* renderer, vtkTransform* worldFromScene, bool byActor)
{
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    if (byActor)
    {
      actor->SetUserTransform(worldFromScene);
      continue;
    }
    vtkNew<vtkTransform> worldFromModel;
    worldFromModel->Concatenate(worldFromScene);
    worldFromModel->Concatenate(actor->GetMatrix());
    vtkNew<vtkTransformPolyDataFilter> move;
    move->SetInputConnection(actor->GetMapper()->GetInputConnection(0, 0));
    move->SetTransform(worldFromModel);
    move->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    actor->GetMapper()->SetInputConnection(move->GetOutputPort());
    actor->SetPosition(0.0, 0.0, 0.0);
    actor->SetOrientation(0.0, 0.0, 0.0);
    actor->SetScale(1.0, 1.0, 1.0);
  }
}

//------------------------------------------------------------------------------
glm::dvec3 Toward(double azimuth, double elevation)
{
  const double a = glm::radians(azimuth), e = glm::radians(elevation);
  return { std::cos(e) * std::sin(a), -std::cos(e) * std::cos(a), std::sin(e) };
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

//------------------------------------------------------------------------------
LotScene AddSceneByLot(vtkRenderer* renderer, int seed, double lowest, int width, int height)
{
  std::mt19937 random(seed);
  const auto any = [&random](double low, double high)
  { return low + (high - low) * (random() / double(random.max())); };
  renderer->RemoveAllViewProps();
  renderer->RemoveAllLights();
  const char* names[] = { "still life", "bumpy mesh", "tubes and glyphs" };
  const int kind = seed % 3;
  const Subject subject = kind == 0 ? AddStillLife(renderer)
    : kind == 1                     ? AddBumpyMesh(renderer)
                                    : AddTubesAndGlyphs(renderer);
  const glm::dvec3 toward = Toward(any(0.0, 360.0), any(lowest, 80.0));
  if (any(0.0, 1.0) < 0.5)
  {
    AddSun(renderer, -toward);
  }
  else
  {
    AddSpot(renderer, subject.centre + any(2.0, 5.0) * subject.radius * toward, subject.centre,
      any(25.0, 50.0));
  }
  AimCamera(renderer, subject, any(0.0, 360.0), any(10.0, 70.0), width, height);
  return { names[kind], kind };
}

}
