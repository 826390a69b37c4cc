#include "vtkShadowTrianglePlaces.h"

#include "vtkShaderProgram.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using vtkshadows::LightView;

namespace
{

// From a view's coordinates, in which it looks along -z, to depths before it.
glm::dmat4 DepthFromView(double zeroDepth)
{
  glm::dmat4 m = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 1.0, -1.0));
  m[3][2] = -zeroDepth;
  return m;
}

// Depths before the light at which a view's map begins and ends.
void RangeOf(const LightView& view, double& nearDepth, double& farDepth)
{
  const double scale = view.clipFromView[2][2], offset = view.clipFromView[3][2];
  nearDepth = view.parallel ? (1.0 + offset) / scale : offset / (scale - 1.0);
  farDepth = view.parallel ? (offset - 1.0) / scale : offset / (scale + 1.0);
}

// The corners' unit of length, so that products of their coordinates are floats at every scale of
// the scene; a power of two, which rounds nothing.
double UnitOf(const vtkShadowMapSlot& slot)
{
  double nearDepth = 0.0, farDepth = 0.0;
  RangeOf(slot.Views.front().View, nearDepth, farDepth);
  const double length =
    slot.IsCube ? vtkShadowMapViews::FarthestIn(slot.CubeFromWorld, slot.Casters) : farDepth;
  return length > 0.0 && std::isfinite(length) ? std::ldexp(1.0, std::ilogb(length)) : 1.0;
}

glm::dmat4 InUnits(double unit)
{
  return glm::scale(glm::dmat4(1.0), glm::dvec3(1.0 / unit));
}

// Whether a prop lies wholly before a light with a position, and not so near that a projection
// overflows.
bool IsBefore(const LightView& view, const vtkShadowScene::Prop& prop)
{
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0.0;
  for (const vtkShadowScene::Piece& piece : prop.Pieces)
  {
    for (const glm::dvec3& corner : piece.CornersWC)
    {
      const double depth = -(view.viewFromWorld * glm::dvec4(corner, 1.0)).z;
      nearest = std::min(nearest, depth);
      farthest = std::max(farthest, depth);
    }
  }
  return nearest > 1e-4 * farthest;
}

}

//------------------------------------------------------------------------------
glm::dmat4 vtkShadowTrianglePlaces::LightFromWorld(
  const vtkShadowMapViews& views, const vtkShadowMapSlot& slot) const
{
  if (slot.IsCube)
  {
    return InUnits(UnitOf(slot)) * slot.CubeFromWorld;
  }
  const LightView& view = slot.Views.front().View;
  if (this->Written.Direct)
  {
    return views.MapOf(view) * view.viewFromWorld;
  }
  double nearDepth = 0.0, farDepth = 0.0;
  RangeOf(view, nearDepth, farDepth);
  return InUnits(UnitOf(slot)) * DepthFromView(nearDepth) * view.viewFromWorld;
}

//------------------------------------------------------------------------------
void vtkShadowTrianglePlaces::Update(const std::vector<vtkShadowScene::Prop>& props,
  const vtkShadowMapViews& views, const std::vector<std::vector<std::size_t>>& propsOf,
  bool hasPlain)
{
  Shape shape;
  shape.HasPlain = hasPlain;
  for (std::size_t i = 0; i < propsOf.size(); ++i)
  {
    const vtkShadowMapSlot& slot = views.GetSlots()[i];
    shape.Direct = shape.Direct && !slot.IsCube && slot.Views.size() <= 1;
    for (const vtkShadowMapView& view : slot.Views)
    {
      shape.Layers = std::max(shape.Layers, static_cast<std::size_t>(view.Layer) + 1);
    }
    if (shape.Direct && !slot.Views.empty() && !slot.Views.front().View.parallel)
    {
      for (const std::size_t prop : propsOf[i])
      {
        shape.Direct = shape.Direct && IsBefore(slot.Views.front().View, props[prop]);
      }
    }
  }
  shape.Layers = std::max(shape.Layers, this->Written.Layers);
  this->ShaderChanged = this->ShaderChanged || !(shape == this->Written);
  this->Written = shape;
  if (!this->Written.Direct)
  {
    this->UpdatePlaces(views);
  }
}

