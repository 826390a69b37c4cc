// Every kind of vtkLight: its visibility against the truth, and its colour against VTK's own frame
// with the light switched off where it is not seen.
#include "ShadowTest.h"

#include "vtkShadowScene.h"

#include <vtkActorCollection.h>
#include <vtkProperty.h>
#include <vtkTransform.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <map>

using namespace shadowtest;

namespace
{

using Lamps = std::vector<vtkSmartPointer<vtkLight>>;

// Of a depth map, in percent of the receiver pixels.
constexpr double Mismatch = 0.1;
constexpr double Gross = 0.005;

void Shine(vtkActor* actor, double red, double green, double blue)
{
  vtkProperty* property = actor->GetProperty();
  property->SetColor(red, green, blue);
  property->SetAmbient(0.15);
  property->SetDiffuse(0.7);
  property->SetSpecular(0.3);
  property->SetSpecularPower(12.0);
}

class Lights : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    Shine(AddFloor(this->Renderer, 5.0), 0.9, 0.9, 0.8);
    Shine(AddSphere(this->Renderer, { -1.0, 0.0, 1.1 }, 0.9), 0.8, 0.4, 0.3);
    Shine(AddBox(this->Renderer, { 0.6, -0.6, 0.0 }, { 1.7, 0.6, 1.4 }), 0.4, 0.6, 0.8);
    LookAt(this->Renderer, { 1.0, -7.0, 5.0 }, { 0.0, 0.0, 0.5 });
    // A scene whose lights are all off stays dark.
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetPass(this->Shadows);
  }

  void CheckColours(const std::string& what, const Lamps& lamps);
  void CheckTechniques(const std::string& what, const Lamps& lamps);
  Frame RenderWithout(const Lamps& lamps, std::uint32_t off);
  void CheckNothingHappens(const std::string& what, vtkLight* lamp);
};

// VTK's own frame with some lights off; the lamps' bits are in `off`.
Frame Lights::RenderWithout(const Lamps& lamps, std::uint32_t off)
{
  // With no light on at all VTK draws unlit colours, so then they are dimmed.
  const bool allOff = off + 1 == std::uint64_t(1) << lamps.size();
  std::vector<double> intensities;
  for (std::size_t i = 0; i < lamps.size(); ++i)
  {
    intensities.push_back(lamps[i]->GetIntensity());
    if ((off >> i) & 1)
    {
      allOff ? lamps[i]->SetIntensity(0.0) : lamps[i]->SwitchOff();
    }
  }
  Frame frame = this->RenderWithoutPass();
  for (std::size_t i = 0; i < lamps.size(); ++i)
  {
    lamps[i]->SetIntensity(intensities[i]);
    lamps[i]->SwitchOn();
  }
  return frame;
}

// Pixels are told apart by which lights they do not see; each such group must look like VTK's own
// frame without those lights. Pixels that see a part of a light (the filtered edge) are left out.
void Lights::CheckColours(const std::string& what, const Lamps& lamps)
{
  constexpr std::size_t mostGroups = 10;
  const Frame shadowed = this->Render();
  std::vector<std::uint32_t> unseen(shadowed.rgb.size() / 3, 0);
  std::vector<bool> isWhole(unseen.size(), true);
  for (std::size_t i = 0; i < lamps.size(); ++i)
  {
    const Visibility visibility = this->VisibilityOf(lamps[i]);
    for (std::size_t pixel = 0; pixel < unseen.size(); ++pixel)
    {
      unseen[pixel] |= visibility.values[pixel] == 0.0f ? 1u << i : 0u;
      isWhole[pixel] =
        isWhole[pixel] && (visibility.values[pixel] == 0.0f || visibility.values[pixel] == 1.0f);
    }
  }
  std::map<std::uint32_t, std::vector<std::size_t>> groups;
  for (std::size_t pixel = 0; pixel < unseen.size(); ++pixel)
  {
    if (isWhole[pixel])
    {
      groups[unseen[pixel]].push_back(pixel);
    }
  }
  EXPECT_GT(groups.size(), 1u) << what << ": no shadows";

  std::vector<std::uint32_t> largest;
  for (const auto& group : groups)
  {
    largest.push_back(group.first);
  }
  std::sort(largest.begin(), largest.end(),
    [&groups](std::uint32_t a, std::uint32_t b) { return groups[a].size() > groups[b].size(); });
  largest.resize(std::min(largest.size(), mostGroups));

  std::size_t wrong = 0, asked = 0;
  for (const std::uint32_t off : largest)
  {
    const Frame expected = this->RenderWithout(lamps, off);
    for (const std::size_t pixel : groups[off])
    {
      int difference = 0;
      for (std::size_t c = 3 * pixel; c < 3 * pixel + 3; ++c)
      {
        difference = std::max(difference, std::abs(shadowed.rgb[c] - expected.rgb[c]));
      }
      wrong += difference > 1 ? 1 : 0;
    }
    asked += groups[off].size();
  }
  Check(what + ": pixels of a wrong colour, of " + std::to_string(asked) + " in " +
      std::to_string(largest.size()) + " groups",
    static_cast<double>(wrong), 0.0);
}

