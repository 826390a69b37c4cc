// A caster's triangles with their edges and pieces, in the floats that its mapper hands to OpenGL
// (see vtkShadowCasterGeometry::PlaceOfVertices): the caster's own coordinates (TC).
#ifndef vtkShadowCasterMesh_h
#define vtkShadowCasterMesh_h

#include "ShadowMesh.h"
#include "vtkShadowCasterGeometry.h"
#include "vtkShadowSceneData.h"

#include <string>

struct vtkShadowCasterMesh
{
  vtkshadows::ShadowMesh<float> Mesh;
  glm::dmat4 ModelFromCaster{ 1.0 };
  std::string NotFinite; // a point at which triangles were left out; empty: there is none
  std::string Skipped;   // what of it is no triangle; empty: nothing

  // The triangles alone, and all of this but its mesh.
  vtkShadowCasterGeometry Extract(const vtkShadowScene::Piece& piece);

  static vtkShadowCasterMesh Build(const vtkShadowScene::Piece& piece);

  // The same with the points where the piece's matrix takes them, in world coordinates about its
  // middle: ModelFromCaster is then no matrix that takes them back, and WorldFromCaster returned.
  // For a matrix that FloatsCannotInvert.
  static vtkShadowCasterMesh BuildInWorld(
    const vtkShadowScene::Piece& piece, glm::dmat4& worldFromCaster);

  // Whether a light, taken back through `matrix` to coordinates that are floats and forth again,
  // would be moved by more than 2^-12 of its distance; so it is by one that flattens. Scales along
  // the model's own axes do not matter.
  //
  // @par Reference: R. Skeel: Scaling for numerical stability in Gaussian elimination, J. ACM
  // 26(3), 1979 (the condition number |A||A^-1|, which column scaling leaves as it is).
  static bool FloatsCannotInvert(const glm::dmat4& matrix);
};

#endif
