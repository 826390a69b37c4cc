#include "ShadowVolume.h"

#include "Parallel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <tbb/parallel_reduce.h>

#include <cstdlib>

namespace vtkshadows
{
namespace
{

using Index = std::uint32_t;

bool HoldsLight(const MeshPiece& piece, const glm::dvec4& light)
{
  const glm::dvec3 position = glm::dvec3(light);
  return light.w != 0.0 && glm::all(glm::greaterThanEqual(position, piece.minimum * light.w)) &&
    glm::all(glm::lessThanEqual(position, piece.maximum * light.w));
}

// The signs of triangles that face the light, and of those that do not.
struct SignRule
{
  CastSign facing = 1;
  CastSign turned = -1;
};

SignRule RuleOf(const MeshPiece& piece, const glm::dvec4& light, CastingFaces which)
{
  if (which == CastingFaces::All || !piece.closed || HoldsLight(piece, light))
  {
    return { 1, -1 };
  }
  return piece.insideOut ? SignRule{ 0, -1 } : SignRule{ 1, 0 };
}

// Edges by one number: borders, then pairs, then fans. Calls use(side, m, number) for those of the
// numbers first .. last whose signed multiplicity m is not 0; m counts along `side`.
template <typename Use>
void ForEachSilhouetteEdge(const EdgeTable& edges, const std::vector<CastSign>& signs,
  std::size_t first, std::size_t last, const Use& use)
{
  const std::size_t pairsFrom = edges.borders.size();
  const std::size_t fansFrom = pairsFrom + edges.pairs.size();
  std::size_t i = first;
  for (; i < std::min(last, pairsFrom); ++i)
  {
    const HalfEdge side = edges.borders[i];
    const int m = signs[side / 3];
    if (m != 0)
    {
      use(side, m, i);
    }
  }
  for (; i < std::min(last, fansFrom); ++i)
  {
    const EdgeTable::Pair pair = edges.pairs[i - pairsFrom];
    const int other = signs[(pair.second & ~RunsAlike) / 3];
    const int m = signs[pair.first / 3] + (pair.second & RunsAlike ? other : -other);
    if (m != 0)
    {
      use(pair.first, m, i);
    }
  }
  for (; i < last; ++i)
  {
    const HalfEdge* const sides = edges.fanSides.data() + edges.fanStarts[i - fansFrom];
    const HalfEdge* const end = edges.fanSides.data() + edges.fanStarts[i - fansFrom + 1];
    int m = signs[sides[0] / 3];
    for (const HalfEdge* side = sides + 1; side != end; ++side)
    {
      const int sign = signs[(*side & ~RunsAlike) / 3];
      m += *side & RunsAlike ? sign : -sign;
    }
    if (m != 0)
    {
      use(sides[0], m, i);
    }
  }
}

// What is written by blocks on all cores: counted first, so that each block knows its place.
class BlockPlaces
{
public:
  explicit BlockPlaces(std::size_t blocks)
    : Counts(blocks + 1, 0)
  {
  }
  void SetCount(std::size_t block, std::size_t count) { this->Counts[block + 1] = count; }
  std::size_t Total()
  {
    for (std::size_t i = 1; i < this->Counts.size(); ++i)
    {
      this->Counts[i] += this->Counts[i - 1];
    }
    return this->Counts.back();
  }
  std::size_t Place(std::size_t block) const { return this->Counts[block]; }

private:
  std::vector<std::size_t> Counts;
};

template <typename Real>
SilhouetteEdge EdgeOf(const ShadowMesh<Real>& mesh, HalfEdge side, int m, std::size_t number)
{
  const glm::uvec3& t = mesh.triangles[side / 3];
  const Index corner = side % 3;
  const Index from = t[corner], to = t[corner == 2 ? 0 : corner + 1];
  const auto edge = static_cast<Index>(number);
  return m > 0 ? SilhouetteEdge{ from, to, static_cast<Index>(m), side, edge }
               : SilhouetteEdge{ to, from, static_cast<Index>(-m), side, edge };
}

// Repeats of a side among the singles and among the doubles.
std::size_t SinglesOf(int m)
{
  return std::abs(m) % 2;
}
std::size_t DoublesOf(int m)
{
  return std::abs(m) / 2;
}

Index* WriteSide(Index* out, const SilhouetteEdge& edge, bool oneImage)
{
  const Index from = 2 * edge.from, to = 2 * edge.to;
  *out++ = to;
  *out++ = from;
  *out++ = from + 1;
  if (!oneImage)
  {
    *out++ = to;
    *out++ = from + 1;
    *out++ = to + 1;
  }
  return out;
}

template <typename Real>
void EmitSides(const ShadowMesh<Real>& mesh, const std::vector<CastSign>& signs, bool oneImage,
  VolumeIndices& indices)
{
  const std::size_t edges = mesh.edges.NumberOfEdges();
  const std::size_t perSide = oneImage ? 3 : 6;
  BlockPlaces singles(NumberOfBlocks(edges)), doubles(NumberOfBlocks(edges));
  ForEachBlock(edges,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::size_t single = 0, twice = 0;
      ForEachSilhouetteEdge(mesh.edges, signs, first, last,
        [&](HalfEdge, int m, std::size_t)
        {
          single += SinglesOf(m);
          twice += DoublesOf(m);
        });
      singles.SetCount(block, single * perSide);
      doubles.SetCount(block, twice * perSide);
    });
  indices.singles.resize(singles.Total());
  indices.doubles.resize(doubles.Total());
  ForEachBlock(edges,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      Index* single = indices.singles.data() + singles.Place(block);
      Index* twice = indices.doubles.data() + doubles.Place(block);
      ForEachSilhouetteEdge(mesh.edges, signs, first, last,
        [&](HalfEdge side, int m, std::size_t number)
        {
          const SilhouetteEdge edge = EdgeOf(mesh, side, m, number);
          for (std::size_t n = 0; n < SinglesOf(m); ++n)
          {
            single = WriteSide(single, edge, oneImage);
          }
          for (std::size_t n = 0; n < DoublesOf(m); ++n)
          {
            twice = WriteSide(twice, edge, oneImage);
          }
        });
    });
}

