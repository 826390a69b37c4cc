#include "Jobs.h"

#include "Measurement.h"
#include "OutputFiles.h"
#include "Pictures.h"
#include "Progress.h"
#include "SharedSteps.h"

#include <vtkImageData.h>

#include <filesystem>
#include <iostream>

namespace vtkshadows
{
namespace
{

OutputFiles PrepareOutputs(const Options& options)
{
  OutputFiles outputs(options.inputs);
  outputs.RequireFolder("-o", options.output);
  if (options.json)
  {
    outputs.RequireFile("--json", *options.json, "");
  }
  return outputs;
}

// Everything about one technique: its files into `outputs`, its rows into `report`.
class TechniqueComparison
{
public:
  TechniqueComparison(Stage& comparedStage, const Options& comparedOptions, Progress& shownProgress)
    : stage(comparedStage)
    , options(comparedOptions)
    , progress(shownProgress)
    , withErrors(CanMeasureErrors(comparedStage))
  {
    NoteLimitsOfErrors(this->stage, this->progress);
  }

  void Add(const std::string& technique, OutputFiles& outputs, Report& report)
  {
    const std::filesystem::path folder = this->options.output;
    this->progress.Begin("rendering " + technique);
    this->stage.UseTechnique(technique);
    this->stage.SettleCulling();
    this->stage.Window().Render();
    this->stage.SettleChoice();
    outputs.Add(folder / (technique + ".png"), PngOfBytes(this->stage.Picture()));

    std::vector<ReportRow> rows;
    for (std::size_t light = 0; light < this->stage.Lights().size(); ++light)
    {
      const std::string number = std::to_string(light);
      this->progress.Begin("measuring " + technique + ", light " + number);
      outputs.Add(
        folder / (technique + "-visibility-" + number + ".png"), VisibilityPng(this->stage, light));
      ReportRow row;
      row.technique = technique;
      row.light = static_cast<int>(light);
      row.explanation = this->stage.ExplanationOf(light);
      row.culledReceivers = this->stage.Shadows()->GetNumberOfCulledReceivers();
      if (this->withErrors)
      {
        MeasuredError measured = MeasureError(this->stage, light);
        row.error = measured.error;
        outputs.Add(folder / (technique + "-error-" + number + ".png"), measured.errorMapPng);
      }
      rows.push_back(row);
    }

    this->progress.Begin("timing " + technique);
    const FrameTimings timings = TimeFrames(this->stage, this->options.frames, this->progress);
    for (ReportRow& row : rows)
    {
      row.timings = timings;
      report.rows.push_back(row);
    }
  }

private:
  Stage& stage;
  const Options& options;
  Progress& progress;
  bool withErrors;
};

std::string UnshadowedPng(Stage& stage)
{
  stage.ShowShadows(false);
  stage.Window().Render();
  std::string png = PngOfBytes(stage.Picture());
  stage.ShowShadows(true);
  return png;
}

}

void RunCompare(const Options& options, Progress& progress)
{
  RequireMeshFiles(options.inputs);
  OutputFiles outputs = PrepareOutputs(options);
  const std::unique_ptr<Stage> stage = PrepareStage(options, progress);

  const std::filesystem::path folder = options.output;
  outputs.Add(folder / "unshadowed.png", UnshadowedPng(*stage));
  Report report = BeginReport(*stage);
  TechniqueComparison comparison(*stage, options, progress);
  for (const std::string& technique : options.techniques)
  {
    comparison.Add(technique, outputs, report);
    NoteVtkWarnings(progress);
  }
  outputs.Add(folder / "comparison.json", JsonOf(report));
  if (options.json)
  {
    outputs.Add(*options.json, JsonOf(report));
  }
  outputs.Commit();
  progress.End();

  if (!options.quiet)
  {
    std::cout << TableOf(report) << ChoicesOf(report) << "written to " << options.output
              << std::endl;
  }
}

}
