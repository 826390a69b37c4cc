// Which points of a mesh are connected by its cells.
#ifndef vtkshadows_ConnectedPieces_h
#define vtkshadows_ConnectedPieces_h

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace vtkshadows
{

// Points are joined (Join), and then numbered by the piece that they are in. Points that agree in
// every bit are one (0 and -0 as well), so that a mesh is not in pieces where its normals are.
class ConnectedPieces
{
public:
  // Precondition: fewer than 2^32 points.
  explicit ConnectedPieces(const std::vector<glm::dvec3>& points);

  void Join(std::size_t a, std::size_t b);

  // The piece of each point, from 0 in the order of their first points; `count`: how many.
  std::vector<std::uint32_t> Number(std::size_t& count);

private:
  std::uint32_t RootOf(std::uint32_t point);

  std::vector<std::uint32_t> Parents; // a root is its own
};

}

#endif
