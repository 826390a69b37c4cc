// What vtkShadowPass keeps, and the course of a frame: lights are planned, techniques serve them,
// and the shading is attached. The class is written in files by subject: vtkShadowPass (a frame,
// and what is set), vtkShadowPassInternals (how a frame is planned), vtkShadowPassLights (settings
// of a light), vtkShadowPassProps (keys of props), vtkShadowPassReadBack (visibility and the
// truth), vtkShadowPassMeasures (errors, for the choice).
#ifndef vtkShadowPassInternals_h
#define vtkShadowPassInternals_h

#include "vtkShadowPass.h"

#include "AdaptiveTruth.h"
#include "vtkShadowMeasured.h"
#include "vtkShadowReceiverBuffer.h"
#include "vtkShadowScene.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowStageClock.h"
#include "vtkShadowTechniqueChooser.h"
#include "vtkShadowedShadingPass.h"
#ifdef VTKSHADOWS_WITH_EMBREE
#include "vtkRayCastShadowPass.h"
#endif

#include "vtkCameraPass.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vtkshadows
{

inline constexpr const char* NoTechnique = "none";
inline constexpr const char* AutoTechnique = "auto";

inline constexpr const char* NoView = "none";

// Beside the techniques' names.
inline constexpr const char* SceneStage = "scene";
inline constexpr const char* ShadingStage = "shading";

}

//------------------------------------------------------------------------------
// Calls vtkShadowPass back from under its camera pass.
class vtkShadowFramePass : public vtkRenderPass
{
public:
  static vtkShadowFramePass* New();
  vtkTypeMacro(vtkShadowFramePass, vtkRenderPass);
  void Render(const vtkRenderState* s) override { this->Owner->RenderFrame(s); }
  vtkShadowPass* Owner = nullptr;
};

//------------------------------------------------------------------------------
struct vtkShadowLightSettings
{
  vtkWeakPointer<vtkLight> Light;
  std::string Technique; // empty: the default one
  double Strength = 1.0;
  double Radius = 0.0;
  double MaximumDistance = 0.0; // 0: any
  double Fade = 0.1;
  double SmoothCone = 0.0; // share of the cone's angle
  vtkSmartPointer<vtkTexture> Texture;
  double TextureUp[3] = { 0.0, 0.0, 1.0 };

  bool FallsOff() const { return this->SmoothCone > 0.0 || this->Texture; }
};

//------------------------------------------------------------------------------
class vtkShadowPass::Internals
{
public:
  std::vector<vtkSmartPointer<vtkShadowTechniquePass>> Owned;
  std::vector<vtkShadowTechniquePass*> Techniques; // owned ones, or one that is borrowed
  std::string Default = vtkshadows::AutoTechnique;
  std::vector<vtkShadowLightSettings> Lights;
  std::string DebugView = vtkshadows::NoView;
  std::string DebugFault;                 // as it was last told
  std::vector<std::string> FalloffFaults; // the same, of the lights in their order
  vtkWeakPointer<vtkLight> DebugLight;
  vtkSmartPointer<vtkRenderPass> Delegate;
  vtkNew<vtkShadowScene> Scene;
  vtkNew<vtkShadowedShadingPass> Shading;
  vtkNew<vtkCameraPass> CameraPass;
  vtkNew<vtkShadowFramePass> FramePass;
  vtkShadowReceiverBuffer Receivers;
  vtkShadowStageClock Clock;
  bool TimeStages = false;
  vtkShadowTechniqueChooser Chooser; // for the lights of "auto"
  bool WasSettled = true;            // its choice, in the last frame
  int CulledReceivers = 0;           // actors with faces left out of the last frame
  int MergedCasters = 0;             // drawn with others in one go, in the last frame

  vtkShadowTechniquePass* Find(const std::string& name) const
  {
    for (vtkShadowTechniquePass* technique : this->Techniques)
    {
      if (name == technique->GetTechniqueName())
      {
        return technique;
      }
    }
    return nullptr;
  }

  std::string KnownNames() const
  {
    std::string names;
    for (vtkShadowTechniquePass* technique : this->Techniques)
    {
      names += std::string(technique->GetTechniqueName()) + ", ";
    }
    return names + vtkshadows::AutoTechnique + ", " + vtkshadows::NoTechnique;
  }

#ifdef VTKSHADOWS_WITH_EMBREE
  // The owned one, or, for a pass that is another technique's, one of its own.
  vtkRayCastShadowPass* GetRayCast()
  {
    if (!this->RayCast)
    {
      this->RayCast = vtkRayCastShadowPass::SafeDownCast(this->Find("ray-cast"));
    }
    if (!this->RayCast)
    {
      this->RayCast = vtkSmartPointer<vtkRayCastShadowPass>::New();
    }
    return this->RayCast;
  }
  vtkSmartPointer<vtkRayCastShadowPass> RayCast;
#endif

