// Every kind of prop casts and receives the same by depth map as by ray cast, and by ray cast the
// same as plain triangles baked into its place.
#include "ShadowTest.h"
#include "TestScenes.h"
#include "vtkShadowScene.h"

#include <vtkAppendPolyData.h>
#include <vtkAssembly.h>
#include <vtkBitArray.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkCompositePolyDataMapper.h>
#if __has_include(<vtkCompositePolyDataMapper2.h>)
#include <vtkCompositePolyDataMapper2.h>
#endif
#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkDataSetMapper.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3D.h>
#include <vtkGlyph3DMapper.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkIntArray.h>
#include <vtkMatrix4x4.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkStripper.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangleFilter.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <cstdlib>
#include <functional>

using namespace shadowtest;

namespace
{

using Mesh = vtkSmartPointer<vtkPolyData>;

Mesh Updated(vtkPolyDataAlgorithm* source)
{
  source->Update();
  Mesh mesh = Mesh::New();
  mesh->ShallowCopy(source->GetOutput());
  return mesh;
}

Mesh Cone(const glm::dvec3& direction, double height, double radius)
{
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(40);
  cone->SetHeight(height);
  cone->SetRadius(radius);
  cone->SetDirection(direction.x, direction.y, direction.z);
  return Updated(cone);
}

Mesh Ball(const glm::dvec3& centre, double radius, int resolution = 40)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(centre.x, centre.y, centre.z);
  ball->SetRadius(radius);
  ball->SetThetaResolution(resolution);
  ball->SetPhiResolution(resolution);
  return Updated(ball);
}

Mesh Brick(const glm::dvec3& centre, const glm::dvec3& size)
{
  vtkNew<vtkCubeSource> brick;
  brick->SetCenter(centre.x, centre.y, centre.z);
  brick->SetXLength(size.x);
  brick->SetYLength(size.y);
  brick->SetZLength(size.z);
  return Updated(brick);
}

Mesh Joined(const std::vector<Mesh>& parts)
{
  vtkNew<vtkAppendPolyData> append;
  for (const Mesh& part : parts)
  {
    append->AddInputData(part);
  }
  return Updated(append);
}

Mesh Moved(const Mesh& mesh, vtkTransform* transform)
{
  vtkNew<vtkTransformPolyDataFilter> move;
  move->SetInputData(mesh);
  move->SetTransform(transform);
  return Updated(move);
}

// Like no mirror image of itself; about 2 across, centred at the origin.
Mesh Thing()
{
  return Joined({ Cone({ 1.0, 0.2, 0.3 }, 1.6, 0.4), Ball({ -0.6, 0.5, 0.3 }, 0.4),
    Brick({ 0.3, -0.6, 0.0 }, { 0.5, 0.3, 0.7 }) });
}

vtkSmartPointer<vtkActor> ActorWith(vtkMapper* mapper)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkActor> ActorOf(const Mesh& mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  return ActorWith(mapper);
}

//------------------------------------------------------------------------------
// Places of glyphs and spheres: over the floor, with direction, size and kind.
Mesh Places(int count)
{
  Mesh places = Mesh::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkFloatArray> direction, size;
  vtkNew<vtkIntArray> kind;
  vtkNew<vtkBitArray> shown;
  direction->SetName("direction");
  direction->SetNumberOfComponents(3);
  size->SetName("size");
  kind->SetName("kind");
  shown->SetName("shown");
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.4 * i, reach = 1.6 * std::sqrt((i + 0.5) / count);
    const vtkIdType id = points->InsertNextPoint(
      reach * std::cos(angle), reach * std::sin(angle), 1.0 + 0.5 * std::sin(3.0 * i));
    verts->InsertNextCell({ id });
    // The first looks along -x, the second along +x: where a rotation from +x is a special case.
    direction->InsertNextTuple3(i == 0 ? -1.0
        : i == 1                       ? 1.0
                                       : std::cos(5.0 * i),
      i < 2 ? 0.0 : std::sin(7.0 * i), i < 2 ? 0.0 : std::sin(2.0 * i + 1.0));
    size->InsertNextValue(static_cast<float>(0.15 + 0.1 * std::abs(std::sin(1.7 * i))));
    kind->InsertNextValue(i % 3);
    shown->InsertNextValue(i % 4 == 1 ? 0 : 1);
  }
  places->SetPoints(points);
  places->SetVerts(verts);
  for (vtkDataArray* array :
    { static_cast<vtkDataArray*>(direction), static_cast<vtkDataArray*>(size),
      static_cast<vtkDataArray*>(kind), static_cast<vtkDataArray*>(shown) })
  {
    places->GetPointData()->AddArray(array);
  }
  return places;
}

