#include "vtkShadowSceneInternals.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{

// How many times as large as all else in the scene a floor's coordinates are to be a wide one.
constexpr double WideFloorTimes = 32.0;

}

//------------------------------------------------------------------------------
// Whether a flat piece is drawn where its plane is, by a shader that can be told so.
bool vtkShadowScene::Internals::IsDrawnOnPlane(const Prop& prop, const Piece& piece)
{
  auto* actor = vtkActor::SafeDownCast(piece.Prop);
  return glm::dvec3(piece.PlaneWC) != glm::dvec3(0.0) && actor && HasShadersOfVTK(actor) &&
    !prop.Impostors && piece.Mapper->IsA("vtkOpenGLPolyDataMapper") &&
    vtkPolyData::SafeDownCast(piece.Mapper->GetInputDataObject(0, 0));
}

//------------------------------------------------------------------------------
// After all lights and props. No more than one is so much wider than all others.
void vtkShadowScene::Internals::FindWideFloor()
{
  const Prop* owner = nullptr;
  Piece* floor = nullptr;
  for (Prop& prop : this->Props)
  {
    for (Piece& piece : prop.Pieces)
    {
      if (!floor || piece.VertexReach > floor->VertexReach)
      {
        owner = &prop;
        floor = &piece;
      }
    }
  }
  if (!floor || !owner->Receives || !IsDrawnOnPlane(*owner, *floor))
  {
    return;
  }

  // A plane that leans in the model has bounds that are no plane, and reach as far beneath it.
  vtkshadows::BoxCorners onPlane = floor->CornersWC;
  for (glm::dvec3& corner : onPlane)
  {
    const glm::dvec3 normal(floor->PlaneWC);
    corner -= (glm::dot(normal, corner) - floor->PlaneWC.w) * normal;
  }
  vtkshadows::Box others;
  double reach = std::ldexp(floor->PlaneRounding, 22), rounding = floor->PlaneRounding;
  std::vector<vtkshadows::BoxCorners> receivers;
  for (const Prop& prop : this->Props)
  {
    for (const Piece& piece : prop.Pieces)
    {
      if (prop.Receives)
      {
        receivers.push_back(&piece == floor ? onPlane : piece.CornersWC);
      }
      if (&piece != floor)
      {
        others.Add(piece.CornersWC);
        reach = std::max(reach, piece.VertexReach);
        rounding = std::max(rounding, piece.Rounding);
      }
    }
  }
  const auto castsOnNothing = [&](const Light& light)
  {
    return light.AtEye ||
      vtkshadows::CastsOnNothing(floor->PlaneWC, light.Ray, receivers, 2.0 * rounding);
  };
  if (!others.isEmpty && floor->VertexReach > WideFloorTimes * std::max(others.Diagonal(), reach) &&
    std::all_of(this->Lights.begin(), this->Lights.end(), castsOnNothing))
  {
    floor->WideFloor = true;
    floor->CornersWC = onPlane;
    floor->VertexReach = reach;
    floor->Rounding = rounding;
  }
}

//------------------------------------------------------------------------------
// Positions are taken to be rounded by what the worst known prop is.
void vtkShadowScene::Internals::FindCoarse()
{
  this->CoarseBefore = this->Coarse;
  this->Coarse = nullptr;
  const Piece* worst = nullptr;
  vtkProp* owner = nullptr;
  for (const Prop& prop : this->Props)
  {
    for (const Piece& piece : prop.Pieces)
    {
      if ((prop.Casts || prop.Receives) && (!worst || piece.Rounding > worst->Rounding))
      {
        worst = &piece;
        owner = prop.Source;
      }
    }
  }
  vtkshadows::Box others;
  for (const Prop& prop : this->Props)
  {
    for (const Piece& piece : prop.Pieces)
    {
      if (&piece != worst && !piece.WideFloor)
      {
        others.Add(piece.CornersWC);
      }
    }
  }
  if (worst && others.Diagonal() > 0.0 && worst->Rounding > others.Diagonal())
  {
    this->Coarse = owner;
    this->CoarseRounding = worst->Rounding;
    this->CoarseReach = worst->VertexReach;
  }
}
