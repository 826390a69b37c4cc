#include "Jobs.h"

#include "BenchJournal.h"
#include "BenchMeasurer.h"
#include "BenchPage.h"
#include "BenchPlan.h"
#include "BenchReport.h"
#include "Display.h"
#include "Failure.h"
#include "Measurement.h"
#include "OutputFiles.h"
#include "Progress.h"
#include "SharedSteps.h"

#include <chrono>
#include <filesystem>
#include <iostream>

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

// "12 of 187, about 3 min left".
class Remaining
{
public:
  explicit Remaining(std::size_t runs)
    : total(runs)
  {
  }
  std::string Next()
  {
    const std::chrono::duration<double> taken = Clock::now() - this->begin;
    std::string text = std::to_string(++this->done) + " of " + std::to_string(this->total);
    if (this->done > 3)
    {
      const double each = taken.count() / static_cast<double>(this->done - 1);
      const double left = each * static_cast<double>(this->total - this->done + 1);
      text += left < 90.0 ? ", about " + std::to_string(int(left)) + " s left"
                          : ", about " + std::to_string(int(left / 60.0 + 0.5)) + " min left";
    }
    return text;
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin = Clock::now();
  std::size_t total;
  std::size_t done = 0;
};

std::unique_ptr<Stage> OpenStage(const Options& options, Progress& progress)
{
  if (!options.inputs.empty())
  {
    Options prepared = options;
    prepared.stage.size = BenchWindow(options.bench);
    return PrepareStage(prepared, progress);
  }
  ProvideDisplay();
  return std::make_unique<Stage>(BenchWindow(options.bench));
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
  if (!CanMeasureErrors(*stage))
  {
    NoteNoErrors(progress);
  }

  std::vector<const BenchRun*> open;
  for (const BenchRun& run : plan)
  {
    if (!journal.HasRow(run.Key()))
    {
      open.push_back(&run);
    }
  }
  if (open.size() < plan.size())
  {
    progress.Note("going on: " + std::to_string(plan.size() - open.size()) + " of " +
      std::to_string(plan.size()) + " are measured");
  }
  BenchMeasurer measurer(*stage, options, progress,
    [&folder](const std::string& name, const std::string& bytes)
    {
      OutputFiles picture({});
      picture.Add(folder / "pictures" / name, bytes);
      picture.Commit();
    });
  Remaining remaining(open.size());
  std::size_t failures = 0;
  for (const BenchRun* run : open)
  {
    progress.Begin(remaining.Next() + ": " + run->Key());
    const BenchJson row =
      measurer.Measure(*run, [&journal](const BenchJson& facts) { journal.AddScene(facts); });
    failures += row["failure"].is_null() ? 0 : 1;
    journal.AddRow(row);
  }
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