Mesh PlacesWhere(const Mesh& places, const char* array, double value)
{
  Mesh some = Mesh::New();
  some->GetPointData()->CopyAllocate(places->GetPointData());
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < places->GetNumberOfPoints(); ++i)
  {
    if (places->GetPointData()->GetArray(array)->GetComponent(i, 0) == value)
    {
      const vtkIdType id = points->InsertNextPoint(places->GetPoint(i));
      some->GetPointData()->CopyData(places->GetPointData(), i, id);
    }
  }
  some->SetPoints(points);
  return some;
}

// VTK's filter, which knows nothing of the mapper, makes the same glyphs as triangles.
Mesh Glyphs(const Mesh& places, const Mesh& source, double factor, bool bySize)
{
  vtkNew<vtkGlyph3D> glyph;
  glyph->SetInputData(places);
  glyph->SetSourceData(source);
  glyph->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "size");
  glyph->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "direction");
  glyph->SetVectorModeToUseVector();
  glyph->OrientOn();
  bySize ? glyph->SetScaleModeToScaleByScalar() : glyph->SetScaleModeToScaleByVector();
  glyph->SetScaleFactor(factor);
  return Updated(glyph);
}

vtkSmartPointer<vtkGlyph3DMapper> GlyphMapper(const Mesh& places, const Mesh& source)
{
  auto mapper = vtkSmartPointer<vtkGlyph3DMapper>::New();
  mapper->SetInputData(places);
  mapper->SetSourceData(source);
  mapper->SetOrientationArray("direction");
  mapper->SetScaleArray("size");
  mapper->SetScaleModeToScaleByMagnitude();
  mapper->ScalarVisibilityOff();
  return mapper;
}

// Each place's glyph by the transform that the mapper's documentation promises.
Mesh GlyphsBy(const Mesh& places, const Mesh& source,
  const std::function<void(vtkIdType, vtkTransform*)>& turnAndScale)
{
  std::vector<Mesh> parts;
  for (vtkIdType i = 0; i < places->GetNumberOfPoints(); ++i)
  {
    vtkNew<vtkTransform> transform;
    transform->Translate(places->GetPoint(i));
    turnAndScale(i, transform);
    parts.push_back(Moved(source, transform));
  }
  return Joined(parts);
}

//------------------------------------------------------------------------------
// A floor, the prop over it, and a bar above that throws a shadow on the prop.
class Props : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Floor = AddFloor(this->Renderer, 5.0);
    this->Bar = AddBox(this->Renderer, { -2.5, -0.85, 2.8 }, { 2.5, -0.5, 3.0 });
    this->Light = AddSpot(this->Renderer, { 2.0, -3.0, 8.0 }, { 0.0, 0.0, 0.8 }, 40.0);
    LookAt(this->Renderer, { 1.0, -6.0, 5.0 }, { 0.0, 0.2, 0.8 });
    this->Renderer->SetPass(this->Shadows);
  }

  // `share` in percent of the window: how far the baked triangles may be from what the prop draws.
  void CheckProp(vtkProp* prop, const Mesh& baked, double share = 0.05);
  void CheckGlyphs(vtkMapper* mapper, const Mesh& baked);
  void CheckDepthMap(const std::string& what);
  void CheckCasts(vtkProp* prop, const Visibility& whole);
  void CheckReceives(vtkProp* prop, const Visibility& whole);
  Visibility SilhouetteOf(vtkProp* prop);

  vtkSmartPointer<vtkActor> Floor, Bar;
  vtkSmartPointer<vtkLight> Light;
  double Mismatch = 0.1; // of a depth map, in percent of the receiver pixels
};

double Share(std::size_t pixels, const Visibility& of)
{
  return 100.0 * pixels / of.values.size();
}

void Props::CheckDepthMap(const std::string& what)
{
  this->Shadows->SetTechnique("depth-map");
  this->Render();
  this->CheckMeasure(what + ", by depth map", this->Light, this->Mismatch, 0.005);
}

// Where the prop alone is drawn, as 0.
Visibility Props::SilhouetteOf(vtkProp* prop)
{
  this->Floor->VisibilityOff();
  this->Bar->VisibilityOff();
  prop->VisibilityOn();
  const Frame frame = this->RenderWithoutPass();
  this->Floor->VisibilityOn();
  this->Bar->VisibilityOn();
  Visibility silhouette;
  silhouette.width = frame.width;
  silhouette.height = frame.height;
  for (int y = 0; y < frame.height; ++y)
  {
    for (int x = 0; x < frame.width; ++x)
    {
      silhouette.values.push_back(frame.Brightness(x, y) > 0 ? 0.0f : 1.0f);
    }
  }
  return silhouette;
}

