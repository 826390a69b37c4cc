/**
 * @class   vtkShadowPass
 * @brief   shadows for a renderer, by a technique chosen per light
 *
 * What a renderer is given:
 * @code
 * vtkNew<vtkShadowPass> shadows;
 * renderer->SetPass(shadows);
 * @endcode
 * Every switched-on light that is not a headlight then casts shadows, by a technique that is chosen
 * for it ("auto") unless one is named. Each light's colour is multiplied by that light's
 * **visibility** (1 where the receiver sees the light, 0 where it does not); ambient light is left
 * alone.
 *
 * The frame is otherwise VTK's own: without a delegate the renderer draws its opaque, translucent,
 * volumetric and overlay props as it would without a pass (depth peeling, FXAA, SSAO and hidden
 * line removal included). With a delegate, that pass draws the frame, and shadows reach whatever
 * it draws through VTK's mappers. The pass may itself be the delegate of another, vtkSSAAPass say:
 * masks and maps are then made at that pass's resolution.
 *
 * **Who casts, who receives.** Every visible opaque prop does both. Two keys in a prop's property
 * keys say otherwise (SetCastsShadows and SetReceivesShadows write them):
 * CASTS_SHADOWS 0: never a caster; 1: a caster even if translucent, then as if opaque.
 * RECEIVES_SHADOWS 0: always lit.
 * A third, CASTER_STAND_IN (SetStandIn), has another mesh cast in a prop's place.
 * Volumes and annotations (axes, text, 2D props) neither cast nor receive. A translucent prop
 * receives from techniques of the lookup form (depth-map, object-id, shadow-texture) and is lit
 * by those of the mask form (stencil-volume, ray-cast). A shadow catcher (SetShadowCatcher) shows
 * nothing but
 * shadow.
 *
 * **Lights.** Directional, positional, spot; scene lights and camera lights; light transforms,
 * cone, exponent and attenuation as VTK shades them. A headlight sits at the eye, from where no
 * shadow is seen: it is always lit and costs nothing. A light that its technique cannot serve is
 * left lit, with one warning that says why.
 *
 * Use one vtkShadowPass per renderer: one shared by several works but rebuilds its maps each time.
 * vtkOpenGLFluidMapper ignores render passes and stays lit.
 *
 * @par Reference
 * Williams, L.: Casting curved shadows on curved surfaces, SIGGRAPH 1978 (depth maps);
 * Crow, F.: Shadow algorithms for computer graphics, SIGGRAPH 1977 (shadow volumes);
 * Appel, A.: Some techniques for shading machine renderings of solids, AFIPS 1968 (ray cast).
 *
 * @sa vtkShadowTechniquePass vtkDepthShadowMapPass vtkObjectIDShadowPass vtkPlanarShadowPass
 *     vtkShadowTexturePass vtkStencilShadowVolumePass vtkRayCastShadowPass
 * vtkShadowErrorMeasure
 */
#ifndef vtkShadowPass_h
#define vtkShadowPass_h

#include "vtkRenderPass.h"
#include "vtkShadowsPassesModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string
#include <vector> // for std::vector

class vtkActor;
class vtkDepthShadowMapPass;
class vtkImageData;
class vtkInformationDoubleVectorKey;
class vtkInformationIntegerKey;
class vtkInformationObjectBaseKey;
class vtkObjectIDShadowPass;
class vtkLight;
class vtkPolyData;
class vtkProp;
class vtkRayCastShadowPass;
class vtkRenderer;
class vtkShadowScene;
class vtkShadowTechniquePass;
class vtkShadowTexturePass;
class vtkPlanarShadowPass;
class vtkStencilShadowVolumePass;
struct vtkShadowFrame;
class vtkStringArray;
class vtkTexture;

class VTKSHADOWSPASSES_EXPORT vtkShadowPass : public vtkRenderPass
{
public:
  static vtkShadowPass* New();
  vtkTypeMacro(vtkShadowPass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* w) override;

