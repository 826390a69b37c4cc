// Shadow volumes as polydata: closed, turned outward, of the right size, and holding what is in
// shadow.
#include "FilterTest.h"

#include "vtkShadowVolumeFilter.h"

#include <vtkIdList.h>
#include <vtkPointData.h>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <set>

using namespace filtertest;

namespace
{

using Filter = vtkShadowVolumeFilter;

const glm::dvec3 Oblique = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
const glm::dvec4 ObliqueLight(Oblique, 0.0);

vtkSmartPointer<Filter> MakeFilter(vtkPolyData* mesh, const glm::dvec4& light, int mode)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(mesh);
  filter->SetLight(light.x, light.y, light.z, light.w);
  filter->SetExtentMode(mode);
  return filter;
}

vtkSmartPointer<vtkPolyData> OutputOf(Filter* filter)
{
  filter->Update();
  return filter->GetOutput();
}

// Area of the mesh's shadow across `toward`, of a convex body.
double ProjectedArea(vtkPolyData* mesh, const glm::dvec3& toward)
{
  double area = 0.0;
  for (const Corners& t : TrianglesOf(mesh))
  {
    const glm::dvec3 a = PointOf(mesh, t[0]), b = PointOf(mesh, t[1]), c = PointOf(mesh, t[2]);
    area += std::max(0.0, 0.5 * glm::dot(toward, glm::cross(b - a, c - a)));
  }
  return area;
}

std::array<vtkIdType, 3> CountParts(vtkPolyData* volume)
{
  std::array<vtkIdType, 3> counts{};
  for (vtkIdType i = 0; i < volume->GetNumberOfCells(); ++i)
  {
    ++counts[static_cast<int>(CellValue(volume, "ShadowVolumePart", i))];
  }
  return counts;
}

}

TEST(ShadowVolume, IsClosedForAnyMesh)
{
  for (const NamedMesh& mesh : AllMeshes())
  {
    const glm::dvec3 vertex = PointOf(mesh.mesh, 0);
    for (const glm::dvec4& light :
      { ObliqueLight, glm::dvec4(0.0, 0.0, 1.0, 0.0), glm::dvec4(2.7, -3.1, 5.3, 1.0),
        glm::dvec4(0.1, 0.2, 0.3, 1.0), glm::dvec4(vertex, 1.0) })
    {
      for (const int mode :
        { Filter::LENGTH_EXTENT, Filter::BOUNDS_EXTENT, Filter::INFINITE_EXTENT })
      {
        for (const int faces : { Filter::ALL_FACES, Filter::CLOSED_FACES })
        {
          const auto filter = MakeFilter(mesh.mesh, light, mode);
          filter->SetCastingFaces(faces);
          const auto volume = OutputOf(filter);
          EXPECT_GT(volume->GetNumberOfCells(), 0) << mesh.name;
          EXPECT_EQ(CountOpenEdges(volume), 0u)
            << mesh.name << ", light " << light.x << " " << light.y << " " << light.z << " "
            << light.w << ", mode " << mode << ", faces " << faces;
          EXPECT_TRUE(std::isfinite(glm::length(PointOf(volume, volume->GetNumberOfPoints() - 1))));
        }
      }
    }
  }
}

TEST(ShadowVolume, OfAConvexBodyIsAreaTimesLength)
{
  // Each prism between a lit triangle and its image a length away has the triangle's area across
  // the light, times the length; prisms of a convex body's lit side do not overlap. The body is in
  // the volume, as far as it is within that length of its lit side.
  const double length = 7.5;
  for (const auto& mesh :
    { ToPolyData(Cube(), VTK_DOUBLE), UnitSphere(32), ToPolyData(Tetrahedron(), VTK_DOUBLE) })
  {
    const auto filter = MakeFilter(mesh, ObliqueLight, Filter::LENGTH_EXTENT);
    filter->SetLength(length);
    const double expected = ProjectedArea(mesh, Oblique) * length;
    filter->SetCastingFacesToClosed();
    EXPECT_NEAR(SignedVolume(OutputOf(filter)), expected, 1e-9 * expected);
    // The far side casts prisms of the same sum.
    filter->SetCastingFacesToAll();
    EXPECT_NEAR(SignedVolume(OutputOf(filter)), 2.0 * expected, 2e-9 * expected);
  }
  const double hexagon = 4.0 * std::sqrt(3.0); // a cube of side 2 along its diagonal
  EXPECT_NEAR(
    ProjectedArea(ToPolyData(Cube(), VTK_DOUBLE), glm::normalize(glm::dvec3(1.0))), hexagon, 1e-12);
}

