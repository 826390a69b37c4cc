#include "ExtremeCaseList.h"
#include "ExtremeMeshes.h"

#include <glm/trigonometric.hpp>

#include <cmath>

namespace vtkshadows
{
namespace
{

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

}

//------------------------------------------------------------------------------
void AddPlacements(ExtremeCaseList& cases)
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

//------------------------------------------------------------------------------
void AddViews(ExtremeCaseList& cases)
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

//------------------------------------------------------------------------------
// With a ball beneath the floor, which then casts, too, and has a map fitted to it.
void AddCellars(ExtremeCaseList& cases)
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
  add("view 0.1 degrees, lamp within",
    [](ExtremeScene& scene)
    {
      SeeFromAfar(scene);
      scene.lights = { Lamp({ 0.1, 0.2, 2.0 }) };
    });
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

}
