/**
 * @class   vtkStencilShadowVolumePass
 * @brief   visibility by shadow volumes: exact for any mesh, to the pixel
 *
 * Technique "stencil-volume", form mask: what lies in the shadow of a caster is a volume, bounded
 * by the caster's lit side, the sides that its silhouette throws, and its image far away. For each
 * pixel the volumes that its receiver lies in are counted, by drawing their faces against the
 * receivers' depth. Directional, spot and point lights; casters of any kind of triangles: open,
 * non-manifold, of mixed winding, duplicated (signed edge multiplicity, see Core/ShadowVolume.h).
 *
 * A light that moved costs a new decision which triangles face it, and a new list of silhouette
 * edges. A caster that moved costs the same, one that changed its shape a new table of its edges. A
 * camera that moves costs neither. Counters say how often.
 *
 * Everything that is drawn is drawn once: the sides, and where faces are counted behind the
 * receiver (z-fail) the caps. Counting those before the receiver (z-pass) needs no caps and is
 * chosen, for each caster and frame, where the eye (where depths are not clamped, its near plane)
 * cannot lie in that caster's shadow and the caster is drawn whole: not culled, translucent or cut
 * by the near plane.
 *
 * Limits: triangles cast, also those of glyphs and composite blocks; lines, points and impostors do
 * not (one warning names the caster). The mask is one answer a pixel: multisampling does not refine
 * it. Translucent receivers are lit.
 *
 * @par Reference
 * Crow, F.: Shadow algorithms for computer graphics, SIGGRAPH 1977;
 * Bergeron, P.: A general version of Crow's shadow volumes, IEEE CG&A 6(9), 1986;
 * Heidmann, T.: Real shadows, real time, IRIS Universe 18, 1991 (counting in the stencil);
 * Everitt, C. and Kilgard, M.: Practical and robust stenciled shadow volumes for
 * hardware-accelerated rendering, 2002 (z-fail, infinite volumes);
 * Hornus, S., Hoberock, J., Lefebvre, S. and Hart, J.: ZP+: correct z-pass stencil shadows, I3D
 * 2005 (near-plane caps); McGuire, M., Hughes, J., Egan, K., Kilgard, M. and Everitt, C.: Fast,
 * practical and robust shadows, 2003 (depth bounds); Aldridge, G. and Woods, E.: Robust,
 * geometry-independent shadow volumes, GRAPHITE 2004; Kim, B., Kim, K. and Turk, G.: A
 * shadow-volume algorithm for opaque and transparent nonmanifold casters, Journal of Graphics Tools
 * 13(3), 2008; Peciva, J. et al.: Robust silhouette shadow volumes on contemporary hardware,
 * GraphiCon 2013.
 *
 * @sa vtkShadowPass vtkRayCastShadowPass
 */
#ifndef vtkStencilShadowVolumePass_h
#define vtkStencilShadowVolumePass_h

#include "vtkShadowTechniquePass.h"

#include <memory> // for std::unique_ptr

