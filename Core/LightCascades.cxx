#include "LightCascades.h"

#include "ShadowReach.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vtkshadows
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

// A cascade is larger than what the eye sees by this share: how far the eye may go or turn before
// the map is drawn again, against how fine its texels are.
constexpr double GuardBand = 0.12;

// Texels are worth a map of their own if they are finer by this factor.
constexpr double WorthwhileGain = 1.5;

// The last cascade follows the eye, and is drawn again with it, where its texels are finer than
// those of the view of all casters by this factor, as the root of their areas' ratio.
constexpr double GainByFollowing = 1.2;

// What rounding changes in the size of a texel, and far less than a texel over a map.
constexpr double SameTexel = 1.0e-9;

// Fewer texels than these are all margin.
constexpr double FewestTexels = 8.0;

// A texel's shorter side is no shorter, as a share of the longer one.
constexpr double LeastShare = 1.0 / 64.0;

// Of these shares, and of where cascades end, steps to a doubling.
constexpr double StepsOfShares = 8.0;
constexpr double StepsOfEnds = 8.0;

// The practical scheme starts no nearer than this share of where it ends.
constexpr double NearestShare = 1.0 / 700.0;

// The sides of a confined view lie on a grid of this many steps.
constexpr double ConfinementSteps = 16.0;

// Bounds of a box along the light's axes; z is against the light's way.
struct LightBounds
{
  glm::dvec3 low{ Infinity }, high{ -Infinity };
};

LightBounds BoundsIn(const glm::dmat3& lightFromWorld, const BoxCorners& corners)
{
  LightBounds bounds;
  for (const glm::dvec3& corner : corners)
  {
    const glm::dvec3 p = lightFromWorld * corner;
    bounds.low = glm::min(bounds.low, p);
    bounds.high = glm::max(bounds.high, p);
  }
  return bounds;
}

// The eye's place, the axis of the narrowest cone about what it sees, and half of that cone's
// angle.
struct Cone
{
  glm::dvec3 tipWC{ 0.0 };
  glm::dvec3 axisWC{ 0.0, 0.0, -1.0 };
  double angle = 0.0;
  double nearest = 0.0; // distance of the near plane
};

Cone ConeOf(const CascadeEye& eye)
{
  const glm::dmat4 worldFromView = glm::inverse(eye.viewFromWorld);
  const glm::dmat4 viewFromClip = glm::inverse(eye.clipFromView);
  Cone cone;
  cone.tipWC = glm::dvec3(worldFromView[3]) / worldFromView[3].w;
  glm::dvec3 rays[4], sum(0.0);
  cone.nearest = Infinity;
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec4 corner =
      viewFromClip * glm::dvec4(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, -1.0, 1.0);
    const glm::dvec3 cornerVC = glm::dvec3(corner) / corner.w;
    rays[i] = glm::normalize(glm::dmat3(worldFromView) * cornerVC);
    sum += rays[i];
    const glm::dvec3 axisPointVC(0.0, 0.0, cornerVC.z);
    cone.nearest = std::min(cone.nearest, glm::length(glm::dmat3(worldFromView) * axisPointVC));
  }
  cone.axisWC = glm::normalize(sum);
  for (const glm::dvec3& ray : rays)
  {
    cone.angle = std::max(cone.angle, std::acos(glm::clamp(glm::dot(ray, cone.axisWC), -1.0, 1.0)));
  }
  return cone;
}

// Of the boxes, of any orientation: the nearest and farthest distance from `p`; of the nearest, a
// lower bound.
void DistancesFrom(
  const glm::dvec3& p, const std::vector<BoxCorners>& boxes, double& nearest, double& farthest)
{
  nearest = Infinity;
  farthest = 0.0;
  for (const BoxCorners& corners : boxes)
  {
    Box box;
    box.Add(corners);
    nearest = std::min(nearest, glm::distance(p, glm::clamp(p, box.minimum, box.maximum)));
    for (const glm::dvec3& corner : corners)
    {
      farthest = std::max(farthest, glm::distance(p, corner));
    }
  }
}

