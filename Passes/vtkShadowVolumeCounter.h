// In how many shadow volumes does the receiver of each pixel lie? The receivers' depth, a count a
// pixel, and the draws that change it.
//
// Counts are floats that blending adds to, exact up to 2^24 volumes; or the stencil's 8 bits, which
// wrap: exact up to 127 volumes, and blind to a multiple of 256.
#ifndef vtkShadowVolumeCounter_h
#define vtkShadowVolumeCounter_h

#include "ShadowReach.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowVolumeCaster.h"

#include <memory>

class vtkShaderProgram;
class vtkShadowDrawScope;
struct vtkShadowFrame;

class vtkShadowVolumeCounter
{
public:
  vtkShadowVolumeCounter();
  ~vtkShadowVolumeCounter();

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
    Rule Faces = Rule::Fail;
    vtkshadows::ViewBounds Bounds; // nothing of it is wanted outside
  };

  // Room for counts of the frame's size, and for sums of sample lights if `sums`. false if the
  // driver has none.
  bool Reserve(const vtkShadowFrame& frame, bool stencil, bool sums);

  // The depth of what is opaque in this frame, seen by `view`. false if the driver cannot.
  bool DrawReceivers(const vtkShadowFrame& frame, const vtkshadows::LightView& view);

  // Between Begin and End: every count starts at `start`, and draws add to it.
  bool Begin(const vtkShadowFrame& frame, const Eye& eye, int start);
  void Add(const Draw& draw);
  void End();

  // Write the visibility that the counts tell to a layer of masks; as a share of it, added to the
  // sum, where one light is several samples.
  void Resolve(const vtkShadowFrame& frame, vtkShadowTextureArray& masks, int layer, bool parity);
  void ClearSum(const vtkShadowFrame& frame);
  void AddToSum(const vtkShadowFrame& frame, float share, bool parity);
  void ResolveSum(const vtkShadowFrame& frame, vtkShadowTextureArray& masks, int layer);

  // The counts of the last Begin: width * height floats, row by row from the bottom.
  void ReadCounts(const vtkShadowFrame& frame, std::vector<float>& counts);

  // Faces handed to OpenGL since the last ResetNumberOfTriangles.
  std::size_t NumberOfTriangles = 0;

  void Release();

private:
  void SetRule(bool behind);
  void DrawSection(const vtkShadowVolumeCaster::Section& section, int front, int back);
  void DrawFullScreen(const vtkShadowFrame& frame, vtkShadowTextureArray& source, bool isSum,
    float share, bool parity);
  void ResolveStencil(const vtkShadowFrame& frame, float share, bool parity);

  bool UsesStencil = false;
  bool CountsBehind = false;
  vtkShadowTextureArray Depth, Counts, Sums;
  std::unique_ptr<vtkShadowDrawScope> Scope;
  const vtkShadowFrame* Frame = nullptr;
  vtkOpenGLState* State = nullptr;
  Eye CurrentEye;
  vtkShaderProgram* Program = nullptr;
  int PointUnit = -1;
  unsigned int Arrays = 0; // a vertex array object without arrays
};

#endif
