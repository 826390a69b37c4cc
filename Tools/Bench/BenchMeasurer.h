// Measures the runs of a bench on a stage, scene by scene: error, time, memory.
#ifndef vtkshadows_BenchMeasurer_h
#define vtkshadows_BenchMeasurer_h

#include "BenchEntrant.h"
#include "Stage.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkShadowErrorMeasure;

namespace vtkshadows
{

class BenchMeasurer
{
public:
  // Who is told of what there is, as soon as it is.
  struct Listener
  {
    // PNG bytes under a name, "still-life--planar--0.png".
    std::function<void(const std::string& name, const std::string& bytes)> picture;
    // What a scene is, when the stage has it.
    std::function<void(const BenchJson& facts)> scene;
    // Work on a run begins, or goes on.
    std::function<void(const BenchRun& run)> begin;
    // A row: what the run was, and every figure; or "failure", what VTK said.
    std::function<void(const BenchJson& row)> row;
  };

  BenchMeasurer(Stage& stage, const Options& options, Listener listener);
  ~BenchMeasurer();

  // Runs that have the same scene. First each run's errors, memory and stages, one after another;
  // then times, in rounds of short visits to all of them, each round shuffled anew, until each is
  // timed: so a busy spell of the machine meets a visit of many, and not all of one. A run that
  // fails says so in its row, and the others go on.
  void MeasureScene(const std::vector<const BenchRun*>& runs);

private:
  using Truths = std::vector<vtkSmartPointer<vtkShadowErrorMeasure>>;
  using Entrants = std::vector<std::unique_ptr<BenchEntrant>>;

  void ShowScene(const BenchRun& run);
  BenchJson FactsOfMeshes() const;
  // Does it, and says in the entrant's row what it cost, or why it failed; whether it did not fail.
  bool Try(BenchEntrant& entrant, const std::function<void()>& work);
  void Prepare(BenchEntrant& entrant);
  void TimeInTurn(Entrants entrants);
  void Finish(BenchEntrant& entrant);
  BenchJson ExplanationsOfChoice();
  // Of the scene shown, one a light; made once.
  Truths& TruthsOf(bool soft);
  BenchJson ErrorsOf(const BenchEntrant& entrant);
  // What reading a visibility off pictures does to one that is right: mismatch in percent.
  double ErrorOfPictures(std::size_t light);

  Stage& stage;
  const Options& options;
  Listener listener;
  std::optional<BenchRun> shown;
  std::map<bool, Truths> truths;
  std::map<std::size_t, double> errorsOfPictures;
};

// What a run is: the beginning of its row.
BenchJson DescribeRun(const BenchRun& run);

// What the machine is: VTK, OpenGL's renderer, cores.
BenchJson DescribeMachine(Stage& stage);

}

#endif
