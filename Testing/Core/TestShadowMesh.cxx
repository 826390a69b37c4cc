// What a caster is turned into for shadow volumes: welding, edges, pieces.
#include "ShadowMesh.h"

#include "ShadowMeshes.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <set>
#include <utility>

using namespace vtkshadows;

namespace
{

ShadowMesh<double> Build(const TestMesh& mesh)
{
  return BuildShadowMesh(mesh.points, mesh.triangles, true);
}

// The half-edges of each undirected edge, by its points; true where it runs from the smaller to the
// larger index. Found without the table.
using Sides = std::map<HalfEdge, bool>;
std::map<std::pair<unsigned int, unsigned int>, Sides> EdgesOf(const ShadowMesh<double>& mesh)
{
  std::map<std::pair<unsigned int, unsigned int>, Sides> edges;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const unsigned int from = mesh.triangles[i][corner];
      const unsigned int to = mesh.triangles[i][(corner + 1) % 3];
      edges[std::minmax(from, to)][static_cast<HalfEdge>(3 * i + corner)] = from < to;
    }
  }
  return edges;
}

// The lists of the table, as they are stored.
std::vector<std::vector<HalfEdge>> ListsOf(const EdgeTable& table)
{
  std::vector<std::vector<HalfEdge>> lists;
  for (const HalfEdge side : table.borders)
  {
    lists.push_back({ side });
  }
  for (const EdgeTable::Pair& pair : table.pairs)
  {
    lists.push_back({ pair.first, pair.second });
  }
  for (std::size_t i = 0; i + 1 < table.fanStarts.size(); ++i)
  {
    lists.emplace_back(
      table.fanSides.begin() + table.fanStarts[i], table.fanSides.begin() + table.fanStarts[i + 1]);
  }
  return lists;
}

// Every edge is in the table, once, with all its half-edges and their directions.
void ExpectEdgesAreRight(const ShadowMesh<double>& mesh)
{
  auto edges = EdgesOf(mesh);
  EXPECT_EQ(mesh.edges.NumberOfEdges(), edges.size());
  for (const std::vector<HalfEdge>& list : ListsOf(mesh.edges))
  {
    ASSERT_FALSE(list.empty());
    const HalfEdge first = list[0];
    ASSERT_EQ(first & RunsAlike, 0u) << "the first half-edge must be plain";
    ASSERT_LT(first / 3, mesh.triangles.size());
    const glm::uvec3 t = mesh.triangles[first / 3];
    const auto edge = edges.find(std::minmax(t[first % 3], t[(first % 3 + 1) % 3]));
    ASSERT_NE(edge, edges.end()) << "an edge is listed twice";
    Sides listed;
    for (const HalfEdge side : list)
    {
      const bool isAlike = side == first || (side & RunsAlike) != 0;
      listed[side & ~RunsAlike] = edge->second.at(first) == isAlike;
    }
    EXPECT_EQ(listed, edge->second);
    edges.erase(edge);
  }
  EXPECT_TRUE(edges.empty());
}

struct EdgeCounts
{
  std::size_t borders, pairs, fans;
  bool operator==(const EdgeCounts& other) const
  {
    return this->borders == other.borders && this->pairs == other.pairs && this->fans == other.fans;
  }
  friend std::ostream& operator<<(std::ostream& os, const EdgeCounts& counts)
  {
    return os << counts.borders << " borders, " << counts.pairs << " pairs, " << counts.fans
              << " fans";
  }
};

EdgeCounts CountsOf(const TestMesh& mesh)
{
  const EdgeTable table = Build(mesh).edges;
  return { table.borders.size(), table.pairs.size(), table.fanStarts.size() - 1 };
}

void ExpectEqual(const MeshPiece& got, const MeshPiece& expected)
{
  EXPECT_EQ(got.first, expected.first);
  EXPECT_EQ(got.last, expected.last);
  EXPECT_EQ(got.closed, expected.closed);
  EXPECT_EQ(got.insideOut, expected.insideOut);
  EXPECT_EQ(got.minimum, expected.minimum);
  EXPECT_EQ(got.maximum, expected.maximum);
}

// Many blocks of everything: two closed bodies and a soup, in turn, over 100 000 triangles.
TestMesh LargeMesh()
{
  TestMesh listed = Torus(200, 120);
  Append(listed, Torus(150, 100), { 3.0, 0.0, 0.0 });
  Append(listed, Soup(30000, 300), { 0.0, 4.0, 0.0 });
  TestMesh mesh{ "large", listed.points, {} };
  const std::size_t count = listed.triangles.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    mesh.triangles.push_back(listed.triangles[i * 7919 % count]); // 7919 is prime
  }
  return mesh;
}

