// The ray cast, which every other technique is held against, against formulas: a sphere, a box and
// a disc over a floor. Each floor pixel's position is worked out in double from its own eye ray and
// the floor's known plane, so nothing that OpenGL drew comes into the expected answer.
#include "ShadowTest.h"

#include "ClosedForms.h"
#include "LightSamples.h"
#include "VisibilityError.h"

#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkDiskSource.h>
#include <vtkImageData.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

using namespace shadowtest;
using vtkshadows::LightKind;
using vtkshadows::PixelRole;
using vtkshadows::ShadowLight;

namespace
{

// The scene is laid out over the plane z = 0 in coordinates of size about 10 (SC), then placed.
struct Placement
{
  const char* name;
  glm::dmat4 worldFromScene; // rigid, and one scale
  double scale;

  glm::dvec3 Point(const glm::dvec3& pointSC) const
  {
    return glm::dvec3(this->worldFromScene * glm::dvec4(pointSC, 1.0));
  }
  glm::dvec3 Direction(const glm::dvec3& directionSC) const
  {
    return glm::normalize(glm::dvec3(this->worldFromScene * glm::dvec4(directionSC, 0.0)));
  }
};

std::vector<Placement> Placements()
{
  const glm::dmat4 one(1.0);
  const auto scaled = [&](double scale) { return glm::scale(one, glm::dvec3(scale)); };
  const glm::dmat4 tilt =
    glm::rotate(one, glm::radians(35.0), glm::normalize(glm::dvec3(1.0, 0.4, 0.3)));
  return { { "plain", one, 1.0 }, { "tilted", tilt, 1.0 },
    { "offset 1e6", glm::translate(one, glm::dvec3(1e6, -1e6, 1e6)), 1.0 },
    { "offset 1e6, tilted", glm::translate(one, glm::dvec3(1e6, -1e6, 1e6)) * tilt, 1.0 },
    { "scale 1e-6", scaled(1e-6), 1e-6 }, { "scale 1e6", scaled(1e6), 1e6 } };
}

//------------------------------------------------------------------------------
// What stands between light and floor, and what a formula says of it. A tessellation lies between
// the round shape and a smaller one: a point that those two disagree about is left out.
struct Occluder
{
  std::function<void(vtkRenderer*, const Placement&)> add;
  std::function<bool(const glm::dvec3&, const ShadowLight&, const Placement&, double)> sees;
  double within = 1.0; // share of the round shape's radius that the triangles surely fill
};

const glm::dvec3 SphereCentre(0.2, -0.1, 2.0), DiscCentre(0.2, 0.0, 1.5), DiscNormal(0.3, 0.2, 1.0);
const glm::dvec3 BoxHalf(1.0, 0.8, 0.5);
constexpr double Radius = 1.1;

glm::dmat4 SceneFromBox()
{
  const glm::dmat4 lift = glm::translate(glm::dmat4(1.0), glm::dvec3(0.1, 0.2, 1.7));
  return glm::rotate(lift, glm::radians(30.0), glm::normalize(glm::dvec3(0.2, 0.5, 1.0)));
}

// The triangles in their place, in double, as one who has such coordinates would give them to VTK.
vtkSmartPointer<vtkPolyData> Placed(vtkAlgorithm* source, const glm::dmat4& worldFromSource)
{
  source->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->DeepCopy(source->GetOutputDataObject(0));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    const glm::dvec4 placed = worldFromSource * glm::dvec4(p[0], p[1], p[2], 1.0);
    points->InsertNextPoint(placed.x, placed.y, placed.z);
  }
  mesh->SetPoints(points);
  mesh->GetPointData()->Initialize();
  return mesh;
}

bool SeesPastSphere(
  const glm::dvec3& pointWC, const ShadowLight& light, const Placement& placement, double share)
{
  return vtkshadows::SeesLightPastSphere(
    pointWC, light, placement.Point(SphereCentre), share * Radius * placement.scale);
}

Occluder ImpostorSphere()
{
  Occluder occluder;
  occluder.add = [](vtkRenderer* renderer, const Placement& placement)
  {
    // VTK keeps an impostor's centre in floats, so a far one is placed by its actor.
    const glm::dvec3 origin(placement.worldFromScene[3]);
    const glm::dvec3 centre = placement.Point(SphereCentre) - origin;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->InsertNextPoint(centre.x, centre.y, centre.z);
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    vtkNew<vtkCellArray> verts;
    verts->InsertNextCell({ 0 });
    mesh->SetVerts(verts);
    vtkNew<vtkOpenGLSphereMapper> mapper;
    mapper->SetInputData(mesh);
    mapper->SetRadius(static_cast<float>(Radius * placement.scale));
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(origin.x, origin.y, origin.z);
    renderer->AddActor(actor);
  };
  occluder.sees = SeesPastSphere;
  return occluder;
}

