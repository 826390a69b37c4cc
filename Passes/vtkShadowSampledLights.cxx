#include "vtkShadowSampledLights.h"

#include "LightSamples.h"
#include "vtkShadowMatrix.h"
#include "vtkShadowSampledLightsLookup.h"
#include "vtkShadowText.h"

#include "vtkShaderProgram.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{

using vtkshadows::BoxCorners;
using vtkshadows::LightKind;
using vtkshadows::LightView;
using vtkshadows::ShadowLight;

constexpr double RiseTexels = 0.5;

// Points on the rim of the disc that stand for all of it where it is fitted to, and how far out
// they stand, so that the rim lies within their hull.
constexpr int RimPoints = 8;
const double RimReach = 1.0 / std::cos(glm::radians(180.0 / RimPoints));

// As a sample sees the scene, so the light's middle sees a scene that is moved, or, under parallel
// rays, sheared.
glm::dmat4 Moved(const ShadowLight& light, const ShadowLight& sample, const glm::dvec3& anchorWC)
{
  if (light.kind != LightKind::Directional)
  {
    return glm::translate(glm::dmat4(1.0), light.position - sample.position);
  }
  const glm::dvec3 lean =
    sample.direction / glm::dot(sample.direction, light.direction) - light.direction;
  glm::dmat4 shear(1.0);
  for (int i = 0; i < 3; ++i)
  {
    shear[i] -= glm::dvec4(lean * light.direction[i], 0.0);
  }
  shear[3] = glm::dvec4(lean * glm::dot(anchorWC, light.direction), 1.0);
  return shear;
}

std::vector<ShadowLight> Rim(const ShadowLight& light, const glm::dvec3& towardWC)
{
  // Two samples lie across the middle from each other: their difference spans the disc.
  const std::vector<ShadowLight> two = vtkshadows::SampleAreaLight(light, 2, towardWC);
  const bool isParallel = light.kind == LightKind::Directional;
  const glm::dvec3 across = isParallel
    ? two[1].direction / glm::dot(two[1].direction, light.direction) -
      two[0].direction / glm::dot(two[0].direction, light.direction)
    : two[1].position - two[0].position;
  const glm::dvec3 normal =
    light.kind == LightKind::Point ? light.TowardLight(towardWC) : light.direction;
  const glm::dvec3 u = glm::normalize(across), v = glm::cross(normal, u);
  std::vector<ShadowLight> rim;
  for (int i = 0; i < RimPoints; ++i)
  {
    const double angle = glm::radians(360.0 * i / RimPoints);
    const glm::dvec3 offset = light.radius * RimReach * (std::cos(angle) * u + std::sin(angle) * v);
    rim.push_back(light);
    rim.back().position += isParallel ? glm::dvec3(0.0) : offset;
    rim.back().direction = isParallel ? glm::normalize(light.direction + offset) : light.direction;
  }
  return rim;
}

// Every box as every one of `movements` moves it: copies of box i are at i, i + n, i + 2n, ...
std::vector<BoxCorners> Copies(
  const std::vector<BoxCorners>& boxes, const std::vector<glm::dmat4>& movements)
{
  std::vector<BoxCorners> copies;
  for (const glm::dmat4& movement : movements)
  {
    for (BoxCorners corners : boxes)
    {
      for (glm::dvec3& corner : corners)
      {
        corner = glm::dvec3(movement * glm::dvec4(corner, 1.0));
      }
      copies.push_back(corners);
    }
  }
  return copies;
}

glm::dvec3 CentreOf(const std::vector<BoxCorners>& boxes)
{
  glm::dvec3 low(boxes.front()[0]), high(low);
  for (const BoxCorners& corners : boxes)
  {
    for (const glm::dvec3& corner : corners)
    {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
  }
  return 0.5 * (low + high);
}

double ReachOf(const std::vector<BoxCorners>& boxes, const glm::dmat4& from)
{
  double reach = 0.0;
  for (const BoxCorners& corners : boxes)
  {
    for (const glm::dvec3& corner : corners)
    {
      reach = std::max(reach, glm::length(glm::dvec3(from * glm::dvec4(corner, 1.0))));
    }
  }
  return reach;
}

}

