// Faces of closed receivers that are turned away from the eye are left out, the picture stays, and
// what is not closed, or not wholly seen from outside, keeps all of its faces.
#include "ShadowTest.h"

#include <vtkConeSource.h>
#include <vtkGlyph3DMapper.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

using namespace shadowtest;

namespace
{

class EyeFaces : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Shadows->SetTechnique("depth-map");
    this->Shadows->CullHiddenFacesOn();
    AddFloor(this->Renderer, 5.0);
    this->Ball = AddSphere(this->Renderer, { -1.0, 0.0, 1.2 }, 0.8);
    this->Light = AddSpot(this->Renderer, { 2.5, -2.5, 6.0 }, { 0.0, 0.0, 0.5 }, 40.0);
    LookAt(this->Renderer, { 1.0, -7.0, 5.0 }, { 0.0, 0.0, 0.5 });
    this->Renderer->SetPass(this->Shadows);
  }

  // Frames until so many receivers are culled; how many they were at last.
  int CulledOnce(int expected)
  {
    using namespace std::chrono_literals;
    int culled = -1;
    for (int i = 0; i < 400 && culled != expected; ++i)
    {
      this->Window->Render();
      culled = this->Shadows->GetNumberOfCulledReceivers();
      std::this_thread::sleep_for(5ms);
    }
    return culled;
  }

  void CheckCulled(const std::string& what, int expected)
  {
    Check(what, this->CulledOnce(expected), expected);
  }

  // The ball is culled; after `change` it is not, nor after frames in which a proof could be made.
  void CheckKept(const std::string& what, const std::function<void()>& change)
  {
    this->CheckCulled(what + ", before", 1);
    change();
    int most = 0;
    for (int i = 0; i < 8; ++i)
    {
      this->Window->Render();
      most = std::max(most, this->Shadows->GetNumberOfCulledReceivers());
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    Check(what, most, 0);
  }

  // The picture and the visibility with all faces. On a silhouette a near and a far face meet, and
  // rounding may have put the far one in front: a pixel, here and there.
  void CheckSame(const std::string& what)
  {
    const Frame culled = this->Render();
    const Visibility seen = this->VisibilityOf(this->Light);
    CheckAtLeast(what + ": receivers culled", this->Shadows->GetNumberOfCulledReceivers(), 1);
    this->Shadows->CullHiddenFacesOff();
    CheckAtMost(what + ": pixels that differ", CountDifferent(culled, this->Render()), 3);
    CheckAtMost(
      what + ": visibility that differs", CountDifferent(seen, this->VisibilityOf(this->Light)), 3);
    Check(what + ": culled when off", this->Shadows->GetNumberOfCulledReceivers(), 0);
    this->Shadows->CullHiddenFacesOn();
  }

  vtkSmartPointer<vtkActor> Ball;
  vtkSmartPointer<vtkLight> Light;
};

// The prism over a figure of eight, closed and wound alike throughout: one half is inside out.
vtkSmartPointer<vtkPolyData> FigureOfEight()
{
  const int count = 40;
  std::vector<glm::dvec3> points;
  std::vector<glm::ivec3> triangles;
  for (const double z : { 0.2, 1.2 })
  {
    for (int i = 0; i < count; ++i)
    {
      const double t = glm::two_pi<double>() * (i + 0.5) / count;
      points.emplace_back(std::sin(t), std::sin(2.0 * t), z);
    }
  }
  for (int i = 0; i < count; ++i)
  {
    const int next = (i + 1) % count;
    triangles.emplace_back(i, next, count + next);
    triangles.emplace_back(i, count + next, count + i);
    if (i > 0 && next > 0)
    {
      triangles.emplace_back(0, next, i);
      triangles.emplace_back(count, count + i, count + next);
    }
  }
  return vtkshadows::scenes::MakeTriangles(points, triangles);
}

}

//------------------------------------------------------------------------------
TEST_F(EyeFaces, ThePictureStays)
{
  AddBox(this->Renderer, { 0.6, -0.6, 0.0 }, { 1.7, 0.6, 1.4 });
  vtkNew<vtkConeSource> source;
  source->SetResolution(30);
  auto cone = AddActor(this->Renderer, source);
  cone->SetPosition(0.0, 1.5, 0.7);
  cone->SetScale(1.0, -1.6, 1.2); // mirrored
  auto turned = AddSphere(this->Renderer, { 1.5, -1.5, 0.5 }, 0.4);
  turned->GetProperty()->SetInterpolationToFlat();
  this->CheckCulled("four closed things", 4);
  this->CheckSame("from the side");
  LookAt(this->Renderer, { -3.0, -2.0, 0.8 }, { 0.0, 0.0, 0.5 });
  this->CheckSame("from below their tops");
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Renderer->GetActiveCamera()->SetParallelScale(3.0);
  this->Renderer->ResetCameraClippingRange();
  this->CheckSame("parallel eye");
  this->Shadows->SetTechnique("stencil-volume");
  this->CheckSame("by a mask");
}

