#include "vtkShadowPassInternals.h"

#include "vtkStencilShadowVolumePass.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPointData.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderState.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{

// Sample lights that tell whether the truth of a light with a radius hangs on the ray epsilon.
constexpr int SamplesOfUncertainty = 16;

// Faces nearer to edge-on than this are not measured: there, a rounding decides what is in shadow.
constexpr double GrazingCosine = 0.02;

// Bring a renderer's window and its props into a render state outside of a frame.
class StateOfRenderer
{
public:
  explicit StateOfRenderer(vtkRenderer* renderer)
    : State(renderer)
  {
    vtkCollectionSimpleIterator it;
    renderer->GetViewProps()->InitTraversal(it);
    while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(it))
    {
      if (prop->GetVisibility())
      {
        this->Props.push_back(prop);
      }
    }
    this->State.SetPropArrayAndCount(this->Props.data(), static_cast<int>(this->Props.size()));
    this->State.SetFrameBuffer(nullptr);
  }
  const vtkRenderState* Get() const { return &this->State; }

private:
  vtkRenderState State;
  std::vector<vtkProp*> Props;
};

// A component for each of `values`.
void FillImage(vtkImageData* image, const vtkShadowFrame& frame,
  const std::vector<std::vector<float>>& values, const char* name)
{
  const int components = static_cast<int>(values.size());
  image->SetDimensions(frame.Size[0], frame.Size[1], 1);
  image->AllocateScalars(VTK_FLOAT, components);
  auto* pixels = static_cast<float*>(image->GetScalarPointer());
  for (int c = 0; c < components; ++c)
  {
    for (std::size_t i = 0; i < values[c].size(); ++i)
    {
      pixels[i * components + c] = values[c][i];
    }
  }
  image->GetPointData()->GetScalars()->SetName(name);
  image->Modified();
}

}

//------------------------------------------------------------------------------
// A frame as it would be drawn, for what is read back outside of one: begun for as long as this
// lives, unless there is nothing to begin. `always`: also without a light that casts.
struct vtkShadowPass::Internals::ReadBack
{
  ReadBack(Internals& my, vtkRenderer* renderer, bool withStrength, bool always)
    : My(my)
    , State(renderer)
    , Frame(my.FrameOf(this->State.Get()))
    , IsBegun(my.Begin(this->Frame, withStrength, always))
  {
  }
  ~ReadBack()
  {
    if (this->IsBegun)
    {
      this->My.End();
    }
  }
  ReadBack(const ReadBack&) = delete;
  void operator=(const ReadBack&) = delete;

  Internals& My;
  const StateOfRenderer State;
  const vtkShadowFrame Frame;
  const bool IsBegun;
};

//------------------------------------------------------------------------------
bool vtkShadowPass::IsReadable(vtkRenderer* renderer)
{
  auto* window =
    renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) : nullptr;
  if (!window || window->GetNeverRendered())
  {
    vtkErrorMacro(
      "The renderer " << renderer
                      << " has no OpenGL window that has rendered: call Render() on its "
                         "window first.");
    return false;
  }
  window->MakeCurrent();
  return true;
}

