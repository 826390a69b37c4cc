// How far a visibility image is from the truth: mismatch, gross false and missed shadow, and the
// mean absolute difference (DESIGN: one contract, one truth). Plain arrays, no VTK.
#ifndef vtkshadows_VisibilityError_h
#define vtkshadows_VisibilityError_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkshadows
{

// What a pixel is to the measure. Ordered: only Measured pixels are counted.
enum class PixelRole : std::uint8_t
{
  Background = 0, // no receiver is seen there
  Grazing = 1,    // a receiver that the light does not reach: its face turns from it, or nearly so
                  // (N.L at most 0.02), or it lies outside a spot's cone
  Uncertain = 2,  // its truth hangs on the ray epsilon
  Measured = 3
};

// Times the ray epsilon: a truth that is another one from there on is uncertain.
constexpr double FartherEpsilonScale = 4.0;

// Images are width*height, row by row, all with the same origin.
struct VisibilityImages
{
  int width = 0;
  int height = 0;
  const float* visibility = nullptr; // of the technique, 0 shadow .. 1 lit
  const float* truth = nullptr;      // of the reference, 0 .. 1
  const PixelRole* role = nullptr;
};

struct VisibilityError
{
  std::size_t receiverPixels = 0;    // Measured
  std::size_t uncertainPixels = 0;   // Uncertain
  std::size_t shadowPixels = 0;      // Measured, truth at most 0.5
  std::size_t mismatchPixels = 0;    // Measured, |visibility - truth| above 0.5
  std::size_t grossFalsePixels = 0;  // mismatched far from any true edge: shadow where it is lit
  std::size_t grossMissedPixels = 0; // ... lit where it is shadow
  double sumAbsoluteDifference = 0.0;
  std::size_t penumbraPixels = 0;     // Measured, visibility or truth between 0 and 1
  double sumPenumbraDifference = 0.0; // absolute
  // Standard error of MeanPenumbraDifference, if the pixels stand for others; 0: not known.
  double penumbraDeviation = 0.0;

  std::size_t GrossPixels() const { return this->grossFalsePixels + this->grossMissedPixels; }
  double MismatchPercent() const;        // of the receiver pixels; 0 if there are none
  double GrossPercent() const;           // of the receiver pixels; 0 if there are none
  double MeanAbsoluteDifference() const; // over the receiver pixels; 0 if there are none
  double MeanPenumbraDifference() const; // over the penumbra pixels; 0 if there are none
};

// Standard errors from which on a mean is told from a limit.
constexpr double SureDeviations = 2.5;

// Of one pixel: what its visibility differs from the truth by.
struct PixelDifference
{
  double absolute = 0.0;
  bool isMismatch = false; // above 0.5, or not a number
  bool isPartial = false;  // visibility or truth lies between 0 and 1
};
PixelDifference DifferenceOf(float visibility, float truth);

// How one pixel fared, for error maps.
enum class PixelVerdict : std::uint8_t
{
  Background,
  Grazing,
  Uncertain,
  RightLit,
  RightShadow,
  FalseShadow,      // mismatch, within edgeDistance of a true edge
  MissedShadow,     // mismatch, within edgeDistance of a true edge
  GrossFalseShadow, // mismatch, farther
  GrossMissedShadow // mismatch, farther
};

// Pixels from a true edge beyond which a mismatch is gross.
constexpr double GrossDistance = 2.0;

// Measure `images`. A true shadow edge runs between two 4-neighbours that both show a receiver (any
// role but Background) and whose truths lie on different sides of 0.5; both pixels belong to it.
// A mismatch is gross if the nearest edge pixel's centre is more than `edgeDistance` pixels away
// (Euclidean; with no edge in the image every mismatch is gross).
// Throws std::invalid_argument if a size is not positive, an array is missing, or `edgeDistance`
// is negative or not finite.
// If `verdicts` is given it receives width*height entries.
VisibilityError MeasureVisibility(const VisibilityImages& images,
  double edgeDistance = GrossDistance, std::vector<PixelVerdict>* verdicts = nullptr);

}

#endif
