// Planar shadows as polydata: polygons and outlines on the plane, where they came from, their area,
// and what is said of shadows without an end.
#include "FilterTest.h"

#include "vtkPlanarShadowFilter.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkPointData.h>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace filtertest;

namespace
{

using Filter = vtkPlanarShadowFilter;

const glm::dvec3 Oblique = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
const glm::dvec4 ObliqueLight(Oblique, 0.0), NearLight(2.7, -3.1, 9.3, 1.0);
const glm::dvec3 Origin(0.3, 0.2, -4.0), Normal(0.2, -0.1, 3.0);

vtkSmartPointer<Filter> MakeFilter(vtkPolyData* mesh, const glm::dvec4& light)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(mesh);
  filter->SetLight(light.x, light.y, light.z, light.w);
  filter->SetPlaneOrigin(Origin.x, Origin.y, Origin.z);
  filter->SetPlaneNormal(Normal.x, Normal.y, Normal.z);
  return filter;
}

vtkSmartPointer<vtkPolyData> OutputOf(Filter* filter)
{
  filter->Update();
  return filter->GetOutput();
}

double FieldValue(vtkPolyData* data, const char* name, int component = 0)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfTuples() != 1 || component >= array->GetNumberOfComponents())
  {
    ADD_FAILURE() << "there is no such field: " << name << ", " << component;
    return 0.0;
  }
  return array->GetComponent(0, component);
}

// Where the plane meets the line from the light through p.
glm::dvec3 ImageOf(const glm::dvec3& p, const glm::dvec4& light)
{
  const glm::dvec3 way = light.w == 0.0 ? -glm::dvec3(light) : p - glm::dvec3(light);
  return p + glm::dot(Normal, Origin - p) / glm::dot(Normal, way) * way;
}

// Twice the area of a cell, seen from the plane's normal.
double TwiceAreaOf(vtkPolyData* data, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  data->GetCellPoints(cell, ids);
  glm::dvec3 sum(0.0);
  const glm::dvec3 first = PointOf(data, ids->GetId(0));
  for (vtkIdType i = 1; i + 1 < ids->GetNumberOfIds(); ++i)
  {
    sum +=
      glm::cross(PointOf(data, ids->GetId(i)) - first, PointOf(data, ids->GetId(i + 1)) - first);
  }
  return glm::dot(sum, glm::normalize(Normal));
}

}

TEST(PlanarShadow, PolygonsAreThePointsThrownOnThePlane)
{
  for (const NamedMesh& mesh : SourceMeshes())
  {
    for (const glm::dvec4& light : { ObliqueLight, NearLight })
    {
      const auto filter = MakeFilter(mesh.mesh, light);
      filter->SetCastingFacesToAll();
      const auto shadow = OutputOf(filter);
      ASSERT_GT(shadow->GetNumberOfCells(), 0) << mesh.name;
      EXPECT_EQ(shadow->GetNumberOfCells(), shadow->GetNumberOfPolys());
      EXPECT_EQ(shadow->GetPoints()->GetDataType(), VTK_DOUBLE);
      vtkIdType last = 0;
      double sum = 0.0;
      for (vtkIdType cell = 0; cell < shadow->GetNumberOfCells(); ++cell)
      {
        const auto original = static_cast<vtkIdType>(CellValue(shadow, "OriginalCellIds", cell));
        EXPECT_GE(original, last);
        last = original;
        vtkNew<vtkIdList> ids;
        shadow->GetCellPoints(cell, ids);
        for (const vtkIdType id : *ids)
        {
          const auto point = static_cast<vtkIdType>(PointValue(shadow, "OriginalPointIds", id));
          const glm::dvec3 p = PointOf(mesh.mesh, point);
          EXPECT_TRUE(CellHolds(mesh.mesh, original, p)) << mesh.name;
          EXPECT_LT(glm::distance(PointOf(shadow, id), ImageOf(p, light)), 1e-12) << mesh.name;
        }
        EXPECT_GT(TwiceAreaOf(shadow, cell), 0.0) << mesh.name;
        sum += 0.5 * TwiceAreaOf(shadow, cell);
      }
      const double area = FieldValue(shadow, "ShadowArea");
      EXPECT_GT(area, 0.0);
      EXPECT_LE(area, sum * (1.0 + 1e-12)) << mesh.name;
      EXPECT_EQ(FieldValue(shadow, "ShadowIsCut"), 0.0);
      EXPECT_FALSE(shadow->GetFieldData()->GetArray("ShadowBounds"));
    }
  }
}

