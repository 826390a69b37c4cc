// Shadow volumes: closed for any mesh and any light, turned outward, and as deep as the triangles
// that a ray to the light crosses.
#include "ShadowVolume.h"

#include "ShadowMeshes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <initializer_list>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <tuple>
#include <utility>

using namespace vtkshadows;

namespace
{

using Triangle = std::array<std::uint32_t, 3>;

struct Volume
{
  ShadowMesh<double> mesh;
  glm::dvec4 light;
  std::vector<CastSign> signs;
  std::vector<std::uint32_t> singles, doubles, caps, turnedCaps; // see VolumeLists
  std::vector<std::uint32_t> soup, turnedSoup;
  std::vector<Triangle> triangles; // all of them, far caps too, turned outward

  void Emit(bool oneImage)
  {
    const VolumeEmitter<double> emitter(this->mesh, this->signs, oneImage);
    const VolumeLists& lists = emitter.Lists();
    std::vector<std::uint32_t> numbers(lists.Count());
    emitter.Write(numbers.data());
    const auto take = [&numbers](std::initializer_list<VolumeLists::List> parts)
    {
      std::vector<std::uint32_t> taken;
      for (const VolumeLists::List& part : parts)
      {
        taken.insert(taken.end(), numbers.begin() + part.first, numbers.begin() + part.End());
      }
      return taken;
    };
    this->singles = take({ lists.singles });
    this->doubles = take({ lists.doubles });
    this->caps = take({ lists.caps });
    this->turnedCaps = take({ lists.turnedCaps });
    this->soup = take({ lists.threeSided, lists.twoSided });
    this->turnedSoup = take({ lists.turnedTwoSided, lists.turnedThreeSided });
    this->triangles.clear();
    this->Add(this->singles, 0, false);
    this->Add(this->doubles, 0, false);
    this->Add(this->doubles, 0, false); // each stands for two
    this->Add(this->caps, 0, false);
    this->Add(this->turnedCaps, 0, true);
    this->Add(this->caps, 1, true);
    this->Add(this->turnedCaps, 1, false);
    this->AddSoup(this->soup, oneImage, false);
    this->AddSoup(this->turnedSoup, oneImage, true);
  }

private:
  void AddSoup(const std::vector<std::uint32_t>& entries, bool oneImage, bool turned)
  {
    for (const std::uint32_t entry : entries)
    {
      const glm::uvec3 t = this->mesh.Corners(this->mesh.triangles.size() + (entry & 0x3fffffffu));
      const std::uint32_t innerSide = entry >> 30;
      this->Add({ 2 * t.x, 2 * t.y, 2 * t.z }, 0, turned);
      this->Add({ 2 * t.x, 2 * t.y, 2 * t.z }, 1, !turned);
      for (std::uint32_t side = 0; side < 3; ++side)
      {
        if (side != innerSide)
        {
          const std::uint32_t from = 2 * t[side], to = 2 * t[(side + 1) % 3];
          this->Add({ to, from, from + 1 }, 0, turned);
          if (!oneImage)
          {
            this->Add({ to, from + 1, to + 1 }, 0, turned);
          }
        }
      }
    }
  }

