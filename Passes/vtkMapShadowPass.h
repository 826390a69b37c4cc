/**
 * @class   vtkMapShadowPass
 * @brief   abstract: a technique that looks a receiver up in a map made from its light
 *
 * What all techniques by maps have in common. Each light has a view, or as many as it needs: where
 * one cannot hold it (a point light amid its casters, or a spot wider than 78 degrees amid them), a
 * map for each face of a cube in which a caster can shadow a receiver. Views are fitted in double
 * to the casters that can shadow a receiver. Flat casters that have every receiver on their lit
 * side (the floor under a scene) are left out. A map is drawn again only if the light, a caster or
 * the fit changed. A light of which no shadow can lie in the view has no map.
 *
 * A directional light may have cascades (SetNumberOfCascades): for a scene that reaches far beyond
 * what is near to the eye.
 *
 * A technique says what its maps hold (DrawMap) and how a receiver is held against them
 * (GetCompareDeclarations); it knows of no kinds of light.
 *
 * @par Reference
 * Zhang, Sun, Xu and Lun: Parallel-split shadow maps for large-scale virtual environments, VRCIA
 * 2006 (cascades, and how they split); Engel: Cascaded shadow maps, ShaderX5, 2006; Valient: Stable
 * rendering of cascaded shadow maps, ShaderX6, 2008 (texels fixed in the world); Stamminger and
 * Drettakis: Perspective shadow maps, SIGGRAPH 2002 (what makes texels too large: "texel-density").
 *
 * @sa vtkDepthShadowMapPass vtkShadowTechniquePass
 */
#ifndef vtkMapShadowPass_h
#define vtkMapShadowPass_h

#include "vtkShadowTechniquePass.h"
#include "vtkTimeStamp.h" // for what shaders are written with

#include <memory> // for std::unique_ptr
#include <vector> // for rows

class vtkCamera;
class vtkShadowMapViews;
class vtkShadowTextureBuffer;
struct vtkShadowMapRoles;
struct vtkShadowMapSlot;
struct vtkShadowMapView;

class VTKSHADOWSPASSES_EXPORT vtkMapShadowPass : public vtkShadowTechniquePass
{
public:
  vtkTypeMacro(vtkMapShadowPass, vtkShadowTechniquePass);
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

  ///@{
  /**
   * How many views a directional light has at most, 1 to 8 (default 1): each serves what is up to
   * some distance from the eye, and has texels as fine as that asks for. The last is the one view
   * of all casters where its texels are fine enough, which then follows no eye. Fewer are made
   * where more would not make texels finer by a half, so that a small scene has one. Spot and point
   * lights have none, and a parallel camera has one, confined as by SetConfineToView. While the
   * camera moves, a map is drawn again only once what it must hold leaves it, and its texels stay
   * where they were in the world. Another number is an error and changes nothing.
   */
  void SetNumberOfCascades(int number);
  vtkGetMacro(NumberOfCascades, int);
  ///@}

  enum CascadeSchemeType
  {
    // LOGARITHMIC and UNIFORM, blended by the weight, from no nearer than a 700th of the way
    PRACTICAL = 0,
    LOGARITHMIC = 1, // each cascade reaches as many times as far as the one before it
    UNIFORM = 2      // each reaches farther by the same distance
  };

  ///@{
  /**
   * How cascades split the distances between the camera's near plane (or the nearest receiver's
   * bounds) and where they end: one of CascadeSchemeType (default PRACTICAL), or its name
   * ("practical", "logarithmic", "uniform"); and the share of LOGARITHMIC in PRACTICAL, 0 to 1
   * (default 1). Else an error, and nothing changes.
   */
  void SetCascadeScheme(int scheme);
  void SetCascadeScheme(const std::string& name);
  vtkGetMacro(CascadeScheme, int);
  static std::string GetCascadeSchemeName(int scheme);
  void SetCascadeWeight(double weight);
  vtkGetMacro(CascadeWeight, double);
  ///@}

  ///@{
  /**
   * The share of a cascade's reach over which it blends into the next, 0 (a seam) to 1 (default
   * 0.1): there, more and more pixels are looked up in the next, in a grain that is fixed on the
   * screen. Else an error, and nothing changes.
   */
  void SetCascadeBlend(double blend);
  vtkGetMacro(CascadeBlend, double);
  ///@}

  ///@{
  /**
   * Confine the single view of a light, directional or spot, to the receivers in view, its sides on
   * a grid of sixteenths of the whole (default off). Texels are finer in close-ups; but a map is
   * drawn again whenever a side moves on, and its edges shift then by a part of a texel.
   */
  vtkSetMacro(ConfineToView, bool);
  vtkGetMacro(ConfineToView, bool);
  vtkBooleanMacro(ConfineToView, bool);
  ///@}

  ///@{
  /**
   * The camera that views are fitted to; nullptr (default): the renderer's own. With another,
   * cascades can be looked at from elsewhere. What that one does not see may be lit.
   */
  void SetFitCamera(vtkCamera* camera);
  vtkCamera* GetFitCamera() const;
  ///@}

