#include "ConnectedPieces.h"

#include <algorithm>
#include <cstring>

namespace vtkshadows
{

namespace
{

struct HashOfBits
{
  std::size_t operator()(const glm::dvec3& p) const
  {
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double value = p[axis] + 0.0; // -0 becomes 0
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof(bits));
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }
};

}

//------------------------------------------------------------------------------
ConnectedPieces::ConnectedPieces(const std::vector<glm::dvec3>& points)
  : Parents(points.size())
{
  std::unordered_map<glm::dvec3, std::uint32_t, HashOfBits> first;
  first.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto number = static_cast<std::uint32_t>(i);
    this->Parents[i] = first.emplace(points[i], number).first->second;
  }
}

//------------------------------------------------------------------------------
// With path halving. A root has the least number of its piece.
std::uint32_t ConnectedPieces::RootOf(std::uint32_t point)
{
  while (this->Parents[point] != point)
  {
    this->Parents[point] = this->Parents[this->Parents[point]];
    point = this->Parents[point];
  }
  return point;
}

//------------------------------------------------------------------------------
void ConnectedPieces::Join(std::size_t a, std::size_t b)
{
  const std::uint32_t rootOfA = this->RootOf(static_cast<std::uint32_t>(a));
  const std::uint32_t rootOfB = this->RootOf(static_cast<std::uint32_t>(b));
  this->Parents[std::max(rootOfA, rootOfB)] = std::min(rootOfA, rootOfB);
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> ConnectedPieces::Number(std::size_t& count)
{
  std::vector<std::uint32_t> pieces(this->Parents.size());
  count = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    const std::uint32_t root = this->RootOf(static_cast<std::uint32_t>(i));
    pieces[i] = root == i ? static_cast<std::uint32_t>(count++) : pieces[root];
  }
  return pieces;
}

}