void Props::CheckCasts(vtkProp* prop, const Visibility& whole)
{
  vtkShadowPass::SetCastsShadows(prop, false);
  const Visibility without = this->VisibilityBy("ray-cast", this->Light);
  CheckAtLeast(
    "pixels that it shadows", static_cast<double>(CountDifferent(whole, without)), 300.0);
  this->CheckDepthMap("no caster");
  vtkShadowPass::SetCastsShadows(prop, true);
}

void Props::CheckReceives(vtkProp* prop, const Visibility& whole)
{
  vtkShadowPass::SetReceivesShadows(prop, false);
  const Visibility byRay = this->VisibilityBy("ray-cast", this->Light);
  const Frame frameByRay = this->Render();
  const Visibility byMap = this->VisibilityBy("depth-map", this->Light);
  const Frame frameByMap = this->Render();
  const Frame lit = this->RenderWithoutPass();
  std::size_t received = 0, stillByMap = 0, wrong = 0;
  for (std::size_t i = 0; i < whole.values.size(); ++i)
  {
    if (whole.values[i] < 0.5f && byRay.values[i] > 0.5f)
    {
      ++received;
      stillByMap += byMap.values[i] < 1.0f ? 1 : 0;
      for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
      {
        wrong += std::abs(frameByRay.rgb[c] - lit.rgb[c]) > 1 ? 1 : 0;
        wrong += std::abs(frameByMap.rgb[c] - lit.rgb[c]) > 1 ? 1 : 0;
      }
    }
  }
  CheckAtLeast("pixels of it in shadow", static_cast<double>(received), 200.0);
  Check(
    "no receiver: of those, still in shadow by depth map", static_cast<double>(stillByMap), 0.0);
  Check("no receiver: components unlike the lit frame", static_cast<double>(wrong), 0.0);
  this->CheckDepthMap("no receiver");
  vtkShadowPass::SetReceivesShadows(prop, true);
}

void Props::CheckProp(vtkProp* prop, const Mesh& baked, double share)
{
  this->Renderer->AddViewProp(prop);
  const Visibility whole = this->VisibilityBy("ray-cast", this->Light);
  this->CheckDepthMap("whole");
  this->CheckCasts(prop, whole);
  this->CheckReceives(prop, whole);
  const Visibility silhouette = this->SilhouetteOf(prop);
  EXPECT_GT(silhouette.CountShadowed(), 2000u) << "the prop is hardly drawn";

  this->Renderer->RemoveViewProp(prop);
  auto triangles = ActorOf(baked);
  this->Renderer->AddActor(triangles);
  // Guards the test itself: the triangles must be where VTK draws the prop.
  const std::size_t unlike = CountDifferent(silhouette, this->SilhouetteOf(triangles));
  CheckAtMost("drawn unlike its baked triangles, % of the window", Share(unlike, whole), share);
  const Visibility ofBaked = this->VisibilityBy("ray-cast", this->Light);
  CheckAtMost("ray cast unlike its baked triangles', % of the window",
    Share(CountDifferent(whole, ofBaked), whole), share);
}

// Small glyphs are nearly all edge.
void Props::CheckGlyphs(vtkMapper* mapper, const Mesh& baked)
{
  this->Mismatch = 0.8;
  this->CheckProp(ActorWith(mapper), baked);
}

}

//------------------------------------------------------------------------------
TEST_F(Props, PolyData)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  vtkNew<vtkTransform> place;
  place->Translate(0.0, 0.0, 1.2);
  this->CheckProp(ActorOf(Moved(Thing(), place)), Moved(Thing(), place));
}

TEST_F(Props, TriangleStrips)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  vtkNew<vtkTransform> place;
  place->Translate(0.0, 0.0, 1.2);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(Moved(Thing(), place));
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(triangles->GetOutputPort());
  const Mesh mesh = Updated(strips);
  EXPECT_GT(mesh->GetNumberOfStrips(), 0);
  this->CheckProp(ActorOf(mesh), Moved(Thing(), place));
}

TEST_F(Props, UserMatrixWithMirrorAndScale)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  vtkNew<vtkTransform> user;
  user->Translate(0.1, 0.0, 1.3);
  user->RotateX(20.0);
  user->Scale(-1.5, 0.8, 1.1);
  user->RotateZ(35.0);
  auto actor = ActorOf(Thing());
  actor->SetUserMatrix(user->GetMatrix());
  this->CheckProp(actor, Moved(Thing(), user));
}

