// The depth map's filter "exact" against the truth: on what DepthMapAccuracy has, for every kind of
// light, and where only some of the casters are triangles.
#include "ShadowTest.h"
#include "TestScenes.h"

#include "vtkShadowErrorMeasure.h"

#include <vtkImageData.h>
#include <vtkLightCollection.h>
#include <vtkPNGWriter.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>

using namespace shadowtest;

namespace
{

// What the filter is meant to keep at its default resolution, 2048.
constexpr double MostMismatch = 0.06; // percent of the receiver pixels
constexpr vtkIdType MostGross = 5;    // pixels

struct WindowSize
{
  int width;
  int height;
};
const WindowSize Windows[] = { { 1024, 768 }, { 768, 768 }, { 333, 1000 } };

class DepthMapExact : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetPass(this->Shadows);
    this->Maps()->SetFilter("exact");
  }

  vtkDepthShadowMapPass* Maps() { return this->Shadows->GetDepthShadowMapPass(); }

  // Holds every light against the truth.
  void CheckLights(const std::string& what)
  {
    this->Render();
    vtkCollectionSimpleIterator it;
    this->Renderer->GetLights()->InitTraversal(it);
    vtkNew<vtkShadowErrorMeasure> error;
    while (vtkLight* light = this->Renderer->GetLights()->GetNextLight(it))
    {
      ASSERT_TRUE(error->Measure(this->Renderer, light)) << what;
      std::printf("%s, %s: receivers %lld, shadow %lld, uncertain %lld | mismatch %.4f %% (limit %g), "
                  "gross %lld (limit %lld): false %lld, missed %lld\n",
        what.c_str(), light->GetPositional() ? "spot or point" : "directional",
        static_cast<long long>(error->GetReceiverPixels()),
        static_cast<long long>(error->GetShadowPixels()),
        static_cast<long long>(error->GetUncertainPixels()), error->GetMismatchPercent(),
        MostMismatch, static_cast<long long>(error->GetGrossPixels()),
        static_cast<long long>(MostGross), static_cast<long long>(error->GetGrossFalsePixels()),
        static_cast<long long>(error->GetGrossMissedPixels()));
      EXPECT_LE(error->GetMismatchPercent(), MostMismatch) << what << ": mismatch %";
      EXPECT_LE(error->GetGrossPixels(), MostGross) << what << ": gross pixels";
      EXPECT_GT(error->GetShadowPixels(), error->GetReceiverPixels() / 50) << what << ": few shadows";
      if (const char* folder = std::getenv("EXACT_MAPS"))
      {
        static int n = 0;
        vtkNew<vtkPNGWriter> writer;
        writer->SetInputData(error->GetErrorMap());
        writer->SetFileName((std::string(folder) + "/" + std::to_string(n++) + ".png").c_str());
        writer->Write();
      }
    }
  }

  void CheckWindows(
    const std::string& what, const Subject& subject, double azimuth, double elevation)
  {
    for (const WindowSize& size : Windows)
    {
      this->Resize(size.width, size.height);
      AimCamera(this->Renderer, subject, azimuth, elevation, size.width, size.height);
      this->CheckLights(what);
    }
  }
};

}

TEST_F(DepthMapExact, StillLifeWithASpot)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Subject subject = AddStillLife(this->Renderer);
  AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0);
  this->CheckWindows("still life", subject, -15.0, 28.0);
}

TEST_F(DepthMapExact, BumpyMeshWithASun)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Subject subject = AddBumpyMesh(this->Renderer);
  AddSun(this->Renderer, -Toward(60.0, 40.0));
  this->CheckWindows("bumpy mesh", subject, 10.0, 20.0);
}

TEST_F(DepthMapExact, TubesAndGlyphsWithTwoLights)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Subject subject = AddTubesAndGlyphs(this->Renderer);
  AddSpot(this->Renderer, { 4.0, -3.0, 7.0 }, { 0.0, 0.0, 0.8 }, 30.0);
  AddSun(this->Renderer, -Toward(-50.0, 50.0));
  this->CheckWindows("tubes and glyphs", subject, 5.0, 25.0);
}

// Light and camera are drawn by lot, from fixed seeds; in turn on each of the scenes.
TEST_F(DepthMapExact, TwentyUnseenViews)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(1024, 768);
  for (int seed = 101; seed <= 120; ++seed)
  {
    std::mt19937 random(seed);
    const auto any = [&random](double low, double high)
    { return low + (high - low) * (random() / double(random.max())); };

    this->Renderer->RemoveAllViewProps();
    this->Renderer->RemoveAllLights();
    const int scene = seed % 3;
    const Subject subject = scene == 0 ? AddStillLife(this->Renderer)
      : scene == 1                     ? AddBumpyMesh(this->Renderer)
                                       : AddTubesAndGlyphs(this->Renderer);
    const glm::dvec3 toward = Toward(any(0.0, 360.0), any(25.0, 80.0));
    if (any(0.0, 1.0) < 0.5)
    {
      AddSun(this->Renderer, -toward);
    }
    else
    {
      AddSpot(this->Renderer, subject.centre + any(2.0, 5.0) * subject.radius * toward,
        subject.centre, any(25.0, 50.0));
    }
    AimCamera(this->Renderer, subject, any(0.0, 360.0), any(10.0, 70.0), 1024, 768);

    const char* names[] = { "still life", "bumpy mesh", "tubes and glyphs" };
    this->CheckLights(std::string(names[scene]) + ", seed " + std::to_string(seed));
  }
}
