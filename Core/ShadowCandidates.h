// The settings that are considered for lights, which of them need not be tried beside others, and
// what each is expected to cost. Plain C++, no VTK, no OpenGL.
#ifndef vtkshadows_ShadowCandidates_h
#define vtkshadows_ShadowCandidates_h

#include "TechniqueChoice.h"

#include <vector>

namespace vtkshadows
{

// As the passes have them by themselves: where nothing can be measured, no coarser ones are taken.
constexpr int UsualMapTexels = 2048;
constexpr int UsualMapSamples = 64;
constexpr int UsualPlanarSamples = 64;
constexpr int UsualPlanarTexels = 2048;
constexpr int UsualVolumeSamples = 32;
constexpr int UsualRaySamples = 64;

// More than any setting that is tried has: of the truth of a light with a radius.
constexpr int TruthSamples = 256;

struct CandidateScope
{
  bool anyHard = true;
  bool anySoft = false;     // lights with a radius
  bool anyCascaded = false; // what receives reaches far from the eye
  bool anyTextured = false; // planes may keep textures: nothing but the camera moves
};

// All that may serve some light of the scene, of maps those of every kind from the coarsest on.
std::vector<ShadowSetting> CandidateSettings(const CandidateScope& scope, const SceneNeeds& scene);

// Whether a setting draws at least as much as another, by as much work a pixel: if that one is
// right, this one need not be tried. `lightsMove`: maps are drawn in each frame, those of the
// filter "exact" from a list of all triangles, in one go, which for many props takes half as long.
bool IsNoFaster(const ShadowSetting& setting, const ShadowSetting& than, bool lightsMove = false);

// For one light, in frames without shadows: for the order of trials, and until times are known.
// A camera that moves draws no map again; a light that moves does.
double ExpectedCost(
  const ShadowSetting& setting, const SceneNeeds& scene, const LightNeeds& light, bool lightsMove);

}

#endif
