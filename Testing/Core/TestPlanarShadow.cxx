// Shadows on a plane: where they fall, what is cut away, and their area, against closed forms and
// convex hulls in long double, and against sampling.
#include "PlanarShadow.h"

#include "GridSegments.h"

#include "ShadowMeshes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

using namespace vtkshadows;

namespace
{

const double Pi = std::acos(-1.0);
const glm::dvec3 Up(0.0, 0.0, 1.0), Ground(0.0);

glm::dvec4 Toward(const glm::dvec3& direction)
{
  return { glm::normalize(direction), 0.0 };
}

struct Scene
{
  TestMesh mesh;
  glm::dvec4 light{ 0.0, 0.0, 1.0, 0.0 };
  glm::dvec3 point{ 0.0 }, normal{ 0.0, 0.0, 1.0 };
  Box bounds{};
  CastingFaces faces = CastingFaces::Closed;

  PlanarShadow Throw() const
  {
    const ShadowMesh<double> made =
      BuildShadowMesh<double>(this->mesh.points, this->mesh.triangles, true);
    std::vector<CastSign> signs;
    FaceTriangles(made, this->light, this->faces, signs);
    return ThrowOnPlane(made, signs, this->light, this->point, this->normal, this->bounds);
  }
  UnionOutline Outline() const { return UnitePolygons(this->Throw().polygons); }
  double Area() const { return this->Outline().area; }
};

// Turns z to an oblique direction, and moves.
struct Motion
{
  glm::dvec3 x, y, z, offset{ 0.0 };
  double scale = 1.0;

  explicit Motion(const glm::dvec3& up = Up)
    : z(glm::normalize(up))
  {
    this->x = glm::normalize(
      glm::cross(std::abs(this->z.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), this->z));
    this->y = glm::cross(this->z, this->x);
  }
  glm::dvec3 Turn(const glm::dvec3& p) const
  {
    return p.x * this->x + p.y * this->y + p.z * this->z;
  }
  glm::dvec3 Move(const glm::dvec3& p) const { return this->offset + this->scale * this->Turn(p); }
  Scene operator()(Scene scene) const
  {
    for (glm::dvec3& p : scene.mesh.points)
    {
      p = this->Move(p);
    }
    scene.light = scene.light.w == 0.0 ? glm::dvec4(this->Turn(glm::dvec3(scene.light)), 0.0)
                                       : glm::dvec4(this->Move(glm::dvec3(scene.light)), 1.0);
    scene.point = this->Move(scene.point);
    scene.normal = this->Turn(scene.normal);
    return scene;
  }
};

TestMesh Moved(TestMesh mesh, const glm::dvec3& offset, double scale = 1.0)
{
  for (glm::dvec3& p : mesh.points)
  {
    p = scale * p + offset;
  }
  return mesh;
}

TestMesh Disc(int sides, double radius, double height)
{
  TestMesh mesh{ "disc", { { 0.0, 0.0, height } }, {} };
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * Pi * i / sides;
    mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    mesh.triangles.emplace_back(0, 1 + i, 1 + (i + 1) % sides);
  }
  return mesh;
}

TestMesh Sphere(int rings, int sides, double radius, const glm::dvec3& centre)
{
  TestMesh mesh{ "sphere", {}, {} };
  for (int r = 1; r < rings; ++r)
  {
    for (int s = 0; s < sides; ++s)
    {
      const double u = Pi * r / rings, v = 2.0 * Pi * s / sides;
      mesh.points.push_back(centre +
        radius * glm::dvec3(std::sin(u) * std::cos(v), std::sin(u) * std::sin(v), std::cos(u)));
    }
  }
  const auto top = static_cast<unsigned int>(mesh.points.size()), bottom = top + 1;
  mesh.points.push_back(centre + radius * Up);
  mesh.points.push_back(centre - radius * Up);
  const auto at = [&](int r, int s)
  { return static_cast<unsigned int>((r - 1) * sides + s % sides); };
  for (int s = 0; s < sides; ++s)
  {
    mesh.triangles.emplace_back(top, at(1, s), at(1, s + 1));
    mesh.triangles.emplace_back(bottom, at(rings - 1, s + 1), at(rings - 1, s));
    for (int r = 1; r + 1 < rings; ++r)
    {
      mesh.triangles.emplace_back(at(r, s), at(r + 1, s), at(r + 1, s + 1));
      mesh.triangles.emplace_back(at(r, s), at(r + 1, s + 1), at(r, s + 1));
    }
  }
  return mesh;
}

