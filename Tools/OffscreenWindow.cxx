#include "OffscreenWindow.h"

#include "Failure.h"
#include "VtkMessages.h"

#include <vtkImageData.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkShadowMatte.h>
#include <vtkTextureObject.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <sstream>

namespace vtkshadows
{
namespace
{

void FailAtVtkError(const std::string& object)
{
  const std::string error = TakeVtkError();
  if (!error.empty())
  {
    throw Failure(object, "", error, "change what it names, or the OpenGL driver");
  }
}

}

OffscreenWindow::OffscreenWindow() = default;
OffscreenWindow::~OffscreenWindow() = default;

void OffscreenWindow::Open(int width, int height)
{
  // Small at first, for the context that tells how large it may be.
  this->window->SetOffScreenRendering(true);
  this->window->SetMultiSamples(0);
  this->window->SetSize(16, 16);
  auto* openGL = vtkOpenGLRenderWindow::SafeDownCast(this->window);
  if (!openGL)
  {
    throw Failure("OpenGL", "", "this VTK has no OpenGL window", "use a VTK with RenderingOpenGL2");
  }
  openGL->Initialize();
  FailAtVtkError("OpenGL");
  openGL->MakeCurrent();

  this->largestTexture = vtkTextureObject::GetMaximumTextureSize(openGL);
  this->Resize(width, height);
}

void OffscreenWindow::Resize(int width, int height)
{
  if (std::max(width, height) > this->largestTexture)
  {
    const std::string limit = std::to_string(this->largestTexture);
    throw Failure("--size", std::to_string(width) + "x" + std::to_string(height),
      "is more than this OpenGL driver can draw", "choose at most " + limit + "x" + limit);
  }
  this->window->SetSize(width, height);
}

void OffscreenWindow::Add(vtkRenderer* renderer)
{
  this->window->AddRenderer(renderer);
}

void OffscreenWindow::Render()
{
  this->window->Render();
  this->window->WaitForCompletion();
  FailAtVtkError("rendering");
}

vtkSmartPointer<vtkImageData> OffscreenWindow::Picture()
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(this->window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  FailAtVtkError("picture");
  return grab->GetOutput();
}

vtkSmartPointer<vtkImageData> OffscreenWindow::TransparentPicture()
{
  vtkNew<vtkShadowMatte> matte;
  auto picture = vtkSmartPointer<vtkImageData>::New();
  matte->Grab(this->window, picture);
  FailAtVtkError("picture");
  return picture;
}

std::string OffscreenWindow::OpenGLRenderer()
{
  const std::string heading = "OpenGL renderer string:";
  std::istringstream capabilities(this->window->ReportCapabilities());
  for (std::string line; std::getline(capabilities, line);)
  {
    if (line.compare(0, heading.size(), heading) == 0)
    {
      const std::size_t begin = line.find_first_not_of(' ', heading.size());
      return begin == std::string::npos ? "" : line.substr(begin);
    }
  }
  return "unknown";
}

}
