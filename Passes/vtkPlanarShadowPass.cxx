#include "vtkPlanarShadowPass.h"

#include "LightSamples.h"
#include "PlanarProjection.h"
#include "ShadowPlateaus.h"
#include "ShadowVolume.h"
#include "vtkPlanarShadowCanvas.h"
#include "vtkPlanarShadowPassLookup.h"
#include "vtkShadowByPiece.h"
#include "vtkShadowCasterMesh.h"
#include "vtkShadowEye.h"
#include "vtkShadowHiddenFaces.h"
#include "vtkShadowMatrix.h"
#include "vtkShadowPlanes.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowTextureArray.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>

vtkStandardNewMacro(vtkPlanarShadowPass);

namespace
{

using vtkshadows::BoxCorners;
using vtkshadows::LightView;
using vtkshadows::PlanarThrow;
using vtkshadows::ShadowLight;

// Sample lights that tell how wide a penumbra is, and the fewest that make one.
constexpr int ProbingSamples = 16;
constexpr int FewestSamples = 4;

// A directional light lower than this over a plane, as a sine, lies in it.
constexpr double LowestLight = 1.0 / (1 << 24);

// How near to a vertex a lamp stands on it, in roundings of the floats that are drawn.
constexpr double OnVertex = 16.0;

// Planes that the float of a pixel can tell apart.
constexpr std::size_t MostBits = 24;

// Texels left free on each side of a plane's texture.
constexpr double MarginTexels = 2.0;

// A height, in roundings, at which no receiver lies on a plane.
constexpr double OffEveryPlane = 2.0;

// The shadow of one light on one plane, before anything is drawn.
struct Shadow
{
  int Slot = 0;
  std::size_t Plane = 0;
  const ShadowLight* Light = nullptr;
  glm::dvec4 PlaneWC{ 0.0 }; // toward the light
  std::vector<PlanarThrow> Throws;
  std::vector<std::size_t> Casters;                 // props
  std::vector<const vtkShadowScene::Piece*> Pieces; // of them
  std::vector<BoxCorners> CasterCorners;
  glm::dvec3 CentreWC{ 0.0 }; // of the casters
  glm::dvec3 FootWC{ 0.0 };   // of the receivers
  double Highest = 0.0;       // of them, over the plane
};

// The `count` shadows that stand for a light on a plane; one, if it is hard or softened otherwise.
std::vector<PlanarThrow> ThrowsOf(const Shadow& shadow, int count, int method)
{
  const ShadowLight& light = *shadow.Light;
  const glm::dvec4 lightWC = vtkshadows::HomogeneousLight(light);
  std::vector<PlanarThrow> throws;
  if (!(light.radius > 0.0) || method == vtkPlanarShadowPass::PLATEAUS)
  {
    throws.push_back({ lightWC, 0.0 });
    return throws;
  }
  if (method == vtkPlanarShadowPass::SAMPLE_LIGHTS)
  {
    for (const ShadowLight& sample : vtkshadows::SampleAreaLight(light, count, shadow.FootWC))
    {
      throws.push_back({ vtkshadows::HomogeneousLight(sample), 0.0 });
    }
    return throws;
  }
  // A plane raised by o drops the shadow of a point, r to the side of the light's foot, by o r / (H
  // - h) toward it (H and h the heights of light and point); a light of radius R moved to the side
  // moves it by R h / (H - h). Likewise for a direction, with r / (H - h) its tangent.
  const glm::dvec3 normal(shadow.PlaneWC);
  const double height =
    std::max(vtkshadows::HeightOver(shadow.PlaneWC, glm::dvec4(shadow.CentreWC, 1.0)), 0.0);
  const glm::dvec3 aside =
    lightWC.w == 0.0 ? glm::dvec3(lightWC) : shadow.CentreWC - glm::dvec3(lightWC);
  const double sideways = glm::length(aside - glm::dot(aside, normal) * normal);
  const double most = sideways > 0.0 ? std::min(light.radius * height / sideways, height) : height;
  for (int i = 0; i < count; ++i)
  {
    throws.push_back({ lightWC, most * ((2 * i + 1) / static_cast<double>(count) - 1.0) });
  }
  return throws;
}

// A lamp that stands on a caster's vertex sees the triangles there edge-on, and rounding would
// throw that vertex anywhere: a lamp that is `nearest` to one, or nearer, is put a little farther
// out of the surface.
glm::dvec3 OffVertices(const vtkShadowScene& scene, const glm::dvec3& lampWC, double nearest)
{
  glm::dvec3 outward(0.0), offVertex(0.0);
  for (const vtkShadowScene::Prop& prop : scene.GetProps())
  {
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      vtkshadows::Box box;
      box.Add(piece.CornersWC);
      if (!prop.Casts || !box.Grown(nearest).Holds(lampWC))
      {
        continue;
      }
      const vtkShadowCasterMesh caster = vtkShadowCasterMesh::Build(piece);
      const glm::dmat4 lampFromCaster =
        glm::translate(glm::dmat4(1.0), -lampWC) * piece.WorldFromModel * caster.ModelFromCaster;
      for (const vtkshadows::MeshPiece& body : caster.Mesh.pieces)
      {
        for (std::uint32_t i = body.first; i < body.last; ++i)
        {
          glm::dvec3 corners[3];
          const glm::dvec3* vertex = nullptr;
          for (int n = 0; n < 3; ++n)
          {
            const glm::dvec3 point(caster.Mesh.points[caster.Mesh.triangles[i][n]]);
            corners[n] = glm::dvec3(lampFromCaster * glm::dvec4(point, 1.0));
            vertex = glm::length(corners[n]) <= nearest ? &corners[n] : vertex;
          }
          const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
          const double length = glm::length(normal);
          if (vertex && length > 0.0)
          {
            offVertex -= *vertex;
            outward += (body.insideOut ? -1.0 : 1.0) * normal / length;
          }
        }
      }
    }
  }
  const double length = glm::length(outward);
  const double side = glm::dot(outward, offVertex) < 0.0 ? -1.0 : 1.0;
  return length > 0.0 ? lampWC + (side * 2.0 * nearest / length) * outward : lampWC;
}

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