TEST_F(EyeFaces, GlyphsAreCulledToo)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 40; ++i)
  {
    points->InsertNextPoint(0.6 * (i % 8) - 2.0, 0.6 * (i / 8) - 1.0, 0.3);
  }
  vtkNew<vtkPolyData> grid;
  grid->SetPoints(points);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.2);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(grid);
  mapper->SetSourceConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  this->CheckCulled("a ball and glyphs", 2);
  this->CheckSame("glyphs");
}

// A frame without shadows is VTK's own, and says so.
TEST_F(EyeFaces, FramesWithoutShadowsKeepAllFaces)
{
  this->CheckCulled("the ball", 1);
  this->Shadows->SetTechnique("none");
  const Frame plain = this->Render();
  Check("culled without shadows", this->Shadows->GetNumberOfCulledReceivers(), 0);
  this->VisibilityOf(this->Light); // which no frame shows
  Check("culled once visibility was read", this->Shadows->GetNumberOfCulledReceivers(), 0);
  Check("pixels unlike VTK's frame", CountDifferent(plain, this->RenderWithoutPass()), 0);
  this->Shadows->SetTechnique("depth-map");
  this->Window->Render();
  Check("culled in the next frame with shadows", this->Shadows->GetNumberOfCulledReceivers(), 1);
  this->Shadows->CullHiddenFacesOff();
  this->Window->Render();
  this->Shadows->CullHiddenFacesOn();
  Check("culled before there is a frame", this->Shadows->GetNumberOfCulledReceivers(), 0);
}

//------------------------------------------------------------------------------
TEST_F(EyeFaces, WhatIsNotClosedKeepsItsFaces)
{
  vtkNew<vtkSphereSource> bowl;
  bowl->SetStartTheta(10.0);
  this->CheckKept(
    "a bowl", [&] { this->Ball->GetMapper()->SetInputConnection(bowl->GetOutputPort()); });
}

// What a closed surface that passes through itself would look like without its far faces shows that
// a proof is needed.
TEST_F(EyeFaces, WhatPassesThroughItselfKeepsItsFaces)
{
  const auto eight = FigureOfEight();
  this->CheckKept("a figure of eight",
    [&]
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(eight);
      this->Ball->SetMapper(mapper);
    });
  const Frame whole = this->Render();
  this->Ball->GetProperty()->BackfaceCullingOn();
  CheckAtLeast("pixels that culling would change", CountDifferent(whole, this->Render()), 500);
}

TEST_F(EyeFaces, WhatIsSeenFromWithinKeepsItsFaces)
{
  this->CheckKept("the eye within",
    [&]
    {
      LookAt(this->Renderer, { -1.0, 0.0, 1.2 }, { 0.0, 0.0, 1.2 });
      this->Renderer->GetActiveCamera()->SetClippingRange(0.01, 20.0);
    });
  LookAt(this->Renderer, { 1.0, -7.0, 5.0 }, { 0.0, 0.0, 0.5 });
  this->CheckKept("cut open by the near plane",
    [&]
    {
      const double distance = glm::distance(glm::dvec3(1.0, -7.0, 5.0), glm::dvec3(-1.0, 0.0, 1.2));
      this->Renderer->GetActiveCamera()->SetClippingRange(distance, 20.0);
    });
}

TEST_F(EyeFaces, WhatIsDrawnOtherwiseKeepsItsFaces)
{
  vtkProperty* property = this->Ball->GetProperty();
  this->CheckKept("wireframe", [&] { property->SetRepresentationToWireframe(); });
  property->SetRepresentationToSurface();
  this->CheckKept("visible edges", [&] { property->EdgeVisibilityOn(); });
  property->EdgeVisibilityOff();
  this->CheckKept("translucent", [&] { property->SetOpacity(0.5); });
  property->SetOpacity(1.0);
  this->CheckKept("culling of the user's", [&] { property->FrontfaceCullingOn(); });
  Check("which stays", property->GetFrontfaceCulling(), 1);
  property->FrontfaceCullingOff();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(-1.0, 0.0, 1.2);
  this->CheckKept("clipped", [&] { this->Ball->GetMapper()->AddClippingPlane(plane); });
  this->Ball->GetMapper()->RemoveAllClippingPlanes();
  vtkNew<vtkActor> sheet;
  vtkNew<vtkSphereSource> bowl;
  bowl->SetStartTheta(10.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(bowl->GetOutputPort());
  sheet->SetMapper(mapper);
  sheet->SetProperty(property);
  this->CheckKept("one property with an open one", [&] { this->Renderer->AddActor(sheet); });
}

//------------------------------------------------------------------------------
TEST_F(EyeFaces, PropertiesAreLeftAsTheyWere)
{
  vtkProperty* property = this->Ball->GetProperty();
  const vtkMTimeType before = property->GetMTime();
  this->CheckCulled("the ball", 1);
  Check("back faces", property->GetBackfaceCulling(), 0);
  Check("front faces", property->GetFrontfaceCulling(), 0);
  Check("time stamps", double(property->GetMTime() - before), 0.0);
}
