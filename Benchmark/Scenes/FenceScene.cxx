#include "SceneList.h"

#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cmath>

namespace vtkshadows::scenes
{

// Metres. The bars are as thin as a map's texels, and their receiver is many times as far away as
// they are high.
void MakeFence(SceneInMaking& scene)
{
  constexpr double Roof = 10.0, Sun = 42.0;
  constexpr double Length = 10.0, Bar = 0.04, Height = 1.8, Rail = 0.06;
  vtkRenderer* renderer = scene.renderer;
  const int bars = ScaledCells(90, scene.size.detail * scene.size.detail, 2);
  AddFloor(renderer, 40.0)->GetProperty()->SetColor(0.82, 0.8, 0.75);
  AddBox(renderer, { -7.0, 0.0, 0.0 }, { 7.0, 6.0, Roof })->GetProperty()->SetColor(0.8, 0.7, 0.6);
  for (int i = 0; i < bars; ++i)
  {
    const double x = Length * (double(i) / (bars - 1) - 0.5);
    AddBox(renderer, { x - 0.5 * Bar, 0.2, Roof }, { x + 0.5 * Bar, 0.2 + Bar, Roof + Height })
      ->GetProperty()
      ->SetColor(0.3, 0.35, 0.4);
  }
  for (const double height : { 0.1, Height })
  {
    AddBox(renderer, { -0.5 * Length, 0.2, Roof + height },
      { 0.5 * Length, 0.2 + Bar, Roof + height + Rail })
      ->GetProperty()
      ->SetColor(0.3, 0.35, 0.4);
  }
  scene.facts.closedCasters = true;
  scene.facts.planes = 1 + 6 * (bars + 3);
  scene.facts.selfShadows = false;
  scene.facts.facts.push_back({ "bars", double(bars), "" });
  scene.facts.facts.push_back({ "foot of the bars above ground", Roof, "m" });
  scene.facts.facts.push_back({ "sun above horizon", Sun, "degrees" });
  // From behind the house: its shadow ends in the bars'.
  scene.Add(AddSun(renderer, -Toward(-178.0, Sun)), 0.00465);
  const double reach = Roof / std::tan(std::acos(-1.0) * Sun / 180.0);
  scene.Show({ { 0.0, -reach - 0.6, 0.0 }, 4.5 }, 8.0, 40.0);
}

}
