#include "Extremes.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkSuperquadricSource.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <limits>
#include <utility>

namespace vtkshadows
{
namespace
{

constexpr double FloorHalf = 30.0; // farther than the plain view reaches
constexpr std::size_t Floor = 0, Ball = 1, Box = 2, Pillar = 3, Ring = 4;
const glm::dvec3 BallCentre(-1.1, -0.9, 0.9);
constexpr double BallRadius = 0.9;
const glm::dvec3 Middle(0.0, 0.0, 0.8);
const glm::dvec3 TowardSpot = glm::normalize(glm::dvec3(3.5, -3.0, 6.5) - Middle);

//------------------------------------------------------------------------------
// Meshes, with points in double.

// Its points taken through `to` in double, with its normals.
vtkSmartPointer<vtkPolyData> Moved(vtkPolyData* mesh, const glm::dmat4& to)
{
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    const glm::dvec4 at = to * glm::dvec4(p[0], p[1], p[2], 1.0);
    points->SetPoint(i, at.x, at.y, at.z);
  }
  moved->SetPoints(points);
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  if (!normals)
  {
    return moved;
  }
  const glm::dmat3 turn = glm::inverseTranspose(glm::dmat3(to));
  vtkNew<vtkFloatArray> turned;
  turned->SetNumberOfComponents(3);
  turned->SetNumberOfTuples(normals->GetNumberOfTuples());
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    double n[3];
    normals->GetTuple(i, n);
    const glm::dvec3 at = glm::normalize(turn * glm::dvec3(n[0], n[1], n[2]));
    turned->SetTuple3(i, at.x, at.y, at.z);
  }
  moved->GetPointData()->SetNormals(turned);
  return moved;
}

template <typename Source>
vtkSmartPointer<vtkPolyData> OutputOf(Source& source)
{
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeFloor(double half, double height = 0.0)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->SetOrigin(-half, -half, height);
  plane->SetPoint1(half, -half, height);
  plane->SetPoint2(-half, half, height);
  return OutputOf(plane);
}

vtkSmartPointer<vtkPolyData> MakeBall(const glm::dvec3& centre, double radius, int resolution = 64)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(centre.x, centre.y, centre.z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  return Moved(OutputOf(sphere), glm::dmat4(1.0));
}

// Its sides 1.4, 1.2 and 1.3, from the floor up, a little turned.
vtkSmartPointer<vtkPolyData> MakeBox()
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(-0.7, 0.7, -0.6, 0.6, 0.0, 1.3);
  const glm::dmat4 one(1.0);
  return Moved(OutputOf(cube),
    glm::rotate(glm::translate(one, glm::dvec3(-1.3, 1.3, 0.0)), glm::radians(25.0),
      glm::dvec3(0.0, 0.0, 1.0)));
}

vtkSmartPointer<vtkPolyData> MakePillar()
{
  vtkNew<vtkCylinderSource> cylinder; // along y
  cylinder->SetHeight(2.4);
  cylinder->SetRadius(0.4);
  cylinder->SetResolution(48);
  const glm::dmat4 one(1.0);
  return Moved(OutputOf(cylinder),
    glm::rotate(glm::translate(one, glm::dvec3(1.2, 1.3, 1.2)), glm::radians(90.0),
      glm::dvec3(1.0, 0.0, 0.0)));
}

vtkSmartPointer<vtkPolyData> MakeRing()
{
  vtkNew<vtkSuperquadricSource> torus;
  torus->ToroidalOn();
  torus->SetThickness(0.35);
  torus->SetSize(1.1);
  torus->SetThetaResolution(64);
  torus->SetPhiResolution(32);
  const glm::dmat4 one(1.0);
  return Moved(OutputOf(torus),
    glm::rotate(glm::translate(one, glm::dvec3(1.3, -0.9, 1.3)), glm::radians(35.0),
      glm::normalize(glm::dvec3(1.0, 0.4, 0.2))));
}