Occluder TessellatedSphere()
{
  constexpr int sides = 200;
  Occluder occluder;
  occluder.add = [](vtkRenderer* renderer, const Placement& placement)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    sphere->SetRadius(Radius);
    sphere->SetThetaResolution(sides);
    sphere->SetPhiResolution(sides);
    AddActor(renderer,
      Placed(sphere, placement.worldFromScene * glm::translate(glm::dmat4(1.0), SphereCentre)));
  };
  occluder.sees = SeesPastSphere;
  // A facet is nearest to the centre at most half a step of both angles from its corners.
  occluder.within =
    std::cos(glm::radians(180.0) / sides) * std::cos(glm::radians(90.0) / (sides - 1));
  return occluder;
}

Occluder Box()
{
  Occluder occluder;
  occluder.add = [](vtkRenderer* renderer, const Placement& placement)
  {
    vtkNew<vtkCubeSource> box;
    box->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    box->SetBounds(-BoxHalf.x, BoxHalf.x, -BoxHalf.y, BoxHalf.y, -BoxHalf.z, BoxHalf.z);
    AddActor(renderer, Placed(box, placement.worldFromScene * SceneFromBox()));
  };
  occluder.sees =
    [](const glm::dvec3& pointWC, const ShadowLight& light, const Placement& placement, double)
  {
    const glm::dmat4 boxFromWorld = glm::affineInverse(placement.worldFromScene * SceneFromBox());
    return vtkshadows::SeesLightPastBox(pointWC, light, -BoxHalf, BoxHalf, boxFromWorld);
  };
  return occluder;
}

Occluder Disc()
{
  constexpr int sides = 200;
  Occluder occluder;
  occluder.add = [](vtkRenderer* renderer, const Placement& placement)
  {
    vtkNew<vtkDiskSource> disc;
    disc->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    disc->SetInnerRadius(0.0);
    disc->SetOuterRadius(Radius);
    disc->SetCircumferentialResolution(sides);
    const glm::dvec3 up(0.0, 0.0, 1.0), normal = glm::normalize(DiscNormal);
    const glm::dmat4 place = glm::rotate(glm::translate(glm::dmat4(1.0), DiscCentre),
      std::acos(glm::dot(up, normal)), glm::normalize(glm::cross(up, normal)));
    AddActor(renderer, Placed(disc, placement.worldFromScene * place));
  };
  occluder.sees = [](const glm::dvec3& pointWC, const ShadowLight& light,
                    const Placement& placement, double share)
  {
    return vtkshadows::SeesLightPastDisc(pointWC, light, placement.Point(DiscCentre),
      placement.Direction(DiscNormal), share * Radius * placement.scale);
  };
  occluder.within = std::cos(glm::radians(180.0) / sides);
  return occluder;
}

//------------------------------------------------------------------------------
struct Lit
{
  ShadowLight ray;
  vtkSmartPointer<vtkLight> light;
};

Lit AddLight(vtkRenderer* renderer, LightKind kind, const Placement& placement)
{
  Lit lit;
  lit.ray.kind = kind;
  lit.ray.direction = placement.Direction({ -0.4, 0.3, -1.0 });
  switch (kind)
  {
    case LightKind::Directional:
      lit.light = AddSun(renderer, lit.ray.direction);
      break;
    case LightKind::Spot:
      lit.ray.position = placement.Point({ 2.5, -2.0, 7.0 });
      lit.light = AddSpot(renderer, lit.ray.position, placement.Point(glm::dvec3(0.0)), 40.0);
      break;
    case LightKind::Point:
      lit.ray.position = placement.Point({ 1.5, -1.0, 5.0 });
      lit.light = AddLamp(renderer, lit.ray.position);
      break;
  }
  return lit;
}

//------------------------------------------------------------------------------
// The eye's rays, in double.
class EyeRays
{
public:
  EyeRays(vtkRenderer* renderer, int width, int height)
    : Width(width)
    , Height(height)
  {
    vtkCamera* camera = renderer->GetActiveCamera();
    this->Eye = Vector(camera->GetPosition());
    this->Ahead = glm::normalize(Vector(camera->GetFocalPoint()) - this->Eye);
    this->Right = glm::normalize(glm::cross(this->Ahead, Vector(camera->GetViewUp())));
    this->Up = glm::cross(this->Right, this->Ahead);
    this->Parallel = camera->GetParallelProjection() != 0;
    this->HalfHeight = this->Parallel ? camera->GetParallelScale()
                                      : std::tan(glm::radians(0.5 * camera->GetViewAngle()));
  }

