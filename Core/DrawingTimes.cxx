#include "DrawingTimes.h"

#include "ShadowCandidates.h"

#include <algorithm>

namespace vtkshadows
{
namespace
{

bool DifferBySamples(ShadowSetting a, const ShadowSetting& b)
{
  a.samples = b.samples;
  return a == b;
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

}
