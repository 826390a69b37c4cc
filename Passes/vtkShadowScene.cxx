#include "vtkShadowScene.h"

#include "ShadowReach.h"
#include "vtkShadowCasterGeometry.h"
#include "vtkShadowMatrix.h"
#include "vtkShadowPass.h"
#include "vtkShadowSceneData.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCamera.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFollower.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkLODProp3D.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkSmartPointer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <set>

vtkStandardNewMacro(vtkShadowScene);

namespace
{

using Scene = vtkShadowScene;

// A plane n.x = d in model coordinates; n = 0: there is none.
struct FlatMesh
{
  glm::dvec4 PlaneMC{ 0.0 };
  double Rounding = 0.0; // of the points as they are kept, along n
};

// The same, kept until the points change.
struct KnownPlane
{
  vtkMTimeType Stamp = 0;
  FlatMesh Flat;
};

// The bounds of a mesh in the world, kept until its points or its place change.
struct KnownBounds
{
  vtkMTimeType Stamp = 0;
  glm::dmat4 WorldFromModel{ 0.0 };
  vtkshadows::Box BoundsWC;
};

// A light so near the eye that it shines past an edge on less than this share of a pixel is there.
constexpr double SeenBesideEye = 1.0 / 64.0;

// How many times as large as all else in the scene a floor's coordinates are to be a wide one.
constexpr double WideFloorTimes = 32.0;

glm::dvec3 PointOf(vtkPoints* points, vtkIdType i)
{
  double p[3];
  points->GetPoint(i, p);
  return { p[0], p[1], p[2] };
}

// Half a step of the numbers that `points` are kept in, as a share of them.
double RoundingUnitOf(vtkPoints* points)
{
  return std::ldexp(1.0, points && points->GetDataType() == VTK_FLOAT ? -24 : -53);
}

// Calls use(p) for each point, in order.
template <typename Use>
void ForEachPoint(const std::vector<vtkPoints*>& sets, const Use& use)
{
  for (vtkPoints* points : sets)
  {
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      use(PointOf(points, i));
    }
  }
}

// The plane through all points of `sets`, to the rounding of the numbers that they are kept in and
// of the floats that they are drawn in, about their middle.
FlatMesh FlatPlane(const std::vector<vtkPoints*>& sets)
{
  vtkIdType count = 0;
  double unit = 0.0;
  for (vtkPoints* points : sets)
  {
    count += points->GetNumberOfPoints();
    unit = std::max(unit, RoundingUnitOf(points));
  }
  if (count < 3)
  {
    return {};
  }

  // Span the plane by the point farthest from the first, and the one farthest from that line.
  const auto first = std::find_if(
    sets.begin(), sets.end(), [](vtkPoints* points) { return points->GetNumberOfPoints() > 0; });
  const glm::dvec3 origin = PointOf(*first, 0);
  glm::dvec3 along(0.0), across(0.0), largest(0.0), low(origin), high(origin);
  ForEachPoint(sets,
    [&](const glm::dvec3& p)
    {
      along = glm::length(p - origin) > glm::length(along) ? p - origin : along;
      largest = glm::max(largest, glm::abs(p));
      low = glm::min(low, p);
      high = glm::max(high, p);
    });
  ForEachPoint(sets,
    [&](const glm::dvec3& p)
    {
      const glm::dvec3 normal = glm::cross(along, p - origin);
      across = glm::length(normal) > glm::length(across) ? normal : across;
    });
  const double length = glm::length(across);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return {};
  }

  const glm::dvec3 normal = across / length;
  // Each coordinate is rounded by itself: in a mesh that its matrix scales unevenly they are
  // unlike.
  const glm::dvec3 kept = 4.0 * unit * largest;
  const glm::dvec3 drawn = std::ldexp(1.0, -22) * glm::min(high - low, largest);
  const glm::dvec3 rounding = glm::abs(normal) * glm::max(kept, drawn);
  const double tolerance =
    rounding.x + rounding.y + rounding.z + std::ldexp(glm::length(along), -50); // of the normal
  bool isFlat = true;
  ForEachPoint(sets,
    [&](const glm::dvec3& p)
    { isFlat = isFlat && std::abs(glm::dot(normal, p - origin)) <= tolerance; });
  if (!isFlat)
  {
    return {};
  }
  return { glm::dvec4(normal, glm::dot(normal, origin)), glm::dot(glm::abs(normal), kept) };
}

