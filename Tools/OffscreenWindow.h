// The one window of the process (VTK 9.2 aborts where many are opened), never on a screen.
#ifndef vtkshadows_OffscreenWindow_h
#define vtkshadows_OffscreenWindow_h

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkImageData;
class vtkRenderWindow;
class vtkRenderer;

namespace vtkshadows
{

class OffscreenWindow
{
public:
  OffscreenWindow();
  ~OffscreenWindow();

  // Throws Failure if there is no OpenGL, or if it cannot draw so many pixels.
  void Open(int width, int height);

  // Throws Failure if it is more than this driver can draw.
  void Resize(int width, int height);

  void Add(vtkRenderer* renderer);

  // Draw a frame and wait until it is done. Throws Failure at the first error of VTK's.
  void Render();

  // The last frame, RGB bytes.
  vtkSmartPointer<vtkImageData> Picture();
  // RGBA bytes over no background at all; draws frames of its own.
  vtkSmartPointer<vtkImageData> TransparentPicture();

  // Of this driver: texels along a side of a texture, and how it calls itself.
  int LargestTexture() const { return this->largestTexture; }
  std::string OpenGLRenderer();

private:
  vtkNew<vtkRenderWindow> window;
  int largestTexture = 0;
};

}

#endif
