// A caster's triangles with their edges and pieces, in the floats that its mapper hands to OpenGL
// (see vtkShadowCasterGeometry::PlaceOfVertices): the caster's own coordinates (TC).
#ifndef vtkShadowCasterMesh_h
#define vtkShadowCasterMesh_h

#include "ShadowMesh.h"
#include "vtkShadowSceneData.h"

#include <string>

struct vtkShadowCasterMesh
{
  vtkshadows::ShadowMesh<float> Mesh;
  glm::dmat4 ModelFromCaster{ 1.0 };
  std::string Fault;   // why it is left out whole; empty: it is not
  std::string Skipped; // what of it is no triangle; empty: nothing

  static vtkShadowCasterMesh Build(const vtkShadowScene::Piece& piece);
};

#endif
