// How spots fall off across their cones: to a smooth side, and by an image that they project. Held
// against closed forms, and against VTK's own frame with lights of another colour.
#include "ShadowTest.h"

#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace shadowtest;

namespace
{

// An image of one colour a cell, that neighbours do not share, not blended.
vtkSmartPointer<vtkTexture> Cells(int width, int height)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      auto* cell = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      cell[0] = static_cast<unsigned char>(255 * (x + 1) / width);
      cell[1] = static_cast<unsigned char>(255 * (y + 1) / height);
      cell[2] = static_cast<unsigned char>((x + y) % 2 == 0 ? 255 : 80);
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOff();
  return texture;
}

// An image of one colour, 0 to 255, of so many components.
vtkSmartPointer<vtkTexture> Plain(const std::vector<int>& color)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 3, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, static_cast<int>(color.size()));
  for (int i = 0; i < 12; ++i)
  {
    for (std::size_t c = 0; c < color.size(); ++c)
    {
      image->SetScalarComponentFromDouble(i % 4, i / 4, 0, static_cast<int>(c), color[c]);
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  return texture;
}

// Where the plane z = height lies in a pixel's middle.
glm::dvec3 PointIn(vtkRenderer* renderer, int x, int y, double height)
{
  glm::dvec3 ends[2];
  for (int i = 0; i < 2; ++i)
  {
    renderer->SetDisplayPoint(x + 0.5, y + 0.5, i == 0 ? 0.1 : 0.9);
    renderer->DisplayToWorld();
    const double* p = renderer->GetWorldPoint();
    ends[i] = glm::dvec3(p[0], p[1], p[2]) / p[3];
  }
  return ends[0] + (height - ends[0].z) / (ends[1].z - ends[0].z) * (ends[1] - ends[0]);
}

glm::dvec3 Place(vtkLight* light)
{
  double p[3];
  light->GetTransformedPosition(p);
  return { p[0], p[1], p[2] };
}

glm::dvec3 Axis(vtkLight* light)
{
  double p[3];
  light->GetTransformedFocalPoint(p);
  return glm::normalize(glm::dvec3(p[0], p[1], p[2]) - Place(light));
}

double SmoothCone(vtkLight* light, double share, const glm::dvec3& point)
{
  const double cosine = glm::dot(glm::normalize(point - Place(light)), Axis(light));
  const double side = std::cos(glm::radians(light->GetConeAngle()));
  const double inner = std::cos(glm::radians((1.0 - share) * light->GetConeAngle()));
  const double t = std::min(std::max((cosine - side) / (inner - side), 0.0), 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Where in the image, 0 to 1.
glm::dvec2 ImagePlace(vtkLight* light, const glm::dvec3& up, const glm::dvec3& point)
{
  const glm::dvec3 axis = Axis(light), right = glm::normalize(glm::cross(axis, up));
  const glm::dvec3 way = point - Place(light);
  const double reach = glm::dot(way, axis) * std::tan(glm::radians(light->GetConeAngle()));
  return { 0.5 + 0.5 * glm::dot(way, right) / reach,
    0.5 + 0.5 * glm::dot(way, glm::cross(right, axis)) / reach };
}

class LightFalloff : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetPass(this->Shadows);
  }

  // Rough and white, so that what arrives is what is seen.
  void AddRoughFloor(double halfSide, double height = 0.0)
  {
    vtkProperty* property = AddFloor(this->Renderer, halfSide, height)->GetProperty();
    property->SetColor(1.0, 1.0, 1.0);
    property->SetAmbient(0.0);
    property->SetSpecular(0.0);
  }

  // The floor's frame over that of VTK's own light, pixel for pixel, against the closed form.
  void CheckFloor(const std::string& what, double height,
    const std::function<bool(const glm::dvec3& point, glm::dvec3& factor)>& factorAt,
    std::size_t leastPixels);
};

void LightFalloff::CheckFloor(const std::string& what, double height,
  const std::function<bool(const glm::dvec3& point, glm::dvec3& factor)>& factorAt,
  std::size_t leastPixels)
{
  const Frame got = this->Render();
  const Frame plain = this->RenderWithoutPass();
  this->Renderer->SetPass(this->Shadows);
  std::size_t asked = 0, wrong = 0;
  double worst = 0.0;
  for (int y = 0; y < got.height; ++y)
  {
    for (int x = 0; x < got.width; ++x)
    {
      glm::dvec3 factor;
      if (plain.Brightness(x, y) < 3 * 60 ||
        !factorAt(PointIn(this->Renderer, x, y, height), factor))
      {
        continue;
      }
      ++asked;
      double largest = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        const std::size_t i = 3 * (std::size_t(y) * got.width + x) + c;
        largest = std::max(largest, std::abs(got.rgb[i] - factor[c] * plain.rgb[i]));
      }
      worst = std::max(worst, largest);
      wrong += largest > 1.6 ? 1 : 0;
    }
  }
  CheckAtLeast(what + ": pixels", static_cast<double>(asked), static_cast<double>(leastPixels));
  Check(what + ": pixels that differ by more than a rounding of each of two frames (most " +
      std::to_string(worst) + ")",
    static_cast<double>(wrong), 0.0);
}

}

