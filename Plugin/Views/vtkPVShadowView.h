/**
 * @class   vtkPVShadowView
 * @brief   ParaView's render view with a vtkShadowPass
 *
 * "Render View (Shadows)" in ParaView. The pass stays in place whatever the technique, so that the
 * render view may put it aside and back as it does for ray tracing (OSPRay, which has shadows of
 * its own) and for capturing values.
 *
 * Limits: under several processes each shadows its own part of the geometry.
 *
 * @sa vtkShadowPass
 */
#ifndef vtkPVShadowView_h
#define vtkPVShadowView_h

#include "vtkNew.h" // for the pass
#include "vtkPVRenderView.h"
#include "vtkShadowsPVViewsModule.h" // for export macro

#include <string> // for the explanation

class vtkShadowPass;

class VTKSHADOWSPVVIEWS_EXPORT vtkPVShadowView : public vtkPVRenderView
{
public:
  static vtkPVShadowView* New();
  vtkTypeMacro(vtkPVShadowView, vtkPVRenderView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Technique of every light: "auto" (default), "depth-map", "object-id", "planar",
   * "shadow-texture", "stencil-volume", "ray-cast" or "none". An unknown name is an error and
   * changes nothing.
   */
  void SetTechnique(const char* name);

  ///@{
  /**
   * What the lights of "auto" may cost, percent and milliseconds; 0 (default): none grossly wrong,
   * and any time. See vtkShadowPass::SetMaximumError. A bad value is an error and changes nothing.
   */
  void SetMaximumError(double percent);
  void SetMaximumFrameTime(double milliseconds);
  ///@}

  /**
   * Why each light has its technique, a line each by its number from 1 on, of the last frame that
   * this process drew; empty before it. See vtkShadowPass::GetExplanation.
   */
  const char* GetExplanation();

  ///@{
  /**
   * Of every light of the view, the light kit's too: its radius, 0 or more (default 0, hard
   * shadows; see vtkShadowPass::SetLightRadius), and how strong its shadows are, 0 to 1 (default,
   * no light where it is not seen). Another value is an error and changes nothing.
   */
  void SetLightRadius(double radius);
  void SetShadowStrength(double strength);
  ///@}

  /**
   * Texels on the longer side of each depth map or shadow texture, 1 or more (default 2048).
   */
  void SetResolution(int resolution);

  /**
   * Filter of depth maps, by name: see vtkDepthShadowMapPass::FilterType. An unknown name is an
   * error and changes nothing.
   */
  void SetFilter(const char* name);

  /**
   * Depth or object-ID maps of a directional light at most, 1 to 8 (default 1): see
   * vtkMapShadowPass::SetNumberOfCascades.
   */
  void SetNumberOfCascades(int number);

  /**
   * Whether object-ID maps hold a depth beside each ID (default on); else no source shadows itself.
   */
  void SetObjectDepths(bool combine);

  /**
   * What has an ID of its own in an object-ID map: "prop" (default), "block", "instance" or
   * "piece"; see vtkObjectIDShadowPass::SetObjectType. Another name is an error and changes
   * nothing.
   */
  void SetObjectType(const char* name);

  /**
   * How translucent sources cast: see vtkShadowPass::SetTranslucentCasting.
   */
  void SetTranslucentCasting(int how);

  /**
   * A shadow texture for each prop that casts (default off): see
   * vtkShadowTexturePass::SetTexturePerCaster.
   */
  void SetTexturePerCaster(bool each);

  /**
   * Leave out the faces of closed, opaque sources that are turned away from the eye (default off):
   * see vtkShadowPass::SetCullHiddenFaces.
   */
  void SetCullHiddenFaces(bool culled);

protected:
  vtkPVShadowView();
  ~vtkPVShadowView() override;

  void AboutToRenderOnLocalProcess(bool interactive) override;

private:
  vtkPVShadowView(const vtkPVShadowView&) = delete;
  void operator=(const vtkPVShadowView&) = delete;

  vtkNew<vtkShadowPass> Shadows;
  double LightRadius = 0.0;
  double ShadowStrength = 1.0;
  std::string Explanation;
};

#endif
