// The views of a light: the frustum (spot, point) or box (directional) from which its casters are
// drawn into a map, or up to six frusta, one a face of a cube around the light. Fitted in double,
// so that only what can cast on something fills the map.
#ifndef vtkshadows_LightView_h
#define vtkshadows_LightView_h

#include "ShadowLight.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace vtkshadows
{

// The eight world-space corners of a box of any orientation; bit k of the index tells the side
// along the box's axis k.
using BoxCorners = std::array<glm::dvec3, 8>;

struct LightView
{
  glm::dmat4 viewFromWorld{ 1.0 }; // rigid; the light looks along -z
  glm::dmat4 clipFromView{ 1.0 };  // OpenGL clip space, z in -w..w
  bool parallel = true;            // directional
  // Its map has as many texels on its shorter side as on its longer one; else texels are square.
  bool fillsMap = false;
};

// The rigid view from `eyeWC` along the unit vector `forward`, turned about it in a fixed way.
glm::dmat4 ViewAlong(const glm::dvec3& forward, const glm::dvec3& eyeWC);

enum class LightViewFit
{
  Fitted, // `view` covers every caster that can shadow a receiver
  Empty,  // no caster can shadow a receiver: the light needs no map
  Refused // one view cannot hold this light, since it stands amid its casters
};

struct LightViewResult
{
  LightViewFit fit = LightViewFit::Empty;
  LightView view;
};

// Fit one view of `light` around the part of `casters` that can throw a shadow on `receivers`.
// The map's sides lie `margin` (share of its longer side, e.g. 2 texels / resolution) outside it.
// The depth range is that of the casters alone: a receiver beyond it is behind every caster, one
// before it is before every caster, and both compare rightly without being inside.
// Precondition: corners are finite.
LightViewResult FitLightView(const ShadowLight& light, const std::vector<BoxCorners>& casters,
  const std::vector<BoxCorners>& receivers, double margin);

// Whether the sphere around all of the casters lies wholly outside a spot's cone.
bool IsOutsideCone(const ShadowLight& light, const std::vector<BoxCorners>& casters);

// Faces of a cube around a light: 2k looks along its axis k, 2k+1 against it. With p seen from the
// light in the cube's axes, m = p[k], s = p[k+1] and t = p[k+2] (k+1 and k+2 modulo 3), a face sees
// p at depth |m|, at the tangents -s/m to the right and t/|m| up.
constexpr int NoFace = -1;

struct FittedLightView
{
  LightView view;
  int face = NoFace;                // of the cube
  std::vector<std::size_t> casters; // those that lie in it, by their place in the list
};

struct LightViews
{
  bool isCube = false;
  glm::dmat4 cubeFromWorld{ 1.0 }; // the light at the origin; rigid
  std::vector<FittedLightView> views;
};

// As many views as the light needs, none if no caster can shadow a receiver: that of FitLightView
// if there is one, else those faces of a cube in which a caster can shadow a receiver. A face's
// sides lie `margin` outside 45 degrees, its depths are those of its casters within these sides. A
// spot's cube has its first axis along the cone's, a point light's the axes of the world.
LightViews FitLightViews(const ShadowLight& light, const std::vector<BoxCorners>& casters,
  const std::vector<BoxCorners>& receivers, double margin);

}

#endif
