// What a bench measures, run by run, in order.
#ifndef vtkshadows_BenchPlan_h
#define vtkshadows_BenchPlan_h

#include "BenchSettings.h"
#include "Options.h"
#include "Scenes.h"

#include <string>
#include <vector>

namespace vtkshadows
{

// The user's own meshes, among the scenes.
extern const char* const MeshesScene;

// How often the frames of a setting are timed. `rounds` 0: in short visits until the ratios are
// steady or `seconds` are spent, 3 to 15, 5 unless they are steady, and fewer of what would take
// many times as long; what takes longer than `seconds` for a frame, by a single one of each kind.
struct TimingPlan
{
  int rounds = 0;
  double seconds = 0.0;
};

struct BenchRun
{
  std::string scene; // of the registry, or MeshesScene
  SceneSize size;
  WindowSize window;
  BenchSetting setting;
  std::string axis; // of a sweep: "triangles", "lights", "pixels" or "samples"; else empty
  double value = 0.0;

  // No two runs of a plan have the same.
  std::string Key() const;
  // "crowd", or of a sweep "crowd, triangles 20000".
  std::string SceneName() const;
  // Whether both show the same picture, but for shadows.
  bool HasSceneOf(const BenchRun& other) const;
};

// Throws Failure for a scene or a pattern that there is not.
std::vector<BenchRun> PlanBench(const Options& options);

// What decides about the figures, for a journal that goes on; one line.
std::string PlanKey(const Options& options);

WindowSize BenchWindow(const BenchOptions& options);
TimingPlan BenchTiming(const Options& options);
// Sample lights of the truth of a soft light.
int TruthSamples(const BenchOptions& options);

}

#endif
