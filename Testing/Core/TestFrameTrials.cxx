#include "FrameTrials.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace
{

using vtkshadows::FrameTrials;
using vtkshadows::FrameWay;
using vtkshadows::ShadowBudget;
using vtkshadows::ShadowSetting;

FrameWay Way(const std::string& technique, double cost, double error = 0.0)
{
  FrameWay way;
  way.settings = { ShadowSetting::By(technique) };
  way.cost = cost;
  way.error = error;
  return way;
}

// Draws frames, each in what its way takes; what was drawn, in order.
std::vector<std::string> Draw(
  FrameTrials& trials, const std::map<std::string, double>& seconds, int frames)
{
  std::vector<std::string> drawn;
  for (int i = 0; i < frames; ++i)
  {
    const std::string name = trials.Way().settings[0].technique;
    drawn.push_back(name);
    trials.FrameDrawn(trials.WantsTime() ? std::optional<double>(seconds.at(name)) : std::nullopt);
  }
  return drawn;
}

int Changes(const std::vector<std::string>& drawn)
{
  int changes = 0;
  for (std::size_t i = 1; i < drawn.size(); ++i)
  {
    changes += drawn[i] != drawn[i - 1] ? 1 : 0;
  }
  return changes;
}

}

//------------------------------------------------------------------------------
TEST(FrameTrials, TheFastestIsFoundAndStays)
{
  FrameTrials trials;
  trials.SetWays({ Way("a", 1.3), Way("b", 2.0), Way("c", 2.6) }, {});
  const std::map<std::string, double> seconds = { { "a", 0.030 }, { "b", 0.020 }, { "c", 0.050 } };
  const std::vector<std::string> drawn = Draw(trials, seconds, 30);
  EXPECT_EQ(drawn.front(), "a"); // what is expected to be the cheapest
  EXPECT_TRUE(trials.IsSettled());
  EXPECT_EQ(drawn.back(), "b");
  EXPECT_LE(Changes(drawn), 5); // each was tried twice at most
  // Then it never changes, though the same ways are named in every frame.
  for (int i = 0; i < 300; ++i)
  {
    trials.SetWays({ Way("a", 1.3), Way("b", 2.0), Way("c", 2.6) }, {});
    EXPECT_EQ(Draw(trials, seconds, 1).front(), "b");
  }
}

//------------------------------------------------------------------------------
// A machine that is busy for a few frames does not decide.
TEST(FrameTrials, ABusyMachineDoesNotDecide)
{
  for (int busy = 0; busy < 8; ++busy)
  {
    FrameTrials trials;
    trials.SetWays({ Way("a", 1.3), Way("b", 2.0) }, {});
    for (int i = 0; i < 30; ++i)
    {
      const double seconds = trials.Way().settings[0].technique == "a" ? 0.010 : 0.015;
      trials.FrameDrawn(trials.WantsTime()
          ? std::optional<double>(i >= busy && i < busy + 3 ? 1.55 * seconds : seconds)
          : std::nullopt);
    }
    EXPECT_EQ(trials.Way().settings[0].technique, "a") << "busy from frame " << busy;
  }
}

//------------------------------------------------------------------------------
TEST(FrameTrials, ALittleDecidesNothing)
{
  FrameTrials trials;
  trials.SetWays({ Way("a", 1.3), Way("b", 2.0) }, {});
  Draw(trials, { { "a", 0.0200 }, { "b", 0.0195 } }, 30);
  EXPECT_TRUE(trials.IsSettled());
  EXPECT_EQ(trials.Way().settings[0].technique, "a"); // which is expected to cost less
}

//------------------------------------------------------------------------------
TEST(FrameTrials, WhatIsFarTooDearIsNotTried)
{
  FrameTrials trials;
  trials.SetWays({ Way("a", 1.3), Way("b", 30.0) }, {});
  const std::vector<std::string> drawn = Draw(trials, { { "a", 0.02 } }, 20);
  EXPECT_EQ(std::count(drawn.begin(), drawn.end(), "b"), 0);
  EXPECT_TRUE(trials.IsSettled());
}

