// The views of the lights of a technique by maps: what each light needs in this frame, in which
// layer of a texture array each map lies and which are stale, and what the lookup is told of them.
// How they are fitted to the scene is in a file of its own, vtkShadowMapViewsFit.cxx.
#ifndef vtkShadowMapViews_h
#define vtkShadowMapViews_h

#include "LightCascades.h"
#include "ShadowReach.h"
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
  static constexpr int NoCascade = -1;
  static constexpr std::size_t AllCasters = static_cast<std::size_t>(-1);

  vtkshadows::LightView View;
  vtkMTimeType CasterStamp = 0;
  std::vector<std::size_t> Casters; // among the scene's props, ascending
  std::size_t Caster = AllCasters;  // whose own map this is, among the scene's props
  int Face = vtkshadows::NoFace;    // of a cube
  int Cascade = NoCascade;          // among those of its slot
  int Layer = NoLayer;

  bool DrawsAs(const vtkShadowMapView& other) const
  {
    return this->CasterStamp == other.CasterStamp &&
      this->View.viewFromWorld == other.View.viewFromWorld &&
      this->View.clipFromView == other.View.clipFromView &&
      this->View.fillsMap == other.View.fillsMap && this->Casters == other.Casters;
  }
};

// What a slot's light needs of this frame.
struct vtkShadowMapSlot
{
  vtkshadows::ShadowLight Light;
  bool IsCube = false;
  glm::dmat4 CubeFromWorld{ 1.0 };
  // None of its shadows can be seen: it has no views.
  bool IsSkipped = false;
  int FacesOutOfSight = 0; // of the cube, that have no view because nothing seen looks into them
  bool HasCascades = false;
  vtkshadows::LightCascades Cascades;
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
  bool MayCascade = true;    // directional lights may have cascades
  // Whether this frame needs a map; none: it needs all.
  std::function<bool(const vtkShadowMapSlot&, const vtkShadowMapView&)> Needs;
};

// What views are fitted to, beside the scene.
struct vtkShadowMapFit
{
  int Resolution = 1;      // texels on the longer side of a map
  double MarginTexels = 0; // that stay free on every side
  vtkshadows::CascadeSettings Cascades;
  bool ConfineToView = false;
  vtkshadows::CascadeEye Eye;
};

class vtkShadowMapViews
{
public:
  // A matrix, and a row of numbers of a cube's face or of a cascade, as GLSL takes them.
  using ShaderMatrix = std::array<float, 16>;
  using Row = std::array<float, 4>;

  // Takes every point nearer to the light than any caster.
  static const ShaderMatrix LitEverywhere;
  // In a perspective map, how much of 1 is taken off a receiver's depth for what the depths there
  // and the stored ones are rounded by.
  static const double PerspectiveRounding;

  void Fit(const vtkShadowFrame& frame, const std::vector<int>& lights, const vtkShadowMapFit& fit,
    const vtkShadowMapRoles& roles = {});
  int NumberOfViews() const;
  // Room for their maps, and for those of faces that the eye may turn to.
  int NumberOfLayers() const;
  int NumberOfSkippedLights() const;
  // Casters that a view does not draw, summed over the views.
  int NumberOfCastersLeftOut() const;

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
  // needed for it. `prefix`: of the lookup's functions; `riseTexels`: see DepthSlack.
  bool UpdateLookups(const std::string& prefix, const glm::dmat4& viewFromWorld, double riseTexels);
  const std::string& Function(int slot) const { return this->Lookups[slot].Function; }
  int Index(int slot) const { return this->Lookups[slot].Index; }
  const float* Matrix(int slot) const { return this->Matrices[slot].data(); }
  // Six a cube.
  const std::vector<Row>& Faces() const { return this->CubeFaces; }
  // Two a cascade, as many for each cascaded light as there may be; and of reaches, one or two a
  // light, with how fine the grain is: see vtkMapShadowPassLookup.glsl.
  const std::vector<Row>& Cascades() const { return this->CascadeRows; }
  const std::vector<Row>& Reaches() const { return this->CascadeReaches; }
  std::size_t ReachesPerLight() const { return this->FittedTo.Cascades.count > 4 ? 2 : 1; }
  std::size_t NumberOfCascadedLights() const
  {
    return this->CascadeReaches.size() / this->ReachesPerLight();
  }

