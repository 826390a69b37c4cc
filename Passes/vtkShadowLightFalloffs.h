// How the spot lights of a frame fall off across their cones, beside VTK's own cone and exponent:
// to a smooth side, and by an image that they project. It is no visibility: it multiplies a light's
// colour whatever its technique.
#ifndef vtkShadowLightFalloffs_h
#define vtkShadowLightFalloffs_h

#include "vtkShadowSceneData.h"
#include "vtkShadowTextureUnit.h"
#include "vtkShadowedShadingPass.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkShaderProgram;
class vtkTexture;
class vtkWindow;

class vtkShadowLightFalloffs
{
public:
  using LightPlan = vtkShadowedShadingPass::LightPlan;

  vtkShadowLightFalloffs() = default;
  ~vtkShadowLightFalloffs();
  vtkShadowLightFalloffs(const vtkShadowLightFalloffs&) = delete;
  void operator=(const vtkShadowLightFalloffs&) = delete;

  // What is wrong with an image, with the remedy; empty: nothing. Brings it up to date.
  static std::string FaultOf(vtkTexture* image);

  // Takes the lights of the plan, and their images to the driver.
  void Gather(const vtkShadowFrame& frame, const std::vector<LightPlan>& plan);

  // Bind the images, to units that are left by the techniques, and give those back. true if shaders
  // are written with other images than before. A light without a unit falls off by its cone alone:
  // GetFault.
  bool Activate();
  void Deactivate();
  const std::string& GetFault() const { return this->Fault; }

  // The images must not outlive the window.
  void Release(vtkWindow* window);

  bool Has(std::size_t light) const;
  // GLSL: declarations, and the factor of a light's colour for a receiver at vertexVC.
  std::string Declarations() const;
  std::string FactorCode(std::size_t light) const;
  void SetParameters(vtkShaderProgram* program) const;

private:
  struct Image
  {
    vtkSmartPointer<vtkTexture> Texture;
    vtkShadowTextureUnit Unit;
    unsigned int Id = 0;
    bool IsGrey = false;
  };
  struct Falloff
  {
    std::size_t Light = 0; // of the plan
    bool IsSmooth = false;
    int Image = -1; // among Images; -1: none
    std::array<float, 16> LightFromView{};
    float Cone[2] = { 0.0f, 0.0f }; // see the shader
    float PerTangent = 0.0f;
  };
  int AddImage(const vtkShadowFrame& frame, vtkTexture* texture);
  const Falloff* Find(std::size_t light) const;
  bool Projects(const Falloff& falloff) const;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::vector<Falloff> Falloffs;
  std::vector<Image> Images; // each once
  std::vector<int> Written;  // of each light with an image, whether it is bound, and grey
  std::string Fault;
};

#endif
