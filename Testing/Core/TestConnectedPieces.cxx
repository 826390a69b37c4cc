// Which points of a mesh are connected.
#include "ConnectedPieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using vtkshadows::ConnectedPieces;

TEST(ConnectedPieces, PointsAtOnePlaceAreOne)
{
  // Two triangles that share an edge by place, and one apart; -0 is 0.
  ConnectedPieces pieces({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 0, -0.0 }, { 0, 1, 0 },
    { 1, 1, 0 }, { 5, 0, 0 }, { 6, 0, 0 }, { 5, 1, 0 } });
  for (const std::size_t first : { 0, 3, 6 })
  {
    pieces.Join(first, first + 1);
    pieces.Join(first, first + 2);
  }
  std::size_t count = 0;
  EXPECT_EQ(pieces.Number(count), (std::vector<std::uint32_t>{ 0, 0, 0, 0, 0, 0, 1, 1, 1 }));
  EXPECT_EQ(count, 2u);
}

TEST(ConnectedPieces, NothingAndSinglePoints)
{
  std::size_t count = 7;
  EXPECT_TRUE(ConnectedPieces({}).Number(count).empty());
  EXPECT_EQ(count, 0u);
  EXPECT_EQ(ConnectedPieces({ { 0, 0, 0 }, { 1, 0, 0 } }).Number(count),
    (std::vector<std::uint32_t>{ 0, 1 }));
  EXPECT_EQ(count, 2u);
}

// Chains whose links are joined in any order are numbered by their first points.
TEST(ConnectedPieces, ChainsInAnyOrder)
{
  for (unsigned int seed = 1; seed <= 20; ++seed)
  {
    constexpr std::size_t Points = 500, Chains = 7;
    std::vector<glm::dvec3> points;
    std::vector<std::size_t> links;
    for (std::size_t i = 0; i < Points; ++i)
    {
      points.emplace_back(double(i), 0.0, 0.0);
      if (i + Chains < Points)
      {
        links.push_back(i); // to i + Chains
      }
    }
    std::shuffle(links.begin(), links.end(), std::mt19937(seed));
    ConnectedPieces pieces(points);
    for (const std::size_t link : links)
    {
      seed % 2 ? pieces.Join(link, link + Chains) : pieces.Join(link + Chains, link);
    }
    std::size_t count = 0;
    const std::vector<std::uint32_t> found = pieces.Number(count);
    EXPECT_EQ(count, Chains);
    for (std::size_t i = 0; i < Points; ++i)
    {
      ASSERT_EQ(found[i], i % Chains) << "point " << i << ", seed " << seed;
    }
  }
}
