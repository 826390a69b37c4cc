/**
 * @class   vtkDepthShadowMapPass
 * @brief   visibility by a depth map, compared with the receiver's own plane
 *
 * Technique "depth-map", form lookup: casters are drawn from the light into a map of depths; while
 * a receiver is shaded, its position is compared with the four texels around it and the four
 * answers are blended (2x2 percentage-closer filtering). Directional, spot and point lights; which
 * views they have, and when a map is drawn again, see vtkMapShadowPass.
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

#include "vtkMapShadowPass.h"

class VTKSHADOWSPASSES_EXPORT vtkDepthShadowMapPass : public vtkMapShadowPass
{
public:
  static vtkDepthShadowMapPass* New();
  vtkTypeMacro(vtkDepthShadowMapPass, vtkMapShadowPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum FilterType
  {
    PERCENTAGE_CLOSER = 0, // four texels, each against the receiver's plane at its centre, blended
    EXACT = 1              // the triangles that four texels show, followed to the receiver
  };

  ///@{
  /**
   * How a receiver is held against the map: one of FilterType (default PERCENTAGE_CLOSER), or its
   * name: "percentage-closer", "exact". Another one is an error that lists the known ones, and
   * changes nothing.
   */
  void SetFilter(int filter);
  void SetFilter(const std::string& name);
  vtkGetMacro(Filter, int);
  static std::string GetFilterName(int filter);
  static int GetNumberOfFilters();
  ///@}

  const char* GetTechniqueName() const override { return "depth-map"; }
  void ReleaseGraphicsResources(vtkWindow* w) override;

protected:
  vtkDepthShadowMapPass();
  ~vtkDepthShadowMapPass() override;

  std::string GetLookupPrefix() const override { return "shadowDepthMap"; }
  std::string GetMacroPrefix() const override { return "SHADOW_DEPTH_MAP"; }
  std::string GetCompareDeclarations() const override;
  bool ReserveMaps(const vtkShadowFrame& frame, int width, int height, int layers) override;
  void BeginMaps(const vtkShadowFrame& frame) override;
  void DrawMap(const vtkShadowFrame& frame, const vtkShadowMapSlot& slot,
    const vtkShadowMapView& view, int width, int height) override;
  bool UpdateVisibility(const vtkShadowFrame& frame, const std::vector<int>& lights) override;
  vtkShadowTextureArray* GetTextures() override;
  void ActivateTextures() override;
  void DeactivateTextures() override;
  void SetLookupParameters(vtkShaderProgram* program, vtkProp* prop) override;
  std::string GetSamplerName() const override { return "shadowDepthMaps"; }

  int Filter = PERCENTAGE_CLOSER;

private:
  vtkDepthShadowMapPass(const vtkDepthShadowMapPass&) = delete;
  void operator=(const vtkDepthShadowMapPass&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