//------------------------------------------------------------------------------
void vtkShadowTrianglePlaces::UpdatePlaces(const vtkShadowMapViews& views)
{
  this->Places.assign(this->Written.Layers, {});
  for (const vtkShadowMapSlot& slot : views.GetSlots())
  {
    for (const vtkShadowMapView& placed : slot.Views)
    {
      const LightView& view = placed.View;
      const glm::dmat4& clip = view.clipFromView;
      const glm::dvec2 half = 0.5 * glm::dvec2(views.WidthOf(view), views.HeightOf(view));
      const glm::dvec2 perLength = half * glm::dvec2(clip[0][0], clip[1][1]);
      glm::dvec2 axis = half *
        (view.parallel ? glm::dvec2(1.0 + clip[3][0], 1.0 + clip[3][1])
                       : glm::dvec2(1.0 - clip[2][0], 1.0 - clip[2][1]));
      double nearDepth = 0.0, farDepth = 0.0, zeroDepth = 0.0, begin = 0.0;
      RangeOf(view, nearDepth, farDepth);
      if (slot.IsCube)
      {
        begin = nearDepth;
      }
      else
      {
        RangeOf(slot.Views.front().View, zeroDepth, begin);
        begin = nearDepth - zeroDepth;
      }
      if (view.parallel)
      {
        // Views of one light differ by where they stand.
        const glm::dvec3 moved((DepthFromView(zeroDepth) * view.viewFromWorld *
          glm::inverse(this->LightFromWorld(views, slot)))[3]);
        axis += perLength * glm::dvec2(moved);
        begin -= moved.z;
      }
      const double unit = UnitOf(slot);
      const auto inUnits = [unit](double length) { return static_cast<float>(length / unit); };
      // A perspective map's texels are as wide as depths are long: their ratio has no unit.
      const glm::dvec2 texel = 1.0 / (view.parallel ? unit * perLength : perLength);
      Place& place = this->Places[placed.Layer];
      place.Plane = { static_cast<float>(axis.x), static_cast<float>(axis.y),
        static_cast<float>(texel.x), static_cast<float>(texel.y) };
      place.Depth = { inUnits(begin), inUnits(farDepth - nearDepth), inUnits(nearDepth),
        view.parallel ? 0.0f : inUnits(farDepth) };
      place.Other = { static_cast<float>(placed.Face), inUnits(zeroDepth) };
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkShadowTrianglePlaces::Declarations() const
{
  return "#define SHADOW_DEPTH_MAP_PLACES " + std::to_string(this->Written.Layers) + "\n" +
    (this->Written.Direct ? "#define SHADOW_DEPTH_MAP_DIRECT\n" : "") +
    (this->Written.HasPlain ? "#define SHADOW_DEPTH_MAP_PLAIN\n" : "");
}

bool vtkShadowTrianglePlaces::TakeShaderChange()
{
  const bool changed = this->ShaderChanged;
  this->ShaderChanged = false;
  return changed;
}

//------------------------------------------------------------------------------
void vtkShadowTrianglePlaces::SetParameters(vtkShaderProgram* program) const
{
  if (this->Written.Direct)
  {
    return;
  }
  std::vector<float> planes, depths, others;
  for (const Place& place : this->Places)
  {
    planes.insert(planes.end(), place.Plane.begin(), place.Plane.end());
    depths.insert(depths.end(), place.Depth.begin(), place.Depth.end());
    others.insert(others.end(), place.Other.begin(), place.Other.end());
  }
  const int count = static_cast<int>(this->Places.size());
  program->SetUniform4fv("shadowDepthMapPlanes", count, planes.data());
  program->SetUniform4fv("shadowDepthMapDepths", count, depths.data());
  program->SetUniform2fv("shadowDepthMapOthers", count, others.data());
}
