#include "BenchExtremes.h"

#include "ExtremeFigures.h"
#include "Stage.h"
#include "VtkMessages.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace vtkshadows
{

struct BenchExtremes::Internals
{
  explicit Internals(vtkRenderWindow* window)
    : measure(window)
  {
  }
  ExtremeMeasure measure;
  std::vector<ExtremeCase> cases = ExtremeCases();
};

namespace
{

std::vector<std::string> TakeMessages()
{
  std::vector<std::string> messages = TakeVtkWarnings();
  const std::string error = TakeVtkError();
  if (!error.empty())
  {
    messages.push_back(error);
  }
  return messages;
}

}

std::vector<std::string> LightExtremes()
{
  std::vector<std::string> names;
  for (const ExtremeCase& extreme : ExtremeCases())
  {
    if (!extreme.isHeavy)
    {
      names.push_back(extreme.Name());
    }
  }
  return names;
}

BenchExtremes::BenchExtremes(Stage& stage)
{
  vtkRenderWindow* window = stage.Renderer()->GetRenderWindow();
  window->RemoveRenderer(stage.Renderer());
  this->internals = std::make_unique<Internals>(window);
}

BenchExtremes::~BenchExtremes() = default;

nlohmann::ordered_json BenchExtremes::Measure(const std::string& name)
{
  nlohmann::ordered_json figures = nlohmann::ordered_json::array();
  for (const ExtremeCase& extreme : this->internals->cases)
  {
    if (extreme.Name() != name)
    {
      continue;
    }
    TakeMessages();
    const double unlike = this->internals->measure.UnshadowedDifference(extreme);
    for (const std::string& technique : ExtremeTechniques())
    {
      const ExtremeOutcome outcome = this->internals->measure.Measure(extreme, technique);
      figures.push_back(ExtremeFigures(extreme, technique, unlike, outcome, TakeMessages()));
    }
  }
  return figures;
}

}
