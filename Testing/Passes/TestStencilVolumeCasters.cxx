// Casters of shadow volumes: under every matrix, of every kind, and broken.
#include "TestScenes.h"
#include "VolumeTest.h"

#include <vtkAssembly.h>
#include <vtkCellArray.h>
#include <vtkCompositePolyDataMapper.h>
#include <vtkConeSource.h>
#include <vtkGlyph3DMapper.h>
#include <vtkIdList.h>
#include <vtkMatrix4x4.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace shadowtest;

namespace
{

class StencilVolumeCasters : public CasterTest
{
protected:
  // The caster, a prop added by the test, must be left out with one warning, and nothing else with
  // it.
  void CheckLeftOut(const std::string& what, vtkProp* bad, const std::vector<std::string>& parts);
};

std::string AddressOf(const void* object)
{
  std::ostringstream text;
  text << object;
  return text.str();
}

void StencilVolumeCasters::CheckLeftOut(
  const std::string& what, vtkProp* bad, const std::vector<std::string>& parts)
{
  // It may be seen, but not be measured.
  vtkShadowPass::SetReceivesShadows(bad, false);
  this->AddThing();
  bad->VisibilityOff();
  this->Render();
  const Visibility without = this->VisibilityOf(this->Sun);
  EXPECT_GT(without.CountShadowed(), 1000u);
  bad->VisibilityOn();
  this->Render();
  std::vector<std::string> all = parts;
  all.push_back("vtkOpenGLActor (" + AddressOf(bad) + ")");
  ExpectOneMessage(all);
  std::size_t others = 0;
  const Visibility with = this->VisibilityOf(this->Sun);
  for (std::size_t i = 0; i < with.values.size(); ++i)
  {
    // Where the bad one is drawn itself it is lit.
    others += with.values[i] < 0.5f && without.values[i] > 0.5f ? 1 : 0;
  }
  Check(what + ": pixels that it shadows", static_cast<double>(others), 0.0);
  CheckAtLeast(what + ": pixels in shadow still", static_cast<double>(with.CountShadowed()),
    0.8 * without.CountShadowed());
  this->Render();
  Check(what + ": messages by the next frame", static_cast<double>(TakeMessages().size()), 0.0);
  Check(what + ": OpenGL error", TakeOpenGLError(), 0.0);
}

}

//------------------------------------------------------------------------------
// Matrices.
TEST_F(StencilVolumeCasters, Matrices)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto thing = this->AddThing();
  this->CheckBoth("plain");
  thing->SetScale(-1.0, 1.0, 1.0);
  this->CheckBoth("mirrored");
  thing->SetScale(-1.3, 0.7, -1.1);
  this->CheckBoth("mirrored twice");
  thing->SetScale(1.5, 0.5, 0.05);
  thing->SetOrientation(20.0, 30.0, 40.0);
  this->CheckBoth("scaled unevenly");
  thing->SetScale(1.0, 1.0, 1.0);
  vtkNew<vtkMatrix4x4> shear;
  shear->SetElement(0, 2, 0.8);
  shear->SetElement(1, 0, -0.4);
  shear->SetElement(2, 2, -0.7);
  shear->SetElement(2, 3, 2.0);
  thing->SetUserMatrix(shear);
  this->CheckBoth("sheared and mirrored");
  this->CheckMeanMismatch(0.005);
}

