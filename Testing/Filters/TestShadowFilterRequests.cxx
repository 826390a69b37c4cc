// Requests: what is done again and what is not, what is refused and how.
#include "FilterTest.h"

#include "vtkPlanarShadowFilter.h"
#include "vtkShadowSilhouetteFilter.h"
#include "vtkShadowVolumeFilter.h"

#include <vtkExecutive.h>
#include <vtkPoints.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <limits>
#include <sstream>

using namespace filtertest;

namespace
{

const double Infinite = std::numeric_limits<double>::infinity();
const double NaN = std::numeric_limits<double>::quiet_NaN();

// One error with all of `parts` in it, a request that fails, and an empty output.
void ExpectRefused(vtkShadowGeometryFilter* filter, const std::vector<std::string>& parts)
{
  Errors errors(filter);
  EXPECT_EQ(filter->GetExecutive()->Update(), 0);
  ASSERT_EQ(errors.Own.size(), 1u);
  std::cout << errors.Own[0].substr(errors.Own[0].find('\n') + 1); // without file and line
  for (const std::string& part : parts)
  {
    EXPECT_NE(errors.Own[0].find(part), std::string::npos) << "without \"" << part << '"';
  }
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

void ExpectFine(vtkShadowGeometryFilter* filter, bool isEmpty)
{
  Errors errors(filter);
  EXPECT_EQ(filter->GetExecutive()->Update(), 1);
  EXPECT_TRUE(errors.Own.empty() && errors.Executives.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells() == 0, isEmpty);
}

// Does it change the modification time? Once it must, and not again.
void ExpectModifiedOnce(vtkObject* object, const std::function<void()>& set)
{
  const vtkMTimeType before = object->GetMTime();
  set();
  const vtkMTimeType after = object->GetMTime();
  EXPECT_GT(after, before);
  set();
  EXPECT_EQ(object->GetMTime(), after);
}

using AllFilters = std::vector<vtkSmartPointer<vtkShadowGeometryFilter>>;
AllFilters MakeAll()
{
  // A plane that none of the lights here is beneath or in.
  const auto planar = vtkSmartPointer<vtkPlanarShadowFilter>::New();
  planar->SetPlaneOrigin(-1.0, 0.0, -1.0);
  planar->SetPlaneNormal(1.0, 0.0, 1.0);
  return { vtkSmartPointer<vtkShadowSilhouetteFilter>::New(),
    vtkSmartPointer<vtkShadowVolumeFilter>::New(), planar };
}

}

TEST(ShadowFilterRequests, ALightThatMovesLeavesTheMeshAsItIs)
{
  for (const auto& filter : MakeAll())
  {
    vtkNew<vtkSphereSource> sphere;
    filter->SetInputConnection(sphere->GetOutputPort());
    EXPECT_EQ(filter->GetNumberOfMeshBuilds(), 0);
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfMeshBuilds(), 1);
    const double before = filter->GetOutput()->GetNumberOfCells();
    for (int i = 0; i < 5; ++i)
    {
      filter->SetLightPosition(3.0 + i, 0.1, 0.2);
      filter->Update();
    }
    filter->SetCastingFacesToAll();
    filter->Update();
    EXPECT_NE(filter->GetOutput()->GetNumberOfCells(), 0);
    EXPECT_EQ(filter->GetNumberOfMeshBuilds(), 1);

    sphere->SetThetaResolution(20);
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfMeshBuilds(), 2);
    EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), before);
  }
}

TEST(ShadowFilterRequests, PointsThatAreEditedInPlaceAreSeen)
{
  const auto cube = ToPolyData(Cube(), VTK_DOUBLE);
  vtkNew<vtkShadowVolumeFilter> filter;
  filter->SetInputData(cube);
  filter->Update();
  const double before = SignedVolume(filter->GetOutput());
  cube->GetPoints()->SetPoint(7, 2.0, 2.0, 2.0);
  cube->GetPoints()->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfMeshBuilds(), 2);
  EXPECT_NE(SignedVolume(filter->GetOutput()), before);
}