TEST(PlanarShadow, OfAConvexBodyIsCoveredOnce)
{
  // The faces toward the light throw its whole shadow, and do not overlap.
  for (const auto& mesh :
    { ToPolyData(Cube(), VTK_DOUBLE), UnitSphere(32), ToPolyData(Tetrahedron(), VTK_FLOAT) })
  {
    for (const glm::dvec4& light : { ObliqueLight, NearLight })
    {
      const auto shadow = OutputOf(MakeFilter(mesh, light));
      double sum = 0.0;
      for (vtkIdType cell = 0; cell < shadow->GetNumberOfCells(); ++cell)
      {
        sum += 0.5 * TwiceAreaOf(shadow, cell);
      }
      const double got = FieldValue(shadow, "ShadowArea");
      std::cout << "area: got " << got << ", expected " << sum << ", tolerance 1e-12\n";
      EXPECT_NEAR(got, sum, 1e-12 * sum);
    }
  }
}

TEST(PlanarShadow, OutlinesBoundTheArea)
{
  for (const NamedMesh& mesh : AllMeshes())
  {
    if (mesh.name == "large soup")
    {
      continue; // as the other soups, but slow
    }
    for (const glm::dvec4& light : { ObliqueLight, NearLight })
    {
      const auto filter = MakeFilter(mesh.mesh, light);
      const double area = FieldValue(OutputOf(filter), "ShadowArea");
      filter->SetOutputModeToOutline();
      const auto outline = OutputOf(filter);
      EXPECT_EQ(outline->GetNumberOfCells(), outline->GetNumberOfLines());
      double sum = 0.0, byPoints = 0.0;
      for (vtkIdType cell = 0; cell < outline->GetNumberOfCells(); ++cell)
      {
        vtkNew<vtkIdList> ids;
        outline->GetCellPoints(cell, ids);
        EXPECT_GE(ids->GetNumberOfIds(), 4);
        EXPECT_EQ(ids->GetId(0), ids->GetId(ids->GetNumberOfIds() - 1));
        sum += CellValue(outline, "LoopArea", cell);
        byPoints += 0.5 * TwiceAreaOf(outline, cell);
      }
      EXPECT_NEAR(sum, area, 1e-12 * area) << mesh.name;
      EXPECT_NEAR(byPoints, area, 1e-11 * area) << mesh.name;
      for (vtkIdType i = 0; i < outline->GetNumberOfPoints(); ++i)
      {
        const auto point = static_cast<vtkIdType>(PointValue(outline, "OriginalPointIds", i));
        EXPECT_LT(std::abs(glm::dot(PointOf(outline, i) - Origin, Normal)), 1e-12);
        if (point >= 0)
        {
          const glm::dvec3 image = ImageOf(PointOf(mesh.mesh, point), light);
          EXPECT_LT(glm::distance(PointOf(outline, i), image), 1e-12) << mesh.name;
        }
      }
    }
  }
}

TEST(PlanarShadow, OfADiscIsItsPolygon)
{
  // A fan of 100 sides, 2 above the plane and 5 beneath the light.
  TestMesh disc{ "disc", { { 0.0, 0.0, 2.0 } }, {} };
  const int sides = 100;
  const double step = 2.0 * std::acos(-1.0) / sides;
  for (int i = 0; i < sides; ++i)
  {
    disc.points.emplace_back(std::cos(i * step), std::sin(i * step), 2.0);
    disc.triangles.emplace_back(0, 1 + i, 1 + (i + 1) % sides);
  }
  const auto filter = MakeFilter(ToPolyData(disc, VTK_DOUBLE), { 3.0, 2.0, 7.0, 1.0 });
  filter->SetPlaneOrigin(0.0, 0.0, 0.0);
  filter->SetPlaneNormal(0.0, 0.0, -2.0);
  const auto shadow = OutputOf(filter);
  const double got = FieldValue(shadow, "ShadowArea");
  const double expected = 0.5 * sides * std::sin(step) * 7.0 / 5.0 * 7.0 / 5.0;
  std::cout << "area: got " << got << ", expected " << expected << ", tolerance 1e-12\n";
  EXPECT_NEAR(got, expected, 1e-12 * expected);
  EXPECT_EQ(FieldValue(shadow, "ShadowPlaneNormal", 2), 1.0); // to the light's side
  EXPECT_EQ(FieldValue(shadow, "ShadowPlaneOrigin", 2), 0.0);
  EXPECT_EQ(FieldValue(shadow, "ShadowLight", 2), 7.0);
  EXPECT_EQ(FieldValue(shadow, "ShadowLight", 3), 1.0);
}