//------------------------------------------------------------------------------
void vtkShadowSampledLights::Fit(const vtkShadowFrame& frame, const std::vector<int>& lights,
  int samples, int resolution, double margin)
{
  this->Resolution = resolution;
  this->Lights.clear();
  this->Maps.clear();
  const std::vector<BoxCorners> receivers = vtkShadowReceiverCorners(*frame.Scene);
  const double share = margin / std::max(static_cast<double>(resolution), 4.0 * margin);
  for (const int light : lights)
  {
    this->FitOne(frame, frame.Scene->GetLights()[light], samples, share, receivers);
  }
}

//------------------------------------------------------------------------------
void vtkShadowSampledLights::FitOne(const vtkShadowFrame& frame,
  const vtkShadowScene::Light& source, int samples, double margin,
  const std::vector<BoxCorners>& receivers)
{
  const ShadowLight& light = source.Ray;
  Light fitted;
  fitted.IsParallel = light.kind == LightKind::Directional;
  fitted.Matrix = vtkShadowMapViews::LitEverywhere;
  std::vector<std::size_t> owners;
  const std::vector<BoxCorners> casters =
    vtkShadowMapViews::CastersOf(*frame.Scene, source, {}, receivers, owners);
  if (casters.empty() || receivers.empty())
  {
    this->Lights.push_back(fitted);
    return;
  }

  // One frustum, or one set of faces, that suits all samples: what the rim of the disc sees.
  const glm::dvec3 anchorWC = CentreOf(casters);
  const glm::dvec3 towardWC = CentreOf(receivers);
  std::vector<glm::dmat4> movements;
  double nearest = 0.0;
  for (const ShadowLight& sample : Rim(light, towardWC))
  {
    movements.push_back(Moved(light, sample, anchorWC));
  }
  ShadowLight widest = light;
  if (light.kind == LightKind::Spot)
  {
    // What is lit by the cone lies before the disc, and a sample may see it beyond the cone's side.
    for (const BoxCorners& corners : casters)
    {
      for (const glm::dvec3& corner : corners)
      {
        const double depth = glm::dot(corner - light.position, light.direction);
        nearest =
          &corners == &casters.front() && &corner == &corners[0] ? depth : std::min(nearest, depth);
      }
    }
    const double lean =
      nearest > 0.0 ? glm::degrees(std::atan(RimReach * light.radius / nearest)) : 90.0;
    if (light.coneAngle + lean < 89.0)
    {
      widest.coneAngle += lean;
    }
    else
    {
      widest.kind = LightKind::Point;
    }
  }
  const vtkshadows::LightViews views = vtkshadows::FitLightViews(
    widest, Copies(casters, movements), Copies(receivers, movements), margin);
  if (views.views.empty())
  {
    this->Lights.push_back(fitted);
    return;
  }

  // The axes of a view, or of the cube, about the light's middle or, of parallel rays, the anchor.
  glm::dmat4 axesFromWorld =
    views.isCube ? views.cubeFromWorld : views.views.front().view.viewFromWorld;
  glm::dvec3 anchor(0.0);
  if (fitted.IsParallel)
  {
    anchor = glm::dvec3(axesFromWorld * glm::dvec4(anchorWC, 1.0));
    axesFromWorld = glm::translate(glm::dmat4(1.0), -anchor) * axesFromWorld;
  }
  const double unit = fitted.IsParallel
    ? ReachOf(casters, axesFromWorld)
    : vtkShadowMapViews::RoundingReach(axesFromWorld * glm::inverse(frame.ViewFromWorld),
        vtkShadowMapViews::FarthestIn(frame.ViewFromWorld, casters));
  glm::dmat4 matrix = axesFromWorld * glm::inverse(frame.ViewFromWorld) / unit;
  matrix[3][3] = 0.0; // what is lit everywhere has 1
  fitted.Matrix = vtkShadowMatrix::ToFloats(matrix);

  const std::vector<ShadowLight> lights = vtkshadows::SampleAreaLight(light, samples, towardWC);
  for (const ShadowLight& sample : lights)
  {
    const glm::dmat4 moved = Moved(light, sample, anchorWC);
    // What a point moves by: all alike, or a unit before the anchor's plane.
    const glm::dvec3 by = fitted.IsParallel
      ? glm::dvec3(moved * glm::dvec4(anchorWC - light.direction, 1.0)) -
        (anchorWC - light.direction)
      : -glm::dvec3(moved[3]) / unit;
    const glm::dvec3 place(axesFromWorld * glm::dvec4(by, 0.0));
    fitted.Places.push_back({ static_cast<float>(place.x), static_cast<float>(place.y),
      static_cast<float>(place.z), 0.0f });
  }

  fitted.LayersPerSample = static_cast<int>(views.views.size());
  fitted.Faces.assign(views.isCube ? 6 : 1, Face{ {}, { 0.0f, 0.0f, -1.0f, 0.0f } });
  const int firstLayer = this->NumberOfMaps();
  for (std::size_t k = 0; k < views.views.size(); ++k)
  {
    const vtkshadows::FittedLightView& seen = views.views[k];
    const LightView& view = seen.view;
    const glm::dmat4 map =
      vtkShadowMatrix::MapFromClip(this->Resolution, this->Resolution) * view.clipFromView;
    // The coarser of a texel's sides counts.
    const double width =
      this->Resolution * std::min(1.0, view.clipFromView[1][1] / view.clipFromView[0][0]);
    const double slack =
      vtkShadowMapViews::DepthSlack(map * (view.viewFromWorld * glm::inverse(frame.ViewFromWorld)),
        view, std::max(static_cast<int>(width), 1), RiseTexels,
        vtkShadowMapViews::FarthestIn(frame.ViewFromWorld, casters));
    Face& face = fitted.Faces[views.isCube ? seen.face : 0];
    const double step = fitted.LayersPerSample;
    const double layer = firstLayer + static_cast<double>(k);
    const auto put = [](std::array<float, 4>& to, double x, double y, double z, double w)
    {
      to = { static_cast<float>(x), static_cast<float>(y), static_cast<float>(z),
        static_cast<float>(w) };
    };
    if (fitted.IsParallel)
    {
      put(face.ScaleAndCentre, map[0][0] * unit, map[1][1] * unit, map[3][0] + map[0][0] * anchor.x,
        map[3][1] + map[1][1] * anchor.y);
      put(face.DepthAndLayer, map[3][2] - slack + map[2][2] * anchor.z, map[2][2] * unit, layer,
        step);
    }
    else
    {
      put(face.ScaleAndCentre, map[0][0], map[1][1], -map[2][0], -map[2][1]);
      put(face.DepthAndLayer,
        -map[2][2] - vtkShadowMapViews::PerspectiveRounding * std::abs(map[2][2]),
        (map[3][2] - slack) / unit, layer, step);
    }
  }

  for (const ShadowLight& sample : lights)
  {
    const glm::dmat4 moved = Moved(light, sample, anchorWC);
    for (const vtkshadows::FittedLightView& seen : views.views)
    {
      Map placed;
      placed.Sample = sample;
      placed.View.View = seen.view;
      // Views are rigid: a shear goes with the projection.
      const glm::dmat4& view = seen.view.viewFromWorld;
      if (fitted.IsParallel)
      {
        placed.View.View.clipFromView = seen.view.clipFromView * view * moved * glm::inverse(view);
      }
      else
      {
        placed.View.View.viewFromWorld = view * moved;
      }
      placed.View.CasterStamp = frame.Scene->GetCasterStamp();
      placed.View.Face = seen.face;
      placed.View.Layer = this->NumberOfMaps();
      std::vector<std::size_t>& drawn = placed.View.Casters;
      for (const std::size_t copy : seen.casters)
      {
        drawn.push_back(owners[copy % owners.size()]);
      }
      std::sort(drawn.begin(), drawn.end());
      drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
      this->Maps.push_back(placed);
    }
  }
  this->Lights.push_back(fitted);
}

