// The triangles of a large mesh in clusters of those that lie near each other, so that a view that
// sees a part of the mesh draws little more than that. Plain C++ and GLM: no VTK, no OpenGL.
#ifndef vtkshadows_TriangleClusters_h
#define vtkshadows_TriangleClusters_h

#include "LightView.h" // for BoxCorners

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkshadows
{

// Of what is drawn from a list a mesh of more triangles is in clusters of so many, once a view sees
// less than that share of its bounds.
constexpr double MostTrianglesInOne = 2.0e4;
constexpr double MostShareSeen = 0.5;
constexpr std::size_t TrianglesOfCluster = 1024;

// Of a list of triangles: first to first + count.
struct TriangleRange
{
  std::size_t first = 0, count = 0;
};

// Triangles first to first + count, all of them within the bounds.
struct TriangleCluster
{
  std::size_t first = 0, count = 0;
  glm::vec3 minimum{ 0.0f }, maximum{ 0.0f };
};

// Reorders `triangles`, indices into finite `vertices`, so that those of a cluster are in a row, at
// most `most` of them, in the order that they had: by halves at the median centre along the longest
// side (J. Bentley 1975). One after another the clusters are all triangles.
std::vector<TriangleCluster> ClusterTriangles(
  const std::vector<glm::vec3>& vertices, std::vector<glm::uvec3>& triangles, std::size_t most);

// The same without a change of the triangles: `order` are their indices in that order.
std::vector<TriangleCluster> ClusterTriangles(const std::vector<glm::vec3>& vertices,
  const std::vector<glm::uvec3>& triangles, std::size_t most, std::vector<std::uint32_t>& order);

// Reorders the vertices as the triangles use them, one after another, so that triangles in a row
// have theirs in a row; what none uses is left out.
void OrderVertices(std::vector<glm::vec3>& vertices, std::vector<glm::uvec3>& triangles);

// The four sides of a view.
class ViewSides
{
public:
  explicit ViewSides(const glm::dmat4& clipFromMesh);
  // Whether nothing of the bounds lies within them. It errs on the side of no, by more than single
  // precision rounds, so that what is left out is drawn by no pixel.
  bool LeaveOut(const glm::vec3& minimum, const glm::vec3& maximum) const;

private:
  std::array<glm::dvec4, 4> Planes;
  // Of the bounds' largest coordinates, for left and right, bottom and top: what clip coordinates
  // are summed from.
  std::array<glm::dvec4, 2> Terms;
};

// What is to be drawn of a list of triangles, in the fewest ranges.
class TriangleRanges
{
public:
  // What goes on from the last range is joined with it.
  void Add(std::size_t first, std::size_t count);
  // Those of the clusters that the view's sides do not leave out; the list has them from `listed`
  // on.
  void AddSeen(const std::vector<TriangleCluster>& clusters, const glm::dmat4& clipFromMesh,
    std::size_t listed = 0);
  const std::vector<TriangleRange>& Get() const { return this->Ranges; }

private:
  std::vector<TriangleRange> Ranges;
};

// About what share of a box's volume lies within the four sides of a view, 0 to 1.
double ShareWithin(const glm::dmat4& clipFromWorld, const BoxCorners& box);

}

#endif
