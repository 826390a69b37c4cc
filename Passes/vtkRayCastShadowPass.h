/**
 * @class   vtkRayCastShadowPass
 * @brief   visibility by a ray from each pixel's receiver to the light: the truth
 *
 * Technique "ray-cast", form mask, on Embree and all cores. The receivers' positions are drawn once
 * into a buffer of floats, read back, and a ray goes from each toward each light. It is the
 * reference that other techniques are held against, and itself selectable.
 *
 * Casters are triangles (polydata, composite blocks, glyph instances, in any assembly) and spheres
 * (vtkOpenGLSphereMapper), traced relative to the casters' centre. Each casts whichever way it
 * faces. Lines, points, sticks (vtkOpenGLStickMapper) and point Gaussians have no surface to hit:
 * they cast nothing here, with one warning.
 *
 * A mapper's clipping planes cut its triangles; transparent texels of a texture still cast.
 *
 * A ray starts off the surface by `EpsilonScale` times the rounding bound of its position (float in
 * the eye's frame, float in the scene's), along the face's normal.
 *
 * Lights with a radius are the mean over LightSamples sample lights.
 *
 * @par Reference
 * Appel 1968; Wald et al.: Embree: a kernel framework for efficient CPU ray tracing, SIGGRAPH 2014.
 *
 * @sa vtkShadowPass vtkShadowErrorMeasure
 */
#ifndef vtkRayCastShadowPass_h
#define vtkRayCastShadowPass_h

#include "vtkShadowTechniquePass.h"

#include <memory> // for std::unique_ptr

class vtkShadowReceiverBuffer;

class VTKSHADOWSPASSES_EXPORT vtkRayCastShadowPass : public vtkShadowTechniquePass
{
public:
  static vtkRayCastShadowPass* New();
  vtkTypeMacro(vtkRayCastShadowPass, vtkShadowTechniquePass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sample lights of a light with a radius, 1 to 4096 (default 64). A light without one takes one
   * ray.
   */
  vtkSetClampMacro(LightSamples, int, 1, 4096);
  vtkGetMacro(LightSamples, int);
  ///@}

  ///@{
  /**
   * Times of the rounding bound that a ray starts off its surface, above 0 (default 1).
   */
  vtkSetClampMacro(EpsilonScale, double, 1e-3, 1e6);
  vtkGetMacro(EpsilonScale, double);
  ///@}

  ///@{
  /**
   * Of the last frame: rays traced, seconds spent tracing them, triangles and spheres in the tree;
   * and how often the tree was built since this pass was made.
   */
  vtkGetMacro(NumberOfRays, vtkIdType);
  vtkGetMacro(TraceSeconds, double);
  vtkGetMacro(NumberOfPrimitives, vtkIdType);
  vtkGetMacro(NumberOfTreeBuilds, vtkIdType);
  ///@}

  const char* GetTechniqueName() const override { return "ray-cast"; }
  VisibilityForm GetVisibilityForm() const override { return MASK; }
  vtkIdType GetTextureMemory() const override;
  vtkIdType GetCasterMemory() const override;
  void ReleaseGraphicsResources(vtkWindow* w) override;

protected:
  vtkRayCastShadowPass();
  ~vtkRayCastShadowPass() override;
  friend class vtkShadowPass;

  bool UpdateVisibility(const vtkShadowFrame& frame, const std::vector<int>& lights) override;
  vtkShadowTextureArray* GetTextures() override;
  std::string GetSamplerName() const override { return "shadowRayCastMasks"; }

  /**
   * Build the tree unless it is this frame's.
   */
  bool UpdateTree(const vtkShadowFrame& frame);

  /**
   * Trace the pixels of `receivers` toward `light`, with a radius toward so many `samples` of it:
   * visibility gets one float a pixel, row by row from the bottom, 1 where there is no receiver. Or
   * only those that `which` names by a number that is not 0: the others stay as they are.
   */
  bool TraceVisibility(const vtkShadowFrame& frame, const vtkShadowReceiverBuffer& receivers,
    const vtkshadows::ShadowLight& light, double epsilonScale, int samples,
    std::vector<float>& visibility, const std::vector<unsigned char>* which = nullptr);

  /**
   * Seconds that a bare loop of rtcOccluded1 over all cores takes for one frame's rays of hard
   * lights: the limit to hold TraceSeconds against. 0 if there is no tree.
   */
  double TimeBareTracing(const vtkShadowFrame& frame);

  int LightSamples = 64;
  double EpsilonScale = 1.0;
  vtkIdType NumberOfRays = 0;
  double TraceSeconds = 0.0;
  vtkIdType NumberOfPrimitives = 0;
  vtkIdType NumberOfTreeBuilds = 0;

private:
  vtkRayCastShadowPass(const vtkRayCastShadowPass&) = delete;
  void operator=(const vtkRayCastShadowPass&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
