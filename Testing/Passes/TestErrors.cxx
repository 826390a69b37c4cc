// A wrong call or an impossible scene gets one message that names the object, the value and the
// remedy; the frame is still drawn, lit where there is no visibility. What is merely empty gets
// none.
#include "ShadowTest.h"

#include "vtkShadowErrorMeasure.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowScene.h"

#include <vtkActorCollection.h>
#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

using namespace shadowtest;

namespace
{

class Errors : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Renderer->SetPass(this->Shadows);
  }

  void AddScene()
  {
    AddFloor(this->Renderer, 5.0);
    this->Box = AddBox(this->Renderer, { -0.6, -0.6, 1.0 }, { 0.6, 0.6, 1.6 });
    this->Light = AddSun(this->Renderer, { 0.6, 0.3, -1.0 });
    LookAt(this->Renderer, { 0.0, -6.0, 6.0 }, { 0.0, 0.0, 0.3 });
  }

  // Of every actor.
  void SetKeys(bool casts, bool receives)
  {
    vtkActorCollection* actors = this->Renderer->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor())
    {
      vtkShadowPass::SetCastsShadows(actor, casts);
      vtkShadowPass::SetReceivesShadows(actor, receives);
    }
  }

  // The frame is VTK's own: everything is lit.
  void CheckLit(const std::string& what, const Frame& frame)
  {
    Check(what + ": pixels unlike the unshadowed frame",
      static_cast<double>(CountDifferent(frame, this->RenderWithoutPass())), 0.0);
  }
  void CheckShadowed(const std::string& what, const Frame& frame)
  {
    CheckAtLeast(what + ": pixels in shadow",
      static_cast<double>(CountDifferent(frame, this->RenderWithoutPass(), 60)), 1000.0);
  }

  vtkSmartPointer<vtkActor> Box;
  vtkSmartPointer<vtkLight> Light;
};

}

//------------------------------------------------------------------------------
// Wrong calls.
TEST_F(Errors, UnknownTechnique)
{
  this->AddScene();
  EXPECT_FALSE(this->Shadows->SetTechnique("depth-mop"));
  ExpectOneMessage({ "vtkShadowPass", "\"depth-mop\"", "depth-map", "none" });
  EXPECT_EQ(this->Shadows->GetTechnique(), "depth-map");
  EXPECT_FALSE(this->Shadows->SetLightTechnique(this->Light, "Ray-Cast"));
  ExpectOneMessage({ "vtkShadowPass", "\"Ray-Cast\"", "depth-map", "none" });
  EXPECT_EQ(this->Shadows->GetLightTechnique(this->Light), "depth-map");
  EXPECT_FALSE(this->Shadows->SetTechnique(""));
  ExpectOneMessage({ "vtkShadowPass", "\"\"", "depth-map" });
  this->CheckShadowed("after all that", this->Render());
}

TEST_F(Errors, RadiusAndStrength)
{
  this->AddScene();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double radius : { -1.0, nan, infinity })
  {
    this->Shadows->SetLightRadius(this->Light, radius);
    ExpectOneMessage({ "vtkShadowPass", "SetLightRadius", "0 or more" });
    Check("radius", this->Shadows->GetLightRadius(this->Light), 0.0);
  }
  for (const double strength : { nan, infinity, -infinity })
  {
    this->Shadows->SetLightStrength(this->Light, strength);
    ExpectOneMessage({ "vtkShadowPass", "SetLightStrength", "0 to 1" });
    Check("strength", this->Shadows->GetLightStrength(this->Light), 1.0);
  }
  this->Shadows->SetLightStrength(this->Light, 7.0);
  Check("strength 7, clamped", this->Shadows->GetLightStrength(this->Light), 1.0);
  this->Shadows->SetLightStrength(this->Light, -7.0);
  Check("strength -7, clamped", this->Shadows->GetLightStrength(this->Light), 0.0);
}