  ///@{
  /**
   * Technique of every light that has none of its own: "auto" (default: chosen for it, see below),
   * "depth-map", "object-id", "planar", "shadow-texture", "stencil-volume", "ray-cast" or "none"
   * (every light lit). An unknown name is an error that lists the known ones, and changes nothing.
   */
  bool SetTechnique(const std::string& name);
  void SetTechniqueToAuto();
  std::string GetTechnique() const;
  ///@}

  ///@{
  /**
   * What a light of "auto" may cost. MaximumError: percent of the receiver pixels that may be wrong
   * (vtkShadowErrorMeasure's mismatch; of a light with a radius 100 times the mean absolute
   * difference), to 100; 0 (default): no gross error, which is at most one pixel in 100 000, and
   * of a light with a radius a mean difference of at most 1 % of all pixels and 4 % of those in the
   * penumbra.
   * MaximumFrameTime: milliseconds that a frame may take, from the lights' being gathered to the
   * last prop drawn; 0 (default): any. With an error, or neither, a light has the fastest that
   * keeps to it; with a time alone the most accurate that does; with both the error comes first,
   * and GetExplanation says if the time is not held. Negative values, and what is not finite, are
   * errors and change nothing.
   *
   * What is right by construction in a scene (planar shadows where all that receives is flat,
   * shadow volumes where all that casts is triangles, rays) is taken for right for a light without
   * a radius. The error of depth maps, of textures on planes and of sample lights is measured
   * beside the frame, at about a million rays, for a light with a radius 8 of them a pixel and 256
   * where the light is seen in part: at the first frame, and again once view, lights or casters are
   * clearly others. In the first
   * frames what may be the fastest is drawn a few times each; all of it keeps to the budget of
   * error. In a frame where lights or casters move another choice may hold. Chosen with a technique
   * are the depth map's resolution, cascades, filter and LightSamples, planar's LightSamples and
   * PlaneTextures, and the LightSamples of stencil-volume and ray-cast, as far as they are at their
   * defaults and no other light names the technique; they are put back once no light is of "auto".
   */
  void SetMaximumError(double percent);
  double GetMaximumError() const;
  void SetMaximumFrameTime(double milliseconds);
  double GetMaximumFrameTime() const;
  ///@}

  ///@{
  /**
   * Of the last frame: why a light has its technique, in a sentence that names it first; the
   * technique itself, "none" if it has none; and whether it was drawn by what is chosen, and no
   * more frames are drawn to tell the fastest.
   */
  std::string GetExplanation(vtkLight* light) const;
  std::string GetChosenTechnique(vtkLight* light) const;
  bool GetChoiceIsSettled() const;
  ///@}

  ///@{
  /**
   * Draw each frame by what "auto" took for the last one, as long as that is right (default off).
   * For frames that make one picture together, which must be alike: tiles, samples, a matte
   * (vtkShadowMatte turns it on by itself). Trials go on once it is off.
   */
  void SetHoldChoice(bool held);
  bool GetHoldChoice() const;
  vtkBooleanMacro(HoldChoice, bool);
  ///@}

  ///@{
  /**
   * Technique of one light, and back to the default one with an empty name.
   */
  bool SetLightTechnique(vtkLight* light, const std::string& name);
  std::string GetLightTechnique(vtkLight* light) const;
  ///@}

  ///@{
  /**
   * Leave out the faces of closed, opaque actors that are turned away from the eye (default off): a
   * frame needs less time. The picture stays, but for single pixels on silhouettes where rounding
   * had a far face in front. VTK's back-face culling does it, of actors that have none set, whose
   * surface is proven not to pass through itself and lies beyond the near plane. The proof is made
   * once a shape, in a thread of its own, when a second frame shows it. Not with a delegate pass,
   * nor where no light has a technique or a falloff: such a frame is VTK's own.
   * GetNumberOfCulledReceivers: of how many actors they were left out in the last frame.
   * GetCullingIsSettled: whether no proof was being made then that lets later frames leave out
   * more.
   */
  void SetCullHiddenFaces(bool culled);
  bool GetCullHiddenFaces() const;
  vtkBooleanMacro(CullHiddenFaces, bool);
  int GetNumberOfCulledReceivers() const;
  bool GetCullingIsSettled() const;
  ///@}