//------------------------------------------------------------------------------
TEST(FrameTrials, WhatIsKnownToBeSlowIsNotTried)
{
  FrameTrials trials;
  FrameWay slow = Way("b", 2.0), fast = Way("c", 2.5);
  slow.atLeast = 0.05;
  fast.atLeast = 0.03;
  trials.SetWays({ Way("a", 1.3), slow, fast }, {});
  EXPECT_FALSE(trials.HasLost(10.0)); // nothing is timed yet
  const std::vector<std::string> drawn = Draw(trials, { { "a", 0.02 }, { "c", 0.031 } }, 30);
  EXPECT_EQ(std::count(drawn.begin(), drawn.end(), "b"), 0);
  EXPECT_GT(std::count(drawn.begin(), drawn.end(), "c"), 0); // which might have been as fast
  EXPECT_TRUE(trials.IsSettled());
  EXPECT_TRUE(trials.HasLost(0.041));
  EXPECT_FALSE(trials.HasLost(0.039));
}

//------------------------------------------------------------------------------
// With a budget of time alone the most accurate is sought that keeps to it, be it slower than
// others.
TEST(FrameTrials, WithABudgetOfTimeThatIsWhatLoses)
{
  ShadowBudget budget;
  budget.maximumSeconds = 0.1;
  FrameTrials trials;
  FrameWay better = Way("b", 2.0, 0.1), best = Way("c", 2.5, 0.0);
  better.atLeast = 0.08;
  best.atLeast = 0.2;
  trials.SetWays({ Way("a", 1.3, 1.0), better, best }, budget);
  const std::vector<std::string> drawn = Draw(trials, { { "a", 0.02 }, { "b", 0.09 } }, 30);
  EXPECT_EQ(drawn.back(), "b");
  EXPECT_EQ(std::count(drawn.begin(), drawn.end(), "c"), 0);
}

//------------------------------------------------------------------------------
TEST(FrameTrials, TheOnlyWayIsTimedWhereOthersWaitForIt)
{
  FrameTrials trials;
  trials.SetWays({ Way("a", 1.3) }, {});
  Draw(trials, { { "a", 0.02 } }, 10);
  EXPECT_TRUE(trials.IsSettled());
  EXPECT_FALSE(trials.HasLost(1.0));
  trials.SetTimesOnlyWay(true);
  EXPECT_FALSE(trials.IsSettled());
  for (int i = 0; i < 4; ++i)
  {
    trials.SetTimesOnlyWay(true);
    trials.SetWays({ Way("a", 1.3) }, {});
    Draw(trials, { { "a", 0.02 } }, 1);
  }
  EXPECT_TRUE(trials.IsSettled()); // after one row
  EXPECT_EQ(trials.LeastSeconds(), 0.02);
  trials.SetTimesOnlyWay(false);
  Draw(trials, { { "a", 0.02 } }, 5);
  EXPECT_TRUE(trials.IsSettled());
}

//------------------------------------------------------------------------------
TEST(FrameTrials, AnotherTimeIsNoticed)
{
  FrameTrials trials;
  trials.SetWays({ Way("a", 1.3), Way("b", 2.0) }, {});
  Draw(trials, { { "a", 0.010 }, { "b", 0.015 } }, 20);
  EXPECT_EQ(trials.Way().settings[0].technique, "a");
  // One slow frame is none; for good, the other is found.
  const std::vector<std::string> drawn = Draw(trials, { { "a", 0.050 }, { "b", 0.015 } }, 100);
  EXPECT_EQ(drawn.back(), "b");
}

//------------------------------------------------------------------------------
TEST(FrameTrials, WhatIsNoLongerRightIsLeftAtOnce)
{
  FrameTrials trials;
  trials.SetWays({ Way("a", 1.3), Way("b", 2.0) }, {});
  Draw(trials, { { "a", 0.010 }, { "b", 0.015 } }, 20);
  EXPECT_EQ(trials.Way().settings[0].technique, "a");
  trials.SetWays({ Way("b", 2.0) }, {});
  EXPECT_EQ(trials.Way().settings[0].technique, "b");
  trials.SetWays({ Way("a", 1.3), Way("b", 2.0) }, {});
  EXPECT_EQ(trials.Way().settings[0].technique, "a"); // whose time is known
  EXPECT_TRUE(trials.IsSettled());
}