  // Where the ray through the pixel's centre meets the plane through `origin`; false if it does
  // not.
  bool Meet(int x, int y, const glm::dvec3& origin, const glm::dvec3& normal, glm::dvec3& pointWC)
  {
    const double perPixel = 2.0 * this->HalfHeight / this->Height;
    const glm::dvec3 aside = (x + 0.5 - 0.5 * this->Width) * perPixel * this->Right +
      (y + 0.5 - 0.5 * this->Height) * perPixel * this->Up;
    const glm::dvec3 from = this->Parallel ? this->Eye + aside : this->Eye;
    const glm::dvec3 along = this->Parallel ? this->Ahead : this->Ahead + aside;
    const double t = glm::dot(origin - from, normal) / glm::dot(along, normal);
    pointWC = from + t * along;
    return t > 0.0;
  }

  // The eye as a light: a floor point is in view where it "sees" it past the occluder.
  ShadowLight AsLight() const
  {
    ShadowLight light;
    light.kind = this->Parallel ? LightKind::Directional : LightKind::Point;
    light.position = this->Eye;
    light.direction = this->Ahead;
    return light;
  }

private:
  static glm::dvec3 Vector(const double* v) { return { v[0], v[1], v[2] }; }

  int Width, Height;
  bool Parallel;
  glm::dvec3 Eye, Ahead, Right, Up;
  double HalfHeight;
};

//------------------------------------------------------------------------------
struct Expected
{
  std::vector<float> truth;
  std::vector<PixelRole> roles;
};

constexpr double FloorHalf = 6.0;

// Truth from the formula at every pixel that surely shows the floor.
Expected Expect(vtkRenderer* renderer, int width, int height, const Occluder& occluder,
  const ShadowLight& light, const Placement& placement)
{
  EyeRays eye(renderer, width, height);
  const ShadowLight asLight = eye.AsLight();
  const glm::dmat4 sceneFromWorld = glm::affineInverse(placement.worldFromScene);
  const glm::dvec3 origin = placement.Point(glm::dvec3(0.0));
  const glm::dvec3 normal = placement.Direction({ 0.0, 0.0, 1.0 });

  Expected expected;
  expected.truth.assign(std::size_t(width) * height, 1.0f);
  expected.roles.assign(expected.truth.size(), PixelRole::Background);
  for (std::size_t i = 0; i < expected.truth.size(); ++i)
  {
    glm::dvec3 pointWC;
    if (!eye.Meet(
          static_cast<int>(i % width), static_cast<int>(i / width), origin, normal, pointWC))
    {
      continue;
    }
    const glm::dvec3 pointSC(sceneFromWorld * glm::dvec4(pointWC, 1.0));
    // A little off the floor's own rim, and off the occluder's in view.
    const bool onFloor = std::max(std::abs(pointSC.x), std::abs(pointSC.y)) < 0.99 * FloorHalf;
    if (!onFloor || !occluder.sees(pointWC, asLight, placement, 1.01))
    {
      continue;
    }
    const bool seesPastWhole = occluder.sees(pointWC, light, placement, 1.0);
    const bool seesPastWithin = occluder.sees(pointWC, light, placement, occluder.within);
    expected.truth[i] = seesPastWhole ? 1.0f : 0.0f;
    expected.roles[i] =
      seesPastWhole == seesPastWithin ? PixelRole::Measured : PixelRole::Uncertain;
  }
  return expected;
}

class RayCastClosedForms : public ShadowTest
{
protected:
  void CheckOccluder(const Occluder& occluder);
  void CheckScene(
    const Occluder& occluder, LightKind kind, const Placement& placement, bool parallel);
};