  ///@{
  /**
   * How many casters were drawn from one list of their triangles, and not by their mappers, in the
   * last frame; each is counted once a view of a light. Small actors are, from their second draw in
   * the same shape on: a draw of its own costs more than their triangles do. So are large ones, up
   * to two million triangles, once a view sees less than half of one: it draws what it sees. And
   * the list's bytes, which are no technique's own.
   */
  int GetNumberOfMergedCasters() const;
  vtkIdType GetMergedCasterMemory() const;
  ///@}

  ///@{
  /**
   * Shadow strength of one light, 0 (lit everywhere, and nothing is computed) to 1 (default: no
   * light where it is not seen). Clamped.
   */
  void SetLightStrength(vtkLight* light, double strength);
  double GetLightStrength(vtkLight* light) const;
  ///@}

  ///@{
  /**
   * Radius of one light, at least 0 (default 0, hard shadows): of its luminous disc in world units;
   * for a directional light the tangent of its half-angle (the sun: 0.00465). "depth-map" softens
   * by it by its filters "soft" and "sample-lights", and else casts hard shadows; "object-id" casts
   * hard ones; the others soften by it.
   */
  void SetLightRadius(vtkLight* light, double radius);
  double GetLightRadius(vtkLight* light) const;
  ///@}

  ///@{
  /**
   * How far from the eye the shadows of one light reach, in world units; 0 (default): however far.
   * Up to `fade` of that distance, 0 to 1 (default 0.1), before its end they fade out; beyond it
   * the light is lit. Cascades reach no farther, and are the finer for it. Like strength it is no
   * part of the visibility that is read back. Negative
   * values, and what is not finite, are errors and change nothing.
   */
  void SetLightMaximumDistance(vtkLight* light, double distance);
  double GetLightMaximumDistance(vtkLight* light) const;
  void SetLightFade(vtkLight* light, double fade);
  double GetLightFade(vtkLight* light) const;
  ///@}

  ///@{
  /**
   * How softly the cone of a spot light ends: the share of its angle, 0 (default: at once, as VTK
   * has it) to 1, over which the light falls off before its side. It is 1 up to (1 - share) of the
   * cone's angle and 0 at its side; between them it is the smoothstep (3 t^2 - 2 t^3) of the cosine
   * of the angle, t its way from the side's cosine to the inner one's. It multiplies the light's
   * colour, as VTK's exponent and attenuation do, for any technique and for "none"; like strength
   * it is no part of the visibility that is read back. The light must be a spot (positional, cone
   * angle below 90 degrees): else, or if the share is out of range, an error, and nothing changes.
   */
  void SetLightSmoothCone(vtkLight* light, double share);
  double GetLightSmoothCone(vtkLight* light) const;
  ///@}

  ///@{
  /**
   * An image that a spot light projects, as a slide projector does; nullptr (default): none. It
   * covers the square around the cone's circle: a receiver that the light sees at the tangents x to
   * the right of its axis and y above it has the colour at (1 + x / tan(cone)) / 2 of the image's
   * width and (1 + y / tan(cone)) / 2 of its height, beside the image black. That colour, alpha
   * left aside, multiplies the light's; VTK's cone, exponent and attenuation, and
   * SetLightSmoothCone, are in force as well. Right and up are those of someone who stands at the
   * light and looks along it, with the vector of SetLightTextureUp above. The texture's own
   * settings of interpolation, mipmaps, colour mapping and sRGB hold; its wrapping does not. For
   * any technique and for "none"; no part of the visibility that is read back. The light must be a
   * spot (positional, cone angle below 90 degrees), and the texture of one image: else an error,
   * and nothing changes. A texture unit of the driver is taken for each texture of the frame: of 16
   * and more some are at hand.
   */
  void SetLightTexture(vtkLight* light, vtkTexture* texture);
  vtkTexture* GetLightTexture(vtkLight* light) const;
  ///@}

