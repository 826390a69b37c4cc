#include "CommandLine.h"

#include "Failure.h"
#include "Techniques.h"

#include <CLI/CLI.hpp>
#include <vtkVersion.h>

#include <algorithm>
#include <limits>

namespace vtkshadows
{
namespace
{

constexpr int MostLightSamples = 4096;
constexpr int MostCascadesOfALight = 8;
constexpr int MostObjectTaps = 4;

// The options as they are written.
struct RawOptions
{
  std::vector<std::string> inputs;
  std::string output;
  std::vector<std::string> techniques;
  std::vector<std::string> lights;
  std::optional<std::string> camera;
  std::optional<std::string> up;
  std::string size = "1024x768";
  std::string floor = "auto";
  std::optional<std::string> visibility;
  std::optional<std::string> json;
  std::optional<std::string> debug;
  std::optional<int> resolution;
  std::optional<int> cascades;
  std::optional<int> lightSamples;
  std::optional<std::string> filter;
  std::optional<int> depthBits;
  std::string objectType = "prop";
  bool objectIDsAlone = false;
  int objectDepthBits = 16;
  int objectTaps = 2;
  bool texturePerCaster = false;
  std::vector<double> opacities;
  std::string translucentCasters = "none";
  bool cullHiddenFaces = false;
  std::optional<double> isovalue;
  std::optional<int> frames;
  std::optional<double> maximumError;
  std::optional<double> maximumFrameTime;
  bool quiet = false;
  BenchOptions bench;
  std::optional<std::string> benchSize;
};

// What every subcommand knows of the meshes and of how their frames are drawn.
void AddFrameOptions(CLI::App& app, RawOptions& raw)
{
  app
    .add_option("--opacity", raw.opacities,
      "of the meshes, above 0 to 1: one for all, or one for each in their order; default: 1")
    ->type_name("A,B,...")
    ->delimiter(',')
    ->allow_extra_args(false);
  app
    .add_option("--translucent-casters", raw.translucentCasters,
      "how translucent meshes cast: " + KnownTranslucentCasters() +
        ". stochastic: by their opacity, in a grain of texels; transmittance: without the grain, "
        "by depth-map. Rays and shadow volumes take both for opaque")
    ->type_name("NAME")
    ->capture_default_str();
  app.add_flag("--cull-hidden-faces", raw.cullHiddenFaces,
    "leave out the faces of closed meshes that are turned away from the eye: faster, and single "
    "pixels on silhouettes differ");
}

void AddSharedOptions(CLI::App& app, RawOptions& raw)
{
  app.add_option("INPUT", raw.inputs, "meshes: " + KnownExtensions())->required();
  app
    .add_option("--light", raw.lights,
      "a light; repeat for more. directional:DX,DY,DZ (the way it travels) or "
      "spot:PX,PY,PZ:FX,FY,FZ:CONE (degrees from the axis) or point:PX,PY,PZ, then any of "
      "@color=R,G,B @intensity=V @radius=V @strength=V @distance=V @fade=V @technique=NAME, and "
      "for "
      "a spot @falloff=V (share of its cone) @texture=FILE.png (an image that it projects). "
      "Default: one directional light from above")
    ->type_name("SPEC")
    ->allow_extra_args(false);
  app.add_option("--camera", raw.camera, "PX,PY,PZ:FX,FY,FZ:UX,UY,UZ:ANGLE; default: fitted")
    ->type_name("SPEC");
  app
    .add_option("--up", raw.up,
      "the scene's up, for the floor and the fitted camera; default: the axis nearest to the "
      "camera's up, else +y for glTF and +z for others")
    ->type_name("X,Y,Z");
  app.add_option("--size", raw.size, "pixels of the picture")
    ->type_name("WxH")
    ->capture_default_str();
  app
    .add_option("--floor", raw.floor,
      "auto (under the scene), none, catcher (as auto, but it shows nothing but shadow, and "
      "pictures "
      "are transparent, with alpha), or NX,NY,NZ,D: the plane n.x = D")
    ->type_name("SPEC")
    ->capture_default_str();
  app
    .add_option("--resolution", raw.resolution,
      "texels on the longer side of a depth or object-ID map, or of a shadow texture")
    ->type_name("N");
  app
    .add_option("--cascades", raw.cascades,
      "depth or object-ID maps of a directional light at most, 1 to " +
        std::to_string(MostCascadesOfALight) + "; default: 1")
    ->type_name("N");
  app
    .add_option("--light-samples", raw.lightSamples,
      "sample lights of a light with a radius, 1 to " + std::to_string(MostLightSamples) +
        ", for stencil-volume (default 32), ray-cast (default 64) and the filter sample-lights of "
        "depth-map (default 64, at most 256)")
    ->type_name("N");
  app
    .add_option(
      "--filter", raw.filter, "of a depth map: " + KnownFilters() + "; default: percentage-closer")
    ->type_name("NAME");
  app.add_option("--depth-bits", raw.depthBits, "of a depth map: 8, 16, 24 or 32 (default)")
    ->type_name("N");
  app
    .add_option("--object-type", raw.objectType,
      "of object-id, what has an ID of its own: " + KnownObjectTypes())
    ->type_name("NAME")
    ->capture_default_str();
  app.add_flag("--object-ids-alone", raw.objectIDsAlone,
    "of object-id, no depths beside the IDs: no object shadows itself");
  app
    .add_option("--object-depth-bits", raw.objectDepthBits,
      "of object-id, bits of the depths beside the IDs: 8, 16, 24 or 32")
    ->type_name("N")
    ->capture_default_str();
  app
    .add_option("--object-taps", raw.objectTaps,
      "of object-id, N x N texels are tested, 1 to " + std::to_string(MostObjectTaps))
    ->type_name("N")
    ->capture_default_str();
  app.add_flag("--texture-per-caster", raw.texturePerCaster,
    "of shadow-texture, a texture for each mesh: casters take the shadows of others");
  AddFrameOptions(app, raw);
  app
    .add_option("--max-error", raw.maximumError,
      "of --technique auto: percent of the receiver pixels that may be wrong; default: no gross "
      "error")
    ->type_name("PERCENT");
  app
    .add_option("--max-frame-time", raw.maximumFrameTime,
      "of --technique auto: milliseconds that a frame may take; default: the fastest")
    ->type_name("MS");
  app
    .add_option(
      "--isovalue", raw.isovalue, "where images are contoured; default: middle of the range")
    ->type_name("V");
  app.add_option("--json", raw.json, "write figures of error and time")->type_name("FILE");
  app.add_option("--frames", raw.frames, "frames of each kind to time; default: 15, fewer if slow")
    ->type_name("N");
  app.add_flag("--quiet", raw.quiet, "say nothing but errors");
}

CLI::App* AddRender(CLI::App& app, RawOptions& raw)
{
  CLI::App* render = app.add_subcommand("render", "one picture");
  render->add_option("-o,--output", raw.output, "the picture, .png")
    ->required()
    ->type_name("IMAGE");
  render
    ->add_option("--technique", raw.techniques,
      "of every light: " + KnownTechniques() + "; default: auto, with --debug depth-map")
    ->type_name("NAME")
    ->expected(1);
  render
    ->add_option("--visibility", raw.visibility,
      "also write each light's visibility, FILE-0.png, FILE-1.png, ...: 255 seen, 0 shadow")
    ->type_name("FILE.png");
  render
    ->add_option("--debug", raw.debug,
      "a view that explains the first light whose technique has it, drawn over the picture: " +
        KnownDebugViews())
    ->type_name("VIEW");
  AddSharedOptions(*render, raw);
  return render;
}

CLI::App* AddCompare(CLI::App& app, RawOptions& raw)
{
  CLI::App* compare = app.add_subcommand(
    "compare", "every technique on the same view: pictures, masks, error maps, table, JSON");
  compare->add_option("-o,--output", raw.output, "the folder; made if it is missing")
    ->required()
    ->type_name("FOLDER");
  compare
    ->add_option("--techniques,--technique", raw.techniques,
      "those to compare, of " + KnownTechniques() + "; default: all but auto and none")
    ->type_name("A,B,...")
    ->delimiter(',')
    ->allow_extra_args(false);
  AddSharedOptions(*compare, raw);
  return compare;
}

CLI::App* AddBench(CLI::App& app, RawOptions& raw)
{
  BenchOptions& bench = raw.bench;
  CLI::App* command = app.add_subcommand("bench",
    "every technique and setting over every scene: error, time, memory; CSV, JSON and a page of "
    "HTML");
  command->add_option("INPUT", raw.inputs, "meshes, in place of the scenes: " + KnownExtensions());
  command->add_option("-o,--output", raw.output, "the folder; made if it is missing")
    ->type_name("FOLDER");
  command->add_option("--scenes", bench.scenes, "those to measure; default: all; see --list")
    ->type_name("A,B,...")
    ->delimiter(',')
    ->allow_extra_args(false);
  command
    ->add_option("--settings", bench.settings,
      "those whose name has one of these in it, or is like one with * and ?; see --list")
    ->type_name("A,B,...");
  command->add_flag("--fast", bench.fast, "small scenes, few settings, a few minutes");
  command->add_flag("--sweeps", bench.sweeps,
    "also cost against triangles, lights, pixels and samples, with the fitted exponent");
  command->add_flag("--extremes", bench.extremes,
    "also what each technique makes of scales, offsets, lights and meshes that try its numbers");
  command->add_flag(
    "--resume", bench.resume, "go on with the bench in the folder, which was cut off");
  command->add_flag("--list", bench.list, "say the names of scenes and settings, and no more");
  command
    ->add_option("--seconds", bench.seconds,
      "of timing, for each setting and scene, in short visits, 3 or more where they are not slow; "
      "default: 0.7, fast 0.2")
    ->type_name("S");
  command->add_option("--frames", raw.frames, "rounds of timing, whatever they take")
    ->type_name("N");
  command->add_option("--size", raw.benchSize, "pixels; default: 640x480, fast 400x300")
    ->type_name("WxH");
  command
    ->add_option("--detail", bench.detail,
      "times the triangles of made scenes, 0.01 to 100; default: 1, fast 0.25")
    ->type_name("F");
  command
    ->add_option("--triangles", bench.triangles,
      "of the scene crowd, 10000 to 50000000; default: 1000000, fast 50000")
    ->type_name("N");
  AddFrameOptions(*command, raw);
  command->add_option("--statue", bench.statue, "the scan of the scene statue, .off or .ply")
    ->type_name("FILE");
  command->add_option("--volume", bench.volume, "the labels of the scene anatomy, .vti")
    ->type_name("FILE");
  command->add_flag("--quiet", raw.quiet, "say nothing but errors");
  return command;
}

template <typename T>
void CheckRange(const std::string& option, const std::optional<T>& value, T low, T high)
{
  if (value && !(*value >= low && *value <= high))
  {
    const std::string range = ToText(double(low)) + " to " + ToText(double(high));
    throw Failure(option, ToText(double(*value)), "is outside " + range, "give " + range);
  }
}

void CheckCount(const std::string& option, const std::optional<int>& count,
  int most = std::numeric_limits<int>::max())
{
  if (count && *count > most)
  {
    throw Failure(option, std::to_string(*count), "is more than " + std::to_string(most),
      "give 1 to " + std::to_string(most));
  }
  if (count && *count < 1)
  {
    throw Failure(option, std::to_string(*count), "is less than 1", "give 1 or more");
  }
}

void CheckBudget(const std::string& option, const std::optional<double>& value, double most)
{
  if (value && !(*value > 0.0 && *value <= most))
  {
    throw Failure(option, std::to_string(*value), "is no such budget",
      most < std::numeric_limits<double>::max() ? "give more than 0 and at most 100"
                                                : "give more than 0");
  }
}

void CheckOpacities(const RawOptions& raw)
{
  for (const double opacity : raw.opacities)
  {
    if (!(opacity > 0.0 && opacity <= 1.0))
    {
      throw Failure("--opacity", ToText(opacity), "is no opacity of what is seen",
        "give more than 0 and at most 1");
    }
  }
  const std::size_t count = raw.opacities.size(), meshes = raw.inputs.size();
  if (count > 0 && count != meshes && (count > 1 || meshes == 0))
  {
    throw Failure("--opacity", std::to_string(count) + " value(s)",
      "but " + std::to_string(meshes) + " mesh(es)", "give one for all meshes, or one for each");
  }
}

// The view, checked: some light must have what it shows.
std::string InterpretDebugView(const RawOptions& raw, const Options& options)
{
  const std::string view = raw.debug.value_or("none");
  RequireDebugView("--debug", view);
  const std::string& shared = options.techniques.front();
  std::vector<std::string> techniques;
  for (const LightSpec& light : options.stage.lights)
  {
    techniques.push_back(light.technique.empty() ? shared : light.technique);
  }
  if (techniques.empty())
  {
    techniques.push_back(shared);
  }
  const std::vector<std::string> explained = TechniquesExplainedBy(view);
  if (view != "none" &&
    std::find_first_of(techniques.begin(), techniques.end(), explained.begin(), explained.end()) ==
      techniques.end())
  {
    throw Failure("--debug", view,
      "explains " + explained.front() + ", and no light is shadowed by that: the technique is " +
        techniques.front(),
      "add --technique " + explained.front());
  }
  return view;
}

StageSettings InterpretStage(const RawOptions& raw)
{
  StageSettings stage;
  for (const std::string& text : raw.lights)
  {
    stage.lights.push_back(ParseLight(text));
    const std::string& technique = stage.lights.back().technique;
    if (!technique.empty())
    {
      RequireTechnique("--light @technique", technique);
    }
  }
  if (raw.camera)
  {
    stage.camera = ParseCamera(*raw.camera);
  }
  if (raw.up)
  {
    stage.up = ParseUp(*raw.up);
  }
  stage.size = ParseSize(raw.size);
  stage.floor = ParseFloor(raw.floor);
  stage.resolution = raw.resolution;
  stage.cascades = raw.cascades;
  stage.lightSamples = raw.lightSamples;
  if (raw.filter)
  {
    RequireFilter("--filter", *raw.filter);
    stage.filter = *raw.filter;
  }
  stage.depthBits = raw.depthBits.value_or(stage.depthBits);
  stage.maximumError = raw.maximumError.value_or(0.0);
  stage.maximumFrameTime = raw.maximumFrameTime.value_or(0.0);
  RequireDepthBits("--depth-bits", stage.depthBits, stage.filter);
  RequireObjectType("--object-type", raw.objectType);
  RequireObjectDepthBits("--object-depth-bits", raw.objectDepthBits);
  stage.objectType = raw.objectType;
  stage.objectDepths = !raw.objectIDsAlone;
  stage.objectDepthBits = raw.objectDepthBits;
  stage.objectTaps = raw.objectTaps;
  stage.texturePerCaster = raw.texturePerCaster;
  CheckOpacities(raw);
  stage.opacities = raw.opacities;
  RequireTranslucentCasters("--translucent-casters", raw.translucentCasters);
  stage.translucentCasters = raw.translucentCasters;
  stage.cullHiddenFaces = raw.cullHiddenFaces;
  return stage;
}

// Each name once, in the order given.
std::vector<std::string> InterpretTechniques(const RawOptions& raw, const std::string& option)
{
  std::vector<std::string> techniques;
  for (const std::string& name : raw.techniques)
  {
    RequireTechnique(option, name);
    if (std::find(techniques.begin(), techniques.end(), name) == techniques.end())
    {
      techniques.push_back(name);
    }
  }
  return techniques;
}

std::vector<std::string> TechniquesToCompare(const RawOptions& raw, const StageSettings& stage)
{
  for (const LightSpec& light : stage.lights)
  {
    if (!light.technique.empty())
    {
      throw Failure("--light @technique", light.technique,
        "has no meaning in compare, where every light has each technique in turn",
        "leave it out, or use render");
    }
  }
  std::vector<std::string> techniques = InterpretTechniques(raw, "--techniques");
  if (techniques.empty())
  {
    techniques = TechniqueNames();
    for (const char* left : { "auto", "none" })
    {
      techniques.erase(std::remove(techniques.begin(), techniques.end(), left), techniques.end());
    }
  }
  return techniques;
}

BenchOptions InterpretBench(const RawOptions& raw)
{
  BenchOptions bench = raw.bench;
  if (raw.output.empty() && !bench.list)
  {
    throw Failure("-o", "", "is missing", "name the folder that the figures go to");
  }
  CheckRange("--seconds", bench.seconds, 0.001, 3600.0);
  CheckRange("--detail", bench.detail, 0.01, 100.0);
  CheckRange<vtkIdType>("--triangles", bench.triangles, 10'000, 50'000'000);
  if (raw.benchSize)
  {
    bench.size = ParseSize(*raw.benchSize);
  }
  return bench;
}

Options Interpret(const RawOptions& raw, Job job)
{
  CheckCount("--frames", raw.frames);
  CheckCount("--resolution", raw.resolution);
  CheckCount("--cascades", raw.cascades, MostCascadesOfALight);
  CheckCount("--light-samples", raw.lightSamples, MostLightSamples);
  CheckCount("--object-taps", raw.objectTaps, MostObjectTaps);
  CheckBudget("--max-error", raw.maximumError, 100.0);
  CheckBudget("--max-frame-time", raw.maximumFrameTime, std::numeric_limits<double>::max());

  Options options;
  options.inputs = raw.inputs;
  options.output = raw.output;
  options.visibility = raw.visibility;
  options.json = raw.json;
  options.isovalue = raw.isovalue;
  options.frames = raw.frames.value_or(0);
  options.quiet = raw.quiet;
  options.stage = InterpretStage(raw);
  if (job == Job::Bench)
  {
    options.bench = InterpretBench(raw);
  }
  else if (job == Job::Compare)
  {
    options.techniques = TechniquesToCompare(raw, options.stage);
  }
  else
  {
    options.techniques = InterpretTechniques(raw, "--technique");
    if (options.techniques.empty())
    {
      options.techniques.push_back(raw.debug ? "depth-map" : "auto");
    }
    options.debugView = InterpretDebugView(raw, options);
  }
  return options;
}

std::string VersionText()
{
  return std::string("vtkshadows ") + VTKSHADOWS_VERSION + " (VTK " + vtkVersion::GetVTKVersion() +
    "; techniques: " + KnownTechniques() + ")";
}

}

CommandLine ParseCommandLine(int argc, char** argv)
{
  RawOptions raw;
  CLI::App app(
    "Selectable, measured shadows: pictures of meshes, and how far each technique is from "
    "the truth.",
    "vtkshadows");
  app.set_version_flag("--version", VersionText());
  app.require_subcommand(1);
  CLI::App* render = AddRender(app, raw);
  CLI::App* compare = AddCompare(app, raw);
  CLI::App* bench = AddBench(app, raw);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == 0)
    {
      app.exit(error);
      return {};
    }
    const std::string subcommand = render->parsed() ? "render "
      : compare->parsed()                           ? "compare "
      : bench->parsed()                             ? "bench "
                                                    : "";
    throw UsageError(
      std::string("command line: ") + error.what() + "; see vtkshadows " + subcommand + "--help");
  }

  const Job job = render->parsed() ? Job::Render : bench->parsed() ? Job::Bench : Job::Compare;
  return { job, Interpret(raw, job) };
}

}
