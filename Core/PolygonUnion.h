// The union of polygons in a plane: its outline and its area, each point of the plane counted once.
// Polygons may overlap, repeat, touch along edges or parts of edges, and wind either way.
//
// Edges of all polygons, each turned counter-clockwise, are summed; those between neighbours
// cancel. What is left is rounded to a grid of 2^50 steps over the points' bounds, split where it
// crosses until nothing crosses any more, and swept: the outline runs where a winding number of 0
// meets one above. All decisions are exact; what is rounded are crossings, to a step of the grid.
// Where more edges cross than is worth it, polygons are united by halves first: what lies inside a
// half is then gone.
//
// @par Reference: J. Bentley, T. Ottmann: Algorithms for reporting and counting geometric
// intersections, IEEE Transactions on Computers 28(9), 1979 (sweep); J. Hobby: Practical segment
// intersection with finite precision output, Computational Geometry 13(4), 1999; D. Halperin,
// E. Packer: Iterated snap rounding, Computational Geometry 23(2), 2002.
#ifndef vtkshadows_PolygonUnion_h
#define vtkshadows_PolygonUnion_h

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkshadows
{

constexpr std::uint32_t NoPoint = 0xffffffffu;

// Polygon i has the corners corners[starts[i]] up to, not including, corners[starts[i + 1]], which
// are indices of points. 0 to 2 corners make no area.
struct PolygonSet
{
  std::vector<glm::dvec2> points;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> starts{ 0 };

  std::size_t NumberOfPolygons() const { return this->starts.size() - 1; }
};

// Loops without crossings, the region to the left of each: outer ones run counter-clockwise, holes
// clockwise. Two may touch in a point. Their polygons are in no particular, but always in the same
// order.
struct UnionOutline
{
  PolygonSet loops;
  std::vector<std::uint32_t> originals; // of each point: the lowest of the set's, or NoPoint if
                                        // edges cross there
  std::vector<double> areas;            // of each loop; negative for a hole
  double area = 0.0;                    // their sum
};

// Precondition: points are finite; each polygon is convex, but for rounding. Loops no wider than
// the grid's steps are left out. On all cores, with the same result on any number of them.
UnionOutline UnitePolygons(const PolygonSet& polygons);

}

#endif
