#include "BenchReport.h"

#include "BenchExtremes.h"
#include "TechniqueChoice.h"

#include <cmath>
#include <map>
#include <sstream>
#include <utility>

namespace vtkshadows
{
namespace
{

using Json = BenchJournal::Json;

struct Points
{
  std::vector<double> values;
  std::vector<double> costs;
  int leftOut = 0; // of costs that are not above 0: smaller than the noise
};

Json FitsOf(const std::vector<Json>& rows)
{
  using AxisAndSetting = std::pair<std::string, std::string>;
  std::map<AxisAndSetting, Points> sweeps;
  for (const Json& row : rows)
  {
    if (row["axis"].is_null() || !row["failure"].is_null())
    {
      continue;
    }
    // Settings of the axis "samples" differ by their number of samples alone.
    std::string setting = row["setting"];
    if (row["axis"] == "samples")
    {
      setting = setting.substr(0, setting.rfind('/'));
    }
    Points& points = sweeps[{ row["axis"], setting }];
    const double cost = row["cost_ms_moving"];
    if (cost > 0.0)
    {
      points.values.push_back(row["value"]);
      points.costs.push_back(cost);
    }
    else
    {
      ++points.leftOut;
    }
  }
  Json fits = Json::array();
  for (const auto& [sweep, points] : sweeps)
  {
    const PowerLaw law = FitPowerLaw(points.values, points.costs);
    Json fit;
    fit["axis"] = sweep.first;
    fit["setting"] = sweep.second;
    fit["exponent"] = law.points ? Json(law.exponent) : nullptr;
    fit["exponent_error"] = law.points > 2 ? Json(law.exponentError) : nullptr;
    fit["factor_ms"] = law.points ? Json(law.factor) : nullptr;
    fit["points"] = points.values.size();
    fit["left_out"] = points.leftOut;
    fits.push_back(fit);
  }
  return fits;
}

const char* const RunColumns[] = { "scene", "setting", "technique", "soft", "resolution", "samples",
  "axis", "value", "width", "height", "triangles", "lights" };
const char* const ErrorColumns[] = { "light", "kind", "receiver_pixels", "shadow_pixels",
  "uncertain_pixels", "mismatch_percent", "gross_false_pixels", "gross_missed_pixels",
  "gross_percent", "mean_absolute_difference", "error_of_pictures_percent" };
const char* const CostColumns[] = { "frame_ms_unshadowed", "frame_ms_static", "frame_ms_moving",
  "spread_ms_static", "spread_ms_moving", "ratio_static", "ratio_moving", "cost_ms_static",
  "cost_ms_moving", "rounds", "texture_bytes", "caster_bytes", "failure" };

// As RFC 4180 has it.
std::string Cell(const Json& object, const char* key)
{
  if (!object.contains(key) || object[key].is_null())
  {
    return "";
  }
  if (!object[key].is_string())
  {
    return object[key].dump();
  }
  std::string quoted = "\"";
  for (const char c : object[key].get<std::string>())
  {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}

template <std::size_t N>
void AppendCells(std::vector<std::string>& cells, const Json& object, const char* const (&keys)[N])
{
  for (const char* key : keys)
  {
    cells.push_back(Cell(object, key));
  }
}

template <std::size_t N>
void AppendNames(std::vector<std::string>& cells, const char* const (&keys)[N])
{
  cells.insert(cells.end(), std::begin(keys), std::end(keys));
}

std::string LineOf(const std::vector<std::string>& cells)
{
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    line += (i ? "," : "") + cells[i];
  }
  return line + "\n";
}

}

PowerLaw FitPowerLaw(const std::vector<double>& values, const std::vector<double>& costs)
{
  PowerLaw law;
  const double n = static_cast<double>(values.size());
  double meanX = 0.0, meanY = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    meanX += std::log(values[i]) / n;
    meanY += std::log(costs[i]) / n;
  }
  double xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double x = std::log(values[i]) - meanX;
    xx += x * x;
    xy += x * (std::log(costs[i]) - meanY);
  }
  if (!(xx > 0.0))
  {
    return law;
  }
  law.points = static_cast<int>(values.size());
  law.exponent = xy / xx;
  law.factor = std::exp(meanY - law.exponent * meanX);
  double residuals = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double r = std::log(costs[i]) - meanY - law.exponent * (std::log(values[i]) - meanX);
    residuals += r * r;
  }
  law.exponentError = law.points > 2 ? std::sqrt(residuals / (n - 2.0) / xx) : -1.0;
  return law;
}

Json ReportOf(const BenchJournal& journal, const std::string& planKey)
{
  Json report;
  report["machine"] = journal.Machine();
  report["plan"] = planKey;
  report["limits"] = { { "gross_percent", MostGrossPercent }, { "gross_pixels", MostGrossPixels },
    { "mismatch_percent", MostMismatchPercent },
    { "soft_difference_percent", MostSoftDifferencePercent },
    { "penumbra_difference_percent", MostPenumbraDifferencePercent } };
  report["scenes"] = journal.Scenes();
  report["rows"] = journal.Rows();
  report["fits"] = FitsOf(journal.Rows());
  report["extremes"] = journal.Extremes(LightExtremes());
  return report;
}

std::string CsvOf(const BenchJournal& journal)
{
  std::vector<std::string> head;
  AppendNames(head, RunColumns);
  AppendNames(head, ErrorColumns);
  AppendNames(head, CostColumns);
  std::string csv = LineOf(head);
  for (const Json& row : journal.Rows())
  {
    // A line also of a row without errors.
    Json errors = row.value("errors", Json::array());
    if (errors.empty())
    {
      errors.push_back(Json::object());
    }
    for (const Json& error : errors)
    {
      std::vector<std::string> cells;
      AppendCells(cells, row, RunColumns);
      AppendCells(cells, error, ErrorColumns);
      AppendCells(cells, row, CostColumns);
      csv += LineOf(cells);
    }
  }
  return csv;
}

}
