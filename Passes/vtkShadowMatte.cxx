#include "vtkShadowMatte.h"

#include "vtkShadowPass.h"

#include "vtkImageData.h"
#include "vtkImageProcessingPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <memory>
#include <vector>

vtkStandardNewMacro(vtkShadowMatte);

namespace
{

// The pass by which a renderer has shadows, also where another takes samples of what it draws.
vtkShadowPass* ShadowsOf(vtkRenderer* renderer)
{
  vtkRenderPass* pass = renderer->GetPass();
  while (auto* sampling = vtkImageProcessingPass::SafeDownCast(pass))
  {
    pass = sampling->GetDelegatePass();
  }
  return vtkShadowPass::SafeDownCast(pass);
}

// One renderer's background and choice of shadows, and back at the end of the scope.
class PlainFrame
{
public:
  explicit PlainFrame(vtkRenderer* renderer)
    : Renderer(renderer)
    , Gradient(renderer->GetGradientBackground())
    , Textured(renderer->GetTexturedBackground())
    , Shadows(ShadowsOf(renderer))
    , Held(this->Shadows && this->Shadows->GetHoldChoice())
  {
    if (this->Shadows)
    {
      this->Shadows->HoldChoiceOn();
    }
    renderer->GetBackground(this->Colour);
    renderer->GradientBackgroundOff();
    renderer->TexturedBackgroundOff();
  }
  ~PlainFrame()
  {
    this->Renderer->SetBackground(this->Colour);
    this->Renderer->SetGradientBackground(this->Gradient);
    this->Renderer->SetTexturedBackground(this->Textured);
    if (this->Shadows)
    {
      this->Shadows->SetHoldChoice(this->Held);
    }
  }
  PlainFrame(const PlainFrame&) = delete;
  void operator=(const PlainFrame&) = delete;
  void SetGrey(double value) { this->Renderer->SetBackground(value, value, value); }

private:
  vtkSmartPointer<vtkRenderer> Renderer;
  bool Gradient, Textured;
  vtkSmartPointer<vtkShadowPass> Shadows;
  bool Held;
  double Colour[3];
};

}

//------------------------------------------------------------------------------
bool vtkShadowMatte::Grab(vtkRenderWindow* window, vtkImageData* image)
{
  if (!window || !image)
  {
    vtkErrorMacro("Grab(" << window << ", " << image
                          << "): give a vtkRenderWindow, and a vtkImageData to fill.");
    return false;
  }
  std::vector<std::unique_ptr<PlainFrame>> backgrounds;
  vtkCollectionSimpleIterator it;
  window->GetRenderers()->InitTraversal(it);
  while (vtkRenderer* renderer = window->GetRenderers()->GetNextRenderer(it))
  {
    backgrounds.emplace_back(new PlainFrame(renderer));
  }

  // Nobody need see the two frames.
  const vtkTypeBool swaps = window->GetSwapBuffers();
  window->SwapBuffersOff();
  vtkNew<vtkUnsignedCharArray> overBlack, overWhite;
  const int* size = window->GetSize();
  for (int frame = 0; frame < 2; ++frame)
  {
    for (const auto& background : backgrounds)
    {
      background->SetGrey(frame);
    }
    window->Render();
    size = window->GetSize();
    window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, frame ? overWhite : overBlack);
  }
  window->SetSwapBuffers(swaps);

  const vtkIdType pixels = vtkIdType(size[0]) * size[1];
  if (pixels < 1 || overBlack->GetNumberOfValues() != 3 * pixels ||
    overWhite->GetNumberOfValues() != 3 * pixels)
  {
    vtkErrorMacro("The window " << window << " gave no picture of " << size[0] << " x " << size[1]
                                << " pixels: give it a size, and a context that can be read.");
    return false;
  }
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  const unsigned char* black = overBlack->GetPointer(0);
  const unsigned char* white = overWhite->GetPointer(0);
  for (vtkIdType i = 0; i < pixels; ++i, out += 4, black += 3, white += 3)
  {
    // The page shows through alike in all three colours, but for rounding.
    const int through = white[0] - black[0] + white[1] - black[1] + white[2] - black[2];
    const int alpha = std::clamp(255 - (through + 1) / 3, 0, 255);
    for (int c = 0; c < 3; ++c)
    {
      out[c] = static_cast<unsigned char>(
        alpha > 0 ? std::min((black[c] * 255 + alpha / 2) / alpha, 255) : 0);
    }
    out[3] = static_cast<unsigned char>(alpha);
  }
  image->Modified();
  return true;
}
