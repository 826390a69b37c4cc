// Plateaus: the penumbra's width, and what of a silhouette has one.
#include "ShadowPlateaus.h"

#include "PlanarProjection.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace vtkshadows;

namespace
{

const glm::dvec4 Ground(0.0, 0.0, 1.0, 0.0);

std::vector<PlateauVertex> Build(
  const glm::dvec4& light, double radius, const glm::dvec3& a, const glm::dvec3& b)
{
  std::vector<PlateauVertex> triangles;
  BuildPlateaus(Ground, light, radius, { { a, b }, { b, a } }, glm::dvec3(0.0), triangles);
  return triangles;
}

double FarthestFrom(const std::vector<PlateauVertex>& triangles, const glm::dvec3& place)
{
  double farthest = 0.0;
  for (const PlateauVertex& vertex : triangles)
  {
    farthest = std::max(farthest, glm::length(glm::dvec3(vertex.place) - place));
  }
  return farthest;
}

}

TEST(ShadowPlateaus, RadiusOfThePenumbra)
{
  const glm::dvec4 lamp(1.0, 2.0, 6.0, 1.0);
  EXPECT_NEAR(PlateauRadius(Ground, lamp, 0.5, { 3.0, 0.0, 2.0 }), 0.5 * 2.0 / 4.0, 1e-12);
  EXPECT_EQ(PlateauRadius(Ground, lamp, 0.5, { 3.0, 0.0, 0.0 }), 0.0);
  EXPECT_EQ(PlateauRadius(Ground, lamp, 0.5, { 3.0, 0.0, -1.0 }), 0.0);
  EXPECT_EQ(PlateauRadius(Ground, lamp, 0.5, { 3.0, 0.0, 7.0 }), 0.0);
  const glm::dvec4 sun(0.8, 0.0, 0.6, 0.0);
  EXPECT_NEAR(PlateauRadius(Ground, sun, 0.1, { 5.0, 5.0, 3.0 }), 0.1 * 3.0 / 0.6, 1e-12);
}

// Everything lies on the plane, is dark on the hard shadow's edge and lit at the penumbra's end.
TEST(ShadowPlateaus, RampsAroundAnEdge)
{
  const glm::dvec4 lamp(0.0, 0.0, 6.0, 1.0);
  const glm::dvec3 a(1.0, 0.0, 2.0), b(1.0, 1.0, 3.0);
  const std::vector<PlateauVertex> triangles = Build(lamp, 0.3, a, b);
  ASSERT_EQ(triangles.size() % 3, 0u);
  ASSERT_GT(triangles.size(), 0u);
  const glm::dvec3 placeA(1.5, 0.0, 0.0), placeB(2.0, 2.0, 0.0);
  const double radiusA = 0.3 * 2.0 / 4.0, radiusB = 0.3 * 3.0 / 3.0;
  for (const PlateauVertex& vertex : triangles)
  {
    const glm::dvec3 p(vertex.place);
    EXPECT_NEAR(p.z, 0.0, 1e-6);
    const double toA = glm::length(p - placeA), toB = glm::length(p - placeB);
    if (vertex.visibility == 0.0f)
    {
      EXPECT_NEAR(std::min(toA, toB), 0.0, 1e-6);
    }
    else
    {
      EXPECT_EQ(vertex.visibility, 1.0f);
      EXPECT_NEAR(std::min(std::abs(toA - radiusA), std::abs(toB - radiusB)), 0.0, 1e-6);
    }
  }
  EXPECT_NEAR(
    FarthestFrom(triangles, placeA), glm::length(placeB - placeA) + radiusB, 0.02 * radiusB);
}

TEST(ShadowPlateaus, EdgesThatStandOnThePlaneOrEndAtTheLight)
{
  const glm::dvec4 lamp(0.0, 0.0, 6.0, 1.0);
  // From the ground up: it tapers to a point there.
  const std::vector<PlateauVertex> upright = Build(lamp, 0.3, { 1, 0, 0 }, { 1, 0, 2 });
  ASSERT_GT(upright.size(), 0u);
  double nearest = 1.0;
  for (const PlateauVertex& vertex : upright)
  {
    nearest = std::min(nearest, glm::length(glm::dvec3(vertex.place) - glm::dvec3(1, 0, 0)));
  }
  EXPECT_NEAR(nearest, 0.0, 1e-6);
  // From beneath the ground: the same, and nothing beneath.
  const std::vector<PlateauVertex> sunk = Build(lamp, 0.3, { 1, 0, -2 }, { 1, 0, 2 });
  EXPECT_EQ(sunk.size(), upright.size());
  EXPECT_NEAR(FarthestFrom(sunk, { 1, 0, 0 }), FarthestFrom(upright, { 1, 0, 0 }), 1e-6);
  EXPECT_TRUE(Build(lamp, 0.3, { 1, 0, -2 }, { 2, 0, -1 }).empty());
  EXPECT_TRUE(Build(lamp, 0.3, { 1, 0, 2 }, { 2, 0, 6 }).empty());
  EXPECT_TRUE(Build(lamp, 0.3, { 1, 0, 2 }, { 2, 0, 7 }).empty());
}
