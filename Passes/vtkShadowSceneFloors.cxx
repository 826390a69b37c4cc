#include "vtkShadowSceneInternals.h"

#include "PlanarProjection.h"
#include "vtkShadowCasterGeometry.h"
#include "vtkShadowMatrix.h"

#include "vtkCamera.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace
{

using vtkshadows::BoxCorners;

// How many times as large as all else in the scene a floor's coordinates are to be a wide one.
constexpr double WideFloorTimes = 32.0;

// What a floor casts on is hidden by itself if less than this share of a pixel shows any of it.
constexpr double SeenPastFloor = 1.0 / 64.0;

// Coordinates of a mesh that differ by less than this share of its size are one: floats.
constexpr double SameShare = 1.0e-6;

// A plane that leans in the model has bounds that are no plane, and reach as far beneath it.
BoxCorners OnPlane(const vtkShadowScene::Piece& piece)
{
  BoxCorners corners = piece.CornersWC;
  const glm::dvec3 normal(piece.PlaneWC);
  for (glm::dvec3& corner : corners)
  {
    corner -= (glm::dot(normal, corner) - piece.PlaneWC.w) * normal;
  }
  return corners;
}

// One that may be a wide floor.
struct FlatPiece
{
  const vtkShadowScene::Prop* Owner;
  vtkShadowScene::Piece* Floor;
  BoxCorners CornersWC; // on its plane
  double Rounding;      // of its plane and of those of all wider ones, at the worst
};

// What is no wide floor.
struct Surroundings
{
  vtkshadows::Box Bounds;
  double Reach = 0.0, Rounding = 0.0; // at the most

  void Add(const vtkShadowScene::Piece& piece)
  {
    this->Bounds.Add(piece.CornersWC);
    this->Reach = std::max(this->Reach, piece.VertexReach);
    this->Rounding = std::max(this->Rounding, piece.Rounding);
  }

  bool AreSmallBeside(const FlatPiece& flat) const
  {
    const double largest =
      std::max({ this->Bounds.Diagonal(), this->Reach, std::ldexp(flat.Rounding, 22) });
    return !this->Bounds.isEmpty && flat.Floor->VertexReach > WideFloorTimes * largest;
  }
};

// No pixels without a window.
vtkshadows::PixelView ViewOf(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const glm::dmat4 viewFromWorld = vtkShadowMatrix::ViewFromWorld(camera);
  const glm::dmat4 clipFromView = vtkShadowMatrix::ClipFromView(camera, renderer);
  const glm::dmat4 worldFromView = glm::inverse(viewFromWorld);
  const int* size = renderer->GetRenderWindow() ? renderer->GetSize() : nullptr;
  return { clipFromView * viewFromWorld,
    camera->GetParallelProjection() ? worldFromView[2] : worldFromView[3], size ? size[0] : 0,
    size ? size[1] : 0 };
}

// The rectangle in the model that a flat piece fills without a hole.
std::optional<vtkshadows::ScreenCorners> FilledRectangle(const vtkShadowScene::Piece& piece)
{
  double bounds[6];
  if (!vtkShadowCasterGeometry::BoundsOf(piece.Mapper, bounds))
  {
    return std::nullopt;
  }
  const glm::dvec3 low(bounds[0], bounds[2], bounds[4]), high(bounds[1], bounds[3], bounds[5]);
  const glm::dvec3 size = high - low;
  const double largest = std::max({ size.x, size.y, size.z });
  const int axis = size.x <= std::min(size.y, size.z) ? 0 : size.y <= size.z ? 1 : 2;
  const int right = (axis + 1) % 3, up = (axis + 2) % 3;
  if (!(size[axis] <= SameShare * largest))
  {
    return std::nullopt;
  }
  const glm::dmat4 modelFromTrace =
    glm::scale(glm::translate(glm::dmat4(1.0), 0.5 * (low + high)), glm::dvec3(largest));
  const vtkShadowCasterGeometry geometry = vtkShadowCasterGeometry::Extract(
    piece, glm::inverse(modelFromTrace), piece.WorldFromModel * modelFromTrace);
  const auto filled = vtkshadows::FilledBounds(geometry.Vertices, geometry.Triangles, axis);
  // Not of points alone, that no triangle has.
  const glm::dvec2 half(0.5 * size[right] / largest, 0.5 * size[up] / largest);
  if (!filled || glm::distance(filled->low, -half) > SameShare ||
    glm::distance(filled->high, half) > SameShare)
  {
    return std::nullopt;
  }
  vtkshadows::ScreenCorners corners{ low, low, high, high };
  corners[1][right] = high[right];
  corners[3][right] = low[right];
  for (glm::dvec3& corner : corners)
  {
    corner[axis] = 0.5 * (low[axis] + high[axis]);
  }
  return corners;
}

}

