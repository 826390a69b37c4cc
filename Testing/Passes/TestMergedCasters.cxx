// Small casters are drawn from one list from their second draw on; the picture is that of a pass
// that has just been made, which draws them by their mappers.
#include "ShadowTest.h"

#include "vtkDepthShadowMapPass.h"
#include "vtkShadowTexturePass.h"

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkConeSource.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTexture.h>

#include <functional>

using namespace shadowtest;

namespace
{

const double Here[] = { 0.0, 0.0, 0.0 };
// As UTM coordinates are: VTK's mappers move what lies so far from the origin.
const double FarAway[] = { 446000.0, 5412000.0, 300.0 };

class MergedCasters : public ShadowTest
{
protected:
  void Build(const double origin[3]);
  vtkSmartPointer<vtkActor> AddBall(const glm::dvec3& centre, double radius);
  // After two frames and changes of the light: as many casters from the list, and the picture of
  // a fresh pass. `prepare` sets a pass up.
  void CheckFresh(
    const std::string& what, int merged, const std::function<void(vtkShadowPass*)>& prepare);
  void MoveLight() { this->Light->SetPosition(this->At(2.5 + 0.1 * ++this->Moves, -2.5, 6.0)); }
  double* At(double x, double y, double z);

  glm::dvec3 Origin{ 0.0 };
  double Point[3];
  int Moves = 0;
  vtkSmartPointer<vtkActor> Floor;
  vtkSmartPointer<vtkLight> Light;
  std::vector<vtkSmartPointer<vtkActor>> Balls;
};

double* MergedCasters::At(double x, double y, double z)
{
  this->Point[0] = this->Origin.x + x;
  this->Point[1] = this->Origin.y + y;
  this->Point[2] = this->Origin.z + z;
  return this->Point;
}

vtkSmartPointer<vtkActor> MergedCasters::AddBall(const glm::dvec3& centre, double radius)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(
    this->Origin.x + centre.x, this->Origin.y + centre.y, this->Origin.z + centre.z);
  source->SetRadius(radius);
  source->SetThetaResolution(24);
  source->SetPhiResolution(24);
  this->Balls.push_back(AddActor(this->Renderer, source));
  return this->Balls.back();
}

// Two rows of balls over a floor; some of them mirrored, sheared, open or with points as they are.
void MergedCasters::Build(const double origin[3])
{
  this->Origin = { origin[0], origin[1], origin[2] };
  this->Floor = AddBox(this->Renderer, this->Origin + glm::dvec3(-5.0, -5.0, -0.1),
    this->Origin + glm::dvec3(5.0, 5.0, 0.0));
  for (int i = 0; i < 10; ++i)
  {
    this->AddBall({ -2.0 + (i % 5), i < 5 ? -1.0 : 1.0, 0.6 }, 0.3 + 0.02 * i);
  }
  this->Balls[1]->SetScale(1.0, 1.0, -1.0);
  this->Balls[1]->SetOrigin(this->At(-1.0, -1.0, 0.6));
  this->Balls[2]->SetScale(1.0, 2.0, 0.5);
  this->Balls[2]->SetOrigin(this->At(0.0, -1.0, 0.6));
  this->Balls[3]->RotateX(30.0);
  this->Balls[3]->SetOrigin(this->At(1.0, -1.0, 0.6));
  this->Balls[4]->GetProperty()->FrontfaceCullingOn();
  this->Light = AddSpot(this->Renderer, this->Origin + glm::dvec3(2.5, -2.5, 6.0),
    this->Origin + glm::dvec3(0.0, 0.0, 0.5), 40.0);
  LookAt(this->Renderer, this->Origin + glm::dvec3(1.0, -6.0, 4.0),
    this->Origin + glm::dvec3(0.0, 0.0, 0.5));
  this->Shadows->SetTechnique("depth-map");
  this->Renderer->SetPass(this->Shadows);
}

void MergedCasters::CheckFresh(
  const std::string& what, int merged, const std::function<void(vtkShadowPass*)>& prepare)
{
  prepare(this->Shadows);
  this->Render();
  this->MoveLight();
  this->Render(); // some mappers change what they tell of their shape in their first frame
  this->MoveLight();
  const Frame frame = this->Render();
  Check(what + ": casters from the list", this->Shadows->GetNumberOfMergedCasters(), merged);
  vtkNew<vtkShadowPass> fresh;
  prepare(fresh);
  this->Renderer->SetPass(fresh);
  const Frame expected = this->Render();
  Check(what + ": casters from the list of a fresh pass", fresh->GetNumberOfMergedCasters(), 0);
  this->Renderer->SetPass(this->Shadows);
  Check(what + ": pixels unlike a fresh pass's, of " + std::to_string(expected.rgb.size() / 3),
    static_cast<double>(CountDifferent(frame, expected)), 0.0);
  this->Renderer->SetPass(nullptr);
  CheckAtLeast(what + ": pixels unlike those without shadows",
    static_cast<double>(CountDifferent(frame, this->Render())), 2000.0);
  this->Renderer->SetPass(this->Shadows);
}

