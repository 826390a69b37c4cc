#include "PolygonUnion.h"

#include "GridSegments.h"
#include "Parallel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

namespace vtkshadows
{
namespace
{

// Of any polygon, by a fan from its first corner.
template <typename PointOf>
double TwiceAreaOf(std::size_t size, const PointOf& pointOf)
{
  // Neumaier's sum: a thin region's area is small against the terms.
  double sum = 0.0, rest = 0.0;
  for (std::size_t i = 1; i + 1 < size; ++i)
  {
    const double term = TwiceArea(pointOf(0), pointOf(i), pointOf(i + 1));
    const double total = sum + term;
    rest += std::abs(sum) >= std::abs(term) ? (sum - total) + term : (term - total) + sum;
    sum = total;
  }
  return sum + rest;
}

// Where points lie on the grid; each axis has its own step, so that a long shadow is no coarser
// across than along.
struct Grid
{
  glm::dvec2 centre{ 0.0 }, stepsPerUnit{ 1.0 };

  explicit Grid(const std::vector<glm::dvec2>& points)
  {
    glm::dvec2 minimum(std::numeric_limits<double>::infinity()), maximum(-minimum);
    for (const glm::dvec2& p : points)
    {
      minimum = glm::min(minimum, p);
      maximum = glm::max(maximum, p);
    }
    for (int axis = 0; axis < 2 && !points.empty(); ++axis)
    {
      const double half = 0.5 * maximum[axis] - 0.5 * minimum[axis];
      this->centre[axis] = minimum[axis] + half;
      // Not above the largest double, however small the extent.
      this->stepsPerUnit[axis] = std::min(GridEnd / std::max(half, 1e-280), 1e290);
    }
  }
  GridPoint Round(const glm::dvec2& p) const
  {
    const glm::dvec2 scaled = (p - this->centre) * this->stepsPerUnit;
    return glm::clamp(glm::round(scaled), -GridEnd, GridEnd) + 0.0; // no -0
  }
  glm::dvec2 ToPlane(const GridPoint& p) const { return this->centre + p / this->stepsPerUnit; }
};

// Which of two segments that the sweep line crosses is the lower one there. They do not cross.
struct IsBelow
{
  const Segments& segments;
  bool operator()(std::uint32_t first, std::uint32_t second) const
  {
    if (first == second)
    {
      return false;
    }
    const Segment &s = this->segments[first], &t = this->segments[second];
    if (IsBefore(t.a, s.a))
    {
      return SideOf(t, s) < 0;
    }
    return SideOf(s, t) > 0;
  }
  // On which side of s the segment t begins.
  static int SideOf(const Segment& s, const Segment& t)
  {
    const int side = Side(s.a, s.b, t.a);
    return side != 0 ? side : Side(s.a, s.b, t.b);
  }
};

struct DirectedEdge
{
  GridPoint from{ 0.0 }, to{ 0.0 };
};

// Those of the segments, planar and sorted by a, that have the region on one side only, directed so
// that it is to their left.
std::vector<DirectedEdge> FindBoundary(const Segments& segments)
{
  using Status = std::set<std::uint32_t, IsBelow>;
  Status status(IsBelow{ segments });
  std::vector<Status::iterator> places(segments.size(), status.end());
  std::vector<std::int32_t> above(segments.size(), 0);
  std::vector<std::uint32_t> byEnd(segments.size());
  std::iota(byEnd.begin(), byEnd.end(), 0u);
  tbb::parallel_sort(byEnd.begin(), byEnd.end(),
    [&](std::uint32_t i, std::uint32_t j)
    { return segments[i].b == segments[j].b ? i < j : IsBefore(segments[i].b, segments[j].b); });

  std::vector<DirectedEdge> boundary;
  std::vector<std::uint32_t> starting;
  std::size_t ended = 0;
  for (std::size_t first = 0; first < segments.size();)
  {
    const GridPoint vertex = segments[first].a;
    for (; ended < byEnd.size() && !IsBefore(vertex, segments[byEnd[ended]].b); ++ended)
    {
      status.erase(places[byEnd[ended]]);
    }
    starting.clear();
    for (; first < segments.size() && segments[first].a == vertex; ++first)
    {
      starting.push_back(static_cast<std::uint32_t>(first));
    }
    std::sort(starting.begin(), starting.end(), IsBelow{ segments });
    auto next = status.lower_bound(starting.front());
    std::int32_t winding = next == status.begin() ? 0 : above[*std::prev(next)];
    for (const std::uint32_t i : starting)
    {
      const bool isBelowInside = winding > 0;
      winding += segments[i].count;
      above[i] = winding;
      places[i] = status.insert(next, i);
      if (isBelowInside != (winding > 0))
      {
        const Segment& s = segments[i];
        boundary.push_back(isBelowInside ? DirectedEdge{ s.b, s.a } : DirectedEdge{ s.a, s.b });
      }
    }
  }
  return boundary;
}

//------------------------------------------------------------------------------
// Of the edges that leave the end of `edge`, the first one clockwise from the way back: there the
// region that lies to the left of `edge` ends.
template <typename Iterator>
Iterator NextEdge(const DirectedEdge& edge, Iterator first, Iterator last)
{
  const glm::dvec2 back = edge.from - edge.to;
  // 0 if less than half a turn away, 1 if half a turn or more.
  const auto halfOf = [&](const glm::dvec2& d)
  { return SignOfDeterminant(back.x, back.y, d.x, d.y) < 0 ? 0 : 1; };
  return std::min_element(first, last,
    [&](const DirectedEdge& e, const DirectedEdge& f)
    {
      const glm::dvec2 d = e.to - e.from, g = f.to - f.from;
      const int half = halfOf(d), otherHalf = halfOf(g);
      return half != otherHalf ? half < otherHalf : SignOfDeterminant(d.x, d.y, g.x, g.y) < 0;
    });
}

// Calls use(loop) for each loop of points.
template <typename Use>
void ForEachLoop(std::vector<DirectedEdge> edges, const Use& use)
{
  const auto isBefore = [](const DirectedEdge& e, const DirectedEdge& f)
  { return e.from == f.from ? IsBefore(e.to, f.to) : IsBefore(e.from, f.from); };
  tbb::parallel_sort(edges.begin(), edges.end(), isBefore);
  std::vector<char> isUsed(edges.size(), 0);
  std::vector<GridPoint> loop;
  for (std::size_t start = 0; start < edges.size(); ++start)
  {
    loop.clear();
    for (std::size_t i = start; !isUsed[i];)
    {
      isUsed[i] = 1;
      loop.push_back(edges[i].from);
      const GridPoint& end = edges[i].to;
      const auto first = std::lower_bound(edges.begin(), edges.end(), end,
        [](const DirectedEdge& e, const GridPoint& p) { return IsBefore(e.from, p); });
      const auto last =
        std::find_if(first, edges.end(), [&end](const DirectedEdge& e) { return e.from != end; });
      i = NextEdge(edges[i], first, last) - edges.begin();
    }
    if (!loop.empty())
    {
      use(loop);
    }
  }
}

//------------------------------------------------------------------------------
// The union of a range of polygons, by their numbers.
class Uniter
{
public:
  Uniter(const PolygonSet& polygons, const Grid& grid)
    : Polygons(polygons)
    , Points(polygons.points.size())
  {
    ForEachBlock(this->Points.size(),
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        for (std::size_t i = first; i < last; ++i)
        {
          this->Points[i] = grid.Round(polygons.points[i]);
        }
      });
  }

