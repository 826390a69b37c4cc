/**
 * @class   vtkDepthShadowMapPass
 * @brief   visibility by a depth map, compared with the receiver's own plane
 *
 * Technique "depth-map", form lookup: casters are drawn from the light into a map of depths; while
 * a receiver is shaded, its position is compared with the four texels around it and the four
 * answers are blended (2x2 percentage-closer filtering). Directional, spot and point lights.
 *
 * A map is fitted in double to the casters that can shadow a receiver. Flat casters that have
 * every receiver on their lit side (the floor under a scene) are left out of it. Where one view
 * cannot hold the light (a point light amid its casters, or a spot wider than 78 degrees amid
 * them), it has a map for each face of a cube in which a caster can shadow a receiver. A map is
 * drawn again only if the light, a caster or the fit changed; GetNumberOfMapBuilds counts.
 *
 * Bias is automatic: each texel's depth is compared at that texel's centre on the receiver's own
 * plane there, with a slack of half a texel, along the plane's slope and in depth, plus the
 * rounding bound of the position and of the map. Where the four texels are of one curved surface,
 * what is not behind it is lit. There is no constant to tune.
 *
 * Limits: an edge is as sharp as the map's texels; a contact shadow thinner than half a texel
 * of slope is lost. Embossed detail below a texel is not seen. Lines and points cast as wide as
 * they are drawn, in texels.
 *
 * @par Reference
 * Williams 1978 (depth maps); Reeves, Salesin and Cook: Rendering antialiased shadows with depth
 * maps, SIGGRAPH 1987 (percentage-closer filtering); Gerasimov: Omnidirectional shadow mapping, GPU
 * Gems 2004 (six faces of a cube); Isidoro: Shadow mapping, GDC 2006 (receiver
 * plane); Dou, Yan, Kerzner, Dai and Wyman: Adaptive depth bias for shadow maps, I3D 2014.
 *
 * @sa vtkShadowPass vtkRayCastShadowPass
 */
#ifndef vtkDepthShadowMapPass_h
#define vtkDepthShadowMapPass_h

#include "vtkShadowTechniquePass.h"
#include "vtkTimeStamp.h" // for what shaders are written with

#include <memory> // for std::unique_ptr

class VTKSHADOWSPASSES_EXPORT vtkDepthShadowMapPass : public vtkShadowTechniquePass
{
public:
  static vtkDepthShadowMapPass* New();
  vtkTypeMacro(vtkDepthShadowMapPass, vtkShadowTechniquePass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Texels on the longer side of each map, 1 or more (default 2048); the shorter side has as many
   * as its length asks for, so that texels are square. Of a cube, each face has them. Above the
   * driver's limit: an error at the next frame that names the limit, which is then used.
   */
  void SetResolution(int resolution);
  vtkGetMacro(Resolution, int);
  ///@}

  /**
   * Maps drawn since this pass was made: grows only when a light, a caster or a fit changed.
   */
  vtkGetMacro(NumberOfMapBuilds, vtkIdType);

  const char* GetTechniqueName() const override { return "depth-map"; }
  VisibilityForm GetVisibilityForm() const override { return LOOKUP; }
  void ReleaseGraphicsResources(vtkWindow* w) override;

protected:
  vtkDepthShadowMapPass();
  ~vtkDepthShadowMapPass() override;

  bool UpdateVisibility(const vtkShadowFrame& frame, const std::vector<int>& lights) override;
  std::string GetLookupDeclarations() const override;
  std::string GetLookupFunction(int slot, vtkProp*) const override;
  int GetLookupIndex(int slot) const override;
  const float* GetLookupMatrix(int slot, vtkProp*) const override;
  const float* GetLitMatrix() const override;
  void SetLookupParameters(vtkShaderProgram* program, vtkProp*) override;
  vtkMTimeType GetReceiverStamp() const override { return this->LookupStamp.GetMTime(); }
  vtkShadowTextureArray* GetTextures() override;
  std::string GetSamplerName() const override { return "shadowDepthMaps"; }

  int Resolution = 2048;
  vtkIdType NumberOfMapBuilds = 0;

private:
  vtkDepthShadowMapPass(const vtkDepthShadowMapPass&) = delete;
  void operator=(const vtkDepthShadowMapPass&) = delete;

  vtkTimeStamp LookupStamp; // of the functions and layers that shaders are written with
  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