TEST_F(StencilVolumeCasters, AssembliesGlyphsAndComposites)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(Thing());
  vtkNew<vtkActor> part, other;
  part->SetMapper(mapper);
  part->SetScale(0.5, 0.6, 0.4);
  part->SetPosition(-0.8, 0.0, 0.3);
  other->SetMapper(mapper);
  other->SetScale(-0.5, 0.5, 0.5);
  other->SetPosition(0.7, 0.3, 0.0);
  vtkNew<vtkAssembly> inner, outer;
  inner->AddPart(other);
  inner->RotateX(40.0);
  outer->AddPart(part);
  outer->AddPart(inner);
  outer->SetPosition(0.0, 0.0, 1.2);
  outer->RotateZ(25.0);
  this->Renderer->AddViewProp(outer);
  this->CheckBoth("assembly of one mesh twice");
  this->Renderer->RemoveViewProp(outer);

  vtkNew<vtkPoints> places;
  for (int i = 0; i < 30; ++i)
  {
    places->InsertNextPoint(1.6 * std::cos(2.4 * i), 1.6 * std::sin(2.1 * i), 0.8 + 0.03 * i);
  }
  vtkNew<vtkPolyData> where;
  where->SetPoints(places);
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(where);
  glyphs->SetSourceData(Thing());
  glyphs->SetScaleFactor(0.2);
  vtkNew<vtkActor> many;
  many->SetMapper(glyphs);
  this->Renderer->AddActor(many);
  this->CheckBoth("glyphs");
  this->Renderer->RemoveActor(many);

  vtkNew<vtkMultiBlockDataSet> blocks, nested;
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(1.3, 0.9, 0.2);
  ball->Update();
  nested->SetBlock(0, ball->GetOutput());
  blocks->SetBlock(0, Thing());
  blocks->SetBlock(1, nested);
  vtkNew<vtkCompositePolyDataMapper> composite;
  composite->SetInputDataObject(blocks);
  vtkNew<vtkActor> whole;
  whole->SetMapper(composite);
  whole->SetPosition(0.0, 0.0, 1.3);
  this->Renderer->AddActor(whole);
  this->CheckBoth("composite");
}

TEST_F(StencilVolumeCasters, OffsetsAndScales)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  Visibility plain;
  for (const Placement& placement : Placements)
  {
    for (const bool byActor : { true, false })
    {
      AddStillLifeAt(this->Renderer, placement, byActor, 320, 240);
      auto spot = AddSpot(
        this->Renderer, placement.Of({ 3.5, -3.0, 6.5 }), placement.Of({ 0.0, 0.0, 0.3 }), 35.0);
      const std::string what =
        std::string(placement.name) + (byActor ? ", by actor" : ", by points");
      this->CheckTruth(what, spot);
      const Visibility mask = this->VisibilityOf(spot);
      plain = plain.values.empty() ? mask : plain;
      CheckAtMost(what + ": pixels unlike the plain scene's",
        static_cast<double>(CountDifferent(plain, mask)), 10.0);
    }
  }
}

//------------------------------------------------------------------------------
// Kinds of casters.
TEST_F(StencilVolumeCasters, Keys)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto thing = this->AddThing();
  auto bar = AddBox(this->Renderer, { -2.5, -0.85, 2.8 }, { 2.5, -0.5, 3.0 });
  this->CheckBoth("both cast");
  const Visibility whole = this->VisibilityOf(this->Sun);
  vtkShadowPass::SetCastsShadows(bar, false);
  this->CheckBoth("the bar casts nothing");
  CheckAtLeast("pixels that the bar shadowed",
    static_cast<double>(CountDifferent(whole, this->VisibilityOf(this->Sun))), 500.0);
  vtkShadowPass::SetCastsShadows(bar, true);
  this->Render();
  Check("casts again: pixels changed",
    static_cast<double>(CountDifferent(whole, this->VisibilityOf(this->Sun))), 0.0);
  vtkShadowPass::SetReceivesShadows(this->Floor, false);
  this->Render();
  const Visibility received = this->VisibilityOf(this->Sun);
  const Pixel p = PixelOf(this->Renderer, { -2.5, -1.5, 0.0 });
  int shadowOnFloor = 0;
  for (int y = 0; y < 20; ++y)
  {
    for (int x = 0; x < received.width; ++x)
    {
      shadowOnFloor += received.At(x, y) < 0.5f ? 1 : 0;
    }
  }
  Check("shadow at the window's foot, where the floor is", shadowOnFloor, 0.0);
  EXPECT_GT(p.x, 0);
  CheckAtLeast(
    "pixels in shadow on the others", static_cast<double>(received.CountShadowed()), 50.0);
  CheckAtMost("pixels in shadow on the others", static_cast<double>(received.CountShadowed()),
    0.6 * whole.CountShadowed());
}

