#include "ShadowMesh.h"

#include "Parallel.h"
#include "PointWelding.h"

#include <glm/geometric.hpp>
#include <tbb/parallel_reduce.h>

#include <atomic>
#include <limits>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>

namespace vtkshadows
{
namespace
{

using Index = std::uint32_t;
using Triangles = std::vector<glm::uvec3>;

constexpr std::size_t MostTriangles = (RunsAlike - 1) / 3;

void DropTrianglesThatRepeatAPoint(Triangles& triangles, std::vector<Index>* originals)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const glm::uvec3 t = triangles[i];
    if (t.x != t.y && t.y != t.z && t.z != t.x)
    {
      triangles[kept] = t;
      if (originals)
      {
        (*originals)[kept] = (*originals)[i];
      }
      ++kept;
    }
  }
  triangles.resize(kept);
  if (originals)
  {
    originals->resize(kept);
  }
}

//------------------------------------------------------------------------------
// Pieces

// Sets of triangles that are joined by their edges, on several threads at once: a set's name is its
// least member (R. Anderson, H. Woll: Wait-free parallel algorithms for the union-find problem,
// STOC 1991).
class JoinedSets
{
public:
  explicit JoinedSets(std::size_t count)
    : Parents(MakeAtomics<Index>(count))
  {
    ForEachBlock(count,
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        for (std::size_t i = first; i < last; ++i)
        {
          this->Parents[i].store(static_cast<Index>(i), std::memory_order_relaxed);
        }
      });
  }

  Index Find(Index i) const
  {
    Index parent = this->Parents[i].load(std::memory_order_relaxed);
    while (parent != i)
    {
      const Index grandparent = this->Parents[parent].load(std::memory_order_relaxed);
      this->Parents[i].compare_exchange_weak(parent, grandparent, std::memory_order_relaxed);
      i = grandparent;
      parent = this->Parents[i].load(std::memory_order_relaxed);
    }
    return i;
  }

  void Join(Index a, Index b)
  {
    for (;;)
    {
      a = this->Find(a);
      b = this->Find(b);
      if (a == b)
      {
        return;
      }
      Index larger = std::max(a, b);
      if (this->Parents[larger].compare_exchange_strong(
            larger, std::min(a, b), std::memory_order_relaxed))
      {
        return;
      }
    }
  }

private:
  std::unique_ptr<std::atomic<Index>[]> Parents;
};

Index TriangleOf(HalfEdge side)
{
  return (side & ~RunsAlike) / 3;
}

// Calls use(first, last) for the half-edges of each edge of two and more triangles.
template <typename Use>
void ForEachSharedEdge(const EdgeTable& edges, const Use& use)
{
  ForEachBlock(edges.pairs.size(),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const HalfEdge sides[2] = { edges.pairs[i].first, edges.pairs[i].second };
        use(sides, sides + 2);
      }
    });
  ForEachBlock(edges.fanStarts.size() - 1,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        use(edges.fanSides.data() + edges.fanStarts[i],
          edges.fanSides.data() + edges.fanStarts[i + 1]);
      }
    });
}

// As many run one way as the other.
bool IsBalanced(const HalfEdge* first, const HalfEdge* last)
{
  int sum = 1;
  for (const HalfEdge* side = first + 1; side != last; ++side)
  {
    sum += *side & RunsAlike ? 1 : -1;
  }
  return sum == 0;
}

// The piece of each triangle: closed ones are numbered by their first triangles, all others
// together are the last piece. Returns the number of closed ones.
Index NumberPieces(const EdgeTable& edges, std::vector<Index>& pieceOf)
{
  const std::size_t count = pieceOf.size();
  JoinedSets sets(count);
  ForEachSharedEdge(edges,
    [&](const HalfEdge* first, const HalfEdge* last)
    {
      for (const HalfEdge* side = first + 1; side != last; ++side)
      {
        sets.Join(TriangleOf(*first), TriangleOf(*side));
      }
    });

  const auto isOpen = MakeAtomics<std::uint8_t>(count);
  const auto open = [&](HalfEdge side)
  { isOpen[sets.Find(TriangleOf(side))].store(1, std::memory_order_relaxed); };
  ForEachBlock(edges.borders.size(),
    [&](std::size_t, std::size_t first, std::size_t last)
    { std::for_each(&edges.borders[first], &edges.borders[first] + (last - first), open); });
  ForEachSharedEdge(edges,
    [&](const HalfEdge* first, const HalfEdge* last)
    {
      if (!IsBalanced(first, last))
      {
        open(*first);
      }
    });

  ForEachBlock(count,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        pieceOf[i] = sets.Find(static_cast<Index>(i));
      }
    });
  // A set's name is its first triangle, so that its number is known when others ask for it.
  Index closed = 0;
  constexpr Index Open = std::numeric_limits<Index>::max();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Index name = pieceOf[i];
    pieceOf[i] = isOpen[name].load(std::memory_order_relaxed) ? Open
      : name == i                                             ? closed++
                                                              : pieceOf[name];
  }
  std::replace(pieceOf.begin(), pieceOf.end(), Open, closed);
  return closed;
}

