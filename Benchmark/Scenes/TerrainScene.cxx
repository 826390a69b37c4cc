#include "SceneList.h"

#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace vtkshadows::scenes
{

namespace
{

const double Pi = std::acos(-1.0);

// Metres. UTM coordinates of the middle: float's steps are half a metre there.
constexpr double Width = 10'000.0;
const glm::dvec3 Middle(412'300.0, 5'411'700.0, 0.0);
constexpr double EyeHeight = 2.0;
constexpr double SunElevation = 12.0;

// Hills as a sum of waves by lot, on a grid: what stands on them stands on its triangles.
class Ground
{
public:
  explicit Ground(int cellsAlong)
    : cells(cellsAlong)
  {
    Lot any(29);
    constexpr int Count = 40;
    for (int i = 0; i < Count; ++i)
    {
      const double length = std::pow(10.0, any(2.2, 3.6)), turn = any(0.0, 2.0 * Pi);
      this->waves.push_back({ 2.0 * Pi / length * glm::dvec2(std::cos(turn), std::sin(turn)),
        any(0.0, 2.0 * Pi), 0.008 * length * any(0.4, 1.0), any(0.0, 1.0) < 0.3 });
    }
  }

  vtkSmartPointer<vtkPolyData> Mesh() const
  {
    std::vector<glm::dvec3> points;
    std::vector<glm::ivec3> triangles;
    const int side = this->cells + 1;
    for (int row = 0; row < side; ++row)
    {
      for (int column = 0; column < side; ++column)
      {
        points.push_back(Middle + this->Corner(column, row));
        if (row > 0 && column > 0)
        {
          const int at = row * side + column;
          triangles.emplace_back(at - side - 1, at - side, at);
          triangles.emplace_back(at - side - 1, at, at - 1);
        }
      }
    }
    return MakeTriangles(points, triangles);
  }

  // Of the triangle at a place relative to the middle.
  double Height(double x, double y) const
  {
    const double u = (x / Width + 0.5) * this->cells, v = (y / Width + 0.5) * this->cells;
    const int column = std::min(this->cells - 1, static_cast<int>(u));
    const int row = std::min(this->cells - 1, static_cast<int>(v));
    const double a = u - column, b = v - row;
    const double low = this->Corner(column, row).z, high = this->Corner(column + 1, row + 1).z;
    const double side = a > b ? this->Corner(column + 1, row).z : this->Corner(column, row + 1).z;
    return a > b ? low + a * (side - low) + b * (high - side)
                 : low + b * (side - low) + a * (high - side);
  }

private:
  struct Wave
  {
    glm::dvec2 number;
    double phase;
    double height;
    bool ridge;
  };

  glm::dvec3 Corner(int column, int row) const
  {
    const double x = Width * (double(column) / this->cells - 0.5);
    const double y = Width * (double(row) / this->cells - 0.5);
    double z = 0.0;
    for (const Wave& wave : this->waves)
    {
      const double s = std::sin(wave.number.x * x + wave.number.y * y + wave.phase);
      z += wave.height * (wave.ridge ? 1.0 - 2.0 * std::abs(s) : s);
    }
    return { x, y, z };
  }

  int cells;
  std::vector<Wave> waves;
};

// Where something stands: near the eye they are closer together.
glm::dvec2 Place(Lot& any)
{
  const double distance = std::pow(10.0, any(1.5, std::log10(0.48 * Width)));
  const double turn = any(0.0, 2.0 * Pi);
  return distance * glm::dvec2(std::cos(turn), std::sin(turn));
}

// A prism of `sides` sides, drawn together to a point if it is a tree; closed, and rooted below the
// ground.
void AppendPrism(const Ground& ground, const glm::dvec2& place, double radius, double height,
  double turn, int sides, bool pointed, std::vector<glm::dvec3>& points,
  std::vector<glm::ivec3>& triangles)
{
  const int first = static_cast<int>(points.size());
  const glm::dvec3 foot =
    Middle + glm::dvec3(place, ground.Height(place.x, place.y) - 0.5 * radius);
  const glm::dvec3 top = foot + glm::dvec3(0.0, 0.0, 0.5 * radius + height);
  points.push_back(foot);
  points.push_back(top);
  for (int i = 0; i < sides; ++i)
  {
    const double angle = turn + 2.0 * Pi * i / sides;
    const glm::dvec3 aside = radius * glm::dvec3(std::cos(angle), std::sin(angle), 0.0);
    points.push_back(foot + aside);
    if (!pointed)
    {
      points.push_back(top + aside);
    }
  }
  const int step = pointed ? 1 : 2;
  for (int i = 0; i < sides; ++i)
  {
    const int here = first + 2 + step * i, next = first + 2 + step * ((i + 1) % sides);
    triangles.emplace_back(first, next, here);
    if (pointed)
    {
      triangles.emplace_back(first + 1, here, next);
    }
    else
    {
      triangles.emplace_back(first + 1, here + 1, next + 1);
      triangles.emplace_back(here, next, next + 1);
      triangles.emplace_back(here, next + 1, here + 1);
    }
  }
}

}

void MakeTerrain(SceneInMaking& scene)
{
  const Ground ground(ScaledCells(400, scene.size.detail));
  AddSmooth(scene.renderer, ground.Mesh())->GetProperty()->SetColor(0.62, 0.66, 0.5);

  Lot any(31);
  std::vector<glm::dvec3> points;
  std::vector<glm::ivec3> triangles;
  for (int i = 0; i < 200; ++i)
  {
    AppendPrism(
      ground, Place(any), any(4.0, 9.0), any(4.0, 12.0), any(0.0, Pi), 4, false, points, triangles);
  }
  AddActor(scene.renderer, MakeTriangles(points, triangles))
    ->GetProperty()
    ->SetColor(0.85, 0.75, 0.65);
  points.clear();
  triangles.clear();
  for (int i = 0; i < 900; ++i)
  {
    const double height = any(4.0, 14.0);
    AppendPrism(
      ground, Place(any), 0.28 * height, height, any(0.0, Pi), 9, true, points, triangles);
  }
  AddActor(scene.renderer, MakeTriangles(points, triangles))
    ->GetProperty()
    ->SetColor(0.35, 0.5, 0.33);

  // The hills are open at their rim, and what stands on them is closed.
  scene.facts.closedCasters = false;
  scene.facts.facts.push_back({ "camera above ground", EyeHeight, "m" });
  scene.facts.facts.push_back({ "sun above horizon", SunElevation, "degrees" });
  scene.Add(AddSun(scene.renderer, -Toward(-70.0, SunElevation)), 0.00465);

  // The clipping range must reach from the grass at the eye's feet to the horizon.
  scene.renderer->SetNearClippingPlaneTolerance(1e-4);
  const glm::dvec3 eye = Middle + glm::dvec3(0.0, 0.0, ground.Height(0.0, 0.0) + EyeHeight);
  const glm::dvec3 focus = Middle + glm::dvec3(0.0, 40.0, ground.Height(0.0, 40.0) + EyeHeight);
  LookAt(scene.renderer, eye, focus);
  scene.facts.centre = focus;
  scene.facts.radius = 40.0;
}

}
