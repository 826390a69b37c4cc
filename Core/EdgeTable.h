// The edges of triangles, each with all of those that meet there: of any number, wound either way.
#ifndef vtkshadows_EdgeTable_h
#define vtkshadows_EdgeTable_h

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkshadows
{

// A side of a triangle, from corner `half % 3` of triangle `half / 3` to the next corner. Listed
// with others of its edge it may carry the bit RunsAlike.
using HalfEdge = std::uint32_t;

// Set on a half-edge that runs the same way as the first one of its edge. Of two neighbours that
// are wound alike the second runs against the first.
constexpr HalfEdge RunsAlike = 0x80000000u;

// The undirected edges, by how many triangles meet there.
struct EdgeTable
{
  struct Pair
  {
    HalfEdge first;  // plain
    HalfEdge second; // with or without RunsAlike
  };
  std::vector<HalfEdge> borders; // edges of one triangle
  std::vector<Pair> pairs;       // edges of two
  // Edges of three and more: fan i is fanSides[fanStarts[i]] up to, not including,
  // fanSides[fanStarts[i + 1]]. The first of each is plain.
  std::vector<HalfEdge> fanSides;
  std::vector<std::uint32_t> fanStarts{ 0 };

  std::size_t NumberOfEdges() const
  {
    return this->borders.size() + this->pairs.size() + this->fanStarts.size() - 1;
  }

  // Calls use(side) for each half-edge of an edge, with or without RunsAlike, in the order of the
  // triangles that the mesh was made of. Edges are numbered through: borders, pairs, fans.
  template <typename Use>
  void ForEachSide(std::size_t edge, const Use& use) const
  {
    const std::size_t pairsFrom = this->borders.size(), fansFrom = pairsFrom + this->pairs.size();
    if (edge < pairsFrom)
    {
      use(this->borders[edge]);
      return;
    }
    if (edge < fansFrom)
    {
      use(this->pairs[edge - pairsFrom].first);
      use(this->pairs[edge - pairsFrom].second);
      return;
    }
    const std::size_t fan = edge - fansFrom;
    for (std::uint32_t i = this->fanStarts[fan]; i < this->fanStarts[fan + 1]; ++i)
    {
      use(this->fanSides[i]);
    }
  }
};

// The edges of triangles of three different points each, whose indices are below `numberOfPoints`;
// on all cores, with the same result on any number of them. At most (2^31 - 1) / 3 triangles.
EdgeTable FindEdges(const std::vector<glm::uvec3>& triangles, std::size_t numberOfPoints);

}

#endif
