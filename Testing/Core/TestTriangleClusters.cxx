// Clusters hold all triangles, and a view's clusters all that it sees.
#include "BoxesByLot.h"
#include "TriangleClusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <tuple>

using namespace vtkshadows;
using namespace coretest;

namespace
{

struct Mesh
{
  std::vector<glm::vec3> vertices;
  std::vector<glm::uvec3> triangles;
};

// A rough country, so many cells a side.
Mesh Country(unsigned int cells, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> height(-0.1f, 0.1f);
  Mesh mesh;
  const unsigned int row = cells + 1;
  for (unsigned int i = 0; i < row * row; ++i)
  {
    mesh.vertices.emplace_back(
      2.0f * (i % row) / cells - 1.0f, 2.0f * (i / row) / cells - 1.0f, height(random));
  }
  for (unsigned int y = 0; y < cells; ++y)
  {
    for (unsigned int x = 0; x < cells; ++x)
    {
      const unsigned int a = y * row + x;
      mesh.triangles.emplace_back(a, a + 1, a + row);
      mesh.triangles.emplace_back(a + 1, a + row + 1, a + row);
    }
  }
  return mesh;
}

std::vector<glm::uvec3> Sorted(std::vector<glm::uvec3> triangles)
{
  std::sort(triangles.begin(), triangles.end(),
    [](const glm::uvec3& a, const glm::uvec3& b)
    { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
  return triangles;
}

bool IsWithinSides(const glm::dvec4& clip)
{
  return std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
}

}

//------------------------------------------------------------------------------
TEST(TriangleClusters, HoldAllTriangles)
{
  for (const unsigned int cells : { 1u, 5u, 40u })
  {
    const Mesh mesh = Country(cells, cells);
    std::vector<glm::uvec3> triangles = mesh.triangles;
    const std::vector<TriangleCluster> clusters = ClusterTriangles(mesh.vertices, triangles, 64);
    EXPECT_EQ(Sorted(triangles), Sorted(mesh.triangles));
    std::size_t next = 0;
    for (const TriangleCluster& cluster : clusters)
    {
      EXPECT_EQ(cluster.first, next) << "one after another";
      EXPECT_GE(cluster.count, 1u);
      EXPECT_LE(cluster.count, 64u);
      for (std::size_t i = cluster.first; i < cluster.first + cluster.count; ++i)
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          const glm::vec3& p = mesh.vertices[triangles[i][corner]];
          for (int axis = 0; axis < 3; ++axis)
          {
            EXPECT_GE(p[axis], cluster.minimum[axis]);
            EXPECT_LE(p[axis], cluster.maximum[axis]);
          }
        }
      }
      next += cluster.count;
    }
    EXPECT_EQ(next, triangles.size());
  }
}

//------------------------------------------------------------------------------
TEST(TriangleClusters, OrderAlone)
{
  const Mesh mesh = Country(30, 3);
  std::vector<glm::uvec3> reordered = mesh.triangles;
  const std::vector<TriangleCluster> clusters = ClusterTriangles(mesh.vertices, reordered, 100);
  std::vector<std::uint32_t> order;
  const std::vector<TriangleCluster> alike =
    ClusterTriangles(mesh.vertices, mesh.triangles, 100, order);
  ASSERT_EQ(order.size(), reordered.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    EXPECT_EQ(mesh.triangles[order[i]], reordered[i]);
  }
  ASSERT_EQ(alike.size(), clusters.size());
  for (std::size_t i = 0; i < alike.size(); ++i)
  {
    EXPECT_EQ(alike[i].first, clusters[i].first);
    EXPECT_EQ(alike[i].count, clusters[i].count);
    EXPECT_EQ(alike[i].minimum, clusters[i].minimum);
    EXPECT_EQ(alike[i].maximum, clusters[i].maximum);
  }
}