// A copy with `more` points and triangles among them appended; the old points keep their numbers.
vtkSmartPointer<vtkPolyData> WithTriangles(vtkPolyData* mesh, const std::vector<glm::dvec3>& more,
  const std::vector<std::array<vtkIdType, 3>>& triangles)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(mesh);
  vtkDataArray* normals = copy->GetPointData()->GetNormals();
  for (const glm::dvec3& p : more)
  {
    copy->GetPoints()->InsertNextPoint(p.x, p.y, p.z);
    if (normals)
    {
      normals->InsertNextTuple3(0.0, 0.0, 1.0);
    }
  }
  vtkNew<vtkCellArray> polys; // its own: of a mesh of strips alone VTK hands out one that is shared
  polys->DeepCopy(copy->GetPolys());
  for (const std::array<vtkIdType, 3>& t : triangles)
  {
    polys->InsertNextCell(3, t.data());
  }
  copy->SetPolys(polys);
  return copy;
}

// A wall of triangles 1 long and `width` wide, `count` of them side by side, about `centre`.
vtkSmartPointer<vtkPolyData> MakeSlivers(const glm::dvec3& centre, double width, int count)
{
  auto wall = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  for (int i = 0; i < count; ++i)
  {
    // Each from a little before the end of the last, so that it is a wall.
    const double x = centre.x + width * (i - 0.5 * count), y = centre.y;
    const vtkIdType first = points->InsertNextPoint(x, y, centre.z - 0.5);
    points->InsertNextPoint(x + width, y, centre.z - 0.5);
    points->InsertNextPoint(x + width, y, centre.z + 0.5);
    points->InsertNextPoint(x, y, centre.z + 0.5);
    polys->InsertNextCell({ first, first + 1, first + 2 });
    polys->InsertNextCell({ first, first + 2, first + 3 });
  }
  wall->SetPoints(points);
  wall->SetPolys(polys);
  return wall;
}

// The part's points through the inverse of a matrix that the actor is given: it looks the same.
void GiveMatrix(ExtremePart& part, const glm::dmat4& matrix)
{
  part.mesh = Moved(part.mesh, glm::inverse(matrix));
  part.sceneFromModel = matrix;
}

glm::dmat4 Sheared(double by)
{
  glm::dmat4 m(1.0);
  m[2][0] = by;
  m[1][0] = 0.5 * by;
  return m;
}

//------------------------------------------------------------------------------
// Lights.

ShadowLight SpotFrom(const glm::dvec3& position, const glm::dvec3& focus, double cone)
{
  ShadowLight light;
  light.kind = cone < 90.0 ? LightKind::Spot : LightKind::Point;
  light.position = position;
  light.direction = glm::normalize(focus - position);
  light.coneAngle = cone;
  return light;
}

ShadowLight Sun(const glm::dvec3& along)
{
  ShadowLight light;
  light.direction = glm::normalize(along);
  return light;
}

ShadowLight Lamp(const glm::dvec3& position)
{
  return SpotFrom(position, position - glm::dvec3(0.0, 0.0, 1.0), 180.0);
}

//------------------------------------------------------------------------------
// Cases.

