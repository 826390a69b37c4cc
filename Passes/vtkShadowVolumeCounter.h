// In how many shadow volumes does the receiver of each pixel lie? The receivers' depth, a count a
// pixel, and the draws that change it.
//
// Three ways to count:
// - Stencil: the stencil's 8 bits, faces that add drawn ahead of those that take away. A count that
//   reached 255 is seen, and then floats count instead: exact, and cheaper where many faces overlap
//   and, as almost everywhere, that does not happen;
// - WrappingStencil: all faces in one go, modulo 256 (Heidmann 1991): right up to 127;
// - Float: by blending, exact up to 2^24.
#ifndef vtkShadowVolumeCounter_h
#define vtkShadowVolumeCounter_h

#include "ShadowReach.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowVolumeCaster.h"

#include <array>
#include <memory>

class vtkShaderProgram;
class vtkShadowDrawScope;
struct vtkShadowFrame;

class vtkShadowVolumeCounter
{
public:
  vtkShadowVolumeCounter();
  ~vtkShadowVolumeCounter();

  enum class Way
  {
    Stencil,
    WrappingStencil,
    Float
  };

  // How the faces of one caster's volume are counted.
  enum class Rule
  {
    Fail,       // those at or behind the receiver, with caps
    Pass,       // those before it
    PassCapped, // those before it, and a cap thrown on the near plane
  };

  // The eye, as receivers and volumes are drawn.
  struct Eye
  {
    glm::dmat4 ClipFromWorld{ 1.0 };
    glm::dvec4 NearPlaneWC{ 0.0 }; // n.x + d, 0 on the near plane
    bool UsesDepthClamp = true;    // else its far plane is at infinity
  };

  // One caster's volume of one light.
  struct Draw
  {
    const vtkShadowVolumeCaster* Caster = nullptr;
    const vtkShadowVolumeCaster::Volume* Volume = nullptr;
    glm::dvec4 LightWC{ 0.0 };
    glm::dvec4 FarPlaneWC{ 0.0 }; // n.x <= d as (n, d); n = 0: to infinity
    bool FarCaps = true;
    bool ClipsCaps = false; // its near plane cuts the caster, its far plane does not
    Rule Faces = Rule::Fail;
    vtkshadows::ViewBounds Bounds; // nothing of it is wanted outside
  };

  // Room for the receivers' depth and counts of the frame's size, and for sums of sample lights if
  // `sums`. false if the driver has none.
  bool Reserve(const vtkShadowFrame& frame, bool sums);

  // The depth of what is opaque in this frame, seen by `view`. false if the driver cannot.
  bool DrawReceivers(const vtkShadowFrame& frame, const vtkshadows::LightView& view);

  // Count all volumes of a light, from `start` on. false if the driver cannot.
  bool Count(const vtkShadowFrame& frame, const Eye& eye, const std::vector<Draw>& draws, int start,
    Way way);

  // Write the visibility that the counts tell to a layer of masks; as a share of it, added to the
  // sum, where one light is several samples.
  void Resolve(const vtkShadowFrame& frame, vtkShadowTextureArray& masks, int layer, bool parity);
  void ClearSum(const vtkShadowFrame& frame);
  void AddToSum(const vtkShadowFrame& frame, float share, bool parity);
  // Smooth steps of the sum that are about as high as `step`; edges stay. false if the driver
  // cannot.
  bool SmoothSum(const vtkShadowFrame& frame, float step);
  void ResolveSum(
    const vtkShadowFrame& frame, vtkShadowTextureArray& masks, int layer, bool smoothed);

  // Views that explain, over the frame in the bound framebuffer and its viewport: the volumes, from
  // `clipFromWorld`, blue where faces are counted before the receiver and orange behind it; the
  // silhouettes, yellow where one side stands on them and magenta where more do; the last counts,
  // in floats, by colour.
  void ShowVolumes(
    const vtkShadowFrame& frame, const glm::dmat4& clipFromWorld, const std::vector<Draw>& draws);
  void ShowSilhouettes(
    const vtkShadowFrame& frame, const glm::dmat4& clipFromWorld, const std::vector<Draw>& draws);
  void ShowCounts(const vtkShadowFrame& frame);

  // The last counts, in floats: width * height, row by row from the bottom.
  void ReadCounts(const vtkShadowFrame& frame, std::vector<float>& counts);

  // Since they were last set to 0: faces handed to OpenGL, and calls that did it; lights that
  // stencils could not count.
  std::size_t NumberOfTriangles = 0;
  std::size_t NumberOfDraws = 0;
  std::size_t NumberOfOverflows = 0;

  // Whether this driver passes over pixels by the depth that is stored there: found out by Reserve.
  bool HasDepthBounds() const { return this->DepthBounds; }

  void Release();
  // Of its textures.
  std::size_t Bytes() const
  {
    return this->Depth.Bytes() + this->Counts.Bytes() + this->Sums.Bytes();
  }

private:
  enum class Phase
  {
    Everything,
    Additions,
    Subtractions
  };
  // Of the caster that is set, of its soup or of all else.
  enum class Faces
  {
    Sides,
    DoubleSides,
    Caps,
    TurnedCaps
  };

  bool UsesStencil() const { return this->CurrentWay != Way::Float; }
  bool Begin(const vtkShadowFrame& frame, const Eye& eye, int start, Way way);
  void End();
  void Add(const Draw& draw, Phase phase);
  void ConfineDepths(const Draw& draw) const;
  static bool MayUseDepthBounds();
  bool HasOverflown();
  void StartVolumes(const vtkShadowFrame& frame, const char* fragmentShader);
  void EndVolumes();
  void SetCaster(const Draw& draw, const glm::dmat4& clipFromWorld, bool soup);
  void AddFaces(const Draw& draw, Phase phase);
  // Faces, or the images of caps at the far end.
  struct Part
  {
    Faces Of;
    bool Images = false;
  };
  using Parts = std::vector<Part>;
  void CountFaces(const Parts& parts, int front, int back, bool behind, Phase phase);
  std::size_t DrawFaces(const Parts& parts);
  std::size_t DrawFacesOfSoup(Faces faces);
  std::size_t DrawSoup(const vtkshadows::VolumeLists::List& list, int borders, bool turned);
  template <typename Use>
  void Show(const vtkShadowFrame& frame, const std::vector<Draw>& draws, const Use& use);
  void ResolveFloats(const vtkShadowFrame& frame, float share, bool parity);
  void ResolveStencil(const vtkShadowFrame& frame, float share, bool parity);

  bool DepthBounds = false;
  Way CurrentWay = Way::Stencil;
  vtkShadowTextureArray Depth, Counts, Sums;
  std::unique_ptr<vtkShadowDrawScope> Scope;
  const vtkShadowFrame* Frame = nullptr;
  vtkOpenGLState* State = nullptr;
  Eye CurrentEye;
  int PointUnit = -1, ListUnit = -1;
  unsigned int Arrays = 0; // a vertex array object without arrays
  unsigned int SoupIndices = 0;

  // Of what is drawn: the caster that is set, and whether its soup is.
  std::string FragmentShader;
  std::array<vtkShaderProgram*, 2> Programs{}; // without soup, and for it
  vtkShaderProgram* Program = nullptr;
  const vtkShadowVolumeCaster* Caster = nullptr;
  const vtkShadowVolumeCaster::Volume* Volume = nullptr;
  bool Soup = false;
};

#endif
