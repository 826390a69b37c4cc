// The shadow of a mesh on a plane, as polygons in the plane: each casting triangle thrown on it.
// What casts lies between the plane and the light. The rest is cut away in homogeneous coordinates,
// ahead of the division, so that nothing beneath the plane or beyond the light casts (no
// anti-shadow). All in double, relative to the middle of the mesh.
//
// A light is a homogeneous vector: (position, 1), or (the unit direction toward it, 0).
//
// @par Reference: J. Blinn: Me and my (fake) shadow, IEEE CG&A 8(1), 1988; I. Sutherland,
// G. Hodgman: Reentrant polygon clipping, Communications of the ACM 17(1), 1974.
#ifndef vtkshadows_PlanarShadow_h
#define vtkshadows_PlanarShadow_h

#include "PolygonUnion.h"
#include "ShadowReach.h"
#include "ShadowVolume.h"

namespace vtkshadows
{

// Coordinates in a plane, with the light above it.
struct PlaneFrame
{
  glm::dvec3 origin{ 0.0 };           // beneath the middle of the mesh
  glm::dvec3 along{ 1.0, 0.0, 0.0 };  // unit; the way that shadows grow long
  glm::dvec3 across{ 0.0, 1.0, 0.0 }; // unit
  glm::dvec3 normal{ 0.0, 0.0, 1.0 }; // unit, along x across, to the light's side

  glm::dvec3 ToWorld(const glm::dvec2& p) const
  {
    return this->origin + p.x * this->along + p.y * this->across;
  }
};

struct PlanarShadow
{
  PlaneFrame frame;
  // In the frame; counter-clockwise seen from the light's side, convex, at least three corners,
  // in the order of the triangles that the mesh was made of if it has `originals`.
  PolygonSet polygons;
  std::vector<std::uint32_t> originals; // of each of its points: the mesh's point, or NoPoint where
                                        // a side was cut. A cut point belongs to one polygon.
  std::vector<std::uint32_t> triangles; // of each polygon: the mesh's triangle

  bool isLightInPlane = false; // then there are no polygons
  bool isUnbounded = false;    // a caster reaches up to the light, or into the last millionth of
                               // the way from the plane to it
  bool isCut = false;          // `bounds` cut something away
  Box bounds;                  // what the shadow was cut to; empty if to nothing
};

// Triangles with a sign of 0 do not cast; those whose shadow is thinner than its rounding are
// dropped. The plane is given by a point and a normal of any length but 0, on either side. A light
// nearer to the plane than rounding can tell (1e-12 of its distance, or of the sine) is in it.
//
// `bounds` in world coordinates: the shadow is cut to it. A face of it that is parallel to the
// plane cuts nothing, or all. Empty: the shadow is left whole, unless it is unbounded. Then it is
// cut to the bounds of the mesh and of what of mesh and light lies straight beneath on the plane,
// grown on every side by ReachOfUnbounded times their diagonal.
constexpr double ReachOfUnbounded = 1000.0;
PlanarShadow ThrowOnPlane(const ShadowMesh<double>& mesh, const std::vector<CastSign>& signs,
  const glm::dvec4& light, const glm::dvec3& planePoint, const glm::dvec3& planeNormal,
  const Box& bounds = {});

}

#endif
