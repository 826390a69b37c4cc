/**
 * @class   vtkShadowedShadingPass
 * @brief   the one consumer of visibility: multiplies each light's colour by it
 *
 * Attached to the props of a frame, it puts one line a light ahead of VTK's own lighting code in
 * the fragment shader:
 * @code
 * vec3 lightColor0 = lightColor0 * visibilityOfLight0;
 * @endcode
 * a local variable that hides the uniform, so that every lighting model of VTK's (Gouraud, flat,
 * PBR with coat) is shadowed alike and no light equation is matched by its text.
 *
 * The other draws of a frame (casters into a map, receivers into a buffer) go through the same
 * mappers with a shader of their stage, without the lookups: a software rasteriser would evaluate
 * them although nothing of them is kept. A change of stage costs each mapper a look into VTK's
 * shader cache.
 *
 * @sa vtkShadowPass vtkShadowTechniquePass
 */
#ifndef vtkShadowedShadingPass_h
#define vtkShadowedShadingPass_h

#include "vtkNew.h" // for the caster camera
#include "vtkOpenGLRenderPass.h"
#include "vtkShadowTechniquePass.h" // for the plan
#include "vtkShadowsPassesModule.h" // for export macro
#include "vtkSmartPointer.h"        // for the keys attached to

#include <memory>        // for catchers and falloffs
#include <string>        // for std::string
#include <unordered_map> // for what is known of a prop
#include <unordered_set> // for the same
#include <vector>        // for the plan

class vtkInformation;
class vtkOpenGLState;
class vtkTexture;
class vtkShadowCasterCamera;
class vtkShadowCatchers;
class vtkShadowEyeFaces;
class vtkShadowLightFalloffs;
class vtkShadowMergedCasters;
class vtkShadowWideFloors;
struct vtkShadowFrame;
namespace vtkshadows
{
struct LightView;
struct ShadowLight;
}