  void Add(const std::vector<std::uint32_t>& corners, std::uint32_t image, bool turned)
  {
    for (std::size_t i = 0; i < corners.size(); i += 3)
    {
      Triangle t{ corners[i] + image, corners[i + 1] + image, corners[i + 2] + image };
      if (turned)
      {
        std::swap(t[1], t[2]);
      }
      this->triangles.push_back(t);
    }
  }
};

constexpr std::size_t AnyPoints = std::numeric_limits<std::size_t>::max();

Volume MakeVolume(const TestMesh& mesh, const glm::dvec4& light, CastingFaces which,
  bool oneImage = false, bool soupApart = false)
{
  Volume volume;
  volume.mesh = BuildShadowMesh(mesh.points, mesh.triangles);
  if (soupApart)
  {
    SetSoupApart(volume.mesh, AnyPoints);
  }
  volume.light = light;
  FaceTriangles(volume.mesh, light, which, volume.signs);
  volume.Emit(oneImage);
  return volume;
}

// How many directed edges are run more often one way than the other. `oneImage`: all images are one
// point.
std::size_t CountOpenEdges(const Volume& volume, bool oneImage)
{
  // Soup has its points for itself.
  const std::vector<glm::dvec3>& points = volume.mesh.points;
  const auto isLess = [&points](std::uint32_t a, std::uint32_t b)
  {
    return std::tie(points[a].x, points[a].y, points[a].z) <
      std::tie(points[b].x, points[b].y, points[b].z);
  };
  std::map<std::uint32_t, std::uint32_t, decltype(isLess)> welded(isLess);
  std::vector<std::uint32_t> number;
  for (std::uint32_t i = 0; i < points.size(); ++i)
  {
    number.push_back(welded.emplace(i, i).first->second);
  }
  const auto pointOf = [&](std::uint32_t i)
  { return oneImage && i % 2 ? 1u : 2 * number[i / 2] + i % 2; };
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> incidence;
  for (const Triangle& t : volume.triangles)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const std::uint32_t from = pointOf(t[corner]), to = pointOf(t[(corner + 1) % 3]);
      // What starts where it ends bounds nothing.
      incidence[std::minmax(from, to)] += from < to ? 1 : from > to ? -1 : 0;
    }
  }
  return std::count_if(
    incidence.begin(), incidence.end(), [](const auto& edge) { return edge.second != 0; });
}

// Lights that matter for the small meshes: far and near, outside and inside, in the plane of faces,
// at vertices.
std::vector<glm::dvec4> LightsFor(const TestMesh& mesh)
{
  const glm::uvec3 t = mesh.triangles[mesh.triangles.size() / 2];
  const glm::dvec3 a = mesh.points[t.x], b = mesh.points[t.y], c = mesh.points[t.z];
  return {
    { glm::normalize(glm::dvec3(0.3, -0.5, 0.8)), 0.0 },
    { 0.0, 0.0, 1.0, 0.0 }, // along the faces of a cube, across a flat sheet
    { 1.0, 0.0, 0.0, 0.0 }, // within a flat sheet
    { 2.7, -3.1, 5.3, 1.0 }, { 0.13, 0.21, 0.17, 1.0 },
    { 5.0, 0.3, 1.0, 1.0 },                             // in the plane of a cube's face
    { 5.0, 3.0, 0.0, 1.0 },                             // in the plane of a flat sheet
    { a, 1.0 }, { 0.25 * a + 0.5 * b + 0.25 * c, 1.0 }, // in a triangle
    { 3.0 * a - b - c, 1.0 },                           // in its plane, outside
  };
}

void ExpectClosed(const TestMesh& mesh)
{
  for (const glm::dvec4& light : LightsFor(mesh))
  {
    for (const CastingFaces which : { CastingFaces::All, CastingFaces::Closed })
    {
      for (const bool oneImage : { false, true })
      {
        for (const bool soupApart : { false, true })
        {
          const Volume volume = MakeVolume(mesh, light, which, oneImage, soupApart);
          EXPECT_EQ(CountOpenEdges(volume, oneImage), 0u)
            << mesh.name << ", light " << light.x << " " << light.y << " " << light.z << " "
            << light.w << (which == CastingFaces::All ? ", all faces" : ", closed faces")
            << (oneImage ? ", one image" : "") << (soupApart ? ", soup apart" : "");
        }
      }
    }
  }
}

// +1 where the ray p + t * d, 0 < t < end, crosses the triangle from its back to its front, -1 the
// other way, 0 elsewhere. An edge is judged alike by both of its triangles.
int Crossing(
  const glm::dvec3& p, const glm::dvec3& d, double end, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c)
{
  a -= p;
  b -= p;
  c -= p;
  const double u = glm::dot(d, glm::cross(a, b));
  const double v = glm::dot(d, glm::cross(b, c));
  const double w = glm::dot(d, glm::cross(c, a));
  const bool isFront = u > 0 && v > 0 && w > 0;
  const bool isBack = u < 0 && v < 0 && w < 0;
  if (!isFront && !isBack)
  {
    return 0;
  }
  const double t = glm::dot(a, glm::cross(b, c)) / (u + v + w);
  return t > 0 && t < end ? (isFront ? 1 : -1) : 0;
}

