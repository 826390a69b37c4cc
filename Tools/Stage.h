// The scene in its one off-screen window: meshes, floor, lights, camera and the shadow pass.
#ifndef vtkshadows_Stage_h
#define vtkshadows_Stage_h

#include "MeshLoader.h"
#include "OffscreenWindow.h"
#include "Scenes.h"
#include "Specs.h"
#include "View.h"

#include <vtkNew.h>
#include <vtkRenderPass.h>
#include <vtkShadowPass.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <optional>
#include <string>
#include <vector>

class vtkImageData;
class vtkLight;
class vtkRenderer;
class vtkTexture;

namespace vtkshadows
{

struct StageSettings
{
  std::vector<LightSpec> lights; // none: DefaultLight
  std::optional<CameraSpec> camera;
  std::optional<glm::dvec3> up;
  FloorSpec floor;
  WindowSize size;
  std::optional<int> resolution;            // of maps, texels
  std::optional<int> cascades;              // maps of a directional light
  std::optional<int> lightSamples;          // of a light with a radius
  std::string filter = "percentage-closer"; // of depth maps
  int depthBits = 32;                       // the same
  std::string objectType = "prop";          // of object-ID maps, as are:
  bool objectDepths = true;
  int objectDepthBits = 16;
  int objectTaps = 2;
  bool texturePerCaster = false; // of shadow textures
  std::vector<double> opacities; // of the meshes: none, one for all, or one each
  std::string translucentCasters = "none";
  bool cullHiddenFaces = false;
  double maximumError = 0.0;     // of "auto", percent; 0: no gross error
  double maximumFrameTime = 0.0; // of "auto", milliseconds; 0: any
};

class Stage
{
public:
  // Opens the window; one Stage a process. Throws Failure if it cannot be opened or is too large.
  Stage(const std::vector<Mesh>& meshes, const StageSettings& settings);
  // The same, with nothing in it.
  explicit Stage(const StageSettings& settings);
  ~Stage();

  // In place of what it has: a scene of the registry, for the window's size. Throws Failure.
  SceneFacts ShowScene(const std::string& name, SceneSize size);

  // Another size of the window. Throws Failure if it is too large.
  void Resize(const WindowSize& size);

  // A shadow pass with every setting as it is made, but for what the lights were given, how
  // translucent meshes cast and what the eye cannot see; and of the radii if lights are to be soft.
  vtkSmartPointer<vtkShadowPass> MakeShadows(bool soft);
  // In place of the one there was, which keeps what it has on the GPU.
  void UseShadows(vtkShadowPass* pass);
  // A pass as MakeShadows has it, in place of the one there was, which lets go of the GPU.
  void RenewShadows(bool soft);

  // A pass that ShowShadows shows in place of the shadow pass; nullptr: that one again.
  void UsePass(vtkRenderPass* pass);

  OffscreenWindow& Window() { return this->window; }
  vtkRenderer* Renderer() { return this->renderer; }
  vtkShadowPass* Shadows() { return this->shadows; }
  const std::vector<vtkSmartPointer<vtkLight>>& Lights() const { return this->lights; }
  const SceneAxes& Axes() const { return this->axes; }
  const SceneExtent& Extent() const { return this->extent; }

  // Every light by `technique`, but those whose LightSpec names one.
  void UseTechnique(const std::string& technique);
  std::string TechniqueOf(std::size_t light);
  bool IsChosen(); // some light has "auto"
  // Renders until what is chosen is settled, if anything is.
  void SettleChoice();
  // Renders until it is known what of the meshes the eye cannot see, if that is to be left out.
  void SettleCulling();
  // Why a light has what it had in the last frame.
  std::string ExplanationOf(std::size_t light);

  // What explains the first light whose technique has that view, over the frame; "none": nothing.
  void ShowDebugView(const std::string& view);

  // Shadows on or off, as a user turns them: by the renderer's pass.
  void ShowShadows(bool shown);

  // What the window shows, rendered: RGB, or RGBA where the floor is a catcher.
  vtkSmartPointer<vtkImageData> Picture();

  vtkIdType NumberOfTriangles() const; // of the meshes and the floor

private:
  void SetMapResolution(std::optional<int> resolution);
  void SetLightSamples(std::optional<int> samples);
  void AddMeshes(const std::vector<Mesh>& meshes, const std::vector<double>& opacities);
  void AddFloor(const FloorSpec& floor);
  void OpenWindow(const WindowSize& size);
  void AddLight(const LightSpec& spec);
  void GiveFrameSettings(vtkShadowPass* pass) const;
  void GiveLightSettings(vtkShadowPass* pass, std::size_t light, bool soft);
  void PlaceCamera(const CameraSpec& spec);

  OffscreenWindow window;
  vtkNew<vtkRenderer> renderer;
  vtkSmartPointer<vtkShadowPass> shadows;
  vtkSmartPointer<vtkRenderPass> shownPass; // none: the shadow pass
  std::vector<vtkSmartPointer<vtkLight>> lights;
  std::vector<LightSpec> lightSpecs;
  WindowSize windowSize;
  SceneAxes axes;
  SceneExtent extent;
  vtkIdType numberOfTriangles = 0;
  std::string translucentCasters;
  bool cullHiddenFaces;
  bool catches = false;
};

}

#endif
