// One option's text, cut into pieces and numbers; its failures name the option and the whole text.
#ifndef vtkshadows_SpecText_h
#define vtkshadows_SpecText_h

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace vtkshadows
{

class SpecText
{
public:
  // `remedy` says how the option is written.
  SpecText(std::string option, std::string text, std::string remedy);

  const std::string& Text() const { return this->text; }

  [[noreturn]] void Fail(const std::string& problem) const;
  [[noreturn]] void Fail(const std::string& problem, const std::string& remedy) const;

  // `count` finite numbers between commas; `what` names them in a failure.
  std::vector<double> Numbers(
    const std::string& piece, std::size_t count, const std::string& what) const;
  double Number(const std::string& piece, const std::string& what) const;
  glm::dvec3 Vector(const std::string& piece, const std::string& what) const;

private:
  std::string option;
  std::string text;
  std::string remedy;
};

std::vector<std::string> Split(const std::string& text, char separator);

}

#endif
