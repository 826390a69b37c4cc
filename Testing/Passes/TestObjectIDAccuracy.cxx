// Object-ID maps against the truth and beside the depth map.
#include "ObjectIDTest.h"

using namespace shadowtest;

namespace
{

class ObjectIDAccuracy : public ObjectIDTest
{
};

}

TEST_F(ObjectIDAccuracy, StillLifeWithASpot)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(1024, 768);
  const Subject subject = AddStillLife(this->Renderer);
  AddSpot(this->Renderer, { 3.5, -3.0, 6.5 }, { 0.0, 0.0, 0.3 }, 35.0);
  AimCamera(this->Renderer, subject, -15.0, 28.0, 1024, 768);
  this->CheckBesideDepthMap("still life");
}

TEST_F(ObjectIDAccuracy, BumpyMeshWithASun)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(1024, 768);
  const Subject subject = AddBumpyMesh(this->Renderer);
  AddSun(this->Renderer, -Toward(60.0, 40.0));
  AimCamera(this->Renderer, subject, 10.0, 20.0, 1024, 768);
  this->CheckBesideDepthMap("bumpy mesh");
}

TEST_F(ObjectIDAccuracy, TubesAndGlyphsWithTwoLights)
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
TEST_F(ObjectIDAccuracy, UnseenViews)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(512, 384);
  for (int seed = 101; seed <= 112; ++seed)
  {
    AddSceneByLot(this->Renderer, seed, 20.0, 512, 384);
    this->Maps()->SetObjectType(seed % vtkObjectIDShadowPass::GetNumberOfObjectTypes());
    this->CheckBesideDepthMap("seed " + std::to_string(seed) + ", by " +
      vtkObjectIDShadowPass::GetObjectTypeName(this->Maps()->GetObjectType()));
  }
}

// Another caster a thousand times as far away along the light: the scene's depths are 1500 long, of
// which 16 bits are steps of 0.02, and each object's own range is as short as ever.
TEST_F(ObjectIDAccuracy, SmallObjectsInALargeScene)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(512, 384);
  const Subject subject = AddBumpyMesh(this->Renderer);
  const glm::dvec3 toward = Toward(60.0, 40.0);
  AddSphere(this->Renderer, subject.centre + 1000.0 * subject.radius * toward, 0.1);
  AddSun(this->Renderer, -toward);
  AimCamera(this->Renderer, subject, 10.0, 20.0, 512, 384);
  this->CheckBesideDepthMap("a caster far away");
}

// A point light in a closed room: the faces of a cube.
TEST_F(ObjectIDAccuracy, PointLightInARoom)
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
TEST_F(ObjectIDAccuracy, OffsetsAndScales)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->Resize(640, 480);
  for (const Placement& placement : Placements)
  {
    for (const bool byActor : { true, false })
    {
      AddStillLifeAt(this->Renderer, placement, byActor, 640, 480);
      AddSpot(
        this->Renderer, placement.Of({ 3.5, -3.0, 6.5 }), placement.Of({ 0.0, 0.0, 0.3 }), 35.0);
      // Pieces are told by their vertices.
      this->Maps()->SetObjectType(byActor ? "prop" : "piece");
      this->CheckBesideDepthMap(
        std::string(placement.name) + (byActor ? ", by actor" : ", by points"));
    }
  }
}