//------------------------------------------------------------------------------
void vtkShadowSampledLights::DrawStale(const Draw& draw)
{
  for (std::size_t i = 0; i < this->Maps.size(); ++i)
  {
    const Map& map = this->Maps[i];
    if (i >= this->Drawn.size() || !this->Drawn[i].DrawsAs(map.View))
    {
      draw(map.Sample, map.View);
      this->Drawn.resize(std::max(this->Drawn.size(), i + 1));
      this->Drawn[i] = map.View;
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkShadowSampledLights::Function(int light) const
{
  const Light& sampled = this->Lights[light];
  const bool isCube = sampled.Faces.size() > 1;
  return std::string("shadowSampled") +
    (sampled.IsParallel ? "Parallel"
        : isCube        ? "Cube"
                        : "View");
}

std::string vtkShadowSampledLights::Shape() const
{
  std::string shape = std::to_string(this->Resolution);
  for (std::size_t i = 0; i < this->Lights.size(); ++i)
  {
    shape += " " + this->Function(static_cast<int>(i));
  }
  return shape;
}

//------------------------------------------------------------------------------
std::string vtkShadowSampledLights::Declarations(const std::string& shared) const
{
  using vtkShadowText::Define;
  return this->Lights.empty()
    ? std::string()
    : Define("SHADOW_SAMPLED_MAP_WIDTH", std::to_string(this->Resolution)) +
      Define("SHADOW_SAMPLED_MAP_HEIGHT", std::to_string(this->Resolution)) +
      Define("SHADOW_SAMPLED_LIGHTS", std::to_string(this->Lights.size())) +
      vtkShadowText::Replaced(vtkShadowText::Replaced(shared, "shadowDepthMap", "shadowSampledMap"),
        "SHADOW_DEPTH_MAP", "SHADOW_SAMPLED_MAP") +
      vtkShadowSampledLightsLookup;
}

//------------------------------------------------------------------------------
void vtkShadowSampledLights::UploadRows(vtkOpenGLRenderWindow* window)
{
  std::vector<float> rows;
  const auto add = [&rows](const std::array<float, 4>& row)
  { rows.insert(rows.end(), row.begin(), row.end()); };
  this->Headers.clear();
  for (const Light& light : this->Lights)
  {
    const float faces = static_cast<float>(rows.size() / 4);
    for (const Face& face : light.Faces)
    {
      add(face.ScaleAndCentre);
      add(face.DepthAndLayer);
    }
    this->Headers.push_back({ faces, static_cast<float>(rows.size() / 4),
      static_cast<float>(light.Places.size()), 0.0f });
    std::for_each(light.Places.begin(), light.Places.end(), add);
  }
  if (!this->Lights.empty() && rows.empty())
  {
    rows.resize(4); // none is read, but its sampler must name a texture of its kind
  }
  this->Rows.Keep(window, 4, rows);
}

//------------------------------------------------------------------------------
void vtkShadowSampledLights::SetParameters(vtkShaderProgram* program) const
{
  if (this->Lights.empty())
  {
    return;
  }
  program->SetUniform4fv("shadowSampledLights", static_cast<int>(this->Headers.size()),
    reinterpret_cast<const float(*)[4]>(this->Headers.data()));
  program->SetUniformi("shadowSampledMaps", this->Textures.Unit());
  program->SetUniformi("shadowSampledRows", this->Rows.Unit());
}

//------------------------------------------------------------------------------
void vtkShadowSampledLights::Activate()
{
  this->Textures.Activate();
  this->Rows.Activate(); // where there are any
}

void vtkShadowSampledLights::Deactivate()
{
  this->Rows.Deactivate();
  this->Textures.Deactivate();
}

void vtkShadowSampledLights::Release()
{
  this->Textures.Release();
  this->Rows.Release();
  this->ForgetMaps();
}
