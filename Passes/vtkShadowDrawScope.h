// Drawing into layers of texture arrays: a framebuffer of its own, the viewport and the state that
// a depth-tested draw wants, and everything as it was at the end of the scope.
#ifndef vtkShadowDrawScope_h
#define vtkShadowDrawScope_h

#include "vtkOpenGLState.h"

class vtkOpenGLRenderWindow;
class vtkShadowTextureArray;

class vtkShadowDrawScope
{
public:
  // `colour` may be nullptr: depth alone. Both have the same size.
  vtkShadowDrawScope(vtkOpenGLRenderWindow* window, const vtkShadowTextureArray& depth,
    int depthLayer, const vtkShadowTextureArray* colour = nullptr, int colourLayer = 0);
  // Either may be nullptr; without depth there is no depth test.
  vtkShadowDrawScope(vtkOpenGLRenderWindow* window, const vtkShadowTextureArray* depth,
    int depthLayer, const vtkShadowTextureArray* colour, int colourLayer);
  ~vtkShadowDrawScope();
  vtkShadowDrawScope(const vtkShadowDrawScope&) = delete;
  void operator=(const vtkShadowDrawScope&) = delete;

  // false: the driver cannot draw into this; nothing must be drawn.
  bool IsComplete() const { return this->Complete; }

  // Map clip space to the lower left width x height texels, and leave the outer `border` of them
  // alone.
  void Confine(int width, int height, int border);

  // Depth to 1, colour to rgba; a colour of integers to 0.
  void Clear(const float rgba[4]);
  // The same, of the colour alone.
  void ClearColour(const float rgba[4]);

  // Read the colour attachment: width*height*4 floats, row by row from the bottom.
  void ReadColour(float* rgba) const;

private:
  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunc;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunc;
  vtkOpenGLState::ScopedglEnableDisable StencilTest;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
  int Width;
  int Height;
  bool HasColour;
  bool ColourIsInteger;
  bool Complete = false;
  unsigned int Framebuffer = 0;
};

#endif
