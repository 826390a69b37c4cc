#include "EdgeTable.h"

#include "Parallel.h"

#include <algorithm>

namespace vtkshadows
{
namespace
{

using Index = std::uint32_t;

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

}

//------------------------------------------------------------------------------
EdgeTable FindEdges(const std::vector<glm::uvec3>& triangles, std::size_t numberOfPoints)
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

}
