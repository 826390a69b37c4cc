// What the eye sees of boxes, held against points of boxes drawn by lot. An answer may err on the
// side of seeing more, never on the other; and where the case is plain it must not err at all.
#include "BoxesByLot.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace vtkshadows;
using namespace coretest;

//------------------------------------------------------------------------------
TEST(SeenBoxes, NearQuadIsSeenAtTheCorners)
{
  for (const bool parallel : { false, true })
  {
    const View view = LookFrom({ 3.0, -2.0, 1.0 }, { 0.0, 0.0, 0.0 }, parallel);
    const glm::dvec2 corners[4] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
    const std::array<glm::dvec3, 4> quad = NearQuad(view.ClipFromWorld());
    for (int i = 0; i < 4; ++i)
    {
      const glm::dvec4 clip = view.ClipFromWorld() * glm::dvec4(quad[i], 1.0);
      EXPECT_NEAR(clip.x / clip.w, corners[i].x, 1.0e-12);
      EXPECT_NEAR(clip.y / clip.w, corners[i].y, 1.0e-12);
      EXPECT_NEAR(clip.z / clip.w, -1.0, 1.0e-12);
    }
  }
}

//------------------------------------------------------------------------------
// Planes that cut.
TEST(SeenBoxes, ABoxThatIsCutMayBeCut)
{
  Lot lot(11);
  int cut = 0, refused = 0, cutFar = 0, refusedFar = 0;
  for (int scene = 0; scene < Scenes; ++scene)
  {
    const Solid solid = lot.AnySolid();
    const View view = lot.AnyView();
    bool isCut = false, isCutFar = false;
    for (int i = 0; i < Samples; ++i)
    {
      const glm::dvec4 clip = view.ClipFromWorld() * glm::dvec4(solid.At(lot.Within(1.0)), 1.0);
      const bool isSeen = clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
      isCut = isCut || (isSeen && clip.z < -clip.w);
      isCutFar = isCutFar || (isSeen && clip.z > clip.w);
    }
    const bool says = NearPlaneMayCut(view.ClipFromWorld(), solid.Corners());
    const bool saysFar = FarPlaneMayCut(view.ClipFromWorld(), solid.Corners());
    EXPECT_TRUE(says || !isCut) << "scene " << scene;
    EXPECT_TRUE(saysFar || !isCutFar) << "the far plane, scene " << scene;
    cut += isCut ? 1 : 0;
    refused += says ? 0 : 1;
    cutFar += isCutFar ? 1 : 0;
    refusedFar += saysFar ? 0 : 1;
  }
  EXPECT_GT(cut, Scenes / 20);
  EXPECT_GT(refused, Scenes / 3);
  EXPECT_GT(cutFar, Scenes / 50);
  EXPECT_GT(refusedFar, Scenes / 3);
}

TEST(SeenBoxes, ABoxPlainlyBeyondIsNotCut)
{
  for (const bool parallel : { false, true })
  {
    // Along +x; the near plane at x = 0.5.
    const glm::dmat4 clip = LookFrom({ 0, 0, 0 }, { 1, 0, 0 }, parallel).ClipFromWorld();
    EXPECT_TRUE(NearPlaneMayCut(clip, CornersOf({ 0.5, 0, 0 }, 0.1)));
    EXPECT_TRUE(NearPlaneMayCut(clip, CornersOf({ 0.3, 0, 0 }, 0.1)));
    EXPECT_TRUE(NearPlaneMayCut(clip, CornersOf({ 0, 0, 0 }, 9.0))) << "the eye is inside";
    EXPECT_FALSE(NearPlaneMayCut(clip, CornersOf({ 0.7, 0, 0 }, 0.1))) << "beyond";
    EXPECT_FALSE(NearPlaneMayCut(clip, CornersOf({ 0.5, 3, 0 }, 0.1))) << "beside";
    EXPECT_FALSE(NearPlaneMayCut(clip, Upright({ 0, 0, -2 }, { 9, 9, 0 }).Corners()))
      << "a floor under the eye";
    EXPECT_EQ(NearPlaneMayCut(clip, CornersOf({ -3, 0, 0 }, 0.1)), parallel)
      << "behind: a parallel eye is farther back still";
    EXPECT_TRUE(FarPlaneMayCut(clip, CornersOf({ 30, 0, 0 }, 1.0)));
    EXPECT_TRUE(FarPlaneMayCut(clip, CornersOf({ 40, 0, 0 }, 1.0))) << "cut away";
    EXPECT_FALSE(FarPlaneMayCut(clip, CornersOf({ 28, 0, 0 }, 1.0))) << "before it";
    EXPECT_FALSE(FarPlaneMayCut(clip, CornersOf({ 30, 90, 0 }, 1.0))) << "beside";
  }
}

