#include "vtkShadowLightFalloffs.h"

#include "ShadowLight.h"
#include "vtkShadowLightFalloff.h"
#include "vtkShadowMatrix.h"

#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLTexture.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkTexture.h"
#include "vtkTextureObject.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{

std::string MatrixUniform(std::size_t light)
{
  return "shadowLightFromView" + std::to_string(light);
}

std::string ConeUniform(std::size_t light)
{
  return "shadowCone" + std::to_string(light);
}

std::string ImageUniform(std::size_t light)
{
  return "shadowImage" + std::to_string(light);
}

// The sine of the angle below which up is no direction across the light's, and another one takes
// its place.
constexpr double LeastSine = 1e-3;

// Right, up, and against the way that the light shines, about its position.
glm::dmat4 LightFromWorld(const vtkshadows::ShadowLight& light, const double up[3])
{
  glm::dvec3 upWC = glm::normalize(glm::dvec3(up[0], up[1], up[2]));
  if (glm::length(glm::cross(light.direction, upWC)) < LeastSine)
  {
    // The next axis of the world: z gives way to y.
    upWC =
      std::abs(upWC.z) > std::abs(upWC.y) ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
  }
  const glm::dvec3 right = glm::normalize(glm::cross(light.direction, upWC));
  const glm::dmat3 axes =
    glm::transpose(glm::dmat3(right, glm::cross(right, light.direction), -light.direction));
  glm::dmat4 lightFromWorld(axes);
  lightFromWorld[3] = glm::dvec4(-(axes * light.position), 1.0);
  return lightFromWorld;
}

}

