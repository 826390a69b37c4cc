#include "vtkStencilShadowVolumePass.h"

#include "LightSamples.h"
#include "ShadowReach.h"
#include "vtkShadowChecks.h"
#include "vtkShadowEye.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowVolumeCaster.h"
#include "vtkShadowVolumeCounter.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProperty.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <map>

vtkStandardNewMacro(vtkStencilShadowVolumePass);

namespace
{

using vtkshadows::CastingFaces;
using Rule = vtkShadowVolumeCounter::Rule;

// Whether the eye sees every triangle of the piece, from either side, so that a shadow starts
// nowhere but on what is drawn.
bool IsDrawnWhole(const vtkShadowScene::Prop& prop, const vtkShadowScene::Piece& piece)
{
  if (prop.StandsInFor || prop.Translucent || !piece.DrawnSolid)
  {
    return false;
  }
  vtkProperty* property = vtkActor::SafeDownCast(piece.Prop)->GetProperty();
  return !property->GetBackfaceCulling() && !property->GetFrontfaceCulling();
}

// How a light was counted: to do it again, and to show it.
struct Counting
{
  vtkShadowVolumeCounter::Eye Eye;
  std::vector<vtkShadowVolumeCounter::Draw> Draws;
  int Start = 0;
};

struct Caster
{
  const vtkShadowScene::Piece* Piece = nullptr;
  vtkShadowVolumeCaster* Geometry = nullptr;
  bool DrawnWhole = false;
  bool ClipsCaps = false;
};

}

//------------------------------------------------------------------------------
class vtkStencilShadowVolumePass::Internals
{
public:
  std::map<std::pair<vtkProp*, vtkMapper*>, vtkShadowVolumeCaster> Known;
  std::vector<Caster> Casters; // of this frame
  std::vector<vtkshadows::BoxCorners> Receivers;
  double ReceiverRounding = 0.0;
  vtkshadows::Box ReceiverBox;
  vtkshadows::Box SeenBox; // with the near plane as far as it is seen
  vtkShadowVolumeCounter Counter;
  vtkShadowVolumeCounter::Eye Eye;
  bool Parallel = false;
  glm::dvec3 BackwardWC{ 0.0 }; // of a parallel eye: against its direction
  glm::dvec4 EyeWC{ 0.0 };      // as EyeMayBeShadowed wants it
  vtkShadowTextureArray Masks;
  std::vector<Counting> Countings; // by slot

  void GatherReceivers(const vtkShadowScene& scene);
  vtkshadows::LightView SetEye(const vtkShadowFrame& frame, bool infinite);
  bool MayCountBefore(const Caster& caster, const glm::dvec4& lightWC) const;
};

//------------------------------------------------------------------------------
void vtkStencilShadowVolumePass::Internals::GatherReceivers(const vtkShadowScene& scene)
{
  this->Receivers = vtkShadowReceiverCorners(scene);
  this->ReceiverRounding = vtkShadowReceiverRounding(scene);
  this->ReceiverBox = {};
  for (const vtkshadows::BoxCorners& corners : this->Receivers)
  {
    this->ReceiverBox.Add(corners);
  }
}

//------------------------------------------------------------------------------
vtkshadows::LightView vtkStencilShadowVolumePass::Internals::SetEye(
  const vtkShadowFrame& frame, bool infinite)
{
  vtkshadows::LightView view = vtkShadowEyeOf(
    frame, vtkShadowCornersOf(*frame.Scene, [](const vtkShadowScene::Prop&) { return true; }));
  const bool isInfinite = infinite && !view.parallel;
  if (isInfinite)
  {
    view.clipFromView = vtkshadows::WithInfiniteFarPlane(view.clipFromView);
  }
  this->Eye.ClipFromWorld = view.clipFromView * view.viewFromWorld;
  this->Eye.NearPlaneWC =
    glm::row(this->Eye.ClipFromWorld, 3) + glm::row(this->Eye.ClipFromWorld, 2);
  this->Eye.UsesDepthClamp = !isInfinite;
  const glm::dmat4 worldFromView = glm::inverse(view.viewFromWorld);
  this->Parallel = view.parallel;
  this->BackwardWC = view.parallel ? glm::dvec3(worldFromView[2]) : glm::dvec3(0.0);
  this->EyeWC = view.parallel ? glm::dvec4(this->BackwardWC, 0.0) : worldFromView[3];
  this->SeenBox = this->ReceiverBox;
  this->SeenBox.Add(vtkshadows::NearQuad(this->Eye.ClipFromWorld));
  if (!view.parallel)
  {
    this->SeenBox.AddPoint(glm::dvec3(this->EyeWC));
  }
  return view;
}

