#include "vtkPlanarShadowPassInternals.h"

#include "vtkShadowMatrix.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{

using vtkshadows::BoxCorners;

// Texels left free on each side of a plane's texture.
constexpr double MarginTexels = 2.0;

// A height, in roundings, at which no receiver lies on a plane.
constexpr double OffEveryPlane = 2.0;

}

//------------------------------------------------------------------------------
bool vtkPlanarShadowPass::Internals::UpdateTextures(
  const vtkShadowFrame& frame, int side, bool anySoft)
{
  this->Masks.Release();
  this->Depths.Release();
  this->PlanesOfPixels.Release();
  this->Canvas.Release();
  const std::size_t planes = std::max<std::size_t>(this->Planes.Get().size(), 1);
  const std::size_t layers = static_cast<std::size_t>(std::max(this->NumberOfSlots, 1)) * planes;
  if (this->Textures.Reserve(
        frame.Window, vtkShadowTextureArray::Format::R8, side, side, static_cast<int>(layers)))
  {
    this->Textures.Smooth();
    this->States.clear();
  }
  if (!this->Textures.Id() || !this->TextureCanvas.Reserve(frame, side, side, anySoft))
  {
    return false;
  }
  this->States.resize(layers);
  // Lit: the corner of a layer is never drawn to.
  glm::dmat4 lit(0.0);
  lit[3] = { 0.0, 0.0, 0.0, 1.0 };
  this->TextureFromView.assign(layers, lit);
  lit[3].w = OffEveryPlane;
  this->AnyTextureFromView.assign(layers, lit);
  for (Shadow& shadow : this->Shadows)
  {
    this->UpdateTexture(frame, shadow);
  }
  this->MostPlanesOfProp = 1;
  for (const std::size_t i : this->Planes.ShadowedProps())
  {
    this->MostPlanesOfProp = std::max(this->MostPlanesOfProp,
      this->Planes.ShadowedPlanesOf(frame.Scene->GetProps()[i].Source)->size());
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::Internals::UpdateTexture(const vtkShadowFrame& frame, Shadow& shadow)
{
  const int side = this->Textures.Width();
  const vtkShadowPlanes::Plane& plane = this->Planes.Get()[shadow.Plane];
  const std::size_t layer = this->LayerOf(shadow.Slot, shadow.Plane);
  const vtkshadows::PlaneFrame onPlane(plane.PlaneWC);
  const int method = this->Self->SoftMethod == PLATEAUS ? SAMPLE_LIGHTS : this->Self->SoftMethod;
  shadow.Throws = ThrowsOf(shadow, ProbingSamples, method);

  // Where its receivers and the shadow meet.
  TextureState wanted;
  if (!vtkshadows::BoundsOnPlane(shadow.PlaneWC, onPlane, plane.Corners, shadow.CasterCorners,
        shadow.Throws, MarginTexels / side, wanted.Low, wanted.High))
  {
    return;
  }
  const glm::dvec2 size = wanted.High - wanted.Low;
  const double longer = std::max(size.x, size.y);
  for (int axis = 0; axis < 2; ++axis)
  {
    wanted.Texels[axis] =
      std::clamp(static_cast<int>(std::ceil(side * size[axis] / longer)), 1, side);
    wanted.High[axis] = wanted.Low[axis] + wanted.Texels[axis] * longer / side; // square texels
  }
  const glm::dmat4 clipFromWorld = onPlane.ClipFromWorld(wanted.Low, wanted.High);
  this->ChooseThrows(shadow, clipFromWorld, wanted.Texels[0], wanted.Texels[1]);
  wanted.Drawn = true;
  wanted.PlaneWC = shadow.PlaneWC;
  wanted.Throws = shadow.Throws;
  wanted.Plateaus = this->IsSum(*shadow.Light) ? 0.0 : shadow.Light->radius;
  wanted.Casters = shadow.Casters;
  wanted.CasterStamp = frame.Scene->GetCasterStamp();
  if (!(this->States[layer] == wanted))
  {
    this->TextureCanvas.KeepTo(wanted.Texels[0], wanted.Texels[1]);
    this->TextureCanvas.Begin(
      frame, this->Textures, static_cast<int>(layer), this->IsSum(*shadow.Light));
    this->TextureCanvas.MarkAll(frame);
    // It is looked at from where its normal points, whichever side the light is on.
    this->Draw(frame, this->TextureCanvas, shadow, clipFromWorld, shadow.PlaneWC != plane.PlaneWC,
      [&]() { this->TextureCanvas.MarkAll(frame); });
    this->TextureCanvas.End(frame);
    this->States[layer] = wanted;
    ++this->Self->NumberOfTextureBuilds;
  }

  // Clip space of the texture, to the share of its layer that it fills.
  const glm::dmat4 clipFromView = clipFromWorld * glm::inverse(frame.ViewFromWorld);
  const glm::dvec2 half =
    0.5 * glm::dvec2(wanted.Texels[0], wanted.Texels[1]) / static_cast<double>(side);
  const glm::dvec4 one(0.0, 0.0, 0.0, 1.0);
  glm::dmat4 textureFromView(0.0);
  textureFromView = glm::row(textureFromView, 0, half.x * (glm::row(clipFromView, 0) + one));
  textureFromView = glm::row(textureFromView, 1, half.y * (glm::row(clipFromView, 1) + one));
  textureFromView = glm::row(textureFromView, 2, static_cast<double>(layer) * one);
  this->TextureFromView[layer] = glm::row(textureFromView, 3, one);

  // Its height, in units of what positions in view coordinates are rounded by.
  double farthest = 0.0;
  for (const BoxCorners& corners : plane.Corners)
  {
    for (const glm::dvec3& corner : corners)
    {
      farthest =
        std::max(farthest, glm::length(glm::dvec3(frame.ViewFromWorld * glm::dvec4(corner, 1.0))));
    }
  }
  const double rounding = this->Planes.Tolerance() + std::ldexp(farthest, -20);
  const glm::dvec4 height =
    glm::dvec4(glm::dvec3(plane.PlaneWC), -plane.PlaneWC.w) * glm::inverse(frame.ViewFromWorld);
  this->AnyTextureFromView[layer] = glm::row(textureFromView, 3, height / rounding);
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowPass::GetPlaneTexture(vtkLight* light, int plane, vtkImageData* texture)
{
  Internals& my = *this->Internal;
  const auto found = std::find(my.Lights.begin(), my.Lights.end(), light);
  const int planes = this->GetNumberOfPlanes();
  const std::size_t layer =
    static_cast<std::size_t>(found - my.Lights.begin()) * static_cast<std::size_t>(planes) +
    static_cast<std::size_t>(std::max(plane, 0));
  const bool exists = light && texture && found != my.Lights.end() && plane >= 0 &&
    plane < planes && layer < my.States.size() && my.States[layer].Drawn;
  std::vector<unsigned char> texels;
  if (!exists || !my.Textures.Download(static_cast<int>(layer), texels))
  {
    vtkErrorMacro("GetPlaneTexture(" << light << ", " << plane << ", " << texture
                                     << "): the last frame drew no such texture. It had " << planes
                                     << " planes; turn PlaneTextures on, give the light the "
                                        "technique \"planar\" and render.");
    return false;
  }
  const Internals::TextureState& state = my.States[layer];
  const int side = my.Textures.Width();
  texture->SetDimensions(state.Texels[0], state.Texels[1], 1);
  texture->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* out = static_cast<unsigned char*>(texture->GetScalarPointer());
  for (int row = 0; row < state.Texels[1]; ++row)
  {
    std::copy_n(texels.begin() + static_cast<std::ptrdiff_t>(row) * side, state.Texels[0],
      out + static_cast<std::ptrdiff_t>(row) * state.Texels[0]);
  }
  texture->GetPointData()->GetScalars()->SetName("Visibility");
  const vtkshadows::PlaneFrame onPlane(my.Planes.Get()[static_cast<std::size_t>(plane)].PlaneWC);
  const glm::dvec2 spacing =
    (state.High - state.Low) / glm::dvec2(state.Texels[0], state.Texels[1]);
  const glm::dvec2 first = state.Low + 0.5 * spacing;
  const glm::dvec3 originWC = onPlane.origin + first.x * onPlane.u + first.y * onPlane.v;
  texture->SetOrigin(originWC.x, originWC.y, originWC.z);
  texture->SetSpacing(spacing.x, spacing.y, 1.0);
  texture->SetDirectionMatrix(onPlane.u.x, onPlane.v.x, onPlane.normal.x, onPlane.u.y, onPlane.v.y,
    onPlane.normal.y, onPlane.u.z, onPlane.v.z, onPlane.normal.z);
  texture->Modified();
  return true;
}

//------------------------------------------------------------------------------
const float* vtkPlanarShadowPass::GetLookupMatrix(int slot, vtkProp* prop) const
{
  Internals& my = *this->Internal;
  my.LookupMatrix = my.MostPlanesOfProp > 1
    ? vtkShadowMatrix::ToFloats(glm::dmat4(1.0))
    : vtkShadowMatrix::ToFloats(
        my.TextureFromView[my.LayerOf(slot, my.Planes.ShadowedPlanesOf(prop)->front())]);
  return my.LookupMatrix.data();
}

const float* vtkPlanarShadowPass::GetLitMatrix() const
{
  // The corner of a layer is never drawn to; and no place is on a plane.
  static const float lit[16] = { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1 };
  return lit;
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::SetLookupParameters(vtkShaderProgram* program, vtkProp* prop)
{
  Internals& my = *this->Internal;
  if (!this->PlaneTextures || my.MostPlanesOfProp == 1)
  {
    return;
  }
  // Every slot's planes of this prop, one slot after the other.
  const std::vector<std::size_t>* planes = my.Planes.ShadowedPlanesOf(prop);
  const std::size_t count = planes ? planes->size() : 0;
  std::vector<float> matrices;
  for (int slot = 0; planes && slot < my.NumberOfSlots; ++slot)
  {
    for (const std::size_t plane : *planes)
    {
      const std::array<float, 16> matrix =
        vtkShadowMatrix::ToFloats(my.AnyTextureFromView[my.LayerOf(slot, plane)]);
      matrices.insert(matrices.end(), matrix.begin(), matrix.end());
    }
  }
  program->SetUniformi("shadowPlaneCount", static_cast<int>(count));
  if (!matrices.empty())
  {
    program->SetUniformMatrix4x4v(
      "shadowPlaneFromView", static_cast<int>(matrices.size() / 16), matrices.data());
  }
}
