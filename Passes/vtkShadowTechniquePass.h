/**
 * @class   vtkShadowTechniquePass
 * @brief   the contract: one technique, its visibility of a light
 *
 * A technique answers one question: how much of a light does a receiver see, 0 to 1. It answers in
 * one of two forms:
 * - LOOKUP: a GLSL function of the fragment's position, evaluated while the receiver is shaded;
 * - MASK: a viewport-sized texture, 1 lit and 0 shadowed, origin bottom-left, one layer a light.
 * Nothing else leaves a technique; vtkShadowedShadingPass is the one that multiplies.
 *
 * Each frame vtkShadowPass calls UpdateVisibility with the lights that this technique serves; slot
 * i of a lookup or mask belongs to lights[i].
 *
 * Given to a renderer by itself (renderer->SetPass), a technique shadows every light.
 *
 * @sa vtkShadowPass vtkShadowScene vtkShadowedShadingPass
 */
#ifndef vtkShadowTechniquePass_h
#define vtkShadowTechniquePass_h

#include "vtkRenderPass.h"
#include "vtkShadowsPassesModule.h" // for export macro
#include "vtkSmartPointer.h"        // for the stand-alone pass

#include <string> // for std::string
#include <vector> // for std::vector

class vtkAbstractMapper;
class vtkProp;
class vtkShaderProgram;
class vtkShadowPass;
class vtkShadowTextureArray;
struct vtkShadowFrame;
namespace vtkshadows
{
struct ShadowLight;
}

/**
 * GLSL of a vertex shader, declarations and statements; and of the fragment shader, ahead of its
 * other declarations.
 */
struct vtkShadowVertexCode
{
  std::string VertexDeclarations;
  std::string VertexStatements;
  std::string FragmentDeclarations;
};

class VTKSHADOWSPASSES_EXPORT vtkShadowTechniquePass : public vtkRenderPass
{
public:
  vtkTypeMacro(vtkShadowTechniquePass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum VisibilityForm
  {
    LOOKUP = 0,
    MASK = 1
  };

  /**
   * The technique's one name, as settings and the command line spell it: "depth-map".
   */
  virtual const char* GetTechniqueName() const = 0;

  virtual VisibilityForm GetVisibilityForm() const = 0;

  /**
   * Whether the shadow of a light with a radius is made for the pixels that show it (smoothed from
   * pixel to pixel, or of as many samples as its penumbra has pixels), so that fewer pixels do not
   * tell how it looks.
   */
  virtual bool IsSoftByPixels() const { return false; }

  ///@{
  /**
   * What it keeps from frame to frame, in bytes: the texels of its textures (smaller copies of them
   * left out), 0 before the first frame and after ReleaseGraphicsResources; and what it made of the
   * casters beside VTK's own copy of them: meshes, tables and trees, in memory and with the driver.
   */
  virtual vtkIdType GetTextureMemory() const = 0;
  virtual vtkIdType GetCasterMemory() const { return 0; }
  ///@}

  /**
   * Render the frame with every light shadowed by this technique.
   */
  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* w) override;

protected:
  vtkShadowTechniquePass();
  ~vtkShadowTechniquePass() override;
  friend class vtkShadowPass;
  friend class vtkShadowedShadingPass;

  /**
   * Make the visibility of `lights` (indices into frame.Scene->GetLights()) ready for this frame,
   * rebuilding only what is stale. A light that cannot be served is left lit, with one warning that
   * says why (WarnOnce). false, with an error, if nothing could be made: every light is then lit.
   */
  virtual bool UpdateVisibility(const vtkShadowFrame& frame, const std::vector<int>& lights) = 0;

  ///@{
  /**
   * The layers that are sampled (LOOKUP: maps; MASK: one a slot, a byte a pixel of the viewport),
   * and the name of the one sampler2DArray that reads them. Called once UpdateVisibility has
   * succeeded.
   */
  virtual vtkShadowTextureArray* GetTextures() = 0;
  virtual std::string GetSamplerName() const = 0;
  ///@}

  ///@{
  /**
   * Bind those layers, and give them back, around everything that is drawn with the visibility. One
   * with further textures binds them here, and names their units in SetLookupParameters.
   */
  virtual void ActivateTextures();
  virtual void DeactivateTextures();
  ///@}

