#include "vtkShadowGeometryFilter.h"

#include "vtkShadowCaster.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace
{

using Corners = std::array<vtkIdType, 3>;

// The input's triangles: corners are the input's points.
struct TriangleList
{
  std::vector<Corners> Triangles;
  std::vector<vtkIdType> CellIds;
};

// Calls use(cell, size, ids) for each cell; the first has the number `cell`.
template <typename Use>
void ForEachCell(vtkCellArray* cells, vtkIdType cell, const Use& use)
{
  auto it = vtk::TakeSmartPointer(cells->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    it->GetCurrentCell(size, ids);
    use(cell++, size, ids);
  }
}

TriangleList ListTriangles(vtkPolyData* input)
{
  TriangleList list;
  const auto add = [&list](vtkIdType cell, const Corners& corners)
  {
    list.Triangles.push_back(corners);
    list.CellIds.push_back(cell);
  };
  // Cells are numbered through: vertices, lines, polygons, strips.
  const vtkIdType firstPolygon = input->GetNumberOfVerts() + input->GetNumberOfLines();
  ForEachCell(input->GetPolys(), firstPolygon,
    [&add](vtkIdType cell, vtkIdType size, const vtkIdType* ids)
    {
      for (vtkIdType i = 1; i + 1 < size; ++i)
      {
        add(cell, { ids[0], ids[i], ids[i + 1] });
      }
    });
  ForEachCell(input->GetStrips(), firstPolygon + input->GetNumberOfPolys(),
    [&add](vtkIdType cell, vtkIdType size, const vtkIdType* ids)
    {
      for (vtkIdType i = 0; i + 2 < size; ++i)
      {
        // Every second triangle is turned, so that all are wound as the first.
        const vtkIdType odd = i % 2;
        add(cell, { ids[i], ids[i + 1 + odd], ids[i + 2 - odd] });
      }
    });
  return list;
}

// The points that triangles use, in the input's order, and for each of the input's points its place
// among them.
struct UsedPoints
{
  std::vector<glm::dvec3> Points;
  std::vector<vtkIdType> Ids;
  std::vector<std::uint32_t> Places;
};

UsedPoints FindUsedPoints(vtkPoints* points, const TriangleList& list)
{
  UsedPoints used;
  const vtkIdType count = points->GetNumberOfPoints();
  used.Places.assign(count, 0);
  for (const Corners& corners : list.Triangles)
  {
    for (const vtkIdType id : corners)
    {
      used.Places[id] = 1;
    }
  }
  for (vtkIdType id = 0; id < count; ++id)
  {
    if (used.Places[id])
    {
      glm::dvec3 point;
      points->GetPoint(id, &point.x);
      used.Places[id] = static_cast<std::uint32_t>(used.Points.size());
      used.Points.push_back(point);
      used.Ids.push_back(id);
    }
  }
  return used;
}

void CheckFinite(const UsedPoints& used)
{
  for (std::size_t i = 0; i < used.Points.size(); ++i)
  {
    const glm::dvec3& p = used.Points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
    {
      std::ostringstream message;
      message << "Point " << used.Ids[i] << " (" << p.x << ", " << p.y << ", " << p.z
              << ") is not finite and casts no shadow: move it, or remove the faces that use it.";
      throw std::runtime_error(message.str());
    }
  }
}

void CheckCorners(const TriangleList& list, vtkIdType numberOfPoints)
{
  for (std::size_t i = 0; i < list.Triangles.size(); ++i)
  {
    for (const vtkIdType id : list.Triangles[i])
    {
      if (id < 0 || id >= numberOfPoints)
      {
        std::ostringstream message;
        message << "Cell " << list.CellIds[i] << " names point " << id << ", but there are "
                << numberOfPoints << " points: give the mesh the points that its cells mean.";
        throw std::runtime_error(message.str());
      }
    }
  }
}

// Of each point of the mesh, the lowest of the input's points that were welded into it.
std::vector<vtkIdType> FindPointIds(
  const vtkshadows::ShadowMesh<double>& mesh, const std::vector<Corners>& triangles)
{
  std::vector<vtkIdType> ids(mesh.points.size(), VTK_ID_MAX);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      vtkIdType& id = ids[mesh.triangles[i][corner]];
      id = std::min(id, triangles[mesh.originals[i]][corner]);
    }
  }
  return ids;
}

}

//------------------------------------------------------------------------------
vtkShadowGeometryFilter::vtkShadowGeometryFilter() = default;
vtkShadowGeometryFilter::~vtkShadowGeometryFilter() = default;

//------------------------------------------------------------------------------
void vtkShadowGeometryFilter::SetLightPosition(const double position[3])
{
  this->SetLightPosition(position[0], position[1], position[2]);
}