class VTKSHADOWSPASSES_EXPORT vtkStencilShadowVolumePass : public vtkShadowTechniquePass
{
public:
  static vtkStencilShadowVolumePass* New();
  vtkTypeMacro(vtkStencilShadowVolumePass, vtkShadowTechniquePass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Which faces are counted.
   * - AUTOMATIC (default): before the receiver (z-pass) where that is right, else behind it
   *   (z-fail), for each caster and frame.
   * - Z_FAIL: always behind it, with caps (Bilodeau and Songy 1999; Carmack 2000): always right.
   * - Z_PASS: always before it, without caps (Heidmann 1991): wrong where the near plane lies in a
   *   shadow.
   * - Z_PASS_CAPPED: before it, with the casters thrown on the near plane as caps (Hornus et al.
   *   2005).
   * - PARITY: before it, and an odd count is shadow (Crow 1977): wrong also where shadows overlap.
   * The last three are for comparison and teaching.
   */
  enum VariantType
  {
    AUTOMATIC = 0,
    Z_FAIL = 1,
    Z_PASS = 2,
    Z_PASS_CAPPED = 3,
    PARITY = 4
  };
  ///@{
  /**
   * One of VariantType; another value is an error and changes nothing.
   */
  void SetVariant(int variant);
  vtkGetMacro(Variant, int);
  ///@}

  /**
   * What the volumes are counted in.
   * - AUTOMATIC_COUNTER (default): the stencil, faces that add ahead of those that take away; where
   *   a count reached 255, that light is counted again in floats. Always right.
   * - WRAPPING_STENCIL: the stencil, all in one go (Heidmann 1991): right up to 127 volumes one in
   *   another, and blind to 256 of them.
   * - FLOAT_COUNTER: floats, by blending. Always right; slower where many faces overlap.
   */
  enum CounterType
  {
    AUTOMATIC_COUNTER = 0,
    WRAPPING_STENCIL = 1,
    FLOAT_COUNTER = 2
  };
  ///@{
  /**
   * One of CounterType; another value is an error and changes nothing.
   */
  void SetCounter(int counter);
  vtkGetMacro(Counter, int);
  ///@}

  ///@{
  /**
   * Let only those triangles of closed, consistently wound pieces cast that face the light (on,
   * default), unless the light is within the piece's bounds. Half the work, the same shadow.
   */
  vtkSetMacro(OneSidedClosedPieces, bool);
  vtkGetMacro(OneSidedClosedPieces, bool);
  vtkBooleanMacro(OneSidedClosedPieces, bool);
  ///@}

  ///@{
  /**
   * Leave out casters whose shadow can reach no receiver in view, and flat ones that have every
   * receiver on their lit side (on, default).
   */
  vtkSetMacro(Culling, bool);
  vtkGetMacro(Culling, bool);
  vtkBooleanMacro(Culling, bool);
  ///@}

  ///@{
  /**
   * End volumes behind the last receiver, and draw them only where their bounds are seen and, if
   * the driver can tell, where the receiver's depth lies within them (on, default); else they reach
   * to infinity, over the whole viewport.
   */
  vtkSetMacro(Confinement, bool);
  vtkGetMacro(Confinement, bool);
  vtkBooleanMacro(Confinement, bool);
  ///@}

  ///@{
  /**
   * Hand all faces of a caster that change the count the same way to OpenGL by one call (on,
   * default); else each kind, sides and caps, near and far, by one of its own.
   */
  vtkSetMacro(MergedDraws, bool);
  vtkGetMacro(MergedDraws, bool);
  vtkBooleanMacro(MergedDraws, bool);
  ///@}

  ///@{
  /**
   * Draw receivers and volumes with the eye's far plane at infinity (Everitt and Kilgard 2002), in
   * place of clamping depths, for drivers that cannot clamp (off, default). Without effect with a
   * parallel projection.
   */
  vtkSetMacro(InfiniteProjection, bool);
  vtkGetMacro(InfiniteProjection, bool);
  vtkBooleanMacro(InfiniteProjection, bool);
  ///@}

  ///@{
  /**
   * Sample lights for a light with a radius, 1 to 4096 (default 32).
   */
  vtkSetClampMacro(LightSamples, int, 1, 4096);
  vtkGetMacro(LightSamples, int);
  ///@}

  ///@{
  /**
   * Smooth the steps between the sample lights' shadows (on, default): neighbouring pixels that
   * differ by about one step, over up to eight pixels to each side; edges stay. Without effect on
   * lights without a radius.
   */
  vtkSetMacro(Smoothing, bool);
  vtkGetMacro(Smoothing, bool);
  vtkBooleanMacro(Smoothing, bool);
  ///@}

  ///@{
  /**
   * Since this pass was made: edge tables built (a caster is new or changed its shape), and volumes
   * built (a light moved relative to a caster).
   */
  vtkGetMacro(NumberOfMeshBuilds, vtkIdType);
  vtkGetMacro(NumberOfVolumeBuilds, vtkIdType);
  ///@}

  ///@{
  /**
   * Of the last frame, summed over lights and their samples: casters counted before the receiver
   * and behind it, and left out; faces drawn, and calls of OpenGL that drew them: those of a caster
   * by one or two, soup by as many as it has lists; lights that were counted again in floats.
   */
  vtkGetMacro(NumberOfZPassCasters, vtkIdType);
  vtkGetMacro(NumberOfZFailCasters, vtkIdType);
  vtkGetMacro(NumberOfCulledCasters, vtkIdType);
  vtkGetMacro(NumberOfFaces, vtkIdType);
  vtkGetMacro(NumberOfDraws, vtkIdType);
  vtkGetMacro(NumberOfOverflows, vtkIdType);
  ///@}

  /**
   * Whether the last frame's driver also confined volumes by the receivers' depth
   * (EXT_depth_bounds_test), with Confinement and neither a classical variant nor
   * InfiniteProjection.
   */
  vtkGetMacro(HasDepthBounds, bool);

  ///@{
  /**
   * What is kept of the casters, in bytes (meshes, points with the driver, volumes of every light;
   * nothing else outlives a frame), and their triangles. A closed caster takes 42 to 49 bytes a
   * triangle with one light, one of triangles that share no edge 76.
   */
  vtkIdType GetMemoryInBytes() const;
  vtkIdType GetNumberOfTriangles() const;
  ///@}

  const char* GetTechniqueName() const override { return "stencil-volume"; }
  VisibilityForm GetVisibilityForm() const override { return MASK; }
  bool IsSoftByPixels() const override { return this->Smoothing; }
  vtkIdType GetTextureMemory() const override;
  vtkIdType GetCasterMemory() const override;
  void ReleaseGraphicsResources(vtkWindow* w) override;

protected:
  vtkStencilShadowVolumePass();
  ~vtkStencilShadowVolumePass() override;

  bool UpdateVisibility(const vtkShadowFrame& frame, const std::vector<int>& lights) override;
  vtkShadowTextureArray* GetTextures() override;
  std::string GetSamplerName() const override { return "shadowVolumeMasks"; }
  std::vector<std::string> GetDebugViews() const override;
  bool DrawDebugView(const vtkShadowFrame& frame, int slot, const std::string& view) override;

  friend class vtkShadowPass;
  // The counts of the light in `slot`, in floats, of this frame: width * height, from the bottom.
  bool CountAgain(const vtkShadowFrame& frame, int slot, std::vector<float>& counts);

  int Variant = AUTOMATIC;
  int Counter = AUTOMATIC_COUNTER;
  bool OneSidedClosedPieces = true;
  bool Culling = true;
  bool Confinement = true;
  bool MergedDraws = true;
  bool InfiniteProjection = false;
  int LightSamples = 32;
  bool Smoothing = true;
  vtkIdType NumberOfMeshBuilds = 0;
  vtkIdType NumberOfVolumeBuilds = 0;
  vtkIdType NumberOfZPassCasters = 0;
  vtkIdType NumberOfZFailCasters = 0;
  vtkIdType NumberOfCulledCasters = 0;
  vtkIdType NumberOfFaces = 0;
  vtkIdType NumberOfDraws = 0;
  vtkIdType NumberOfOverflows = 0;
  bool HasDepthBounds = false;

private:
  vtkStencilShadowVolumePass(const vtkStencilShadowVolumePass&) = delete;
  void operator=(const vtkStencilShadowVolumePass&) = delete;

  void UpdateCasters(const vtkShadowFrame& frame);
  bool UpdateMask(
    const vtkShadowFrame& frame, const vtkshadows::ShadowLight& light, std::size_t slot);
  bool CountVolumes(
    const vtkShadowFrame& frame, const vtkshadows::ShadowLight& light, std::size_t slot);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
