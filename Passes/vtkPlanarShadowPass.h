/**
 * @class   vtkPlanarShadowPass
 * @brief   visibility on planes: casters flattened onto them, exact to the pixel
 *
 * Technique "planar", form mask (with textures, lookup): for each light and receiving plane the
 * casters are drawn through VTK's own mappers, flattened by the projection from the light onto the
 * plane, over the pixels that show that plane. The cheapest exact shadow there is, for what most
 * figures show: objects over a floor. Directional, spot and point lights; casters of every kind
 * that VTK's mappers draw, lines, points and impostors included.
 *
 * Planes are found: flat receivers, and the larger flat sides of receivers with few faces (a table,
 * a room). Planes may be named, too (AddPlane); a receiver takes the shadow of a plane where it
 * lies on it, told by its depth. What beneath the plane, or farther from it than the light, does
 * not cast, to the pixel. Nothing is drawn twice as dark, and nothing fights for depth: what leaves
 * the technique is visibility.
 *
 * A light with a radius is soft, in one of three ways (SetSoftMethod), with as many shadows as its
 * widest penumbra has pixels, up to a budget.
 *
 * With textures (SetPlaneTextures), a light's shadow on a plane is drawn into a texture that is
 * fixed in the world, again only if the light, a caster or the plane changed. A moving camera then
 * draws no caster twice, for edges as coarse as the texels.
 *
 * Limits: receivers that are not flat are lit, and nothing shadows itself; where a scene has no
 * plane at all, one warning. The mask is one answer a pixel: multisampling does not refine it.
 * Translucent receivers are lit, but with textures they are shadowed.
 *
 * @par Reference
 * Blinn, J.: Me and my (fake) shadow, IEEE CG&A 8(1), 1988; Heckbert, P. and Herf, M.: Simulating
 * soft shadows with graphics hardware, CMU-CS-97-104, 1997; Gooch, B., Sloan, P.-P., Gooch, A.,
 * Shirley, P. and Riesenfeld, R.: Interactive technical illustration, I3D 1999 (offset planes);
 * Haines, E.: Soft planar shadows using plateaus, Journal of Graphics Tools 6(1), 2001.
 *
 * @sa vtkShadowPass vtkRayCastShadowPass
 */
#ifndef vtkPlanarShadowPass_h
#define vtkPlanarShadowPass_h

#include "vtkShadowTechniquePass.h"

#include <memory> // for std::unique_ptr

class vtkImageData;
class vtkLight;