const auto ByDepthMap = [](vtkShadowPass* shadows) { shadows->SetTechnique("depth-map"); };

}

TEST_F(MergedCasters, OfEachTechnique)
{
  this->Build(Here);
  this->CheckFresh("depth-map", 11, ByDepthMap);
  for (const int bits : { 8, 16, 24 })
  {
    this->CheckFresh("of " + std::to_string(bits) + " bits", 11,
      [bits](vtkShadowPass* shadows)
      {
        shadows->SetTechnique("depth-map");
        shadows->GetDepthShadowMapPass()->SetDepthBits(bits);
      });
  }
  // A caster takes no shadow from a texture that it is in.
  vtkShadowPass::SetCastsShadows(this->Floor, false);
  this->CheckFresh(
    "shadow-texture", 10, [](vtkShadowPass* shadows) { shadows->SetTechnique("shadow-texture"); });
}

TEST_F(MergedCasters, FarFromTheOrigin)
{
  this->Build(FarAway);
  this->CheckFresh("depth-map", 11, ByDepthMap);
}

TEST_F(MergedCasters, OfALampAmidThem)
{
  this->Build(Here);
  this->Light->SetConeAngle(180.0);
  this->Light->SetPosition(0.1, 0.0, 1.5);
  const auto render = [&](vtkShadowPass* shadows)
  {
    shadows->SetTechnique("depth-map");
    this->Renderer->SetPass(shadows);
    return this->Render();
  };
  render(this->Shadows);
  this->Light->SetPosition(0.2, 0.0, 1.5);
  const Frame frame = render(this->Shadows);
  CheckAtLeast(
    "casters from the list, over the faces", this->Shadows->GetNumberOfMergedCasters(), 11);
  vtkNew<vtkShadowPass> fresh;
  Check(
    "pixels unlike a fresh pass's", static_cast<double>(CountDifferent(frame, render(fresh))), 0.0);
  this->Renderer->SetPass(nullptr);
}

// What has more to it than triangles is left to its mapper.
TEST_F(MergedCasters, OthersAmongThem)
{
  this->Build(Here);
  this->Balls[0]->GetProperty()->SetRepresentationToWireframe();
  this->Balls[5]->GetProperty()->SetOpacity(0.5);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(this->At(1.0, 1.0, 0.6));
  plane->SetNormal(1.0, 0.0, 0.0);
  this->Balls[8]->GetMapper()->AddClippingPlane(plane);
  vtkNew<vtkAssembly> assembly;
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkConeSource> cone;
    cone->SetCenter(-1.0 + i, 0.0, 1.5);
    cone->SetRadius(0.2);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(cone->GetOutputPort());
    vtkNew<vtkActor> part;
    part->SetMapper(mapper);
    assembly->AddPart(part);
  }
  this->Renderer->AddViewProp(assembly);
  double away = 0.0;
  for (const auto& mapper : CompositeMappers())
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    for (unsigned int i = 0; i < 2; ++i)
    {
      vtkNew<vtkSphereSource> block;
      block->SetCenter(-0.5 + i, 2.5 + away, 0.5);
      block->SetRadius(0.3);
      block->Update();
      blocks->SetBlock(i, block->GetOutput());
    }
    away += 0.8;
    mapper->SetInputDataObject(blocks);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
  }
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-1.5, 2.0, 0.8);
  points->InsertNextPoint(1.5, 2.0, 0.8);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkSphereSource> bead;
  bead->SetRadius(0.2);
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(places);
  glyphs->SetSourceConnection(bead->GetOutputPort());
  glyphs->ScalingOff();
  vtkNew<vtkActor> beads;
  beads->SetMapper(glyphs);
  this->Renderer->AddActor(beads);
  // 7 balls, the floor, the beads and whatever is of composite data.
  const int composite = static_cast<int>(CompositeMappers().size());
  this->CheckFresh("depth-map", 9 + composite, ByDepthMap);
}

TEST_F(MergedCasters, ShapesAndPropsThatChange)
{
  this->Build(Here);
  this->CheckFresh("at first", 11, ByDepthMap);
  vtkNew<vtkSphereSource> larger;
  larger->SetCenter(2.0, 1.0, 0.6);
  larger->SetRadius(0.8);
  this->Balls[9]->GetMapper()->SetInputConnection(larger->GetOutputPort());
  this->MoveLight();
  this->Render();
  Check(
    "casters from the list, one with another shape", this->Shadows->GetNumberOfMergedCasters(), 10);
  this->CheckFresh("the same later", 11, ByDepthMap);
  for (int i = 0; i < 6; ++i)
  {
    this->Renderer->RemoveActor(this->Balls[i]);
  }
  this->CheckFresh("six gone", 5, ByDepthMap);
  vtkNew<vtkTexture> texture; // may have holes
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  image->GetPointData()->GetScalars()->Fill(255.0);
  texture->SetInputData(image);
  this->Balls[6]->SetTexture(texture);
  this->CheckFresh("one with a texture", 4, ByDepthMap);
  this->Balls[6]->SetTexture(nullptr);
  this->Balls[6]->SetPosition(0.3, 0.3, 0.4);
  this->CheckFresh("one moved", 5, ByDepthMap);
  for (int i = 0; i < 30; ++i)
  {
    this->AddBall({ -2.0 + 0.15 * i, 0.0, 1.0 }, 0.06);
  }
  this->CheckFresh("thirty more", 35, ByDepthMap);
  this->Balls[7]->VisibilityOff();
  this->CheckFresh("one hidden", 34, ByDepthMap);
}