void RayCastClosedForms::CheckScene(
  const Occluder& occluder, LightKind kind, const Placement& placement, bool parallel)
{
  vtkNew<vtkRenderer> renderer;
  this->Window->AddRenderer(renderer);
  vtkNew<vtkPlaneSource> floor;
  floor->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  floor->SetOrigin(-FloorHalf, -FloorHalf, 0.0);
  floor->SetPoint1(FloorHalf, -FloorHalf, 0.0);
  floor->SetPoint2(-FloorHalf, FloorHalf, 0.0);
  AddActor(renderer, Placed(floor, placement.worldFromScene));
  occluder.add(renderer, placement);
  const Lit lit = AddLight(renderer, kind, placement);

  vtkNew<vtkShadowPass> shadows;
  shadows->SetTechnique("ray-cast");
  renderer->SetPass(shadows);

  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetParallelProjection(parallel);
  camera->SetParallelScale(4.0 * placement.scale);
  LookAt(renderer, placement.Point({ 3.0, -8.0, 7.0 }), placement.Point({ -0.5, 0.5, 0.5 }));
  camera->SetViewUp(&placement.Direction({ 0.0, 0.0, 1.0 })[0]);
  renderer->ResetCameraClippingRange();
  this->Window->Render();

  vtkNew<vtkImageData> image;
  ASSERT_TRUE(shadows->GetVisibility(renderer, lit.light, image));
  const int* size = image->GetDimensions();
  const Expected expected = Expect(renderer, size[0], size[1], occluder, lit.ray, placement);
  vtkshadows::VisibilityImages images;
  images.width = size[0];
  images.height = size[1];
  images.visibility = static_cast<float*>(image->GetScalarPointer());
  images.truth = expected.truth.data();
  images.role = expected.roles.data();
  const vtkshadows::VisibilityError error = vtkshadows::MeasureVisibility(images);

  const char* kinds[] = { "directional", "spot", "point" };
  const std::string what = std::string(placement.name) + ", " + kinds[static_cast<int>(kind)] +
    (parallel ? ", parallel eye" : "") + " (" + std::to_string(error.receiverPixels) +
    " floor pixels, " + std::to_string(error.shadowPixels) + " in shadow)";
  CheckAtMost(what + ": mismatch %", error.MismatchPercent(), 0.05);
  CheckAtMost(what + ": gross pixels", static_cast<double>(error.GrossPixels()), 0.0);
  // The scene must ask something: enough floor, enough shadow, few pixels left out.
  EXPECT_GT(error.receiverPixels, 50000u) << what;
  EXPECT_GT(error.shadowPixels, 2500u) << what;
  EXPECT_LT(error.uncertainPixels, 300u) << what;

  renderer->SetPass(nullptr);
  this->Window->RemoveRenderer(renderer);
}

void RayCastClosedForms::CheckOccluder(const Occluder& occluder)
{
  this->Resize(480, 360);
  for (const Placement& placement : Placements())
  {
    for (const LightKind kind : { LightKind::Directional, LightKind::Spot, LightKind::Point })
    {
      this->CheckScene(occluder, kind, placement, kind == LightKind::Spot);
      this->CheckScene(occluder, kind, placement, kind != LightKind::Spot);
    }
  }
}

}

TEST_F(RayCastClosedForms, ImpostorSphereOverPlane)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->CheckOccluder(ImpostorSphere());
}

TEST_F(RayCastClosedForms, TessellatedSphereOverPlane)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->CheckOccluder(TessellatedSphere());
}

TEST_F(RayCastClosedForms, BoxOverPlane)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->CheckOccluder(Box());
}

TEST_F(RayCastClosedForms, DiscOverPlane)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  this->CheckOccluder(Disc());
}

// A luminous disc is the mean over many points of it, each by the formula.
TEST_F(RayCastClosedForms, BoxOverPlaneInTheLightOfADisc)
{
  SHADOWTEST_NEEDS_RAY_CAST();
  const Placement plain = Placements()[0];
  const Occluder box = Box();
  AddFloor(this->Renderer, FloorHalf);
  box.add(this->Renderer, plain);
  Lit lit = AddLight(this->Renderer, LightKind::Spot, plain);
  lit.ray.direction = glm::normalize(-lit.ray.position);
  lit.ray.radius = 0.5;
  this->Shadows->SetTechnique("ray-cast");
  this->Shadows->SetLightRadius(lit.light, lit.ray.radius);
  this->Shadows->GetRayCastShadowPass()->SetLightSamples(256);
  this->Renderer->SetPass(this->Shadows);
  LookAt(this->Renderer, { 3.0, -8.0, 7.0 }, { -0.5, 0.5, 0.5 });
  this->Render();
  const Visibility got = this->VisibilityOf(lit.light);

  Expected mean = Expect(this->Renderer, got.width, got.height, box, lit.ray, plain);
  std::fill(mean.truth.begin(), mean.truth.end(), 0.0f);
  // Not those of the pass: another number of points.
  const auto samples = vtkshadows::SampleAreaLight(lit.ray, 400, glm::dvec3(0.0));
  for (const ShadowLight& sample : samples)
  {
    const Expected hard = Expect(this->Renderer, got.width, got.height, box, sample, plain);
    for (std::size_t i = 0; i < mean.truth.size(); ++i)
    {
      mean.truth[i] += hard.truth[i] / samples.size();
    }
  }
  double sum = 0.0, largest = 0.0;
  std::size_t count = 0, partial = 0;
  for (std::size_t i = 0; i < mean.truth.size(); ++i)
  {
    if (mean.roles[i] == PixelRole::Measured)
    {
      const double difference = std::abs(got.values[i] - mean.truth[i]);
      sum += difference;
      largest = std::max(largest, difference);
      partial += mean.truth[i] > 0.05f && mean.truth[i] < 0.95f ? 1 : 0;
      ++count;
    }
  }
  CheckAtMost("mean absolute difference", sum / count, 0.001);
  CheckAtMost("largest difference", largest, 0.03);
  EXPECT_GT(partial, 2000u) << "hardly a penumbra";
}
