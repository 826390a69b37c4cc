#include "ExtremeMeasure.h"

#include "vtkDepthShadowMapPass.h"
#include "vtkObjectIDShadowPass.h"
#include "vtkShadowErrorMeasure.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowPass.h"
#include "vtkShadowTexturePass.h"

#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace vtkshadows
{
namespace
{

// A frame's colours differ by more than rounding from here on, of 255.
constexpr int ColourTolerance = 8;

// Of a map, a side.
constexpr int MapResolution = 1024;

std::vector<float> ValuesOf(vtkImageData* image)
{
  const auto* values = static_cast<float*>(image->GetScalarPointer());
  return std::vector<float>(values, values + image->GetNumberOfPoints());
}

double AgreementPercent(const std::vector<float>& a, const std::vector<float>& b)
{
  if (a.size() != b.size() || a.empty())
  {
    return 0.0;
  }
  std::size_t alike = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    alike += (a[i] < 0.5f) == (b[i] < 0.5f) ? 1 : 0;
  }
  return 100.0 * static_cast<double>(alike) / static_cast<double>(a.size());
}

void SetTechnique(vtkShadowPass* pass, const std::string& technique)
{
  const std::size_t blank = technique.find(' ');
  pass->SetTechnique(technique.substr(0, blank));
  pass->GetDepthShadowMapPass()->SetFilter(
    blank == std::string::npos ? "percentage-closer" : technique.substr(blank + 1));
  pass->GetDepthShadowMapPass()->SetResolution(MapResolution);
  pass->GetObjectIDShadowPass()->SetResolution(MapResolution);
  pass->GetShadowTexturePass()->SetResolution(MapResolution);
}

std::string FileName(std::string name)
{
  std::replace_if(
    name.begin(), name.end(),
    [](char c) { return !std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.'; },
    '_');
  return name + ".png";
}

ExtremeScene PlainSceneOf(const ExtremeCase& extreme)
{
  ExtremeScene scene = PlainExtremeScene();
  if (extreme.plain)
  {
    extreme.plain(scene);
  }
  return scene;
}

void WritePng(vtkImageData* image, const std::string& file)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->Write();
}

}

//------------------------------------------------------------------------------
double ExtremeOutcome::MismatchPercent() const
{
  return this->receivers > 0
    ? 100.0 * static_cast<double>(this->mismatch) / static_cast<double>(this->receivers)
    : 0.0;
}

//------------------------------------------------------------------------------
std::vector<std::string> ExtremeTechniques()
{
  vtkNew<vtkStringArray> names;
  vtkShadowPass::GetTechniqueNames(names);
  std::vector<std::string> techniques;
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    const std::string name = names->GetValue(i);
    if (name == "none" || name == "auto")
    {
      continue;
    }
    techniques.push_back(name);
    if (name == "depth-map")
    {
      techniques.push_back("depth-map exact");
    }
  }
  return techniques;
}

//------------------------------------------------------------------------------
ExtremeMeasure::ExtremeMeasure(vtkRenderWindow* window)
  : Window(window)
{
  this->Window->SetMultiSamples(0);
  this->Window->AddRenderer(this->Renderer);
}

ExtremeMeasure::~ExtremeMeasure()
{
  this->Renderer->SetPass(nullptr);
  this->Window->RemoveRenderer(this->Renderer);
}

