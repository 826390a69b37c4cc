// Shared by the tests of Filters: meshes as polydata, and what is asked of a filter's output.
#ifndef FilterTest_h
#define FilterTest_h

#include "ShadowMeshes.h"

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

namespace filtertest
{

using Corners = std::array<vtkIdType, 3>;

vtkSmartPointer<vtkPolyData> ToPolyData(const TestMesh& mesh, int pointType);

// Bodies, sheets and rough shapes that VTK's sources make: some with seams, caps that are apart,
// quads and larger polygons.
struct NamedMesh
{
  std::string name;
  vtkSmartPointer<vtkPolyData> mesh;
};
std::vector<NamedMesh> SourceMeshes();
// Those, and all of Testing/Core/ShadowMeshes.h.
std::vector<NamedMesh> AllMeshes();

vtkSmartPointer<vtkPolyData> UnitSphere(int resolution);
// Vertex, line, quad, strip of three triangles: cells 0 to 3.
vtkSmartPointer<vtkPolyData> OneOfEachCell();

glm::dvec3 PointOf(vtkPolyData* mesh, vtkIdType id);
std::vector<Corners> TrianglesOf(vtkPolyData* mesh); // polygons only, as fans
// Whether one of the cell's points has these coordinates.
bool CellHolds(vtkPolyData* mesh, vtkIdType cell, const glm::dvec3& p);
double ArrayValue(vtkDataArray* array, vtkIdType index); // fails the test if there is no array
double CellValue(vtkPolyData* mesh, const char* name, vtkIdType cell);
double PointValue(vtkPolyData* mesh, const char* name, vtkIdType point);

// How many edges have more triangles running one way than the other; by the indices of points.
std::size_t CountOpenEdges(vtkPolyData* mesh);
// Of a closed surface.
double SignedVolume(vtkPolyData* mesh);
// Sum over the triangles that the ray p + t * d, 0 < t < end, crosses: +1 from back to front, -1
// from front to back; or, `unsigned`, +1 each.
int CountCrossings(
  vtkPolyData* mesh, const glm::dvec3& p, const glm::dvec3& d, double end, bool signedCount);

// Collects the errors and warnings of an algorithm and of its executive while it lives.
class Errors
{
public:
  explicit Errors(vtkAlgorithm* algorithm);
  ~Errors();
  // The algorithm's own; its executive adds that the request failed.
  std::vector<std::string> Own;
  std::vector<std::string> Executives;
  std::vector<std::string> Warnings;

private:
  vtkSmartPointer<vtkAlgorithm> Algorithm;
  vtkNew<vtkCallbackCommand> OwnCommand, ExecutiveCommand, WarningCommand;
};

}

#endif
