// Shadows that are less than whole: of translucent casters, and with the distance from the eye.
#include "ShadowTest.h"

#include <vtkProperty.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace shadowtest;

namespace
{

class WeakShadows : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetPass(this->Shadows);
  }

  // A square of 2 x 2 above the floor, of this opacity.
  vtkSmartPointer<vtkActor> AddPane(double height, double opacity)
  {
    auto pane = AddFloor(this->Renderer, 1.0, height);
    pane->GetProperty()->SetOpacity(opacity);
    return pane;
  }

  // Mean visibility of the floor under the panes, away from their rims, seen from beneath them.
  double MeanUnderPanes(vtkLight* light)
  {
    LookAt(this->Renderer, { 0.0, -6.0, 1.2 }, { 0.0, 0.0, 0.0 });
    this->Render();
    const Visibility seen = this->VisibilityOf(light);
    const Pixel low = PixelOf(this->Renderer, { -0.6, -0.8, 0.0 });
    const Pixel high = PixelOf(this->Renderer, { 0.6, 0.8, 0.0 });
    double sum = 0.0;
    int count = 0;
    for (int y = low.y; y <= high.y; ++y)
    {
      for (int x = low.x; x <= high.x; ++x)
      {
        sum += seen.At(x, y);
        ++count;
      }
    }
    EXPECT_GT(count, 500);
    return sum / count;
  }
};

}

TEST_F(WeakShadows, TranslucentCasters)
{
  AddFloor(this->Renderer, 4.0);
  auto pane = this->AddPane(2.2, 0.3);
  auto sun = AddSun(this->Renderer, { 0.0, 0.0, -1.0 });
  this->Shadows->GetDepthShadowMapPass()->SetResolution(512);

  Check("no shadow of it", this->MeanUnderPanes(sun), 1.0);
  this->Shadows->SetTranslucentCasting(vtkShadowPass::TRANSLUCENT_OPAQUE);
  Check("as if opaque", this->MeanUnderPanes(sun), 0.0);
  this->Shadows->SetTranslucentCasting(vtkShadowPass::TRANSLUCENT_STOCHASTIC);
  Check("by an opacity of 0.3", this->MeanUnderPanes(sun), 0.7, 0.01);
  pane->GetProperty()->SetOpacity(0.8);
  Check("by an opacity of 0.8", this->MeanUnderPanes(sun), 0.2, 0.01);

  // What lies behind another darkens on.
  pane->GetProperty()->SetOpacity(0.5);
  auto second = this->AddPane(2.5, 0.5);
  Check("by two of 0.5", this->MeanUnderPanes(sun), 0.25, 0.03);

  // The key decides before the setting does.
  vtkShadowPass::SetCastsShadows(pane, false);
  vtkShadowPass::SetCastsShadows(second, false);
  Check("told not to cast", this->MeanUnderPanes(sun), 1.0);
  vtkShadowPass::SetCastsShadows(second, true);
  Check("told to cast, by opacity", this->MeanUnderPanes(sun), 0.5, 0.01);

  // Opaque props are as ever.
  AddBox(this->Renderer, { -1.0, -1.0, 2.3 }, { 1.0, 1.0, 2.4 });
  Check("under an opaque box, too", this->MeanUnderPanes(sun), 0.0);
}

TEST_F(WeakShadows, TranslucentCastersOfTheExactFilter)
{
  AddFloor(this->Renderer, 4.0);
  this->AddPane(2.2, 0.3);
  auto sun = AddSun(this->Renderer, { 0.0, 0.0, -1.0 });
  this->Shadows->GetDepthShadowMapPass()->SetResolution(512);
  this->Shadows->GetDepthShadowMapPass()->SetFilter("exact");
  this->Shadows->SetTranslucentCasting(vtkShadowPass::TRANSLUCENT_STOCHASTIC);
  Check("by an opacity of 0.3", this->MeanUnderPanes(sun), 0.7, 0.01);
  this->Shadows->SetTranslucentCasting(vtkShadowPass::TRANSLUCENT_OPAQUE);
  Check("as if opaque", this->MeanUnderPanes(sun), 0.0);
}

TEST_F(WeakShadows, OnlyNearTheEye)
{
  AddFloor(this->Renderer, 40.0);
  for (int i = 0; i < 12; ++i)
  {
    AddBox(this->Renderer, { -1.0, 3.0 * i, 1.0 }, { 1.0, 3.0 * i + 1.5, 1.2 });
  }
  auto sun = AddSun(this->Renderer, { 1.0, 0.0, -1.0 });
  for (const std::string technique : { "depth-map", "stencil-volume" })
  {
    this->Shadows->SetTechnique(technique);
    const glm::dvec3 eye(1.0, -8.0, 3.0);
    LookAt(this->Renderer, eye, { 1.0, 16.0, 0.0 });
    const Frame lit = this->RenderWithoutPass();
    this->Renderer->SetPass(this->Shadows);
    this->Shadows->SetLightMaximumDistance(sun, 0.0);
    const Frame whole = this->Render();
    const Visibility seen = this->VisibilityOf(sun);
    this->Shadows->SetLightMaximumDistance(sun, 20.0);
    this->Shadows->SetLightFade(sun, 0.25);
    const Frame faded = this->Render();
    Check(technique + ": visibility that is read back, pixels unlike",
      static_cast<double>(CountDifferent(this->VisibilityOf(sun), seen)), 0.0);
    int near = 0, between = 0, far = 0;
    for (double y = 0.2; y < 34.0; y += 0.1)
    {
      const glm::dvec3 point(1.4, y, 0.0);
      const Pixel at = PixelOf(this->Renderer, point);
      const double full = lit.Brightness(at.x, at.y) - whole.Brightness(at.x, at.y);
      if (seen.At(at.x, at.y) > 0.0f || full < 30.0)
      {
        continue;
      }
      const double distance = glm::length(point - eye);
      const double expected = std::min(std::max((20.0 - distance) / 5.0, 0.0), 1.0);
      const double got = (lit.Brightness(at.x, at.y) - faded.Brightness(at.x, at.y)) / full;
      // A pixel's own receiver lies up to a few of its sizes away.
      EXPECT_NEAR(got, expected, 0.06) << technique << " at " << distance;
      near += expected == 1.0 ? 1 : 0;
      far += expected == 0.0 ? 1 : 0;
      between += expected > 0.0 && expected < 1.0 ? 1 : 0;
    }
    CheckAtLeast(technique + ": points near", near, 20);
    CheckAtLeast(technique + ": points between", between, 10);
    CheckAtLeast(technique + ": points far", far, 20);
  }
}

TEST_F(WeakShadows, BadSettings)
{
  auto sun = AddSun(this->Renderer, { 1.0, 0.0, -1.0 });
  this->Shadows->SetLightMaximumDistance(sun, -1.0);
  ExpectOneMessage({ "SetLightMaximumDistance", "-1" });
  this->Shadows->SetLightMaximumDistance(sun, std::nan(""));
  ExpectOneMessage({ "SetLightMaximumDistance", "nan" });
  this->Shadows->SetLightFade(sun, 1.5);
  ExpectOneMessage({ "SetLightFade", "1.5", "0 to 1" });
  this->Shadows->SetTranslucentCasting(3);
  ExpectOneMessage({ "TranslucentCasting 3", "0 to 2" });
  EXPECT_EQ(this->Shadows->GetLightMaximumDistance(sun), 0.0);
  EXPECT_EQ(this->Shadows->GetLightFade(sun), 0.1);
  EXPECT_EQ(this->Shadows->GetTranslucentCasting(), 0);
}
