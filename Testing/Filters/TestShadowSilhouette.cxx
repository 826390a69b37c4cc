// Silhouettes: which edges, in what direction, with which numbers on them.
#include "FilterTest.h"

#include "vtkShadowSilhouetteFilter.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

using namespace filtertest;

namespace
{

using Filter = vtkShadowSilhouetteFilter;

vtkSmartPointer<vtkPolyData> OutputOf(vtkPolyData* mesh, const glm::dvec4& light, int faces)
{
  vtkNew<Filter> filter;
  filter->SetInputData(mesh);
  filter->SetLight(light.x, light.y, light.z, light.w);
  filter->SetCastingFaces(faces);
  filter->Update();
  return filter->GetOutput();
}

std::pair<vtkIdType, vtkIdType> EndsOf(vtkPolyData* lines, vtkIdType line)
{
  vtkNew<vtkIdList> ids;
  lines->GetCellPoints(line, ids);
  EXPECT_EQ(ids->GetNumberOfIds(), 2);
  return { ids->GetId(0), ids->GetId(1) };
}

// The area that the lines go round counter-clockwise, seen along `toward` from its tip, each as
// often as its multiplicity.
double AreaInside(vtkPolyData* lines, const glm::dvec3& toward)
{
  double area = 0.0;
  for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i)
  {
    const auto [from, to] = EndsOf(lines, i);
    area += 0.5 * std::abs(CellValue(lines, "SignedMultiplicity", i)) *
      glm::dot(toward, glm::cross(PointOf(lines, from), PointOf(lines, to)));
  }
  return area;
}

const glm::dvec3 Oblique = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
const glm::dvec4 ObliqueLight(Oblique, 0.0);

}

TEST(ShadowSilhouette, GoesRoundTheProjectedAreaOfACube)
{
  const auto cube = ToPolyData(Cube(), VTK_DOUBLE);
  // Each face of area 4 is seen at its own angle.
  const double area = 4.0 * (std::abs(Oblique.x) + std::abs(Oblique.y) + std::abs(Oblique.z));
  const auto once = OutputOf(cube, ObliqueLight, Filter::CLOSED_FACES);
  EXPECT_EQ(once->GetNumberOfCells(), 6);
  EXPECT_EQ(once->GetNumberOfPoints(), 6);
  EXPECT_NEAR(AreaInside(once, Oblique), area, 1e-12 * area);
  const auto twice = OutputOf(cube, ObliqueLight, Filter::ALL_FACES);
  EXPECT_EQ(twice->GetNumberOfCells(), 6);
  EXPECT_NEAR(AreaInside(twice, Oblique), 2.0 * area, 1e-12 * area);
}

TEST(ShadowSilhouette, IsLoopsOnAnyMesh)
{
  // As many lines end at a point as begin there: the border of a border is nothing.
  vtkIdType count = 0;
  for (const NamedMesh& mesh : AllMeshes())
  {
    for (const glm::dvec4& light : { ObliqueLight, glm::dvec4(0.1, 0.2, 0.3, 1.0) })
    {
      const auto lines = OutputOf(mesh.mesh, light, Filter::ALL_FACES);
      count += lines->GetNumberOfCells();
      std::map<vtkIdType, int> balance;
      for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i)
      {
        const int sides = std::abs(static_cast<int>(CellValue(lines, "SignedMultiplicity", i)));
        const auto [from, to] = EndsOf(lines, i);
        balance[from] += sides;
        balance[to] -= sides;
      }
      for (const auto& point : balance)
      {
        ASSERT_EQ(point.second, 0) << mesh.name << ", point " << point.first;
      }
    }
  }
  EXPECT_GT(count, 10000);
}