TEST(PlanarShadow, AreaCanBeLeftOut)
{
  const auto filter = MakeFilter(UnitSphere(8), ObliqueLight);
  filter->ComputeAreaOff();
  EXPECT_FALSE(OutputOf(filter)->GetFieldData()->GetArray("ShadowArea"));
  filter->SetOutputModeToOutline();
  EXPECT_GT(FieldValue(OutputOf(filter), "ShadowArea"), 0.0);
}

TEST(PlanarShadow, CutPointsAreNoOriginalOnes)
{
  const auto filter = MakeFilter(UnitSphere(16), ObliqueLight);
  filter->SetPlaneOrigin(0.0, 0.0, 0.0); // through its middle
  const auto shadow = OutputOf(filter);
  vtkDataArray* ids = shadow->GetPointData()->GetArray("OriginalPointIds");
  ASSERT_TRUE(ids);
  EXPECT_EQ(ids->GetRange()[0], -1.0);
  EXPECT_GT(ids->GetRange()[1], 0.0);
  EXPECT_EQ(FieldValue(shadow, "ShadowIsCut"), 0.0);
}

TEST(PlanarShadow, WithoutAnEndIsCutWithAWarning)
{
  const auto filter = MakeFilter(UnitSphere(16), { 3.0, 0.0, 0.2, 1.0 });
  Errors errors(filter);
  const auto shadow = OutputOf(filter);
  ASSERT_EQ(errors.Warnings.size(), 1u);
  EXPECT_NE(errors.Warnings[0].find("set Bounds"), std::string::npos) << errors.Warnings[0];
  EXPECT_EQ(FieldValue(shadow, "ShadowIsCut"), 1.0);
  double bounds[6];
  shadow->GetBounds(bounds);
  for (int i = 0; i < 6; ++i)
  {
    const double limit = FieldValue(shadow, "ShadowBounds", i);
    EXPECT_GE((i % 2 ? limit - bounds[i] : bounds[i] - limit), -1e-6);
  }
  EXPECT_GT(bounds[1] - bounds[0], 1000.0);

  // With bounds of one's own there is none.
  errors.Warnings.clear();
  filter->SetBounds(-50.0, 50.0, -50.0, 50.0, -50.0, 50.0);
  EXPECT_EQ(FieldValue(OutputOf(filter), "ShadowIsCut"), 1.0);
  EXPECT_EQ(FieldValue(shadow, "ShadowBounds", 5), 50.0);
  EXPECT_TRUE(errors.Warnings.empty() && errors.Own.empty());
}

TEST(PlanarShadow, OfALightInThePlaneIsEmptyWithAWarning)
{
  for (const glm::dvec4& light :
    { glm::dvec4(1.0, 0.0, 0.0, 0.0), glm::dvec4(9.0, 0.0, -4.0, 1.0) })
  {
    const auto filter = MakeFilter(UnitSphere(16), light);
    filter->SetPlaneNormal(0.0, 0.0, 1.0);
    Errors errors(filter);
    const auto shadow = OutputOf(filter);
    ASSERT_EQ(errors.Warnings.size(), 1u);
    EXPECT_NE(errors.Warnings[0].find("lies in the plane"), std::string::npos);
    EXPECT_TRUE(errors.Own.empty());
    EXPECT_EQ(shadow->GetNumberOfCells(), 0);
    EXPECT_EQ(FieldValue(shadow, "ShadowArea"), 0.0);
  }
}
