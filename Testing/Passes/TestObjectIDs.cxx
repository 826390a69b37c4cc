// Object-ID maps: what an object is, what a texel holds, when maps are drawn.
#include "ObjectIDTest.h"

#include <vtkAppendPolyData.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkCubeSource.h>
#include <vtkDataArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace shadowtest;

namespace
{

class ObjectIDs : public ObjectIDTest
{
};

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

}

TEST_F(ObjectIDs, Props)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->AddFloorAndSun();
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
TEST_F(ObjectIDs, BlocksOfAComposite)
{
  this->AddFloorAndSun();
  vtkNew<vtkMultiBlockDataSet> blocks, inner;
  const std::vector<vtkSmartPointer<vtkPolyData>> bodies = ConvexBodies();
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    // One after the other in memory, and in another order in the tree.
    (i % 2 ? blocks : inner)->SetBlock(static_cast<unsigned int>(bodies.size() - i), bodies[i]);
  }
  blocks->SetBlock(0, inner);
  for (const vtkSmartPointer<vtkMapper>& mapper : CompositeMappers())
  {
    mapper->SetInputDataObject(blocks);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    this->CheckToldApart("prop", "block", 2 + 12);
    this->Renderer->RemoveActor(actor);
  }
}

namespace
{

// Where glyphs of two kinds hang over each other, at most 18, of these the given ones.
vtkSmartPointer<vtkPolyData> GlyphPlaces(int begin, int end)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkIntArray> kinds;
  kinds->SetName("kind");
  for (int i = begin; i < end; ++i)
  {
    points->InsertNextPoint(0.8 * (i % 3 - 1) + 0.3 * (i / 9), 0.8 * (i / 3 % 3 - 1), 0.5 + i / 9);
    kinds->InsertNextValue(i % 2);
  }
  auto places = vtkSmartPointer<vtkPolyData>::New();
  places->SetPoints(points);
  places->GetPointData()->AddArray(kinds);
  return places;
}

// Draws two sources at such places.
vtkSmartPointer<vtkGlyph3DMapper> GlyphMapperOfTwo(vtkDataObject* places)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.3);
  ball->SetThetaResolution(40);
  ball->SetPhiResolution(30);
  vtkNew<vtkCubeSource> box;
  box->SetXLength(0.5);
  box->SetYLength(0.4);
  box->SetZLength(0.2);
  auto mapper = vtkSmartPointer<vtkGlyph3DMapper>::New();
  mapper->SetInputDataObject(places);
  mapper->SetSourceConnection(0, ball->GetOutputPort());
  mapper->SetSourceConnection(1, box->GetOutputPort());
  mapper->SetSourceIndexArray("kind");
  mapper->SourceIndexingOn();
  mapper->ScalingOff();
  mapper->OrientOff();
  return mapper;
}

vtkSmartPointer<vtkActor> AddActorOf(vtkRenderer* renderer, vtkMapper* mapper)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  return actor;
}

}

// Two sources.
TEST_F(ObjectIDs, InstancesOfGlyphs)
{
  this->AddFloorAndSun();
  auto places = GlyphPlaces(0, 18);
  auto mapper = GlyphMapperOfTwo(places);
  AddActorOf(this->Renderer, mapper);
  this->CheckToldApart("block", "instance", 2 + 18);
  // As ParaView gives them to the mapper: the one block of a composite.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(1, places);
  mapper->SetInputDataObject(blocks);
  this->CheckToldApart("block", "instance", 2 + 18);
}

