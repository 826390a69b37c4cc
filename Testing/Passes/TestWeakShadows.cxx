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

  struct Under
  {
    double mean = 0.0, least = 1.0, most = 0.0;
  };

  double MeanUnderPanes(vtkLight* light) { return this->UnderPanes(light).mean; }

  // Visibility of the floor under the panes, away from their rims, seen from beneath them.
  Under UnderPanes(vtkLight* light)
  {
    LookAt(this->Renderer, { 0.0, -6.0, 1.2 }, { 0.0, 0.0, 0.0 });
    this->Render();
    const Visibility seen = this->VisibilityOf(light);
    const Pixel low = PixelOf(this->Renderer, { -0.6, -0.8, 0.0 });
    const Pixel high = PixelOf(this->Renderer, { 0.6, 0.8, 0.0 });
    Under under;
    double sum = 0.0;
    int count = 0;
    for (int y = low.y; y <= high.y; ++y)
    {
      for (int x = low.x; x <= high.x; ++x)
      {
        const double value = seen.At(x, y);
        sum += value;
        under.least = std::min(under.least, value);
        under.most = std::max(under.most, value);
        ++count;
      }
    }
    EXPECT_GT(count, 500);
    under.mean = sum / count;
    return under;
  }

  // Every pixel has this visibility, to the steps of a byte that holds each product.
  void CheckUnderPanes(const std::string& what, vtkLight* light, double expected)
  {
    const Under under = this->UnderPanes(light);
    Check(what + ": least", under.least, expected, 0.005);
    Check(what + ": most", under.most, expected, 0.005);
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

// The light times the product of 1 - opacity, without noise, in every view of a light and by every
// filter.
TEST_F(WeakShadows, Transmittance)
{
  AddFloor(this->Renderer, 4.0);
  auto pane = this->AddPane(2.2, 0.3);
  vtkDepthShadowMapPass* maps = this->Shadows->GetDepthShadowMapPass();
  this->Shadows->SetTechnique("depth-map");
  maps->SetResolution(512);
  this->Shadows->SetTranslucentCasting(vtkShadowPass::TRANSLUCENT_TRANSMITTANCE);

  const auto check = [&](const std::string& what, vtkLight* light)
  {
    pane->GetProperty()->SetOpacity(0.3);
    this->CheckUnderPanes(what + ", an opacity of 0.3", light, 0.7);
    pane->GetProperty()->SetOpacity(0.5);
    auto second = this->AddPane(2.5, 0.6);
    this->CheckUnderPanes(what + ", 0.5 over 0.6", light, 0.2);
    auto box = AddBox(this->Renderer, { -1.0, -1.0, 2.3 }, { 1.0, 1.0, 2.4 });
    this->CheckUnderPanes(what + ", under an opaque box, too", light, 0.0);
    this->Renderer->RemoveViewProp(box);
    this->Renderer->RemoveViewProp(second);
  };
  auto sun = AddSun(this->Renderer, { 0.0, 0.0, -1.0 });
  check("sun", sun);
  for (int filter = 0; filter < vtkDepthShadowMapPass::GetNumberOfFilters(); ++filter)
  {
    maps->SetFilter(filter);
    this->CheckUnderPanes(vtkDepthShadowMapPass::GetFilterName(filter), sun, 0.5);
  }
  maps->SetFilter(vtkDepthShadowMapPass::PERCENTAGE_CLOSER);
  for (const int bits : { 8, 16, 24 })
  {
    maps->SetDepthBits(bits);
    this->CheckUnderPanes(std::to_string(bits) + " bits", sun, 0.5);
  }
  maps->SetDepthBits(32);
  // What is far away makes one map's texels too large.
  auto far = AddBox(this->Renderer, { -5.0, 400.0, 0.0 }, { 5.0, 410.0, 10.0 });
  maps->SetNumberOfCascades(4);
  check("cascades", sun);
  CheckAtLeast("cascades", maps->GetNumberOfViews(), 2);
  maps->SetNumberOfCascades(1);
  this->Renderer->RemoveViewProp(far);
  this->Renderer->RemoveLight(sun);
  auto spot = AddSpot(this->Renderer, { 0.3, 0.0, 9.0 }, { 0.0, 0.0, 0.0 }, 30.0);
  check("spot", spot);
  this->Renderer->RemoveLight(spot);
  auto lamp = AddLamp(this->Renderer, { 0.3, 0.0, 5.0 });
  AddBox(this->Renderer, { 3.0, 3.0, 5.0 }, { 3.5, 3.5, 8.0 });
  check("lamp amid casters", lamp);
  LookAt(this->Renderer, { 0.0, -30.0, 10.0 }, { 0.0, 0.0, 3.0 });
  this->Render();
  CheckAtLeast("faces of its cube, seen from afar", maps->GetNumberOfViews(), 2);
}

// What stands between two panes has the share of both, and so has the second; a box's own top has
// that of the pane above it alone, since what lies behind the box does not count.
TEST_F(WeakShadows, TransmittanceBetween)
{
  AddFloor(this->Renderer, 4.0);
  this->AddPane(3.0, 0.5);
  AddBox(this->Renderer, { -0.8, -0.8, 1.5 }, { 0.8, 0.8, 1.6 });
  this->AddPane(1.0, 0.5);
  auto sun = AddSun(this->Renderer, { 0.0, 0.0, -1.0 });
  this->Shadows->SetTechnique("depth-map");
  this->Shadows->GetDepthShadowMapPass()->SetResolution(512);
  this->Shadows->SetTranslucentCasting(vtkShadowPass::TRANSLUCENT_TRANSMITTANCE);
  LookAt(this->Renderer, { 0.0, -6.0, 2.6 }, { 0.0, 0.0, 1.6 });
  this->Render();
  const Visibility seen = this->VisibilityOf(sun);
  const Pixel top = PixelOf(this->Renderer, { 0.0, 0.0, 1.6 });
  Check("top of the box", seen.At(top.x, top.y), 0.5, 0.005);
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
  this->Shadows->SetTranslucentCasting(4);
  ExpectOneMessage({ "TranslucentCasting 4", "0 to 3" });
  EXPECT_EQ(this->Shadows->GetLightMaximumDistance(sun), 0.0);
  EXPECT_EQ(this->Shadows->GetLightFade(sun), 0.1);
  EXPECT_EQ(this->Shadows->GetTranslucentCasting(), 0);
}
