#include "vtkShadowTextureArray.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowOpenGL.h"

#include <utility>

namespace
{

struct TexelLayout
{
  GLenum Internal;
  GLenum Components;
  GLenum Type;
  std::size_t Bytes;
};

TexelLayout LayoutOf(vtkShadowTextureArray::Format format)
{
  switch (format)
  {
    case vtkShadowTextureArray::Format::Depth32F:
      return { GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 4 };
    case vtkShadowTextureArray::Format::Depth24:
      return { GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 4 };
    case vtkShadowTextureArray::Format::Depth16:
      return { GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, 2 };
    case vtkShadowTextureArray::Format::Depth24Stencil8:
      return { GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 4 };
    case vtkShadowTextureArray::Format::R32F:
      return { GL_R32F, GL_RED, GL_FLOAT, 4 };
    case vtkShadowTextureArray::Format::RG32F:
      return { GL_RG32F, GL_RG, GL_FLOAT, 8 };
    case vtkShadowTextureArray::Format::R32UI:
      return { GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 4 };
    case vtkShadowTextureArray::Format::RG16:
      return { GL_RG16, GL_RG, GL_UNSIGNED_SHORT, 4 };
    case vtkShadowTextureArray::Format::RGBA32F:
      return { GL_RGBA32F, GL_RGBA, GL_FLOAT, 16 };
    default:
      return { GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1 };
  }
}

// Binds a texture to the active unit, and what was there before back at the end of the scope.
class ScopedBinding
{
public:
  explicit ScopedBinding(unsigned int texture)
  {
    glGetIntegerv(GL_TEXTURE_BINDING_2D_ARRAY, &this->Before);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
  }
  ~ScopedBinding() { glBindTexture(GL_TEXTURE_2D_ARRAY, static_cast<GLuint>(this->Before)); }

private:
  GLint Before = 0;
};

}

//------------------------------------------------------------------------------
vtkShadowTextureArray::~vtkShadowTextureArray()
{
  this->Release();
}

//------------------------------------------------------------------------------
bool vtkShadowTextureArray::Reserve(
  vtkOpenGLRenderWindow* window, Format format, int width, int height, int layers)
{
  if (this->Texture && this->Window == window && this->TexelFormat == format &&
    this->Size[0] == width && this->Size[1] == height && this->Size[2] >= layers)
  {
    return false;
  }
  this->Release();
  this->Window = window;
  this->TexelFormat = format;

  glGenTextures(1, &this->Texture);
  const ScopedBinding bound(this->Texture);
  const TexelLayout layout = LayoutOf(format);
  while (glGetError() != GL_NO_ERROR)
  {
    // Forget errors of others: the next one asked for must be ours.
  }
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(layout.Internal), width, height, layers,
    0, layout.Components, layout.Type, nullptr);
  if (glGetError() != GL_NO_ERROR)
  {
    glDeleteTextures(1, &this->Texture);
    this->Texture = 0;
    return true;
  }
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
  this->Size[0] = width;
  this->Size[1] = height;
  this->Size[2] = layers;
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::Upload(int layer, const unsigned char* texels)
{
  const ScopedBinding bound(this->Texture);
  GLint alignment = 4;
  glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer, this->Size[0], this->Size[1], 1, GL_RED,
    GL_UNSIGNED_BYTE, texels);
  glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
}

//------------------------------------------------------------------------------
bool vtkShadowTextureArray::Download(int layer, std::vector<unsigned char>& texels) const
{
  if (!this->Texture || !this->Window)
  {
    return false;
  }
  this->Window->MakeCurrent();
  vtkOpenGLState* state = this->Window->GetState();
  texels.resize(static_cast<std::size_t>(this->Size[0]) * this->Size[1]);
  state->PushFramebufferBindings();
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->Texture, 0, layer);
  state->vtkglReadBuffer(GL_COLOR_ATTACHMENT0);
  const bool isComplete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (isComplete)
  {
    GLint alignment = 4;
    glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, this->Size[0], this->Size[1], GL_RED, GL_UNSIGNED_BYTE, texels.data());
    glPixelStorei(GL_PACK_ALIGNMENT, alignment);
  }
  state->PopFramebufferBindings();
  glDeleteFramebuffers(1, &framebuffer);
  return isComplete;
}

//------------------------------------------------------------------------------
int vtkShadowTextureArray::LargestSide()
{
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  return limit;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowTextureArray::Bytes() const
{
  return this->Texture
    ? LayoutOf(this->TexelFormat).Bytes * this->Size[0] * this->Size[1] * this->Size[2]
    : 0;
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::Smooth()
{
  const ScopedBinding bound(this->Texture);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::MakeLevels(int levels)
{
  const ScopedBinding bound(this->Texture);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, levels);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::CompareDepths(bool compared)
{
  const ScopedBinding bound(this->Texture);
  const GLint filter = compared ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE,
    compared ? static_cast<GLint>(GL_COMPARE_REF_TO_TEXTURE) : GL_NONE);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, filter);
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::Activate()
{
  if (this->Texture)
  {
    this->BoundTo.Bind(this->Window, GL_TEXTURE_2D_ARRAY, this->Texture);
  }
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::Deactivate()
{
  this->BoundTo.Free(this->Window, GL_TEXTURE_2D_ARRAY);
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::Release()
{
  if (this->Texture && this->Window)
  {
    this->Window->MakeCurrent();
    this->Deactivate();
    glDeleteTextures(1, &this->Texture);
  }
  this->Texture = 0;
  this->Window = nullptr;
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::Swap(vtkShadowTextureArray& other)
{
  std::swap(this->Window, other.Window);
  std::swap(this->Texture, other.Texture);
  std::swap(this->TexelFormat, other.TexelFormat);
  std::swap(this->Size, other.Size);
}