// How many casting triangles are between the point and the light.
int CountCasters(const Volume& volume, const glm::dvec3& p)
{
  const glm::dvec3 toward = glm::dvec3(volume.light) - p * volume.light.w;
  const double end = volume.light.w == 0.0 ? 1e300 : 1.0;
  int count = 0;
  for (std::size_t i = 0; i < volume.signs.size(); ++i)
  {
    const glm::uvec3 t = volume.mesh.Corners(i);
    const glm::dvec3 a = volume.mesh.points[t.x], b = volume.mesh.points[t.y];
    const int crossing = Crossing(p, toward, end, a, b, volume.mesh.points[t.z]);
    count += volume.signs[i] == 0 ? 0 : std::abs(crossing);
  }
  return count;
}

// How often the volume's surface winds round the point: how many of its prisms hold it. Images are
// far enough to be beyond every point that is asked.
int Winding(const Volume& volume, const glm::dvec3& p)
{
  const glm::dvec3 along = glm::normalize(glm::dvec3(0.532, -0.219, 0.817));
  const auto position = [&volume](std::uint32_t index)
  {
    const glm::dvec3 point = volume.mesh.points[index / 2];
    const glm::dvec3 away = point * volume.light.w - glm::dvec3(volume.light);
    return index % 2 ? point + 1e5 * away : point;
  };
  int winding = 0;
  for (const Triangle& t : volume.triangles)
  {
    winding += Crossing(p, along, 1e300, position(t[0]), position(t[1]), position(t[2]));
  }
  return winding;
}

}

TEST(ShadowVolume, IsClosedForAnyMeshAndAnyLight)
{
  for (const TestMesh& mesh : SmallMeshes())
  {
    ExpectClosed(mesh);
  }
}

TEST(ShadowVolume, IsClosedForASoupOfTenThousandTriangles)
{
  ExpectClosed(Soup(10000, 500));
}

TEST(ShadowVolume, IsClosedWhicheverTrianglesCast)
{
  // Facing may be rounding noise: any signs will do, as caps and sides share them.
  std::mt19937 random(3);
  std::uniform_int_distribution<int> sign(-1, 1);
  for (const TestMesh& mesh : SmallMeshes())
  {
    for (const bool soupApart : { false, true })
    {
      Volume volume = MakeVolume(mesh, { 0, 0, 1, 0 }, CastingFaces::All, false, soupApart);
      for (CastSign& each : volume.signs)
      {
        each = static_cast<CastSign>(sign(random));
      }
      volume.Emit(false);
      EXPECT_EQ(CountOpenEdges(volume, false), 0u) << mesh.name;
    }
  }
}

TEST(ShadowVolume, HoldsAPointAsOftenAsItsRayToTheLightIsCrossed)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(-4.0, 4.0);
  const std::vector<glm::dvec4> lights{ { glm::normalize(glm::dvec3(0.3, -0.5, 0.8)), 0.0 },
    { 2.7, -3.1, 5.3, 1.0 }, { 0.13, 0.21, 0.17, 1.0 } };
  int inShadow = 0;
  for (const TestMesh& mesh : SmallMeshes())
  {
    for (const glm::dvec4& light : lights)
    {
      for (const CastingFaces which : { CastingFaces::All, CastingFaces::Closed })
      {
        const Volume volume = MakeVolume(mesh, light, which);
        const Volume soupApart = MakeVolume(mesh, light, which, false, true);
        for (int i = 0; i < 300; ++i)
        {
          // Half of the points are behind the mesh, as the light sees it.
          const glm::uvec3 t = mesh.triangles[i % mesh.triangles.size()];
          const glm::dvec3 behind = (mesh.points[t.x] + mesh.points[t.y] + mesh.points[t.z]) / 3.0;
          const glm::dvec3 away = behind * light.w - glm::dvec3(light);
          const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
          const glm::dvec3 p =
            i % 2 ? glm::dvec3(x, y, z) : behind + 0.5 * away + 0.02 * glm::dvec3(x, y, z);
          const int expected = CountCasters(volume, p);
          ASSERT_EQ(Winding(volume, p), expected)
            << mesh.name << ", point " << p.x << " " << p.y << " " << p.z;
          ASSERT_EQ(Winding(soupApart, p), expected)
            << mesh.name << ", soup apart, point " << p.x << " " << p.y << " " << p.z;
          inShadow += expected > 0;
        }
      }
    }
  }
  std::cout << "points in shadow: " << inShadow << " of " << SmallMeshes().size() * 1800 << '\n';
  EXPECT_GT(inShadow, 9000);
}

