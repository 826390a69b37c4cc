// A 2D texture array: maps or masks, a layer each, behind a single sampler (vtkTextureObject
// has no array target). Released with its window, or on destruction while the window lives.
#ifndef vtkShadowTextureArray_h
#define vtkShadowTextureArray_h

#include "vtkShadowTextureUnit.h"

#include "vtkWeakPointer.h"

#include <cstddef>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkWindow;

class vtkShadowTextureArray
{
public:
  enum class Format
  {
    Depth32F, // one float, 0 nearest .. 1 farthest
    Depth24,  // depth in 24 bits, and in 16
    Depth16,
    Depth24Stencil8, // depth in 24 bits, and 8 of stencil
    RGBA32F,
    R32F,
    RG32F,
    R32UI, // sampled as integers
    RG16,  // 0..65535 read as 0..1
    R8     // 0..255 read as 0..1
  };

  vtkShadowTextureArray() = default;
  ~vtkShadowTextureArray();
  vtkShadowTextureArray(const vtkShadowTextureArray&) = delete;
  void operator=(const vtkShadowTextureArray&) = delete;

  // Room for `layers` of width x height texels; true if it was allocated anew, its contents lost.
  // Keeps what it has if that has the same texels and enough layers. Id() is 0 if memory ran out.
  bool Reserve(vtkOpenGLRenderWindow* window, Format format, int width, int height, int layers);

  // Texels on a side that this driver's textures have at most. A context must be current.
  static int LargestSide();

  // R8 only: width*height bytes, row by row from the bottom. Download is false if the driver
  // cannot.
  void Upload(int layer, const unsigned char* texels);
  bool Download(int layer, std::vector<unsigned char>& texels) const;

  // Blend neighbouring texels when it is sampled.
  void Smooth();

  // Make `levels` smaller copies of every layer, each half the size of the one before, and blend
  // between them when it is sampled at a level.
  void MakeLevels(int levels);
  // Depths: what a shadow sampler asks for, from now on: the blended answers whether a reference is
  // at most the texel's depth; or again the depth of one texel.
  void CompareDepths(bool compared);

  // Bind to a texture unit of the window's own, and give the unit back.
  void Activate();
  void Deactivate();
  int Unit() const { return this->BoundTo.Get(); }

  void Release();

  // Trade contents; neither may be bound.
  void Swap(vtkShadowTextureArray& other);

  bool IsInteger() const { return this->TexelFormat == Format::R32UI; }
  bool HasStencil() const { return this->TexelFormat == Format::Depth24Stencil8; }

  unsigned int Id() const { return this->Texture; }
  int Width() const { return this->Size[0]; }
  int Height() const { return this->Size[1]; }

  // Of its texels, smaller copies left out; 0 if there is no texture.
  std::size_t Bytes() const;

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  unsigned int Texture = 0;
  Format TexelFormat = Format::R8;
  int Size[3] = { 0, 0, 0 };
  vtkShadowTextureUnit BoundTo;
};

#endif
