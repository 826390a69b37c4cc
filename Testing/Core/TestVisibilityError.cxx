// The measure itself, on masks small enough to count by hand.
#include "VisibilityError.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

using namespace vtkshadows;

namespace
{

// Truth and visibility, lit and measured everywhere until told otherwise.
struct Scene
{
  int width;
  int height;
  std::vector<float> visibility;
  std::vector<float> truth;
  std::vector<PixelRole> role;

  Scene(int width, int height)
    : width(width)
    , height(height)
    , visibility(width * height, 1.0f)
    , truth(width * height, 1.0f)
    , role(width * height, PixelRole::Measured)
  {
  }

  int At(int x, int y) const { return y * this->width + x; }

  VisibilityImages Images() const
  {
    return { this->width, this->height, this->visibility.data(), this->truth.data(),
      this->role.data() };
  }

  VisibilityError Measure(double edgeDistance = 2.0) const
  {
    return MeasureVisibility(this->Images(), edgeDistance);
  }

  // Shadow in columns first <= x < last.
  void ShadeColumns(std::vector<float>& image, int first, int last) const
  {
    for (int y = 0; y < this->height; ++y)
    {
      for (int x = first; x < last; ++x)
      {
        image[this->At(x, y)] = 0.0f;
      }
    }
  }
};

// Shadow left of x = 10 in truth, left of x = 10 + shift in the technique: 20 x 6 pixels.
Scene ShiftedEdge(int shift)
{
  Scene scene(20, 6);
  scene.ShadeColumns(scene.truth, 0, 10);
  scene.ShadeColumns(scene.visibility, 0, 10 + shift);
  return scene;
}

// True shadow on the left, and `missed` and `false` shadow dots far from the edge at x = 9 | 10.
Scene DottedHalves(int falseDots, int missedDots)
{
  Scene scene = ShiftedEdge(0);
  for (int i = 0; i < falseDots; ++i)
  {
    scene.visibility[scene.At(14 + i % 5, i / 5)] = 0.0f;
  }
  for (int i = 0; i < missedDots; ++i)
  {
    scene.visibility[scene.At(i % 5, i / 5)] = 1.0f;
  }
  return scene;
}

std::string MessageOf(const VisibilityImages& images, double edgeDistance)
{
  try
  {
    MeasureVisibility(images, edgeDistance);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "nothing was thrown";
}

void ExpectMessage(const VisibilityImages& images, double edgeDistance, const std::string& object,
  const std::string& value)
{
  const std::string message = MessageOf(images, edgeDistance);
  EXPECT_NE(message.find(object), std::string::npos) << "got: " << message;
  EXPECT_NE(message.find(value), std::string::npos) << "got: " << message;
  EXPECT_NE(message.find("; give "), std::string::npos) << "no remedy in: " << message;
}

}

TEST(VisibilityError, PerfectImageHasNoError)
{
  const VisibilityError error = ShiftedEdge(0).Measure();
  EXPECT_EQ(error.receiverPixels, 120u);
  EXPECT_EQ(error.shadowPixels, 60u);
  EXPECT_EQ(error.uncertainPixels, 0u);
  EXPECT_EQ(error.mismatchPixels, 0u);
  EXPECT_EQ(error.GrossPixels(), 0u);
  EXPECT_EQ(error.MeanAbsoluteDifference(), 0.0);
}

// The first wrong pixel is itself an edge pixel: the k-th lies k - 1 from it, so a shift of 3
// reaches the allowed 2 px and does not pass them.
TEST(VisibilityError, ShiftedEdgeTurnsGrossBeyondTwoPixels)
{
  const std::size_t grossColumns[] = { 0, 0, 0, 0, 1, 2 };
  for (int shift = 1; shift <= 5; ++shift)
  {
    SCOPED_TRACE("shift of " + std::to_string(shift) + " px");
    const VisibilityError late = ShiftedEdge(shift).Measure();
    EXPECT_EQ(late.mismatchPixels, 6u * shift);
    EXPECT_EQ(late.grossFalsePixels, 6u * grossColumns[shift]);
    EXPECT_EQ(late.grossMissedPixels, 0u);

    const VisibilityError early = ShiftedEdge(-shift).Measure();
    EXPECT_EQ(early.mismatchPixels, 6u * shift);
    EXPECT_EQ(early.grossFalsePixels, 0u);
    EXPECT_EQ(early.grossMissedPixels, 6u * grossColumns[shift]);
  }
}

TEST(VisibilityError, EdgeDistanceIsTheUsers)
{
  const Scene scene = ShiftedEdge(5); // wrong at distances 0, 1, 2, 3, 4
  EXPECT_EQ(scene.Measure(0.0).GrossPixels(), 24u);
  EXPECT_EQ(scene.Measure(0.99).GrossPixels(), 24u);
  EXPECT_EQ(scene.Measure(1.0).GrossPixels(), 18u);
  EXPECT_EQ(scene.Measure(3.5).GrossPixels(), 6u);
  EXPECT_EQ(scene.Measure(4.0).GrossPixels(), 0u);
  EXPECT_EQ(scene.Measure(1e300).GrossPixels(), 0u);
}

TEST(VisibilityError, PercentagesAreOfTheReceiverPixels)
{
  const VisibilityError error = ShiftedEdge(4).Measure();
  EXPECT_DOUBLE_EQ(error.MismatchPercent(), 20.0); // 24 of 120
  EXPECT_DOUBLE_EQ(error.GrossPercent(), 5.0);     // 6 of 120
}

TEST(VisibilityError, IsolatedDotsAreGrossFalseShadow)
{
  const VisibilityError error = DottedHalves(7, 0).Measure();
  EXPECT_EQ(error.mismatchPixels, 7u);
  EXPECT_EQ(error.grossFalsePixels, 7u);
  EXPECT_EQ(error.grossMissedPixels, 0u);
}

TEST(VisibilityError, LeaksAreGrossMissedShadow)
{
  const VisibilityError error = DottedHalves(3, 8).Measure();
  EXPECT_EQ(error.mismatchPixels, 11u);
  EXPECT_EQ(error.grossFalsePixels, 3u);
  EXPECT_EQ(error.grossMissedPixels, 8u);
}

// A true blob of 5 x 5 pixels that the technique does not know. Its rim of 16 pixels is edge, the
// ring of 8 lies 1 px inside, its centre 2 px.
TEST(VisibilityError, MissedBlobIsGrossInItsInterior)
{
  Scene scene(15, 15);
  for (int y = 5; y < 10; ++y)
  {
    for (int x = 5; x < 10; ++x)
    {
      scene.truth[scene.At(x, y)] = 0.0f;
    }
  }
  EXPECT_EQ(scene.Measure(0.0).mismatchPixels, 25u);
  EXPECT_EQ(scene.Measure(0.0).grossMissedPixels, 9u);
  EXPECT_EQ(scene.Measure(1.0).grossMissedPixels, 1u);
  EXPECT_EQ(scene.Measure(2.0).grossMissedPixels, 0u);
}

// One shadow pixel at (5, 5) makes edge pixels of itself and its four neighbours. From (8, 7) the
// nearest is (6, 5): sqrt(8) px, where rows plus columns would say 4 and their maximum 2.
TEST(VisibilityError, DistanceIsEuclidean)
{
  Scene scene(12, 12);
  scene.truth[scene.At(5, 5)] = scene.visibility[scene.At(5, 5)] = 0.0f;
  scene.visibility[scene.At(8, 7)] = 0.0f;
  EXPECT_EQ(scene.Measure(2.82).grossFalsePixels, 1u);
  EXPECT_EQ(scene.Measure(2.83).grossFalsePixels, 0u);
}

TEST(VisibilityError, WithoutTrueEdgesEveryMismatchIsGross)
{
  Scene lit(8, 4);
  lit.visibility[lit.At(3, 2)] = 0.0f;
  EXPECT_EQ(lit.Measure().grossFalsePixels, 1u);
  EXPECT_EQ(lit.Measure(1e6).grossFalsePixels, 1u);
  EXPECT_EQ(lit.Measure(1e300).grossFalsePixels, 1u);

  Scene dark(8, 4);
  dark.ShadeColumns(dark.truth, 0, 8);
  EXPECT_EQ(dark.Measure().shadowPixels, 32u);
  EXPECT_EQ(dark.Measure().mismatchPixels, 32u);
  EXPECT_EQ(dark.Measure().grossMissedPixels, 32u);
}

TEST(VisibilityError, OnlyMeasuredPixelsCount)
{
  Scene scene = DottedHalves(4, 0); // dots at x = 14 .. 17 of row 0
  scene.role[scene.At(14, 0)] = PixelRole::Background;
  scene.role[scene.At(15, 0)] = PixelRole::Grazing;
  scene.role[scene.At(16, 0)] = PixelRole::Uncertain;
  scene.role[scene.At(0, 0)] = PixelRole::Uncertain; // in true shadow
  const VisibilityError error = scene.Measure();
  EXPECT_EQ(error.receiverPixels, 116u);
  EXPECT_EQ(error.uncertainPixels, 2u);
  EXPECT_EQ(error.shadowPixels, 59u);
  EXPECT_EQ(error.mismatchPixels, 1u);
  EXPECT_EQ(error.grossFalsePixels, 1u);
  EXPECT_DOUBLE_EQ(error.sumAbsoluteDifference, 1.0);
}

// The truth changes at x = 9 | 10. If either side shows no receiver, that is a silhouette, not a
// shadow edge; grazing and uncertain receivers do carry one.
TEST(VisibilityError, BackgroundMakesNoEdge)
{
  const std::pair<PixelRole, std::size_t> grossOfRole[] = { { PixelRole::Background, 6u },
    { PixelRole::Grazing, 0u }, { PixelRole::Uncertain, 0u } };
  for (const auto& [role, gross] : grossOfRole)
  {
    SCOPED_TRACE("role " + std::to_string(static_cast<int>(role)));
    Scene scene = ShiftedEdge(2); // wrong at x = 10 and 11
    for (int y = 0; y < scene.height; ++y)
    {
      scene.role[scene.At(9, y)] = scene.role[scene.At(10, y)] = role;
    }
    EXPECT_EQ(scene.Measure().mismatchPixels, 6u);
    EXPECT_EQ(scene.Measure().grossFalsePixels, gross);
  }
}

TEST(VisibilityError, EdgesRunBetweenRowsToo)
{
  Scene scene(3, 12);
  for (int x = 0; x < 3; ++x)
  {
    for (int y = 0; y < 6; ++y)
    {
      scene.truth[scene.At(x, y)] = 0.0f;
    }
  }
  // All lit: rows 0 .. 5 are missed, at distances 5 .. 0 from row 5.
  EXPECT_EQ(scene.Measure().mismatchPixels, 18u);
  EXPECT_EQ(scene.Measure().grossMissedPixels, 9u);
}

// The last pixel of a row and the first of the next are no neighbours.
TEST(VisibilityError, EdgesDoNotWrapAroundRows)
{
  Scene scene(4, 2);
  scene.truth = { 1, 1, 1, 0, 1, 1, 1, 1 };
  scene.role[scene.At(2, 0)] = scene.role[scene.At(3, 1)] = PixelRole::Background;
  scene.visibility[scene.At(0, 1)] = 0.0f;
  EXPECT_EQ(scene.Measure(1e6).grossFalsePixels, 1u);
}

TEST(VisibilityError, SoftValuesMismatchAboveHalf)
{
  Scene scene(4, 1);
  scene.truth = { 1.0f, 1.0f, 0.25f, 0.0f };
  scene.visibility = { 0.5f, 0.375f, 0.75f, 0.625f };
  const VisibilityError error = scene.Measure();
  EXPECT_EQ(error.shadowPixels, 2u);
  EXPECT_EQ(error.mismatchPixels, 2u); // 0.625 twice; 0.5 twice is not above 0.5
  EXPECT_DOUBLE_EQ(error.sumAbsoluteDifference, 2.25);
  EXPECT_DOUBLE_EQ(error.MeanAbsoluteDifference(), 0.5625);
}

// Where the truth or the technique is neither lit nor in shadow.
TEST(VisibilityError, PenumbraOfEither)
{
  Scene scene(5, 1);
  scene.truth = { 1.0f, 1.0f, 0.5f, 0.0f, 0.0f };
  scene.visibility = { 1.0f, 0.75f, 0.0f, 0.0f, 1.0f };
  const VisibilityError error = scene.Measure();
  EXPECT_EQ(error.penumbraPixels, 2u);
  EXPECT_DOUBLE_EQ(error.MeanPenumbraDifference(), 0.375);
  EXPECT_DOUBLE_EQ(error.MeanAbsoluteDifference(), 0.35);
  scene.truth = scene.visibility = { 1.0f, 1.0f, 1.0f, 0.0f, 0.0f };
  EXPECT_EQ(scene.Measure().MeanPenumbraDifference(), 0.0);
}

// A truth of exactly 0.5 is shadow: an edge toward 0.75, none toward 0.25.
TEST(VisibilityError, HalfLitTruthIsShadow)
{
  Scene scene(12, 1);
  scene.truth = { 1, 0.25f, 0.5f, 0.25f, 0.25f, 0.25f, 0.25f, 0.25f, 0.25f, 0.25f, 0.5f, 0.75f };
  scene.visibility = scene.truth;
  scene.visibility[4] = scene.visibility[6] = 1.0f;
  const VisibilityError error = scene.Measure(2.5); // 4 and 6 lie 3 and 4 px from the edges 1, 10
  EXPECT_EQ(error.shadowPixels, 10u);
  EXPECT_EQ(error.grossMissedPixels, 2u);
  EXPECT_EQ(scene.Measure(3.0).grossMissedPixels, 1u);
}

TEST(VisibilityError, NotANumberIsWrong)
{
  Scene scene = ShiftedEdge(0);
  scene.visibility[scene.At(0, 0)] = std::numeric_limits<float>::quiet_NaN();
  const VisibilityError error = scene.Measure();
  EXPECT_EQ(error.mismatchPixels, 1u);
  EXPECT_EQ(error.grossMissedPixels, 1u);
  EXPECT_TRUE(std::isnan(error.MeanAbsoluteDifference()));
}

TEST(VisibilityError, NoReceiverGivesZeroFigures)
{
  Scene scene(3, 3);
  scene.role.assign(9, PixelRole::Background);
  const VisibilityError error = scene.Measure();
  EXPECT_EQ(error.receiverPixels, 0u);
  EXPECT_EQ(error.MismatchPercent(), 0.0);
  EXPECT_EQ(error.GrossPercent(), 0.0);
  EXPECT_EQ(error.MeanAbsoluteDifference(), 0.0);
}

TEST(VisibilityError, VerdictsTellEachPixelsFate)
{
  using V = PixelVerdict;
  Scene scene(16, 1);
  scene.ShadeColumns(scene.truth, 0, 8);
  scene.visibility = { 1, 0, 0, 0, 0, 0, 0, 1, 0, 1, 1, 1, 1, 0, 0, 0 };
  scene.role[12] = PixelRole::Background;
  scene.role[13] = PixelRole::Grazing;
  scene.role[14] = PixelRole::Uncertain;
  const std::vector<V> expected = { V::GrossMissedShadow, V::RightShadow, V::RightShadow,
    V::RightShadow, V::RightShadow, V::RightShadow, V::RightShadow, V::MissedShadow, V::FalseShadow,
    V::RightLit, V::RightLit, V::RightLit, V::Background, V::Grazing, V::Uncertain,
    V::GrossFalseShadow };

  std::vector<V> verdicts(3, V::RightLit); // whatever it held is replaced
  MeasureVisibility(scene.Images(), 2.0, &verdicts);
  ASSERT_EQ(verdicts.size(), expected.size());
  for (std::size_t x = 0; x < expected.size(); ++x)
  {
    EXPECT_EQ(static_cast<int>(verdicts[x]), static_cast<int>(expected[x])) << "pixel " << x;
  }
}

// Against the definition itself, pixel by pixel, on random shadows from sparse to dense.
TEST(VisibilityError, DistanceAgreesWithBruteForce)
{
  std::mt19937 random(7);
  for (int trial = 0; trial < 40; ++trial)
  {
    Scene scene(3 + trial, 29);
    std::vector<std::pair<int, int>> edges;
    for (int spot = 0; spot <= 2 * trial; ++spot)
    {
      scene.truth[random() % scene.truth.size()] = 0.0f;
    }
    scene.visibility = scene.truth;
    for (float& v : scene.visibility)
    {
      v = 1.0f - v; // every pixel is wrong, so that every distance is asked for
    }
    for (int y = 0; y < scene.height; ++y)
    {
      for (int x = 0; x < scene.width; ++x)
      {
        const auto differs = [&](int nx, int ny)
        {
          return nx >= 0 && ny >= 0 && nx < scene.width && ny < scene.height &&
            scene.truth[scene.At(nx, ny)] != scene.truth[scene.At(x, y)];
        };
        if (differs(x - 1, y) || differs(x + 1, y) || differs(x, y - 1) || differs(x, y + 1))
        {
          edges.emplace_back(x, y);
        }
      }
    }
    for (const double edgeDistance :
      { 0.0, 1.0, std::sqrt(2.0) + 1e-9, 2.0, 3.1, 4.0, 5.0, 7.5, 9.9, 25.0 })
    {
      std::size_t expected = 0;
      for (int y = 0; y < scene.height; ++y)
      {
        for (int x = 0; x < scene.width; ++x)
        {
          int nearest = std::numeric_limits<int>::max();
          for (const auto& [ex, ey] : edges)
          {
            nearest = std::min(nearest, (x - ex) * (x - ex) + (y - ey) * (y - ey));
          }
          expected += nearest > edgeDistance * edgeDistance;
        }
      }
      EXPECT_EQ(scene.Measure(edgeDistance).GrossPixels(), expected)
        << "trial " << trial << ", edgeDistance " << edgeDistance;
    }
  }
}

TEST(VisibilityError, BadInputIsNamedWithItsRemedy)
{
  const Scene scene(4, 3);
  const VisibilityImages good = scene.Images();
  VisibilityImages bad = good;
  bad.width = 0;
  ExpectMessage(bad, 2.0, "VisibilityImages: width", "0");
  bad = good;
  bad.height = -3;
  ExpectMessage(bad, 2.0, "VisibilityImages: height", "-3");
  bad = good;
  bad.visibility = nullptr;
  ExpectMessage(bad, 2.0, "VisibilityImages: visibility", "null");
  bad = good;
  bad.truth = nullptr;
  ExpectMessage(bad, 2.0, "VisibilityImages: truth", "null");
  bad = good;
  bad.role = nullptr;
  ExpectMessage(bad, 2.0, "VisibilityImages: role", "null");
  ExpectMessage(good, -1.0, "edgeDistance", "-1");
  ExpectMessage(good, std::nan(""), "edgeDistance", "nan");
  ExpectMessage(good, std::numeric_limits<double>::infinity(), "edgeDistance", "inf");
}