// A dome of 79 600 triangles, of which a narrow light sees a part.
TEST_F(MergedCasters, APartOfALargeOne)
{
  for (const double* origin : { Here, FarAway })
  {
    this->Renderer->RemoveAllViewProps();
    this->Renderer->RemoveAllLights();
    this->Balls.clear();
    this->Build(origin);
    this->Renderer->RemoveActor(this->Floor);
    for (int i = 0; i < 9; ++i)
    {
      this->Renderer->RemoveActor(this->Balls[i]);
    }
    vtkNew<vtkSphereSource> dome;
    dome->SetCenter(this->At(0.0, 0.0, -6.0));
    dome->SetRadius(6.0);
    dome->SetThetaResolution(200);
    dome->SetPhiResolution(200);
    dome->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    AddActor(this->Renderer, dome);
    this->AddBall({ 0.0, 0.0, 1.0 }, 0.6);
    this->Light->SetFocalPoint(this->At(0.0, 0.0, 0.5));
    this->Light->SetConeAngle(15.0);
    this->CheckFresh("a narrow light", 1, ByDepthMap);
    // Once it is in the list it stays there.
    this->Light->SetConeAngle(60.0);
    this->CheckFresh("a wide one", 1, ByDepthMap);
    const double bytes = static_cast<double>(this->Shadows->GetMergedCasterMemory());
    CheckAtLeast("bytes of the list", bytes, 79600 * 12.0);
    this->Shadows->ReleaseGraphicsResources(this->Window);
    this->CheckFresh("a wide one at once", 0, ByDepthMap);
    Check("bytes", static_cast<double>(this->Shadows->GetMergedCasterMemory()), 0.0);
    this->Renderer->SetPass(nullptr);
  }
}

// A mesh that has another shape in each frame is left to its mapper.
TEST_F(MergedCasters, ALargeOneThatChanges)
{
  this->Build(Here);
  this->Renderer->RemoveAllViewProps();
  vtkNew<vtkSphereSource> dome;
  dome->SetCenter(0.0, 0.0, -6.0);
  dome->SetThetaResolution(200);
  dome->SetPhiResolution(200);
  AddActor(this->Renderer, dome);
  this->Light->SetConeAngle(15.0);
  for (int i = 0; i < 4; ++i)
  {
    dome->SetRadius(6.0 + 0.01 * i);
    this->MoveLight();
    this->Render();
    Check("casters from the list", this->Shadows->GetNumberOfMergedCasters(), 0);
  }
  this->MoveLight();
  this->Render();
  Check("casters from the list once it stands", this->Shadows->GetNumberOfMergedCasters(), 1);
}

// So few are not worth a list.
TEST_F(MergedCasters, Few)
{
  this->Build(Here);
  for (int i = 2; i < 10; ++i)
  {
    this->Renderer->RemoveActor(this->Balls[i]);
  }
  this->CheckFresh("a floor and two balls", 0, ByDepthMap);
}

// While a light and what it shines on stand still nothing is drawn, from a list or by mappers.
TEST_F(MergedCasters, NothingMoves)
{
  this->Build(Here);
  for (int i = 0; i < 3; ++i)
  {
    this->Render();
    Check("casters from the list", this->Shadows->GetNumberOfMergedCasters(), 0);
  }
  Check("bytes of the list", static_cast<double>(this->Shadows->GetMergedCasterMemory()), 0.0);
}

// A list that is given back is made again.
TEST_F(MergedCasters, Released)
{
  this->Build(Here);
  this->CheckFresh("depth-map", 11, ByDepthMap);
  // Ten balls of 1056 triangles, and room for as many again.
  CheckAtLeast("bytes of the list", static_cast<double>(this->Shadows->GetMergedCasterMemory()),
    10 * 1056 * 12.0);
  CheckAtMost("the same", static_cast<double>(this->Shadows->GetMergedCasterMemory()),
    2 * 11 * (1056 * 12.0 + 600 * 16.0));
  this->Shadows->ReleaseGraphicsResources(this->Window);
  Check("bytes once released", static_cast<double>(this->Shadows->GetMergedCasterMemory()), 0.0);
  this->CheckFresh("again", 11, ByDepthMap);
}
