#include "vtkPlanarShadowPassInternals.h"

#include "ShadowPlateaus.h"
#include "ShadowVolume.h"

#include "vtkActor.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProperty.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace
{

using vtkshadows::LightView;
using vtkshadows::PlanarThrow;

// VTK draws polygons with visible edges larger by half an edge's width, without moving their depth.
double WidestEdge(const vtkShadowScene& scene, const std::vector<std::size_t>& props)
{
  double widest = 0.0;
  for (const std::size_t i : props)
  {
    for (const vtkShadowScene::Piece& piece : scene.GetProps()[i].Pieces)
    {
      auto* actor = vtkActor::SafeDownCast(piece.Prop);
      if (actor && actor->GetProperty()->GetEdgeVisibility())
      {
        widest = std::max<double>(widest, actor->GetProperty()->GetLineWidth());
      }
    }
  }
  return widest;
}

}

//------------------------------------------------------------------------------
// The pixels that show a plane: all that its receivers cover, if no other receiver may hide them;
// else told by their depth.
void vtkPlanarShadowPass::Internals::MarkPlane(
  const vtkShadowFrame& frame, std::size_t plane, bool isOnlyOne)
{
  this->Marked = static_cast<int>(plane);
  if (isOnlyOne)
  {
    this->Canvas.MarkReceivers(frame, this->Eye, this->Planes.ShadowedProps());
    return;
  }
  const glm::dvec4 rounding(0.0, 0.0, 0.0, this->Planes.Tolerance());
  // Seen from among its receivers: far from the world's origin the plane would lose its digits.
  const vtkshadows::Box& bounds = this->Planes.Get()[plane].Bounds;
  const glm::dvec3 originWC = 0.5 * (bounds.minimum + bounds.maximum);
  const glm::dvec4 planeHere =
    vtkshadows::PlaneSeenFrom(this->Planes.Get()[plane].PlaneWC, originWC);
  const glm::dmat4 clipFromHere = this->ClipFromWorld * glm::translate(glm::dmat4(1.0), originWC);
  glm::dvec3 beneath, above;
  if (vtkshadows::DepthOnPlane(
        planeHere - rounding, clipFromHere, frame.Size[0], frame.Size[1], beneath) &&
    vtkshadows::DepthOnPlane(
      planeHere + rounding, clipFromHere, frame.Size[0], frame.Size[1], above))
  {
    this->Canvas.MarkPlane(frame, this->PlanesOfPixels, this->BitOf(plane), beneath, above,
      WidestEdge(*frame.Scene, this->Planes.ShadowedProps()));
  }
  else
  {
    this->Canvas.MarkNothing(frame); // edge-on
  }
}