  ///@{
  /**
   * Counts of the last frame: views, each with a map; lights that had none because none of their
   * shadows can lie in the view; and casters that a view did not draw, summed over the views.
   */
  int GetNumberOfViews() const;
  int GetNumberOfSkippedLights() const;
  int GetNumberOfCastersLeftOut() const;
  ///@}

  /**
   * Maps drawn since this pass was made: grows only when a light, a caster or a fit changed.
   */
  vtkGetMacro(NumberOfMapBuilds, vtkIdType);

  VisibilityForm GetVisibilityForm() const override { return LOOKUP; }
  void ReleaseGraphicsResources(vtkWindow* w) override;

protected:
  vtkMapShadowPass();
  ~vtkMapShadowPass() override;

  ///@{
  /**
   * What the names of the lookup's functions and uniforms begin with ("shadowDepthMap"), in
   * capitals for its macros ("SHADOW_DEPTH_MAP"), and GLSL that declares `float <prefix>Compare(int
   * layer, vec3 p, vec2 slope)`, the visibility of a receiver at p (texels of the layer, and depth
   * there less the bound of its rounding); slope: of the receiver's plane, in depth per texel.
   * <MACRO>_WIDTH and _HEIGHT are a layer's texels.
   */
  virtual std::string GetLookupPrefix() const = 0;
  virtual std::string GetMacroPrefix() const = 0;
  virtual std::string GetCompareDeclarations() const = 0;
  ///@}

  /**
   * Texels that stay free on each side of a map, so that all that are compared lie in it.
   */
  virtual double GetMarginTexels() const { return 2.0; }

  /**
   * Whether what maps hold is linear in the distance from the light; else the driver's depth.
   */
  virtual bool HasDistances() const { return false; }

  /**
   * How far a surface may rise out of the receiver's plane beside it: what p is nearer to the light
   * by, in texels' widths as depth.
   */
  virtual double GetRiseTexels() const { return 0.5; }

  /**
   * Who casts and receives, and which maps there are.
   */
  virtual vtkShadowMapRoles GetRoles(const vtkShadowFrame& frame) const;

  ///@{
  /**
   * Room for `layers` maps of width x height texels; true if what was in them is lost.
   * GetTextures() has no texture afterwards if memory ran out.
   */
  virtual bool ReserveMaps(const vtkShadowFrame& frame, int width, int height, int layers) = 0;
  /**
   * Ahead of the maps of a frame, and one of them into view.Layer, at the lower left of it
   * width x height texels; what lies around it must say that nothing casts there.
   */
  virtual void BeginMaps(const vtkShadowFrame&) {}
  virtual void DrawMap(const vtkShadowFrame& frame, const vtkShadowMapSlot& slot,
    const vtkShadowMapView& view, int width, int height) = 0;
  ///@}

  bool UpdateVisibility(const vtkShadowFrame& frame, const std::vector<int>& lights) override;
  std::string GetLookupDeclarations() const override;
  vtkShadowVertexCode GetLookupCode(bool byVertex) const override;
  std::string GetLookupFunction(int slot, vtkProp*) const override;
  int GetLookupIndex(int slot) const override;
  const float* GetLookupMatrix(int slot, vtkProp*) const override;
  const float* GetLitMatrix() const override;
  void SetLookupParameters(vtkShaderProgram* program, vtkProp*) override;
  void ActivateTextures() override;
  void DeactivateTextures() override;
  vtkMTimeType GetReceiverStamp() const override { return this->LookupStamp.GetMTime(); }

  std::vector<std::string> GetDebugViews() const override;
  bool DrawDebugView(const vtkShadowFrame& frame, int slot, const std::string& view) override;

  /**
   * GLSL that all techniques by maps share, with the names of this one.
   */
  std::string Named(const char* text) const;

  const vtkShadowMapViews& GetViews() const { return *this->Views; }

  /**
   * Draw every map again, whatever changed; or those of a slot, once BeginMaps is called.
   */
  void ForgetMaps();
  void ForgetMaps(std::size_t slot);

  /**
   * Say that shaders must be written anew, with other declarations.
   */
  void LookupChanged() { this->LookupStamp.Modified(); }

  int Resolution = 2048;
  int NumberOfCascades = 1;
  int CascadeScheme = PRACTICAL;
  double CascadeWeight = 1.0;
  double CascadeBlend = 0.1;
  bool ConfineToView = false;
  vtkIdType NumberOfMapBuilds = 0;

private:
  vtkMapShadowPass(const vtkMapShadowPass&) = delete;
  void operator=(const vtkMapShadowPass&) = delete;

  void UploadRows(const vtkShadowFrame& frame);
  void SetShare(const char* name, double share, double& setting);

  vtkSmartPointer<vtkCamera> FitCamera;
  vtkTimeStamp LookupStamp; // of the functions and layers that shaders are written with
  std::unique_ptr<vtkShadowMapViews> Views;
  std::unique_ptr<vtkShadowTextureBuffer> Rows;
};

#endif
