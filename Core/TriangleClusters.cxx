#include "TriangleClusters.h"

#include "SeenBoxes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace vtkshadows
{
namespace
{

// Of the terms that clip coordinates are summed from: many times what single precision rounds
// there.
constexpr double Rounding = 1.0e-5;

constexpr int StepsOfShare = 8; // along each axis

struct Centred
{
  glm::vec3 centre; // times three
  glm::uvec3 triangle;
  std::size_t place; // in the mesh
};

TriangleCluster BoundsOf(const std::vector<glm::vec3>& vertices,
  const std::vector<Centred>& triangles, std::size_t first, std::size_t count)
{
  constexpr float Infinity = std::numeric_limits<float>::infinity();
  TriangleCluster cluster{ first, count, glm::vec3(Infinity), glm::vec3(-Infinity) };
  for (std::size_t i = first; i < first + count; ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const glm::vec3& p = vertices[triangles[i].triangle[corner]];
      cluster.minimum = glm::min(cluster.minimum, p);
      cluster.maximum = glm::max(cluster.maximum, p);
    }
  }
  return cluster;
}

// The axis along which the centres lie farthest apart.
int LongestAxis(const std::vector<Centred>& triangles, std::size_t first, std::size_t count)
{
  glm::vec3 least = triangles[first].centre, most = least;
  for (std::size_t i = first; i < first + count; ++i)
  {
    least = glm::min(least, triangles[i].centre);
    most = glm::max(most, triangles[i].centre);
  }
  const glm::vec3 size = most - least;
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

std::vector<Centred> CentresOf(
  const std::vector<glm::vec3>& vertices, const std::vector<glm::uvec3>& triangles)
{
  std::vector<Centred> centred;
  centred.reserve(triangles.size());
  for (const glm::uvec3& t : triangles)
  {
    centred.push_back({ vertices[t.x] + vertices[t.y] + vertices[t.z], t, centred.size() });
  }
  return centred;
}

// Brings them into the order of the clusters.
std::vector<TriangleCluster> Cluster(
  const std::vector<glm::vec3>& vertices, std::vector<Centred>& centred, std::size_t most)
{
  std::vector<TriangleCluster> clusters;
  struct Range
  {
    std::size_t first, count;
  };
  std::vector<Range> open;
  if (!centred.empty())
  {
    open.push_back({ 0, centred.size() });
  }
  while (!open.empty())
  {
    const Range range = open.back();
    open.pop_back();
    const auto begin = centred.begin() + static_cast<std::ptrdiff_t>(range.first);
    const auto end = begin + static_cast<std::ptrdiff_t>(range.count);
    if (range.count <= std::max<std::size_t>(most, 1))
    {
      std::sort(begin, end, [](const Centred& a, const Centred& b) { return a.place < b.place; });
      clusters.push_back(BoundsOf(vertices, centred, range.first, range.count));
      continue;
    }
    const int axis = LongestAxis(centred, range.first, range.count);
    const std::size_t half = range.count / 2;
    std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(half), end,
      [axis](const Centred& a, const Centred& b) { return a.centre[axis] < b.centre[axis]; });
    open.push_back({ range.first + half, range.count - half });
    open.push_back({ range.first, half }); // the next, so that clusters follow each other
  }
  return clusters;
}

}

//------------------------------------------------------------------------------
std::vector<TriangleCluster> ClusterTriangles(
  const std::vector<glm::vec3>& vertices, std::vector<glm::uvec3>& triangles, std::size_t most)
{
  std::vector<Centred> centred = CentresOf(vertices, triangles);
  std::vector<TriangleCluster> clusters = Cluster(vertices, centred, most);
  std::transform(centred.begin(), centred.end(), triangles.begin(),
    [](const Centred& entry) { return entry.triangle; });
  return clusters;
}

