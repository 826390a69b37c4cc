/**
 * @class   vtkShadowTexturePass
 * @brief   visibility by a picture of the casters, thrown from the light like a slide
 *
 * Technique "shadow-texture", form lookup: the casters are drawn from the light, dark on white,
 * into a texture fitted to their bounds, and the texture is projected on the receivers. What a
 * texel is covered by is a picture: its edges are smoothed by the texture's own filter, at one
 * fetch a fragment. Nothing of it can show acne, since no caster is a receiver of a texture that it
 * is in. Beside the coverage lies the casters' depth, by which a receiver before them stays lit,
 * and so does what lies behind the light. Directional, spot and point lights; a light amid its
 * casters has the faces of a cube. When a texture is drawn again, see vtkMapShadowPass.
 *
 * A texture is made for what can be seen alone: not if its shadows miss the view; and what lies off
 * its frustum has no code for it in its shader.
 *
 * **Who casts, who receives** is said by the keys of vtkShadowPass, or by a near plane
 * (SetCasterSelection). Without a key that says so, what is flat and has the middle of all else on
 * its lit side (a floor, and things that stand on it or are sunk in it) does not cast. A caster is
 * not darkened by a texture that it is in: with one texture for all casters (default), casters are
 * lit. With a texture for each (SetTexturePerCaster), a caster is darkened by those of the others.
 *
 * A light with a radius has soft edges, the wider, the farther a receiver lies behind its caster:
 * the mean depth of the casters around a receiver tells how wide the light's disc is seen there,
 * and the mean coverage of that disc, read from smaller copies of the texture, is what is hidden of
 * it.
 *
 * Limits, which GetLimits says, too: nothing shadows itself. With one texture, casters take no
 * shadow at all; a scene in which everything casts, and so nothing receives, gets one warning, in
 * the second such frame in a row. An edge is as sharp as the texels. A caster closer to its
 * receiver than half a texel, or 1/65536 of the casters' depth, throws no shadow there.
 *
 * @par Reference
 * Segal, M., Korobkin, C., van Widenfelt, R., Foran, J. and Haeberli, P.: Fast shadows and lighting
 * effects using texture mapping, SIGGRAPH 1992 (projective textures); Heidrich, W.: High-quality
 * shading and lighting for hardware-accelerated rendering, dissertation, Erlangen 1999; Soler, C.
 * and Sillion, F.: Fast calculation of soft shadow textures using convolution, SIGGRAPH 1998;
 * Fernando, R.: Percentage-closer soft shadows, SIGGRAPH 2005 Sketches (the width from depths
 * around).
 *
 * @sa vtkShadowPass vtkMapShadowPass vtkPlanarShadowPass
 */
#ifndef vtkShadowTexturePass_h
#define vtkShadowTexturePass_h

#include "vtkMapShadowPass.h"

#include <string> // for std::string

class VTKSHADOWSPASSES_EXPORT vtkShadowTexturePass : public vtkMapShadowPass
{
public:
  static vtkShadowTexturePass* New();
  vtkTypeMacro(vtkShadowTexturePass, vtkMapShadowPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * A texture for each prop that casts, fitted to its own bounds, instead of one for all of a light
   * (off, default). Then casters take the shadows of others, and only the textures of casters that
   * changed are drawn again. Each costs the memory of a texture, and a lookup wherever it may
   * reach. Above what the driver's shaders can hold: one warning, and one texture for all.
   */
  vtkSetMacro(TexturePerCaster, bool);
  vtkGetMacro(TexturePerCaster, bool);
  vtkBooleanMacro(TexturePerCaster, bool);
  ///@}

  enum CasterSelectionType
  {
    BY_FLAG = 0,      // the keys CASTS_SHADOWS and RECEIVES_SHADOWS alone
    BY_NEAR_PLANE = 1 // what lies before the near plane casts, and the rest receives
  };
  ///@{
  /**
   * How casters are told from receivers: one of CasterSelectionType (default BY_FLAG); another
   * value is an error and changes nothing. By near plane, a prop whose bounds all lie before it
   * casts and does not receive, and any other receives and does not cast; keys that say 0 still
   * hold.
   */
  void SetCasterSelection(int selection);
  vtkGetMacro(CasterSelection, int);
  ///@}

  ///@{
  /**
   * How far the near plane lies before the light, in world units, finite and above 0 (default 1),
   * along the light's direction, from its position: a directional light has one, too. Of a point
   * light it is a sphere around it. Another value is an error and changes nothing.
   */
  void SetNearPlane(double distance);
  vtkGetMacro(NearPlane, double);
  ///@}

  ///@{
  /**
   * Of the last frame: textures that can be seen; and, summed over lights, props that some texture
   * may reach.
   */
  vtkGetMacro(NumberOfTextures, int);
  vtkGetMacro(NumberOfReachedProps, int);
  ///@}

  /**
   * What this technique cannot do, in a few sentences.
   */
  static std::string GetLimits();

  const char* GetTechniqueName() const override { return "shadow-texture"; }
  vtkIdType GetTextureMemory() const override;
  void ReleaseGraphicsResources(vtkWindow* w) override;

protected:
  vtkShadowTexturePass();
  ~vtkShadowTexturePass() override;

  std::string GetLookupPrefix() const override { return "shadowTexture"; }
  std::string GetMacroPrefix() const override { return "SHADOW_TEXTURE"; }
  std::string GetCompareDeclarations() const override;
  double GetMarginTexels() const override;
  vtkShadowMapRoles GetRoles(const vtkShadowFrame& frame) const override;
  bool ReserveMaps(const vtkShadowFrame& frame, int width, int height, int layers) override;
  void BeginMaps(const vtkShadowFrame& frame) override;
  void DrawMap(const vtkShadowFrame& frame, const vtkShadowMapSlot& slot,
    const vtkShadowMapView& view, int width, int height) override;

  bool UpdateVisibility(const vtkShadowFrame& frame, const std::vector<int>& lights) override;
  vtkShadowTextureArray* GetTextures() override;
  std::string GetSamplerName() const override { return "shadowTextures"; }
  std::string GetLookupDeclarations() const override;
  std::string GetLookupFunction(int slot, vtkProp* prop) const override;
  int GetLookupIndex(int slot) const override;
  const float* GetLookupMatrix(int slot, vtkProp* prop) const override;
  const float* GetLitMatrix() const override;
  void SetLookupParameters(vtkShaderProgram* program, vtkProp* prop) override;
  bool HasVisibilityOf(vtkProp* prop) const override;
  vtkMTimeType GetReceiverStamp() const override;

  int LevelsOfTexture() const;
  void TellWhatReceives(
    const vtkShadowFrame& frame, const std::vector<int>& lights, const vtkShadowMapRoles& roles);

  bool TexturePerCaster = false;
  int CasterSelection = BY_FLAG;
  double NearPlane = 1.0;
  int NumberOfTextures = 0;
  int NumberOfReachedProps = 0;

private:
  vtkShadowTexturePass(const vtkShadowTexturePass&) = delete;
  void operator=(const vtkShadowTexturePass&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
