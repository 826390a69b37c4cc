// Between GLM (column-major) and VTK (row-major) matrices, in double.
#ifndef vtkShadowMatrix_h
#define vtkShadowMatrix_h

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>

#include <array>

namespace vtkShadowMatrix
{

inline glm::dmat4 ToGlm(vtkMatrix4x4* m)
{
  glm::dmat4 out;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      out[column][row] = m->GetElement(row, column);
    }
  }
  return out;
}

inline void ToVtk(const glm::dmat4& m, vtkMatrix4x4* out)
{
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      out->SetElement(row, column, m[column][row]);
    }
  }
}

// What a camera sees, and by a renderer's window what of it: OpenGL clip space, z in -w..w.
inline glm::dmat4 ViewFromWorld(vtkCamera* camera)
{
  return ToGlm(camera->GetModelViewTransformMatrix());
}

inline glm::dmat4 ClipFromView(vtkCamera* camera, vtkRenderer* renderer)
{
  return ToGlm(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
}

// From the clip space of a view to a map of width x height texels, its depth from 0 to 1.
inline glm::dmat4 MapFromClip(int width, int height)
{
  const glm::dvec3 half(0.5 * width, 0.5 * height, 0.5);
  return glm::scale(glm::translate(glm::dmat4(1.0), half), half);
}

// As GLSL takes it, column by column.
inline std::array<float, 16> ToFloats(const glm::dmat4& m)
{
  std::array<float, 16> out;
  for (int i = 0; i < 16; ++i)
  {
    out[i] = static_cast<float>(m[i / 4][i % 4]);
  }
  return out;
}

}

#endif
