// What the user asked for, checked as far as that goes without reading a mesh or opening a window.
#ifndef vtkshadows_Options_h
#define vtkshadows_Options_h

#include "Stage.h"

#include <optional>
#include <string>
#include <vector>

namespace vtkshadows
{

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
};

}

#endif
