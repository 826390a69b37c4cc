// What only a picture can show: whole frames, held against Testing/Baseline by VTK's own
// comparison. What was drawn is left in the build's folder, beside the difference where there is
// one; look at it before you make it the new baseline.
#include "ShadowTest.h"
#include "TestScenes.h"

#include "vtkPlanarShadowPass.h"
#include "vtkShadowTexturePass.h"

#include <vtkActorCollection.h>
#include <vtkImageData.h>
#include <vtkImageDifference.h>
#include <vtkImageShiftScale.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkTexture.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

using namespace shadowtest;

namespace
{

// VTK's own measure, which forgives edges a pixel or two off. Differences of a pixel's red, green
// and blue of up to 15 together are not counted (VTK's default of 105 is blind to a shadow 10 % too
// light); of what is, a sum of 10 is what VTK's tests call the same picture.
constexpr int Uncounted = 15;
constexpr double MostDifference = 10.0;

std::string FolderOf(const char* variable)
{
  const char* folder = std::getenv(variable);
  return folder ? folder : ".";
}

class Regression : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Renderer->SetBackground(0.95, 0.95, 0.97);
    const Subject subject = AddStillLife(this->Renderer);
    AimCamera(this->Renderer, subject, -15.0, 28.0, 400, 300);
    this->Renderer->SetPass(this->Shadows);
  }

  // A dim light at the eye, so that shadows are not black.
  void AddFillLight()
  {
    auto fill = AddSun(this->Renderer, { 0.0, 0.0, -1.0 });
    fill->SetLightTypeToHeadlight();
    fill->SetIntensity(0.25);
  }

  void CheckPicture(const std::string& name);
};

void Regression::CheckPicture(const std::string& name)
{
  const std::string drawn = FolderOf("VTKSHADOWS_TEST_OUTPUT") + "/" + name + ".png";
  const std::string baseline = FolderOf("VTKSHADOWS_TEST_BASELINE") + "/" + name + ".png";
  const std::string unlike = FolderOf("VTKSHADOWS_TEST_OUTPUT") + "/" + name + ".diff.png";
  WritePng(this->Render(), drawn);
  std::remove(unlike.c_str());
  ASSERT_TRUE(std::ifstream(baseline))
    << "no baseline " << baseline << "; what was drawn is " << drawn;

  vtkNew<vtkPNGReader> got, expected;
  got->SetFileName(drawn.c_str());
  expected->SetFileName(baseline.c_str());
  vtkNew<vtkImageDifference> difference;
  difference->SetInputConnection(got->GetOutputPort());
  difference->SetImageConnection(expected->GetOutputPort());
  difference->SetThreshold(Uncounted);
  difference->Update();
  const double error = difference->GetThresholdedError();
  if (!CheckAtMost(name + ": difference, as vtkImageDifference has it", error, MostDifference))
  {
    vtkNew<vtkImageShiftScale> stronger;
    stronger->SetInputConnection(difference->GetOutputPort());
    stronger->SetScale(10.0);
    stronger->ClampOverflowOn();
    stronger->SetOutputScalarTypeToUnsignedChar();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(stronger->GetOutputPort());
    writer->SetFileName(unlike.c_str());
    writer->Write();
  }
}

}

TEST_F(Regression, StillLifeByDepthMap)
{
  AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0);
  this->AddFillLight();
  this->CheckPicture("StillLifeByDepthMap");
}

TEST_F(Regression, StillLifeByObjectID)
{
  AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0);
  this->AddFillLight();
  this->Shadows->SetTechnique("object-id");
  this->CheckPicture("StillLifeByObjectID");
}

TEST_F(Regression, StillLifeByRayCast)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0);
  this->AddFillLight();
  this->Shadows->SetTechnique("ray-cast");
  this->CheckPicture("StillLifeByRayCast");
}

TEST_F(Regression, StillLifeByStencilVolume)
{
  AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0);
  this->AddFillLight();
  this->Shadows->SetTechnique("stencil-volume");
  this->CheckPicture("StillLifeByStencilVolume");
}