//------------------------------------------------------------------------------
// Depths.
TEST(SeenBoxes, SeenDepthsHoldAllThatIsSeen)
{
  Lot lot(9);
  int seen = 0;
  for (int scene = 0; scene < Scenes; ++scene)
  {
    const View view = lot.AnyView();
    const Solid solids[2] = { lot.AnySolid(), lot.AnySolid() };
    const DepthRange range = SeenDepths(
      view.clipFromView, view.viewFromWorld, { solids[0].Corners(), solids[1].Corners() });
    EXPECT_LT(range.nearest, range.farthest);
    EXPECT_GE(range.nearest, view.nearPlane * (1.0 - 1.0e-9));
    EXPECT_LE(range.farthest, view.farPlane * (1.0 + 1.0e-9));
    for (int i = 0; i < 2 * Samples; ++i)
    {
      const glm::dvec4 place(solids[i % 2].At(lot.Within(1.0)), 1.0);
      if (IsInView(view.ClipFromWorld() * place))
      {
        ++seen;
        const double depth = -(view.viewFromWorld * place).z;
        EXPECT_GE(depth, range.nearest * (1.0 - 1.0e-9)) << "scene " << scene;
        EXPECT_LE(depth, range.farthest * (1.0 + 1.0e-9)) << "scene " << scene;
      }
    }
  }
  EXPECT_GT(seen, Scenes);
}

TEST(SeenBoxes, SeenDepthsAreTight)
{
  for (const bool parallel : { false, true })
  {
    const View view = LookFrom({ 0, 0, 0 }, { 1, 0, 0 }, parallel); // 0.5 to 30, along +x
    const auto depthsOf = [&](const BoxCorners& box)
    { return SeenDepths(view.clipFromView, view.viewFromWorld, { box }); };
    const DepthRange plain = depthsOf(CornersOf({ 10, 0, 0 }, 0.4));
    EXPECT_NEAR(plain.nearest, 9.6, 0.002);
    EXPECT_NEAR(plain.farthest, 10.4, 0.002);
    // The middle of a slab is seen, its far ends are not.
    const DepthRange slab = depthsOf(Upright({ 10, 0, 0 }, { 0.4, 90, 90 }).Corners());
    EXPECT_NEAR(slab.nearest, 9.6, 0.002);
    EXPECT_NEAR(slab.farthest, 10.4, 0.002);
    const DepthRange around = depthsOf(CornersOf({ 0, 0, 0 }, 3.0));
    EXPECT_NEAR(around.nearest, 0.5, 1.0e-12) << "the eye is inside the box";
    EXPECT_NEAR(around.farthest, 3.0, 0.01) << "the eye is inside the box";
    const DepthRange none = depthsOf(CornersOf({ -10, 0, 0 }, 0.4));
    EXPECT_NEAR(none.nearest, 0.5, 1.0e-12) << "nothing is seen";
    EXPECT_NEAR(none.farthest, 30.0, 1.0e-9) << "nothing is seen";
  }
}

TEST(SeenBoxes, ProjectionsWithOtherPlanes)
{
  const auto expectSame = [](const glm::dmat4& got, const glm::dmat4& expected)
  {
    for (int i = 0; i < 16; ++i)
    {
      EXPECT_NEAR(got[i / 4][i % 4], expected[i / 4][i % 4], 1.0e-12)
        << "column " << i / 4 << ", row " << i % 4;
    }
  };
  expectSame(WithDepthRange(glm::perspective(0.7, 1.3, 0.5, 30.0), { 2.0, 7.0 }),
    glm::perspective(0.7, 1.3, 2.0, 7.0));
  expectSame(WithDepthRange(glm::ortho(-2.0, 3.0, -1.0, 4.0, 0.5, 30.0), { 2.0, 7.0 }),
    glm::ortho(-2.0, 3.0, -1.0, 4.0, 2.0, 7.0));
  expectSame(WithInfiniteFarPlane(glm::perspective(0.7, 1.3, 0.5, 30.0)),
    glm::infinitePerspective(0.7, 1.3, 0.5));
  // Off centre, as for one tile of a wall or one eye of two.
  const glm::dmat4 tile = glm::frustum(-0.1, 0.3, 0.0, 0.2, 0.5, 30.0);
  const glm::dmat4 infinite = WithInfiniteFarPlane(tile);
  const glm::dvec4 place(0.2, 0.1, -0.5, 1.0), far(0.0, 0.0, -1.0, 0.0);
  EXPECT_NEAR((infinite * place).z / (infinite * place).w, -1.0, 1.0e-12) << "the near plane";
  EXPECT_NEAR((infinite * far).z / (infinite * far).w, 1.0, 1.0e-12) << "infinity";
  EXPECT_NEAR((infinite * place).x, (tile * place).x, 1.0e-12);
  EXPECT_NEAR((infinite * place).w, (tile * place).w, 1.0e-12);
}
