// Technique "auto" and lights with a radius: techniques, and how many sample lights they take.
#include "AutoTest.h"
#include "Scenes.h"

#include "vtkPlanarShadowPass.h"
#include "vtkShadowErrorMeasure.h"

#include <vtkPolyData.h>
#include <vtkSphereSource.h>

#include <string>

using namespace shadowtest;

namespace
{

class AutoSoft : public AutoTest
{
protected:
  // A scene of the registry under its light with a radius, in a window of that size.
  void MakeScene(const std::string& name, const vtkshadows::SceneSize& size)
  {
    this->Resize(size.width, size.height);
    const vtkshadows::SceneFacts facts = vtkshadows::BuildScene(name, this->Renderer, size);
    this->Sun = facts.lights[0].light;
    this->Radius = facts.lights[0].radius;
    this->Shadows->SetLightRadius(this->Sun, this->Radius);
  }

  double Radius = 0.0;
};

}

//------------------------------------------------------------------------------
TEST_F(AutoSoft, SoftLights)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(200, 150);
  this->MakeStillLife();
  this->Shadows->SetLightRadius(this->Sun, 0.1);
  vtkNew<vtkShadowErrorMeasure> error;
  for (const double percent : { 0.0, 1.0 })
  {
    this->Shadows->SetMaximumError(percent);
    this->Render();
    this->ExpectChosen(this->Sun, { "depth-map", "stencil-volume", "ray-cast" });
    ASSERT_TRUE(error->Measure(this->Renderer, this->Sun));
    CheckAtMost("mean difference %", 100.0 * error->GetMeanAbsoluteDifference(),
      percent > 0.0 ? percent : 1.0);
    if (percent == 0.0)
    {
      CheckAtMost("penumbra %", 100.0 * error->GetMeanPenumbraDifference(), 4.0);
    }
    if (this->Chosen(this->Sun) == "depth-map")
    {
      const int filter = this->Shadows->GetDepthShadowMapPass()->GetFilter();
      EXPECT_TRUE(
        filter == vtkDepthShadowMapPass::SOFT || filter == vtkDepthShadowMapPass::SAMPLE_LIGHTS);
    }
  }
}

//------------------------------------------------------------------------------
// Of eight volumes the penumbra is 3.96 % wrong here, the limit being 4: a third of the pixels, or
// a sample of them, may say more.
TEST_F(AutoSoft, PenumbraCloseToTheLimit)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  vtkshadows::SceneSize size;
  size.width = 640;
  size.height = 480;
  this->MakeScene("still-life", size);
  this->Shadows->SetLightTechnique(this->Sun, "stencil-volume");
  this->Shadows->GetStencilShadowVolumePass()->SetLightSamples(8);
  this->Shadows->GetRayCastShadowPass()->SetLightSamples(256); // of the truth
  this->Render();
  vtkNew<vtkShadowErrorMeasure> error;
  ASSERT_TRUE(error->Measure(this->Renderer, this->Sun));
  const double penumbra = 100.0 * error->GetMeanPenumbraDifference();
  CheckAtMost("penumbra by 8 volumes, %", penumbra, 4.0);
  CheckAtLeast("the same", penumbra, 3.9);

  vtkNew<vtkShadowPass> fresh;
  this->Renderer->SetPass(fresh);
  fresh->SetLightRadius(this->Sun, this->Radius);
  for (int i = 0; i < 100 && (i == 0 || !fresh->GetChoiceIsSettled()); ++i)
  {
    this->Render();
  }
  const std::string explanation = fresh->GetExplanation(this->Sun),
                    name = "stencil-volume (8 samples)";
  std::printf("       %s\n", explanation.c_str());
  const std::size_t found = explanation.find(name);
  ASSERT_NE(found, std::string::npos) << explanation;
  EXPECT_TRUE(found == 0 || explanation.compare(found + name.size(), 6, " takes") == 0)
    << explanation;
  this->Renderer->SetPass(nullptr);
}

//------------------------------------------------------------------------------
// A lawn, whose volumes cover each pixel many times: where 8 of them take far longer than rays that
// serve, 16 and 32 are neither measured nor drawn.
TEST_F(AutoSoft, WhatIsSlowWithFewSamplesIsNotMeasuredWithMany)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  vtkshadows::SceneSize size;
  size.detail = 0.25;
  size.width = 160;
  size.height = 120;
  this->MakeScene("grass", size);
  this->Settle(200);
  this->ExpectChosen(this->Sun, { "ray-cast" }, { "stencil-volume (8 samples)" });
  const std::string explanation = this->Shadows->GetExplanation(this->Sun);
  for (const char* slow : { "stencil-volume (16 samples)", "stencil-volume (32 samples)" })
  {
    EXPECT_EQ(explanation.find(slow), std::string::npos) << explanation;
  }
}

//------------------------------------------------------------------------------
// Where no truth is known, as without Embree, no fewer samples are taken than a technique has.
TEST_F(AutoSoft, SoftLightsWithoutTruth)
{
  this->Resize(100, 75);
  this->MakeStillLife();
  vtkNew<vtkSphereSource> coarse;
  coarse->SetCenter(0.0, 0.0, 1.2);
  coarse->SetRadius(0.8);
  coarse->Update();
  vtkShadowPass::SetStandIn(this->Ball, coarse->GetOutput());
  this->Shadows->SetLightRadius(this->Sun, 0.1);
  this->Settle();
  this->ExpectChosen(this->Sun, { "stencil-volume" }, { "32 samples", "each sample light" });
  EXPECT_EQ(this->Shadows->GetStencilShadowVolumePass()->GetLightSamples(), 32);
}

//------------------------------------------------------------------------------
// Numbers of samples are chosen, those of the user stay, and all are put back; the truth that is
// measured against has the user's whatever was chosen.
TEST_F(AutoSoft, NumbersOfSamples)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(200, 150);
  this->MakeStillLife();
  this->Shadows->SetLightRadius(this->Sun, 0.1);
  vtkRayCastShadowPass* rays = this->Shadows->GetRayCastShadowPass();
  vtkStencilShadowVolumePass* volumes = this->Shadows->GetStencilShadowVolumePass();
  vtkDepthShadowMapPass* maps = this->Shadows->GetDepthShadowMapPass();
  volumes->SetLightSamples(5);
  vtkNew<vtkShadowErrorMeasure> error;
  for (const double percent : { 2.0, 0.03 })
  {
    this->Shadows->SetMaximumError(percent);
    this->Settle();
    EXPECT_EQ(volumes->GetLightSamples(), 5);
    ASSERT_TRUE(error->Measure(this->Renderer, this->Sun));
    CheckAtMost(this->Shadows->GetExplanation(this->Sun),
      100.0 * error->GetMeanAbsoluteDifference(), percent);
    if (this->Chosen(this->Sun) == "ray-cast" && rays->GetLightSamples() < 64)
    {
      // Against itself it would be right to the last pixel.
      CheckAtLeast("difference from the truth", error->GetMeanAbsoluteDifference(), 1.0e-6);
    }
  }
  this->Shadows->SetTechnique("stencil-volume");
  this->Render();
  EXPECT_EQ(rays->GetLightSamples(), 64);
  EXPECT_EQ(maps->GetLightSamples(), 64);
  EXPECT_EQ(maps->GetFilter(), static_cast<int>(vtkDepthShadowMapPass::PERCENTAGE_CLOSER));
  EXPECT_EQ(volumes->GetLightSamples(), 5);
  EXPECT_FALSE(this->Shadows->GetPlanarShadowPass()->GetPlaneTextures());
}
