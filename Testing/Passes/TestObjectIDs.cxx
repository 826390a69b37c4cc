// Object-ID maps: against the truth and beside the depth map, what an object is, what a texel
// holds, when maps are drawn.
#include "ShadowTest.h"
#include "TestScenes.h"

#include "vtkObjectIDShadowPass.h"
#include "vtkShadowErrorMeasure.h"

#include <vtkAppendPolyData.h>
#include <vtkCompositePolyDataMapper2.h>
#include <vtkCubeSource.h>
#include <vtkGlyph3DMapper.h>
#include <vtkIntArray.h>
#include <vtkLightCollection.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

using namespace shadowtest;

namespace
{

struct Error
{
  double mismatch = 0.0; // percent of the receiver pixels
  double gross = 0.0;    // pixels
  double receivers = 0.0;
  double shadow = 0.0;
};

class ObjectIDs : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Renderer->SetPass(this->Shadows);
    this->Shadows->SetTechnique("object-id");
  }

  vtkObjectIDShadowPass* Maps() { return this->Shadows->GetObjectIDShadowPass(); }

  Error ErrorOf(const std::string& what, const std::string& technique, vtkLight* light)
  {
    this->Shadows->SetTechnique(technique);
    this->Render();
    vtkNew<vtkShadowErrorMeasure> error;
    EXPECT_TRUE(error->Measure(this->Renderer, light)) << what;
    Error found;
    found.mismatch = error->GetMismatchPercent();
    found.gross = static_cast<double>(error->GetGrossFalsePixels() + error->GetGrossMissedPixels());
    found.receivers = static_cast<double>(error->GetReceiverPixels());
    found.shadow = static_cast<double>(error->GetShadowPixels());
    std::printf("%-34s %-10s mismatch %.4f %% gross %lld false, %lld missed of %.0f\n",
      what.c_str(), technique.c_str(), found.mismatch,
      static_cast<long long>(error->GetGrossFalsePixels()),
      static_cast<long long>(error->GetGrossMissedPixels()), found.receivers);
    EXPECT_GT(found.shadow, found.receivers / 100) << what << ": few shadows";
    return found;
  }

  // At the default settings no grosser than the depth map, 16 bits as good as 32; what 8 bits lose
  // is printed.
  void CheckBesideDepthMap(const std::string& what)
  {
    this->Renderer->GetLights()->InitTraversal();
    int index = 0;
    while (vtkLight* light = this->Renderer->GetLights()->GetNextItem())
    {
      const std::string row = what + ", light " + std::to_string(index++);
      const Error byDepth = this->ErrorOf(row, "depth-map", light);
      Error byBits[4];
      const int bits[] = { 8, 16, 24, 32 };
      for (int i = 0; i < 4; ++i)
      {
        this->Maps()->SetDepthBits(bits[i]);
        byBits[i] =
          this->ErrorOf(row + ", " + std::to_string(bits[i]) + " bits", "object-id", light);
      }
      this->Maps()->SetDepthBits(16);
      CheckAtMost(row + ": gross px, beside the depth map's", byBits[1].gross, byDepth.gross);
      CheckAtMost(row + ": mismatch at 16 bits, beside 1.5 times that at 32", byBits[1].mismatch,
        1.5 * byBits[3].mismatch);
      CheckAtMost(row + ": gross at 16 bits, beside 1.5 times that at 32", byBits[1].gross,
        1.5 * byBits[3].gross);
      CheckAtMost(row + ": mismatch, beside 1.1 times the depth map's", byBits[1].mismatch,
        1.1 * byDepth.mismatch);
    }
  }
};

}

TEST_F(ObjectIDs, StillLifeWithASpot)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(1024, 768);
  const Subject subject = AddStillLife(this->Renderer);
  AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0);
  AimCamera(this->Renderer, subject, -15.0, 28.0, 1024, 768);
  this->CheckBesideDepthMap("still life");
}

TEST_F(ObjectIDs, BumpyMeshWithASun)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(1024, 768);
  const Subject subject = AddBumpyMesh(this->Renderer);
  AddSun(this->Renderer, -Toward(60.0, 40.0));
  AimCamera(this->Renderer, subject, 10.0, 20.0, 1024, 768);
  this->CheckBesideDepthMap("bumpy mesh");
}

