#include "BenchMeasurer.h"

#include "Failure.h"
#include "FrameTimings.h"
#include "Measurement.h"
#include "MovingStage.h"
#include "PeerShadows.h"
#include "Pictures.h"
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
#include <chrono>
#include <exception>
#include <random>
#include <thread>
#include <utility>

namespace vtkshadows
{
namespace
{

// What the passes of a scene's settings may hold together; others are made anew for each visit.
constexpr std::int64_t MostMemoryKept = std::int64_t(1) << 30;

// Of the time of a setting: where a frame takes more of it, its stages are those of a single one.
constexpr double StagesShare = 0.03;

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
  row["spread_ratio_static"] = timings.staticRatioSpread;
  row["spread_ratio_moving"] = timings.movingRatioSpread;
  row["rounds"] = timings.rounds;
}

}

//------------------------------------------------------------------------------
BenchMeasurer::BenchMeasurer(Stage& usedStage, const Options& givenOptions, Listener givenListener)
  : stage(usedStage)
  , options(givenOptions)
  , listener(std::move(givenListener))
{
}

BenchMeasurer::~BenchMeasurer() = default;

void BenchMeasurer::MeasureScene(const std::vector<const BenchRun*>& runs)
{
  Entrants entrants;
  std::int64_t kept = 0;
  for (const BenchRun* run : runs)
  {
    auto entrant = std::make_unique<BenchEntrant>(this->stage, *run);
    this->listener.begin(*run);
    entrant->row = DescribeRun(*run);
    const bool isMeasured = this->Try(*entrant,
      [&]()
      {
        this->ShowScene(*run);
        this->Prepare(*entrant);
      });
    if (!isMeasured || entrant->IsTimed(BenchTiming(this->options)))
    {
      this->Finish(*entrant);
      continue;
    }
    // "auto" would have to settle anew.
    entrant->isKept =
      run->setting.technique == "auto" || kept + entrant->Memory() <= MostMemoryKept;
    if (entrant->isKept)
    {
      kept += entrant->Memory();
    }
    else
    {
      entrant->Drop();
    }
    entrants.push_back(std::move(entrant));
  }
  this->TimeInTurn(std::move(entrants));
}

bool BenchMeasurer::Try(BenchEntrant& entrant, const std::function<void()>& work)
{
  entrant.row["failure"] = nullptr;
  TakeVtkWarnings();
  try
  {
    work();
  }
  catch (const std::exception& error)
  {
    entrant.row["failure"] = error.what();
  }
  for (const std::string& warning : TakeVtkWarnings())
  {
    BenchJson& known = entrant.row["warnings"];
    if (std::find(known.begin(), known.end(), warning) == known.end())
    {
      known.push_back(warning);
    }
  }
  return entrant.row["failure"].is_null();
}

void BenchMeasurer::TimeInTurn(Entrants entrants)
{
  const TimingPlan plan = BenchTiming(this->options);
  std::mt19937 order; // the same for every bench
  while (!entrants.empty())
  {
    std::shuffle(entrants.begin(), entrants.end(), order);
    for (auto& entrant : entrants)
    {
      this->listener.begin(entrant->Run());
      const bool isTimed =
        !this->Try(*entrant, [&]() { entrant->Visit(plan); }) || entrant->IsTimed(plan);
      if (isTimed)
      {
        this->Finish(*entrant);
        entrant.reset();
      }
      else if (!entrant->isKept)
      {
        entrant->Drop();
      }
    }
    entrants.erase(std::remove(entrants.begin(), entrants.end(), nullptr), entrants.end());
  }
}

void BenchMeasurer::Finish(BenchEntrant& entrant)
{
  BenchJson& row = entrant.row;
  if (entrant.Rounds().Count() > 0)
  {
    PutTimings(row, entrant.Rounds().Medians());
  }
  row["seconds"]["timing"] = entrant.VisitSeconds();
  row["seconds"]["settling"] = entrant.SettlingSeconds();
  this->listener.row(row);
  this->stage.UsePass(nullptr);
  entrant.Drop();
}

void BenchMeasurer::ShowScene(const BenchRun& run)
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
    this->listener.scene(facts);
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

