#include "PlanarShadow.h"

#include "Parallel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vtkshadows
{
namespace
{

// A point of a caster, thrown on the plane and not yet divided: (u, v, w) on the plane, and its
// height over it. All four are linear in the point, so that what lies on a side is between its
// ends.
using Thrown = glm::dvec4;

// The half-space that is kept: dot(*this, thrown) >= 0.
using Cut = glm::dvec4;

// Nearer to the light's height than this, in shares of it, a caster's shadow counts as unbounded.
constexpr double NearestToLight = 1e-6;
// Where points are at the light's height, but for rounding.
constexpr double LeastW = 1e-14;
// What direction or height is none, but for rounding.
constexpr double Negligible = 1e-12;

glm::dvec3 Unit(const glm::dvec3& v)
{
  // By the largest component first: its square could be too large or too small for a double.
  return glm::normalize(v / std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) }));
}

double LargestOf(const glm::dvec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

Box BoundsOf(const std::vector<glm::dvec3>& points)
{
  Box box;
  box.Add(points);
  return box;
}

// The light over the plane. Lengths are relative to the mesh's middle.
class Thrower
{
public:
  Thrower(const Box& meshBounds, const glm::dvec4& light, const glm::dvec3& planePoint,
    const glm::dvec3& planeNormal)
    : Middle(0.5 * meshBounds.minimum + 0.5 * meshBounds.maximum)
    , Size(0.5 * meshBounds.Diagonal())
    , LightW(light.w)
  {
    PlaneFrame& frame = this->Frame;
    frame.normal = Unit(planeNormal);
    const glm::dvec3 toLight = glm::dvec3(light) - light.w * this->Middle;
    this->MiddleHeight = glm::dot(frame.normal, this->Middle - planePoint);
    this->LightHeight = glm::dot(frame.normal, toLight) + light.w * this->MiddleHeight;
    if (this->LightHeight < 0.0)
    {
      frame.normal = -frame.normal;
      this->MiddleHeight = -this->MiddleHeight;
      this->LightHeight = -this->LightHeight;
    }
    frame.origin = this->Middle - this->MiddleHeight * frame.normal;

    // A directional light's shadows grow long away from it, a near one's away from beneath it.
    const glm::dvec3 flat = toLight - glm::dot(frame.normal, toLight) * frame.normal;
    const double length = LargestOf(flat);
    glm::dvec3 axis(0.0);
    axis[LeastAxis(frame.normal)] = 1.0;
    frame.along =
      length > Negligible * LargestOf(toLight) ? -Unit(flat) : Unit(glm::cross(frame.normal, axis));
    frame.across = Unit(glm::cross(frame.normal, frame.along));

    this->IsLightInPlane = this->LightHeight <=
      Negligible * (LargestOf(toLight) + light.w * std::abs(this->MiddleHeight));
    this->Rate =
      glm::dvec3(glm::dot(frame.along, toLight), glm::dot(frame.across, toLight), light.w) /
      this->LightHeight;
  }

  Thrown Throw(const glm::dvec3& point) const
  {
    const glm::dvec3 p = point - this->Middle;
    const double height = glm::dot(this->Frame.normal, p) + this->MiddleHeight;
    return { glm::dot(this->Frame.along, p) - height * this->Rate.x,
      glm::dot(this->Frame.across, p) - height * this->Rate.y, 1.0 - height * this->Rate.z,
      height };
  }

  // How far from its true place a point on the plane may be, with room to spare.
  double RoundingOf(const Thrown& p) const
  {
    const double largest =
      this->Size + p.w * std::max(std::abs(this->Rate.x), std::abs(this->Rate.y));
    return 8.0 * std::numeric_limits<double>::epsilon() * largest / (p.z * p.z);
  }

  bool IsPosition() const { return this->LightW != 0.0; }

  Cut AbovePlane() const { return { 0.0, 0.0, 0.0, 1.0 }; }

  // 1 = w + height * rate.
  Cut BelowLight() const { return { 0.0, 0.0, 1.0 - LeastW, -LeastW * this->Rate.z }; }

  // The cuts to a box; one that keeps nothing if the box does not reach the plane.
  std::vector<Cut> WithinBox(const Box& box) const
  {
    std::vector<Cut> cuts;
    for (int axis = 0; axis < 3; ++axis)
    {
      const glm::dvec3 rate(
        this->Frame.along[axis], this->Frame.across[axis], this->Frame.origin[axis]);
      const double low = box.minimum[axis], high = box.maximum[axis];
      if (std::max(std::abs(rate.x), std::abs(rate.y)) > Negligible)
      {
        cuts.emplace_back(rate.x, rate.y, rate.z - low, 0.0);
        cuts.emplace_back(-rate.x, -rate.y, high - rate.z, 0.0);
        continue;
      }
      const double slack =
        Negligible * std::max({ std::abs(low), std::abs(high), std::abs(rate.z) });
      if (rate.z < low - slack || rate.z > high + slack)
      {
        return { Cut(0.0, 0.0, -1.0, 0.0) };
      }
    }
    return cuts;
  }

  glm::dvec3 FootOf(const glm::dvec3& p) const
  {
    const double height = glm::dot(this->Frame.normal, p - this->Middle) + this->MiddleHeight;
    return p - height * this->Frame.normal;
  }

  PlaneFrame Frame;
  bool IsLightInPlane = false;

private:
  static int LeastAxis(const glm::dvec3& v)
  {
    const glm::dvec3 a = glm::abs(v);
    return a.x <= a.y && a.x <= a.z ? 0 : a.y <= a.z ? 1 : 2;
  }

  glm::dvec3 Middle;
  double Size;
  double MiddleHeight = 0.0;
  double LightHeight = 0.0; // of a direction: its sine
  double LightW = 0.0;
  glm::dvec3 Rate{ 0.0 }; // the light, by its height
};

// Where the shadow of what reaches the light ends.
Box BoxOfUnbounded(const Box& meshBounds, const Thrower& thrower, const glm::dvec4& light)
{
  Box box = meshBounds;
  for (const glm::dvec3& p : { meshBounds.minimum, meshBounds.maximum, glm::dvec3(light) })
  {
    box.AddPoint(thrower.FootOf(p));
  }
  return box.Grown(ReachOfUnbounded * box.Diagonal());
}

// Triangles that cast, in the order of what the mesh was made of.
std::vector<std::uint32_t> CastingTriangles(
  const ShadowMesh<double>& mesh, const std::vector<CastSign>& signs)
{
  std::vector<std::uint32_t> places(mesh.triangles.size());
  if (mesh.originals.empty())
  {
    std::iota(places.begin(), places.end(), 0u);
  }
  else
  {
    const std::uint32_t last = *std::max_element(mesh.originals.begin(), mesh.originals.end());
    places.assign(std::size_t(last) + 1, NoPoint);
    for (std::size_t i = 0; i < mesh.originals.size(); ++i)
    {
      places[mesh.originals[i]] = static_cast<std::uint32_t>(i);
    }
  }
  places.erase(std::remove_if(places.begin(), places.end(),
                 [&](std::uint32_t i) { return i == NoPoint || signs[i] == 0; }),
    places.end());
  return places;
}

// A corner of a polygon that is being cut.
struct Corner
{
  Thrown thrown{ 0.0 };
  std::uint32_t point = NoPoint;
};

// What is left of the polygon. A side is cut from its kept end, whichever way it runs: neighbours
// get the same point.
void CutPolygon(std::vector<Corner>& polygon, const Cut& cut, std::vector<Corner>& scratch)
{
  scratch.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Corner &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double atFrom = glm::dot(cut, from.thrown), atTo = glm::dot(cut, to.thrown);
    if (atFrom >= 0.0)
    {
      scratch.push_back(from);
    }
    if ((atFrom > 0.0 && atTo < 0.0) || (atFrom < 0.0 && atTo > 0.0))
    {
      const bool isLeaving = atFrom > 0.0;
      const Thrown &kept = isLeaving ? from.thrown : to.thrown,
                   &lost = isLeaving ? to.thrown : from.thrown;
      const double atKept = isLeaving ? atFrom : atTo, atLost = isLeaving ? atTo : atFrom;
      scratch.push_back({ kept + atKept / (atKept - atLost) * (lost - kept), NoPoint });
    }
  }
  polygon.swap(scratch);
}

