#include "vtkShadowHiddenFaces.h"

#include "ShadowReach.h"
#include "vtkShadowCasterMesh.h"
#include "vtkShadowOpenGL.h"

#include "vtkProp3D.h"

#include <glm/matrix.hpp>

#include <algorithm>

namespace
{

using Side = vtkShadowHiddenFaces::Side;

// What a light outside need not see of the whole surface, if all of it is closed and wound alike.
Side Survey(const vtkShadowScene::Piece& piece)
{
  const vtkShadowCasterMesh caster = vtkShadowCasterMesh::Build(piece);
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
    surface.Hidden = Survey(piece);
    surface.Surveyed = true;
  }
  const bool isMirrored = glm::determinant(glm::dmat3(piece.WorldFromModel)) < 0.0;
  return surface.Hidden == Side::None || !isMirrored ? surface.Hidden
    : surface.Hidden == Side::Back                   ? Side::Front
                                                     : Side::Back;
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
