#include "vtkShadowEyeFaces.h"

#include "vtkActor.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPlaneCollection.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <map>
#include <unordered_set>

namespace
{

using Side = vtkShadowHiddenFaces::Side;

// The flags without their time stamp: a property that is newer than a mapper's buffers has VTK
// build these anew.
class Flags : public vtkProperty
{
public:
  static void Cull(vtkProperty* property, Side side)
  {
    property->*(&Flags::BackfaceCulling) = side == Side::Back;
    property->*(&Flags::FrontfaceCulling) = side == Side::Front;
  }
};

// The eye as a light: (position, 1), or (the direction toward it, 0).
glm::dvec4 EyeOf(const vtkShadowFrame& frame)
{
  const glm::dmat4 worldFromView = glm::inverse(frame.ViewFromWorld);
  const bool isParallel = frame.ClipFromView[2][3] == 0.0;
  return isParallel ? worldFromView[2] : worldFromView[3];
}

// Whether all of it lies beyond the near plane: else that cuts it open.
bool IsBeyondNear(const vtkshadows::BoxCorners& cornersWC, const glm::dmat4& clipFromWorld)
{
  return std::all_of(cornersWC.begin(), cornersWC.end(),
    [&clipFromWorld](const glm::dvec3& corner)
    {
      const glm::dvec4 clip = clipFromWorld * glm::dvec4(corner, 1.0);
      return clip.w > 0.0 && clip.z > -clip.w;
    });
}

// Whether VTK draws each of its triangles, whole, opaque, and nothing else.
bool IsPlain(vtkActor* actor, vtkMapper* mapper)
{
  vtkProperty* property = actor->GetProperty();
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper);
  return property->GetRepresentation() == VTK_SURFACE && !property->GetEdgeVisibility() &&
    !property->GetVertexVisibility() && !property->GetBackfaceCulling() &&
    !property->GetFrontfaceCulling() && !actor->GetForceOpaque() && !actor->GetForceTranslucent() &&
    !actor->HasTranslucentPolygonalGeometry() && (!planes || planes->GetNumberOfItems() == 0) &&
    !(glyphs && glyphs->GetCullingAndLOD());
}

}

//------------------------------------------------------------------------------
void vtkShadowEyeFaces::LeaveOut(const vtkShadowFrame& frame)
{
  this->Restore();
  const std::vector<vtkShadowScene::Prop>& props = frame.Scene->GetProps();
  this->Faces.BeginFrame(props);
  this->Count = 0;
  const glm::dmat4 clipFromWorld = frame.ClipFromView * frame.ViewFromWorld;
  // A delegate may draw by another view, and a view that mirrors shows faces the other way round.
  const double turn = glm::determinant(glm::dmat3(frame.ViewFromWorld)) * frame.ClipFromView[0][0] *
    frame.ClipFromView[1][1];
  if (frame.HasDelegate || !(turn > 0.0))
  {
    return;
  }

  // Actors may share a property, and parts of assemblies an actor: all of them must agree.
  const glm::dvec4 eyeWC = EyeOf(frame);
  std::map<vtkProperty*, Side> sides;
  std::map<vtkProperty*, int> actors;
  std::unordered_set<vtkProp*> known;
  for (const vtkShadowScene::Prop& prop : props)
  {
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      known.insert(piece.Prop);
      auto* actor = vtkActor::SafeDownCast(piece.Prop);
      if (prop.StandsInFor || !actor)
      {
        continue;
      }
      const bool isCandidate = !prop.Translucent && !prop.Impostors &&
        IsPlain(actor, piece.Mapper) && IsBeyondNear(piece.CornersWC, clipFromWorld);
      const Side side = isCandidate ? this->Faces.Of(piece, eyeWC) : Side::None;
      Side& agreed = sides.emplace(actor->GetProperty(), side).first->second;
      agreed = agreed == side ? side : Side::None;
      ++actors[actor->GetProperty()];
    }
  }
  vtkCollectionSimpleIterator it;
  vtkPropCollection* all = frame.Renderer->GetViewProps();
  all->InitTraversal(it);
  while (vtkProp* prop = all->GetNextProp(it))
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    if (actor && known.count(prop) == 0 && actor->GetVisibility())
    {
      sides.erase(actor->GetProperty());
    }
  }
  for (const auto& [property, side] : sides)
  {
    if (side != Side::None)
    {
      Flags::Cull(property, side);
      this->Properties.emplace_back(property);
      this->Count += actors[property];
    }
  }
}

//------------------------------------------------------------------------------
// Only properties without culling were changed.
void vtkShadowEyeFaces::Restore()
{
  for (vtkProperty* property : this->Properties)
  {
    Flags::Cull(property, Side::None);
  }
  this->Properties.clear();
}