TEST_F(LightFalloff, SmoothCone)
{
  for (const double scale : { 1.0, 1e6, 1e-6 })
  {
    vtkSmartPointer<vtkActor> floor = AddFloor(this->Renderer, 4.0 * scale);
    floor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    floor->GetProperty()->SetAmbient(0.0);
    LookAt(this->Renderer, scale * glm::dvec3(0.0, -7.0, 6.0), glm::dvec3(0.0));
    for (const double cone : { 3.0, 20.0, 40.0, 80.0 })
    {
      // VTK's exponent stays in force.
      auto spot = AddSpot(this->Renderer, scale * glm::dvec3(1.0, -2.0, 4.0),
        scale * glm::dvec3(0.3, 0.2, 0.0), cone);
      spot->SetExponent(cone > 50.0 ? 1.0 : 2.0);
      for (const double share : { 1.0, 0.5, 0.05 })
      {
        this->Shadows->SetLightSmoothCone(spot, share);
        this->CheckFloor(
          "scale " + std::to_string(scale) + ", cone " + std::to_string(int(cone)) + ", share " +
            std::to_string(share),
          0.0,
          [&](const glm::dvec3& point, glm::dvec3& factor)
          {
            factor = glm::dvec3(SmoothCone(spot, share, point));
            return true;
          },
          cone < 10.0 ? 300 : 5000);
      }
      this->Renderer->RemoveLight(spot);
    }
    this->Renderer->RemoveViewProp(floor);
  }
}

// A cosine in a float has no digits left to tell the angles of such a cone by.
TEST_F(LightFalloff, NarrowSmoothCone)
{
  this->AddRoughFloor(4.0);
  LookAt(this->Renderer, { 0.0, -5.0, 6.0 }, { 0.0, 0.0, 0.0 });
  auto spot = AddSpot(this->Renderer, { 300.0, -200.0, 2500.0 }, { 0.0, 0.0, 0.0 }, 0.04);
  for (const double share : { 1.0, 0.3 })
  {
    this->Shadows->SetLightSmoothCone(spot, share);
    this->CheckFloor(
      "cone of 0.04 degrees, share " + std::to_string(share), 0.0,
      [&](const glm::dvec3& point, glm::dvec3& factor)
      {
        factor = glm::dvec3(SmoothCone(spot, share, point));
        // VTK's own side is where a float's cosine says.
        return factor.x > 0.02;
      },
      3000);
  }
}