TEST(ShadowVolume, AClosedBodysEdgesCountTwiceWithAllFacesAndOnceWithClosed)
{
  for (const TestMesh& mesh : { Tetrahedron(), Cube(), InsideOutCube(), Torus(12, 8) })
  {
    for (const glm::dvec4& light :
      { glm::dvec4(0.31, 0.52, 0.79, 0.0), glm::dvec4(2.7, -3.1, 5.3, 1.0) })
    {
      for (const std::uint32_t expected : { 1u, 2u })
      {
        const Volume volume =
          MakeVolume(mesh, light, expected == 1 ? CastingFaces::Closed : CastingFaces::All);
        std::vector<SilhouetteEdge> silhouette;
        FindSilhouette(volume.mesh, volume.signs, silhouette);
        ASSERT_FALSE(silhouette.empty());
        for (const SilhouetteEdge& edge : silhouette)
        {
          EXPECT_EQ(edge.multiplicity, expected) << mesh.name;
        }
        EXPECT_EQ(volume.singles.size(), expected == 1 ? 6 * silhouette.size() : 0u);
        EXPECT_EQ(volume.doubles.size(), expected == 2 ? 6 * silhouette.size() : 0u);
      }
    }
  }
}

TEST(ShadowVolume, TheShadowIsToTheLeftOfASilhouetteEdgeSeenFromTheLight)
{
  for (const TestMesh& mesh : { Tetrahedron(), Cube(), InsideOutCube() })
  {
    for (const glm::dvec4& light :
      { glm::dvec4(0.31, 0.52, 0.79, 0.0), glm::dvec4(2.7, -3.1, 5.3, 1.0) })
    {
      const Volume volume = MakeVolume(mesh, light, CastingFaces::All);
      std::vector<SilhouetteEdge> silhouette;
      FindSilhouette(volume.mesh, volume.signs, silhouette);
      for (const SilhouetteEdge& edge : silhouette)
      {
        const glm::dvec3 from = volume.mesh.points[edge.from], to = volume.mesh.points[edge.to];
        const glm::dvec3 middle = 0.5 * (from + to);
        const glm::dvec3 toward = glm::dvec3(light) - middle * light.w;
        const glm::dvec3 left = 1e-3 * glm::normalize(glm::cross(toward, to - from));
        EXPECT_EQ(CountCasters(volume, middle - 2.0 * toward + left), 2) << mesh.name;
        EXPECT_EQ(CountCasters(volume, middle - 2.0 * toward - left), 0) << mesh.name;
      }
    }
  }
}

TEST(ShadowVolume, ASheetsEdgesCountOnceAndEdgesOfManyBladesUpToAll)
{
  std::vector<SilhouetteEdge> silhouette;
  const auto largest = [&silhouette](const TestMesh& mesh, const glm::dvec4& light)
  {
    const Volume volume = MakeVolume(mesh, light, CastingFaces::Closed);
    FindSilhouette(volume.mesh, volume.signs, silhouette);
    return std::max_element(silhouette.begin(), silhouette.end(),
      [](const SilhouetteEdge& a, const SilhouetteEdge& b)
      { return a.multiplicity < b.multiplicity; })
      ->multiplicity;
  };
  EXPECT_EQ(largest(OpenStrip(), { 0, 0, 1, 0 }), 1u);
  EXPECT_EQ(silhouette.size(), 10u); // the border alone
  // Blades to the right of x = 0, seen along y from below: all on one side of the common edge.
  TestMesh blades = Fan(3);
  blades.points[2] = { 1.0, 0.0, 0.0 };
  blades.points[3] = { 1.0, 0.5, 0.0 };
  blades.points[4] = { 1.0, -0.5, 0.0 };
  EXPECT_EQ(largest(blades, { 0, 1, 0, 0 }), 3u);
}

