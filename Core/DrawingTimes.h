// How long settings draw at least, told from what smaller ones took: what is slow with few samples
// need not be tried with many. Plain C++, no VTK, no OpenGL.
#ifndef vtkshadows_DrawingTimes_h
#define vtkshadows_DrawingTimes_h

#include "TechniqueChoice.h"

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
  void Forget() { this->Known.clear(); }

private:
  std::vector<std::pair<ShadowSetting, double>> Known;
};

}

#endif
