#include "TimingRounds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace vtkshadows
{
namespace
{

// Standard error of the median over half the distance between the quartiles, times the root of the
// number, where values scatter as a normal distribution: sqrt(pi / 2) / 0.6745.
constexpr double ErrorOverSpread = 1.858;

double Quantile(std::vector<double> values, double share)
{
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const std::size_t low = static_cast<std::size_t>(at);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (at - static_cast<double>(low)) * (values[high] - values[low]);
}

}

double Median(std::vector<double> values)
{
  return Quantile(std::move(values), 0.5);
}

double Spread(std::vector<double> values)
{
  return 0.5 * (Quantile(values, 0.75) - Quantile(values, 0.25));
}

void TimingRounds::Add(const TimingRound& round)
{
  this->AddStill(round.unshadowed, round.still);
  this->AddMoving(round.unshadowed, round.moving);
}

void TimingRounds::AddStill(double unshadowedFrame, double frame)
{
  this->unshadowed.push_back(unshadowedFrame);
  this->still.push_back(frame);
  this->stillRatio.push_back(frame / unshadowedFrame);
  this->stillCost.push_back(frame - unshadowedFrame);
}

void TimingRounds::AddMoving(double unshadowedFrame, double frame)
{
  this->moving.push_back(frame);
  this->movingRatio.push_back(frame / unshadowedFrame);
  this->movingCost.push_back(frame - unshadowedFrame);
}

FrameTimings TimingRounds::Medians() const
{
  FrameTimings timings;
  timings.unshadowedMilliseconds = Median(this->unshadowed);
  timings.staticMilliseconds = Median(this->still);
  timings.movingMilliseconds = Median(this->moving);
  timings.staticRatio = Median(this->stillRatio);
  timings.movingRatio = Median(this->movingRatio);
  timings.staticCost = Median(this->stillCost);
  timings.movingCost = Median(this->movingCost);
  timings.staticSpread = Spread(this->still);
  timings.movingSpread = Spread(this->moving);
  timings.staticRatioSpread = Spread(this->stillRatio);
  timings.movingRatioSpread = Spread(this->movingRatio);
  timings.rounds = this->Count();
  return timings;
}

bool TimingRounds::AreSteady(double share) const
{
  if (this->stillRatio.size() < 3 || this->movingRatio.size() < 3)
  {
    return false;
  }
  const auto isSteady = [share](const std::vector<double>& ratios)
  {
    const double error =
      ErrorOverSpread * Spread(ratios) / std::sqrt(static_cast<double>(ratios.size()));
    return error <= share * Median(ratios);
  };
  return isSteady(this->stillRatio) && isSteady(this->movingRatio);
}

}
