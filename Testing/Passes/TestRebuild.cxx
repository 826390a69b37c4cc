// Maps and trees are built again when a caster or a light changed, always then and only then; and
// whatever was kept, the picture is that of a pass that has just been made.
#include "ShadowTest.h"

#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>

#include <functional>

using namespace shadowtest;

namespace
{

enum Builds
{
  None,
  One,
  AtMostOne // where a needless one is forgiven
};

class Rebuild : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Floor = AddFloor(this->Renderer, 5.0);
    this->Source->SetRadius(0.8);
    this->Source->SetCenter(-1.0, 0.0, 1.2);
    this->Source->SetThetaResolution(40);
    this->Source->SetPhiResolution(40);
    this->Ball = AddActor(this->Renderer, this->Source);
    this->Box = AddBox(this->Renderer, { 0.6, -0.6, 0.0 }, { 1.7, 0.6, 1.4 });
    this->Light = AddSpot(this->Renderer, { 2.5, -2.5, 6.0 }, { 0.0, 0.0, 0.5 }, 40.0);
    LookAt(this->Renderer, { 1.0, -7.0, 5.0 }, { 0.0, 0.0, 0.5 });
    this->Renderer->SetPass(this->Shadows);
  }

  // After `change` the next frame builds as many maps (and trees) as it should and looks like a
  // fresh pass's, and the frame after that builds none. `prepare` comes a frame ahead of it.
  void CheckChange(const std::string& what, Builds maps, Builds trees,
    const std::function<void()>& change, const std::function<void()>& prepare = {});
  void CheckBuilds(const std::string& what, vtkIdType got, Builds expected);
  void CheckFresh(const std::string& what, const Frame& frame, const std::string& technique);

  vtkIdType Maps() { return this->Shadows->GetDepthShadowMapPass()->GetNumberOfMapBuilds(); }
  vtkIdType Trees() { return this->Shadows->GetRayCastShadowPass()->GetNumberOfTreeBuilds(); }

  vtkNew<vtkSphereSource> Source;
  vtkSmartPointer<vtkActor> Floor, Ball, Box;
  vtkSmartPointer<vtkLight> Light;
};

void Rebuild::CheckBuilds(const std::string& what, vtkIdType got, Builds expected)
{
  if (expected == AtMostOne)
  {
    CheckAtMost(what, static_cast<double>(got), 1.0);
  }
  else
  {
    Check(what, static_cast<double>(got), expected == One ? 1.0 : 0.0);
  }
}

void Rebuild::CheckFresh(const std::string& what, const Frame& frame, const std::string& technique)
{
  vtkNew<vtkShadowPass> fresh;
  fresh->SetTechnique(technique);
  fresh->GetDepthShadowMapPass()->SetResolution(
    this->Shadows->GetDepthShadowMapPass()->GetResolution());
  this->Renderer->SetPass(fresh);
  const Frame expected = this->Render();
  this->Renderer->SetPass(this->Shadows);
  Check(what + ": pixels unlike a fresh pass's, of " + std::to_string(expected.rgb.size() / 3),
    static_cast<double>(CountDifferent(frame, expected)), 0.0);
}

void Rebuild::CheckChange(const std::string& what, Builds maps, Builds trees,
  const std::function<void()>& change, const std::function<void()>& prepare)
{
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    if (technique == "ray-cast" && !this->Shadows->GetRayCastShadowPass())
    {
      continue;
    }
    this->Shadows->SetTechnique(technique);
    if (prepare)
    {
      prepare();
    }
    this->Render();
    const auto count = [&]() { return technique == "depth-map" ? this->Maps() : this->Trees(); };
    const std::string title = what + ", " + technique;

    const vtkIdType before = count();
    change();
    const Frame frame = this->Render();
    const vtkIdType after = count();
    this->CheckBuilds(title + ": builds", after - before, technique == "depth-map" ? maps : trees);
    this->CheckFresh(title, frame, technique);
    this->Render();
    this->CheckBuilds(title + ": builds by the next frame", count() - after, None);
  }
}

}

