// One view of a light: the frustum (spot, point) or box (directional) from which its casters are
// drawn into a map. Fitted in double, so that only what can cast on something fills the map.
#ifndef vtkshadows_LightView_h
#define vtkshadows_LightView_h

#include "ShadowLight.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <string>
#include <vector>

namespace vtkshadows
{

// The eight world-space corners of a box of any orientation.
using BoxCorners = std::array<glm::dvec3, 8>;

struct LightView
{
  glm::dmat4 viewFromWorld{ 1.0 }; // rigid; the light looks along -z
  glm::dmat4 clipFromView{ 1.0 };  // OpenGL clip space, z in -w..w
  bool parallel = true;            // directional
};

// The rigid view from `eyeWC` along the unit vector `forward`, turned about it in a fixed way.
glm::dmat4 ViewAlong(const glm::dvec3& forward, const glm::dvec3& eyeWC);

enum class LightViewFit
{
  Fitted, // `view` covers every caster that can shadow a receiver
  Empty,  // no caster can shadow a receiver: the light needs no map
  Refused // one view cannot hold this light; `reason` says why
};

struct LightViewResult
{
  LightViewFit fit = LightViewFit::Empty;
  LightView view;
  std::string reason;
};

// Fit one view of `light` around the part of `casters` that can throw a shadow on `receivers`.
// The map's sides lie `margin` (share of its longer side, e.g. 2 texels / resolution) outside it.
// The depth range is that of the casters alone: a receiver beyond it is behind every caster, one
// before it is before every caster, and both compare rightly without being inside.
// Precondition: corners are finite.
LightViewResult FitLightView(const ShadowLight& light, const std::vector<BoxCorners>& casters,
  const std::vector<BoxCorners>& receivers, double margin);

}

#endif
