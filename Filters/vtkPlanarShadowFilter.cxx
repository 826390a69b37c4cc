#include "vtkPlanarShadowFilter.h"

#include "vtkShadowCaster.h"

#include "PlanarShadow.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <initializer_list>

vtkStandardNewMacro(vtkPlanarShadowFilter);

namespace
{

using vtkshadows::NoPoint;
using vtkshadows::PlanarShadow;
using vtkshadows::PolygonSet;

void AddPoints(const PolygonSet& polygons, const vtkshadows::PlaneFrame& frame, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(polygons.points.size()));
  for (std::size_t i = 0; i < polygons.points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), &frame.ToWorld(polygons.points[i])[0]);
  }
  output->SetPoints(points);
}

// `isClosed`: each cell ends with its first corner.
vtkSmartPointer<vtkCellArray> MakeCells(const PolygonSet& polygons, bool isClosed)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  const auto count = static_cast<vtkIdType>(polygons.NumberOfPolygons());
  cells->AllocateExact(
    count, static_cast<vtkIdType>(polygons.corners.size()) + (isClosed ? count : 0));
  for (vtkIdType i = 0; i < count; ++i)
  {
    const std::uint32_t first = polygons.starts[i], last = polygons.starts[i + 1];
    cells->InsertNextCell(static_cast<int>(last - first) + (isClosed ? 1 : 0));
    for (std::uint32_t corner = first; corner < last; ++corner)
    {
      cells->InsertCellPoint(polygons.corners[corner]);
    }
    if (isClosed)
    {
      cells->InsertCellPoint(polygons.corners[first]);
    }
  }
  return cells;
}

template <typename Array, typename Value>
vtkSmartPointer<Array> MakeArray(const char* name, std::size_t count, const Value& valueOf)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(count));
  for (std::size_t i = 0; i < count; ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), valueOf(i));
  }
  return array;
}

void AddField(vtkPolyData* output, const char* name, std::initializer_list<double> values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.size()));
  array->InsertNextTuple(values.begin());
  output->GetFieldData()->AddArray(array);
}

void AddFields(const PlanarShadow& shadow, const glm::dvec4& light, vtkPolyData* output)
{
  const glm::dvec3 &origin = shadow.frame.origin, &normal = shadow.frame.normal;
  AddField(output, "ShadowPlaneOrigin", { origin.x, origin.y, origin.z });
  AddField(output, "ShadowPlaneNormal", { normal.x, normal.y, normal.z });
  AddField(output, "ShadowLight", { light.x, light.y, light.z, light.w });
  output->GetFieldData()->AddArray(
    MakeArray<vtkIntArray>("ShadowIsCut", 1, [&](std::size_t) { return shadow.isCut ? 1 : 0; }));
  if (shadow.isCut)
  {
    const glm::dvec3 &low = shadow.bounds.minimum, &high = shadow.bounds.maximum;
    AddField(output, "ShadowBounds", { low.x, high.x, low.y, high.y, low.z, high.z });
  }
}

void AddPolygons(
  const PlanarShadow& shadow, const vtkShadowGeometryFilter::Caster& caster, vtkPolyData* output)
{
  AddPoints(shadow.polygons, shadow.frame, output);
  output->SetPolys(MakeCells(shadow.polygons, false));
  output->GetPointData()->AddArray(
    MakeArray<vtkIdTypeArray>("OriginalPointIds", shadow.originals.size(),
      [&](std::size_t i)
      { return shadow.originals[i] == NoPoint ? -1 : caster.PointIds[shadow.originals[i]]; }));
  output->GetCellData()->AddArray(MakeArray<vtkIdTypeArray>("OriginalCellIds",
    shadow.triangles.size(), [&](std::size_t i) { return caster.CellIds[shadow.triangles[i]]; }));
}

void AddOutline(const vtkshadows::UnionOutline& outline, const PlanarShadow& shadow,
  const vtkShadowGeometryFilter::Caster& caster, vtkPolyData* output)
{
  AddPoints(outline.loops, shadow.frame, output);
  output->SetLines(MakeCells(outline.loops, true));
  output->GetPointData()->AddArray(
    MakeArray<vtkIdTypeArray>("OriginalPointIds", outline.originals.size(),
      [&](std::size_t i) -> vtkIdType
      {
        const std::uint32_t place = outline.originals[i];
        const std::uint32_t point = place == NoPoint ? NoPoint : shadow.originals[place];
        return point == NoPoint ? -1 : caster.PointIds[point];
      }));
  output->GetCellData()->AddArray(MakeArray<vtkDoubleArray>(
    "LoopArea", outline.areas.size(), [&](std::size_t i) { return outline.areas[i]; }));
}

}