TEST(ShadowVolume, OfACubeReachesToAPlaneBeyondTheBounds)
{
  const auto filter =
    MakeFilter(ToPolyData(Cube(), VTK_DOUBLE), { 0.0, 0.0, 1.0, 0.0 }, Filter::BOUNDS_EXTENT);
  filter->SetBounds(-2.0, 2.0, -2.0, 2.0, -9.0, 0.5);
  const auto volume = OutputOf(filter);
  double bounds[6];
  volume->GetBounds(bounds);
  EXPECT_LT(bounds[4], -9.0);
  EXPECT_GT(bounds[4], -9.5);
  EXPECT_NEAR(SignedVolume(volume), 4.0 * (1.0 - bounds[4]), 1e-12);
  // Where every far point is.
  for (vtkIdType i = volume->GetNumberOfPoints() / 2; i < volume->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(PointOf(volume, i).z, bounds[4]);
  }

  // Left to itself it goes by the cube's bounds, grown by their diagonal.
  filter->SetBounds(1.0, -1.0, 1.0, -1.0, 1.0, -1.0);
  OutputOf(filter)->GetBounds(bounds);
  const double expected = -1.0 - std::sqrt(12.0);
  EXPECT_LT(bounds[4], expected);
  EXPECT_GT(bounds[4], 1.1 * expected);
}

TEST(ShadowVolume, HoldsAPointAsOftenAsItsRayToTheLightIsCrossed)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-2.0, 2.0);
  const glm::dvec3 along = glm::normalize(glm::dvec3(0.532, -0.219, 0.817));
  int inShadow = 0;
  for (const TestMesh& each :
    { Cube(), MoebiusStrip(), KleinBottle(), Soup(300, 30), OpenStrip(), Fan(5) })
  {
    const auto mesh = ToPolyData(each, VTK_DOUBLE);
    // A light far away, one outside, one among the faces.
    for (const glm::dvec4& light :
      { ObliqueLight, glm::dvec4(2.7, -3.1, 5.3, 1.0), glm::dvec4(0.13, 0.21, 0.17, 1.0) })
    {
      const auto filter = MakeFilter(mesh, light, Filter::BOUNDS_EXTENT);
      filter->SetCastingFacesToAll();
      filter->SetBounds(-2.0, 2.0, -2.0, 2.0, -2.0, 2.0);
      const auto volume = OutputOf(filter);
      for (int i = 0; i < 200; ++i)
      {
        const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
        const glm::dvec3 p(x, y, z), toward = glm::dvec3(light) - p * light.w;
        const int expected = CountCrossings(mesh, p, toward, light.w == 0.0 ? 1e300 : 1.0, false);
        ASSERT_EQ(CountCrossings(volume, p, along, 1e300, true), expected)
          << each.name << ", point " << x << " " << y << " " << z << ", light " << light.x;
        inShadow += expected > 0;
      }
    }
  }
  std::cout << "points in shadow: " << inShadow << " of 3600\n";
  EXPECT_GT(inShadow, 500);
}

