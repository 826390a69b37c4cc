// Measures runs of a bench on a stage, one after another: error, time, memory.
#ifndef vtkshadows_BenchMeasurer_h
#define vtkshadows_BenchMeasurer_h

#include "BenchPlan.h"
#include "Stage.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <map>
#include <optional>
#include <vector>

class vtkShadowErrorMeasure;

namespace vtkshadows
{

class Progress;

using BenchJson = nlohmann::ordered_json;

class BenchMeasurer
{
public:
  // Takes PNG bytes under a name, "still-life--planar--0.png".
  using Pictures = std::function<void(const std::string& name, const std::string& bytes)>;

  BenchMeasurer(Stage& stage, const Options& options, Progress& progress, Pictures pictures);
  ~BenchMeasurer();

  // One row: what the run was, and every figure; or "failure", what VTK said. What the scene of a
  // run is, is handed to `sceneShown` when the stage first has it.
  BenchJson Measure(const BenchRun& run, const std::function<void(const BenchJson&)>& sceneShown);

private:
  using Truths = std::vector<vtkSmartPointer<vtkShadowErrorMeasure>>;

  void ShowScene(const BenchRun& run, const std::function<void(const BenchJson&)>& sceneShown);
  BenchJson FactsOfMeshes() const;
  void MeasureInto(BenchJson& row, const BenchRun& run);
  // Of the scene shown, one a light; made once.
  BenchJson ExplanationsOfChoice();
  Truths& TruthsOf(bool soft);
  BenchJson ErrorsOf(const BenchRun& run, vtkRenderPass* peer);
  // What reading a visibility off pictures does to one that is right: mismatch in percent.
  double ErrorOfPictures(std::size_t light);

  Stage& stage;
  const Options& options;
  Progress& progress;
  Pictures pictures;
  std::optional<BenchRun> shown;
  std::map<bool, Truths> truths;
  std::map<std::size_t, double> errorsOfPictures;
};

// What the machine is: VTK, OpenGL's renderer, cores.
BenchJson DescribeMachine(Stage& stage);

}

#endif
