// What a technique makes of the extremes: its picture against its own of the plain still life, and
// against the truth there.
#ifndef vtkshadows_ExtremeMeasure_h
#define vtkshadows_ExtremeMeasure_h

#include "Extremes.h"

#include <vtkNew.h>
#include <vtkRenderer.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

class vtkRenderWindow;

namespace vtkshadows
{

// "depth-map", or "depth-map exact" with one of its filters.
std::vector<std::string> ExtremeTechniques();

struct ExtremeOutcome
{
  bool made = false; // a visibility was read back; of a scene without lights: a frame was drawn
  // Share of pixels, in percent, whose visibility lies on the same side of 0.5 as in the plain
  // still life, or what the case has in its place; negative where the case is not alike. The same
  // of the truth.
  double agreement = -1.0;
  double truthAgreement = -1.0;
  // Against the truth of the case itself, as vtkShadowErrorMeasure has it, of its first and last
  // light together. No truth without Embree: then 0 receivers.
  std::int64_t receivers = 0;
  std::int64_t shadowed = 0;
  std::int64_t uncertain = 0;
  std::int64_t mismatch = 0;
  std::int64_t gross = 0;
  unsigned int openGLError = 0;

  double MismatchPercent() const;
};

class ExtremeMeasure
{
public:
  // Draws in `window`, which it resizes, and which must live longer.
  explicit ExtremeMeasure(vtkRenderWindow* window);
  ~ExtremeMeasure();
  ExtremeMeasure(const ExtremeMeasure&) = delete;
  void operator=(const ExtremeMeasure&) = delete;

  ExtremeOutcome Measure(const ExtremeCase& extreme, const std::string& technique);

  // Share of pixels, in percent, in which VTK's own frame, without shadows, differs from that of
  // the plain still life, or what the case has in its place, by more than 8 of 255. Negative where
  // the case is not alike.
  double UnshadowedDifference(const ExtremeCase& extreme);

  // Where to write a picture of each error map and shadowed frame: PNGs into this folder, if not
  // "".
  std::string Pictures;

private:
  struct Images
  {
    std::vector<float> visibility, truth;
  };

  ExtremeOutcome MeasureScene(const ExtremeScene& scene, const std::string& technique,
    Images& first, const std::string& picture);
  std::vector<unsigned char> FrameOf(const ExtremeScene& scene);

  vtkRenderWindow* Window;
  vtkNew<vtkRenderer> Renderer;
  // By what they are of: "" is the plain still life, else the kind of cases with one of their own.
  std::map<std::string, std::map<std::string, Images>> Plain; // and by technique
  std::map<std::string, std::vector<unsigned char>> PlainFrames;
};

}

#endif
