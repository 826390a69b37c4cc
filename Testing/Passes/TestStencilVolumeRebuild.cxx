// Shadow volumes are built again when a caster or a light changed, always then and only then, and
// of that caster and light alone; and what is kept of them is small, and goes with them.
#include "VolumeTest.h"

#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

using namespace shadowtest;

namespace
{

class StencilVolumeRebuild : public CasterTest
{
protected:
  void SetUp() override
  {
    CasterTest::SetUp();
    this->Mesh = Thing();
    this->Edited = AddActor(this->Renderer, this->Mesh);
    this->Edited->SetPosition(-1.2, 0.0, 1.3);
    this->Box = AddBox(this->Renderer, { 0.6, -0.6, 0.0 }, { 1.7, 0.6, 1.4 });
    this->Render();
  }

  // After `change`, the next frame builds as many meshes and volumes, the frame after it none, and
  // the frame is that of a pass that has just been made. Volumes are one a caster and light.
  void CheckChange(
    const std::string& what, double meshes, double volumes, const std::function<void()>& change)
  {
    this->Render();
    const vtkIdType meshesBefore = this->Volumes()->GetNumberOfMeshBuilds();
    const vtkIdType volumesBefore = this->Volumes()->GetNumberOfVolumeBuilds();
    change();
    const Frame frame = this->Render();
    const vtkIdType meshesAfter = this->Volumes()->GetNumberOfMeshBuilds();
    const vtkIdType volumesAfter = this->Volumes()->GetNumberOfVolumeBuilds();
    Check(what + ": meshes built", double(meshesAfter - meshesBefore), meshes);
    Check(what + ": volumes built", double(volumesAfter - volumesBefore), volumes);
    this->Render();
    Check(what + ": built by the next frame",
      double(this->Volumes()->GetNumberOfMeshBuilds() - meshesAfter +
        this->Volumes()->GetNumberOfVolumeBuilds() - volumesAfter),
      0.0);
    vtkNew<vtkShadowPass> fresh;
    fresh->SetTechnique("stencil-volume");
    this->Renderer->SetPass(fresh);
    const Frame expected = this->Render();
    this->Renderer->SetPass(this->Shadows);
    Check(what + ": pixels unlike a fresh pass's",
      static_cast<double>(CountDifferent(frame, expected)), 0.0);
  }

  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkActor> Edited, Box;
};

}

TEST_F(StencilVolumeRebuild, ACameraThatMovesBuildsNothing)
{
  this->CheckChange("orbited", 0, 0, [&]() { this->Renderer->GetActiveCamera()->Azimuth(20.0); });
  this->CheckChange("zoomed", 0, 0, [&]() { this->Renderer->GetActiveCamera()->Zoom(1.3); });
  this->CheckChange("window resized", 0, 0, [&]() { this->Resize(300, 260); });
  this->CheckChange("nothing", 0, 0, []() {});
}

// The floor casts on nothing and so has no volume: two casters, two lights.
TEST_F(StencilVolumeRebuild, ALightThatMovesBuildsItsVolumes)
{
  this->CheckChange("lamp moved", 0, 2, [&]() { this->Lamp->SetPosition(1.0, -3.5, 5.0); });
  this->CheckChange("sun turned", 0, 2, [&]() { this->Sun->SetPosition(0.2, -0.4, 1.0); });
  this->CheckChange("lamp's colour", 0, 0, [&]() { this->Lamp->SetColor(0.5, 0.7, 0.9); });
  this->CheckChange("lamp's intensity", 0, 0, [&]() { this->Lamp->SetIntensity(0.6); });
}

TEST_F(StencilVolumeRebuild, AnActorThatMovesBuildsItsVolumes)
{
  this->CheckChange("lifted", 0, 1, [&]() { this->Edited->SetPosition(-1.2, 0.0, 1.6); });
  // Its sun is the same for it wherever it is, but turned it is not.
  this->CheckChange("turned", 0, 2, [&]() { this->Edited->RotateX(15.0); });
  this->CheckChange("mirrored", 0, 2, [&]() { this->Box->SetScale(-1.0, 1.0, 1.0); });
}

