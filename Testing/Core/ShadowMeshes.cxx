#include "ShadowMeshes.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

const double Pi = std::acos(-1.0);

glm::uvec3 Turned(const glm::uvec3& t)
{
  return { t.x, t.z, t.y };
}

// A grid of `rings` x `sides` quads, closed in both directions. After the last ring the first one
// comes, with side s of the last at `next(s)` of the first.
template <typename Next>
void CloseGrid(TestMesh& mesh, int rings, int sides, const Next& next)
{
  const auto index = [&](int ring, int side)
  {
    side = (side + sides) % sides;
    return static_cast<unsigned int>(
      ring < rings ? ring * sides + side : (next(side) + sides) % sides);
  };
  for (int r = 0; r < rings; ++r)
  {
    for (int s = 0; s < sides; ++s)
    {
      const unsigned int a = index(r, s), b = index(r + 1, s);
      const unsigned int c = index(r + 1, s + 1), d = index(r, s + 1);
      mesh.triangles.emplace_back(a, b, c);
      mesh.triangles.emplace_back(a, c, d);
    }
  }
}

}

void Append(TestMesh& mesh, const TestMesh& part, const glm::dvec3& offset)
{
  const auto base = static_cast<unsigned int>(mesh.points.size());
  for (const glm::dvec3& p : part.points)
  {
    mesh.points.push_back(p + offset);
  }
  for (const glm::uvec3& t : part.triangles)
  {
    mesh.triangles.push_back(t + base);
  }
}

TestMesh Tetrahedron()
{
  return { "tetrahedron", { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } } };
}

TestMesh Cube()
{
  TestMesh mesh{ "cube", {}, {} };
  for (int i = 0; i < 8; ++i)
  {
    mesh.points.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  }
  const glm::uvec4 quads[] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  for (const glm::uvec4& q : quads)
  {
    mesh.triangles.emplace_back(q.x, q.y, q.z);
    mesh.triangles.emplace_back(q.x, q.z, q.w);
  }
  return mesh;
}

TestMesh UnweldedCube()
{
  const TestMesh cube = Cube();
  TestMesh mesh{ "unwelded cube", {}, {} };
  for (const glm::uvec3& t : cube.triangles)
  {
    const auto base = static_cast<unsigned int>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), { cube.points[t.x], cube.points[t.y], cube.points[t.z] });
    mesh.triangles.emplace_back(base, base + 1, base + 2);
  }
  return mesh;
}

TestMesh InsideOutCube()
{
  TestMesh mesh = Cube();
  mesh.name = "inside-out cube";
  std::transform(mesh.triangles.begin(), mesh.triangles.end(), mesh.triangles.begin(), Turned);
  return mesh;
}

TestMesh OpenStrip()
{
  TestMesh mesh{ "open strip", {}, {} };
  for (unsigned int i = 0; i < 10; ++i)
  {
    mesh.points.emplace_back(0.3 * (i / 2), i % 2, 0.0);
  }
  for (unsigned int i = 0; i < 8; ++i)
  {
    const glm::uvec3 t(i, i + 1, i + 2);
    mesh.triangles.push_back(i % 2 ? t : Turned(t));
  }
  return mesh;
}

TestMesh Fan(int blades)
{
  TestMesh mesh{ "fan of " + std::to_string(blades), { { 0, 0, -1 }, { 0, 0, 1 } }, {} };
  for (int i = 0; i < blades; ++i)
  {
    const double angle = 2.0 * Pi * i / blades + 0.1;
    mesh.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    const glm::uvec3 t(0, 1, i + 2);
    mesh.triangles.push_back(i % 2 ? Turned(t) : t);
  }
  return mesh;
}

TestMesh Duplicated()
{
  TestMesh mesh = Tetrahedron();
  mesh.name = "duplicated tetrahedron";
  Append(mesh, Tetrahedron());
  return mesh;
}

TestMesh OneTurned()
{
  TestMesh mesh = Tetrahedron();
  mesh.name = "tetrahedron, one triangle turned";
  mesh.triangles[2] = Turned(mesh.triangles[2]);
  return mesh;
}

TestMesh MoebiusStrip()
{
  const unsigned int count = 30;
  TestMesh mesh{ "Moebius strip", {}, {} };
  for (unsigned int i = 0; i < count; ++i)
  {
    const double u = 2.0 * Pi * i / count;
    for (const double v : { -0.4, 0.4 })
    {
      const double r = 1.0 + v * std::cos(u / 2.0);
      mesh.points.emplace_back(r * std::cos(u), r * std::sin(u), v * std::sin(u / 2.0));
    }
  }
  for (unsigned int i = 0; i < count; ++i)
  {
    // After one turn the strip's left side is its right one.
    const bool isLast = i + 1 == count;
    const unsigned int a = 2 * i, b = a + 1;
    const unsigned int c = isLast ? 1 : a + 2, d = isLast ? 0 : a + 3;
    mesh.triangles.emplace_back(a, c, b);
    mesh.triangles.emplace_back(b, c, d);
  }
  return mesh;
}