template <typename Real>
void EmitCaps(
  const ShadowMesh<Real>& mesh, const std::vector<CastSign>& signs, VolumeIndices& indices)
{
  const std::size_t count = mesh.triangles.size();
  BlockPlaces caps(NumberOfBlocks(count)), turnedCaps(NumberOfBlocks(count));
  ForEachBlock(count,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::size_t facing = 0, turned = 0;
      for (std::size_t i = first; i < last; ++i)
      {
        facing += signs[i] > 0 ? 3 : 0;
        turned += signs[i] < 0 ? 3 : 0;
      }
      caps.SetCount(block, facing);
      turnedCaps.SetCount(block, turned);
    });
  indices.caps.resize(caps.Total());
  indices.turnedCaps.resize(turnedCaps.Total());
  ForEachBlock(count,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      Index* facing = indices.caps.data() + caps.Place(block);
      Index* turned = indices.turnedCaps.data() + turnedCaps.Place(block);
      for (std::size_t i = first; i < last; ++i)
      {
        if (signs[i] != 0)
        {
          Index*& out = signs[i] > 0 ? facing : turned;
          const glm::uvec3& t = mesh.triangles[i];
          *out++ = 2 * t.x;
          *out++ = 2 * t.y;
          *out++ = 2 * t.z;
        }
      }
    });
}

}

//------------------------------------------------------------------------------
template <typename Real>
void FaceTriangles(const ShadowMesh<Real>& mesh, const glm::dvec4& light, CastingFaces which,
  std::vector<CastSign>& signs)
{
  signs.resize(mesh.triangles.size());
  std::vector<SignRule> rules;
  for (const MeshPiece& piece : mesh.pieces)
  {
    rules.push_back(RuleOf(piece, light, which));
  }
  ForEachBlock(mesh.triangles.size(),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      // The piece that `first` is in, and those after it.
      std::size_t piece = std::upper_bound(mesh.pieces.begin(), mesh.pieces.end(), first,
                            [](std::size_t i, const MeshPiece& p) { return i < p.last; }) -
        mesh.pieces.begin();
      for (std::size_t i = first; i < last; ++piece)
      {
        const SignRule rule = rules[piece];
        const std::size_t end = std::min<std::size_t>(last, mesh.pieces[piece].last);
        for (; i < end; ++i)
        {
          const glm::uvec3& t = mesh.triangles[i];
          const glm::dvec3 a(mesh.points[t.x]), b(mesh.points[t.y]), c(mesh.points[t.z]);
          const glm::dvec3 normal = glm::cross(b - a, c - a);
          const bool faces = glm::dot(normal, glm::dvec3(light) - a * light.w) > 0.0;
          signs[i] = faces ? rule.facing : rule.turned;
        }
      }
    });
}

