#include "vtkShadowSceneInternals.h"

#include "vtkShadowCasterGeometry.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <cmath>

namespace
{

glm::dvec3 PointOf(vtkPoints* points, vtkIdType i)
{
  double p[3];
  points->GetPoint(i, p);
  return { p[0], p[1], p[2] };
}

// Half a step of the numbers that `points` are kept in, as a share of them.
double RoundingUnitOf(vtkPoints* points)
{
  return std::ldexp(1.0, points && points->GetDataType() == VTK_FLOAT ? -24 : -53);
}

// Calls use(p) for each point, in order.
template <typename Use>
void ForEachPoint(const std::vector<vtkPoints*>& sets, const Use& use)
{
  for (vtkPoints* points : sets)
  {
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      use(PointOf(points, i));
    }
  }
}

// The plane through all points of `sets`, to the rounding of the numbers that they are kept in and
// of the floats that they are drawn in, about their middle.
vtkShadowFlatMesh FlatPlane(const std::vector<vtkPoints*>& sets)
{
  vtkIdType count = 0;
  double unit = 0.0;
  for (vtkPoints* points : sets)
  {
    count += points->GetNumberOfPoints();
    unit = std::max(unit, RoundingUnitOf(points));
  }
  if (count < 3)
  {
    return {};
  }

  // Span the plane by the point farthest from the first, and the one farthest from that line.
  const auto first = std::find_if(
    sets.begin(), sets.end(), [](vtkPoints* points) { return points->GetNumberOfPoints() > 0; });
  const glm::dvec3 origin = PointOf(*first, 0);
  glm::dvec3 along(0.0), across(0.0), largest(0.0), low(origin), high(origin);
  ForEachPoint(sets,
    [&](const glm::dvec3& p)
    {
      along = glm::length(p - origin) > glm::length(along) ? p - origin : along;
      largest = glm::max(largest, glm::abs(p));
      low = glm::min(low, p);
      high = glm::max(high, p);
    });
  ForEachPoint(sets,
    [&](const glm::dvec3& p)
    {
      const glm::dvec3 normal = glm::cross(along, p - origin);
      across = glm::length(normal) > glm::length(across) ? normal : across;
    });
  const double length = glm::length(across);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return {};
  }

  const glm::dvec3 normal = across / length;
  // Each coordinate is rounded by itself: in a mesh that its matrix scales unevenly they are
  // unlike.
  const glm::dvec3 kept = 4.0 * unit * largest;
  const glm::dvec3 drawn = std::ldexp(1.0, -22) * glm::min(high - low, largest);
  const glm::dvec3 rounding = glm::abs(normal) * glm::max(kept, drawn);
  const double tolerance =
    rounding.x + rounding.y + rounding.z + std::ldexp(glm::length(along), -50); // of the normal
  bool isFlat = true;
  ForEachPoint(sets,
    [&](const glm::dvec3& p)
    { isFlat = isFlat && std::abs(glm::dot(normal, p - origin)) <= tolerance; });
  if (!isFlat)
  {
    return {};
  }
  return { glm::dvec4(normal, glm::dot(normal, origin)), glm::dot(glm::abs(normal), kept) };
}

// The points of a polygonal mesh, or of all blocks of several, hidden or not; empty where anything
// else is among them.
std::vector<vtkPoints*> PointSetsOf(vtkDataObject* data)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    return mesh->GetPoints() ? std::vector<vtkPoints*>{ mesh->GetPoints() }
                             : std::vector<vtkPoints*>{};
  }
  std::vector<vtkPoints*> sets;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      auto* block = vtkPolyData::SafeDownCast(it->GetCurrentDataObject());
      if (!block)
      {
        return {};
      }
      if (block->GetPoints())
      {
        sets.push_back(block->GetPoints());
      }
    }
  }
  return sets;
}

glm::dvec4 TransformPlane(const glm::dmat4& worldFromModel, const glm::dvec4& planeMC)
{
  // A plane is a row: (n, -d) transforms by the inverse transpose.
  const glm::dvec4 row =
    glm::inverseTranspose(worldFromModel) * glm::dvec4(glm::dvec3(planeMC), -planeMC.w);
  const double length = glm::length(glm::dvec3(row));
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return glm::dvec4(0.0);
  }
  return glm::dvec4(glm::dvec3(row), -row.w) / length;
}

// How long one unit of height over a plane in the model is in the world.
double HeightScale(const glm::dmat4& worldFromModel, const glm::dvec4& planeMC)
{
  const glm::dvec3 row = glm::inverseTranspose(glm::dmat3(worldFromModel)) * glm::dvec3(planeMC);
  return 1.0 / glm::length(row);
}

// Whether a matrix keeps the model's axes at right angles: then the bounds that it takes to the
// world are as tight as they are in the model.
bool KeepsRightAngles(const glm::dmat4& worldFromModel)
{
  const glm::dmat3 axes(worldFromModel);
  const auto areUpright = [&axes](int i, int j)
  {
    return std::abs(glm::dot(axes[i], axes[j])) <=
      1.0e-3 * glm::length(axes[i]) * glm::length(axes[j]);
  };
  return areUpright(0, 1) && areUpright(1, 2) && areUpright(2, 0);
}