TEST(ShadowVolume, HigherMultiplicitiesAreDoublesAndAnOddOneASingle)
{
  TestMesh blades = Fan(5);
  for (int i = 0; i < 5; ++i)
  {
    blades.points[i + 2] = { 1.0, 0.2 * i - 0.4, 0.0 };
  }
  const Volume volume = MakeVolume(blades, { 0, 1, 0, 0 }, CastingFaces::All, true);
  const auto countOn =
    [](const std::vector<std::uint32_t>& corners, std::uint32_t a, std::uint32_t b)
  {
    int count = 0;
    for (std::size_t i = 0; i < corners.size(); i += 3)
    {
      count += std::minmax(corners[i], corners[i + 1]) == std::minmax(a, b);
    }
    return count;
  };
  // The common edge, from point 0 to 1, has five sides: one single and two doubles.
  EXPECT_EQ(countOn(volume.singles, 0, 2), 1);
  EXPECT_EQ(countOn(volume.doubles, 0, 2), 2);
}

TEST(ShadowVolume, TheSilhouetteIsTheSameWithSoupApart)
{
  for (const TestMesh& mesh : SmallMeshes())
  {
    using Edge = std::array<double, 7>;
    std::vector<Edge> found[2];
    for (const bool soupApart : { false, true })
    {
      const Volume volume =
        MakeVolume(mesh, { 2.7, -3.1, 5.3, 1.0 }, CastingFaces::Closed, false, soupApart);
      std::vector<SilhouetteEdge> silhouette;
      FindSilhouette(volume.mesh, volume.signs, silhouette);
      for (const SilhouetteEdge& edge : silhouette)
      {
        const glm::dvec3 from = volume.mesh.points[edge.from], to = volume.mesh.points[edge.to];
        found[soupApart].push_back(
          { from.x, from.y, from.z, to.x, to.y, to.z, double(edge.multiplicity) });
      }
      std::sort(found[soupApart].begin(), found[soupApart].end());
    }
    EXPECT_TRUE(found[0] == found[1]) << mesh.name;
  }
}

TEST(ShadowVolume, ClosedFacesAreAllFacesWhereTheBoundsHoldTheLight)
{
  const auto signs = [](const TestMesh& mesh, const glm::dvec4& light, CastingFaces which)
  { return MakeVolume(mesh, light, which).signs; };
  for (const glm::dvec4& inside :
    { glm::dvec4(0.1, 0.2, 0.3, 1.0), glm::dvec4(1.0, 1.0, 1.0, 1.0) })
  {
    EXPECT_EQ(
      signs(Cube(), inside, CastingFaces::Closed), signs(Cube(), inside, CastingFaces::All));
  }
  const glm::dvec4 outside(1.01, 0.2, 0.3, 1.0);
  const std::vector<CastSign> closed = signs(Cube(), outside, CastingFaces::Closed);
  EXPECT_EQ(std::count(closed.begin(), closed.end(), CastSign(1)), 2);
  EXPECT_EQ(std::count(closed.begin(), closed.end(), CastSign(0)), 10);
  // An inside-out body casts with the faces that do not face the light as they are wound.
  const std::vector<CastSign> turned = signs(InsideOutCube(), outside, CastingFaces::Closed);
  EXPECT_EQ(std::count(turned.begin(), turned.end(), CastSign(-1)), 2);
  EXPECT_EQ(std::count(turned.begin(), turned.end(), CastSign(0)), 10);
}

