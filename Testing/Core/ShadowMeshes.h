// Small meshes for the tests of shadow volumes: sound ones, and all that can be wrong with one.
// Coordinates are a few units around the origin; what is closed is wound counter-clockwise seen
// from outside, unless its name says otherwise.
#ifndef ShadowMeshes_h
#define ShadowMeshes_h

#include <glm/vec3.hpp>

#include <string>
#include <vector>

struct TestMesh
{
  std::string name;
  std::vector<glm::dvec3> points;
  std::vector<glm::uvec3> triangles;
};

TestMesh Tetrahedron();
TestMesh Cube();               // from -1 to 1
TestMesh UnweldedCube();       // three points of its own for each triangle
TestMesh InsideOutCube();      // wound clockwise, seen from outside
TestMesh OpenStrip();          // 8 triangles in the plane z = 0, in one row
TestMesh Fan(int blades);      // triangles that share one edge, every second one turned round
TestMesh Duplicated();         // a tetrahedron whose triangles are all there twice
TestMesh OneTurned();          // a tetrahedron with one triangle turned round
TestMesh MoebiusStrip();       // 60 triangles, one side, one border
TestMesh KleinBottle();        // 512 triangles, no border, but no outside either
TestMesh TwoBodiesAndASheet(); // cube, inside-out tetrahedron and strip, in turn in the list
TestMesh Torus(int rings, int sides);
// Random triangles over few random points: edges of many triangles, repeats, repeated corners.
TestMesh Soup(int triangles, int points);

// Triangles and quads in the plane z = 0 that share no point, over a square of columns^2 units: of
// mixed winding, one place in two a quad.
TestMesh Confetti(int columns);

// All of the above, the soup and the torus small.
std::vector<TestMesh> SmallMeshes();

// `part`'s triangles after those of `mesh`; its points moved.
void Append(TestMesh& mesh, const TestMesh& part, const glm::dvec3& offset = glm::dvec3(0.0));

#endif