struct LongPoint
{
  long double x, y;
};

long double Cross(const LongPoint& a, const LongPoint& b, const LongPoint& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The convex hull's area of the points thrown on z = 0 (A. Andrew's monotone chain, 1979): of a
// convex mesh wholly between plane and light, its shadow.
double HullArea(const TestMesh& mesh, const glm::dvec4& light)
{
  std::vector<LongPoint> points;
  for (const glm::dvec3& p : mesh.points)
  {
    const long double w =
      static_cast<long double>(light.z) - static_cast<long double>(light.w) * p.z;
    points.push_back(
      { (static_cast<long double>(light.z) * p.x - static_cast<long double>(p.z) * light.x) / w,
        (static_cast<long double>(light.z) * p.y - static_cast<long double>(p.z) * light.y) / w });
  }
  std::sort(points.begin(), points.end(),
    [](const LongPoint& a, const LongPoint& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<LongPoint> hull;
  for (int pass = 0; pass < 2; ++pass)
  {
    const std::size_t base = hull.size();
    for (const LongPoint& p : points)
    {
      while (hull.size() >= base + 2 && Cross(hull[hull.size() - 2], hull.back(), p) <= 0)
      {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  long double area = 0;
  for (std::size_t i = 1; i + 1 < hull.size(); ++i)
  {
    area += Cross(hull[0], hull[i], hull[i + 1]) / 2;
  }
  return static_cast<double>(area);
}

void ExpectArea(double got, double expected, double tolerance, const std::string& of)
{
  std::cout << of << ": got " << got << ", expected " << expected << ", relative error "
            << std::abs(got / expected - 1.0) << ", tolerance " << tolerance << "\n";
  EXPECT_NEAR(got, expected, tolerance * expected) << of;
}

bool HoldsPoint(const PolygonSet& set, std::size_t polygon, const glm::dvec2& p)
{
  const std::uint32_t first = set.starts[polygon], last = set.starts[polygon + 1];
  for (std::uint32_t i = first; i < last; ++i)
  {
    const glm::dvec2 a = set.points[set.corners[i]],
                     b = set.points[set.corners[i + 1 < last ? i + 1 : first]];
    if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0.0)
    {
      return false;
    }
  }
  return true;
}

// The area of counter-clockwise convex polygons from lines across, at least `most`: along each, the
// union of the intervals is exact; between the heights of two points it bends where sides cross.
double AreaByLines(const PolygonSet& set, int most)
{
  std::vector<double> heights;
  for (const glm::dvec2& p : set.points)
  {
    heights.push_back(p.y);
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  std::vector<double> lines, weights;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i)
  {
    const double step = heights[i + 1] - heights[i];
    const double share = step / (heights.back() - heights.front());
    const int count = static_cast<int>(std::ceil(share * most));
    for (int line = 0; line < count; ++line)
    {
      lines.push_back(heights[i] + (line + 0.5) / count * step);
      weights.push_back(step / count);
    }
  }
  double area = 0.0;
  std::vector<std::pair<double, double>> spans;
  for (std::size_t line = 0; line < lines.size(); ++line)
  {
    const double y = lines[line];
    spans.clear();
    for (std::size_t polygon = 0; polygon < set.NumberOfPolygons(); ++polygon)
    {
      double from = 1e300, to = -1e300;
      const std::uint32_t first = set.starts[polygon], last = set.starts[polygon + 1];
      for (std::uint32_t i = first; i < last; ++i)
      {
        const glm::dvec2 a = set.points[set.corners[i]],
                         b = set.points[set.corners[i + 1 < last ? i + 1 : first]];
        if ((a.y <= y) != (b.y <= y))
        {
          const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
          from = std::min(from, x);
          to = std::max(to, x);
        }
      }
      if (from < to)
      {
        spans.emplace_back(from, to);
      }
    }
    std::sort(spans.begin(), spans.end());
    double end = -1e300;
    for (const auto& span : spans)
    {
      area += std::max(0.0, span.second - std::max(span.first, end)) * weights[line];
      end = std::max(end, span.second);
    }
  }
  return area;
}

const std::vector<glm::dvec4> Lights()
{
  return { { 0.0, 0.0, 1.0, 0.0 }, Toward({ 0.3, -0.5, 0.8 }), Toward({ -2.0, 0.7, 1.0 }),
    { 0.0, 0.0, 9.0, 1.0 }, { 5.0, -4.0, 7.0, 1.0 } };
}

}

TEST(PlanarShadow, OfConvexMeshesIsTheHullOfTheirPoints)
{
  for (const TestMesh& mesh :
    { Disc(7, 1.5, 2.0), Disc(1000, 1.5, 2.0), Moved(Cube(), { 0.5, 0.2, 3.0 }),
      Moved(Tetrahedron(), { 0.0, 0.0, 1.0 }), Sphere(24, 48, 1.3, { 0.3, -0.4, 2.5 }) })
  {
    for (const glm::dvec4& light : Lights())
    {
      for (const CastingFaces faces : { CastingFaces::All, CastingFaces::Closed })
      {
        Scene scene{ mesh, light };
        scene.faces = faces;
        const UnionOutline outline = scene.Outline();
        ExpectArea(outline.area, HullArea(mesh, light), 1e-12, mesh.name);
        EXPECT_EQ(outline.loops.NumberOfPolygons(), 1u) << mesh.name;
      }
    }
  }
}

TEST(PlanarShadow, HasTheAreaOfTheFormula)
{
  // A disc that lies parallel to the plane: itself, or scaled by the light's height over the
  // height that is left.
  const int sides = 360;
  const double polygon = 0.5 * sides * 1.5 * 1.5 * std::sin(2.0 * Pi / sides);
  const double scale = 7.0 / (7.0 - 2.0);
  ExpectArea(Scene{ Disc(sides, 1.5, 2.0), Toward({ 1, 2, 3 }) }.Area(), polygon, 1e-12, "disc");
  ExpectArea(Scene{ Disc(sides, 1.5, 2.0), { 5, -4, 7, 1 } }.Area(), polygon * scale * scale, 1e-12,
    "disc, near light");
  // A cube's faces, each as it faces the light, over the sine of the light's height.
  const glm::dvec3 d = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
  ExpectArea(Scene{ Moved(Cube(), { 0, 0, 3 }), Toward(d) }.Area(),
    4.0 * (std::abs(d.x) + std::abs(d.y) + std::abs(d.z)) / d.z, 1e-12, "cube");
  // Straight beneath a light, a cube throws its upper face.
  ExpectArea(Scene{ Moved(Cube(), { 0, 0, 2 }), { 0, 0, 9, 1 } }.Area(), 4.0 * 1.5 * 1.5, 1e-12,
    "cube, near light");
}

TEST(PlanarShadow, ConvergesToRoundShadows)
{
  const double radius = 1.3, height = 2.5;
  const glm::dvec3 centre(0.0, 0.0, height), d = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
  // A directional light's is the ellipse of a cylinder. A near light's is the ellipse of a cone
  // whose axis leaves the vertical by a: of half-angle b, at the height h its half-axes are
  // h sin b cos b / (cos^2 a - sin^2 b) and h sin b / sqrt(cos^2 a - sin^2 b).
  const glm::dvec3 light(3.0, 1.0, 8.0), away = centre - light;
  const double sinB2 = radius * radius / glm::dot(away, away);
  const double k = away.z * away.z / glm::dot(away, away) - sinB2;
  const double cone = Pi * light.z * light.z * sinB2 * std::sqrt(1.0 - sinB2) / (k * std::sqrt(k));
  const struct
  {
    const char* name;
    glm::dvec4 light;
    double area;
  } cases[] = { { "sphere, directional", Toward(d), Pi * radius * radius / d.z },
    { "sphere, near light", glm::dvec4(light, 1.0), cone } };
  for (const auto& c : cases)
  {
    double last = 0.0;
    for (const int rings : { 32, 64, 128, 256 })
    {
      const double error =
        1.0 - Scene{ Sphere(rings, 2 * rings, radius, centre), c.light }.Area() / c.area;
      const double order = std::log2(last / error);
      std::cout << c.name << ", " << rings << " rings: short by " << error;
      if (last > 0.0)
      {
        std::cout << ", order " << order << ", expected 2, tolerance 0.1";
        EXPECT_NEAR(order, 2.0, 0.1) << c.name;
      }
      std::cout << "\n";
      EXPECT_GT(error, 0.0); // its points lie on the sphere
      last = error;
    }
  }
}

TEST(PlanarShadow, KeepsItsAreaWherever)
{
  for (const Scene& scene : { Scene{ Moved(Cube(), { 0, 0, 3 }), { 5, -4, 7, 1 } },
         Scene{ Moved(Torus(40, 20), { 0, 0, 3 }), Toward({ 1, 2, 3 }) } })
  {
    const double expected = scene.Area();
    for (const glm::dvec3& up :
      { Up, glm::dvec3(1, -2, 0.5), glm::dvec3(0, 0, -1), glm::dvec3(1, 1e-9, 0) })
    {
      for (const double scale : { 1e-9, 1.0, 1e9, 1e-100, 1e100 })
      {
        for (const double offset : { 0.0, 1e3, 1e6 })
        {
          Motion motion(up);
          motion.scale = scale;
          motion.offset = scale * offset * glm::dvec3(0.6, -0.3, 0.74);
          // The input's own precision is 1e-16 of the offset.
          ExpectArea(motion(scene).Area() / scale / scale, expected,
            std::max(1e-12, 3e-16 * offset), scene.mesh.name);
        }
      }
    }
  }
}

TEST(PlanarShadow, GrowsLongUnderALowLight)
{
  for (const double degrees : { 80.0, 89.0, 89.9, 89.999 })
  {
    const double angle = degrees * Pi / 180.0;
    const glm::dvec4 light =
      Toward({ std::sin(angle) * 0.6, std::sin(angle) * 0.8, std::cos(angle) });
    for (const TestMesh& mesh : { Moved(Cube(), { 0, 0, 3 }), Sphere(24, 48, 1.0, { 0, 0, 2 }) })
    {
      ExpectArea(Scene{ mesh, light }.Area(), HullArea(mesh, light), 1e-11,
        mesh.name + " at " + std::to_string(degrees));
    }
  }
}

TEST(PlanarShadow, CountsEachPointOnce)
{
  const glm::dvec4 light = Toward({ 1, 2, 3 });
  const double cube = Scene{ Moved(Cube(), { 0, 0, 3 }), light }.Area();
  const auto lifted = [](TestMesh mesh) { return Moved(std::move(mesh), { 0, 0, 3 }); };
  ExpectArea(Scene{ lifted(UnweldedCube()), light }.Area(), cube, 1e-12, "unwelded");
  ExpectArea(Scene{ lifted(InsideOutCube()), light }.Area(), cube, 1e-12, "inside out");

  TestMesh twice = lifted(Cube());
  Append(twice, lifted(Cube()));
  ExpectArea(Scene{ twice, light }.Area(), cube, 1e-12, "twice");

  // Another one on the same ray.
  TestMesh behind = lifted(Cube());
  Append(behind, Cube(), glm::dvec3(0, 0, 9) + 6.0 / 3.0 * glm::dvec3(1, 2, 0));
  ExpectArea(Scene{ behind, light }.Area(), cube, 1e-12, "one behind the other");

  TestMesh apart = lifted(Cube());
  Append(apart, lifted(InsideOutCube()), { 20, 0, 0 });
  const UnionOutline outline = Scene{ apart, light }.Outline();
  ExpectArea(outline.area, 2.0 * cube, 1e-12, "apart");
  EXPECT_EQ(outline.loops.NumberOfPolygons(), 2u);

  // Squares of side 2, the second one moved by half a side, or touching in an edge or a corner.
  const auto squares = [](double x, double y)
  {
    TestMesh mesh = Disc(4, std::sqrt(2.0), 1.0);
    Append(mesh, TestMesh(mesh), { x * std::sqrt(0.5), y * std::sqrt(0.5), 0 });
    return Scene{ mesh }.Outline();
  };
  ExpectArea(squares(1, 1).area, 6.0, 1e-12, "overlapping");
  ExpectArea(squares(2, 2).area, 8.0, 1e-12, "edge to edge");
  EXPECT_EQ(squares(2, 2).loops.NumberOfPolygons(), 1u);
  ExpectArea(squares(4, 0).area, 8.0, 1e-12, "corner to corner");
}

TEST(PlanarShadow, OfARingHasAHole)
{
  const int rings = 96, sides = 48;
  const Scene scene{ Moved(Torus(rings, sides), { 0, 0, 3 }) };
  const UnionOutline outline = scene.Outline();
  const double polygon = 0.5 * rings * std::sin(2.0 * Pi / rings);
  ASSERT_EQ(outline.areas.size(), 2u);
  ExpectArea(outline.area, polygon * (1.4 * 1.4 - 0.6 * 0.6), 1e-12, "torus");
  ExpectArea(std::max(outline.areas[0], outline.areas[1]), polygon * 1.4 * 1.4, 1e-12, "outer");
  ExpectArea(-std::min(outline.areas[0], outline.areas[1]), polygon * 0.36, 1e-12, "hole");
}

TEST(PlanarShadow, WhatIsBeneathThePlaneCastsNothing)
{
  for (const glm::dvec4& light : Lights())
  {
    // The upper half of a cube and the half cube itself.
    TestMesh half = Cube();
    for (glm::dvec3& p : half.points)
    {
      p.z = std::max(p.z, 0.0);
    }
    ExpectArea(Scene{ Cube(), light }.Area(), HullArea(half, light), 1e-12, "sunk cube");
    EXPECT_EQ(
      Scene({ Moved(Cube(), { 0, 0, -3 }), light }).Throw().polygons.NumberOfPolygons(), 0u);
  }
  const PlanarShadow shadow = Scene{ Cube(), Toward({ 1, 2, 3 }) }.Throw();
  EXPECT_FALSE(shadow.isCut); // the plane is no bound
  EXPECT_TRUE(std::any_of(shadow.originals.begin(), shadow.originals.end(),
    [](std::uint32_t point) { return point == NoPoint; }));
}

TEST(PlanarShadow, FallsOnTheOtherSideToo)
{
  Scene scene{ Moved(Cube(), { 0, 0, -3 }), { 5, -4, -7, 1 } };
  const double expected = HullArea(Moved(Cube(), { 0, 0, -3 }), { 5, -4, -7, 1 });
  ExpectArea(scene.Area(), expected, 1e-12, "light beneath");
  EXPECT_EQ(scene.Throw().frame.normal.z, -1.0);
  scene.normal = { 0, 0, -123.0 };
  ExpectArea(scene.Area(), expected, 1e-12, "normal turned");
}

TEST(PlanarShadow, WhatIsBeyondTheLightCastsNothing)
{
  const Scene above{ Moved(Cube(), { 0, 0, 12 }), { 5, -4, 7, 1 } };
  EXPECT_EQ(above.Throw().polygons.NumberOfPolygons(), 0u);
  EXPECT_FALSE(above.Throw().isCut);

  // A wall from the plane to far above the light: its shadow is all behind it, a trapezium in the
  // bounds. Light at (0, 0, 2), wall x = 1 for y in -1 .. 1; behind it |y| < x.
  Scene wall{ { "wall", { { 1, -1, 0 }, { 1, 1, 0 }, { 1, 1, 9 }, { 1, -1, 9 } },
                { { 0, 1, 2 }, { 0, 2, 3 } } },
    { 0, 0, 2, 1 } };
  wall.bounds.AddPoint({ -5, -100, 0 });
  wall.bounds.AddPoint({ 5, 100, 0 });
  ExpectArea(wall.Area(), 5.0 * 5.0 - 1.0, 1e-12, "wall in bounds");
  EXPECT_TRUE(wall.Throw().isCut);
  EXPECT_TRUE(wall.Throw().isUnbounded);

  wall.bounds = Box();
  const PlanarShadow shadow = wall.Throw();
  const double end = shadow.bounds.maximum.x;
  EXPECT_TRUE(shadow.isCut);
  EXPECT_GT(end, 1000.0);
  ExpectArea(wall.Area(), end * end - 1.0, 1e-12, "wall without bounds");
  for (const glm::dvec2& p : shadow.polygons.points)
  {
    EXPECT_TRUE(shadow.bounds.Grown(1e-6).Holds(shadow.frame.ToWorld(p)));
  }
}

TEST(PlanarShadow, IsCutToBounds)
{
  Scene scene{ Moved(Cube(), { 0, 0, 3 }) };
  scene.bounds.AddPoint({ 0, -9, 0 });
  scene.bounds.AddPoint({ 9, 0.5, 0 });
  ExpectArea(scene.Area(), 1.5, 1e-12, "a part");
  EXPECT_TRUE(scene.Throw().isCut);
  scene.bounds.AddPoint({ -9, 9, 0 });
  EXPECT_FALSE(scene.Throw().isCut);
  ExpectArea(scene.Area(), 4.0, 1e-12, "whole");
  // Beside the plane.
  scene.bounds = Box();
  scene.bounds.AddPoint({ -9, -9, 1 });
  scene.bounds.AddPoint({ 9, 9, 2 });
  EXPECT_EQ(scene.Throw().polygons.NumberOfPolygons(), 0u);
}

TEST(PlanarShadow, LightsInThePlaneThrowNone)
{
  for (const glm::dvec4& light :
    { glm::dvec4(1, 0, 0, 0), glm::dvec4(5, 1, 0, 1), Toward({ 1, 1, 1e-14 }) })
  {
    const PlanarShadow shadow = Scene{ Moved(Cube(), { 0, 0, 3 }), light }.Throw();
    EXPECT_TRUE(shadow.isLightInPlane);
    EXPECT_EQ(shadow.polygons.NumberOfPolygons(), 0u);
  }
}

TEST(PlanarShadow, OfAnyMeshIsAsSampled)
{
  std::vector<TestMesh> meshes = SmallMeshes();
  meshes.push_back(Soup(800, 60));
  for (const TestMesh& mesh : meshes)
  {
    for (const glm::dvec4& light : Lights())
    {
      // Through the plane in part.
      const Scene scene{ Moved(mesh, { 0, 0, 0.3 }), light };
      const PlanarShadow shadow = scene.Throw();
      const UnionOutline outline = UnitePolygons(shadow.polygons);
      const double expected = AreaByLines(shadow.polygons, 4000);
      EXPECT_NEAR(outline.area, expected, 2e-5 * expected + 1e-12) << mesh.name;
      Scene all = scene;
      all.faces = CastingFaces::All;
      EXPECT_NEAR(all.Area(), outline.area, 1e-12 * outline.area) << mesh.name;
      for (const glm::dvec2& p : outline.loops.points)
      {
        EXPECT_TRUE(std::isfinite(p.x + p.y));
      }
    }
  }
}

TEST(PlanarShadow, OfLightsAtAVertexIsFinite)
{
  for (const TestMesh& mesh : SmallMeshes())
  {
    for (const glm::dvec3& p : mesh.points)
    {
      Scene scene{ Moved(mesh, { 0, 0, 1.5 }), glm::dvec4(p + glm::dvec3(0, 0, 1.5), 1.0) };
      const PlanarShadow shadow = scene.Throw();
      for (const glm::dvec2& q : shadow.polygons.points)
      {
        ASSERT_TRUE(std::isfinite(q.x + q.y)) << mesh.name;
      }
      EXPECT_TRUE(std::isfinite(UnitePolygons(shadow.polygons).area)) << mesh.name;
    }
  }
}

TEST(PlanarShadow, IsTheSameOnAnyNumberOfCores)
{
  const TestMesh many = Sphere(150, 300, 1.0, { 0, 0, 2 });
  // So many layers that they are united by halves, too.
  for (const Scene& s : { Scene{ many, { 5, -4, 7, 1 } },
         Scene{ Moved(Soup(2000, 100), { 0, 0, 2 }), { 5, -4, 7, 1 } } })
  {
    const UnionOutline some = s.Outline();
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const UnionOutline other = s.Outline();
    EXPECT_TRUE(some.loops.points == other.loops.points);
    EXPECT_TRUE(some.loops.corners == other.loops.corners);
    EXPECT_EQ(some.area, other.area);
  }
}

TEST(PolygonUnion, OfRandomTrianglesIsAsSampled)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (const int count : { 1, 2, 5, 20, 100, 1000 })
  {
    for (const double size : { 1.0, 0.1, 0.01 })
    {
      PolygonSet set;
      for (int i = 0; i < count; ++i)
      {
        const glm::dvec2 at(coordinate(random), coordinate(random));
        for (int corner = 0; corner < 3; ++corner)
        {
          set.corners.push_back(static_cast<std::uint32_t>(set.points.size()));
          set.points.push_back(at + size * glm::dvec2(coordinate(random), coordinate(random)));
        }
        set.starts.push_back(static_cast<std::uint32_t>(set.points.size()));
      }
      const UnionOutline outline = UnitePolygons(set);
      const double expected = AreaByLines(set, 4000);
      EXPECT_NEAR(outline.area, expected, 1e-4 * expected);

      // Turned round, it is the same.
      PolygonSet turned = set;
      std::reverse(turned.corners.begin(), turned.corners.end());
      const double again = UnitePolygons(turned).area;
      EXPECT_NEAR(again, outline.area, 1e-13 * outline.area);

      // Inside of the outline is what is inside of a polygon.
      for (int sample = 0; sample < 200; ++sample)
      {
        const glm::dvec2 p(coordinate(random), coordinate(random));
        bool isCovered = false;
        for (std::size_t i = 0; i < set.NumberOfPolygons() && !isCovered; ++i)
        {
          isCovered = HoldsPoint(set, i, p) || HoldsPoint(turned, i, p);
        }
        int winding = 0;
        for (std::size_t loop = 0; loop < outline.loops.NumberOfPolygons(); ++loop)
        {
          const std::uint32_t first = outline.loops.starts[loop],
                              last = outline.loops.starts[loop + 1];
          for (std::uint32_t i = first; i < last; ++i)
          {
            const glm::dvec2 a = outline.loops.points[outline.loops.corners[i]],
                             b = outline.loops
                                   .points[outline.loops.corners[i + 1 < last ? i + 1 : first]];
            const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
            winding += a.y <= p.y && b.y > p.y && side > 0.0 ? 1 : 0;
            winding -= a.y > p.y && b.y <= p.y && side < 0.0 ? 1 : 0;
          }
        }
        EXPECT_EQ(winding, isCovered ? 1 : 0);
      }
    }
  }
}

TEST(GridSegments, SidesAreExact)
{
  // Determinants of 1 among products of 2^98.
  const double n = GridEnd;
  EXPECT_EQ(Side({ 0, 0 }, { n, n - 1 }, { n - 1, n - 2 }), -1);
  EXPECT_EQ(Side({ 0, 0 }, { n - 1, n - 2 }, { n, n - 1 }), 1);
  EXPECT_EQ(Side({ -n, -n + 1 }, { 0, 0 }, { n, n - 1 }), 0);
  EXPECT_EQ(Side({ -n, -n }, { n - 1, n - 1 }, { n, n }), 0);
  EXPECT_EQ(Determinant(n, n - 1, n - 1, n - 2), -1.0);
}

TEST(GridSegments, ArePlanarOnceTheyAreMade)
{
  std::mt19937 random(5);
  for (const double size : { 3.0, 20.0, 1e6, GridEnd })
  {
    std::uniform_real_distribution<double> coordinate(-size, size);
    const auto point = [&]
    {
      const double x = std::round(coordinate(random));
      return GridPoint(x, std::round(coordinate(random)));
    };
    Segments segments;
    for (int i = 0; i < 40; ++i)
    {
      // Triangles, so that as much ends at each point as starts there.
      const GridPoint corners[3] = { point(), point(), point() };
      for (int side = 0; side < 3; ++side)
      {
        segments.push_back(SegmentOf(corners[side], corners[(side + 1) % 3]));
      }
    }
    MergeSegments(segments);
    EXPECT_FALSE(MakePlanar(segments, 10));
    ASSERT_TRUE(MakePlanar(segments, 1000000));
    std::size_t crossing = 0;
    for (const Segment& s : segments)
    {
      EXPECT_TRUE(IsBefore(s.a, s.b) && s.count != 0);
      for (const Segment& t : segments)
      {
        const int ta = Side(s.a, s.b, t.a), tb = Side(s.a, s.b, t.b);
        const int sa = Side(t.a, t.b, s.a), sb = Side(t.a, t.b, s.b);
        crossing += ta * tb < 0 && sa * sb < 0 ? 1 : 0;
      }
    }
    std::cout << segments.size() << " segments, crossing: got " << crossing << ", expected 0\n";
    EXPECT_EQ(crossing, 0u);
  }
}

TEST(PolygonUnion, OfNothingIsNothing)
{
  EXPECT_EQ(UnitePolygons({}).area, 0.0);
  PolygonSet set;
  set.points = { { 1, 1 }, { 2, 2 }, { 3, 3 }, { 1, 1 } };
  set.corners = { 0, 1, 2, 0, 3, 1, 0 };
  set.starts = { 0, 3, 3, 6, 7 };
  const UnionOutline outline = UnitePolygons(set);
  EXPECT_EQ(outline.area, 0.0);
  EXPECT_EQ(outline.loops.NumberOfPolygons(), 0u);
}
