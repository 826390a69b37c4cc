#include "EmbeddedSurface.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vtkshadows
{
namespace
{

using Index = std::uint32_t;

constexpr double Epsilon = std::numeric_limits<double>::epsilon();

// A triangle of an ordinary surface has some twenty others beside it.
constexpr std::size_t PairsPerTriangle = 256, PairsAtLeast = 1 << 20;

//------------------------------------------------------------------------------
// Corners of a triangle or ends of a segment, relative to a point nearby.
struct Corners
{
  glm::dvec3 at[3];
  int count = 0;

  glm::dvec3 Side(int i) const { return this->at[(i + 1) % this->count] - this->at[i]; }
  int NumberOfSides() const { return this->count == 3 ? 3 : 1; }
};

// Whether there is a gap between a and b on an axis; reach: no coordinate is farther from 0.
bool HasGap(const Corners& a, const Corners& b, const glm::dvec3& axis, const glm::dvec3& reach)
{
  const auto rangeOf = [&axis](const Corners& corners)
  {
    glm::dvec2 range(glm::dot(axis, corners.at[0]));
    for (int i = 1; i < corners.count; ++i)
    {
      const double along = glm::dot(axis, corners.at[i]);
      range = { std::min(range.x, along), std::max(range.y, along) };
    }
    return range;
  };
  const glm::dvec2 ofA = rangeOf(a), ofB = rangeOf(b);
  const double rounding = 16.0 * Epsilon * glm::dot(glm::abs(axis), reach);
  return std::max(ofB.x - ofA.y, ofA.x - ofB.y) > rounding;
}

// Whether b, a triangle, is proven to have no point in common with a, a triangle or a segment.
bool AreApart(const Corners& a, const Corners& b)
{
  glm::dvec3 reach(0.0);
  for (const Corners* corners : { &a, &b })
  {
    for (int i = 0; i < corners->count; ++i)
    {
      reach = glm::max(reach, glm::abs(corners->at[i]));
    }
  }
  const glm::dvec3 normal = glm::cross(b.Side(0), b.Side(1));
  if (HasGap(a, b, normal, reach) ||
    (a.count == 3 && HasGap(a, b, glm::cross(a.Side(0), a.Side(1)), reach)))
  {
    return true;
  }
  for (int i = 0; i < a.NumberOfSides(); ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      if (HasGap(a, b, glm::cross(a.Side(i), b.Side(j)), reach))
      {
        return true;
      }
    }
  }
  // In one plane.
  for (int j = 0; j < 3; ++j)
  {
    if (HasGap(a, b, glm::cross(normal, b.Side(j)), reach) ||
      HasGap(a, b, glm::cross(normal, a.Side(j % a.NumberOfSides())), reach))
    {
      return true;
    }
  }
  return false;
}

// Whether two triangles with a side in common are proven not to be folded onto each other.
bool AreUnfolded(const glm::dvec3& side, const glm::dvec3& first, const glm::dvec3& second)
{
  const glm::dvec3 normal = glm::cross(side, first), other = glm::cross(second, side);
  const double size = glm::length(normal);
  const double rounding = 16.0 * Epsilon * size;
  return glm::dot(normal, other) > rounding * glm::length(other) ||
    std::abs(glm::dot(second, normal)) > rounding * glm::length(second);
}

//------------------------------------------------------------------------------
// One piece of a mesh, its triangles in a tree of boxes.
class PieceTree
{
public:
  PieceTree(const ShadowMesh<float>& mesh, const MeshPiece& piece)
    : Mesh(mesh)
    , Order(piece.last - piece.first)
  {
    std::iota(this->Order.begin(), this->Order.end(), piece.first);
    this->Nodes.reserve(2 * this->Order.size() / MostInLeaf + 2);
    this->Build(0, static_cast<Index>(this->Order.size()));
  }

  // Whether its triangles are proven to meet only where they should.
  bool IsEmbedded(std::size_t& pairsLeft, const std::atomic<bool>& cancelled) const
  {
    for (std::size_t i = 0; i < this->Order.size(); ++i)
    {
      if (cancelled || !this->IsClear(static_cast<Index>(i), pairsLeft))
      {
        return false;
      }
    }
    return true;
  }

private:
  static constexpr Index MostInLeaf = 4;

  struct Box
  {
    glm::vec3 low{ std::numeric_limits<float>::max() };
    glm::vec3 high{ -std::numeric_limits<float>::max() };

    void Add(const glm::vec3& p)
    {
      this->low = glm::min(this->low, p);
      this->high = glm::max(this->high, p);
    }
    bool Meets(const Box& other) const
    {
      return glm::all(glm::lessThanEqual(this->low, other.high)) &&
        glm::all(glm::lessThanEqual(other.low, this->high));
    }
  };

  struct Node
  {
    Box box;
    Index first = 0, last = 0; // of Order
    Index second = 0;          // the other child, 0 of a leaf; the one is the next node
  };

  Box BoxOf(Index triangle) const
  {
    Box box;
    for (int i = 0; i < 3; ++i)
    {
      box.Add(this->Mesh.points[this->Mesh.triangles[triangle][i]]);
    }
    return box;
  }

  void Build(Index first, Index last)
  {
    const std::size_t number = this->Nodes.size();
    Node node;
    node.first = first;
    node.last = last;
    Box middles;
    for (Index i = first; i < last; ++i)
    {
      const Box box = this->BoxOf(this->Order[i]);
      node.box.Add(box.low);
      node.box.Add(box.high);
      middles.Add(0.5f * box.low + 0.5f * box.high);
    }
    this->Nodes.push_back(node);
    if (last - first <= MostInLeaf)
    {
      return;
    }
    const glm::vec3 size = middles.high - middles.low;
    const int axis = size.x >= std::max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
    const auto middleOf = [this, axis](Index triangle)
    {
      const Box box = this->BoxOf(triangle);
      return 0.5f * box.low[axis] + 0.5f * box.high[axis];
    };
    const Index half = first + (last - first) / 2;
    std::nth_element(this->Order.begin() + first, this->Order.begin() + half,
      this->Order.begin() + last,
      [&middleOf](Index a, Index b) { return middleOf(a) < middleOf(b); });
    this->Build(first, half);
    this->Nodes[number].second = static_cast<Index>(this->Nodes.size());
    this->Build(half, last);
  }

  // Of the triangles that follow it in Order, none meets number i but in what they share.
  bool IsClear(Index i, std::size_t& pairsLeft) const
  {
    const Box box = this->BoxOf(this->Order[i]);
    Index waiting[64];
    int count = 0;
    waiting[count++] = 0;
    while (count > 0)
    {
      const Index number = waiting[--count];
      const Node& node = this->Nodes[number];
      if (node.last <= i + 1 || !node.box.Meets(box))
      {
        continue;
      }
      if (node.second != 0)
      {
        waiting[count++] = node.second;
        waiting[count++] = number + 1;
        continue;
      }
      for (Index j = std::max(node.first, i + 1); j < node.last; ++j)
      {
        if (!this->BoxOf(this->Order[j]).Meets(box))
        {
          continue;
        }
        if (pairsLeft == 0 || !this->MeetRightly(this->Order[i], this->Order[j]))
        {
          return false;
        }
        --pairsLeft;
      }
    }
    return true;
  }

  bool MeetRightly(Index a, Index b) const
  {
    // Corners that they share come last.
    glm::uvec3 ofA = this->Mesh.triangles[a], ofB = this->Mesh.triangles[b];
    int apart = 3;
    for (int i = 2; i >= 0; --i)
    {
      for (int j = 0; j < apart; ++j)
      {
        if (ofA[i] == ofB[j])
        {
          --apart;
          std::swap(ofA[i], ofA[apart]);
          std::swap(ofB[j], ofB[apart]);
          break;
        }
      }
    }
    const glm::dvec3 origin(this->Mesh.points[ofA[2]]);
    const auto cornersOf = [this, &origin](const glm::uvec3& points, int count)
    {
      Corners corners;
      corners.count = count;
      for (int i = 0; i < count; ++i)
      {
        corners.at[i] = glm::dvec3(this->Mesh.points[points[i]]) - origin;
      }
      return corners;
    };
    const Corners wholeA = cornersOf(ofA, 3), wholeB = cornersOf(ofB, 3);
    switch (apart)
    {
      case 3:
        return AreApart(wholeA, wholeB);
      case 2:
        // Beyond the corner they could only meet up to the side opposite to it, of either.
        return AreApart(cornersOf(ofA, 2), wholeB) && AreApart(cornersOf(ofB, 2), wholeA);
      case 1:
        return AreUnfolded(wholeA.at[1], wholeA.at[0], wholeB.at[0]);
      default:
        return false;
    }
  }

  const ShadowMesh<float>& Mesh;
  std::vector<Index> Order;
  std::vector<Node> Nodes;
};

bool IsManifold(const ShadowMesh<float>& mesh)
{
  const EdgeTable& edges = mesh.edges;
  return mesh.soup.NumberOfTriangles() == 0 && edges.borders.empty() && edges.fanSides.empty() &&
    std::all_of(mesh.pieces.begin(), mesh.pieces.end(),
      [](const MeshPiece& piece) { return piece.closed; }) &&
    std::none_of(edges.pairs.begin(), edges.pairs.end(),
      [](const EdgeTable::Pair& pair) { return (pair.second & RunsAlike) != 0; });
}

}

//------------------------------------------------------------------------------
bool IsEmbedded(const ShadowMesh<float>& mesh, const std::atomic<bool>& cancelled)
{
  std::size_t pairsLeft = PairsPerTriangle * mesh.triangles.size() + PairsAtLeast;
  return IsManifold(mesh) &&
    std::all_of(mesh.pieces.begin(), mesh.pieces.end(),
      [&](const MeshPiece& piece)
      { return PieceTree(mesh, piece).IsEmbedded(pairsLeft, cancelled); });
}

}