TEST_F(Props, ClippingPlane)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetNormal(-1.0, 0.0, 0.0);
  const Mesh left = Brick({ -0.5, 0.0, 1.2 }, { 1.0, 1.0, 1.0 });
  // Open where it is cut.
  Mesh open = Mesh::New();
  open->DeepCopy(left);
  open->BuildCells();
  for (vtkIdType cell = 0; cell < open->GetNumberOfCells(); ++cell)
  {
    const double* bounds = open->GetCell(cell)->GetBounds();
    if (bounds[0] == 0.0 && bounds[1] == 0.0)
    {
      open->DeleteCell(cell);
    }
  }
  open->RemoveDeletedCells();
  auto actor = ActorOf(Brick({ 0.0, 0.0, 1.2 }, { 2.0, 1.0, 1.0 }));
  actor->GetMapper()->AddClippingPlane(plane);
  this->CheckProp(actor, open);
}

TEST_F(Props, NestedAssembly)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Mesh cone = Cone({ 0.0, 0.0, 1.0 }, 1.2, 0.5),
             brick = Brick({ 0, 0, 0 }, { 0.8, 0.5, 0.4 });
  auto first = ActorOf(cone), second = ActorOf(brick);
  first->SetPosition(-0.6, 0.2, 0.2);
  second->SetPosition(0.6, 0.0, 0.0);
  second->RotateZ(30.0);
  vtkNew<vtkAssembly> inner;
  inner->AddPart(second);
  inner->SetScale(1.4, 1.0, 0.8);
  inner->RotateY(25.0);
  vtkNew<vtkAssembly> outer;
  outer->AddPart(first);
  outer->AddPart(inner);
  outer->SetPosition(0.0, 0.2, 1.2);
  outer->RotateX(15.0);

  vtkNew<vtkTransform> ofFirst, ofSecond;
  ofFirst->Concatenate(outer->GetMatrix());
  ofFirst->Concatenate(first->GetMatrix());
  ofSecond->Concatenate(outer->GetMatrix());
  ofSecond->Concatenate(inner->GetMatrix());
  ofSecond->Concatenate(second->GetMatrix());
  this->CheckProp(outer, Joined({ Moved(cone, ofFirst), Moved(brick, ofSecond) }));
}

TEST_F(Props, UnstructuredGrid)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  // A hexahedron, and a tetrahedron on top of it.
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 8; ++i)
  {
    const int x = (i ^ (i >> 1)) & 1, y = (i >> 1) & 1, z = i >> 2;
    points->InsertNextPoint(-1.0 + 1.8 * x + 0.2 * z, -0.6 + 1.2 * y, 0.4 + 0.8 * z);
  }
  points->InsertNextPoint(0.2, 0.0, 2.2);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  const vtkIdType hexahedron[] = { 0, 1, 2, 3, 4, 5, 6, 7 }, tetrahedron[] = { 4, 5, 6, 8 };
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, hexahedron);
  grid->InsertNextCell(VTK_TETRA, 4, tetrahedron);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(grid);

  vtkNew<vtkCellArray> faces;
  const vtkIdType quads[6][4] = { { 0, 1, 2, 3 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 },
    { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };
  for (const auto& quad : quads)
  {
    faces->InsertNextCell({ quad[0], quad[1], quad[2] });
    faces->InsertNextCell({ quad[0], quad[2], quad[3] });
  }
  for (const auto& side : { std::pair<int, int>(4, 5), { 5, 6 }, { 6, 4 } })
  {
    faces->InsertNextCell({ side.first, side.second, 8 });
  }
  Mesh baked = Mesh::New();
  baked->SetPoints(points);
  baked->SetPolys(faces);
  this->CheckProp(ActorWith(mapper), baked);
}

//------------------------------------------------------------------------------
// Composite data.
namespace
{

struct Blocks
{
  vtkNew<vtkMultiBlockDataSet> whole, nested;
  Mesh cone, ball, brick;

  Blocks()
  {
    vtkNew<vtkTransform> lift;
    lift->Translate(-0.8, 0.0, 1.0);
    this->cone = Moved(Cone({ 0.0, 0.3, 1.0 }, 1.4, 0.6), lift);
    this->ball = Ball({ 0.3, 0.3, 1.3 }, 0.5);
    this->brick = Brick({ 1.2, -0.2, 1.0 }, { 0.7, 0.7, 0.9 });
    this->nested->SetBlock(0, this->ball);
    this->nested->SetBlock(1, this->brick);
    this->whole->SetBlock(0, this->cone);
    this->whole->SetBlock(1, this->nested);
  }
};

}

TEST_F(Props, CompositePolyData)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Blocks blocks;
  vtkNew<vtkCompositePolyDataMapper> mapper;
  mapper->SetInputDataObject(blocks.whole);
  this->CheckProp(ActorWith(mapper), Joined({ blocks.cone, blocks.ball, blocks.brick }));
}

