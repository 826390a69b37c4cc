// What the user asked for, checked as far as that goes without reading a mesh or opening a window.
#ifndef vtkshadows_Options_h
#define vtkshadows_Options_h

#include "Stage.h"

#include <optional>
#include <string>
#include <vector>

namespace vtkshadows
{

// Of bench. What is not given follows from whether it is the fast one.
struct BenchOptions
{
  std::vector<std::string> scenes; // none: all of the registry, or the meshes that are given
  std::string settings;            // see MatchesPatterns
  bool fast = false;
  bool sweeps = false;
  bool extremes = false;
  bool resume = false;
  bool list = false;             // say the names of scenes and settings, and do nothing
  std::optional<double> seconds; // of timing, a run
  std::optional<double> detail;  // see SceneSize, as the following
  std::optional<vtkIdType> triangles;
  std::string statue;
  std::string volume;
  std::optional<WindowSize> size;
};

struct Options
{
  std::vector<std::string> inputs;
  std::string output;                  // render: the picture; compare: the folder
  std::vector<std::string> techniques; // render: one; compare: at least one
  std::string debugView = "none";      // render
  StageSettings stage;
  std::optional<std::string> visibility; // the masks' name, with .png
  std::optional<std::string> json;
  std::optional<double> isovalue;
  int frames = 0; // rounds of timing; 0: chosen
  bool quiet = false;
  BenchOptions bench;
};

}

#endif