TEST_F(Errors, Nothing)
{
  this->AddScene();
  this->Render();
  vtkNew<vtkImageData> image;
  vtkNew<vtkRenderer> elsewhere;
  EXPECT_FALSE(this->Shadows->SetLightTechnique(nullptr, "none"));
  ExpectOneMessage({ "vtkShadowPass", "nullptr", "vtkLight" });
  this->Shadows->SetLightStrength(nullptr, 0.5);
  ExpectOneMessage({ "vtkShadowPass", "vtkLight" });
  this->Shadows->SetLightRadius(nullptr, 0.5);
  ExpectOneMessage({ "vtkShadowPass", "vtkLight" });
  EXPECT_FALSE(this->Shadows->GetVisibility(nullptr, this->Light, image));
  ExpectOneMessage({ "vtkShadowPass", "renderer", "Render()" });
  EXPECT_FALSE(this->Shadows->GetVisibility(this->Renderer, nullptr, image));
  ExpectOneMessage({ "vtkShadowPass", "light" });
  EXPECT_FALSE(this->Shadows->GetVisibility(this->Renderer, this->Light, nullptr));
  ExpectOneMessage({ "vtkShadowPass", "vtkImageData" });
  EXPECT_FALSE(this->Shadows->GetVisibility(elsewhere, this->Light, image));
  ExpectOneMessage({ "vtkShadowPass", "window", "Render()" });
  EXPECT_FALSE(this->Shadows->GetVisibilities(nullptr, image));
  ExpectOneMessage({ "vtkShadowPass", "renderer", "Render()" });
  EXPECT_FALSE(this->Shadows->GetVisibilities(this->Renderer, nullptr));
  ExpectOneMessage({ "vtkShadowPass", "vtkImageData" });

  // These have a meaning.
  this->Shadows->ClearLightSettings(nullptr);
  this->Shadows->SetDelegatePass(nullptr);
  vtkShadowPass::SetCastsShadows(nullptr, true);
  vtkShadowPass::SetReceivesShadows(nullptr, true);
  EXPECT_EQ(this->Shadows->GetLightTechnique(nullptr), "depth-map");
  Check("strength of nothing", this->Shadows->GetLightStrength(nullptr), 1.0);
  EXPECT_EQ(this->Shadows->GetTechniquePass("depth-mop"), nullptr);
  this->CheckShadowed("after all that", this->Render());
}

TEST_F(Errors, VisibilityOfTheWrongLight)
{
  this->AddScene();
  this->Render();
  vtkNew<vtkImageData> image;
  vtkNew<vtkLight> foreign;
  EXPECT_FALSE(this->Shadows->GetVisibility(this->Renderer, foreign, image));
  ExpectOneMessage({ "vtkShadowPass", "light", "add it" });
  auto off = AddSun(this->Renderer, { 1.0, 0.0, -1.0 });
  off->SwitchOff();
  EXPECT_FALSE(this->Shadows->GetVisibility(this->Renderer, off, image));
  ExpectOneMessage({ "vtkShadowPass", "light", "switch it on" });
}

// A window of its own: it is the only one that never renders.
TEST_F(Errors, VisibilityAheadOfTheFirstFrame)
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->OffScreenRenderingOn();
  window->AddRenderer(renderer);
  renderer->SetPass(this->Shadows);
  auto light = AddSun(renderer, { 0.0, 0.0, -1.0 });
  vtkNew<vtkImageData> image;
  EXPECT_FALSE(this->Shadows->GetVisibility(renderer, light, image));
  ExpectOneMessage({ "vtkShadowPass", "renderer", "Render()" });
  renderer->SetPass(nullptr);
}

TEST_F(Errors, MeasureWithoutAShadowPass)
{
  this->AddScene();
  this->Renderer->SetPass(nullptr);
  this->Render();
  vtkNew<vtkShadowErrorMeasure> error;
  EXPECT_FALSE(error->Measure(this->Renderer, this->Light));
  ExpectOneMessage({ "vtkShadowErrorMeasure", "vtkShadowPass", "SetPass" });
  EXPECT_FALSE(error->Measure(nullptr, this->Light));
  ExpectOneMessage({ "vtkShadowErrorMeasure", "vtkShadowPass" });
}

