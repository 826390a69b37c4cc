// In how many shadow volumes a receiver lies: exact, also where eight bits end. The counters that
// are kept for comparison are wrong where theory says so, and nowhere else.
#include "VolumeTest.h"

#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

using namespace shadowtest;

namespace
{

using Pass = vtkStencilShadowVolumePass;

// Squares of side 2 over each other, between z = 1 and z = 2.
vtkSmartPointer<vtkPolyData> Stack(int sheets)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  for (int i = 0; i < sheets; ++i)
  {
    const double z = 1.0 + double(i) / sheets;
    const vtkIdType base = points->InsertNextPoint(-1.0, -1.0, z);
    points->InsertNextPoint(1.0, -1.0, z);
    points->InsertNextPoint(1.0, 1.0, z);
    points->InsertNextPoint(-1.0, 1.0, z);
    // Turned this way and that.
    i % 3 ? polys->InsertNextCell({ base, base + 1, base + 2, base + 3 })
          : polys->InsertNextCell({ base, base + 3, base + 2, base + 1 });
  }
  auto stack = vtkSmartPointer<vtkPolyData>::New();
  stack->SetPoints(points);
  stack->SetPolys(polys);
  return stack;
}

// Under a stack of sheets: the floor in the middle of its shadow, and beside it.
class StencilVolumeCounts : public VolumeTest
{
protected:
  void SetUp() override
  {
    VolumeTest::SetUp();
    AddFloor(this->Renderer, 6.0);
    this->Stacked = AddActor(this->Renderer, Stack(1));
    this->Light = AddSun(this->Renderer, { 0.0, 0.0, -1.0 });
    // Below the sheets, so that none of them hides the floor.
    LookAt(this->Renderer, { 0.0, -7.0, 0.9 }, { 0.0, 0.0, 0.0 });
  }

  void SetSheets(int sheets)
  {
    this->Renderer->RemoveActor(this->Stacked);
    this->Stacked = AddActor(this->Renderer, Stack(sheets));
    this->Render();
  }

  // Values at places on the floor that lie in the shadow of all sheets, or of none.
  void CheckFloor(const std::string& what, const Visibility& values, double inside, double outside)
  {
    int places = 0, wrongInside = 0, wrongOutside = 0;
    for (double x = -2.0; x <= 2.0; x += 0.05)
    {
      for (double y = -2.0; y <= 2.0; y += 0.05)
      {
        const double reach = std::max(std::abs(x), std::abs(y));
        const Pixel p = PixelOf(this->Renderer, { x, y, 0.0 });
        if (std::abs(reach - 1.0) < 0.1 || p.x < 0 || p.y < 0 || p.x >= values.width ||
          p.y >= values.height)
        {
          continue;
        }
        ++places;
        wrongInside += reach < 1.0 && values.At(p.x, p.y) != inside ? 1 : 0;
        wrongOutside += reach > 1.0 && values.At(p.x, p.y) != outside ? 1 : 0;
      }
    }
    CheckAtLeast(what + ": places on the floor", places, 2000.0);
    Check(what + ": in the shadow, not " + std::to_string(inside), wrongInside, 0.0);
    Check(what + ": outside, not " + std::to_string(outside), wrongOutside, 0.0);
  }

  vtkSmartPointer<vtkActor> Stacked;
  vtkSmartPointer<vtkLight> Light;
};

}

//------------------------------------------------------------------------------
// What is counted in.
TEST_F(StencilVolumeCounts, CountsAreExactWhereEightBitsEnd)
{
  for (const int variant : { Pass::AUTOMATIC, Pass::Z_FAIL })
  {
    this->Volumes()->SetVariant(variant);
    for (const int sheets : { 1, 126, 127, 128, 254, 255, 256, 257, 300, 512 })
    {
      const std::string what =
        std::to_string(sheets) + (variant == Pass::Z_FAIL ? " sheets, z-fail" : " sheets");
      this->SetSheets(sheets);
      this->CheckFloor(what + ", counts", this->CountsOf(this->Light), sheets, 0.0);
      this->CheckFloor(what + ", mask", this->VisibilityOf(this->Light), 0.0, 1.0);
      // The stencil stops at 255 and says so.
      Check(what + ": counted again in floats",
        static_cast<double>(this->Volumes()->GetNumberOfOverflows()), sheets >= 255 ? 1.0 : 0.0);
    }
  }
}

TEST_F(StencilVolumeCounts, FloatsAreAlwaysRight)
{
  this->Volumes()->SetCounter(Pass::FLOAT_COUNTER);
  for (const int sheets : { 1, 127, 128, 255, 256, 257, 512 })
  {
    this->SetSheets(sheets);
    this->CheckFloor(std::to_string(sheets) + " sheets", this->VisibilityOf(this->Light), 0.0, 1.0);
    Check("overflows", static_cast<double>(this->Volumes()->GetNumberOfOverflows()), 0.0);
  }
}

// As documented: read as signed bytes, right up to 127 and blind to 256.
TEST_F(StencilVolumeCounts, WrappingStencilIsWrongFrom128On)
{
  this->Volumes()->SetCounter(Pass::WRAPPING_STENCIL);
  for (const int sheets : { 1, 126, 127, 128, 200, 256, 512 })
  {
    this->SetSheets(sheets);
    this->CheckFloor(std::to_string(sheets) + " sheets", this->VisibilityOf(this->Light),
      sheets <= 127 ? 0.0 : 1.0, 1.0);
  }
}

TEST_F(StencilVolumeCounts, OverlappingCastersAddUp)
{
  this->SetSheets(3);
  AddActor(this->Renderer, Stack(4))->SetPosition(0.0, 0.0, 1.5);
  this->Render();
  this->CheckFloor("3 and 4 sheets", this->CountsOf(this->Light), 7.0, 0.0);
  // Closed, and counted by its lit side alone.
  AddBox(this->Renderer, { -1.0, -1.0, 4.0 }, { 1.0, 1.0, 4.5 });
  this->Render();
  this->CheckFloor("and a box", this->CountsOf(this->Light), 8.0, 0.0);
  this->Volumes()->OneSidedClosedPiecesOff();
  this->Render();
  this->CheckFloor("and a box, both sides", this->CountsOf(this->Light), 9.0, 0.0);
}

TEST_F(StencilVolumeCounts, CountsAreOfVolumesAlone)
{
  this->Shadows->SetTechnique("depth-map");
  this->Render();
  vtkNew<vtkImageData> image;
  EXPECT_FALSE(this->Shadows->GetVolumeCounts(this->Renderer, this->Light, image));
  ExpectOneMessage({ "vtkShadowPass", "\"depth-map\"", "\"stencil-volume\"" });
  EXPECT_FALSE(this->Shadows->GetVolumeCounts(this->Renderer, this->Light, nullptr));
  ExpectOneMessage({ "vtkShadowPass", "vtkImageData" });
}
