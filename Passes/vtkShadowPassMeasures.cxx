// How wrong a technique is in the present view, for the choice: beside the frame, and at no more
// rays than a part of a second allows.
#include "vtkShadowPassInternals.h"

#include "ShadowCandidates.h"
#include "vtkShadowSeconds.h"

#include <algorithm>
#include <cmath>

namespace
{

// Rays that a choice traces for one measure: enough for one gross pixel in 100 000 to be seen, and
// a small part of a second. Lights share them, down to so many pixels each.
constexpr double MeasuredRays = 1.0e6;
constexpr double MeasuredRaysOfBudget = 4.0e6; // where a budget of error is held against it
constexpr double LeastMeasuredPixels = 3.0e4;

// Of a light with a radius, at every pixel.
constexpr int CoarseSamples = 8;

}

//------------------------------------------------------------------------------
// No more than a part of a second allows.
double vtkShadowPass::Internals::PixelsToMeasure(const std::vector<int>& lights) const
{
  double rays = 0.0;
  for (const int i : lights)
  {
    rays += this->Scene->GetLights()[i].Ray.radius > 0.0 ? CoarseSamples : 1.0;
  }
  const double budget =
    this->Chooser.GetBudget().maximumError ? MeasuredRaysOfBudget : MeasuredRays;
  return std::max(budget / rays, LeastMeasuredPixels);
}

//------------------------------------------------------------------------------
// No more pixels than that: of a smaller view, or, `allDrawn`, some of those of the frame's own.
void vtkShadowPass::Internals::Reduce(
  MeasuredView& view, const vtkShadowFrame& frame, double mostPixels, bool allDrawn)
{
  const double pixels = static_cast<double>(frame.Size[0]) * frame.Size[1];
  view.Scale = std::min(1.0, std::sqrt(mostPixels / pixels));
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

#ifdef VTKSHADOWS_WITH_EMBREE
//------------------------------------------------------------------------------
// Of the technique that is attached to the shading, for a light without a radius.
bool vtkShadowPass::Internals::MeasureError(
  MeasuredView& view, int light, vtkshadows::VisibilityError& error)
{
  auto known = view.Truths.find(light);
  if (known == view.Truths.end())
  {
    Measured truth;
    if (!this->TraceTruth(view.Frame, view.Receivers, light, 1, truth))
    {
      return false;
    }
    known = view.Truths.emplace(light, std::move(truth)).first;
  }
  Measured& measured = known->second;
  if (!view.Receivers.DrawVisibility(view.Frame, light, measured.Visibility))
  {
    return false;
  }
  error = vtkshadows::MeasureVisibility(measured.Images(), vtkshadows::GrossDistance * view.Scale);
  return true;
}

//------------------------------------------------------------------------------
// The same for one with a radius.
bool vtkShadowPass::Internals::MeasureSoftError(
  MeasuredView& view, int light, vtkshadows::VisibilityError& error)
{
  auto known = view.SoftTruths.find(light);
  if (known == view.SoftTruths.end())
  {
    std::vector<vtkshadows::PixelRole> roles;
    if (!this->FindRoles(view.Frame, view.Receivers, light, roles))
    {
      return false;
    }
    vtkshadows::AdaptiveTruth::Settings settings;
    settings.width = view.Size[0];
    settings.height = view.Size[1];
    settings.coarse = CoarseSamples;
    settings.fine = std::max(vtkshadows::TruthSamples, this->SamplesOfTruth());
    settings.edgeDistance = vtkshadows::GrossDistance * view.Scale;
    const std::optional<double> maximumError = this->Chooser.GetBudget().maximumError;
    // The margin, by which a mean is held against its limit, covers what chance leaves of it.
    const double mostMean = 0.01 * maximumError.value_or(vtkshadows::MostSoftDifferencePercent);
    settings.meanLimit = mostMean / vtkshadows::ErrorMargin;
    settings.meanTolerance = mostMean - settings.meanLimit;
    settings.penumbraLimit = maximumError ? 0.0 : 0.01 * vtkshadows::MostPenumbraDifferencePercent;
    const auto trace = [this, &view, light](int samples, double epsilonScale,
                         const std::vector<unsigned char>& which, std::vector<float>& visibility)
    {
      // A headlight is lit everywhere by definition.
      const vtkShadowScene::Light& traced = this->Scene->GetLights()[light];
      return traced.AtEye ||
        (view.Receivers.Draw(view.Frame) &&
          this->GetRayCast()->TraceVisibility(
            view.Frame, view.Receivers, traced.Ray, epsilonScale, samples, visibility, &which));
    };
    vtkshadows::AdaptiveTruth truth;
    if (!truth.Begin(settings, std::move(roles), trace))
    {
      return false;
    }
    known = view.SoftTruths.emplace(light, std::move(truth)).first;
  }
  std::vector<float> visibility;
  return view.Receivers.DrawVisibility(view.Frame, light, visibility) &&
    known->second.Measure(visibility, error);
}
#endif

//------------------------------------------------------------------------------
// Hold what a technique makes of `lights`, as it is set, against the truth, in this view.
bool vtkShadowPass::Internals::MeasureErrors(MeasuredView& view,
  const std::vector<vtkShadowedShadingPass::LightPlan>& plan, const std::string& name,
  const std::vector<int>& lights, std::vector<std::optional<vtkshadows::ErrorPercents>>& errors,
  double& drawingSeconds)
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
  const double start = vtkShadowSecondsOnceDrawn();
  bool done = technique->UpdateVisibility(frame, lights);
  drawingSeconds = std::max(drawingSeconds, vtkShadowSecondsOnceDrawn() - start);
  this->Shading->ActivateTextures();
  for (std::size_t i = 0; done && i < lights.size(); ++i)
  {
    vtkshadows::VisibilityError error;
    done = this->Scene->GetLights()[lights[i]].Ray.radius > 0.0
      ? this->MeasureSoftError(view, lights[i], error)
      : this->MeasureError(view, lights[i], error);
    if (done)
    {
      errors.push_back(error.receiverPixels > 0
          ? std::optional<vtkshadows::ErrorPercents>(
              vtkshadows::ErrorPercents::Of(error, view.Scale < 1.0))
          : std::nullopt);
    }
  }
  this->Shading->Detach();
  technique->NumberOfSlots = 0;
  return done;
#else
  return false;
#endif
}