bool vtkShadowPass::FindLight(vtkRenderer* renderer, vtkLight* light, int& index)
{
  if (!this->IsReadable(renderer))
  {
    return false;
  }
  index = 0;
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* other = renderer->GetLights()->GetNextLight(it))
  {
    if (other == light && light->GetSwitch())
    {
      this->UpdateLightGeometry(renderer);
      this->UpdateLights(renderer);
      return true;
    }
    index += other->GetSwitch() ? 1 : 0;
  }
  vtkErrorMacro("The light " << light << " is not among the switched-on lights of renderer "
                             << renderer << ": add it, or switch it on.");
  return false;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetVisibility(vtkRenderer* renderer, vtkLight* light, vtkImageData* visibility)
{
  int index = 0;
  if (!visibility)
  {
    vtkErrorMacro(
      "GetVisibility(" << renderer << ", " << light << ", nullptr): give a vtkImageData to fill.");
    return false;
  }
  return this->FindLight(renderer, light, index) &&
    this->ReadVisibility(renderer, { index }, visibility);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetVisibilities(vtkRenderer* renderer, vtkImageData* visibilities)
{
  if (!visibilities)
  {
    vtkErrorMacro("GetVisibilities(" << renderer << ", nullptr): give a vtkImageData to fill.");
    return false;
  }
  if (!this->IsReadable(renderer))
  {
    return false;
  }
  std::vector<int> all;
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(it))
  {
    if (light->GetSwitch())
    {
      all.push_back(static_cast<int>(all.size()));
    }
  }
  if (all.empty())
  {
    vtkErrorMacro(
      "Renderer " << renderer << " has no light that is switched on: add one, or switch one on.");
    return false;
  }
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);
  return this->ReadVisibility(renderer, all, visibilities);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::ReadVisibility(
  vtkRenderer* renderer, const std::vector<int>& lights, vtkImageData* image)
{
  const Internals::ReadBack readBack(*this->Internal, renderer, false, false);
  const vtkShadowFrame& frame = readBack.Frame;
  const std::size_t pixels = static_cast<std::size_t>(frame.Size[0]) * frame.Size[1];
  std::vector<std::vector<float>> values(lights.size(), std::vector<float>(pixels, 1.0f));
  for (std::size_t i = 0; readBack.IsBegun && i < lights.size(); ++i)
  {
    if (!this->Internal->Receivers.DrawVisibility(frame, lights[i], values[i]))
    {
      vtkErrorMacro("The driver cannot hold a buffer of "
        << frame.Size[0] << " x " << frame.Size[1]
        << " float pixels to read visibility from. Use a smaller window.");
      return false;
    }
  }
  FillImage(image, frame, values, "Visibility");
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetVolumeCounts(vtkRenderer* renderer, vtkLight* light, vtkImageData* counts)
{
  int index = 0;
  if (!counts)
  {
    vtkErrorMacro("GetVolumeCounts(" << renderer << ", " << light
                                     << ", nullptr): give a vtkImageData to fill.");
    return false;
  }
  if (!this->FindLight(renderer, light, index))
  {
    return false;
  }
  const Internals::ReadBack readBack(*this->Internal, renderer, false, false);
  const vtkShadowedShadingPass::LightPlan& entry = this->Internal->Plan[index];
  auto* volumes = vtkStencilShadowVolumePass::SafeDownCast(entry.Technique);
  std::vector<float> values;
  if (!readBack.IsBegun || !volumes || !volumes->CountAgain(readBack.Frame, entry.Slot, values))
  {
    vtkErrorMacro("Light " << light << " has no volumes to count: its technique is \""
                           << this->GetLightTechnique(light)
                           << "\", or nothing casts. Give it \"stencil-volume\".");
    return false;
  }
  FillImage(counts, readBack.Frame, { values }, "VolumeCounts");
  return true;
}

//------------------------------------------------------------------------------
// Sample lights of the truth as the user asked for: the choice may have set the ray cast otherwise.
int vtkShadowPass::Internals::SamplesOfTruth()
{
#ifdef VTKSHADOWS_WITH_EMBREE
  const int own = this->Chooser.OwnSamples("ray-cast");
  return own > 0 ? own : this->GetRayCast()->GetLightSamples();
#else
  return 1;
#endif
}

//------------------------------------------------------------------------------
// What each pixel is to the measure of a light, but for those whose truth is uncertain.
bool vtkShadowPass::Internals::FindRoles(const vtkShadowFrame& frame,
  vtkShadowReceiverBuffer& receivers, int light, std::vector<vtkshadows::PixelRole>& roles)
{
  if (!receivers.Draw(frame))
  {
    return false;
  }
  const vtkshadows::ShadowLight ray = this->Scene->GetLights()[light].Ray;
  const glm::dmat4 worldFromView = glm::inverse(frame.ViewFromWorld);
  const double coneCosine = std::cos(glm::radians(ray.coneAngle));
  roles.assign(static_cast<std::size_t>(receivers.Width()) * receivers.Height(),
    vtkshadows::PixelRole::Background);
  for (std::size_t i = 0; i < roles.size(); ++i)
  {
    vtkShadowReceiverBuffer::Receiver receiver;
    if (!receivers.At(i, receiver))
    {
      continue;
    }
    const glm::dvec3 pointWC(worldFromView * glm::dvec4(receiver.PositionVC, 1.0));
    const glm::dvec3 normalWC(worldFromView * glm::dvec4(receiver.NormalVC, 0.0));
    const glm::dvec3 towardLight = ray.TowardLight(pointWC);
    // A spot shines on nothing outside its cone.
    const bool reached = ray.kind != vtkshadows::LightKind::Spot ||
      -glm::dot(towardLight, ray.direction) >= coneCosine;
    roles[i] = reached && glm::dot(normalWC, towardLight) > GrazingCosine
      ? vtkshadows::PixelRole::Measured
      : vtkshadows::PixelRole::Grazing;
  }
  return true;
}

//------------------------------------------------------------------------------
// The truth of light `light` at every pixel, and what each pixel is to the measure.
bool vtkShadowPass::Internals::TraceTruth(const vtkShadowFrame& frame,
  vtkShadowReceiverBuffer& receivers, int light, int samples, Measured& measured)
{
#ifdef VTKSHADOWS_WITH_EMBREE
  const vtkshadows::ShadowLight ray = this->Scene->GetLights()[light].Ray;
  vtkRayCastShadowPass* reference = this->GetRayCast();
  std::vector<float> nearby;
  if (!this->FindRoles(frame, receivers, light, measured.Roles) ||
    !reference->TraceVisibility(frame, receivers, ray, 1.0, samples, measured.Truth) ||
    !reference->TraceVisibility(frame, receivers, ray, vtkshadows::FartherEpsilonScale,
      std::min(samples, SamplesOfUncertainty), nearby))
  {
    return false;
  }
  measured.Size[0] = receivers.Width();
  measured.Size[1] = receivers.Height();
  for (std::size_t i = 0; i < measured.Roles.size(); ++i)
  {
    if (measured.Roles[i] == vtkshadows::PixelRole::Measured &&
      std::abs(measured.Truth[i] - nearby[i]) > 0.5f)
    {
      measured.Roles[i] = vtkshadows::PixelRole::Uncertain;
    }
  }
  // A headlight is lit everywhere by definition, and its truth with it.
  if (this->Scene->GetLights()[light].AtEye)
  {
    std::fill(measured.Truth.begin(), measured.Truth.end(), 1.0f);
  }
  return true;
#else
  return false;
#endif
}

//------------------------------------------------------------------------------
bool vtkShadowPass::MeasureLight(vtkRenderer* renderer, vtkLight* light, Measured& measured)
{
#ifndef VTKSHADOWS_WITH_EMBREE
  vtkErrorMacro("This build has no Embree, so there is no truth to measure light "
    << light << " against: configure with -DVTKSHADOWS_WITH_EMBREE=ON.");
  return false;
#else
  int index = 0;
  if (!this->FindLight(renderer, light, index))
  {
    return false;
  }
  Internals& my = *this->Internal;
  const Internals::ReadBack readBack(my, renderer, false, true);
  const vtkShadowFrame& frame = readBack.Frame;
  if (!readBack.IsBegun)
  {
    vtkErrorMacro("The renderer " << renderer << " has a viewport of " << frame.Size[0] << " x "
                                  << frame.Size[1] << " pixels: nothing to measure. Enlarge it.");
    return false;
  }

  const bool done = my.TraceTruth(frame, my.Receivers, index, my.SamplesOfTruth(), measured) &&
    my.Receivers.DrawVisibility(frame, index, measured.Visibility);
  if (!done)
  {
    vtkErrorMacro(
      "Light " << light << " could not be measured: the driver or Embree gave no buffer of "
               << frame.Size[0] << " x " << frame.Size[1] << " pixels. Use a smaller window.");
  }
  return done;
#endif
}

//------------------------------------------------------------------------------
double vtkShadowPass::TimeBareTracing(vtkRenderer* renderer)
{
  double seconds = 0.0;
#ifdef VTKSHADOWS_WITH_EMBREE
  vtkRayCastShadowPass* reference = this->GetRayCastShadowPass();
  if (!reference || !renderer || !renderer->GetRenderWindow() ||
    renderer->GetRenderWindow()->GetNeverRendered())
  {
    vtkErrorMacro("TimeBareTracing(" << renderer << "): call Render() on its window first.");
    return seconds;
  }
  renderer->GetRenderWindow()->MakeCurrent();
  const Internals::ReadBack readBack(*this->Internal, renderer, true, true);
  if (readBack.IsBegun)
  {
    seconds = reference->TimeBareTracing(readBack.Frame);
  }
#endif
  return seconds;
}