TestMesh KleinBottle()
{
  const int rings = 16, sides = 16;
  TestMesh mesh{ "Klein bottle", {}, {} };
  for (int r = 0; r < rings; ++r)
  {
    for (int s = 0; s < sides; ++s)
    {
      // The figure-of-eight immersion.
      const double u = 2.0 * Pi * r / rings, v = 2.0 * Pi * s / sides;
      const double eight = std::cos(u / 2.0) * std::sin(v) - std::sin(u / 2.0) * std::sin(2.0 * v);
      mesh.points.emplace_back((1.5 + eight) * std::cos(u), (1.5 + eight) * std::sin(u),
        std::sin(u / 2.0) * std::sin(v) + std::cos(u / 2.0) * std::sin(2.0 * v));
    }
  }
  CloseGrid(mesh, rings, sides, [](int s) { return -s; });
  return mesh;
}

TestMesh TwoBodiesAndASheet()
{
  TestMesh listed = Cube();
  Append(listed, Tetrahedron(), { 3.0, 0.5, 0.0 });
  Append(listed, OpenStrip(), { 6.0, 1.0, 0.0 });
  const auto tetrahedron = listed.triangles.begin() + 12;
  std::transform(tetrahedron, tetrahedron + 4, tetrahedron, Turned);

  TestMesh mesh{ "two bodies and a sheet, mixed", listed.points, {} };
  for (std::size_t i = 0; i < 12; ++i)
  {
    const auto add = [&](std::size_t first, std::size_t count)
    {
      if (i < count)
      {
        mesh.triangles.push_back(listed.triangles[first + i]);
      }
    };
    add(16, 8); // sheet
    add(0, 12); // cube
    add(12, 4); // tetrahedron
  }
  return mesh;
}

TestMesh Torus(int rings, int sides)
{
  TestMesh mesh{ "torus", {}, {} };
  for (int r = 0; r < rings; ++r)
  {
    for (int s = 0; s < sides; ++s)
    {
      const double u = 2.0 * Pi * r / rings, v = 2.0 * Pi * s / sides;
      const double x = 1.0 + 0.4 * std::cos(v);
      mesh.points.emplace_back(x * std::cos(u), x * std::sin(u), 0.4 * std::sin(v));
    }
  }
  CloseGrid(mesh, rings, sides, [](int s) { return s; });
  return mesh;
}

TestMesh Soup(int triangles, int points)
{
  TestMesh mesh{ "soup of " + std::to_string(triangles), {}, {} };
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (int i = 0; i < points; ++i)
  {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    mesh.points.emplace_back(x, y, z);
  }
  std::uniform_int_distribution<unsigned int> index(0, points - 1);
  for (int i = 0; i < triangles; ++i)
  {
    const unsigned int a = index(random), b = index(random), c = index(random);
    mesh.triangles.emplace_back(a, b, c);
  }
  return mesh;
}

TestMesh Confetti(int columns)
{
  TestMesh mesh;
  mesh.name = "confetti";
  for (int i = 0; i < columns * columns; ++i)
  {
    const glm::dvec3 low(i % columns, i / columns, 0.0);
    const auto a = static_cast<unsigned int>(mesh.points.size());
    mesh.points.insert(
      mesh.points.end(), { low, low + glm::dvec3(0.7, 0.1, 0.0), low + glm::dvec3(0.6, 0.8, 0.0) });
    const glm::uvec3 t(a, a + 1, a + 2);
    mesh.triangles.push_back(i % 3 ? t : Turned(t));
    if (i % 2)
    {
      mesh.points.push_back(low + glm::dvec3(-0.1, 0.6, 0.0));
      const glm::uvec3 other(a + 2, a + 3, a);
      mesh.triangles.push_back(i % 5 ? other : Turned(other));
    }
  }
  return mesh;
}

std::vector<TestMesh> SmallMeshes()
{
  return { Tetrahedron(), Cube(), UnweldedCube(), InsideOutCube(), OpenStrip(), Confetti(4), Fan(3),
    Fan(4), Fan(5), Duplicated(), OneTurned(), MoebiusStrip(), KleinBottle(), TwoBodiesAndASheet(),
    Torus(12, 8), Soup(300, 30) };
}