TEST_F(Rebuild, NothingChanged)
{
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    this->Render();
    const vtkIdType maps = this->Maps(), trees = this->Trees();
    for (int frame = 0; frame < 10; ++frame)
    {
      this->Render();
    }
    Check(
      technique + ": maps built by 10 more frames", static_cast<double>(this->Maps() - maps), 0.0);
    Check(technique + ": trees built by 10 more frames", static_cast<double>(this->Trees() - trees),
      0.0);
  }
  Check("maps built in all", static_cast<double>(this->Maps()), 1.0);
  Check("trees built in all", static_cast<double>(this->Trees()), 1.0);
}

// vtkCamera::DeepCopy tells nobody: mappers would draw by the matrices that they had, and shadows
// fall by those that the camera has.
TEST_F(Rebuild, CopiedCamera)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  vtkNew<vtkCamera> turned;
  turned->DeepCopy(camera);
  turned->Azimuth(5.0);
  for (const std::string technique : { "depth-map", "stencil-volume", "ray-cast" })
  {
    if (technique == "ray-cast" && !this->Shadows->GetRayCastShadowPass())
    {
      continue;
    }
    this->Shadows->SetTechnique(technique);
    this->Render();
    vtkNew<vtkCamera> before;
    before->DeepCopy(camera);
    camera->DeepCopy(turned);
    const Frame copied = this->Render();
    camera->Modified();
    Check(technique + ": pixels unlike those of a camera that tells",
      static_cast<double>(CountDifferent(copied, this->Render())), 0.0);
    camera->DeepCopy(before);
    camera->Modified();
    CheckAtLeast(technique + ": pixels unlike the view before",
      static_cast<double>(CountDifferent(copied, this->Render())), 1000.0);
  }
}

TEST_F(Rebuild, ReadingVisibilityBuildsNothing)
{
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    this->Render();
    const vtkIdType maps = this->Maps(), trees = this->Trees();
    this->VisibilityOf(this->Light);
    this->Render();
    Check(technique + ": maps built", static_cast<double>(this->Maps() - maps), 0.0);
    Check(technique + ": trees built", static_cast<double>(this->Trees() - trees), 0.0);
  }
}

TEST_F(Rebuild, CameraMoves)
{
  double x = 1.0;
  this->CheckChange("orbited", None, None,
    [&]() {
      LookAt(this->Renderer, { x -= 1.5, -6.0, 5.0 }, { 0.0, 0.0, 0.5 });
    });
  this->CheckChange("zoomed", None, None, [&]() { this->Renderer->GetActiveCamera()->Zoom(1.2); });
  this->CheckChange("parallel", None, None,
    [&]()
    {
      vtkCamera* camera = this->Renderer->GetActiveCamera();
      camera->SetParallelScale(3.0);
      camera->SetParallelProjection(!camera->GetParallelProjection());
    });
  this->CheckChange("another camera", None, None,
    [&]()
    {
      vtkNew<vtkCamera> camera;
      this->Renderer->SetActiveCamera(camera);
      LookAt(this->Renderer, { 2.0, -6.0, 6.0 }, { 0.0, 0.0, 0.5 });
    });
  this->CheckChange("window resized", None, None,
    [&]() { this->Resize(360 + (this->Window->GetSize()[0] == 360 ? 20 : 0), 320); });
}

TEST_F(Rebuild, ActorMoves)
{
  double x = 0.0;
  this->CheckChange("moved", One, One, [&]() { this->Ball->SetPosition(x += 0.3, 0.2, 0.0); });
  this->CheckChange("turned", One, One, [&]() { this->Box->RotateZ(20.0); });
  this->CheckChange("scaled", One, One, [&]() { this->Ball->SetScale(x += 0.9); });
  vtkNew<vtkTransform> user;
  this->Ball->SetUserTransform(user);
  this->CheckChange("user transform edited", One, One, [&]() { user->Translate(0.0, 0.0, 0.2); });
}