TEST(ShadowVolume, TheSameOnAnyNumberOfThreads)
{
  const TestMesh torus = Torus(200, 120);
  const auto make = [&torus](std::size_t threads)
  {
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return MakeVolume(torus, { 2.7, -3.1, 5.3, 1.0 }, CastingFaces::All);
  };
  const Volume one = make(1), two = make(2);
  EXPECT_FALSE(one.doubles.empty());
  EXPECT_TRUE(one.signs == two.signs);
  EXPECT_TRUE(one.singles == two.singles);
  EXPECT_TRUE(one.doubles == two.doubles);
  EXPECT_TRUE(one.caps == two.caps);
  EXPECT_TRUE(one.turnedCaps == two.turnedCaps);
}

TEST(ShadowVolume, FacingIsDecidedInDoubleForFloatsToo)
{
  // Tilted against the light by less than a float can tell at this size of the normal.
  const std::vector<glm::vec3> points{ { 1e4f, 0.0f, 0.0f }, { 1e4f + 1.0f, 0.0f, 0.0f },
    { 1e4f, 1.0f, 1.0f } };
  const ShadowMesh<float> mesh = BuildShadowMesh(points, std::vector<glm::uvec3>{ { 0, 1, 2 } });
  std::vector<CastSign> signs;
  for (const double tilt : { 1e-12, -1e-12 })
  {
    // The normal is (0, -1, 1).
    FaceTriangles(mesh, { 0.0, 1.0, 1.0 + tilt, 0.0 }, CastingFaces::All, signs);
    EXPECT_EQ(signs[0], tilt > 0.0 ? 1 : -1);
  }
}

// A lamp at a corner, on an edge or on a face of a box whose points are floats, though the lamp is
// where they were in double: the faces that it lies on cast nothing, and what lies behind the box
// is in the shadow of the others, whichever way rounding went.
TEST(ShadowVolume, WhatALampLiesOnNeedNotCast)
{
  std::mt19937 random(17);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (int turn = 0; turn < 50; ++turn)
  {
    const glm::dvec3 axis(coordinate(random), coordinate(random), 1.5 + coordinate(random));
    const glm::dvec3 x = glm::normalize(axis), y = glm::normalize(glm::cross(x, { 0.3, 1.0, 0.1 })),
                     z = glm::cross(x, y);
    const glm::dvec3 middle(5.0 * coordinate(random), 5.0 * coordinate(random), coordinate(random));
    const auto at = [&](double i, double j, double k) { return middle + i * x + j * y + k * z; };
    std::vector<glm::vec3> points;
    for (int i = 0; i < 8; ++i)
    {
      points.emplace_back(at(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    }
    // Two triangles a side; sides that meet at corner 7 come first.
    const std::vector<glm::uvec3> triangles{ { 1, 3, 7 }, { 1, 7, 5 }, { 2, 6, 7 }, { 2, 7, 3 },
      { 4, 5, 7 }, { 4, 7, 6 }, { 0, 4, 6 }, { 0, 6, 2 }, { 0, 1, 5 }, { 0, 5, 4 }, { 0, 2, 3 },
      { 0, 3, 1 } };
    const ShadowMesh<float> mesh = BuildShadowMesh(points, triangles, true);
    const struct
    {
      glm::dvec3 place;
      unsigned int touched; // a bit a triangle
    } lamps[] = { { at(1, 1, 1), 0x3f }, { at(1, 1, 0.2), 0x09 }, { at(1, 0.3, -0.4), 0x01 } };
    for (const auto& lamp : lamps)
    {
      for (const CastingFaces which : { CastingFaces::All, CastingFaces::Closed })
      {
        std::vector<CastSign> signs;
        FaceTriangles(mesh, glm::dvec4(lamp.place, 1.0), which, signs, TouchedFaces::CastNot);
        unsigned int silent = 0;
        for (std::size_t i = 0; i < signs.size(); ++i)
        {
          silent |= signs[i] == 0 ? 1u << mesh.originals[i] : 0u;
        }
        EXPECT_EQ(silent, lamp.touched) << "turn " << turn;
      }
    }
  }
}
