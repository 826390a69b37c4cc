// What ends the command: one line that names the thing, its value, what is wrong and the remedy.
#ifndef vtkshadows_Failure_h
#define vtkshadows_Failure_h

#include <sstream>
#include <stdexcept>
#include <string>

namespace vtkshadows
{

class Failure : public std::runtime_error
{
public:
  Failure(const std::string& object, const std::string& value, const std::string& problem,
    const std::string& remedy)
    : std::runtime_error(
        object + (value.empty() ? "" : " ") + value + ": " + problem + "; " + remedy)
  {
  }
};

// A number as messages have it: short.
inline std::string ToText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

}

#endif
