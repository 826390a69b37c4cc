// A buffer texture: a table that shaders look up by an index (samplerBuffer). Released with its
// window, or on destruction while the window lives.
#ifndef vtkShadowTextureBuffer_h
#define vtkShadowTextureBuffer_h

#include "vtkShadowTextureUnit.h"

#include "vtkWeakPointer.h"

#include <cstddef>
#include <vector>

class vtkOpenGLRenderWindow;

class vtkShadowTextureBuffer
{
public:
  vtkShadowTextureBuffer() = default;
  ~vtkShadowTextureBuffer();
  vtkShadowTextureBuffer(const vtkShadowTextureBuffer&) = delete;
  void operator=(const vtkShadowTextureBuffer&) = delete;

  // Texels of `components` floats each, 1 or 4; what it held is gone. Not while it is bound.
  void Upload(vtkOpenGLRenderWindow* window, int components, const std::vector<float>& values);

  // As Upload, but only if that is not what it holds, of which it keeps a copy: for small tables.
  // None: released.
  void Keep(vtkOpenGLRenderWindow* window, int components, const std::vector<float>& values);

  // Texels that this driver's buffer textures have at most. A context must be current.
  static std::size_t LargestSize();

  // Bind to a texture unit of the window's own, and give the unit back.
  void Activate();
  void Deactivate();
  int Unit() const { return this->BoundTo.Get(); }

  void Release();

  bool IsOf(vtkOpenGLRenderWindow* window) const;

  // Of what it holds; 0 if there is no texture.
  std::size_t Bytes() const { return this->Texture ? this->Size : 0; }

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::size_t Size = 0; // bytes
  std::vector<float> Kept;
  unsigned int Buffer = 0;
  unsigned int Texture = 0;
  vtkShadowTextureUnit BoundTo;
};

#endif
