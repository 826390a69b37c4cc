// The cases by subject, each in a file of its own; and what they share.
#ifndef vtkshadows_ExtremeCaseList_h
#define vtkshadows_ExtremeCaseList_h

#include "Extremes.h"

#include <glm/geometric.hpp>

#include <cstddef>

namespace vtkshadows
{

// The parts of the plain still life.
constexpr std::size_t Floor = 0, Ball = 1, Box = 2, Pillar = 3, Ring = 4;
constexpr double FloorHalf = 30.0; // farther than the plain view reaches
const glm::dvec3 BallCentre(-1.1, -0.9, 0.9);
constexpr double BallRadius = 0.9;
const glm::dvec3 Middle(0.0, 0.0, 0.8);
const glm::dvec3 TowardSpot = glm::normalize(glm::dvec3(3.5, -3.0, 6.5) - Middle);

std::string Text(double value); // as %g has it

// A spotlight; a point light from a cone of 90 degrees on.
ShadowLight SpotFrom(const glm::dvec3& position, const glm::dvec3& focus, double cone);
ShadowLight Sun(const glm::dvec3& along);
ShadowLight Lamp(const glm::dvec3& position);

class ExtremeCaseList
{
public:
  std::vector<ExtremeCase> all;

  ExtremeCase& Add(const std::string& kind, const std::string& value, bool looksPlain,
    const std::function<void(ExtremeScene&)>& change);
};

// Scales and offsets, near and far planes, views and windows, and these with a floor that casts.
void AddPlacements(ExtremeCaseList& cases);
void AddViews(ExtremeCaseList& cases);
void AddCellars(ExtremeCaseList& cases);
// Places of lights, cones, numbers of lights; a sun and a lamp at scales and offsets.
void AddLights(ExtremeCaseList& cases);
void AddOtherLights(ExtremeCaseList& cases);
// Floors and walls far wider than the still life, by themselves and as parts of other props.
void AddFloors(ExtremeCaseList& cases);
// Sizes and shapes of triangles, broken coordinates; matrices of actors.
void AddMeshes(ExtremeCaseList& cases);
void AddMatrices(ExtremeCaseList& cases);

}

#endif
