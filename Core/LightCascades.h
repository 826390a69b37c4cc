// Cascades of a directional light: several views, each around what the eye sees up to some
// distance, so that the light's texels are fine where the screen's pixels are (Engel 2006; Zhang,
// Sun, Xu and Lun 2006). World space and double.
//
// What changes with the eye is kept apart from what shadows depend on. A receiver belongs to a
// cascade by its distance from the eye, which does not change while the eye turns. A cascade's
// texels have one size and one orientation, that of the light, and lie on a grid fixed in the world
// (Valient 2008), so that its map can follow the eye by whole texels. It is larger than what the
// eye sees by a guard band, and follows only when that is used up: until then its map stays as it
// is. What the eye sees is a ball, cut by the bounds of what receives: under a low sun ground is
// foreshortened, and a texel has one side longer than the other.
#ifndef vtkshadows_LightCascades_h
#define vtkshadows_LightCascades_h

#include "LightView.h"

#include <limits>

namespace vtkshadows
{

enum class CascadeScheme
{
  Practical,   // Uniform and Logarithmic, blended by a weight (Zhang et al. 2006)
  Logarithmic, // each cascade reaches as many times as far as the one before it
  Uniform      // each reaches farther by the same distance
};

constexpr int MostCascades = 8;

struct CascadeSettings
{
  int count = 1; // at most; 1 to MostCascades
  CascadeScheme scheme = CascadeScheme::Practical;
  double weight = 1.0; // of the logarithmic scheme in the practical one, 0 to 1
  double blend = 0.1;  // share of a cascade's reach over which it blends into the next, 0 to 1
  // Beyond this distance from the eye nothing is in shadow, whatever casts: above 0.
  double farthest = std::numeric_limits<double>::infinity();
};

// What the eye sees: OpenGL clip space, z in -w..w.
struct CascadeEye
{
  glm::dmat4 viewFromWorld{ 1.0 };
  glm::dmat4 clipFromView{ 1.0 };
};

struct Cascade
{
  LightView view;
  double reach = std::numeric_limits<double>::infinity(); // distance from the eye that it ends at
  bool followsEye = false;                                // else it is the view of all casters
  double texel = 0.0;                                     // its longer side, world units
  // Of one that follows the eye: a texel's sides along the light's axes, the third a step of depth;
  // and what it stands around, in these.
  glm::dvec3 sides{ 1.0 };
  glm::dvec3 centre{ 0.0 };
  std::vector<std::size_t> casters; // those that lie in it, by their place in the list
};

struct LightCascades
{
  glm::dvec3 eyeWC{ 0.0 };          // distances are from here
  glm::dmat3 lightFromWorld{ 1.0 }; // rotation; every view's axes
  std::vector<Cascade> cascades;    // nearest first, the last without an end; none: no shadow
};

// Distances from the eye at which `count` cascades end, from `nearest` to `farthest`, both above 0.
// The practical scheme starts no nearer than a 700th of `farthest`: what little lies nearer has the
// first cascade, too.
std::vector<double> CascadeReaches(
  int count, double nearest, double farthest, CascadeScheme scheme, double weight);

// The ball around all that lies within `angle` (radians, below a quarter turn) of an axis, at a
// distance from `nearest` to `farthest` from its start.
struct SliceBall
{
  double centre = 0.0; // distance along the axis
  double radius = 0.0;
};
SliceBall BallOfSlice(double nearest, double farthest, double angle);

// How far along the unit vector `way` from the middle of a ball lies what is both in it and in a
// box, whose corners are seen from there. An upper bound: the least that the box, and each pair of
// its sides with the ball, allow. Minus infinity, if they are seen not to meet.
double ReachInBall(
  const glm::dvec3& way, double radius, const glm::dvec3& low, const glm::dvec3& high);

// Fit cascades of `light` (directional) for maps of `resolution` texels a side, of which `margin`
// stay free on each side. `whole` is the view that FitLightView gives for the same light and boxes:
// it serves from where on a cascade's texels would be no finer, and then does not follow the eye.
// Only so many cascades are made as make texels finer by a half. `before`: those of the frame
// before, or nullptr; a cascade that still holds what it must stays as it was. A parallel eye sees
// everything at one scale: it has one view, by ConfineView.
LightCascades FitLightCascades(const ShadowLight& light, const LightView& whole,
  const std::vector<BoxCorners>& casters, const std::vector<BoxCorners>& receivers,
  const CascadeEye& eye, const CascadeSettings& settings, int resolution, double margin,
  const LightCascades* before);

// The part of `view` that holds what of the receivers lies in the eye's view, its sides on a grid
// of sixteenths of the view's own, so that it seldom changes while the eye moves. `margin`: share
// of the longer side that stays free beyond it. false, and `view` as it was, if the eye sees none
// of them, or so much that texels would not become finer.
bool ConfineView(
  LightView& view, const std::vector<BoxCorners>& receivers, const CascadeEye& eye, double margin);

// The casters that reach into the rectangle of `view`, before its far plane.
std::vector<std::size_t> CastersIn(const LightView& view, const std::vector<BoxCorners>& casters);

}

#endif
