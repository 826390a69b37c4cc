// What the eye sees of the receivers in this frame: per pixel a position and the face's normal, in
// view coordinates. Drawn once a frame, and only if a technique asks.
#ifndef vtkShadowReceiverBuffer_h
#define vtkShadowReceiverBuffer_h

#include "vtkShadowTextureArray.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

struct vtkShadowFrame;

class vtkShadowReceiverBuffer
{
public:
  // Forget the last frame's.
  void Invalidate() { this->Drawn = false; }

  // Draw and read back, unless this frame's is there already. false if the driver cannot.
  bool Draw(const vtkShadowFrame& frame);

  // From the next drawing on, read back only so many of the pixels that are drawn, spread evenly.
  void KeepPixels(int width, int height)
  {
    this->MostKept[0] = width;
    this->MostKept[1] = height;
  }

  // Of the pixels that were read back.
  int Width() const { return this->Kept[0]; }
  int Height() const { return this->Kept[1]; }

  struct Receiver
  {
    glm::vec3 PositionVC;
    glm::vec3 NormalVC; // unit, of the face, toward the eye
  };
  // false if pixel i (row by row from the bottom) shows no receiver.
  bool At(std::size_t i, Receiver& receiver) const;

  // Pixel i as it was drawn: position VC, and 0 for no receiver or the code of its normal.
  const float* PixelAt(std::size_t i) const { return &this->Pixels[4 * i]; }
  static bool IsReceiver(const float* pixel) { return pixel[3] > 0.5f; }

  // The octahedral code of vtkShadowReceiverBufferFS.glsl: 12 bits an axis, 1 added so that 0 is
  // nothing (Cigolle et al. 2014). Unit, and written without branches so that compilers vectorise
  // loops of it.
  static void DecodeNormal(float code, float& x, float& y, float& z)
  {
    const int bits = static_cast<int>(code) - 1;
    const float u = static_cast<float>(bits & 4095) * (2.0f / 4095.0f) - 1.0f;
    const float v = static_cast<float>(bits >> 12) * (2.0f / 4095.0f) - 1.0f;
    const float w = 1.0f - std::abs(u) - std::abs(v);
    const float fold = std::max(-w, 0.0f);
    const float foldedU = u - std::copysign(fold, u);
    const float foldedV = v - std::copysign(fold, v);
    const float perLength = 1.0f / std::sqrt(foldedU * foldedU + foldedV * foldedV + w * w);
    x = foldedU * perLength;
    y = foldedV * perLength;
    z = w * perLength;
  }

  std::size_t CountReceivers() const;

  // The same as a texture; once drawn.
  vtkShadowTextureArray& Texture() { return this->Colour; }

  // Draw the receivers' visibility of light `light` instead: one float a pixel, 1 where there is
  // none.
  bool DrawVisibility(const vtkShadowFrame& frame, int light, std::vector<float>& visibility);

  void Release();

private:
  bool DrawStage(const vtkShadowFrame& frame, int stage, const float background[4]);
  void DropPixels(const int drawn[2]);

  vtkShadowTextureArray Depth;
  vtkShadowTextureArray Colour;
  std::vector<float> Pixels;  // RGBA
  int MostKept[2] = { 0, 0 }; // 0: all
  int Kept[2] = { 0, 0 };
  bool Drawn = false;
};

#endif