TEST_F(Errors, MeasureAgainWithoutATruthOrWithAnotherSize)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->AddScene();
  this->Render();
  vtkNew<vtkShadowErrorMeasure> error;
  vtkNew<vtkImageData> image;
  EXPECT_FALSE(error->MeasureAgain(image));
  ExpectOneMessage({ "vtkShadowErrorMeasure", "no truth", "Measure" });
  ASSERT_TRUE(error->Measure(this->Renderer, this->Light));
  const vtkIdType receivers = error->GetReceiverPixels(), shadow = error->GetShadowPixels();
  const vtkIdType uncertain = error->GetUncertainPixels();
  image->SetDimensions(7, 5, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  EXPECT_FALSE(error->MeasureAgain(image));
  ExpectOneMessage({ "vtkShadowErrorMeasure", "float component 0", "400 x 300" });
  EXPECT_FALSE(error->MeasureAgain(nullptr));
  ExpectOneMessage({ "vtkShadowErrorMeasure", "float component 0" });
  Check("receivers", double(error->GetReceiverPixels()), double(receivers));

  // The truth itself is right; lit everywhere, what is in shadow is missed; no number is left out.
  image->DeepCopy(error->GetTruth());
  ASSERT_TRUE(error->MeasureAgain(image));
  Check("mismatch of the truth", double(error->GetMismatchPixels()), 0.0);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  std::fill_n(values, image->GetNumberOfPoints(), 1.0f);
  ASSERT_TRUE(error->MeasureAgain(image));
  CheckAtLeast("shadow", double(shadow), 1.0);
  Check("mismatch of light", double(error->GetMismatchPixels()), double(shadow));
  std::fill_n(values, image->GetNumberOfPoints(), std::nanf(""));
  ASSERT_TRUE(error->MeasureAgain(image));
  Check("receivers of no number", double(error->GetReceiverPixels()), 0.0);
  Check("left out", double(error->GetUncertainPixels()), double(uncertain + receivers));

  // Of several lights.
  const int* size = error->GetTruth()->GetDimensions();
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(VTK_FLOAT, 2);
  values = static_cast<float*>(image->GetScalarPointer());
  const auto* truth = static_cast<float*>(error->GetTruth()->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values[2 * i] = 1.0f;
    values[2 * i + 1] = truth[i];
  }
  ASSERT_TRUE(error->MeasureAgain(image, 1));
  Check("mismatch of the second component", double(error->GetMismatchPixels()), 0.0);
  ASSERT_TRUE(error->MeasureAgain(image, 0));
  Check("mismatch of the first", double(error->GetMismatchPixels()), double(shadow));
  EXPECT_FALSE(error->MeasureAgain(image, 2));
  ExpectOneMessage({ "vtkShadowErrorMeasure", "float component 2" });
}

//------------------------------------------------------------------------------
// Resolutions.
TEST_F(Errors, ResolutionOfNothing)
{
  this->AddScene();
  vtkDepthShadowMapPass* maps = this->Shadows->GetDepthShadowMapPass();
  for (const int resolution : { 0, -5 })
  {
    maps->SetResolution(resolution);
    ExpectOneMessage({ "vtkDepthShadowMapPass", std::to_string(resolution), "1 or more" });
    Check("resolution", maps->GetResolution(), 2048);
  }
  for (const int resolution : { 1, 2, 3, 7, 64 })
  {
    maps->SetResolution(resolution);
    this->Render();
  }
  this->CheckShadowed("resolution 64", this->Render());
}

TEST_F(Errors, ResolutionAboveTheDrivers)
{
  this->AddScene();
  this->Render();
  int limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  this->Shadows->GetDepthShadowMapPass()->SetResolution(limit + 1);
  const Frame frame = this->Render();
  std::vector<std::string> messages = TakeMessages();
  ASSERT_FALSE(messages.empty());
  // The driver may have no memory for the largest map there is: a second message, and everything is
  // lit.
  EXPECT_NE(messages[0].find(std::to_string(limit + 1)), std::string::npos) << messages[0];
  EXPECT_NE(messages[0].find(std::to_string(limit)), std::string::npos) << messages[0];
  EXPECT_NE(messages[0].find("vtkDepthShadowMapPass"), std::string::npos) << messages[0];
  if (messages.size() == 1)
  {
    this->CheckShadowed("above the limit", frame);
  }
  else
  {
    Check("messages", static_cast<double>(messages.size()), 2.0);
    EXPECT_NE(messages[1].find("memory"), std::string::npos) << messages[1];
    EXPECT_NE(messages[1].find("Lower the resolution"), std::string::npos) << messages[1];
    this->CheckLit("no memory", frame);
  }
  this->Render();
  Check("messages by the next frame", static_cast<double>(TakeMessages().size()), 0.0);
  this->Shadows->GetDepthShadowMapPass()->SetResolution(512);
  this->CheckShadowed("back to 512", this->Render());
}

