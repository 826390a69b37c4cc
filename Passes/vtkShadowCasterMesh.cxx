#include "vtkShadowCasterMesh.h"

#include "ShadowReach.h"
#include "vtkShadowCasterGeometry.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{

bool IsFinite(const glm::vec3& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

// Without the triangles that have a point that is not finite: as VTK draws them. The number of the
// first such point; -1: there is none.
std::ptrdiff_t DropNotFinite(vtkShadowCasterGeometry& geometry)
{
  std::vector<glm::vec3>& vertices = geometry.Vertices;
  const auto bad = std::find_if_not(vertices.begin(), vertices.end(), IsFinite);
  if (bad == vertices.end())
  {
    return -1;
  }
  const std::ptrdiff_t first = bad - vertices.begin();
  std::vector<glm::uvec3>& triangles = geometry.Triangles;
  triangles.erase(
    std::remove_if(triangles.begin(), triangles.end(),
      [&vertices](const glm::uvec3& t)
      { return !IsFinite(vertices[t.x]) || !IsFinite(vertices[t.y]) || !IsFinite(vertices[t.z]); }),
    triangles.end());
  std::replace_if(
    vertices.begin(), vertices.end(), [](const glm::vec3& p) { return !IsFinite(p); },
    glm::vec3(0.0f)); // no triangle's any more
  return first;
}

}

//------------------------------------------------------------------------------
vtkShadowCasterGeometry vtkShadowCasterMesh::Extract(const vtkShadowScene::Piece& piece)
{
  const vtkShadowCasterGeometry::VertexPlace place =
    vtkShadowCasterGeometry::PlaceOfVertices(piece.Mapper);
  this->ModelFromCaster =
    glm::scale(glm::translate(glm::dmat4(1.0), place.Shift), 1.0 / place.Scale);
  const glm::dmat4 casterFromModel =
    glm::translate(glm::scale(glm::dmat4(1.0), place.Scale), -place.Shift);
  vtkShadowCasterGeometry geometry = vtkShadowCasterGeometry::Extract(
    piece, casterFromModel, piece.WorldFromModel * this->ModelFromCaster);
  this->Skipped =
    geometry.Skipped.empty() && !geometry.Spheres.empty() ? "sphere impostors" : geometry.Skipped;
  const std::ptrdiff_t bad = DropNotFinite(geometry);
  if (bad >= 0)
  {
    this->NotFinite =
      "a point that is not finite (number " + std::to_string(bad) + " of its surface)";
  }
  return geometry;
}

//------------------------------------------------------------------------------
vtkShadowCasterMesh vtkShadowCasterMesh::Build(const vtkShadowScene::Piece& piece)
{
  vtkShadowCasterMesh out;
  vtkShadowCasterGeometry geometry = out.Extract(piece);
  out.Mesh =
    vtkshadows::BuildShadowMesh(std::move(geometry.Vertices), std::move(geometry.Triangles));
  return out;
}

//------------------------------------------------------------------------------
vtkShadowCasterMesh vtkShadowCasterMesh::BuildInWorld(
  const vtkShadowScene::Piece& piece, glm::dmat4& worldFromCaster)
{
  vtkShadowCasterMesh out;
  vtkShadowCasterGeometry geometry = out.Extract(piece);
  vtkshadows::Box bounds;
  bounds.Add(piece.CornersWC);
  const glm::dvec3 middleWC = 0.5 * (bounds.minimum + bounds.maximum);
  // From the floats that VTK draws.
  const glm::dmat4 placed = piece.WorldFromModel * out.ModelFromCaster;
  for (glm::vec3& p : geometry.Vertices)
  {
    p = glm::vec3(glm::dvec3(placed * glm::dvec4(glm::dvec3(p), 1.0)) - middleWC);
  }
  worldFromCaster = glm::translate(glm::dmat4(1.0), middleWC);
  out.Mesh =
    vtkshadows::BuildShadowMesh(std::move(geometry.Vertices), std::move(geometry.Triangles));
  return out;
}

//------------------------------------------------------------------------------
bool vtkShadowCasterMesh::FloatsCannotInvert(const glm::dmat4& matrix)
{
  const glm::dmat3 there(matrix), back = glm::inverse(there);
  double most = 0.0;
  for (int row = 0; row < 3; ++row)
  {
    double sum = 0.0;
    for (int column = 0; column < 3; ++column)
    {
      for (int i = 0; i < 3; ++i)
      {
        sum += std::abs(there[i][row]) * std::abs(back[column][i]);
      }
    }
    most = sum <= most ? most : sum; // NaN, too
  }
  return !(most < 4096.0);
}
