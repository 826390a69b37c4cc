// What the setters of passes refuse, each in one message that names the setting, the value, what
// would be right, and what stays.
#ifndef vtkShadowChecks_h
#define vtkShadowChecks_h

#include "vtkObject.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>

// Written so that NaN is refused.
template <typename T>
bool vtkShadowRefusesRange(
  vtkObject* pass, const char* setting, T value, T lowest, T highest, T before)
{
  if (value >= lowest && value <= highest)
  {
    return false;
  }
  vtkErrorWithObjectMacro(pass, << setting << " " << value << " is out of range: give " << lowest
                                << " to " << highest << ". It stays " << before << ".");
  return true;
}

// Of an enumeration `type`, that counts from 0.
inline bool vtkShadowRefusesChoice(
  vtkObject* pass, const char* setting, const char* type, int value, int choices, int before)
{
  if (value >= 0 && value < choices)
  {
    return false;
  }
  vtkErrorWithObjectMacro(pass, << setting << " " << value << " is none of " << type << " (0 to "
                                << choices - 1 << "). It stays " << before << ".");
  return true;
}

// Of a map or a texture, `what`, along a side. One above the driver's limit is told of when it is
// drawn (vtkShadowTechniquePass::WithinDriver).
inline bool vtkShadowRefusesSize(
  vtkObject* pass, const char* setting, const char* what, int texels, int before)
{
  if (texels >= 1)
  {
    return false;
  }
  vtkErrorWithObjectMacro(pass, << setting << " " << texels << " is no size of " << what
                                << ": give 1 or more texels. It stays " << before << ".");
  return true;
}

inline bool vtkShadowRefusesDepthBits(vtkObject* pass, int bits, int before)
{
  if (bits == 8 || bits == 16 || bits == 24 || bits == 32)
  {
    return false;
  }
  vtkErrorWithObjectMacro(pass, << "DepthBits " << bits << " is no format of a map's depths: give "
                                << "8, 16, 24 or 32 (a float). It stays " << before << ".");
  return true;
}

// Which of `names` it is, in their order; none if it is refused.
template <typename Names>
std::optional<int> vtkShadowChoiceOf(
  vtkObject* pass, const char* setting, const Names& names, const std::string& name, int before)
{
  const auto found = std::find(std::begin(names), std::end(names), name);
  if (found != std::end(names))
  {
    return static_cast<int>(found - std::begin(names));
  }
  std::string list;
  for (const char* known : names)
  {
    list += (list.empty() ? "" : ", ") + std::string(known);
  }
  vtkErrorWithObjectMacro(pass, << setting << " \"" << name << "\" is not known: use one of "
                                << list << ". It stays \"" << names[before] << "\".");
  return std::nullopt;
}

#endif
