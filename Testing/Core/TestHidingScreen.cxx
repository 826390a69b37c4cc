// Which meshes fill a rectangle, and how many pixels show what lies behind a screen.
#include "BoxesByLot.h"
#include "HidingScreen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace vtkshadows;
using namespace coretest;

namespace
{

// A grid of square cells across an axis, two triangles each, those alone for which wants(i, j).
struct Grid
{
  std::vector<glm::vec3> points;
  std::vector<glm::uvec3> triangles;

  Grid(int side, int axis, const std::function<bool(int, int)>& wants)
  {
    const auto at = [&](int i, int j)
    {
      // Each cell has points of its own.
      glm::vec3 p(0.25f);
      p[(axis + 1) % 3] = 0.1f * static_cast<float>(i) - 3.0f;
      p[(axis + 2) % 3] = 0.1f * static_cast<float>(j) + 2.0f;
      this->points.push_back(p);
      return static_cast<unsigned int>(this->points.size() - 1);
    };
    for (int i = 0; i < side; ++i)
    {
      for (int j = 0; j < side; ++j)
      {
        if (wants(i, j))
        {
          const unsigned int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
          this->triangles.emplace_back(a, b, c);
          this->triangles.emplace_back(a, d, c); // the other way round
        }
      }
    }
  }

  std::optional<FlatBounds> Filled(int axis) const
  {
    return FilledBounds(this->points, this->triangles, axis);
  }
};

// A wall 20 wide and 8 high in the plane y = 0, seen from its side of smaller y.
const ScreenCorners Wall{ { { -10, 0, 0 }, { 10, 0, 0 }, { 10, 0, 8 }, { -10, 0, 8 } } };
const glm::dvec4 WallPlane(0.0, -1.0, 0.0, 0.0);
constexpr int Width = 400, Height = 300;

PixelView PixelsOf(const View& view)
{
  return { view.ClipFromWorld(), view.eye, Width, Height };
}

// A box of no depth, in a plane of constant y.
BoxCorners Panel(double lowX, double highX, double y, double lowZ, double highZ)
{
  return Upright({ 0.5 * (lowX + highX), y, 0.5 * (lowZ + highZ) },
    { 0.5 * (highX - lowX), 0.0, 0.5 * (highZ - lowZ) })
    .Corners();
}

}

//------------------------------------------------------------------------------
TEST(HidingScreen, AGridFillsItsBounds)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto filled = Grid(9, axis, [](int, int) { return true; }).Filled(axis);
    ASSERT_TRUE(filled) << "axis " << axis;
    EXPECT_NEAR(filled->low.x, -3.0, 1e-6);
    EXPECT_NEAR(filled->high.x, -2.1, 1e-6);
    EXPECT_NEAR(filled->low.y, 2.0, 1e-6);
    EXPECT_NEAR(filled->high.y, 2.9, 1e-6);
  }
}

TEST(HidingScreen, HolesAndOtherOutlinesAreToldFromIt)
{
  EXPECT_FALSE(Grid(9, 2, [](int i, int j) { return i != 4 || j != 4; }).Filled(2)) << "a hole";
  EXPECT_FALSE(Grid(9, 2, [](int i, int j) { return i != 0 || j != 3; }).Filled(2)) << "a notch";
  EXPECT_FALSE(Grid(40, 2, [](int i, int j) { return i + j > 0; }).Filled(2)) << "a corner";
  EXPECT_FALSE(FilledBounds({}, {}, 0)) << "nothing";

  // A hole of the area of what lies twice.
  Grid twice(9, 2, [](int i, int j) { return i != 4 || j != 4; });
  twice.triangles.push_back(twice.triangles[0]);
  twice.triangles.push_back(twice.triangles[1]);
  EXPECT_FALSE(twice.Filled(2)) << "a hole, and a cell that lies twice";

  // Half of it, with each cell twice.
  Grid half(4, 2, [](int, int j) { return j == 0 || j == 3; });
  const std::vector<glm::uvec3> once = half.triangles;
  half.triangles.insert(half.triangles.end(), once.begin(), once.end());
  EXPECT_FALSE(half.Filled(2)) << "stripes that lie twice";
}

