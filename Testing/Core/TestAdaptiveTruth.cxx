#include "AdaptiveTruth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using vtkshadows::AdaptiveTruth;
using vtkshadows::PixelRole;
using vtkshadows::VisibilityError;

constexpr int Width = 400;
constexpr int Height = 300;

// A half plane in shadow with a penumbra 60 pixels wide, its samples at even steps.
float Edge(std::size_t i, int samples)
{
  const double lit = std::clamp((static_cast<double>(i % Width) - 170.0) / 60.0, 0.0, 1.0);
  return static_cast<float>(std::floor(lit * samples + 0.5) / samples);
}

struct Picture
{
  AdaptiveTruth truth;
  std::size_t rays = 0;

  explicit Picture(
    double epsilonAt = 1e9, AdaptiveTruth::Settings settings = AdaptiveTruth::Settings())
  {
    settings.width = Width;
    settings.height = Height;
    settings.partialPixels = 3000.0;
    settings.otherPixels = 2000.0;
    std::vector<PixelRole> roles(Width * Height, PixelRole::Measured);
    std::fill(roles.begin() + 250 * Width, roles.end(), PixelRole::Background);
    const auto trace = [this, epsilonAt](int samples, double scale,
                         const std::vector<unsigned char>& which, std::vector<float>& visibility)
    {
      for (std::size_t i = 0; i < which.size(); ++i)
      {
        if (which[i])
        {
          this->rays += samples;
          // A strip at the right is in its own shadow, unless rays start farther off.
          const bool isOwn = static_cast<double>(i % Width) > epsilonAt && scale < 2.0;
          visibility[i] = isOwn ? 0.0f : Edge(i, samples);
        }
      }
      return true;
    };
    EXPECT_TRUE(this->truth.Begin(settings, roles, trace));
  }

  VisibilityError Measure(const std::vector<float>& visibility)
  {
    VisibilityError error;
    EXPECT_TRUE(this->truth.Measure(visibility, error));
    return error;
  }
};

std::vector<float> Right(int samples)
{
  std::vector<float> visibility(Width * Height);
  for (std::size_t i = 0; i < visibility.size(); ++i)
  {
    visibility[i] = Edge(i, samples);
  }
  return visibility;
}

TEST(AdaptiveTruth, WhatIsRightHasNoError)
{
  Picture picture;
  const VisibilityError error = picture.Measure(Right(256));
  EXPECT_EQ(error.receiverPixels, 250u * Width);
  EXPECT_EQ(error.GrossPixels(), 0u);
  EXPECT_EQ(error.mismatchPixels, 0u);
  EXPECT_LT(error.MeanPenumbraDifference(), 0.005);
  EXPECT_NEAR(static_cast<double>(picture.truth.GetFinePixels()), 5000.0, 250.0);
  EXPECT_LT(picture.rays, 0.1 * 256 * 250 * Width);
  EXPECT_NEAR(static_cast<double>(error.penumbraPixels), 59.0 * 250, 0.05 * 60 * 250);
  EXPECT_NEAR(static_cast<double>(error.shadowPixels), 200.0 * 250, 0.02 * Width * 250);
}

// Steps of a few samples, as all pixels' truth would tell them: a quarter of a step in the mean.
TEST(AdaptiveTruth, DifferencesOfFewSamples)
{
  Picture picture;
  for (const int samples : { 2, 4, 16 })
  {
    const VisibilityError error = picture.Measure(Right(samples));
    EXPECT_EQ(error.GrossPixels(), 0u);
    EXPECT_NEAR(error.MeanPenumbraDifference(), 0.25 / samples, 0.02 / samples) << samples;
    EXPECT_NEAR(error.MeanAbsoluteDifference(), 0.25 / samples * 60.0 / Width, 0.01 / samples);
  }
}