TEST_F(StencilVolumeRebuild, AMeshThatIsEditedIsBuiltAgain)
{
  this->CheckChange("points edited in place", 1, 2,
    [&]()
    {
      for (vtkIdType i = 0; i < this->Mesh->GetNumberOfPoints(); ++i)
      {
        double p[3];
        this->Mesh->GetPoint(i, p);
        this->Mesh->GetPoints()->SetPoint(i, 0.9 * p[0], p[1] + 0.1, p[2]);
      }
      this->Mesh->GetPoints()->Modified();
    });
  this->CheckChange(
    "colour", 0, 0, [&]() { this->Edited->GetProperty()->SetColor(0.2, 0.5, 0.8); });
  this->CheckChange(
    "opacity of what is drawn", 0, 0, [&]() { this->Edited->GetProperty()->SetAmbient(0.2); });
}

TEST_F(StencilVolumeRebuild, WhatIsGoneIsForgotten)
{
  const double before = static_cast<double>(this->Volumes()->GetMemoryInBytes());
  const double triangles = static_cast<double>(this->Volumes()->GetNumberOfTriangles());
  auto ball = AddSphere(this->Renderer, { 0.0, 1.5, 1.0 }, 0.5, 100);
  this->Render();
  CheckAtLeast("bytes, with a ball", static_cast<double>(this->Volumes()->GetMemoryInBytes()),
    before + 100000.0);
  this->Renderer->RemoveActor(ball);
  this->Render();
  Check("bytes, once it is gone", static_cast<double>(this->Volumes()->GetMemoryInBytes()), before);
  Check("triangles, once it is gone", static_cast<double>(this->Volumes()->GetNumberOfTriangles()),
    triangles);
  this->Edited->VisibilityOff();
  this->Render();
  CheckAtMost("bytes, with one hidden", static_cast<double>(this->Volumes()->GetMemoryInBytes()),
    0.5 * before);
  this->Shadows->ReleaseGraphicsResources(this->Window);
  Check("bytes, once released", static_cast<double>(this->Volumes()->GetMemoryInBytes()), 0.0);
  this->Edited->VisibilityOn();
  this->Render();
  Check("bytes, in use again", static_cast<double>(this->Volumes()->GetMemoryInBytes()), before);
}

// Of mesh, its points with the driver, and the volume of one light.
TEST_F(StencilVolumeRebuild, BytesATriangle)
{
  const auto check = [this](const std::string& what, double leastTriangles, double mostBytes)
  {
    this->Render();
    const double triangles = static_cast<double>(this->Volumes()->GetNumberOfTriangles());
    CheckAtLeast(what + ": triangles", triangles, leastTriangles);
    CheckAtMost(what + ": bytes a triangle",
      static_cast<double>(this->Volumes()->GetMemoryInBytes()) / triangles, mostBytes);
  };
  const auto add = [this](vtkPolyData* mesh)
  {
    auto actor = AddActor(this->Renderer, mesh);
    actor->SetScale(0.02);
    actor->SetPosition(-1.0, -1.0, 1.0);
    return actor;
  };
  this->Renderer->RemoveAllViewProps();
  this->Renderer->RemoveLight(this->Lamp);
  AddFloor(this->Renderer, 5.0);
  auto ball = AddSphere(this->Renderer, { 0.0, 0.0, 1.2 }, 0.9, 200);
  check("closed", 70000.0, 60.0);
  this->Renderer->RemoveActor(ball);

  // Single triangles, then with as many quads; every one casts.
  TestMesh soup = Confetti(100), mixed = soup;
  for (std::size_t i = 0; i < mixed.triangles.size(); ++i)
  {
    const glm::uvec3 t = mixed.triangles[i];
    const auto a = static_cast<unsigned int>(3 * i);
    soup.points.resize(a);
    soup.points.insert(soup.points.end(),
      { mixed.points[t.x], mixed.points[t.y] + glm::dvec3(1e-3 * i, 0.0, 0.0),
        mixed.points[t.z] + glm::dvec3(0.0, 0.0, 0.5) });
    soup.triangles[i] = { a, a + 1, a + 2 };
  }
  auto single = add(ToPolyData(soup));
  check("soup", 15000.0, 110.0);
  this->Renderer->RemoveActor(single);
  add(ToPolyData(mixed));
  check("triangles and quads", 15000.0, 110.0);
}
