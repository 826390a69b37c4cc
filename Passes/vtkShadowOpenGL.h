// OpenGL through VTK, whichever loader this VTK carries.
#ifndef vtkShadowOpenGL_h
#define vtkShadowOpenGL_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#define VTKSHADOWS_GL_HAS(extension) GLAD_GL_##extension
#else
#include "vtk_glew.h"
#define VTKSHADOWS_GL_HAS(extension) GLEW_##extension
#endif

#endif
