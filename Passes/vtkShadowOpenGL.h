// OpenGL through VTK, whichever loader this VTK carries.
#ifndef vtkShadowOpenGL_h
#define vtkShadowOpenGL_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#endif