// The points of a polygonal mesh, or of all blocks of several, hidden or not; empty where anything
// else is among them.
std::vector<vtkPoints*> PointSetsOf(vtkDataObject* data)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    return mesh->GetPoints() ? std::vector<vtkPoints*>{ mesh->GetPoints() }
                             : std::vector<vtkPoints*>{};
  }
  std::vector<vtkPoints*> sets;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      auto* block = vtkPolyData::SafeDownCast(it->GetCurrentDataObject());
      if (!block)
      {
        return {};
      }
      if (block->GetPoints())
      {
        sets.push_back(block->GetPoints());
      }
    }
  }
  return sets;
}

glm::dvec4 TransformPlane(const glm::dmat4& worldFromModel, const glm::dvec4& planeMC)
{
  // A plane is a row: (n, -d) transforms by the inverse transpose.
  const glm::dvec4 row =
    glm::inverseTranspose(worldFromModel) * glm::dvec4(glm::dvec3(planeMC), -planeMC.w);
  const double length = glm::length(glm::dvec3(row));
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return glm::dvec4(0.0);
  }
  return glm::dvec4(glm::dvec3(row), -row.w) / length;
}

// How long one unit of height over a plane in the model is in the world.
double HeightScale(const glm::dmat4& worldFromModel, const glm::dvec4& planeMC)
{
  const glm::dvec3 row = glm::inverseTranspose(glm::dmat3(worldFromModel)) * glm::dvec3(planeMC);
  return 1.0 / glm::length(row);
}

vtkMTimeType DeepMTime(vtkDataObject* data)
{
  vtkMTimeType time = data->GetMTime();
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      time = std::max(time, it->GetCurrentDataObject()->GetMTime());
    }
  }
  return time;
}

// When a mapper last changed in a way that changes what it casts. A mapper's own time grows with
// its colours, too; where it places or shapes things by settings of its own there is no other.
vtkMTimeType ShapeMTime(vtkMapper* mapper)
{
  const bool isPlain = (mapper->IsA("vtkPolyDataMapper") || mapper->IsA("vtkDataSetMapper")) &&
    !mapper->IsA("vtkCompositePolyDataMapper") && !mapper->IsA("vtkCompositePolyDataMapper2") &&
    !mapper->IsA("vtkOpenGLSphereMapper") && !mapper->IsA("vtkOpenGLStickMapper") &&
    !mapper->IsA("vtkPointGaussianMapper");
  if (!isPlain)
  {
    vtkCompositeDataDisplayAttributes* blocks = vtkShadowCasterGeometry::AttributesOf(mapper);
    return std::max(mapper->GetMTime(), blocks ? blocks->GetMTime() : 0);
  }
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  vtkMTimeType time = planes ? planes->GetMTime() : 0;
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    time = std::max(time, planes->GetItem(i)->GetMTime());
  }
  return time;
}

template <typename T>
void Append(std::vector<std::uint64_t>& signature, T value)
{
  static_assert(sizeof(T) <= sizeof(std::uint64_t), "one word a value");
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(T));
  signature.push_back(bits);
}

std::vector<std::uint64_t> ShapeOf(const Scene::Piece& piece)
{
  std::vector<std::uint64_t> shape;
  Append(shape, piece.Prop);
  Append(shape, piece.Mapper);
  Append(shape, ShapeMTime(piece.Mapper));
  for (int port = 0; port < piece.Mapper->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < piece.Mapper->GetNumberOfInputConnections(port); ++i)
    {
      vtkDataObject* data = piece.Mapper->GetInputDataObject(port, i);
      Append(shape, data);
      Append(shape, data ? DeepMTime(data) : 0);
    }
  }
  if (auto* actor = vtkActor::SafeDownCast(piece.Prop))
  {
    vtkProperty* property = actor->GetProperty();
    Append(shape, property->GetRepresentation());
    Append(shape, property->GetLineWidth());
    Append(shape, property->GetPointSize());
    Append(shape, property->GetEdgeVisibility());
    Append(shape, actor->GetShaderProperty()->GetMTime());
  }
  return shape;
}