// Of steps by two, or of so many to a doubling: what is made from them stays while the eye or a
// receiver moves a little. No step is a round number, which rounding would put now on this side of
// it and now on that.
constexpr double StepOffset = 0.4;
double StepBelow(double x)
{
  return std::exp2(std::floor(std::log2(x) - StepOffset) + StepOffset);
}
double StepAbove(double x, double perDoubling)
{
  return std::exp2(std::ceil(perDoubling * (std::log2(x) - StepOffset)) / perDoubling + StepOffset);
}

// To a multiple of 2^-24 of itself or less, so that nearly equal eyes mostly have equal texels.
double Rounded(double x)
{
  const double unit = std::ldexp(StepBelow(x), -24);
  return std::ceil(x / unit) * unit;
}

// What receivers can lie in of a ball, along the light's axes across its way; along its way the
// ball's own bounds. One place, where they can lie nowhere in it.
LightBounds BoundsInBall(
  const glm::dmat3& lightFromWorld, const glm::dvec3& centreWC, double radius, const Box& receivers)
{
  const glm::dmat3 worldFromLight = glm::transpose(lightFromWorld);
  const glm::dvec3 centre = lightFromWorld * centreWC;
  const glm::dvec3 low = receivers.minimum - centreWC, high = receivers.maximum - centreWC;
  LightBounds bounds{ centre - radius, centre + radius };
  for (int axis = 0; axis < 2; ++axis)
  {
    const double up = ReachInBall(worldFromLight[axis], radius, low, high);
    const double down = ReachInBall(-worldFromLight[axis], radius, low, high);
    bounds.low[axis] = centre[axis] - (std::isfinite(down) ? down : 0.0);
    bounds.high[axis] = centre[axis] + (std::isfinite(up) ? up : 0.0);
  }
  return bounds;
}

// How long these bounds can be, wherever the ball stands, as shares of its diameter. They are
// longest where it stands amid the receivers: both it and the box are as they are when turned
// about their middles, so that what they share there holds the mean of what they share with the
// ball to one side of it and to the other.
glm::dvec3 SharesOfBall(const glm::dmat3& lightFromWorld, double radius, const Box& receivers)
{
  const glm::dmat3 worldFromLight = glm::transpose(lightFromWorld);
  const glm::dvec3 half = 0.5 * (receivers.maximum - receivers.minimum);
  glm::dvec3 shares(1.0);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double share = ReachInBall(worldFromLight[axis], radius, -half, half) / radius;
    shares[axis] = std::min(StepAbove(std::max(share, LeastShare), StepsOfShares), 1.0);
  }
  return shares;
}

bool AreSame(const glm::dvec3& a, const glm::dvec3& b)
{
  return glm::all(glm::lessThan(glm::abs(a / b - 1.0), glm::dvec3(SameTexel)));
}

// Whether a map of `texels` texels a side holds all of it.
bool Holds(const Cascade& cascade, const LightBounds& bounds, double texels)
{
  const glm::dvec3 centre = cascade.centre * cascade.sides, half = 0.5 * texels * cascade.sides;
  return glm::all(glm::greaterThanEqual(bounds.low, centre - half)) &&
    glm::all(glm::lessThanEqual(bounds.high, centre + half));
}

Cascade WholeScene(const LightView& whole, std::size_t casters, double texel)
{
  Cascade cascade;
  cascade.view = whole;
  // Ground under a low sun is foreshortened along the shorter side.
  cascade.view.fillsMap = true;
  cascade.texel = texel;
  cascade.casters.resize(casters);
  std::iota(cascade.casters.begin(), cascade.casters.end(), std::size_t(0));
  return cascade;
}

