#include "vtkShadowTexturePass.h"

#include "ShadowReach.h"
#include "vtkShadowChecks.h"
#include "vtkShadowDrawScope.h"
#include "vtkShadowHiddenFaces.h"
#include "vtkShadowMapViews.h"
#include "vtkShadowMatrix.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowPass.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowTexturePassEach.h"
#include "vtkShadowTexturePassLookup.h"
#include "vtkShadowedShadingPass.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkObjectFactory.h"
#include "vtkProp3D.h"
#include "vtkShaderProgram.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <unordered_map>
#include <unordered_set>

vtkStandardNewMacro(vtkShadowTexturePass);

namespace
{

using vtkshadows::BoxCorners;
using vtkshadows::LightKind;
using vtkshadows::LightView;
using ShaderMatrix = vtkShadowMapViews::ShaderMatrix;

constexpr double HardMarginTexels = 2.0;

// Smaller copies of a texture smear it over its own rim: a soft light's keeps this share of its
// texels free around it, and as many copies as smear no farther. Beside a single caster a penumbra
// is a larger part of the texture.
constexpr double SoftMarginShare = 1.0 / 8.0, SoftMarginShareOfOne = 1.0 / 4.0;

// Places of the light's disc that are read, for the casters' depth and for its coverage.
constexpr int Searches = 16;
constexpr int Samples = 32;

// Uniforms that are left to VTK's own shaders and to other techniques, in floats; and what a
// texture of its own needs of a prop's shader: a matrix, a layer and a width.
constexpr int UniformsOfOthers = 512;
constexpr int UniformsOfTexture = 18;

// No position: lit, in either lookup.
constexpr ShaderMatrix Nowhere = {};
constexpr ShaderMatrix Unchanged = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };

// The next power of two: what a shader is written with changes seldom.
std::size_t RoundedUp(std::size_t count)
{
  std::size_t size = 1;
  while (size < count)
  {
    size *= 2;
  }
  return size;
}

std::string Define(const char* name, std::size_t value)
{
  return std::string("#define SHADOW_TEXTURE_") + name + " " + std::to_string(value) + "\n";
}

// How far before the light all of a prop's bounds lie.
double DepthOf(const vtkshadows::ShadowLight& light, const vtkShadowScene::Prop& prop)
{
  double depth = 0.0;
  for (const vtkShadowScene::Piece& piece : prop.Pieces)
  {
    for (const glm::dvec3& corner : piece.CornersWC)
    {
      const glm::dvec3 from = corner - light.position;
      depth = std::max(depth,
        light.kind == LightKind::Point ? glm::length(from) : glm::dot(light.direction, from));
    }
  }
  return depth;
}

bool IsToldToCast(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(vtkShadowPass::CASTS_SHADOWS()) &&
    keys->Get(vtkShadowPass::CASTS_SHADOWS()) != 0;
}

// The plane n.x = d of what is flat, as (n, d), n of length 1; n = 0 if it is not. The scene knows
// that of plain meshes; of others (composite ones, as ParaView's are) flat bounds tell it.
glm::dvec4 PlaneOf(const vtkShadowScene::Piece& piece)
{
  const BoxCorners& box = piece.CornersWC;
  const glm::dvec3 axes[3] = { box[1] - box[0], box[2] - box[0], box[4] - box[0] };
  glm::dvec4 plane = piece.PlaneWC;
  for (int axis = 0; axis < 3 && glm::dvec3(plane) == glm::dvec3(0.0); ++axis)
  {
    if (glm::length(axes[axis]) <= std::ldexp(piece.VertexReach, -24))
    {
      const glm::dvec3 normal = glm::cross(axes[(axis + 1) % 3], axes[(axis + 2) % 3]);
      plane = glm::dvec4(normal, glm::dot(normal, box[0]));
    }
  }
  const double length = glm::length(glm::dvec3(plane));
  return length > 0.0 ? plane / length : glm::dvec4(0.0);
}