void AppendMatrix(std::vector<std::uint64_t>& signature, const glm::dmat4& matrix)
{
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 4; ++row)
    {
      Append(signature, matrix[column][row]);
    }
  }
}

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

// How far a point may be from where its mesh has it, world units.
double RoundingOf(vtkMapper* mapper, const double bounds[6], const Scene::Piece& piece)
{
  auto* mesh = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  const double unit = mesh ? RoundingUnitOf(mesh->GetPoints()) : std::ldexp(1.0, -24);
  double kept = 0.0, placed = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double largest = std::max(std::abs(bounds[2 * axis]), std::abs(bounds[2 * axis + 1]));
    kept = std::max(kept, largest * glm::length(glm::dvec3(piece.WorldFromModel[axis])));
  }
  for (const glm::dvec3& corner : piece.CornersWC)
  {
    placed = std::max(placed, glm::length(corner));
  }
  return std::max(
    { 4.0 * unit * kept, std::ldexp(piece.VertexReach, -22), std::ldexp(placed, -50) });
}

double VertexReachOf(vtkMapper* mapper, const double bounds[6], const glm::dmat4& worldFromModel)
{
  const bool isMoved = vtkShadowCasterGeometry::PlaceOfVertices(mapper).IsMoved();
  double reach = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = bounds[2 * axis], high = bounds[2 * axis + 1];
    const double largest = isMoved ? high - low : std::max(std::abs(low), std::abs(high));
    reach = std::max(reach, largest * glm::length(glm::dvec3(worldFromModel[axis])));
  }
  return reach;
}

bool HasShadersOfVTK(vtkActor* actor)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  return !shaders->HasVertexShaderCode() && !shaders->HasFragmentShaderCode() &&
    !shaders->HasGeometryShaderCode() && shaders->GetNumberOfShaderReplacements() == 0;
}

bool IsDrawnSolid(const Scene::Piece& piece)
{
  auto* actor = vtkActor::SafeDownCast(piece.Prop);
  return actor && !actor->GetTexture() && actor->GetProperty()->GetAllTextures().empty() &&
    HasShadersOfVTK(actor);
}

// Whether a flat piece is drawn where its plane is, by a shader that can be told so.
bool IsDrawnOnPlane(const Scene::Prop& prop, const Scene::Piece& piece)
{
  auto* actor = vtkActor::SafeDownCast(piece.Prop);
  return glm::dvec3(piece.PlaneWC) != glm::dvec3(0.0) && actor && HasShadersOfVTK(actor) &&
    !prop.Impostors && piece.Mapper->IsA("vtkOpenGLPolyDataMapper") &&
    vtkPolyData::SafeDownCast(piece.Mapper->GetInputDataObject(0, 0));
}

bool DrawsImpostors(const Scene::Piece& piece)
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

// Whether a matrix keeps the model's axes at right angles: then the bounds that it takes to the
// world are as tight as they are in the model.
bool KeepsRightAngles(const glm::dmat4& worldFromModel)
{
  const glm::dmat3 axes(worldFromModel);
  const auto areUpright = [&axes](int i, int j)
  {
    return std::abs(glm::dot(axes[i], axes[j])) <=
      1.0e-3 * glm::length(axes[i]) * glm::length(axes[j]);
  };
  return areUpright(0, 1) && areUpright(1, 2) && areUpright(2, 0);
}

// Half of it.
double SurfaceOf(const vtkshadows::BoxCorners& box)
{
  const glm::dvec3 a = box[1] - box[0], b = box[2] - box[0], c = box[4] - box[0];
  return glm::length(glm::cross(a, b)) + glm::length(glm::cross(b, c)) +
    glm::length(glm::cross(c, a));
}

