// What views that explain shadows share: they are blended over a frame and leave its depths alone.
#ifndef vtkShadowOverlay_h
#define vtkShadowOverlay_h

#include "vtkShadowOpenGL.h"
#include "vtkShadowSceneData.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace vtkShadowOverlay
{

// As long as it lives, what is drawn is tested against the frame's depths and blended.
class State
{
public:
  explicit State(vtkOpenGLState* state)
    : DepthMask(state)
    , DepthFunc(state)
    , BlendFunc(state)
    , DepthTest(state, GL_DEPTH_TEST)
    , Blend(state, GL_BLEND)
    , CullFace(state, GL_CULL_FACE)
  {
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(GL_LEQUAL);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendEquation(GL_FUNC_ADD);
    state->vtkglBlendFuncSeparate(
      GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }

private:
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunc;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunc;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
};

// Where a shader finds the pixel of the frame: the viewport's origin, and pixels of the frame in
// one of the framebuffer.
inline void PlaceViewport(const vtkShadowFrame& frame, vtkShaderProgram* program)
{
  int viewport[4];
  frame.Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const float origin[2] = { static_cast<float>(viewport[0]), static_cast<float>(viewport[1]) };
  const float scale[2] = { static_cast<float>(frame.Size[0]) / static_cast<float>(viewport[2]),
    static_cast<float>(frame.Size[1]) / static_cast<float>(viewport[3]) };
  program->SetUniform2f("shadowViewOrigin", origin);
  program->SetUniform2f("shadowViewScale", scale);
}

}

#endif
