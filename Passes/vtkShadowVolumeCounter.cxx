#include "vtkShadowVolumeCounter.h"

#include "vtkShadowDrawScope.h"
#include "vtkShadowFullScreenVS.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowedShadingPass.h"
#include "vtkStencilShadowVolumePassFS.h"
#include "vtkStencilShadowVolumePassResolveFS.h"
#include "vtkStencilShadowVolumePassVS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

#include <glm/matrix.hpp>

#include <array>
#include <cmath>

namespace
{

// Faces are pushed back by as many steps of the depth buffer: more than different matrix arithmetic
// puts between a cap and the surface that it lies on, and all of them alike, so that volumes stay
// closed.
constexpr float PushedBack = 4.0f;

std::array<float, 16> ToFloats(const glm::dmat4& m)
{
  std::array<float, 16> out;
  for (int i = 0; i < 16; ++i)
  {
    out[i] = static_cast<float>(m[i / 4][i % 4]);
  }
  return out;
}

void SetVector(vtkShaderProgram* program, const char* name, const glm::dvec4& v)
{
  const float values[4] = { static_cast<float>(v.x), static_cast<float>(v.y),
    static_cast<float>(v.z), static_cast<float>(v.w) };
  program->SetUniform4f(name, values);
}

// Draws without vertex arrays: everything comes from gl_VertexID.
class ScopedArrays
{
public:
  ScopedArrays()
  {
    glGenVertexArrays(1, &this->Id);
    glBindVertexArray(this->Id);
  }
  ~ScopedArrays()
  {
    glBindVertexArray(0);
    glDeleteVertexArrays(1, &this->Id);
  }

private:
  GLuint Id = 0;
};

}

//------------------------------------------------------------------------------
vtkShadowVolumeCounter::vtkShadowVolumeCounter() = default;
vtkShadowVolumeCounter::~vtkShadowVolumeCounter() = default;

//------------------------------------------------------------------------------
bool vtkShadowVolumeCounter::Reserve(const vtkShadowFrame& frame, bool stencil, bool sums)
{
  using Format = vtkShadowTextureArray::Format;
  const int width = frame.Size[0], height = frame.Size[1];
  this->UsesStencil = stencil;
  this->Depth.Reserve(frame.Window, Format::Depth24Stencil8, width, height, 1);
  bool done = this->Depth.Id() != 0;
  if (!stencil)
  {
    this->Counts.Reserve(frame.Window, Format::R32F, width, height, 1);
    done = done && this->Counts.Id() != 0;
  }
  if (sums)
  {
    this->Sums.Reserve(frame.Window, Format::R32F, width, height, 1);
    done = done && this->Sums.Id() != 0;
  }
  return done;
}

//------------------------------------------------------------------------------
bool vtkShadowVolumeCounter::DrawReceivers(
  const vtkShadowFrame& frame, const vtkshadows::LightView& view)
{
  vtkShadowDrawScope target(frame.Window, this->Depth, 0);
  if (!target.IsComplete())
  {
    return false;
  }
  target.Clear(nullptr);
  frame.Shading->DrawDepths(frame, view);
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowVolumeCounter::Begin(const vtkShadowFrame& frame, const Eye& eye, int start)
{
  this->Scope.reset(new vtkShadowDrawScope(
    frame.Window, this->Depth, 0, this->UsesStencil ? nullptr : &this->Counts, 0));
  if (!this->Scope->IsComplete())
  {
    this->Scope.reset();
    return false;
  }
  this->Frame = &frame;
  this->State = frame.Window->GetState();
  this->CurrentEye = eye;
  this->State->vtkglDepthMask(GL_FALSE);
  this->State->vtkglDisable(GL_CULL_FACE);
  if (this->UsesStencil)
  {
    const GLint count = start & 0xff;
    this->State->vtkglStencilMask(0xff);
    glClearBufferiv(GL_STENCIL, 0, &count);
    this->State->vtkglEnable(GL_STENCIL_TEST);
    this->State->vtkglStencilFunc(GL_ALWAYS, 0, 0xff);
  }
  else
  {
    const float count[4] = { static_cast<float>(start), 0.0f, 0.0f, 0.0f };
    glClearBufferfv(GL_COLOR, 0, count);
    this->State->vtkglEnable(GL_BLEND);
    this->State->vtkglBlendEquation(GL_FUNC_ADD);
    this->State->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  }
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(0.0f, PushedBack);
  if (eye.UsesDepthClamp)
  {
    glEnable(GL_DEPTH_CLAMP);
  }

  glGenVertexArrays(1, &this->Arrays);
  glBindVertexArray(this->Arrays);
  this->Program = frame.Window->GetShaderCache()->ReadyShaderProgram(
    vtkStencilShadowVolumePassVS, vtkStencilShadowVolumePassFS, "");
  this->PointUnit = this->State->GetTextureUnitManager()->Allocate();
  this->State->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->PointUnit));
  this->Program->SetUniformi("shadowPointsTC", this->PointUnit);
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::SetRule(bool behind)
{
  // A tie counts as behind, so that a lit surface is not in the volume that starts on it.
  this->CountsBehind = behind;
  this->State->vtkglDepthFunc(behind && !this->UsesStencil ? GL_GEQUAL : GL_LESS);
}

