#include "vtkPlanarShadowPassInternals.h"

#include "LightSamples.h"
#include "ShadowVolume.h"
#include "vtkShadowEye.h"

#include "vtkLight.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{

using vtkshadows::BoxCorners;
using vtkshadows::PlanarThrow;
using vtkshadows::ShadowLight;

// The fewest sample lights that make a penumbra.
constexpr int FewestSamples = 4;

// A directional light lower than this over a plane, as a sine, lies in it.
constexpr double LowestLight = 1.0 / (1 << 24);

// How near to a vertex a lamp stands on it, in roundings of the floats that are drawn.
constexpr double OnVertex = 16.0;

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

}

//------------------------------------------------------------------------------
// The `count` shadows that stand for a light on a plane; one, if it is hard or softened otherwise.
std::vector<PlanarThrow> vtkPlanarShadowPass::Internals::ThrowsOf(
  const Shadow& shadow, int count, int method)
{
  const ShadowLight& light = *shadow.Light;
  const glm::dvec4 lightWC = vtkshadows::HomogeneousLight(light);
  std::vector<PlanarThrow> throws;
  if (!(light.radius > 0.0) || method == PLATEAUS)
  {
    throws.push_back({ lightWC, 0.0 });
    return throws;
  }
  if (method == SAMPLE_LIGHTS)
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
      if (!props[i].Casts || piece.WideFloor || !(highest > this->Planes.Tolerance()) ||
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