TEST_F(LightFalloff, ProjectedImage)
{
  this->AddRoughFloor(6.0);
  LookAt(this->Renderer, { 0.0, -9.0, 7.0 }, { 0.0, 0.0, 0.0 });
  const int width = 6, height = 4;
  const vtkSmartPointer<vtkTexture> image = Cells(width, height);
  struct Case
  {
    const char* name;
    glm::dvec3 position, focus;
    double cone;
    glm::dvec3 given, up; // as set, and as it is in force
  };
  const glm::dvec3 y(0.0, 1.0, 0.0), z(0.0, 0.0, 1.0);
  for (const Case& each : {
         Case{ "aslant", { 3.0, -3.0, 4.0 }, { 0.0, 0.3, 0.0 }, 30.0, z, z },
         Case{ "from above", { 0.5, 0.2, 5.0 }, { 0.5, 0.2, 0.0 }, 35.0, z, y },
         Case{ "rolled", { 3.0, -3.0, 4.0 }, { 0.0, 0.3, 0.0 }, 30.0, { -2.0, 0.5, 1.0 },
           { -2.0, 0.5, 1.0 } },
         Case{ "up along the light", { 0.0, -6.0, 3.0 }, { 0.0, 0.0, 0.0 }, 30.0,
           { 0.0, 2e-200, -1e-200 }, z },
         Case{ "as wide as 179 degrees", { 1.0, -2.0, 1.0 }, { 0.9, -1.9, 0.0 }, 89.5, z, z },
       })
  {
    auto spot = AddSpot(this->Renderer, each.position, each.focus, each.cone);
    this->Shadows->SetLightTexture(spot, image);
    this->Shadows->SetLightTextureUp(spot, each.given.x, each.given.y, each.given.z);
    std::size_t cells[6][4] = {};
    this->CheckFloor(
      each.name, 0.0,
      [&](const glm::dvec3& point, glm::dvec3& factor)
      {
        const glm::dvec2 at = ImagePlace(spot, each.up, point);
        const glm::dvec2 cell = at * glm::dvec2(width, height);
        const glm::dvec2 edge = glm::abs(cell - glm::round(cell));
        // Not at a cell's edge, nor at the cone's side.
        const double off = glm::length(2.0 * at - 1.0);
        if (std::min(edge.x, edge.y) < 1e-3 || off > 0.999)
        {
          return false;
        }
        const int i = static_cast<int>(std::floor(cell.x)),
                  j = static_cast<int>(std::floor(cell.y));
        factor =
          glm::dvec3(255 * (i + 1) / width, 255 * (j + 1) / height, (i + j) % 2 == 0 ? 255 : 80) /
          255.0;
        ++cells[i][j];
        return true;
      },
      4000);
    if (each.cone < 45.0)
    {
      std::size_t seen = 0;
      for (const auto& column : cells)
      {
        seen += std::count_if(column, column + 4, [](std::size_t n) { return n > 0; });
      }
      CheckAtLeast(
        std::string(each.name) + ": cells that are seen", static_cast<double>(seen), 16.0);
    }
    this->Renderer->RemoveLight(spot);
  }
}

// With the smooth cone, and with VTK's exponent and attenuation.
TEST_F(LightFalloff, ImageAndConeTogether)
{
  this->AddRoughFloor(6.0);
  LookAt(this->Renderer, { 0.0, -9.0, 7.0 }, { 0.0, 0.0, 0.0 });
  auto spot = AddSpot(this->Renderer, { 2.0, -2.0, 4.0 }, { 0.0, 0.3, 0.0 }, 35.0);
  spot->SetExponent(3.0);
  spot->SetAttenuationValues(1.0, 0.05, 0.0);
  this->Shadows->SetLightTexture(spot, Plain({ 200, 120, 60, 3 }));
  this->Shadows->SetLightSmoothCone(spot, 0.7);
  this->CheckFloor(
    "image and cone", 0.0,
    [&](const glm::dvec3& point, glm::dvec3& factor)
    {
      factor = SmoothCone(spot, 0.7, point) * glm::dvec3(200.0, 120.0, 60.0) / 255.0;
      return true;
    },
    5000);
}