// Triangles in the order of their groups, of which starts[group] are before, and the edges with
// them.
template <typename Group, typename Real>
void SortByGroup(
  ShadowMesh<Real>& mesh, const std::vector<Group>& groupOf, std::vector<Index> starts)
{
  if (std::is_sorted(groupOf.begin(), groupOf.end()))
  {
    return;
  }
  const std::size_t count = groupOf.size();
  std::vector<Index> place(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    place[i] = starts[groupOf[i]]++;
  }
  Triangles sorted(count);
  std::vector<Index> originals(mesh.originals.size());
  for (std::size_t i = 0; i < count; ++i)
  {
    sorted[place[i]] = mesh.triangles[i];
    if (!originals.empty())
    {
      originals[place[i]] = mesh.originals[i];
    }
  }
  mesh.triangles.swap(sorted);
  mesh.originals.swap(originals);

  const auto move = [&place](HalfEdge side)
  { return (side & RunsAlike) | (3 * place[TriangleOf(side)] + (side & ~RunsAlike) % 3); };
  for (HalfEdge& side : mesh.edges.borders)
  {
    side = move(side);
  }
  for (EdgeTable::Pair& pair : mesh.edges.pairs)
  {
    pair = { move(pair.first), move(pair.second) };
  }
  for (HalfEdge& side : mesh.edges.fanSides)
  {
    side = move(side);
  }
}

struct Extent
{
  glm::dvec3 minimum{ std::numeric_limits<double>::infinity() };
  glm::dvec3 maximum{ -std::numeric_limits<double>::infinity() };
  double volume = 0.0; // six times, signed

  static Extent Join(const Extent& a, const Extent& b)
  {
    return { glm::min(a.minimum, b.minimum), glm::max(a.maximum, b.maximum), a.volume + b.volume };
  }
};

template <typename Real>
void Survey(const ShadowMesh<Real>& mesh, MeshPiece& piece)
{
  const auto point = [&mesh](Index i) { return glm::dvec3(mesh.points[i]); };
  const glm::dvec3 origin = point(mesh.triangles[piece.first].x);
  const Extent extent = tbb::parallel_deterministic_reduce(
    tbb::blocked_range<std::size_t>(piece.first, piece.last, BlockSize), Extent(),
    [&](const tbb::blocked_range<std::size_t>& range, Extent sum)
    {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        const glm::uvec3& t = mesh.triangles[i];
        const glm::dvec3 a = point(t.x), b = point(t.y), c = point(t.z);
        sum.minimum = glm::min(sum.minimum, glm::min(a, glm::min(b, c)));
        sum.maximum = glm::max(sum.maximum, glm::max(a, glm::max(b, c)));
        sum.volume += glm::dot(a - origin, glm::cross(b - origin, c - origin));
      }
      return sum;
    },
    Extent::Join);
  piece.minimum = extent.minimum;
  piece.maximum = extent.maximum;
  piece.insideOut = piece.closed && extent.volume < 0.0;
}

template <typename Real>
void FindPieces(ShadowMesh<Real>& mesh)
{
  std::vector<Index> pieceOf(mesh.triangles.size());
  const Index closed = NumberPieces(mesh.edges, pieceOf);

  std::vector<Index> starts(closed + 2, 0);
  for (const Index piece : pieceOf)
  {
    ++starts[piece + 1];
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  SortByGroup(mesh, pieceOf, starts);

  for (Index i = 0; i <= closed; ++i)
  {
    if (starts[i] < starts[i + 1])
    {
      MeshPiece piece;
      piece.first = starts[i];
      piece.last = starts[i + 1];
      piece.closed = i < closed;
      mesh.pieces.push_back(piece);
    }
  }
  mesh.pieces.shrink_to_fit();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.pieces.size()),
    [&mesh](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        Survey(mesh, mesh.pieces[i]);
      }
    });
}

//------------------------------------------------------------------------------
// Soup

// By the number of borders, in the order of SoupTriangles::starts; 0: no soup.
std::vector<std::uint8_t> GroupsOfSoup(const EdgeTable& edges, std::size_t triangles)
{
  std::vector<std::uint8_t> groups(triangles, 0);
  for (const HalfEdge side : edges.borders)
  {
    groups[side / 3] |= 1u << side % 3;
  }
  constexpr std::uint8_t GroupOf[8] = { 0, 0, 0, 4, 0, 3, 2, 1 }; // by the sides that are borders
  for (std::uint8_t& group : groups)
  {
    group = GroupOf[group];
  }
  return groups;
}

