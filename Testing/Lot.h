// Numbers by lot, the same on every machine for the same seed.
#ifndef vtkshadows_Lot_h
#define vtkshadows_Lot_h

#include <random>

namespace testinglot
{

class Lot
{
public:
  explicit Lot(int seed)
    : Random(seed)
  {
  }
  double Any(double low, double high)
  {
    return low + (high - low) * (this->Random() / double(this->Random.max()));
  }

private:
  std::mt19937 Random;
};

}

#endif