void Lights::CheckTechniques(const std::string& what, const Lamps& lamps)
{
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    this->Render();
    for (std::size_t i = 0; i < lamps.size(); ++i)
    {
      // A ray cast is its own truth, up to what a byte of its mask can say.
      this->CheckMeasure(what + ", " + technique + ", light " + std::to_string(i), lamps[i],
        technique == "ray-cast" ? 0.0 : Mismatch, technique == "ray-cast" ? 0.0 : Gross);
      EXPECT_GT(this->VisibilityOf(lamps[i]).CountShadowed(), 1000u) << what << ": few shadows";
    }
    this->CheckColours(what + ", " + technique, lamps);
  }
}

void Lights::CheckNothingHappens(const std::string& what, vtkLight* lamp)
{
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    const Frame frame = this->Render();
    Check(what + ", " + technique + ": pixels unlike the unshadowed frame",
      static_cast<double>(CountDifferent(frame, this->RenderWithoutPass())), 0.0);
    Check(what + ", " + technique + ": shadow pixels",
      static_cast<double>(this->VisibilityOf(lamp).CountShadowed()), 0.0);
  }
  Check(what + ": maps drawn",
    static_cast<double>(this->Shadows->GetDepthShadowMapPass()->GetNumberOfMapBuilds()), 0.0);
  Check(what + ": trees built",
    static_cast<double>(this->Shadows->GetRayCastShadowPass()->GetNumberOfTreeBuilds()), 0.0);
}

// Dim lights of many colours from all around.
Lamps AddRing(vtkRenderer* renderer, int count)
{
  Lamps lamps;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / count;
    const glm::dvec3 place(4.0 * std::cos(angle), 4.0 * std::sin(angle), 4.0 + 0.3 * (i % 4));
    auto lamp = i % 2 == 0 ? AddSun(renderer, -place)
                           : AddSpot(renderer, place, glm::dvec3(0.0, 0.0, 0.3), 50.0);
    lamp->SetColor(0.4 + 0.3 * (i % 3), 0.4 + 0.3 * ((i + 1) % 3), 0.4 + 0.3 * ((i + 2) % 3));
    lamp->SetIntensity(1.2 / count);
    lamps.push_back(lamp);
  }
  return lamps;
}

}

TEST_F(Lights, Directional)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->CheckTechniques("directional", { AddSun(this->Renderer, { 1.0, 0.7, -1.2 }) });
}

TEST_F(Lights, SpotWithConeExponentAndAttenuation)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto spot = AddSpot(this->Renderer, { 2.5, -2.5, 5.0 }, { 0.0, 0.0, 0.5 }, 28.0);
  spot->SetExponent(6.0);
  spot->SetAttenuationValues(0.4, 0.1, 0.01);
  this->CheckTechniques("spot", { spot });
}

TEST_F(Lights, PositionalOutsideItsCasters)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  for (const double cone : { 90.0, 180.0 })
  {
    auto lamp = AddSpot(this->Renderer, { 2.0, -2.5, 4.5 }, { 0.0, 0.0, 0.5 }, cone);
    lamp->SetAttenuationValues(0.5, 0.1, 0.0);
    this->CheckTechniques("positional, cone " + std::to_string(int(cone)), { lamp });
    this->Renderer->RemoveLight(lamp);
  }
}

TEST_F(Lights, PositionalAmidItsCasters)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  for (const double cone : { 80.0, 89.5, 90.0, 180.0 })
  {
    auto lamp = AddSpot(this->Renderer, { 0.1, -0.2, 1.2 }, { -0.5, 0.3, 0.0 }, cone);
    lamp->SetAttenuationValues(0.5, 0.1, 0.0);
    this->CheckTechniques("positional amid, cone " + std::to_string(int(cone)), { lamp });
    this->Renderer->RemoveLight(lamp);
  }
}

