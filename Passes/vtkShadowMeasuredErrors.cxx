#include "vtkShadowMeasuredErrors.h"

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
std::size_t vtkShadowMeasuredErrors::Place(
  const vtkshadows::ShadowSetting& setting, const Circumstances& now) const
{
  return std::find_if(this->Entries.begin(), this->Entries.end(),
           [&](const Entry& entry)
           { return entry.Then.Source == now.Source && entry.Setting == setting; }) -
    this->Entries.begin();
}

//------------------------------------------------------------------------------
std::optional<vtkShadowMeasuredErrors::Record> vtkShadowMeasuredErrors::Find(
  const vtkshadows::ShadowSetting& setting, const Circumstances& now) const
{
  const std::size_t place = this->Place(setting, now);
  if (place == this->Entries.size())
  {
    return std::nullopt;
  }
  const Entry& entry = this->Entries[place];
  return Record{ entry.Error, entry.Cost, this->Time - entry.Time, DriftOf(entry.Then, now),
    entry.Rate.Get(), entry.WasRefused };
}

//------------------------------------------------------------------------------
void vtkShadowMeasuredErrors::Keep(const vtkshadows::ShadowSetting& setting,
  const Circumstances& now, const vtkshadows::ErrorPercents& error, double cost)
{
  const std::size_t place = this->Place(setting, now);
  if (place == this->Entries.size())
  {
    this->Entries.push_back({ setting, now, error, cost, this->Time, {}, false });
    return;
  }
  Entry& entry = this->Entries[place];
  if (!entry.Error.isOfNothing && !error.isOfNothing)
  {
    const bool soft = now.Light.radius > 0.0;
    const double change = vtkshadows::ShareOfChange(entry.Error.Figure(soft), error.Figure(soft));
    const double inPenumbra = soft
      ? vtkshadows::ShareOfChange(entry.Error.penumbraDifference, error.penumbraDifference)
      : 0.0;
    entry.Rate.Learn(std::max(change, inPenumbra), DriftOf(entry.Then, now));
  }
  entry.Then = now;
  entry.Error = error;
  entry.Cost = cost;
  entry.Time = this->Time;
}

//------------------------------------------------------------------------------
void vtkShadowMeasuredErrors::Refuse(
  const vtkshadows::ShadowSetting& setting, const Circumstances& now)
{
  const std::size_t place = this->Place(setting, now);
  if (place < this->Entries.size())
  {
    this->Entries[place].WasRefused = true;
  }
}

void vtkShadowMeasuredErrors::ForgiveAll()
{
  for (Entry& entry : this->Entries)
  {
    entry.WasRefused = false;
  }
}

void vtkShadowMeasuredErrors::KeepOnly(const std::vector<const vtkLight*>& lights)
{
  this->Entries.erase(
    std::remove_if(this->Entries.begin(), this->Entries.end(),
      [&](const Entry& entry)
      { return std::find(lights.begin(), lights.end(), entry.Then.Source) == lights.end(); }),
    this->Entries.end());
}
