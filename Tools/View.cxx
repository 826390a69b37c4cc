#include "View.h"

#include "MeshLoader.h"

#include <vtkPolyData.h>
#include <vtkShadowFloor.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vtkshadows
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

// The fitted camera: degrees to the scene's right and above its level, and the share of the
// window's half that the meshes may fill, so that floor and shadow are seen around them.
constexpr double CameraAzimuth = 25.0;
constexpr double CameraElevation = 27.0;
constexpr double FilledShare = 0.68;

template <class Visit>
void ForEachPoint(const std::vector<Mesh>& meshes, Visit visit)
{
  for (const Mesh& mesh : meshes)
  {
    const vtkIdType count = mesh.triangles->GetNumberOfPoints();
    for (vtkIdType i = 0; i < count; ++i)
    {
      glm::dvec3 point;
      mesh.triangles->GetPoint(i, &point.x);
      visit(point);
    }
  }
}

// Any unit vector across the unit vector `axis`, the one nearest to `wanted` if that is not along
// it.
glm::dvec3 Across(const glm::dvec3& axis, const glm::dvec3& wanted, const glm::dvec3& otherwise)
{
  const bool along = std::abs(glm::dot(axis, wanted)) > 0.9;
  const glm::dvec3 start = along ? otherwise : wanted;
  return glm::normalize(start - glm::dot(start, axis) * axis);
}

bool IsGltf(const Mesh& mesh)
{
  const std::string& path = mesh.path;
  const std::size_t dot = path.rfind('.');
  return dot != std::string::npos && dot + 1 < path.size() && std::tolower(path[dot + 1]) == 'g';
}

// The planes of a view's sides, at slope `tangent` along one window axis, moved until they touch
// every point. Relative to an origin; x is along the window axis, z away from the viewer.
struct TouchingPlanes
{
  double tangent;
  double high = -Infinity; // of x - tangent*z
  double low = -Infinity;  // of -x - tangent*z

  void Add(double x, double z)
  {
    this->high = std::max(this->high, x - this->tangent * z);
    this->low = std::max(this->low, -x - this->tangent * z);
  }
  double Distance() const { return 0.5 * (this->high + this->low) / this->tangent; }
  double Middle() const { return 0.5 * (this->high - this->low); }
};

}

double SceneExtent::Size() const
{
  const glm::dvec3 sides = this->high - this->low;
  return std::max({ sides.x, sides.y, sides.z });
}

SceneAxes ChooseAxes(const std::optional<glm::dvec3>& up, const std::optional<CameraSpec>& camera,
  const std::vector<Mesh>& meshes)
{
  SceneAxes axes;
  if (up)
  {
    axes.up = *up;
  }
  else if (camera)
  {
    vtkShadowFloor::NearestAxis(&camera->up.x, &axes.up.x);
  }
  else if (std::all_of(meshes.begin(), meshes.end(), IsGltf))
  {
    axes.up = { 0.0, 1.0, 0.0 };
  }
  axes.right = Across(axes.up, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
  axes.forward = glm::cross(axes.up, axes.right);
  return axes;
}

SceneExtent MeasureExtent(const std::vector<Mesh>& meshes, const SceneAxes& axes)
{
  SceneExtent extent;
  extent.low = glm::dvec3(Infinity);
  extent.high = glm::dvec3(-Infinity);
  ForEachPoint(meshes,
    [&](const glm::dvec3& point)
    {
      const glm::dvec3 along(
        glm::dot(point, axes.right), glm::dot(point, axes.forward), glm::dot(point, axes.up));
      extent.low = glm::min(extent.low, along);
      extent.high = glm::max(extent.high, along);
    });
  const glm::dvec3 middle = 0.5 * (extent.low + extent.high);
  extent.center = middle.x * axes.right + middle.y * axes.forward + middle.z * axes.up;
  return extent;
}

CameraSpec FitCamera(const std::vector<Mesh>& meshes, const SceneAxes& axes, double aspect)
{
  const double azimuth = glm::radians(CameraAzimuth);
  const double elevation = glm::radians(CameraElevation);
  const glm::dvec3 level = std::cos(azimuth) * axes.forward - std::sin(azimuth) * axes.right;
  const glm::dvec3 view = std::cos(elevation) * level - std::sin(elevation) * axes.up;
  const glm::dvec3 right = glm::normalize(glm::cross(view, axes.up));
  const glm::dvec3 windowUp = glm::cross(right, view);

  // Move the view's four sides until they touch the meshes, each pair by itself.
  CameraSpec camera;
  const glm::dvec3 center = MeasureExtent(meshes, axes).center;
  const double tangent = FilledShare * std::tan(0.5 * glm::radians(camera.viewAngle));
  TouchingPlanes horizontal{ tangent * aspect };
  TouchingPlanes vertical{ tangent };
  ForEachPoint(meshes,
    [&](const glm::dvec3& point)
    {
      const glm::dvec3 offset = point - center;
      const double depth = glm::dot(offset, view);
      horizontal.Add(glm::dot(offset, right), depth);
      vertical.Add(glm::dot(offset, windowUp), depth);
    });

  const double distance = std::max(horizontal.Distance(), vertical.Distance());
  camera.focalPoint = center + horizontal.Middle() * right + vertical.Middle() * windowUp;
  camera.position = camera.focalPoint - distance * view;
  camera.up = axes.up;
  return camera;
}

LightSpec DefaultLight(const SceneAxes& axes)
{
  LightSpec light;
  light.direction = glm::normalize(0.55 * axes.right + 0.5 * axes.forward - axes.up);
  return light;
}

}