std::vector<TriangleCluster> ClusterTriangles(const std::vector<glm::vec3>& vertices,
  const std::vector<glm::uvec3>& triangles, std::size_t most, std::vector<std::uint32_t>& order)
{
  std::vector<Centred> centred = CentresOf(vertices, triangles);
  std::vector<TriangleCluster> clusters = Cluster(vertices, centred, most);
  order.resize(centred.size());
  std::transform(centred.begin(), centred.end(), order.begin(),
    [](const Centred& entry) { return static_cast<std::uint32_t>(entry.place); });
  return clusters;
}

//------------------------------------------------------------------------------
void OrderVertices(std::vector<glm::vec3>& vertices, std::vector<glm::uvec3>& triangles)
{
  constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> numbers(vertices.size(), None);
  std::vector<glm::vec3> ordered;
  ordered.reserve(vertices.size());
  for (glm::uvec3& triangle : triangles)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      std::uint32_t& number = numbers[triangle[corner]];
      if (number == None)
      {
        number = static_cast<std::uint32_t>(ordered.size());
        ordered.push_back(vertices[triangle[corner]]);
      }
      triangle[corner] = number;
    }
  }
  vertices.swap(ordered);
}

//------------------------------------------------------------------------------
ViewSides::ViewSides(const glm::dmat4& clipFromMesh)
{
  const std::array<glm::dvec4, 6> planes = ViewPlanes(clipFromMesh);
  std::copy_n(planes.begin(), SidePlanes, this->Planes.begin());
  const glm::dvec4 depth = glm::abs(glm::row(clipFromMesh, 3));
  for (int i = 0; i < 2; ++i)
  {
    this->Terms[i] = glm::abs(glm::row(clipFromMesh, i)) + depth;
  }
}

bool ViewSides::LeaveOut(const glm::vec3& minimum, const glm::vec3& maximum) const
{
  const glm::dvec3 low(minimum), high(maximum);
  const glm::dvec4 largest(glm::max(glm::abs(low), glm::abs(high)), 1.0);
  for (std::size_t i = 0; i < SidePlanes; ++i)
  {
    const glm::dvec4& plane = this->Planes[i];
    // The corner farthest within.
    const glm::dvec4 corner(plane.x > 0.0 ? high.x : low.x, plane.y > 0.0 ? high.y : low.y,
      plane.z > 0.0 ? high.z : low.z, 1.0);
    if (glm::dot(plane, corner) < -Rounding * glm::dot(this->Terms[i / 2], largest))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void TriangleRanges::Add(std::size_t first, std::size_t count)
{
  if (count == 0)
  {
    return;
  }
  if (!this->Ranges.empty() && this->Ranges.back().first + this->Ranges.back().count == first)
  {
    this->Ranges.back().count += count;
    return;
  }
  this->Ranges.push_back({ first, count });
}

void TriangleRanges::AddSeen(
  const std::vector<TriangleCluster>& clusters, const glm::dmat4& clipFromMesh, std::size_t listed)
{
  const ViewSides sides(clipFromMesh);
  for (const TriangleCluster& cluster : clusters)
  {
    if (!sides.LeaveOut(cluster.minimum, cluster.maximum))
    {
      this->Add(listed + cluster.first, cluster.count);
    }
  }
}

//------------------------------------------------------------------------------
double ShareWithin(const glm::dmat4& clipFromWorld, const BoxCorners& box)
{
  const std::array<glm::dvec4, 6> planes = ViewPlanes(clipFromWorld);
  const glm::dmat3 axes(box[1] - box[0], box[2] - box[0], box[4] - box[0]);
  int within = 0;
  for (int i = 0; i < StepsOfShare * StepsOfShare * StepsOfShare; ++i)
  {
    const glm::dvec3 cell(
      i % StepsOfShare, i / StepsOfShare % StepsOfShare, i / (StepsOfShare * StepsOfShare));
    const glm::dvec4 p(box[0] + axes * ((cell + 0.5) / double(StepsOfShare)), 1.0);
    within += std::all_of(planes.begin(), planes.begin() + SidePlanes,
      [&p](const glm::dvec4& plane) { return glm::dot(plane, p) >= 0.0; });
  }
  return static_cast<double>(within) / (StepsOfShare * StepsOfShare * StepsOfShare);
}

}