  ///@{
  /**
   * Which way is up in a projected image: a vector of the world, of any length (default 0, 0, 1),
   * as the light sees it. Of a light that looks along it, to a thousandth, y is up instead, or z if
   * the vector is nearer to y. Zero, and what is not finite, are errors and change nothing.
   */
  void SetLightTextureUp(vtkLight* light, double x, double y, double z);
  void GetLightTextureUp(vtkLight* light, double up[3]) const;
  ///@}

  /**
   * Forget technique, strength, radius, distance, fade, smooth cone and texture of one light
   * (nullptr: of all).
   */
  void ClearLightSettings(vtkLight* light);

  /**
   * Names of the techniques there are in this build, "auto" and "none" included.
   */
  static void GetTechniqueNames(vtkStringArray* names);

  ///@{
  /**
   * The techniques' own settings. GetRayCastShadowPass is nullptr in a build without Embree.
   */
  vtkDepthShadowMapPass* GetDepthShadowMapPass();
  vtkObjectIDShadowPass* GetObjectIDShadowPass();
  vtkPlanarShadowPass* GetPlanarShadowPass();
  vtkShadowTexturePass* GetShadowTexturePass();
  vtkStencilShadowVolumePass* GetStencilShadowVolumePass();
  vtkRayCastShadowPass* GetRayCastShadowPass();
  vtkShadowTechniquePass* GetTechniquePass(const std::string& name);
  ///@}

  ///@{
  /**
   * A view that explains the shadows of one light, drawn over the frame: "none" (default); or for a
   * light of the technique "stencil-volume":
   * - "volumes": the sides of its shadow volumes, blue where faces are counted before the receiver
   *   (z-pass) and orange where behind it (z-fail);
   * - "silhouette": the edges that the sides stand on, yellow, and magenta where more than one
   *   stands;
   * - "counts": in how many volumes each pixel's receiver lies: 1 to 6 from blue to red, more
   *   purple, from 256 on white, below 0 grey;
   * or for a light of a technique by maps, "depth-map":
   * - "cascades": which of its maps each receiver is looked up in, by colour: cascades from the
   *   nearest on, and faces of a cube, orange, sky blue, green, yellow, blue, vermilion, purple,
   *   grey; without colour where there is no map;
   * - "texel-density": the map's texels to a pixel, in the direction in which they are fewest: red
   *   where a texel is 16 pixels wide or more, pale at 1, blue at 16 texels to a pixel or more. Red
   *   beside blue are the duelling frusta of light and eye;
   * - "map": the maps themselves, from the lower left, near to the light black, far and empty
   * white;
   * - "lit-part": the part of the scene that each map covers, in those colours, the finest in
   * front, its border as a line; dark what no map covers. Another name is an error that lists the
   * known ones, and changes nothing.
   */
  bool SetDebugView(const std::string& view);
  std::string GetDebugView() const;
  static void GetDebugViewNames(vtkStringArray* names);
  ///@}

  /**
   * The techniques that a view explains, none for "none".
   */
  static void GetDebugViewTechniques(const std::string& view, vtkStringArray* names);

  ///@{
  /**
   * The light that the view explains; nullptr (default): the first that casts shadows.
   */
  void SetDebugLight(vtkLight* light);
  vtkLight* GetDebugLight() const;
  ///@}

  ///@{
  /**
   * The pass that draws the frame; nullptr (default): as the renderer draws it without a pass.
   */
  void SetDelegatePass(vtkRenderPass* delegate);
  vtkRenderPass* GetDelegatePass();
  ///@}

  /**
   * Visibility of one light in the current view of `renderer`, as an image of the renderer's size:
   * one float component, 0 (not seen) to 1 (seen, background, or no receiver), origin bottom-left.
   * Strength is left out: it is the technique's own answer. The renderer's window must have
   * rendered once and `renderer` must have this pass; light must be one of its lights. Renders the
   * receivers into a buffer of its own, not into the window. A shadow catcher is a receiver there
   * that hides what is behind it. false, with an error, if it could not be made.
   */
  bool GetVisibility(vtkRenderer* renderer, vtkLight* light, vtkImageData* visibility);

  /**
   * As GetVisibility, of all lights of `renderer` that are switched on: a component for each, in
   * their order. What all lights are drawn by is made once, where n calls of GetVisibility make it
   * n times.
   */
  bool GetVisibilities(vtkRenderer* renderer, vtkImageData* visibilities);