void BenchMeasurer::Prepare(BenchEntrant& entrant)
{
  const BenchRun& run = entrant.Run();
  BenchJson& row = entrant.row;
  row["triangles"] = this->stage.NumberOfTriangles();
  row["lights"] = this->stage.Lights().size();
  const bool withErrors = run.axis.empty() && CanMeasureErrors(this->stage);
  if (withErrors)
  {
    this->TruthsOf(run.setting.soft);
  }
  const auto begin = std::chrono::steady_clock::now();
  entrant.Show();
  if (run.setting.technique == "auto")
  {
    row["explanations"] = this->ExplanationsOfChoice();
  }
  else if (!withErrors)
  {
    this->stage.Window().Render(); // else what errors are measured in warms up
  }
  row["errors"] = withErrors ? this->ErrorsOf(entrant) : BenchJson::array();

  entrant.Show();
  double frame = 0.0, work = 0.0;
  {
    MovingStage motion(this->stage);
    motion.SwingCamera();
    const WorkClock clock;
    frame = RenderMilliseconds(this->stage);
    work = clock.Seconds();
  }
  row["culled_receivers"] =
    entrant.Peer() ? 0 : this->stage.Shadows()->GetNumberOfCulledReceivers();
  const TimingPlan plan = BenchTiming(this->options);
  const bool isSlow = plan.rounds == 0 && run.setting.technique != "auto" && work > plan.seconds;
  if (isSlow)
  {
    entrant.TimeOnce(frame);
  }
  row["stages"] = entrant.Peer() || isSlow
    ? BenchJson::array()
    : JsonOf(TimeStages(this->stage, work > StagesShare * plan.seconds ? 1 : 3));
  row["texture_bytes"] = nullptr;
  row["caster_bytes"] = nullptr;
  if (auto* technique = this->stage.Shadows()->GetTechniquePass(run.setting.technique))
  {
    row["texture_bytes"] = technique->GetTextureMemory();
    row["caster_bytes"] = technique->GetCasterMemory();
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  entrant.row["seconds"]["prepare"] = taken.count();
}

// What "auto" says of each light, once it has chosen.
BenchJson BenchMeasurer::ExplanationsOfChoice()
{
  SettleChoice(this->stage, [] {});
  return ExplanationsOf(this->stage);
}

BenchMeasurer::Truths& BenchMeasurer::TruthsOf(bool soft)
{
  Truths& made = this->truths[soft];
  if (!made.empty())
  {
    return made;
  }
  const vtkSmartPointer<vtkShadowPass> shadows = this->stage.MakeShadows(soft);
  this->stage.UseShadows(shadows);
  shadows->GetRayCastShadowPass()->SetLightSamples(TruthSamples(this->options.bench));
  if (!soft)
  {
    shadows->SetTechnique("ray-cast");
    this->stage.Window().Render();
    this->listener.picture(
      "scene-" + this->shown->scene + ".png", PngOfBytes(this->stage.Picture()));
  }
  shadows->SetTechnique("none"); // else the same rays are traced for what is measured, too
  this->stage.Window().Render();
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
  shadows->ReleaseGraphicsResources(this->stage.Renderer()->GetVTKWindow());
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
  const vtkSmartPointer<vtkShadowPass> shadows = this->stage.MakeShadows(false);
  this->stage.UseShadows(shadows);
  shadows->SetTechnique("ray-cast");
  vtkShadowErrorMeasure* truth = this->TruthsOf(false)[light];
  truth->MeasureAgain(VisibilityOffPictures(this->stage, light, shadows));
  shadows->ReleaseGraphicsResources(this->stage.Renderer()->GetVTKWindow());
  return this->errorsOfPictures[light] = truth->GetMismatchPercent();
}

BenchJson BenchMeasurer::ErrorsOf(const BenchEntrant& entrant)
{
  const BenchRun& run = entrant.Run();
  vtkNew<vtkImageData> visibilities; // a component for each light
  if (!entrant.Peer() &&
    !this->stage.Shadows()->GetVisibilities(this->stage.Renderer(), visibilities))
  {
    throw Failure("visibility in scene", run.scene, TakeVtkError(),
      "leave the setting " + run.setting.name + " out");
  }
  BenchJson errors = BenchJson::array();
  for (std::size_t light = 0; light < this->stage.Lights().size(); ++light)
  {
    BenchJson error;
    error["light"] = light;
    error["kind"] = NameOf(KindOf(this->stage.Lights()[light]));
    error["error_of_pictures_percent"] = nullptr;
    vtkShadowErrorMeasure* measure = this->TruthsOf(run.setting.soft)[light];
    if (entrant.Peer())
    {
      error["error_of_pictures_percent"] = this->ErrorOfPictures(light);
      measure->MeasureAgain(VisibilityOffPictures(this->stage, light, entrant.Peer()));
    }
    else
    {
      measure->MeasureAgain(visibilities, static_cast<int>(light));
    }
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
    this->listener.picture(picture, PngOfBytes(measure->GetErrorMap()));
    error["picture"] = picture;
    errors.push_back(error);
  }
  return errors;
}

//------------------------------------------------------------------------------
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
  row["warnings"] = BenchJson::array();
  return row;
}

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
