#include "Jobs.h"

#include "BenchEstimate.h"
#include "BenchExtremes.h"
#include "BenchJournal.h"
#include "BenchMeasurer.h"
#include "BenchPage.h"
#include "BenchPlan.h"
#include "BenchReport.h"
#include "Display.h"
#include "Failure.h"
#include "OutputFiles.h"
#include "Progress.h"
#include "SharedSteps.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <utility>

namespace vtkshadows
{
namespace
{

namespace fs = std::filesystem;

void ListNames()
{
  std::cout << "scenes:\n";
  for (const std::string& name : SceneNames())
  {
    std::cout << "  " << name << ": " << SceneDescription(name) << "\n";
  }
  std::cout << "settings (* in the fast bench, too):\n";
  for (const BenchSetting& setting : BenchSettings())
  {
    std::cout << (setting.fast ? "* " : "  ") << setting.name << "\n";
  }
}

void MakeFolder(const fs::path& folder)
{
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
  {
    throw Failure(
      "-o", folder.string(), "cannot be made (" + error.message() + ")", "choose another place");
  }
}

void RequireScenesFiles(const BenchOptions& bench)
{
  for (const auto& [option, path] :
    { std::pair<const char*, std::string>("--statue", bench.statue), { "--volume", bench.volume } })
  {
    if (!path.empty() && !fs::is_regular_file(path))
    {
      throw Failure(option, path, "no such file", "give one that there is");
    }
  }
}

using Runs = std::vector<const BenchRun*>;

// Runs of the same scene that follow each other.
std::vector<Runs> ByScene(const Runs& runs)
{
  std::vector<Runs> scenes;
  for (const BenchRun* run : runs)
  {
    if (scenes.empty() || !scenes.back().front()->HasSceneOf(*run))
    {
      scenes.emplace_back();
    }
    scenes.back().push_back(run);
  }
  return scenes;
}

BenchJournal::Json FailedRow(const BenchRun& run)
{
  BenchJournal::Json row = DescribeRun(run);
  row["failure"] = "the bench ended in it twice; measure it alone, in another folder";
  return row;
}

// What is still to be measured, and how long that takes.
class Agenda
{
public:
  Agenda(const BenchJournal& journal, const std::vector<BenchRun>& plan)
  {
    for (const BenchRun& run : plan)
    {
      if (!journal.HasRow(run.Key()))
      {
        this->open.push_back(&run);
      }
    }
    this->total = this->open.size();
    for (const BenchJournal::Json& row : journal.Rows())
    {
      this->estimate.AddRow(row);
    }
  }

  const Runs& Open() const { return this->open; }

  void BeginScene(std::size_t scenesLeft)
  {
    this->scenes = static_cast<int>(scenesLeft);
    this->sceneBegin = Clock::now();
    this->rowsSeconds = 0.0;
  }
  // How long the scene took beside its rows, for those that follow.
  void EndScene()
  {
    const std::chrono::duration<double> taken = Clock::now() - this->sceneBegin;
    this->estimate.AddScene(std::max(taken.count() - this->rowsSeconds, 0.0));
  }
  void EndRow(const BenchJournal::Json& row)
  {
    this->estimate.AddRow(row);
    this->rowsSeconds += BenchEstimate::SecondsOf(row);
    const auto isIt = [&row](const BenchRun* run) { return run->Key() == row["key"]; };
    this->open.erase(std::remove_if(this->open.begin(), this->open.end(), isIt), this->open.end());
  }