  /**
   * In how many shadow volumes of one light the receiver of each pixel lies, as GetVisibility gives
   * visibility: one float component, 0 or less where lit; where there is no receiver it says
   * nothing. The light's technique must be "stencil-volume". Of a light with a radius, its last
   * sample.
   */
  bool GetVolumeCounts(vtkRenderer* renderer, vtkLight* light, vtkImageData* counts);

  /**
   * Seconds that a bare loop of Embree's rtcOccluded1 over all cores takes for the rays from the
   * receivers in the current view of `renderer` to every light: the limit to hold
   * vtkRayCastShadowPass::GetTraceSeconds against. 0 without Embree or without casters.
   */
  double TimeBareTracing(vtkRenderer* renderer);

  ///@{
  /**
   * Time the stages of each frame (default off: it empties OpenGL's queue between them, which costs
   * a little). Of the last frame that was timed: the names of its stages, in their order: "scene",
   * lights, casters and receivers gathered; a technique's name, its visibility brought up to date;
   * "shading", the frame drawn with it. Seconds that one took on the clock, 0 if there was none;
   * and on the GPU by its own clock, below 0 if the driver does not tell or there was none.
   */
  void SetTimeStages(bool timed);
  bool GetTimeStages() const;
  void GetStageNames(vtkStringArray* names) const;
  double GetStageSeconds(const std::string& name) const;
  double GetStageGPUSeconds(const std::string& name) const;
  ///@}

  enum TranslucentCastingType
  {
    TRANSLUCENT_NONE = 0,   // they cast nothing
    TRANSLUCENT_OPAQUE = 1, // as if they were opaque
    TRANSLUCENT_STOCHASTIC =
      2, // by opacity: in maps and flattened shadows each texel holds or lets through
    TRANSLUCENT_TRANSMITTANCE =
      3 // by opacity, without grain: in depth maps each texel is attenuated
  };

  ///@{
  /**
   * How translucent props cast that have no key CASTS_SHADOWS: one of TranslucentCastingType
   * (default TRANSLUCENT_NONE), or its name: "none", "opaque", "stochastic", "transmittance".
   * TRANSLUCENT_STOCHASTIC goes for all that cast, and is told by
   * "depth-map" and the other techniques that draw casters: of a prop of the opacity 0.3 three
   * texels in ten cast, in a fixed pattern that a wide filter smooths (screen-door transparency;
   * Enderton et al. 2010). The others, "stencil-volume" and "ray-cast", cast as if it were opaque.
   * TRANSLUCENT_TRANSMITTANCE: a receiver behind the translucent surface that is nearest to the
   * light has the light times the product of 1 - opacity over all translucent surfaces before the
   * nearest opaque one, without noise. What lies between two of them, or is the second, has the
   * attenuation of both. It is told by "depth-map" with any filter; with "sample-lights", and by
   * the other techniques, it is TRANSLUCENT_STOCHASTIC. Another value is an error and changes
   * nothing.
   */
  void SetTranslucentCasting(int how);
  void SetTranslucentCasting(const std::string& name);
  int GetTranslucentCasting() const;
  static std::string GetTranslucentCastingName(int how);
  static int GetNumberOfTranslucentCastings();
  ///@}

  /**
   * What the last frame saw: lights, casters, receivers.
   */
  vtkShadowScene* GetScene();

  ///@{
  /**
   * The keys that say whether a prop casts and receives (int, 0 or 1; default 1), and their
   * setters. A part of an assembly has the assembly's keys: VTK hands them down.
   */
  static vtkInformationIntegerKey* CASTS_SHADOWS();
  static vtkInformationIntegerKey* RECEIVES_SHADOWS();
  static void SetCastsShadows(vtkProp* prop, bool casts);
  static void SetReceivesShadows(vtkProp* prop, bool receives);
  ///@}