// Leaves those points that the first triangles use, and appends three for each of the others.
template <typename Real>
void TakeCornersApart(
  ShadowMesh<Real>& mesh, std::size_t firstApart, std::size_t used, const std::vector<char>& isUsed)
{
  Triangles& triangles = mesh.triangles;
  const std::size_t apart = triangles.size() - firstApart;
  std::vector<glm::vec<3, Real>> points(used + 3 * apart);
  ForEachBlock(apart,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          points[used + 3 * i + corner] = mesh.points[triangles[firstApart + i][corner]];
        }
      }
    });
  triangles.resize(firstApart);
  if (used > 0)
  {
    std::vector<Index> number(mesh.points.size());
    Index next = 0;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      if (isUsed[i])
      {
        points[next] = mesh.points[i];
        number[i] = next++;
      }
    }
    for (glm::uvec3& t : triangles)
    {
      t = { number[t.x], number[t.y], number[t.z] };
    }
  }
  mesh.points.swap(points);
}

// Whether every triangle has three points of its own, in order: no two share any.
bool AreApart(const Triangles& triangles, std::size_t points)
{
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const auto first = static_cast<Index>(3 * i);
    if (triangles[i] != glm::uvec3(first, first + 1, first + 2))
    {
      return false;
    }
  }
  return points == 3 * triangles.size();
}

template <typename T>
std::size_t BytesOf(const std::vector<T>& values)
{
  return values.capacity() * sizeof(T);
}

}

//------------------------------------------------------------------------------
template <typename Real>
std::size_t ShadowMesh<Real>::MemoryInBytes() const
{
  return BytesOf(this->points) + BytesOf(this->triangles) + BytesOf(this->originals) +
    BytesOf(this->edges.borders) + BytesOf(this->edges.pairs) + BytesOf(this->edges.fanSides) +
    BytesOf(this->edges.fanStarts) + BytesOf(this->pieces);
}

//------------------------------------------------------------------------------
template <typename Real>
ShadowMesh<Real> BuildShadowMesh(
  std::vector<glm::vec<3, Real>> points, std::vector<glm::uvec3> triangles, bool keepOriginals)
{
  if (triangles.size() > MostTriangles)
  {
    throw std::length_error("a caster of " + std::to_string(triangles.size()) +
      " triangles is too large for a shadow volume: at most " + std::to_string(MostTriangles) +
      "; split it");
  }
  ShadowMesh<Real> mesh;
  mesh.points = std::move(points);
  mesh.triangles = std::move(triangles);
  if (keepOriginals)
  {
    mesh.originals.resize(mesh.triangles.size());
    std::iota(mesh.originals.begin(), mesh.originals.end(), 0u);
  }
  Weld(mesh.points, mesh.triangles);
  DropTrianglesThatRepeatAPoint(mesh.triangles, keepOriginals ? &mesh.originals : nullptr);
  mesh.triangles.shrink_to_fit();
  mesh.edges = FindEdges(mesh.triangles, mesh.points.size());
  FindPieces(mesh);
  return mesh;
}

//------------------------------------------------------------------------------
template <typename Real>
void SetSoupApart(ShadowMesh<Real>& mesh, std::size_t mostPoints)
{
  const std::vector<std::uint8_t> groups = GroupsOfSoup(mesh.edges, mesh.triangles.size());
  std::vector<char> isUsed(mesh.points.size(), 0);
  std::vector<Index> starts(6, 0);
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    ++starts[groups[i] + 1];
    if (groups[i] == 0)
    {
      const glm::uvec3& t = mesh.triangles[i];
      isUsed[t.x] = isUsed[t.y] = isUsed[t.z] = 1;
    }
  }
  const Index rest = starts[1];
  const std::size_t apart = groups.size() - rest;
  const std::size_t used = std::count(isUsed.begin(), isUsed.end(), 1);
  if (apart == 0 || used + 3 * apart > mostPoints)
  {
    return;
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  SortByGroup(mesh, groups, starts);
  std::vector<HalfEdge>& borders = mesh.edges.borders;
  borders.erase(std::remove_if(borders.begin(), borders.end(),
                  [rest](HalfEdge side) { return side / 3 >= rest; }),
    borders.end());
  borders.shrink_to_fit();
  if (rest == 0 && AreApart(mesh.triangles, mesh.points.size()))
  {
    mesh.triangles.clear();
  }
  else
  {
    TakeCornersApart(mesh, rest, used, isUsed);
  }
  mesh.triangles.shrink_to_fit();
  mesh.soup.firstPoint = static_cast<Index>(used);
  for (int group = 0; group < 5; ++group)
  {
    mesh.soup.starts[group] = starts[group + 1] - rest;
  }
}

template struct ShadowMesh<float>;
template struct ShadowMesh<double>;
template ShadowMesh<float> BuildShadowMesh(
  std::vector<glm::vec3> points, std::vector<glm::uvec3> triangles, bool keepOriginals);
template ShadowMesh<double> BuildShadowMesh(
  std::vector<glm::dvec3> points, std::vector<glm::uvec3> triangles, bool keepOriginals);
template void SetSoupApart(ShadowMesh<float>& mesh, std::size_t mostPoints);
template void SetSoupApart(ShadowMesh<double>& mesh, std::size_t mostPoints);

}