// What a texture was drawn from: equal states give equal textures.
struct TextureState
{
  bool Drawn = false;
  glm::dvec4 PlaneWC{ 0.0 };
  glm::dvec2 Low{ 0.0 }, High{ 0.0 };
  int Texels[2] = { 0, 0 };
  std::vector<PlanarThrow> Throws;
  double Plateaus = 0.0; // the light's radius
  std::vector<std::size_t> Casters;
  vtkMTimeType CasterStamp = 0;

  bool operator==(const TextureState& other) const
  {
    const auto same = [](const PlanarThrow& a, const PlanarThrow& b)
    { return a.light == b.light && a.offset == b.offset; };
    return this->Drawn == other.Drawn && this->PlaneWC == other.PlaneWC && this->Low == other.Low &&
      this->High == other.High && this->Texels[0] == other.Texels[0] &&
      this->Texels[1] == other.Texels[1] && this->CasterStamp == other.CasterStamp &&
      this->Casters == other.Casters && this->Plateaus == other.Plateaus &&
      std::equal(
        this->Throws.begin(), this->Throws.end(), other.Throws.begin(), other.Throws.end(), same);
  }
};

}

//------------------------------------------------------------------------------
class vtkPlanarShadowPass::Internals
{
public:
  explicit Internals(vtkPlanarShadowPass* self)
    : Self(self)
  {
  }

  vtkPlanarShadowPass* Self;
  std::vector<glm::dvec4> Named;
  vtkShadowPlanes Planes;
  vtkShadowHiddenFaces HiddenFaces;
  vtkPlanarShadowCanvas Canvas, TextureCanvas;
  vtkShadowTextureArray Masks, Depths, PlanesOfPixels, Textures;
  std::vector<Shadow> Shadows;      // of this frame, by slot and plane
  std::vector<TextureState> States; // by slot, and within it by plane
  std::vector<vtkLight*> Lights;    // by slot, of the last frame
  std::vector<ShadowLight> Rays;    // the same, off vertices
  struct Place
  {
    glm::dvec3 AskedWC{ 0.0 }, MovedWC{ 0.0 };
    vtkMTimeType CasterStamp = 0;
  };
  std::vector<Place> Places;                    // the same
  vtkShadowByPiece<vtkShadowCasterMesh> Meshes; // of casters with plateaus
  int NumberOfSlots = 0;

  // From the eye's view coordinates to the texture of a slot on a plane: x and y of its sides, z
  // its layer, and w 1; or w the height over the plane, where a prop lies on several.
  std::vector<glm::dmat4> TextureFromView, AnyTextureFromView;
  std::array<float, 16> LookupMatrix; // as it was last asked for
  std::size_t MostPlanesOfProp = 1;

  LightView Eye;
  glm::dmat4 ClipFromWorld{ 1.0 };
  glm::dvec4 EyeWC{ 0.0 }; // homogeneous: a parallel eye is a direction
  int Marked = -1;         // the plane whose pixels the canvas keeps to