// Where a light is seen it falls off; where it is not there is none of it, by any technique. What
// is read back knows nothing of it.
TEST_F(LightFalloff, WithEveryTechnique)
{
  this->AddRoughFloor(6.0);
  AddSphere(this->Renderer, { -0.5, 0.0, 1.1 }, 0.8);
  LookAt(this->Renderer, { 0.0, -9.0, 7.0 }, { 0.0, 0.0, 0.0 });
  auto spot = AddSpot(this->Renderer, { 3.0, -3.0, 4.0 }, { 0.0, 0.3, 0.0 }, 35.0);
  // Nothing else shines: where this is not seen it is black.
  const auto fallOff = [&](bool falls)
  {
    this->Shadows->SetLightTexture(spot, falls ? Cells(5, 5).Get() : nullptr);
    this->Shadows->SetLightSmoothCone(spot, falls ? 0.6 : 0.0);
  };
  this->Shadows->SetTechnique("none");
  fallOff(true);
  const Frame lit = this->Render();
  for (const std::string technique :
    { "depth-map", "object-id", "planar", "shadow-texture", "stencil-volume", "ray-cast" })
  {
    if (technique == "ray-cast" && !this->Shadows->GetRayCastShadowPass())
    {
      continue;
    }
    this->Shadows->SetTechnique(technique);
    fallOff(false);
    const Visibility expected = this->VisibilityBy(technique, spot);
    fallOff(true);
    const Frame got = this->Render();
    const Visibility seen = this->VisibilityOf(spot);
    Check(technique + ": visibility that is read back, pixels unlike",
      static_cast<double>(CountDifferent(seen, expected)), 0.0);
    CheckAtLeast(
      technique + ": pixels in shadow", static_cast<double>(seen.CountShadowed()), 1000.0);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < got.rgb.size(); ++i)
    {
      // As far as a byte tells a share of it.
      const double wanted = seen.values[i / 3] * lit.rgb[i];
      wrong += std::abs(got.rgb[i] - wanted) > 1.1 ? 1 : 0;
    }
    Check(technique + ": colours unlike visibility times what falls off",
      static_cast<double>(wrong), 0.0);
  }
}

// An image of one colour is that colour of the light, on all that VTK shades.
TEST_F(LightFalloff, WhateverIsShaded)
{
  AddFloor(this->Renderer, 6.0)->GetProperty()->SetAmbient(0.2);
  auto box = AddBox(this->Renderer, { 0.5, -0.6, 0.0 }, { 1.7, 0.6, 1.4 });
  auto sphere = AddSphere(this->Renderer, { -1.0, 0.0, 1.1 }, 0.9);
  auto points = AddSphere(this->Renderer, { -2.6, -1.0, 0.7 }, 0.7, 9);
  points->GetProperty()->SetRepresentationToPoints();
  points->GetProperty()->RenderPointsAsSpheresOn();
  points->GetProperty()->SetPointSize(9.0f);
  auto lines = AddSphere(this->Renderer, { 2.6, 1.0, 0.7 }, 0.7, 9);
  lines->GetProperty()->SetRepresentationToWireframe();
  lines->GetProperty()->RenderLinesAsTubesOn();
  lines->GetProperty()->SetLineWidth(5.0f);
  LookAt(this->Renderer, { 0.0, -9.0, 5.0 }, { 0.0, 0.0, 0.5 });
  auto spot = AddSpot(this->Renderer, { 3.0, -3.0, 5.0 }, { 0.0, 0.3, 0.0 }, 40.0);
  auto sun = AddSun(this->Renderer, { 1.0, 0.7, -1.2 });
  sun->SetIntensity(0.3);
  auto other = AddSpot(this->Renderer, { -3.0, -4.0, 5.0 }, { 0.0, 0.3, 0.0 }, 40.0);
  other->SetIntensity(0.5);
  this->Shadows->SetLightTechnique(other, "none");

  const auto check = [&](const std::string& what)
  {
    for (const std::vector<int>& color :
      { std::vector<int>{ 204, 102, 51 }, std::vector<int>{ 102 }, std::vector<int>{ 102, 9 } })
    {
      this->Shadows->SetLightTexture(spot, Plain(color));
      this->Shadows->SetLightTexture(other, Plain({ 51, 102, 204, 77 }));
      const Frame got = this->Render();
      this->Shadows->SetLightTexture(spot, nullptr);
      this->Shadows->SetLightTexture(other, nullptr);
      const bool isGrey = color.size() < 3;
      spot->SetColor(color[0] / 255.0, (isGrey ? color[0] : color[1]) / 255.0,
        (isGrey ? color[0] : color[2]) / 255.0);
      other->SetColor(0.2, 0.4, 0.8);
      const Frame expected = this->Render();
      spot->SetColor(1.0, 1.0, 1.0);
      other->SetColor(1.0, 1.0, 1.0);
      Check(what + ", " + std::to_string(color.size()) + " components: pixels of another colour",
        static_cast<double>(CountDifferent(got, expected, 1)), 0.0);
      CheckAtLeast(what + ": pixels that it changes",
        static_cast<double>(CountDifferent(got, this->Render(), 20)), 10000.0);
    }
  };
  for (const std::string technique : { "depth-map", "stencil-volume" })
  {
    this->Shadows->SetTechnique(technique);
    if (technique == "stencil-volume")
    {
      vtkShadowPass::SetCastsShadows(points, false);
      vtkShadowPass::SetCastsShadows(lines, false);
    }
    box->GetProperty()->SetInterpolationToPhong();
    sphere->GetProperty()->SetOpacity(1.0);
    check(technique);
    box->GetProperty()->SetInterpolationToPBR();
    box->GetProperty()->SetMetallic(0.3);
    sphere->GetProperty()->SetOpacity(0.5);
    check(technique + ", physically based, translucent");
  }
}

