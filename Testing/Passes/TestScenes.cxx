#include "TestScenes.h"

#include "ShadowTest.h"

#include <vtkActorCollection.h>
#include <vtkMapper.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

namespace shadowtest
{

//------------------------------------------------------------------------------
void PlaceActors(vtkRenderer* renderer, vtkTransform* worldFromScene, bool byActor)
{
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    if (byActor)
    {
      actor->SetUserTransform(worldFromScene);
      continue;
    }
    vtkNew<vtkTransform> worldFromModel;
    worldFromModel->Concatenate(worldFromScene);
    worldFromModel->Concatenate(actor->GetMatrix());
    vtkNew<vtkTransformPolyDataFilter> move;
    move->SetInputConnection(actor->GetMapper()->GetInputConnection(0, 0));
    move->SetTransform(worldFromModel);
    move->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    actor->GetMapper()->SetInputConnection(move->GetOutputPort());
    actor->SetPosition(0.0, 0.0, 0.0);
    actor->SetOrientation(0.0, 0.0, 0.0);
    actor->SetScale(1.0, 1.0, 1.0);
  }
}

void PlaceActors(vtkRenderer* renderer, const Placement& placement, bool byActor)
{
  vtkNew<vtkTransform> worldFromScene;
  worldFromScene->Translate(placement.offset, placement.offset, placement.offset);
  worldFromScene->Scale(placement.scale, placement.scale, placement.scale);
  PlaceActors(renderer, worldFromScene, byActor);
}

//------------------------------------------------------------------------------
void AddStillLifeAt(
  vtkRenderer* renderer, const Placement& placement, bool byActor, int width, int height)
{
  renderer->RemoveAllViewProps();
  renderer->RemoveAllLights();
  Subject subject = AddStillLife(renderer);
  PlaceActors(renderer, placement, byActor);
  subject.centre = placement.Of(subject.centre);
  subject.radius *= placement.scale;
  AimCamera(renderer, subject, -15.0, 28.0, width, height);
}

//------------------------------------------------------------------------------
LotScene AddSceneByLot(vtkRenderer* renderer, int seed, double lowest, int width, int height)
{
  vtkshadows::scenes::Lot any(seed);
  renderer->RemoveAllViewProps();
  renderer->RemoveAllLights();
  const char* names[] = { "still life", "bumpy mesh", "tubes and glyphs" };
  const int kind = seed % 3;
  const Subject subject = kind == 0 ? AddStillLife(renderer)
    : kind == 1                     ? AddBumpyMesh(renderer)
                                    : AddTubesAndGlyphs(renderer);
  const glm::dvec3 toward = Toward(any(0.0, 360.0), any(lowest, 80.0));
  if (any(0.0, 1.0) < 0.5)
  {
    AddSun(renderer, -toward);
  }
  else
  {
    AddSpot(renderer, subject.centre + any(2.0, 5.0) * subject.radius * toward, subject.centre,
      any(25.0, 50.0));
  }
  AimCamera(renderer, subject, any(0.0, 360.0), any(10.0, 70.0), width, height);
  return { names[kind], kind };
}

}
