// Object-ID maps: against the truth and beside the depth map, what an object is, what a texel
// holds, when maps are drawn.
#include "ShadowTest.h"
#include "TestScenes.h"

#include "vtkObjectIDShadowPass.h"
#include "vtkShadowErrorMeasure.h"

#include <vtkAppendPolyData.h>
#include <vtkCompositePolyDataMapper2.h>
#include <vtkCubeSource.h>
#include <vtkGlyph3DMapper.h>
#include <vtkIntArray.h>
#include <vtkLightCollection.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

using namespace shadowtest;

namespace
{

struct Error
{
  double mismatch = 0.0; // percent of the receiver pixels
  double gross = 0.0;    // pixels
  double receivers = 0.0;
  double shadow = 0.0;
};

class ObjectIDs : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Renderer->SetPass(this->Shadows);
    this->Shadows->SetTechnique("object-id");
  }

  vtkObjectIDShadowPass* Maps() { return this->Shadows->GetObjectIDShadowPass(); }

  Error ErrorOf(const std::string& what, const std::string& technique, vtkLight* light)
  {
    this->Shadows->SetTechnique(technique);
    this->Render();
    vtkNew<vtkShadowErrorMeasure> error;
    EXPECT_TRUE(error->Measure(this->Renderer, light)) << what;
    Error found;
    found.mismatch = error->GetMismatchPercent();
    found.gross = static_cast<double>(error->GetGrossFalsePixels() + error->GetGrossMissedPixels());
    found.receivers = static_cast<double>(error->GetReceiverPixels());
    found.shadow = static_cast<double>(error->GetShadowPixels());
    std::printf("%-34s %-10s mismatch %.4f %% gross %lld false, %lld missed of %.0f\n",
      what.c_str(), technique.c_str(), found.mismatch,
      static_cast<long long>(error->GetGrossFalsePixels()),
      static_cast<long long>(error->GetGrossMissedPixels()), found.receivers);
    EXPECT_GT(found.shadow, found.receivers / 100) << what << ": few shadows";
    return found;
  }

  // At the default settings no grosser than the depth map, 16 bits as good as 32; what 8 bits lose
  // is printed.
  void CheckBesideDepthMap(const std::string& what)
  {
    this->Renderer->GetLights()->InitTraversal();
    int index = 0;
    while (vtkLight* light = this->Renderer->GetLights()->GetNextItem())
    {
      const std::string row = what + ", light " + std::to_string(index++);
      const Error byDepth = this->ErrorOf(row, "depth-map", light);
      Error byBits[4];
      const int bits[] = { 8, 16, 24, 32 };
      for (int i = 0; i < 4; ++i)
      {
        this->Maps()->SetDepthBits(bits[i]);
        byBits[i] =
          this->ErrorOf(row + ", " + std::to_string(bits[i]) + " bits", "object-id", light);
      }
      this->Maps()->SetDepthBits(16);
      CheckAtMost(row + ": gross px, beside the depth map's", byBits[1].gross, byDepth.gross);
      CheckAtMost(row + ": mismatch at 16 bits, beside 1.5 times that at 32", byBits[1].mismatch,
        1.5 * byBits[3].mismatch);
      CheckAtMost(row + ": gross at 16 bits, beside 1.5 times that at 32", byBits[1].gross,
        1.5 * byBits[3].gross);
      CheckAtMost(row + ": mismatch, beside 1.1 times the depth map's", byBits[1].mismatch,
        1.1 * byDepth.mismatch);
    }
  }
};

}

TEST_F(ObjectIDs, StillLifeWithASpot)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(1024, 768);
  const Subject subject = AddStillLife(this->Renderer);
  AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0);
  AimCamera(this->Renderer, subject, -15.0, 28.0, 1024, 768);
  this->CheckBesideDepthMap("still life");
}

TEST_F(ObjectIDs, BumpyMeshWithASun)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(1024, 768);
  const Subject subject = AddBumpyMesh(this->Renderer);
  AddSun(this->Renderer, -Toward(60.0, 40.0));
  AimCamera(this->Renderer, subject, 10.0, 20.0, 1024, 768);
  this->CheckBesideDepthMap("bumpy mesh");
}

TEST_F(ObjectIDs, TubesAndGlyphsWithTwoLights)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(1024, 768);
  const Subject subject = AddTubesAndGlyphs(this->Renderer);
  AddSpot(this->Renderer, { 4.0, -3.0, 7.0 }, { 0.0, 0.0, 0.8 }, 30.0);
  AddSun(this->Renderer, -Toward(-50.0, 50.0));
  AimCamera(this->Renderer, subject, 5.0, 25.0, 1024, 768);
  this->CheckBesideDepthMap("tubes and glyphs");
}
