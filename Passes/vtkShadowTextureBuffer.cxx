#include "vtkShadowTextureBuffer.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowOpenGL.h"

//------------------------------------------------------------------------------
vtkShadowTextureBuffer::~vtkShadowTextureBuffer()
{
  this->Release();
}

//------------------------------------------------------------------------------
bool vtkShadowTextureBuffer::IsOf(vtkOpenGLRenderWindow* window) const
{
  return this->Texture != 0 && this->Window == window;
}

//------------------------------------------------------------------------------
void vtkShadowTextureBuffer::Upload(
  vtkOpenGLRenderWindow* window, int components, const std::vector<float>& values)
{
  if (!this->IsOf(window))
  {
    this->Release();
    window->MakeCurrent();
    this->Window = window;
    glGenBuffers(1, &this->Buffer);
    glGenTextures(1, &this->Texture);
  }
  this->Size = values.size() * sizeof(float);
  glBindBuffer(GL_TEXTURE_BUFFER, this->Buffer);
  glBufferData(
    GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(this->Size), values.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
  GLint before = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &before);
  glBindTexture(GL_TEXTURE_BUFFER, this->Texture);
  glTexBuffer(GL_TEXTURE_BUFFER, components == 1 ? GL_R32F : GL_RGBA32F, this->Buffer);
  glBindTexture(GL_TEXTURE_BUFFER, static_cast<GLuint>(before));
}

//------------------------------------------------------------------------------
void vtkShadowTextureBuffer::Keep(
  vtkOpenGLRenderWindow* window, int components, const std::vector<float>& values)
{
  if (values.empty())
  {
    this->Release();
  }
  else if (values != this->Kept || !this->IsOf(window))
  {
    this->Upload(window, components, values);
    this->Kept = values;
  }
}

//------------------------------------------------------------------------------
std::size_t vtkShadowTextureBuffer::LargestSize()
{
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
  return static_cast<std::size_t>(limit);
}

//------------------------------------------------------------------------------
void vtkShadowTextureBuffer::Activate()
{
  if (this->Texture)
  {
    this->BoundTo.Bind(this->Window, GL_TEXTURE_BUFFER, this->Texture);
  }
}

//------------------------------------------------------------------------------
void vtkShadowTextureBuffer::Deactivate()
{
  this->BoundTo.Free(this->Window, GL_TEXTURE_BUFFER);
}

//------------------------------------------------------------------------------
void vtkShadowTextureBuffer::Release()
{
  if (this->Texture && this->Window)
  {
    this->Window->MakeCurrent();
    this->Deactivate();
    glDeleteTextures(1, &this->Texture);
    glDeleteBuffers(1, &this->Buffer);
  }
  this->Kept.clear();
  this->Texture = 0;
  this->Buffer = 0;
  this->Window = nullptr;
}