TEST_F(ObjectIDs, TubesAndGlyphsWithTwoLights)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(1024, 768);
  const Subject subject = AddTubesAndGlyphs(this->Renderer);
  AddSpot(this->Renderer, { 4.0, -3.0, 7.0 }, { 0.0, 0.0, 0.8 }, 30.0);
  AddSun(this->Renderer, -Toward(-50.0, 50.0));
  AimCamera(this->Renderer, subject, 5.0, 25.0, 1024, 768);
  this->CheckBesideDepthMap("tubes and glyphs");
}

// Lights and cameras by lot, in turn on each of the scenes, and every kind of object in turn.
TEST_F(ObjectIDs, UnseenViews)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(512, 384);
  for (int seed = 101; seed <= 112; ++seed)
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
    const glm::dvec3 toward = Toward(any(0.0, 360.0), any(20.0, 80.0));
    if (any(0.0, 1.0) < 0.5)
    {
      AddSun(this->Renderer, -toward);
    }
    else
    {
      AddSpot(this->Renderer, subject.centre + any(2.0, 5.0) * subject.radius * toward,
        subject.centre, any(25.0, 50.0));
    }
    AimCamera(this->Renderer, subject, any(0.0, 360.0), any(10.0, 70.0), 512, 384);
    this->Maps()->SetObjectType(seed % vtkObjectIDShadowPass::GetNumberOfObjectTypes());
    this->CheckBesideDepthMap("seed " + std::to_string(seed) + ", by " +
      vtkObjectIDShadowPass::GetObjectTypeName(this->Maps()->GetObjectType()));
  }
}

// A point light in a closed room: the faces of a cube.
TEST_F(ObjectIDs, PointLightInARoom)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Renderer->AutomaticLightCreationOff();
  AddBox(this->Renderer, { -3.0, -3.0, 0.0 }, { 3.0, 3.0, 4.0 });
  AddSphere(this->Renderer, { 1.5, 1.5, 1.0 }, 0.6);
  AddSphere(this->Renderer, { -1.6, 0.2, 2.0 }, 0.4);
  AddBox(this->Renderer, { 0.5, -1.8, 0.0 }, { 1.3, -0.9, 0.9 });
  auto lamp = AddLamp(this->Renderer, { 0.2, 0.3, 2.1 });
  this->Renderer->GetActiveCamera()->SetViewAngle(80.0);
  LookAt(this->Renderer, { 2.5, 2.5, 3.5 }, { -1.0, -1.0, 0.5 });
  this->Maps()->SetResolution(1024);
  this->Shadows->GetDepthShadowMapPass()->SetResolution(1024);
  this->CheckBesideDepthMap("room");
  Check("maps a light", static_cast<double>(this->Maps()->GetNumberOfMapBuilds()), 4 * 6.0);
  lamp->SetPosition(2.2, -2.4, 3.7);
  this->CheckBesideDepthMap("lamp in a corner");
}

// Far from the origin, very small, very large.
TEST_F(ObjectIDs, OffsetsAndScales)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(640, 480);
  const double placements[][2] = { { 1e6, 1.0 }, { 0.0, 1e-6 }, { 0.0, 1e6 } };
  for (const auto& placement : placements)
  {
    for (const bool byActor : { true, false })
    {
      this->Renderer->RemoveAllViewProps();
      this->Renderer->RemoveAllLights();
      Subject subject = AddStillLife(this->Renderer);
      const double offset = placement[0], scale = placement[1];
      const auto place = [&](const glm::dvec3& p) { return glm::dvec3(offset) + scale * p; };
      vtkNew<vtkTransform> worldFromScene;
      worldFromScene->Translate(offset, offset, offset);
      worldFromScene->Scale(scale, scale, scale);
      PlaceActors(this->Renderer, worldFromScene, byActor);
      AddSpot(this->Renderer, place({ 3.5, -3.0, 6.5 }), place({ 0.0, 0.0, 0.3 }), 35.0);
      subject.centre = place(subject.centre);
      subject.radius *= scale;
      AimCamera(this->Renderer, subject, -15.0, 28.0, 640, 480);
      // Pieces are told by their vertices.
      this->Maps()->SetObjectType(byActor ? "prop" : "piece");
      this->CheckBesideDepthMap("offset " + std::to_string(offset) + ", scale " +
        std::to_string(scale) + (byActor ? ", by actor" : ", by points"));
    }
  }
}