  const std::vector<vtkShadowMapSlot>& GetSlots() const { return this->Slots; }

  const vtkShadowMapFit& GetFit() const { return this->FittedTo; }

  // What can cast on any of the receivers, and which of the scene's props each is of.
  static std::vector<vtkshadows::BoxCorners> CastersOf(const vtkShadowScene& scene,
    const vtkShadowScene::Light& light, const vtkShadowMapRoles& roles,
    const std::vector<vtkshadows::BoxCorners>& receivers, std::vector<std::size_t>& owners);

  // What a receiver's depth is less by in a map of `width` texels, over w: the depth of
  // `riseTexels` texels' width and, of a parallel map, a bound of the depth's rounding. `map`: to
  // it from the eye's view coordinates; `farthest`: how far from the eye a receiver may lie, as
  // FarthestIn finds it. In a perspective map the lookup takes off what the rounding of w makes:
  // see ReceiverMap.
  static double DepthSlack(const glm::dmat4& map, const vtkshadows::LightView& view, int width,
    double riseTexels, double farthest);
  // How large the sum that gives each coordinate of a space may grow on its way, in its units: what
  // positions there are rounded in proportion to.
  static double RoundingReach(const glm::dmat4& spaceFromView, double farthest);
  // How far from the origin of a space the casters reach.
  static double FarthestIn(
    const glm::dmat4& spaceFromWorld, const std::vector<vtkshadows::BoxCorners>& castersWC);

  // From the eye's view coordinates to the texels of a map, and depth there; homogeneous.
  glm::dmat4 MapFromView(const vtkshadows::LightView& view, const glm::dmat4& viewFromWorld) const;
  // The same for the lookup of receivers of what a slot's casters throw: the depth less its slack;
  // of a perspective map less w, too, and all over the reach of the rounding of w. Near the light a
  // depth is 1 less a small share of w, and z and w apart have roundings as of an eye that may be
  // far away.
  glm::dmat4 ReceiverMap(const vtkShadowMapSlot& slot, const vtkshadows::LightView& view,
    const glm::dmat4& viewFromWorld, double riseTexels) const;
  // From a view's own coordinates.
  glm::dmat4 MapOf(const vtkshadows::LightView& view) const;

  // Texels of a view's map. They are square, and its shorter side has fewer, unless it is filled.
  int WidthOf(const vtkshadows::LightView& view) const;
  int HeightOf(const vtkshadows::LightView& view) const;

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

  vtkShadowMapSlot SlotOf(const vtkShadowFrame& frame, const vtkShadowScene::Light& light,
    const vtkShadowMapRoles& roles, const std::vector<vtkshadows::BoxCorners>& receivers) const;
  void FitCascades(vtkShadowMapSlot& slot, double maximumDistance,
    const std::vector<vtkshadows::BoxCorners>& receivers,
    std::vector<vtkshadows::FittedLightView>& views) const;
  int LayerBefore(std::size_t slot, const vtkShadowMapView& like) const;
  void StampCasters(const vtkShadowScene& scene);
  ShaderMatrix AddCascades(const vtkShadowMapSlot& slot, const glm::dmat4& viewFromWorld,
    double riseTexels, double farthest);

  vtkShadowMapFit FittedTo;
  vtkshadows::Box SeenReceivers; // those within the view's sides
  int CastersInScene = 0;
  std::vector<vtkShadowMapSlot> Slots;
  std::vector<vtkShadowMapSlot> SlotsBefore; // as they were placed in the frame before
  std::vector<Content> Drawn;                // one a layer
  std::vector<CasterState> CasterStates;     // one a prop, for maps of its own
  std::vector<Lookup> Lookups;               // one a slot
  std::vector<ShaderMatrix> Matrices;
  std::vector<Row> CubeFaces;
  std::vector<Row> CascadeRows;
  std::vector<Row> CascadeReaches;
};

#endif
