// The clock that frames, measures and trials are timed by.
#ifndef vtkShadowSeconds_h
#define vtkShadowSeconds_h

#include "vtkShadowOpenGL.h"

#include <chrono>

// Since some fixed time.
inline double vtkShadowSeconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The same, once OpenGL has worked off all that it was given.
inline double vtkShadowSecondsOnceDrawn()
{
  glFinish();
  return vtkShadowSeconds();
}

#endif
