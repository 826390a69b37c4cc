#include "DrawingTimes.h"

#include <gtest/gtest.h>

namespace
{

using vtkshadows::DrawingTimes;
using vtkshadows::ShadowSetting;

ShadowSetting Sampled(const char* technique, int samples)
{
  return ShadowSetting::By(technique, samples);
}

ShadowSetting Map(int texels, const char* filter, int samples = 0)
{
  return ShadowSetting::Map(texels, filter, 1, samples);
}

}

//------------------------------------------------------------------------------
TEST(DrawingTimes, OfWhatDrawsMore)
{
  DrawingTimes times;
  EXPECT_FALSE(times.AtLeast(Sampled("stencil-volume", 8)));
  times.Note(Sampled("stencil-volume", 8), 1.6);
  EXPECT_EQ(times.AtLeast(Sampled("stencil-volume", 8)), 1.6);
  EXPECT_EQ(times.AtLeast(Sampled("stencil-volume", 32)), 1.6);
  // What draws less, and what is another technique, may be as fast as it likes.
  EXPECT_FALSE(times.AtLeast(Sampled("stencil-volume", 4)));
  EXPECT_FALSE(times.AtLeast(Sampled("ray-cast", 32)));
}

//------------------------------------------------------------------------------
TEST(DrawingTimes, ARiseGoesOn)
{
  DrawingTimes times;
  times.Note(Sampled("stencil-volume", 8), 1.7);
  times.Note(Sampled("stencil-volume", 4), 0.9);
  EXPECT_NEAR(*times.AtLeast(Sampled("stencil-volume", 32)), 0.1 + 32 * 0.2, 1.0e-9);
  // A smaller one that took longer, by a busy machine, makes none.
  times.Note(Sampled("stencil-volume", 4), 2.0);
  EXPECT_NEAR(*times.AtLeast(Sampled("stencil-volume", 32)), 2.0, 1.0e-9);
  times.Note(Sampled("stencil-volume", 32), 3.0);
  EXPECT_EQ(times.AtLeast(Sampled("stencil-volume", 32)), 3.0); // as it was noted itself
  times.Forget();
  EXPECT_FALSE(times.AtLeast(Sampled("stencil-volume", 32)));
}

//------------------------------------------------------------------------------
TEST(DrawingTimes, OfMapsByTheirTexels)
{
  DrawingTimes times;
  times.Note(Map(1024, "percentage-closer"), 0.02);
  EXPECT_EQ(times.AtLeast(Map(2048, "percentage-closer")), 0.02);
  EXPECT_FALSE(times.AtLeast(Map(1024, "exact"))); // drawn in another way
  EXPECT_FALSE(times.AtLeast(Map(512, "percentage-closer")));
  EXPECT_FALSE(times.AtLeast(Map(2048, "soft")));
  times.Note(Map(2048, "sample-lights", 8), 0.3);
  times.Note(Map(2048, "sample-lights", 16), 0.6);
  EXPECT_NEAR(*times.AtLeast(Map(2048, "sample-lights", 64)), 2.4, 1.0e-9);
}

//------------------------------------------------------------------------------
TEST(DrawingTimes, AboutByTheNearestOfItsKind)
{
  const auto costOf = [](const ShadowSetting& setting) { return 2.0 + setting.samples; };
  DrawingTimes times;
  EXPECT_FALSE(times.About(Sampled("ray-cast", 32), costOf));
  times.Note(Sampled("ray-cast", 4), 0.6); // 0.1 for a unit of cost
  // Of other kinds nothing else is known.
  EXPECT_NEAR(*times.About(Sampled("stencil-volume", 8), costOf), 1.0, 1.0e-9);
  EXPECT_NEAR(*times.About(Sampled("ray-cast", 30), costOf), 3.2, 1.0e-9);
  times.Note(Sampled("ray-cast", 14), 3.2); // 0.2
  EXPECT_NEAR(*times.About(Sampled("ray-cast", 30), costOf), 6.4, 1.0e-9);
  EXPECT_NEAR(*times.About(Sampled("ray-cast", 5), costOf), 0.7, 1.0e-9);
  times.Note(Sampled("stencil-volume", 4), 6.0); // 1
  EXPECT_NEAR(*times.About(Sampled("stencil-volume", 8), costOf), 10.0, 1.0e-9);
  EXPECT_NEAR(*times.About(Map(2048, "soft"), costOf), 0.4, 1.0e-9); // the middle one of three
}

//------------------------------------------------------------------------------
TEST(DrawingTimes, AboutOfMapsByTheirTexels)
{
  const auto costOf = [](const ShadowSetting& setting)
  { return 1.0 + setting.resolution / 1024.0; };
  DrawingTimes times;
  times.Note(Map(1024, "soft"), 0.02);
  times.Note(Map(1024, "exact"), 0.2);
  EXPECT_NEAR(*times.About(Map(2048, "soft"), costOf), 0.03, 1.0e-9);
  EXPECT_NEAR(*times.About(Map(2048, "exact"), costOf), 0.3, 1.0e-9);
  // One that has no texels is no kin of a map of the same technique.
  ShadowSetting planar = Sampled("planar", 0), texture = planar;
  texture.resolution = 1024;
  times.Note(texture, 2.0);
  EXPECT_NEAR(*times.About(planar, costOf), 0.1, 1.0e-9);
}
