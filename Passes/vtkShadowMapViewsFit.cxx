#include "vtkShadowMapViews.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace
{

using vtkshadows::BoxCorners;
using vtkshadows::LightKind;
using vtkshadows::LightView;

std::vector<BoxCorners> CornersOf(const vtkShadowScene::Prop& prop)
{
  std::vector<BoxCorners> corners;
  for (const vtkShadowScene::Piece& piece : prop.Pieces)
  {
    corners.push_back(piece.CornersWC);
  }
  return corners;
}

// The bounds of what receives and is not one of `casters`, nor stands one in for it.
std::vector<BoxCorners> ReceiversBut(const vtkShadowScene& scene,
  const vtkShadowScene::Light& light, const vtkShadowMapRoles& roles,
  const std::vector<std::size_t>& casters)
{
  const std::unordered_set<const vtkProp*> owners = vtkShadowOwnersOf(scene, casters);
  std::vector<BoxCorners> receivers;
  for (const vtkShadowScene::Prop& prop : scene.GetProps())
  {
    if (roles.Receives(light, prop) && owners.count(prop.Source) == 0)
    {
      const std::vector<BoxCorners> corners = CornersOf(prop);
      receivers.insert(receivers.end(), corners.begin(), corners.end());
    }
  }
  return receivers;
}

// Adds the views that are fitted to `casters`, of the props `owners`.
void AddViews(vtkShadowMapSlot& slot, const std::vector<vtkshadows::FittedLightView>& views,
  const std::vector<std::size_t>& owners, std::size_t caster, vtkMTimeType stamp)
{
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    vtkShadowMapView placed;
    placed.Caster = caster;
    placed.Face = views[i].face;
    placed.Cascade = slot.HasCascades ? static_cast<int>(i) : vtkShadowMapView::NoCascade;
    placed.View = views[i].view;
    placed.CasterStamp = stamp;
    for (const std::size_t k : views[i].casters)
    {
      placed.Casters.push_back(owners[k]);
    }
    std::vector<std::size_t>& drawn = placed.Casters; // in ascending order
    drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
    if (!drawn.empty())
    {
      slot.Views.push_back(placed);
    }
  }
}

// A receiver is looked up in the one face that it lies in: those of receivers out of sight need no
// map.
void LeaveOutFaces(
  vtkShadowMapSlot& slot, const glm::dmat4& clipFromWorld, const std::vector<BoxCorners>& receivers)
{
  const std::size_t faces = slot.Views.size();
  slot.Views.erase(std::remove_if(slot.Views.begin(), slot.Views.end(),
                     [&](const vtkShadowMapView& view)
                     { return !vtkshadows::FaceMayBeSeen(clipFromWorld, receivers, view.View); }),
    slot.Views.end());
  slot.FacesOutOfSight = static_cast<int>(faces - slot.Views.size());
  slot.IsSkipped = faces > 0 && slot.Views.empty();
}

}

//------------------------------------------------------------------------------
std::vector<BoxCorners> vtkShadowMapViews::CastersOf(const vtkShadowScene& scene,
  const vtkShadowScene::Light& light, const vtkShadowMapRoles& roles,
  const std::vector<BoxCorners>& receivers, std::vector<std::size_t>& owners)
{
  const std::vector<vtkShadowScene::Prop>& props = scene.GetProps();
  const double rounding = vtkShadowReceiverRounding(scene);
  std::vector<BoxCorners> casters;
  for (std::size_t i = 0; i < props.size(); ++i)
  {
    if (!roles.Casts(light, props[i]))
    {
      continue;
    }
    for (const vtkShadowScene::Piece& piece : props[i].Pieces)
    {
      if (!vtkShadowCastsOnNothing(
            piece, light.Ray, receivers, 2.0 * std::max(rounding, piece.Rounding)))
      {
        casters.push_back(piece.CornersWC);
        owners.push_back(i);
      }
    }
  }
  return casters;
}

