// How long a bench goes on, from how long it took so far.
#ifndef vtkshadows_BenchEstimate_h
#define vtkshadows_BenchEstimate_h

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace vtkshadows
{

struct BenchRun;

// A setting takes what it took on other scenes, on average, and one that was not met yet what the
// others took; building a scene and its truth take what they took for other scenes.
class BenchEstimate
{
public:
  // What a row says of itself, measured now or in the bench that goes on.
  void AddRow(const nlohmann::ordered_json& row);
  // What a scene took beside its rows.
  void AddScene(double seconds);

  // Of rows that are still to be measured, on so many scenes; seconds. Below 0: not known.
  double Of(const std::vector<const BenchRun*>& runs, int scenes) const;

  // What all of a row took, as it says itself; 0 where it does not.
  static double SecondsOf(const nlohmann::ordered_json& row);

  // "about 12 min", or "" where the seconds are below 0.
  static std::string Say(double seconds);

private:
  struct Mean
  {
    double sum = 0.0;
    int count = 0;
  };

  std::map<std::string, Mean> settings;
  Mean all, ofScenes;
};

}

#endif