// Beside a limit chance would decide; far from it more rays tell nothing.
TEST(AdaptiveTruth, MorePixelsBesideALimit)
{
  const auto finePixels = [](double mean, double penumbra, double& found, double tolerance = 0.0)
  {
    AdaptiveTruth::Settings settings;
    settings.meanLimit = mean;
    settings.meanTolerance = tolerance;
    settings.penumbraLimit = penumbra;
    settings.mostTimes = 4.0;
    Picture picture(1e9, settings);
    found = picture.Measure(Right(4)).MeanPenumbraDifference();
    return static_cast<double>(picture.truth.GetFinePixels());
  };
  double expected = 0.0;
  for (int x = 0; x < Width; ++x)
  {
    expected += std::abs(Edge(x, 4) - Edge(x, 256)) / 59.0; // so many columns are partly lit
  }
  double some = 0.0, all = 0.0;
  const double usual = finePixels(0.0, 0.0, some);
  EXPECT_NEAR(usual, 5000.0, 250.0);
  EXPECT_EQ(finePixels(0.1, 0.1, some), usual);
  EXPECT_NEAR(finePixels(0.0, expected, all), 4.0 * usual, 0.2 * usual);
  // Nine in ten of the penumbra's pixels are known then, but for its rims.
  EXPECT_NEAR(all, expected, 0.01 * expected);
  EXPECT_GT(std::abs(some - all), 1e-6);
  const double mean = expected * 59.0 / Width;
  const double fine = finePixels(mean, 0.0, some);
  EXPECT_GT(fine, 1.5 * usual);
  // What the mean need not be known better than asks for no more of them.
  EXPECT_EQ(finePixels(mean, 0.0, some, mean), usual);
  EXPECT_EQ(finePixels(mean, 0.0, some, 1.0e-3 * mean), fine);
}

// Rims of a penumbra that eight rays do not see count as they do: ten times as many pixels as the
// core has, each 0.03 wrong.
TEST(AdaptiveTruth, WhatFewRaysMiss)
{
  AdaptiveTruth::Settings settings;
  settings.width = Width;
  settings.height = Height;
  const auto trace =
    [](int samples, double, const std::vector<unsigned char>& which, std::vector<float>& visibility)
  {
    for (std::size_t i = 0; i < which.size(); ++i)
    {
      const int x = static_cast<int>(i % Width);
      const float lit = x < 200 ? (x < 20 ? 0.5f : 0.97f) : 1.0f;
      visibility[i] = which[i] ? std::floor(lit * samples + 0.5f) / samples : visibility[i];
    }
    return true;
  };
  AdaptiveTruth truth;
  ASSERT_TRUE(
    truth.Begin(settings, std::vector<PixelRole>(Width * Height, PixelRole::Measured), trace));
  VisibilityError error;
  ASSERT_TRUE(truth.Measure(std::vector<float>(Width * Height, 1.0f), error));
  EXPECT_NEAR(error.MeanPenumbraDifference(), 0.1 * 0.5 + 0.9 * 0.03, 0.005);
}

// Single pixels anywhere, whether they are of the sample or not; not of a mere step of the coarse
// truth.
TEST(AdaptiveTruth, GrossPixelsAreFoundEverywhere)
{
  Picture picture;
  std::vector<float> visibility = Right(256);
  for (int k = 0; k < 7; ++k)
  {
    visibility[(20 + 30 * k) * Width + 300 + 10 * k] = 0.0f;
    visibility[(25 + 30 * k) * Width + 20 + 10 * k] = 1.0f;
  }
  const VisibilityError error = picture.Measure(visibility);
  EXPECT_EQ(error.grossFalsePixels, 7u);
  EXPECT_EQ(error.grossMissedPixels, 7u);
}

TEST(AdaptiveTruth, ManyGrossPixels)
{
  Picture picture;
  const VisibilityError error = picture.Measure(std::vector<float>(Width * Height, 1.0f));
  EXPECT_EQ(error.grossFalsePixels, 0u);
  EXPECT_NEAR(static_cast<double>(error.grossMissedPixels), 198.0 * 250, 3.0 * 250);
}

// A technique that is right where the coarse truth hangs on the epsilon is not blamed.
TEST(AdaptiveTruth, WhatHangsOnTheEpsilon)
{
  Picture picture(389.5); // ten columns
  const VisibilityError error = picture.Measure(Right(256));
  EXPECT_LT(error.GrossPixels(), 10u * 250 / 20);
  EXPECT_GT(error.uncertainPixels, 400u);
}

TEST(AdaptiveTruth, NothingToMeasure)
{
  AdaptiveTruth truth;
  AdaptiveTruth::Settings settings;
  settings.width = 3;
  settings.height = 2;
  const auto trace = [](int, double, const std::vector<unsigned char>&, std::vector<float>&)
  { return true; };
  EXPECT_TRUE(truth.Begin(settings, std::vector<PixelRole>(6, PixelRole::Background), trace));
  VisibilityError error;
  EXPECT_TRUE(truth.Measure(std::vector<float>(6, 0.0f), error));
  EXPECT_EQ(error.receiverPixels, 0u);
  const auto fails = [](int, double, const std::vector<unsigned char>&, std::vector<float>&)
  { return false; };
  EXPECT_FALSE(truth.Begin(settings, std::vector<PixelRole>(6, PixelRole::Measured), fails));
}

}
