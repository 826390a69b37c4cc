// Segments between points of a grid: exact predicates, and a planar arrangement of them.
//
// @par Reference: J. Hobby: Practical segment intersection with finite precision output,
// Computational Geometry 13(4), 1999; D. Halperin, E. Packer: Iterated snap rounding, Computational
// Geometry 23(2), 2002.
#ifndef vtkshadows_GridSegments_h
#define vtkshadows_GridSegments_h

#include <glm/vec2.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkshadows
{

// On the grid: whole numbers, at most GridEnd in magnitude, so that differences are exact.
using GridPoint = glm::dvec2;
constexpr double GridEnd = 562949953421312.0; // 2^49

inline bool IsBefore(const GridPoint& a, const GridPoint& b)
{
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

// a * d - b * c, with a relative error of a few roundings; 0 if and only if it is 0.
inline double Determinant(double a, double b, double c, double d)
{
  const double p = a * d, q = b * c;
  return (p - q) + (std::fma(a, d, -p) - std::fma(b, c, -q));
}

// The sign of a * d - b * c, exactly. Rounding keeps order: unless both products round to the same,
// they compare as they are; else what was rounded off decides.
inline int SignOfDeterminant(double a, double b, double c, double d)
{
  const double p = a * d, q = b * c;
  if (p != q)
  {
    return p > q ? 1 : -1;
  }
  const double pRest = std::fma(a, d, -p), qRest = std::fma(b, c, -q);
  return (pRest > qRest) - (pRest < qRest);
}

// +1 if c lies to the left of a -> b, -1 to the right, 0 on it.
inline int Side(const GridPoint& a, const GridPoint& b, const GridPoint& c)
{
  return SignOfDeterminant(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
}

// Twice the area of a, b, c; positive counter-clockwise.
inline double TwiceArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
  return Determinant(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
}

// From its lower end to its higher one. A region lies to the left `count` times more often than to
// the right.
struct Segment
{
  GridPoint a{ 0.0 }, b{ 0.0 };
  std::int32_t count = 0;
  bool isNew = true; // MakePlanar: not yet held against the others

  bool IsAlong(const Segment& other) const { return this->a == other.a && this->b == other.b; }
};
using Segments = std::vector<Segment>;

inline Segment SegmentOf(const GridPoint& from, const GridPoint& to)
{
  return IsBefore(from, to) ? Segment{ from, to, 1 } : Segment{ to, from, -1 };
}

// Sorts by a and then b, makes one of those that are along each other, and drops what cancels.
void MergeSegments(Segments& segments);

// Splits merged segments until none crosses or touches another but at its ends, where two that come
// as near as half a step of the grid touch; crossings are rounded to the grid. The result is
// merged. false, and nothing is changed, if that would make more than `most` splits in the first
// round. On all cores, with the same result on any number of them. std::runtime_error if it does
// not end, which has not been seen.
bool MakePlanar(Segments& segments, std::size_t most);

}

#endif