class VTKSHADOWSPASSES_EXPORT vtkPlanarShadowPass : public vtkShadowTechniquePass
{
public:
  static vtkPlanarShadowPass* New();
  vtkTypeMacro(vtkPlanarShadowPass, vtkShadowTechniquePass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name a plane normal.x = offset that receives, in world coordinates; the normal has any length
   * but 0, and offset is in the units of normal.x. false, with an error, for a normal without a
   * direction or a number that is not finite: nothing changed.
   */
  bool AddPlane(double nx, double ny, double nz, double offset);
  void RemoveAllPlanes();
  ///@}

  ///@{
  /**
   * Find planes in the scene, beside those that are named (on, default): receivers that are flat;
   * the sides of receivers with at most 16 (a box, a table); and of others with at most 4096 cells
   * those sides that make 1/8 of their area and more.
   */
  vtkSetMacro(AutomaticPlanes, bool);
  vtkGetMacro(AutomaticPlanes, bool);
  vtkBooleanMacro(AutomaticPlanes, bool);
  ///@}

  ///@{
  /**
   * Planes that shadows are drawn on in a frame, at most, 1 or more (default 16): named ones first,
   * then those with the largest receivers. One warning says if there are more.
   */
  vtkSetClampMacro(MaximumNumberOfPlanes, int, 1, VTK_INT_MAX);
  vtkGetMacro(MaximumNumberOfPlanes, int);
  ///@}

  /**
   * How a light with a radius is made soft.
   * - SAMPLE_LIGHTS (default): the mean of the shadows of sample lights (Heckbert and Herf 1997):
   *   right, but for steps.
   * - OFFSET_PLANES: the mean of shadows on planes above and below the plane, dropped onto it
   *   (Gooch et al. 1999): as wide as it is right for the middle of the casters, along one
   *   direction, and not at all beneath a directional light straight above. A look, not a measure.
   * - PLATEAUS: one hard shadow, and around it ramps of the penumbra's width along the casters'
   *   silhouettes (Haines 2001): smooth and cheap whatever the radius, with an umbra that is too
   *   large. Casters without triangles (lines, points, impostors) stay hard.
   */
  enum SoftMethodType
  {
    SAMPLE_LIGHTS = 0,
    OFFSET_PLANES = 1,
    PLATEAUS = 2
  };
  ///@{
  /**
   * One of SoftMethodType; another value is an error and changes nothing.
   */
  void SetSoftMethod(int method);
  vtkGetMacro(SoftMethod, int);
  ///@}

  ///@{
  /**
   * Shadows drawn of a light with a radius, at most, 1 to 4096 (default 64). As many are drawn as
   * the widest penumbra has pixels (texels of a texture), told from the casters' bounds, at least
   * 4. GetNumberOfThrows tells.
   */
  vtkSetClampMacro(LightSamples, int, 1, 4096);
  vtkGetMacro(LightSamples, int);
  ///@}

  ///@{
  /**
   * Keep each light's shadow on each plane as a texture fixed in the world (off, default).
   */
  vtkSetMacro(PlaneTextures, bool);
  vtkGetMacro(PlaneTextures, bool);
  vtkBooleanMacro(PlaneTextures, bool);
  ///@}

  ///@{
  /**
   * Texels on the longer side of such a texture, 1 or more (default 2048); above the driver's limit
   * an error at the next frame names it, and it is used.
   */
  void SetTextureResolution(int resolution);
  vtkGetMacro(TextureResolution, int);
  ///@}

  /**
   * The texture of a light on a plane, as the last frame with textures had it, for those who bake
   * it: scalars "Visibility" (unsigned char, 0 shadowed to 255 lit), one point a texel's centre,
   * placed in the world by the image's origin, spacing and direction (its third axis is the plane's
   * normal). `plane` counts from 0 to GetNumberOfPlanes() - 1. false, with an error, if there is
   * none.
   */
  bool GetPlaneTexture(vtkLight* light, int plane, vtkImageData* texture);

  ///@{
  /**
   * Of the last frame: planes that may receive; one of them, as normal (unit, toward no side in
   * particular) and offset.
   */
  int GetNumberOfPlanes() const;
  bool GetPlane(int plane, double normalAndOffset[4]) const;
  ///@}

  ///@{
  /**
   * Of the last frame, summed over lights and planes: shadows drawn (one for a hard light), casters
   * drawn for them, and casters left out since they cast nothing on that plane.
   */
  vtkGetMacro(NumberOfThrows, vtkIdType);
  vtkGetMacro(NumberOfDrawnCasters, vtkIdType);
  vtkGetMacro(NumberOfCulledCasters, vtkIdType);
  ///@}

  /**
   * Textures drawn since this pass was made: grows only when a light, a caster or a plane changed.
   */
  vtkGetMacro(NumberOfTextureBuilds, vtkIdType);

  const char* GetTechniqueName() const override { return "planar"; }
  VisibilityForm GetVisibilityForm() const override { return this->PlaneTextures ? LOOKUP : MASK; }
  bool IsSoftByPixels() const override { return true; }
  vtkIdType GetTextureMemory() const override;
  vtkIdType GetCasterMemory() const override;
  void ReleaseGraphicsResources(vtkWindow* w) override;

protected:
  vtkPlanarShadowPass();
  ~vtkPlanarShadowPass() override;

  bool UpdateVisibility(const vtkShadowFrame& frame, const std::vector<int>& lights) override;
  vtkShadowTextureArray* GetTextures() override;
  std::string GetSamplerName() const override
  {
    return this->PlaneTextures ? "shadowPlaneTextureArray" : "shadowPlanarMasks";
  }
  std::string GetLookupDeclarations() const override;
  std::string GetLookupFunction(int slot, vtkProp* prop) const override;
  const float* GetLookupMatrix(int slot, vtkProp* prop) const override;
  const float* GetLitMatrix() const override;
  void SetLookupParameters(vtkShaderProgram* program, vtkProp* prop) override;
  bool HasVisibilityOf(vtkProp* prop) const override;
  vtkMTimeType GetReceiverStamp() const override;

  bool AutomaticPlanes = true;
  int MaximumNumberOfPlanes = 16;
  int SoftMethod = SAMPLE_LIGHTS;
  int LightSamples = 64;
  bool PlaneTextures = false;
  int TextureResolution = 2048;
  vtkIdType NumberOfThrows = 0;
  vtkIdType NumberOfDrawnCasters = 0;
  vtkIdType NumberOfCulledCasters = 0;
  vtkIdType NumberOfTextureBuilds = 0;

private:
  vtkPlanarShadowPass(const vtkPlanarShadowPass&) = delete;
  void operator=(const vtkPlanarShadowPass&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