  ///@{
  /**
   * A **shadow catcher** shows nothing but the shadow that falls on it: its own colour where light
   * is missing, transparent elsewhere. It always receives, from every technique, and never casts.
   * Making an actor one gives its property the opacity 0, by which VTK draws it translucent, and
   * not at all without this pass or without a light that casts; picking passes through it, too. A
   * catcher that is made no catcher is opaque again (opacity 1). Its property must be its own. One
   * whose property is given the opacity 1 is an ordinary prop as long as it has that.
   *
   * Its alpha is strength times the share of its brightness that a floor with its property would
   * lose: D (G - R) / (A + D G), where R is the luminance of the light that arrives, with each
   * light's N.L, attenuation and visibility, G the same without visibility, and D and A the
   * luminance of its diffuse and ambient colour. With one light, no ambient colour and strength 1
   * it is 1 - visibility. Where no light arrives it is 0. A property without lighting catches
   * nothing.
   */
  static void SetShadowCatcher(vtkActor* actor, bool catches);
  static bool IsShadowCatcher(vtkProp* prop);
  ///@}

  ///@{
  /**
   * Settings of a catcher; an actor that is none is made one.
   * Color: of the shadow, red, green and blue from 0 to 1 (default black).
   * Strength: what its alpha is multiplied by, 0 to 1 (default 1).
   * Fade: 0 to 1 (default 0): share of the way from its rim to its middle, along each axis of its
   * bounds in model coordinates, on which the shadow rises from nothing to its whole strength.
   * Values are clamped; what is not finite is refused with a warning.
   */
  static void SetCatcherColor(vtkActor* actor, double red, double green, double blue);
  static void SetCatcherStrength(vtkActor* actor, double strength);
  static void SetCatcherFade(vtkActor* actor, double fade);
  ///@}

  /**
   * What they are; false, and the defaults, for a prop that is no catcher.
   */
  static bool GetCatcherSettings(vtkProp* prop, double color[3], double& strength, double& fade);

  /**
   * The key that makes a prop a catcher, if it is translucent: red, green, blue, strength, fade.
   */
  static vtkInformationDoubleVectorKey* SHADOW_CATCHER();

  ///@{
  /**
   * A mesh that casts in place of a prop that casts, a decimated or convex one say: the key, in the
   * prop's property keys, its setter and its getter; nullptr (default): the prop itself. It is
   * given in the prop's own coordinates and follows the prop's matrix; edited in place, it must be
   * told so by Modified(). A mesh without triangles, or an infinite one, is left out with one
   * warning. "ray-cast", the truth that errors are held against, casts with the prop all the same.
   * The prop receives its stand-in's shadow as any other: where it lies behind that, as in a hull
   * around it, it is dark; choose a mesh that lies within it, or let the prop receive nothing.
   */
  static vtkInformationObjectBaseKey* CASTER_STAND_IN();
  static void SetStandIn(vtkProp* prop, vtkPolyData* mesh);
  static vtkPolyData* GetStandIn(vtkProp* prop);
  ///@}

protected:
  vtkShadowPass();
  ~vtkShadowPass() override;

  friend class vtkShadowErrorMeasure;
  friend class vtkShadowTechniquePass;
  friend class vtkShadowFramePass;

  // Be the pass of one technique that is owned elsewhere.
  void UseTechnique(vtkShadowTechniquePass* technique);

  // The frame, once the camera is set up.
  void RenderFrame(const vtkRenderState* s);

  // Visibility and truth of `light` at every pixel, as vtkShadowErrorMeasure wants them.
  struct Measured;
  bool MeasureLight(vtkRenderer* renderer, vtkLight* light, Measured& measured);

private:
  vtkShadowPass(const vtkShadowPass&) = delete;
  void operator=(const vtkShadowPass&) = delete;

  // What is read back outside of a frame: whether `renderer` can be drawn; the number of a light;
  // and visibility of `lights`, by their numbers, as components.
  bool IsReadable(vtkRenderer* renderer);
  bool FindLight(vtkRenderer* renderer, vtkLight* light, int& index);
  bool ReadVisibility(vtkRenderer* renderer, const std::vector<int>& lights, vtkImageData* image);
  void ShowDebugView(const vtkShadowFrame& frame);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
