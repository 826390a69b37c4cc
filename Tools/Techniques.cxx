#include "Techniques.h"

#include "Failure.h"

#include <vtkNew.h>
#include <vtkShadowPass.h>
#include <vtkStringArray.h>

#include <algorithm>

namespace vtkshadows
{

std::vector<std::string> TechniqueNames()
{
  vtkNew<vtkStringArray> array;
  vtkShadowPass::GetTechniqueNames(array);
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    names.push_back(array->GetValue(i));
  }
  return names;
}

std::string KnownTechniques()
{
  std::string list;
  for (const std::string& name : TechniqueNames())
  {
    list += (list.empty() ? "" : ", ") + name;
  }
  return list;
}

void RequireTechnique(const std::string& option, const std::string& name)
{
  const std::vector<std::string> names = TechniqueNames();
  if (std::find(names.begin(), names.end(), name) == names.end())
  {
    throw Failure(option, name.empty() ? "''" : name, "is no technique of this build",
      "choose one of " + KnownTechniques());
  }
}

}
