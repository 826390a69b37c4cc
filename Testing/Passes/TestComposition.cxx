// Shadows among everything else that VTK's users combine. In each combination: with every light
// "none" the frame is VTK's own to the byte, shadows are where they should be by either technique,
// and without the pass the frame is as it was before.
#include "ShadowTest.h"

#include "vtkShadowOpenGL.h"

#include <vtkActorCollection.h>
#include <vtkDataObject.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkHardwareSelector.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkLightCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLFXAAPass.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkSSAAPass.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTransform.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkWindowToImageFilter.h>

#include <glm/geometric.hpp>

#include <algorithm>

using namespace shadowtest;

namespace
{

// A floor, and a box that floats over it in the sun; two places on the floor of which one is in its
// shadow.
const glm::dvec3 SunAlong(0.6, 0.3, -1.0);
const glm::dvec3 LitPlace(-0.9, -1.2, 0.0), ShadowPlace(0.95, 0.4, 0.0);

void AddScene(vtkRenderer* renderer)
{
  AddFloor(renderer, 5.0)->GetProperty()->SetColor(0.9, 0.85, 0.8);
  AddBox(renderer, { -0.6, -0.6, 1.0 }, { 0.6, 0.6, 1.6 })->GetProperty()->SetColor(0.3, 0.5, 0.8);
  AddSun(renderer, SunAlong);
  LookAt(renderer, { 0.0, -6.0, 6.0 }, { 0.0, 0.0, 0.3 });
}

class Composition : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    AddScene(this->Renderer);
  }

  // Holds the combination as it is set up now against what the head of this file promises.
  void CheckCombination(const std::string& what);
  void CheckSamples(
    const std::string& what, const Frame& frame, const Frame& unshadowed, vtkRenderer* renderer);
};

// Frame and unshadowed frame are of the whole window; the places are those of `renderer`'s
// viewport.
void Composition::CheckSamples(
  const std::string& what, const Frame& frame, const Frame& unshadowed, vtkRenderer* renderer)
{
  const int* origin = renderer->GetOrigin();
  const Pixel lit = PixelOf(renderer, LitPlace), shadow = PixelOf(renderer, ShadowPlace);
  Check(what + ": brightness of the lit place",
    frame.Brightness(origin[0] + lit.x, origin[1] + lit.y),
    unshadowed.Brightness(origin[0] + lit.x, origin[1] + lit.y), 3.0);
  CheckAtMost(what + ": brightness of the shadowed place",
    frame.Brightness(origin[0] + shadow.x, origin[1] + shadow.y),
    0.6 * unshadowed.Brightness(origin[0] + shadow.x, origin[1] + shadow.y));
}

void Composition::CheckCombination(const std::string& what)
{
  this->Renderer->SetPass(nullptr);
  const Frame plain = this->Render();
  Check(what + ": pixels that VTK itself draws anew",
    static_cast<double>(CountDifferent(plain, this->Render())), 0.0);

  this->Renderer->SetPass(this->Shadows);
  this->Shadows->SetTechnique("none");
  Check(what + ": pixels changed by the pass with lights of \"none\"",
    static_cast<double>(CountDifferent(plain, this->Render())), 0.0);
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    this->CheckSamples(what + ", " + technique, this->Render(), plain, this->Renderer);
  }

  this->Renderer->SetPass(nullptr);
  Check(what + ": pixels changed after the pass is gone",
    static_cast<double>(CountDifferent(plain, this->Render())), 0.0);
}

vtkSmartPointer<vtkActor> AddPane(vtkRenderer* renderer, double height)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-3.5, -0.5, height);
  plane->SetPoint1(-2.5, -0.5, height);
  plane->SetPoint2(-3.5, 0.5, height);
  auto pane = AddActor(renderer, plane);
  pane->GetProperty()->SetOpacity(0.5);
  pane->GetProperty()->SetColor(0.9, 0.2, 0.2);
  return pane;
}