TEST(ShadowFilterRequests, SettersCallModifiedOnlyOnChange)
{
  for (const auto& filter : MakeAll())
  {
    ExpectModifiedOnce(filter, [&] { filter->SetLight(1.0, 2.0, 3.0, 1.0); });
    ExpectModifiedOnce(filter, [&] { filter->SetLightPosition(1.0, 2.0, 4.0); });
    ExpectModifiedOnce(filter, [&] { filter->SetLightDirection(1.0, 2.0, 4.0); });
    ExpectModifiedOnce(filter, [&] { filter->SetCastingFacesToAll(); });
  }
  vtkNew<vtkShadowVolumeFilter> filter;
  ExpectModifiedOnce(filter, [&] { filter->SetExtentModeToLength(); });
  ExpectModifiedOnce(filter, [&] { filter->SetLength(3.0); });
  ExpectModifiedOnce(filter, [&] { filter->SetBounds(0.0, 1.0, 0.0, 1.0, 0.0, 1.0); });
  vtkNew<vtkPlanarShadowFilter> planar;
  ExpectModifiedOnce(planar, [&] { planar->SetPlaneOrigin(0.0, 1.0, 0.0); });
  ExpectModifiedOnce(planar, [&] { planar->SetPlaneNormal(0.0, 1.0, 0.0); });
  ExpectModifiedOnce(planar, [&] { planar->SetBounds(0.0, 1.0, 0.0, 1.0, 0.0, 1.0); });
  ExpectModifiedOnce(planar, [&] { planar->SetOutputModeToOutline(); });
  ExpectModifiedOnce(planar, [&] { planar->ComputeAreaOff(); });
}

TEST(ShadowFilterRequests, ALightIsAPositionOrADirectionOfTravel)
{
  vtkNew<vtkShadowVolumeFilter> filter;
  filter->SetLightDirection(1.0, 0.0, -2.0);
  const double expected[] = { -1.0, 0.0, 2.0, 0.0 };
  EXPECT_TRUE(std::equal(expected, expected + 4, filter->GetLight()));
  const double position[] = { 1.0, 2.0, 3.0 };
  filter->SetLightPosition(position);
  EXPECT_EQ(filter->GetLight()[2], 3.0);
  EXPECT_EQ(filter->GetLight()[3], 1.0);

  // Scaled positions, and directions of any length, are the same light.
  filter->SetInputData(UnitSphere(16));
  filter->SetExtentModeToLength();
  const auto volumeFor = [&](double x, double y, double z, double w)
  {
    filter->SetLight(x, y, z, w);
    filter->Update();
    return SignedVolume(filter->GetOutput());
  };
  EXPECT_EQ(volumeFor(2.0, 1.0, 3.0, 1.0), volumeFor(4.0, 2.0, 6.0, 2.0));
  const double once = volumeFor(0.0, 3.0, 4.0, 0.0);
  EXPECT_NEAR(volumeFor(0.0, 3e-300, 4e-300, 0.0), once, 1e-12 * once);
  EXPECT_NEAR(volumeFor(0.0, 3e300, 4e300, 0.0), once, 1e-12 * once);
}

TEST(ShadowFilterRequests, WhatIsNoLightIsRefused)
{
  const double lights[][4] = { { 0.0, 0.0, 0.0, 0.0 }, { 1.0, 2.0, 3.0, -1.0 },
    { NaN, 0.0, 0.0, 1.0 }, { 0.0, Infinite, 0.0, 1.0 }, { 0.0, 0.0, NaN, 0.0 },
    { Infinite, 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0, NaN }, { 1.0, 0.0, 0.0, Infinite },
    { 1e300, 0.0, 0.0, 1e-300 } };
  for (const auto& filter : MakeAll())
  {
    filter->SetInputData(UnitSphere(8));
    for (const auto& light : lights)
    {
      std::ostringstream value;
      value << "Light (" << light[0] << ", " << light[1] << ", " << light[2] << ", " << light[3];
      filter->SetLight(light[0], light[1], light[2], light[3]);
      ExpectRefused(filter, { value.str(), "w = 1", "w = 0" });
    }
    filter->SetLight(0.0, 0.0, 5.0, 1.0);
    ExpectFine(filter, false);
  }
}

TEST(ShadowFilterRequests, PointsThatAreNotFiniteAreRefusedByName)
{
  for (const double bad : { NaN, Infinite, -Infinite })
  {
    for (const auto& filter : MakeAll())
    {
      const auto mesh = ToPolyData(OpenStrip(), VTK_FLOAT);
      mesh->GetPoints()->SetPoint(6, 0.0, bad, 0.0);
      filter->SetInputData(mesh);
      ExpectRefused(filter, { "Point 6 (0, ", "not finite", "remove the faces" });

      // Repaired, it works; and so it does where no face uses the point.
      mesh->GetPoints()->SetPoint(6, 0.0, 0.5, 0.0);
      mesh->GetPoints()->InsertNextPoint(bad, bad, bad);
      mesh->GetPoints()->Modified();
      ExpectFine(filter, false);
    }
  }
}

TEST(ShadowFilterRequests, FacesWithoutTheirPointsAreRefused)
{
  for (const auto& filter : MakeAll())
  {
    auto mesh = ToPolyData(OpenStrip(), VTK_FLOAT);
    vtkNew<vtkPoints> fewer;
    fewer->InsertNextPoint(0.0, 0.0, 0.0);
    mesh->SetPoints(fewer);
    filter->SetInputData(mesh);
    ExpectRefused(filter, { "Cell 0 names point 2", "1 points" });
  }
}