// The bounds of finite points in the world, along its axes.
vtkshadows::Box BoundsInWorld(vtkPoints* points, const glm::dmat4& worldFromModel)
{
  vtkshadows::Box bounds;
  ForEachPoint({ points },
    [&](const glm::dvec3& p)
    {
      const glm::dvec3 at(worldFromModel * glm::dvec4(p, 1.0));
      if (std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z))
      {
        bounds.AddPoint(at);
      }
    });
  return bounds;
}

// How far beside a perspective eye a light may be and still be there, for the pixels of its view.
double SameAsEye(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const int* size = renderer->GetRenderWindow() ? renderer->GetSize() : nullptr;
  if (!size || size[0] < 1 || size[1] < 1 || camera->GetParallelProjection() ||
    camera->GetUseOffAxisProjection() || camera->GetUseExplicitProjectionTransformMatrix())
  {
    return 0.0;
  }
  // What is moved by e moves in the picture by at most e (1 + t) / near, with t the tangent of the
  // view's corner.
  const double side = std::tan(0.5 * glm::radians(camera->GetViewAngle()));
  const double perPixel = 2.0 * side / size[camera->GetUseHorizontalViewAngle() ? 0 : 1];
  const double corner = 0.5 * perPixel * std::hypot(size[0], size[1]);
  return SeenBesideEye * perPixel * camera->GetClippingRange()[0] / (1.0 + corner);
}

// A mesh as an actor, which is kept as long as its prop has it, so that nothing is built anew.
class StandIn
{
public:
  StandIn()
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

}

//------------------------------------------------------------------------------
class vtkShadowScene::Internals
{
public:
  std::vector<Light> Lights;
  std::vector<Prop> Props;
  std::map<vtkMapper*, KnownPlane> Planes;
  std::map<std::pair<vtkProp*, vtkMapper*>, KnownBounds> Bounds; // of what is sheared
  std::vector<std::uint64_t> CasterSignature;
  int TranslucentCasting = vtkShadowPass::TRANSLUCENT_NONE;
  vtkTimeStamp CasterTime;
  std::set<vtkProp*> Unbounded, UnboundedBefore; // of this frame, and of the last
  std::map<vtkProp*, StandIn> StandIns;          // by the prop that has it
  std::set<vtkProp*> Unfit, UnfitBefore;         // whose stand-in cannot cast
  vtkProp* Coarse = nullptr;                     // whose rounding is more than all else is large
  vtkProp* CoarseBefore = nullptr;               // of the last frame
  double CoarseRounding = 0.0, CoarseReach = 0.0;

  void GatherLights(vtkRenderer* renderer);
  void GatherProps(vtkRenderer* renderer);
  void StampCasters();
  void AddPiece(Prop& prop, vtkProp* leaf, vtkMatrix4x4* matrix);
  void AddStandIn();
  void FindWideFloor();
  void FindCoarse();
  FlatMesh PlaneOf(vtkMapper* mapper);
  void TightenBounds(Piece& piece);
};

//------------------------------------------------------------------------------
void vtkShadowScene::Internals::GatherLights(vtkRenderer* renderer)
{
  this->Lights.clear();
  vtkCamera* camera = renderer->GetActiveCamera();
  const glm::dmat4 viewFromWorld = vtkShadowMatrix::ToGlm(camera->GetModelViewTransformMatrix());
  const glm::dvec3 eyeWC(glm::inverse(viewFromWorld)[3]);
  const double sameAsEye =
    std::max(SameAsEye(renderer), std::ldexp(glm::length(eyeWC), -40)); // or is, to rounding

  vtkCollectionSimpleIterator it;
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal(it);
  while (vtkLight* source = lights->GetNextLight(it))
  {
    if (!source->GetSwitch())
    {
      continue;
    }
    Light light;
    light.Source = source;
    double position[3], focus[3];
    source->GetTransformedPosition(position);
    source->GetTransformedFocalPoint(focus);
    const glm::dvec3 positionWC(position[0], position[1], position[2]);
    const glm::dvec3 alongWC = glm::dvec3(focus[0], focus[1], focus[2]) - positionWC;

    const double length = glm::length(alongWC);
    light.Ray.position = positionWC;
    light.Ray.direction = length > 0.0 ? alongWC / length : glm::dvec3(0.0, 0.0, -1.0);
    light.Ray.coneAngle = source->GetConeAngle();
    light.Ray.kind = !source->GetPositional() ? vtkshadows::LightKind::Directional
      : source->GetConeAngle() < 90.0         ? vtkshadows::LightKind::Spot
                                              : vtkshadows::LightKind::Point;
    light.AtEye = source->LightTypeIsHeadlight() ||
      (source->GetPositional() && glm::length(positionWC - eyeWC) <= sameAsEye);
    this->Lights.push_back(light);
  }
}