void AddVolume(vtkRenderer* renderer)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 16, 16);
  image->SetSpacing(0.08, 0.08, 0.08);
  image->SetOrigin(-3.5, -0.5, 0.2);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 16 * 16 * 16; ++i)
  {
    const glm::dvec3 p(i % 16 - 7.5, (i / 16) % 16 - 7.5, i / 256 - 7.5);
    values[i] = glm::length(p) < 6.0 ? 200 : 0;
  }
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(200.0, 0.4);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetInterpolationTypeToLinear();
  renderer->AddVolume(volume);
}

}

//------------------------------------------------------------------------------
TEST_F(Composition, Plain)
{
  this->CheckCombination("plain");
}

TEST_F(Composition, TranslucentProps)
{
  AddPane(this->Renderer, 0.5);
  this->CheckCombination("translucent");
}

TEST_F(Composition, DepthPeeling)
{
  this->Window->SetAlphaBitPlanes(1);
  this->Renderer->UseDepthPeelingOn();
  this->Renderer->SetMaximumNumberOfPeels(4);
  AddPane(this->Renderer, 0.5);
  AddPane(this->Renderer, 1.0)->GetProperty()->SetColor(0.2, 0.9, 0.2);
  this->CheckCombination("depth peeling");
}

// A depth map is looked up wherever a fragment is; a mask knows the opaque ones.
TEST_F(Composition, TranslucentPropsReceiveDepthMapsOnly)
{
  for (const bool peeling : { false, true })
  {
    this->Window->SetAlphaBitPlanes(1);
    this->Renderer->SetUseDepthPeeling(peeling);
    auto pane = AddPane(this->Renderer, 0.3);
    pane->SetPosition(3.8, 0.3, 0.0); // under the box's shadow
    this->Renderer->SetPass(nullptr);
    const Frame plain = this->Render();
    const Frame opaqueHidden = [&]()
    {
      pane->VisibilityOff();
      const Frame frame = this->Render();
      pane->VisibilityOn();
      return frame;
    }();
    const Pixel p = PixelOf(this->Renderer, ShadowPlace + 0.3 * glm::dvec3(-0.6, -0.3, 1.0));
    ASSERT_NE(plain.Brightness(p.x, p.y), opaqueHidden.Brightness(p.x, p.y)) << "no pane there";

    // Over the shadowed, black floor there is only the pane's own share: dark by map, lit by mask.
    this->Renderer->SetPass(this->Shadows);
    this->Shadows->SetTechnique("ray-cast");
    const int byMask = this->Render().Brightness(p.x, p.y);
    this->Shadows->SetTechnique("depth-map");
    const int byMap = this->Render().Brightness(p.x, p.y);
    const std::string what = peeling ? "peeled: " : "blended: ";
    CheckAtLeast(what + "pane by ray cast", byMask, 100.0);
    CheckAtMost(what + "pane by depth map", byMap, 0.2 * byMask);
    this->Renderer->RemoveActor(pane);
  }
}

TEST_F(Composition, Volume)
{
  AddVolume(this->Renderer);
  this->CheckCombination("volume");
}

TEST_F(Composition, VolumeAndTranslucentProps)
{
  AddVolume(this->Renderer);
  AddPane(this->Renderer, 0.5);
  this->CheckCombination("volume and translucent");
}

TEST_F(Composition, Overlay)
{
  vtkNew<vtkTextActor> text;
  text->SetInput("overlay");
  text->SetDisplayPosition(10, 10);
  text->GetTextProperty()->SetFontSize(30);
  this->Renderer->AddActor2D(text);
  this->CheckCombination("overlay");
}

TEST_F(Composition, FXAA)
{
  this->Renderer->UseFXAAOn();
  this->CheckCombination("FXAA");
}

TEST_F(Composition, SSAO)
{
  this->Renderer->UseSSAOOn();
  this->Renderer->SetSSAORadius(0.5);
  this->CheckCombination("SSAO");
}

