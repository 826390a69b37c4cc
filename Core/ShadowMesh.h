// A caster's triangles, ready for shadow volumes: welded, every edge known with all its triangles,
// and the closed pieces told from the rest. Built once a shape; a light that moves changes nothing
// here (see ShadowVolume.h).
//
// Any triangle soup will do: open, non-manifold, of mixed winding, with duplicated faces.
// Real is float for what is drawn, double for what is computed as geometry.
//
// @par Reference: P. Bergeron: A general version of Crow's shadow volumes, IEEE CG&A 6(9), 1986
// (edges of any number of faces); B. Kim, K. Kim, G. Turk: A shadow-volume algorithm for opaque and
// transparent nonmanifold casters, Journal of Graphics Tools 13(3), 2008.
#ifndef vtkshadows_ShadowMesh_h
#define vtkshadows_ShadowMesh_h

#include "EdgeTable.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkshadows
{

// Triangles first .. last-1, which are connected by edges, or are all those that are not closed.
struct MeshPiece
{
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  // Closed and consistently wound: along each edge as many triangles run one way as the other.
  bool closed = false;
  bool insideOut = false; // of a closed piece: its triangles are wound clockwise, seen from outside
  glm::dvec3 minimum{ 0.0 }, maximum{ 0.0 }; // of its points
};

// Triangles of a mesh that are kept as their corners alone, three points each: those of which at
// least two sides are borders (see SetSoupApart). They follow all others.
struct SoupTriangles
{
  std::uint32_t firstPoint = 0;
  // Counted from the first of them: starts[0] up to, not including, starts[1] have three borders;
  // starts[g] up to starts[g + 1] all but side g - 1.
  std::array<std::uint32_t, 5> starts{};

  std::size_t NumberOfTriangles() const { return this->starts[4]; }
  // Which side of triangle i is no border; 3: all are.
  std::uint32_t InnerSide(std::uint32_t i) const
  {
    return i < this->starts[1] ? 3 : i < this->starts[2] ? 0 : i < this->starts[3] ? 1 : 2;
  }
};

template <typename Real>
struct ShadowMesh
{
  using Point = glm::vec<3, Real>;
  std::vector<Point> points;            // no two with the same bits, but for those of soup
  std::vector<glm::uvec3> triangles;    // three different points each; piece by piece
  SoupTriangles soup;                   // none, unless set apart
  std::vector<std::uint32_t> originals; // of each triangle: its index in what the mesh was made of.
                                        // Empty unless asked for.
  EdgeTable edges;                      // without the borders of soup
  std::vector<MeshPiece> pieces;        // closed ones, and at most one of all the others, the last

  std::size_t NumberOfTriangles() const
  {
    return this->triangles.size() + this->soup.NumberOfTriangles();
  }
  // The points of triangle i, of soup too.
  glm::uvec3 Corners(std::size_t i) const
  {
    if (i < this->triangles.size())
    {
      return this->triangles[i];
    }
    const auto first =
      static_cast<std::uint32_t>(this->soup.firstPoint + 3 * (i - this->triangles.size()));
    return { first, first + 1, first + 2 };
  }
  // Of the arrays, with their spare capacity.
  std::size_t MemoryInBytes() const;
};

// Weld points that agree in every bit (0 and -0 are one), drop triangles that then repeat a point,
// and find edges and pieces; on all cores, with the same result on any number of them. At most
// (2^31 - 1) / 3 triangles; std::length_error above. Precondition: points are finite, indices below
// points.size(). `keepOriginals`: fill `originals`.
template <typename Real>
ShadowMesh<Real> BuildShadowMesh(std::vector<glm::vec<3, Real>> points,
  std::vector<glm::uvec3> triangles, bool keepOriginals = false);

// Keep the triangles of two and three borders as soup: their corners and nothing else. Each has its
// three points for itself, then; if that makes more than `mostPoints`, nothing is done. What casts,
// and the floats of every corner, stay.
template <typename Real>
void SetSoupApart(ShadowMesh<Real>& mesh, std::size_t mostPoints);

extern template struct ShadowMesh<float>;
extern template struct ShadowMesh<double>;
extern template ShadowMesh<float> BuildShadowMesh(
  std::vector<glm::vec3> points, std::vector<glm::uvec3> triangles, bool keepOriginals);
extern template ShadowMesh<double> BuildShadowMesh(
  std::vector<glm::dvec3> points, std::vector<glm::uvec3> triangles, bool keepOriginals);
extern template void SetSoupApart(ShadowMesh<float>& mesh, std::size_t mostPoints);
extern template void SetSoupApart(ShadowMesh<double>& mesh, std::size_t mostPoints);

}

#endif