//------------------------------------------------------------------------------
// All that a shadow throws, over pixels that are marked; mark() when the marks are used up.
void vtkPlanarShadowPass::Internals::Draw(const vtkShadowFrame& frame,
  vtkPlanarShadowCanvas& canvas, const Shadow& shadow, const glm::dmat4& clipFromWorld,
  bool isMirrored, const std::function<void()>& mark)
{
  const float share = 1.0f / static_cast<float>(shadow.Throws.size());
  for (const PlanarThrow& thrown : shadow.Throws)
  {
    const auto culled =
      this->HiddenFaces.CulledOf(frame.Scene->GetProps(), shadow.Casters, thrown.light, isMirrored);
    const LightView view = vtkshadows::PlanarView(shadow.PlaneWC, thrown, clipFromWorld,
      shadow.CentreWC, this->Planes.Tolerance(), shadow.Highest);
    while (!canvas.Throw(frame, shadow.Casters, view, culled, share))
    {
      mark();
    }
    ++this->Self->NumberOfThrows;
    this->Self->NumberOfDrawnCasters += static_cast<vtkIdType>(shadow.Casters.size());
  }
  this->DrawPlateaus(frame, canvas, shadow, clipFromWorld);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::Internals::DrawPlateaus(const vtkShadowFrame& frame,
  vtkPlanarShadowCanvas& canvas, const Shadow& shadow, const glm::dmat4& clipFromWorld)
{
  if (!(shadow.Light->radius > 0.0) || this->Self->SoftMethod != PLATEAUS)
  {
    return;
  }
  const glm::dvec4 lightWC = vtkshadows::HomogeneousLight(*shadow.Light);
  std::vector<std::pair<glm::dvec3, glm::dvec3>> edges;
  std::vector<vtkshadows::CastSign> signs;
  std::vector<vtkshadows::SilhouetteEdge> silhouette;
  for (const vtkShadowScene::Piece* piece : shadow.Pieces)
  {
    const vtkShadowCasterMesh& caster =
      this->Meshes.Of(*piece, [piece]() { return vtkShadowCasterMesh::Build(*piece); });
    const glm::dmat4 worldFromCaster = piece->WorldFromModel * caster.ModelFromCaster;
    const vtkshadows::ShadowMesh<float>& mesh = caster.Mesh;
    vtkshadows::FaceTriangles(
      mesh, glm::inverse(worldFromCaster) * lightWC, vtkshadows::CastingFaces::Closed, signs);
    vtkshadows::FindSilhouette(mesh, signs, silhouette);
    const auto toWorld = [&](std::uint32_t i)
    { return glm::dvec3(worldFromCaster * glm::dvec4(glm::dvec3(mesh.points[i]), 1.0)); };
    for (const vtkshadows::SilhouetteEdge& edge : silhouette)
    {
      edges.emplace_back(toWorld(edge.from), toWorld(edge.to));
    }
  }
  std::vector<vtkshadows::PlateauVertex> triangles;
  vtkshadows::BuildPlateaus(
    shadow.PlaneWC, lightWC, shadow.Light->radius, edges, shadow.FootWC, triangles);
  canvas.DrawPlateaus(
    frame, clipFromWorld * glm::translate(glm::dmat4(1.0), shadow.FootWC), triangles);
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowPass::Internals::UpdateMasks(const vtkShadowFrame& frame, bool anySoft)
{
  using Format = vtkShadowTextureArray::Format;
  const int width = frame.Size[0], height = frame.Size[1];
  this->Textures.Release();
  this->TextureCanvas.Release();
  this->States.clear();
  this->Masks.Reserve(frame.Window, Format::R8, width, height, std::max(this->NumberOfSlots, 1));
  if (!this->Masks.Id() || !this->Canvas.Reserve(frame, width, height, anySoft))
  {
    return false;
  }
  const bool isOnlyOne = std::all_of(this->Shadows.begin(), this->Shadows.end(),
    [this](const Shadow& shadow)
    { return shadow.Plane == this->Shadows[0].Plane && this->Planes.Get()[shadow.Plane].AllFlat; });
  this->Marked = -1;
  if (!isOnlyOne)
  {
    this->Depths.Reserve(frame.Window, Format::Depth24Stencil8, width, height, 1);
    this->PlanesOfPixels.Reserve(frame.Window, Format::RG32F, width, height, 1);
    const std::vector<std::size_t>& props = this->Planes.ShadowedProps();
    std::vector<float> planesOfProps;
    for (const std::size_t i : props)
    {
      const std::vector<std::size_t>* planes =
        this->Planes.ShadowedPlanesOf(frame.Scene->GetProps()[i].Source);
      // Planes that share a bit are one to this test.
      std::set<float> bits;
      for (const std::size_t plane : *planes)
      {
        bits.insert(this->BitOf(plane));
      }
      planesOfProps.push_back(std::accumulate(bits.begin(), bits.end(), 0.0f));
    }
    if (!this->Depths.Id() || !this->PlanesOfPixels.Id() ||
      !this->Canvas.DrawReceivers(
        frame, this->Depths, this->PlanesOfPixels, this->Eye, props, planesOfProps))
    {
      return false;
    }
  }
  std::size_t next = 0;
  for (int slot = 0; slot < this->NumberOfSlots && !this->Shadows.empty(); ++slot)
  {
    const bool isSoft = next < this->Shadows.size() && this->Shadows[next].Slot == slot &&
      this->IsSum(*this->Shadows[next].Light);
    this->Canvas.Begin(frame, this->Masks, slot, isSoft);
    for (; next < this->Shadows.size() && this->Shadows[next].Slot == slot; ++next)
    {
      Shadow& shadow = this->Shadows[next];
      this->ChooseThrows(shadow, this->ClipFromWorld, width, height);
      const auto mark = [&]() { this->MarkPlane(frame, shadow.Plane, isOnlyOne); };
      if (this->Marked != static_cast<int>(shadow.Plane))
      {
        mark();
      }
      this->Draw(frame, this->Canvas, shadow, this->ClipFromWorld, false, mark);
    }
    this->Canvas.End(frame);
  }
  return true;
}
