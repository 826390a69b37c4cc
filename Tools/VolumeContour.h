// Images and rectilinear grids to the surface that is drawn of them.
#ifndef vtkshadows_VolumeContour_h
#define vtkshadows_VolumeContour_h

#include <vtkSmartPointer.h>

#include <optional>
#include <string>

class vtkDataSet;
class vtkPolyData;

namespace vtkshadows
{

// Whether `data` is an image or rectilinear grid of three dimensions.
bool IsVolume(vtkDataSet* data);

// The surface in `volume` where its scalars are `isovalue`, or else the middle of their range: the
// active scalars, else the first array; cell data is averaged to the points. Throws Failure naming
// `path`.
vtkSmartPointer<vtkPolyData> ContourOf(
  vtkDataSet* volume, const std::string& path, std::optional<double> isovalue);

}

#endif
