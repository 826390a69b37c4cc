// A flat screen and what it hides from the eye of what lies behind it. All in world coordinates and
// double.
#ifndef vtkshadows_HidingScreen_h
#define vtkshadows_HidingScreen_h

#include "LightView.h" // for BoxCorners

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <optional>
#include <vector>

namespace vtkshadows
{

// The corners of a flat convex screen, in their order around it.
using ScreenCorners = std::array<glm::dvec3, 4>;

// A rectangle along two axes.
struct FlatBounds
{
  glm::dvec2 low{ 0.0 }, high{ 0.0 };
};

// The bounds of triangles that are flat across `axis` (0 to 2), along the two axes after it; none
// if they leave a hole in that rectangle. Turned the same way, their edges that no neighbour takes
// back are their outline: if all of it lies on the rectangle's sides, it winds equally often around
// every place within, and areas tell that this is once. A mesh whose neighbours do not share their
// points is taken for one with holes.
std::optional<FlatBounds> FilledBounds(
  std::vector<glm::vec3> points, std::vector<glm::uvec3> triangles, int axis);

// What an eye sees, and by how many pixels.
struct PixelView
{
  glm::dmat4 clipFromWorld{ 1.0 };
  // (position, 1), or of a parallel projection (the direction from which it looks, 0)
  glm::dvec4 eye{ 0.0, 0.0, 0.0, 1.0 };
  int width = 0, height = 0;
};

// In how many pixels at most the eye sees past the screen what of a box lies behind it: beyond its
// plane n.x = d, given as (n, d), by more than `rounding`. If there is any, and the eye is not on
// the side that n points to, or would see some of the screen before its near plane: infinite.
double PixelsSeenPast(const ScreenCorners& screen, const glm::dvec4& plane, const BoxCorners& box,
  double rounding, const PixelView& view);

}

#endif