//------------------------------------------------------------------------------
TEST(TriangleClusters, VerticesAsTheyAreUsed)
{
  const Mesh mesh = Country(20, 7);
  Mesh ordered = mesh;
  ordered.vertices.emplace_back(9.0f); // which no triangle uses
  ClusterTriangles(ordered.vertices, ordered.triangles, 50);
  const Mesh before = ordered;
  OrderVertices(ordered.vertices, ordered.triangles);
  ASSERT_EQ(ordered.vertices.size(), mesh.vertices.size());
  ASSERT_EQ(ordered.triangles.size(), mesh.triangles.size());
  unsigned int most = 0;
  for (std::size_t i = 0; i < ordered.triangles.size(); ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const unsigned int number = ordered.triangles[i][corner];
      EXPECT_EQ(ordered.vertices[number], before.vertices[before.triangles[i][corner]]);
      EXPECT_LE(number, most) << "no vertex before it was used";
      most = std::max(most, number + 1);
    }
  }
}

//------------------------------------------------------------------------------
TEST(TriangleClusters, NoneAndAlike)
{
  std::vector<glm::uvec3> none;
  EXPECT_TRUE(ClusterTriangles({}, none, 64).empty());
  // All at one place: no axis tells them apart.
  const std::vector<glm::vec3> points(3, glm::vec3(2.0f));
  std::vector<glm::uvec3> alike(100, glm::uvec3(0, 1, 2));
  const std::vector<TriangleCluster> clusters = ClusterTriangles(points, alike, 30);
  EXPECT_EQ(clusters.size(), 4u);
  EXPECT_EQ(clusters.front().minimum, glm::vec3(2.0f));
  EXPECT_EQ(clusters.front().maximum, glm::vec3(2.0f));
}

