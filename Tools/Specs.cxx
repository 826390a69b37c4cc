#include "Specs.h"

#include "SpecText.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace vtkshadows
{
namespace
{

// The sine below which the view's direction and its up vector count as parallel.
constexpr double ParallelSine = 1e-6;

glm::dvec3 Normalized(const glm::dvec3& vector)
{
  // Scaled first, so that neither tiny nor huge vectors leave the range when they are squared.
  const glm::dvec3 size = glm::abs(vector);
  return glm::normalize(vector / std::max({ size.x, size.y, size.z }));
}

void ParseGeometry(const SpecText& spec, const std::string& geometry, LightSpec& light)
{
  const std::vector<std::string> pieces = Split(geometry, ':');
  const std::string& kind = pieces.front();
  static const std::map<std::string, std::size_t> pieceCounts = { { "directional", 2 },
    { "spot", 4 }, { "point", 2 } };
  const auto known = pieceCounts.find(kind);
  if (known == pieceCounts.end())
  {
    spec.Fail("'" + kind + "' is no kind of light");
  }
  if (pieces.size() != known->second)
  {
    spec.Fail("a " + kind + " light has " + std::to_string(known->second - 1) +
      " part(s) after its kind, not " + std::to_string(pieces.size() - 1));
  }

  if (kind == "directional")
  {
    light.kind = LightKind::Directional;
    const glm::dvec3 travel = spec.Vector(pieces[1], "direction");
    if (travel == glm::dvec3(0.0))
    {
      spec.Fail("the light has no direction", "give a direction that is not zero, as 0.5,0.3,-1");
    }
    light.direction = Normalized(travel);
    return;
  }

  light.position = spec.Vector(pieces[1], "position");
  light.kind = kind == "spot" ? LightKind::Spot : LightKind::Point;
  if (light.kind == LightKind::Spot)
  {
    light.focalPoint = spec.Vector(pieces[2], "focal point");
    light.coneAngle = spec.Number(pieces[3], "cone angle");
    if (light.position == light.focalPoint)
    {
      spec.Fail("the light has no direction: its position is its focal point",
        "give a focal point that the light shines at");
    }
    if (!(light.coneAngle > 0.0 && light.coneAngle < 90.0))
    {
      spec.Fail("its cone angle is not between 0 and 90 degrees",
        "give the angle between the cone's axis and its side, as 30, or a point: light");
    }
  }
}

void ParseAttribute(
  const SpecText& spec, const std::string& key, const std::string& value, LightSpec& light)
{
  const auto atLeastZero = [&]()
  {
    const double number = spec.Number(value, key);
    if (number < 0.0)
    {
      spec.Fail("its " + key + " is negative", "give 0 or more");
    }
    return number;
  };

  if (key == "color")
  {
    light.color = spec.Vector(value, key);
    for (int i = 0; i < 3; ++i)
    {
      if (light.color[i] < 0.0 || light.color[i] > 1.0)
      {
        spec.Fail(
          "its color leaves 0 to 1", "give R,G,B from 0 to 1, and the rest as @intensity=V");
      }
    }
  }
  else if (key == "intensity")
  {
    light.intensity = atLeastZero();
  }
  else if (key == "radius")
  {
    light.radius = atLeastZero();
  }
  else if (key == "strength")
  {
    light.strength = spec.Number(value, key);
    if (light.strength < 0.0 || light.strength > 1.0)
    {
      spec.Fail("its strength leaves 0 to 1", "give 0 (no shadow) to 1 (full shadow)");
    }
  }
  else if (key == "distance")
  {
    light.distance = atLeastZero();
  }
  else if (key == "fade")
  {
    light.fade = spec.Number(value, key);
    if (light.fade < 0.0 || light.fade > 1.0)
    {
      spec.Fail("its fade leaves 0 to 1", "give the share of its distance, 0 to 1");
    }
  }
  else if (key == "falloff")
  {
    light.falloff = spec.Number(value, key);
    if (light.falloff < 0.0 || light.falloff > 1.0)
    {
      spec.Fail("its falloff leaves 0 to 1", "give the share of its cone's angle, 0 to 1");
    }
  }
  else if (key == "texture" && !value.empty())
  {
    light.texture = value;
  }
  else if (key == "technique" && !value.empty())
  {
    light.technique = value;
  }
  else
  {
    spec.Fail("'@" + key + "=" + value + "' is not understood",
      "use @color=R,G,B @intensity=V @radius=V @strength=V @distance=V @fade=V @falloff=V "
      "@texture=FILE.png @technique=NAME");
  }
}

}

LightSpec ParseLight(const std::string& text)
{
  const SpecText spec(
    "--light", text, "write directional:DX,DY,DZ or spot:PX,PY,PZ:FX,FY,FZ:CONE or point:PX,PY,PZ");
  const std::vector<std::string> parts = Split(text, '@');

  LightSpec light;
  ParseGeometry(spec, parts.front(), light);
  for (std::size_t i = 1; i < parts.size(); ++i)
  {
    const std::size_t equals = parts[i].find('=');
    const bool hasValue = equals != std::string::npos;
    ParseAttribute(spec, parts[i].substr(0, equals),
      hasValue ? parts[i].substr(equals + 1) : std::string(), light);
  }
  if (light.kind != LightKind::Spot && (light.falloff > 0.0 || !light.texture.empty()))
  {
    spec.Fail("only a spot has a cone to fall off in or to project an image through",
      "give a spot:PX,PY,PZ:FX,FY,FZ:CONE, or leave @falloff and @texture out");
  }
  return light;
}

CameraSpec ParseCamera(const std::string& text)
{
  const SpecText spec("--camera", text,
    "write PX,PY,PZ:FX,FY,FZ:UX,UY,UZ:ANGLE (position, focal point, up, view angle)");
  const std::vector<std::string> pieces = Split(text, ':');
  if (pieces.size() != 4)
  {
    spec.Fail("a camera has 4 parts, not " + std::to_string(pieces.size()));
  }

  CameraSpec camera;
  camera.position = spec.Vector(pieces[0], "position");
  camera.focalPoint = spec.Vector(pieces[1], "focal point");
  camera.up = spec.Vector(pieces[2], "up");
  camera.viewAngle = spec.Number(pieces[3], "view angle");
  if (camera.position == camera.focalPoint)
  {
    spec.Fail("its position is its focal point", "give a focal point that it looks at");
  }
  const glm::dvec3 view = Normalized(camera.focalPoint - camera.position);
  if (camera.up == glm::dvec3(0.0) ||
    glm::length(glm::cross(view, Normalized(camera.up))) < ParallelSine)
  {
    spec.Fail("its up vector is zero or along the view", "give an up vector across the view");
  }
  if (!(camera.viewAngle > 0.0 && camera.viewAngle < 180.0))
  {
    spec.Fail("its view angle is not between 0 and 180 degrees", "give one inside, as 30");
  }
  return camera;
}

FloorSpec ParseFloor(const std::string& text)
{
  const SpecText spec(
    "--floor", text, "write auto, none, catcher or NX,NY,NZ,D (the plane n.x = D)");
  FloorSpec floor;
  const std::map<std::string, FloorSpec::Kind> named = { { "auto", FloorSpec::Kind::Auto },
    { "catcher", FloorSpec::Kind::Catcher }, { "none", FloorSpec::Kind::None } };
  const auto known = named.find(text);
  if (known != named.end())
  {
    floor.kind = known->second;
    return floor;
  }

  const std::vector<double> numbers = spec.Numbers(text, 4, "plane");
  const glm::dvec3 normal(numbers[0], numbers[1], numbers[2]);
  if (normal == glm::dvec3(0.0))
  {
    spec.Fail("the plane has no normal", "give a normal that is not zero, as 0,0,1,0");
  }
  floor.kind = FloorSpec::Kind::Plane;
  floor.normal = Normalized(normal);
  floor.offset = numbers[3] / glm::dot(normal, floor.normal);
  return floor;
}

WindowSize ParseSize(const std::string& text)
{
  const SpecText spec("--size", text, "write WxH in pixels, as 1024x768");
  const std::vector<std::string> pieces = Split(text, 'x');
  if (pieces.size() != 2)
  {
    spec.Fail("a size has a width and a height");
  }

  int sides[2];
  for (int i = 0; i < 2; ++i)
  {
    const double number = spec.Number(pieces[i], i == 0 ? "width" : "height");
    if (number < 1.0)
    {
      spec.Fail("the window has no area");
    }
    if (number != std::floor(number) || number > 1e9)
    {
      spec.Fail("'" + pieces[i] + "' is no number of pixels");
    }
    sides[i] = static_cast<int>(number);
  }
  return { sides[0], sides[1] };
}

glm::dvec3 ParseUp(const std::string& text)
{
  const SpecText spec("--up", text, "write a vector that is not zero, as 0,1,0");
  const glm::dvec3 up = spec.Vector(text, "vector");
  if (up == glm::dvec3(0.0))
  {
    spec.Fail("the scene has no up");
  }
  return Normalized(up);
}

}