// A catcher's alpha is that of the light that arrives.
TEST_F(LightFalloff, OnACatcher)
{
  auto floor = AddFloor(this->Renderer, 6.0);
  vtkShadowPass::SetShadowCatcher(floor, true);
  this->Renderer->SetBackground(1.0, 1.0, 1.0);
  auto box = AddBox(this->Renderer, { -0.5, -0.6, 0.5 }, { 0.7, 0.6, 1.4 });
  LookAt(this->Renderer, { 0.0, -9.0, 7.0 }, { 0.0, 0.0, 0.0 });
  auto spot = AddSpot(this->Renderer, { 3.0, -3.0, 4.0 }, { 0.0, 0.3, 0.0 }, 40.0);
  auto fill = AddSpot(this->Renderer, { -2.0, -3.0, 6.0 }, { 0.0, 0.3, 0.0 }, 40.0);
  this->Shadows->SetLightTechnique(fill, "none");
  const Frame plain = this->Render();
  this->Shadows->SetLightTexture(spot, Plain({ 102, 102, 102 }));
  const Frame got = this->Render();
  this->Shadows->SetLightTexture(spot, nullptr);
  spot->SetIntensity(0.4);
  const Frame expected = this->Render();
  Check("pixels unlike those of a weaker light",
    static_cast<double>(CountDifferent(got, expected, 1)), 0.0);
  CheckAtLeast(
    "pixels that it changes", static_cast<double>(CountDifferent(got, plain, 20)), 500.0);
  spot->SetIntensity(1.0);
  this->Shadows->SetLightTexture(fill, Plain({ 102, 102, 102 }));
  const Frame weakFill = this->Render();
  this->Shadows->SetLightTexture(fill, nullptr);
  fill->SetIntensity(0.4);
  Check("a light without technique, pixels unlike those of a weaker one",
    static_cast<double>(CountDifferent(weakFill, this->Render(), 1)), 0.0);
}