//------------------------------------------------------------------------------
// Of a country of 20 000 triangles a view of a tenth draws little more than a tenth, and all of it.
TEST(TriangleClusters, AViewDrawsWhatItSees)
{
  const Mesh mesh = Country(100, 3);
  std::vector<glm::uvec3> triangles = mesh.triangles;
  const std::vector<TriangleCluster> clusters = ClusterTriangles(mesh.vertices, triangles, 256);
  Lot lot(5);
  std::size_t beside = 0, seen = 0;
  for (int scene = 0; scene < Scenes; ++scene)
  {
    const glm::dmat4 clipFromMesh = lot.AnyView().ClipFromWorld();
    for (const TriangleCluster& cluster : clusters)
    {
      const bool isBeside = ViewSides(clipFromMesh).LeaveOut(cluster.minimum, cluster.maximum);
      beside += isBeside;
      seen += !isBeside;
      for (std::size_t i = cluster.first; isBeside && i < cluster.first + cluster.count; ++i)
      {
        const glm::uvec3& t = triangles[i];
        const glm::dvec3 a(mesh.vertices[t.x]), b(mesh.vertices[t.y]), c(mesh.vertices[t.z]);
        for (const glm::dvec3& p :
          { a, b, c, (a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0, (a + b + c) / 3.0 })
        {
          ASSERT_FALSE(IsWithinSides(clipFromMesh * glm::dvec4(p, 1.0)));
        }
      }
    }
  }
  EXPECT_GT(beside, 0u);
  EXPECT_GT(seen, 0u);

  const BoxCorners unit = CornersOf(glm::dvec3(0.0), 1.0);
  // From above, by a square of a tenth of the country's.
  const double half = std::sqrt(0.1);
  glm::dmat4 clipFromMesh(1.0);
  clipFromMesh[0][0] = clipFromMesh[1][1] = 1.0 / half;
  std::size_t drawn = 0;
  for (const TriangleCluster& cluster : clusters)
  {
    drawn += ViewSides(clipFromMesh).LeaveOut(cluster.minimum, cluster.maximum) ? 0 : cluster.count;
  }
  EXPECT_GT(drawn, 0.1 * triangles.size());
  EXPECT_LT(drawn, 0.25 * triangles.size());
  EXPECT_NEAR(ShareWithin(clipFromMesh, unit), 0.1, 0.05);
  EXPECT_EQ(ShareWithin(glm::dmat4(1.0), unit), 1.0);
  clipFromMesh[3][0] = 10.0;
  EXPECT_EQ(ShareWithin(clipFromMesh, unit), 0.0);
}

//------------------------------------------------------------------------------
// What touches a side may be rounded into it.
TEST(TriangleClusters, ASideErrsOnTheSideOfDrawing)
{
  const glm::dmat4 clip(1.0);
  EXPECT_FALSE(ViewSides(clip).LeaveOut({ 1.0f, -0.1f, 0.0f }, { 2.0f, 0.1f, 0.0f }));
  EXPECT_FALSE(ViewSides(clip).LeaveOut({ 1.000001f, -0.1f, 0.0f }, { 2.0f, 0.1f, 0.0f }));
  EXPECT_TRUE(ViewSides(clip).LeaveOut({ 1.001f, -0.1f, 0.0f }, { 2.0f, 0.1f, 0.0f }));
  // Seen from far away the sums have larger terms: single precision moves by 0.06 what lies 1e6
  // from the eye.
  glm::dmat4 far(1.0);
  far[2] = glm::dvec4(0.0, 0.0, -1.0, -1.0);
  far[3] = glm::dvec4(1.0e6, 0.0, 1.0e6, 1.0e6);
  EXPECT_FALSE(ViewSides(far).LeaveOut({ 0.5f, -0.1f, -0.1f }, { 0.6f, 0.1f, 0.1f }));
  EXPECT_TRUE(ViewSides(far).LeaveOut({ 100.0f, -0.1f, -0.1f }, { 101.0f, 0.1f, 0.1f }));
  // Behind an eye nothing is seen, but what reaches to before it.
  glm::dmat4 eye(0.0);
  eye[0][0] = eye[1][1] = 1.0;
  eye[2][2] = eye[2][3] = -1.0; // w = -z
  eye[3][2] = -0.1;
  EXPECT_TRUE(ViewSides(eye).LeaveOut({ -1.0f, -1.0f, 2.0f }, { 1.0f, 1.0f, 3.0f }));
  EXPECT_EQ(ShareWithin(eye, CornersOf({ 0.0, 0.0, 3.0 }, 1.0)), 0.0);
  EXPECT_FALSE(ViewSides(eye).LeaveOut({ -1.0f, -1.0f, -1.0f }, { 1.0f, 1.0f, 3.0f }));
  EXPECT_TRUE(ViewSides(eye).LeaveOut({ 5.0f, -1.0f, -1.0f }, { 6.0f, 1.0f, -0.5f }));
}

//------------------------------------------------------------------------------
// What is drawn is what the sides do not leave out, in ranges that do not touch.
TEST(TriangleClusters, RangesOfAView)
{
  const Mesh mesh = Country(60, 11);
  std::vector<glm::uvec3> triangles = mesh.triangles;
  const std::vector<TriangleCluster> clusters = ClusterTriangles(mesh.vertices, triangles, 50);
  constexpr std::size_t Listed = 1000;
  Lot lot(12);
  std::size_t joined = 0;
  for (int scene = 0; scene < Scenes; ++scene)
  {
    const glm::dmat4 clipFromMesh = lot.AnyView().ClipFromWorld();
    TriangleRanges ranges;
    ranges.AddSeen(clusters, clipFromMesh, Listed);
    std::vector<char> drawn(triangles.size(), 0), wanted = drawn;
    std::size_t end = 0, seen = 0;
    for (const TriangleRange& range : ranges.Get())
    {
      ASSERT_GT(range.count, 0u);
      ASSERT_TRUE(end == 0 || range.first > end) << "they would be one";
      end = range.first + range.count;
      ASSERT_GE(range.first, Listed);
      ASSERT_LE(end, Listed + triangles.size());
      std::fill_n(drawn.begin() + (range.first - Listed), range.count, 1);
    }
    const ViewSides sides(clipFromMesh);
    for (const TriangleCluster& cluster : clusters)
    {
      const bool isSeen = !sides.LeaveOut(cluster.minimum, cluster.maximum);
      std::fill_n(wanted.begin() + cluster.first, cluster.count, isSeen);
      seen += isSeen;
    }
    EXPECT_EQ(drawn, wanted);
    joined += seen - ranges.Get().size();
  }
  EXPECT_GT(joined, 0u);

  TriangleRanges ranges;
  ranges.Add(3, 0);
  EXPECT_TRUE(ranges.Get().empty());
  ranges.Add(3, 4);
  ranges.Add(7, 0);
  ranges.Add(7, 2);
  ranges.Add(10, 1);
  ASSERT_EQ(ranges.Get().size(), 2u);
  EXPECT_EQ(ranges.Get()[0].first, 3u);
  EXPECT_EQ(ranges.Get()[0].count, 6u);
  EXPECT_EQ(ranges.Get()[1].first, 10u);
}