template <typename Real>
ShadowMesh<Real> WeldPoints(std::vector<glm::vec<3, Real>> points)
{
  std::vector<glm::uvec3> triangles;
  for (unsigned int i = 0; i + 2 < points.size(); i += 3)
  {
    triangles.emplace_back(i, i + 1, i + 2);
  }
  return BuildShadowMesh(std::move(points), std::move(triangles), true);
}

template <typename Real>
void TestWelding()
{
  const Real zero(0), one(1), next = std::nextafter(one, Real(2));
  const ShadowMesh<Real> mesh = WeldPoints<Real>({
    { zero, zero, zero },
    { one, zero, zero },
    { zero, one, zero }, //
    { -zero, zero, -zero },
    { one, -zero, zero },
    { zero, next, zero },
  });
  // (0, 1, 0) and its neighbour by one bit stay two points; the others are pairs.
  ASSERT_EQ(mesh.points.size(), 4u);
  EXPECT_EQ(mesh.triangles[0], glm::uvec3(0, 1, 2));
  EXPECT_EQ(mesh.triangles[1], glm::uvec3(0, 1, 3));
  EXPECT_EQ(mesh.points[3].y, next);
  EXPECT_FALSE(std::signbit(mesh.points[0].x));
}

}

TEST(ShadowMesh, PointsAreWeldedByTheirExactBits)
{
  TestWelding<float>();
  TestWelding<double>();
}

TEST(ShadowMesh, ManyPointsAreWeldedInTheOrderOfTheirFirstAppearance)
{
  // 90 000 points, each of 30 011 places about three times; -0 and 0 among them.
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 90000; ++i)
  {
    const int place = static_cast<int>(i * 7919LL % 30011);
    points.emplace_back(place % 100, place / 100, i % 2 ? 0.0 : -0.0);
  }
  const ShadowMesh<double> mesh = WeldPoints(points);
  ASSERT_EQ(mesh.points.size(), 30011u);
  ASSERT_EQ(mesh.triangles.size(), 30000u);
  unsigned int largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const unsigned int index = mesh.triangles[i / 3][i % 3];
    ASSERT_EQ(mesh.points[index], points[i]) << "point " << i;
    ASSERT_LE(index, largest) << "point " << i;
    largest = std::max(largest, index + 1);
  }
}

TEST(ShadowMesh, TrianglesThatRepeatAPointAreDropped)
{
  TestMesh mesh = Cube();
  mesh.points.push_back(mesh.points[0]);
  mesh.points[8].x = -1.0;
  mesh.triangles.insert(mesh.triangles.begin(), glm::uvec3(2, 2, 3));
  mesh.triangles.insert(mesh.triangles.begin() + 5, glm::uvec3(0, 8, 1)); // welded: 0, 0, 1
  mesh.triangles.emplace_back(3, 4, 3);
  const ShadowMesh<double> got = Build(mesh);
  const std::vector<std::uint32_t> expected{ 1, 2, 3, 4, 6, 7, 8, 9, 10, 11, 12, 13 };
  EXPECT_EQ(got.originals, expected);
  EXPECT_EQ(got.edges.pairs.size(), 18u);
  EXPECT_EQ(got.edges.NumberOfEdges(), 18u);
}

TEST(ShadowMesh, NothingMakesNothing)
{
  for (const TestMesh& mesh : { TestMesh{ "empty", {}, {} },
         TestMesh{ "repeats", { { 0, 0, 0 }, { 1, 0, 0 } }, { { 0, 1, 0 } } } })
  {
    const ShadowMesh<double> got = Build(mesh);
    EXPECT_EQ(got.NumberOfTriangles(), 0u);
    EXPECT_EQ(got.edges.NumberOfEdges(), 0u);
    EXPECT_TRUE(got.pieces.empty());
  }
}

TEST(ShadowMesh, EdgesOfEveryKind)
{
  for (const TestMesh& mesh : SmallMeshes())
  {
    SCOPED_TRACE(mesh.name);
    ExpectEdgesAreRight(Build(mesh));
  }
  ExpectEdgesAreRight(Build(Soup(10000, 500)));
}