// The same light, placed by its matrix and placed by hand.
TEST_F(Lights, TransformMatrix)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  vtkNew<vtkTransform> transform;
  transform->Translate(0.5, -0.5, 1.0);
  transform->RotateZ(-70.0);
  auto moved = AddSpot(this->Renderer, { 2.0, 2.0, 4.0 }, { 0.0, 0.0, 0.0 }, 35.0);
  moved->SetTransformMatrix(transform->GetMatrix());
  this->CheckTechniques("transform", { moved });

  double position[3], focus[3];
  moved->GetTransformedPosition(position);
  moved->GetTransformedFocalPoint(focus);
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    const Visibility byMatrix = this->VisibilityBy(technique, moved);
    auto placed = AddSpot(this->Renderer, { position[0], position[1], position[2] },
      { focus[0], focus[1], focus[2] }, 35.0);
    const Visibility byHand = this->VisibilityBy(technique, placed);
    Check("transform, " + technique + ": pixels unlike those of a light placed by hand",
      static_cast<double>(CountDifferent(byMatrix, byHand)), 0.0);
    this->Renderer->RemoveLight(placed);
  }
}

TEST_F(Lights, CameraLight)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  for (const bool positional : { false, true })
  {
    auto lamp = AddSun(this->Renderer, { 0.0, 0.0, 1.0 });
    lamp->SetLightTypeToCameraLight();
    lamp->SetPosition(0.5, 0.5, 0.8);
    lamp->SetFocalPoint(0.0, 0.0, 0.0);
    lamp->SetPositional(positional);
    lamp->SetConeAngle(40.0);
    const std::string what = positional ? "camera light, spot" : "camera light, directional";
    this->CheckTechniques(what, { lamp });

    // It goes with the camera.
    LookAt(this->Renderer, { -4.0, -5.0, 5.0 }, { 0.0, 0.0, 0.5 });
    this->CheckTechniques(what + ", moved", { lamp });
    this->Renderer->RemoveLight(lamp);
  }
}

TEST_F(Lights, HeadlightCostsNothing)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto lamp = AddSun(this->Renderer, { 0.0, 0.0, -1.0 });
  lamp->SetLightTypeToHeadlight();
  this->CheckNothingHappens("headlight", lamp);
}

// A camera light where a headlight is.
TEST_F(Lights, PositionalAtTheEyeCostsNothing)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto lamp = AddLamp(this->Renderer, { 0.0, 0.0, 1.0 });
  lamp->SetLightTypeToCameraLight();
  this->CheckNothingHappens("camera light at the eye", lamp);
}

TEST_F(Lights, TwoColouredLights)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto red = AddSun(this->Renderer, { 1.0, 0.7, -1.2 });
  red->SetColor(0.9, 0.3, 0.1);
  auto blue = AddSpot(this->Renderer, { 2.5, -2.0, 5.0 }, { 0.0, 0.0, 0.5 }, 40.0);
  blue->SetColor(0.2, 0.4, 0.9);
  this->CheckTechniques("two coloured", { red, blue });
}

// VTK numbers only the lights that are on.
TEST_F(Lights, SwitchedOffLightsAreSkipped)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto off = AddSun(this->Renderer, { 1.0, -1.0, -1.0 });
  auto on = AddSun(this->Renderer, { 1.0, 0.7, -1.2 });
  off->SwitchOff();
  this->CheckTechniques("after one that is off", { on });
  Check("lights of the scene", static_cast<double>(this->Shadows->GetScene()->GetNumberOfLights()),
    1.0);

  const Visibility before = this->VisibilityBy("depth-map", on);
  this->Renderer->RemoveLight(off);
  const Visibility after = this->VisibilityBy("depth-map", on);
  Check("pixels changed by removing it", static_cast<double>(CountDifferent(before, after)), 0.0);
}

TEST_F(Lights, SwitchingOnAndOffBetweenFrames)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto first = AddSun(this->Renderer, { 1.0, 0.7, -1.2 });
  auto second = AddSpot(this->Renderer, { 2.5, -2.0, 5.0 }, { 0.0, 0.0, 0.5 }, 40.0);
  const Frame both = this->Render();
  first->SwitchOff();
  this->CheckTechniques("the second alone", { second });
  first->SwitchOn();
  this->Shadows->SetTechnique("depth-map");
  Check("pixels unlike the first frame", static_cast<double>(CountDifferent(both, this->Render())),
    0.0);
}

TEST_F(Lights, SixteenLights)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->CheckTechniques("16 lights", AddRing(this->Renderer, 16));
}

