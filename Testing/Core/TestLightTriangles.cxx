// Triangles as a light sees them: turned toward it, and next to each other where their surface goes
// on.
#include "LightTriangles.h"

#include "ShadowMeshes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <numeric>
#include <random>
#include <vector>

using namespace vtkshadows;

namespace
{

const std::vector<std::uint32_t> AsInMesh; // no other order

struct Listed
{
  ShadowMesh<float> mesh;
  std::vector<LightCorner> corners; // three a triangle
};

ShadowMesh<float> MeshOf(const TestMesh& made)
{
  std::vector<glm::vec3> points(made.points.begin(), made.points.end());
  return BuildShadowMesh(std::move(points), made.triangles);
}

// First number 1.
Listed ListOf(const TestMesh& made, const glm::dmat4& lightFromMesh, const glm::dvec4& light,
  bool mirrored = false)
{
  Listed listed;
  listed.mesh = MeshOf(made);
  const auto neighbours = FindNeighbours(listed.mesh.edges, listed.mesh.triangles.size());
  const LightTriangles triangles(listed.mesh, neighbours, lightFromMesh, light, mirrored, AsInMesh);
  listed.corners.resize(3 * triangles.Count());
  triangles.Write(listed.corners.data(), 1);
  return listed;
}

// Twice the area, positive if counter-clockwise seen along -z.
double AreaOf(const LightCorner* t)
{
  const glm::dvec3 a(t[0].position), b(t[1].position), c(t[2].position);
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

glm::dvec3 AnyDirection(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

}

// What the lookup builds on, for every mesh and many directions of light.
TEST(LightTriangles, AreTurnedAndJoined)
{
  std::mt19937 random(7);
  std::size_t joined = 0;
  for (const TestMesh& made : SmallMeshes())
  {
    for (int round = 0; round < 20; ++round)
    {
      const glm::dvec3 toward = AnyDirection(random);
      const glm::dvec3 up = std::abs(toward.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
      const bool mirrored = round % 2 == 1;
      const glm::dmat4 worldFromMesh =
        glm::scale(glm::dmat4(1.0), glm::dvec3(mirrored ? -1.0 : 1.0, 1.0, 1.0));
      const glm::dmat4 lightFromMesh = glm::lookAt(toward, glm::dvec3(0.0), up) * worldFromMesh;
      const glm::dvec4 light = glm::inverse(worldFromMesh) * glm::dvec4(toward, 0.0);
      const Listed listed = ListOf(made, lightFromMesh, light, mirrored);
      const std::vector<LightCorner>& corners = listed.corners;
      for (std::size_t i = 0; i < corners.size(); i += 3)
      {
        // Edge-on, a rounding decides.
        EXPECT_GE(AreaOf(&corners[i]), -1e-5) << made.name << ", triangle " << i / 3;
        for (std::size_t k = 0; k < 3; ++k)
        {
          const auto beyond = static_cast<std::size_t>(corners[i + k].beyond);
          if (beyond == 0)
          {
            continue;
          }
          ++joined;
          ASSERT_LE(3 * beyond, corners.size()) << made.name;
          const LightCorner* other = &corners[3 * beyond - 3];
          const glm::vec3 from = corners[i + k].position, to = corners[i + (k + 1) % 3].position;
          int shared = -1;
          for (int m = 0; m < 3; ++m)
          {
            const bool isIt = other[m].position == to && other[(m + 1) % 3].position == from &&
              other[m].beyond == static_cast<float>(i / 3 + 1);
            shared = isIt ? m : shared;
          }
          EXPECT_GE(shared, 0) << made.name << ": triangle " << beyond - 1
                               << " does not have the side of triangle " << i / 3 << " back";
        }
      }
    }
  }
  std::cout << "joined sides: " << joined << "\n";
  EXPECT_GT(joined, 10000u);
}

// In another order the same triangles are listed, each beside the same ones.
TEST(LightTriangles, InAnotherOrder)
{
  std::mt19937 random(11);
  for (const TestMesh& made : SmallMeshes())
  {
    const ShadowMesh<float> mesh = MeshOf(made);
    const auto neighbours = FindNeighbours(mesh.edges, mesh.triangles.size());
    std::vector<std::uint32_t> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    const glm::dvec3 toward = AnyDirection(random);
    const glm::dvec4 light(toward, 0.0);
    const LightTriangles plain(mesh, neighbours, glm::dmat4(1.0), light, false, AsInMesh);
    const LightTriangles shuffled(mesh, neighbours, glm::dmat4(1.0), light, false, order);
    ASSERT_EQ(plain.Count(), shuffled.Count()) << made.name;
    const std::size_t half = order.size() / 2;
    EXPECT_EQ(
      shuffled.CountOf(0, half) + shuffled.CountOf(half, order.size() - half), shuffled.Count());

    // Where triangle i of the mesh is in a list, counted from 1; 0: nowhere.
    std::vector<std::size_t> plainAt(order.size(), 0), shuffledAt(order.size(), 0);
    for (std::size_t i = 0, listed = 0; i < order.size(); ++i)
    {
      listed += plain.CountOf(i, 1);
      plainAt[i] = plain.CountOf(i, 1) ? listed : 0;
    }
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      shuffledAt[order[i]] = shuffled.CountOf(i, 1) ? shuffled.CountOf(0, i + 1) : 0;
    }
    std::vector<LightCorner> expected(3 * plain.Count()), got(3 * plain.Count());
    plain.Write(expected.data(), 1);
    shuffled.Write(got.data(), 1);
    std::vector<std::size_t> shuffledOf(plain.Count() + 1, 0);
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      shuffledOf[plainAt[i]] = plainAt[i] ? shuffledAt[i] : 0;
    }
    for (std::size_t i = 1; i <= plain.Count(); ++i)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const LightCorner& a = expected[3 * i - 3 + k];
        const LightCorner& b = got[3 * shuffledOf[i] - 3 + k];
        ASSERT_EQ(a.position, b.position) << made.name;
        ASSERT_EQ(
          shuffledOf[static_cast<std::size_t>(a.beyond)], static_cast<std::size_t>(b.beyond))
          << made.name;
      }
    }
  }
}

// Of a closed body, what faces the light; its silhouette is where the surface ends.
TEST(LightTriangles, OfAClosedBodyThoseThatFaceTheLight)
{
  const glm::dvec4 light(0.0, 0.0, 1.0, 0.0);
  const Listed cube = ListOf(Cube(), glm::dmat4(1.0), light);
  EXPECT_EQ(cube.corners.size(), 6u);
  EXPECT_EQ(std::count_if(cube.corners.begin(), cube.corners.end(),
              [](const LightCorner& c) { return c.beyond > 0.0f; }),
    2);
  // From within, all of it.
  const Listed around = ListOf(Cube(), glm::dmat4(1.0), glm::dvec4(0.1, 0.0, 0.0, 1.0));
  EXPECT_EQ(around.corners.size(), 36u);
}

// A fold is no way on: the strip bent back over itself along one side.
TEST(LightTriangles, AFoldEndsTheSurface)
{
  TestMesh book;
  book.points = { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0.5 }, { 1, 1, 1.0 } };
  book.triangles = { { 0, 2, 1 }, { 0, 3, 1 } }; // both on the same side of the edge 0-1
  const Listed folded = ListOf(book, glm::dmat4(1.0), glm::dvec4(0.0, 0.0, 1.0, 0.0));
  ASSERT_EQ(folded.corners.size(), 6u);
  for (const LightCorner& corner : folded.corners)
  {
    EXPECT_EQ(corner.beyond, 0.0f);
  }
}