//------------------------------------------------------------------------------
// What is an object. Without depths nothing shadows itself; so where all objects are convex, and
// told apart, there is nothing that must be missed.
namespace
{

vtkSmartPointer<vtkPolyData> MadeBy(vtkAlgorithm* source, const glm::dvec3& place, double turn)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(place.x, place.y, place.z);
  transform->RotateWXYZ(turn, 1.0, 2.0, 3.0);
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetTransform(transform);
  moved->SetInputConnection(source->GetOutputPort());
  moved->Update();
  return moved->GetOutput();
}

// Convex bodies that hang over each other, of different kinds of points and cells.
std::vector<vtkSmartPointer<vtkPolyData>> ConvexBodies()
{
  std::vector<vtkSmartPointer<vtkPolyData>> bodies;
  for (int i = 0; i < 12; ++i)
  {
    const glm::dvec3 place(
      0.9 * (i % 3 - 1), 0.9 * (i / 3 % 2 - 0.5) + 0.25 * (i / 6), 0.6 + 1.3 * (i / 6));
    vtkNew<vtkCubeSource> box;
    box->SetXLength(0.6);
    box->SetYLength(0.3 + 0.03 * i);
    box->SetZLength(0.2);
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(0.2 + 0.01 * i);
    ball->SetThetaResolution(30 + i);
    ball->SetPhiResolution(20 + i);
    ball->SetGenerateNormals(i % 4 < 2);
    bodies.push_back(i % 3 == 0 ? MadeBy(box, place, 30.0 * i) : MadeBy(ball, place, 0.0));
  }
  return bodies;
}

class ObjectKinds : public ObjectIDs
{
protected:
  void SetUp() override
  {
    ObjectIDs::SetUp();
    this->Resize(640, 480);
    AddFloor(this->Renderer, 4.0);
    this->Light = AddSun(this->Renderer, { 0.3, 0.4, -1.0 });
    LookAt(this->Renderer, { 1.0, -6.0, 4.5 }, { 0.0, 0.0, 0.9 });
    this->Maps()->CombineDepthOff();
  }

  // By `type` as the truth has it, but for an edge a texel narrower; with the coarser one much is
  // missed; and with depths both are right.
  void CheckToldApart(const std::string& coarser, const std::string& type, int objects)
  {
    SHADOWTEST_NEEDS_RAY_CAST();
    this->Maps()->SetObjectType(coarser);
    const Error merged = this->ErrorOf("merged, by " + coarser, "object-id", this->Light);
    CheckAtLeast("gross px where objects are merged", merged.gross, 500.0);
    this->Maps()->SetObjectType(type);
    const Error apart = this->ErrorOf("told apart, by " + type, "object-id", this->Light);
    CheckAtMost("mismatch where objects are told apart", apart.mismatch, 0.3);
    CheckAtMost("gross px where objects are told apart", apart.gross, 0.0);
    Check("objects", this->Maps()->GetNumberOfObjects(), objects);
    this->Maps()->CombineDepthOn();
    for (const std::string& each : { coarser, type })
    {
      this->Maps()->SetObjectType(each);
      const Error deep = this->ErrorOf("with depths, by " + each, "object-id", this->Light);
      CheckAtMost("mismatch with depths", deep.mismatch, 0.1);
      CheckAtMost("gross px with depths", deep.gross, 0.0);
    }
    this->Maps()->CombineDepthOff();
  }

  vtkSmartPointer<vtkLight> Light;
};

}

TEST_F(ObjectKinds, Props)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  for (const vtkSmartPointer<vtkPolyData>& body : ConvexBodies())
  {
    AddActor(this->Renderer, body);
  }
  const Error error = this->ErrorOf("props", "object-id", this->Light);
  CheckAtMost("mismatch", error.mismatch, 0.3);
  CheckAtMost("gross px", error.gross, 0.0);
  Check("objects", this->Maps()->GetNumberOfObjects(), 13.0);
}