//------------------------------------------------------------------------------
FlatMesh vtkShadowScene::Internals::PlaneOf(vtkMapper* mapper)
{
  const bool drawsSurfaces =
    (mapper->IsA("vtkPolyDataMapper") || mapper->IsA("vtkCompositePolyDataMapper")) &&
    !mapper->IsA("vtkOpenGLSphereMapper") && !mapper->IsA("vtkOpenGLStickMapper");
  vtkDataObject* data = drawsSurfaces ? mapper->GetInputDataObject(0, 0) : nullptr;
  if (!data)
  {
    return {};
  }
  KnownPlane& known = this->Planes[mapper];
  const vtkMTimeType stamp = std::max(DeepMTime(data), mapper->GetMTime());
  if (known.Stamp != stamp)
  {
    known.Stamp = stamp;
    known.Flat = FlatPlane(PointSetsOf(data));
  }
  return known.Flat;
}

//------------------------------------------------------------------------------
// A matrix that shears makes a box around the model lean far over the mesh within, which would have
// few of a map's texels. Then the bounds are those of its points.
void vtkShadowScene::Internals::TightenBounds(Piece& piece)
{
  vtkMapper* mapper = piece.Mapper;
  auto* mesh = mapper->IsA("vtkPolyDataMapper")
    ? vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0))
    : nullptr;
  if (!mesh || !mesh->GetPoints() || DrawsImpostors(piece) ||
    KeepsRightAngles(piece.WorldFromModel))
  {
    return;
  }
  KnownBounds& known = this->Bounds[{ piece.Prop, mapper }];
  const vtkMTimeType stamp = std::max(mesh->GetMTime(), mapper->GetMTime());
  if (known.Stamp != stamp || known.WorldFromModel != piece.WorldFromModel)
  {
    known = { stamp, piece.WorldFromModel, BoundsInWorld(mesh->GetPoints(), piece.WorldFromModel) };
  }
  const vtkshadows::BoxCorners tight = known.BoundsWC.Grown(piece.Rounding).Corners();
  if (!known.BoundsWC.isEmpty && SurfaceOf(tight) < SurfaceOf(piece.CornersWC))
  {
    piece.CornersWC = tight;
  }
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
  const FlatMesh flat = this->PlaneOf(mapper);
  if (glm::dvec3(flat.PlaneMC) != glm::dvec3(0.0))
  {
    piece.PlaneWC = TransformPlane(piece.WorldFromModel, flat.PlaneMC);
    piece.PlaneRounding = flat.Rounding * HeightScale(piece.WorldFromModel, flat.PlaneMC);
  }
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
  StandIn& standIn = this->StandIns[source];
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

//------------------------------------------------------------------------------
void vtkShadowScene::Internals::StampCasters()
{
  std::vector<std::uint64_t> signature;
  for (const Prop& prop : this->Props)
  {
    if (prop.Casts || prop.CastsRays)
    {
      Append(signature, prop.Source);
      Append(signature, prop.Casts); // not, if a stand-in does
      for (const Piece& piece : prop.Pieces)
      {
        signature.insert(signature.end(), piece.Signature.begin(), piece.Signature.end());
        Append(signature, piece.WideFloor); // then it is none
      }
    }
  }
  if (signature != this->CasterSignature || this->CasterTime.GetMTime() == 0)
  {
    this->CasterSignature.swap(signature);
    this->CasterTime.Modified();
  }
}