TEST_F(Rebuild, ActorsComeAndGo)
{
  this->CheckChange(
    "hidden", One, One, [&]() { this->Ball->VisibilityOff(); },
    [&]() { this->Ball->VisibilityOn(); });
  this->CheckChange(
    "shown", One, One, [&]() { this->Ball->VisibilityOn(); },
    [&]() { this->Ball->VisibilityOff(); });
  double x = 0.0;
  this->CheckChange("added", One, One,
    [&]() {
      AddSphere(this->Renderer, { x += 0.2, 1.5, 0.5 }, 0.4);
    });
  this->CheckChange(
    "removed", One, One, [&]() { this->Renderer->RemoveActor(this->Ball); },
    [&]() { this->Renderer->AddActor(this->Ball); });
}

TEST_F(Rebuild, KeysChange)
{
  this->CheckChange(
    "casts no more", One, One, [&]() { vtkShadowPass::SetCastsShadows(this->Ball, false); },
    [&]() { vtkShadowPass::SetCastsShadows(this->Ball, true); });
  this->CheckChange(
    "casts again", One, One, [&]() { vtkShadowPass::SetCastsShadows(this->Ball, true); },
    [&]() { vtkShadowPass::SetCastsShadows(this->Ball, false); });
}

// What the peer misses: the mesh is edited where it is.
TEST_F(Rebuild, PointsEditedInPlace)
{
  vtkNew<vtkPolyData> mesh;
  this->Source->Update();
  mesh->DeepCopy(this->Source->GetOutput());
  auto edited = AddActor(this->Renderer, mesh);
  edited->SetPosition(0.8, 1.8, 0.0);
  this->CheckChange("points edited, points modified", One, One,
    [&]()
    {
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        double p[3];
        mesh->GetPoint(i, p);
        mesh->GetPoints()->SetPoint(i, p[0] + 0.1, 0.9 * p[1], p[2]);
      }
      mesh->GetPoints()->Modified();
    });
  this->CheckChange("points edited, mesh modified", One, One,
    [&]()
    {
      mesh->GetPoints()->SetPoint(0, 0.0, 0.0, 3.0);
      mesh->Modified();
    });
  this->CheckChange("coordinates edited, array modified", One, One,
    [&]()
    {
      auto* coordinates = vtkFloatArray::SafeDownCast(mesh->GetPoints()->GetData());
      coordinates->SetValue(2, coordinates->GetValue(2) + 0.3f);
      coordinates->Modified();
      mesh->GetPoints()->Modified();
    });
}

TEST_F(Rebuild, PipelineChanges)
{
  double radius = 0.8;
  this->CheckChange(
    "source's parameter", One, One, [&]() { this->Source->SetRadius(radius -= 0.1); });
  this->CheckChange("mapper's input replaced", One, One,
    [&]()
    {
      vtkNew<vtkSphereSource> other;
      other->SetRadius(radius -= 0.1);
      other->SetCenter(-1.0, 0.0, 1.0);
      this->Ball->GetMapper()->SetInputConnection(other->GetOutputPort());
    });
  this->CheckChange("mapper replaced", One, One,
    [&]()
    {
      vtkNew<vtkSphereSource> other;
      other->SetRadius(radius -= 0.05);
      other->SetCenter(-1.0, 0.3, 1.0);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(other->GetOutputPort());
      this->Ball->SetMapper(mapper);
    });
}

TEST_F(Rebuild, LightMoves)
{
  double x = 2.5;
  this->CheckChange(
    "position", One, None, [&]() { this->Light->SetPosition(x -= 0.5, -2.5, 6.0); });
  // Neither need change the map: it is fitted to the casters.
  this->CheckChange(
    "focal point", AtMostOne, None, [&]() { this->Light->SetFocalPoint(x -= 0.3, 0.0, 0.0); });
  this->CheckChange("cone", AtMostOne, None, [&]() { this->Light->SetConeAngle(40.0 + x); });
  this->CheckChange(
    "directional", One, None, [&]() { this->Light->PositionalOff(); },
    [&]() { this->Light->PositionalOn(); });
  vtkNew<vtkTransform> transform;
  this->CheckChange("transform", One, None,
    [&]()
    {
      transform->RotateZ(15.0);
      this->Light->SetTransformMatrix(transform->GetMatrix());
    });
}