TEST(ShadowVolume, SaysWhatEachCellIsAndWhereItCameFrom)
{
  for (const glm::dvec4& light : { ObliqueLight, glm::dvec4(2.0, 1.0, 3.0, 1.0) })
  {
    const auto sphere = UnitSphere(16);
    const auto volume = OutputOf(MakeFilter(sphere, light, Filter::LENGTH_EXTENT));
    const auto [caps, sides, farCaps] = CountParts(volume);
    EXPECT_GT(caps, 0);
    EXPECT_LT(caps, sphere->GetNumberOfCells());
    EXPECT_EQ(caps, farCaps);
    EXPECT_EQ(caps + sides + farCaps, volume->GetNumberOfCells());
    vtkNew<vtkIdList> ids;
    std::set<vtkIdType> casting;
    for (vtkIdType i = 0; i < volume->GetNumberOfCells(); ++i)
    {
      volume->GetCellPoints(i, ids);
      const auto cell = static_cast<vtkIdType>(CellValue(volume, "OriginalCellIds", i));
      // A side's cell is one of those that cast.
      EXPECT_EQ(casting.insert(cell).second, i < caps) << "cell " << i;
      for (const vtkIdType id : *ids)
      {
        // The input's point that this is, or is the image of.
        const auto original = static_cast<vtkIdType>(PointValue(volume, "OriginalPointIds", id));
        EXPECT_TRUE(CellHolds(sphere, cell, PointOf(sphere, original)));
        const double moved = glm::distance(PointOf(volume, id), PointOf(sphere, original));
        EXPECT_NEAR(moved, id < volume->GetNumberOfPoints() / 2 ? 0.0 : 1.0, 1e-12);
      }
      const auto part = static_cast<int>(CellValue(volume, "ShadowVolumePart", i));
      EXPECT_EQ(part,
        i < caps             ? Filter::NEAR_CAP
          : i < caps + sides ? Filter::SIDE
                             : Filter::FAR_CAP);
    }
  }
}

TEST(ShadowVolume, WithoutEndHasDirectionsForFarPoints)
{
  const auto cube = ToPolyData(Cube(), VTK_FLOAT);
  const glm::dvec3 position(2.0, 1.5, 3.0);
  auto volume = OutputOf(MakeFilter(cube, glm::dvec4(position, 1.0), Filter::INFINITE_EXTENT));
  EXPECT_EQ(volume->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
  {
    const bool isFar = i >= volume->GetNumberOfPoints() / 2;
    EXPECT_EQ(PointValue(volume, "HomogeneousW", i), isFar ? 0.0 : 1.0);
    const auto original = static_cast<vtkIdType>(PointValue(volume, "OriginalPointIds", i));
    EXPECT_EQ(PointOf(volume, i), PointOf(cube, original) - (isFar ? position : glm::dvec3(0.0)));
  }
  EXPECT_EQ(CountParts(volume), (std::array<vtkIdType, 3>{ 6, 12, 6 }));

  volume = OutputOf(MakeFilter(cube, { 0.0, 3.0, 4.0, 0.0 }, Filter::INFINITE_EXTENT));
  const vtkIdType last = volume->GetNumberOfPoints() - 1;
  EXPECT_EQ(PointValue(volume, "HomogeneousW", last), 0.0);
  EXPECT_EQ(PointValue(volume, "OriginalPointIds", last), -1.0);
  EXPECT_LT(glm::distance(PointOf(volume, last), glm::dvec3(0.0, -0.6, -0.8)), 1e-15);
  EXPECT_EQ(CountParts(volume), (std::array<vtkIdType, 3>{ 4, 6, 0 }));

  const auto finite = OutputOf(MakeFilter(cube, ObliqueLight, Filter::LENGTH_EXTENT));
  EXPECT_EQ(finite->GetPointData()->GetArray("HomogeneousW"), nullptr);
}

TEST(ShadowVolume, SidesStandAsOftenAsTheirEdgeCounts)
{
  const auto filter =
    MakeFilter(ToPolyData(Cube(), VTK_DOUBLE), ObliqueLight, Filter::LENGTH_EXTENT);
  filter->SetCastingFacesToClosed();
  EXPECT_EQ(CountParts(OutputOf(filter)), (std::array<vtkIdType, 3>{ 6, 12, 6 }));
  filter->SetCastingFacesToAll();
  EXPECT_EQ(CountParts(OutputOf(filter)), (std::array<vtkIdType, 3>{ 12, 24, 12 }));
}