//------------------------------------------------------------------------------
// Adds `front` for a face toward the eye, and `back` for one away from it.
void vtkShadowVolumeCounter::DrawSection(
  const vtkShadowVolumeCaster::Section& section, int front, int back)
{
  if (section.Count == 0)
  {
    return;
  }
  const auto count = static_cast<GLsizei>(section.Count);
  const auto* first = reinterpret_cast<const void*>(section.First * sizeof(std::uint32_t));
  int repeats = 1;
  if (this->UsesStencil)
  {
    const GLenum faces[2] = { GL_FRONT, GL_BACK };
    const int weights[2] = { front, back };
    for (int i = 0; i < 2; ++i)
    {
      const GLenum change = weights[i] > 0 ? GL_INCR_WRAP : GL_DECR_WRAP;
      this->State->vtkglStencilOpSeparate(faces[i], GL_KEEP, this->CountsBehind ? change : GL_KEEP,
        this->CountsBehind ? GL_KEEP : change);
    }
    repeats = std::abs(front);
  }
  else
  {
    const float weights[2] = { static_cast<float>(front), static_cast<float>(back) };
    this->Program->SetUniform2f("shadowWeights", weights);
  }
  for (int i = 0; i < repeats; ++i)
  {
    glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, first);
  }
  this->NumberOfTriangles += section.Count / 3;
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::Add(const Draw& draw)
{
  const int width = this->Frame->Size[0], height = this->Frame->Size[1];
  const glm::dvec3 low = 0.5 * draw.Bounds.minimum + 0.5, high = 0.5 * draw.Bounds.maximum + 0.5;
  const int left = std::max(static_cast<int>(std::floor(low.x * width)) - 1, 0);
  const int bottom = std::max(static_cast<int>(std::floor(low.y * height)) - 1, 0);
  const int right = std::min(static_cast<int>(std::ceil(high.x * width)) + 1, width);
  const int top = std::min(static_cast<int>(std::ceil(high.y * height)) + 1, height);
  if (right <= left || top <= bottom)
  {
    return;
  }
  this->State->vtkglEnable(GL_SCISSOR_TEST);
  this->State->vtkglScissor(left, bottom, right - left, top - bottom);

  const vtkShadowVolumeCaster& caster = *draw.Caster;
  const vtkShadowVolumeCaster::Volume& volume = *draw.Volume;
  const glm::dmat4 worldFromCaster = caster.GetWorldFromCaster();
  std::array<float, 16> clipFromCaster = ToFloats(this->CurrentEye.ClipFromWorld * worldFromCaster);
  this->Program->SetUniformMatrix4x4("shadowClipFromCaster", clipFromCaster.data());
  SetVector(this->Program, "shadowLightTC", volume.LightTC);
  // A plane is a row.
  const glm::dvec4 farRow =
    glm::dvec4(glm::dvec3(draw.FarPlaneWC), -draw.FarPlaneWC.w) * worldFromCaster;
  SetVector(this->Program, "shadowFarPlaneTC", glm::dvec4(glm::dvec3(farRow), -farRow.w));
  this->Program->SetUniformi("shadowAllAreImages", 0);
  this->Program->SetUniformi("shadowNearSide", 0);
  caster.BindPoints();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, volume.Buffer);

  // Behind a receiver a face away from the eye is where the way out of a volume is; before it, one
  // toward the eye is the way in. A mirrored caster shows its faces the other way round.
  const bool behind = draw.Faces == Rule::Fail;
  const int way = (behind ? -1 : 1) * (caster.IsMirrored() ? -1 : 1);
  this->SetRule(behind);
  this->DrawSection(volume.Singles, way, -way);
  this->DrawSection(volume.Doubles, 2 * way, -2 * way);
  if (behind)
  {
    this->DrawSection(volume.Caps, way, -way);
    this->DrawSection(volume.TurnedCaps, -way, way);
    if (draw.FarCaps)
    {
      this->Program->SetUniformi("shadowAllAreImages", 1);
      this->DrawSection(volume.Caps, -way, way);
      this->DrawSection(volume.TurnedCaps, way, -way);
    }
  }
  else if (draw.Faces == Rule::PassCapped)
  {
    // Every triangle between the light and the near plane shadows that, whichever way it is seen.
    const glm::dvec4& plane = this->CurrentEye.NearPlaneWC;
    this->Program->SetUniformi("shadowNearSide", glm::dot(plane, draw.LightWC) > 0.0 ? 1 : -1);
    SetVector(this->Program, "shadowNearPlaneTC", plane * worldFromCaster);
    glEnable(GL_CLIP_DISTANCE0);
    this->DrawSection(volume.Caps, 1, 1);
    this->DrawSection(volume.TurnedCaps, 1, 1);
    glDisable(GL_CLIP_DISTANCE0);
  }
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::End()
{
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  glBindVertexArray(0);
  glDeleteVertexArrays(1, &this->Arrays);
  glDisable(GL_DEPTH_CLAMP);
  glPolygonOffset(0.0f, 0.0f);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glBindTexture(GL_TEXTURE_BUFFER, 0);
  this->State->GetTextureUnitManager()->Free(this->PointUnit);
  this->PointUnit = -1;
  if (this->UsesStencil)
  {
    this->State->vtkglStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  }
  this->Scope.reset();
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::DrawFullScreen(
  const vtkShadowFrame& frame, vtkShadowTextureArray& source, bool isSum, float share, bool parity)
{
  vtkShaderProgram* program = frame.Window->GetShaderCache()->ReadyShaderProgram(
    vtkShadowFullScreenVS, vtkStencilShadowVolumePassResolveFS, "");
  source.Activate();
  program->SetUniformi("shadowCounts", source.Unit());
  program->SetUniformi("shadowParity", parity ? 1 : 0);
  program->SetUniformi("shadowIsSum", isSum ? 1 : 0);
  program->SetUniformf("shadowShare", share);
  const ScopedArrays arrays;
  glDrawArrays(GL_TRIANGLES, 0, 3);
  source.Deactivate();
}

//------------------------------------------------------------------------------
// By the stencil itself: lit everywhere, then shadow where the count is not 0, then lit again where
// it is negative.
void vtkShadowVolumeCounter::ResolveStencil(const vtkShadowFrame& frame, float share, bool parity)
{
  vtkOpenGLState* state = frame.Window->GetState();
  vtkShaderProgram* program = frame.Window->GetShaderCache()->ReadyShaderProgram(
    vtkShadowFullScreenVS, vtkStencilShadowVolumePassFS, "");
  const float value[2] = { share, share };
  program->SetUniform2f("shadowWeights", value);
  state->vtkglEnable(GL_STENCIL_TEST);
  state->vtkglStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  const ScopedArrays arrays;
  state->vtkglStencilFunc(GL_EQUAL, 0, parity ? 0x01 : 0xff);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  if (!parity)
  {
    state->vtkglStencilFunc(GL_EQUAL, 0x80, 0x80);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  state->vtkglDisable(GL_STENCIL_TEST);
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::Resolve(
  const vtkShadowFrame& frame, vtkShadowTextureArray& masks, int layer, bool parity)
{
  vtkShadowDrawScope target(frame.Window, this->Depth, 0, &masks, layer);
  frame.Window->GetState()->vtkglDisable(GL_DEPTH_TEST);
  if (this->UsesStencil)
  {
    const float shadow[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
    glClearBufferfv(GL_COLOR, 0, shadow);
    this->ResolveStencil(frame, 1.0f, parity);
    return;
  }
  this->DrawFullScreen(frame, this->Counts, false, 1.0f, parity);
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::ClearSum(const vtkShadowFrame& frame)
{
  vtkShadowDrawScope target(frame.Window, this->Depth, 0, &this->Sums, 0);
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 0, nothing);
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::AddToSum(const vtkShadowFrame& frame, float share, bool parity)
{
  vtkShadowDrawScope target(frame.Window, this->Depth, 0, &this->Sums, 0);
  vtkOpenGLState* state = frame.Window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  if (this->UsesStencil)
  {
    this->ResolveStencil(frame, share, parity);
    return;
  }
  this->DrawFullScreen(frame, this->Counts, false, share, parity);
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::ResolveSum(
  const vtkShadowFrame& frame, vtkShadowTextureArray& masks, int layer)
{
  vtkShadowDrawScope target(frame.Window, this->Depth, 0, &masks, layer);
  frame.Window->GetState()->vtkglDisable(GL_DEPTH_TEST);
  this->DrawFullScreen(frame, this->Sums, true, 1.0f, false);
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::ReadCounts(const vtkShadowFrame& frame, std::vector<float>& counts)
{
  counts.resize(static_cast<std::size_t>(frame.Size[0]) * frame.Size[1]);
  if (this->UsesStencil)
  {
    vtkShadowDrawScope target(frame.Window, this->Depth, 0);
    std::vector<unsigned char> stencil(counts.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(
      0, 0, frame.Size[0], frame.Size[1], GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    std::copy(stencil.begin(), stencil.end(), counts.begin());
    return;
  }
  vtkShadowDrawScope target(frame.Window, this->Depth, 0, &this->Counts, 0);
  glReadPixels(0, 0, frame.Size[0], frame.Size[1], GL_RED, GL_FLOAT, counts.data());
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::Release()
{
  this->Depth.Release();
  this->Counts.Release();
  this->Sums.Release();
}
