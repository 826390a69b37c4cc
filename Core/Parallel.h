// Loops over blocks of indices on all cores. What a block does may depend on its bounds, so these
// are the same on any number of cores.
#ifndef vtkshadows_Parallel_h
#define vtkshadows_Parallel_h

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>

namespace vtkshadows
{

constexpr std::size_t BlockSize = 16384;

inline std::size_t NumberOfBlocks(std::size_t count)
{
  return (count + BlockSize - 1) / BlockSize;
}

// Calls use(block, first, last) for 0 .. count in blocks of BlockSize.
template <typename Use>
void ForEachBlock(std::size_t count, const Use& use)
{
  const std::size_t blocks = NumberOfBlocks(count);
  if (blocks == 1)
  {
    use(std::size_t(0), std::size_t(0), count);
    return;
  }
  tbb::parallel_for(std::size_t(0), blocks,
    [&](std::size_t block)
    {
      const std::size_t first = block * BlockSize;
      use(block, first, std::min(first + BlockSize, count));
    });
}

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

}

#endif