// An impostor's surface is where its image lies, not its square.
TEST_F(LightFalloff, OnSphereImpostors)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetVerts(verts);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->SetRadius(1.0f);
  vtkNew<vtkActor> impostor;
  impostor->SetMapper(mapper);
  this->Renderer->AddActor(impostor);
  LookAt(this->Renderer, { 0.0, -6.0, 0.0 }, { 0.0, 0.0, 0.0 });
  this->Renderer->GetActiveCamera()->SetClippingRange(3.0, 9.0);
  auto spot = AddSpot(this->Renderer, { 3.0, -5.0, 4.0 }, { 0.0, 0.0, 0.0 }, 12.0);
  this->Shadows->SetTechnique("none");
  this->Shadows->SetLightTexture(spot, Cells(7, 5));
  const Frame asImpostor = this->Render();
  this->Renderer->RemoveViewProp(impostor);
  AddSphere(this->Renderer, { 0.0, 0.0, 0.0 }, 1.0, 200);
  const Frame asMesh = this->Render();
  std::size_t covered = 0;
  for (std::size_t i = 0; i < asMesh.rgb.size(); i += 3)
  {
    covered += asMesh.rgb[i] + asMesh.rgb[i + 1] + asMesh.rgb[i + 2] > 30 ? 1 : 0;
  }
  CheckAtLeast("pixels of the ball", static_cast<double>(covered), 5000.0);
  // The edges of cells run through some pixels.
  CheckAtMost("pixels of another colour, of those",
    static_cast<double>(CountDifferent(asImpostor, asMesh, 12)), 0.02 * covered);
}

// Sixteen, each with an image of its own or a smooth side, mixed with others and with techniques.
TEST_F(LightFalloff, SixteenLights)
{
  AddFloor(this->Renderer, 6.0)->GetProperty()->SetAmbient(0.1);
  AddSphere(this->Renderer, { -0.5, 0.0, 1.1 }, 0.8);
  LookAt(this->Renderer, { 0.0, -9.0, 7.0 }, { 0.0, 0.0, 0.0 });
  std::vector<vtkSmartPointer<vtkLight>> lamps;
  for (int i = 0; i < 16; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / 16.0;
    const glm::dvec3 place(4.0 * std::cos(angle), 4.0 * std::sin(angle), 4.0);
    auto lamp = i % 4 == 3 ? AddSun(this->Renderer, -place)
                           : AddSpot(this->Renderer, place, { 0.0, 0.0, 0.3 }, 40.0);
    lamp->SetIntensity(0.08);
    this->Shadows->SetLightTechnique(lamp,
      i % 3 == 0     ? "depth-map"
        : i % 3 == 1 ? "stencil-volume"
                     : "none");
    lamps.push_back(lamp);
  }
  const auto dress = [&](bool byImage)
  {
    for (int i = 0; i < 16; ++i)
    {
      if (i % 4 != 3)
      {
        const int grey = 40 + 10 * i;
        this->Shadows->SetLightTexture(
          lamps[i], byImage ? Plain({ grey, 255 - grey, grey }).Get() : nullptr);
        lamps[i]->SetColor(byImage ? 1.0 : grey / 255.0, byImage ? 1.0 : 1.0 - grey / 255.0,
          byImage ? 1.0 : grey / 255.0);
      }
    }
  };
  dress(true);
  const Frame got = this->Render();
  dress(false);
  const Frame expected = this->Render();
  Check("pixels of another colour", static_cast<double>(CountDifferent(got, expected, 1)), 0.0);
}