TEST_F(Composition, HiddenLineRemoval)
{
  this->Renderer->UseHiddenLineRemovalOn();
  auto wires = AddBox(this->Renderer, { -3.5, 0.0, 0.2 }, { -2.8, 0.7, 0.9 });
  wires->GetProperty()->SetRepresentationToWireframe();
  vtkShadowPass::SetCastsShadows(wires, false);
  this->CheckCombination("hidden line removal");
}

TEST_F(Composition, MultiSamples)
{
  this->Window->SetMultiSamples(0);
  const Frame single = this->Render();
  this->Window->SetMultiSamples(4);
  EXPECT_GT(CountDifferent(single, this->Render()), 50u) << "no multisampling here";
  this->CheckCombination("MSAA 4");
}

TEST_F(Composition, ViewportInTheMiddle)
{
  this->Renderer->SetViewport(0.21, 0.3, 0.77, 0.93);
  this->CheckCombination("viewport");
}

//------------------------------------------------------------------------------
// Other passes.

// Without shadows but under the same passes, the frame is the one to compare with.
TEST_F(Composition, UnderSSAA)
{
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAAPass> ssaa;
  ssaa->SetDelegatePass(steps);
  this->Renderer->SetPass(ssaa);
  const Frame plain = this->Render();

  ssaa->SetDelegatePass(this->Shadows);
  this->Shadows->SetTechnique("none");
  Check("pixels changed by the pass with lights of \"none\"",
    static_cast<double>(CountDifferent(plain, this->Render())), 0.0);
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    this->CheckSamples("under SSAA, " + technique, this->Render(), plain, this->Renderer);
  }
  ssaa->SetDelegatePass(steps);
  Check("pixels changed after the pass is gone",
    static_cast<double>(CountDifferent(plain, this->Render())), 0.0);
}

// In a framebuffer of another pass, VTK's own blending of translucent props loses the depth.
TEST_F(Composition, TranslucentPropsUnderSSAA)
{
  AddPane(this->Renderer, 0.5);
  AddPane(this->Renderer, -0.5)->SetPosition(3.0, 0.5, 0.0); // beneath the floor: hidden
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAAPass> ssaa;
  ssaa->SetDelegatePass(steps);
  this->Renderer->SetPass(ssaa);
  const Frame plain = this->Render();
  ssaa->SetDelegatePass(this->Shadows);
  this->Shadows->SetTechnique("none");
  Check("pixels changed by the pass with lights of \"none\"",
    static_cast<double>(CountDifferent(plain, this->Render())), 0.0);
  this->Shadows->SetTechnique("depth-map");
  this->CheckSamples("under SSAA", this->Render(), plain, this->Renderer);
}

TEST_F(Composition, OverOtherPasses)
{
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAAPass> ssaa;
  ssaa->SetDelegatePass(steps);
  vtkNew<vtkRenderStepsPass> stepsOfFxaa;
  vtkNew<vtkOpenGLFXAAPass> fxaa;
  fxaa->SetDelegatePass(stepsOfFxaa);
  vtkNew<vtkRenderStepsPass> alone;
  const std::pair<std::string, vtkRenderPass*> delegates[] = { { "SSAA", ssaa }, { "FXAA", fxaa },
    { "steps", alone } };
  for (const auto& delegate : delegates)
  {
    this->Renderer->SetPass(delegate.second);
    const Frame plain = this->Render();
    this->Renderer->SetPass(this->Shadows);
    this->Shadows->SetDelegatePass(delegate.second);
    this->Shadows->SetTechnique("none");
    Check(delegate.first + ": pixels changed by the pass with lights of \"none\"",
      static_cast<double>(CountDifferent(plain, this->Render())), 0.0);
    for (const std::string technique : { "depth-map", "ray-cast" })
    {
      this->Shadows->SetTechnique(technique);
      this->CheckSamples(
        "over " + delegate.first + ", " + technique, this->Render(), plain, this->Renderer);
    }
  }
}