  bool IsKnown(const std::string& name) const
  {
    // A technique that stands alone has no others to choose among.
    return name == vtkshadows::NoTechnique ||
      (name == vtkshadows::AutoTechnique && !this->Owned.empty()) || this->Find(name);
  }

  // The techniques that a view explains.
  std::vector<std::string> ExplainedBy(const std::string& view) const
  {
    std::vector<std::string> names;
    for (vtkShadowTechniquePass* technique : this->Techniques)
    {
      const std::vector<std::string> views = technique->GetDebugViews();
      if (std::find(views.begin(), views.end(), view) != views.end())
      {
        names.push_back(technique->GetTechniqueName());
      }
    }
    return names;
  }

  // A spot, as VTK has them.
  static bool IsSpot(vtkLight* light)
  {
    return light->GetPositional() && light->GetConeAngle() > 0.0 && light->GetConeAngle() < 90.0;
  }

  vtkShadowLightSettings SettingsOf(const vtkLight* light) const
  {
    for (const vtkShadowLightSettings& settings : this->Lights)
    {
      if (settings.Light == light)
      {
        return settings;
      }
    }
    return {};
  }

  // False if it has that value already.
  bool Change(vtkLight* light, double vtkShadowLightSettings::*setting, double value)
  {
    if (this->SettingsOf(light).*setting == value)
    {
      return false;
    }
    this->EditSettings(light).*setting = value;
    return true;
  }
  vtkShadowLightSettings& EditSettings(vtkLight* light)
  {
    // Lights that are gone take their settings with them.
    this->Lights.erase(std::remove_if(this->Lights.begin(), this->Lights.end(),
                         [](const vtkShadowLightSettings& s) { return !s.Light; }),
      this->Lights.end());
    for (vtkShadowLightSettings& settings : this->Lights)
    {
      if (settings.Light == light)
      {
        return settings;
      }
    }
    this->Lights.emplace_back();
    this->Lights.back().Light = light;
    return this->Lights.back();
  }

  vtkShadowFrame FrameOf(const vtkRenderState* s);
  std::vector<vtkShadowedShadingPass::LightPlan> PlanLights(
    const vtkShadowFrame& frame, bool withStrength);
  void ChooseTechniques(const vtkShadowFrame& frame,
    std::vector<vtkShadowedShadingPass::LightPlan>& plan, const std::vector<int>& lights,
    bool isDrawn);
  // A view that errors are measured in, at fewer pixels than the frame's, and the truth there.
  struct MeasuredView
  {
    vtkShadowFrame Frame;
    int Size[2] = { 0, 0 }; // pixels that are measured
    double Scale = 1.0;     // they are so many of the frame's along an axis
    vtkShadowReceiverBuffer Receivers;
    std::map<int, Measured> Truths; // of lights without a radius
    std::map<int, vtkshadows::AdaptiveTruth> SoftTruths;
  };
  static constexpr double MostMeasuredPixels = 1.0e6;
  double PixelsToMeasure(const std::vector<int>& lights) const;
  static void Reduce(
    MeasuredView& view, const vtkShadowFrame& frame, double mostPixels, bool allDrawn);
  bool MeasureErrors(MeasuredView& view, const std::vector<vtkShadowedShadingPass::LightPlan>& plan,
    const std::string& name, const std::vector<int>& lights,
    std::vector<std::optional<vtkshadows::ErrorPercents>>& errors, double& drawingSeconds);
  bool MeasureError(MeasuredView& view, int light, vtkshadows::VisibilityError& error);
  bool MeasureSoftError(MeasuredView& view, int light, vtkshadows::VisibilityError& error);
  bool FindRoles(const vtkShadowFrame& frame, vtkShadowReceiverBuffer& receivers, int light,
    std::vector<vtkshadows::PixelRole>& roles);
  bool TraceTruth(const vtkShadowFrame& frame, vtkShadowReceiverBuffer& receivers, int light,
    int samples, Measured& measured);
  int SamplesOfTruth();
  void ReleaseWhatWasTried(vtkWindow* window);
  struct ReadBack;
  bool Begin(const vtkShadowFrame& frame, bool withStrength, bool always);
  void UpdateTechniques(
    const vtkShadowFrame& frame, std::vector<vtkShadowedShadingPass::LightPlan>& plan, bool masks);
  void End();
  std::string DrawDebugView(const vtkShadowFrame& frame);
  void TellFalloffs(const std::vector<std::string>& faults);
  std::vector<std::string> PlanFalloffs(std::vector<vtkShadowedShadingPass::LightPlan>& plan);
  std::vector<vtkShadowedShadingPass::LightPlan> Plan; // of this frame
};

#endif
