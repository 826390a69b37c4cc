#include "vtkShadowSceneInternals.h"

#include "vtkShadowCasterGeometry.h"
#include "vtkShadowMatrix.h"

#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLODProp3D.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace
{

bool HasKey(vtkProp* prop, vtkInformationIntegerKey* key)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(key);
}

// Whether a mesh has triangles, and is not infinite.
bool CanCast(vtkPolyData* mesh)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  return mesh->GetNumberOfPoints() > 0 &&
    mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0 &&
    std::all_of(bounds, bounds + 6, [](double bound) { return std::isfinite(bound); });
}

int KeyOr(vtkProp* prop, vtkInformationIntegerKey* key, int otherwise)
{
  return HasKey(prop, key) ? prop->GetPropertyKeys()->Get(key) : otherwise;
}

vtkMapper* MapperOf(vtkProp* leaf)
{
  if (auto* actor = vtkActor::SafeDownCast(leaf))
  {
    return actor->GetMapper();
  }
  if (auto* lod = vtkLODProp3D::SafeDownCast(leaf))
  {
    return vtkMapper::SafeDownCast(lod->GetLODMapper(lod->GetPickLODID()));
  }
  return nullptr;
}

}

//------------------------------------------------------------------------------
bool vtkShadowScene::Internals::HasShadersOfVTK(vtkActor* actor)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  return !shaders->HasVertexShaderCode() && !shaders->HasFragmentShaderCode() &&
    !shaders->HasGeometryShaderCode() && shaders->GetNumberOfShaderReplacements() == 0;
}

//------------------------------------------------------------------------------
bool vtkShadowScene::Internals::IsDrawnSolid(const Piece& piece)
{
  auto* actor = vtkActor::SafeDownCast(piece.Prop);
  return actor && !actor->GetTexture() && actor->GetProperty()->GetAllTextures().empty() &&
    HasShadersOfVTK(actor);
}

//------------------------------------------------------------------------------
bool vtkShadowScene::Internals::DrawsImpostors(const Piece& piece)
{
  // By name: the sphere and stick mappers' classes moved between VTK's modules and versions.
  if (piece.Mapper->IsA("vtkOpenGLSphereMapper") || piece.Mapper->IsA("vtkOpenGLStickMapper") ||
    piece.Mapper->IsA("vtkPointGaussianMapper"))
  {
    return true;
  }
  auto* actor = vtkActor::SafeDownCast(piece.Prop);
  return actor &&
    (actor->GetProperty()->GetRenderPointsAsSpheres() ||
      actor->GetProperty()->GetRenderLinesAsTubes());
}

//------------------------------------------------------------------------------
void vtkShadowScene::Internals::AddPiece(Prop& prop, vtkProp* leaf, vtkMatrix4x4* matrix)
{
  vtkMapper* mapper = MapperOf(leaf);
  if (!mapper || !leaf->GetVisibility())
  {
    return;
  }
  double bounds[6];
  if (!vtkShadowCasterGeometry::BoundsOf(mapper, bounds))
  {
    return;
  }
  Piece piece;
  piece.Prop = vtkProp3D::SafeDownCast(leaf);
  piece.Mapper = mapper;
  piece.WorldFromModel = matrix ? vtkShadowMatrix::ToGlm(matrix) : glm::dmat4(1.0);
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec4 cornerMC(
      bounds[i & 1], bounds[2 + ((i >> 1) & 1)], bounds[4 + ((i >> 2) & 1)], 1.0);
    piece.CornersWC[i] = glm::dvec3(piece.WorldFromModel * cornerMC);
    // Lengths are squared in floats.
    const double most = std::sqrt(std::numeric_limits<float>::max());
    const glm::dvec3 reach = glm::abs(piece.CornersWC[i]);
    if (!(std::max({ reach.x, reach.y, reach.z }) < most))
    {
      this->Unbounded.insert(prop.Source);
      return;
    }
  }
  piece.VertexReach = VertexReachOf(mapper, bounds, piece.WorldFromModel);
  piece.Rounding = RoundingOf(mapper, bounds, piece);
  this->TightenBounds(piece);
  this->FindPlane(piece);
  piece.DrawnSolid = IsDrawnSolid(piece);
  piece.Shape = ShapeOf(piece);
  if (mapper->GetClippingPlanes())
  {
    AppendMatrix(piece.Shape, piece.WorldFromModel); // they cut it in the world
  }
  piece.Signature = piece.Shape;
  AppendMatrix(piece.Signature, piece.WorldFromModel);
  prop.Impostors = prop.Impostors || DrawsImpostors(piece);
  prop.Pieces.push_back(std::move(piece));
}

