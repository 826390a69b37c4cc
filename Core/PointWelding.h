// Points of triangles that agree in every bit made one.
#ifndef vtkshadows_PointWelding_h
#define vtkshadows_PointWelding_h

#include <glm/vec3.hpp>

#include <vector>

namespace vtkshadows
{

// Leaves each point once, in the order of their first appearance, and renumbers the triangles; on
// all cores. 0 and -0 are one. Precondition: points are finite and fewer than 2^32, indices below
// points.size().
template <typename Real>
void Weld(std::vector<glm::vec<3, Real>>& points, std::vector<glm::uvec3>& triangles);

extern template void Weld(std::vector<glm::vec3>& points, std::vector<glm::uvec3>& triangles);
extern template void Weld(std::vector<glm::dvec3>& points, std::vector<glm::uvec3>& triangles);

}

#endif
