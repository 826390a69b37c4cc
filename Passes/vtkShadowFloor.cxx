#include "vtkShadowFloor.h"

#include "vtkShadowCasterGeometry.h"
#include "vtkShadowMatrix.h"
#include "vtkShadowSceneData.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkShadowFloor);

namespace
{

// How far the floor lies below the lowest point, as a share of the scene's size: less than a pixel,
// enough that a flat bottom does not tie with it.
constexpr double Gap = 5e-4;

// The square from -0.5 to 0.5 in the plane z = 0, facing +z.
vtkSmartPointer<vtkPolyData> UnitSquare()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 4; ++i)
  {
    points->InsertNextPoint(i == 1 || i == 2 ? 0.5 : -0.5, i < 2 ? -0.5 : 0.5, 0.0);
    normals->InsertNextTuple3(0.0, 0.0, 1.0);
  }
  vtkNew<vtkCellArray> quad;
  quad->InsertNextCell({ 0, 1, 2, 3 });
  auto square = vtkSmartPointer<vtkPolyData>::New();
  square->SetPoints(points);
  square->SetPolys(quad);
  square->GetPointData()->SetNormals(normals);
  return square;
}

// Extent along the floor's axes.
struct Extent
{
  glm::dmat3 Axes{ 1.0 }; // columns: two sides and the normal, world
  glm::dvec3 Low{ std::numeric_limits<double>::infinity() };
  glm::dvec3 High{ -std::numeric_limits<double>::infinity() };

  void Add(const glm::dvec3& pointWC, double radius = 0.0)
  {
    const glm::dvec3 along = pointWC * this->Axes;
    this->Low = glm::min(this->Low, along - radius);
    this->High = glm::max(this->High, along + radius);
  }
  double Size() const
  {
    const glm::dvec3 sides = this->High - this->Low;
    return std::max({ sides.x, sides.y, sides.z });
  }
};

void Add(Extent& extent, const vtkShadowScene::Piece& piece)
{
  // In floats relative to the piece, wherever it lies.
  const glm::dvec3 centre = 0.5 * (piece.CornersWC[0] + piece.CornersWC[7]);
  const glm::dmat4 worldFromTrace = glm::translate(glm::dmat4(1.0), centre);
  const auto geometry = vtkShadowCasterGeometry::Extract(
    piece, glm::translate(glm::dmat4(1.0), -centre) * piece.WorldFromModel, worldFromTrace);
  if (!geometry.Skipped.empty() || (geometry.Triangles.empty() && geometry.Spheres.empty()))
  {
    for (const glm::dvec3& corner : piece.CornersWC)
    {
      extent.Add(corner);
    }
    return;
  }
  for (const glm::vec3& vertex : geometry.Vertices)
  {
    extent.Add(centre + glm::dvec3(vertex));
  }
  for (const glm::vec4& sphere : geometry.Spheres)
  {
    extent.Add(centre + glm::dvec3(sphere), sphere.w);
  }
}

}

//------------------------------------------------------------------------------
vtkShadowFloor::vtkShadowFloor()
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(UnitSquare());
  this->Actor->SetMapper(mapper);
}

vtkShadowFloor::~vtkShadowFloor() = default;

//------------------------------------------------------------------------------
vtkActor* vtkShadowFloor::GetActor()
{
  return this->Actor;
}

//------------------------------------------------------------------------------
void vtkShadowFloor::NearestAxis(const double vector[3], double axis[3])
{
  const int largest =
    static_cast<int>(std::max_element(vector, vector + 3,
                       [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      vector);
  const double sign = vector[largest] < 0.0 ? -1.0 : 1.0;
  std::fill_n(axis, 3, 0.0);
  axis[largest] = sign;
}

//------------------------------------------------------------------------------
bool vtkShadowFloor::Fit(vtkRenderer* renderer)
{
  return this->Place(renderer, nullptr);
}

bool vtkShadowFloor::FitAt(vtkRenderer* renderer, double offset)
{
  return this->Place(renderer, &offset);
}

//------------------------------------------------------------------------------
bool vtkShadowFloor::Place(vtkRenderer* renderer, const double* offset)
{
  if (!renderer)
  {
    vtkErrorMacro("Fit(nullptr): give the vtkRenderer to fit the floor to.");
    return false;
  }
  glm::dvec3 normal(this->Normal[0], this->Normal[1], this->Normal[2]);
  if (!std::isfinite(glm::length(normal)) || !(this->Size > 0.0 && std::isfinite(this->Size)) ||
    (offset && !std::isfinite(*offset)))
  {
    vtkErrorMacro("Normal (" << normal.x << ", " << normal.y << ", " << normal.z << "), Size "
                             << this->Size << ", offset " << (offset ? *offset : 0.0)
                             << ": give a finite direction, a size above 0 and a finite offset.");
    return false;
  }

  // A camera that is made now must not last: VTK resets the one that it makes in its first frame.
  const bool hasCamera = renderer->IsActiveCameraCreated() != 0;
  if (normal == glm::dvec3(0.0))
  {
    NearestAxis(renderer->GetActiveCamera()->GetViewUp(), &normal.x);
  }
  normal = glm::normalize(normal);

  // One side along x, or along y if the floor faces x.
  const glm::dvec3 wanted =
    std::abs(normal.x) > 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 side1 = glm::normalize(wanted - glm::dot(wanted, normal) * normal);
  Extent extent;
  extent.Axes = glm::dmat3(side1, glm::cross(normal, side1), normal);

  vtkNew<vtkShadowScene> scene;
  scene->Gather(renderer);
  if (!hasCamera)
  {
    renderer->SetActiveCamera(nullptr);
  }
  for (const vtkShadowScene::Prop& prop : scene->GetProps())
  {
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      if (prop.Source != this->Actor && !prop.Catches)
      {
        Add(extent, piece);
      }
    }
  }
  const double size = extent.Size();
  if (!(size > 0.0) || !std::isfinite(size))
  {
    vtkErrorMacro("The renderer " << renderer
                                  << " shows nothing with an extent to fit a floor to: add actors, "
                                     "or make them visible, first.");
    return false;
  }

  glm::dvec3 centre = 0.5 * (extent.Low + extent.High);
  centre.z = offset ? *offset : extent.Low.z - Gap * size;
  glm::dmat4 worldFromFloor(extent.Axes * (this->Size * size));
  worldFromFloor[3] = glm::dvec4(extent.Axes * centre, 1.0);
  vtkNew<vtkMatrix4x4> matrix;
  vtkShadowMatrix::ToVtk(worldFromFloor, matrix);
  this->Actor->SetUserMatrix(matrix);
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowFloor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Normal: " << this->Normal[0] << " " << this->Normal[1] << " " << this->Normal[2]
     << "\n";
  os << indent << "Size: " << this->Size << "\n";
}