  const std::vector<GridPoint>& GetPoints() const { return this->Points; }

  std::vector<DirectedEdge> Unite(std::uint32_t* first, std::uint32_t* last) const
  {
    Segments segments = this->Edges(first, last);
    MergeSegments(segments);
    // A mesh is cheapest at once: halves are cut apart, and joined again. Where many layers lie one
    // above the other, what is in a half is mostly inside of it.
    const std::size_t count = last - first;
    const std::size_t most =
      count < 2 ? std::numeric_limits<std::size_t>::max() : 16 * segments.size() + 1000;
    if (!MakePlanar(segments, most))
    {
      segments = this->UniteHalves(first, last);
      MakePlanar(segments, std::numeric_limits<std::size_t>::max());
    }
    return FindBoundary(segments);
  }

private:
  GridPoint CornerOf(std::uint32_t polygon, std::size_t corner) const
  {
    return this->Points[this->Polygons.corners[this->Polygons.starts[polygon] + corner]];
  }

  Segments Edges(const std::uint32_t* firstPolygon, const std::uint32_t* lastPolygon) const
  {
    const std::size_t count = lastPolygon - firstPolygon;
    std::vector<Segments> some(NumberOfBlocks(count));
    ForEachBlock(count,
      [&](std::size_t block, std::size_t first, std::size_t last)
      {
        for (std::size_t i = first; i < last; ++i)
        {
          this->AddEdges(firstPolygon[i], some[block]);
        }
      });
    Segments all;
    for (const Segments& of : some)
    {
      all.insert(all.end(), of.begin(), of.end());
    }
    return all;
  }

