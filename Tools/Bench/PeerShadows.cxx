#include "PeerShadows.h"

#include "Stage.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCameraPass.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderer.h>
#include <vtkSequencePass.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkShadowMapPass.h>
#include <vtkShadowPass.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace vtkshadows
{
namespace
{

constexpr int LeastContrast = 24;

// Leaves one light and the opaque props, and gives back the others when it goes.
class OneLightAlone
{
public:
  OneLightAlone(Stage& changedStage, std::size_t light)
    : stage(changedStage)
  {
    for (std::size_t i = 0; i < this->stage.Lights().size(); ++i)
    {
      this->switches.push_back(this->stage.Lights()[i]->GetSwitch());
      if (i != light)
      {
        this->stage.Lights()[i]->SwitchOff();
      }
    }
    vtkActorCollection* actors = this->stage.Renderer()->GetActors();
    vtkCollectionSimpleIterator it;
    actors->InitTraversal(it);
    while (vtkActor* actor = actors->GetNextActor(it))
    {
      if (actor->GetVisibility() && actor->GetProperty()->GetOpacity() < 1.0)
      {
        this->hidden.push_back(actor);
        actor->VisibilityOff();
      }
    }
  }
  ~OneLightAlone()
  {
    for (std::size_t i = 0; i < this->switches.size(); ++i)
    {
      this->stage.Lights()[i]->SetSwitch(this->switches[i]);
    }
    for (vtkActor* actor : this->hidden)
    {
      actor->VisibilityOn();
    }
    this->stage.UsePass(nullptr);
  }
  OneLightAlone(const OneLightAlone&) = delete;
  OneLightAlone& operator=(const OneLightAlone&) = delete;

private:
  Stage& stage;
  std::vector<int> switches;
  std::vector<vtkActor*> hidden;
};

vtkSmartPointer<vtkImageData> Draw(Stage& stage)
{
  stage.Window().Render();
  return stage.Window().Picture();
}

}

vtkSmartPointer<vtkRenderPass> MakePeerPass(int resolution)
{
  vtkNew<vtkShadowMapPass> shadows;
  shadows->GetShadowMapBakerPass()->SetResolution(resolution);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(shadows->GetShadowMapBakerPass());
  passes->AddItem(shadows);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(sequence);
  return camera;
}

vtkSmartPointer<vtkImageData> VisibilityOffPictures(
  Stage& stage, std::size_t light, vtkRenderPass* pass)
{
  const OneLightAlone alone(stage, light);
  vtkLight* shining = stage.Lights()[light];
  const double intensity = shining->GetIntensity();

  stage.ShowShadows(false);
  const vtkSmartPointer<vtkImageData> lit = Draw(stage);
  shining->SetIntensity(0.0);
  const vtkSmartPointer<vtkImageData> dark = Draw(stage);
  shining->SetIntensity(intensity);
  stage.UsePass(pass);
  const vtkSmartPointer<vtkImageData> shadowed = Draw(stage);

  auto visibility = vtkSmartPointer<vtkImageData>::New();
  visibility->SetDimensions(lit->GetDimensions());
  visibility->AllocateScalars(VTK_FLOAT, 1);
  const auto* l = static_cast<const unsigned char*>(lit->GetScalarPointer());
  const auto* d = static_cast<const unsigned char*>(dark->GetScalarPointer());
  const auto* s = static_cast<const unsigned char*>(shadowed->GetScalarPointer());
  auto* value = static_cast<float*>(visibility->GetScalarPointer());
  for (vtkIdType i = 0; i < visibility->GetNumberOfPoints(); ++i, l += 3, d += 3, s += 3)
  {
    const int contrast = (l[0] + l[1] + l[2]) - (d[0] + d[1] + d[2]);
    const int above = (s[0] + s[1] + s[2]) - (d[0] + d[1] + d[2]);
    value[i] = contrast < LeastContrast
      ? std::numeric_limits<float>::quiet_NaN()
      : std::clamp(static_cast<float>(above) / static_cast<float>(contrast), 0.0f, 1.0f);
  }
  return visibility;
}

}