#if __has_include(<vtkCompositePolyDataMapper2.h>)
using AttributedMapper = vtkCompositePolyDataMapper2;
#else
using AttributedMapper = vtkCompositePolyDataMapper;
#endif

TEST_F(Props, CompositePolyDataWithAnInvisibleBlock)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Blocks blocks;
  vtkNew<AttributedMapper> mapper;
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetInputDataObject(blocks.whole);
  attributes->SetBlockVisibility(blocks.ball, false);
  this->CheckProp(ActorWith(mapper), Joined({ blocks.cone, blocks.brick }));
}

TEST_F(Props, CompositePolyDataWithAnInvisibleBranch)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Blocks blocks;
  vtkNew<AttributedMapper> mapper;
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetInputDataObject(blocks.whole);
  // The branch is hidden, one leaf of it shown again.
  attributes->SetBlockVisibility(blocks.nested, false);
  attributes->SetBlockVisibility(blocks.brick, true);
  this->CheckProp(ActorWith(mapper), Joined({ blocks.cone, blocks.brick }));
}

//------------------------------------------------------------------------------
// Glyphs.
TEST_F(Props, GlyphsScaledAndOriented)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Mesh places = Places(30);
  auto mapper = GlyphMapper(places, Thing());
  mapper->SetScaleFactor(1.3);
  this->CheckGlyphs(mapper, Glyphs(places, Thing(), 1.3, true));
}

TEST_F(Props, GlyphsUnderAUserMatrix)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Mesh places = Places(30);
  vtkNew<vtkTransform> user;
  user->Translate(0.0, 0.3, 0.2);
  user->RotateZ(40.0);
  user->Scale(-1.2, 0.9, 1.1);
  auto actor = ActorWith(GlyphMapper(places, Thing()));
  actor->SetUserMatrix(user->GetMatrix());
  this->Mismatch = 0.8;
  this->CheckProp(actor, Moved(Glyphs(places, Thing(), 1.0, true), user));
}

TEST_F(Props, GlyphsOfSeveralSources)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Mesh places = Places(30);
  const Mesh sources[] = { Thing(), Ball({ 0.0, 0.0, 0.0 }, 0.8),
    Brick({ 0, 0, 0 }, { 2.0, 0.6, 0.4 }) };
  auto mapper = GlyphMapper(places, sources[0]);
  std::vector<Mesh> baked;
  for (int kind = 0; kind < 3; ++kind)
  {
    mapper->SetSourceData(kind, sources[kind]);
    baked.push_back(Glyphs(PlacesWhere(places, "kind", kind), sources[kind], 1.0, true));
  }
  mapper->SourceIndexingOn();
  mapper->SetSourceIndexArray("kind");
  this->CheckGlyphs(mapper, Joined(baked));
}

TEST_F(Props, GlyphsMasked)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Mesh places = Places(40);
  auto mapper = GlyphMapper(places, Thing());
  mapper->MaskingOn();
  mapper->SetMaskArray("shown");
  this->CheckGlyphs(mapper, Glyphs(PlacesWhere(places, "shown", 1), Thing(), 1.0, true));
}

// VTK takes no other array than one of bits for a mask, and then draws all glyphs.
TEST_F(Props, GlyphsMaskedByIntegers)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Mesh places = Places(40);
  vtkNew<vtkIntArray> mask;
  mask->DeepCopy(places->GetPointData()->GetArray("shown"));
  mask->SetName("mask");
  places->GetPointData()->AddArray(mask);
  auto mapper = GlyphMapper(places, Thing());
  mapper->MaskingOn();
  mapper->SetMaskArray("mask");
  this->CheckGlyphs(mapper, Glyphs(places, Thing(), 1.0, true));
}

TEST_F(Props, GlyphsRotatedAndScaledByComponents)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Mesh places = Places(20);
  vtkNew<vtkFloatArray> turn, stretch;
  turn->SetName("turn");
  turn->SetNumberOfComponents(3);
  stretch->SetName("stretch");
  stretch->SetNumberOfComponents(3);
  for (int i = 0; i < 20; ++i)
  {
    turn->InsertNextTuple3(20.0 * i, 33.0 * i, 47.0 * i);
    stretch->InsertNextTuple3(0.2 + 0.01 * i, 0.3, 0.15);
  }
  places->GetPointData()->AddArray(turn);
  places->GetPointData()->AddArray(stretch);
  auto mapper = GlyphMapper(places, Thing());
  mapper->SetOrientationArray("turn");
  mapper->SetOrientationModeToRotation();
  mapper->SetScaleArray("stretch");
  mapper->SetScaleModeToScaleByVectorComponents();
  this->CheckGlyphs(mapper,
    GlyphsBy(places, Thing(),
      [&](vtkIdType i, vtkTransform* transform)
      {
        const double* degrees = turn->GetTuple3(i);
        transform->RotateZ(degrees[2]);
        transform->RotateX(degrees[0]);
        transform->RotateY(degrees[1]);
        transform->Scale(stretch->GetTuple3(i));
      }));
}

