/**
 * @class   vtkMapShadowPass
 * @brief   abstract: a technique that looks a receiver up in a map made from its light
 *
 * What all techniques by maps have in common. Each light has a view, or as many as it needs: where
 * one cannot hold it (a point light amid its casters, or a spot wider than 78 degrees amid them), a
 * map for each face of a cube in which a caster can shadow a receiver. Views are fitted in double
 * to the casters that can shadow a receiver. Flat casters that have every receiver on their lit
 * side (the floor under a scene) are left out. A map is drawn again only if the light, a caster or
 * the fit changed.
 *
 * A technique says what its maps hold (DrawMap) and how a receiver is held against them
 * (GetCompareDeclarations); it knows of no kinds of light.
 *
 * @sa vtkDepthShadowMapPass vtkShadowTechniquePass
 */
#ifndef vtkMapShadowPass_h
#define vtkMapShadowPass_h

#include "vtkShadowTechniquePass.h"
#include "vtkTimeStamp.h" // for what shaders are written with

#include <memory> // for std::unique_ptr

class vtkShadowMapViews;
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
   * How far a surface may rise out of the receiver's plane beside it: what p is nearer to the light
   * by, in texels' widths as depth.
   */
  virtual double GetRiseTexels() const { return 0.5; }

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
  std::string GetLookupFunction(int slot, vtkProp*) const override;
  int GetLookupIndex(int slot) const override;
  const float* GetLookupMatrix(int slot, vtkProp*) const override;
  const float* GetLitMatrix() const override;
  void SetLookupParameters(vtkShaderProgram* program, vtkProp*) override;
  vtkMTimeType GetReceiverStamp() const override { return this->LookupStamp.GetMTime(); }

  const vtkShadowMapViews& GetViews() const { return *this->Views; }

  /**
   * Draw every map again, whatever changed.
   */
  void ForgetMaps();

  int Resolution = 2048;
  vtkIdType NumberOfMapBuilds = 0;

private:
  vtkMapShadowPass(const vtkMapShadowPass&) = delete;
  void operator=(const vtkMapShadowPass&) = delete;

  vtkTimeStamp LookupStamp; // of the functions and layers that shaders are written with
  std::unique_ptr<vtkShadowMapViews> Views;
};

#endif