//------------------------------------------------------------------------------
vtkShadowLightFalloffs::~vtkShadowLightFalloffs()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
std::string vtkShadowLightFalloffs::FaultOf(vtkTexture* image)
{
  if (image->GetCubeMap())
  {
    return "is a cube map: give one of a single image";
  }
  if (image->GetNumberOfInputConnections(0) == 0)
  {
    return "has no image: give it one by SetInputConnection or SetInputData";
  }
  image->GetInputAlgorithm()->Update();
  vtkImageData* data = image->GetInput();
  int size[3] = { 0, 0, 0 };
  if (data)
  {
    data->GetDimensions(size);
  }
  if (std::min({ size[0], size[1], size[2] }) < 1 || !data->GetPointData()->GetScalars())
  {
    return "has an image without pixels: check what it is read from";
  }
  if (std::min({ size[0], size[1], size[2] }) > 1)
  {
    return "has an image of three dimensions: give it a slice of it";
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkShadowLightFalloffs::Gather(const vtkShadowFrame& frame, const std::vector<LightPlan>& plan)
{
  if (this->Window != frame.Window)
  {
    this->Release(this->Window);
    this->Window = frame.Window;
  }
  std::vector<vtkSmartPointer<vtkTexture>> before;
  for (const Image& image : this->Images)
  {
    before.push_back(image.Texture);
  }
  this->Images.clear();
  this->Falloffs.clear();
  const glm::dmat4 worldFromView = glm::inverse(frame.ViewFromWorld);
  for (std::size_t i = 0; i < plan.size(); ++i)
  {
    const LightPlan& light = plan[i];
    if (!light.FallsOff())
    {
      continue;
    }
    Falloff falloff;
    falloff.Light = i;
    falloff.LightFromView =
      vtkShadowMatrix::ToFloats(LightFromWorld(*light.Light, light.TextureUp) * worldFromView);
    const double side = glm::radians(light.Light->coneAngle);
    // 1 less a cosine, to all digits.
    const auto versine = [](double angle)
    { return 2.0 * std::sin(0.5 * angle) * std::sin(0.5 * angle); };
    const double inner = (1.0 - light.SmoothCone) * side;
    falloff.IsSmooth = light.SmoothCone > 0.0;
    falloff.Cone[0] = static_cast<float>(versine(side));
    falloff.Cone[1] =
      static_cast<float>(falloff.IsSmooth ? 1.0 / (versine(side) - versine(inner)) : 0.0);
    falloff.PerTangent = static_cast<float>(1.0 / std::tan(side));
    falloff.Image = light.Texture ? this->AddImage(frame, light.Texture) : -1;
    this->Falloffs.push_back(falloff);
  }
  for (const vtkSmartPointer<vtkTexture>& texture : before)
  {
    if (std::none_of(this->Images.begin(), this->Images.end(),
          [&](const Image& image) { return image.Texture == texture; }))
    {
      texture->ReleaseGraphicsResources(frame.Window);
    }
  }
}

//------------------------------------------------------------------------------
int vtkShadowLightFalloffs::AddImage(const vtkShadowFrame& frame, vtkTexture* texture)
{
  const auto known = std::find_if(this->Images.begin(), this->Images.end(),
    [texture](const Image& image) { return image.Texture == texture; });
  if (known != this->Images.end())
  {
    return static_cast<int>(known - this->Images.begin());
  }
  Image image;
  image.Texture = texture;
  texture->Render(frame.Renderer);
  auto* driver = vtkOpenGLTexture::SafeDownCast(texture);
  if (driver && driver->GetTextureObject())
  {
    image.Id = driver->GetTextureObject()->GetHandle();
    image.IsGrey = driver->GetTextureObject()->GetComponents() < 3;
  }
  texture->PostRender(frame.Renderer);
  this->Images.push_back(image);
  return static_cast<int>(this->Images.size()) - 1;
}

//------------------------------------------------------------------------------
bool vtkShadowLightFalloffs::Activate()
{
  this->Fault.clear();
  for (Image& image : this->Images)
  {
    if (image.Id != 0)
    {
      image.Unit.Bind(this->Window, GL_TEXTURE_2D, image.Id);
    }
  }
  std::vector<int> written;
  for (const Falloff& falloff : this->Falloffs)
  {
    if (falloff.Image >= 0)
    {
      const bool projects = this->Projects(falloff);
      written.push_back(projects ? 1 + this->Images[falloff.Image].IsGrey : 0);
      this->Fault +=
        projects ? "" : (this->Fault.empty() ? "" : ", ") + std::to_string(falloff.Light);
    }
  }
  const bool changed = written != this->Written;
  this->Written.swap(written);
  return changed;
}

void vtkShadowLightFalloffs::Deactivate()
{
  for (Image& image : this->Images)
  {
    image.Unit.Free(this->Window, GL_TEXTURE_2D);
  }
}

void vtkShadowLightFalloffs::Release(vtkWindow* window)
{
  for (const Image& image : this->Images)
  {
    if (window)
    {
      image.Texture->ReleaseGraphicsResources(window);
    }
  }
  this->Images.clear();
  this->Falloffs.clear();
}

//------------------------------------------------------------------------------
const vtkShadowLightFalloffs::Falloff* vtkShadowLightFalloffs::Find(std::size_t light) const
{
  const auto found = std::find_if(this->Falloffs.begin(), this->Falloffs.end(),
    [light](const Falloff& falloff) { return falloff.Light == light; });
  return found == this->Falloffs.end() ? nullptr : &*found;
}

bool vtkShadowLightFalloffs::Projects(const Falloff& falloff) const
{
  return falloff.Image >= 0 && this->Images[falloff.Image].Unit.Get() >= 0;
}

bool vtkShadowLightFalloffs::Has(std::size_t light) const
{
  const Falloff* falloff = this->Find(light);
  return falloff && (falloff->IsSmooth || this->Projects(*falloff));
}

//------------------------------------------------------------------------------
std::string vtkShadowLightFalloffs::Declarations() const
{
  std::string code;
  for (const Falloff& falloff : this->Falloffs)
  {
    const std::size_t light = falloff.Light;
    if (this->Has(light))
    {
      code += (code.empty() ? vtkShadowLightFalloff : "") + std::string("uniform mat4 ") +
        MatrixUniform(light) + ";\nuniform vec3 " + ConeUniform(light) + ";\n";
    }
    if (this->Projects(falloff))
    {
      code += "uniform sampler2D " + ImageUniform(light) + ";\n";
    }
  }
  return code;
}

std::string vtkShadowLightFalloffs::FactorCode(std::size_t light) const
{
  const Falloff* falloff = this->Find(light);
  if (!this->Has(light))
  {
    return "1.0";
  }
  const std::string place = "(" + MatrixUniform(light) + " * vertexVC).xyz";
  std::string code;
  if (falloff->IsSmooth)
  {
    code = "shadowSmoothCone(" + place + ", " + ConeUniform(light) + ".xy)";
  }
  if (this->Projects(*falloff))
  {
    code += (code.empty() ? "" : " * ") + std::string("shadowProjected(") + place + ", " +
      ConeUniform(light) + ".z, " + ImageUniform(light) + ")" +
      (this->Images[falloff->Image].IsGrey ? ".rrr" : "");
  }
  return code;
}

//------------------------------------------------------------------------------
void vtkShadowLightFalloffs::SetParameters(vtkShaderProgram* program) const
{
  for (const Falloff& falloff : this->Falloffs)
  {
    float matrix[16];
    std::copy(falloff.LightFromView.begin(), falloff.LightFromView.end(), matrix);
    const float cone[3] = { falloff.Cone[0], falloff.Cone[1], falloff.PerTangent };
    program->SetUniformMatrix4x4(MatrixUniform(falloff.Light).c_str(), matrix);
    program->SetUniform3f(ConeUniform(falloff.Light).c_str(), cone);
    if (this->Projects(falloff))
    {
      program->SetUniformi(
        ImageUniform(falloff.Light).c_str(), this->Images[falloff.Image].Unit.Get());
    }
  }
}
