// Sample lights that stand for an area light: their mean visibility is its visibility.
#ifndef vtkshadows_LightSamples_h
#define vtkshadows_LightSamples_h

#include "ShadowLight.h"

#include <vector>

namespace vtkshadows
{

// `count` lights (at least 1) of radius 0 spread evenly over the disc of `light`, which faces along
// `light.direction`; a point light's disc faces `towardWC`. A light with radius 0 gives one sample,
// itself. Deterministic. Vogel's sunflower spiral (Vogel 1979): radius sqrt((i+0.5)/n), golden
// angle.
std::vector<ShadowLight> SampleAreaLight(
  const ShadowLight& light, int count, const glm::dvec3& towardWC);

}

#endif
