#include "ShadowMesh.h"

#include "Parallel.h"

#include <glm/geometric.hpp>
#include <tbb/parallel_reduce.h>

#include <atomic>
#include <cstring>
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

// Atomic counters that start at 0.
template <typename T>
std::unique_ptr<std::atomic<T>[]> MakeAtomics(std::size_t count)
{
  std::unique_ptr<std::atomic<T>[]> atomics(new std::atomic<T>[count]);
  ForEachBlock(count,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        atomics[i].store(0, std::memory_order_relaxed);
      }
    });
  return atomics;
}

//------------------------------------------------------------------------------
// Welding

std::uint64_t Mix(std::uint64_t x)
{
  // The finaliser of MurmurHash3 (A. Appleby).
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdULL;
  x ^= x >> 33;
  x *= 0xc4ceb9fe1a85ec53ULL;
  return x ^ (x >> 33);
}

template <typename Real>
std::uint64_t HashOf(const glm::vec<3, Real>& p)
{
  std::uint64_t hash = 0;
  for (int i = 0; i < 3; ++i)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &p[i], sizeof(Real));
    hash = Mix(hash ^ bits);
  }
  return hash;
}

// Of each point, the first one with its bits. Points are parted by their hashes, so that each
// part's table stays in a processor's cache.
template <typename Real>
std::vector<Index> FirstAlike(const std::vector<glm::vec<3, Real>>& points)
{
  constexpr std::size_t Parts = 256;
  const std::size_t count = points.size(), blocks = NumberOfBlocks(count);
  std::vector<Index> hashes(count), byPart(count), firsts(count);
  std::vector<Index> starts(blocks * Parts, 0);
  ForEachBlock(count,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        hashes[i] = static_cast<Index>(HashOf(points[i]));
        ++starts[block * Parts + hashes[i] % Parts];
      }
    });
  std::vector<Index> partStarts(Parts + 1, 0);
  Index sum = 0;
  for (std::size_t part = 0; part < Parts; ++part)
  {
    partStarts[part] = sum;
    for (std::size_t block = 0; block < blocks; ++block)
    {
      const Index size = starts[block * Parts + part];
      starts[block * Parts + part] = sum;
      sum += size;
    }
  }
  partStarts[Parts] = sum;
  ForEachBlock(count,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        byPart[starts[block * Parts + hashes[i] % Parts]++] = static_cast<Index>(i);
      }
    });
  tbb::parallel_for(std::size_t(0), Parts,
    [&](std::size_t part)
    {
      const Index size = partStarts[part + 1] - partStarts[part];
      std::size_t slots = 1;
      while (slots < 2 * std::size_t(size))
      {
        slots *= 2;
      }
      constexpr Index Free = std::numeric_limits<Index>::max();
      std::vector<Index> table(slots, Free);
      for (Index n = partStarts[part]; n < partStarts[part + 1]; ++n)
      {
        const Index i = byPart[n];
        std::size_t slot = (hashes[i] / Parts) & (slots - 1);
        while (table[slot] != Free && points[table[slot]] != points[i])
        {
          slot = (slot + 1) & (slots - 1);
        }
        table[slot] = table[slot] == Free ? i : table[slot];
        firsts[i] = table[slot];
      }
    });
  return firsts;
}

// Leaves each point once, in the order of their first appearance, and renumbers the triangles.
template <typename Real>
void Weld(std::vector<glm::vec<3, Real>>& points, Triangles& triangles)
{
  using Point = glm::vec<3, Real>;
  const std::size_t count = points.size();
  ForEachBlock(count,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        points[i] += Point(Real(0)); // -0 becomes 0
      }
    });
  std::vector<Index> number = FirstAlike(points);
  Index next = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (number[i] == i)
    {
      points[next] = points[i];
      number[i] = next++;
    }
    else
    {
      number[i] = number[number[i]];
    }
  }
  points.resize(next);
  points.shrink_to_fit();
  ForEachBlock(triangles.size(),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        glm::uvec3& t = triangles[i];
        t = { number[t.x], number[t.y], number[t.z] };
      }
    });
}

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
// Edges

constexpr HalfEdge RunsDown = 0x80000000u; // from the larger index to the smaller one

// A half-edge in the list of its smaller point.
struct Spoke
{
  Index larger;
  HalfEdge side; // with or without RunsDown

  bool operator<(const Spoke& other) const
  {
    return this->larger < other.larger ||
      (this->larger == other.larger && (this->side & ~RunsDown) < (other.side & ~RunsDown));
  }
};

