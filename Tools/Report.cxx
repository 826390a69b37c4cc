#include "Report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace vtkshadows
{
namespace
{

std::string Fixed(double number, int digits)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", digits, number);
  return text;
}

using Cells = std::vector<std::string>;

Cells CellsOf(const ReportRow& row)
{
  Cells cells = { row.technique, std::to_string(row.light) };
  if (row.error)
  {
    const LightError& error = *row.error;
    cells.insert(cells.end(),
      { std::to_string(error.receiverPixels), std::to_string(error.shadowPixels),
        Fixed(error.mismatchPercent, 4), std::to_string(error.grossFalsePixels),
        std::to_string(error.grossMissedPixels), Fixed(error.meanAbsoluteDifference, 6) });
  }
  else
  {
    cells.insert(cells.end(), 6, "-");
  }
  const FrameTimings& timings = row.timings;
  cells.insert(cells.end(),
    { Fixed(timings.unshadowedMilliseconds, 2), Fixed(timings.staticMilliseconds, 2),
      Fixed(timings.movingMilliseconds, 2), Fixed(timings.staticRatio, 2),
      Fixed(timings.movingRatio, 2) });
  return cells;
}

// Columns as wide as their widest cell, the first to the left and the others to the right.
std::string Aligned(const std::vector<Cells>& lines)
{
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const Cells& cells : lines)
  {
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      widths[i] = std::max(widths[i], cells[i].size());
    }
  }

  std::ostringstream table;
  for (const Cells& cells : lines)
  {
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      const std::string padding(widths[i] - cells[i].size(), ' ');
      table << (i == 0 ? cells[i] + padding : "  " + padding + cells[i]);
    }
    table << '\n';
  }
  return table.str();
}

nlohmann::ordered_json ObjectOf(const ReportRow& row, const Report& report)
{
  nlohmann::ordered_json object;
  object["technique"] = row.technique;
  object["light"] = row.light;
  object["explanation"] = row.explanation;
  object["filter"] = nullptr;
  object["depth_bits"] = nullptr;
  if (row.technique == "depth-map")
  {
    object["filter"] = report.filter;
    object["depth_bits"] = report.depthBits;
  }
  const auto put = [&](const char* key, auto member)
  { object[key] = row.error ? nlohmann::ordered_json((*row.error).*member) : nullptr; };
  put("receiver_pixels", &LightError::receiverPixels);
  put("shadow_pixels", &LightError::shadowPixels);
  put("mismatch_percent", &LightError::mismatchPercent);
  object["gross_pixels"] = nullptr;
  if (row.error)
  {
    object["gross_pixels"] = row.error->grossFalsePixels + row.error->grossMissedPixels;
  }
  put("gross_false_pixels", &LightError::grossFalsePixels);
  put("gross_missed_pixels", &LightError::grossMissedPixels);
  put("mean_absolute_difference", &LightError::meanAbsoluteDifference);
  object["culled_receivers"] = row.culledReceivers;
  object["frame_ms_unshadowed"] = row.timings.unshadowedMilliseconds;
  object["frame_ms_static"] = row.timings.staticMilliseconds;
  object["frame_ms_moving"] = row.timings.movingMilliseconds;
  object["ratio_static"] = row.timings.staticRatio;
  object["ratio_moving"] = row.timings.movingRatio;
  object["triangles"] = report.triangles;
  object["vtk_version"] = report.vtkVersion;
  object["gl_renderer"] = report.openGLRenderer;
  return object;
}

}

std::string TableOf(const Report& report)
{
  std::vector<Cells> lines = { { "", "", "receiver", "shadow", "mismatch", "gross", "gross",
                                 "mean abs.", "ms", "ms", "ms", "static", "moving" },
    { "technique", "light", "pixels", "pixels", "%", "false", "missed", "difference", "unshadowed",
      "static", "moving", "ratio", "ratio" } };
  for (const ReportRow& row : report.rows)
  {
    lines.push_back(CellsOf(row));
  }
  return Aligned(lines) + std::to_string(report.triangles) + " triangles, VTK " +
    report.vtkVersion + ", " + report.openGLRenderer + "\n";
}

std::string ChoicesOf(const Report& report)
{
  std::string text;
  for (const ReportRow& row : report.rows)
  {
    if (row.technique == "auto")
    {
      text += "auto, light " + std::to_string(row.light) + ": " + row.explanation + "\n";
    }
  }
  return text;
}

std::string JsonOf(const Report& report)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ReportRow& row : report.rows)
  {
    list.push_back(ObjectOf(row, report));
  }
  return list.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}
