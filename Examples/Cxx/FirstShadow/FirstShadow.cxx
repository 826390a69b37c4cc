// The shadow of a sphere on a plane: writes FirstShadow.png, or the file that is named.
#include "vtkShadowPass.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkWindowToImageFilter.h"

static void AddActor(vtkRenderer* renderer, vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

int main(int argc, char* argv[])
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkPlaneSource> plane; // a unit square at z = 0
  AddActor(renderer, plane);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0, 0, 0.25);
  sphere->SetRadius(0.15);
  sphere->SetPhiResolution(64);
  sphere->SetThetaResolution(64);
  AddActor(renderer, sphere);

  vtkNew<vtkLight> light; // a spot: positional, with a cone
  light->SetPositional(true);
  light->SetConeAngle(40);
  light->SetPosition(0.6, 0.3, 1.2);
  light->SetFocalPoint(0, 0, 0);
  renderer->AddLight(light);

  vtkNew<vtkShadowPass> shadows;
  shadows->SetTechnique("depth-map");
  shadows->SetLightStrength(light, 0.8);
  renderer->SetPass(shadows);

  vtkNew<vtkRenderWindow> window;
  window->SetSize(800, 600);
  window->OffScreenRenderingOn();
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(0, -2, 1.5);
  renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.5);
  renderer->SetBackground(1, 1, 1);
  window->Render();

  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "FirstShadow.png");
  writer->Write();
  return writer->GetErrorCode() == 0 ? 0 : 1;
}
