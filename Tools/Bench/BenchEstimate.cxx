#include "BenchEstimate.h"

#include "BenchPlan.h"

#include <cmath>

namespace vtkshadows
{

void BenchEstimate::AddRow(const nlohmann::ordered_json& row)
{
  if (!row.contains("seconds"))
  {
    return;
  }
  const double seconds = SecondsOf(row);
  for (Mean* mean : { &this->settings[row.value("setting", "")], &this->all })
  {
    mean->sum += seconds;
    ++mean->count;
  }
}

double BenchEstimate::SecondsOf(const nlohmann::ordered_json& row)
{
  double sum = 0.0;
  for (const auto& seconds : row.value("seconds", nlohmann::ordered_json::object()))
  {
    sum += seconds.get<double>();
  }
  return sum;
}

void BenchEstimate::AddScene(double seconds)
{
  this->ofScenes.sum += seconds;
  ++this->ofScenes.count;
}

double BenchEstimate::Of(const std::vector<const BenchRun*>& runs, int scenes) const
{
  if (this->all.count == 0)
  {
    return -1.0;
  }
  double seconds = this->ofScenes.count ? scenes * this->ofScenes.sum / this->ofScenes.count : 0.0;
  for (const BenchRun* run : runs)
  {
    const auto known = this->settings.find(run->setting.name);
    const Mean& mean = known == this->settings.end() ? this->all : known->second;
    seconds += mean.sum / mean.count;
  }
  return seconds;
}

std::string BenchEstimate::Say(double seconds)
{
  return seconds < 0.0 ? ""
    : seconds < 90.0   ? "about " + std::to_string(std::lround(seconds)) + " s"
                       : "about " + std::to_string(std::lround(seconds / 60.0)) + " min";
}

}
