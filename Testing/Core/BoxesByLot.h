// Boxes, views and lights, drawn by lot or plain, for the tests of what is told from bounds.
#ifndef vtkshadows_BoxesByLot_h
#define vtkshadows_BoxesByLot_h

#include "Lot.h"
#include "SeenBoxes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace coretest
{

using vtkshadows::Box;
using vtkshadows::BoxCorners;

// A box of any orientation: centre + axes * (-1..1)^3.
struct Solid
{
  glm::dvec3 centre{ 0.0 };
  glm::dmat3 axes{ 1.0 };

  glm::dvec3 At(const glm::dvec3& t) const { return this->centre + this->axes * t; }
  BoxCorners Corners() const
  {
    BoxCorners corners;
    for (int i = 0; i < 8; ++i)
    {
      corners[i] = this->At({ i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1 });
    }
    return corners;
  }
};

inline Solid Upright(const glm::dvec3& centre, const glm::dvec3& half)
{
  Solid solid;
  solid.centre = centre;
  solid.axes = glm::dmat3(half.x, 0, 0, 0, half.y, 0, 0, 0, half.z);
  return solid;
}

inline BoxCorners CornersOf(const glm::dvec3& centre, double half)
{
  return Upright(centre, glm::dvec3(half)).Corners();
}

inline Box BoxOf(const BoxCorners& corners)
{
  Box box;
  box.Add(corners);
  return box;
}

// How a scene drawn by lot is seen.
struct View
{
  glm::dmat4 clipFromView{ 1.0 }, viewFromWorld{ 1.0 };
  glm::dvec4 eye{ 0.0 }; // as EyeMayBeShadowed wants it
  double nearPlane = 0.0, farPlane = 0.0;
  glm::dmat4 ClipFromWorld() const { return this->clipFromView * this->viewFromWorld; }
};

inline View LookFrom(const glm::dvec3& position, const glm::dvec3& focus, bool parallel,
  double nearPlane = 0.5, double farPlane = 30.0, double size = 1.0)
{
  View view;
  view.nearPlane = nearPlane;
  view.farPlane = farPlane;
  view.viewFromWorld = glm::lookAt(position, focus, glm::dvec3(0.1, 0.2, 1.0));
  view.clipFromView = parallel
    ? glm::ortho(-1.3 * size, 1.3 * size, -size, size, nearPlane, farPlane)
    : glm::perspective(2.0 * std::atan(0.4 * size), 1.3, nearPlane, farPlane);
  view.eye = parallel ? glm::dvec4(glm::normalize(position - focus), 0.0) : glm::dvec4(position, 1);
  return view;
}

inline bool IsInView(const glm::dvec4& clip)
{
  return clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w &&
    std::abs(clip.z) <= clip.w;
}

class Lot : public testinglot::Lot
{
public:
  using testinglot::Lot::Lot;

  bool Flip() { return this->Any(0.0, 1.0) < 0.5; }
  glm::dvec3 Within(double half)
  {
    const double x = this->Any(-half, half), y = this->Any(-half, half);
    return { x, y, this->Any(-half, half) };
  }
  glm::dvec3 Direction() { return glm::normalize(this->Within(1.0) + glm::dvec3(1.0e-9)); }
  Solid AnySolid(double reach = 3.0)
  {
    const glm::dvec3 centre = this->Within(reach);
    const double x = this->Any(0.05, 1.2), y = this->Any(0.05, 1.2);
    Solid solid = Upright(centre, { x, y, this->Any(0.05, 1.2) });
    if (this->Flip())
    {
      solid.axes =
        glm::dmat3(glm::rotate(glm::dmat4(1.0), this->Any(0.0, 3.0), this->Direction())) *
        solid.axes;
    }
    return solid;
  }
  glm::dvec4 AnyLight()
  {
    return this->Flip() ? glm::dvec4(this->Direction(), 0.0) : glm::dvec4(this->Within(6.0), 1.0);
  }
  View AnyView()
  {
    const glm::dvec3 position = this->Within(5.0);
    const bool parallel = this->Flip();
    const double nearPlane = this->Any(0.05, 2.0);
    return LookFrom(position, this->Within(2.0), parallel, nearPlane, nearPlane + this->Any(1, 20),
      this->Any(0.2, 3.0));
  }
  // In the shadow of the caster, or in the caster.
  glm::dvec3 InShadow(const Solid& caster, const glm::dvec4& light)
  {
    const glm::dvec3 p = caster.At(this->Within(1.0));
    const glm::dvec3 along = glm::normalize(p * light.w - glm::dvec3(light));
    return p + along * std::pow(10.0, this->Any(-2.0, 1.3));
  }
};

constexpr int Scenes = 2000;
constexpr int Samples = 60;

}

#endif
