#include "SceneList.h"

#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace vtkshadows::scenes
{

// Metres. A square grid of houses, each an actor of its own, as a city model has them.
void MakeCity(SceneInMaking& scene)
{
  constexpr double Pitch = 40.0, LowestRoof = 8.0, HighestRoof = 55.0;
  const int houses = ScaledCells(8, scene.size.detail, 1);
  const double half = 0.5 * Pitch * houses;
  AddFloor(scene.renderer, half + Pitch)->GetProperty()->SetColor(0.78, 0.78, 0.76);
  Lot any(5);
  for (int row = 0; row < houses; ++row)
  {
    for (int column = 0; column < houses; ++column)
    {
      const glm::dvec3 middle(Pitch * (column + 0.5) - half, Pitch * (row + 0.5) - half, 0.0);
      const double width = any(0.4, 0.75) * Pitch, depth = any(0.4, 0.75) * Pitch;
      const double share = any(0.0, 1.0);
      const double roof = LowestRoof + (HighestRoof - LowestRoof) * share * share;
      auto house = AddBox(
        scene.renderer, { -0.5 * width, -0.5 * depth, 0.0 }, { 0.5 * width, 0.5 * depth, roof });
      house->SetPosition(middle.x, middle.y, 0.0);
      house->RotateZ(any(-8.0, 8.0));
      const double tone = any(0.65, 0.95);
      house->GetProperty()->SetColor(tone, 0.95 * tone, any(0.75, 0.9) * tone);
    }
  }
  scene.facts.closedCasters = true;
  scene.facts.planes = 1 + 6 * houses * houses;
  scene.facts.facts.push_back({ "houses", double(houses) * houses, "" });
  scene.facts.facts.push_back({ "sun above horizon", 38.0, "degrees" });
  scene.Add(AddSun(scene.renderer, -Toward(-125.0, 38.0)), 0.00465);
  scene.Show({ { 0.0, 0.0, 10.0 }, 1.05 * half }, 25.0, 35.0);
}

}