// Blocks of unlike size in a tree: with one kind alone, empty, hidden, and twice the same.
TEST_F(ObjectIDs, InstancesAtSeveralBlocks)
{
  this->AddFloorAndSun();
  vtkNew<vtkMultiBlockDataSet> blocks, inner;
  auto hidden = GlyphPlaces(0, 9);
  hidden->GetPoints()->GetData()->FillComponent(2, 3.0);
  auto first = GlyphPlaces(0, 5);
  blocks->SetBlock(0, first);
  inner->SetBlock(0, GlyphPlaces(5, 6));
  inner->SetBlock(1, hidden);
  inner->SetBlock(3, GlyphPlaces(0, 0));
  inner->SetBlock(4, GlyphPlaces(6, 13));
  blocks->SetBlock(1, inner);
  blocks->SetBlock(2, first);
  blocks->SetBlock(3, GlyphPlaces(13, 18));
  auto mapper = GlyphMapperOfTwo(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  attributes->SetBlockVisibility(hidden, false);
  mapper->SetBlockAttributes(attributes);
  AddActorOf(this->Renderer, mapper);
  this->CheckToldApart("prop", "instance", 2 + 18);
  // What it draws by is made anew.
  mapper->Modified();
  this->CheckToldApart("prop", "instance", 2 + 18);
  attributes->SetBlockVisibility(hidden, true);
  this->CheckToldApart("prop", "instance", 2 + 18 + 9);
  // Two sources that are one.
  attributes->SetBlockVisibility(hidden, false);
  mapper->SetSourceConnection(1, mapper->GetInputConnection(1, 0));
  this->CheckToldApart("prop", "instance", 2 + 18);
}

TEST_F(ObjectIDs, BlocksOfGlyphs)
{
  this->AddFloorAndSun();
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int i = 0; i < 18; ++i)
  {
    blocks->SetBlock(static_cast<unsigned int>(i), GlyphPlaces(i, i + 1));
  }
  AddActorOf(this->Renderer, GlyphMapperOfTwo(blocks));
  this->CheckToldApart("prop", "block", 2 + 18);
}

// The box's sides do not share points, but their corners are at the same places.
TEST_F(ObjectIDs, PiecesOfAMesh)
{
  this->AddFloorAndSun();
  vtkNew<vtkAppendPolyData> together;
  for (const vtkSmartPointer<vtkPolyData>& body : ConvexBodies())
  {
    together->AddInputData(body);
  }
  together->Update();
  AddActor(this->Renderer, together->GetOutput());
  this->CheckToldApart("instance", "piece", 2 + 1 + 12);
}

// Blocks that are each of two pieces.
TEST_F(ObjectIDs, PiecesOfBlocks)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->AddFloorAndSun();
  const std::vector<vtkSmartPointer<vtkPolyData>> bodies = ConvexBodies();
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (std::size_t i = 0; i < 6; ++i)
  {
    vtkNew<vtkAppendPolyData> two;
    two->AddInputData(bodies[i]);
    two->AddInputData(bodies[i < 3 ? i + 9 : i + 3]); // of the last three, what shadows it
    two->Update();
    blocks->SetBlock(static_cast<unsigned int>(i), two->GetOutput());
  }
  for (const vtkSmartPointer<vtkMapper>& mapper : CompositeMappers())
  {
    mapper->SetInputDataObject(blocks);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    this->CheckToldApart("block", "piece", 2 + 1 + 12);
    this->Renderer->RemoveActor(actor);
  }
}

// What does not cast has no ID in the map. It is lit where all of what the light sees lies behind
// it.
TEST_F(ObjectIDs, ReceiversThatDoNotCast)
{
  this->AddFloorAndSun();
  this->Renderer->RemoveAllViewProps();
  AddSphere(this->Renderer, { 0.0, 0.0, 0.5 }, 0.5);
  auto above = AddBox(this->Renderer, { -1.0, -1.0, 1.5 }, { 1.0, 1.0, 1.6 });
  auto below = AddBox(this->Renderer, { -2.0, -1.0, -1.1 }, { 2.0, 2.0, -1.0 });
  vtkShadowPass::SetCastsShadows(above, false);
  vtkShadowPass::SetCastsShadows(below, false);
  below->VisibilityOff();
  Check("px in shadow of what lies behind",
    static_cast<double>(this->VisibilityOf(this->Light).CountShadowed()), 0.0);
  below->VisibilityOn();
  CheckAtLeast("px in shadow of what lies before",
    static_cast<double>(this->VisibilityOf(this->Light).CountShadowed()), 500.0);
}

// A bracket over itself: its own shadow comes and goes with the depths, and the technique says so.
TEST_F(ObjectIDs, NothingShadowsItselfWithoutDepths)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->AddFloorAndSun();
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

