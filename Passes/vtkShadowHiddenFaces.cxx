#include "vtkShadowHiddenFaces.h"

#include "EmbeddedSurface.h"
#include "ShadowReach.h"
#include "vtkShadowCasterMesh.h"
#include "vtkShadowOpenGL.h"

#include "vtkProp3D.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <utility>

namespace
{

using Side = vtkShadowHiddenFaces::Side;

// What a light outside need not see of the whole surface, if all of it is closed and wound alike.
Side Survey(const vtkShadowCasterMesh& caster)
{
  const std::vector<vtkshadows::MeshPiece>& pieces = caster.Mesh.pieces;
  if (!caster.Skipped.empty() || pieces.empty())
  {
    return Side::None;
  }
  const bool insideOut = pieces.front().insideOut;
  const bool isClosed = std::all_of(pieces.begin(), pieces.end(),
    [insideOut](const vtkshadows::MeshPiece& p) { return p.closed && p.insideOut == insideOut; });
  return !isClosed ? Side::None : insideOut ? Side::Front : Side::Back;
}

bool HoldsLight(const vtkShadowScene::Piece& piece, const glm::dvec4& lightWC)
{
  vtkshadows::Box bounds;
  bounds.Add(piece.CornersWC);
  return lightWC.w != 0.0 && bounds.Holds(glm::dvec3(lightWC));
}

}

//------------------------------------------------------------------------------
struct vtkShadowHiddenFaces::Search
{
  // Triangles that are looked at as soon as asked for: it takes no longer than a frame or so.
  static constexpr std::size_t MostAtOnce = 8192;

  explicit Search(vtkshadows::ShadowMesh<float> mesh)
  {
    const auto when =
      mesh.triangles.size() > MostAtOnce ? std::launch::async : std::launch::deferred;
    this->IsEmbedded = std::async(when,
      [this, mesh = std::move(mesh)] { return vtkshadows::IsEmbedded(mesh, this->Cancelled); });
  }
  ~Search() { this->Cancelled = true; } // the future waits for its thread
  bool IsOver() const
  {
    return this->IsEmbedded.wait_for(std::chrono::seconds(0)) != std::future_status::timeout;
  }

  std::atomic<bool> Cancelled{ false };
  std::future<bool> IsEmbedded;
};

vtkShadowHiddenFaces::Surface::Surface() = default;
vtkShadowHiddenFaces::Surface::Surface(Surface&&) noexcept = default;
vtkShadowHiddenFaces::Surface& vtkShadowHiddenFaces::Surface::operator=(
  Surface&&) noexcept = default;
vtkShadowHiddenFaces::Surface::~Surface() = default;

vtkShadowHiddenFaces::~vtkShadowHiddenFaces() = default;

//------------------------------------------------------------------------------
void vtkShadowHiddenFaces::BeginFrame(const std::vector<vtkShadowScene::Prop>& props)
{
  ++this->Frame;
  this->Known.BeginFrame(props);
}

//------------------------------------------------------------------------------
vtkShadowHiddenFaces::Side vtkShadowHiddenFaces::Of(
  const vtkShadowScene::Piece& piece, const glm::dvec4& lightWC)
{
  // Holes that a texture cuts show what lies behind.
  if (!piece.DrawnSolid || HoldsLight(piece, lightWC))
  {
    return Side::None;
  }
  Surface& surface = this->Known.Of(piece,
    [this]()
    {
      Surface fresh;
      fresh.FirstFrame = this->Frame;
      return fresh;
    });
  if (surface.FirstFrame == this->Frame)
  {
    return Side::None;
  }
  if (!surface.Surveyed)
  {
    vtkShadowCasterMesh caster = vtkShadowCasterMesh::Build(piece);
    surface.Hidden = Survey(caster);
    surface.Surveyed = true;
    if (this->Wanted == Proof::Embedded && surface.Hidden != Side::None)
    {
      surface.Embedded = std::make_unique<Search>(std::move(caster.Mesh));
    }
  }
  if (surface.Embedded)
  {
    if (!surface.Embedded->IsOver())
    {
      return Side::None;
    }
    surface.Hidden = surface.Embedded->IsEmbedded.get() ? surface.Hidden : Side::None;
    surface.Embedded.reset();
  }
  const bool isMirrored = glm::determinant(glm::dmat3(piece.WorldFromModel)) < 0.0;
  return surface.Hidden == Side::None || !isMirrored ? surface.Hidden
    : surface.Hidden == Side::Back                   ? Side::Front
                                                     : Side::Back;
}

//------------------------------------------------------------------------------
bool vtkShadowHiddenFaces::IsSearching() const
{
  bool isSearching = false;
  this->Known.ForEach([&isSearching](const Surface& surface)
    { isSearching = isSearching || (surface.Embedded && !surface.Embedded->IsOver()); });
  return isSearching;
}

//------------------------------------------------------------------------------
std::unordered_map<vtkProp*, unsigned int> vtkShadowHiddenFaces::CulledOf(
  const std::vector<vtkShadowScene::Prop>& props, const std::vector<std::size_t>& casters,
  const glm::dvec4& lightWC, bool mirrored)
{
  std::unordered_map<vtkProp*, unsigned int> culled;
  for (const std::size_t i : casters)
  {
    for (const vtkShadowScene::Piece& piece : props[i].Pieces)
    {
      const Side hidden = this->Of(piece, lightWC);
      if (hidden != Side::None)
      {
        culled[piece.Prop] = (hidden == Side::Back) != mirrored ? GL_BACK : GL_FRONT;
      }
    }
  }
  return culled;
}