// Blocks of unlike arrays are drawn by several of VTK's mappers.
TEST_F(ObjectKinds, BlocksOfAComposite)
{
  vtkNew<vtkMultiBlockDataSet> blocks, inner;
  const std::vector<vtkSmartPointer<vtkPolyData>> bodies = ConvexBodies();
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    // One after the other in memory, and in another order in the tree.
    (i % 2 ? blocks : inner)->SetBlock(static_cast<unsigned int>(bodies.size() - i), bodies[i]);
  }
  blocks->SetBlock(0, inner);
  vtkNew<vtkCompositePolyDataMapper2> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  this->CheckToldApart("prop", "block", 2 + 12);
}

// Two sources, a mask, and instances of different sizes.
TEST_F(ObjectKinds, InstancesOfGlyphs)
{
  vtkNew<vtkPolyData> places;
  vtkNew<vtkPoints> points;
  vtkNew<vtkIntArray> kinds;
  kinds->SetName("kind");
  for (int i = 0; i < 18; ++i)
  {
    points->InsertNextPoint(0.8 * (i % 3 - 1) + 0.3 * (i / 9), 0.8 * (i / 3 % 3 - 1), 0.5 + i / 9);
    kinds->InsertNextValue(i % 2);
  }
  places->SetPoints(points);
  places->GetPointData()->AddArray(kinds);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.3);
  ball->SetThetaResolution(40);
  ball->SetPhiResolution(30);
  vtkNew<vtkCubeSource> box;
  box->SetXLength(0.5);
  box->SetYLength(0.4);
  box->SetZLength(0.2);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceConnection(0, ball->GetOutputPort());
  mapper->SetSourceConnection(1, box->GetOutputPort());
  mapper->SetSourceIndexArray("kind");
  mapper->SourceIndexingOn();
  mapper->ScalingOff();
  mapper->OrientOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  this->CheckToldApart("block", "instance", 2 + 18);
}

// The box's sides do not share points, but their corners are at the same places.
TEST_F(ObjectKinds, PiecesOfAMesh)
{
  vtkNew<vtkAppendPolyData> together;
  for (const vtkSmartPointer<vtkPolyData>& body : ConvexBodies())
  {
    together->AddInputData(body);
  }
  together->Update();
  AddActor(this->Renderer, together->GetOutput());
  this->CheckToldApart("instance", "piece", 2 + 1 + 12);
}

// A bracket over itself: its own shadow comes and goes with the depths, and the technique says so.
TEST_F(ObjectKinds, NothingShadowsItselfWithoutDepths)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Renderer->RemoveAllViewProps();
  vtkNew<vtkAppendPolyData> bracket;
  for (const double height : { 0.0, 1.0 })
  {
    vtkNew<vtkCubeSource> plate;
    plate->SetBounds(-1.0, height > 0.0 ? 0.0 : 1.0, -1.0, 1.0, height, height + 0.1);
    plate->Update();
    bracket->AddInputData(plate->GetOutput());
  }
  bracket->Update();
  AddActor(this->Renderer, bracket->GetOutput());
  const double truth =
    static_cast<double>(this->VisibilityBy("ray-cast", this->Light).CountShadowed());
  for (const int taps : { 1, 2, 3, 4 })
  {
    this->Maps()->SetTaps(taps);
    Check("pixels in shadow of themselves",
      static_cast<double>(this->VisibilityBy("object-id", this->Light).CountShadowed()), 0.0);
  }
  EXPECT_FALSE(this->Maps()->GetSelfShadows());
  this->Maps()->SetTaps(2);
  this->Maps()->CombineDepthOn();
  EXPECT_TRUE(this->Maps()->GetSelfShadows());
  Check("pixels in shadow with depths",
    static_cast<double>(this->VisibilityBy("object-id", this->Light).CountShadowed()), truth,
    0.02 * truth);
  CheckAtLeast("pixels in shadow, by rays", truth, 1000.0);
}
