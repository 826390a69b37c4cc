// What a frame's stages take, and what techniques keep from frame to frame.
#include "ShadowTest.h"
#include "TestScenes.h"

#include "vtkObjectIDShadowPass.h"
#include "vtkPlanarShadowPass.h"
#include "vtkShadowTexturePass.h"

#include <vtkStringArray.h>

#include <chrono>

using namespace shadowtest;

namespace
{

std::vector<std::string> StagesOf(vtkShadowPass* shadows)
{
  vtkNew<vtkStringArray> array;
  shadows->GetStageNames(array);
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    names.push_back(array->GetValue(i));
  }
  return names;
}

class Stages : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    const Subject subject = AddStillLife(this->Renderer);
    AimCamera(this->Renderer, subject, 20.0, 35.0, 400, 300);
    this->Resize(400, 300);
    this->First = AddSun(this->Renderer, { 0.4, 0.5, -0.8 });
    this->Second = AddSpot(this->Renderer, { -4.0, -3.0, 6.0 }, { 0.0, 0.0, 0.0 }, 30.0);
    this->Shadows->SetTechnique("depth-map");
    this->Renderer->SetPass(this->Shadows);
  }

  vtkSmartPointer<vtkLight> First, Second;
};

}

//------------------------------------------------------------------------------
TEST_F(Stages, OnlyIfAskedFor)
{
  this->Render();
  EXPECT_TRUE(StagesOf(this->Shadows).empty());
  Check("seconds of a stage that there was not", this->Shadows->GetStageSeconds("depth-map"), 0.0);
  CheckAtMost("GPU's", this->Shadows->GetStageGPUSeconds("depth-map"), -1.0);
}

//------------------------------------------------------------------------------
TEST_F(Stages, AreThoseOfTheFrame)
{
  this->Shadows->SetTimeStages(true);
  this->Shadows->SetLightTechnique(this->Second, "stencil-volume");
  const Frame timed = this->Render();
  EXPECT_EQ(StagesOf(this->Shadows),
    (std::vector<std::string>{ "scene", "depth-map", "stencil-volume", "shading" }));

  // What is read back is no frame.
  const double before = this->Shadows->GetStageSeconds("stencil-volume");
  this->VisibilityOf(this->Second);
  Check("seconds after a mask was read", this->Shadows->GetStageSeconds("stencil-volume"), before);

  this->Shadows->SetLightTechnique(this->First, "none");
  this->Render();
  EXPECT_EQ(
    StagesOf(this->Shadows), (std::vector<std::string>{ "scene", "stencil-volume", "shading" }));

  this->Shadows->SetTimeStages(false);
  this->Shadows->SetLightTechnique(this->First, "");
  EXPECT_EQ(CountDifferent(this->Render(), timed), 0u);
  EXPECT_EQ(StagesOf(this->Shadows).size(), 3u) << "those of the last frame that was timed";
}

//------------------------------------------------------------------------------
// They are parts of the frame, and nearly all of it.
TEST_F(Stages, AddUpToTheFrame)
{
  this->Shadows->SetTimeStages(true);
  double best = 0.0;
  for (int i = 0; i < 5; ++i)
  {
    const auto begin = std::chrono::steady_clock::now();
    this->Render();
    const std::chrono::duration<double> frame = std::chrono::steady_clock::now() - begin;
    double sum = 0.0;
    for (const std::string& name : StagesOf(this->Shadows))
    {
      const double seconds = this->Shadows->GetStageSeconds(name);
      CheckAtLeast("seconds of " + name, seconds, 0.0);
      sum += seconds;
    }
    CheckAtMost("sum of the stages over the frame", sum / frame.count(), 1.0);
    best = std::max(best, sum / frame.count());
  }
  CheckAtLeast("the largest share of a frame", best, 0.5);
}

//------------------------------------------------------------------------------
// A map that need not be drawn costs next to nothing.
TEST_F(Stages, TellWhatWasDrawn)
{
  this->Shadows->SetTimeStages(true);
  this->Render();
  double drawn = 1e9, kept = 1e9;
  for (int i = 0; i < 5; ++i)
  {
    this->First->SetPosition(0.1 * (i + 1), -1.0, 2.0);
    this->Render();
    drawn = std::min(drawn, this->Shadows->GetStageSeconds("depth-map"));
    this->Render();
    kept = std::min(kept, this->Shadows->GetStageSeconds("depth-map"));
  }
  CheckAtMost("seconds without a map to draw over those with one", kept / drawn, 0.5);
}

//------------------------------------------------------------------------------
TEST_F(Stages, MemoryOfTextures)
{
  auto* maps = this->Shadows->GetDepthShadowMapPass();
  Check("bytes ahead of the first frame", double(maps->GetTextureMemory()), 0.0);
  maps->SetResolution(512);
  this->Render();
  // Two lights, 4 bytes a texel, on the longer side at least the resolution.
  CheckAtLeast("bytes of two maps of 512", double(maps->GetTextureMemory()), 2 * 4.0 * 512 * 256);
  CheckAtMost("bytes of two maps of 512", double(maps->GetTextureMemory()), 2 * 4.0 * 520 * 520);
  const double coarse = double(maps->GetTextureMemory());
  maps->SetResolution(1024);
  this->Render();
  CheckAtLeast("bytes of 1024 over those of 512", maps->GetTextureMemory() / coarse, 3.8);
  CheckAtMost("bytes of 1024 over those of 512", maps->GetTextureMemory() / coarse, 4.0);
  // A directional light's 16 bits are drawn as they stay; a spot's distances are made of 32 bits
  // beside them.
  const double fine = double(maps->GetTextureMemory());
  maps->SetDepthBits(16);
  this->Render();
  Check("bytes of 16 bits over those of 32", maps->GetTextureMemory() / fine, 1.0);
  this->Shadows->SetLightTechnique(this->Second, "none");
  this->Render();
  Check("the directional light's by itself", maps->GetTextureMemory() / fine, 0.5);

  this->Shadows->ReleaseGraphicsResources(this->Window);
  Check("bytes once released", double(maps->GetTextureMemory()), 0.0);
}

//------------------------------------------------------------------------------
TEST_F(Stages, MemoryOfCasters)
{
  auto* maps = this->Shadows->GetDepthShadowMapPass();
  this->Render();
  Check("bytes of casters, percentage-closer", double(maps->GetCasterMemory()), 0.0);
  maps->SetFilter("exact");
  this->Render();
  CheckAtLeast("bytes of casters, exact", double(maps->GetCasterMemory()), 1e5);

  std::vector<std::string> keepers = { "stencil-volume" };
  if (this->Shadows->GetRayCastShadowPass())
  {
    keepers.push_back("ray-cast");
  }
  for (const std::string& name : keepers)
  {
    vtkShadowTechniquePass* technique = this->Shadows->GetTechniquePass(name);
    this->Shadows->SetTechnique(name);
    this->Render();
    const double few = double(technique->GetCasterMemory());
    CheckAtLeast("bytes of " + name, few, 1e5);
    const auto ball = AddSphere(this->Renderer, { 0.0, 0.0, 4.0 }, 0.5, 200);
    this->Render();
    // 79 000 triangles more.
    CheckAtLeast(
      "bytes more with another caster, " + name, technique->GetCasterMemory() - few, 1e6);
    this->Renderer->RemoveActor(ball);
    this->Render();
    CheckAtMost("bytes without it, " + name, technique->GetCasterMemory() / few, 1.05);
    CheckAtLeast("bytes of masks, " + name, double(technique->GetTextureMemory()), 2.0 * 400 * 300);
  }
}