// With maps of one view and of several.
TEST_F(Lights, SixteenLightsOfEveryKind)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Shadows->GetDepthShadowMapPass()->SetResolution(1024);
  Lamps lamps = AddRing(this->Renderer, 10);
  for (int i = 0; i < 6; ++i)
  {
    const glm::dvec3 place(-0.2 + 0.1 * i, -1.5 + 0.5 * i, 1.0 + 0.1 * i);
    lamps.push_back(
      AddSpot(this->Renderer, place, { 0.1 * i, 0.0, 0.2 }, i % 2 == 0 ? 180.0 : 82.0 + i));
    lamps.back()->SetIntensity(0.08);
  }
  this->CheckColours("16 lights of every kind", lamps);
  for (vtkLight* lamp : lamps)
  {
    this->CheckMeasure("16 lights of every kind", lamp, Mismatch, Gross);
  }
}

// From nine depth maps on, not every light's position can go through the rasteriser.
TEST_F(Lights, MoreDepthMapsThanVaryings)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Shadows->GetDepthShadowMapPass()->SetResolution(1024);
  for (const int count : { 9, 12 })
  {
    const Lamps lamps = AddRing(this->Renderer, count);
    this->CheckColours(std::to_string(count) + " lights", lamps);
    for (vtkLight* lamp : lamps)
    {
      this->CheckMeasure(std::to_string(count) + " lights", lamp, Mismatch, Gross);
      this->Renderer->RemoveLight(lamp);
    }
  }
}

TEST_F(Lights, Strength)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Lamps lamps = { AddSun(this->Renderer, { 1.0, 0.7, -1.2 }) };
  const Frame lit = this->RenderWithoutPass();
  const Frame dark = this->RenderWithout(lamps, 1);
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    const Visibility visibility = this->VisibilityBy(technique, lamps[0]);
    for (const double strength : { 0.0, 0.5, 1.0 })
    {
      this->Shadows->SetLightStrength(lamps[0], strength);
      const Frame frame = this->Render();
      std::size_t wrong = 0, asked = 0;
      for (std::size_t i = 0; i < frame.rgb.size(); ++i)
      {
        const float seen = visibility.values[i / 3];
        const double expected = lit.rgb[i] + strength * (1.0 - seen) * (dark.rgb[i] - lit.rgb[i]);
        const bool isWhole = seen == 0.0f || seen == 1.0f;
        wrong += isWhole && std::abs(frame.rgb[i] - expected) > 1.0 ? 1 : 0;
        asked += seen == 0.0f ? 1 : 0;
      }
      EXPECT_GT(asked, 3000u);
      Check("strength " + std::to_string(strength) + ", " + technique + ": wrong components",
        static_cast<double>(wrong), 0.0);
      Check("strength " + std::to_string(strength) + ", " + technique +
          ": visibility that strength changed",
        static_cast<double>(CountDifferent(visibility, this->VisibilityOf(lamps[0]))), 0.0);
    }
  }
}

TEST_F(Lights, StrengthZeroCostsNothing)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto lamp = AddSun(this->Renderer, { 1.0, 0.7, -1.2 });
  this->Shadows->SetLightStrength(lamp, 0.0);
  const Frame frame = this->Render();
  Check("pixels unlike the unshadowed frame",
    static_cast<double>(CountDifferent(frame, this->RenderWithoutPass())), 0.0);
  Check("maps drawn",
    static_cast<double>(this->Shadows->GetDepthShadowMapPass()->GetNumberOfMapBuilds()), 0.0);
}