// What is culled while it is drawn casts all the same; and the eye may see inside.
TEST_F(StencilVolumeCasters, CulledFacesCast)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto ball = AddSphere(this->Renderer, { 0.0, 0.0, 1.2 }, 0.7);
  auto thing = this->AddThing();
  thing->SetPosition(-1.5, 1.0, 1.0);
  for (const bool front : { false, true })
  {
    for (vtkActor* actor : { ball.Get(), thing.Get() })
    {
      actor->GetProperty()->SetBackfaceCulling(!front);
      actor->GetProperty()->SetFrontfaceCulling(front);
    }
    this->CheckBoth(front ? "front faces culled" : "back faces culled");
  }
}

TEST_F(StencilVolumeCasters, WhatHasNoTrianglesIsTold)
{
  vtkNew<vtkPoints> places;
  places->InsertNextPoint(-1.5, 0.0, 1.0);
  vtkNew<vtkPolyData> where;
  where->SetPoints(places);
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  where->SetVerts(verts);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(where);
  mapper->SetRadius(0.5f);
  vtkNew<vtkActor> impostor;
  impostor->SetMapper(mapper);
  this->Renderer->AddActor(impostor);
  this->CheckLeftOut("sphere impostor", impostor, { "\"depth-map\"" });
}

// A closed body, an open sheet and soup in one mesh, none in the shadow of another, so that every
// way to count is right.
TEST_F(StencilVolumeCasters, SoupAndSurfacesInOneMesh)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  using Pass = vtkStencilShadowVolumePass;
  TestMesh mesh = Confetti(4);
  Append(mesh, Cube(), { -2.5, 1.5, 0.0 });
  Append(mesh, OpenStrip(), { -0.5, 5.5, 0.0 });
  auto mixed = AddActor(this->Renderer, ToPolyData(mesh));
  mixed->SetScale(0.5);
  mixed->SetPosition(-0.5, -0.8, 1.2);
  const auto checkAll = [&](const std::string& what)
  {
    for (const int variant :
      { Pass::AUTOMATIC, Pass::Z_FAIL, Pass::Z_PASS, Pass::Z_PASS_CAPPED, Pass::PARITY })
    {
      for (const int counter :
        { Pass::AUTOMATIC_COUNTER, Pass::WRAPPING_STENCIL, Pass::FLOAT_COUNTER })
      {
        this->Volumes()->SetVariant(variant);
        this->Volumes()->SetCounter(counter);
        this->CheckBoth(
          what + ", variant " + std::to_string(variant) + ", counter " + std::to_string(counter));
      }
    }
  };
  checkAll("as it is");
  mixed->SetScale(-0.5, 0.5, 0.5);
  mixed->RotateX(15.0);
  this->Volumes()->ConfinementOff(); // the sun's sides end in one point
  checkAll("mirrored, to infinity");
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Renderer->GetActiveCamera()->SetParallelScale(2.5);
  checkAll("mirrored, to infinity, parallel");
}