// What is flat and has the middle of all else on its lit side: a floor on which things stand, or in
// which they are sunk a bit.
bool IsGround(const vtkShadowScene& scene, const vtkshadows::ShadowLight& light,
  const vtkShadowScene::Prop& prop)
{
  const glm::dvec4 lightWC = vtkshadows::HomogeneousLight(light);
  for (const vtkShadowScene::Piece& flat : prop.Pieces)
  {
    const glm::dvec4 planeWC = PlaneOf(flat);
    const glm::dvec3 normal(planeWC);
    const double lit = glm::dot(normal, glm::dvec3(lightWC)) - planeWC.w * lightWC.w;
    if (lit == 0.0) // or no plane
    {
      return false;
    }
    for (const vtkShadowScene::Prop& other : scene.GetProps())
    {
      if (other.Source == prop.Source || (!other.Casts && !other.Receives))
      {
        continue;
      }
      for (const vtkShadowScene::Piece& piece : other.Pieces)
      {
        const glm::dvec3 middle = 0.5 * (piece.CornersWC[0] + piece.CornersWC[7]);
        const double height = glm::dot(normal, middle) - planeWC.w;
        const double rounding = std::ldexp(flat.VertexReach + piece.VertexReach, -20);
        if ((lit > 0.0 ? height : -height) < -rounding)
        {
          return false;
        }
      }
    }
  }
  return true;
}

// How wide the light's disc is seen through a caster, in texels per depth between it and a
// receiver. A perspective map's depths are linear in the inverse of the distance, and so is that.
double WidthPerDepth(const vtkshadows::ShadowLight& light, const LightView& view, int width)
{
  const double step = view.parallel ? view.clipFromView[2][2] : view.clipFromView[3][2];
  return 2.0 * light.radius * width * view.clipFromView[0][0] / std::abs(step);
}

// The bounds of casters: those of a single piece as they lie, else along the world's axes.
BoxCorners BoundsOf(const vtkShadowScene& scene, const std::vector<std::size_t>& casters)
{
  vtkshadows::Box bounds;
  std::size_t pieces = 0;
  for (const std::size_t i : casters)
  {
    for (const vtkShadowScene::Piece& piece : scene.GetProps()[i].Pieces)
    {
      bounds.Add(piece.CornersWC);
      ++pieces;
    }
  }
  return pieces == 1 ? scene.GetProps()[casters.front()].Pieces.front().CornersWC
                     : bounds.Corners();
}

// A texture as it is looked up in this frame.
struct Texture
{
  std::vector<glm::dvec4> SidesWC; // see vtkshadows::SidesTowardLight
  glm::dmat4 FromView{ 0.0 }; // from the eye's view coordinates to texels and depth, homogeneous
  int Layer = 0;
  double Size[2] = { 0.0, 0.0 }; // texels
  double WidthPerDepth = 0.0;
  bool Parallel = true;
};

// Whether any of a box can lie behind the near side of the texture's casters and within its
// frustum, or within half the width of the light's disc of it.
bool Reaches(const Texture& texture, const glm::dmat4& viewFromWorld, const BoxCorners& box)
{
  for (const glm::dvec4& side : texture.SidesWC)
  {
    if (std::all_of(box.begin(), box.end(),
          [&side](const glm::dvec3& p) { return glm::dot(glm::dvec3(side), p) > side.w; }))
    {
      return false;
    }
  }
  std::array<glm::dvec4, 8> corners;
  double deepest = 1.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    corners[i] = texture.FromView * (viewFromWorld * glm::dvec4(box[i], 1.0));
    deepest = std::max(deepest, texture.Parallel ? corners[i].z : 1.0);
  }
  if (!texture.Parallel)
  {
    // An infinite distance has the depth that z and w have along the axis.
    const glm::dvec4 z = glm::row(texture.FromView, 2), w = glm::row(texture.FromView, 3);
    deepest = glm::dot(glm::dvec3(z), glm::dvec3(w)) / glm::dot(glm::dvec3(w), glm::dvec3(w));
  }
  const double around = 0.5 * texture.WidthPerDepth * deepest;
  const auto all = [&corners](const auto& isOut)
  { return std::all_of(corners.begin(), corners.end(), isOut); };
  return !all([](const glm::dvec4& q) { return q.z <= 0.0; }) &&
    !all([](const glm::dvec4& q) { return q.w <= 0.0; }) &&
    !all([&](const glm::dvec4& q) { return q.x < -around * q.w; }) &&
    !all([&](const glm::dvec4& q) { return q.y < -around * q.w; }) &&
    !all([&](const glm::dvec4& q) { return q.x > (texture.Size[0] + around) * q.w; }) &&
    !all([&](const glm::dvec4& q) { return q.y > (texture.Size[1] + around) * q.w; });
}

}

