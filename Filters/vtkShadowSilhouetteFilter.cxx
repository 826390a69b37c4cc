#include "vtkShadowSilhouetteFilter.h"

#include "vtkShadowCaster.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkShadowSilhouetteFilter);

namespace
{

template <typename Array>
Array* AddArray(vtkDataSetAttributes* attributes, const char* name)
{
  vtkNew<Array> array;
  array->SetName(name);
  attributes->AddArray(array);
  return array; // the attributes hold it
}

}

//------------------------------------------------------------------------------
vtkShadowSilhouetteFilter::vtkShadowSilhouetteFilter() = default;
vtkShadowSilhouetteFilter::~vtkShadowSilhouetteFilter() = default;

//------------------------------------------------------------------------------
bool vtkShadowSilhouetteFilter::MakeGeometry(const Caster& caster, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(caster.PointType);
  vtkNew<vtkCellArray> lines;
  auto* pointIds = AddArray<vtkIdTypeArray>(output->GetPointData(), "OriginalPointIds");
  auto* multiplicities = AddArray<vtkIntArray>(output->GetCellData(), "SignedMultiplicity");
  auto* firstCells = AddArray<vtkIdTypeArray>(output->GetCellData(), "OriginalCellId0");
  auto* secondCells = AddArray<vtkIdTypeArray>(output->GetCellData(), "OriginalCellId1");
  auto* cellCounts = AddArray<vtkIntArray>(output->GetCellData(), "NumberOfCells");

  std::vector<vtkIdType> places(caster.Mesh.points.size(), -1);
  const auto placeOf = [&](std::uint32_t point)
  {
    if (places[point] < 0)
    {
      places[point] = points->InsertNextPoint(&caster.Mesh.points[point].x);
      pointIds->InsertNextValue(caster.PointIds[point]);
    }
    return places[point];
  };
  for (const vtkshadows::SilhouetteEdge& edge : caster.Silhouette)
  {
    const vtkIdType ends[2] = { placeOf(edge.from), placeOf(edge.to) };
    lines->InsertNextCell(2, ends);
    const auto multiplicity = static_cast<int>(edge.multiplicity);
    multiplicities->InsertNextValue(caster.RunsAsWound(edge) ? multiplicity : -multiplicity);

    vtkIdType cells[2] = { -1, -1 };
    int count = 0;
    caster.Mesh.edges.ForEachSide(edge.edge,
      [&](vtkshadows::HalfEdge side)
      {
        if (count < 2)
        {
          cells[count] = caster.CellOf(side);
        }
        ++count;
      });
    firstCells->InsertNextValue(cells[0]);
    secondCells->InsertNextValue(cells[1]);
    cellCounts->InsertNextValue(count);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowSilhouetteFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