//------------------------------------------------------------------------------
// Faces before the receiver may be counted if none of them is missing: with depths clamped, unless
// the eye is in the shadow; clipped, unless the near plane is.
bool vtkStencilShadowVolumePass::Internals::MayCountBefore(
  const Caster& caster, const glm::dvec4& lightWC) const
{
  const vtkshadows::BoxCorners& corners = caster.Piece->CornersWC;
  return caster.DrawnWhole &&
    !(this->Eye.UsesDepthClamp
        ? vtkshadows::EyeMayBeShadowed(this->EyeWC, lightWC, corners)
        : vtkshadows::NearPlaneMayBeShadowed(this->Eye.ClipFromWorld, lightWC, corners));
}

//------------------------------------------------------------------------------
vtkStencilShadowVolumePass::vtkStencilShadowVolumePass()
  : Internal(new Internals)
{
}

vtkStencilShadowVolumePass::~vtkStencilShadowVolumePass() = default;

//------------------------------------------------------------------------------
void vtkStencilShadowVolumePass::SetVariant(int variant)
{
  if (!vtkShadowRefusesChoice(this, "Variant", "vtkStencilShadowVolumePass::VariantType", variant,
        PARITY + 1, this->Variant) &&
    variant != this->Variant)
  {
    this->Variant = variant;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkStencilShadowVolumePass::SetCounter(int counter)
{
  if (!vtkShadowRefusesChoice(this, "Counter", "vtkStencilShadowVolumePass::CounterType", counter,
        FLOAT_COUNTER + 1, this->Counter) &&
    counter != this->Counter)
  {
    this->Counter = counter;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
// Bring every caster's mesh up to date, and drop those that are gone.
void vtkStencilShadowVolumePass::UpdateCasters(const vtkShadowFrame& frame)
{
  Internals& my = *this->Internal;
  my.Casters.clear();
  for (auto& known : my.Known)
  {
    known.second.Used = false;
  }
  for (const vtkShadowScene::Prop& prop : frame.Scene->GetProps())
  {
    std::string fault, notFinite, skipped;
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      if (!prop.Casts)
      {
        continue;
      }
      vtkShadowVolumeCaster& caster = my.Known[{ piece.Prop, piece.Mapper }];
      caster.Used = true;
      this->NumberOfMeshBuilds += caster.Update(frame.Window, piece) ? 1 : 0;
      fault = caster.GetFault().empty() ? fault : caster.GetFault();
      notFinite = caster.GetNotFinite().empty() ? notFinite : caster.GetNotFinite();
      skipped = caster.GetSkipped().empty() ? skipped : caster.GetSkipped();
      if (caster.GetFault().empty() && !caster.IsEmpty())
      {
        my.Casters.push_back({ &piece, &caster, IsDrawnWhole(prop, piece) });
      }
    }
    vtkProp* named = prop.StandsInFor ? prop.StandsInFor : prop.Source;
    std::ostringstream message;
    message << "The " << (prop.StandsInFor ? "stand-in of the " : "") << "caster "
            << named->GetClassName() << " (" << named << ") has ";
    if (!fault.empty())
    {
      message << fault << ": it casts no shadow. Repair it, or clean its input.";
    }
    else if (!notFinite.empty())
    {
      message << notFinite
              << ": its faces there cast no shadow, the others do. Repair the point, or clean the "
                 "input.";
    }
    else if (!skipped.empty())
    {
      message << skipped
              << ": shadow volumes have none of that. Use \"depth-map\", or give it a surface "
                 "(vtkTubeFilter, vtkGlyph3DMapper).";
    }
    const bool isWhole = fault.empty() && notFinite.empty() && skipped.empty();
    this->WarnOnce(prop.Source, isWhole ? "" : message.str());
  }
  for (auto it = my.Known.begin(); it != my.Known.end();)
  {
    it = it->second.Used ? std::next(it) : my.Known.erase(it);
  }
}

//------------------------------------------------------------------------------
bool vtkStencilShadowVolumePass::UpdateVisibility(
  const vtkShadowFrame& frame, const std::vector<int>& lights)
{
  Internals& my = *this->Internal;
  this->NumberOfZPassCasters = 0;
  this->NumberOfZFailCasters = 0;
  this->NumberOfCulledCasters = 0;
  my.Counter.NumberOfTriangles = 0;
  my.Counter.NumberOfDraws = 0;
  my.Counter.MergesDraws = this->MergedDraws;
  my.Counter.NumberOfOverflows = 0;

  const auto& sceneLights = frame.Scene->GetLights();
  const bool anySoft = std::any_of(
    lights.begin(), lights.end(), [&](int i) { return sceneLights[i].Ray.radius > 0.0; });
  my.Masks.Reserve(frame.Window, vtkShadowTextureArray::Format::R8, frame.Size[0], frame.Size[1],
    static_cast<int>(lights.size()));
  my.GatherReceivers(*frame.Scene);
  this->UpdateCasters(frame);
  const vtkshadows::LightView view = my.SetEye(frame, this->InfiniteProjection);
  bool done = my.Masks.Id() != 0 && my.Counter.Reserve(frame, anySoft) &&
    my.Counter.DrawReceivers(frame, view);
  for (Caster& caster : my.Casters)
  {
    const glm::dmat4& clipFromWorld = my.Eye.ClipFromWorld;
    const bool isCut = vtkshadows::NearPlaneMayCut(clipFromWorld, caster.Piece->CornersWC);
    caster.DrawnWhole = caster.DrawnWhole && !isCut;
    caster.ClipsCaps = isCut && !vtkshadows::FarPlaneMayCut(clipFromWorld, caster.Piece->CornersWC);
  }
  my.Countings.assign(lights.size(), {});
  for (std::size_t slot = 0; done && slot < lights.size(); ++slot)
  {
    done = this->UpdateMask(frame, sceneLights[lights[slot]].Ray, slot);
  }
  this->HasDepthBounds = my.Counter.HasDepthBounds();
  this->NumberOfFaces = static_cast<vtkIdType>(my.Counter.NumberOfTriangles);
  this->NumberOfDraws = static_cast<vtkIdType>(my.Counter.NumberOfDraws);
  this->NumberOfOverflows = static_cast<vtkIdType>(my.Counter.NumberOfOverflows);
  this->WarnOnce(this,
    done ? ""
         : "The driver cannot hold depths and counts of " + std::to_string(frame.Size[0]) + " x " +
        std::to_string(frame.Size[1]) + " pixels and " + std::to_string(lights.size()) +
        " masks: their lights are lit. Use a smaller window or fewer lights.");
  return done;
}

//------------------------------------------------------------------------------
bool vtkStencilShadowVolumePass::UpdateMask(
  const vtkShadowFrame& frame, const vtkshadows::ShadowLight& light, std::size_t slot)
{
  Internals& my = *this->Internal;
  const bool parity = this->Variant == PARITY;
  const int layer = static_cast<int>(slot);
  if (!(light.radius > 0.0))
  {
    if (!this->CountVolumes(frame, light, slot))
    {
      return false;
    }
    my.Counter.Resolve(frame, my.Masks, layer, parity);
    return true;
  }
  const glm::dvec3 centreWC = 0.5 * (my.ReceiverBox.minimum + my.ReceiverBox.maximum);
  const std::vector<vtkshadows::ShadowLight> samples =
    vtkshadows::SampleAreaLight(light, this->LightSamples, centreWC);
  const float share = 1.0f / static_cast<float>(samples.size());
  my.Counter.ClearSum(frame);
  for (const vtkshadows::ShadowLight& sample : samples)
  {
    if (!this->CountVolumes(frame, sample, slot))
    {
      return false;
    }
    my.Counter.AddToSum(frame, share, parity);
  }
  const bool smoothed = this->Smoothing && my.Counter.SmoothSum(frame, share);
  my.Counter.ResolveSum(frame, my.Masks, layer, smoothed);
  return true;
}

//------------------------------------------------------------------------------
bool vtkStencilShadowVolumePass::CountVolumes(
  const vtkShadowFrame& frame, const vtkshadows::ShadowLight& light, std::size_t slot)
{
  Internals& my = *this->Internal;
  const glm::dvec4 lightWC = vtkshadows::HomogeneousLight(light);
  const CastingFaces faces = this->OneSidedClosedPieces ? CastingFaces::Closed : CastingFaces::All;

  std::vector<vtkShadowVolumeCounter::Draw> draws;
  int start = 0;
  for (const Caster& caster : my.Casters)
  {
    const vtkshadows::BoxCorners& corners = caster.Piece->CornersWC;
    // Receivers on a wide floor are on its plane, but its caps would be where VTK draws it.
    if (caster.Piece->WideFloor ||
      (this->Culling &&
        (!vtkshadows::ShadowMayBeSeen(my.Eye.ClipFromWorld, lightWC, corners) ||
          !vtkshadows::ShadowMayReach(my.ReceiverBox, lightWC, corners) ||
          vtkshadows::CastsOnNothing(caster.Piece->PlaneWC, light, my.Receivers,
            2.0 * std::max(my.ReceiverRounding, caster.Piece->Rounding)))))
    {
      ++this->NumberOfCulledCasters;
      continue;
    }
    vtkShadowVolumeCounter::Draw draw;
    draw.Caster = caster.Geometry;
    draw.LightWC = lightWC;
    draw.ClipsCaps = caster.ClipsCaps;
    switch (this->Variant)
    {
      case Z_FAIL:
        draw.Faces = Rule::Fail;
        break;
      case Z_PASS:
      case PARITY:
        draw.Faces = Rule::Pass;
        break;
      case Z_PASS_CAPPED:
        draw.Faces = Rule::PassCapped;
        break;
      default:
        draw.Faces = my.MayCountBefore(caster, lightWC) ? Rule::Pass : Rule::Fail;
    }
    ++(draw.Faces == Rule::Fail ? this->NumberOfZFailCasters : this->NumberOfZPassCasters);

    if (this->Confinement || my.Parallel)
    {
      draw.FarPlaneWC = draw.Faces == Rule::Fail
        ? vtkshadows::FarPlane(lightWC, corners, my.ReceiverBox)
        : vtkshadows::FarPlane(lightWC, corners, my.SeenBox, my.BackwardWC);
    }
    if (this->Confinement)
    {
      draw.Bounds =
        vtkshadows::BoundsInView(my.Eye.ClipFromWorld, lightWC, corners, draw.FarPlaneWC);
    }
    // All images of a directional light are one point at infinity, which closes a volume by itself.
    const bool toInfinity = glm::dvec3(draw.FarPlaneWC) == glm::dvec3(0.0);
    const bool oneImage = toInfinity && light.kind == vtkshadows::LightKind::Directional;
    draw.FarCaps = !oneImage;
    if (toInfinity && !oneImage && my.Parallel && draw.Faces == Rule::Fail)
    {
      // Parallel rays of the eye all end in one point at infinity, which no cap there can cover.
      draw.FarCaps = false;
      start += caster.Geometry->CountAtInfinity(lightWC, -my.BackwardWC, faces);
    }
    draw.Volume =
      &caster.Geometry->UpdateVolume(slot, lightWC, oneImage, faces, this->NumberOfVolumeBuilds);
    draws.push_back(draw);
  }

  // The classical variants clip what lies before the near plane, as they always did.
  vtkShadowVolumeCounter::Eye eye = my.Eye;
  eye.UsesDepthClamp =
    eye.UsesDepthClamp && (this->Variant == AUTOMATIC || this->Variant == Z_FAIL);
  using Way = vtkShadowVolumeCounter::Way;
  const Way way = this->Counter == WRAPPING_STENCIL ? Way::WrappingStencil
    : this->Counter == FLOAT_COUNTER                ? Way::Float
                                                    : Way::Stencil;
  my.Countings[slot] = { eye, draws, start };
  return my.Counter.Count(frame, eye, draws, start, way);
}

//------------------------------------------------------------------------------
bool vtkStencilShadowVolumePass::CountAgain(
  const vtkShadowFrame& frame, int slot, std::vector<float>& counts)
{
  Internals& my = *this->Internal;
  const Counting& counting = my.Countings[slot];
  if (!my.Counter.Count(
        frame, counting.Eye, counting.Draws, counting.Start, vtkShadowVolumeCounter::Way::Float))
  {
    return false;
  }
  my.Counter.ReadCounts(frame, counts);
  return true;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkStencilShadowVolumePass::GetDebugViews() const
{
  return { "volumes", "silhouette", "counts" };
}

//------------------------------------------------------------------------------
bool vtkStencilShadowVolumePass::DrawDebugView(
  const vtkShadowFrame& frame, int slot, const std::string& view)
{
  Internals& my = *this->Internal;
  const Counting& counting = my.Countings[slot];
  if (view == "counts")
  {
    const bool done = my.Counter.Count(
      frame, counting.Eye, counting.Draws, counting.Start, vtkShadowVolumeCounter::Way::Float);
    if (done)
    {
      my.Counter.ShowCounts(frame);
    }
    return done;
  }
  // The frame has the camera's own depths.
  const glm::dmat4 clipFromWorld = frame.ClipFromView * frame.ViewFromWorld;
  if (view == "volumes")
  {
    my.Counter.ShowVolumes(frame, clipFromWorld, counting.Draws);
    return true;
  }
  if (view == "silhouette")
  {
    my.Counter.ShowSilhouettes(frame, clipFromWorld, counting.Draws);
    return true;
  }
  return false;
}

//------------------------------------------------------------------------------
vtkIdType vtkStencilShadowVolumePass::GetMemoryInBytes() const
{
  std::size_t bytes = 0;
  for (const auto& known : this->Internal->Known)
  {
    bytes += known.second.MemoryInBytes();
  }
  return static_cast<vtkIdType>(bytes);
}

//------------------------------------------------------------------------------
vtkIdType vtkStencilShadowVolumePass::GetNumberOfTriangles() const
{
  std::size_t triangles = 0;
  for (const auto& known : this->Internal->Known)
  {
    triangles += known.second.GetMesh().NumberOfTriangles();
  }
  return static_cast<vtkIdType>(triangles);
}

//------------------------------------------------------------------------------
vtkShadowTextureArray* vtkStencilShadowVolumePass::GetTextures()
{
  return &this->Internal->Masks;
}

//------------------------------------------------------------------------------
vtkIdType vtkStencilShadowVolumePass::GetTextureMemory() const
{
  return static_cast<vtkIdType>(this->Internal->Masks.Bytes() + this->Internal->Counter.Bytes());
}

vtkIdType vtkStencilShadowVolumePass::GetCasterMemory() const
{
  return this->GetMemoryInBytes();
}

//------------------------------------------------------------------------------
void vtkStencilShadowVolumePass::ReleaseGraphicsResources(vtkWindow* w)
{
  this->Internal->Masks.Release();
  this->Internal->Counter.Release();
  this->Internal->Known.clear();
  this->Superclass::ReleaseGraphicsResources(w);
}

//------------------------------------------------------------------------------
void vtkStencilShadowVolumePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Variant: " << this->Variant << "\n";
  os << indent << "Counter: " << this->Counter << "\n";
  os << indent << "OneSidedClosedPieces: " << this->OneSidedClosedPieces << "\n";
  os << indent << "Culling: " << this->Culling << "\n";
  os << indent << "Confinement: " << this->Confinement << "\n";
  os << indent << "MergedDraws: " << this->MergedDraws << "\n";
  os << indent << "InfiniteProjection: " << this->InfiniteProjection << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "LightSamples: " << this->LightSamples << "\n";
  os << indent << "NumberOfMeshBuilds: " << this->NumberOfMeshBuilds << "\n";
  os << indent << "NumberOfVolumeBuilds: " << this->NumberOfVolumeBuilds << "\n";
  os << indent << "NumberOfZPassCasters: " << this->NumberOfZPassCasters << "\n";
  os << indent << "NumberOfZFailCasters: " << this->NumberOfZFailCasters << "\n";
  os << indent << "NumberOfCulledCasters: " << this->NumberOfCulledCasters << "\n";
  os << indent << "NumberOfFaces: " << this->NumberOfFaces << "\n";
  os << indent << "NumberOfDraws: " << this->NumberOfDraws << "\n";
  os << indent << "HasDepthBounds: " << this->HasDepthBounds << "\n";
  os << indent << "NumberOfOverflows: " << this->NumberOfOverflows << "\n";
}
