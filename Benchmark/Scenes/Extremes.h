// The extremes: one still life with self-shadows over a floor, and what can be done to it that
// tries the numbers that shadows are made of. A case is a kind, a value and a change of the plain
// still life; `Build` puts the changed one on a renderer. Lengths in scene units: the still life is
// about 5 of them wide and stands on z = 0.
#ifndef vtkshadows_Extremes_h
#define vtkshadows_Extremes_h

#include "ShadowLight.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <string>
#include <vector>

class vtkLight;
class vtkRenderer;

namespace vtkshadows
{

// A mesh with its actor's matrix, which takes it to scene coordinates.
struct ExtremePart
{
  vtkSmartPointer<vtkPolyData> mesh;
  glm::dmat4 sceneFromModel{ 1.0 };
  glm::dvec3 colour{ 0.8, 0.8, 0.8 };
  bool isGrouped = false; // one prop with all others that are
};

// What the parts of one prop are.
enum class ExtremeGrouping
{
  Blocks,      // of composite data, drawn together
  BlockMeshes, // of composite data, each drawn by a mapper of its own
  Assembly     // actors
};

// All that makes a picture, in scene coordinates.
struct ExtremeScene
{
  std::vector<ExtremePart> parts; // the floor first
  ExtremeGrouping grouping = ExtremeGrouping::Blocks;
  std::vector<ShadowLight> lights; // the first is the one that is measured
  glm::dvec3 eye{ 0.0, 0.0, 0.0 };
  glm::dvec3 focus{ 0.0, 0.0, 0.0 };
  double viewAngle = 30.0;           // degrees, of the whole view from below to above
  double parallelScale = 0.0;        // half the height of a parallel view; 0: in perspective
  double clipping[2] = { 1.0, 2.0 }; // near and far plane, along the view

  // World coordinates are offset + scale * scene coordinates: by the points' own coordinates, which
  // are doubles, or by the actors' matrices.
  glm::dvec3 offset{ 0.0, 0.0, 0.0 };
  double scale = 1.0;
  bool byMatrix = false;

  int width = 320;
  int height = 240;
};

struct ExtremeCase
{
  std::string kind;  // "scale by points"
  std::string value; // "1e-12"
  // Shows what the plain still life shows, or what `plain` makes of it: its pictures can be held
  // against those.
  bool looksPlain = false;
  // Takes minutes or gigabytes.
  bool isHeavy = false;
  // Beyond what floats, VTK or a technique can: drawn without harm, but held to no figures.
  // Docs/Extremes.md says why.
  bool isBeyond = false;
  // The input is broken: a technique may say so, in one sentence.
  bool isBroken = false;
  std::function<void(ExtremeScene&)> change;
  std::function<void(ExtremeScene&)> plain; // one for all cases of a kind, or none

  std::string Name() const { return this->kind + " " + this->value; }
};

// The still life in the sight of a spotlight.
ExtremeScene PlainExtremeScene();

std::vector<ExtremeCase> ExtremeCases();

// In place of all that `renderer` shows and what lights it. The scene's lights in their order.
std::vector<vtkSmartPointer<vtkLight>> Build(const ExtremeScene& scene, vtkRenderer* renderer);

}

#endif