// Half of it.
double SurfaceOf(const vtkshadows::BoxCorners& box)
{
  const glm::dvec3 a = box[1] - box[0], b = box[2] - box[0], c = box[4] - box[0];
  return glm::length(glm::cross(a, b)) + glm::length(glm::cross(b, c)) +
    glm::length(glm::cross(c, a));
}

// The bounds of finite points in the world, along its axes.
vtkshadows::Box BoundsInWorld(vtkPoints* points, const glm::dmat4& worldFromModel)
{
  vtkshadows::Box bounds;
  ForEachPoint({ points },
    [&](const glm::dvec3& p)
    {
      const glm::dvec3 at(worldFromModel * glm::dvec4(p, 1.0));
      if (std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z))
      {
        bounds.AddPoint(at);
      }
    });
  return bounds;
}

}

//------------------------------------------------------------------------------
double vtkShadowScene::Internals::VertexReachOf(
  vtkMapper* mapper, const double bounds[6], const glm::dmat4& worldFromModel)
{
  const bool isMoved = vtkShadowCasterGeometry::PlaceOfVertices(mapper).IsMoved();
  double reach = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = bounds[2 * axis], high = bounds[2 * axis + 1];
    const double largest = isMoved ? high - low : std::max(std::abs(low), std::abs(high));
    reach = std::max(reach, largest * glm::length(glm::dvec3(worldFromModel[axis])));
  }
  return reach;
}

//------------------------------------------------------------------------------
// How far a point may be from where its mesh has it, world units.
double vtkShadowScene::Internals::RoundingOf(
  vtkMapper* mapper, const double bounds[6], const Piece& piece)
{
  auto* mesh = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  const double unit = mesh ? RoundingUnitOf(mesh->GetPoints()) : std::ldexp(1.0, -24);
  double kept = 0.0, placed = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double largest = std::max(std::abs(bounds[2 * axis]), std::abs(bounds[2 * axis + 1]));
    kept = std::max(kept, largest * glm::length(glm::dvec3(piece.WorldFromModel[axis])));
  }
  for (const glm::dvec3& corner : piece.CornersWC)
  {
    placed = std::max(placed, glm::length(corner));
  }
  return std::max(
    { 4.0 * unit * kept, std::ldexp(piece.VertexReach, -22), std::ldexp(placed, -50) });
}

//------------------------------------------------------------------------------
// A matrix that shears makes a box around the model lean far over the mesh within, which would have
// few of a map's texels. Then the bounds are those of its points.
void vtkShadowScene::Internals::TightenBounds(Piece& piece)
{
  vtkMapper* mapper = piece.Mapper;
  auto* mesh = mapper->IsA("vtkPolyDataMapper")
    ? vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0))
    : nullptr;
  if (!mesh || !mesh->GetPoints() || DrawsImpostors(piece) ||
    KeepsRightAngles(piece.WorldFromModel))
  {
    return;
  }
  vtkShadowKnownBounds& known = this->Bounds[{ piece.Prop, mapper }];
  const vtkMTimeType stamp = std::max(mesh->GetMTime(), mapper->GetMTime());
  if (known.Stamp != stamp || known.WorldFromModel != piece.WorldFromModel)
  {
    known = { stamp, piece.WorldFromModel, BoundsInWorld(mesh->GetPoints(), piece.WorldFromModel) };
  }
  const vtkshadows::BoxCorners tight = known.BoundsWC.Grown(piece.Rounding).Corners();
  if (!known.BoundsWC.isEmpty && SurfaceOf(tight) < SurfaceOf(piece.CornersWC))
  {
    piece.CornersWC = tight;
  }
}

//------------------------------------------------------------------------------
vtkShadowFlatMesh vtkShadowScene::Internals::PlaneOf(vtkMapper* mapper)
{
  const bool drawsSurfaces =
    (mapper->IsA("vtkPolyDataMapper") || mapper->IsA("vtkCompositePolyDataMapper")) &&
    !mapper->IsA("vtkOpenGLSphereMapper") && !mapper->IsA("vtkOpenGLStickMapper");
  vtkDataObject* data = drawsSurfaces ? mapper->GetInputDataObject(0, 0) : nullptr;
  if (!data)
  {
    return {};
  }
  vtkShadowKnownPlane& known = this->Planes[mapper];
  const vtkMTimeType stamp = std::max(DeepMTime(data), mapper->GetMTime());
  if (known.Stamp != stamp)
  {
    known.Stamp = stamp;
    known.Flat = FlatPlane(PointSetsOf(data));
  }
  return known.Flat;
}

//------------------------------------------------------------------------------
void vtkShadowScene::Internals::FindPlane(Piece& piece)
{
  const vtkShadowFlatMesh flat = this->PlaneOf(piece.Mapper);
  if (glm::dvec3(flat.PlaneMC) != glm::dvec3(0.0))
  {
    piece.PlaneWC = TransformPlane(piece.WorldFromModel, flat.PlaneMC);
    piece.PlaneRounding = flat.Rounding * HeightScale(piece.WorldFromModel, flat.PlaneMC);
  }
}