TEST_F(Lights, StrengthsOfTwoLights)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto half = AddSun(this->Renderer, { 1.0, 0.7, -1.2 });
  auto whole = AddSun(this->Renderer, { -1.0, 0.5, -1.2 });
  half->SetIntensity(0.5);
  whole->SetIntensity(0.5);
  this->Shadows->SetLightStrength(half, 0.5);

  const Frame lit = this->RenderWithoutPass();
  half->SetIntensity(0.25);
  const Frame halfLit = this->RenderWithoutPass();
  half->SetIntensity(0.5);
  const Visibility ofHalf = this->VisibilityBy("depth-map", half);
  const Visibility ofWhole = this->VisibilityOf(whole);
  const Frame frame = this->Render();
  std::size_t wrong = 0, asked = 0;
  for (std::size_t i = 0; i < frame.rgb.size(); ++i)
  {
    if (ofWhole.values[i / 3] == 1.0f && ofHalf.values[i / 3] == 0.0f)
    {
      wrong += std::abs(frame.rgb[i] - halfLit.rgb[i]) > 1 ? 1 : 0;
      ++asked;
    }
    if (ofWhole.values[i / 3] == 1.0f && ofHalf.values[i / 3] == 1.0f)
    {
      wrong += std::abs(frame.rgb[i] - lit.rgb[i]) > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(asked, 3000u);
  Check("wrong components", static_cast<double>(wrong), 0.0);
}

// However the props themselves are shaded.
TEST_F(Lights, ShadingModels)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Lamps lamps = { AddSun(this->Renderer, { 1.0, 0.7, -1.2 }),
    AddSpot(this->Renderer, { 2.5, -2.0, 5.0 }, { 0.0, 0.0, 0.5 }, 40.0) };
  const std::pair<std::string, std::function<void(vtkProperty*)>> models[] = {
    { "flat", [](vtkProperty* p) { p->SetInterpolationToFlat(); } },
    { "Gouraud", [](vtkProperty* p) { p->SetInterpolationToGouraud(); } },
    { "PBR", [](vtkProperty* p) { p->SetInterpolationToPBR(); } },
    { "edges", [](vtkProperty* p) { p->EdgeVisibilityOn(); } },
    { "front faces culled", [](vtkProperty* p) { p->FrontfaceCullingOn(); } },
  };
  for (const auto& model : models)
  {
    vtkActorCollection* actors = this->Renderer->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor())
    {
      vtkNew<vtkProperty> property;
      property->SetColor(0.7, 0.6, 0.5);
      model.second(property);
      // The floor has but one face.
      actor->SetProperty(actor->GetZRange()[1] > 0.0 ? property.Get() : actor->GetProperty());
    }
    for (const std::string technique : { "depth-map", "ray-cast" })
    {
      this->Shadows->SetTechnique(technique);
      this->CheckColours(model.first + ", " + technique, lamps);
    }
  }
}

// A prop without lighting has no light to take away, and casts all the same.
TEST_F(Lights, UnlitProps)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto sun = AddSun(this->Renderer, { 1.0, 0.7, -1.2 });
  auto unlit = AddSphere(this->Renderer, { -0.2, -1.6, 0.8 }, 0.4);
  unlit->GetProperty()->SetColor(0.2, 0.9, 0.4);
  unlit->GetProperty()->LightingOff();
  const Frame plain = this->RenderWithoutPass();
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    const Frame frame = this->Render();
    const Pixel p = PixelOf(this->Renderer, { -0.2, -1.9, 0.9 });
    Check(technique + ": brightness of the unlit prop", frame.Brightness(p.x, p.y),
      plain.Brightness(p.x, p.y));
    const Visibility with = this->VisibilityOf(sun);
    unlit->VisibilityOff();
    CheckAtLeast(technique + ": pixels that it shadows",
      static_cast<double>(CountDifferent(with, this->VisibilityBy(technique, sun))), 500.0);
    unlit->VisibilityOn();
  }
}

TEST_F(Lights, MixedTechniques)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Lamps lamps = { AddSun(this->Renderer, { 1.0, 0.7, -1.2 }),
    AddSpot(this->Renderer, { 2.5, -2.0, 5.0 }, { 0.0, 0.0, 0.5 }, 40.0),
    AddSun(this->Renderer, { -1.0, 0.5, -1.2 }) };
  const char* techniques[] = { "depth-map", "ray-cast", "none" };
  std::vector<Visibility> alone;
  for (int i = 0; i < 3; ++i)
  {
    lamps[i]->SetIntensity(0.4);
    alone.push_back(this->VisibilityBy(techniques[i], lamps[i]));
  }
  this->Shadows->SetTechnique("none");
  this->Shadows->SetLightTechnique(lamps[0], "depth-map");
  this->Shadows->SetLightTechnique(lamps[1], "ray-cast");
  this->CheckColours("mixed", lamps);
  for (int i = 0; i < 3; ++i)
  {
    Check(std::string("visibility by ") + techniques[i] + ": pixels unlike the technique alone",
      static_cast<double>(CountDifferent(alone[i], this->VisibilityOf(lamps[i]))), 0.0);
  }
  Check("shadow pixels by none", static_cast<double>(alone[2].CountShadowed()), 0.0);
}

// A light without shadows beside shadowed ones, first and last in the list.
TEST_F(Lights, HeadlightAmongOthers)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto headlight = AddSun(this->Renderer, { 0.0, 0.0, -1.0 });
  headlight->SetLightTypeToHeadlight();
  headlight->SetIntensity(0.4);
  auto sun = AddSun(this->Renderer, { 1.0, 0.7, -1.2 });
  sun->SetIntensity(0.6);
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    this->CheckColours("headlight first, " + technique, { headlight, sun });
    this->Renderer->RemoveLight(headlight);
    this->Renderer->AddLight(headlight);
    this->CheckColours("headlight last, " + technique, { sun, headlight });
  }
}