// A mask made at one size and shaded at another is off by the whole shadow: the edges must agree.
TEST_F(Composition, MasksFitWhateverThePassesSize)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAAPass> inner, outer;
  inner->SetDelegatePass(steps);
  outer->SetDelegatePass(this->Shadows);
  for (const bool under : { true, false })
  {
    this->Shadows->SetDelegatePass(under ? nullptr : inner.Get());
    this->Renderer->SetPass(under ? static_cast<vtkRenderPass*>(outer) : this->Shadows.Get());
    this->Shadows->SetTechnique("depth-map");
    const Frame byMap = this->Render();
    this->Shadows->SetTechnique("ray-cast");
    const Frame byRay = this->Render();
    CheckAtMost(
      std::string(under ? "under" : "over") + " SSAA: ray cast unlike depth map, % of the window",
      100.0 * CountDifferent(byMap, byRay, 60) / (byMap.rgb.size() / 3), 0.1);
  }
}

TEST_F(Composition, TechniquePassAlone)
{
  this->Renderer->SetPass(nullptr);
  const Frame plain = this->Render();
  vtkNew<vtkDepthShadowMapPass> map;
  this->Renderer->SetPass(map);
  this->CheckSamples("depth map pass alone", this->Render(), plain, this->Renderer);
  Check("maps built", static_cast<double>(map->GetNumberOfMapBuilds()), 1.0);
  this->Render();
  Check("maps built by another frame", static_cast<double>(map->GetNumberOfMapBuilds()), 1.0);
  // Not by its class, which a build without Embree has only the header of.
  if (vtkShadowTechniquePass* known = this->Shadows->GetTechniquePass("ray-cast"))
  {
    auto rays = vtk::TakeSmartPointer(known->NewInstance());
    this->Renderer->SetPass(rays);
    this->CheckSamples("ray cast pass alone", this->Render(), plain, this->Renderer);
  }
  this->Renderer->SetPass(nullptr);
  Check("pixels changed after the pass is gone",
    static_cast<double>(CountDifferent(plain, this->Render())), 0.0);
}

// The technique pass of a vtkShadowPass may be given to another renderer by itself.
TEST_F(Composition, TechniquePassOfAShadowPass)
{
  this->Renderer->SetPass(nullptr);
  const Frame plain = this->Render();
  this->Renderer->SetPass(this->Shadows->GetDepthShadowMapPass());
  this->CheckSamples("borrowed", this->Render(), plain, this->Renderer);
  this->Renderer->SetPass(this->Shadows);
  this->CheckSamples("owner", this->Render(), plain, this->Renderer);
}

//------------------------------------------------------------------------------
// Several renderers.
TEST_F(Composition, TwoViewports)
{
  vtkNew<vtkRenderer> right;
  AddScene(right);
  LookAt(right, { 3.0, -5.0, 6.0 }, { 0.0, 0.0, 0.3 });
  this->Window->AddRenderer(right);
  this->Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  this->Renderer->SetPass(nullptr);
  // From its second frame on, VTK 9.2 lights one of two renderers by the other's camera.
  this->Render();
  const Frame plain = this->Render();

  vtkNew<vtkShadowPass> ofRight;
  ofRight->SetTechnique("depth-map");
  for (const bool shared : { false, true })
  {
    this->Renderer->SetPass(this->Shadows);
    right->SetPass(shared ? this->Shadows.Get() : ofRight.Get());
    for (const std::string technique : { "depth-map", "ray-cast" })
    {
      this->Shadows->SetTechnique(technique);
      ofRight->SetTechnique(technique);
      const std::string what = (shared ? "one pass, " : "two passes, ") + technique;
      this->Render();
      const Frame frame = this->Render();
      this->CheckSamples(what + ", left", frame, plain, this->Renderer);
      this->CheckSamples(what + ", right", frame, plain, right);
    }
  }
  this->Renderer->SetPass(nullptr);
  right->SetPass(nullptr);
  Check("pixels changed after the passes are gone",
    static_cast<double>(CountDifferent(plain, this->Render())), 0.0);
}

