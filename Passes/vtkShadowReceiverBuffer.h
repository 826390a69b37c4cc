// What the eye sees of the receivers in this frame: per pixel a position and the face's normal, in view
// coordinates. Drawn once a frame, and only if a technique asks.
#ifndef vtkShadowReceiverBuffer_h
#define vtkShadowReceiverBuffer_h

#include "vtkShadowTextureArray.h"

#include <glm/vec3.hpp>

#include <vector>

struct vtkShadowFrame;

class vtkShadowReceiverBuffer
{
public:
  // Forget the last frame's.
  void Invalidate() { this->Drawn = false; }

  // Draw and read back, unless this frame's is there already. false if the driver cannot.
  bool Draw(const vtkShadowFrame& frame);

  int Width() const { return this->Depth.Width(); }
  int Height() const { return this->Depth.Height(); }

  struct Receiver
  {
    glm::vec3 PositionVC;
    glm::vec3 NormalVC; // unit, of the face, toward the eye
  };
  // false if pixel i (row by row from the bottom) shows no receiver.
  bool At(std::size_t i, Receiver& receiver) const;

  std::size_t CountReceivers() const;

  // Draw the receivers' visibility of light `light` instead: one float a pixel, 1 where there is none.
  bool DrawVisibility(const vtkShadowFrame& frame, int light, std::vector<float>& visibility);

  void Release();

private:
  bool DrawStage(const vtkShadowFrame& frame, int stage, const float background[4]);

  vtkShadowTextureArray Depth;
  vtkShadowTextureArray Colour;
  std::vector<float> Pixels; // RGBA
  bool Drawn = false;
};

#endif
