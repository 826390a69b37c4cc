#include "BenchMeasurer.h"

#include "Failure.h"
#include "Measurement.h"
#include "PeerShadows.h"
#include "Pictures.h"
#include "Progress.h"
#include "VtkMessages.h"

#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRayCastShadowPass.h>
#include <vtkRenderPass.h>
#include <vtkRenderer.h>
#include <vtkShadowErrorMeasure.h>
#include <vtkShadowPass.h>
#include <vtkShadowTechniquePass.h>
#include <vtkVersion.h>

#include <algorithm>
#include <thread>

namespace vtkshadows
{
namespace
{

std::string NameOf(LightKind kind)
{
  return kind == LightKind::Directional ? "directional"
    : kind == LightKind::Spot           ? "spot"
                                        : "point";
}

std::string NameOf(SceneReceivers receivers)
{
  return receivers == SceneReceivers::Planar ? "planar"
    : receivers == SceneReceivers::Mixed     ? "mixed"
                                             : "curved";
}

LightKind KindOf(vtkLight* light)
{
  return !light->GetPositional()   ? LightKind::Directional
    : light->GetConeAngle() < 90.0 ? LightKind::Spot
                                   : LightKind::Point;
}

BenchJson JsonOf(const SceneFacts& facts)
{
  BenchJson json;
  json["name"] = facts.name;
  json["description"] = facts.description;
  json["notes"] = facts.notes;
  json["triangles"] = facts.triangles;
  json["impostors"] = facts.impostors;
  json["bounds"] = facts.bounds;
  json["receivers"] = NameOf(facts.receivers);
  json["planes"] = facts.planes;
  json["closed_casters"] = facts.closedCasters;
  json["self_shadows"] = facts.selfShadows;
  json["translucents"] = facts.translucents;
  json["lights"] = BenchJson::array();
  for (const SceneLight& light : facts.lights)
  {
    json["lights"].push_back({ { "kind", NameOf(light.kind) }, { "radius", light.radius } });
  }
  json["facts"] = BenchJson::array();
  for (const SceneFact& fact : facts.facts)
  {
    json["facts"].push_back(
      { { "what", fact.what }, { "value", fact.value }, { "unit", fact.unit } });
  }
  return json;
}

// In a file's name: "soft/planar" as "soft-planar".
std::string FileName(std::string name)
{
  std::replace(name.begin(), name.end(), '/', '-');
  return name;
}

BenchJson NumberOrNull(double number)
{
  return number < 0.0 ? BenchJson(nullptr) : BenchJson(number);
}

BenchJson JsonOf(const std::vector<StageTimings>& stages)
{
  BenchJson list = BenchJson::array();
  for (const StageTimings& stage : stages)
  {
    list.push_back(
      { { "name", stage.name }, { "static_ms", NumberOrNull(stage.staticMilliseconds) },
        { "moving_ms", NumberOrNull(stage.movingMilliseconds) },
        { "static_gpu_ms", NumberOrNull(stage.staticGpuMilliseconds) },
        { "moving_gpu_ms", NumberOrNull(stage.movingGpuMilliseconds) } });
  }
  return list;
}

void PutTimings(BenchJson& row, const FrameTimings& timings)
{
  row["frame_ms_unshadowed"] = timings.unshadowedMilliseconds;
  row["frame_ms_static"] = timings.staticMilliseconds;
  row["frame_ms_moving"] = timings.movingMilliseconds;
  row["spread_ms_static"] = timings.staticSpread;
  row["spread_ms_moving"] = timings.movingSpread;
  row["ratio_static"] = timings.staticRatio;
  row["ratio_moving"] = timings.movingRatio;
  row["cost_ms_static"] = timings.staticCost;
  row["cost_ms_moving"] = timings.movingCost;
  row["rounds"] = timings.rounds;
}

BenchJson DescribeRun(const BenchRun& run)
{
  BenchJson row;
  row["key"] = run.Key();
  row["scene"] = run.scene;
  row["setting"] = run.setting.name;
  row["technique"] = run.setting.technique;
  row["soft"] = run.setting.soft;
  row["resolution"] = run.setting.resolution ? BenchJson(run.setting.resolution) : nullptr;
  row["samples"] = run.setting.samples ? BenchJson(run.setting.samples) : nullptr;
  row["axis"] = run.axis.empty() ? BenchJson(nullptr) : BenchJson(run.axis);
  row["value"] = run.axis.empty() ? BenchJson(nullptr) : BenchJson(run.value);
  row["width"] = run.window.width;
  row["height"] = run.window.height;
  return row;
}

}

//------------------------------------------------------------------------------
BenchMeasurer::BenchMeasurer(
  Stage& usedStage, const Options& givenOptions, Progress& shownProgress, Pictures takePictures)
  : stage(usedStage)
  , options(givenOptions)
  , progress(shownProgress)
  , pictures(std::move(takePictures))
{
}

BenchMeasurer::~BenchMeasurer() = default;

BenchJson BenchMeasurer::Measure(
  const BenchRun& run, const std::function<void(const BenchJson&)>& sceneShown)
{
  BenchJson row = DescribeRun(run);
  this->ShowScene(run, sceneShown);
  row["triangles"] = this->stage.NumberOfTriangles();
  row["lights"] = this->stage.Lights().size();
  row["failure"] = nullptr;
  TakeVtkWarnings();
  try
  {
    this->MeasureInto(row, run);
  }
  catch (const Failure& failure)
  {
    row["failure"] = failure.what();
  }
  row["warnings"] = TakeVtkWarnings();
  this->stage.UsePass(nullptr);
  return row;
}

void BenchMeasurer::ShowScene(
  const BenchRun& run, const std::function<void(const BenchJson&)>& sceneShown)
{
  if (this->shown && this->shown->HasSceneOf(run))
  {
    return;
  }
  this->shown.reset();
  this->truths.clear();
  this->errorsOfPictures.clear();
  this->stage.RenewShadows(false); // which lets go of the scene before
  this->stage.Resize(run.window);
  const BenchJson facts = run.scene == MeshesScene
    ? this->FactsOfMeshes()
    : JsonOf(this->stage.ShowScene(run.scene, run.size));
  this->shown = run;
  if (run.axis.empty())
  {
    sceneShown(facts);
  }
}

BenchJson BenchMeasurer::FactsOfMeshes() const
{
  BenchJson json;
  json["name"] = MeshesScene;
  json["description"] = "the meshes that were given";
  json["notes"] = this->options.inputs;
  json["triangles"] = this->stage.NumberOfTriangles();
  return json;
}

void BenchMeasurer::MeasureInto(BenchJson& row, const BenchRun& run)
{
  const BenchSetting& setting = run.setting;
  const bool withErrors = run.axis.empty() && CanMeasureErrors(this->stage);
  if (withErrors)
  {
    this->TruthsOf(setting.soft);
  }
  this->stage.RenewShadows(setting.soft);
  vtkSmartPointer<vtkRenderPass> peer;
  if (setting.IsPeer())
  {
    peer = MakePeerPass(setting.resolution);
    this->stage.UsePass(peer);
  }
  else
  {
    setting.apply(this->stage.Shadows());
  }
  this->stage.Window().Render();
  if (setting.technique == "auto")
  {
    row["explanations"] = this->ExplanationsOfChoice();
  }
  row["errors"] = withErrors ? this->ErrorsOf(run, peer) : BenchJson::array();

  this->stage.UsePass(peer);
  const FrameTimings timings = TimeFrames(this->stage, BenchTiming(this->options), this->progress);
  PutTimings(row, timings);
  // Where one round was too much already, its stages are not asked for.
  const bool slow = timings.rounds == 1 && this->options.frames == 0;
  row["stages"] = setting.IsPeer() || slow ? BenchJson::array() : JsonOf(TimeStages(this->stage));
  row["texture_bytes"] = nullptr;
  row["caster_bytes"] = nullptr;
  if (auto* technique = this->stage.Shadows()->GetTechniquePass(setting.technique))
  {
    row["texture_bytes"] = technique->GetTextureMemory();
    row["caster_bytes"] = technique->GetCasterMemory();
  }
  if (peer)
  {
    peer->ReleaseGraphicsResources(this->stage.Renderer()->GetVTKWindow());
  }
}

// What "auto" says of each light, once it has chosen.
BenchJson BenchMeasurer::ExplanationsOfChoice()
{
  SettleChoice(this->stage, [] {});
  vtkShadowPass* shadows = this->stage.Shadows();
  BenchJson explanations = BenchJson::array();
  for (vtkLight* light : this->stage.Lights())
  {
    explanations.push_back(shadows->GetExplanation(light));
  }
  return explanations;
}

BenchMeasurer::Truths& BenchMeasurer::TruthsOf(bool soft)
{
  Truths& made = this->truths[soft];
  if (!made.empty())
  {
    return made;
  }
  this->stage.RenewShadows(soft);
  vtkShadowPass* shadows = this->stage.Shadows();
  shadows->SetTechnique("ray-cast");
  shadows->GetRayCastShadowPass()->SetLightSamples(TruthSamples(this->options.bench));
  this->stage.Window().Render();
  if (!soft)
  {
    this->pictures("scene-" + this->shown->scene + ".png", PngOfBytes(this->stage.Picture()));
  }
  Truths truth;
  for (vtkLight* light : this->stage.Lights())
  {
    auto measure = vtkSmartPointer<vtkShadowErrorMeasure>::New();
    if (!measure->Measure(this->stage.Renderer(), light))
    {
      throw Failure("truth of scene", this->shown->scene, TakeVtkError(), "leave the scene out");
    }
    truth.push_back(measure);
  }
  made = truth;
  return made;
}

double BenchMeasurer::ErrorOfPictures(std::size_t light)
{
  const auto known = this->errorsOfPictures.find(light);
  if (known != this->errorsOfPictures.end())
  {
    return known->second;
  }
  this->stage.RenewShadows(false);
  this->stage.Shadows()->SetTechnique("ray-cast");
  vtkShadowErrorMeasure* truth = this->TruthsOf(false)[light];
  truth->MeasureAgain(VisibilityOffPictures(this->stage, light, this->stage.Shadows()));
  return this->errorsOfPictures[light] = truth->GetMismatchPercent();
}

BenchJson BenchMeasurer::ErrorsOf(const BenchRun& run, vtkRenderPass* peer)
{
  BenchJson errors = BenchJson::array();
  for (std::size_t light = 0; light < this->stage.Lights().size(); ++light)
  {
    BenchJson error;
    error["light"] = light;
    error["kind"] = NameOf(KindOf(this->stage.Lights()[light]));
    error["error_of_pictures_percent"] = nullptr;
    vtkSmartPointer<vtkImageData> visibility;
    if (peer)
    {
      error["error_of_pictures_percent"] = this->ErrorOfPictures(light);
      visibility = VisibilityOffPictures(this->stage, light, peer);
    }
    else
    {
      visibility = vtkSmartPointer<vtkImageData>::New();
      if (!this->stage.Shadows()->GetVisibility(
            this->stage.Renderer(), this->stage.Lights()[light], visibility))
      {
        throw Failure("visibility of light", std::to_string(light), TakeVtkError(),
          "leave the setting " + run.setting.name + " out");
      }
    }
    vtkShadowErrorMeasure* measure = this->TruthsOf(run.setting.soft)[light];
    measure->MeasureAgain(visibility);
    error["receiver_pixels"] = measure->GetReceiverPixels();
    error["shadow_pixels"] = measure->GetShadowPixels();
    error["uncertain_pixels"] = measure->GetUncertainPixels();
    error["mismatch_percent"] = measure->GetMismatchPercent();
    error["gross_false_pixels"] = measure->GetGrossFalsePixels();
    error["gross_missed_pixels"] = measure->GetGrossMissedPixels();
    error["gross_percent"] = measure->GetGrossPercent();
    error["mean_absolute_difference"] = measure->GetMeanAbsoluteDifference();
    error["mean_penumbra_difference"] = measure->GetMeanPenumbraDifference();
    const std::string picture =
      FileName(run.scene + "--" + run.setting.name + "--" + std::to_string(light) + ".png");
    this->pictures(picture, PngOfBytes(measure->GetErrorMap()));
    error["picture"] = picture;
    errors.push_back(error);
  }
  return errors;
}

//------------------------------------------------------------------------------
BenchJson DescribeMachine(Stage& stage)
{
  BenchJson machine;
  machine["vtkshadows"] = VTKSHADOWS_VERSION;
  machine["vtk"] = vtkVersion::GetVTKVersion();
  machine["renderer"] = stage.Window().OpenGLRenderer();
  machine["cores"] = std::thread::hardware_concurrency();
  return machine;
}

}
