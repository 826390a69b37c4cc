// Which surfaces are proven not to pass through themselves.
#include "EmbeddedSurface.h"

#include "ShadowMeshes.h"

#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace vtkshadows;

namespace
{

bool IsEmbedded(
  const TestMesh& mesh, double scale = 1.0, const glm::dvec3& offset = glm::dvec3(0.0))
{
  std::vector<glm::vec3> points;
  for (const glm::dvec3& p : mesh.points)
  {
    points.emplace_back(scale * p + offset);
  }
  const std::atomic<bool> cancelled{ false };
  return vtkshadows::IsEmbedded(BuildShadowMesh(points, mesh.triangles), cancelled);
}

// The prism over a polygon in the plane z = 0, with caps that are fans around corner 0.
TestMesh Prism(const std::vector<glm::dvec2>& polygon)
{
  TestMesh mesh;
  const auto count = static_cast<unsigned int>(polygon.size());
  for (const double z : { 0.0, 1.0 })
  {
    for (const glm::dvec2& p : polygon)
    {
      mesh.points.emplace_back(p, z);
    }
  }
  for (unsigned int i = 0; i < count; ++i)
  {
    const unsigned int next = (i + 1) % count;
    mesh.triangles.emplace_back(i, next, count + next);
    mesh.triangles.emplace_back(i, count + next, count + i);
    if (i > 0 && next > 0)
    {
      mesh.triangles.emplace_back(0, next, i);
      mesh.triangles.emplace_back(count, count + i, count + next);
    }
  }
  return mesh;
}

// A closed grid of quads around the axis of a ball, whose points lie at place(u, v).
template <typename Place>
TestMesh Globe(unsigned int rings, unsigned int sides, const Place& place)
{
  TestMesh mesh;
  mesh.points = { place(0.0, 0.0), place(0.0, 1.0) };
  for (unsigned int ring = 1; ring < rings; ++ring)
  {
    for (unsigned int side = 0; side < sides; ++side)
    {
      mesh.points.push_back(place(double(side) / sides, double(ring) / rings));
    }
  }
  const auto at = [&](unsigned int ring, unsigned int side) {
    return ring == 0 ? 0 : ring == rings ? 1 : 2 + (ring - 1) * sides + side % sides;
  };
  for (unsigned int ring = 0; ring < rings; ++ring)
  {
    for (unsigned int side = 0; side < sides; ++side)
    {
      const unsigned int a = at(ring, side), b = at(ring, side + 1);
      const unsigned int c = at(ring + 1, side), d = at(ring + 1, side + 1);
      mesh.triangles.emplace_back(a, c, d); // one of them repeats a pole
      mesh.triangles.emplace_back(a, d, b);
    }
  }
  return mesh;
}

glm::dvec3 OnBall(double u, double v)
{
  const double around = glm::two_pi<double>() * u, down = glm::pi<double>() * v;
  return { std::cos(around) * std::sin(down), std::sin(around) * std::sin(down), std::cos(down) };
}

}

//------------------------------------------------------------------------------
TEST(EmbeddedSurface, ClosedOnesAreProven)
{
  for (const TestMesh& mesh :
    { Tetrahedron(), Cube(), UnweldedCube(), InsideOutCube(), Torus(60, 30), Globe(40, 60, OnBall),
      Prism({ { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1.2, 1.5 }, { 0, 1 } }) })
  {
    EXPECT_TRUE(IsEmbedded(mesh)) << mesh.name;
  }
}

TEST(EmbeddedSurface, ThoseWithBordersOrOtherEdgesAreNot)
{
  for (const TestMesh& mesh : { OpenStrip(), Fan(4), Duplicated(), OneTurned(), MoebiusStrip(),
         KleinBottle(), TwoBodiesAndASheet(), Soup(40, 12) })
  {
    EXPECT_FALSE(IsEmbedded(mesh)) << mesh.name;
  }
}

// What it is for: half of this is inside out, though closed and wound alike throughout.
TEST(EmbeddedSurface, AFigureOfEightIsNot)
{
  std::vector<glm::dvec2> eight;
  for (int i = 0; i < 40; ++i)
  {
    const double t = glm::two_pi<double>() * (i + 0.5) / 40;
    eight.emplace_back(std::sin(t), std::sin(2.0 * t));
  }
  EXPECT_FALSE(IsEmbedded(Prism(eight)));
}