//------------------------------------------------------------------------------
// One tap is as sharp as a texel, more are softer; without depths more tests that must agree shrink
// the shadow.
TEST_F(ObjectIDs, Taps)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Subject subject = AddStillLife(this->Renderer);
  auto spot = AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0);
  AimCamera(this->Renderer, subject, -15.0, 28.0, 400, 300);
  this->Maps()->SetResolution(512);
  double shadowedBefore = 0.0, blendedBefore = -1.0;
  for (const int taps : { 1, 2, 3, 4 })
  {
    this->Maps()->SetTaps(taps);
    const std::string row = std::to_string(taps) + " x " + std::to_string(taps) + " taps";
    const Error error = this->ErrorOf(row, "object-id", spot);
    CheckAtMost(row + ": mismatch", error.mismatch, 0.35);
    const Visibility visibility = this->VisibilityOf(spot);
    const double blended = static_cast<double>(std::count_if(visibility.values.begin(),
      visibility.values.end(), [](float v) { return v > 0.001f && v < 0.999f; }));
    if (taps == 1)
    {
      Check(row + ": pixels between lit and dark", blended, 0.0);
    }
    CheckAtLeast(row + ": pixels between lit and dark", blended, blendedBefore + 1.0);
    blendedBefore = blended;

    this->Maps()->CombineDepthOff();
    const double shadowed = static_cast<double>(this->VisibilityOf(spot).CountShadowed());
    this->Maps()->CombineDepthOn();
    if (taps > 1)
    {
      CheckAtMost(row + ", IDs alone: pixels in shadow", shadowed, shadowedBefore - 20.0);
    }
    shadowedBefore = shadowed;
  }
}

// Eight bits see less of a surface's own relief than 16; more bits than 16 change little.
TEST_F(ObjectIDs, BitsOfADepth)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Subject subject = AddBumpyMesh(this->Renderer);
  auto sun = AddSun(this->Renderer, -Toward(60.0, 25.0));
  AimCamera(this->Renderer, subject, 10.0, 20.0, 400, 300);
  const Visibility finest = [&]()
  {
    this->Maps()->SetDepthBits(32);
    return this->VisibilityOf(sun);
  }();
  double unlike[3];
  const int bits[] = { 8, 16, 24 };
  for (int i = 0; i < 3; ++i)
  {
    this->Maps()->SetDepthBits(bits[i]);
    unlike[i] = static_cast<double>(CountDifferent(this->VisibilityOf(sun), finest));
    std::printf("%d bits: %.0f px unlike 32\n", bits[i], unlike[i]);
  }
  CheckAtLeast("px of 8 bits unlike 32", unlike[0], 10.0);
  CheckAtMost("px of 16 bits unlike 32", unlike[1], 0.2 * unlike[0]);
  CheckAtMost("px of 24 bits unlike 32", unlike[2], unlike[1]);
}

// The same as one mesh: as one object its 16 bits divide the whole range, piece by piece they do
// not.
TEST_F(ObjectIDs, RangesOfPieces)
{
  this->AddFloorAndSun();
  vtkNew<vtkAppendPolyData> together;
  for (const vtkSmartPointer<vtkPolyData>& body : ConvexBodies())
  {
    together->AddInputData(body);
  }
  vtkNew<vtkSphereSource> far;
  far->SetCenter(-300.0, -400.0, 1000.0); // where the sun shines from
  far->SetRadius(0.1);
  far->Update();
  together->AddInputData(far->GetOutput());
  together->Update();
  AddActor(this->Renderer, together->GetOutput());
  this->Maps()->CombineDepthOn();
  double unlike[2];
  for (const int kind : { 0, 1 })
  {
    this->Maps()->SetObjectType(kind == 0 ? "prop" : "piece");
    this->Maps()->SetDepthBits(32);
    const Visibility fine = this->VisibilityOf(this->Light);
    this->Maps()->SetDepthBits(8);
    unlike[kind] = static_cast<double>(CountDifferent(this->VisibilityOf(this->Light), fine));
  }
  CheckAtLeast("px of 8 bits unlike 32, as one object", unlike[0], 1000.0);
  CheckAtMost("px of 8 bits unlike 32, by piece", unlike[1], 0.1 * unlike[0]);
}