TEST_F(Regression, StillLifeByPlanar)
{
  auto spot = AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0);
  this->AddFillLight();
  this->Shadows->SetTechnique("planar");
  this->CheckPicture("StillLifeByPlanar");
  this->Shadows->SetLightRadius(spot, 0.4);
  this->CheckPicture("StillLifeByPlanarSamples");
  this->Shadows->GetPlanarShadowPass()->SetSoftMethod(vtkPlanarShadowPass::OFFSET_PLANES);
  this->CheckPicture("StillLifeByPlanarOffsets");
  this->Shadows->GetPlanarShadowPass()->SetSoftMethod(vtkPlanarShadowPass::PLATEAUS);
  this->CheckPicture("StillLifeByPlanarPlateaus");
}

// Bodies cast, the floor alone receives; then each body receives from the others, too; then soft.
TEST_F(Regression, StillLifeByShadowTexture)
{
  auto spot = AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0);
  this->AddFillLight();
  this->Shadows->SetTechnique("shadow-texture");
  this->CheckPicture("StillLifeByShadowTexture");
  this->Shadows->GetShadowTexturePass()->TexturePerCasterOn();
  this->CheckPicture("StillLifeByShadowTextures");
  this->Shadows->SetLightRadius(spot, 0.4);
  this->CheckPicture("StillLifeBySoftShadowTextures");
}

// The views that explain it. The eye stands in the shadow of a box that it does not see: one volume
// is counted behind the receiver.
TEST_F(Regression, DebugViews)
{
  const glm::dvec3 toward = Toward(65.0, 30.0);
  AddSun(this->Renderer, -toward)->SetIntensity(0.8);
  this->AddFillLight();
  const double* eye = this->Renderer->GetActiveCamera()->GetPosition();
  const glm::dvec3 centre = glm::dvec3(eye[0], eye[1], eye[2]) + 3.0 * toward;
  AddBox(this->Renderer, centre - 1.0, centre + 1.0);
  this->Shadows->SetTechnique("stencil-volume");
  for (const std::string view : { "Volumes", "Silhouette", "Counts" })
  {
    this->Shadows->SetDebugView(view == "Volumes" ? "volumes"
        : view == "Counts"                        ? "counts"
                                                  : "silhouette");
    this->CheckPicture("DebugView" + view);
  }
}

TEST_F(Regression, TwoColouredLights)
{
  AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 40.0)->SetColor(1.0, 0.6, 0.3);
  AddSun(this->Renderer, -Toward(-70.0, 45.0))->SetColor(0.3, 0.5, 0.9);
  this->AddFillLight();
  this->CheckPicture("TwoColouredLights");
}

// A window's light through its bars, and a lamp with a smooth side.
TEST_F(Regression, ProjectedImage)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 64, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 64 * 64; ++i)
  {
    const int x = i % 64, y = i / 64;
    const bool isBar = x % 21 < 3 || y % 31 < 3;
    for (int c = 0; c < 3; ++c)
    {
      image->SetScalarComponentFromDouble(x, y, 0, c, isBar ? 20.0 : c == 2 ? 4.0 * x : 255.0);
    }
  }
  vtkNew<vtkTexture> window;
  window->SetInputData(image);
  window->InterpolateOn();
  auto spot = AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 24.0);
  auto lamp = AddSpot(this->Renderer, { -3.0, -2.5, 4.0 }, { -0.5, 0.0, 0.0 }, 28.0);
  lamp->SetColor(0.5, 0.6, 0.9);
  this->Shadows->SetLightTexture(spot, window);
  this->Shadows->SetLightSmoothCone(lamp, 0.8);
  this->AddFillLight();
  this->CheckPicture("ProjectedImage");
}

TEST_F(Regression, AreaLightByRayCast)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto lamp = AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 40.0);
  this->AddFillLight();
  this->Shadows->SetTechnique("ray-cast");
  this->Shadows->SetLightRadius(lamp, 0.6);
  this->CheckPicture("AreaLightByRayCast");
}

// Nothing of the floor but its shadows, which fade toward the rim.
TEST_F(Regression, ShadowCatcher)
{
  AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 40.0)->SetColor(1.0, 0.8, 0.6);
  AddSun(this->Renderer, -Toward(-70.0, 30.0))->SetColor(0.3, 0.5, 0.9);
  this->AddFillLight();
  vtkActorCollection* actors = this->Renderer->GetActors();
  actors->InitTraversal();
  vtkActor* floor = actors->GetNextActor(); // the still life's first
  vtkShadowPass::SetCatcherColor(floor, 0.1, 0.05, 0.3);
  vtkShadowPass::SetCatcherFade(floor, 0.8);
  this->Shadows->SetTechnique("stencil-volume");
  this->CheckPicture("ShadowCatcher");
}