//------------------------------------------------------------------------------
// Memory for a cube's maps, but not for six of that size; and back.
TEST_F(Errors, MapsOfAPointLightWithoutMemory)
{
  this->AddScene();
  this->Renderer->RemoveLight(this->Light);
  AddBox(this->Renderer, { -9.0, -9.0, -1.0 }, { 9.0, 9.0, 12.0 });
  AddLamp(this->Renderer, { 0.2, 0.1, 2.8 });
  this->Render();
  int limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  this->Shadows->GetDepthShadowMapPass()->SetResolution(limit);
  const Frame frame = this->Render();
  const std::vector<std::string> messages = TakeMessages();
  if (messages.empty())
  {
    this->CheckShadowed("a driver with memory", frame);
    return;
  }
  Check("messages", static_cast<double>(messages.size()), 1.0);
  EXPECT_NE(messages[0].find("memory for 6 shadow maps"), std::string::npos) << messages[0];
  EXPECT_NE(messages[0].find("Lower the resolution"), std::string::npos) << messages[0];
  this->CheckLit("no memory", frame);
  this->Render();
  Check("messages by the next frame", static_cast<double>(TakeMessages().size()), 0.0);
  this->Shadows->GetDepthShadowMapPass()->SetResolution(512);
  this->CheckShadowed("back to 512", this->Render());
}

//------------------------------------------------------------------------------
// Scenes that cannot be served, and one that is.
TEST_F(Errors, PointLightAmidItsCasters)
{
  this->AddScene();
  this->Renderer->RemoveLight(this->Light);
  for (const glm::dvec3& place : { glm::dvec3(2, 0, 1), { -2, 0, 1 }, { 0, 2, 1 }, { 0, 0, 3 } })
  {
    AddSphere(this->Renderer, place, 0.3);
  }
  auto lamp = AddLamp(this->Renderer, { 0.2, 0.1, 2.2 });
  for (const glm::dvec3& place :
    { glm::dvec3(0.2, 0.1, 2.2), { 3.0, -3.0, 9.0 }, { 0.2, 0.1, 2.2 } })
  {
    lamp->SetPosition(place.x, place.y, place.z);
    this->CheckShadowed("amid its casters, outside, and amid them", this->Render());
    Check("messages", static_cast<double>(TakeMessages().size()), 0.0);
    if (this->Shadows->GetRayCastShadowPass())
    {
      this->CheckMeasure("amid its casters, outside, and amid them", lamp, 0.1, 0.005);
    }
  }
}

TEST_F(Errors, ShaderWithoutTags)
{
  this->AddScene();
  auto odd = AddBox(this->Renderer, { -3.0, 0.0, 0.5 }, { -2.0, 1.0, 1.2 });
  odd->GetShaderProperty()->SetFragmentShaderCode("//VTK::System::Dec\n"
                                                  "//VTK::Output::Dec\n"
                                                  "void main()\n"
                                                  "{\n"
                                                  "  gl_FragData[0] = vec4(0.2, 0.9, 0.4, 1.0);\n"
                                                  "}\n");
  const Frame plain = this->RenderWithoutPass();
  TakeMessages();
  for (const std::string technique : { "depth-map", "stencil-volume", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    const Frame frame = this->Render();
    if (technique == "depth-map")
    {
      ExpectOneMessage({ "vtkOpenGLActor", "//VTK::Light::Impl", "Keep these tags" });
    }
    this->CheckShadowed("the others, " + technique, frame);
    const Pixel p = PixelOf(this->Renderer, { -2.5, 0.5, 1.2 });
    Check("brightness of the actor itself, " + technique, frame.Brightness(p.x, p.y),
      plain.Brightness(p.x, p.y));
    this->VisibilityOf(this->Light);
    this->Render();
    Check("more messages, " + technique, static_cast<double>(TakeMessages().size()), 0.0);
  }
}

// No ray hits a line: said once for the caster.
TEST_F(Errors, LinesByRayCast)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->AddScene();
  auto wires = AddBox(this->Renderer, { -2.0, -1.0, 0.5 }, { -1.0, 0.0, 1.5 });
  wires->GetProperty()->SetRepresentationToWireframe();
  this->Shadows->SetTechnique("ray-cast");
  this->CheckShadowed("the others", this->Render());
  ExpectOneMessage({ "vtkRayCastShadowPass", "wireframe", "\"depth-map\"" });
  this->Render();
  Check("messages by the next frame", static_cast<double>(TakeMessages().size()), 0.0);
}

