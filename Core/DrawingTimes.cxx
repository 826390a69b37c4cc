#include "DrawingTimes.h"

#include "ShadowCandidates.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace vtkshadows
{
namespace
{

bool DifferBySamples(ShadowSetting a, const ShadowSetting& b)
{
  a.samples = b.samples;
  return a == b;
}

bool DifferByTexels(ShadowSetting a, const ShadowSetting& b)
{
  const bool areMaps = a.resolution > 0 && b.resolution > 0;
  a.resolution = b.resolution;
  return areMaps && a == b;
}

}

//------------------------------------------------------------------------------
void DrawingTimes::Note(const ShadowSetting& setting, double seconds)
{
  const auto known = std::find_if(this->Known.begin(), this->Known.end(),
    [&](const auto& entry) { return entry.first == setting; });
  if (known != this->Known.end())
  {
    known->second = seconds;
    return;
  }
  this->Known.emplace_back(setting, seconds);
}

//------------------------------------------------------------------------------
std::optional<double> DrawingTimes::AtLeast(const ShadowSetting& setting) const
{
  std::optional<double> least;
  std::vector<std::pair<int, double>> rise; // by samples, fewer than the setting's
  for (const auto& [known, seconds] : this->Known)
  {
    if (known == setting)
    {
      return seconds;
    }
    if (IsNoFaster(setting, known, true))
    {
      least = std::max(least.value_or(0.0), seconds);
    }
    if (DifferBySamples(known, setting) && known.samples < setting.samples)
    {
      rise.emplace_back(known.samples, seconds);
    }
  }
  if (rise.size() >= 2)
  {
    std::sort(rise.begin(), rise.end());
    const auto [fewer, less] = rise[rise.size() - 2];
    const auto [more, last] = rise.back();
    least = std::max(
      *least, last + (last - less) / (more - fewer) * static_cast<double>(setting.samples - more));
  }
  return least;
}

//------------------------------------------------------------------------------
std::optional<double> DrawingTimes::About(
  const ShadowSetting& setting, const std::function<double(const ShadowSetting&)>& costOf) const
{
  if (this->Known.empty())
  {
    return std::nullopt;
  }
  using Entry = std::pair<ShadowSetting, double>;
  const double cost = costOf(setting);
  const auto rateOf = [&](const Entry& entry) { return entry.second / costOf(entry.first); };
  const auto distanceOf = [&](const Entry& entry)
  { return std::abs(std::log(costOf(entry.first) / cost)); };
  for (const auto differ : { DifferBySamples, DifferByTexels })
  {
    const Entry* nearest = nullptr;
    for (const Entry& entry : this->Known)
    {
      if (differ(entry.first, setting) && (!nearest || distanceOf(entry) < distanceOf(*nearest)))
      {
        nearest = &entry;
      }
    }
    if (nearest)
    {
      return cost * rateOf(*nearest);
    }
  }
  std::vector<double> rates;
  std::transform(this->Known.begin(), this->Known.end(), std::back_inserter(rates), rateOf);
  const auto middle = rates.begin() + static_cast<std::ptrdiff_t>(rates.size() / 2);
  std::nth_element(rates.begin(), middle, rates.end());
  return cost * *middle;
}

}