//------------------------------------------------------------------------------
// Who can cast on any of the receivers, and from where they are seen.
vtkShadowMapSlot vtkShadowMapViews::SlotOf(const vtkShadowFrame& frame,
  const vtkShadowScene::Light& light, const vtkShadowMapRoles& roles,
  const std::vector<BoxCorners>& receivers) const
{
  const vtkShadowScene& scene = *frame.Scene;
  vtkShadowMapSlot slot;
  slot.Light = light.Ray;
  std::vector<std::size_t> owners; // of the casters, among the props
  slot.Casters = CastersOf(scene, light, roles, receivers, owners);
  slot.CasterProps = owners;
  slot.CasterProps.erase(
    std::unique(slot.CasterProps.begin(), slot.CasterProps.end()), slot.CasterProps.end());
  slot.HasCascades = roles.MayCascade && !roles.MapPerCaster &&
    light.Ray.kind == LightKind::Directional && this->FittedTo.Cascades.count > 1;

  const vtkshadows::CascadeEye& eye = this->FittedTo.Eye;
  const glm::dmat4 clipFromWorld = eye.clipFromView * eye.viewFromWorld;
  // A penumbra reaches farther than the shadow from the light's middle.
  const auto isSoftSeen = [&](const BoxCorners& caster)
  {
    return vtkshadows::SoftShadowMayBeSeen(clipFromWorld, vtkshadows::HomogeneousLight(light.Ray),
      light.Ray.radius, caster, this->SeenReceivers);
  };
  slot.IsSkipped = !slot.Casters.empty() &&
    !vtkshadows::LightMayBeSeen(clipFromWorld, this->SeenReceivers, light.Ray, slot.Casters) &&
    (light.Ray.radius == 0.0 || std::none_of(slot.Casters.begin(), slot.Casters.end(), isSoftSeen));
  if (slot.IsSkipped)
  {
    return slot;
  }

  // A map narrower than its margins is all margin.
  const double margin = this->FittedTo.MarginTexels;
  const double share =
    margin / std::max(static_cast<double>(this->FittedTo.Resolution), 4.0 * margin);
  if (roles.MapPerCaster)
  {
    for (const std::size_t i : slot.CasterProps)
    {
      const std::vector<BoxCorners> own = CornersOf(scene.GetProps()[i]);
      const vtkshadows::LightViews fitted =
        vtkshadows::FitLightViews(slot.Light, own, ReceiversBut(scene, light, roles, { i }), share);
      AddViews(slot, fitted.views, std::vector<std::size_t>(own.size(), i), i,
        this->CasterStates[i].Stamp.GetMTime());
    }
  }
  else
  {
    const std::vector<BoxCorners> others =
      roles.SelfShadows ? receivers : ReceiversBut(scene, light, roles, slot.CasterProps);
    vtkshadows::LightViews fitted =
      vtkshadows::FitLightViews(slot.Light, slot.Casters, others, share);
    slot.IsCube = fitted.isCube;
    slot.CubeFromWorld = fitted.cubeFromWorld;
    if (slot.HasCascades && !fitted.views.empty())
    {
      this->FitCascades(slot, light.MaximumDistance, others, fitted.views);
    }
    else if (this->FittedTo.ConfineToView && !fitted.isCube && !fitted.views.empty())
    {
      vtkshadows::FittedLightView& one = fitted.views.front();
      if (vtkshadows::ConfineView(one.view, others, eye, share))
      {
        one.casters = vtkshadows::CastersIn(one.view, slot.Casters);
      }
    }
    AddViews(slot, fitted.views, owners, vtkShadowMapView::AllCasters, scene.GetCasterStamp());
    if (slot.IsCube)
    {
      LeaveOutFaces(slot, clipFromWorld, others);
    }
  }
  if (roles.Needs)
  {
    slot.Views.erase(std::remove_if(slot.Views.begin(), slot.Views.end(),
                       [&](const vtkShadowMapView& view) { return !roles.Needs(slot, view); }),
      slot.Views.end());
  }
  return slot;
}

//------------------------------------------------------------------------------
// In place of the one view of a directional light.
void vtkShadowMapViews::FitCascades(vtkShadowMapSlot& slot, double maximumDistance,
  const std::vector<BoxCorners>& receivers, std::vector<vtkshadows::FittedLightView>& views) const
{
  const vtkShadowMapFit& fit = this->FittedTo;
  const LightView whole = views.front().view;
  const auto before = std::find_if(this->SlotsBefore.begin(), this->SlotsBefore.end(),
    [&whole](const vtkShadowMapSlot& other)
    { return other.Cascades.lightFromWorld == glm::dmat3(whole.viewFromWorld); });
  vtkshadows::CascadeSettings settings = fit.Cascades;
  if (maximumDistance > 0.0)
  {
    settings.farthest = maximumDistance;
  }
  slot.Cascades = vtkshadows::FitLightCascades(slot.Light, whole, slot.Casters, receivers, fit.Eye,
    settings, fit.Resolution, fit.MarginTexels,
    before != this->SlotsBefore.end() ? &before->Cascades : nullptr);
  views.clear();
  for (const vtkshadows::Cascade& cascade : slot.Cascades.cascades)
  {
    views.push_back({ cascade.view, vtkshadows::NoFace, cascade.casters });
  }
}

//------------------------------------------------------------------------------
void vtkShadowMapViews::Fit(const vtkShadowFrame& frame, const std::vector<int>& lights,
  const vtkShadowMapFit& fit, const vtkShadowMapRoles& roles)
{
  this->FittedTo = fit;
  const vtkShadowScene& scene = *frame.Scene;
  if (roles.MapPerCaster)
  {
    this->StampCasters(scene);
  }
  this->CastersInScene = static_cast<int>(std::count_if(scene.GetProps().begin(),
    scene.GetProps().end(), [](const vtkShadowScene::Prop& prop) { return prop.Casts; }));
  this->SlotsBefore = std::move(this->Slots);
  this->Slots.clear();
  std::vector<BoxCorners> receivers;
  for (const int i : lights)
  {
    const vtkShadowScene::Light& light = scene.GetLights()[i];
    if (this->Slots.empty() || roles.DifferByLight)
    {
      receivers = ReceiversBut(scene, light, roles, {});
      this->SeenReceivers = {};
      this->SeenReceivers.Add(
        vtkshadows::SeenCorners(fit.Eye.clipFromView * fit.Eye.viewFromWorld, receivers));
    }
    this->Slots.push_back(this->SlotOf(frame, light, roles, receivers));
  }
}

//------------------------------------------------------------------------------
// A prop that has another place among the others is taken for another.
void vtkShadowMapViews::StampCasters(const vtkShadowScene& scene)
{
  const std::vector<vtkShadowScene::Prop>& props = scene.GetProps();
  this->CasterStates.resize(props.size());
  for (std::size_t i = 0; i < props.size(); ++i)
  {
    CasterState now;
    now.Source = props[i].Source;
    for (const vtkShadowScene::Piece& piece : props[i].Pieces)
    {
      now.Signature.insert(now.Signature.end(), piece.Signature.begin(), piece.Signature.end());
    }
    if (now.Source != this->CasterStates[i].Source ||
      now.Signature != this->CasterStates[i].Signature)
    {
      now.Stamp.Modified();
      this->CasterStates[i] = now;
    }
  }
}