//------------------------------------------------------------------------------
// Scenes that are merely empty.
TEST_F(Errors, EmptyScenes)
{
  for (const std::string technique : { "depth-map", "stencil-volume", "ray-cast", "none" })
  {
    this->Shadows->SetTechnique(technique);
    this->CheckLit("nothing at all, " + technique, this->Render());
    auto light = AddSun(this->Renderer, { 0.6, 0.3, -1.0 });
    this->CheckLit("a light alone, " + technique, this->Render());
    Check("shadow pixels", static_cast<double>(this->VisibilityOf(light).CountShadowed()), 0.0);
    this->Renderer->RemoveAllLights();
  }
}

TEST_F(Errors, NoLights)
{
  this->AddScene();
  for (const bool automatic : { true, false })
  {
    this->Renderer->RemoveAllLights();
    this->Renderer->SetAutomaticLightCreation(automatic);
    for (const std::string technique : { "depth-map", "stencil-volume", "ray-cast" })
    {
      this->Shadows->SetTechnique(technique);
      this->CheckLit("no light, " + technique, this->Render());
    }
  }
}

TEST_F(Errors, NoCastersAndNoReceivers)
{
  this->AddScene();
  for (const std::string technique : { "depth-map", "stencil-volume", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    this->SetKeys(false, true);
    this->CheckLit("no casters, " + technique, this->Render());
    Check("casters", this->Shadows->GetScene()->GetNumberOfCasters(), 0.0);
    Check(
      "shadow pixels", static_cast<double>(this->VisibilityOf(this->Light).CountShadowed()), 0.0);

    this->SetKeys(true, false);
    this->CheckLit("no receivers, " + technique, this->Render());
    Check("receivers", this->Shadows->GetScene()->GetNumberOfReceivers(), 0.0);
    Check(
      "shadow pixels", static_cast<double>(this->VisibilityOf(this->Light).CountShadowed()), 0.0);
  }
}

TEST_F(Errors, CastersOutOfReach)
{
  AddFloor(this->Renderer, 5.0);
  AddSphere(this->Renderer, { 0.0, 0.0, -3.0 }, 0.5); // behind the floor, as the light sees it
  auto light = AddSun(this->Renderer, { 0.0, 0.0, -1.0 });
  LookAt(this->Renderer, { 0.0, -6.0, 6.0 }, { 0.0, 0.0, 0.3 });
  for (const std::string technique : { "depth-map", "stencil-volume", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    this->CheckLit("behind the floor, " + technique, this->Render());
  }
  light->SwitchOff();
}

TEST_F(Errors, EmptyAndBrokenMeshes)
{
  this->AddScene();
  vtkNew<vtkPolyData> empty, pointless, degenerate;
  vtkNew<vtkCellArray> nothing;
  pointless->SetPolys(nothing);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.0, 1.0, 1.0);
  points->InsertNextPoint(2.0, 1.0, 1.0);
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 1 });
  polys->InsertNextCell({ 0, 0, 0 });
  degenerate->SetPoints(points);
  degenerate->SetPolys(polys);
  for (vtkPolyData* mesh : { empty.Get(), pointless.Get(), degenerate.Get() })
  {
    AddActor(this->Renderer, mesh);
  }
  vtkNew<vtkActor> noMapper;
  this->Renderer->AddActor(noMapper);
  for (const std::string technique : { "depth-map", "stencil-volume", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    this->CheckShadowed(technique, this->Render());
  }
}

// Told once, whatever the technique, and again if it comes back.
TEST_F(Errors, BoundsThatAreNotFinite)
{
  this->AddScene();
  auto ball = AddSphere(this->Renderer, { -2.0, 0.0, 1.0 }, 0.4);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const std::string technique : { "depth-map", "stencil-volume", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    ball->SetPosition(0.0, infinity, 0.0);
    this->CheckShadowed(technique + ", the others", this->Render());
    std::ostringstream name;
    name << "vtkOpenGLActor (" << ball.Get() << ")";
    ExpectOneMessage({ "vtkShadowScene", name.str(), "not finite", "matrix" });
    this->Render();
    Check("messages by the next frame", static_cast<double>(TakeMessages().size()), 0.0);
    ball->SetPosition(0.0, 0.0, 0.0);
    this->CheckShadowed(technique + ", repaired", this->Render());
  }
}