//------------------------------------------------------------------------------
TEST(FrameTrials, ATimeAloneBuysAccuracy)
{
  const std::vector<FrameWay> ways = { Way("coarse", 1.2, 0.5), Way("fine", 1.4, 0.1),
    Way("exact", 2.0), Way("slow", 2.5) };
  const std::map<std::string, double> seconds = { { "coarse", 0.010 }, { "fine", 0.012 },
    { "exact", 0.020 }, { "slow", 0.040 } };
  for (const auto& expected : std::map<double, std::string>{ { 0.011, "coarse" }, { 0.015, "fine" },
         { 0.025, "exact" }, { 0.100, "exact" }, { 0.001, "coarse" } })
  {
    FrameTrials trials;
    ShadowBudget budget;
    budget.maximumSeconds = expected.first;
    trials.SetWays(ways, budget);
    EXPECT_EQ(Draw(trials, seconds, 30).back(), expected.second) << expected.first;
    EXPECT_TRUE(trials.IsSettled());
  }
}

//------------------------------------------------------------------------------
// What is far slower is drawn twice: once as shaders are compiled, and once timed.
TEST(FrameTrials, WhatIsFarSlowerIsDroppedAtOnce)
{
  FrameTrials trials;
  trials.SetWays({ Way("a", 1.3), Way("b", 2.0) }, {});
  const std::vector<std::string> drawn = Draw(trials, { { "a", 0.010 }, { "b", 0.030 } }, 40);
  EXPECT_EQ(std::count(drawn.begin(), drawn.end(), "b"), 2);
  EXPECT_EQ(drawn.back(), "a");
}

//------------------------------------------------------------------------------
// What is dear beside the fastest that is known is not tried, though a cheaper one was expected.
TEST(FrameTrials, DearBesideTheFastest)
{
  FrameTrials trials;
  trials.SetWays({ Way("a", 1.0), Way("b", 3.0), Way("c", 5.0) }, {});
  const std::map<std::string, double> seconds = { { "a", 0.030 }, { "b", 0.020 }, { "c", 0.010 } };
  // "c" is 5 times "a", but not 4 times "b", which turned out faster.
  EXPECT_EQ(Draw(trials, seconds, 40).back(), "c");
}

//------------------------------------------------------------------------------
// Ways that come and go beside the one in use, with times that are known, change nothing by a
// little; by much they do.
TEST(FrameTrials, WhatIsInUseStays)
{
  const std::map<std::string, double> seconds = { { "a", 0.0200 }, { "b", 0.0196 },
    { "c", 0.010 } };
  FrameTrials trials;
  trials.SetWays({ Way("b", 2.0) }, {});
  Draw(trials, seconds, 20);
  trials.SetWays({ Way("a", 1.3), Way("b", 2.0) }, {});
  EXPECT_EQ(Draw(trials, seconds, 40).back(), "b");
  for (int i = 0; i < 20; ++i)
  {
    trials.SetWays({ Way("b", 2.0) }, {});
    EXPECT_EQ(Draw(trials, seconds, 1).front(), "b");
    trials.SetWays({ Way("a", 1.3), Way("b", 2.0) }, {});
    EXPECT_EQ(Draw(trials, seconds, 1).front(), "b");
  }
  trials.SetWays({ Way("a", 1.3), Way("b", 2.0), Way("c", 2.0) }, {});
  EXPECT_EQ(Draw(trials, seconds, 40).back(), "c");
}

//------------------------------------------------------------------------------
// A machine that is busy while the first way is tried does not have it dropped.
TEST(FrameTrials, WhatIsExpectedToBeFasterHasASecondChance)
{
  FrameTrials trials;
  trials.SetWays({ Way("a", 1.3), Way("b", 2.0) }, {});
  for (int i = 0; i < 40; ++i)
  {
    const double seconds = trials.Way().settings[0].technique == "a" ? 0.010 : 0.015;
    trials.FrameDrawn(
      trials.WantsTime() ? std::optional<double>(i < 4 ? 5.0 * seconds : seconds) : std::nullopt);
  }
  EXPECT_EQ(trials.Way().settings[0].technique, "a");
}

//------------------------------------------------------------------------------
// Beside a limit it does not matter which of several ways is the fastest: one row each is enough.
TEST(FrameTrials, ALimitThatIsFarOffIsSoonKnownToBeKept)
{
  FrameTrials trials;
  ShadowBudget budget;
  budget.maximumSeconds = 1.0;
  trials.SetWays({ Way("a", 1.2, 0.5), Way("b", 1.4, 0.1), Way("c", 2.0) }, budget);
  EXPECT_EQ(Draw(trials, { { "a", 0.010 }, { "b", 0.011 }, { "c", 0.012 } }, 13).back(), "c");
  EXPECT_TRUE(trials.IsSettled());
}
