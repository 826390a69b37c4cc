#include "LightTriangles.h"

#include "Parallel.h"

namespace vtkshadows
{
namespace
{

std::uint32_t& BeyondSide(std::vector<TriangleNeighbours>& neighbours, HalfEdge side)
{
  return neighbours[side / 3][side % 3];
}

}

std::vector<TriangleNeighbours> FindNeighbours(
  const EdgeTable& edges, std::size_t numberOfTriangles)
{
  std::vector<TriangleNeighbours> neighbours(
    numberOfTriangles, { NoTriangle, NoTriangle, NoTriangle });
  ForEachBlock(edges.pairs.size(),
    [&](std::size_t, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const HalfEdge first = edges.pairs[i].first;
        const HalfEdge second = edges.pairs[i].second & ~RunsAlike;
        const std::uint32_t alike = edges.pairs[i].second & RunsAlike;
        BeyondSide(neighbours, first) = second / 3 | alike;
        BeyondSide(neighbours, second) = first / 3 | alike;
      }
    });
  return neighbours;
}

LightTriangles::LightTriangles(const ShadowMesh<float>& mesh,
  const std::vector<TriangleNeighbours>& neighbours, const glm::dmat4& lightFromMesh,
  const glm::dvec4& light, bool mirrored, const std::vector<std::uint32_t>& order)
  : Mesh(mesh)
  , Neighbours(neighbours)
  , Order(order)
  , LightFromMesh(lightFromMesh)
  , Mirrored(mirrored)
{
  FaceTriangles(mesh, light, CastingFaces::Closed, this->Signs);
  const std::size_t count = mesh.triangles.size();
  this->Places.resize(count, NoTriangle);
  std::vector<std::size_t> starts(NumberOfBlocks(count) + 1, 0);
  ForEachBlock(count,
    [&](std::size_t block, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        starts[block + 1] += this->Signs[this->At(i)] != 0 ? 1 : 0;
      }
    });
  for (std::size_t block = 1; block < starts.size(); ++block)
  {
    starts[block] += starts[block - 1];
  }
  this->NumberListed = starts.back();
  ForEachBlock(count,
    [&](std::size_t block, std::size_t begin, std::size_t end)
    {
      auto place = static_cast<std::uint32_t>(starts[block]);
      for (std::size_t i = begin; i < end; ++i)
      {
        if (this->Signs[this->At(i)] != 0)
        {
          this->Places[this->At(i)] = place++;
        }
      }
    });
}

std::size_t LightTriangles::CountOf(std::size_t first, std::size_t count) const
{
  std::size_t listed = 0;
  for (std::size_t i = first; i < first + count; ++i)
  {
    listed += this->Signs[this->At(i)] != 0 ? 1 : 0;
  }
  return listed;
}

void LightTriangles::Write(LightCorner* corners, std::uint32_t first) const
{
  std::vector<glm::vec3> points(this->Mesh.points.size());
  ForEachBlock(points.size(),
    [&](std::size_t, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const glm::dvec4 p =
          this->LightFromMesh * glm::dvec4(glm::dvec3(this->Mesh.points[i]), 1.0);
        points[i] = glm::vec3(glm::dvec3(p) / p.w);
      }
    });
  const auto beyond = [&](std::size_t triangle, int side)
  {
    const std::uint32_t neighbour = this->Neighbours[triangle][side];
    if (neighbour == NoTriangle)
    {
      return 0.0f;
    }
    const std::uint32_t other = neighbour & ~RunsAlike;
    // Turned toward the light, two neighbours have a side in opposite directions, unless one is
    // folded back over the other.
    const bool isFolded =
      (this->Signs[triangle] == this->Signs[other]) == ((neighbour & RunsAlike) != 0);
    return this->Places[other] == NoTriangle || isFolded
      ? 0.0f
      : static_cast<float>(first + this->Places[other]);
  };
  ForEachBlock(this->Mesh.triangles.size(),
    [&](std::size_t, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        if (this->Places[i] == NoTriangle)
        {
          continue;
        }
        const glm::uvec3 t = this->Mesh.triangles[i];
        LightCorner* out = corners + std::size_t(3) * this->Places[i];
        const bool turned = (this->Signs[i] < 0) != this->Mirrored;
        out[0] = { points[t[0]], beyond(i, turned ? 2 : 0) };
        out[1] = { points[turned ? t[2] : t[1]], beyond(i, 1) };
        out[2] = { points[turned ? t[1] : t[2]], beyond(i, turned ? 0 : 2) };
      }
    });
}

}
