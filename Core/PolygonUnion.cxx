#include "PolygonUnion.h"

#include "Parallel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

namespace vtkshadows
{
namespace
{

// On the grid: whole numbers, at most GridEnd in magnitude, so that differences are exact.
using GridPoint = glm::dvec2;
constexpr double GridEnd = 562949953421312.0; // 2^49

bool IsBefore(const GridPoint& a, const GridPoint& b)
{
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

// a * d - b * c, with a relative error of a few roundings; 0 if and only if it is 0.
double Determinant(double a, double b, double c, double d)
{
  const double p = a * d, q = b * c;
  return (p - q) + (std::fma(a, d, -p) - std::fma(b, c, -q));
}

// The sign of a * d - b * c, exactly. Rounding keeps order: unless both products round to the same,
// they compare as they are; else what was rounded off decides.
int SignOfDeterminant(double a, double b, double c, double d)
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
int Side(const GridPoint& a, const GridPoint& b, const GridPoint& c)
{
  return SignOfDeterminant(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
}

// Twice the area of a, b, c; positive counter-clockwise.
double TwiceArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
  return Determinant(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
}

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

// An edge from its lower end to its higher one. Its region lies to the left `count` times more
// often than to the right.
struct Segment
{
  GridPoint a{ 0.0 }, b{ 0.0 };
  std::int32_t count = 0;
  bool isNew = true; // not yet held against the others

  bool IsAlong(const Segment& other) const { return this->a == other.a && this->b == other.b; }
};
using Segments = std::vector<Segment>;

Segment SegmentOf(const GridPoint& from, const GridPoint& to)
{
  return IsBefore(from, to) ? Segment{ from, to, 1 } : Segment{ to, from, -1 };
}

// Sorts, makes one of those that are along each other, and drops what cancels.
void Merge(Segments& segments)
{
  tbb::parallel_sort(segments.begin(), segments.end(),
    [](const Segment& s, const Segment& t)
    { return s.a == t.a ? IsBefore(s.b, t.b) : IsBefore(s.a, t.a); });
  std::size_t kept = 0;
  for (std::size_t first = 0; first < segments.size();)
  {
    Segment sum = segments[first];
    std::size_t next = first + 1;
    for (; next < segments.size() && segments[next].IsAlong(sum); ++next)
    {
      sum.count += segments[next].count;
      sum.isNew = sum.isNew || segments[next].isNew;
    }
    if (sum.count != 0 && sum.a != sum.b)
    {
      segments[kept++] = sum;
    }
    first = next;
  }
  segments.resize(kept);
}

//------------------------------------------------------------------------------
struct Box2
{
  glm::dvec2 minimum{ std::numeric_limits<double>::infinity() };
  glm::dvec2 maximum{ -std::numeric_limits<double>::infinity() };

  void Add(const Box2& box)
  {
    this->minimum = glm::min(this->minimum, box.minimum);
    this->maximum = glm::max(this->maximum, box.maximum);
  }
  bool Meets(const Box2& box) const
  {
    return this->minimum.x <= box.maximum.x && box.minimum.x <= this->maximum.x &&
      this->minimum.y <= box.maximum.y && box.minimum.y <= this->maximum.y;
  }
};

// Below this distance, in steps of the grid, an end is on a segment. At most half a step: of the
// points of the grid that are on a segment, no two lie side by side across it, and splitting ends.
constexpr double Near = 0.5;
// A loop of this mean width, in steps, is none.
constexpr double Narrow = 2.0;

// A segment, or a part of one that is long for its kind: boxes round parts are smaller.
struct Part
{
  Box2 box;
  std::uint32_t segment = 0;
  std::uint32_t code = 0; // along a space-filling curve
};

std::uint32_t SpreadBits(std::uint32_t x)
{
  x = (x | x << 8) & 0x00ff00ffu;
  x = (x | x << 4) & 0x0f0f0f0fu;
  x = (x | x << 2) & 0x33333333u;
  return (x | x << 1) & 0x55555555u;
}

// Parts of segments by where they are: a tree of boxes over parts in Morton's order.
class PartTree
{
public:
  explicit PartTree(const Segments& segments)
  {
    double length = 0.0;
    for (const Segment& s : segments)
    {
      length += glm::distance(s.a, s.b);
    }
    const double partLength = 0.5 * length / static_cast<double>(segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
      this->Add(segments[i], static_cast<std::uint32_t>(i), partLength);
    }
    tbb::parallel_sort(this->Parts.begin(), this->Parts.end(),
      [](const Part& p, const Part& q)
      {
        return std::make_pair(p.code, p.segment) < std::make_pair(q.code, q.segment) ||
          (p.code == q.code && p.segment == q.segment && IsBefore(p.box.minimum, q.box.minimum));
      });
    this->Levels.emplace_back((this->Parts.size() + Arity - 1) / Arity);
    for (std::size_t i = 0; i < this->Parts.size(); ++i)
    {
      this->Levels[0][i / Arity].Add(this->Parts[i].box);
    }
    while (this->Levels.back().size() > 1)
    {
      const std::vector<Box2>& below = this->Levels.back();
      std::vector<Box2> level((below.size() + Arity - 1) / Arity);
      for (std::size_t i = 0; i < below.size(); ++i)
      {
        level[i / Arity].Add(below[i]);
      }
      this->Levels.push_back(std::move(level));
    }
  }

  const std::vector<Part>& GetParts() const { return this->Parts; }

  // Calls use(segment) for each part whose box meets this one.
  template <typename Use>
  void ForEachNear(const Box2& box, const Use& use) const
  {
    this->Visit(this->Levels.size(), 0, box, use);
  }

private:
  static constexpr std::size_t Arity = 4;

  void Add(const Segment& s, std::uint32_t segment, double partLength)
  {
    const auto count =
      static_cast<int>(std::min(std::ceil(glm::distance(s.a, s.b) / partLength), 1e6));
    const glm::dvec2 margin(Near + 1.0);
    for (int i = 0; i < std::max(count, 1); ++i)
    {
      const glm::dvec2 from = glm::mix(s.a, s.b, i / static_cast<double>(count));
      const glm::dvec2 to = glm::mix(s.a, s.b, (i + 1) / static_cast<double>(count));
      const glm::dvec2 middle = (0.5 * (from + to) + GridEnd) * (65535.0 / (2.0 * GridEnd));
      this->Parts.push_back({ { glm::min(from, to) - margin, glm::max(from, to) + margin }, segment,
        SpreadBits(static_cast<std::uint32_t>(middle.x)) |
          SpreadBits(static_cast<std::uint32_t>(middle.y)) << 1 });
    }
  }

  // The boxes `first` and its brothers, one level below `level`.
  template <typename Use>
  void Visit(std::size_t level, std::size_t first, const Box2& box, const Use& use) const
  {
    if (level == 0)
    {
      const std::size_t last = std::min(first + Arity, this->Parts.size());
      for (std::size_t i = first; i < last; ++i)
      {
        if (this->Parts[i].box.Meets(box))
        {
          use(this->Parts[i].segment);
        }
      }
      return;
    }
    const std::vector<Box2>& boxes = this->Levels[level - 1];
    const std::size_t last = std::min(first + Arity, boxes.size());
    for (std::size_t i = first; i < last; ++i)
    {
      if (boxes[i].Meets(box))
      {
        this->Visit(level - 1, i * Arity, box, use);
      }
    }
  }

  std::vector<Part> Parts;
  std::vector<std::vector<Box2>> Levels; // the last is the root
};

//------------------------------------------------------------------------------
// That a segment is to pass through a point.
struct Split
{
  std::uint32_t segment = 0;
  GridPoint point{ 0.0 };
};

// Whether p lies on the segment between its ends, but for Near.
bool IsOn(const Segment& s, const GridPoint& p)
{
  const glm::dvec2 along = s.b - s.a, toward = p - s.a;
  const double covered = glm::dot(along, toward), whole = glm::dot(along, along);
  return covered > 0.0 && covered < whole && p != s.a && p != s.b &&
    std::abs(Determinant(along.x, along.y, toward.x, toward.y)) < Near * std::sqrt(whole);
}

// Whether t lies to one side of s, and is farther from it than Near. Rounding makes less than a
// step of the grid.
bool IsAside(const Segment& s, const Segment& t)
{
  const glm::dvec2 along = s.b - s.a, first = t.a - s.a, second = t.b - s.a;
  const double p = along.x * first.y - along.y * first.x;
  const double q = along.x * second.y - along.y * second.x;
  const double least = 2.0 * (std::abs(along.x) + std::abs(along.y));
  return (p > least && q > least) || (p < -least && q < -least);
}

// Calls use(which, point) where one of the two is to be split, 0 for s and 1 for t.
template <typename Use>
void MeetSegments(const Segment& s, const Segment& t, const Use& use)
{
  if (IsAside(s, t) || IsAside(t, s))
  {
    return;
  }
  bool isTouched = false;
  const auto touch = [&](const Segment& segment, const GridPoint& end, int which)
  {
    if (IsOn(segment, end))
    {
      isTouched = true;
      use(which, end);
    }
  };
  touch(s, t.a, 0);
  touch(s, t.b, 0);
  touch(t, s.a, 1);
  touch(t, s.b, 1);
  if (isTouched || Side(s.a, s.b, t.a) * Side(s.a, s.b, t.b) >= 0 ||
    Side(t.a, t.b, s.a) * Side(t.a, t.b, s.b) >= 0)
  {
    return;
  }
  const glm::dvec2 along = s.b - s.a, across = t.b - t.a, between = t.a - s.a;
  const double share = Determinant(between.x, between.y, across.x, across.y) /
    Determinant(along.x, along.y, across.x, across.y);
  const GridPoint crossing = glm::round(s.a + share * along) + 0.0;
  if (crossing != s.a && crossing != s.b)
  {
    use(0, crossing);
  }
  if (crossing != t.a && crossing != t.b)
  {
    use(1, crossing);
  }
}

// Of new segments against all. false if there are more than `most`; `splits` is then incomplete.
bool FindSplits(const Segments& segments, std::size_t most, std::vector<Split>& splits)
{
  const PartTree tree(segments);
  const std::vector<Part>& parts = tree.GetParts();
  // Small blocks: a long segment meets many.
  constexpr std::size_t Size = 256;
  const std::size_t blocks = (parts.size() + Size - 1) / Size;
  std::vector<std::vector<Split>> found(blocks);
  std::atomic<std::size_t> total{ 0 };
  tbb::parallel_for(std::size_t(0), blocks,
    [&](std::size_t block)
    {
      for (std::size_t i = block * Size; i < std::min((block + 1) * Size, parts.size()); ++i)
      {
        const std::uint32_t first = parts[i].segment;
        const Segment& s = segments[first];
        if (!s.isNew || total.load(std::memory_order_relaxed) > most)
        {
          continue;
        }
        const std::size_t before = found[block].size();
        tree.ForEachNear(parts[i].box,
          [&](std::uint32_t second)
          {
            const Segment& t = segments[second];
            if (second != first && (!t.isNew || second > first))
            {
              MeetSegments(s, t,
                [&](int which, const GridPoint& p) {
                  found[block].push_back({ which == 0 ? first : second, p });
                });
            }
          });
        total += found[block].size() - before;
      }
    });
  splits.clear();
  for (const std::vector<Split>& some : found)
  {
    splits.insert(splits.end(), some.begin(), some.end());
  }
  return total <= most;
}

// Replaces each segment that is to be split by its parts, in order along it.
void SplitSegments(Segments& segments, std::vector<Split>& splits)
{
  tbb::parallel_sort(splits.begin(), splits.end(),
    [](const Split& p, const Split& q)
    { return p.segment == q.segment ? IsBefore(p.point, q.point) : p.segment < q.segment; });
  for (Segment& s : segments)
  {
    s.isNew = false;
  }
  std::vector<GridPoint> places;
  for (auto first = splits.begin(); first != splits.end();)
  {
    const Segment whole = segments[first->segment];
    auto last = first;
    places.assign(1, whole.a);
    for (; last != splits.end() && last->segment == first->segment; ++last)
    {
      if (last->point != places.back())
      {
        places.push_back(last->point);
      }
    }
    places.push_back(whole.b);
    const glm::dvec2 along = whole.b - whole.a;
    std::sort(places.begin() + 1, places.end() - 1,
      [&](const GridPoint& p, const GridPoint& q)
      {
        const double atP = glm::dot(along, p - whole.a), atQ = glm::dot(along, q - whole.a);
        return atP == atQ ? IsBefore(p, q) : atP < atQ;
      });
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
    {
      Segment part = SegmentOf(places[i], places[i + 1]);
      part.count *= whole.count;
      if (i == 0)
      {
        segments[first->segment] = part;
      }
      else
      {
        segments.push_back(part);
      }
    }
    first = last;
  }
}

// Splits segments until none crosses or touches another but at its ends. false if that would make
// more than `most` splits in the first round.
bool MakePlanar(Segments& segments, std::size_t most)
{
  constexpr int MostRounds = 100; // 2 to 5 do
  std::vector<Split> splits;
  for (int round = 0; round < MostRounds && !segments.empty(); ++round)
  {
    if (!FindSplits(segments, round == 0 ? most : std::numeric_limits<std::size_t>::max(), splits))
    {
      return false;
    }
    if (splits.empty())
    {
      return true;
    }
    SplitSegments(segments, splits);
    Merge(segments);
  }
  if (!segments.empty())
  {
    throw std::runtime_error("the shadow's outline could not be made planar");
  }
  return true;
}

//------------------------------------------------------------------------------
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
    Merge(segments);
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
    Box2 box;
    for (const std::uint32_t* i = first; i < last; ++i)
    {
      const GridPoint p = this->CornerOf(*i, 0);
      box.Add({ p, p });
    }
    const glm::dvec2 size = box.maximum - box.minimum;
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
    Merge(segments);
    return segments;
  }

  const PolygonSet& Polygons;
  std::vector<GridPoint> Points;
};

// Finds the lowest of the set's points at a place of the grid.
class PointFinder
{
public:
  PointFinder(const PolygonSet& polygons, const std::vector<GridPoint>& points)
    : Points(points)
    , Order(polygons.corners)
  {
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

// No wider than the grid can tell.
bool IsRounding(const std::vector<GridPoint>& loop)
{
  double length = glm::distance(loop.front(), loop.back());
  for (std::size_t i = 1; i < loop.size(); ++i)
  {
    length += glm::distance(loop[i - 1], loop[i]);
  }
  const double area = TwiceAreaOf(loop.size(), [&loop](std::size_t i) { return loop[i]; });
  return std::abs(area) <= Narrow * length;
}

}

//------------------------------------------------------------------------------
UnionOutline UnitePolygons(const PolygonSet& polygons)
{
  const Grid grid(polygons.points);
  const Uniter uniter(polygons, grid);
  std::vector<std::uint32_t> numbers(polygons.NumberOfPolygons());
  std::iota(numbers.begin(), numbers.end(), 0u);
  const PointFinder finder(polygons, uniter.GetPoints());

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