//------------------------------------------------------------------------------
class vtkShadowTexturePass::Internals
{
public:
  // The textures that may reach a prop, by slot.
  using Reach = std::vector<std::vector<std::size_t>>;

  vtkShadowTextureArray Maps;
  vtkShadowTextureArray Depths; // of the casters, while a texture is drawn
  vtkShadowHiddenFaces HiddenFaces;

  // What this frame's shaders are written with.
  struct Shape
  {
    bool Soft = false;
    bool PerCaster = false;
    std::size_t Layers = 1;
    std::size_t Most = 1; // textures of a prop
    bool operator==(const Shape& other) const
    {
      return this->Soft == other.Soft && this->PerCaster == other.PerCaster &&
        this->Layers == other.Layers && this->Most == other.Most;
    }
  };
  Shape Now, Before;
  std::vector<Texture> Textures;
  std::vector<ShaderMatrix> Matrices;               // of the textures
  std::vector<float> Widths;                        // by layer
  std::unordered_map<const void*, Reach> Reached;   // leaves, tops, and their keys
  std::unordered_set<const void*> Told, ToldBefore; // those that any texture reaches
  vtkTimeStamp Stamp;
  bool Drew = false;
  bool WasInVain = false; // the frame before had casters and nothing that could receive

  const Reach* ReachOf(vtkProp* prop) const;
  std::size_t UpdateReach(const vtkShadowFrame& frame, const std::vector<int>& lights,
    const std::vector<vtkShadowMapSlot>& slots, const vtkShadowMapRoles& roles);
};

//------------------------------------------------------------------------------
// A copy that a mapper made of its actor for a block has the actor's keys.
const vtkShadowTexturePass::Internals::Reach* vtkShadowTexturePass::Internals::ReachOf(
  vtkProp* prop) const
{
  auto found = this->Reached.find(prop);
  if (found == this->Reached.end() && prop->GetPropertyKeys())
  {
    found = this->Reached.find(prop->GetPropertyKeys());
  }
  return found == this->Reached.end() ? nullptr : &found->second;
}

//------------------------------------------------------------------------------
// Returns the most textures that reach one prop.
std::size_t vtkShadowTexturePass::Internals::UpdateReach(const vtkShadowFrame& frame,
  const std::vector<int>& lights, const std::vector<vtkShadowMapSlot>& slots,
  const vtkShadowMapRoles& roles)
{
  const vtkShadowScene& scene = *frame.Scene;
  this->Reached.clear();
  this->Told.clear();
  std::size_t most = 0;
  std::vector<std::unordered_set<const vtkProp*>> ownersOfSlot, ownersOfTexture;
  for (const vtkShadowMapSlot& slot : slots)
  {
    ownersOfSlot.push_back(vtkShadowOwnersOf(scene, slot.CasterProps));
    for (const vtkShadowMapView& view : slot.Views)
    {
      ownersOfTexture.push_back(vtkShadowOwnersOf(scene, view.Casters));
    }
  }
  for (const vtkShadowScene::Prop& prop : scene.GetProps())
  {
    Reach reach(slots.size());
    std::size_t texture = 0, count = 0;
    for (std::size_t slot = 0; slot < slots.size(); ++slot)
    {
      const bool receives = roles.Receives(scene.GetLights()[lights[slot]], prop);
      for (std::size_t i = 0; i < slots[slot].Views.size(); ++i, ++texture)
      {
        const auto& owners = roles.MapPerCaster ? ownersOfTexture[texture] : ownersOfSlot[slot];
        if (receives && owners.count(prop.Source) == 0 &&
          std::any_of(prop.Pieces.begin(), prop.Pieces.end(),
            [&](const vtkShadowScene::Piece& piece)
            { return Reaches(this->Textures[texture], frame.ViewFromWorld, piece.CornersWC); }))
        {
          reach[slot].push_back(texture);
          ++count;
        }
      }
    }
    most = std::max(most, count);
    std::vector<const void*> names = { prop.Source, prop.Source->GetPropertyKeys() };
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      names.push_back(piece.Prop);
      names.push_back(piece.Prop->GetPropertyKeys());
    }
    for (const void* name : names)
    {
      this->Reached[name] = reach;
      if (count > 0)
      {
        this->Told.insert(name);
      }
    }
  }
  return most;
}

