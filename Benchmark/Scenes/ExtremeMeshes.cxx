#include "ExtremeMeshes.h"

#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSphereSource.h>
#include <vtkSuperquadricSource.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace vtkshadows
{
namespace
{

template <typename Source>
vtkSmartPointer<vtkPolyData> OutputOf(Source& source)
{
  source->Update();
  return source->GetOutput();
}

}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Moved(vtkPolyData* mesh, const glm::dmat4& to)
{
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    const glm::dvec4 at = to * glm::dvec4(p[0], p[1], p[2], 1.0);
    points->SetPoint(i, at.x, at.y, at.z);
  }
  moved->SetPoints(points);
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  if (!normals)
  {
    return moved;
  }
  const glm::dmat3 turn = glm::inverseTranspose(glm::dmat3(to));
  vtkNew<vtkFloatArray> turned;
  turned->SetNumberOfComponents(3);
  turned->SetNumberOfTuples(normals->GetNumberOfTuples());
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    double n[3];
    normals->GetTuple(i, n);
    const glm::dvec3 at = glm::normalize(turn * glm::dvec3(n[0], n[1], n[2]));
    turned->SetTuple3(i, at.x, at.y, at.z);
  }
  moved->GetPointData()->SetNormals(turned);
  return moved;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeRectangle(
  const glm::dvec3& corner, const glm::dvec3& right, const glm::dvec3& up)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->SetOrigin(corner.x, corner.y, corner.z);
  plane->SetPoint1(right.x, right.y, right.z);
  plane->SetPoint2(up.x, up.y, up.z);
  return OutputOf(plane);
}

vtkSmartPointer<vtkPolyData> MakeFloor(double half, double height)
{
  return MakeRectangle({ -half, -half, height }, { half, -half, height }, { -half, half, height });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeBall(const glm::dvec3& centre, double radius, int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(centre.x, centre.y, centre.z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  return Moved(OutputOf(sphere), glm::dmat4(1.0));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeBox()
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(-0.7, 0.7, -0.6, 0.6, 0.0, 1.3);
  const glm::dmat4 one(1.0);
  return Moved(OutputOf(cube),
    glm::rotate(glm::translate(one, glm::dvec3(-1.3, 1.3, 0.0)), glm::radians(25.0),
      glm::dvec3(0.0, 0.0, 1.0)));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakePillar()
{
  vtkNew<vtkCylinderSource> cylinder; // along y
  cylinder->SetHeight(2.4);
  cylinder->SetRadius(0.4);
  cylinder->SetResolution(48);
  const glm::dmat4 one(1.0);
  return Moved(OutputOf(cylinder),
    glm::rotate(glm::translate(one, glm::dvec3(1.2, 1.3, 1.2)), glm::radians(90.0),
      glm::dvec3(1.0, 0.0, 0.0)));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeRing()
{
  vtkNew<vtkSuperquadricSource> torus;
  torus->ToroidalOn();
  torus->SetThickness(0.35);
  torus->SetSize(1.1);
  torus->SetThetaResolution(64);
  torus->SetPhiResolution(32);
  const glm::dmat4 one(1.0);
  return Moved(OutputOf(torus),
    glm::rotate(glm::translate(one, glm::dvec3(1.3, -0.9, 1.3)), glm::radians(35.0),
      glm::normalize(glm::dvec3(1.0, 0.4, 0.2))));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> WithTriangles(vtkPolyData* mesh, const std::vector<glm::dvec3>& more,
  const std::vector<std::array<vtkIdType, 3>>& triangles)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(mesh);
  vtkDataArray* normals = copy->GetPointData()->GetNormals();
  for (const glm::dvec3& p : more)
  {
    copy->GetPoints()->InsertNextPoint(p.x, p.y, p.z);
    if (normals)
    {
      normals->InsertNextTuple3(0.0, 0.0, 1.0);
    }
  }
  vtkNew<vtkCellArray> polys; // its own: of a mesh of strips alone VTK hands out one that is shared
  polys->DeepCopy(copy->GetPolys());
  for (const std::array<vtkIdType, 3>& t : triangles)
  {
    polys->InsertNextCell(3, t.data());
  }
  copy->SetPolys(polys);
  return copy;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSlivers(const glm::dvec3& centre, double width, int count)
{
  auto wall = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  for (int i = 0; i < count; ++i)
  {
    // Each from a little before the end of the last, so that it is a wall.
    const double x = centre.x + width * (i - 0.5 * count), y = centre.y;
    const vtkIdType first = points->InsertNextPoint(x, y, centre.z - 0.5);
    points->InsertNextPoint(x + width, y, centre.z - 0.5);
    points->InsertNextPoint(x + width, y, centre.z + 0.5);
    points->InsertNextPoint(x, y, centre.z + 0.5);
    polys->InsertNextCell({ first, first + 1, first + 2 });
    polys->InsertNextCell({ first, first + 2, first + 3 });
  }
  wall->SetPoints(points);
  wall->SetPolys(polys);
  return wall;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeFan(double half, double step)
{
  auto floor = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  points->InsertNextPoint(-half, -half, 0.0);
  points->InsertNextPoint(half, -half, 0.0);
  for (int i = 0; i < 500; ++i)
  {
    points->InsertNextPoint(half, (-0.2 + step * i) * half, 0.0);
  }
  points->InsertNextPoint(half, half, 0.0);
  points->InsertNextPoint(-half, half, 0.0);
  for (vtkIdType i = 1; i + 1 < points->GetNumberOfPoints(); ++i)
  {
    polys->InsertNextCell({ vtkIdType(0), i, i + 1 });
  }
  floor->SetPoints(points);
  floor->SetPolys(polys);
  return floor;
}

}
