#include "ErrorRate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using vtkshadows::ErrorRate;
using vtkshadows::ShareOfChange;

TEST(ErrorRate, FasterChangesCountAtOnce)
{
  ErrorRate rate;
  EXPECT_EQ(rate.Get(), ErrorRate::Unknown);
  rate.Learn(0.3, 0.1);
  EXPECT_DOUBLE_EQ(rate.Get(), 3.0);
  rate.Learn(10.0, 0.1);
  EXPECT_EQ(rate.Get(), ErrorRate::Most);
}

TEST(ErrorRate, SlowerChangesCountByHalves)
{
  ErrorRate rate;
  rate.Learn(0.05, 0.1);
  EXPECT_DOUBLE_EQ(rate.Get(), 1.25);
  for (int i = 0; i < 100; ++i)
  {
    rate.Learn(0.0, 0.1);
    EXPECT_GE(rate.Get(), ErrorRate::Least);
  }
  EXPECT_NEAR(rate.Get(), ErrorRate::Least, 1.0e-6);
}

TEST(ErrorRate, DriftsThatTellNothing)
{
  ErrorRate rate;
  for (const double drift : { 0.0, 0.01, 1.5, double(INFINITY), double(NAN) })
  {
    rate.Learn(0.0, drift);
    rate.Learn(1.0, drift);
    EXPECT_EQ(rate.Get(), ErrorRate::Unknown) << drift;
  }
}

TEST(ErrorRate, SharesOfChange)
{
  EXPECT_DOUBLE_EQ(ShareOfChange(2.0, 3.0), 0.5);
  EXPECT_DOUBLE_EQ(ShareOfChange(3.0, 2.0), 0.5);
  EXPECT_EQ(ShareOfChange(0.0, 0.0), 0.0);
  EXPECT_TRUE(std::isinf(ShareOfChange(0.0, 1.0)));
}

}
