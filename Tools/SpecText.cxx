#include "SpecText.h"

#include "Failure.h"

#include <cmath>
#include <cstdlib>
#include <utility>

namespace vtkshadows
{

SpecText::SpecText(std::string optionName, std::string wholeText, std::string howToWrite)
  : option(std::move(optionName))
  , text(std::move(wholeText))
  , remedy(std::move(howToWrite))
{
}

void SpecText::Fail(const std::string& problem) const
{
  this->Fail(problem, this->remedy);
}

void SpecText::Fail(const std::string& problem, const std::string& otherRemedy) const
{
  throw Failure(this->option, this->text.empty() ? "''" : this->text, problem, otherRemedy);
}

std::vector<double> SpecText::Numbers(
  const std::string& piece, std::size_t count, const std::string& what) const
{
  const std::vector<std::string> words = Split(piece, ',');
  if (words.size() != count)
  {
    this->Fail(what + " '" + piece + "' should be " + std::to_string(count) +
      (count == 1 ? " number" : " numbers with commas between"));
  }

  std::vector<double> numbers;
  for (const std::string& word : words)
  {
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !std::isfinite(number))
    {
      this->Fail(what + " '" + piece + "': '" + word + "' is not a finite number");
    }
    numbers.push_back(number);
  }
  return numbers;
}

double SpecText::Number(const std::string& piece, const std::string& what) const
{
  return this->Numbers(piece, 1, what).front();
}

glm::dvec3 SpecText::Vector(const std::string& piece, const std::string& what) const
{
  const std::vector<double> numbers = this->Numbers(piece, 3, what);
  return { numbers[0], numbers[1], numbers[2] };
}

std::vector<std::string> Split(const std::string& text, char separator)
{
  std::vector<std::string> pieces(1);
  for (const char c : text)
  {
    if (c == separator)
    {
      pieces.emplace_back();
    }
    else
    {
      pieces.back() += c;
    }
  }
  return pieces;
}

}
