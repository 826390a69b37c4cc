#include "ShadowTest.h"

#include "vtkShadowErrorMeasure.h"
#include "vtkShadowOpenGL.h"

#include <vtkCompositePolyDataMapper.h>
#if __has_include(<vtkCompositePolyDataMapper2.h>)
#include <vtkCompositePolyDataMapper2.h>
#endif
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>
#include <vtkRendererCollection.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace
{

constexpr int DefaultSize[2] = { 400, 300 };

std::vector<std::string>& Messages()
{
  static std::vector<std::string> messages;
  return messages;
}

// Keeps what VTK says instead of printing it.
class KeepingWindow : public vtkOutputWindow
{
public:
  static KeepingWindow* New();
  vtkTypeMacro(KeepingWindow, vtkOutputWindow);

  void DisplayText(const char* text) override { Messages().emplace_back(text); }
  void DisplayErrorText(const char* text) override { this->DisplayText(text); }
  void DisplayWarningText(const char* text) override { this->DisplayText(text); }
  void DisplayGenericWarningText(const char* text) override { this->DisplayText(text); }
  void DisplayDebugText(const char*) override {}
};
vtkStandardNewMacro(KeepingWindow);

vtkRenderWindow* TheWindow()
{
  static vtkRenderWindow* window = nullptr;
  if (!window)
  {
    // Never deleted: its context must outlive whatever is released late.
    window = vtkRenderWindow::New();
    window->OffScreenRenderingOn();
  }
  return window;
}

}