//------------------------------------------------------------------------------
// Whether a flat piece is drawn where its plane is, by a shader that can be told so.
bool vtkShadowScene::Internals::IsDrawnOnPlane(const Prop& prop, const Piece& piece)
{
  auto* actor = vtkActor::SafeDownCast(piece.Prop);
  return glm::dvec3(piece.PlaneWC) != glm::dvec3(0.0) && actor && HasShadersOfVTK(actor) &&
    !prop.Impostors &&
    (piece.Mapper->IsA("vtkOpenGLPolyDataMapper") ||
      piece.Mapper->IsA("vtkCompositePolyDataMapper"));
}

//------------------------------------------------------------------------------
// Whether all that lies behind a flat piece for the light does so for the eye, too, which sees none
// of it: as the ground behind a wall that is as wide.
bool vtkShadowScene::Internals::HidesItsShadow(const Prop& prop, const Piece& piece,
  const Light& light, const std::vector<BoxCorners>& receivers, double rounding,
  const vtkshadows::PixelView& view)
{
  auto* actor = vtkActor::SafeDownCast(piece.Prop);
  vtkProperty* property = actor ? actor->GetProperty() : nullptr;
  if (!property || view.width < 1 || view.height < 1 || prop.Translucent || !piece.DrawnSolid ||
    property->GetRepresentation() != VTK_SURFACE || property->GetBackfaceCulling() ||
    property->GetFrontfaceCulling())
  {
    return false;
  }
  const auto& filled = this->Screens.Of(piece, [&piece]() { return FilledRectangle(piece); });
  if (!filled)
  {
    return false;
  }
  vtkshadows::ScreenCorners screen = *filled;
  for (glm::dvec3& corner : screen)
  {
    corner = glm::dvec3(piece.WorldFromModel * glm::dvec4(corner, 1.0));
  }
  const glm::dvec4 planeWC =
    vtkshadows::TurnedToLight(piece.PlaneWC, vtkshadows::HomogeneousLight(light.Ray));
  double pixels = 0.0;
  for (const BoxCorners& corners : receivers)
  {
    pixels += vtkshadows::PixelsSeenPast(screen, planeWC, corners, rounding, view);
  }
  return pixels < SeenPastFloor;
}

//------------------------------------------------------------------------------
// After all lights and props. As many as are all so much wider than the others.
void vtkShadowScene::Internals::FindWideFloors(vtkRenderer* renderer)
{
  this->Screens.BeginFrame(this->Props);
  std::vector<FlatPiece> flats; // the candidates
  Surroundings others;
  std::vector<BoxCorners> receivers;
  for (Prop& prop : this->Props)
  {
    for (Piece& piece : prop.Pieces)
    {
      const bool isFlat = prop.Receives && IsDrawnOnPlane(prop, piece);
      if (isFlat)
      {
        flats.push_back({ &prop, &piece, OnPlane(piece), piece.PlaneRounding });
      }
      else
      {
        others.Add(piece);
      }
      if (prop.Receives)
      {
        receivers.push_back(isFlat ? flats.back().CornersWC : piece.CornersWC);
      }
    }
  }
  std::sort(flats.begin(), flats.end(),
    [](const FlatPiece& a, const FlatPiece& b)
    { return a.Floor->VertexReach < b.Floor->VertexReach; });
  double worst = 0.0;
  for (auto flat = flats.rbegin(); flat != flats.rend(); ++flat)
  {
    flat->Rounding = worst = std::max(worst, flat->Rounding);
  }

  const vtkshadows::PixelView view = ViewOf(renderer);
  const auto castOnNothing = [&](std::vector<FlatPiece>::const_iterator first)
  {
    const double rounding = 2.0 * std::max(others.Rounding, first->Rounding);
    const auto castsOnNothing = [&](const FlatPiece& flat)
    {
      return std::all_of(this->Lights.begin(), this->Lights.end(),
        [&](const Light& light)
        {
          return light.AtEye ||
            vtkshadows::CastsOnNothing(flat.Floor->PlaneWC, light.Ray, receivers, rounding) ||
            this->HidesItsShadow(*flat.Owner, *flat.Floor, light, receivers, rounding, view);
        });
    };
    return std::all_of(first, flats.cend(), castsOnNothing);
  };
  auto first = flats.begin();
  while (first != flats.end() && !(others.AreSmallBeside(*first) && castOnNothing(first)))
  {
    others.Add(*first->Floor);
    ++first;
  }
  for (; first != flats.end(); ++first)
  {
    Piece& floor = *first->Floor;
    floor.WideFloor = true;
    floor.CornersWC = first->CornersWC;
    floor.VertexReach = std::max(others.Reach, std::ldexp(floor.PlaneRounding, 22));
    floor.Rounding = std::max(others.Rounding, floor.PlaneRounding);
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
