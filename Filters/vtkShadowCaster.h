// What vtkShadowGeometryFilter hands to its subclasses: the mesh, and how it casts for the light.
#ifndef vtkShadowCaster_h
#define vtkShadowCaster_h

#include "vtkShadowGeometryFilter.h"

#include "ShadowVolume.h"

struct vtkShadowGeometryFilter::Caster
{
  // Throws a std::exception if the mesh cannot be made ready. Its message names what is wrong, and
  // the remedy.
  static std::unique_ptr<Caster> Make(vtkPolyData* input);

  // Of the input, until it changes.
  vtkPolyData* Input = nullptr; // never used, only compared
  vtkMTimeType InputTime = 0;
  int PointType = VTK_DOUBLE; // VTK's code of the input's point coordinates
  vtkshadows::ShadowMesh<double> Mesh;
  std::vector<vtkIdType> CellIds;  // of each triangle of the mesh: the input's cell
  std::vector<vtkIdType> PointIds; // of each point of the mesh: the input's; of several the lowest

  // Of the light: (position, 1) or (unit direction toward it, 0).
  glm::dvec4 Light{ 0.0 };
  std::vector<vtkshadows::CastSign> Signs;
  std::vector<vtkshadows::SilhouetteEdge> Silhouette;

  vtkIdType CellOf(vtkshadows::HalfEdge side) const
  {
    return this->CellIds[(side & ~vtkshadows::RunsAlike) / 3];
  }

  // Whether an edge runs as its first triangle is wound there.
  bool RunsAsWound(const vtkshadows::SilhouetteEdge& edge) const
  {
    return this->Mesh.triangles[edge.side / 3][edge.side % 3] == edge.from;
  }
};

#endif