//------------------------------------------------------------------------------
vtkPlanarShadowFilter::vtkPlanarShadowFilter() = default;
vtkPlanarShadowFilter::~vtkPlanarShadowFilter() = default;

//------------------------------------------------------------------------------
bool vtkPlanarShadowFilter::MakeGeometry(const Caster& caster, vtkPolyData* output)
{
  if (!this->CheckPlane() || !this->CheckBounds(this->Bounds, "no bounds"))
  {
    return false;
  }
  const double *o = this->PlaneOrigin, *n = this->PlaneNormal, *b = this->Bounds;
  vtkshadows::Box bounds;
  if (b[0] <= b[1])
  {
    bounds.AddPoint({ b[0], b[2], b[4] });
    bounds.AddPoint({ b[1], b[3], b[5] });
  }
  const PlanarShadow shadow = vtkshadows::ThrowOnPlane(
    caster.Mesh, caster.Signs, caster.Light, { o[0], o[1], o[2] }, { n[0], n[1], n[2] }, bounds);
  if (shadow.isLightInPlane)
  {
    vtkWarningMacro("Light (" << this->Light[0] << ", " << this->Light[1] << ", " << this->Light[2]
                              << ", " << this->Light[3] << ") lies in the plane through (" << o[0]
                              << ", " << o[1] << ", " << o[2] << ") across (" << n[0] << ", "
                              << n[1] << ", " << n[2]
                              << ") and throws no shadow on it: move the light or the plane.");
  }
  else if (shadow.isCut && bounds.isEmpty)
  {
    vtkWarningMacro("The mesh reaches up to the light, and its shadow has no end. It was cut to ("
      << shadow.bounds.minimum.x << ", " << shadow.bounds.maximum.x << ", "
      << shadow.bounds.minimum.y << ", " << shadow.bounds.maximum.y << ", "
      << shadow.bounds.minimum.z << ", " << shadow.bounds.maximum.z
      << "): set Bounds, or raise the light above the mesh.");
  }

  AddFields(shadow, caster.Light, output);
  vtkshadows::UnionOutline outline;
  if (this->ComputeArea || this->OutputMode == OUTLINE)
  {
    try
    {
      outline = vtkshadows::UnitePolygons(shadow.polygons);
    }
    catch (const std::exception& error)
    {
      vtkErrorMacro(<< error.what());
      return false;
    }
    AddField(output, "ShadowArea", { outline.area });
  }
  if (this->OutputMode == OUTLINE)
  {
    AddOutline(outline, shadow, caster, output);
  }
  else
  {
    AddPolygons(shadow, caster, output);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowFilter::CheckPlane()
{
  const double *o = this->PlaneOrigin, *n = this->PlaneNormal;
  if (!std::isfinite(o[0]) || !std::isfinite(o[1]) || !std::isfinite(o[2]))
  {
    vtkErrorMacro("PlaneOrigin (" << o[0] << ", " << o[1] << ", " << o[2]
                                  << ") is no point: give three finite numbers.");
    return false;
  }
  const double largest = std::max({ std::abs(n[0]), std::abs(n[1]), std::abs(n[2]) });
  if (!(largest > 0.0) || !std::isfinite(n[0]) || !std::isfinite(n[1]) || !std::isfinite(n[2]))
  {
    vtkErrorMacro("PlaneNormal (" << n[0] << ", " << n[1] << ", " << n[2]
                                  << ") is no direction: give three finite numbers, not all 0.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPlanarShadowFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PlaneOrigin: (" << this->PlaneOrigin[0] << ", " << this->PlaneOrigin[1] << ", "
     << this->PlaneOrigin[2] << ")\n";
  os << indent << "PlaneNormal: (" << this->PlaneNormal[0] << ", " << this->PlaneNormal[1] << ", "
     << this->PlaneNormal[2] << ")\n";
  os << indent << "Bounds: (" << this->Bounds[0];
  for (int i = 1; i < 6; ++i)
  {
    os << ", " << this->Bounds[i];
  }
  os << ")\n";
  os << indent << "OutputMode: " << (this->OutputMode == OUTLINE ? "OUTLINE" : "POLYGONS") << "\n";
  os << indent << "ComputeArea: " << (this->ComputeArea ? "on" : "off") << "\n";
}