//------------------------------------------------------------------------------
vtkShadowTexturePass::vtkShadowTexturePass()
  : Internal(new Internals)
{
}

vtkShadowTexturePass::~vtkShadowTexturePass() = default;

//------------------------------------------------------------------------------
void vtkShadowTexturePass::SetCasterSelection(int selection)
{
  if (!vtkShadowRefusesChoice(this, "CasterSelection", "vtkShadowTexturePass::CasterSelectionType",
        selection, BY_NEAR_PLANE + 1, this->CasterSelection) &&
    selection != this->CasterSelection)
  {
    this->CasterSelection = selection;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkShadowTexturePass::SetNearPlane(double distance)
{
  if (!std::isfinite(distance) || distance <= 0.0)
  {
    vtkErrorMacro(
      "NearPlane " << distance
                   << " is no distance from a light: give a finite one above 0. It stays "
                   << this->NearPlane << ".");
    return;
  }
  if (distance != this->NearPlane)
  {
    this->NearPlane = distance;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkShadowTexturePass::GetLimits()
{
  return "Nothing shadows itself. With one texture for all casters of a light, casters take no "
         "shadow "
         "from it: let what shall receive (a terrain) not cast (CASTS_SHADOWS 0), or use a texture "
         "for each caster. An edge is as sharp as the texels; a caster closer to its receiver than "
         "half a texel or 1/65536 of the casters' depth throws no shadow there.";
}

//------------------------------------------------------------------------------
double vtkShadowTexturePass::GetMarginTexels() const
{
  const Internals& my = *this->Internal;
  if (!my.Now.Soft)
  {
    return HardMarginTexels;
  }
  const int side = this->WithinDriver("Resolution", this->Resolution);
  return std::max(
    HardMarginTexels, side * (my.Now.PerCaster ? SoftMarginShareOfOne : SoftMarginShare));
}

//------------------------------------------------------------------------------
vtkShadowMapRoles vtkShadowTexturePass::GetRoles(const vtkShadowFrame& frame) const
{
  vtkShadowMapRoles roles;
  roles.SelfShadows = false;
  roles.MayCascade = false;
  roles.MapPerCaster = this->Internal->Now.PerCaster;
  roles.DifferByLight = true;
  const vtkShadowScene* scene = frame.Scene;
  if (this->CasterSelection == BY_NEAR_PLANE)
  {
    const auto isBefore = [this](
                            const vtkShadowScene::Light& light, const vtkShadowScene::Prop& prop)
    { return DepthOf(light.Ray, prop) <= this->NearPlane; };
    roles.Casts = [isBefore](const vtkShadowScene::Light& light, const vtkShadowScene::Prop& prop)
    { return prop.Casts && isBefore(light, prop); };
    roles.Receives = [isBefore](
                       const vtkShadowScene::Light& light, const vtkShadowScene::Prop& prop)
    { return prop.Receives && !isBefore(light, prop); };
  }
  else
  {
    roles.Casts = [scene](const vtkShadowScene::Light& light, const vtkShadowScene::Prop& prop)
    { return prop.Casts && (IsToldToCast(prop.Source) || !IsGround(*scene, light.Ray, prop)); };
  }
  const glm::dmat4 clipFromWorld = frame.ClipFromView * frame.ViewFromWorld;
  vtkshadows::Box receivers;
  for (const BoxCorners& corners : vtkShadowReceiverCorners(*scene))
  {
    receivers.Add(corners);
  }
  roles.Needs = [=](const vtkShadowMapSlot& slot, const vtkShadowMapView& view)
  {
    const glm::dvec4 lightWC = vtkshadows::HomogeneousLight(slot.Light);
    const auto isSeen = [&](const vtkShadowScene::Piece& piece)
    {
      return vtkshadows::SoftShadowMayBeSeen(
        clipFromWorld, lightWC, slot.Light.radius, piece.CornersWC, receivers);
    };
    return std::any_of(view.Casters.begin(), view.Casters.end(),
      [&](std::size_t i)
      {
        const std::vector<vtkShadowScene::Piece>& pieces = scene->GetProps()[i].Pieces;
        return std::any_of(pieces.begin(), pieces.end(), isSeen);
      });
  };
  return roles;
}

//------------------------------------------------------------------------------
bool vtkShadowTexturePass::UpdateVisibility(
  const vtkShadowFrame& frame, const std::vector<int>& lights)
{
  Internals& my = *this->Internal;
  const vtkShadowScene& scene = *frame.Scene;
  my.Now.Soft = std::any_of(lights.begin(), lights.end(),
    [&scene](int light) { return scene.GetLights()[light].Ray.radius > 0.0; });

  // Any prop may be reached by every caster's texture of every light.
  GLint uniforms = 0;
  glGetIntegerv(GL_MAX_FRAGMENT_UNIFORM_COMPONENTS, &uniforms);
  const std::size_t room =
    static_cast<std::size_t>(std::max((uniforms - UniformsOfOthers) / UniformsOfTexture, 1));
  const std::size_t wanted = lights.size() *
    static_cast<std::size_t>(std::count_if(scene.GetProps().begin(), scene.GetProps().end(),
      [](const vtkShadowScene::Prop& prop) { return prop.Casts; }));
  my.Now.PerCaster = this->TexturePerCaster && wanted <= room;
  this->WarnOnce(&my.Now,
    this->TexturePerCaster && !my.Now.PerCaster
      ? "TexturePerCaster asks for up to " + std::to_string(wanted) +
        " textures, of every light and caster, and this driver's shaders hold " +
        std::to_string(room) +
        ": one texture serves all casters of a light. Let fewer props cast (CASTS_SHADOWS 0)."
      : std::string());

  my.Drew = false;
  if (!this->Superclass::UpdateVisibility(frame, lights))
  {
    return false;
  }
  if (my.Drew && my.Now.Soft)
  {
    my.Maps.MakeLevels(this->LevelsOfTexture());
  }

  const vtkShadowMapViews& views = this->GetViews();
  const vtkShadowMapRoles roles = this->GetRoles(frame);
  my.Textures.clear();
  my.Matrices.clear();
  my.Widths.clear();
  for (const vtkShadowMapSlot& slot : views.GetSlots())
  {
    for (const vtkShadowMapView& view : slot.Views)
    {
      Texture texture;
      texture.FromView = views.MapFromView(view.View, frame.ViewFromWorld);
      texture.Layer = view.Layer;
      texture.Size[0] = views.WidthOf(view.View);
      texture.Size[1] = views.HeightOf(view.View);
      texture.Parallel = view.View.parallel;
      texture.WidthPerDepth = WidthPerDepth(slot.Light, view.View, views.WidthOf(view.View));
      my.Widths.resize(std::max(my.Widths.size(), static_cast<std::size_t>(view.Layer) + 1), 0.0f);
      my.Widths[static_cast<std::size_t>(view.Layer)] = static_cast<float>(texture.WidthPerDepth);
      texture.SidesWC = vtkshadows::SidesTowardLight(
        vtkshadows::HomogeneousLight(slot.Light), slot.Light.radius, BoundsOf(scene, view.Casters));
      glm::dmat4 lookup =
        views.ReceiverMap(slot, view.View, frame.ViewFromWorld, this->GetRiseTexels());
      // One function looks up in all of them: a parallel one as if it were perspective.
      lookup[3][2] -= texture.Parallel ? 1.0 : 0.0;
      my.Matrices.push_back(vtkShadowMatrix::ToFloats(lookup));
      my.Textures.push_back(texture);
    }
  }
  const std::size_t most = my.UpdateReach(frame, lights, views.GetSlots(), roles);
  this->NumberOfTextures = static_cast<int>(my.Textures.size());
  this->TellWhatReceives(frame, lights, roles);

  my.Now.Layers = std::max(my.Now.Layers, RoundedUp(my.Widths.size()));
  my.Now.Most = my.Now.PerCaster ? std::max(my.Now.Most, RoundedUp(most)) : 1;
  my.Widths.resize(my.Now.Layers, 0.0f);
  if (!(my.Now == my.Before) || my.Told != my.ToldBefore)
  {
    my.Before = my.Now;
    my.ToldBefore = my.Told;
    my.Stamp.Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
// Counts them, and warns of a light whose casters are all that could receive.
void vtkShadowTexturePass::TellWhatReceives(
  const vtkShadowFrame& frame, const std::vector<int>& lights, const vtkShadowMapRoles& roles)
{
  Internals& my = *this->Internal;
  const vtkShadowScene& scene = *frame.Scene;
  const std::vector<vtkShadowMapSlot>& slots = this->GetViews().GetSlots();
  this->NumberOfReachedProps = 0;
  bool anyInVain = false;
  for (std::size_t slot = 0; slot < slots.size(); ++slot)
  {
    const auto owners = vtkShadowOwnersOf(scene, slots[slot].CasterProps);
    bool anyReceives = false;
    for (const vtkShadowScene::Prop& prop : scene.GetProps())
    {
      anyReceives = anyReceives ||
        (roles.Receives(scene.GetLights()[lights[slot]], prop) &&
          (owners.count(prop.Source) == 0 ||
            (roles.MapPerCaster && slots[slot].CasterProps.size() > 1)));
      this->NumberOfReachedProps += my.ReachOf(prop.Source)->at(slot).empty() ? 0 : 1;
    }
    anyInVain = anyInVain || (!slots[slot].CasterProps.empty() && !anyReceives);
  }
  // Not of a single frame: a script may hide what receives for one.
  const bool isLasting = anyInVain && my.WasInVain;
  my.WasInVain = anyInVain;
  std::ostringstream message;
  if (isLasting && this->CasterSelection == BY_NEAR_PLANE)
  {
    message << "All that could receive lies before the near plane, " << this->NearPlane
            << " before a light: nothing is darkened. Set NearPlane between casters and receivers.";
  }
  else if (isLasting)
  {
    message
      << "All that receives casts, too, and a caster takes no shadow from a texture that it is "
         "in: nothing is darkened. Let what shall receive (a terrain) not cast (CASTS_SHADOWS "
         "0), or set TexturePerCaster.";
  }
  this->WarnOnce(&my.Reached, message.str());
}

//------------------------------------------------------------------------------
// Copies of half, a quarter, ... of a texture's size.
int vtkShadowTexturePass::LevelsOfTexture() const
{
  return std::max(static_cast<int>(std::floor(std::log2(0.5 * this->GetMarginTexels()))), 0);
}

//------------------------------------------------------------------------------
bool vtkShadowTexturePass::ReserveMaps(
  const vtkShadowFrame& frame, int width, int height, int layers)
{
  using Format = vtkShadowTextureArray::Format;
  Internals& my = *this->Internal;
  const bool isNew = my.Maps.Reserve(frame.Window, Format::RG16, width, height, layers);
  if (isNew && my.Maps.Id())
  {
    my.Maps.Smooth();
  }
  my.Depths.Reserve(frame.Window, Format::Depth32F, width, height, 1);
  if (!my.Depths.Id())
  {
    my.Maps.Release();
  }
  return isNew;
}

//------------------------------------------------------------------------------
void vtkShadowTexturePass::BeginMaps(const vtkShadowFrame& frame)
{
  this->Internal->HiddenFaces.BeginFrame(frame.Scene->GetProps());
}

//------------------------------------------------------------------------------
void vtkShadowTexturePass::DrawMap(const vtkShadowFrame& frame, const vtkShadowMapSlot& slot,
  const vtkShadowMapView& view, int width, int height)
{
  Internals& my = *this->Internal;
  vtkShadowDrawScope target(frame.Window, my.Depths, 0, &my.Maps, view.Layer);
  // All of the layer is cleared, and its outermost texels stay so: what lies off the texture is
  // lit.
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  target.Clear(nothing);
  target.Confine(width, height, 1);
  frame.Shading->DrawCasters(frame, view.Casters, view.View,
    my.HiddenFaces.CulledOf(
      frame.Scene->GetProps(), view.Casters, vtkshadows::HomogeneousLight(slot.Light)));
  my.Drew = true;
}

//------------------------------------------------------------------------------
std::string vtkShadowTexturePass::GetCompareDeclarations() const
{
  const Internals& my = *this->Internal;
  std::string soft;
  if (my.Now.Soft)
  {
    soft = "#define SHADOW_TEXTURE_SOFT\n" +
      Define("LEVELS", static_cast<std::size_t>(this->LevelsOfTexture())) +
      Define("SEARCHES", Searches) + Define("SAMPLES", Samples);
  }
  return Define("LAYERS", my.Now.Layers) + soft + vtkShadowTexturePassLookup;
}

std::string vtkShadowTexturePass::GetLookupDeclarations() const
{
  const Internals& my = *this->Internal;
  return this->Superclass::GetLookupDeclarations() +
    (my.Now.PerCaster ? Define("SLOTS", static_cast<std::size_t>(this->GetNumberOfSlots())) +
          Define("MOST", my.Now.Most) + vtkShadowTexturePassEach
                      : std::string());
}

//------------------------------------------------------------------------------
std::string vtkShadowTexturePass::GetLookupFunction(int slot, vtkProp* prop) const
{
  return this->Internal->Now.PerCaster ? "shadowTextureEach"
                                       : this->Superclass::GetLookupFunction(slot, prop);
}

int vtkShadowTexturePass::GetLookupIndex(int slot) const
{
  return this->Internal->Now.PerCaster ? slot : this->Superclass::GetLookupIndex(slot);
}

const float* vtkShadowTexturePass::GetLookupMatrix(int slot, vtkProp* prop) const
{
  const Internals::Reach* reach = this->Internal->ReachOf(prop);
  if (!reach || reach->at(static_cast<std::size_t>(slot)).empty())
  {
    return this->GetLitMatrix();
  }
  return this->Internal->Now.PerCaster ? Unchanged.data()
                                       : this->Superclass::GetLookupMatrix(slot, prop);
}

const float* vtkShadowTexturePass::GetLitMatrix() const
{
  return this->Internal->Now.PerCaster ? Nowhere.data() : this->Superclass::GetLitMatrix();
}

//------------------------------------------------------------------------------
bool vtkShadowTexturePass::HasVisibilityOf(vtkProp* prop) const
{
  const Internals::Reach* reach = this->Internal->ReachOf(prop);
  return reach &&
    std::any_of(
      reach->begin(), reach->end(), [](const auto& textures) { return !textures.empty(); });
}

vtkMTimeType vtkShadowTexturePass::GetReceiverStamp() const
{
  return std::max(this->Superclass::GetReceiverStamp(), this->Internal->Stamp.GetMTime());
}

//------------------------------------------------------------------------------
void vtkShadowTexturePass::SetLookupParameters(vtkShaderProgram* program, vtkProp* prop)
{
  const Internals& my = *this->Internal;
  this->Superclass::SetLookupParameters(program, prop);
  if (my.Now.Soft)
  {
    program->SetUniform1fv(
      "shadowTextureWidths", static_cast<int>(my.Widths.size()), my.Widths.data());
  }
  if (!my.Now.PerCaster)
  {
    return;
  }
  const Internals::Reach* reach = my.ReachOf(prop);
  std::vector<int> first = { 0 }, layers;
  std::vector<float> matrices;
  for (int slot = 0; slot < this->GetNumberOfSlots(); ++slot)
  {
    if (reach)
    {
      for (const std::size_t i : reach->at(static_cast<std::size_t>(slot)))
      {
        layers.push_back(my.Textures[i].Layer);
        matrices.insert(matrices.end(), my.Matrices[i].begin(), my.Matrices[i].end());
      }
    }
    first.push_back(static_cast<int>(layers.size()));
  }
  program->SetUniform1iv("shadowTextureFirst", static_cast<int>(first.size()), first.data());
  if (!layers.empty())
  {
    const int count = static_cast<int>(layers.size());
    program->SetUniform1iv("shadowTextureLayers", count, layers.data());
    program->SetUniformMatrix4x4v("shadowTextureFromView", count, matrices.data());
  }
}

//------------------------------------------------------------------------------
vtkShadowTextureArray* vtkShadowTexturePass::GetTextures()
{
  return &this->Internal->Maps;
}

//------------------------------------------------------------------------------
vtkIdType vtkShadowTexturePass::GetTextureMemory() const
{
  return static_cast<vtkIdType>(this->Internal->Maps.Bytes() + this->Internal->Depths.Bytes());
}

//------------------------------------------------------------------------------
void vtkShadowTexturePass::ReleaseGraphicsResources(vtkWindow* w)
{
  this->Internal->Maps.Release();
  this->Internal->Depths.Release();
  this->Superclass::ReleaseGraphicsResources(w);
}

//------------------------------------------------------------------------------
void vtkShadowTexturePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TexturePerCaster: " << this->TexturePerCaster << "\n";
  os << indent << "CasterSelection: " << this->CasterSelection << "\n";
  os << indent << "NearPlane: " << this->NearPlane << "\n";
  os << indent << "NumberOfTextures: " << this->NumberOfTextures << "\n";
  os << indent << "NumberOfReachedProps: " << this->NumberOfReachedProps << "\n";
}
