/**
 * @class   vtkDepthShadowMapPass
 * @brief   visibility by a depth map, compared with the receiver's own plane
 *
 * Technique "depth-map", form lookup: casters are drawn from the light into a map of depths; while
 * a receiver is shaded, its position is compared with the four texels around it and the four
 * answers are blended (2x2 percentage-closer filtering); other filters can be chosen (SetFilter).
 * Directional, spot and point lights; which views they have, and when a map is drawn again, see
 * vtkMapShadowPass.
 *
 * Bias is automatic: each texel's depth is compared at that texel's centre on the receiver's own
 * plane there, with a slack of half a texel, along the plane's slope and in depth, plus the
 * rounding bound of the position and of the map. Where the four texels are of one curved surface,
 * what is not behind it is lit. There is no constant to tune.
 *
 * Limits: an edge is as sharp as the map's texels; a contact shadow thinner than half a texel
 * of slope is lost. Embossed detail below a texel is not seen. Lines and points cast as wide as
 * they are drawn, in texels. With all filters but "soft" and "sample-lights" the shadow is hard,
 * whatever the light's radius.
 *
 * @par Reference
 * Williams 1978 (depth maps); Reeves, Salesin and Cook: Rendering antialiased shadows with depth
 * maps, SIGGRAPH 1987 (percentage-closer filtering); Gerasimov: Omnidirectional shadow mapping,
 * GPU Gems 2004 (cubes); Isidoro: Shadow mapping, GDC 2006 (receiver plane); Dou et al.: Adaptive
 * depth bias for shadow maps, I3D 2014; Fernando: Percentage-closer soft shadows, SIGGRAPH 2005;
 * Guennebaud, Barthe and Paulin: Real-time soft shadow mapping by backprojection, EGSR 2006;
 * Kaplan and Meier 1958 (slabs); Donnelly and Lauritzen: Variance shadow maps, I3D 2006; Annen et
 * al.: Exponential shadow maps, GI 2008; Heckbert and Herf: Simulating soft shadows with graphics
 * hardware, CMU-CS-97-104, 1997 (sample lights); Heidrich: High-quality shading and lighting for
 * hardware-accelerated rendering, 1999 (ramps of eight bits).
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

  /**
   * How a receiver is held against the map.
   * - PERCENTAGE_CLOSER (default): the four texels around it, each against the receiver's plane at
   *   its centre, blended.
   * - NONE: one texel: edges are jagged.
   * - HARDWARE: four texels, compared by the driver with one depth, and so with three times the
   *   slack. Not with 8 depth bits.
   * - DISC: percentage-closer over a disc of FilterRadius texels, by FilterTaps taps, turned from
   *   pixel to pixel.
   * - SOFT: soft shadows of a light with a radius: as wide as the similar triangles of its disc,
   *   what blocks it and the receiver ask for (Fernando 2005), for blockers in four slabs of depth
   * (Guennebaud et al. 2006; Kaplan and Meier 1958); FilterTaps taps to find them, and as many to
   * filter, up to half as many again and three times as many where the kernel is wider than 64
   * texels. A light without a radius is filtered as by PERCENTAGE_CLOSER. On the faces of a cube no
   * kernel is wider than 1/16 of the resolution.
   * - SAMPLE_LIGHTS: a light with a radius is the mean over LightSamples lights on its disc, each
   * with maps of its own (Heckbert and Herf 1997); one without as by PERCENTAGE_CLOSER.
   * - VARIANCE: a bound of visibility by the blurred map's mean and variance (Donnelly and
   * Lauritzen 2006), less LightBleedingReduction. Not with 8 depth bits.
   * - EXPONENTIAL: the blurred exponential of the depth (Annen et al. 2008), by
   * ExponentialConstant; VTK's own vtkShadowMapPass is of this kind. Not with 8 depth bits.
   * - EXACT: the triangles that four texels show, followed to the receiver: edges are those of the
   *   casters. What is not triangles is looked up as by PERCENTAGE_CLOSER. Its bias is automatic,
   *   and beyond the map it is lit. Not with 8 depth bits.
   */
  enum FilterType
  {
    PERCENTAGE_CLOSER = 0,
    NONE,
    HARDWARE,
    DISC,
    SOFT,
    SAMPLE_LIGHTS,
    VARIANCE,
    EXPONENTIAL,
    EXACT
  };

  ///@{
  /**
   * One of FilterType, or its name: "percentage-closer", "none", "hardware", "disc", "soft",
   * "sample-lights", "variance", "exponential", "exact". Another one is an error that lists the
   * known ones, and changes nothing.
   */
  void SetFilter(int filter);
  void SetFilter(const std::string& name);
  vtkGetMacro(Filter, int);
  static std::string GetFilterName(int filter);
  static int GetNumberOfFilters();
  ///@}

  /**
   * Whether a filter, by its name, has maps of so many DepthBits.
   */
  static bool HasDepthBits(const std::string& filter, int bits);

  ///@{
  /**
   * DISC, VARIANCE, EXPONENTIAL: radius of the kernel in texels, 0.5 to 64 (default 3); of the
   * blurs, two standard deviations of a Gaussian. Another value is an error and changes nothing.
   */
  void SetFilterRadius(double texels);
  vtkGetMacro(FilterRadius, double);
  ///@}

  ///@{
  /**
   * DISC, SOFT: taps of the kernel, 1 to 256 (default 32), each of four texels; of SOFT more where
   * it is wide. Another value is an error and changes nothing.
   */
  void SetFilterTaps(int taps);
  vtkGetMacro(FilterTaps, int);
  ///@}

  ///@{
  /**
   * SAMPLE_LIGHTS: lights on the disc of a light with a radius, 1 to 256 (default 64), and texels
   * on the longer side of each one's maps, 1 or more (default 1024; above the driver's limit as
   * Resolution). Another value is an error and changes nothing. A light amid its casters has up to
   * six maps a sample.
   */
  static constexpr int MostLightSamples = 256;
  void SetLightSamples(int samples);
  vtkGetMacro(LightSamples, int);
  void SetSampleResolution(int resolution);
  vtkGetMacro(SampleResolution, int);
  ///@}

  ///@{
  /**
   * VARIANCE: visibility up to this is cut off, and the rest stretched, against light that bleeds
   * where shadows of different depths overlap; 0 (none) to 0.99 (default 0.2). Another value is an
   * error and changes nothing.
   */
  void SetLightBleedingReduction(double reduction);
  vtkGetMacro(LightBleedingReduction, double);
  ///@}

  ///@{
  /**
   * EXPONENTIAL: what the depth, as a share of the map's range, is multiplied by in the
   * exponential; 1 to 80, where a float ends (default 80). A receiver 1 / constant of the range
   * behind its caster still has 37 % of the light. Another value is an error and changes nothing.
   */
  void SetExponentialConstant(double constant);
  vtkGetMacro(ExponentialConstant, double);
  ///@}

  ///@{
  /**
   * Bits of a map's depths: 32 (float, default), 24, 16 or 8; all but 32 are steps of the distance
   * from the light, so that they are as fine far from a spot or point light as near to it. 8 is a
   * ramp as of the time before depth textures: lit where the receiver's step is the map's, or an
   * earlier one. Another value is an error and changes nothing. Maps of sample lights, and those
   * that are blurred, are made of the driver's depths of 24 and 16 bits.
   */
  void SetDepthBits(int bits);
  vtkGetMacro(DepthBits, int);
  ///@}

  ///@{
  /**
   * AUTOMATIC_BIAS (default): see above. MANUAL_BIAS, for those who compare: one depth for all
   * texels, less by a bias as glPolygonOffset has it: SlopeBias (default 1.1) times the larger of
   * the receiver's depth slopes along the map's axes, in depth per texel, plus ConstantBias
   * (default 4) steps of the format (32 and 24 bits: 2^-24; 16: 2^-16; 8: 1/255). -1e9 to
   * 1e9; another value is an error and changes nothing.
   */
  enum BiasModeType
  {
    AUTOMATIC_BIAS = 0,
    MANUAL_BIAS = 1
  };
  void SetBiasMode(int mode);
  vtkGetMacro(BiasMode, int);
  void SetConstantBias(double steps);
  vtkGetMacro(ConstantBias, double);
  void SetSlopeBias(double factor);
  vtkGetMacro(SlopeBias, double);
  ///@}

  ///@{
  /**
   * What lies beyond the map: LIT_BEYOND (default), or, to show what goes wrong: the map again
   * (REPEAT_BEYOND), or its outermost texels drawn out to bars (CLAMP_BEYOND). Nothing that casts
   * lies beyond a fitted map: then it is the middle three quarters of it, along each side, as
   * though it had been placed by hand, too tightly. Lights with several maps stay lit beyond.
   * Another value is an error and changes nothing.
   */
  enum BeyondType
  {
    LIT_BEYOND = 0,
    REPEAT_BEYOND,
    CLAMP_BEYOND
  };
  void SetBeyond(int beyond);
  vtkGetMacro(Beyond, int);
  ///@}

  const char* GetTechniqueName() const override { return "depth-map"; }
  vtkIdType GetTextureMemory() const override;
  vtkIdType GetCasterMemory() const override;
  void ReleaseGraphicsResources(vtkWindow* w) override;