// The view of `cascade`, whose texels and centre are known, and who casts in it. Casters before it
// have their depths, those beyond it cast on nothing in it.
void FitBox(Cascade& cascade, const glm::dmat3& lightFromWorld,
  const std::vector<LightBounds>& casters, int resolution)
{
  const glm::dvec3 centre = cascade.centre * cascade.sides;
  const glm::dvec3 half = 0.5 * resolution * cascade.sides;
  const double farthest = half.z - centre.z; // along the light
  double nearDepth = Infinity, farDepth = -Infinity;
  cascade.casters.clear();
  for (std::size_t i = 0; i < casters.size(); ++i)
  {
    const LightBounds& box = casters[i];
    if (box.high.x >= centre.x - half.x && box.low.x <= centre.x + half.x &&
      box.high.y >= centre.y - half.y && box.low.y <= centre.y + half.y && -box.high.z <= farthest)
    {
      cascade.casters.push_back(i);
      nearDepth = std::min(nearDepth, -box.high.z);
      farDepth = std::max(farDepth, -box.low.z);
    }
  }
  farDepth = std::min(farDepth, farthest);
  const double slack = half.z / 1024.0; // so that a flat caster has a depth range, too
  cascade.view.parallel = true;
  cascade.view.fillsMap = true;
  cascade.view.viewFromWorld = glm::dmat4(lightFromWorld);
  cascade.view.viewFromWorld[3] = glm::dvec4(-centre.x, -centre.y, nearDepth - slack, 1.0);
  cascade.view.clipFromView =
    glm::ortho(-half.x, half.x, -half.y, half.y, 0.0, farDepth - nearDepth + 2.0 * slack);
}

}

//------------------------------------------------------------------------------
std::vector<double> CascadeReaches(
  int count, double nearest, double farthest, CascadeScheme scheme, double weight)
{
  const double logarithmic = scheme == CascadeScheme::Logarithmic ? 1.0
    : scheme == CascadeScheme::Uniform                            ? 0.0
                                                                  : weight;
  const double start =
    scheme == CascadeScheme::Practical ? std::max(nearest, NearestShare * farthest) : nearest;
  std::vector<double> reaches;
  for (int i = 1; i <= count; ++i)
  {
    const double share = static_cast<double>(i) / count;
    reaches.push_back(logarithmic * start * std::pow(farthest / start, share) +
      (1.0 - logarithmic) * (start + share * (farthest - start)));
  }
  return reaches;
}

//------------------------------------------------------------------------------
// The ball passes through the rims of the slice's two ends, if its own middle is not nearer than
// the middle of the far rim.
SliceBall BallOfSlice(double nearest, double farthest, double angle)
{
  const double cosine = std::cos(angle);
  SliceBall ball;
  ball.centre = std::min(0.5 * (nearest + farthest) / cosine, farthest * cosine);
  ball.radius = std::sqrt(std::max(
    farthest * farthest + ball.centre * ball.centre - 2.0 * farthest * ball.centre * cosine, 0.0));
  return ball;
}

//------------------------------------------------------------------------------
// By each pair of the box's sides the ball is cut to a slice, in which the farthest place lies on
// the ball, straight along the way or on the rim of the cut.
double ReachInBall(
  const glm::dvec3& way, double radius, const glm::dvec3& low, const glm::dvec3& high)
{
  const glm::dvec3 farthest = glm::max(way * low, way * high);
  double reach = std::min(radius, farthest.x + farthest.y + farthest.z);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double place = glm::clamp(radius * way[axis], low[axis], high[axis]);
    if (!(std::abs(place) <= radius))
    {
      return -Infinity;
    }
    const double beside = std::max(1.0 - way[axis] * way[axis], 0.0);
    reach =
      std::min(reach, way[axis] * place + std::sqrt(beside * (radius * radius - place * place)));
  }
  return reach;
}

