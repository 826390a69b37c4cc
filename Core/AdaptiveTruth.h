// The truth of a light with a radius, traced only as finely as telling an error needs: a few rays
// at every pixel, many at some of them, most of which lie in or beside a penumbra, and many
// wherever a technique seems to be grossly wrong. Plain C++, no VTK, no OpenGL.
#ifndef vtkshadows_AdaptiveTruth_h
#define vtkshadows_AdaptiveTruth_h

#include "VisibilityError.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace vtkshadows
{

class AdaptiveTruth
{
public:
  // Rays to as many samples of the light from each pixel i with which[i] not 0, starting so many
  // times the ray epsilon off their surfaces: their mean visibility into visibility[i], whose other
  // entries stay. false if it cannot.
  using Trace = std::function<bool(int samples, double epsilonScale,
    const std::vector<unsigned char>& which, std::vector<float>& visibility)>;

  struct Settings
  {
    int width = 0;
    int height = 0;
    int coarse = 8;             // rays at every pixel
    int fine = 256;             // rays where it is partial
    double partialPixels = 2e3; // in or beside what seems partial, from which differences are told
    double otherPixels = 1e3;   // and elsewhere, where few rays may have missed a part
    double edgeDistance = GrossDistance; // pixels, as of MeasureVisibility
    std::size_t checked = 1000; // pixels a measure that are traced finely for seeming gross
    // Mean differences, over all pixels and over the penumbra's, 0 to 1, that decide about what is
    // measured; 0: none. As long as one is too close to be told from it, more pixels are traced
    // finely, up to so many times the above.
    double meanLimit = 0.0;
    double penumbraLimit = 0.0;
    double meanTolerance = 0.0; // beside its limit, that the first need be known no better than
    double mostTimes = 16.0;
  };

  // `roles`: one a pixel, none of them Uncertain yet. false if a trace fails.
  bool Begin(const Settings& settings, std::vector<PixelRole> roles, Trace trace);

  // Hold `visibility`, one a pixel, against it. Differences and mismatch are of pixels chosen by
  // lot, each counted as often as there are of its kind; gross pixels and receiver pixels of all; a
  // mismatch is gross once fine rays say so. false if a trace fails.
  bool Measure(const std::vector<float>& visibility, VisibilityError& error);

  // For tests: pixels that many rays were traced from.
  std::size_t GetFinePixels() const;

private:
  // Standard errors of the means of a sample.
  struct Deviations
  {
    double mean = 0.0;
    double penumbra = 0.0;
  };

  bool TraceFinely(const std::vector<unsigned char>& which);
  bool TraceSample();
  VisibilityError DifferencesOf(const std::vector<float>& visibility, Deviations& deviations) const;
  bool HangsOnSample(const VisibilityError& error, const Deviations& deviations) const;
  VisibilityImages ImagesOf(const std::vector<float>& visibility) const;

  Settings With;
  Trace Tracer;
  double Times = 1.0; // as many pixels in the sample as Settings has
  std::vector<float> Truth;
  std::vector<PixelRole> Roles;
  std::vector<unsigned char> IsPartial; // or beside what seems so
  std::vector<unsigned char> IsSample;
  std::vector<unsigned char> IsFine;
};

}

#endif
