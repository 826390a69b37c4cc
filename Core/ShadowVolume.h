// The shadow volume of a mesh for one light, by signed edge multiplicity: each casting triangle is
// turned toward the light and closes a prism with its image at the far end; along an edge, the
// sides of the prisms that meet there cancel as far as they run opposite ways, and what is left is
// emitted. The result is a sum of closed prisms for any triangle soup.
//
// A light is a homogeneous vector: (position, 1), or (the unit direction toward it, 0).
//
// @par Reference: P. Bergeron 1986; G. Aldridge, E. Woods: Robust, geometry-independent shadow
// volumes, GRAPHITE 2004; B. Kim, K. Kim, G. Turk 2008; J. Peciva, T. Starka, T. Milet, J. Kobrtek,
// P. Zemcik: Robust silhouette shadow volumes on contemporary hardware, GraphiCon 2013.
#ifndef vtkshadows_ShadowVolume_h
#define vtkshadows_ShadowVolume_h

#include "ShadowMesh.h"

#include <glm/vec4.hpp>

namespace vtkshadows
{

// How a triangle casts: +1 as it is wound (its counter-clockwise side faces the light), -1 turned
// round, 0 not at all.
using CastSign = std::int8_t;

// Which triangles need to cast.
enum class CastingFaces
{
  All,   // every triangle: right for everything
  Closed // of a closed piece whose bounds do not hold the light those alone that face it, which
         // halves the work; of the rest, all
};

// One sign a triangle, each decided once, in double, whatever Real is. Edge-on triangles (and those
// without an area) count as turned away. `signs` is resized.
template <typename Real>
void FaceTriangles(const ShadowMesh<Real>& mesh, const glm::dvec4& light, CastingFaces which,
  std::vector<CastSign>& signs);

// A silhouette edge. Seen from the light, the shadow lies to the left of from -> to.
struct SilhouetteEdge
{
  std::uint32_t from = 0, to = 0; // points of the mesh
  std::uint32_t multiplicity = 1; // how many sides stand on it, at least 1
  HalfEdge side = 0;              // the first of its half-edges, plain
  std::uint32_t edge = 0;         // its number; see EdgeTable::ForEachSide
};

template <typename Real>
void FindSilhouette(const ShadowMesh<Real>& mesh, const std::vector<CastSign>& signs,
  std::vector<SilhouetteEdge>& silhouette);

// The volume as indices for drawing: 2 * point, and 2 * point + 1 for the point's image at the far
// end, away from the light.
struct VolumeIndices
{
  // Sides, their outer face counter-clockwise: a quad as two triangles; with `oneImage` one
  // triangle, whose third corner is an image.
  // Each of `doubles` counts as two sides: an edge of multiplicity m has m / 2 of them, and one of
  // `singles` if m is odd.
  std::vector<std::uint32_t> singles;
  std::vector<std::uint32_t> doubles;
  // The casting triangles in their own order of corners (so that they are drawn with the same
  // rounding as the surface itself): those that face the light as they are wound, and those that do
  // not, which are to be taken as turned round.
  std::vector<std::uint32_t> caps;
  std::vector<std::uint32_t> turnedCaps;

  std::size_t Count() const
  {
    return this->singles.size() + this->doubles.size() + this->caps.size() +
      this->turnedCaps.size();
  }
};

// `oneImage`: sides end in one point (a directional light's, infinitely long).
template <typename Real>
void EmitVolume(const ShadowMesh<Real>& mesh, const std::vector<CastSign>& signs, bool oneImage,
  VolumeIndices& indices);

// How many casting triangles the ray from the light in `direction` crosses: in how many prisms the
// point at infinity there lies. For a light with a position.
template <typename Real>
int CountCrossed(const ShadowMesh<Real>& mesh, const std::vector<CastSign>& signs,
  const glm::dvec4& light, const glm::dvec3& direction);

}

#endif
