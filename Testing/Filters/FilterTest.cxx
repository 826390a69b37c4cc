#include "FilterTest.h"

#include <vtkArrowSource.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkDiskSource.h>
#include <vtkExecutive.h>
#include <vtkIdList.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkSphereSource.h>
#include <vtkSuperquadricSource.h>
#include <vtkTextSource.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

namespace filtertest
{
namespace
{

template <typename Source>
NamedMesh Made(const char* name, Source* source)
{
  source->Update();
  return { name, source->GetOutput() };
}

void Collect(vtkObject*, unsigned long, void* messages, void* message)
{
  static_cast<std::vector<std::string>*>(messages)->emplace_back(static_cast<char*>(message));
}

}

vtkSmartPointer<vtkPolyData> ToPolyData(const TestMesh& mesh, int pointType)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(pointType);
  for (const glm::dvec3& p : mesh.points)
  {
    points->InsertNextPoint(p.x, p.y, p.z);
  }
  vtkNew<vtkCellArray> cells;
  for (const glm::uvec3& t : mesh.triangles)
  {
    const vtkIdType corners[3] = { t.x, t.y, t.z };
    cells->InsertNextCell(3, corners);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

vtkSmartPointer<vtkPolyData> UnitSphere(int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetPhiResolution(resolution);
  sphere->SetThetaResolution(resolution);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  return sphere->GetOutput();
}

vtkSmartPointer<vtkPolyData> OneOfEachCell()
{
  TestMesh mesh{ "", {}, {} };
  for (int i = 0; i < 9; ++i)
  {
    mesh.points.emplace_back(i / 2, i % 2, 0.0);
  }
  mesh.points[7] = { 1.0, 2.0, 0.0 };
  auto data = ToPolyData(mesh, VTK_DOUBLE);
  const vtkIdType vertex[] = { 8 }, line[] = { 0, 1 }, quad[] = { 0, 2, 3, 1 },
                  strip[] = { 2, 4, 3, 5, 7 };
  vtkNew<vtkCellArray> vertices, lines, polygons, strips;
  vertices->InsertNextCell(1, vertex);
  lines->InsertNextCell(2, line);
  polygons->InsertNextCell(4, quad);
  strips->InsertNextCell(5, strip);
  data->SetVerts(vertices);
  data->SetLines(lines);
  data->SetPolys(polygons);
  data->SetStrips(strips);
  return data;
}

std::vector<NamedMesh> SourceMeshes()
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkCylinderSource> cylinder;
  vtkNew<vtkConeSource> cone;
  vtkNew<vtkArrowSource> arrow;
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(5, 4);
  vtkNew<vtkDiskSource> disk;
  vtkNew<vtkTextSource> text;
  text->SetText("cow");
  vtkNew<vtkSuperquadricSource> torus, star;
  torus->ToroidalOn();
  star->SetPhiRoundness(2.5);
  star->SetThetaRoundness(3.0);
  cylinder->SetResolution(11);
  return { { "sphere", UnitSphere(16) }, Made("cube", cube.Get()), Made("cylinder", cylinder.Get()),
    Made("cone", cone.Get()), Made("arrow", arrow.Get()), Made("plane", plane.Get()),
    Made("disk", disk.Get()), Made("text", text.Get()), Made("superquadric torus", torus.Get()),
    Made("superquadric star", star.Get()), { "one of each cell", OneOfEachCell() } };
}

std::vector<NamedMesh> AllMeshes()
{
  std::vector<NamedMesh> meshes = SourceMeshes();
  for (const TestMesh& mesh : SmallMeshes())
  {
    meshes.push_back({ mesh.name, ToPolyData(mesh, VTK_DOUBLE) });
    meshes.push_back({ mesh.name + " in float", ToPolyData(mesh, VTK_FLOAT) });
  }
  meshes.push_back({ "large soup", ToPolyData(Soup(10000, 500), VTK_DOUBLE) });
  return meshes;
}

glm::dvec3 PointOf(vtkPolyData* mesh, vtkIdType id)
{
  glm::dvec3 point;
  mesh->GetPoint(id, &point.x);
  return point;
}

std::vector<Corners> TrianglesOf(vtkPolyData* mesh)
{
  std::vector<Corners> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    for (vtkIdType i = 1; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      triangles.push_back({ ids->GetId(0), ids->GetId(i), ids->GetId(i + 1) });
    }
  }
  return triangles;
}

