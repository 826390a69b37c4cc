// The views of the lights of a technique by maps: what each light needs in this frame, in which
// layer of a texture array each map lies and which are stale, and what the lookup is told of them.
#ifndef vtkShadowMapViews_h
#define vtkShadowMapViews_h

#include "vtkShadowSceneData.h"

#include "vtkTimeStamp.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

// One view of a light, in this frame, and all that its map is drawn from: equal ones give equal
// maps.
struct vtkShadowMapView
{
  static constexpr int NoLayer = -1;
  static constexpr std::size_t AllCasters = static_cast<std::size_t>(-1);

  vtkshadows::LightView View;
  vtkMTimeType CasterStamp = 0;
  std::vector<std::size_t> Casters; // among the scene's props, ascending
  std::size_t Caster = AllCasters;  // whose own map this is, among the scene's props
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
  std::vector<std::size_t> CasterProps;        // whose they are, among the scene's props, ascending
  std::vector<vtkShadowMapView> Views;
};

// Who casts into the maps of a light and who is looked up in them, and which maps it has.
struct vtkShadowMapRoles
{
  using Says = std::function<bool(const vtkShadowScene::Light&, const vtkShadowScene::Prop&)>;

  Says Casts = [](const vtkShadowScene::Light&, const vtkShadowScene::Prop& prop)
  { return prop.Casts; };
  Says Receives = [](const vtkShadowScene::Light&, const vtkShadowScene::Prop& prop)
  { return prop.Receives; };
  bool DifferByLight = false;
  bool SelfShadows = true;   // what casts into a map is looked up in it, too
  bool MapPerCaster = false; // each prop that casts has maps of its own, fitted to it
  // Whether this frame needs a map; none: it needs all.
  std::function<bool(const vtkShadowMapSlot&, const vtkShadowMapView&)> Needs;
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
  void Fit(const vtkShadowFrame& frame, const std::vector<int>& lights, int resolution,
    double margin, const vtkShadowMapRoles& roles = {});
  int NumberOfViews() const;

  // Gives each view one of `layers` layers: one that holds its map already, if there is.
  void Place(int layers);
  // What the layers held is lost.
  void ForgetLayers() { this->Drawn.clear(); }

  // The maps of a slot's placed views are drawn again, whatever they are of.
  void MarkStale(std::size_t slot);

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
  // needed for it. `prefix`: of the lookup's functions.
  bool UpdateLookups(const std::string& prefix, const glm::dmat4& viewFromWorld);
  const std::string& Function(int slot) const { return this->Lookups[slot].Function; }
  int Index(int slot) const { return this->Lookups[slot].Index; }
  const float* Matrix(int slot) const { return this->Matrices[slot].data(); }
  // Six a cube.
  const std::vector<FaceParameters>& Faces() const { return this->CubeFaces; }

  const std::vector<vtkShadowMapSlot>& GetSlots() const { return this->Slots; }

  // From the eye's view coordinates to the texels of a map, and depth there less the bound of its
  // rounding; homogeneous.
  glm::dmat4 MapFromView(const vtkShadowMapSlot& slot, const vtkShadowMapView& view,
    const glm::dmat4& viewFromWorld) const;

  // Texels of a view's map. They are square: its shorter side has fewer.
  int WidthOf(const vtkshadows::LightView& view) const;
  int HeightOf(const vtkshadows::LightView& view) const;
  // From a view's coordinates to its map: texels, and depth from 0 to 1.
  glm::dmat4 MapOf(const vtkshadows::LightView& view) const;

private:
  struct Content
  {
    bool Known = false;
    vtkShadowMapView Of;
  };
  // What a prop casts, and a stamp that grows with it.
  struct CasterState
  {
    const vtkProp* Source = nullptr;
    std::vector<std::uint64_t> Signature;
    vtkTimeStamp Stamp;
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

  int LayerBefore(std::size_t slot, const vtkShadowMapView& like) const;
  void StampCasters(const vtkShadowScene& scene);

  int Resolution = 0;
  std::vector<vtkShadowMapSlot> Slots;
  std::vector<vtkShadowMapSlot> SlotsBefore; // as they were placed in the frame before
  std::vector<Content> Drawn;                // one a layer
  std::vector<CasterState> CasterStates;     // one a prop, for maps of its own
  std::vector<Lookup> Lookups;               // one a slot
  std::vector<ShaderMatrix> Matrices;
  std::vector<FaceParameters> CubeFaces;
};

#endif
