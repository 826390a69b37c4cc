// Errors about the limits that pass for none, with what Core says of each, and the limits: JSON for
// the tests of those who have the rule in Python.
#include "Lot.h"
#include "TechniqueChoice.h"

#include <cmath>
#include <cstdio>

using namespace vtkshadows;

namespace
{

constexpr int Cases = 2000;

std::size_t Rounded(double value)
{
  return static_cast<std::size_t>(std::lround(value));
}

// Near to a limit, at it, or far below.
double About(testinglot::Lot& lot, double limit)
{
  const double which = lot.Any(0.0, 3.0);
  return which < 1.0 ? limit : which < 2.0 ? lot.Any(0.9, 1.1) * limit : lot.Any(0.0, 1.0) * limit;
}

VisibilityError ErrorByLot(testinglot::Lot& lot)
{
  VisibilityError error;
  error.receiverPixels = 100 * Rounded(std::pow(10.0, lot.Any(0.0, 4.0)));
  const double pixels = static_cast<double>(error.receiverPixels);
  error.grossFalsePixels = Rounded(lot.Any(0.0, 1.4) + lot.Any(0.0, 1.0) * 1.0e-5 * pixels);
  error.grossMissedPixels = Rounded(lot.Any(0.0, 0.9) + lot.Any(0.0, 0.5) * 1.0e-5 * pixels);
  error.mismatchPixels = Rounded(0.01 * About(lot, MostMismatchPercent) * pixels);
  error.sumAbsoluteDifference = 0.01 * About(lot, MostSoftDifferencePercent) * pixels;
  error.penumbraPixels = 1 + error.receiverPixels / 10;
  error.sumPenumbraDifference =
    0.01 * About(lot, MostPenumbraDifferencePercent) * static_cast<double>(error.penumbraPixels);
  return error;
}

}

int main()
{
  std::printf("{\"limits\": {\"gross_percent\": %.17g, \"gross_pixels\": %d, "
              "\"mismatch_percent\": %.17g, \"soft_difference_percent\": %.17g, "
              "\"penumbra_difference_percent\": %.17g},\n\"cases\": [",
    MostGrossPercent, MostGrossPixels, MostMismatchPercent, MostSoftDifferencePercent,
    MostPenumbraDifferencePercent);
  testinglot::Lot lot(1);
  for (int i = 0; i < Cases; ++i)
  {
    const bool isSoft = i % 2 != 0;
    const VisibilityError error = ErrorByLot(lot);
    const bool isRight = IsWithin({}, ErrorPercents::Of(error), isSoft, 1.0);
    std::printf("%s\n{\"soft\": %s, \"right\": %s, \"gross_false_pixels\": %zu, "
                "\"gross_missed_pixels\": %zu, \"gross_percent\": %.17g, "
                "\"mismatch_percent\": %.17g, \"mean_absolute_difference\": %.17g, "
                "\"mean_penumbra_difference\": %.17g}",
      i ? "," : "", isSoft ? "true" : "false", isRight ? "true" : "false", error.grossFalsePixels,
      error.grossMissedPixels, error.GrossPercent(), error.MismatchPercent(),
      error.MeanAbsoluteDifference(), error.MeanPenumbraDifference());
  }
  std::printf("\n]}\n");
}