  ///@{
  /**
   * LOOKUP: GLSL 1.50 that declares the sampler and `float f(int index, vec4 position)`; the name
   * of f and its index for a slot and what a prop shows; and the matrix, column-major, that takes a
   * receiver's position from the eye's view coordinates to the space that f wants it in, which
   * vtkShadowedShadingPass applies. f takes the receiver's plane from screen derivatives; an
   * impostor, beside whose rim there are none, calls `f(index, position, along1, along2)` with two
   * directions on its plane, by the same matrix. Every name in it begins with "shadow".
   */
  virtual std::string GetLookupDeclarations() const { return {}; }
  virtual std::string GetLookupFunction(int, vtkProp*) const { return {}; }
  virtual int GetLookupIndex(int slot) const { return slot; }
  virtual const float* GetLookupMatrix(int, vtkProp*) const { return nullptr; }
  ///@}

  ///@{
  /**
   * Whether it tells the visibility of what a prop (a leaf, or a top) shows; else the prop is lit,
   * and its shader has no code for that. What may change from frame to frame, in this or in the
   * lookup's functions and indices, has a stamp, that grows with it. Asked once UpdateVisibility
   * has succeeded.
   */
  virtual bool HasVisibilityOf(vtkProp*) const { return true; }
  virtual vtkMTimeType GetReceiverStamp() const { return 0; }
  ///@}

  /**
   * LOOKUP: set further uniforms of the declarations, for what this prop shows.
   */
  virtual void SetLookupParameters(vtkShaderProgram*, vtkProp*) {}

  /**
   * LOOKUP: what its functions are told by way of the vertices. `byVertex`: no geometry shader
   * stands between the two; else all must be in the fragment shader.
   */
  virtual vtkShadowVertexCode GetLookupCode(bool byVertex) const;

  ///@{
  /**
   * LOOKUP, if its functions ask which object a fragment is of, and so do the maps that it has
   * drawn (vtkShadowedShadingPass::DrawCasters, with `writer`). `byVertex` as in GetLookupCode.
   * And what each draw of a prop by a mapper is told: `mapper` may be one that the prop's own
   * mapper draws through, and `prop` a copy that has the prop's keys.
   */
  virtual vtkShadowVertexCode GetObjectCode(bool byVertex) const;
  virtual void SetObjectParameters(vtkShaderProgram*, vtkAbstractMapper*, vtkProp*) {}
  /**
   * What casters write, as the type of the fragment shader's output ("vec4", "uvec4"), GLSL
   * declarations, and an expression of `depth`, window space.
   */
  struct CasterCode
  {
    std::string OutputType;
    std::string Declarations;
    std::string Expression;
  };
  virtual CasterCode GetCasterCode() const;
  ///@}

  ///@{
  /**
   * The views, of those of vtkShadowPass::GetDebugViewNames, by which it explains its visibility;
   * and draw one, of the light in `slot`, over the frame in the bound framebuffer: false if the
   * driver cannot.
   */
  virtual std::vector<std::string> GetDebugViews() const { return {}; }
  virtual bool DrawDebugView(const vtkShadowFrame&, int, const std::string&) { return false; }
  ///@}

  /**
   * LOOKUP: the matrix that makes every position lit, for what takes no shadows.
   */
  virtual const float* GetLitMatrix() const { return nullptr; }

  /**
   * Warn of `message` unless the last warning about `subject` said the same; an empty message
   * forgets it, so that a fault that comes back is told again.
   */
  void WarnOnce(const void* subject, const std::string& message);

  /**
   * `side` texels, or what this driver's textures have at most: then there is one error that names
   * `setting`, the value and the limit.
   */
  int WithinDriver(const char* setting, int side) const;

  int GetNumberOfSlots() const { return this->NumberOfSlots; }

private:
  vtkShadowTechniquePass(const vtkShadowTechniquePass&) = delete;
  void operator=(const vtkShadowTechniquePass&) = delete;

  vtkSmartPointer<vtkShadowPass> Standalone;
  std::vector<std::pair<const void*, std::string>> Warned;
  mutable int RefusedSide = 0; // of a texture, as it was last told
  int NumberOfSlots = 0;       // lights of the coming frame, set ahead of its shaders
};

#endif
