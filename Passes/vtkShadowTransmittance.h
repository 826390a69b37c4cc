// Maps of the translucent casters that attenuate light: beside the map of what is opaque, in each
// layer the depth of the nearest translucent surface, and the share of light that all of them let
// through which lie before what is opaque. What lies between two of them has the share of both.
#ifndef vtkShadowTransmittance_h
#define vtkShadowTransmittance_h

#include "vtkShadowTextureArray.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkShaderProgram;
struct vtkShadowFrame;
struct vtkShadowMapView;

class vtkShadowTransmittance
{
public:
  // Room for `layers` of width x height texels; true if what was in them is lost.
  bool Reserve(vtkOpenGLRenderWindow* window, int width, int height, int layers);
  bool IsReady() const { return this->Depths.Id() != 0 && this->Shares.Id() != 0; }
  void Release();

  // Into the layer of `view`, at its lower left width x height texels; `casters`: the translucent
  // ones. `opaque`, `layer`: the depths of what is opaque in the same view.
  void Draw(const vtkShadowFrame& frame, const vtkShadowMapView& view,
    const std::vector<std::size_t>& casters, const vtkShadowTextureArray& opaque, int layer,
    int width, int height);

  // GLSL that makes of the function `shadowDepthMapCompare` in `opaque` one that counts both.
  static std::string Declarations(const std::string& opaque);
  void SetParameters(vtkShaderProgram* program) const;
  void Activate();
  void Deactivate();

  std::size_t Bytes() const { return this->Depths.Bytes() + this->Shares.Bytes(); }

private:
  vtkShadowTextureArray Depths;
  vtkShadowTextureArray Shares;
};

#endif
