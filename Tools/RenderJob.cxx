#include "Jobs.h"

#include "Failure.h"
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

// "masks.png" and light 2 to "masks-2.png".
std::filesystem::path MaskPath(const std::filesystem::path& path, std::size_t light)
{
  return path.parent_path() /
    (path.stem().string() + "-" + std::to_string(light) + path.extension().string());
}

OutputFiles PrepareOutputs(const Options& options)
{
  OutputFiles outputs(options.inputs);
  if (options.stage.floor.kind == FloorSpec::Kind::Catcher &&
    std::filesystem::path(options.output).extension() != ".png")
  {
    throw Failure("-o", options.output, "is no .png file, which a picture with alpha must be",
      "give it a name that ends in .png, or another --floor than catcher");
  }
  outputs.RequireFile("-o", options.output, ".png");
  if (options.visibility)
  {
    outputs.RequireFile("--visibility", *options.visibility, ".png");
  }
  if (options.json)
  {
    outputs.RequireFile("--json", *options.json, "");
  }
  return outputs;
}

Report Measure(Stage& stage, const Options& options, Progress& progress)
{
  stage.SettleChoice();
  Report report = BeginReport(stage);
  const bool withErrors = CanMeasureErrors(stage);
  NoteLimitsOfErrors(stage, progress);
  for (std::size_t light = 0; light < stage.Lights().size(); ++light)
  {
    progress.Begin("measuring the error of light " + std::to_string(light));
    ReportRow row;
    row.technique = stage.TechniqueOf(light);
    row.light = static_cast<int>(light);
    row.explanation = stage.ExplanationOf(light);
    row.culledReceivers = stage.Shadows()->GetNumberOfCulledReceivers();
    if (withErrors)
    {
      row.error = MeasureError(stage, light).error;
    }
    report.rows.push_back(row);
  }

  progress.Begin("timing frames");
  const FrameTimings timings = TimeFrames(stage, options.frames, progress);
  for (ReportRow& row : report.rows)
  {
    row.timings = timings;
  }
  return report;
}

}

void RunRender(const Options& options, Progress& progress)
{
  RequireMeshFiles(options.inputs);
  OutputFiles outputs = PrepareOutputs(options);
  const std::unique_ptr<Stage> stage = PrepareStage(options, progress);

  progress.Begin("rendering");
  stage->UseTechnique(options.techniques.front());
  stage->ShowDebugView(options.debugView);
  stage->SettleCulling();
  stage->Window().Render();
  outputs.Add(options.output, PngOfBytes(stage->Picture()));
  std::vector<std::string> explanations; // of the picture
  for (std::size_t light = 0; light < stage->Lights().size(); ++light)
  {
    explanations.push_back(stage->ExplanationOf(light));
  }
  stage->ShowDebugView("none"); // which would cost time in the figures
  for (std::size_t light = 0; options.visibility && light < stage->Lights().size(); ++light)
  {
    outputs.Add(MaskPath(*options.visibility, light), VisibilityPng(*stage, light));
  }
  if (options.json)
  {
    outputs.Add(*options.json, JsonOf(Measure(*stage, options, progress)));
  }
  NoteVtkWarnings(progress);
  outputs.Commit();
  progress.End();

  if (!options.quiet)
  {
    std::cout << options.output << ": " << stage->NumberOfTriangles() << " triangles, "
              << stage->Lights().size() << " light(s)" << std::endl;
    for (std::size_t light = 0; stage->IsChosen() && light < explanations.size(); ++light)
    {
      std::cout << "light " << light << ": " << explanations[light] << std::endl;
    }
  }
}

}