//------------------------------------------------------------------------------
LightCascades FitLightCascades(const ShadowLight& light, const LightView& whole,
  const std::vector<BoxCorners>& casters, const std::vector<BoxCorners>& receivers,
  const CascadeEye& eye, const CascadeSettings& settings, int resolution, double margin,
  const LightCascades* before)
{
  LightCascades result;
  result.lightFromWorld = glm::dmat3(whole.viewFromWorld);
  const double wholeTexel =
    2.0 / (std::min(whole.clipFromView[0][0], whole.clipFromView[1][1]) * resolution);
  const bool isParallel = eye.clipFromView[2][3] == 0.0;
  const double texels = resolution - 2.0 * margin;
  const Cone cone = isParallel ? Cone() : ConeOf(eye);
  result.eyeWC = cone.tipWC;
  const auto onlyWhole = [&]() -> LightCascades&
  {
    result.cascades = { WholeScene(whole, casters.size(), wholeTexel) };
    if (isParallel && ConfineView(result.cascades[0].view, receivers, eye, margin / resolution))
    {
      result.cascades[0].casters = CastersIn(result.cascades[0].view, casters);
    }
    return result;
  };
  if (light.kind != LightKind::Directional || isParallel || texels < FewestTexels ||
    !(cone.angle < 1.5))
  {
    return onlyWhole();
  }

  Box everyone;
  for (const BoxCorners& receiver : receivers)
  {
    everyone.Add(receiver);
  }
  const auto texelOf = [&](const SliceBall& ball)
  { return 2.0 * (1.0 + GuardBand) * ball.radius / texels; };
  const auto sidesOf = [&](const SliceBall& ball)
  { return Rounded(texelOf(ball)) * SharesOfBall(result.lightFromWorld, ball.radius, everyone); };
  double nearest = 0.0, farthest = 0.0;
  DistancesFrom(cone.tipWC, receivers, nearest, farthest);
  const double end = std::min(StepAbove(farthest, StepsOfEnds), settings.farthest);
  if (!(end > 0.0) || !std::isfinite(end))
  {
    return onlyWhole();
  }
  nearest = std::max({ nearest, cone.nearest, 1.0e-9 * end });
  const auto reachesTo = [&](double last)
  {
    const int useful = static_cast<int>(std::ceil(
      std::min(std::log(last / std::min(nearest, last)) / std::log(WorthwhileGain), 1.0e3)));
    return CascadeReaches(std::clamp(useful, 1, settings.count), std::min(StepBelow(nearest), last),
      last, settings.scheme, settings.weight);
  };
  const auto ballOf = [&](const std::vector<double>& reaches, std::size_t i)
  {
    const double from = i == 0 ? 0.0 : reaches[i - 1] * (1.0 - settings.blend);
    return BallOfSlice(from, reaches[i], cone.angle);
  };

  // The last one follows the eye, too, if that makes its texels worth it. Else cascades go as far
  // as they pay: beyond that the view of the whole scene has finer texels, or there is nothing.
  std::vector<double> reaches = reachesTo(end);
  const glm::dvec3 lastSides = sidesOf(ballOf(reaches, reaches.size() - 1));
  const glm::dvec2 wholeSides = 2.0 /
    (static_cast<double>(resolution) *
      glm::dvec2(whole.clipFromView[0][0], whole.clipFromView[1][1]));
  const bool endsInWhole =
    wholeSides.x * wholeSides.y < GainByFollowing * GainByFollowing * lastSides.x * lastSides.y;
  if (endsInWhole)
  {
    // Where both are as fine.
    const double last = std::min(wholeTexel / texelOf(BallOfSlice(0.0, 1.0, cone.angle)), end);
    if (!(last >= WorthwhileGain * nearest))
    {
      return onlyWhole();
    }
    reaches = reachesTo(last);
  }
  const int count = static_cast<int>(reaches.size());
  if (count == 1 && endsInWhole)
  {
    return onlyWhole();
  }

  std::vector<LightBounds> bounds;
  for (const BoxCorners& caster : casters)
  {
    bounds.push_back(BoundsIn(result.lightFromWorld, caster));
  }
  for (int i = 0; i < count; ++i)
  {
    if (i == count - 1 && endsInWhole)
    {
      result.cascades.push_back(WholeScene(whole, casters.size(), wholeTexel));
      break;
    }
    const SliceBall ball = ballOf(reaches, i);
    Cascade cascade;
    cascade.followsEye = true;
    cascade.sides = sidesOf(ball);
    cascade.reach = i == count - 1 ? Infinity : reaches[i];
    const LightBounds held = BoundsInBall(
      result.lightFromWorld, cone.tipWC + ball.centre * cone.axisWC, ball.radius, everyone);
    const Cascade* kept = before && before->lightFromWorld == result.lightFromWorld &&
        static_cast<std::size_t>(i) < before->cascades.size()
      ? &before->cascades[i]
      : nullptr;
    const bool isSameSize = kept && kept->followsEye && AreSame(kept->sides, cascade.sides);
    cascade.sides = isSameSize ? kept->sides : cascade.sides;
    cascade.texel = std::max(cascade.sides.x, cascade.sides.y);
    cascade.centre = isSameSize && Holds(*kept, held, texels)
      ? kept->centre
      : glm::floor(0.5 * (held.low + held.high) / cascade.sides + 0.5);
    FitBox(cascade, result.lightFromWorld, bounds, resolution);
    result.cascades.push_back(cascade);
  }
  return result;
}

