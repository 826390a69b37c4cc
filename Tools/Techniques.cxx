#include "Techniques.h"

#include "Failure.h"

#include <vtkDepthShadowMapPass.h>
#include <vtkNew.h>
#include <vtkObjectIDShadowPass.h>
#include <vtkShadowPass.h>
#include <vtkStringArray.h>

#include <algorithm>

namespace vtkshadows
{
namespace
{

template <typename Fill>
std::vector<std::string> NamesFrom(const Fill& fill)
{
  vtkNew<vtkStringArray> array;
  fill(array);
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    names.push_back(array->GetValue(i));
  }
  return names;
}

std::string ListOf(const std::vector<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
  {
    list += (list.empty() ? "" : ", ") + name;
  }
  return list;
}

void Require(const std::vector<std::string>& names, const std::string& option,
  const std::string& name, const std::string& problem)
{
  if (std::find(names.begin(), names.end(), name) == names.end())
  {
    throw Failure(option, name.empty() ? "''" : name, problem, "choose one of " + ListOf(names));
  }
}

// The names of 0, 1, ...
template <typename NameOf>
std::vector<std::string> NamesOf(int count, const NameOf& nameOf)
{
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i)
  {
    names.push_back(nameOf(i));
  }
  return names;
}

std::vector<std::string> FilterNames()
{
  return NamesOf(vtkDepthShadowMapPass::GetNumberOfFilters(), vtkDepthShadowMapPass::GetFilterName);
}

std::vector<std::string> ObjectTypeNames()
{
  return NamesOf(
    vtkObjectIDShadowPass::GetNumberOfObjectTypes(), vtkObjectIDShadowPass::GetObjectTypeName);
}

std::vector<std::string> TranslucentCasterNames()
{
  return NamesOf(
    vtkShadowPass::GetNumberOfTranslucentCastings(), vtkShadowPass::GetTranslucentCastingName);
}

void RequireBits(const std::string& option, int bits)
{
  if (bits != 8 && bits != 16 && bits != 24 && bits != 32)
  {
    throw Failure(
      option, std::to_string(bits), "is no format of a depth map", "choose one of 8, 16, 24, 32");
  }
}

std::vector<std::string> DebugViewNames()
{
  return NamesFrom(vtkShadowPass::GetDebugViewNames);
}

}

std::vector<std::string> TechniqueNames()
{
  return NamesFrom(vtkShadowPass::GetTechniqueNames);
}

std::string KnownTechniques()
{
  return ListOf(TechniqueNames());
}

void RequireTechnique(const std::string& option, const std::string& name)
{
  Require(TechniqueNames(), option, name, "is no technique of this build");
}

std::string KnownFilters()
{
  return ListOf(FilterNames());
}

void RequireFilter(const std::string& option, const std::string& name)
{
  Require(FilterNames(), option, name, "is no filter of a depth map");
}

void RequireDepthBits(const std::string& option, int bits, const std::string& filter)
{
  RequireBits(option, bits);
  if (!vtkDepthShadowMapPass::HasDepthBits(filter, bits))
  {
    throw Failure(option, std::to_string(bits), "is no format of the filter " + filter,
      "choose one of 16, 24, 32, or another --filter");
  }
}

std::string KnownObjectTypes()
{
  return ListOf(ObjectTypeNames());
}

void RequireObjectType(const std::string& option, const std::string& name)
{
  Require(ObjectTypeNames(), option, name, "is no object that has an ID of its own");
}

void RequireObjectDepthBits(const std::string& option, int bits)
{
  RequireBits(option, bits);
}

std::string KnownTranslucentCasters()
{
  return ListOf(TranslucentCasterNames());
}

void RequireTranslucentCasters(const std::string& option, const std::string& name)
{
  Require(TranslucentCasterNames(), option, name, "is no way in which translucent meshes cast");
}

std::string KnownDebugViews()
{
  return ListOf(DebugViewNames());
}

std::vector<std::string> TechniquesExplainedBy(const std::string& view)
{
  return NamesFrom(
    [&view](vtkStringArray* names) { vtkShadowPass::GetDebugViewTechniques(view, names); });
}

void RequireDebugView(const std::string& option, const std::string& name)
{
  Require(DebugViewNames(), option, name, "is no view that explains shadows");
}

}