// An image that is given another, a light that goes, and one that is no spot any more.
TEST_F(LightFalloff, Changes)
{
  this->AddRoughFloor(6.0);
  LookAt(this->Renderer, { 0.0, -9.0, 7.0 }, { 0.0, 0.0, 0.0 });
  auto spot = AddSpot(this->Renderer, { 3.0, -3.0, 4.0 }, { 0.0, 0.3, 0.0 }, 40.0);
  const Frame plain = this->Render();
  auto image = Plain({ 100, 100, 100 });
  this->Shadows->SetLightTexture(spot, image);
  EXPECT_EQ(this->Shadows->GetLightTexture(spot), image.Get());
  const Frame dim = this->Render();
  CheckAtLeast(
    "pixels changed by an image", static_cast<double>(CountDifferent(dim, plain)), 5000.0);
  image->SetInputData(Plain({ 255, 255, 255 })->GetInput());
  Check("pixels unlike, of a white image",
    static_cast<double>(CountDifferent(this->Render(), plain)), 0.0);

  // It keeps its settings while it is no spot, and says so once.
  this->Shadows->SetLightSmoothCone(spot, 0.5);
  const Frame smooth = this->Render();
  spot->SetConeAngle(120.0);
  this->Render();
  ExpectOneMessage({ "Light 0", "no spot", "below 90 degrees" });
  this->Render();
  spot->SetConeAngle(40.0);
  Check("pixels unlike, a spot again", static_cast<double>(CountDifferent(this->Render(), smooth)),
    0.0);

  this->Shadows->ClearLightSettings(spot);
  EXPECT_EQ(this->Shadows->GetLightTexture(spot), nullptr);
  EXPECT_EQ(this->Shadows->GetLightSmoothCone(spot), 0.0);
  Check("pixels unlike, cleared", static_cast<double>(CountDifferent(this->Render(), plain)), 0.0);
}

TEST_F(LightFalloff, BadSettings)
{
  this->AddRoughFloor(6.0);
  LookAt(this->Renderer, { 0.0, -9.0, 7.0 }, { 0.0, 0.0, 0.0 });
  auto sun = AddSun(this->Renderer, { 1.0, 0.0, -1.0 });
  auto lamp = AddLamp(this->Renderer, { 0.0, 0.0, 3.0 });
  auto spot = AddSpot(this->Renderer, { 3.0, -3.0, 4.0 }, { 0.0, 0.3, 0.0 }, 40.0);
  const Frame plain = this->Render();
  const vtkSmartPointer<vtkTexture> image = Plain({ 100, 100, 100 });
  for (const auto& other : { sun, lamp })
  {
    this->Shadows->SetLightTexture(other, image);
    ExpectOneMessage({ "SetLightTexture", "no spot", "positional" });
    this->Shadows->SetLightSmoothCone(other, 0.5);
    ExpectOneMessage({ "SetLightSmoothCone", "no spot", "positional" });
  }
  this->Shadows->SetLightSmoothCone(spot, 1.5);
  ExpectOneMessage({ "SetLightSmoothCone", "1.5", "0 to 1" });
  this->Shadows->SetLightSmoothCone(spot, std::nan(""));
  ExpectOneMessage({ "SetLightSmoothCone", "nan", "0 to 1" });
  this->Shadows->SetLightTextureUp(spot, 0.0, 0.0, 0.0);
  ExpectOneMessage({ "SetLightTextureUp", "not zero" });
  this->Shadows->SetLightTextureUp(spot, 0.0, std::nan(""), 1.0);
  ExpectOneMessage({ "SetLightTextureUp", "nan", "finite" });
  vtkNew<vtkTexture> cube;
  cube->CubeMapOn();
  this->Shadows->SetLightTexture(spot, cube);
  ExpectOneMessage({ "SetLightTexture", "cube map", "single image" });
  EXPECT_EQ(this->Shadows->GetLightTexture(spot), nullptr);
  EXPECT_EQ(this->Shadows->GetLightSmoothCone(spot), 0.0);

  // What is wrong with an image is told once, and the light shines without it.
  vtkNew<vtkTexture> empty;
  this->Shadows->SetLightTexture(spot, empty);
  Check("pixels unlike, a texture without an image",
    static_cast<double>(CountDifferent(this->Render(), plain)), 0.0);
  ExpectOneMessage({ "Light 2", "has no image", "SetInputConnection" });
  this->Render();
  vtkNew<vtkImageData> block;
  block->SetDimensions(3, 3, 3);
  block->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  empty->SetInputData(block);
  Check("pixels unlike, an image of three dimensions",
    static_cast<double>(CountDifferent(this->Render(), plain)), 0.0);
  ExpectOneMessage({ "Light 2", "three dimensions", "slice" });
}
