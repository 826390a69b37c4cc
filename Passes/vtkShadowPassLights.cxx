#include "vtkShadowPassInternals.h"

#include "vtkShadowLightFalloffs.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{

std::string Named(const vtkObject* object)
{
  std::ostringstream text;
  text << object;
  return text.str();
}

}

//------------------------------------------------------------------------------
bool vtkShadowPass::SetLightTechnique(vtkLight* light, const std::string& name)
{
  if (!light)
  {
    vtkErrorMacro("SetLightTechnique(nullptr, \"" << name << "\"): give a vtkLight.");
    return false;
  }
  if (!name.empty() && !this->Internal->IsKnown(name))
  {
    vtkErrorMacro("Technique \"" << name << "\" of light " << light << " is not known: use one of "
                                 << this->Internal->KnownNames() << ".");
    return false;
  }
  this->Internal->EditSettings(light).Technique = name;
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetLightTechnique(vtkLight* light) const
{
  const std::string own = this->Internal->SettingsOf(light).Technique;
  return own.empty() ? this->Internal->Default : own;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightStrength(vtkLight* light, double strength)
{
  if (!light || !std::isfinite(strength))
  {
    vtkErrorMacro(
      "SetLightStrength(" << light << ", " << strength << "): give a vtkLight and 0 to 1.");
    return;
  }
  if (this->Internal->Change(
        light, &vtkShadowLightSettings::Strength, std::min(std::max(strength, 0.0), 1.0)))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkShadowPass::GetLightStrength(vtkLight* light) const
{
  return this->Internal->SettingsOf(light).Strength;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightRadius(vtkLight* light, double radius)
{
  if (!light || !std::isfinite(radius) || radius < 0.0)
  {
    vtkErrorMacro(
      "SetLightRadius(" << light << ", " << radius << "): give a vtkLight and 0 or more.");
    return;
  }
  if (this->Internal->Change(light, &vtkShadowLightSettings::Radius, radius))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkShadowPass::GetLightRadius(vtkLight* light) const
{
  return this->Internal->SettingsOf(light).Radius;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightMaximumDistance(vtkLight* light, double distance)
{
  if (!light || !std::isfinite(distance) || distance < 0.0)
  {
    vtkErrorMacro("SetLightMaximumDistance("
      << light << ", " << distance
      << "): give a vtkLight and a distance in world units, or 0 for no limit.");
    return;
  }
  if (this->Internal->Change(light, &vtkShadowLightSettings::MaximumDistance, distance))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkShadowPass::GetLightMaximumDistance(vtkLight* light) const
{
  return this->Internal->SettingsOf(light).MaximumDistance;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightFade(vtkLight* light, double fade)
{
  if (!light || !(fade >= 0.0 && fade <= 1.0))
  {
    vtkErrorMacro("SetLightFade(" << light << ", " << fade
                                  << "): give a vtkLight and a share of its distance, 0 to 1.");
    return;
  }
  if (this->Internal->Change(light, &vtkShadowLightSettings::Fade, fade))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkShadowPass::GetLightFade(vtkLight* light) const
{
  return this->Internal->SettingsOf(light).Fade;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightSmoothCone(vtkLight* light, double share)
{
  if (!light || !(share >= 0.0 && share <= 1.0))
  {
    vtkErrorMacro("SetLightSmoothCone("
      << light << ", " << share
      << "): give a vtkLight and the share of its cone's angle that it falls off over, 0 to 1.");
    return;
  }
  if (share > 0.0 && !Internals::IsSpot(light))
  {
    vtkErrorMacro("SetLightSmoothCone(" << light << ", " << share
                                        << "): the light is no spot. Make it positional, with a "
                                           "cone angle above 0 and below 90 degrees.");
    return;
  }
  if (this->Internal->Change(light, &vtkShadowLightSettings::SmoothCone, share))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkShadowPass::GetLightSmoothCone(vtkLight* light) const
{
  return this->Internal->SettingsOf(light).SmoothCone;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightTexture(vtkLight* light, vtkTexture* texture)
{
  const std::string call = "SetLightTexture(" + Named(light) + ", " + Named(texture) + "): ";
  if (!light)
  {
    vtkErrorMacro(<< call << "give a vtkLight.");
    return;
  }
  if (texture && !Internals::IsSpot(light))
  {
    vtkErrorMacro(<< call
                  << "the light is no spot, and has no cone to project an image through. Make it "
                     "positional, with a cone angle above 0 and below 90 degrees.");
    return;
  }
  if (texture && texture->GetCubeMap())
  {
    vtkErrorMacro(<< call << "the texture " << vtkShadowLightFalloffs::FaultOf(texture) << ".");
    return;
  }
  this->Internal->EditSettings(light).Texture = texture;
  this->Modified();
}

//------------------------------------------------------------------------------
vtkTexture* vtkShadowPass::GetLightTexture(vtkLight* light) const
{
  return this->Internal->SettingsOf(light).Texture;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightTextureUp(vtkLight* light, double x, double y, double z)
{
  // Of a length that neither tiny nor huge vectors lose.
  const double size = std::max({ std::abs(x), std::abs(y), std::abs(z) });
  if (!light || !std::isfinite(x + y + z) || !(size > 0.0) || !std::isfinite(size))
  {
    vtkErrorMacro("SetLightTextureUp("
      << light << ", " << x << ", " << y << ", " << z
      << "): give a vtkLight and a finite vector that is not zero.");
    return;
  }
  const double up[3] = { x / size, y / size, z / size };
  std::copy_n(up, 3, this->Internal->EditSettings(light).TextureUp);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkShadowPass::GetLightTextureUp(vtkLight* light, double up[3]) const
{
  const vtkShadowLightSettings settings = this->Internal->SettingsOf(light);
  std::copy_n(settings.TextureUp, 3, up);
}

//------------------------------------------------------------------------------
void vtkShadowPass::ClearLightSettings(vtkLight* light)
{
  std::vector<vtkShadowLightSettings>& all = this->Internal->Lights;
  all.erase(std::remove_if(all.begin(), all.end(),
              [light](const vtkShadowLightSettings& s) { return !light || s.Light == light; }),
    all.end());
  this->Modified();
}