//------------------------------------------------------------------------------
void vtkShadowScene::Internals::GatherProps(vtkRenderer* renderer)
{
  this->Props.clear();
  this->UnboundedBefore.swap(this->Unbounded);
  this->Unbounded.clear();
  this->UnfitBefore.swap(this->Unfit);
  this->Unfit.clear();
  for (auto& known : this->StandIns)
  {
    known.second.Used = false;
  }
  vtkCollectionSimpleIterator it;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(it);
  while (vtkProp* source = props->GetNextProp(it))
  {
    if (!source->GetVisibility())
    {
      continue;
    }
    Prop prop;
    prop.Source = source;
    prop.Translucent =
      !source->HasOpaqueGeometry() && source->HasTranslucentPolygonalGeometry() != 0;
    source->InitPathTraversal();
    while (vtkAssemblyPath* path = source->GetNextPath())
    {
      vtkAssemblyNode* node = path->GetLastNode();
      this->AddPiece(prop, node->GetViewProp(), node->GetMatrix());
    }
    if (prop.Pieces.empty())
    {
      continue;
    }
    // A follower is a label: it turns with the eye.
    const int isScenery = source->IsA("vtkFollower") ? 0 : 1;
    const bool castsUnasked =
      !prop.Translucent || this->TranslucentCasting != vtkShadowPass::TRANSLUCENT_NONE;
    prop.Casts = KeyOr(source, vtkShadowPass::CASTS_SHADOWS(), isScenery && castsUnasked) != 0;
    prop.CastsRays = prop.Casts;
    prop.Receives = KeyOr(source, vtkShadowPass::RECEIVES_SHADOWS(), isScenery) != 0;
    if (prop.Translucent && vtkShadowPass::IsShadowCatcher(source))
    {
      prop.Catches = true;
      prop.Casts = false;
      prop.Receives = true;
    }
    if (prop.Translucent && prop.Casts &&
      this->TranslucentCasting >= vtkShadowPass::TRANSLUCENT_STOCHASTIC)
    {
      prop.Dithers = true;
      prop.Transmits = this->TranslucentCasting == vtkShadowPass::TRANSLUCENT_TRANSMITTANCE;
      for (Piece& piece : prop.Pieces)
      {
        piece.DrawnSolid = false;
        auto* actor = vtkActor::SafeDownCast(piece.Prop);
        Append(piece.Signature, 1.0 + (actor ? actor->GetProperty()->GetOpacity() : 1.0));
      }
    }
    this->Props.push_back(std::move(prop));
    this->AddStandIn();
  }
  for (auto known = this->StandIns.begin(); known != this->StandIns.end();)
  {
    known = known->second.Used ? std::next(known) : this->StandIns.erase(known);
  }
}

//------------------------------------------------------------------------------
// If the last prop casts by another mesh: that, as one more prop.
void vtkShadowScene::Internals::AddStandIn()
{
  vtkProp* source = this->Props.back().Source;
  vtkPolyData* mesh = vtkShadowPass::GetStandIn(source);
  if (!mesh || !this->Props.back().Casts)
  {
    return;
  }
  if (!CanCast(mesh))
  {
    this->Unfit.insert(source);
    return;
  }
  vtkShadowStandIn& standIn = this->StandIns[source];
  standIn.Used = true;
  vtkActor* actor = standIn.Update(mesh, source->GetMatrix());
  Prop prop;
  prop.Source = actor;
  prop.CastsRays = false;
  prop.Receives = false;
  prop.StandsInFor = source;
  this->AddPiece(prop, actor, actor->GetMatrix());
  this->Props.back().Casts = false;
  this->Props.push_back(std::move(prop));
}
