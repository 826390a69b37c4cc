// The views of the lights of a technique by maps: what each light needs in this frame, in which
// layer of a texture array each map lies and which are stale, and what the lookup is told of them.
#ifndef vtkShadowMapViews_h
#define vtkShadowMapViews_h

#include "vtkShadowSceneData.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

// One view of a light, in this frame, and all that its map is drawn from: equal ones give equal
// maps.
struct vtkShadowMapView
{
  static constexpr int NoLayer = -1;

  vtkshadows::LightView View;
  vtkMTimeType CasterStamp = 0;
  std::vector<std::size_t> Casters; // among the scene's props, ascending
  int Face = vtkshadows::NoFace;    // of a cube
  int Layer = NoLayer;

  bool DrawsAs(const vtkShadowMapView& other) const
  {
    return this->CasterStamp == other.CasterStamp &&
      this->View.viewFromWorld == other.View.viewFromWorld &&
      this->View.clipFromView == other.View.clipFromView && this->Casters == other.Casters;
  }
};

// What a slot's light needs of this frame.
struct vtkShadowMapSlot
{
  vtkshadows::ShadowLight Light;
  bool IsCube = false;
  glm::dmat4 CubeFromWorld{ 1.0 };
  std::vector<vtkshadows::BoxCorners> Casters; // that can cast on a receiver
  std::vector<vtkShadowMapView> Views;
};

class vtkShadowMapViews
{
public:
  // A matrix, and a face of a cube, as GLSL takes them.
  using ShaderMatrix = std::array<float, 16>;
  using FaceParameters = std::array<float, 4>;

  // Takes every point nearer to the light than any caster.
  static const ShaderMatrix LitEverywhere;

  // Fits the views of `lights`, for maps of `resolution` texels on the longer side of which
  // `margin` stay free on every side.
  void Fit(
    const vtkShadowFrame& frame, const std::vector<int>& lights, int resolution, double margin);
  int NumberOfViews() const;

  // Gives each view one of `layers` layers: one that holds its map already, if there is.
  void Place(int layers);
  // What the layers held is lost.
  void ForgetLayers() { this->Drawn.clear(); }

  // Calls draw(slot, view) for each view whose layer does not hold its map.
  template <typename Draw>
  void DrawStale(const Draw& draw)
  {
    for (const vtkShadowMapSlot& slot : this->Slots)
    {
      for (const vtkShadowMapView& view : slot.Views)
      {
        Content& content = this->Drawn[view.Layer];
        if (!content.Known || !content.Of.DrawsAs(view))
        {
          draw(slot, view);
          content = { true, view };
        }
      }
    }
  }

  // What the lookup is told of each slot, once its views have layers; true if other shaders are
  // needed for it. `prefix`: of the lookup's functions; `riseTexels`: see DepthSlack.
  bool UpdateLookups(const std::string& prefix, const glm::dmat4& viewFromWorld, double riseTexels);

  // What can cast on any of the receivers, and which of the scene's props each is of.
  static std::vector<vtkshadows::BoxCorners> CastersOf(const vtkShadowScene& scene,
    const vtkshadows::ShadowLight& light, const std::vector<vtkshadows::BoxCorners>& receivers,
    std::vector<std::size_t>& owners);

  // What a receiver's depth is less by in a map of `width` texels, over w: a bound of its rounding,
  // and the depth of `riseTexels` texels' width. `map`: to it from the eye's view coordinates.
  static double DepthSlack(const glm::dmat4& map, const vtkshadows::LightView& view,
    const glm::dmat4& viewFromWorld, int width, double riseTexels,
    const std::vector<vtkshadows::BoxCorners>& castersWC);
  const std::string& Function(int slot) const { return this->Lookups[slot].Function; }
  int Index(int slot) const { return this->Lookups[slot].Index; }
  const float* Matrix(int slot) const { return this->Matrices[slot].data(); }
  // Six a cube.
  const std::vector<FaceParameters>& Faces() const { return this->CubeFaces; }

  const std::vector<vtkShadowMapSlot>& GetSlots() const { return this->Slots; }

  // Texels of a view's map. They are square: its shorter side has fewer.
  int WidthOf(const vtkshadows::LightView& view) const;
  int HeightOf(const vtkshadows::LightView& view) const;

private:
  struct Content
  {
    bool Known = false;
    vtkShadowMapView Of;
  };
  // What a shader is written with for a slot.
  struct Lookup
  {
    std::string Function;
    int Index = 0; // of its layer, or of its cube

    bool operator==(const Lookup& other) const
    {
      return this->Function == other.Function && this->Index == other.Index;
    }
  };

  int LayerBefore(std::size_t slot, int face) const;

  int Resolution = 0;
  std::vector<vtkShadowMapSlot> Slots;
  std::vector<vtkShadowMapSlot> SlotsBefore; // as they were placed in the frame before
  std::vector<Content> Drawn;                // one a layer
  std::vector<Lookup> Lookups;               // one a slot
  std::vector<ShaderMatrix> Matrices;
  std::vector<FaceParameters> CubeFaces;
};

#endif