// Eight bits of IDs for more objects: one warning, and with depths the shadows are right all the
// same.
TEST_F(ObjectIDs, MoreObjectsThanIDs)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->AddFloorAndSun();
  vtkNew<vtkPolyData> places;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 400; ++i)
  {
    points->InsertNextPoint(0.15 * (i % 20 - 10), 0.15 * (i / 20 - 10), 0.4 + 0.3 * std::sin(i));
  }
  places->SetPoints(points);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.07);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  this->Maps()->CombineDepthOn();
  this->Maps()->SetObjectType("instance");
  const Error with16 = this->ErrorOf("16 bits", "object-id", this->Light);
  this->Maps()->SetDepthBits(24);
  this->Render();
  ExpectOneMessage({ "vtkObjectIDShadowPass", "402 objects", "255 IDs", "\"instance\"" });
  const Error with24 = this->ErrorOf("24 bits", "object-id", this->Light);
  CheckAtMost("mismatch with IDs shared", with24.mismatch, 1.1 * with16.mismatch);
}

//------------------------------------------------------------------------------
// Whatever VTK draws, at the depths of a float: the depth map's picture.
TEST_F(ObjectIDs, WhateverVTKDraws)
{
  this->Renderer->AutomaticLightCreationOff();
  AddFloor(this->Renderer, 4.0);
  auto glass = AddBox(this->Renderer, { -2.0, -2.5, 0.0 }, { 2.0, -2.4, 1.0 });
  glass->GetProperty()->SetOpacity(0.5);
  auto edged = AddSphere(this->Renderer, { 1.5, 0.0, 0.8 }, 0.6, 12);
  edged->GetProperty()->EdgeVisibilityOn();
  auto wires = AddSphere(this->Renderer, { -1.5, 0.6, 0.8 }, 0.6, 12);
  wires->GetProperty()->SetRepresentationToWireframe();
  wires->GetProperty()->SetLineWidth(3.0);
  AddSphere(this->Renderer, { 0.0, 1.4, 1.0 }, 0.5)->GetProperty()->SetInterpolationToPBR();
  auto catcher = AddBox(this->Renderer, { -4.0, 2.5, 0.0 }, { 4.0, 2.6, 3.0 });
  vtkShadowPass::SetShadowCatcher(catcher, true);
  vtkNew<vtkPolyData> centres;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, -0.8, 1.2);
  points->InsertNextPoint(0.5, -0.6, 0.5);
  vtkNew<vtkCellArray> verts;
  for (vtkIdType i = 0; i < 2; ++i)
  {
    verts->InsertNextCell(1, &i);
  }
  centres->SetPoints(points);
  centres->SetVerts(verts);
  vtkNew<vtkOpenGLSphereMapper> spheres;
  spheres->SetInputData(centres);
  spheres->SetRadius(0.35);
  vtkNew<vtkActor> impostors;
  impostors->SetMapper(spheres);
  this->Renderer->AddActor(impostors);
  LookAt(this->Renderer, { 1.0, -7.0, 4.0 }, { 0.0, 0.0, 0.8 });
  auto sun = AddSun(this->Renderer, { 0.3, 0.6, -1.0 });
  AddSpot(this->Renderer, { 2.5, -3.0, 6.0 }, { 0.0, 0.0, 0.5 }, 40.0);
  auto lamp = AddLamp(this->Renderer, { -0.6, 0.3, 1.6 });
  this->Shadows->SetLightStrength(sun, 0.6);
  this->Renderer->GetLights()->InitTraversal();
  while (vtkLight* light = this->Renderer->GetLights()->GetNextItem())
  {
    light->SetIntensity(0.35); // together no brighter than white
  }

  this->Shadows->SetTechnique("depth-map");
  const Frame byDepth = this->Render();
  this->Shadows->SetTechnique("none");
  const Frame lit = this->Render();
  CheckAtLeast(
    "px that shadows change", static_cast<double>(CountDifferent(byDepth, lit, 8)), 5000.0);
  this->Shadows->SetTechnique("object-id");
  const double pixels = static_cast<double>(byDepth.rgb.size() / 3);
  for (int type = 0; type < vtkObjectIDShadowPass::GetNumberOfObjectTypes(); ++type)
  {
    for (const int bits : { 32, 16 })
    {
      if (bits == 16 && type != vtkObjectIDShadowPass::PROP)
      {
        continue; // each has shaders of its own, which take long to make
      }
      this->Maps()->SetObjectType(type);
      this->Maps()->SetDepthBits(bits);
      const Frame frame = this->Render();
      CheckAtMost("px unlike the depth map's, by " +
          vtkObjectIDShadowPass::GetObjectTypeName(type) + ", " + std::to_string(bits) + " bits",
        static_cast<double>(CountDifferent(frame, byDepth, 8)), 0.0005 * pixels);
    }
  }

  // Beside other techniques in one frame each keeps its own.
  this->Shadows->SetLightTechnique(lamp, "depth-map");
  CheckAtMost("px unlike the depth map's, mixed with it",
    static_cast<double>(CountDifferent(this->Render(), byDepth, 8)), 0.0005 * pixels);

  // IDs alone cast, too: the frame is neither lit nor the same.
  this->Shadows->ClearLightSettings(lamp);
  this->Maps()->CombineDepthOff();
  CheckAtLeast("px that IDs alone shadow",
    static_cast<double>(CountDifferent(this->Render(), lit, 8)), 5000.0);
}