// Different scenes, and techniques, side by side: neither sees the other's casters or lights.
TEST_F(Composition, TwoViewportsOfDifferentScenes)
{
  vtkNew<vtkRenderer> right;
  AddFloor(right, 5.0);
  AddSun(right, SunAlong);
  AddSphere(right, { -1.0, 1.0, 1.0 }, 0.5);
  LookAt(right, { 0.0, -6.0, 6.0 }, { 0.0, 0.0, 0.3 });
  this->Window->AddRenderer(right);
  this->Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  const Frame plain = this->Render();
  vtkNew<vtkShadowPass> ofRight;
  ofRight->SetTechnique("ray-cast");
  this->Renderer->SetPass(this->Shadows);
  right->SetPass(ofRight);
  const Frame frame = this->Render();
  this->CheckSamples("left", frame, plain, this->Renderer);
  for (const glm::dvec3& place : { LitPlace, ShadowPlace })
  {
    const Pixel p = PixelOf(right, place);
    const int x = p.x + right->GetOrigin()[0], y = p.y + right->GetOrigin()[1];
    Check("a place of the right scene, lit", frame.Brightness(x, y), plain.Brightness(x, y), 3.0);
  }
}

TEST_F(Composition, Layers)
{
  this->Window->SetNumberOfLayers(2);
  vtkNew<vtkRenderer> above;
  above->SetLayer(1);
  this->Window->AddRenderer(above);
  AddSphere(above, { -3.0, 0.0, 0.5 }, 0.4);
  AddSun(above, SunAlong);
  above->SetActiveCamera(this->Renderer->GetActiveCamera());
  this->CheckCombination("layer below");

  vtkNew<vtkShadowPass> ofAbove;
  ofAbove->SetTechnique("depth-map");
  above->SetPass(ofAbove);
  this->CheckCombination("layer below, with a pass above");
  above->SetPass(nullptr);
}

//------------------------------------------------------------------------------
// Selection, sizes, screenshots.
TEST_F(Composition, Selection)
{
  const auto select = [this]()
  {
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(this->Renderer);
    selector->SetArea(0, 0, this->Window->GetSize()[0] - 1, this->Window->GetSize()[1] - 1);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    const auto selection = vtk::TakeSmartPointer(selector->Select());
    std::vector<std::pair<vtkObjectBase*, vtkIdType>> found;
    for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
    {
      vtkSelectionNode* node = selection->GetNode(i);
      found.emplace_back(node->GetProperties()->Get(vtkSelectionNode::PROP()),
        node->GetSelectionList() ? node->GetSelectionList()->GetNumberOfTuples() : 0);
    }
    return found;
  };
  this->Renderer->SetPass(nullptr);
  this->Render();
  const auto expected = select();
  EXPECT_EQ(expected.size(), 2u);
  this->Renderer->SetPass(this->Shadows);
  for (const std::string technique : { "depth-map", "ray-cast", "none" })
  {
    this->Shadows->SetTechnique(technique);
    const Frame before = this->Render();
    EXPECT_EQ(select(), expected) << technique;
    Check(technique + ": pixels changed by a selection",
      static_cast<double>(CountDifferent(before, this->Render())), 0.0);
  }
}

TEST_F(Composition, Resizing)
{
  this->Renderer->SetPass(this->Shadows);
  this->Renderer->GetLights()->InitTraversal();
  vtkLight* sun = this->Renderer->GetLights()->GetNextItem();
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    for (const auto& size :
      { std::pair<int, int>(400, 300), { 640, 200 }, { 250, 400 }, { 400, 300 } })
    {
      this->Resize(size.first, size.second);
      const Frame frame = this->Render();
      Check("width", frame.width, size.first);
      this->CheckSamples(
        technique + ", " + std::to_string(size.first) + " x " + std::to_string(size.second), frame,
        this->RenderWithoutPass(), this->Renderer);
      const Visibility visibility = this->VisibilityOf(sun);
      Check("width of the visibility", visibility.width, size.first);
      Check("height of the visibility", visibility.height, size.second);
    }
  }
}

