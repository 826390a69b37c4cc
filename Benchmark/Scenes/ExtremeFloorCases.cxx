#include "ExtremeCaseList.h"
#include "ExtremeMeshes.h"

#include <functional>
#include <string>

namespace vtkshadows
{
namespace
{

// Half of the still life's own width.
constexpr double StillLifeHalf = 2.5;

// Walls close behind the still life and beside it, where its shadows fall.
constexpr double WallBehind = 2.5, WallBeside = -3.2;

using Widen = std::function<void(ExtremeScene&, double half)>;

// A floor, and what else there is, of a width given by its half: against 100 times as wide as the
// still life. As wide as in the plain still life it casts, and maps have other texels.
void AddWidths(ExtremeCaseList& cases, const std::string& kind, const Widen& widen)
{
  for (const double times : { FloorHalf / StillLifeHalf, 1e2, 1e4, 1e6 })
  {
    ExtremeCase& added = cases.Add(kind + " wider by", Text(times), times >= 1e2,
      [=](ExtremeScene& scene) { widen(scene, StillLifeHalf * times); });
    added.plain = [=](ExtremeScene& scene) { widen(scene, StillLifeHalf * 1e2); };
  }
}

void AddWall(
  ExtremeScene& scene, const glm::dvec3& corner, const glm::dvec3& right, const glm::dvec3& up)
{
  ExtremePart wall;
  wall.mesh = MakeRectangle(corner, right, up);
  scene.parts.push_back(wall);
}

void WidenFloor(ExtremeScene& scene, double half)
{
  scene.parts[Floor].mesh = MakeFloor(half);
}

// What lies beneath it is not seen.
void WidenFloorOverBall(ExtremeScene& scene, double half)
{
  WidenFloor(scene, half);
  ExtremePart ball;
  ball.mesh = MakeBall({ 2.0, 1.0, -1.5 }, 0.5);
  scene.parts.push_back(ball);
}

// They cross: each has a half behind the other one.
void WidenFloorAndWall(ExtremeScene& scene, double half)
{
  WidenFloor(scene, half);
  AddWall(
    scene, { -half, WallBehind, -half }, { half, WallBehind, -half }, { -half, WallBehind, half });
}

// They meet in the corner of a room.
void WidenRoom(ExtremeScene& scene, double half)
{
  scene.parts[Floor].mesh = MakeRectangle(
    { WallBeside, -half, 0.0 }, { half, -half, 0.0 }, { WallBeside, WallBehind, 0.0 });
  AddWall(scene, { WallBeside, WallBehind, 0.0 }, { half, WallBehind, 0.0 },
    { WallBeside, WallBehind, half });
  AddWall(scene, { WallBeside, -half, 0.0 }, { WallBeside, WallBehind, 0.0 },
    { WallBeside, -half, half });
}

void WidenFloorOfBlocks(ExtremeScene& scene, double half, ExtremeGrouping grouping)
{
  scene.parts[Floor].mesh =
    MakeRectangle({ -half, -half, 0.0 }, { 0.0, -half, 0.0 }, { -half, half, 0.0 });
  AddWall(scene, { 0.0, -half, 0.0 }, { half, -half, 0.0 }, { 0.0, half, 0.0 });
  scene.parts.front().isGrouped = scene.parts.back().isGrouped = true;
  scene.grouping = grouping;
}

void WidenFloorAmongOthers(ExtremeScene& scene, double half, ExtremeGrouping grouping)
{
  WidenFloor(scene, half);
  for (ExtremePart& part : scene.parts)
  {
    part.isGrouped = true;
  }
  scene.grouping = grouping;
}

}

//------------------------------------------------------------------------------
void AddFloors(ExtremeCaseList& cases)
{
  for (const double times : { 1e2, 1e4, 1e6 })
  {
    cases.Add("floor wider by", Text(times), true,
      [=](ExtremeScene& scene) { scene.parts[Floor].mesh = MakeFloor(2.5 * times); });
  }
  cases.Add("floor wider by", "1e+06, parallel view", false,
    [](ExtremeScene& scene)
    {
      scene.parts[Floor].mesh = MakeFloor(2.5e6);
      scene.parallelScale = 2.6;
      scene.clipping[1] = 80.0;
    });
  AddWidths(cases, "floor over a ball", WidenFloorOverBall);
  AddWidths(cases, "floor and wall", WidenFloorAndWall);
  AddWidths(cases, "floor and walls of a room", WidenRoom);
  const struct
  {
    const char* name;
    ExtremeGrouping grouping;
  } groupings[] = { { "composite data", ExtremeGrouping::Blocks },
    { "composite data, block by block,", ExtremeGrouping::BlockMeshes },
    { "an assembly", ExtremeGrouping::Assembly } };
  for (const auto& group : groupings)
  {
    const ExtremeGrouping grouping = group.grouping;
    AddWidths(cases, std::string("floor of ") + group.name,
      [=](ExtremeScene& scene, double half) { WidenFloorOfBlocks(scene, half, grouping); });
    AddWidths(cases, std::string("floor with all else in ") + group.name,
      [=](ExtremeScene& scene, double half) { WidenFloorAmongOthers(scene, half, grouping); });
  }
}

}