TEST(ShadowMesh, EdgesAreCountedByTheirTriangles)
{
  EXPECT_EQ(CountsOf(Tetrahedron()), (EdgeCounts{ 0, 6, 0 }));
  EXPECT_EQ(CountsOf(Cube()), (EdgeCounts{ 0, 18, 0 }));
  EXPECT_EQ(CountsOf(UnweldedCube()), (EdgeCounts{ 0, 18, 0 }));
  EXPECT_EQ(CountsOf(OpenStrip()), (EdgeCounts{ 10, 7, 0 }));
  EXPECT_EQ(CountsOf(Fan(3)), (EdgeCounts{ 6, 0, 1 }));
  EXPECT_EQ(CountsOf(Fan(4)), (EdgeCounts{ 8, 0, 1 }));
  EXPECT_EQ(CountsOf(Fan(5)), (EdgeCounts{ 10, 0, 1 }));
  EXPECT_EQ(CountsOf(Duplicated()), (EdgeCounts{ 0, 0, 6 }));
  EXPECT_EQ(CountsOf(OneTurned()), (EdgeCounts{ 0, 6, 0 }));
  EXPECT_EQ(CountsOf(MoebiusStrip()), (EdgeCounts{ 60, 60, 0 }));
  EXPECT_EQ(CountsOf(KleinBottle()), (EdgeCounts{ 0, 768, 0 }));
}

TEST(ShadowMesh, WhatIsClosedIsAPieceAndTheRestIsOne)
{
  const TestMesh mesh = TwoBodiesAndASheet();
  const ShadowMesh<double> got = Build(mesh);
  ASSERT_EQ(got.pieces.size(), 3u);
  // The cube comes before the tetrahedron in the list; what is open is last.
  const MeshPiece cube{ 0, 12, true, false, { -1, -1, -1 }, { 1, 1, 1 } };
  const MeshPiece tetrahedron{ 12, 16, true, true, { 3, 0.5, 0 }, { 4, 1.5, 1 } };
  ExpectEqual(got.pieces[0], cube);
  ExpectEqual(got.pieces[1], tetrahedron);
  ExpectEqual(got.pieces[2], { 16, 24, false, false, { 6, 1, 0 }, { 7.2, 2, 0 } });

  std::set<std::uint32_t> used;
  ASSERT_EQ(got.originals.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < got.originals.size(); ++i)
  {
    const glm::uvec3 t = mesh.triangles[got.originals[i]];
    for (int corner = 0; corner < 3; ++corner)
    {
      EXPECT_EQ(got.points[got.triangles[i][corner]], mesh.points[t[corner]]) << "triangle " << i;
    }
    used.insert(got.originals[i]);
  }
  EXPECT_EQ(used.size(), mesh.triangles.size());
}

TEST(ShadowMesh, ClosedMeansAsManySidesOneWayAsTheOther)
{
  const auto isClosed = [](const TestMesh& mesh)
  {
    const ShadowMesh<double> got = Build(mesh);
    EXPECT_EQ(got.pieces.size(), 1u) << mesh.name;
    return got.pieces[0].closed;
  };
  for (const TestMesh& mesh :
    { Tetrahedron(), Cube(), UnweldedCube(), InsideOutCube(), Duplicated(), Torus(12, 8) })
  {
    EXPECT_TRUE(isClosed(mesh)) << mesh.name;
  }
  for (const TestMesh& mesh :
    { OpenStrip(), Fan(3), Fan(4), OneTurned(), MoebiusStrip(), KleinBottle() })
  {
    EXPECT_FALSE(isClosed(mesh)) << mesh.name;
  }
  EXPECT_TRUE(Build(InsideOutCube()).pieces[0].insideOut);
  EXPECT_FALSE(Build(Cube()).pieces[0].insideOut);
}

TEST(ShadowMesh, BodiesThatTouchAlongAnEdgeAreOnePiece)
{
  TestMesh mesh = Cube();
  Append(mesh, Cube(), { 2.0, 2.0, 0.0 });
  const ShadowMesh<double> got = Build(mesh);
  ASSERT_EQ(got.pieces.size(), 1u);
  EXPECT_TRUE(got.pieces[0].closed);
  EXPECT_EQ(CountsOf(mesh), (EdgeCounts{ 0, 34, 1 }));
}