// Each of the three ways in which triangles may meet wrongly.
TEST(EmbeddedSurface, OneThatIsPiercedIsNot)
{
  TestMesh spike = Globe(12, 16, OnBall);
  spike.points[0] = { 0.05, 0.03, -1.4 }; // a pole through the other side
  EXPECT_FALSE(IsEmbedded(spike)) << "no corner in common";

  TestMesh pyramid = Prism({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
  EXPECT_TRUE(IsEmbedded(pyramid));
  pyramid.points[6] = { 0.25, 0.5, -0.5 }; // a corner through the floor
  EXPECT_FALSE(IsEmbedded(pyramid)) << "a corner in common";

  TestMesh flat;
  flat.points = { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 3, 0 }, { 1, 1, 1e-6 } };
  flat.triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  EXPECT_TRUE(IsEmbedded(flat));
  flat.points[3].z = 0.0; // its three upper sides fill the lower one
  EXPECT_FALSE(IsEmbedded(flat)) << "a side in common";
}

// Only by as much as a float can tell.
TEST(EmbeddedSurface, ItTakesLittleToPierceIt)
{
  // A dent in the upper side of a box, down to its floor at z = 0 and beyond.
  const auto dented = [](double depth)
  {
    TestMesh box = Prism({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
    box.triangles.pop_back();
    box.triangles.erase(box.triangles.end() - 2);
    // The upper side is now a fan around its middle.
    TestMesh mesh;
    mesh.points = box.points;
    mesh.points.emplace_back(0.4, 0.45, depth);
    for (unsigned int i = 0; i < 4; ++i)
    {
      const unsigned int next = (i + 1) % 4;
      mesh.triangles.emplace_back(i, next, 4 + next);
      mesh.triangles.emplace_back(i, 4 + next, 4 + i);
      mesh.triangles.emplace_back(4 + i, 4 + next, 8);
    }
    mesh.triangles.emplace_back(0, 2, 1);
    mesh.triangles.emplace_back(0, 3, 2);
    return mesh;
  };
  EXPECT_TRUE(IsEmbedded(dented(0.5)));
  EXPECT_TRUE(IsEmbedded(dented(1e-7)));
  EXPECT_FALSE(IsEmbedded(dented(0.0)));
  EXPECT_FALSE(IsEmbedded(dented(-1e-7)));
}

TEST(EmbeddedSurface, PiecesMayPassThroughEachOther)
{
  TestMesh two = Cube();
  Append(two, Torus(24, 12), { 0.4, 0.3, 0.2 });
  EXPECT_TRUE(IsEmbedded(two));
  Append(two, Duplicated(), { 9.0, 0.0, 0.0 });
  EXPECT_FALSE(IsEmbedded(two)) << "one that is not is enough";
}

// Sides that lie in one plane, turned so that rounding puts their corners off it.
TEST(EmbeddedSurface, ScaleTurnAndOffsetDoNotMatter)
{
  const double turn = 0.7;
  TestMesh plate = Globe(8, 32,
    [](double u, double v)
    {
      // A flat cylinder: both of its ends are grids in one plane.
      const double around = glm::two_pi<double>() * u;
      const double radius = v < 0.5 ? std::min(3.0 * v, 1.0) : std::min(3.0 - 3.0 * v, 1.0);
      return glm::dvec3(radius * std::cos(around), radius * std::sin(around), v < 0.5 ? 0.1 : 0.0);
    });
  for (glm::dvec3& p : plate.points)
  {
    p = { std::cos(turn) * p.x + std::sin(turn) * p.z, p.y,
      std::cos(turn) * p.z - std::sin(turn) * p.x };
  }
  for (const double scale : { 1e-12, 1.0, 1e12 })
  {
    EXPECT_TRUE(IsEmbedded(plate, scale)) << scale;
    EXPECT_TRUE(IsEmbedded(plate, scale, scale * glm::dvec3(100.0, -50.0, 20.0))) << scale;
  }
}

// Balls whose points are moved about: at first so little that nothing meets, then more.
TEST(EmbeddedSurface, TheWilderTheRougher)
{
  std::mt19937 random(5);
  int proven = 0, refused = 0;
  for (const double by : { 0.0, 0.01, 0.02, 0.3, 0.6, 1.0 })
  {
    std::uniform_real_distribution<double> move(-by, by);
    TestMesh rough = Globe(10, 14, OnBall);
    for (glm::dvec3& p : rough.points)
    {
      p += glm::dvec3(move(random), move(random), move(random));
    }
    const bool is = IsEmbedded(rough);
    proven += is && by < 0.1;
    refused += !is && by > 0.1;
  }
  EXPECT_EQ(proven, 3);
  EXPECT_EQ(refused, 3);
}

TEST(EmbeddedSurface, ASearchCanBeCancelled)
{
  std::vector<glm::vec3> points;
  const TestMesh torus = Torus(20, 10);
  for (const glm::dvec3& p : torus.points)
  {
    points.emplace_back(p);
  }
  const std::atomic<bool> cancelled{ true };
  EXPECT_FALSE(vtkshadows::IsEmbedded(BuildShadowMesh(points, torus.triangles), cancelled));
}