  void AddEdges(std::uint32_t polygon, Segments& segments) const
  {
    const std::size_t size = this->Polygons.starts[polygon + 1] - this->Polygons.starts[polygon];
    const double area =
      TwiceAreaOf(size, [&](std::size_t i) { return this->CornerOf(polygon, i); });
    for (std::size_t i = 0; i < size && area != 0.0; ++i)
    {
      Segment s = SegmentOf(this->CornerOf(polygon, i), this->CornerOf(polygon, (i + 1) % size));
      s.count = area > 0.0 ? s.count : -s.count;
      if (s.a != s.b)
      {
        segments.push_back(s);
      }
    }
  }

  Segments UniteHalves(std::uint32_t* first, std::uint32_t* last) const
  {
    glm::dvec2 minimum(GridEnd), maximum(-GridEnd);
    for (const std::uint32_t* i = first; i < last; ++i)
    {
      minimum = glm::min(minimum, this->CornerOf(*i, 0));
      maximum = glm::max(maximum, this->CornerOf(*i, 0));
    }
    const glm::dvec2 size = maximum - minimum;
    const int axis = size.x >= size.y ? 0 : 1;
    std::uint32_t* middle = first + (last - first) / 2;
    std::nth_element(first, middle, last,
      [&](std::uint32_t i, std::uint32_t j)
      {
        const double p = this->CornerOf(i, 0)[axis], q = this->CornerOf(j, 0)[axis];
        return p == q ? i < j : p < q;
      });
    const std::vector<DirectedEdge> halves[2] = { this->Unite(first, middle),
      this->Unite(middle, last) };
    Segments segments;
    for (const std::vector<DirectedEdge>& half : halves)
    {
      for (const DirectedEdge& edge : half)
      {
        segments.push_back(SegmentOf(edge.from, edge.to));
      }
    }
    MergeSegments(segments);
    return segments;
  }

  const PolygonSet& Polygons;
  std::vector<GridPoint> Points;
};

// Finds the lowest of the points at a place of the grid.
class PointFinder
{
public:
  explicit PointFinder(const std::vector<GridPoint>& points)
    : Points(points)
    , Order(points.size())
  {
    std::iota(this->Order.begin(), this->Order.end(), 0u);
    tbb::parallel_sort(this->Order.begin(), this->Order.end(),
      [&](std::uint32_t i, std::uint32_t j)
      { return points[i] == points[j] ? i < j : IsBefore(points[i], points[j]); });
  }
  std::uint32_t Find(const GridPoint& p) const
  {
    const auto found = std::lower_bound(this->Order.begin(), this->Order.end(), p,
      [&](std::uint32_t i, const GridPoint& place) { return IsBefore(this->Points[i], place); });
    return found != this->Order.end() && this->Points[*found] == p ? *found : NoPoint;
  }

private:
  const std::vector<GridPoint>& Points;
  std::vector<std::uint32_t> Order;
};

// No wider, in the mean, than a few steps of the grid.
bool IsRounding(const std::vector<GridPoint>& loop)
{
  double length = glm::distance(loop.front(), loop.back());
  for (std::size_t i = 1; i < loop.size(); ++i)
  {
    length += glm::distance(loop[i - 1], loop[i]);
  }
  const double area = TwiceAreaOf(loop.size(), [&loop](std::size_t i) { return loop[i]; });
  return std::abs(area) <= 2.0 * length;
}

}

//------------------------------------------------------------------------------
UnionOutline UnitePolygons(const PolygonSet& polygons)
{
  const Grid grid(polygons.points);
  const Uniter uniter(polygons, grid);
  std::vector<std::uint32_t> numbers(polygons.NumberOfPolygons());
  std::iota(numbers.begin(), numbers.end(), 0u);
  const PointFinder finder(uniter.GetPoints());

  UnionOutline outline;
  PolygonSet& loops = outline.loops;
  ForEachLoop(uniter.Unite(numbers.data(), numbers.data() + numbers.size()),
    [&](const std::vector<GridPoint>& loop)
    {
      if (IsRounding(loop))
      {
        return;
      }
      const std::size_t first = loops.points.size();
      for (const GridPoint& p : loop)
      {
        const std::uint32_t original = finder.Find(p);
        loops.corners.push_back(static_cast<std::uint32_t>(loops.points.size()));
        loops.points.push_back(original == NoPoint ? grid.ToPlane(p) : polygons.points[original]);
        outline.originals.push_back(original);
      }
      loops.starts.push_back(static_cast<std::uint32_t>(loops.points.size()));
      outline.areas.push_back(
        0.5 * TwiceAreaOf(loop.size(), [&](std::size_t i) { return loops.points[first + i]; }));
      outline.area += outline.areas.back();
    });
  return outline;
}

}
