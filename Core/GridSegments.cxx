#include "GridSegments.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace vtkshadows
{
namespace
{

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

}

//------------------------------------------------------------------------------
void MergeSegments(Segments& segments)
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
bool MakePlanar(Segments& segments, std::size_t most)
{
  constexpr int MostRounds = 100; // up to 11 were seen
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
    MergeSegments(segments);
  }
  if (!segments.empty())
  {
    throw std::runtime_error("An outline of " + std::to_string(segments.size()) +
      " segments still crosses itself after " + std::to_string(MostRounds) +
      " rounds of splitting: move the light or the mesh a little.");
  }
  return true;
}

}
