// The meshes that the extremes are made of, with points in double. Scene units.
#ifndef vtkshadows_ExtremeMeshes_h
#define vtkshadows_ExtremeMeshes_h

#include "Extremes.h"

#include <array>

namespace vtkshadows
{

// Its points taken through `to` in double, with its normals.
vtkSmartPointer<vtkPolyData> Moved(vtkPolyData* mesh, const glm::dmat4& to);

vtkSmartPointer<vtkPolyData> MakeFloor(double half, double height = 0.0);
// From one corner to its two neighbours.
vtkSmartPointer<vtkPolyData> MakeRectangle(
  const glm::dvec3& corner, const glm::dvec3& right, const glm::dvec3& up);
vtkSmartPointer<vtkPolyData> MakeBall(const glm::dvec3& centre, double radius, int resolution = 64);
// Its sides 1.4, 1.2 and 1.3, from the floor up, a little turned.
vtkSmartPointer<vtkPolyData> MakeBox();
vtkSmartPointer<vtkPolyData> MakePillar();
vtkSmartPointer<vtkPolyData> MakeRing();

// A wall of triangles 1 long and `width` wide, `count` of them side by side, about `centre`.
vtkSmartPointer<vtkPolyData> MakeSlivers(const glm::dvec3& centre, double width, int count);
// A square floor from one corner to points `step` of its half side apart, and on to the others.
vtkSmartPointer<vtkPolyData> MakeFan(double half, double step);

// A copy with `more` points and triangles among them appended; the old points keep their numbers.
vtkSmartPointer<vtkPolyData> WithTriangles(vtkPolyData* mesh, const std::vector<glm::dvec3>& more,
  const std::vector<std::array<vtkIdType, 3>>& triangles);

}

#endif
