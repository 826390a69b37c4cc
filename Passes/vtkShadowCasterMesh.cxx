#include "vtkShadowCasterMesh.h"

#include "vtkShadowCasterGeometry.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace
{

bool IsFinite(const glm::vec3& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}

//------------------------------------------------------------------------------
vtkShadowCasterMesh vtkShadowCasterMesh::Build(const vtkShadowScene::Piece& piece)
{
  vtkShadowCasterMesh out;
  const vtkShadowCasterGeometry::VertexPlace place =
    vtkShadowCasterGeometry::PlaceOfVertices(piece.Mapper);
  out.ModelFromCaster = glm::scale(glm::translate(glm::dmat4(1.0), place.Shift), 1.0 / place.Scale);
  const glm::dmat4 casterFromModel =
    glm::translate(glm::scale(glm::dmat4(1.0), place.Scale), -place.Shift);
  vtkShadowCasterGeometry geometry = vtkShadowCasterGeometry::Extract(
    piece, casterFromModel, piece.WorldFromModel * out.ModelFromCaster);
  out.Skipped =
    geometry.Skipped.empty() && !geometry.Spheres.empty() ? "sphere impostors" : geometry.Skipped;
  const auto bad = std::find_if_not(geometry.Vertices.begin(), geometry.Vertices.end(), IsFinite);
  if (bad != geometry.Vertices.end())
  {
    out.Fault = "a point that is not finite (number " +
      std::to_string(bad - geometry.Vertices.begin()) + " of its surface)";
    return out;
  }
  out.Mesh =
    vtkshadows::BuildShadowMesh(std::move(geometry.Vertices), std::move(geometry.Triangles));
  return out;
}