//------------------------------------------------------------------------------
template <typename Real>
void FindSilhouette(const ShadowMesh<Real>& mesh, const std::vector<CastSign>& signs,
  std::vector<SilhouetteEdge>& silhouette)
{
  silhouette.clear();
  ForEachSilhouetteEdge(mesh.edges, signs, 0, mesh.edges.NumberOfEdges(),
    [&](HalfEdge side, int m, std::size_t number)
    { silhouette.push_back(EdgeOf(mesh, side, m, number)); });
}

//------------------------------------------------------------------------------
template <typename Real>
void EmitVolume(const ShadowMesh<Real>& mesh, const std::vector<CastSign>& signs, bool oneImage,
  VolumeIndices& indices)
{
  EmitSides(mesh, signs, oneImage, indices);
  EmitCaps(mesh, signs, indices);
}

//------------------------------------------------------------------------------
template <typename Real>
int CountCrossed(const ShadowMesh<Real>& mesh, const std::vector<CastSign>& signs,
  const glm::dvec4& light, const glm::dvec3& direction)
{
  const glm::dvec3 origin = glm::dvec3(light) / light.w;
  return tbb::parallel_reduce(
    tbb::blocked_range<std::size_t>(0, mesh.triangles.size(), BlockSize), 0,
    [&](const tbb::blocked_range<std::size_t>& range, int count)
    {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        const glm::uvec3& t = mesh.triangles[i];
        const glm::dvec3 a = glm::dvec3(mesh.points[t.x]) - origin;
        const glm::dvec3 b = glm::dvec3(mesh.points[t.y]) - origin;
        const glm::dvec3 c = glm::dvec3(mesh.points[t.z]) - origin;
        // Within all three planes through the origin and a side, on the same side as the triangle.
        const double ab = glm::dot(glm::cross(a, b), direction);
        const double bc = glm::dot(glm::cross(b, c), direction);
        const double ca = glm::dot(glm::cross(c, a), direction);
        const double volume = glm::dot(glm::cross(a, b), c);
        const double sign = volume < 0.0 ? -1.0 : 1.0;
        const bool isCrossed = ab * sign > 0.0 && bc * sign > 0.0 && ca * sign > 0.0;
        count += signs[i] != 0 && isCrossed ? 1 : 0;
      }
      return count;
    },
    [](int a, int b) { return a + b; });
}

template void FaceTriangles(const ShadowMesh<float>& mesh, const glm::dvec4& light,
  CastingFaces which, std::vector<CastSign>& signs);
template void FaceTriangles(const ShadowMesh<double>& mesh, const glm::dvec4& light,
  CastingFaces which, std::vector<CastSign>& signs);
template void FindSilhouette(const ShadowMesh<float>& mesh, const std::vector<CastSign>& signs,
  std::vector<SilhouetteEdge>& silhouette);
template void FindSilhouette(const ShadowMesh<double>& mesh, const std::vector<CastSign>& signs,
  std::vector<SilhouetteEdge>& silhouette);
template void EmitVolume(const ShadowMesh<float>& mesh, const std::vector<CastSign>& signs,
  bool oneImage, VolumeIndices& indices);
template void EmitVolume(const ShadowMesh<double>& mesh, const std::vector<CastSign>& signs,
  bool oneImage, VolumeIndices& indices);
template int CountCrossed(const ShadowMesh<float>& mesh, const std::vector<CastSign>& signs,
  const glm::dvec4& light, const glm::dvec3& direction);
template int CountCrossed(const ShadowMesh<double>& mesh, const std::vector<CastSign>& signs,
  const glm::dvec4& light, const glm::dvec3& direction);

}
