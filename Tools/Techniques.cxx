#include "Techniques.h"

#include "Failure.h"

#include <vtkNew.h>
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