// The polygons of a block of triangles. Corners that are cut are numbered from `FirstCut` on.
struct Block
{
  std::vector<glm::dvec2> cutPoints;
  std::vector<std::uint32_t> corners, sizes, triangles;
  bool isCut = false;
};
constexpr std::uint32_t FirstCut = 0x80000000u;

class Cutter
{
public:
  Cutter(const Thrower& thrower, const std::vector<Thrown>& points)
    : Owner(thrower)
    , Points(points)
    , Always{ thrower.AbovePlane() }
  {
  }

  void CutTo(const Box& box)
  {
    if (this->Owner.IsPosition())
    {
      this->Always.push_back(this->Owner.BelowLight());
    }
    this->Bounds = this->Owner.WithinBox(box);
  }

  void AddTriangle(const glm::uvec3& t, std::uint32_t number, Block& block)
  {
    this->Polygon.clear();
    for (int i = 0; i < 3; ++i)
    {
      this->Polygon.push_back({ this->Points[t[i]], t[i] });
    }
    this->CutBy(this->Always);
    if (this->Polygon.size() >= 3 && this->CutBy(this->Bounds))
    {
      block.isCut = true;
    }
    this->Divide();
    if (this->Polygon.size() < 3 || this->Flat.size() < 3)
    {
      return;
    }
    this->Emit(number, block);
  }

private:
  // Whether anything was cut away.
  bool CutBy(const std::vector<Cut>& cuts)
  {
    bool isCut = false;
    for (const Cut& cut : cuts)
    {
      if (std::any_of(this->Polygon.begin(), this->Polygon.end(),
            [&cut](const Corner& c) { return glm::dot(cut, c.thrown) < 0.0; }))
      {
        isCut = true;
        CutPolygon(this->Polygon, cut, this->Scratch);
      }
    }
    return isCut;
  }

