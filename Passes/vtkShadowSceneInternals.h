// What vtkShadowScene keeps, and how a frame is gathered. In files by subject: vtkShadowScene (the
// course of it, and its warnings), vtkShadowSceneLights, vtkShadowSceneProps (props, their pieces
// and stand-ins), vtkShadowSceneBounds (planes, bounds and roundings of pieces),
// vtkShadowSceneFloors (what is far wider or coarser than all else), vtkShadowSceneStamps (what
// tells that a shadow changed).
#ifndef vtkShadowSceneInternals_h
#define vtkShadowSceneInternals_h

#include "vtkShadowScene.h"

#include "HidingScreen.h"
#include "ShadowReach.h"
#include "vtkShadowByPiece.h"
#include "vtkShadowPass.h"
#include "vtkShadowSceneData.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

// A plane n.x = d in model coordinates; n = 0: there is none.
struct vtkShadowFlatMesh
{
  glm::dvec4 PlaneMC{ 0.0 };
  double Rounding = 0.0; // of the points as they are kept, along n
};

// The same, kept until the points change.
struct vtkShadowKnownPlane
{
  vtkMTimeType Stamp = 0;
  vtkShadowFlatMesh Flat;
};

// The bounds of a mesh in the world, kept until its points or its place change.
struct vtkShadowKnownBounds
{
  vtkMTimeType Stamp = 0;
  glm::dmat4 WorldFromModel{ 0.0 };
  vtkshadows::Box BoundsWC;
};

// A mesh as an actor, which is kept as long as its prop has it, so that nothing is built anew.
class vtkShadowStandIn
{
public:
  vtkShadowStandIn()
  {
    this->Mapper->ScalarVisibilityOff(); // translucent colours would not be drawn into a map
    this->Actor->SetMapper(this->Mapper);
    this->Actor->SetUserMatrix(this->Matrix);
  }

  // Follow the mesh, and the matrix of the prop that it stands in for.
  vtkActor* Update(vtkPolyData* mesh, vtkMatrix4x4* matrix)
  {
    if (this->Mapper->GetInput() != mesh)
    {
      this->Mapper->SetInputData(mesh);
    }
    if (matrix)
    {
      this->Matrix->DeepCopy(matrix);
    }
    return this->Actor;
  }

  bool Used = false;

private:
  vtkNew<vtkActor> Actor;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkMatrix4x4> Matrix;
};

//------------------------------------------------------------------------------
class vtkShadowScene::Internals
{
public:
  std::vector<Light> Lights;
  std::vector<Prop> Props;
  std::map<vtkMapper*, vtkShadowKnownPlane> Planes;
  std::map<std::pair<vtkProp*, vtkMapper*>, vtkShadowKnownBounds> Bounds; // of what is sheared
  std::vector<std::uint64_t> CasterSignature;
  int TranslucentCasting = vtkShadowPass::TRANSLUCENT_NONE;
  vtkTimeStamp CasterTime;
  std::set<vtkProp*> Unbounded, UnboundedBefore; // of this frame, and of the last
  std::map<vtkProp*, vtkShadowStandIn> StandIns; // by the prop that has it
  std::set<vtkProp*> Unfit, UnfitBefore;         // whose stand-in cannot cast
  vtkProp* Coarse = nullptr;                     // whose rounding is more than all else is large
  vtkProp* CoarseBefore = nullptr;               // of the last frame
  double CoarseRounding = 0.0, CoarseReach = 0.0;

  void GatherLights(vtkRenderer* renderer);
  void GatherProps(vtkRenderer* renderer);
  void AddPiece(Prop& prop, vtkProp* leaf, vtkMatrix4x4* matrix);
  void AddStandIn();
  void FindWideFloors(vtkRenderer* renderer);
  void FindCoarse();
  void StampCasters();

  // Of a piece with its mapper and its matrix.
  static bool DrawsImpostors(const Piece& piece);
  static bool HasShadersOfVTK(vtkActor* actor);
  static bool IsDrawnSolid(const Piece& piece);
  static bool IsDrawnOnPlane(const Prop& prop, const Piece& piece);
  static double VertexReachOf(
    vtkMapper* mapper, const double bounds[6], const glm::dmat4& worldFromModel);
  static double RoundingOf(vtkMapper* mapper, const double bounds[6], const Piece& piece);
  void TightenBounds(Piece& piece);
  void FindPlane(Piece& piece);

  // The newest change of a data object and of all its blocks.
  static vtkMTimeType DeepMTime(vtkDataObject* data);
  static std::vector<std::uint64_t> ShapeOf(const Piece& piece);
  static void AppendMatrix(std::vector<std::uint64_t>& signature, const glm::dmat4& matrix);
  template <typename T>
  static void Append(std::vector<std::uint64_t>& signature, T value)
  {
    static_assert(sizeof(T) <= sizeof(std::uint64_t), "one word a value");
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(T));
    signature.push_back(bits);
  }

private:
  vtkShadowFlatMesh PlaneOf(vtkMapper* mapper);
  bool HidesItsShadow(const Prop& prop, const Piece& piece, const Light& light,
    const std::vector<vtkshadows::BoxCorners>& receivers, double rounding,
    const vtkshadows::PixelView& view);

  // In model coordinates; none of what has holes, or is no rectangle.
  vtkShadowByPiece<std::optional<vtkshadows::ScreenCorners>> Screens;
};

#endif