  // Whether a light's visibility is the mean of several shadows.
  bool IsSum(const ShadowLight& light) const
  {
    return light.radius > 0.0 && this->Self->SoftMethod != PLATEAUS;
  }
  // A power of two for a plane, exact with others in the sum of a float.
  static float BitOf(std::size_t plane)
  {
    return std::ldexp(1.0f, static_cast<int>(plane % MostBits));
  }
  std::size_t LayerOf(int slot, std::size_t plane) const
  {
    return static_cast<std::size_t>(slot) * this->Planes.Get().size() + plane;
  }
  void SetEye(const vtkShadowFrame& frame);
  std::size_t FindShadows(const vtkShadowFrame& frame, const std::vector<int>& lights);
  void FindCasters(const vtkShadowFrame& frame, Shadow& shadow);
  void ChooseThrows(Shadow& shadow, const glm::dmat4& clipFromWorld, int width, int height);
  bool UpdateMasks(const vtkShadowFrame& frame, bool anySoft);
  void MarkPlane(const vtkShadowFrame& frame, std::size_t plane, bool isOnlyOne);
  bool UpdateTextures(const vtkShadowFrame& frame, int side, bool anySoft);
  void UpdateTexture(const vtkShadowFrame& frame, Shadow& shadow);
  template <typename Mark>
  void Draw(const vtkShadowFrame& frame, vtkPlanarShadowCanvas& canvas, const Shadow& shadow,
    const glm::dmat4& clipFromWorld, bool isMirrored, const Mark& mark);
  void DrawPlateaus(const vtkShadowFrame& frame, vtkPlanarShadowCanvas& canvas,
    const Shadow& shadow, const glm::dmat4& clipFromWorld);
};

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::Internals::SetEye(const vtkShadowFrame& frame)
{
  std::vector<BoxCorners> receivers;
  for (const vtkShadowPlanes::Plane& plane : this->Planes.Get())
  {
    receivers.insert(receivers.end(), plane.Corners.begin(), plane.Corners.end());
  }
  this->Eye = vtkShadowEyeOf(frame, receivers);
  this->ClipFromWorld = this->Eye.clipFromView * this->Eye.viewFromWorld;
}

//------------------------------------------------------------------------------
vtkPlanarShadowPass::vtkPlanarShadowPass()
  : Internal(new Internals(this))
{
}

vtkPlanarShadowPass::~vtkPlanarShadowPass() = default;

//------------------------------------------------------------------------------
bool vtkPlanarShadowPass::AddPlane(double nx, double ny, double nz, double offset)
{
  // Scaled first, so that a very short or long normal keeps its digits.
  const double largest = std::max({ std::abs(nx), std::abs(ny), std::abs(nz) });
  const glm::dvec3 normal = glm::dvec3(nx, ny, nz) / largest;
  const double length = glm::length(normal);
  const glm::dvec4 plane(normal / length, offset / largest / length);
  if (!(largest > 0.0) || !std::isfinite(length) || !std::isfinite(plane.w))
  {
    vtkErrorMacro("AddPlane(" << nx << ", " << ny << ", " << nz << ", " << offset
                              << "): the normal has no direction, or a number is not finite. Give "
                                 "a normal of any length but 0.");
    return false;
  }
  this->Internal->Named.push_back(plane);
  this->Modified();
  return true;
}

