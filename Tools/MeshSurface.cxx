#include "MeshSurface.h"

#include "Failure.h"
#include "VolumeContour.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cmath>

namespace vtkshadows
{
namespace
{

// A mesh's extent outside of this leaves the range of the floats that it is drawn with.
constexpr double SmallestExtent = 1e-30;
constexpr double LargestExtent = 1e30;

vtkSmartPointer<vtkPolyData> SurfaceOfDataSet(
  vtkDataSet* data, const std::string& path, std::optional<double> isovalue)
{
  if (IsVolume(data))
  {
    return ContourOf(data, path, isovalue);
  }
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    return mesh;
  }
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(data);
  surface->Update();
  return surface->GetOutput();
}

vtkSmartPointer<vtkPolyData> SurfaceOfComposite(
  vtkCompositeDataSet* composite, const std::string& path, std::optional<double> isovalue)
{
  vtkNew<vtkAppendPolyData> append;
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    auto* leaf = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject());
    if (leaf && leaf->GetNumberOfPoints() > 0)
    {
      append->AddInputData(SurfaceOfDataSet(leaf, path, isovalue));
    }
  }
  if (append->GetNumberOfInputConnections(0) == 0)
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  append->Update();
  return append->GetOutput();
}

void RequireFinitePoints(vtkPolyData* mesh, const std::string& path)
{
  vtkIdType bad = 0;
  vtkIdType first = -1;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double position[3];
    mesh->GetPoint(i, position);
    if (!std::all_of(position, position + 3, [](double x) { return std::isfinite(x); }))
    {
      first = bad++ == 0 ? i : first;
    }
  }
  if (bad > 0)
  {
    throw Failure("input", path,
      std::to_string(bad) + " of its points are not finite (NaN or infinite), the first is point " +
        std::to_string(first),
      "remove or repair them");
  }
}

// Triangles alone, without the data that would colour, hide or blank them.
vtkSmartPointer<vtkPolyData> TrianglesOf(vtkPolyData* mesh)
{
  vtkNew<vtkPolyData> faces;
  faces->SetPoints(mesh->GetPoints());
  faces->SetPolys(mesh->GetPolys());
  faces->SetStrips(mesh->GetStrips());
  faces->GetPointData()->SetNormals(mesh->GetPointData()->GetNormals());

  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(faces);
  triangulate->PassLinesOff();
  triangulate->PassVertsOff();

  // Points of no triangle would count as scene when the camera and the floor are placed.
  vtkNew<vtkCleanPolyData> compact;
  compact->SetInputConnection(triangulate->GetOutputPort());
  compact->PointMergingOff();
  compact->ConvertPolysToLinesOff();
  compact->ConvertLinesToPointsOff();
  compact->Update();
  return compact->GetOutput();
}

void RequireExtent(vtkPolyData* mesh, const std::string& path)
{
  const double extent = mesh->GetLength();
  if (extent == 0.0)
  {
    throw Failure("input", path, "all its points are one point", "give it an extent");
  }
  if (!(extent >= SmallestExtent && extent <= LargestExtent))
  {
    throw Failure("input", path, "its extent of " + ToText(extent) + " leaves the range of floats",
      "scale it to between 1e-30 and 1e30");
  }
}

}

vtkSmartPointer<vtkPolyData> SurfaceOf(
  vtkDataObject* data, const std::string& path, std::optional<double> isovalue)
{
  vtkSmartPointer<vtkPolyData> surface;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    surface = SurfaceOfComposite(composite, path, isovalue);
  }
  else if (auto* single = vtkDataSet::SafeDownCast(data))
  {
    surface = SurfaceOfDataSet(single, path, isovalue);
  }
  else
  {
    throw Failure("input", path, std::string("holds a ") + data->GetClassName() + ", not a mesh",
      "give a file of polygons, of a grid or of an image");
  }

  if (surface->GetNumberOfPoints() == 0)
  {
    throw Failure("input", path, "is an empty mesh: it has no points", "leave it out");
  }
  RequireFinitePoints(surface, path);
  const vtkSmartPointer<vtkPolyData> triangles = TrianglesOf(surface);
  if (triangles->GetNumberOfPolys() == 0)
  {
    throw Failure("input", path,
      "has no faces to draw, only " + std::to_string(surface->GetNumberOfPoints()) + " points",
      "give it polygons, or leave it out");
  }
  RequireExtent(triangles, path);
  return triangles;
}

}
