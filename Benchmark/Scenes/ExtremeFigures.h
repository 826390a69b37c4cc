// What was measured of an extreme, for programs: the table of the extremes and the bench write it.
#ifndef vtkshadows_ExtremeFigures_h
#define vtkshadows_ExtremeFigures_h

#include "ExtremeMeasure.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace vtkshadows
{

// Of a case by a technique. null stands where there is no such figure.
//   case                 string, "scale by points 1e-12": the kind and the value, with a blank
//   kind, value          strings, "scale by points" and "1e-12"
//   looks_plain          whether it shows what the plain still life shows, so that pictures compare
//   heavy                whether it takes minutes or gigabytes
//   beyond               whether it is beyond what floats, VTK or a technique can (see Extremes.h)
//   technique            string, "depth-map", or with a filter of it "depth-map exact"
//   drawn                whether a visibility came (without lights: a frame)
//   frame_unlike_percent `unlike`, of pixels of VTK's own frame without shadows, against the plain
//                        one's; null unless looks_plain
//   truth_alike_percent  of pixels of the truth, against the plain one's; null unless looks_plain
//   alike_percent        of pixels of the technique's visibility, against its plain one's; null
//                        unless looks_plain
//   receivers, shadowed, uncertain, mismatch, gross
//                        pixels, of the first and last light together (see vtkShadowErrorMeasure)
//   mismatch_percent     of receivers; null if there are none
//   opengl_error         the code of OpenGL's error, 0: none
//   messages             array of strings, what VTK or the technique said
nlohmann::ordered_json ExtremeFigures(const ExtremeCase& extreme, const std::string& technique,
  double unlike, const ExtremeOutcome& outcome, const std::vector<std::string>& messages);

}

#endif