//------------------------------------------------------------------------------
vtkShadowScene::vtkShadowScene()
  : Internal(new Internals)
{
}

vtkShadowScene::~vtkShadowScene() = default;

//------------------------------------------------------------------------------
void vtkShadowScene::Gather(vtkRenderer* renderer)
{
  this->Internal->GatherLights(renderer);
  this->Internal->GatherProps(renderer);
  this->Internal->FindWideFloor();
  this->Internal->FindCoarse();
  this->Internal->StampCasters();
  for (vtkProp* prop : this->Internal->Unbounded)
  {
    if (this->Internal->UnboundedBefore.count(prop) == 0)
    {
      vtkWarningMacro("The prop "
        << prop->GetClassName() << " (" << prop
        << ") has bounds that are not finite, or too large for OpenGL's floats (from 1.8e19 on): "
           "what of it has none casts no shadow. Remove its points that are so far, or repair its "
           "matrix.");
    }
  }
  if (vtkProp* prop = this->Internal->Coarse; prop && prop != this->Internal->CoarseBefore)
  {
    vtkWarningMacro("The prop "
      << prop->GetClassName() << " (" << prop << ") reaches to " << this->Internal->CoarseReach
      << ", where floats are known to " << this->Internal->CoarseRounding
      << ", more than all other props together are large: most techniques can tell nothing of "
         "their shadows. Remove its points that are so far, or give it no part in shadows "
         "(CASTS_SHADOWS and RECEIVES_SHADOWS 0).");
  }
  for (vtkProp* prop : this->Internal->Unfit)
  {
    if (this->Internal->UnfitBefore.count(prop) == 0)
    {
      vtkWarningMacro("The prop "
        << prop->GetClassName() << " (" << prop
        << ") has a stand-in without triangles, or one that is infinite: it casts itself. Give "
           "SetStandIn a mesh with polygons or strips, or nullptr to remove it.");
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowScene::SetTranslucentCasting(int how)
{
  this->Internal->TranslucentCasting = how;
}

int vtkShadowScene::GetTranslucentCasting() const
{
  return this->Internal->TranslucentCasting;
}

//------------------------------------------------------------------------------
void vtkShadowScene::SetLightRadius(std::size_t light, double radius)
{
  this->Internal->Lights[light].Ray.radius = radius;
}

void vtkShadowScene::SetLightMaximumDistance(std::size_t light, double distance)
{
  this->Internal->Lights[light].MaximumDistance = distance;
}

//------------------------------------------------------------------------------
const std::vector<vtkShadowScene::Light>& vtkShadowScene::GetLights() const
{
  return this->Internal->Lights;
}

const std::vector<vtkShadowScene::Prop>& vtkShadowScene::GetProps() const
{
  return this->Internal->Props;
}

int vtkShadowScene::GetNumberOfLights() const
{
  return static_cast<int>(this->Internal->Lights.size());
}

int vtkShadowScene::GetNumberOfCasters() const
{
  int count = 0;
  for (const Prop& prop : this->Internal->Props)
  {
    count += prop.CastsRays ? 1 : 0; // one with a stand-in once
  }
  return count;
}

int vtkShadowScene::GetNumberOfReceivers() const
{
  int count = 0;
  for (const Prop& prop : this->Internal->Props)
  {
    count += prop.Receives ? 1 : 0;
  }
  return count;
}

vtkMTimeType vtkShadowScene::GetCasterStamp() const
{
  return this->Internal->CasterTime.GetMTime();
}

//------------------------------------------------------------------------------
void vtkShadowScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLights: " << this->GetNumberOfLights() << "\n";
  os << indent << "NumberOfCasters: " << this->GetNumberOfCasters() << "\n";
  os << indent << "NumberOfReceivers: " << this->GetNumberOfReceivers() << "\n";
  os << indent << "CasterStamp: " << this->GetCasterStamp() << "\n";
}
