#include "vtkShadowVolumeFilter.h"

#include "vtkShadowCaster.h"

#include "ShadowReach.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

vtkStandardNewMacro(vtkShadowVolumeFilter);

namespace
{

using Filter = vtkShadowVolumeFilter;
using Mesh = vtkshadows::ShadowMesh<double>;
using vtkshadows::Box;
using Signs = std::vector<vtkshadows::CastSign>;

// `bounds` or their default, and the mesh's points.
Box BoxToReach(const Mesh& mesh, const double bounds[6])
{
  Box box;
  box.Add(mesh.points);
  if (bounds[0] > bounds[1])
  {
    return box.Grown(box.Diagonal());
  }
  box.AddPoint({ bounds[0], bounds[2], bounds[4] });
  box.AddPoint({ bounds[1], bounds[3], bounds[5] });
  return box;
}

// Far enough that what lies in the box is inside of the volume, and not on its end.
constexpr double Slack = 0.01;

// How far along the unit `direction` the plane is that ends the volume of a directional light.
double PlaneBeyond(const Box& box, const glm::dvec3& direction)
{
  double farthest = -std::numeric_limits<double>::infinity();
  for (const glm::dvec3& corner : box.Corners())
  {
    farthest = std::max(farthest, glm::dot(direction, corner));
  }
  return farthest + Slack * box.Diagonal();
}

// The unit vector from the light's position to a point; 0 at the light itself.
glm::dvec3 DirectionTo(const glm::dvec3& p, const glm::dvec3& light)
{
  const glm::dvec3 away = p - light;
  const double length = glm::length(away);
  return length > 0.0 ? away / length : glm::dvec3(0.0);
}

// The radius of the sphere round the light that ends its volume.
double SphereBeyond(const Box& box, const Mesh& mesh, const Signs& signs, const glm::dvec3& light)
{
  double farthest = 0.0;
  for (const glm::dvec3& corner : box.Corners())
  {
    farthest = std::max(farthest, glm::distance(light, corner));
  }
  // A flat cap between points of a unit sphere is no nearer to its centre than they are along any
  // one direction.
  double nearest = 1.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    if (signs[i] != 0)
    {
      const glm::uvec3& t = mesh.triangles[i];
      const glm::dvec3 a = DirectionTo(mesh.points[t.x], light);
      const glm::dvec3 b = DirectionTo(mesh.points[t.y], light);
      const glm::dvec3 c = DirectionTo(mesh.points[t.z], light);
      const glm::dvec3 middle = DirectionTo(a + b + c, glm::dvec3(0.0));
      nearest =
        std::min({ nearest, glm::dot(a, middle), glm::dot(b, middle), glm::dot(c, middle) });
    }
  }
  return (1.0 + Slack) * farthest / std::max(nearest, 1e-6);
}

// Gives the image of a point, at the far end of the volume.
using ImageRule = std::function<glm::dvec3(const glm::dvec3&)>;

ImageRule LengthRule(const glm::dvec4& homogeneousLight, double length)
{
  const glm::dvec3 light(homogeneousLight);
  if (homogeneousLight.w == 0.0)
  {
    return [=](const glm::dvec3& p) { return p - length * light; };
  }
  return [=](const glm::dvec3& p) { return p + length * DirectionTo(p, light); };
}

ImageRule BoundsRule(const Filter::Caster& caster, const double bounds[6])
{
  const glm::dvec3 light(caster.Light);
  const Box box = BoxToReach(caster.Mesh, bounds);
  if (caster.Light.w == 0.0)
  {
    const double end = PlaneBeyond(box, -light);
    return [=](const glm::dvec3& p) { return p - (end + glm::dot(p, light)) * light; };
  }
  const double radius = SphereBeyond(box, caster.Mesh, caster.Signs, light);
  return [=](const glm::dvec3& p) { return light + radius * DirectionTo(p, light); };
}

ImageRule InfiniteRule(const glm::dvec4& homogeneousLight)
{
  const glm::dvec3 light(homogeneousLight);
  if (homogeneousLight.w == 0.0)
  {
    return [=](const glm::dvec3&) { return 0.0 - light; };
  }
  return [=](const glm::dvec3& p) { return p - light; };
}

// Gathers the output's points, triangles and arrays.
class VolumeWriter
{
public:
  VolumeWriter()
  {
    this->Points->SetDataTypeToDouble();
    this->PointIds->SetName("OriginalPointIds");
    this->W->SetName("HomogeneousW");
    this->Parts->SetName("ShadowVolumePart");
    this->CellIds->SetName("OriginalCellIds");
  }

  vtkIdType AddPoint(const glm::dvec3& p, vtkIdType original, double w)
  {
    this->PointIds->InsertNextValue(original);
    this->W->InsertNextValue(w);
    return this->Points->InsertNextPoint(&p.x);
  }

  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c, int part, vtkIdType original)
  {
    const vtkIdType corners[3] = { a, b, c };
    this->Cells->InsertNextCell(3, corners);
    this->Parts->InsertNextValue(static_cast<unsigned char>(part));
    this->CellIds->InsertNextValue(original);
  }

  void Give(vtkPolyData* output, bool withW)
  {
    output->SetPoints(this->Points);
    output->SetPolys(this->Cells);
    output->GetPointData()->AddArray(this->PointIds);
    output->GetCellData()->AddArray(this->Parts);
    output->GetCellData()->AddArray(this->CellIds);
    if (withW)
    {
      output->GetPointData()->AddArray(this->W);
    }
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkIdTypeArray> PointIds, CellIds;
  vtkNew<vtkDoubleArray> W;
  vtkNew<vtkUnsignedCharArray> Parts;
};

