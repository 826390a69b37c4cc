// What was measured, as a table for people and as JSON for programs.
#ifndef vtkshadows_Report_h
#define vtkshadows_Report_h

#include "FrameTimings.h"

#include <vtkType.h>

#include <optional>
#include <string>
#include <vector>

namespace vtkshadows
{

// As vtkShadowErrorMeasure has it, against the ray-cast truth.
struct LightError
{
  vtkIdType receiverPixels = 0;
  vtkIdType shadowPixels = 0;
  vtkIdType grossFalsePixels = 0;
  vtkIdType grossMissedPixels = 0;
  double mismatchPercent = 0.0;
  double meanAbsoluteDifference = 0.0;
};

// One light by one technique. The timings are those of the whole frame, with all its lights.
struct ReportRow
{
  std::string technique;
  int light = 0;                   // from 0, as masks are numbered
  std::string explanation;         // why the light has this technique
  std::optional<LightError> error; // none without Embree
  int culledReceivers = 0;         // meshes of which hidden faces were left out
  FrameTimings timings;
};

struct Report
{
  std::vector<ReportRow> rows;
  std::string filter; // of depth maps
  int depthBits = 32; // the same
  vtkIdType triangles = 0;
  std::string vtkVersion;
  std::string openGLRenderer;
};

std::string TableOf(const Report& report);

// A line for each light that had its technique chosen; empty if there is none.
std::string ChoicesOf(const Report& report);

// An array of one object per technique and light; figures of the error are null where there is
// none, and so are filter and format of what is no depth map.
std::string JsonOf(const Report& report);

}

#endif