TEST(ShadowFilterRequests, ExtentsThatCannotBeAreRefused)
{
  vtkNew<vtkShadowVolumeFilter> filter;
  filter->SetInputData(UnitSphere(8));
  filter->SetExtentModeToLength();
  for (const double length : { 0.0, -1.0, NaN, Infinite })
  {
    std::ostringstream value;
    value << "Length " << length;
    filter->SetLength(length);
    ExpectRefused(filter, { value.str(), "above 0" });
  }
  filter->SetExtentModeToBounds();
  ExpectFine(filter, false); // Length is not asked
  filter->SetBounds(0.0, 1.0, 2.0, 1.0, 0.0, 1.0);
  ExpectRefused(filter, { "Bounds (0, 1, 2, 1, 0, 1)", "minimum" });
  filter->SetBounds(0.0, Infinite, 0.0, 1.0, 0.0, 1.0);
  ExpectRefused(filter, { "Bounds (0, inf", "finite" });
  filter->SetExtentModeToInfinite();
  ExpectFine(filter, false);
}

TEST(ShadowFilterRequests, PlanesThatCannotBeAreRefused)
{
  vtkNew<vtkPlanarShadowFilter> filter;
  filter->SetInputData(UnitSphere(8));
  for (const double bad : { 0.0, NaN, Infinite })
  {
    std::ostringstream value;
    value << "PlaneNormal (0, " << bad << ", 0)";
    filter->SetPlaneNormal(0.0, bad, 0.0);
    ExpectRefused(filter, { value.str(), "not all 0" });
  }
  filter->SetPlaneNormal(0.0, 0.0, 1e-200);
  ExpectFine(filter, false);
  filter->SetPlaneOrigin(NaN, 0.0, 0.0);
  ExpectRefused(filter, { "PlaneOrigin (nan, 0, 0)", "finite" });
  filter->SetPlaneOrigin(0.0, 0.0, 0.0);
  filter->SetBounds(0.0, 1.0, 2.0, 1.0, 0.0, 1.0);
  ExpectRefused(filter, { "Bounds (0, 1, 2, 1, 0, 1)", "for no bounds" });
  filter->SetBounds(0.0, 1.0, 0.0, NaN, 0.0, 1.0);
  ExpectRefused(filter, { "Bounds (0, 1, 0, nan", "finite" });
  filter->SetBounds(2.0, -2.0, 2.0, -2.0, 2.0, -2.0);
  ExpectFine(filter, false);
}

TEST(ShadowFilterRequests, NothingMakesNothing)
{
  vtkNew<vtkPolyData> nothing;
  const auto onlyALine = OneOfEachCell();
  onlyALine->SetPolys(nullptr);
  onlyALine->SetStrips(nullptr);
  const auto repeats =
    ToPolyData({ "", { { 0, 0, 0 }, { 1, 0, 0 } }, { { 0, 1, 0 } } }, VTK_DOUBLE);
  for (const auto& mesh : { vtkSmartPointer<vtkPolyData>(nothing), onlyALine, repeats })
  {
    for (const auto& filter : MakeAll())
    {
      filter->SetInputData(mesh);
      ExpectFine(filter, true);
    }
    vtkNew<vtkShadowVolumeFilter> filter;
    filter->SetInputData(mesh);
    filter->SetLightPosition(0.0, 0.0, 1.0);
    for (const int mode : { 0, 1, 2 })
    {
      filter->SetExtentMode(mode);
      ExpectFine(filter, true);
      EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    }
  }
}

TEST(ShadowFilterRequests, PrintsItsSettings)
{
  vtkNew<vtkShadowVolumeFilter> filter;
  std::ostringstream printed;
  filter->Print(printed);
  for (const char* part : { "Light: (0, 0, 1, 0)", "CastingFaces: CLOSED_FACES",
         "NumberOfMeshBuilds: 0", "ExtentMode: BOUNDS_EXTENT", "Length: 1", "Bounds: (1, -1, 1" })
  {
    EXPECT_NE(printed.str().find(part), std::string::npos) << part;
  }
  vtkNew<vtkPlanarShadowFilter> planar;
  std::ostringstream planarPrinted;
  planar->Print(planarPrinted);
  for (const char* part : { "Light: (0, 0, 1, 0)", "PlaneOrigin: (0, 0, 0)",
         "PlaneNormal: (0, 0, 1)", "Bounds: (1, -1, 1", "OutputMode: POLYGONS", "ComputeArea: on" })
  {
    EXPECT_NE(planarPrinted.str().find(part), std::string::npos) << part;
  }
}
