#include "vtkShadowDrawScope.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowTextureArray.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkShadowDrawScope::vtkShadowDrawScope(vtkOpenGLRenderWindow* window,
  const vtkShadowTextureArray& depth, int depthLayer, const vtkShadowTextureArray* colour,
  int colourLayer)
  : vtkShadowDrawScope(window, &depth, depthLayer, colour, colourLayer)
{
}

vtkShadowDrawScope::vtkShadowDrawScope(vtkOpenGLRenderWindow* window,
  const vtkShadowTextureArray* depth, int depthLayer, const vtkShadowTextureArray* colour,
  int colourLayer)
  : State(window->GetState())
  , Viewport(State)
  , Scissor(State)
  , DepthMask(State)
  , DepthFunc(State)
  , ColorMask(State)
  , ScissorTest(State, GL_SCISSOR_TEST)
  , DepthTest(State, GL_DEPTH_TEST)
  , Blend(State, GL_BLEND)
  , BlendFunc(State)
  , StencilTest(State, GL_STENCIL_TEST)
  , CullFace(State, GL_CULL_FACE)
  , Width((depth ? depth : colour)->Width())
  , Height((depth ? depth : colour)->Height())
  , HasColour(colour != nullptr)
  , ColourIsInteger(colour != nullptr && colour->IsInteger())
{
  this->State->PushFramebufferBindings();
  glGenFramebuffers(1, &this->Framebuffer);
  this->State->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
  if (depth)
  {
    glFramebufferTextureLayer(GL_FRAMEBUFFER,
      depth->HasStencil() ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, depth->Id(), 0,
      depthLayer);
  }
  GLenum target = colour ? GL_COLOR_ATTACHMENT0 : GL_NONE;
  if (colour)
  {
    glFramebufferTextureLayer(GL_FRAMEBUFFER, target, colour->Id(), 0, colourLayer);
  }
  this->State->vtkglDrawBuffers(1, &target);
  this->State->vtkglReadBuffer(target);
  this->Complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;

  this->State->vtkglViewport(0, 0, this->Width, this->Height);
  this->State->vtkglDisable(GL_SCISSOR_TEST);
  this->State->vtkglDisable(GL_BLEND);
  this->State->vtkglDisable(GL_STENCIL_TEST);
  if (depth)
  {
    this->State->vtkglEnable(GL_DEPTH_TEST);
  }
  else
  {
    this->State->vtkglDisable(GL_DEPTH_TEST);
  }
  this->State->vtkglDepthFunc(GL_LEQUAL);
  this->State->vtkglDepthMask(GL_TRUE);
  this->State->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

//------------------------------------------------------------------------------
vtkShadowDrawScope::~vtkShadowDrawScope()
{
  this->State->PopFramebufferBindings();
  glDeleteFramebuffers(1, &this->Framebuffer);
}

//------------------------------------------------------------------------------
void vtkShadowDrawScope::Confine(int width, int height, int border)
{
  this->State->vtkglViewport(0, 0, width, height);
  this->State->vtkglEnable(GL_SCISSOR_TEST);
  this->State->vtkglScissor(
    border, border, std::max(width - 2 * border, 0), std::max(height - 2 * border, 0));
}

//------------------------------------------------------------------------------
void vtkShadowDrawScope::Clear(const float rgba[4])
{
  const float farthest = 1.0f;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  this->ClearColour(rgba);
}

//------------------------------------------------------------------------------
void vtkShadowDrawScope::ClearColour(const float rgba[4])
{
  if (this->ColourIsInteger)
  {
    const GLuint none[4] = { 0, 0, 0, 0 };
    glClearBufferuiv(GL_COLOR, 0, none);
  }
  else if (this->HasColour)
  {
    glClearBufferfv(GL_COLOR, 0, rgba);
  }
}

//------------------------------------------------------------------------------
void vtkShadowDrawScope::ReadColour(float* rgba) const
{
  glReadPixels(0, 0, this->Width, this->Height, GL_RGBA, GL_FLOAT, rgba);
}
