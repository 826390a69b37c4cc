// What vtkDepthShadowMapPass keeps, and what its files share. They are by subject:
// vtkDepthShadowMapPass (settings, memory), vtkDepthShadowMapPassMaps (how maps are drawn),
// vtkDepthShadowMapPassCode (shader text, and what shaders are given).
#ifndef vtkDepthShadowMapPassInternals_h
#define vtkDepthShadowMapPassInternals_h

#include "vtkDepthShadowMapPass.h"

#include "vtkShadowHiddenFaces.h"
#include "vtkShadowSampledLights.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowTransmittance.h"
#include "vtkShadowTriangleMaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

class vtkDepthShadowMapPass::Internals
{
public:
  using Vector = std::array<float, 4>;

  // Of an ordinary map, or of a light in Sampled.
  struct Slot
  {
    bool IsSampled = false;
    int Index = 0;
  };

  vtkShadowTextureArray Maps;    // what is sampled
  vtkShadowTextureArray Depths;  // one layer, where what is sampled is made of it
  vtkShadowTextureArray Moments; // one layer, between the axes of a blur
  vtkShadowSampledLights Sampled;
  vtkShadowHiddenFaces HiddenFaces;
  vtkShadowTriangleMaps Triangles; // of the filter EXACT
  vtkShadowTransmittance Transmittance;
  bool Transmits = false; // some caster of this frame attenuates
  std::vector<Slot> Slots;
  double SoftTexels = 0.0; // the widest kernel on a face of a cube, this frame
  int Room = 8;
  std::vector<Vector> Views;
  std::vector<Vector> Sides;
  std::string SampledShape;
  std::vector<bool> SampledSlots;
  vtkTimeStamp Stamp; // of what shaders are written with, beyond the superclass

  // What a format can tell apart, as depth, or as a share of the way from the near plane to the far
  // one.
  static double StepOf(int depthBits)
  {
    return depthBits == 8 ? 1.0 / 255.0 : std::ldexp(1.0, -std::min(depthBits, 24));
  }
};

#endif
