// A mesh's triangles as one light sees them, each with what lies beyond its sides: what a lookup
// needs that walks over a surface from one triangle to the next.
#ifndef vtkshadows_LightTriangles_h
#define vtkshadows_LightTriangles_h

#include "ShadowMesh.h"
#include "ShadowVolume.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkshadows
{

// Of a triangle, for the side from its corner k to the next: the triangle beyond it, with the bit
// RunsAlike if that has the side in the same direction; NoTriangle at a border, and where more than
// two triangles meet.
using TriangleNeighbours = std::array<std::uint32_t, 3>;
constexpr std::uint32_t NoTriangle = 0xffffffffu;

// On all cores. Soup that was set apart has no neighbours, and no entries.
std::vector<TriangleNeighbours> FindNeighbours(
  const EdgeTable& edges, std::size_t numberOfTriangles);

// Numbers that a float holds.
constexpr std::uint32_t MostLightTriangles = (1u << 24) - 1;

// A corner of a triangle in the light's space.
struct LightCorner
{
  glm::vec3 position{ 0.0f };
  // Number of the triangle beyond the side from here to the next corner, at most
  // MostLightTriangles; 0: none, or it is folded back, as it is at a silhouette.
  float beyond = 0.0f;
};

// Lists the triangles of a mesh that cast, in two steps, so that they are written where they will
// stay. Each runs counter-clockwise seen from the light. Of closed pieces around which the light
// is not, only what faces it is listed. Mesh, neighbours and order must outlive it.
class LightTriangles
{
public:
  // The light is homogeneous, in the mesh's own coordinates. lightFromMesh: to the light's
  // space, projective if need be (every point then has w > 0); `mirrored`: what is
  // counter-clockwise in the mesh is clockwise in the world.
  // `order`: indices of all triangles, as they are to be listed; empty: as they are in the mesh.
  LightTriangles(const ShadowMesh<float>& mesh, const std::vector<TriangleNeighbours>& neighbours,
    const glm::dmat4& lightFromMesh, const glm::dvec4& light, bool mirrored,
    const std::vector<std::uint32_t>& order);

  std::size_t Count() const { return this->NumberListed; }
  // Of `count` triangles of the order, from the one at `first` on.
  std::size_t CountOf(std::size_t first, std::size_t count) const;

  // Three corners for each; the first triangle's number is `first`, and the others follow. Room for
  // 3 * Count().
  void Write(LightCorner* corners, std::uint32_t first) const;

private:
  // The triangle at a place of the order.
  std::size_t At(std::size_t i) const { return this->Order.empty() ? i : this->Order[i]; }

  const ShadowMesh<float>& Mesh;
  const std::vector<TriangleNeighbours>& Neighbours;
  const std::vector<std::uint32_t>& Order;
  glm::dmat4 LightFromMesh;
  bool Mirrored;
  std::vector<CastSign> Signs;
  std::vector<std::uint32_t> Places; // of each triangle in the list; NoTriangle
  std::size_t NumberListed = 0;
};

}

#endif
