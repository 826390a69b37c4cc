// Vertex arrays for one draw, bound as long as this lives. A context must be current.
#ifndef vtkShadowVertexArray_h
#define vtkShadowVertexArray_h

#include "vtkShadowOpenGL.h"

#include "vtkShaderProgram.h"

#include <cstddef>

class vtkShadowVertexArray
{
public:
  // By buffers of vertices and of indices; 0: without.
  explicit vtkShadowVertexArray(GLuint vertices = 0, GLuint indices = 0)
  {
    glGenVertexArrays(1, &this->Name);
    glBindVertexArray(this->Name);
    if (indices != 0)
    {
      glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices); // belongs to the arrays
    }
    glBindBuffer(GL_ARRAY_BUFFER, vertices);
  }
  ~vtkShadowVertexArray()
  {
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindVertexArray(0);
    glDeleteVertexArrays(1, &this->Name);
  }
  vtkShadowVertexArray(const vtkShadowVertexArray&) = delete;
  void operator=(const vtkShadowVertexArray&) = delete;

  // An attribute of `program`: `components` floats of each vertex, which has `stride` bytes.
  void AddFloats(vtkShaderProgram* program, const char* attribute, int components,
    std::size_t stride, std::size_t offset = 0) const
  {
    const GLuint place = Enabled(program, attribute);
    glVertexAttribPointer(place, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
      reinterpret_cast<const void*>(offset));
  }
  // The same, of one unsigned number.
  void AddNumber(vtkShaderProgram* program, const char* attribute, std::size_t stride,
    std::size_t offset = 0) const
  {
    const GLuint place = Enabled(program, attribute);
    glVertexAttribIPointer(place, 1, GL_UNSIGNED_INT, static_cast<GLsizei>(stride),
      reinterpret_cast<const void*>(offset));
  }

private:
  static GLuint Enabled(vtkShaderProgram* program, const char* attribute)
  {
    const auto place = static_cast<GLuint>(
      glGetAttribLocation(static_cast<GLuint>(program->GetHandle()), attribute));
    glEnableVertexAttribArray(place);
    return place;
  }

  GLuint Name = 0;
};

#endif
