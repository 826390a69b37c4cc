#include "BenchPlan.h"

#include "Failure.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace vtkshadows
{

const char* const MeshesScene = "meshes";

namespace
{

SceneSize SizeOf(const BenchOptions& options)
{
  SceneSize size;
  size.detail = options.detail.value_or(options.fast ? 0.25 : 1.0);
  size.triangles = options.triangles.value_or(options.fast ? 50'000 : 1'000'000);
  size.mesh = options.statue;
  size.volume = options.volume;
  return size;
}

std::vector<std::string> ScenesOf(const Options& options)
{
  const std::vector<std::string> known = SceneNames();
  std::vector<std::string> scenes;
  if (!options.inputs.empty())
  {
    scenes.push_back(MeshesScene);
  }
  for (const std::string& name : options.bench.scenes)
  {
    if (std::find(known.begin(), known.end(), name) == known.end())
    {
      std::string list;
      for (const std::string& each : known)
      {
        list += (list.empty() ? "" : ", ") + each;
      }
      throw Failure("--scenes", name.empty() ? "''" : name, "is no scene", "choose of " + list);
    }
    if (std::find(scenes.begin(), scenes.end(), name) == scenes.end())
    {
      scenes.push_back(name);
    }
  }
  return scenes.empty() ? known : scenes;
}

void AddScenes(std::vector<BenchRun>& plan, const Options& options)
{
  const BenchOptions& bench = options.bench;
  for (const std::string& scene : ScenesOf(options))
  {
    for (const BenchSetting& setting : BenchSettings())
    {
      if ((setting.fast || !bench.fast || !bench.settings.empty()) &&
        MatchesPatterns(setting.name, bench.settings))
      {
        plan.push_back({ scene, SizeOf(bench), BenchWindow(bench), setting, "", 0.0 });
      }
    }
  }
}

// One size of a scene for each value, by every setting.
void AddSweep(std::vector<BenchRun>& plan, const Options& options, const std::string& axis,
  const std::string& scene, const std::vector<double>& values)
{
  for (const double value : values)
  {
    SceneSize size = SizeOf(options.bench);
    WindowSize window = BenchWindow(options.bench);
    if (axis == "triangles")
    {
      size.triangles = static_cast<vtkIdType>(value);
    }
    else if (axis == "lights")
    {
      size.lights = static_cast<int>(value);
    }
    else if (axis == "pixels")
    {
      window.width = static_cast<int>(std::lround(std::sqrt(value * 4.0 / 3.0)));
      window.height = window.width * 3 / 4;
    }
    const std::vector<BenchSetting> settings =
      axis == "samples" ? SampledSettings(static_cast<int>(value)) : SweepSettings();
    for (const BenchSetting& setting : settings)
    {
      if (MatchesPatterns(setting.name, options.bench.settings))
      {
        plan.push_back({ scene, size, window, setting, axis, value });
      }
    }
  }
}

void AddSweeps(std::vector<BenchRun>& plan, const Options& options)
{
  const bool fast = options.bench.fast;
  using Values = std::vector<double>;
  AddSweep(plan, options, "triangles", "crowd",
    fast ? Values{ 2e4, 8e4, 3.2e5 } : Values{ 2e4, 8e4, 3.2e5, 1.28e6, 5.12e6 });
  AddSweep(
    plan, options, "lights", "still-life", fast ? Values{ 1, 4, 16 } : Values{ 1, 2, 4, 8, 16 });
  AddSweep(plan, options, "pixels", "still-life",
    fast ? Values{ 3e4, 1.2e5, 4.8e5 } : Values{ 3e4, 1.2e5, 4.8e5, 1.92e6 });
  AddSweep(
    plan, options, "samples", "still-life", fast ? Values{ 4, 16, 64 } : Values{ 4, 16, 64, 256 });
}

}

std::string BenchRun::Key() const
{
  std::ostringstream key;
  key << this->scene << "|" << this->setting.name;
  if (!this->axis.empty())
  {
    key << "|" << this->axis << "=" << this->value;
  }
  return key.str();
}

std::string BenchRun::SceneName() const
{
  std::ostringstream name;
  name << this->scene;
  if (!this->axis.empty() && this->axis != "samples")
  {
    name << ", " << this->axis << " " << std::setprecision(9) << this->value;
  }
  return name.str();
}

bool BenchRun::HasSceneOf(const BenchRun& other) const
{
  return this->scene == other.scene && this->size.detail == other.size.detail &&
    this->size.triangles == other.size.triangles && this->size.lights == other.size.lights &&
    this->window.width == other.window.width && this->window.height == other.window.height;
}

//------------------------------------------------------------------------------
std::vector<BenchRun> PlanBench(const Options& options)
{
  std::vector<BenchRun> plan;
  AddScenes(plan, options);
  if (options.bench.sweeps)
  {
    AddSweeps(plan, options);
  }
  if (plan.empty())
  {
    throw Failure("--settings", options.bench.settings, "is no part of a setting's name",
      "see the names with --list");
  }
  return plan;
}

std::string PlanKey(const Options& options)
{
  const BenchOptions& bench = options.bench;
  const SceneSize size = SizeOf(bench);
  const WindowSize window = BenchWindow(bench);
  const TimingPlan timing = BenchTiming(options);
  std::ostringstream key;
  key << "window " << window.width << "x" << window.height << ", detail " << size.detail
      << ", triangles of the crowd " << size.triangles << ", truth by " << TruthSamples(bench)
      << " samples, timing ";
  if (timing.rounds > 0)
  {
    key << timing.rounds << " rounds";
  }
  else
  {
    key << timing.seconds << " s";
  }
  key << (size.mesh.empty() ? "" : ", statue " + size.mesh)
      << (size.volume.empty() ? "" : ", volume " + size.volume);
  for (const std::string& input : options.inputs)
  {
    key << ", input " << input;
  }
  for (const double opacity : options.stage.opacities)
  {
    key << ", opacity " << opacity;
  }
  const StageSettings& stage = options.stage;
  key << (stage.translucentCasters == "none" ? ""
                                             : ", translucent casters " + stage.translucentCasters)
      << (stage.cullHiddenFaces ? ", hidden faces culled" : "");
  return key.str();
}

WindowSize BenchWindow(const BenchOptions& options)
{
  WindowSize window;
  window.width = options.fast ? 400 : 640;
  window.height = options.fast ? 300 : 480;
  return options.size.value_or(window);
}

TimingPlan BenchTiming(const Options& options)
{
  TimingPlan timing;
  timing.rounds = options.frames;
  timing.seconds = options.bench.seconds.value_or(options.bench.fast ? 0.2 : 0.7);
  return timing;
}

int TruthSamples(const BenchOptions& options)
{
  return options.fast ? 128 : 256;
}

}
