#include "PointWelding.h"

#include "Parallel.h"

#include <cstdint>
#include <cstring>
#include <limits>

namespace vtkshadows
{
namespace
{

using Index = std::uint32_t;

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

}

//------------------------------------------------------------------------------
template <typename Real>
void Weld(std::vector<glm::vec<3, Real>>& points, std::vector<glm::uvec3>& triangles)
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

template void Weld(std::vector<glm::vec3>& points, std::vector<glm::uvec3>& triangles);
template void Weld(std::vector<glm::dvec3>& points, std::vector<glm::uvec3>& triangles);

}