//------------------------------------------------------------------------------
// Straight on, from 10 before the wall at a height of 4: what is 5 behind it has 2/3 of the size.
TEST(HidingScreen, PixelsPastTheSidesHaveTheirArea)
{
  const View view = LookFrom({ 0, -10, 4 }, { 0, 0, 4 }, false, 0.5, 100.0, 4.0);
  const PixelView pixels = PixelsOf(view);
  const auto past = [&](const BoxCorners& box)
  { return PixelsSeenPast(Wall, WallPlane, box, 1e-9, pixels); };
  // A side of it is seen through x = 15 at that depth.
  EXPECT_EQ(past(Panel(-12, 14.9, 5, -1.9, 9.9)), 0.0) << "behind the wall";
  EXPECT_EQ(past(Panel(11, 13, -1, 0, 8)), 0.0) << "before its plane";

  // Both sides of a panel are counted.
  const double tangent = 0.4 * 4.0; // of half the view's height
  const double perUnit = 0.5 * Height / tangent / 15.0;
  const double ofWidth = 0.5 * Width / (1.3 * tangent) / 15.0;
  EXPECT_NEAR(past(Panel(14, 17, 5, 3, 4)), 2.0 * 2.0 * ofWidth * perUnit, 1e-6);
  EXPECT_NEAR(past(Panel(-1, 1, 5, 9, 11)), 2.0 * 2.0 * ofWidth * perUnit, 1e-6);
  // Through the plane: the part behind it.
  EXPECT_GT(past(Upright({ 16, 0, 4 }, { 1, 5, 1 }).Corners()), 1.0);
}

TEST(HidingScreen, NothingIsHiddenFromTheOtherSideOrThroughTheNearPlane)
{
  const BoxCorners box = Panel(-1, 1, 5, 3, 4);
  const auto past = [&](const View& view)
  { return PixelsSeenPast(Wall, WallPlane, box, 1e-9, PixelsOf(view)); };
  EXPECT_EQ(past(LookFrom({ 0, -10, 4 }, { 0, 0, 4 }, false)), 0.0);
  EXPECT_EQ(past(LookFrom({ 0, -10, 4 }, { 0, 0, 4 }, true)), 0.0);
  EXPECT_TRUE(std::isinf(past(LookFrom({ 0, 20, 4 }, { 0, 0, 4 }, false))));
  EXPECT_TRUE(std::isinf(past(LookFrom({ 0, 20, 4 }, { 0, 0, 4 }, true))));
  EXPECT_TRUE(std::isinf(past(LookFrom({ 0, -0.3, 4 }, { 0, 5, 4 }, false))));
}

//------------------------------------------------------------------------------
// Held against points of boxes, drawn by lot: where one is seen past the wall there are pixels.
TEST(HidingScreen, NoPointThatIsSeenIsMissed)
{
  Lot lot(29);
  int seen = 0, hidden = 0;
  for (int scene = 0; scene < Scenes; ++scene)
  {
    const Solid solid = lot.AnySolid();
    const View view = lot.AnyView();
    ScreenCorners screen;
    for (std::size_t i = 0; i < screen.size(); ++i)
    {
      screen[i] = 0.25 * Wall[i] - glm::dvec3(0.0, 0.0, 1.0);
    }
    const glm::dvec4 plane = view.eye.y * WallPlane.y > 0.0 ? WallPlane : -WallPlane;
    const double pixels = PixelsSeenPast(screen, plane, solid.Corners(), 1e-9, PixelsOf(view));
    bool isSeen = false;
    for (int i = 0; i < Samples; ++i)
    {
      glm::dvec3 onFace = lot.Within(1.0);
      onFace[i % 3] = onFace[i % 3] > 0.0 ? 1.0 : -1.0;
      const glm::dvec3 p = solid.At(onFace);
      const glm::dvec4 clip = view.ClipFromWorld() * glm::dvec4(p, 1.0);
      const double height = glm::dot(glm::dvec3(plane), p);
      const double eyeHeight = glm::dot(glm::dvec3(plane), glm::dvec3(view.eye));
      if (!IsInView(clip) || height >= 0.0)
      {
        continue;
      }
      // Where its way to the eye meets the plane.
      const glm::dvec3 toward = glm::dvec3(view.eye) - p * view.eye.w;
      const glm::dvec3 at = p - toward * (height / (eyeHeight - height * view.eye.w));
      const bool isBeside =
        at.x < screen[0].x || at.x > screen[1].x || at.z < screen[0].z || at.z > screen[2].z;
      isSeen = isSeen || isBeside;
    }
    EXPECT_TRUE(!isSeen || pixels > 0.0) << "scene " << scene;
    seen += isSeen ? 1 : 0;
    hidden += pixels == 0.0 ? 1 : 0;
  }
  EXPECT_GT(seen, Scenes / 20);
  EXPECT_GT(hidden, Scenes / 20);
}