std::string Text(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

class Cases
{
public:
  std::vector<ExtremeCase> all;

  ExtremeCase& Add(const std::string& kind, const std::string& value, bool looksPlain,
    const std::function<void(ExtremeScene&)>& change)
  {
    ExtremeCase added;
    added.kind = kind;
    added.value = value;
    added.looksPlain = looksPlain;
    added.change = change;
    this->all.push_back(added);
    return this->all.back();
  }
};

void AddPlacements(Cases& cases)
{
  for (const bool byMatrix : { false, true })
  {
    const std::string how = byMatrix ? " by matrix" : " by points";
    for (const double scale : { 1e-12, 1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9, 1e12 })
    {
      cases.Add("scale" + how, Text(scale), true,
        [=](ExtremeScene& scene)
        {
          scene.scale = scale;
          scene.byMatrix = byMatrix;
        });
    }
    // Times the still life's size.
    for (const double offset : { 1e3, 1e5, 1e6, 1e7, 1e8, 1e9 })
    {
      cases.Add("offset" + how, Text(offset), true,
        [=](ExtremeScene& scene)
        {
          scene.offset = 5.0 * offset * glm::dvec3(1.0, -0.7, 0.4);
          scene.byMatrix = byMatrix;
        });
    }
  }
  // Other lights, far away, large and small. What they are alike to is the same light's plain
  // picture.
  cases.Add("small and far", "1e-6, 1e8", true,
    [](ExtremeScene& scene)
    {
      scene.scale = 1e-6;
      scene.offset = 5e2 * glm::dvec3(-1.0, 0.3, 0.8);
    });
}

// What a view of 30 degrees shows, in one of 0.1.
void SeeFromAfar(ExtremeScene& scene)
{
  scene.viewAngle = 0.1;
  const double farther = std::tan(glm::radians(15.0)) / std::tan(glm::radians(0.05));
  scene.eye = scene.focus + farther * (scene.eye - scene.focus);
  const double distance = glm::length(scene.eye - scene.focus);
  scene.clipping[0] = 0.9 * distance;
  scene.clipping[1] = 1.1 * distance;
}

void AddViews(Cases& cases)
{
  for (const double ratio : { 1e3, 1e5, 1e7 })
  {
    cases.Add("near:far", "1:" + Text(ratio), true,
      [=](ExtremeScene& scene) { scene.clipping[0] = scene.clipping[1] / ratio; });
  }
  cases.Add("view", "parallel", false,
    [](ExtremeScene& scene)
    {
      scene.parallelScale = 2.6;
      scene.clipping[1] = 80.0;
    });
  cases.Add("view", "0.1 degrees", false, SeeFromAfar);
  cases.Add("view", "170 degrees", false,
    [](ExtremeScene& scene)
    {
      scene.eye = glm::dvec3(0.4, -2.4, 1.6);
      scene.viewAngle = 170.0;
      scene.clipping[0] = 0.05;
    });
  const struct
  {
    int width, height;
    bool isHeavy;
  } windows[] = { { 1, 1, false }, { 1, 4096, false }, { 4096, 1, false }, { 7680, 4320, true } };
  for (const auto& window : windows)
  {
    cases
      .Add("window", std::to_string(window.width) + "x" + std::to_string(window.height), false,
        [=](ExtremeScene& scene)
        {
          scene.width = window.width;
          scene.height = window.height;
        })
      .isHeavy = window.isHeavy;
  }
}

void AddLights(Cases& cases)
{
  for (const double distance : { 1e-6, 1e-3, 1e-1, 1e1, 1e3, 1e6, 1e9 })
  {
    // Times the still life's size, from the top of the ball.
    cases.Add("light distance", Text(distance), false,
      [=](ExtremeScene& scene)
      {
        const glm::dvec3 top = BallCentre + 1.0001 * BallRadius * TowardSpot;
        scene.lights = { Lamp(top + 5.0 * distance * TowardSpot) };
      });
  }
  const auto place = [&cases](const std::string& where, const glm::dvec3& position)
  {
    cases.Add(
      "light", where, false, [=](ExtremeScene& scene) { scene.lights = { Lamp(position) }; });
  };
  cases.Add("light", "at a vertex", false,
    [](ExtremeScene& scene)
    {
      double p[3];
      scene.parts[Box].mesh->GetPoint(scene.parts[Box].mesh->GetNumberOfPoints() - 1, p);
      scene.lights = { Lamp({ p[0], p[1], p[2] }) };
    });
  place("in the floor's plane", { 6.0, -4.0, 0.0 });
  cases.Add("light", "in the plane of a triangle", false,
    [](ExtremeScene& scene)
    {
      // Beyond a side of the box, in that side's plane.
      double a[3], b[3];
      scene.parts[Box].mesh->GetPoint(0, a);
      scene.parts[Box].mesh->GetPoint(1, b);
      const glm::dvec3 from(a[0], a[1], a[2]), along(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
      scene.lights = { Lamp(from + 2.5 * along + glm::dvec3(0.0, 0.0, 3.0)) };
    });
  place("inside a caster", BallCentre);
  cases.Add(
    "light", "at the eye", false, [](ExtremeScene& scene) { scene.lights = { Lamp(scene.eye) }; });
  cases.Add("light", "beside the eye", false,
    [](ExtremeScene& scene) { scene.lights = { Lamp(scene.eye + glm::dvec3(1e-6, 0.0, 0.0)) }; });
  cases.Add("light", "behind the eye", false,
    [](ExtremeScene& scene)
    { scene.lights = { Lamp(scene.eye + 2.0 * (scene.eye - scene.focus)) }; });
  cases.Add("light", "beyond the scene, toward the eye", false,
    [](ExtremeScene& scene) { scene.lights = { Lamp(glm::dvec3(0.3, 12.0, 5.0)) }; });
  for (const double rise : { 1e-2, 1e-4, 1e-6, 0.0, -1e-6 })
  {
    cases.Add("sun above the floor by", Text(rise), false,
      [=](ExtremeScene& scene) {
        scene.lights = { Sun({ -0.8, 0.6, -rise }) };
      });
  }
  for (const double cone : { 0.005, 0.05, 5.0, 60.0, 85.0, 89.0, 89.95, 89.9999, 90.0, 120.0 })
  {
    cases.Add("cone, axis to side", Text(cone) + " degrees", false,
      [=](ExtremeScene& scene)
      {
        // Narrow ones on the rim of the ball; wide ones from amid the still life.
        const glm::dvec3 rim =
          BallCentre + BallRadius * glm::normalize(glm::cross(TowardSpot, glm::dvec3(0, 0, 1)));
        scene.lights = { cone < 10.0 ? SpotFrom(rim + 3.0 * TowardSpot, rim, cone)
                                     : SpotFrom({ 0.1, 0.2, 2.9 }, { 0.0, 0.0, 0.0 }, cone) };
        if (cone < 1.0)
        {
          // So near that its pool of light is seen.
          const double away = 5.0 * std::tan(glm::radians(cone)) / std::tan(glm::radians(15.0));
          const glm::dvec3 line = glm::normalize(scene.eye - rim);
          scene.focus = rim - (rim.z / TowardSpot.z) * TowardSpot;
          scene.eye = scene.focus + std::max(away, 1e-3) * 3.0 * line;
          scene.clipping[0] = 0.2 * glm::length(scene.eye - scene.focus);
          scene.clipping[1] = 1e3 * scene.clipping[0];
        }
      });
  }
  cases.Add("lights", "0", false, [](ExtremeScene& scene) { scene.lights.clear(); });
  for (const int count : { 16, 64 })
  {
    cases.Add("lights", std::to_string(count), true,
      [=](ExtremeScene& scene)
      {
        for (int i = 1; i < count; ++i)
        {
          const double turn = glm::two_pi<double>() * i / count;
          const glm::dvec3 toward(std::cos(turn), std::sin(turn), 0.7 + 0.4 * (i % 3));
          scene.lights.push_back(i % 4 == 3 ? Sun(-toward)
              : i % 4 == 2                  ? Lamp(Middle + 6.0 * toward)
                                            : SpotFrom(Middle + 7.0 * toward, Middle, 30.0));
        }
      });
  }
}

void AddMeshes(Cases& cases)
{
  for (const double times : { 1e2, 1e4, 1e6 })
  {
    cases.Add("floor wider by", Text(times), true,
      [=](ExtremeScene& scene) { scene.parts[Floor].mesh = MakeFloor(2.5 * times); });
  }
  for (const double aspect : { 1e2, 1e4, 1e6 })
  {
    cases.Add("slivers of aspect", Text(aspect), false,
      [=](ExtremeScene& scene)
      {
        scene.parts[Box].mesh =
          MakeSlivers({ -1.3, 0.6, 0.9 }, 1.0 / aspect, static_cast<int>(std::min(aspect, 4096.0)));
      });
  }
  cases.Add("fan of slivers", "1e6", true,
    [](ExtremeScene& scene)
    {
      // The floor, from one corner to points 1e-6 of its side apart, and on to the others.
      const double h = FloorHalf;
      auto floor = vtkSmartPointer<vtkPolyData>::New();
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      vtkNew<vtkCellArray> polys;
      points->InsertNextPoint(-h, -h, 0.0);
      points->InsertNextPoint(h, -h, 0.0);
      for (int i = 0; i < 500; ++i)
      {
        points->InsertNextPoint(h, -0.2 * h + 2e-6 * h * i, 0.0);
      }
      points->InsertNextPoint(h, h, 0.0);
      points->InsertNextPoint(-h, h, 0.0);
      for (vtkIdType i = 1; i + 1 < points->GetNumberOfPoints(); ++i)
      {
        polys->InsertNextCell({ vtkIdType(0), i, i + 1 });
      }
      floor->SetPoints(points);
      floor->SetPolys(polys);
      scene.parts[Floor].mesh = floor;
    });
  cases.Add("triangles of no area", "a third of all", true,
    [](ExtremeScene& scene)
    {
      for (std::size_t i = Ball; i <= Ring; ++i)
      {
        vtkPolyData* mesh = scene.parts[i].mesh;
        std::vector<std::array<vtkIdType, 3>> none;
        for (vtkIdType p = 0; p + 2 < mesh->GetNumberOfPoints(); p += 3)
        {
          none.push_back({ p, p, p + 1 });
          none.push_back({ p, p, p });
        }
        scene.parts[i].mesh = WithTriangles(mesh, {}, none);
      }
    });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  cases.Add("coordinates", "NaN", false,
    [=](ExtremeScene& scene)
    {
      vtkPolyData* ball = scene.parts[Ball].mesh;
      const vtkIdType next = ball->GetNumberOfPoints();
      scene.parts[Ball].mesh = WithTriangles(ball, { glm::dvec3(nan) }, { { 0, 1, next } });
    });
  cases.Add("coordinates", "infinite", false,
    [=](ExtremeScene& scene)
    {
      vtkPolyData* ball = scene.parts[Ball].mesh;
      const vtkIdType next = ball->GetNumberOfPoints();
      scene.parts[Ball].mesh = WithTriangles(ball, { { infinity, 0.0, 0.0 } }, { { 0, 1, next } });
    });
  cases.Add("coordinates", "1e30 among others", false,
    [](ExtremeScene& scene)
    {
      vtkPolyData* ball = scene.parts[Ball].mesh;
      const vtkIdType next = ball->GetNumberOfPoints();
      scene.parts[Ball].mesh = WithTriangles(ball, { { 0.0, 0.0, 1e30 } }, { { 0, 1, next } });
    });
  const glm::dmat4 one(1.0);
  cases.Add("matrix", "mirrored", true,
    [=](ExtremeScene& scene)
    {
      for (std::size_t i = Ball; i <= Ring; ++i)
      {
        GiveMatrix(scene.parts[i], glm::scale(one, glm::dvec3(-1.0, 1.0, 1.0)));
      }
    });
  for (const double by : { 1.0, 1e3 })
  {
    cases.Add("matrix", "sheared by " + Text(by), true,
      [=](ExtremeScene& scene)
      {
        for (std::size_t i = Ball; i <= Ring; ++i)
        {
          GiveMatrix(scene.parts[i], Sheared(by));
        }
      });
  }
  cases.Add("matrix", "of unlike scales, 1e-6 and 1e6", true,
    [=](ExtremeScene& scene)
    {
      for (std::size_t i = Ball; i <= Ring; ++i)
      {
        GiveMatrix(scene.parts[i], glm::scale(one, glm::dvec3(1e-6, 1e6, 1.0)));
      }
    });
  const struct
  {
    const char* name;
    glm::dvec3 scale;
  } singular[] = { { "singular, to a plane", { 1.0, 1.0, 0.0 } },
    { "singular, to a line", { 0.0, 0.0, 1.0 } }, { "singular, to a point", { 0.0, 0.0, 0.0 } } };
  for (const auto& matrix : singular)
  {
    cases.Add("matrix", matrix.name, false,
      [=](ExtremeScene& scene)
      {
        // Of the ball, about its centre.
        scene.parts[Ball].sceneFromModel =
          glm::translate(glm::scale(glm::translate(one, BallCentre), matrix.scale), -BallCentre);
      });
  }
  cases.Add("matrix", "with NaN", false,
    [=](ExtremeScene& scene) { scene.parts[Ball].sceneFromModel[0][0] = nan; });

  cases.Add("triangles", "0", false,
    [](ExtremeScene& scene)
    {
      for (ExtremePart& part : scene.parts)
      {
        part.mesh = vtkSmartPointer<vtkPolyData>::New();
      }
    });
  cases.Add("triangles", "1", false,
    [](ExtremeScene& scene)
    {
      auto empty = vtkSmartPointer<vtkPolyData>::New();
      vtkNew<vtkPoints> none;
      none->SetDataTypeToDouble();
      empty->SetPoints(none);
      vtkNew<vtkCellArray> polys;
      empty->SetPolys(polys);
      scene.parts.resize(2);
      scene.parts[Ball].mesh = WithTriangles(
        empty, { { -1.0, 0.0, 1.0 }, { 1.0, 0.2, 1.4 }, { 0.0, 0.5, 1.9 } }, { { 0, 1, 2 } });
    });
  cases
    .Add("triangles", "20 million", false,
      [](ExtremeScene& scene) { scene.parts[Ball].mesh = MakeBall(BallCentre, BallRadius, 3164); })
    .isHeavy = true;
}

// With a ball beneath the floor, which then casts, too, and has a map fitted to it.
void AddCellars(Cases& cases)
{
  const auto add = [&cases](
                     const std::string& value, const std::function<void(ExtremeScene&)>& change)
  {
    cases.Add("cellar", value, false,
      [change](ExtremeScene& scene)
      {
        ExtremePart ball;
        ball.mesh = MakeBall({ 2.0, 1.0, -1.5 }, 0.5);
        scene.parts.push_back(ball);
        change(scene);
      });
  };
  add("plain", [](ExtremeScene&) {});
  add("view 0.1 degrees", SeeFromAfar);
  for (const double scale : { 1e-12, 1e12 })
  {
    add("scale " + Text(scale), [=](ExtremeScene& scene) { scene.scale = scale; });
  }
  for (const double offset : { 1e6, 1e8 })
  {
    add("offset " + Text(offset),
      [=](ExtremeScene& scene) { scene.offset = 5.0 * offset * glm::dvec3(1.0, -0.7, 0.4); });
  }
}

// The same under a sun, and under a lamp amid the still life.
void AddOtherLights(Cases& cases)
{
  const struct
  {
    const char* name;
    ShadowLight light;
  } others[] = { { "sun", Sun(-TowardSpot) }, { "lamp within", Lamp({ 0.1, 0.2, 2.0 }) } };
  for (const auto& other : others)
  {
    const ShadowLight light = other.light;
    const std::string kind = other.name;
    cases.Add(kind, "plain", false, [=](ExtremeScene& scene) { scene.lights = { light }; });
    for (const double scale : { 1e-12, 1e12 })
    {
      cases.Add(kind, "scale by points " + Text(scale), false,
        [=](ExtremeScene& scene)
        {
          scene.lights = { light };
          scene.scale = scale;
        });
    }
    for (const bool byMatrix : { false, true })
    {
      cases.Add(kind, std::string("offset by ") + (byMatrix ? "matrix" : "points") + " 1e8", false,
        [=](ExtremeScene& scene)
        {
          scene.lights = { light };
          scene.offset = 5e8 * glm::dvec3(1.0, -0.7, 0.4);
          scene.byMatrix = byMatrix;
        });
    }
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLight> LightOf(const ShadowLight& light, const glm::dvec3& offset, double scale)
{
  auto made = vtkSmartPointer<vtkLight>::New();
  // A light's direction is its focal point's: as far away as the light is large in the world.
  const glm::dvec3 position = light.kind == LightKind::Directional
    ? offset - scale * light.direction
    : offset + scale * light.position;
  const glm::dvec3 focus = light.kind == LightKind::Directional
    ? offset
    : offset + scale * (light.position + light.direction);
  made->SetPositional(light.kind != LightKind::Directional);
  made->SetPosition(position.x, position.y, position.z);
  made->SetFocalPoint(focus.x, focus.y, focus.z);
  made->SetConeAngle(light.kind == LightKind::Point ? 180.0 : light.coneAngle);
  return made;
}

}

//------------------------------------------------------------------------------
ExtremeScene PlainExtremeScene()
{
  ExtremeScene scene;
  const auto add = [&scene](const vtkSmartPointer<vtkPolyData>& mesh, const glm::dvec3& colour)
  {
    ExtremePart part;
    part.mesh = mesh;
    part.colour = colour;
    scene.parts.push_back(part);
  };
  add(MakeFloor(FloorHalf), { 0.85, 0.85, 0.8 });
  add(MakeBall(BallCentre, BallRadius), { 0.8, 0.3, 0.25 });
  add(MakeBox(), { 0.4, 0.7, 0.4 });
  add(MakePillar(), { 0.9, 0.75, 0.3 });
  add(MakeRing(), { 0.3, 0.5, 0.8 });
  scene.lights = { SpotFrom(Middle + 7.0 * TowardSpot, Middle, 35.0) };
  scene.eye = { -1.5, -8.5, 6.5 };
  scene.focus = Middle;
  scene.clipping[0] = 2.0;
  scene.clipping[1] = 60.0;
  return scene;
}

//------------------------------------------------------------------------------
std::vector<ExtremeCase> ExtremeCases()
{
  Cases cases;
  AddPlacements(cases);
  AddViews(cases);
  AddLights(cases);
  AddOtherLights(cases);
  AddCellars(cases);
  AddMeshes(cases);
  for (ExtremeCase& extreme : cases.all)
  {
    const std::string name = extreme.Name();
    const auto isOneOf = [&name](std::initializer_list<const char*> names)
    { return std::find(names.begin(), names.end(), name) != names.end(); };
    extreme.isBeyond = isOneOf({ "near:far 1:1e+07", "floor wider by 10000", "floor wider by 1e+06",
      "light at a vertex", "light beside the eye", "cellar view 0.1 degrees", "coordinates NaN",
      "coordinates 1e30 among others", "matrix singular, to a plane", "matrix sheared by 1000" });
    extreme.isBroken = extreme.kind == "coordinates" || extreme.kind == "matrix";
  }
  return std::move(cases.all);
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkLight>> Build(const ExtremeScene& scene, vtkRenderer* renderer)
{
  renderer->RemoveAllViewProps();
  renderer->RemoveAllLights();
  renderer->AutomaticLightCreationOff();
  const glm::dmat4 worldFromScene =
    glm::scale(glm::translate(glm::dmat4(1.0), scene.offset), glm::dvec3(scene.scale));
  for (const ExtremePart& part : scene.parts)
  {
    const bool isPlain = scene.byMatrix || worldFromScene == glm::dmat4(1.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(isPlain || !part.mesh->GetPoints()
        ? part.mesh.Get()
        : Moved(part.mesh, worldFromScene).Get());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(part.colour.x, part.colour.y, part.colour.z);
    const glm::dmat4 worldFromModel =
      scene.byMatrix ? worldFromScene * part.sceneFromModel : part.sceneFromModel;
    if (worldFromModel != glm::dmat4(1.0))
    {
      vtkNew<vtkMatrix4x4> matrix;
      for (int row = 0; row < 4; ++row)
      {
        for (int column = 0; column < 4; ++column)
        {
          matrix->SetElement(row, column, worldFromModel[column][row]);
        }
      }
      actor->SetUserMatrix(matrix);
    }
    renderer->AddActor(actor);
  }

  std::vector<vtkSmartPointer<vtkLight>> lights;
  for (const ShadowLight& light : scene.lights)
  {
    lights.push_back(LightOf(light, scene.offset, scene.scale));
    renderer->AddLight(lights.back());
  }

  const glm::dvec3 eye = scene.offset + scene.scale * scene.eye;
  const glm::dvec3 focus = scene.offset + scene.scale * scene.focus;
  vtkNew<vtkCamera> camera;
  camera->SetPosition(eye.x, eye.y, eye.z);
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(scene.viewAngle);
  camera->SetParallelProjection(scene.parallelScale > 0.0);
  camera->SetParallelScale(scene.scale * std::max(scene.parallelScale, 1e-3));
  camera->SetClippingRange(scene.scale * scene.clipping[0], scene.scale * scene.clipping[1]);
  renderer->SetActiveCamera(camera);
  return lights;
}

}
