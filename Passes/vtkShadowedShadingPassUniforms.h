// Names of the uniforms of vtkShadowedShadingPass: vtkShadowedShadingPassCode declares them,
// vtkShadowedShadingPassParameters sets them.
#ifndef vtkShadowedShadingPassUniforms_h
#define vtkShadowedShadingPassUniforms_h

#include <cstddef>
#include <string>

namespace vtkShadowUniforms
{

inline std::string Strength(std::size_t light)
{
  return "shadowStrength" + std::to_string(light);
}

// Where shadow ends, and how fast it does, in inverse units.
inline std::string Distance(std::size_t light)
{
  return "shadowDistance" + std::to_string(light);
}

// 1 where a prop takes shadows from the masks of this sampler.
inline std::string Receives(const std::string& sampler)
{
  return sampler + "Receives";
}

// From the eye's view to the light's space.
inline std::string Matrix(std::size_t light)
{
  return "shadowFromView" + std::to_string(light);
}

}

#endif