TEST_F(Rebuild, LightsComeAndGo)
{
  // The first light's map may move to another place; what must hold is the picture.
  vtkSmartPointer<vtkLight> second;
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    this->Render();
    second = AddSun(this->Renderer, { 1.0, 0.5, -1.0 });
    this->CheckFresh("added, " + technique, this->Render(), technique);
    this->Light->SwitchOff();
    this->CheckFresh("first switched off, " + technique, this->Render(), technique);
    this->Light->SwitchOn();
    this->CheckFresh("first switched on, " + technique, this->Render(), technique);
    this->Renderer->RemoveLight(second);
    this->CheckFresh("removed, " + technique, this->Render(), technique);
  }
}

TEST_F(Rebuild, OneLightOfTwoMoves)
{
  auto second = AddSun(this->Renderer, { 1.0, 0.5, -1.0 });
  double x = 1.0;
  this->CheckChange(
    "one of two lights", One, None, [&]() { second->SetPosition(x -= 0.4, -1.0, 1.5); });
}

TEST_F(Rebuild, LookChanges)
{
  double red = 0.0;
  this->CheckChange("colour", AtMostOne, AtMostOne,
    [&]() { this->Ball->GetProperty()->SetColor(red += 0.3, 0.5, 0.2); });
  this->CheckChange(
    "light's colour", AtMostOne, AtMostOne, [&]() { this->Light->SetColor(0.9, red -= 0.2, 0.5); });
  this->CheckChange(
    "light's intensity", AtMostOne, AtMostOne, [&]() { this->Light->SetIntensity(red += 0.3); });

  // Scalars through a lookup table.
  this->Source->Update();
  vtkNew<vtkPolyData> mesh;
  mesh->DeepCopy(this->Source->GetOutput());
  vtkNew<vtkFloatArray> height;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    height->InsertNextValue(static_cast<float>(mesh->GetPoint(i)[2]));
  }
  mesh->GetPointData()->SetScalars(height);
  auto coloured = AddActor(this->Renderer, mesh);
  coloured->SetPosition(0.8, 1.8, 0.0);
  vtkNew<vtkLookupTable> colours;
  coloured->GetMapper()->SetLookupTable(colours);
  coloured->GetMapper()->SetScalarRange(0.0, 2.0);
  double hue = 0.0;
  this->CheckChange("lookup table", AtMostOne, AtMostOne,
    [&]()
    {
      colours->SetHueRange(hue += 0.1, 0.8);
      colours->Build();
    });
  this->CheckChange("scalar range", AtMostOne, AtMostOne,
    [&]() { coloured->GetMapper()->SetScalarRange(0.0, 2.0 + (hue += 0.1)); });
  this->CheckChange("scalars", AtMostOne, AtMostOne,
    [&]()
    {
      height->SetValue(0, static_cast<float>(hue += 0.1));
      height->Modified();
      mesh->Modified();
    });
}

// Only what a depth map draws depends on it: no ray hits a line.
TEST_F(Rebuild, RepresentationChanges)
{
  this->Render();
  const vtkIdType before = this->Maps();
  this->Box->GetProperty()->SetRepresentationToWireframe();
  const Frame frame = this->Render();
  this->CheckBuilds("wireframe: builds", this->Maps() - before, One);
  this->CheckFresh("wireframe", frame, "depth-map");
}

TEST_F(Rebuild, ResolutionChanges)
{
  int resolution = 256;
  this->CheckChange("resolution", One, None,
    [&]() { this->Shadows->GetDepthShadowMapPass()->SetResolution(resolution *= 2); });
}

// Another caster in the same place and with the same memory is not taken for the first one.
TEST_F(Rebuild, ActorsReplacedEveryFrame)
{
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    this->Shadows->SetTechnique(technique);
    for (int i = 0; i < 6; ++i)
    {
      auto passing = AddSphere(this->Renderer, { 0.3 * i - 1.0, 1.6, 0.8 }, 0.5, 24);
      const Frame frame = this->Render();
      this->CheckFresh("actor " + std::to_string(i) + ", " + technique, frame, technique);
      this->Renderer->RemoveActor(passing);
    }
  }
}
