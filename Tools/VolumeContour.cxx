#include "VolumeContour.h"

#include "Failure.h"

#include <vtkCellData.h>
#include <vtkCellDataToPointData.h>
#include <vtkContourFilter.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>

namespace vtkshadows
{
namespace
{

// The point scalars to contour: the active ones, else the first array there is.
vtkDataArray* ScalarsOf(vtkDataSet* volume)
{
  vtkPointData* arrays = volume->GetPointData();
  if (vtkDataArray* active = arrays->GetScalars())
  {
    return active;
  }
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* array = arrays->GetArray(i))
    {
      return array;
    }
  }
  return nullptr;
}

// The value to contour at: `wanted`, which must lie in the scalars' range, or the range's middle.
double ContourValue(
  vtkDataArray* scalars, const std::string& path, const std::optional<double>& wanted)
{
  double range[2];
  scalars->GetFiniteRange(range, 0);
  if (!(range[0] < range[1]))
  {
    throw Failure("input", path,
      std::string("its scalars ") + scalars->GetName() +
        " are all one value, with no surface between",
      "give it scalars that vary");
  }
  const double value = wanted.value_or(0.5 * (range[0] + range[1]));
  if (!(value >= range[0] && value <= range[1]))
  {
    throw Failure("--isovalue", ToText(value),
      "is outside the scalars " + std::string(scalars->GetName()) + " of " + path,
      "choose one from " + ToText(range[0]) + " to " + ToText(range[1]));
  }
  return value;
}

}

bool IsVolume(vtkDataSet* data)
{
  int size[3] = { 1, 1, 1 };
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(size);
  }
  else if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    grid->GetDimensions(size);
  }
  return size[0] > 1 && size[1] > 1 && size[2] > 1;
}

vtkSmartPointer<vtkPolyData> ContourOf(
  vtkDataSet* volume, const std::string& path, std::optional<double> isovalue)
{
  vtkNew<vtkCellDataToPointData> toPoints;
  if (!ScalarsOf(volume) && volume->GetCellData()->GetNumberOfArrays() > 0)
  {
    toPoints->SetInputData(volume);
    toPoints->Update();
    volume = vtkDataSet::SafeDownCast(toPoints->GetOutput());
  }
  vtkDataArray* scalars = ScalarsOf(volume);
  if (!scalars)
  {
    throw Failure("input", path, "is a volume without scalars", "give it scalars to contour");
  }
  if (!scalars->GetName())
  {
    scalars->SetName("scalars");
  }

  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(volume);
  contour->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, scalars->GetName());
  contour->SetValue(0, ContourValue(scalars, path, isovalue));
  contour->Update();
  return contour->GetOutput();
}

}