// Lengths of it, squared, are no floats any more.
TEST_F(Errors, BoundsTooLargeForFloats)
{
  this->AddScene();
  auto ball = AddSphere(this->Renderer, { -2.0, 0.0, 1.0 }, 0.4);
  ball->SetPosition(0.0, 1.0e30, 0.0);
  for (const std::string technique : { "depth-map", "stencil-volume", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    this->CheckShadowed(technique + ", the others", this->Render());
  }
  ExpectOneMessage({ "vtkShadowScene", "too large for OpenGL's floats", "matrix" });
}

// Lights that point nowhere, and scales of nothing.
TEST_F(Errors, DegenerateLightsAndMatrices)
{
  this->AddScene();
  auto nowhere = AddSun(this->Renderer, { 0.0, 0.0, 0.0 });
  nowhere->SetIntensity(0.0);
  auto inside = AddSpot(this->Renderer, { 0.0, 0.0, 1.3 }, { 0.0, 0.0, 1.3 }, 30.0);
  inside->SetIntensity(0.0);
  auto flat = AddSphere(this->Renderer, { 0.0, 0.0, 0.0 }, 0.5);
  flat->SetPosition(-2.0, 0.0, 1.0);
  flat->SetScale(1.0, 1.0, 0.0);
  for (const std::string technique : { "depth-map", "stencil-volume", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    this->CheckShadowed(technique, this->Render());
  }
  // Whatever is said of them is a warning, once.
  CheckAtMost("messages", static_cast<double>(TakeMessages().size()), 2.0);
}

//------------------------------------------------------------------------------
// Life.
TEST_F(Errors, PassesComeAndGo)
{
  this->AddScene();
  for (int i = 0; i < 5; ++i)
  {
    vtkNew<vtkShadowPass> passing;
    passing->SetTechnique(i % 2 == 0 ? "depth-map" : "ray-cast");
    this->Renderer->SetPass(passing);
    this->CheckShadowed("pass " + std::to_string(i), this->Render());
    this->Renderer->SetPass(nullptr);
    passing->ReleaseGraphicsResources(this->Window);
    passing->ReleaseGraphicsResources(this->Window);
  }
  // Released while it is in use, it comes back.
  this->Renderer->SetPass(this->Shadows);
  this->Render();
  this->Shadows->ReleaseGraphicsResources(this->Window);
  this->CheckShadowed("released in use", this->Render());
}

// A light's settings go with the light, and do not pass to another that happens to get its memory.
TEST_F(Errors, SettingsOfLightsThatAreGone)
{
  this->AddScene();
  for (int i = 0; i < 20; ++i)
  {
    vtkNew<vtkLight> passing;
    Check("strength of a new light", this->Shadows->GetLightStrength(passing), 1.0);
    this->Shadows->SetLightStrength(passing, 0.25);
    this->Shadows->SetLightTechnique(passing, "none");
    Check("strength as set", this->Shadows->GetLightStrength(passing), 0.25);
  }
  this->Shadows->SetLightStrength(this->Light, 0.25);
  this->Shadows->ClearLightSettings(this->Light);
  Check("strength once cleared", this->Shadows->GetLightStrength(this->Light), 1.0);
}

TEST_F(Errors, Prints)
{
  this->AddScene();
  this->Render();
  std::ostringstream text;
  this->Shadows->Print(text);
  this->Shadows->GetDepthShadowMapPass()->Print(text);
  this->Shadows->GetStencilShadowVolumePass()->Print(text);
  this->Shadows->GetScene()->Print(text);
  vtkNew<vtkShadowErrorMeasure> error;
  error->Print(text);
  for (const std::string part : { "Technique: depth-map", "Resolution: 2048", "NumberOfLights: 1",
         "Variant: 0", "NumberOfOverflows: 0" })
  {
    EXPECT_NE(text.str().find(part), std::string::npos) << "no \"" << part << "\"";
  }
}
