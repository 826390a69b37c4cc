#include "ExtremeCaseList.h"

#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace vtkshadows
{

//------------------------------------------------------------------------------
void AddLights(ExtremeCaseList& cases)
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

//------------------------------------------------------------------------------
// The same under a sun, and under a lamp amid the still life.
void AddOtherLights(ExtremeCaseList& cases)
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

}
