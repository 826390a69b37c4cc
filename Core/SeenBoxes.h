// What the eye sees of boxes: of the bounds of what casts or receives. All in world coordinates and
// double; each answer errs on the side of seeing more.
#ifndef vtkshadows_SeenBoxes_h
#define vtkshadows_SeenBoxes_h

#include "LightView.h" // for BoxCorners

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace vtkshadows
{

struct Box
{
  glm::dvec3 minimum{ 0.0 }, maximum{ 0.0 };
  bool isEmpty = true;
  template <typename Points>
  void Add(const Points& points)
  {
    for (const glm::dvec3& p : points)
    {
      this->AddPoint(p);
    }
  }
  void AddPoint(const glm::dvec3& p);
  double Diagonal() const { return glm::distance(this->minimum, this->maximum); }
  BoxCorners Corners() const;
  // The box grown on every side.
  Box Grown(double margin) const;
  bool Holds(const glm::dvec3& p) const;
};

// Its six sides, each as its corners in their order around it.
std::array<std::vector<glm::dvec3>, 6> FacesOf(const BoxCorners& box);

// Leaves the part of a convex polygon where plane.x >= 0 (Sutherland and Hodgman 1974).
void ClipPolygon(std::vector<glm::dvec3>& polygon, const glm::dvec4& plane);

// Where plane.x >= 0 for all of these is seen: the four sides of the view, its near and far plane.
std::array<glm::dvec4, 6> ViewPlanes(const glm::dmat4& clipFromWorld);
constexpr std::size_t SidePlanes = 4; // the first of them

// What the eye sees of its near plane.
std::array<glm::dvec3, 4> NearQuad(const glm::dmat4& clipFromWorld);

// The corners of what of the boxes lies within the four sides of the view.
std::vector<glm::dvec3> SeenCorners(
  const glm::dmat4& clipFromWorld, const std::vector<BoxCorners>& boxes);

// Whether a place in one of the boxes that lies within the four sides of the eye's view can lie
// within the four sides of `face`, a view from a light in their midst.
bool FaceMayBeSeen(
  const glm::dmat4& clipFromWorld, const std::vector<BoxCorners>& receivers, const LightView& face);

// Whether the near plane, or the far plane, can cut away a part of the box that the eye would see
// otherwise.
bool NearPlaneMayCut(const glm::dmat4& clipFromWorld, const BoxCorners& box);
bool FarPlaneMayCut(const glm::dmat4& clipFromWorld, const BoxCorners& box);

// How far before the eye, along its axis, what it sees of the boxes begins and ends, within the
// near and far plane of its projection; that whole range if it sees none. The tighter, the finer
// are the steps of a depth buffer.
struct DepthRange
{
  double nearest = 0.0, farthest = 0.0;
};
DepthRange SeenDepths(const glm::dmat4& clipFromView, const glm::dmat4& viewFromWorld,
  const std::vector<BoxCorners>& boxes);

// The same projection with other near and far planes.
glm::dmat4 WithDepthRange(glm::dmat4 clipFromView, const DepthRange& range);

// With its near plane, and its far plane at infinity (Everitt and Kilgard 2002). Not of a parallel
// one.
glm::dmat4 WithInfiniteFarPlane(glm::dmat4 clipFromView);

}

#endif
