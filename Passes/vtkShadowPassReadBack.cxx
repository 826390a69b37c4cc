#include "vtkShadowPassInternals.h"

#include "ShadowCandidates.h"
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

// Pixels from a true edge beyond which a mismatch is gross.
constexpr double GrossDistance = 2.0;

// Rays that a choice traces for one measure: enough for one gross pixel in 100 000 to be seen, and
// a small part of a second. Lights share them, down to so many pixels each.
constexpr double MeasuredRays = 1.0e6;
constexpr double MeasuredRaysOfBudget = 4.0e6; // where a budget of error is held against it
constexpr double LeastMeasuredPixels = 3.0e4;

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

void FillImage(vtkImageData* image, const vtkShadowFrame& frame, const std::vector<float>& values,
  const char* name)
{
  image->SetDimensions(frame.Size[0], frame.Size[1], 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  std::copy(values.begin(), values.end(), static_cast<float*>(image->GetScalarPointer()));
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
bool vtkShadowPass::FindLight(vtkRenderer* renderer, vtkLight* light, int& index)
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
  if (!this->FindLight(renderer, light, index))
  {
    return false;
  }
  const Internals::ReadBack readBack(*this->Internal, renderer, false, false);
  const vtkShadowFrame& frame = readBack.Frame;
  std::vector<float> values(static_cast<std::size_t>(frame.Size[0]) * frame.Size[1], 1.0f);
  if (readBack.IsBegun && !this->Internal->Receivers.DrawVisibility(frame, index, values))
  {
    vtkErrorMacro("The driver cannot hold a buffer of "
      << frame.Size[0] << " x " << frame.Size[1]
      << " float pixels to read visibility from. Use a smaller window.");
    return false;
  }
  FillImage(visibility, frame, values, "Visibility");
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
  FillImage(counts, readBack.Frame, values, "VolumeCounts");
  return true;
}

//------------------------------------------------------------------------------
// No more pixels than a part of a second allows: of a smaller view, or, `allDrawn`, some of those
// of the frame's own.
void vtkShadowPass::Internals::Reduce(
  MeasuredView& view, const vtkShadowFrame& frame, const std::vector<int>& lights, bool allDrawn)
{
  double rays = 0.0;
  for (const int i : lights)
  {
    rays += this->Scene->GetLights()[i].Ray.radius > 0.0 ? vtkshadows::TruthSamples : 1.0;
  }
  const double pixels = static_cast<double>(frame.Size[0]) * frame.Size[1];
  const double budget =
    this->Chooser.GetBudget().maximumError ? MeasuredRaysOfBudget : MeasuredRays;
  view.Scale = std::min(1.0, std::sqrt(std::max(budget / rays, LeastMeasuredPixels) / pixels));
  view.Frame = frame;
  for (int axis = 0; axis < 2; ++axis)
  {
    view.Size[axis] = std::max(1, static_cast<int>(std::lround(view.Scale * frame.Size[axis])));
    view.Frame.Size[axis] = allDrawn ? frame.Size[axis] : view.Size[axis];
    view.Frame.Origin[axis] = 0;
  }
  view.Receivers.KeepPixels(view.Size[0], view.Size[1]);
  view.Frame.Receivers = &view.Receivers;
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
// The truth of light `light` at every pixel, and what each pixel is to the measure.
bool vtkShadowPass::Internals::TraceTruth(const vtkShadowFrame& frame,
  vtkShadowReceiverBuffer& receivers, int light, int samples, Measured& measured)
{
#ifdef VTKSHADOWS_WITH_EMBREE
  const vtkshadows::ShadowLight ray = this->Scene->GetLights()[light].Ray;
  vtkRayCastShadowPass* reference = this->GetRayCast();
  std::vector<float> nearby;
  if (!receivers.Draw(frame) ||
    !reference->TraceVisibility(frame, receivers, ray, 1.0, samples, measured.Truth) ||
    !reference->TraceVisibility(
      frame, receivers, ray, 4.0, std::min(samples, SamplesOfUncertainty), nearby))
  {
    return false;
  }
  measured.Size[0] = receivers.Width();
  measured.Size[1] = receivers.Height();
  const std::size_t pixels = measured.Truth.size();
  const glm::dmat4 worldFromView = glm::inverse(frame.ViewFromWorld);
  const double coneCosine = std::cos(glm::radians(ray.coneAngle));
  measured.Roles.assign(pixels, vtkshadows::PixelRole::Background);
  for (std::size_t i = 0; i < pixels; ++i)
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
    measured.Roles[i] = !reached || glm::dot(normalWC, towardLight) <= GrazingCosine
      ? vtkshadows::PixelRole::Grazing
      : std::abs(measured.Truth[i] - nearby[i]) > 0.5f ? vtkshadows::PixelRole::Uncertain
                                                       : vtkshadows::PixelRole::Measured;
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
// Hold what a technique makes of `lights`, as it is set, against the truth, in this view.
bool vtkShadowPass::Internals::MeasureErrors(MeasuredView& view,
  const std::vector<vtkShadowedShadingPass::LightPlan>& plan, const std::string& name,
  const std::vector<int>& lights, std::vector<std::optional<vtkshadows::ErrorPercents>>& errors)
{
#ifdef VTKSHADOWS_WITH_EMBREE
  vtkShadowTechniquePass* technique = this->Find(name);
  std::vector<vtkShadowedShadingPass::LightPlan> measuredPlan = plan;
  for (vtkShadowedShadingPass::LightPlan& entry : measuredPlan)
  {
    entry.Technique = nullptr;
    entry.Strength = 1.0f;
    entry.MaximumDistance = 0.0f;
  }
  technique->NumberOfSlots = 0;
  for (const int i : lights)
  {
    measuredPlan[i].Technique = technique;
    measuredPlan[i].Slot = technique->NumberOfSlots++;
  }
  const vtkShadowFrame& frame = view.Frame;
  this->Shading->SetPlan(measuredPlan);
  this->Shading->Attach(frame);
  view.Receivers.Invalidate();
  bool done = technique->UpdateVisibility(frame, lights);
  this->Shading->ActivateTextures();
  for (std::size_t i = 0; done && i < lights.size(); ++i)
  {
    auto known = view.Truths.find(lights[i]);
    if (known == view.Truths.end())
    {
      known = view.Truths.emplace(lights[i], Measured()).first;
      done = this->TraceTruth(frame, view.Receivers, lights[i],
        std::max(vtkshadows::TruthSamples, this->SamplesOfTruth()), known->second);
    }
    Measured& measured = known->second;
    done = done && view.Receivers.DrawVisibility(frame, lights[i], measured.Visibility);
    if (!done)
    {
      view.Truths.erase(known);
      break;
    }
    vtkshadows::VisibilityImages images;
    images.width = view.Size[0];
    images.height = view.Size[1];
    images.visibility = measured.Visibility.data();
    images.truth = measured.Truth.data();
    images.role = measured.Roles.data();
    const vtkshadows::VisibilityError error =
      vtkshadows::MeasureVisibility(images, GrossDistance * view.Scale);
    errors.push_back(error.receiverPixels > 0
        ? std::optional<vtkshadows::ErrorPercents>(
            vtkshadows::ErrorPercents::Of(error, view.Scale < 1.0))
        : std::nullopt);
  }
  this->Shading->Detach();
  technique->NumberOfSlots = 0;
  return done;
#else
  return false;
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
