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
