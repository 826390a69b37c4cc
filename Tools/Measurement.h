// Masks, errors and times of the technique that a stage shows.
#ifndef vtkshadows_Measurement_h
#define vtkshadows_Measurement_h

#include "Report.h"

#include <string>
#include <vector>

namespace vtkshadows
{

class Progress;
class Stage;

// Whether errors can be measured: the truth is a ray cast, and this build may have none.
bool CanMeasureErrors(Stage& stage);

// PNG bytes of one light's visibility. The stage has rendered.
std::string VisibilityPng(Stage& stage, std::size_t light);

struct MeasuredError
{
  LightError error;
  std::string errorMapPng;
};

// One light's error. The stage has rendered, and CanMeasureErrors.
MeasuredError MeasureError(Stage& stage, std::size_t light);

// A report without rows: what is the same for all of them.
Report BeginReport(Stage& stage);

}

#endif
