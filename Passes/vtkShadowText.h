// Text of shaders that settings are written into.
#ifndef vtkShadowText_h
#define vtkShadowText_h

#include <cstdio>
#include <string>

namespace vtkShadowText
{

inline std::string Replaced(std::string text, const std::string& name, const std::string& by)
{
  for (std::size_t at = text.find(name); at != std::string::npos;
       at = text.find(name, at + by.size()))
  {
    text.replace(at, name.size(), by);
  }
  return text;
}

// A number as GLSL reads a float back, to its last bit.
inline std::string Float(double number)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.9e", number);
  return text;
}

inline std::string Define(const std::string& name, const std::string& value = {})
{
  return "#define " + name + " " + value + "\n";
}

}

#endif