void vtkPlanarShadowPass::RemoveAllPlanes()
{
  this->Internal->Named.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::SetSoftMethod(int method)
{
  if (method < SAMPLE_LIGHTS || method > PLATEAUS)
  {
    vtkErrorMacro("SoftMethod " << method
                                << " is none of vtkPlanarShadowPass::SoftMethodType (0 to "
                                << PLATEAUS << "). It stays " << this->SoftMethod << ".");
    return;
  }
  if (method != this->SoftMethod)
  {
    this->SoftMethod = method;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::SetTextureResolution(int resolution)
{
  if (resolution < 1)
  {
    vtkErrorMacro("TextureResolution " << resolution
                                       << " is no size of a texture: give 1 or more texels. It "
                                          "stays "
                                       << this->TextureResolution << ".");
    return;
  }
  if (resolution != this->TextureResolution)
  {
    this->TextureResolution = resolution;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowPass::UpdateVisibility(
  const vtkShadowFrame& frame, const std::vector<int>& lights)
{
  Internals& my = *this->Internal;
  this->NumberOfThrows = 0;
  this->NumberOfDrawnCasters = 0;
  this->NumberOfCulledCasters = 0;
  const vtkShadowScene& scene = *frame.Scene;
  const glm::dmat4 worldFromView = glm::inverse(frame.ViewFromWorld);
  const bool isParallel = frame.Renderer->GetActiveCamera()->GetParallelProjection() != 0;
  my.EyeWC = isParallel ? worldFromView[2] : worldFromView[3];
  my.Planes.Find(scene, my.Named, this->AutomaticPlanes, my.EyeWC);
  const std::vector<vtkShadowPlanes::Plane>& planes = my.Planes.Get();
  const bool anyReceiver = std::any_of(planes.begin(), planes.end(),
    [](const vtkShadowPlanes::Plane& plane) { return !plane.Props.empty(); });
  my.SetEye(frame);
  my.HiddenFaces.BeginFrame(scene.GetProps());
  my.Meshes.BeginFrame(scene.GetProps());
  const std::size_t leftOut = my.FindShadows(frame, lights);
  this->WarnOnce(&my.Planes,
    !anyReceiver
      ? "No receiver lies in a plane: nothing takes a planar shadow. Add a floor, name a plane "
        "(AddPlane) that a receiver has a face on, or use another technique."
      : leftOut > 0 ? "Shadows fall on " + std::to_string(leftOut) + " more planes than the " +
        std::to_string(this->MaximumNumberOfPlanes) +
        " with the largest receivers, and are left out. Raise MaximumNumberOfPlanes, or use "
        "another technique."
                    : "");

  const bool anySoft = std::any_of(my.Shadows.begin(), my.Shadows.end(),
    [&my](const Shadow& shadow) { return my.IsSum(*shadow.Light); });
  const bool done = this->PlaneTextures
    ? my.UpdateTextures(
        frame, this->WithinDriver("TextureResolution", this->TextureResolution), anySoft)
    : my.UpdateMasks(frame, anySoft);
  this->WarnOnce(this,
    done ? ""
         : "The driver cannot hold masks of " + std::to_string(frame.Size[0]) + " x " +
        std::to_string(frame.Size[1]) + " pixels for " + std::to_string(lights.size()) +
        " lights, or the planes' textures: they are lit. Use a smaller window, fewer lights, or a "
        "lower TextureResolution.");
  return done;
}

//------------------------------------------------------------------------------
// Which lights throw what on which planes. Returns how many planes are left out.
std::size_t vtkPlanarShadowPass::Internals::FindShadows(
  const vtkShadowFrame& frame, const std::vector<int>& lights)
{
  const std::vector<vtkShadowPlanes::Plane>& planes = this->Planes.Get();
  const auto most = static_cast<std::size_t>(this->Self->MaximumNumberOfPlanes);
  std::vector<bool> isShadowed(planes.size(), false);
  std::size_t used = 0, leftOut = 0;
  this->Shadows.clear();
  this->Lights.clear();
  this->NumberOfSlots = static_cast<int>(lights.size());
  this->Rays.resize(lights.size());
  this->Places.resize(lights.size());
  for (std::size_t slot = 0; slot < lights.size(); ++slot)
  {
    const vtkShadowScene::Light& light = frame.Scene->GetLights()[lights[slot]];
    this->Lights.push_back(light.Source);
    this->Rays[slot] = light.Ray;
    Place& place = this->Places[slot];
    const vtkMTimeType stamp = frame.Scene->GetCasterStamp();
    if (light.Ray.kind != vtkshadows::LightKind::Directional &&
      (place.AskedWC != light.Ray.position || place.CasterStamp != stamp))
    {
      place = { light.Ray.position,
        OffVertices(*frame.Scene, light.Ray.position, OnVertex * this->Planes.Tolerance()), stamp };
    }
    this->Rays[slot].position = place.MovedWC;
  }
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    std::vector<Shadow> onPlane;
    for (int slot = 0; slot < this->NumberOfSlots; ++slot)
    {
      const glm::dvec4 lightWC = vtkshadows::HomogeneousLight(this->Rays[slot]);
      Shadow shadow;
      shadow.Slot = slot;
      shadow.Plane = i;
      shadow.Light = &this->Rays[slot];
      shadow.PlaneWC = vtkshadows::TurnedToLight(planes[i].PlaneWC, lightWC);
      shadow.FootWC = 0.5 * (planes[i].Bounds.minimum + planes[i].Bounds.maximum);
      const double lightHeight =
        vtkshadows::HeightOver(planes[i].OneSided ? planes[i].PlaneWC : shadow.PlaneWC, lightWC);
      const bool isLit = lightHeight > (lightWC.w == 0.0 ? LowestLight : this->Planes.Tolerance());
      // From the other side no light is seen on it. A texture is there for all who look.
      const bool isSeen =
        this->Self->PlaneTextures || vtkshadows::HeightOver(shadow.PlaneWC, this->EyeWC) > 0.0;
      if (planes[i].Props.empty() || !isLit || !isSeen)
      {
        continue;
      }
      this->FindCasters(frame, shadow);
      if (!shadow.Casters.empty())
      {
        onPlane.push_back(std::move(shadow));
      }
    }
    isShadowed[i] = !onPlane.empty() && used < most;
    used += isShadowed[i] ? 1 : 0;
    leftOut += !onPlane.empty() && !isShadowed[i] ? 1 : 0;
    if (isShadowed[i])
    {
      std::move(onPlane.begin(), onPlane.end(), std::back_inserter(this->Shadows));
    }
  }
  std::stable_sort(this->Shadows.begin(), this->Shadows.end(),
    [](const Shadow& a, const Shadow& b) { return a.Slot < b.Slot; });
  this->Planes.SetShadowed(*frame.Scene, isShadowed);
  return leftOut;
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::Internals::FindCasters(const vtkShadowFrame& frame, Shadow& shadow)
{
  const std::vector<vtkShadowScene::Prop>& props = frame.Scene->GetProps();
  const vtkShadowPlanes::Plane& plane = this->Planes.Get()[shadow.Plane];
  const glm::dvec4 lightWC = vtkshadows::HomogeneousLight(*shadow.Light);
  // A larger light throws shadows farther than its middle does.
  const bool isHard = !(shadow.Light->radius > 0.0);
  vtkshadows::Box box;
  for (std::size_t i = 0; i < props.size(); ++i)
  {
    bool casts = false;
    for (const vtkShadowScene::Piece& piece : props[i].Pieces)
    {
      double lowest = 0.0, highest = 0.0;
      vtkshadows::HeightsOver(shadow.PlaneWC, piece.CornersWC, lowest, highest);
      if (!props[i].Casts || !(highest > this->Planes.Tolerance()) ||
        this->Planes.LiesOn(piece, plane.PlaneWC) ||
        (isHard && !vtkshadows::ShadowMayReach(plane.Bounds, lightWC, piece.CornersWC)) ||
        (isHard && !this->Self->PlaneTextures &&
          !vtkshadows::ShadowMayBeSeen(this->ClipFromWorld, lightWC, piece.CornersWC)))
      {
        continue;
      }
      casts = true;
      shadow.Pieces.push_back(&piece);
      shadow.CasterCorners.push_back(piece.CornersWC);
      shadow.Highest = std::max(shadow.Highest, highest);
      box.Add(piece.CornersWC);
    }
    if (casts)
    {
      shadow.Casters.push_back(i);
    }
    else if (props[i].Casts)
    {
      ++this->Self->NumberOfCulledCasters;
    }
  }
  shadow.CentreWC = 0.5 * (box.minimum + box.maximum);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::Internals::ChooseThrows(
  Shadow& shadow, const glm::dmat4& clipFromWorld, int width, int height)
{
  const int method = this->Self->SoftMethod;
  shadow.Throws = ThrowsOf(shadow, ProbingSamples, method);
  if (shadow.Throws.size() == 1)
  {
    return;
  }
  const double widest = vtkshadows::WidestPenumbra(
    shadow.PlaneWC, shadow.Throws, clipFromWorld, width, height, shadow.CasterCorners);
  const int wanted = std::max(static_cast<int>(std::ceil(widest)), FewestSamples);
  shadow.Throws = ThrowsOf(shadow, std::min(wanted, this->Self->LightSamples), method);
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
  const glm::dvec4& planeWC = this->Planes.Get()[plane].PlaneWC;
  glm::dvec3 beneath, above;
  if (vtkshadows::DepthOnPlane(
        planeWC - rounding, this->ClipFromWorld, frame.Size[0], frame.Size[1], beneath) &&
    vtkshadows::DepthOnPlane(
      planeWC + rounding, this->ClipFromWorld, frame.Size[0], frame.Size[1], above))
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
template <typename Mark>
void vtkPlanarShadowPass::Internals::Draw(const vtkShadowFrame& frame,
  vtkPlanarShadowCanvas& canvas, const Shadow& shadow, const glm::dmat4& clipFromWorld,
  bool isMirrored, const Mark& mark)
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
bool vtkPlanarShadowPass::Internals::UpdateTextures(
  const vtkShadowFrame& frame, int side, bool anySoft)
{
  this->Masks.Release();
  this->Depths.Release();
  this->PlanesOfPixels.Release();
  this->Canvas.Release();
  const std::size_t planes = std::max<std::size_t>(this->Planes.Get().size(), 1);
  const std::size_t layers = static_cast<std::size_t>(std::max(this->NumberOfSlots, 1)) * planes;
  if (this->Textures.Reserve(
        frame.Window, vtkShadowTextureArray::Format::R8, side, side, static_cast<int>(layers)))
  {
    this->Textures.Smooth();
    this->States.clear();
  }
  if (!this->Textures.Id() || !this->TextureCanvas.Reserve(frame, side, side, anySoft))
  {
    return false;
  }
  this->States.resize(layers);
  // Lit: the corner of a layer is never drawn to.
  glm::dmat4 lit(0.0);
  lit[3] = { 0.0, 0.0, 0.0, 1.0 };
  this->TextureFromView.assign(layers, lit);
  lit[3].w = OffEveryPlane;
  this->AnyTextureFromView.assign(layers, lit);
  for (Shadow& shadow : this->Shadows)
  {
    this->UpdateTexture(frame, shadow);
  }
  this->MostPlanesOfProp = 1;
  for (const std::size_t i : this->Planes.ShadowedProps())
  {
    this->MostPlanesOfProp = std::max(this->MostPlanesOfProp,
      this->Planes.ShadowedPlanesOf(frame.Scene->GetProps()[i].Source)->size());
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::Internals::UpdateTexture(const vtkShadowFrame& frame, Shadow& shadow)
{
  const int side = this->Textures.Width();
  const vtkShadowPlanes::Plane& plane = this->Planes.Get()[shadow.Plane];
  const std::size_t layer = this->LayerOf(shadow.Slot, shadow.Plane);
  const vtkshadows::PlaneFrame onPlane(plane.PlaneWC);
  const int method = this->Self->SoftMethod == PLATEAUS ? SAMPLE_LIGHTS : this->Self->SoftMethod;
  shadow.Throws = ThrowsOf(shadow, ProbingSamples, method);

  // Where its receivers and the shadow meet.
  TextureState wanted;
  if (!vtkshadows::BoundsOnPlane(shadow.PlaneWC, onPlane, plane.Corners, shadow.CasterCorners,
        shadow.Throws, MarginTexels / side, wanted.Low, wanted.High))
  {
    return;
  }
  const glm::dvec2 size = wanted.High - wanted.Low;
  const double longer = std::max(size.x, size.y);
  for (int axis = 0; axis < 2; ++axis)
  {
    wanted.Texels[axis] =
      std::clamp(static_cast<int>(std::ceil(side * size[axis] / longer)), 1, side);
    wanted.High[axis] = wanted.Low[axis] + wanted.Texels[axis] * longer / side; // square texels
  }
  const glm::dmat4 clipFromWorld = onPlane.ClipFromWorld(wanted.Low, wanted.High);
  this->ChooseThrows(shadow, clipFromWorld, wanted.Texels[0], wanted.Texels[1]);
  wanted.Drawn = true;
  wanted.PlaneWC = shadow.PlaneWC;
  wanted.Throws = shadow.Throws;
  wanted.Plateaus = this->IsSum(*shadow.Light) ? 0.0 : shadow.Light->radius;
  wanted.Casters = shadow.Casters;
  wanted.CasterStamp = frame.Scene->GetCasterStamp();
  if (!(this->States[layer] == wanted))
  {
    this->TextureCanvas.KeepTo(wanted.Texels[0], wanted.Texels[1]);
    this->TextureCanvas.Begin(
      frame, this->Textures, static_cast<int>(layer), this->IsSum(*shadow.Light));
    this->TextureCanvas.MarkAll(frame);
    // It is looked at from where its normal points, whichever side the light is on.
    this->Draw(frame, this->TextureCanvas, shadow, clipFromWorld, shadow.PlaneWC != plane.PlaneWC,
      [&]() { this->TextureCanvas.MarkAll(frame); });
    this->TextureCanvas.End(frame);
    this->States[layer] = wanted;
    ++this->Self->NumberOfTextureBuilds;
  }

  // Clip space of the texture, to the share of its layer that it fills.
  const glm::dmat4 clipFromView = clipFromWorld * glm::inverse(frame.ViewFromWorld);
  const glm::dvec2 half =
    0.5 * glm::dvec2(wanted.Texels[0], wanted.Texels[1]) / static_cast<double>(side);
  const glm::dvec4 one(0.0, 0.0, 0.0, 1.0);
  glm::dmat4 textureFromView(0.0);
  textureFromView = glm::row(textureFromView, 0, half.x * (glm::row(clipFromView, 0) + one));
  textureFromView = glm::row(textureFromView, 1, half.y * (glm::row(clipFromView, 1) + one));
  textureFromView = glm::row(textureFromView, 2, static_cast<double>(layer) * one);
  this->TextureFromView[layer] = glm::row(textureFromView, 3, one);

  // Its height, in units of what positions in view coordinates are rounded by.
  double farthest = 0.0;
  for (const BoxCorners& corners : plane.Corners)
  {
    for (const glm::dvec3& corner : corners)
    {
      farthest =
        std::max(farthest, glm::length(glm::dvec3(frame.ViewFromWorld * glm::dvec4(corner, 1.0))));
    }
  }
  const double rounding = this->Planes.Tolerance() + std::ldexp(farthest, -20);
  const glm::dvec4 height =
    glm::dvec4(glm::dvec3(plane.PlaneWC), -plane.PlaneWC.w) * glm::inverse(frame.ViewFromWorld);
  this->AnyTextureFromView[layer] = glm::row(textureFromView, 3, height / rounding);
}

//------------------------------------------------------------------------------
std::string vtkPlanarShadowPass::GetLookupDeclarations() const
{
  const Internals& my = *this->Internal;
  return !this->PlaneTextures ? std::string()
                              : "#define SHADOW_PLANE_MATRICES " +
      std::to_string(my.MostPlanesOfProp * static_cast<std::size_t>(my.NumberOfSlots)) + "\n" +
      vtkPlanarShadowPassLookup;
}

std::string vtkPlanarShadowPass::GetLookupFunction(int, vtkProp*) const
{
  return this->Internal->MostPlanesOfProp > 1 ? "shadowPlaneTextures" : "shadowPlaneTexture";
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowPass::GetPlaneTexture(vtkLight* light, int plane, vtkImageData* texture)
{
  Internals& my = *this->Internal;
  const auto found = std::find(my.Lights.begin(), my.Lights.end(), light);
  const int planes = this->GetNumberOfPlanes();
  const std::size_t layer =
    static_cast<std::size_t>(found - my.Lights.begin()) * static_cast<std::size_t>(planes) +
    static_cast<std::size_t>(std::max(plane, 0));
  const bool exists = light && texture && found != my.Lights.end() && plane >= 0 &&
    plane < planes && layer < my.States.size() && my.States[layer].Drawn;
  std::vector<unsigned char> texels;
  if (!exists || !my.Textures.Download(static_cast<int>(layer), texels))
  {
    vtkErrorMacro("GetPlaneTexture(" << light << ", " << plane << ", " << texture
                                     << "): the last frame drew no such texture. It had " << planes
                                     << " planes; turn PlaneTextures on, give the light the "
                                        "technique \"planar\" and render.");
    return false;
  }
  const TextureState& state = my.States[layer];
  const int side = my.Textures.Width();
  texture->SetDimensions(state.Texels[0], state.Texels[1], 1);
  texture->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* out = static_cast<unsigned char*>(texture->GetScalarPointer());
  for (int row = 0; row < state.Texels[1]; ++row)
  {
    std::copy_n(texels.begin() + static_cast<std::ptrdiff_t>(row) * side, state.Texels[0],
      out + static_cast<std::ptrdiff_t>(row) * state.Texels[0]);
  }
  texture->GetPointData()->GetScalars()->SetName("Visibility");
  const vtkshadows::PlaneFrame onPlane(my.Planes.Get()[static_cast<std::size_t>(plane)].PlaneWC);
  const glm::dvec2 spacing =
    (state.High - state.Low) / glm::dvec2(state.Texels[0], state.Texels[1]);
  const glm::dvec2 first = state.Low + 0.5 * spacing;
  const glm::dvec3 originWC = onPlane.origin + first.x * onPlane.u + first.y * onPlane.v;
  texture->SetOrigin(originWC.x, originWC.y, originWC.z);
  texture->SetSpacing(spacing.x, spacing.y, 1.0);
  texture->SetDirectionMatrix(onPlane.u.x, onPlane.v.x, onPlane.normal.x, onPlane.u.y, onPlane.v.y,
    onPlane.normal.y, onPlane.u.z, onPlane.v.z, onPlane.normal.z);
  texture->Modified();
  return true;
}

//------------------------------------------------------------------------------
int vtkPlanarShadowPass::GetNumberOfPlanes() const
{
  return static_cast<int>(this->Internal->Planes.Get().size());
}

bool vtkPlanarShadowPass::GetPlane(int plane, double normalAndOffset[4]) const
{
  if (plane < 0 || plane >= this->GetNumberOfPlanes())
  {
    return false;
  }
  const glm::dvec4& planeWC = this->Internal->Planes.Get()[static_cast<std::size_t>(plane)].PlaneWC;
  for (int i = 0; i < 4; ++i)
  {
    normalAndOffset[i] = planeWC[i];
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowPass::HasVisibilityOf(vtkProp* prop) const
{
  return this->Internal->Planes.ShadowedPlanesOf(prop) != nullptr;
}

vtkMTimeType vtkPlanarShadowPass::GetReceiverStamp() const
{
  return this->Internal->Planes.ShadowedStamp();
}

//------------------------------------------------------------------------------
const float* vtkPlanarShadowPass::GetLookupMatrix(int slot, vtkProp* prop) const
{
  Internals& my = *this->Internal;
  my.LookupMatrix = my.MostPlanesOfProp > 1
    ? vtkShadowMatrix::ToFloats(glm::dmat4(1.0))
    : vtkShadowMatrix::ToFloats(
        my.TextureFromView[my.LayerOf(slot, my.Planes.ShadowedPlanesOf(prop)->front())]);
  return my.LookupMatrix.data();
}

const float* vtkPlanarShadowPass::GetLitMatrix() const
{
  // The corner of a layer is never drawn to; and no place is on a plane.
  static const float lit[16] = { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1 };
  return lit;
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::SetLookupParameters(vtkShaderProgram* program, vtkProp* prop)
{
  Internals& my = *this->Internal;
  if (!this->PlaneTextures || my.MostPlanesOfProp == 1)
  {
    return;
  }
  // Every slot's planes of this prop, one slot after the other.
  const std::vector<std::size_t>* planes = my.Planes.ShadowedPlanesOf(prop);
  const std::size_t count = planes ? planes->size() : 0;
  std::vector<float> matrices;
  for (int slot = 0; planes && slot < my.NumberOfSlots; ++slot)
  {
    for (const std::size_t plane : *planes)
    {
      const std::array<float, 16> matrix =
        vtkShadowMatrix::ToFloats(my.AnyTextureFromView[my.LayerOf(slot, plane)]);
      matrices.insert(matrices.end(), matrix.begin(), matrix.end());
    }
  }
  program->SetUniformi("shadowPlaneCount", static_cast<int>(count));
  if (!matrices.empty())
  {
    program->SetUniformMatrix4x4v(
      "shadowPlaneFromView", static_cast<int>(matrices.size() / 16), matrices.data());
  }
}

vtkShadowTextureArray* vtkPlanarShadowPass::GetTextures()
{
  return this->PlaneTextures ? &this->Internal->Textures : &this->Internal->Masks;
}

//------------------------------------------------------------------------------
vtkIdType vtkPlanarShadowPass::GetTextureMemory() const
{
  const Internals& my = *this->Internal;
  return static_cast<vtkIdType>(my.Masks.Bytes() + my.Depths.Bytes() + my.PlanesOfPixels.Bytes() +
    my.Textures.Bytes() + my.Canvas.Bytes() + my.TextureCanvas.Bytes());
}

vtkIdType vtkPlanarShadowPass::GetCasterMemory() const
{
  std::size_t bytes = 0;
  this->Internal->Meshes.ForEach(
    [&bytes](const vtkShadowCasterMesh& caster) { bytes += caster.Mesh.MemoryInBytes(); });
  return static_cast<vtkIdType>(bytes);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::ReleaseGraphicsResources(vtkWindow* w)
{
  Internals& my = *this->Internal;
  my.Canvas.Release();
  my.TextureCanvas.Release();
  my.Masks.Release();
  my.Depths.Release();
  my.PlanesOfPixels.Release();
  my.Textures.Release();
  my.States.clear();
  this->Superclass::ReleaseGraphicsResources(w);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Named planes: " << this->Internal->Named.size() << "\n";
  os << indent << "AutomaticPlanes: " << this->AutomaticPlanes << "\n";
  os << indent << "MaximumNumberOfPlanes: " << this->MaximumNumberOfPlanes << "\n";
  os << indent << "SoftMethod: " << this->SoftMethod << "\n";
  os << indent << "LightSamples: " << this->LightSamples << "\n";
  os << indent << "PlaneTextures: " << this->PlaneTextures << "\n";
  os << indent << "TextureResolution: " << this->TextureResolution << "\n";
  os << indent << "NumberOfPlanes: " << this->GetNumberOfPlanes() << "\n";
  os << indent << "NumberOfThrows: " << this->NumberOfThrows << "\n";
  os << indent << "NumberOfDrawnCasters: " << this->NumberOfDrawnCasters << "\n";
  os << indent << "NumberOfCulledCasters: " << this->NumberOfCulledCasters << "\n";
  os << indent << "NumberOfTextureBuilds: " << this->NumberOfTextureBuilds << "\n";
}