// The points of casting triangles, in the mesh's order.
std::vector<std::uint32_t> CastingPoints(const Mesh& mesh, const Signs& signs)
{
  std::vector<char> casts(mesh.points.size(), 0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    if (signs[i] != 0)
    {
      const glm::uvec3& t = mesh.triangles[i];
      casts[t.x] = casts[t.y] = casts[t.z] = 1;
    }
  }
  std::vector<std::uint32_t> points;
  for (std::size_t i = 0; i < casts.size(); ++i)
  {
    if (casts[i])
    {
      points.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return points;
}

using Places = std::vector<vtkIdType>;

// `places`: of each of the mesh's points, where it is in the output, or where its image is.
void AddCaps(VolumeWriter& writer, const Filter::Caster& caster, const Places& places, int part)
{
  for (std::size_t i = 0; i < caster.Mesh.triangles.size(); ++i)
  {
    const int sign = part == Filter::NEAR_CAP ? caster.Signs[i] : -caster.Signs[i];
    const glm::uvec3& t = caster.Mesh.triangles[i];
    if (sign != 0)
    {
      writer.AddTriangle(places[t.x], places[sign > 0 ? t.y : t.z], places[sign > 0 ? t.z : t.y],
        part, caster.CellIds[i]);
    }
  }
}

// Of the cells that cast a side on this edge, the lowest.
vtkIdType CellOfSide(const Filter::Caster& caster, const vtkshadows::SilhouetteEdge& edge)
{
  const int direction = caster.RunsAsWound(edge) ? 1 : -1;
  vtkIdType lowest = VTK_ID_MAX;
  caster.Mesh.edges.ForEachSide(edge.edge,
    [&](vtkshadows::HalfEdge side)
    {
      const bool isAlike = side == edge.side || (side & vtkshadows::RunsAlike) != 0;
      const int sign = caster.Signs[(side & ~vtkshadows::RunsAlike) / 3];
      if ((isAlike ? sign : -sign) == direction)
      {
        lowest = std::min(lowest, caster.CellOf(side));
      }
    });
  return lowest;
}

void AddSides(VolumeWriter& writer, const Filter::Caster& caster, const Places& nearPlaces,
  const Places& farPlaces)
{
  for (const vtkshadows::SilhouetteEdge& edge : caster.Silhouette)
  {
    const vtkIdType from = nearPlaces[edge.from], to = nearPlaces[edge.to];
    const vtkIdType farFrom = farPlaces[edge.from], farTo = farPlaces[edge.to];
    const vtkIdType cell = CellOfSide(caster, edge);
    for (std::uint32_t n = 0; n < edge.multiplicity; ++n)
    {
      writer.AddTriangle(to, from, farFrom, Filter::SIDE, cell);
      if (farFrom != farTo)
      {
        writer.AddTriangle(to, farFrom, farTo, Filter::SIDE, cell);
      }
    }
  }
}

}

//------------------------------------------------------------------------------
vtkShadowVolumeFilter::vtkShadowVolumeFilter() = default;
vtkShadowVolumeFilter::~vtkShadowVolumeFilter() = default;

//------------------------------------------------------------------------------
bool vtkShadowVolumeFilter::MakeGeometry(const Caster& caster, vtkPolyData* output)
{
  if (!this->CheckExtent())
  {
    return false;
  }
  const bool isInfinite = this->ExtentMode == INFINITE_EXTENT;
  const bool isOneImage = isInfinite && caster.Light.w == 0.0;
  const std::vector<std::uint32_t> casting = CastingPoints(caster.Mesh, caster.Signs);
  Places nearPlaces(caster.Mesh.points.size(), -1), farPlaces(nearPlaces);
  VolumeWriter writer;
  for (const std::uint32_t i : casting)
  {
    nearPlaces[i] = writer.AddPoint(caster.Mesh.points[i], caster.PointIds[i], 1.0);
  }
  const ImageRule imageOf = this->ExtentMode == LENGTH_EXTENT
    ? LengthRule(caster.Light, this->Length)
    : isInfinite ? InfiniteRule(caster.Light)
                 : BoundsRule(caster, this->Bounds);
  if (isOneImage && !casting.empty())
  {
    const vtkIdType place = writer.AddPoint(imageOf(glm::dvec3(0.0)), -1, 0.0);
    std::fill(farPlaces.begin(), farPlaces.end(), place);
  }
  else
  {
    for (const std::uint32_t i : casting)
    {
      farPlaces[i] =
        writer.AddPoint(imageOf(caster.Mesh.points[i]), caster.PointIds[i], isInfinite ? 0.0 : 1.0);
    }
  }

  AddCaps(writer, caster, nearPlaces, NEAR_CAP);
  AddSides(writer, caster, nearPlaces, farPlaces);
  if (!isOneImage)
  {
    AddCaps(writer, caster, farPlaces, FAR_CAP);
  }
  writer.Give(output, isInfinite);
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowVolumeFilter::CheckExtent()
{
  if (this->ExtentMode == LENGTH_EXTENT && !(this->Length > 0.0 && std::isfinite(this->Length)))
  {
    vtkErrorMacro("Length " << this->Length << " is no length: give a finite one above 0.");
    return false;
  }
  return this->ExtentMode != BOUNDS_EXTENT ||
    this->CheckBounds(this->Bounds, "the mesh's own bounds");
}

//------------------------------------------------------------------------------
void vtkShadowVolumeFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const modes[] = { "LENGTH_EXTENT", "BOUNDS_EXTENT", "INFINITE_EXTENT" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ExtentMode: " << modes[this->ExtentMode] << "\n";
  os << indent << "Length: " << this->Length << "\n";
  os << indent << "Bounds: (" << this->Bounds[0];
  for (int i = 1; i < 6; ++i)
  {
    os << ", " << this->Bounds[i];
  }
  os << ")\n";
}