class VTKSHADOWSPASSES_EXPORT vtkShadowedShadingPass : public vtkOpenGLRenderPass
{
public:
  static vtkShadowedShadingPass* New();
  vtkTypeMacro(vtkShadowedShadingPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Nothing by itself: vtkShadowPass attaches it to the props of its frame.
   */
  void Render(const vtkRenderState*) override {}

#ifndef __VTK_WRAP__
  // What is drawn, and so what a mapper's shader says.
  enum Stage
  {
    SHADE,         // the frame
    CASTERS,       // depth from a light, and as a colour (1, depth)
    TEXELS,        // the same, and what a technique has its casters write
    TRANSMITTANCE, // the same of translucent ones, and as a colour 1 - opacity
    DEPTHS,        // depth from the eye
    COVERAGE,      // what the frame shows in front, and as a colour (1, its surface's depth)
    POSITIONS,     // the receivers' positions and normals
    VISIBILITY     // the visibility of one light
  };

  // Whose visibility light i of the scene is multiplied by; no technique: lit.
  struct LightPlan
  {
    vtkShadowTechniquePass* Technique = nullptr;
    int Slot = 0;
    float Strength = 1.0f;
    float MaximumDistance = 0.0f; // of a receiver from the eye, for shadow; 0: any
    float Fade = 0.0f;            // the share of it over which shadow fades out
    const vtkshadows::ShadowLight* Light = nullptr;
    // Of a spot: see vtkShadowPass::SetLightSmoothCone and SetLightTexture.
    double SmoothCone = 0.0;
    vtkTexture* Texture = nullptr;
    double TextureUp[3] = { 0.0, 0.0, 1.0 };

    bool Weakens() const { return this->Strength < 1.0f || this->MaximumDistance > 0.0f; }
    bool FallsOff() const { return this->SmoothCone > 0.0 || this->Texture; }
  };
  void SetPlan(const std::vector<LightPlan>& plan);

  // Put this pass among the render passes of every prop of the scene, and take it away again.
  void Attach(const vtkShadowFrame& frame);
  void Detach();

  // Whether faces that the eye cannot see are left out while attached (see vtkShadowPass), of how
  // many actors they were at last, and whether it may soon be more.
  void SetCullHiddenFaces(bool culled)
  {
    this->CullHiddenFaces = culled;
  }
  bool GetCullHiddenFaces() const
  {
    return this->CullHiddenFaces;
  }
  int GetNumberOfCulledReceivers() const;
  bool IsCullingUndecided() const;

  // Casters that were drawn in one go with others (see vtkShadowMergedCasters) since Attach, over
  // all views.
  int GetNumberOfMergedCasters() const;
  std::size_t GetMergedCasterBytes() const;

  // Between UpdateVisibility of every technique in the plan and the frame's shading; Detach undoes
  // it.
  void ActivateTextures();

  // Draw casters (indices into the scene's props) from a light's view, or receivers from the eye's,
  // into the bound framebuffer. Camera and stage are as before afterwards. `culled`: the faces,
  // GL_FRONT or GL_BACK, that need not be drawn of a part. Of casters the depth is written, or
  // their colour alone: (1, depth); with `writer` the depth, and what that technique has them
  // write.
  void DrawCasters(const vtkShadowFrame& frame, const std::vector<std::size_t>& props,
    const vtkshadows::LightView& view, const std::unordered_map<vtkProp*, unsigned int>& culled,
    bool writesDepth = true, vtkShadowTechniquePass* writer = nullptr);
  // Translucent casters: their depths, whole; or what they let through of the light, multiplied
  // into the colour.
  void DrawTransmittance(const vtkShadowFrame& frame, const std::vector<std::size_t>& props,
    const vtkshadows::LightView& view, bool writesDepth);
  void DrawReceivers(
    const vtkShadowFrame& frame, Stage stage, const std::vector<std::size_t>* props = nullptr);
  // After Attach. Where a shadow catcher may lie before another receiver, masks are made in two
  // rounds: true, and the catchers alone are drawn; EndCatcherMasks keeps the masks of that round,
  // and leaves the catchers out; at the end DrawAllReceivers.
  bool BeginCatcherMasks();
  void EndCatcherMasks();
  void DrawAllReceivers();
  // The depth of what is opaque, of all props or of some, by the eye's view with a depth range of
  // its own.
  void DrawDepths(const vtkShadowFrame& frame, const vtkshadows::LightView& view,
    const std::vector<std::size_t>* props = nullptr, Stage stage = DEPTHS);

  // The light that VISIBILITY shows.
  void SetShownLight(int light)
  {
    this->ShownLight = light;
  }
#endif

  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;
  void ReleaseGraphicsResources(vtkWindow* w) override;

protected:
  vtkShadowedShadingPass();
  ~vtkShadowedShadingPass() override;

private:
  vtkShadowedShadingPass(const vtkShadowedShadingPass&) = delete;
  void operator=(const vtkShadowedShadingPass&) = delete;

  void DrawFromLight(const vtkShadowFrame& frame, const std::vector<std::size_t>& props,
    const vtkshadows::LightView& view, Stage stage);
  void DrawByMappers(const vtkShadowFrame& frame, const std::vector<std::size_t>& props,
    const vtkshadows::LightView& view, Stage stage);
  std::string Declarations() const;
  std::string PlaceVertexCode(std::string& vertexShader, bool byVertex) const;
  void PlaceTexels(
    std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader) const;
  bool Tells(std::size_t light, vtkAbstractMapper* mapper, vtkProp* prop) const;
  std::string FactorCode(std::size_t light) const;
  std::string LightCode(const std::string& fragmentShader, bool isImpostor, bool isCatcher,
    vtkAbstractMapper* mapper, vtkProp* prop) const;
  std::string OutputCode(const std::string& fragmentShader, bool isImpostor,
    vtkAbstractMapper* mapper, vtkProp* prop) const;
  void PlaceDepth(std::string& fragmentShader) const;
  std::string NoReceiver() const;
  void PlacePositions(std::string& vertexShader, std::string& fragmentShader, bool isPlain,
    vtkAbstractMapper* mapper, vtkProp* prop) const;
  void SetMaskParameters(vtkShaderProgram* program, vtkProp* prop, bool receives);
  void AttachTo(vtkProp* prop, bool receives);
  void SetStage(Stage stage);
  bool IsReceiver(vtkProp* prop) const;
  bool IsCatcher(vtkProp* prop) const;
  void ClampDepth(bool clamped);
  bool DrawsDepthAlone() const
  {
    return this->DrawsCasters() || this->CurrentStage == DEPTHS || this->CurrentStage == COVERAGE;
  }
  bool DrawsCasters() const
  {
    return this->CurrentStage == CASTERS || this->CurrentStage == TEXELS ||
      this->CurrentStage == TRANSMITTANCE;
  }

  std::vector<LightPlan> Plan;
  std::vector<vtkShadowTechniquePass*> Techniques; // of the plan, each once
  std::vector<std::size_t> Lookups;                // lights of the plan
  bool HasMasks = false;
  std::string PlanShape;                    // what of the plan the shader's text depends on
  std::vector<vtkMTimeType> ReceiverStamps; // the same, of the techniques
  vtkTimeStamp ShaderStage;
  Stage CurrentStage = SHADE;
  int ShownLight = 0;
  bool Complained = false;

  vtkOpenGLState* State = nullptr; // while attached
  std::unordered_map<vtkInformation*, vtkSmartPointer<vtkInformation>> Attached;
  std::unordered_map<vtkProp*, bool> Receives;                 // leaves and tops
  std::unordered_multimap<vtkAbstractMapper*, vtkProp*> Users; // leaves that a mapper draws
  std::unordered_set<vtkProp*> Dithered;             // leaves and tops that cast by opacity
  std::unordered_map<vtkProp*, unsigned int> Culled; // while casters are drawn
  bool CastersWriteDepth = true;                     // the same
  vtkShadowTechniquePass* Writer = nullptr;          // the same, in TEXELS
  float MaskSize[2] = { 0.0f, 0.0f };
  bool MaskIsPixels = true;
  int ParallelEye = 0;
  vtkNew<vtkShadowCasterCamera> CasterCamera;
  std::unique_ptr<vtkShadowCatchers> Catchers;
  std::unique_ptr<vtkShadowLightFalloffs> Falloffs;
  std::unique_ptr<vtkShadowEyeFaces> EyeFaces;
  std::unique_ptr<vtkShadowMergedCasters> MergedCasters;
  std::unique_ptr<vtkShadowWideFloors> WideFloors;
  bool CullHiddenFaces = false;
  std::string FalloffFault; // as it was last told
  bool DepthClamped = false;
};

#endif