  void Divide()
  {
    this->Flat.clear();
    for (const Corner& corner : this->Polygon)
    {
      this->Flat.push_back(glm::dvec2(corner.thrown) / corner.thrown.z);
    }
  }

  void Emit(std::uint32_t number, Block& block)
  {
    double area = 0.0, length = 0.0, error = 0.0;
    const std::size_t size = this->Flat.size();
    for (std::size_t i = 0; i < size; ++i)
    {
      const glm::dvec2 p = this->Flat[i] - this->Flat[0],
                       q = this->Flat[(i + 1) % size] - this->Flat[0];
      area += p.x * q.y - p.y * q.x;
      length += glm::distance(p, q);
      error = std::max(error, this->Owner.RoundingOf(this->Polygon[i].thrown));
    }
    if (!(std::abs(area) > error * length))
    {
      return;
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      const std::size_t place = area > 0.0 ? i : size - 1 - i;
      if (this->Polygon[place].point != NoPoint)
      {
        block.corners.push_back(this->Polygon[place].point);
        continue;
      }
      block.corners.push_back(FirstCut + static_cast<std::uint32_t>(block.cutPoints.size()));
      block.cutPoints.push_back(this->Flat[place]);
    }
    block.sizes.push_back(static_cast<std::uint32_t>(size));
    block.triangles.push_back(number);
  }

  const Thrower& Owner;
  const std::vector<Thrown>& Points;
  std::vector<Cut> Always, Bounds;
  std::vector<Corner> Polygon, Scratch;
  std::vector<glm::dvec2> Flat;
};

// Joins the blocks, with the mesh's points that polygons use ahead of those where they were cut.
void Join(const std::vector<Block>& blocks, const std::vector<Thrown>& thrown, PlanarShadow& shadow)
{
  PolygonSet& set = shadow.polygons;
  std::vector<std::uint32_t> places(thrown.size(), NoPoint);
  for (const Block& block : blocks)
  {
    for (const std::uint32_t corner : block.corners)
    {
      if (corner < FirstCut)
      {
        places[corner] = 0;
      }
    }
  }
  for (std::size_t i = 0; i < thrown.size(); ++i)
  {
    if (places[i] != NoPoint)
    {
      places[i] = static_cast<std::uint32_t>(set.points.size());
      set.points.push_back(glm::dvec2(thrown[i]) / thrown[i].z);
      shadow.originals.push_back(static_cast<std::uint32_t>(i));
    }
  }
  for (const Block& block : blocks)
  {
    const auto firstCut = static_cast<std::uint32_t>(set.points.size());
    set.points.insert(set.points.end(), block.cutPoints.begin(), block.cutPoints.end());
    for (const std::uint32_t corner : block.corners)
    {
      set.corners.push_back(corner < FirstCut ? places[corner] : firstCut + (corner - FirstCut));
    }
    for (const std::uint32_t size : block.sizes)
    {
      set.starts.push_back(set.starts.back() + size);
    }
    shadow.triangles.insert(shadow.triangles.end(), block.triangles.begin(), block.triangles.end());
    shadow.isCut = shadow.isCut || block.isCut;
  }
  shadow.originals.resize(set.points.size(), NoPoint);
}

}

//------------------------------------------------------------------------------
PlanarShadow ThrowOnPlane(const ShadowMesh<double>& mesh, const std::vector<CastSign>& signs,
  const glm::dvec4& light, const glm::dvec3& planePoint, const glm::dvec3& planeNormal,
  const Box& bounds)
{
  PlanarShadow shadow;
  const Box meshBounds = BoundsOf(mesh.points);
  const Thrower thrower(meshBounds, light, planePoint, planeNormal);
  shadow.frame = thrower.Frame;
  shadow.isLightInPlane = thrower.IsLightInPlane;
  const std::vector<std::uint32_t> casting = CastingTriangles(mesh, signs);
  if (shadow.isLightInPlane || casting.empty())
  {
    return shadow;
  }

  std::vector<Thrown> thrown(mesh.points.size());
  ForEachBlock(thrown.size(),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        thrown[i] = thrower.Throw(mesh.points[i]);
      }
    });
  shadow.isUnbounded = std::any_of(casting.begin(), casting.end(),
    [&](std::uint32_t i)
    {
      const glm::uvec3& t = mesh.triangles[i];
      return std::min({ thrown[t.x].z, thrown[t.y].z, thrown[t.z].z }) < NearestToLight;
    });

  Cutter cutter(thrower, thrown);
  if (!bounds.isEmpty || shadow.isUnbounded)
  {
    shadow.bounds = bounds.isEmpty ? BoxOfUnbounded(meshBounds, thrower, light) : bounds;
    cutter.CutTo(shadow.bounds);
  }
  std::vector<Block> blocks(NumberOfBlocks(casting.size()));
  ForEachBlock(casting.size(),
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      Cutter own = cutter;
      for (std::size_t i = first; i < last; ++i)
      {
        own.AddTriangle(mesh.triangles[casting[i]], casting[i], blocks[block]);
      }
    });
  Join(blocks, thrown, shadow);
  return shadow;
}

}