bool CellHolds(vtkPolyData* mesh, vtkIdType cell, const glm::dvec3& p)
{
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(cell, ids);
  return std::any_of(
    ids->begin(), ids->end(), [&](vtkIdType id) { return PointOf(mesh, id) == p; });
}

double ArrayValue(vtkDataArray* array, vtkIdType index)
{
  if (!array)
  {
    ADD_FAILURE() << "there is no such array";
    return 0.0;
  }
  return array->GetTuple1(index);
}

double CellValue(vtkPolyData* mesh, const char* name, vtkIdType cell)
{
  return ArrayValue(mesh->GetCellData()->GetArray(name), cell);
}

double PointValue(vtkPolyData* mesh, const char* name, vtkIdType point)
{
  return ArrayValue(mesh->GetPointData()->GetArray(name), point);
}

std::size_t CountOpenEdges(vtkPolyData* mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> incidence;
  for (const Corners& t : TrianglesOf(mesh))
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const vtkIdType from = t[corner], to = t[(corner + 1) % 3];
      incidence[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  return std::count_if(
    incidence.begin(), incidence.end(), [](const auto& edge) { return edge.second != 0; });
}

double SignedVolume(vtkPolyData* mesh)
{
  double sum = 0.0;
  for (const Corners& t : TrianglesOf(mesh))
  {
    sum += glm::dot(PointOf(mesh, t[0]), glm::cross(PointOf(mesh, t[1]), PointOf(mesh, t[2])));
  }
  return sum / 6.0;
}

int CountCrossings(
  vtkPolyData* mesh, const glm::dvec3& p, const glm::dvec3& d, double end, bool signedCount)
{
  int count = 0;
  for (const Corners& corners : TrianglesOf(mesh))
  {
    const glm::dvec3 a = PointOf(mesh, corners[0]) - p, b = PointOf(mesh, corners[1]) - p,
                     c = PointOf(mesh, corners[2]) - p;
    const double u = glm::dot(d, glm::cross(a, b));
    const double v = glm::dot(d, glm::cross(b, c));
    const double w = glm::dot(d, glm::cross(c, a));
    const bool isFront = u > 0 && v > 0 && w > 0;
    const bool isBack = u < 0 && v < 0 && w < 0;
    const double t = glm::dot(a, glm::cross(b, c)) / (u + v + w);
    if ((isFront || isBack) && t > 0 && t < end)
    {
      count += signedCount && isBack ? -1 : 1;
    }
  }
  return count;
}

Errors::Errors(vtkAlgorithm* algorithm)
  : Algorithm(algorithm)
{
  this->OwnCommand->SetCallback(Collect);
  this->OwnCommand->SetClientData(&this->Own);
  this->ExecutiveCommand->SetCallback(Collect);
  this->ExecutiveCommand->SetClientData(&this->Executives);
  this->WarningCommand->SetCallback(Collect);
  this->WarningCommand->SetClientData(&this->Warnings);
  algorithm->AddObserver(vtkCommand::ErrorEvent, this->OwnCommand);
  algorithm->AddObserver(vtkCommand::WarningEvent, this->WarningCommand);
  algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->ExecutiveCommand);
}

Errors::~Errors()
{
  this->Algorithm->RemoveObserver(this->OwnCommand);
  this->Algorithm->RemoveObserver(this->WarningCommand);
  this->Algorithm->GetExecutive()->RemoveObserver(this->ExecutiveCommand);
}

}
