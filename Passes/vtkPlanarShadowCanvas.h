// Where flattened casters are drawn: a stencil that keeps to a plane's pixels and lets each of them
// be darkened once, a depth that keeps to what lies above the plane, and the sum of several shadows
// of one light. One for the viewport, one for the planes' textures.
#ifndef vtkPlanarShadowCanvas_h
#define vtkPlanarShadowCanvas_h

#include "LightView.h"
#include "ShadowPlateaus.h"
#include "vtkShadowTextureArray.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <unordered_map>
#include <vector>

class vtkProp;
struct vtkShadowFrame;

class vtkPlanarShadowCanvas
{
public:
  // Room for width x height pixels, and for sums of shadows if `sums`. false if the driver has
  // none.
  bool Reserve(const vtkShadowFrame& frame, int width, int height, bool sums);

  // What the eye sees of the opaque `props`, by `view`: into `planes` (RG32F), on which planes they
  // have receivers, as a sum of powers of two for each, and the depth of their surface. `depths`
  // tells what is in front, as in the frame. Textures of the same size. false if the driver cannot.
  bool DrawReceivers(const vtkShadowFrame& frame, vtkShadowTextureArray& depths,
    vtkShadowTextureArray& planes, const vtkshadows::LightView& view,
    const std::vector<std::size_t>& props, const std::vector<float>& planesOfProps);

  // Keep to the lower left width x height pixels; to those whose receiver lies between two planes,
  // told by its depth as vtkshadows::DepthOnPlane gives it; to those that `props` cover, hidden or
  // not; to all, but for a rim of one pixel; or to none.
  void KeepTo(int width, int height);
  // `bit`: the plane's, among those that DrawReceivers was told; `slack` pixels: by so much its
  // receivers' outline may be drawn elsewhere.
  void MarkPlane(const vtkShadowFrame& frame, vtkShadowTextureArray& planes, float bit,
    const glm::dvec3& depthBeneath, const glm::dvec3& depthAbove, double slack);
  void MarkReceivers(const vtkShadowFrame& frame, const vtkshadows::LightView& view,
    const std::vector<std::size_t>& props);
  void MarkAll(const vtkShadowFrame& frame);
  void MarkNothing(const vtkShadowFrame& frame);

  // Start a light: all of `layer` is lit.
  void Begin(const vtkShadowFrame& frame, vtkShadowTextureArray& masks, int layer, bool isSoft);
  // Darken the marked pixels that casters cover by `share` of the light, each once. false if the
  // marks are used up: mark again, and go on.
  // `culled`: as vtkShadowedShadingPass::DrawCasters has it.
  bool Throw(const vtkShadowFrame& frame, const std::vector<std::size_t>& casters,
    const vtkshadows::LightView& view, const std::unordered_map<vtkProp*, unsigned int>& culled,
    float share);
  // Plateaus, by their triangles: the least visibility stays. Of a hard light, after Throw.
  void DrawPlateaus(const vtkShadowFrame& frame, const glm::dmat4& clipFromPlateau,
    const std::vector<vtkshadows::PlateauVertex>& triangles);
  void End(const vtkShadowFrame& frame);

  void Release();
  std::size_t Bytes() const { return this->Marks.Bytes() + this->Sums.Bytes(); } // of textures

private:
  void ClearMarks(const vtkShadowFrame& frame, int mark);

  vtkShadowTextureArray Marks, Sums;
  vtkShadowTextureArray* Masks = nullptr;
  int Layer = 0;
  bool IsSoft = false;
  int UsedMarks = 0;
  int Rim = 0;
  int Extent[2] = { 0, 0 };
};

#endif