// Each border has a side of two triangles, one if all images are one point; each triangle two caps
// where faces are counted behind the receiver.
TEST_F(StencilVolumeCasters, FacesOfSoup)
{
  using Pass = vtkStencilShadowVolumePass;
  TestMesh mesh = Confetti(3); // 5 triangles and 4 quads
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    // All of one winding: no side stands on a quad's diagonal.
    glm::uvec3& t = mesh.triangles[i];
    const glm::dvec3 a = mesh.points[t.x], b = mesh.points[t.y], c = mesh.points[t.z];
    if ((b.x - a.x) * (c.y - a.y) < (b.y - a.y) * (c.x - a.x))
    {
      std::swap(t.y, t.z);
    }
  }
  AddActor(this->Renderer, ToPolyData(mesh))->SetPosition(-1.0, -1.0, 1.5);
  const auto check = [this](const std::string& what, double faces)
  {
    this->Render();
    Check(what + ": faces", static_cast<double>(this->Volumes()->GetNumberOfFaces()), faces);
  };
  const double borders = 5 * 3 + 4 * 4, triangles = 5 + 4 * 2;
  check("before the receiver, two lights", 2 * 2 * borders);
  this->Volumes()->SetVariant(Pass::Z_FAIL);
  check("behind it, two lights", 2 * (2 * borders + 2 * triangles));
  this->Renderer->RemoveLight(this->Lamp);
  this->Volumes()->ConfinementOff();
  check("a sun to infinity", borders + triangles);
}

//------------------------------------------------------------------------------
// Bad casters.
// Of a mesh with points that are NaN, all other triangles cast: as of one without those.
TEST_F(StencilVolumeCasters, PointsThatAreNaN)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<vtkIdType> some[] = { { 0 }, { 7 }, { 3, 40, 290 } };
  for (const std::vector<vtkIdType>& broken : some)
  {
    const std::string what = std::to_string(broken.size()) + " from " + std::to_string(broken[0]);
    this->Renderer->RemoveAllViewProps();
    AddFloor(this->Renderer, 5.0);
    auto whole = Thing(), bad = Thing();
    vtkNew<vtkCellArray> kept;
    vtkNew<vtkIdList> corners;
    for (vtkIdType i = 0; i < whole->GetNumberOfCells(); ++i)
    {
      whole->GetCellPoints(i, corners);
      const bool isKept = std::none_of(
        broken.begin(), broken.end(), [&corners](vtkIdType id) { return corners->IsId(id) >= 0; });
      if (isKept)
      {
        kept->InsertNextCell(corners);
      }
    }
    EXPECT_LT(kept->GetNumberOfCells(), whole->GetNumberOfCells());
    whole->SetPolys(kept);
    for (const vtkIdType id : broken)
    {
      bad->GetPoints()->SetPoint(id, nan, nan, nan);
    }
    auto actor = AddActor(this->Renderer, whole);
    actor->SetPosition(0.0, 0.0, 1.3);
    this->Render();
    const Visibility expected = this->VisibilityOf(this->Lamp);
    EXPECT_GT(expected.CountShadowed(), 1000u);
    this->Renderer->RemoveActor(actor);
    actor = AddActor(this->Renderer, bad);
    actor->SetPosition(0.0, 0.0, 1.3);
    this->Render();
    ExpectOneMessage(
      { "vtkOpenGLActor (" + AddressOf(actor) + ")", "not finite", "the others do" });
    const Visibility got = this->VisibilityOf(this->Lamp);
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < got.values.size(); ++i)
    {
      unlike += std::abs(got.values[i] - expected.values[i]) > 0.5f ? 1 : 0;
    }
    Check(what + ": pixels unlike", static_cast<double>(unlike), 0.0);
    this->CheckBoth(what);
    this->Render();
    Check(what + ": messages by the next frame", static_cast<double>(TakeMessages().size()), 0.0);
    Check(what + ": OpenGL error", TakeOpenGLError(), 0.0);
  }
}

// VTK draws nothing of a mesh with an infinite point, and nothing of it casts.
TEST_F(StencilVolumeCasters, PointsThatAreInfinite)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : { infinity, -infinity })
  {
    for (const bool first : { true, false })
    {
      this->Renderer->RemoveAllViewProps();
      AddFloor(this->Renderer, 5.0);
      auto mesh = Thing();
      double p[3];
      const vtkIdType index = first ? 0 : 7;
      mesh->GetPoint(index, p);
      mesh->GetPoints()->SetPoint(index, p[0], value, p[2]);
      mesh->GetPoints()->Modified();
      auto bad = AddActor(this->Renderer, mesh);
      bad->SetPosition(-2.0, 0.0, 1.5);
      this->CheckLeftOut(
        std::to_string(value) + (first ? " first" : " amid"), bad, { "not finite" });
    }
  }
}

