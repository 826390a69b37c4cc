// The extremes among what a bench measures: what each technique makes of cases that try its
// numbers.
#ifndef vtkshadows_BenchExtremes_h
#define vtkshadows_BenchExtremes_h

#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <vector>

namespace vtkshadows
{

class Stage;

// Those that take neither minutes nor gigabytes, by name.
std::vector<std::string> LightExtremes();

// One of them by every technique: an array with an object a technique (see ExtremeFigures.h). Takes
// the stage's window, in which the stage's scene is not shown any more.
class BenchExtremes
{
public:
  explicit BenchExtremes(Stage& stage);
  ~BenchExtremes();
  BenchExtremes(const BenchExtremes&) = delete;
  BenchExtremes& operator=(const BenchExtremes&) = delete;

  nlohmann::ordered_json Measure(const std::string& name);

private:
  struct Internals;
  std::unique_ptr<Internals> internals;
};

}

#endif