TEST_F(Props, GlyphsWithQuaternions)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Mesh places = Places(20);
  vtkNew<vtkFloatArray> turn;
  turn->SetName("turn");
  turn->SetNumberOfComponents(4);
  for (int i = 0; i < 20; ++i)
  {
    const double half = 0.3 * i;
    turn->InsertNextTuple4(std::cos(half), 0.6 * std::sin(half), 0.0, 0.8 * std::sin(half));
  }
  places->GetPointData()->AddArray(turn);
  auto mapper = GlyphMapper(places, Thing());
  mapper->SetOrientationArray("turn");
  mapper->SetOrientationModeToQuaternion();
  mapper->SetScaleModeToNoDataScaling();
  mapper->SetScaleFactor(0.25);
  this->CheckGlyphs(mapper,
    GlyphsBy(places, Thing(),
      [&](vtkIdType i, vtkTransform* transform)
      {
        transform->RotateWXYZ(2.0 * 0.3 * i * 180.0 / std::acos(-1.0), 0.6, 0.0, 0.8);
        transform->Scale(0.25, 0.25, 0.25);
      }));
}

TEST_F(Props, GlyphsUnoriented)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Mesh places = Places(30);
  auto mapper = GlyphMapper(places, Thing());
  mapper->OrientOff();
  mapper->SetScaleFactor(1.3);
  this->CheckGlyphs(mapper,
    GlyphsBy(places, Thing(),
      [&](vtkIdType i, vtkTransform* transform)
      {
        const double size = 1.3 * places->GetPointData()->GetArray("size")->GetComponent(i, 0);
        transform->Scale(size, size, size);
      }));
}

TEST_F(Props, GlyphsInBlocks)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Mesh places = Places(30);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, PlacesWhere(places, "shown", 1));
  blocks->SetBlock(1, PlacesWhere(places, "shown", 0));
  auto mapper = GlyphMapper(places, Thing());
  mapper->SetInputDataObject(blocks);
  this->CheckGlyphs(mapper, Glyphs(places, Thing(), 1.0, true));
}

TEST_F(Props, GlyphsWithAnInvisibleBlock)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Mesh places = Places(30);
  const Mesh some = PlacesWhere(places, "shown", 1), others = PlacesWhere(places, "shown", 0);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, some);
  blocks->SetBlock(1, others);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  attributes->SetBlockVisibility(others, false);
  auto mapper = GlyphMapper(places, Thing());
  mapper->SetInputDataObject(blocks);
  mapper->SetBlockAttributes(attributes);
  this->CheckGlyphs(mapper, Glyphs(some, Thing(), 1.0, true));
}

//------------------------------------------------------------------------------
// Sphere impostors: their triangles are within 0.02 % of the round shape.
namespace
{

Mesh Balls(const Mesh& places, const std::function<double(vtkIdType)>& radius)
{
  std::vector<Mesh> balls;
  for (vtkIdType i = 0; i < places->GetNumberOfPoints(); ++i)
  {
    double p[3];
    places->GetPoint(i, p);
    balls.push_back(Ball({ p[0], p[1], p[2] }, radius(i), 120));
  }
  return Joined(balls);
}

}

TEST_F(Props, SphereImpostors)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Mesh places = Places(12);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetRadius(0.3f);
  this->CheckProp(ActorWith(mapper), Balls(places, [](vtkIdType) { return 0.3; }), 0.1);
}

TEST_F(Props, SphereImpostorsOfTheirOwnSize)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Mesh places = Places(12);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetScaleArray("size");
  vtkDataArray* size = places->GetPointData()->GetArray("size");
  this->CheckProp(ActorWith(mapper),
    Balls(places, [size](vtkIdType i) { return size->GetComponent(i, 0); }), 0.1);
}

TEST_F(Props, SphereImpostorsMovedByTheirActor)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Mesh places = Places(12);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetRadius(0.3f);
  vtkNew<vtkTransform> place;
  place->Translate(0.0, 0.2, 0.3);
  place->RotateZ(50.0);
  auto actor = ActorWith(mapper);
  actor->SetUserMatrix(place->GetMatrix());
  this->CheckProp(actor, Moved(Balls(places, [](vtkIdType) { return 0.3; }), place), 0.1);
}