// Sixteen lights at once, by all forms.
TEST_F(ObjectIDs, SixteenLights)
{
  this->Renderer->AutomaticLightCreationOff();
  const Subject subject = AddStillLife(this->Renderer);
  AimCamera(this->Renderer, subject, -15.0, 28.0, 400, 300);
  std::vector<vtkSmartPointer<vtkLight>> lights;
  for (int i = 0; i < 16; ++i)
  {
    const glm::dvec3 toward = Toward(22.5 * i, 35.0 + 2.0 * i);
    lights.push_back(i % 2 ? AddSun(this->Renderer, -toward)
                           : AddSpot(this->Renderer, 7.0 * toward, { 0.0, 0.0, 0.3 }, 30.0));
    lights.back()->SetIntensity(0.1);
  }
  this->Maps()->SetResolution(512);
  this->Shadows->GetDepthShadowMapPass()->SetResolution(512);
  const char* techniques[] = { "object-id", "depth-map", "stencil-volume" };
  this->Shadows->SetTechnique("depth-map");
  const Frame byDepth = this->Render();
  this->Shadows->SetTechnique("object-id");
  CheckAtMost("px unlike the depth map's",
    static_cast<double>(CountDifferent(this->Render(), byDepth, 2)), 50.0);
  for (int i = 0; i < 16; ++i)
  {
    this->Shadows->SetLightTechnique(lights[i], techniques[i % 3]);
  }
  this->Render();
  const Visibility mixed = this->VisibilityOf(lights[3]);
  this->Shadows->SetTechnique("depth-map");
  this->Shadows->SetLightTechnique(lights[3], "depth-map");
  CheckAtMost("px of a light among others of other techniques, unlike the depth map's",
    static_cast<double>(CountDifferent(mixed, this->VisibilityOf(lights[3]))), 10.0);
}

//------------------------------------------------------------------------------
TEST_F(ObjectIDs, MapsAreDrawnWhenStale)
{
  AddFloor(this->Renderer, 5.0);
  auto ball = AddSphere(this->Renderer, { -1.0, 0.0, 1.2 }, 0.8);
  auto box = AddBox(this->Renderer, { 0.6, -0.6, 0.0 }, { 1.7, 0.6, 1.4 });
  auto light = AddSpot(this->Renderer, { 2.5, -2.5, 6.0 }, { 0.0, 0.0, 0.5 }, 40.0);
  LookAt(this->Renderer, { 1.0, -7.0, 5.0 }, { 0.0, 0.0, 0.5 });
  this->Render();
  const auto check = [&](const std::string& what, double maps)
  {
    const vtkIdType before = this->Maps()->GetNumberOfMapBuilds();
    const Frame frame = this->Render();
    Check(what + ": maps drawn", static_cast<double>(this->Maps()->GetNumberOfMapBuilds() - before),
      maps);
    vtkNew<vtkShadowPass> fresh;
    fresh->SetTechnique("object-id");
    vtkObjectIDShadowPass* maps2 = fresh->GetObjectIDShadowPass();
    maps2->SetObjectType(this->Maps()->GetObjectType());
    maps2->SetCombineDepth(this->Maps()->GetCombineDepth());
    maps2->SetDepthBits(this->Maps()->GetDepthBits());
    maps2->SetTaps(this->Maps()->GetTaps());
    this->Renderer->SetPass(fresh);
    const Frame expected = this->Render();
    this->Renderer->SetPass(this->Shadows);
    Check(what + ": px unlike a fresh pass's", static_cast<double>(CountDifferent(frame, expected)),
      0.0);
  };
  check("nothing", 0);
  this->Renderer->GetActiveCamera()->Azimuth(10.0);
  check("the camera moved", 0);
  ball->GetProperty()->SetColor(1.0, 0.0, 0.0);
  check("a colour", 0);
  light->SetPosition(2.0, -2.5, 6.0);
  check("the light moved", 1);
  box->SetPosition(0.1, 0.0, 0.0);
  check("a caster moved", 1);
  for (const char* type : { "block", "instance", "piece" })
  {
    this->Maps()->SetObjectType(type);
    check(std::string("objects by ") + type, 1);
  }
  for (const int bits : { 8, 24, 32, 16 })
  {
    this->Maps()->SetDepthBits(bits);
    check(std::to_string(bits) + " bits", 1);
  }
  this->Maps()->CombineDepthOff();
  check("IDs alone", 1);
  this->Maps()->SetTaps(2);
  check("the taps that there were", 0);
  this->Maps()->CombineDepthOn();
  check("with depths", 1);
  auto hidden = AddSphere(this->Renderer, { 0.0, 1.5, 0.5 }, 0.4);
  check("one caster more", 1);
  vtkShadowPass::SetCastsShadows(ball, false);
  check("one caster less", 1);
  this->Renderer->RemoveActor(hidden);
  check("another caster less", 1);
}

