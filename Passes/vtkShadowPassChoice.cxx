// The budgets of the choice, and what it took and why.
#include "vtkShadowPassInternals.h"

#include <algorithm>
#include <cmath>
#include <optional>

using vtkshadows::AutoTechnique;
using vtkshadows::NoTechnique;

//------------------------------------------------------------------------------
void vtkShadowPass::SetMaximumError(double percent)
{
  if (!std::isfinite(percent) || percent < 0.0 || percent > 100.0)
  {
    vtkErrorMacro(
      "MaximumError " << percent
                      << " is no share of the pixels: give percent, above 0 to 100, or 0 "
                         "for no limit. It stays "
                      << this->GetMaximumError() << ".");
    return;
  }
  if (percent != this->GetMaximumError())
  {
    vtkshadows::ShadowBudget budget = this->Internal->Chooser.GetBudget();
    budget.maximumError = percent > 0.0 ? std::optional<double>(percent) : std::nullopt;
    this->Internal->Chooser.SetBudget(budget);
    this->Modified();
  }
}

double vtkShadowPass::GetMaximumError() const
{
  return this->Internal->Chooser.GetBudget().maximumError.value_or(0.0);
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetMaximumFrameTime(double milliseconds)
{
  if (!std::isfinite(milliseconds) || milliseconds < 0.0)
  {
    vtkErrorMacro("MaximumFrameTime " << milliseconds
                                      << " is no time of a frame: give milliseconds, above 0, or 0 "
                                         "for no limit. It stays "
                                      << this->GetMaximumFrameTime() << ".");
    return;
  }
  if (milliseconds != this->GetMaximumFrameTime())
  {
    vtkshadows::ShadowBudget budget = this->Internal->Chooser.GetBudget();
    budget.maximumSeconds =
      milliseconds > 0.0 ? std::optional<double>(0.001 * milliseconds) : std::nullopt;
    this->Internal->Chooser.SetBudget(budget);
    this->Modified();
  }
}

double vtkShadowPass::GetMaximumFrameTime() const
{
  return 1000.0 * this->Internal->Chooser.GetBudget().maximumSeconds.value_or(0.0);
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetExplanation(vtkLight* light) const
{
  const Internals& my = *this->Internal;
  const std::vector<vtkShadowScene::Light>& lights = my.Scene->GetLights();
  const auto found = std::find_if(lights.begin(), lights.end(),
    [light](const vtkShadowScene::Light& one) { return one.Source == light; });
  if (!light || found == lights.end())
  {
    return "none: the last frame had no such light.";
  }
  const std::string name = this->GetLightTechnique(light);
  return name != AutoTechnique ? name + ": named, not chosen."
    : found->AtEye             ? "none: from the eye, where the light is, no shadow is seen."
    : this->GetLightStrength(light) <= 0.0 ? "none: the strength of its shadows is 0."
    : my.Scene->GetNumberOfCasters() < 1   ? "none: nothing casts."
    : my.Scene->GetNumberOfReceivers() < 1 ? "none: nothing receives."
                                           : my.Chooser.Explain(light);
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetChosenTechnique(vtkLight* light) const
{
  const Internals& my = *this->Internal;
  const std::vector<vtkShadowScene::Light>& lights = my.Scene->GetLights();
  for (std::size_t i = 0; i < lights.size() && i < my.Plan.size(); ++i)
  {
    if (lights[i].Source == light && my.Plan[i].Technique)
    {
      return my.Plan[i].Technique->GetTechniqueName();
    }
  }
  return NoTechnique;
}

bool vtkShadowPass::GetChoiceIsSettled() const
{
  return this->Internal->Chooser.IsSettled();
}

//------------------------------------------------------------------------------
// No setting of the picture: nothing is modified.
void vtkShadowPass::SetHoldChoice(bool held)
{
  this->Internal->Chooser.SetHolds(held);
}

bool vtkShadowPass::GetHoldChoice() const
{
  return this->Internal->Chooser.GetHolds();
}