TEST_F(Composition, TinyWindows)
{
  this->Renderer->SetPass(this->Shadows);
  this->Renderer->GetLights()->InitTraversal();
  vtkLight* sun = this->Renderer->GetLights()->GetNextItem();
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    for (const auto& size : { std::pair<int, int>(1, 1), { 1, 300 }, { 300, 1 }, { 2, 2 } })
    {
      this->Resize(size.first, size.second);
      const Frame frame = this->Render();
      const std::string what =
        technique + ", " + std::to_string(size.first) + " x " + std::to_string(size.second);
      Check(what + ": pixels", static_cast<double>(frame.rgb.size() / 3), size.first * size.second);
      Check(what + ": pixels of visibility",
        static_cast<double>(this->VisibilityOf(sun).values.size()), size.first * size.second);
    }
  }
}

// A screenshot at twice the size is drawn in tiles.
TEST_F(Composition, MagnifiedScreenshot)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const auto grab = [this]()
  {
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(this->Window);
    filter->SetScale(2);
    filter->ReadFrontBufferOff();
    filter->Update();
    vtkImageData* image = filter->GetOutput();
    Frame frame;
    frame.width = image->GetDimensions()[0];
    frame.height = image->GetDimensions()[1];
    const auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
    frame.rgb.assign(values, values + 3 * image->GetNumberOfPoints());
    return frame;
  };
  this->Renderer->SetPass(nullptr);
  this->Render();
  const Frame plain = grab();
  this->Renderer->SetPass(this->Shadows);
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    this->Render();
    const Frame frame = grab();
    Check(technique + ": width", frame.width, 800);
    const Pixel lit = PixelOf(this->Renderer, LitPlace),
                shadow = PixelOf(this->Renderer, ShadowPlace);
    Check(technique + ": brightness of the lit place", frame.Brightness(2 * lit.x, 2 * lit.y),
      plain.Brightness(2 * lit.x, 2 * lit.y), 3.0);
    CheckAtMost(technique + ": brightness of the shadowed place",
      frame.Brightness(2 * shadow.x, 2 * shadow.y),
      0.6 * plain.Brightness(2 * shadow.x, 2 * shadow.y));
    // The whole shadow is where a window of that size has it.
    this->Resize(800, 600);
    const Frame large = this->Render();
    this->Resize(400, 300);
    this->Render();
    CheckAtMost(technique + ": unlike a window of twice the size, % of it",
      100.0 * CountDifferent(large, frame, 30) / (large.rgb.size() / 3), 0.3);
  }
}

TEST_F(Composition, Stereo)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Window->SetStereoTypeToSplitViewportHorizontal();
  this->Window->StereoRenderOn();
  this->Renderer->SetPass(nullptr);
  const Frame plain = this->Render();
  this->Renderer->SetPass(this->Shadows);
  this->Shadows->SetTechnique("depth-map");
  const Frame byMap = this->Render();
  this->Shadows->SetTechnique("ray-cast");
  const Frame byRay = this->Render();
  this->Window->StereoRenderOff();
  const double pixels = byMap.rgb.size() / 3.0;
  CheckAtLeast("shadowed, % of the window", 100.0 * CountDifferent(plain, byMap, 60) / pixels, 1.0);
  CheckAtMost("ray cast unlike depth map, % of the window",
    100.0 * CountDifferent(byMap, byRay, 60) / pixels, 0.1);
}