protected:
  vtkDepthShadowMapPass();
  ~vtkDepthShadowMapPass() override;

  bool UpdateVisibility(const vtkShadowFrame& frame, const std::vector<int>& lights) override;
  std::string GetLookupPrefix() const override { return "shadowDepthMap"; }
  std::string GetMacroPrefix() const override { return "SHADOW_DEPTH_MAP"; }
  std::string GetCompareDeclarations() const override;
  std::string GetLookupDeclarations() const override;
  std::string GetLookupFunction(int slot, vtkProp* prop) const override;
  int GetLookupIndex(int slot) const override;
  const float* GetLookupMatrix(int slot, vtkProp* prop) const override;
  void SetLookupParameters(vtkShaderProgram* program, vtkProp* prop) override;
  vtkMTimeType GetReceiverStamp() const override;
  double GetMarginTexels() const override;
  double GetRiseTexels() const override;
  // A perspective's depths are coarse far from the light; a blurred map has moments, of floats.
  bool HasDistances() const override { return this->DepthBits < 32 && !this->IsBlurred(); }
  bool ReserveMaps(const vtkShadowFrame& frame, int width, int height, int layers) override;
  void BeginMaps(const vtkShadowFrame& frame) override;
  void DrawMap(const vtkShadowFrame& frame, const vtkShadowMapSlot& slot,
    const vtkShadowMapView& view, int width, int height) override;
  vtkShadowTextureArray* GetTextures() override;
  std::string GetSamplerName() const override { return "shadowDepthMaps"; }
  void ActivateTextures() override;
  void DeactivateTextures() override;

  int Filter = PERCENTAGE_CLOSER;
  double FilterRadius = 3.0;
  int FilterTaps = 32;
  int LightSamples = 64;
  int SampleResolution = 1024;
  double LightBleedingReduction = 0.2;
  double ExponentialConstant = 80.0;
  int DepthBits = 32;
  int BiasMode = AUTOMATIC_BIAS;
  double ConstantBias = 4.0;
  double SlopeBias = 1.1;
  int Beyond = LIT_BEYOND;

private:
  vtkDepthShadowMapPass(const vtkDepthShadowMapPass&) = delete;
  void operator=(const vtkDepthShadowMapPass&) = delete;

  bool IsBlurred() const { return this->Filter == VARIANCE || this->Filter == EXPONENTIAL; }
  template <typename T>
  void Change(T& setting, T value);
  bool UpdateSampled(const vtkShadowFrame& frame, const std::vector<int>& lights);
  void DrawDepths(const vtkShadowFrame& frame, const vtkshadows::ShadowLight& light,
    const vtkShadowMapView& view, const vtkShadowTextureArray& maps, int layer, int width,
    int height);
  std::string GetSharedDeclarations(bool distances) const;
  std::string GetOpaqueDeclarations() const;
  bool ReserveOpaque(const vtkShadowFrame& frame, int width, int height, int layers);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