void Sort(Spoke* first, Spoke* last)
{
  if (last - first > 32)
  {
    std::sort(first, last);
    return;
  }
  for (Spoke* i = first + 1; i < last; ++i)
  {
    const Spoke spoke = *i;
    Spoke* hole = i;
    for (; hole > first && spoke < hole[-1]; --hole)
    {
      *hole = hole[-1];
    }
    *hole = spoke;
  }
}

// The edges of one block of points.
struct BlockEdges
{
  std::vector<HalfEdge> borders;
  std::vector<EdgeTable::Pair> pairs;
  std::vector<HalfEdge> fanSides;
  std::vector<Index> fanSizes;

  // first .. last are the half-edges of one edge.
  void Add(const Spoke* first, const Spoke* last)
  {
    const auto size = static_cast<Index>(last - first);
    const auto sideOf = [first](const Spoke& spoke)
    {
      const bool isAlike = ((spoke.side ^ first->side) & RunsDown) == 0 && &spoke != first;
      return (spoke.side & ~RunsDown) | (isAlike ? RunsAlike : 0);
    };
    if (size == 1)
    {
      this->borders.push_back(sideOf(*first));
    }
    else if (size == 2)
    {
      this->pairs.push_back({ sideOf(first[0]), sideOf(first[1]) });
    }
    else
    {
      for (const Spoke* spoke = first; spoke != last; ++spoke)
      {
        this->fanSides.push_back(sideOf(*spoke));
      }
      this->fanSizes.push_back(size);
    }
  }
};

template <typename T>
void Append(std::vector<T>& all, const std::vector<T>& part)
{
  all.insert(all.end(), part.begin(), part.end());
}

EdgeTable FindEdges(const Triangles& triangles, std::size_t numberOfPoints)
{
  // Every half-edge goes into the list of its smaller point.
  const auto counts = MakeAtomics<Index>(numberOfPoints);
  const auto forEachSide = [&](const auto& use)
  {
    ForEachBlock(triangles.size(),
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        for (std::size_t i = first; i < last; ++i)
        {
          const glm::uvec3& t = triangles[i];
          const auto side = static_cast<HalfEdge>(3 * i);
          use(t.x, t.y, side);
          use(t.y, t.z, side + 1);
          use(t.z, t.x, side + 2);
        }
      });
  };
  forEachSide([&](Index from, Index to, HalfEdge)
    { counts[std::min(from, to)].fetch_add(1, std::memory_order_relaxed); });

  std::vector<Index> starts(numberOfPoints + 1, 0);
  for (std::size_t i = 0; i < numberOfPoints; ++i)
  {
    starts[i + 1] = starts[i] + counts[i].load(std::memory_order_relaxed);
  }
  std::vector<Spoke> spokes(starts.back());
  forEachSide(
    [&](Index from, Index to, HalfEdge side)
    {
      const Index smaller = std::min(from, to);
      const Index place =
        starts[smaller] + counts[smaller].fetch_sub(1, std::memory_order_relaxed) - 1;
      spokes[place] = { std::max(from, to), from > to ? side | RunsDown : side };
    });

  // Those with the same larger point are of one edge.
  std::vector<BlockEdges> blocks(NumberOfBlocks(numberOfPoints));
  ForEachBlock(numberOfPoints,
    [&](std::size_t block, std::size_t firstPoint, std::size_t lastPoint)
    {
      BlockEdges& edges = blocks[block];
      edges.pairs.reserve((starts[lastPoint] - starts[firstPoint]) / 2);
      for (std::size_t point = firstPoint; point < lastPoint; ++point)
      {
        Spoke* first = spokes.data() + starts[point];
        Spoke* const last = spokes.data() + starts[point + 1];
        Sort(first, last);
        while (first != last)
        {
          Spoke* next = first + 1;
          while (next != last && next->larger == first->larger)
          {
            ++next;
          }
          edges.Add(first, next);
          first = next;
        }
      }
    });
  std::vector<Spoke>().swap(spokes);

  EdgeTable table;
  std::size_t borders = 0, pairs = 0, fanSides = 0, fans = 0;
  for (const BlockEdges& block : blocks)
  {
    borders += block.borders.size();
    pairs += block.pairs.size();
    fanSides += block.fanSides.size();
    fans += block.fanSizes.size();
  }
  table.borders.reserve(borders);
  table.pairs.reserve(pairs);
  table.fanSides.reserve(fanSides);
  table.fanStarts.reserve(fans + 1);
  for (BlockEdges& block : blocks)
  {
    Append(table.borders, block.borders);
    Append(table.pairs, block.pairs);
    Append(table.fanSides, block.fanSides);
    for (const Index size : block.fanSizes)
    {
      table.fanStarts.push_back(table.fanStarts.back() + size);
    }
    block = BlockEdges();
  }
  return table;
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
