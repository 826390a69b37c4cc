#include "ShadowVolume.h"

#include "Parallel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace vtkshadows
{
namespace
{

using Index = std::uint32_t;

// How far a lamp may be from a piece's triangles and yet lie on them, by what points are rounded
// by; negative if it is not within the piece's bounds and could lie on none.
double TouchOf(const MeshPiece& piece, const glm::dvec4& light, double rounding)
{
  if (light.w == 0.0)
  {
    return -1.0;
  }
  const glm::dvec3 largest = glm::max(glm::abs(piece.minimum), glm::abs(piece.maximum));
  const double touch = rounding * std::max({ largest.x, largest.y, largest.z });
  const glm::dvec3 position = glm::dvec3(light) / light.w;
  const bool isWithin = glm::all(glm::greaterThanEqual(position, piece.minimum - touch)) &&
    glm::all(glm::lessThanEqual(position, piece.maximum + touch));
  return isWithin ? touch : -1.0;
}

// Whether `p`, in the plane of the triangle a, b, c, lies beyond none of its sides by more than
// `touch`.
bool IsWithinSides(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
  const glm::dvec3& normal, const glm::dvec3& p, double touch)
{
  const auto isWithin = [&](const glm::dvec3& from, const glm::dvec3& to)
  {
    const glm::dvec3 inward = glm::cross(normal, to - from);
    return glm::dot(inward, p - from) >= -touch * glm::length(inward);
  };
  return isWithin(a, b) && isWithin(b, c) && isWithin(c, a);
}

// The signs of triangles that face the light, and of those that do not.
struct SignRule
{
  CastSign facing = 1;
  CastSign turned = -1;
};

SignRule RuleOf(const MeshPiece& piece, bool holdsLight, CastingFaces which)
{
  if (which == CastingFaces::All || !piece.closed || holdsLight)
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

// What is written by blocks on all cores is counted first, so that each block knows its places:
// calls use(first, last, counts) for each, with counts to be added to, and lays the lists out one
// after another, from `start` on.
template <std::size_t N, typename Use>
std::vector<std::array<std::size_t, N>> LayOut(std::size_t count, std::size_t start,
  const std::array<VolumeLists::List*, N>& lists, const Use& use)
{
  std::vector<std::array<std::size_t, N>> places(NumberOfBlocks(count));
  ForEachBlock(count,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::array<std::size_t, N> counts{};
      use(first, last, counts);
      places[block] = counts;
    });
  for (std::size_t list = 0; list < N; ++list)
  {
    lists[list]->first = start;
    for (std::array<std::size_t, N>& place : places)
    {
      const std::size_t size = place[list];
      place[list] = start;
      start += size;
    }
    lists[list]->count = start - lists[list]->first;
  }
  return places;
}

template <typename Real>
SilhouetteEdge EdgeOf(const ShadowMesh<Real>& mesh, HalfEdge side, int m, std::size_t number)
{
  const glm::uvec3 t = mesh.Corners(side / 3);
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

// Which list of soup a casting triangle is in.
std::size_t SoupListOf(CastSign sign, bool threeBorders)
{
  return sign > 0 ? (threeBorders ? 0 : 1) : (threeBorders ? 3 : 2);
}

}

//------------------------------------------------------------------------------
template <typename Real>
void FaceTriangles(const ShadowMesh<Real>& mesh, const glm::dvec4& light, CastingFaces which,
  std::vector<CastSign>& signs, TouchedFaces touched)
{
  signs.resize(mesh.NumberOfTriangles());
  std::vector<SignRule> rules;
  std::vector<double> touches;
  for (const MeshPiece& piece : mesh.pieces)
  {
    const double rounding =
      touched == TouchedFaces::CastNot ? 4.0 * std::numeric_limits<Real>::epsilon() : 0.0;
    const double touch = TouchOf(piece, light, rounding);
    rules.push_back(RuleOf(piece, touch >= 0.0, which));
    touches.push_back(touched == TouchedFaces::CastNot ? touch : -1.0);
  }
  ForEachBlock(signs.size(),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      // The piece that `first` is in, and those after it.
      std::size_t piece = std::upper_bound(mesh.pieces.begin(), mesh.pieces.end(), first,
                            [](std::size_t i, const MeshPiece& p) { return i < p.last; }) -
        mesh.pieces.begin();
      for (std::size_t i = first; i < last; ++piece)
      {
        const SignRule rule = rules[piece];
        const double touch = touches[piece];
        const std::size_t end = std::min<std::size_t>(last, mesh.pieces[piece].last);
        for (; i < end; ++i)
        {
          const glm::uvec3 t = mesh.Corners(i);
          const glm::dvec3 a(mesh.points[t.x]), b(mesh.points[t.y]), c(mesh.points[t.z]);
          const glm::dvec3 normal = glm::cross(b - a, c - a);
          const double height = glm::dot(normal, glm::dvec3(light) - a * light.w);
          signs[i] = height > 0.0 ? rule.facing : rule.turned;
          const double reach = touch * light.w;
          if (touch >= 0.0 && height * height <= reach * reach * glm::dot(normal, normal) &&
            IsWithinSides(a, b, c, normal, glm::dvec3(light) / light.w, touch))
          {
            signs[i] = 0;
          }
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
  std::size_t number = mesh.edges.NumberOfEdges();
  for (std::size_t i = mesh.triangles.size(); i < mesh.NumberOfTriangles(); ++i)
  {
    const auto triangle = static_cast<Index>(i - mesh.triangles.size());
    for (Index side = 0; side < 3; ++side)
    {
      if (side != mesh.soup.InnerSide(triangle) && signs[i] != 0)
      {
        silhouette.push_back(EdgeOf(mesh, static_cast<HalfEdge>(3 * i + side), signs[i], number++));
      }
    }
  }
}

//------------------------------------------------------------------------------
template <typename Real>
VolumeEmitter<Real>::VolumeEmitter(
  const ShadowMesh<Real>& mesh, const std::vector<CastSign>& signs, bool oneImage)
  : Mesh(mesh)
  , Signs(signs)
  , OneImage(oneImage)
{
  VolumeLists& lists = this->Found;
  const std::size_t others = mesh.triangles.size();
  const SoupTriangles& soup = mesh.soup;
  this->SoupPlaces = LayOut<4>(soup.NumberOfTriangles(), 0,
    { &lists.threeSided, &lists.twoSided, &lists.turnedTwoSided, &lists.turnedThreeSided },
    [&](std::size_t first, std::size_t last, std::array<std::size_t, 4>& counts)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const CastSign sign = signs[others + i];
        counts[SoupListOf(sign, i < soup.starts[1])] += sign != 0 ? 1 : 0;
      }
    });
  const std::size_t perSide = oneImage ? 3 : 6;
  this->SidePlaces = LayOut<2>(mesh.edges.NumberOfEdges(), lists.turnedThreeSided.End(),
    { &lists.singles, &lists.doubles },
    [&](std::size_t first, std::size_t last, std::array<std::size_t, 2>& counts)
    {
      ForEachSilhouetteEdge(mesh.edges, signs, first, last,
        [&](HalfEdge, int m, std::size_t)
        {
          counts[0] += SinglesOf(m) * perSide;
          counts[1] += DoublesOf(m) * perSide;
        });
    });
  this->CapPlaces = LayOut<2>(others, lists.doubles.End(), { &lists.caps, &lists.turnedCaps },
    [&](std::size_t first, std::size_t last, std::array<std::size_t, 2>& counts)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        counts[0] += signs[i] > 0 ? 3 : 0;
        counts[1] += signs[i] < 0 ? 3 : 0;
      }
    });
}

//------------------------------------------------------------------------------
template <typename Real>
void VolumeEmitter<Real>::Write(std::uint32_t* numbers) const
{
  const ShadowMesh<Real>& mesh = this->Mesh;
  const std::vector<CastSign>& signs = this->Signs;
  const std::size_t others = mesh.triangles.size();
  ForEachBlock(mesh.soup.NumberOfTriangles(),
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::array<std::size_t, 4> places = this->SoupPlaces[block];
      for (auto i = static_cast<Index>(first); i < last; ++i)
      {
        const CastSign sign = signs[others + i];
        if (sign != 0)
        {
          const Index innerSide = mesh.soup.InnerSide(i);
          numbers[places[SoupListOf(sign, innerSide == 3)]++] = SoupEntry(i, innerSide);
        }
      }
    });
  ForEachBlock(mesh.edges.NumberOfEdges(),
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      Index* single = numbers + this->SidePlaces[block][0];
      Index* twice = numbers + this->SidePlaces[block][1];
      ForEachSilhouetteEdge(mesh.edges, signs, first, last,
        [&](HalfEdge side, int m, std::size_t number)
        {
          const SilhouetteEdge edge = EdgeOf(mesh, side, m, number);
          for (std::size_t n = 0; n < SinglesOf(m); ++n)
          {
            single = WriteSide(single, edge, this->OneImage);
          }
          for (std::size_t n = 0; n < DoublesOf(m); ++n)
          {
            twice = WriteSide(twice, edge, this->OneImage);
          }
        });
    });
  ForEachBlock(others,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      Index* facing = numbers + this->CapPlaces[block][0];
      Index* turned = numbers + this->CapPlaces[block][1];
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

//------------------------------------------------------------------------------
template <typename Real>
int CountCrossed(const ShadowMesh<Real>& mesh, const std::vector<CastSign>& signs,
  const glm::dvec4& light, const glm::dvec3& direction)
{
  const glm::dvec3 origin = glm::dvec3(light) / light.w;
  return tbb::parallel_reduce(
    tbb::blocked_range<std::size_t>(0, mesh.NumberOfTriangles(), BlockSize), 0,
    [&](const tbb::blocked_range<std::size_t>& range, int count)
    {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        const glm::uvec3 t = mesh.Corners(i);
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
  CastingFaces which, std::vector<CastSign>& signs, TouchedFaces touched);
template void FaceTriangles(const ShadowMesh<double>& mesh, const glm::dvec4& light,
  CastingFaces which, std::vector<CastSign>& signs, TouchedFaces touched);
template void FindSilhouette(const ShadowMesh<float>& mesh, const std::vector<CastSign>& signs,
  std::vector<SilhouetteEdge>& silhouette);
template void FindSilhouette(const ShadowMesh<double>& mesh, const std::vector<CastSign>& signs,
  std::vector<SilhouetteEdge>& silhouette);
template class VolumeEmitter<float>;
template class VolumeEmitter<double>;
template int CountCrossed(const ShadowMesh<float>& mesh, const std::vector<CastSign>& signs,
  const glm::dvec4& light, const glm::dvec3& direction);
template int CountCrossed(const ShadowMesh<double>& mesh, const std::vector<CastSign>& signs,
  const glm::dvec4& light, const glm::dvec3& direction);

}
