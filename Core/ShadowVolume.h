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

#include <array>

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

// What a lamp lies on, to the rounding of the points: rounding alone tells on which side of it the
// lamp is.
enum class TouchedFaces
{
  Cast,    // as all do
  CastNot, // as for rays that begin at the lamp
};

// One sign a triangle, each decided once, in double, whatever Real is. Edge-on triangles (and those
// without an area) count as turned away. `signs` is resized.
template <typename Real>
void FaceTriangles(const ShadowMesh<Real>& mesh, const glm::dvec4& light, CastingFaces which,
  std::vector<CastSign>& signs, TouchedFaces touched = TouchedFaces::Cast);

// A silhouette edge. Seen from the light, the shadow lies to the left of from -> to.
struct SilhouetteEdge
{
  std::uint32_t from = 0, to = 0; // points of the mesh
  std::uint32_t multiplicity = 1; // how many sides stand on it, at least 1
  HalfEdge side = 0;              // the first of its half-edges, plain
  std::uint32_t edge = 0;         // its number; see EdgeTable::ForEachSide. A border of soup is in
                                  // no table: NumberOfEdges() and above
};

template <typename Real>
void FindSilhouette(const ShadowMesh<Real>& mesh, const std::vector<CastSign>& signs,
  std::vector<SilhouetteEdge>& silhouette);

// A volume as lists of numbers for drawing, one after another in one array.
struct VolumeLists
{
  struct List
  {
    std::size_t first = 0;
    std::size_t count = 0; // numbers

    std::size_t End() const { return this->first + this->count; }
  };
  // The casting triangles of soup, each as SoupEntry: those that face the light as they are wound,
  // and those that do not; with three borders and with two. Caps and sides of them are drawn by
  // this alone: a side stands on each border.
  List threeSided, twoSided, turnedTwoSided, turnedThreeSided;

  // Of all others, indices: 2 * point, and 2 * point + 1 for the point's image at the far end, away
  // from the light.
  // Sides, their outer face counter-clockwise: a quad as two triangles; with `oneImage` one
  // triangle, whose third corner is an image.
  // Each of `doubles` counts as two sides: an edge of multiplicity m has m / 2 of them, and one of
  // `singles` if m is odd.
  List singles, doubles;
  // The casting triangles in their own order of corners (so that they are drawn with the same
  // rounding as the surface itself): those that face the light as they are wound, and those that do
  // not, which are to be taken as turned round.
  List caps, turnedCaps;

  std::size_t Count() const { return this->turnedCaps.End(); }
};

// Triangle i of soup, and in the two highest bits its SoupTriangles::InnerSide.
constexpr std::uint32_t SoupEntry(std::uint32_t i, std::uint32_t innerSide)
{
  return i | innerSide << 30;
}

// Emits the volume of casting triangles in two steps, so that it is written where it will stay.
// `oneImage`: sides end in one point (a directional light's, infinitely long). Both, the mesh and
// the signs, must outlive it.
template <typename Real>
class VolumeEmitter
{
public:
  VolumeEmitter(const ShadowMesh<Real>& mesh, const std::vector<CastSign>& signs, bool oneImage);

  const VolumeLists& Lists() const { return this->Found; }
  // Write all lists to `numbers`, which has room for Lists().Count().
  void Write(std::uint32_t* numbers) const;

private:
  // Where each block of a loop writes in each of N lists.
  template <std::size_t N>
  using Places = std::vector<std::array<std::size_t, N>>;

  const ShadowMesh<Real>& Mesh;
  const std::vector<CastSign>& Signs;
  bool OneImage;
  VolumeLists Found;
  Places<4> SoupPlaces;
  Places<2> SidePlaces, CapPlaces;
};

// How many casting triangles the ray from the light in `direction` crosses: in how many prisms the
// point at infinity there lies. For a light with a position.
template <typename Real>
int CountCrossed(const ShadowMesh<Real>& mesh, const std::vector<CastSign>& signs,
  const glm::dvec4& light, const glm::dvec3& direction);

}

#endif
