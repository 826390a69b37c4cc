// A fragment shader over the whole viewport.
#ifndef vtkShadowFullScreen_h
#define vtkShadowFullScreen_h

#include "vtkShadowFullScreenVS.h"
#include "vtkShadowVertexArray.h"

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
  const vtkShadowVertexArray none;
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}

#endif
