#include "VolumeTest.h"

#include "vtkShadowErrorMeasure.h"

#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cstdio>

namespace shadowtest
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ToPolyData(const TestMesh& mesh)
{
  vtkNew<vtkPoints> points;
  for (const glm::dvec3& p : mesh.points)
  {
    points->InsertNextPoint(p.x, p.y, p.z);
  }
  vtkNew<vtkCellArray> polys;
  for (const glm::uvec3& t : mesh.triangles)
  {
    polys->InsertNextCell({ vtkIdType(t.x), vtkIdType(t.y), vtkIdType(t.z) });
  }
  auto out = vtkSmartPointer<vtkPolyData>::New();
  out->SetPoints(points);
  out->SetPolys(polys);
  return out;
}

//------------------------------------------------------------------------------
void VolumeTest::SetUp()
{
  ShadowTest::SetUp();
  this->Resize(320, 240);
  this->Shadows->SetTechnique("stencil-volume");
  this->Renderer->SetPass(this->Shadows);
}

//------------------------------------------------------------------------------
double VolumeTest::CheckTruthIfAny(
  const std::string& what, vtkLight* light, double mismatchPercent, double grossPixels)
{
  this->Render();
  vtkNew<vtkShadowErrorMeasure> error;
  EXPECT_TRUE(error->Measure(this->Renderer, light)) << what;
  this->SumOfMismatches += error->GetMismatchPercent();
  ++this->Cases;
  std::printf("  %-36s receivers %6lld shadow %6lld left out %4lld | mismatch %.4f %% (at most "
              "%.3f), gross %lld false %lld missed (at most %.0f)\n",
    what.c_str(), static_cast<long long>(error->GetReceiverPixels()),
    static_cast<long long>(error->GetShadowPixels()),
    static_cast<long long>(error->GetUncertainPixels()), error->GetMismatchPercent(),
    mismatchPercent, static_cast<long long>(error->GetGrossFalsePixels()),
    static_cast<long long>(error->GetGrossMissedPixels()), grossPixels);
  EXPECT_LE(error->GetMismatchPercent(), mismatchPercent) << what << ": mismatch %";
  EXPECT_LE(static_cast<double>(error->GetGrossPixels()), grossPixels) << what << ": gross pixels";
  return static_cast<double>(error->GetShadowPixels());
}

void VolumeTest::CheckTruth(
  const std::string& what, vtkLight* light, double mismatchPercent, double grossPixels)
{
  EXPECT_GT(this->CheckTruthIfAny(what, light, mismatchPercent, grossPixels), 0.0)
    << what << ": no shadow is seen";
}

void VolumeTest::CheckMeanMismatch(double percent)
{
  ASSERT_GT(this->Cases, 0);
  CheckAtMost("mean mismatch % over " + std::to_string(this->Cases) + " cases",
    this->SumOfMismatches / this->Cases, percent);
}

//------------------------------------------------------------------------------
std::size_t VolumeTest::CountChanged(vtkLight* light, const std::function<void()>& change)
{
  this->Render();
  const Visibility before = this->VisibilityOf(light);
  EXPECT_GT(before.CountShadowed(), 0u) << "no shadow to compare";
  change();
  this->Render();
  return CountDifferent(before, this->VisibilityOf(light));
}

//------------------------------------------------------------------------------
Visibility VolumeTest::CountsOf(vtkLight* light)
{
  Visibility counts;
  vtkNew<vtkImageData> image;
  const bool made = this->Shadows->GetVolumeCounts(this->Renderer, light, image);
  EXPECT_TRUE(made) << "no counts";
  if (made)
  {
    counts.width = image->GetDimensions()[0];
    counts.height = image->GetDimensions()[1];
    const auto* values = static_cast<float*>(image->GetScalarPointer());
    counts.values.assign(values, values + image->GetNumberOfPoints());
  }
  return counts;
}

//------------------------------------------------------------------------------
void CasterTest::SetUp()
{
  VolumeTest::SetUp();
  this->Floor = AddFloor(this->Renderer, 5.0);
  this->Sun = AddSun(this->Renderer, { 0.4, 0.5, -1.0 });
  this->Lamp = AddLamp(this->Renderer, { 2.0, -3.0, 6.0 });
  LookAt(this->Renderer, { 1.0, -7.0, 5.0 }, { 0.0, 0.2, 0.8 });
}

vtkSmartPointer<vtkActor> CasterTest::AddThing()
{
  auto thing = AddActor(this->Renderer, Thing());
  thing->SetPosition(0.0, 0.0, 1.3);
  return thing;
}

vtkSmartPointer<vtkPolyData> CasterTest::Thing()
{
  TestMesh thing = Torus(24, 12);
  Append(thing, Tetrahedron(), { 0.9, 0.2, 0.3 });
  Append(thing, OpenStrip(), { -0.6, -0.5, 0.1 });
  return ToPolyData(thing);
}

}