TEST(ShadowMesh, TheSameOnAnyNumberOfThreads)
{
  const TestMesh mesh = LargeMesh();
  const auto build = [&mesh](std::size_t threads)
  {
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return Build(mesh);
  };
  const ShadowMesh<double> one = build(1), two = build(2);
  EXPECT_EQ(one.pieces.size(), 3u);
  EXPECT_GT(one.edges.fanStarts.size(), 2u);
  EXPECT_TRUE(one.points == two.points);
  EXPECT_TRUE(one.triangles == two.triangles);
  EXPECT_TRUE(one.originals == two.originals);
  EXPECT_TRUE(one.edges.borders == two.edges.borders);
  EXPECT_TRUE(std::equal(one.edges.pairs.begin(), one.edges.pairs.end(), two.edges.pairs.begin(),
    two.edges.pairs.end(),
    [](const EdgeTable::Pair& a, const EdgeTable::Pair& b)
    { return a.first == b.first && a.second == b.second; }));
  EXPECT_TRUE(one.edges.fanSides == two.edges.fanSides);
  EXPECT_TRUE(one.edges.fanStarts == two.edges.fanStarts);
  ASSERT_EQ(one.pieces.size(), two.pieces.size());
  for (std::size_t i = 0; i < one.pieces.size(); ++i)
  {
    ExpectEqual(one.pieces[i], two.pieces[i]);
  }
}

// A closed body, an open sheet, and triangles of their own: three borders, and two.
TEST(ShadowMesh, SoupApartKeepsEveryTriangle)
{
  TestMesh mesh = OpenStrip();
  Append(mesh, Cube(), { 5.0, 0.0, 0.0 });
  TestMesh quad;
  quad.points = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 }, { 0.0, 1.0, 0.0 } };
  for (const auto& triangles : std::vector<std::vector<glm::uvec3>>{ { { 0, 1, 2 } },
         { { 0, 1, 2 }, { 0, 2, 3 } }, { { 1, 2, 0 }, { 2, 3, 0 } }, { { 2, 0, 1 }, { 3, 0, 2 } } })
  {
    quad.triangles = triangles;
    Append(mesh, quad, { 0.0, 3.0 * mesh.points.size(), 1.0 });
  }
  const ShadowMesh<double> whole = Build(mesh);
  ShadowMesh<double> apart = whole;
  SetSoupApart(apart, 1000);
  ASSERT_EQ(apart.NumberOfTriangles(), mesh.triangles.size());
  // The single one, the quads' and both ends of the strip.
  EXPECT_EQ(apart.soup.NumberOfTriangles(), 9u);
  EXPECT_EQ(apart.soup.starts[1], 1u);
  EXPECT_EQ(apart.points.size(), apart.soup.firstPoint + 27u);
  EXPECT_LT(apart.soup.firstPoint, whole.points.size());
  for (std::size_t i = 0; i < apart.NumberOfTriangles(); ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      EXPECT_EQ(apart.points[apart.Corners(i)[corner]],
        mesh.points[mesh.triangles[apart.originals[i]][corner]])
        << "triangle " << i;
    }
  }
  // Borders of soup are not in the table; the inner side is in a pair.
  std::set<HalfEdge> inner;
  for (const EdgeTable::Pair& pair : apart.edges.pairs)
  {
    inner.insert(pair.first);
    inner.insert(pair.second & ~RunsAlike);
  }
  std::size_t borders = apart.edges.borders.size();
  for (std::uint32_t i = 0; i < 9; ++i)
  {
    const auto first = static_cast<HalfEdge>(3 * (apart.triangles.size() + i));
    for (HalfEdge side = 0; side < 3; ++side)
    {
      EXPECT_EQ(inner.count(first + side), side == apart.soup.InnerSide(i) ? 1u : 0u) << i;
    }
    borders += apart.soup.InnerSide(i) == 3 ? 3 : 2;
  }
  EXPECT_EQ(borders, whole.edges.borders.size());
  ASSERT_EQ(apart.pieces.size(), whole.pieces.size());
  for (std::size_t i = 0; i < whole.pieces.size(); ++i)
  {
    ExpectEqual(apart.pieces[i], whole.pieces[i]);
  }
}

TEST(ShadowMesh, SoupApartOnlyIfThePointsSuffice)
{
  const ShadowMesh<double> whole = Build(OpenStrip());
  ShadowMesh<double> apart = whole;
  SetSoupApart(apart, whole.points.size());
  EXPECT_EQ(apart.soup.NumberOfTriangles(), 0u);
  EXPECT_TRUE(apart.triangles == whole.triangles);
  EXPECT_TRUE(apart.points == whole.points);
  SetSoupApart(apart, whole.points.size() + 6);
  EXPECT_EQ(apart.soup.NumberOfTriangles(), 2u);
  // Closed, there is none.
  ShadowMesh<double> closed = Build(Cube());
  SetSoupApart(closed, 1000);
  EXPECT_EQ(closed.soup.NumberOfTriangles(), 0u);
}
