// A texture unit of a window's own, for as long as a texture is bound to it.
#ifndef vtkShadowTextureUnit_h
#define vtkShadowTextureUnit_h

#include "vtkShadowOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureUnitManager.h"

class vtkShadowTextureUnit
{
public:
  // Binds `texture` to a free unit, which is left active; false if it is bound already, or none is
  // free.
  bool Bind(vtkOpenGLRenderWindow* window, GLenum target, GLuint texture)
  {
    if (this->Number >= 0)
    {
      return false;
    }
    vtkOpenGLState* state = window->GetState();
    this->Number = state->GetTextureUnitManager()->Allocate();
    if (this->Number >= 0)
    {
      state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(this->Number));
      glBindTexture(target, texture);
    }
    return this->Number >= 0;
  }

  // Gives the unit back; the window may be gone.
  void Free(vtkOpenGLRenderWindow* window, GLenum target)
  {
    if (this->Number >= 0 && window)
    {
      vtkOpenGLState* state = window->GetState();
      state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(this->Number));
      glBindTexture(target, 0);
      state->GetTextureUnitManager()->Free(this->Number);
    }
    this->Number = -1;
  }

  // -1: none.
  int Get() const { return this->Number; }

private:
  int Number = -1;
};

#endif
