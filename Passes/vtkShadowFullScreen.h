// A fragment shader over the whole viewport.
#ifndef vtkShadowFullScreen_h
#define vtkShadowFullScreen_h

#include "vtkShadowFullScreenVS.h"
#include "vtkShadowOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

namespace vtkShadowFullScreen
{

inline vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, const char* fragmentShader)
{
  return window->GetShaderCache()->ReadyShaderProgram(vtkShadowFullScreenVS, fragmentShader, "");
}

// By the program that is ready. Without vertex arrays: everything comes from gl_VertexID.
inline void Draw()
{
  GLuint arrays = 0;
  glGenVertexArrays(1, &arrays);
  glBindVertexArray(arrays);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glDeleteVertexArrays(1, &arrays);
}

}

#endif