// What casts by another mesh is one object with it: it is not in shadow of a hull around it.
TEST_F(ObjectIDs, StandIns)
{
  AddFloor(this->Renderer, 5.0);
  auto ball = AddSphere(this->Renderer, { 0.0, 0.0, 1.2 }, 0.8);
  vtkNew<vtkSphereSource> hull;
  hull->SetCenter(0.0, 0.0, 1.2);
  hull->SetRadius(0.9);
  hull->Update();
  vtkShadowPass::SetStandIn(ball, hull->GetOutput());
  auto sun = AddSun(this->Renderer, { 0.3, 0.4, -1.0 });
  LookAt(this->Renderer, { 1.0, -7.0, 5.0 }, { 0.0, 0.0, 0.5 });
  this->Render();
  const double deep = static_cast<double>(this->VisibilityOf(sun).CountShadowed());
  this->Maps()->CombineDepthOff();
  const double alone = static_cast<double>(this->VisibilityOf(sun).CountShadowed());
  CheckAtLeast("px of the hull's shadow on the floor", alone, 1000.0);
  CheckAtLeast("px more in shadow with depths: the ball in its hull", deep - alone, 1000.0);
}

//------------------------------------------------------------------------------
TEST_F(ObjectIDs, BadSettings)
{
  AddFloor(this->Renderer, 5.0);
  AddSphere(this->Renderer, { 0.0, 0.0, 1.2 }, 0.8);
  AddSun(this->Renderer, { 0.3, 0.4, -1.0 });
  LookAt(this->Renderer, { 1.0, -7.0, 5.0 }, { 0.0, 0.0, 0.5 });
  const Frame before = this->Render();
  vtkObjectIDShadowPass* maps = this->Maps();
  for (const int bits : { 0, -8, 12, 64 })
  {
    maps->SetDepthBits(bits);
    ExpectOneMessage({ "vtkObjectIDShadowPass", std::to_string(bits), "8, 16, 24 or 32" });
  }
  for (const int taps : { 0, -1, 5 })
  {
    maps->SetTaps(taps);
    ExpectOneMessage({ "vtkObjectIDShadowPass", std::to_string(taps), "1 to 4" });
  }
  for (const int type : { -1, 4 })
  {
    maps->SetObjectType(type);
    ExpectOneMessage({ "vtkObjectIDShadowPass", std::to_string(type), "0 to 3" });
  }
  maps->SetObjectType("atom");
  ExpectOneMessage({ "vtkObjectIDShadowPass", "\"atom\"", "prop, block, instance, piece" });
  maps->SetResolution(0);
  ExpectOneMessage({ "vtkObjectIDShadowPass", "0", "1 or more" });
  Check(
    "px unlike the frame before", static_cast<double>(CountDifferent(this->Render(), before)), 0.0);
  Check("maps drawn", static_cast<double>(maps->GetNumberOfMapBuilds()), 1.0);

  for (const int resolution : { 1, 2, 3, 7, 2048 })
  {
    maps->SetResolution(resolution);
    this->Render();
  }
  Check(
    "px unlike the frame before", static_cast<double>(CountDifferent(this->Render(), before)), 0.0);
}
