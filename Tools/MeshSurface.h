// What VTK has read, as the triangles of its surface, checked.
#ifndef vtkshadows_MeshSurface_h
#define vtkshadows_MeshSurface_h

#include <vtkSmartPointer.h>

#include <optional>
#include <string>

class vtkDataObject;
class vtkPolyData;

namespace vtkshadows
{

// Volumes (images and rectilinear grids of three dimensions) are contoured at `isovalue`, or else
// at the middle of their scalar range; grids are surfaced, composites merged, polygons
// triangulated. Points and normals remain, other data is dropped. Throws Failure naming `path`
// where nothing is left to draw, or where it cannot be drawn: coordinates that are not finite, all
// points one point.
vtkSmartPointer<vtkPolyData> SurfaceOf(
  vtkDataObject* data, const std::string& path, std::optional<double> isovalue);

}

#endif