//------------------------------------------------------------------------------
// What only a depth map sees: lines and points, as wide as they are drawn, in texels. So a coarse
// map shows them.
TEST_F(Props, LinesAndPointsCastByDepthMap)
{
  this->Shadows->GetDepthShadowMapPass()->SetResolution(256);
  const Visibility without = this->VisibilityBy("depth-map", this->Light);
  const std::pair<std::string, std::function<void(vtkProperty*)>> looks[] = {
    { "wireframe", [](vtkProperty* p) { p->SetRepresentationToWireframe(); } },
    { "points", [](vtkProperty* p) { p->SetRepresentationToPoints(); } },
    { "lines as tubes",
      [](vtkProperty* p)
      {
        p->SetRepresentationToWireframe();
        p->RenderLinesAsTubesOn();
      } },
    { "points as spheres",
      [](vtkProperty* p)
      {
        p->SetRepresentationToPoints();
        p->RenderPointsAsSpheresOn();
      } },
  };
  for (const auto& look : looks)
  {
    auto actor = ActorOf(Ball({ 0.0, 0.0, 1.2 }, 0.7));
    actor->GetProperty()->SetLineWidth(4.0f);
    actor->GetProperty()->SetPointSize(6.0f);
    look.second(actor->GetProperty());
    vtkShadowPass::SetReceivesShadows(actor, false);
    this->Renderer->AddActor(actor);
    CheckAtLeast(look.first + ": pixels that they shadow",
      static_cast<double>(CountDifferent(without, this->VisibilityBy("depth-map", this->Light))),
      300.0);
    this->Renderer->RemoveActor(actor);
  }
}

//------------------------------------------------------------------------------
// Keys.

// A translucent prop casts if told to, as if opaque.
TEST_F(Props, TranslucentCasterIfTold)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto ball = ActorOf(Ball({ 0.0, 0.0, 1.2 }, 0.7));
  this->Renderer->AddActor(ball);
  // Seen from above and beside the light, so that it hides none of its own shadow.
  const Visibility opaque = this->VisibilityBy("ray-cast", this->Light);
  ball->GetProperty()->SetOpacity(0.5);
  for (const std::string technique : { "depth-map", "ray-cast" })
  {
    vtkShadowPass::SetCastsShadows(ball, false);
    const Visibility without = this->VisibilityBy(technique, this->Light);
    ball->GetPropertyKeys()->Remove(vtkShadowPass::CASTS_SHADOWS());
    Check(technique + ": pixels that it shadows by itself",
      static_cast<double>(CountDifferent(without, this->VisibilityBy(technique, this->Light))),
      0.0);
    vtkShadowPass::SetCastsShadows(ball, true);
    CheckAtLeast(technique + ": pixels that it shadows if told",
      static_cast<double>(CountDifferent(without, this->VisibilityBy(technique, this->Light))),
      500.0);
    this->CheckMeasure(technique, this->Light, 0.1, 0.005);
  }
}

// Mirrored or not, culled or not: every face casts.
TEST_F(Props, CullingDoesNotStopCasting)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto ball = ActorOf(Ball({ 0.0, 0.0, 1.2 }, 0.7));
  this->Renderer->AddActor(ball);
  const Visibility whole = this->VisibilityBy("depth-map", this->Light);
  ball->GetProperty()->BackfaceCullingOn();
  Check("back faces culled: pixels changed",
    static_cast<double>(CountDifferent(whole, this->VisibilityBy("depth-map", this->Light))), 0.0);
  this->CheckMeasure("back faces culled", this->Light, 0.1, 0.005);
}

//------------------------------------------------------------------------------
// Stand-ins.