namespace shadowtest
{

//------------------------------------------------------------------------------
bool Check(const std::string& what, double got, double expected, double tolerance)
{
  const bool holds = std::abs(got - expected) <= tolerance;
  std::printf("%s %s: got %.10g, expected %.10g, tolerance %.3g\n", holds ? "  ok  " : "  FAIL",
    what.c_str(), got, expected, tolerance);
  EXPECT_TRUE(holds) << what << ": got " << got << ", expected " << expected << ", tolerance "
                     << tolerance;
  return holds;
}

bool CheckAtMost(const std::string& what, double got, double limit)
{
  const bool holds = got <= limit;
  std::printf("%s %s: got %.10g, expected at most %.10g\n", holds ? "  ok  " : "  FAIL",
    what.c_str(), got, limit);
  EXPECT_TRUE(holds) << what << ": got " << got << ", expected at most " << limit;
  return holds;
}

bool CheckAtLeast(const std::string& what, double got, double limit)
{
  const bool holds = got >= limit;
  std::printf("%s %s: got %.10g, expected at least %.10g\n", holds ? "  ok  " : "  FAIL",
    what.c_str(), got, limit);
  EXPECT_TRUE(holds) << what << ": got " << got << ", expected at least " << limit;
  return holds;
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkMapper>> CompositeMappers()
{
  std::vector<vtkSmartPointer<vtkMapper>> mappers{
    vtkSmartPointer<vtkCompositePolyDataMapper>::New()
  };
#if __has_include(<vtkCompositePolyDataMapper2.h>)
  mappers.push_back(vtkSmartPointer<vtkCompositePolyDataMapper2>::New());
#endif
  return mappers;
}

//------------------------------------------------------------------------------
std::vector<std::string> TakeMessages()
{
  return std::exchange(Messages(), {});
}

void ExpectOneMessage(const std::vector<std::string>& parts)
{
  const std::vector<std::string> messages = TakeMessages();
  Check("messages", static_cast<double>(messages.size()), 1.0);
  for (const std::string& message : messages)
  {
    std::printf("       %s\n", message.c_str());
  }
  if (messages.empty())
  {
    return;
  }
  for (const std::string& part : parts)
  {
    EXPECT_NE(messages[0].find(part), std::string::npos)
      << "no \"" << part << "\" in: " << messages[0];
  }
}

//------------------------------------------------------------------------------
int Frame::Brightness(int x, int y) const
{
  const unsigned char* pixel = &this->rgb[3 * (std::size_t(y) * this->width + x)];
  return pixel[0] + pixel[1] + pixel[2];
}

std::size_t Visibility::CountShadowed() const
{
  return std::count_if(
    this->values.begin(), this->values.end(), [](float value) { return value < 0.5f; });
}

void WritePng(const Frame& frame, const std::string& file)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(frame.width, frame.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(
    frame.rgb.begin(), frame.rgb.end(), static_cast<unsigned char*>(image->GetScalarPointer()));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->Write();
}

std::size_t CountDifferent(const Frame& a, const Frame& b, int tolerance)
{
  if (a.width != b.width || a.height != b.height)
  {
    return std::max(a.rgb.size(), b.rgb.size()) / 3;
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3)
  {
    int largest = 0;
    for (std::size_t c = i; c < i + 3; ++c)
    {
      largest = std::max(largest, std::abs(a.rgb[c] - b.rgb[c]));
    }
    count += largest > tolerance ? 1 : 0;
  }
  return count;
}

std::size_t CountDifferent(const Visibility& a, const Visibility& b)
{
  if (a.width != b.width || a.height != b.height)
  {
    return std::max(a.values.size(), b.values.size());
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
  {
    count += (a.values[i] < 0.5f) != (b.values[i] < 0.5f) ? 1 : 0;
  }
  return count;
}

Pixel PixelOf(vtkRenderer* renderer, const glm::dvec3& pointWC)
{
  renderer->SetWorldPoint(pointWC.x, pointWC.y, pointWC.z, 1.0);
  renderer->WorldToDisplay();
  const double* display = renderer->GetDisplayPoint();
  const int* origin = renderer->GetOrigin();
  return { static_cast<int>(std::floor(display[0])) - origin[0],
    static_cast<int>(std::floor(display[1])) - origin[1] };
}

//------------------------------------------------------------------------------
ShadowTest::ShadowTest()
  : Window(TheWindow())
{
  // What a technique does is tested by name; what is chosen, in TestAuto.cxx.
  this->Shadows->SetTechnique("depth-map");
}

ShadowTest::~ShadowTest() = default;

void ShadowTest::SetUp()
{
  this->Window->SetMultiSamples(0);
  this->Window->SetNumberOfLayers(1);
  this->Window->SetAlphaBitPlanes(0);
  this->Resize(DefaultSize[0], DefaultSize[1]);
  this->Window->AddRenderer(this->Renderer);
  TakeMessages();
}

void ShadowTest::TearDown()
{
  for (const std::string& message : TakeMessages())
  {
    ADD_FAILURE() << "VTK said: " << message;
  }
  if (!this->Window->GetNeverRendered())
  {
    Check("OpenGL error", TakeOpenGLError(), GL_NO_ERROR);
  }
  while (vtkRenderer* renderer = this->Window->GetRenderers()->GetFirstRenderer())
  {
    renderer->SetPass(nullptr);
    this->Window->RemoveRenderer(renderer);
  }
}

Frame ShadowTest::Render()
{
  this->Window->Render();
  Frame frame;
  frame.width = this->Window->GetSize()[0];
  frame.height = this->Window->GetSize()[1];
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(0, 0, frame.width - 1, frame.height - 1, 0, pixels);
  frame.rgb.assign(pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
  return frame;
}

Frame ShadowTest::RenderWithoutPass()
{
  const vtkSmartPointer<vtkRenderPass> pass = this->Renderer->GetPass();
  this->Renderer->SetPass(nullptr);
  Frame frame = this->Render();
  this->Renderer->SetPass(pass);
  return frame;
}

Visibility ShadowTest::VisibilityOf(vtkLight* light)
{
  Visibility visibility;
  vtkNew<vtkImageData> image;
  const bool made = this->Shadows->GetVisibility(this->Renderer, light, image);
  EXPECT_TRUE(made) << "no visibility";
  if (made)
  {
    visibility.width = image->GetDimensions()[0];
    visibility.height = image->GetDimensions()[1];
    const auto* values = static_cast<float*>(image->GetScalarPointer());
    visibility.values.assign(values, values + image->GetNumberOfPoints());
  }
  return visibility;
}

Visibility ShadowTest::VisibilityBy(const std::string& technique, vtkLight* light)
{
  this->Shadows->SetTechnique(technique);
  this->Render();
  return this->VisibilityOf(light);
}

void ShadowTest::Resize(int width, int height)
{
  this->Window->SetSize(width, height);
}

void ShadowTest::CheckMeasure(
  const std::string& what, vtkLight* light, double mismatchPercent, double grossPercent)
{
  vtkNew<vtkShadowErrorMeasure> error;
  ASSERT_TRUE(error->Measure(this->Renderer, light)) << what;
  const std::string figures = what + " (" + std::to_string(error->GetReceiverPixels()) +
    " receivers, " + std::to_string(error->GetShadowPixels()) + " in shadow, " +
    std::to_string(error->GetUncertainPixels()) + " left out, gross " +
    std::to_string(error->GetGrossFalsePixels()) + " false " +
    std::to_string(error->GetGrossMissedPixels()) + " missed)";
  EXPECT_GT(error->GetReceiverPixels(), 0) << what;
  CheckAtMost(figures + ": mismatch %", error->GetMismatchPercent(), mismatchPercent);
  CheckAtMost(what + ": gross %", error->GetGrossPercent(), grossPercent);
}

//------------------------------------------------------------------------------
unsigned int TakeOpenGLError()
{
  TheWindow()->MakeCurrent();
  return glGetError();
}

}

//------------------------------------------------------------------------------
int main(int argc, char** argv)
{
  ::testing::InitGoogleTest(&argc, argv);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(vtkSmartPointer<KeepingWindow>::New());
  return RUN_ALL_TESTS();
}