// To a plane, along an axis or not, mirrored, and nearly; to a line; and back.
TEST_F(StencilVolumeCasters, MatricesThatFlatten)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  auto thing = this->AddThing();
  const auto pixels = [this]()
  {
    this->Render();
    const Visibility with = this->VisibilityOf(this->Sun);
    return static_cast<double>(with.CountShadowed());
  };
  thing->SetScale(1.0, 1.0, 0.0);
  this->CheckBoth("scale 0");
  CheckAtLeast("scale 0: pixels in shadow", pixels(), 1000.0);
  thing->SetPosition(0.3, -0.2, 1.6);
  this->CheckBoth("scale 0, moved");
  CheckAtLeast("scale 0, moved: pixels in shadow", pixels(), 1000.0);
  thing->SetScale(1.0, 1.0, 1e-15);
  this->CheckBoth("scale 1e-15");
  CheckAtLeast("scale 1e-15: pixels in shadow", pixels(), 1000.0);

  // p - share (n.p) n: onto a plane that leans, wholly and nearly; then beyond it, mirrored.
  thing->SetScale(1.0, 1.0, 1.0);
  const double n[] = { 0.36, 0.48, 0.8 };
  for (const double share : { 1.0, 1.0 - 1e-9, 1.0 + 1e-9, 1.0 - 1e-5, 1.0 + 1e-3 })
  {
    vtkNew<vtkMatrix4x4> matrix;
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        matrix->SetElement(row, column, (row == column ? 1.0 : 0.0) - share * n[row] * n[column]);
      }
    }
    matrix->SetElement(2, 3, 2.2);
    thing->SetUserMatrix(matrix);
    const std::string what = "share " + std::to_string(share);
    this->CheckBoth(what);
    CheckAtLeast(what + ": pixels in shadow", pixels(), 1000.0);
  }
  thing->SetUserMatrix(nullptr);
  thing->SetPosition(0.0, 0.0, 1.3);
  thing->SetScale(1.0, 0.0, 0.0);
  this->Render();
  Check("to a line: pixels in shadow", pixels(), 0.0);
  Check("messages", static_cast<double>(TakeMessages().size()), 0.0);
  Check("OpenGL error", TakeOpenGLError(), 0.0);

  // Repaired, it casts as if nothing had been.
  thing->SetScale(1.0, 1.0, 1.0);
  this->Render();
  vtkNew<vtkShadowPass> fresh;
  fresh->SetTechnique("stencil-volume");
  this->Renderer->SetPass(fresh);
  const Frame expected = this->Render();
  this->Renderer->SetPass(this->Shadows);
  Check("repaired: pixels unlike a fresh pass's",
    static_cast<double>(CountDifferent(expected, this->Render())), 0.0);
  CheckAtLeast("repaired: pixels in shadow", pixels(), 1000.0);
}

// Nothing to say of what is merely empty.
TEST_F(StencilVolumeCasters, EmptyMeshes)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->AddThing();
  vtkNew<vtkPolyData> empty, pointless, degenerate;
  vtkNew<vtkCellArray> nothing, polys;
  pointless->SetPolys(nothing);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.0, 1.0, 1.0);
  points->InsertNextPoint(2.0, 1.0, 1.0);
  polys->InsertNextCell({ 0, 1, 1 });
  polys->InsertNextCell({ 0, 0, 0 });
  degenerate->SetPoints(points);
  degenerate->SetPolys(polys);
  for (vtkPolyData* mesh : { empty.Get(), pointless.Get(), degenerate.Get() })
  {
    AddActor(this->Renderer, mesh);
  }
  this->CheckBoth("with empty meshes");
  Check("messages", static_cast<double>(TakeMessages().size()), 0.0);
}