TEST(ShadowSilhouette, PartsTheFacesOfASphereThatAreLitFromThoseThatAreNot)
{
  const auto sphere = UnitSphere(24);
  const glm::dvec3 position(2.0, 1.0, 3.0);
  const auto lines = OutputOf(sphere, glm::dvec4(position, 1.0), Filter::ALL_FACES);
  const std::vector<Corners> triangles = TrianglesOf(sphere);
  const auto isLit = [&](vtkIdType cell)
  {
    const glm::dvec3 a = PointOf(sphere, triangles[cell][0]);
    const glm::dvec3 b = PointOf(sphere, triangles[cell][1]);
    const glm::dvec3 c = PointOf(sphere, triangles[cell][2]);
    return glm::dot(glm::cross(b - a, c - a), position - a) > 0.0;
  };
  ASSERT_GT(lines->GetNumberOfCells(), 20);
  for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i)
  {
    const auto [from, to] = EndsOf(lines, i);
    const auto cell0 = static_cast<vtkIdType>(CellValue(lines, "OriginalCellId0", i));
    const auto cell1 = static_cast<vtkIdType>(CellValue(lines, "OriginalCellId1", i));
    EXPECT_LT(cell0, cell1);
    for (const vtkIdType cell : { cell0, cell1 })
    {
      EXPECT_TRUE(CellHolds(sphere, cell, PointOf(lines, from)));
      EXPECT_TRUE(CellHolds(sphere, cell, PointOf(lines, to)));
    }
    EXPECT_EQ(CellValue(lines, "NumberOfCells", i), 2.0);
    // The line runs as the lit one of the two is wound, against the other.
    EXPECT_NE(isLit(cell0), isLit(cell1));
    EXPECT_EQ(CellValue(lines, "SignedMultiplicity", i), isLit(cell0) ? 2.0 : -2.0);
    for (const vtkIdType point : { from, to })
    {
      const auto original = static_cast<vtkIdType>(PointValue(lines, "OriginalPointIds", point));
      EXPECT_EQ(PointOf(lines, point), PointOf(sphere, original));
    }
  }
}

TEST(ShadowSilhouette, NumbersCellsAsPolyDataDoes)
{
  // All of it is flat and faces the light: the border of quad and strip, which share an edge.
  const auto lines = OutputOf(OneOfEachCell(), { 0.0, 0.0, 1.0, 0.0 }, Filter::ALL_FACES);
  std::multiset<int> cells;
  for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i)
  {
    cells.insert(static_cast<int>(CellValue(lines, "OriginalCellId0", i)));
    EXPECT_EQ(CellValue(lines, "OriginalCellId1", i), -1.0);
    EXPECT_EQ(CellValue(lines, "NumberOfCells", i), 1.0);
    EXPECT_EQ(CellValue(lines, "SignedMultiplicity", i), 1.0);
  }
  EXPECT_EQ(cells.count(2), 3u);
  EXPECT_EQ(cells.count(3), 4u);
  EXPECT_EQ(cells.size(), 7u);
}

TEST(ShadowSilhouette, CountsTheCellsOfAnEdgeThatManyShare)
{
  for (const int blades : { 3, 4, 5 })
  {
    const auto lines =
      OutputOf(ToPolyData(Fan(blades), VTK_DOUBLE), { 0.1, 0.9, 0.2, 0.0 }, Filter::ALL_FACES);
    double most = 0.0;
    for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i)
    {
      const double count = CellValue(lines, "NumberOfCells", i);
      most = std::max(most, count);
      if (count > 1.0)
      {
        EXPECT_EQ(CellValue(lines, "OriginalCellId0", i), 0.0);
        EXPECT_EQ(CellValue(lines, "OriginalCellId1", i), 1.0);
      }
    }
    // An even fan may cancel on the edge.
    EXPECT_TRUE(most == blades || (blades == 4 && most == 1.0)) << "got " << most;
  }
}

TEST(ShadowSilhouette, KeepsThePrecisionOfTheInput)
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const auto lines = OutputOf(ToPolyData(MoebiusStrip(), type), ObliqueLight, Filter::ALL_FACES);
    EXPECT_EQ(lines->GetPoints()->GetDataType(), type);
    const auto input = ToPolyData(MoebiusStrip(), type);
    for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
    {
      const auto original = static_cast<vtkIdType>(PointValue(lines, "OriginalPointIds", i));
      EXPECT_EQ(PointOf(lines, i), PointOf(input, original));
    }
  }
}

TEST(ShadowSilhouette, WeldedPointsHaveTheLowestIdOfThem)
{
  const auto input = ToPolyData(UnweldedCube(), VTK_DOUBLE);
  const auto lines = OutputOf(input, ObliqueLight, Filter::ALL_FACES);
  ASSERT_EQ(lines->GetNumberOfPoints(), 6);
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    vtkIdType lowest = 0;
    while (PointOf(input, lowest) != PointOf(lines, i))
    {
      ++lowest;
    }
    EXPECT_EQ(PointValue(lines, "OriginalPointIds", i), static_cast<double>(lowest));
  }
}