// A ball casts as a bar, wherever it is, but for the ray cast.
TEST_F(Props, AStandInCasts)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(2.0);
  cube->SetYLength(0.4);
  cube->SetZLength(0.3);
  const Mesh bar = Updated(cube);
  auto ball = ActorOf(Ball({ 0.0, 0.0, 0.0 }, 0.7)), drawnBar = ActorOf(bar);
  for (vtkActor* actor : { ball.Get(), drawnBar.Get() })
  {
    actor->GetProperty()->SetAmbient(0.3); // seen on its dark side, too
    this->Renderer->AddActor(actor);
  }
  const auto check = [&](const std::string& what)
  {
    const Visibility ofBall = this->SilhouetteOf(ball);
    ball->VisibilityOff();
    drawnBar->SetUserMatrix(ball->GetMatrix());
    drawnBar->VisibilityOn();
    const Visibility expected = this->VisibilityBy("ray-cast", this->Light);
    const Visibility ofBar = this->SilhouetteOf(drawnBar);
    drawnBar->VisibilityOff();
    ball->VisibilityOn();
    const Visibility byItself = this->VisibilityBy("ray-cast", this->Light);
    vtkShadowPass::SetStandIn(ball, bar);
    for (const std::string technique : { "depth-map", "stencil-volume" })
    {
      const Visibility got = this->VisibilityBy(technique, this->Light);
      std::size_t wrong = 0, unlikeTheBall = 0;
      for (std::size_t i = 0; i < got.values.size(); ++i)
      {
        // Where neither is drawn, it is the same receiver.
        if (ofBall.values[i] > 0.5f && ofBar.values[i] > 0.5f)
        {
          wrong += (got.values[i] > 0.5f) != (expected.values[i] > 0.5f) ? 1 : 0;
          unlikeTheBall += (got.values[i] > 0.5f) != (byItself.values[i] > 0.5f) ? 1 : 0;
        }
      }
      CheckAtMost(what + ", " + technique + ": pixels unlike a bar's shadow, % of the window",
        Share(wrong, got), 0.05);
      CheckAtLeast(what + ", " + technique + ": pixels unlike the ball's",
        static_cast<double>(unlikeTheBall), 500.0);
      Check(what + ": casters", this->Shadows->GetScene()->GetNumberOfCasters(), 3.0); // floor, bar
      Check(what + ": receivers", this->Shadows->GetScene()->GetNumberOfReceivers(), 3.0);
    }
    Check(what + ", ray-cast: pixels changed",
      static_cast<double>(CountDifferent(byItself, this->VisibilityBy("ray-cast", this->Light))),
      0.0);
    vtkShadowPass::SetStandIn(ball, nullptr);
  };
  drawnBar->VisibilityOff();
  ball->SetPosition(0.0, 0.0, 1.2);
  const Visibility before = this->VisibilityBy("depth-map", this->Light);
  check("as it is");
  EXPECT_EQ(vtkShadowPass::GetStandIn(ball), nullptr);
  Check("removed: pixels changed",
    static_cast<double>(CountDifferent(before, this->VisibilityBy("depth-map", this->Light))), 0.0);
  ball->SetPosition(0.4, 0.6, 1.0);
  ball->RotateZ(70.0);
  ball->SetScale(1.0, -0.8, 1.2);
  check("moved");
}

TEST_F(Props, AStandInIsKeptFromFrameToFrame)
{
  auto ball = ActorOf(Ball({ 0.0, 0.0, 0.0 }, 0.7));
  this->Renderer->AddActor(ball);
  vtkShadowPass::SetStandIn(ball, Ball({ 0.0, 0.0, 0.0 }, 0.5));
  this->Shadows->SetLightTechnique(
    AddSun(this->Renderer, { 0.4, 0.5, -1.0 }).Get(), "stencil-volume");
  this->Shadows->SetTechnique("depth-map");
  auto* maps = this->Shadows->GetDepthShadowMapPass();
  auto* volumes = this->Shadows->GetStencilShadowVolumePass();
  for (int i = 0; i < 3; ++i)
  {
    this->Render(); // the second may draw maps again, without hidden faces
  }
  const auto builds = [&]()
  {
    return static_cast<double>(maps->GetNumberOfMapBuilds() + volumes->GetNumberOfMeshBuilds() +
      volumes->GetNumberOfVolumeBuilds());
  };
  const double before = builds();
  this->Render();
  this->Renderer->GetActiveCamera()->Azimuth(5.0);
  this->Render();
  Check("builds, still or orbited", builds() - before, 0.0);
  ball->SetPosition(0.0, 0.0, 0.3);
  this->Render();
  // The map alone: seen from a sun, the volume is the same.
  Check("builds, moved", builds() - before, 1.0);
}

TEST_F(Props, AStandInWithoutTriangles)
{
  auto ball = ActorOf(Ball({ 0.0, 0.0, 1.2 }, 0.7));
  this->Renderer->AddActor(ball);
  const Visibility byItself = this->VisibilityBy("stencil-volume", this->Light);
  vtkNew<vtkPolyData> empty;
  vtkShadowPass::SetStandIn(ball, empty);
  const Visibility got = this->VisibilityBy("stencil-volume", this->Light);
  std::ostringstream address;
  address << ball.Get();
  ExpectOneMessage({ "vtkOpenGLActor (" + address.str() + ")", "without triangles", "SetStandIn" });
  Check("pixels changed", static_cast<double>(CountDifferent(byItself, got)), 0.0);
  this->Render();
  Check("messages by the next frame", static_cast<double>(TakeMessages().size()), 0.0);
}
