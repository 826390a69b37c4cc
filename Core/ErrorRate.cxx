#include "ErrorRate.h"

#include <algorithm>
#include <cmath>

namespace vtkshadows
{

void ErrorRate::Learn(double change, double drift)
{
  if (drift >= SmallestDrift && drift <= LargestDrift)
  {
    const double seen = std::clamp(change / drift, Least, Most);
    this->Rate = seen >= this->Rate ? seen : 0.5 * (this->Rate + seen);
  }
}

double ShareOfChange(double before, double after)
{
  return before == after ? 0.0 : std::abs(after - before) / std::min(before, after);
}

}
