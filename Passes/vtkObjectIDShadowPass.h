/**
 * @class   vtkObjectIDShadowPass
 * @brief   visibility by a map of object IDs, with each object's depth in its own range
 *
 * Technique "object-id", form lookup: casters are drawn from the light into a map of IDs, one for
 * each object. A receiver is held against the texels around it. Where the light sees another object
 * there, nearer than the receiver, it is in shadow. Where the light sees the receiver's own object,
 * depth decides (CombineDepth, the default), or it is lit.
 *
 * With CombineDepth a texel holds, beside the ID, the depth within the range that the object has
 * along the light, in DepthBits bits: 16 of them divide each object's own depths, not the scene's,
 * so that a small object in a large scene shadows itself as precisely as alone. Without it a texel
 * is an ID, no bias is needed, and **no object has a shadow on itself** (GetSelfShadows).
 *
 * What an object is, is a setting: a prop, a block of a composite data set, a glyph's instance, or
 * a connected piece of a mesh. Directional, spot and point lights; which views they have, and when
 * a map is drawn again, see vtkMapShadowPass.
 *
 * Limits: an edge is as sharp as the map's texels. IDs are 32 - DepthBits bits wide and at most
 * 65535, or what the driver's buffer textures hold of them for each map: further objects share
 * them, one warning says so. Impostors, glyphs with level of detail or of a source tree, and what a
 * geometry shader draws (visible edges, wide lines) are one object for each prop. Without
 * CombineDepth a texel says no more of another object than its nearest depth: a receiver between
 * two parts of it, or one that does not cast itself, is in shadow of what lies behind it.
 *
 * @par Reference
 * Hourcade and Nicolas: Algorithms for antialiased cast shadows, Computers and Graphics 9(3), 1985
 * (IDs; several tests); Williams 1978 (depths); Reeves, Salesin and Cook: Rendering antialiased
 * shadows with depth maps, SIGGRAPH 1987 (percentage-closer filtering); Dietrich: Practical
 * priority buffer shadows, Game Programming Gems 2, 2001 (IDs between objects, depths within one).
 *
 * @sa vtkShadowPass vtkMapShadowPass vtkDepthShadowMapPass
 */
#ifndef vtkObjectIDShadowPass_h
#define vtkObjectIDShadowPass_h

#include "vtkMapShadowPass.h"

class VTKSHADOWSPASSES_EXPORT vtkObjectIDShadowPass : public vtkMapShadowPass
{
public:
  static vtkObjectIDShadowPass* New();
  vtkTypeMacro(vtkObjectIDShadowPass, vtkMapShadowPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ObjectType
  {
    PROP = 0,     // each prop; of an assembly, each part
    BLOCK = 1,    // and each block of a composite data set, with the glyphs at its points
    INSTANCE = 2, // and each instance of a glyph mapper
    PIECE = 3     // and, of meshes and blocks, each piece that is connected by points
  };

  ///@{
  /**
   * What is an object: one of ObjectType (default PROP), or its name: "prop", "block", "instance",
   * "piece". Each has those before it, too. Another one is an error that lists the known ones, and
   * changes nothing.
   */
  void SetObjectType(int type);
  void SetObjectType(const std::string& name);
  vtkGetMacro(ObjectType, int);
  static std::string GetObjectTypeName(int type);
  static int GetNumberOfObjectTypes();
  ///@}

  ///@{
  /**
   * Whether a texel holds a depth as well (default on). Off: no object shadows itself.
   */
  void SetCombineDepth(bool combine);
  vtkGetMacro(CombineDepth, bool);
  vtkBooleanMacro(CombineDepth, bool);
  ///@}

  /**
   * Whether an object can have a shadow on itself, with the present settings.
   */
  bool GetSelfShadows() const { return this->CombineDepth; }

  ///@{
  /**
   * Bits of a depth within its object's range: 8, 16 (default), 24, or 32, a float. With 32 a texel
   * has eight bytes, else four. Other values are an error and change nothing.
   */
  void SetDepthBits(int bits);
  vtkGetMacro(DepthBits, int);
  ///@}

  ///@{
  /**
   * A receiver is tested against Taps x Taps texels around it, 1 to 4 (default 2). With
   * CombineDepth their answers are blended; without, it is in shadow where all agree. Other values
   * are an error and change nothing.
   */
  void SetTaps(int taps);
  vtkGetMacro(Taps, int);
  ///@}

  /**
   * Objects that cast in the last frame.
   */
  int GetNumberOfObjects() const;

  const char* GetTechniqueName() const override { return "object-id"; }
  vtkIdType GetTextureMemory() const override;
  vtkIdType GetCasterMemory() const override;
  void ReleaseGraphicsResources(vtkWindow* w) override;

protected:
  vtkObjectIDShadowPass();
  ~vtkObjectIDShadowPass() override;

  std::string GetLookupPrefix() const override { return "shadowObjectMap"; }
  std::string GetMacroPrefix() const override { return "SHADOW_OBJECT_MAP"; }
  std::string GetCompareDeclarations() const override;
  double GetMarginTexels() const override;
  bool UpdateVisibility(const vtkShadowFrame& frame, const std::vector<int>& lights) override;
  bool ReserveMaps(const vtkShadowFrame& frame, int width, int height, int layers) override;
  void BeginMaps(const vtkShadowFrame& frame) override;
  void DrawMap(const vtkShadowFrame& frame, const vtkShadowMapSlot& slot,
    const vtkShadowMapView& view, int width, int height) override;
  vtkShadowTextureArray* GetTextures() override;
  std::string GetSamplerName() const override { return "shadowObjectMaps"; }
  void ActivateTextures() override;
  void DeactivateTextures() override;
  vtkShadowVertexCode GetObjectCode(bool byVertex) const override;
  CasterCode GetCasterCode() const override;
  void SetObjectParameters(
    vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop) override;

  int ObjectType = PROP;
  bool CombineDepth = true;
  int DepthBits = 16;
  int Taps = 2;

private:
  vtkObjectIDShadowPass(const vtkObjectIDShadowPass&) = delete;
  void operator=(const vtkObjectIDShadowPass&) = delete;

  std::string Defines() const;
  int StoredBits() const { return this->CombineDepth ? this->DepthBits : 0; }
  int MostIDs(std::size_t lights) const;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