//------------------------------------------------------------------------------
ExtremeOutcome ExtremeMeasure::MeasureScene(const ExtremeScene& scene, const std::string& technique,
  Images& first, const std::string& picture)
{
  ExtremeOutcome outcome;
  this->Window->SetSize(scene.width, scene.height);
  const std::vector<vtkSmartPointer<vtkLight>> lights = Build(scene, this->Renderer);
  vtkNew<vtkShadowPass> pass;
  SetTechnique(pass, technique);
  this->Renderer->SetPass(pass);
  this->Window->Render();
  outcome.made = lights.empty();
  std::vector<vtkLight*> measured;
  if (!lights.empty())
  {
    measured.push_back(lights.front());
  }
  if (lights.size() > 1)
  {
    measured.push_back(lights.back());
  }
  for (vtkLight* light : measured)
  {
    Images images;
    if (pass->GetRayCastShadowPass())
    {
      vtkNew<vtkShadowErrorMeasure> error;
      outcome.made =
        error->Measure(this->Renderer, light) && (outcome.made || light == measured[0]);
      if (!outcome.made)
      {
        break;
      }
      outcome.receivers += error->GetReceiverPixels();
      outcome.shadowed += error->GetShadowPixels();
      outcome.uncertain += error->GetUncertainPixels();
      outcome.mismatch += error->GetMismatchPixels();
      outcome.gross += error->GetGrossPixels();
      images = { ValuesOf(error->GetVisibility()), ValuesOf(error->GetTruth()) };
      if (!this->Pictures.empty() && light == measured[0])
      {
        WritePng(error->GetErrorMap(), this->Pictures + "/" + FileName(picture));
      }
    }
    else
    {
      vtkNew<vtkImageData> visibility;
      outcome.made = pass->GetVisibility(this->Renderer, light, visibility) &&
        (outcome.made || light == measured[0]);
      if (!outcome.made)
      {
        break;
      }
      images.visibility = ValuesOf(visibility);
    }
    if (light == measured[0])
    {
      first = std::move(images);
    }
  }
  this->Window->MakeCurrent();
  outcome.openGLError = glGetError();
  this->Renderer->SetPass(nullptr);
  pass->ReleaseGraphicsResources(this->Window);
  return outcome;
}

//------------------------------------------------------------------------------
ExtremeOutcome ExtremeMeasure::Measure(const ExtremeCase& extreme, const std::string& technique)
{
  ExtremeScene scene = PlainExtremeScene();
  extreme.change(scene);
  Images images;
  ExtremeOutcome outcome =
    this->MeasureScene(scene, technique, images, extreme.Name() + " " + technique);
  if (extreme.looksPlain && outcome.made)
  {
    const std::string plain = extreme.plain ? extreme.kind : "";
    const auto isNew = this->Plain[plain].emplace(technique, Images());
    if (isNew.second)
    {
      this->MeasureScene(
        PlainSceneOf(extreme), technique, isNew.first->second, "plain " + plain + " " + technique);
    }
    outcome.agreement = AgreementPercent(images.visibility, isNew.first->second.visibility);
    outcome.truthAgreement =
      images.truth.empty() ? -1.0 : AgreementPercent(images.truth, isNew.first->second.truth);
  }
  return outcome;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> ExtremeMeasure::FrameOf(const ExtremeScene& scene)
{
  this->Window->SetSize(scene.width, scene.height);
  Build(scene, this->Renderer);
  this->Window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(0, 0, scene.width - 1, scene.height - 1, 0, pixels);
  return std::vector<unsigned char>(
    pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
}

double ExtremeMeasure::UnshadowedDifference(const ExtremeCase& extreme)
{
  if (!extreme.looksPlain)
  {
    return -1.0;
  }
  std::vector<unsigned char>& plain = this->PlainFrames[extreme.plain ? extreme.kind : ""];
  if (plain.empty())
  {
    plain = this->FrameOf(PlainSceneOf(extreme));
  }
  // Its first light alone, as the plain still life has it.
  ExtremeScene scene = PlainExtremeScene();
  extreme.change(scene);
  scene.lights.resize(1);
  const std::vector<unsigned char> frame = this->FrameOf(scene);
  std::size_t unlike = 0;
  for (std::size_t i = 0; i + 2 < std::min(frame.size(), plain.size()); i += 3)
  {
    int largest = 0;
    for (std::size_t c = i; c < i + 3; ++c)
    {
      largest = std::max(largest, std::abs(int(frame[c]) - int(plain[c])));
    }
    unlike += largest > ColourTolerance ? 1 : 0;
  }
  return 100.0 * static_cast<double>(unlike) / (static_cast<double>(plain.size()) / 3.0);
}

}