//------------------------------------------------------------------------------
bool ConfineView(
  LightView& view, const std::vector<BoxCorners>& receivers, const CascadeEye& eye, double margin)
{
  const glm::dmat4 clipFromWorld = view.clipFromView * view.viewFromWorld;
  glm::dvec2 low(1.0), high(-1.0);
  const std::vector<glm::dvec3> seen = SeenCorners(eye.clipFromView * eye.viewFromWorld, receivers);
  for (const glm::dvec3& p : seen)
  {
    const glm::dvec4 clip = clipFromWorld * glm::dvec4(p, 1.0);
    if (!(clip.w > 0.0))
    {
      return false; // beside or behind the light, which tells nothing of its sides
    }
    low = glm::min(low, glm::dvec2(clip) / clip.w);
    high = glm::max(high, glm::dvec2(clip) / clip.w);
  }
  // Shares of the view's sides, 0 to 1, the margin's texels among them.
  const double room = 2.0 * margin;
  low = glm::floor(ConfinementSteps * (0.5 * glm::max(low, -1.0) + 0.5 - room)) / ConfinementSteps;
  high = glm::ceil(ConfinementSteps * (0.5 * glm::min(high, 1.0) + 0.5 + room)) / ConfinementSteps;
  low = glm::max(low, 0.0);
  high = glm::min(high, 1.0);
  if (seen.empty() || low.x >= high.x || low.y >= high.y)
  {
    return false;
  }
  // Texels are square: the longer side tells their size.
  const glm::dvec2 sides(1.0 / view.clipFromView[0][0], 1.0 / view.clipFromView[1][1]);
  const glm::dvec2 confined = sides * (high - low);
  if (std::max(confined.x, confined.y) >= std::max(sides.x, sides.y))
  {
    return false;
  }
  const glm::dvec2 scale = 1.0 / (high - low);
  const glm::dvec2 middle = low + high - 1.0; // -1 to 1
  glm::dmat4 part(1.0);
  part[0][0] = scale.x;
  part[1][1] = scale.y;
  part[3][0] = -scale.x * middle.x;
  part[3][1] = -scale.y * middle.y;
  view.clipFromView = part * view.clipFromView;
  return true;
}

//------------------------------------------------------------------------------
std::vector<std::size_t> CastersIn(const LightView& view, const std::vector<BoxCorners>& casters)
{
  const glm::dmat4 clipFromWorld = view.clipFromView * view.viewFromWorld;
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < casters.size(); ++i)
  {
    // Beyond one side with all its corners: -x, x, -y, y, z.
    bool isBeyond[5] = { true, true, true, true, true };
    for (const glm::dvec3& corner : casters[i])
    {
      const glm::dvec4 p = clipFromWorld * glm::dvec4(corner, 1.0);
      isBeyond[0] = isBeyond[0] && p.x < -p.w;
      isBeyond[1] = isBeyond[1] && p.x > p.w;
      isBeyond[2] = isBeyond[2] && p.y < -p.w;
      isBeyond[3] = isBeyond[3] && p.y > p.w;
      isBeyond[4] = isBeyond[4] && p.z > p.w;
    }
    if (std::none_of(std::begin(isBeyond), std::end(isBeyond), [](bool beyond) { return beyond; }))
    {
      inside.push_back(i);
    }
  }
  return inside;
}

}