  // "12 of 187 done, about 3 min left".
  std::string Say() const
  {
    const std::string time = BenchEstimate::Say(this->estimate.Of(this->open, this->scenes));
    return std::to_string(this->total - this->open.size()) + " of " + std::to_string(this->total) +
      " done" + (time.empty() ? "" : ", " + time + " left");
  }

private:
  using Clock = std::chrono::steady_clock;
  Runs open;
  std::size_t total = 0;
  BenchEstimate estimate;
  int scenes = 0;
  Clock::time_point sceneBegin;
  double rowsSeconds = 0.0;
};

std::unique_ptr<Stage> OpenStage(const Options& options, Progress& progress)
{
  Options prepared = options;
  prepared.stage.size = BenchWindow(options.bench);
  if (!options.inputs.empty())
  {
    return PrepareStage(prepared, progress);
  }
  ProvideDisplay();
  return std::make_unique<Stage>(prepared.stage);
}

void MeasureExtremes(Stage& stage, BenchJournal& journal, Progress& progress)
{
  std::vector<std::string> open;
  for (const std::string& name : LightExtremes())
  {
    if (!journal.HasExtreme(name))
    {
      open.push_back(name);
    }
  }
  if (open.empty())
  {
    return;
  }
  progress.Note("extremes: " + std::to_string(open.size()) + " cases, a few minutes");
  BenchExtremes extremes(stage);
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    progress.Begin(
      std::to_string(i) + " of " + std::to_string(open.size()) + " extremes done: " + open[i]);
    journal.AddExtreme(open[i], extremes.Measure(open[i]));
  }
}

void WriteReport(const BenchJournal& journal, const std::string& planKey, const fs::path& folder,
  Progress& progress)
{
  progress.Begin("writing the report");
  const BenchJournal::Json report = ReportOf(journal, planKey);
  OutputFiles outputs({});
  outputs.Add(folder / "bench.json",
    report.dump(1, ' ', false, BenchJournal::Json::error_handler_t::replace) + "\n");
  outputs.Add(folder / "bench.csv", CsvOf(journal));
  if (CanMakePage())
  {
    outputs.Add(folder / "bench.html", PageOf(report, folder / "pictures"));
  }
  outputs.Commit();
  progress.End();
  if (!CanMakePage())
  {
    progress.Note("note: no bench.html is written: this build has no Chart.js; install "
                  "libjs-chart.js and configure it again");
  }
}

}

void RunBench(const Options& options, Progress& progress)
{
  if (options.bench.list)
  {
    ListNames();
    return;
  }
  RequireMeshFiles(options.inputs);
  RequireScenesFiles(options.bench);
  const std::vector<BenchRun> plan = PlanBench(options);
  const fs::path folder = options.output;
  OutputFiles(options.inputs).RequireFolder("-o", options.output);
  const std::string planKey = PlanKey(options);
  if (fs::exists(folder / "journal.jsonl"))
  {
    BenchJournal(folder, planKey, options.bench.resume); // found out before the window opens
  }

  const std::unique_ptr<Stage> stage = OpenStage(options, progress);
  MakeFolder(folder / "pictures");
  BenchJournal journal(folder, planKey, options.bench.resume);
  journal.SetMachine(DescribeMachine(*stage));
  NoteLimitsOfErrors(*stage, progress);

  Agenda agenda(journal, plan);
  if (agenda.Open().size() < plan.size())
  {
    progress.Note("going on: " + std::to_string(plan.size() - agenda.Open().size()) + " of " +
      std::to_string(plan.size()) + " are measured");
  }
  std::size_t failures = 0;
  BenchMeasurer::Listener listener;
  listener.picture = [&folder](const std::string& name, const std::string& bytes)
  {
    OutputFiles picture({});
    picture.Add(folder / "pictures" / name, bytes);
    picture.Commit();
  };
  listener.scene = [&journal](const BenchJson& facts) { journal.AddScene(facts); };
  listener.begin = [&](const BenchRun& run)
  {
    journal.Begin(run.Key());
    progress.Begin(agenda.Say() + ": " + run.Key());
  };
  listener.row = [&](const BenchJson& row)
  {
    failures += row["failure"].is_null() ? 0 : 1;
    journal.AddRow(row);
    agenda.EndRow(row);
  };
  for (const BenchRun& run : plan)
  {
    if (!journal.HasRow(run.Key()) && journal.EndedTwiceIn(run.Key()))
    {
      listener.row(FailedRow(run));
    }
  }
  BenchMeasurer measurer(*stage, options, listener);
  const std::vector<Runs> scenes = ByScene(agenda.Open());
  for (std::size_t i = 0; i < scenes.size(); ++i)
  {
    agenda.BeginScene(scenes.size() - i);
    progress.Note(scenes[i].front()->SceneName() + ": " + std::to_string(scenes[i].size()) +
      " settings; " + agenda.Say());
    measurer.MeasureScene(scenes[i]);
    agenda.EndScene();
  }
  if (options.bench.extremes)
  {
    MeasureExtremes(*stage, journal, progress);
  }
  std::vector<std::string> order;
  for (const BenchRun& run : plan)
  {
    order.push_back(run.Key());
  }
  journal.SortRows(order);
  WriteReport(journal, planKey, folder, progress);
  if (!options.quiet)
  {
    std::cout << (folder / (CanMakePage() ? "bench.html" : "bench.json")).string() << ": "
              << journal.Rows().size() << " runs";
    if (failures)
    {
      std::cout << ", " << failures << " of them failed: see \"failure\" in bench.json";
    }
    std::cout << std::endl;
  }
}

}
