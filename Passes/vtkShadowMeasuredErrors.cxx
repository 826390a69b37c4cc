#include "vtkShadowMeasuredErrors.h"

#include "vtkShadowSeconds.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <cmath>

namespace
{

// How far apart two positive numbers are, as the logarithm of their ratio.
double Ratio(double a, double b)
{
  return a == b ? 0.0 : a > 0.0 && b > 0.0 ? std::abs(std::log(a / b)) : 1.0;
}

}

//------------------------------------------------------------------------------
// In radians, and in shares of distances and sizes: all of them steps of what a picture shows.
double vtkShadowMeasuredErrors::DriftOf(const Circumstances& then, const Circumstances& now)
{
  const glm::dmat4 worldThen = glm::inverse(then.ViewFromWorld);
  const glm::dmat4 worldNow = glm::inverse(now.ViewFromWorld);
  double drift = glm::length(glm::dvec3(worldNow[2]) - glm::dvec3(worldThen[2]));
  drift += glm::length(glm::dvec3(worldNow[3]) - glm::dvec3(worldThen[3])) /
    std::min(then.Distance, now.Distance);
  drift += Ratio(then.ClipFromView[1][1], now.ClipFromView[1][1]);
  drift += Ratio(then.Height, now.Height);
  drift += Ratio(then.Reach, now.Reach);
  drift += now.CasterChanges - then.CasterChanges;
  if (then.Light.kind != now.Light.kind)
  {
    return drift + 1.0;
  }
  drift += glm::length(now.Light.direction - then.Light.direction);
  drift += Ratio(then.Light.radius, now.Light.radius);
  if (now.Light.kind != vtkshadows::LightKind::Directional)
  {
    drift += glm::length(now.Light.position - then.Light.position) / now.Reach;
    drift += std::abs(now.Light.coneAngle - then.Light.coneAngle) / 90.0;
  }
  return std::isfinite(drift) ? drift : 1.0;
}

//------------------------------------------------------------------------------
std::optional<vtkShadowMeasuredErrors::Record> vtkShadowMeasuredErrors::Find(
  const vtkshadows::ShadowSetting& setting, const Circumstances& now) const
{
  for (const Entry& entry : this->Entries)
  {
    if (entry.Then.Source == now.Source && entry.Setting == setting)
    {
      return Record{ entry.Error, entry.Cost, vtkShadowSeconds() - entry.Time,
        DriftOf(entry.Then, now) };
    }
  }
  return std::nullopt;
}

//------------------------------------------------------------------------------
void vtkShadowMeasuredErrors::Keep(const vtkshadows::ShadowSetting& setting,
  const Circumstances& now, const vtkshadows::ErrorPercents& error, double cost)
{
  this->Entries.erase(std::remove_if(this->Entries.begin(), this->Entries.end(),
                        [&](const Entry& entry)
                        { return entry.Then.Source == now.Source && entry.Setting == setting; }),
    this->Entries.end());
  this->Entries.push_back({ setting, now, error, cost, vtkShadowSeconds() });
}

void vtkShadowMeasuredErrors::KeepOnly(const std::vector<const vtkLight*>& lights)
{
  this->Entries.erase(
    std::remove_if(this->Entries.begin(), this->Entries.end(),
      [&](const Entry& entry)
      { return std::find(lights.begin(), lights.end(), entry.Then.Source) == lights.end(); }),
    this->Entries.end());
}