//------------------------------------------------------------------------------
// What the pass must leave alone.
namespace
{

std::vector<double> Elements(vtkMatrix4x4* matrix)
{
  return matrix ? std::vector<double>(matrix->GetData(), matrix->GetData() + 16)
                : std::vector<double>();
}

// Whatever a user could have set, as numbers.
std::vector<double> StateOf(vtkRenderer* renderer)
{
  std::vector<double> state;
  const auto add = [&state](const double* values, int count)
  { state.insert(state.end(), values, values + count); };
  vtkCamera* camera = renderer->GetActiveCamera();
  add(camera->GetPosition(), 3);
  add(camera->GetFocalPoint(), 3);
  add(camera->GetViewUp(), 3);
  add(camera->GetClippingRange(), 2);
  state.push_back(camera->GetViewAngle());
  state.push_back(camera->GetParallelScale());
  state.push_back(camera->GetParallelProjection());
  for (double element : Elements(camera->GetViewTransformMatrix()))
  {
    state.push_back(element);
  }
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal();
  while (vtkLight* light = lights->GetNextItem())
  {
    add(light->GetPosition(), 3);
    add(light->GetFocalPoint(), 3);
    add(light->GetDiffuseColor(), 3);
    state.push_back(light->GetIntensity());
    state.push_back(light->GetSwitch());
    for (double element : Elements(light->GetTransformMatrix()))
    {
      state.push_back(element);
    }
  }
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    for (double element : Elements(actor->GetMatrix()))
    {
      state.push_back(element);
    }
    state.push_back(actor->GetVisibility());
    state.push_back(actor->GetProperty()->GetOpacity());
    // An empty set of keys is as good as none.
    state.push_back(actor->GetPropertyKeys() ? actor->GetPropertyKeys()->GetNumberOfKeys() : 0);
  }
  add(renderer->GetBackground(), 3);
  add(renderer->GetViewport(), 4);
  return state;
}

std::vector<int> OpenGLState()
{
  std::vector<int> state;
  for (const unsigned int flag : { GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST,
         GL_DEPTH_CLAMP, GL_STENCIL_TEST, GL_POLYGON_OFFSET_FILL })
  {
    state.push_back(glIsEnabled(flag));
  }
  for (const unsigned int name : { GL_DEPTH_WRITEMASK, GL_DEPTH_FUNC, GL_DRAW_FRAMEBUFFER_BINDING,
         GL_READ_FRAMEBUFFER_BINDING, GL_VERTEX_ARRAY_BINDING })
  {
    int value[4] = {};
    glGetIntegerv(name, value);
    state.push_back(value[0]);
  }
  return state;
}

}

TEST_F(Composition, LeavesTheSceneAlone)
{
  auto actor = AddSphere(this->Renderer, { 0.0, 0.0, 0.0 }, 0.5);
  vtkNew<vtkTransform> transform;
  transform->Translate(-2.0, 1.0, 0.5);
  actor->SetUserTransform(transform);
  auto lamp = AddSpot(this->Renderer, { 2.0, -3.0, 6.0 }, { 0.0, 0.0, 0.0 }, 40.0);
  lamp->SetTransformMatrix(transform->GetMatrix());
  this->Renderer->SetPass(nullptr);
  this->Render();
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const std::vector<double> before = StateOf(this->Renderer);
  const std::vector<int> openGLBefore = OpenGLState();

  this->Renderer->SetPass(this->Shadows);
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    this->Render();
    EXPECT_EQ(StateOf(this->Renderer), before) << technique << ", after a frame";
    EXPECT_EQ(OpenGLState(), openGLBefore) << technique << ", OpenGL after a frame";
    EXPECT_EQ(this->Renderer->GetActiveCamera(), camera);
    this->VisibilityOf(lamp);
    EXPECT_EQ(StateOf(this->Renderer), before) << technique << ", after reading visibility";
    EXPECT_EQ(this->Renderer->GetActiveCamera(), camera);
  }
}

// Reading visibility back draws into a buffer of its own.
TEST_F(Composition, ReadingBackLeavesTheWindowAlone)
{
  this->Renderer->SetPass(this->Shadows);
  this->Renderer->GetLights()->InitTraversal();
  vtkLight* sun = this->Renderer->GetLights()->GetNextItem();
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    const Frame before = this->Render();
    this->VisibilityOf(sun);
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, before.width - 1, before.height - 1, 0, pixels);
    EXPECT_TRUE(std::equal(before.rgb.begin(), before.rgb.end(), pixels->GetPointer(0)))
      << technique << ": the window's picture changed";
    Check(technique + ": pixels changed in the next frame",
      static_cast<double>(CountDifferent(before, this->Render())), 0.0);
  }
}