//------------------------------------------------------------------------------
void vtkShadowGeometryFilter::SetLightDirection(double dx, double dy, double dz)
{
  // Not -dx, which would turn 0 into -0.
  this->SetLight(0.0 - dx, 0.0 - dy, 0.0 - dz, 0.0);
}

//------------------------------------------------------------------------------
void vtkShadowGeometryFilter::SetLightDirection(const double direction[3])
{
  this->SetLightDirection(direction[0], direction[1], direction[2]);
}

//------------------------------------------------------------------------------
int vtkShadowGeometryFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  if (!this->UpdateMesh(input) || !this->UpdateLight())
  {
    return 0;
  }
  return this->MakeGeometry(*this->Prepared, output) ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkShadowGeometryFilter::UpdateMesh(vtkPolyData* input)
{
  if (this->Prepared && this->Prepared->Input == input &&
    this->Prepared->InputTime == input->GetMTime())
  {
    return true;
  }
  this->Prepared.reset();
  try
  {
    this->Prepared = Caster::Make(input);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
  ++this->NumberOfMeshBuilds;
  return true;
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkShadowGeometryFilter::Caster> vtkShadowGeometryFilter::Caster::Make(
  vtkPolyData* input)
{
  auto caster = std::make_unique<Caster>();
  caster->Input = input;
  caster->InputTime = input->GetMTime();
  const TriangleList list = ListTriangles(input);
  CheckCorners(list, input->GetNumberOfPoints());
  if (list.Triangles.empty())
  {
    return caster;
  }
  UsedPoints used = FindUsedPoints(input->GetPoints(), list);
  CheckFinite(used);

  std::vector<glm::uvec3> triangles;
  triangles.reserve(list.Triangles.size());
  for (const Corners& c : list.Triangles)
  {
    triangles.emplace_back(used.Places[c[0]], used.Places[c[1]], used.Places[c[2]]);
  }
  caster->Mesh = vtkshadows::BuildShadowMesh(std::move(used.Points), std::move(triangles), true);
  caster->PointIds = FindPointIds(caster->Mesh, list.Triangles);
  for (const std::uint32_t original : caster->Mesh.originals)
  {
    caster->CellIds.push_back(list.CellIds[original]);
  }
  caster->PointType = input->GetPoints()->GetDataType();
  return caster;
}

//------------------------------------------------------------------------------
bool vtkShadowGeometryFilter::UpdateLight()
{
  glm::dvec4 light(this->Light[0], this->Light[1], this->Light[2], this->Light[3]);
  if (light.w > 0.0)
  {
    light /= light.w;
  }
  else
  {
    // By the largest component first: its square could be too large or too small for a double.
    const glm::dvec3 toward(light);
    const double largest = std::max({ std::abs(toward.x), std::abs(toward.y), std::abs(toward.z) });
    light = glm::dvec4(glm::normalize(toward / largest), light.w);
  }
  // Four zeros have become NaN.
  if (!(light.w >= 0.0) || !std::isfinite(light.x + light.y + light.z + light.w))
  {
    vtkErrorMacro("Light (" << this->Light[0] << ", " << this->Light[1] << ", " << this->Light[2]
                            << ", " << this->Light[3]
                            << ") is no light: give four finite numbers, a position with w = 1 or "
                               "a direction toward the light, not 0, with w = 0.");
    return false;
  }

  Caster& caster = *this->Prepared;
  caster.Light = light;
  vtkshadows::FaceTriangles(caster.Mesh, light,
    this->CastingFaces == ALL_FACES ? vtkshadows::CastingFaces::All
                                    : vtkshadows::CastingFaces::Closed,
    caster.Signs);
  vtkshadows::FindSilhouette(caster.Mesh, caster.Signs, caster.Silhouette);
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowGeometryFilter::CheckBounds(const double bounds[6], const char* meaning)
{
  const double* b = bounds;
  const bool isFinite = std::all_of(b, b + 6, [](double value) { return std::isfinite(value); });
  const int reversed = (b[0] > b[1]) + (b[2] > b[3]) + (b[4] > b[5]);
  if (!isFinite || reversed % 3 != 0)
  {
    vtkErrorMacro("Bounds (" << b[0] << ", " << b[1] << ", " << b[2] << ", " << b[3] << ", " << b[4]
                             << ", " << b[5]
                             << ") are no box: give six finite numbers, each minimum at most its "
                                "maximum, or (1, -1, 1, -1, 1, -1) for "
                             << meaning << ".");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowGeometryFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Light: (" << this->Light[0] << ", " << this->Light[1] << ", " << this->Light[2]
     << ", " << this->Light[3] << ")\n";
  os << indent
     << "CastingFaces: " << (this->CastingFaces == ALL_FACES ? "ALL_FACES" : "CLOSED_FACES")
     << "\n";
  os << indent << "NumberOfMeshBuilds: " << this->NumberOfMeshBuilds << "\n";
}
