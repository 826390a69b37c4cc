#include "vtkPlanarShadowCanvas.h"

#include "vtkPlanarShadowPassMarkFS.h"
#include "vtkPlanarShadowPassPlateauFS.h"
#include "vtkPlanarShadowPassPlateauVS.h"
#include "vtkShadowDrawScope.h"
#include "vtkShadowFullScreen.h"
#include "vtkShadowMatrix.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowSumFS.h"
#include "vtkShadowVertexArray.h"
#include "vtkShadowedShadingPass.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

// The stencil: 255 off the plane; on it how many shadows have been thrown when this pixel was
// last darkened, so that whatever covers it again changes nothing.
constexpr int OffPlane = 255;

// Depths of a receiver and of its plane differ by the rounding of two ways to them, in steps of the
// depth buffer.
constexpr double DepthSteps = 64.0;

void SetVector(vtkShaderProgram* program, const char* name, const glm::dvec3& v)
{
  const float values[3] = { static_cast<float>(v.x), static_cast<float>(v.y),
    static_cast<float>(v.z) };
  program->SetUniform3f(name, values);
}

}

//------------------------------------------------------------------------------
bool vtkPlanarShadowCanvas::Reserve(const vtkShadowFrame& frame, int width, int height, bool sums)
{
  using Format = vtkShadowTextureArray::Format;
  this->Marks.Reserve(frame.Window, Format::Depth24Stencil8, width, height, 1);
  if (sums)
  {
    this->Sums.Reserve(frame.Window, Format::R32F, width, height, 1);
  }
  this->KeepTo(width, height);
  return this->Marks.Id() != 0 && (!sums || this->Sums.Id() != 0);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowCanvas::KeepTo(int width, int height)
{
  this->Extent[0] = width;
  this->Extent[1] = height;
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowCanvas::DrawReceivers(const vtkShadowFrame& frame,
  vtkShadowTextureArray& depths, vtkShadowTextureArray& planes, const vtkshadows::LightView& view,
  const std::vector<std::size_t>& props, const std::vector<float>& planesOfProps)
{
  vtkShadowDrawScope target(frame.Window, depths, 0, &planes, 0);
  if (!target.IsComplete())
  {
    return false;
  }
  const float none[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  target.Clear(none);
  // They are drawn with a red of 1, of which blending makes a number, and a green of their depth.
  vtkOpenGLState* state = frame.Window->GetState();
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_CONSTANT_COLOR, GL_ZERO, GL_CONSTANT_COLOR, GL_ZERO);
  for (std::size_t i = 0; i < props.size(); ++i)
  {
    glBlendColor(planesOfProps[i], 1.0f, 1.0f, 1.0f);
    const std::vector<std::size_t> one = { props[i] };
    frame.Shading->DrawDepths(frame, view, &one, vtkShadowedShadingPass::COVERAGE);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPlanarShadowCanvas::ClearMarks(const vtkShadowFrame& frame, int mark)
{
  // Depths halfway: what lies above a plane is drawn beyond it, what lies beneath before it.
  frame.Window->GetState()->vtkglStencilMask(0xff);
  glClearBufferfi(GL_DEPTH_STENCIL, 0, 0.5f, mark);
  this->UsedMarks = 0;
  this->Rim = 0;
}

//------------------------------------------------------------------------------
void vtkPlanarShadowCanvas::MarkAll(const vtkShadowFrame& frame)
{
  vtkShadowDrawScope target(frame.Window, this->Marks, 0);
  this->ClearMarks(frame, 0);
  this->Rim = 1;
}

void vtkPlanarShadowCanvas::MarkNothing(const vtkShadowFrame& frame)
{
  vtkShadowDrawScope target(frame.Window, this->Marks, 0);
  this->ClearMarks(frame, OffPlane);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowCanvas::MarkReceivers(const vtkShadowFrame& frame,
  const vtkshadows::LightView& view, const std::vector<std::size_t>& props)
{
  vtkOpenGLState* state = frame.Window->GetState();
  vtkShadowDrawScope target(frame.Window, this->Marks, 0);
  this->ClearMarks(frame, OffPlane);
  state->vtkglDepthFunc(GL_NEVER);
  state->vtkglEnable(GL_STENCIL_TEST);
  state->vtkglStencilFunc(GL_ALWAYS, 0, 0xff);
  state->vtkglStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
  frame.Shading->DrawDepths(frame, view, &props);
  state->vtkglStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowCanvas::MarkPlane(const vtkShadowFrame& frame, vtkShadowTextureArray& planes,
  float bit, const glm::dvec3& depthBeneath, const glm::dvec3& depthAbove, double slack)
{
  vtkOpenGLState* state = frame.Window->GetState();
  vtkShadowDrawScope target(frame.Window, this->Marks, 0);
  this->ClearMarks(frame, OffPlane);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_STENCIL_TEST);
  state->vtkglStencilFunc(GL_ALWAYS, 0, 0xff);
  state->vtkglStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);

  vtkShaderProgram* program = vtkShadowFullScreen::Ready(frame.Window, vtkPlanarShadowPassMarkFS);
  // Each term is rounded, too.
  double terms = 0.0, slope = 0.0;
  for (const glm::dvec3& plane : { depthBeneath, depthAbove })
  {
    slope = std::max(slope, std::abs(plane.x) + std::abs(plane.y));
    terms = std::max(terms,
      std::abs(plane.x) * frame.Size[0] + std::abs(plane.y) * frame.Size[1] + std::abs(plane.z));
  }
  SetVector(program, "shadowDepthBeneath", depthBeneath);
  SetVector(program, "shadowDepthAbove", depthAbove);
  program->SetUniformf("shadowDepthTolerance",
    static_cast<float>(std::ldexp(DepthSteps + 4.0 * terms, -24) + slack * slope));
  planes.Activate();
  program->SetUniformi("shadowReceivers", planes.Unit());
  program->SetUniformf("shadowPlaneBit", bit);
  vtkShadowFullScreen::Draw();
  planes.Deactivate();
  state->vtkglStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowCanvas::Begin(
  const vtkShadowFrame& frame, vtkShadowTextureArray& masks, int layer, bool isSoft)
{
  this->Masks = &masks;
  this->Layer = layer;
  this->IsSoft = isSoft;
  vtkShadowDrawScope target(
    frame.Window, this->Marks, 0, isSoft ? &this->Sums : &masks, isSoft ? 0 : layer);
  const float lit[4] = { 1.0f, 1.0f, 1.0f, 1.0f };
  glClearBufferfv(GL_COLOR, 0, lit);
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowCanvas::Throw(const vtkShadowFrame& frame,
  const std::vector<std::size_t>& casters, const vtkshadows::LightView& view,
  const std::unordered_map<vtkProp*, unsigned int>& culled, float share)
{
  if (this->UsedMarks + 1 >= OffPlane)
  {
    return false;
  }
  ++this->UsedMarks;
  vtkOpenGLState* state = frame.Window->GetState();
  vtkShadowDrawScope target(frame.Window, this->Marks, 0, this->IsSoft ? &this->Sums : this->Masks,
    this->IsSoft ? 0 : this->Layer);
  target.Confine(this->Extent[0], this->Extent[1], this->Rim);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDepthFunc(GL_GREATER);
  state->vtkglEnable(GL_STENCIL_TEST);
  state->vtkglStencilMask(0xff);
  state->vtkglStencilFunc(GL_GREATER, this->UsedMarks, 0xff);
  state->vtkglStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  // Casters are drawn white: so much of it is taken away.
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_REVERSE_SUBTRACT);
  state->vtkglBlendFuncSeparate(GL_CONSTANT_COLOR, GL_ONE, GL_CONSTANT_COLOR, GL_ONE);
  glBlendColor(share, share, share, share);
  frame.Shading->DrawCasters(frame, casters, view, culled, false);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  return true;
}

//------------------------------------------------------------------------------
void vtkPlanarShadowCanvas::DrawPlateaus(const vtkShadowFrame& frame,
  const glm::dmat4& clipFromPlateau, const std::vector<vtkshadows::PlateauVertex>& triangles)
{
  if (triangles.empty())
  {
    return;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  vtkShadowDrawScope target(frame.Window, this->Marks, 0, this->Masks, this->Layer);
  target.Confine(this->Extent[0], this->Extent[1], this->Rim);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_STENCIL_TEST);
  state->vtkglStencilFunc(GL_NOTEQUAL, OffPlane, 0xff);
  state->vtkglStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_MIN);
  glEnable(GL_DEPTH_CLAMP);

  vtkShaderProgram* program = frame.Window->GetShaderCache()->ReadyShaderProgram(
    vtkPlanarShadowPassPlateauVS, vtkPlanarShadowPassPlateauFS, "");
  std::array<float, 16> matrix = vtkShadowMatrix::ToFloats(clipFromPlateau);
  program->SetUniformMatrix4x4("shadowClipFromPlateau", matrix.data());
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  {
    const vtkShadowVertexArray vertices(buffer);
    glBufferData(GL_ARRAY_BUFFER,
      static_cast<GLsizeiptr>(triangles.size() * sizeof(vtkshadows::PlateauVertex)),
      triangles.data(), GL_STREAM_DRAW);
    vertices.AddFloats(program, "shadowVertex", 4, sizeof(vtkshadows::PlateauVertex));
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles.size()));
  }
  glDeleteBuffers(1, &buffer);

  glDisable(GL_DEPTH_CLAMP);
  state->vtkglBlendEquation(GL_FUNC_ADD);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowCanvas::End(const vtkShadowFrame& frame)
{
  if (!this->IsSoft)
  {
    return;
  }
  vtkShadowDrawScope target(frame.Window, this->Marks, 0, this->Masks, this->Layer);
  frame.Window->GetState()->vtkglDisable(GL_DEPTH_TEST);
  vtkShaderProgram* program = vtkShadowFullScreen::Ready(frame.Window, vtkShadowSumFS);
  this->Sums.Activate();
  program->SetUniformi("shadowSums", this->Sums.Unit());
  vtkShadowFullScreen::Draw();
  this->Sums.Deactivate();
}

//------------------------------------------------------------------------------
void vtkPlanarShadowCanvas::Release()
{
  this->Marks.Release();
  this->Sums.Release();
}
