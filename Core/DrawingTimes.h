// How long settings draw, told from what others took: at least, so that what is slow with few
// samples need not be tried with many; and about, so that what is soon drawn is tried first. Plain
// C++, no VTK, no OpenGL.
#ifndef vtkshadows_DrawingTimes_h
#define vtkshadows_DrawingTimes_h

#include "TechniqueChoice.h"

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace vtkshadows
{

// Seconds for one light, without what the frame takes beside it.
class DrawingTimes
{
public:
  // What a setting makes in every frame anew took so long, without what it makes once.
  void Note(const ShadowSetting& setting, double seconds);
  // Nothing, if no setting was noted that this one draws at least as much as (IsNoFaster). Of two
  // that differ from it by their samples alone the rise goes on.
  std::optional<double> AtLeast(const ShadowSetting& setting) const;
  // About, by what is expected beforehand, in any unit: the time of the setting that differs by its
  // samples alone, else by its texels, and is nearest in cost, times how much more is expected;
  // where there is none, what the middle one of all took for its cost. Nothing, if nothing was
  // noted.
  std::optional<double> About(
    const ShadowSetting& setting, const std::function<double(const ShadowSetting&)>& costOf) const;
  void Forget() { this->Known.clear(); }

private:
  std::vector<std::pair<ShadowSetting, double>> Known;
};

}

#endif
