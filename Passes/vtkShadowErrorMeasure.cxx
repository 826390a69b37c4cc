#include "vtkShadowErrorMeasure.h"

#include "vtkShadowMeasured.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

#include <algorithm>

vtkStandardNewMacro(vtkShadowErrorMeasure);

namespace
{

void FillImage(vtkImageData* image, const int size[2], const std::vector<float>& values)
{
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  std::copy(values.begin(), values.end(), static_cast<float*>(image->GetScalarPointer()));
  image->Modified();
}

// Okabe and Ito's palette (2008), which the colour-blind can tell apart.
const unsigned char* ColourOf(vtkshadows::PixelVerdict verdict)
{
  static const unsigned char colours[][3] = {
    { 255, 255, 255 }, // Background
    { 160, 160, 160 }, // Grazing
    { 160, 160, 160 }, // Uncertain
    { 225, 225, 225 }, // RightLit
    { 95, 95, 95 },    // RightShadow
    { 230, 159, 0 },   // FalseShadow
    { 86, 180, 233 },  // MissedShadow
    { 200, 0, 0 },     // GrossFalseShadow
    { 0, 0, 220 },     // GrossMissedShadow
  };
  return colours[static_cast<int>(verdict)];
}

void FillErrorMap(
  vtkImageData* image, const int size[2], const std::vector<vtkshadows::PixelVerdict>& verdicts)
{
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* rgb = static_cast<unsigned char*>(image->GetScalarPointer());
  for (const vtkshadows::PixelVerdict verdict : verdicts)
  {
    rgb = std::copy_n(ColourOf(verdict), 3, rgb);
  }
  image->Modified();
}

}

//------------------------------------------------------------------------------
vtkShadowErrorMeasure::vtkShadowErrorMeasure() = default;
vtkShadowErrorMeasure::~vtkShadowErrorMeasure() = default;

//------------------------------------------------------------------------------
bool vtkShadowErrorMeasure::Measure(vtkRenderer* renderer, vtkLight* light)
{
  auto* pass = renderer ? vtkShadowPass::SafeDownCast(renderer->GetPass()) : nullptr;
  if (!pass)
  {
    vtkErrorMacro("The renderer " << renderer
                                  << " has no vtkShadowPass whose shadows could be measured: call "
                                     "SetPass with one, and Render.");
    return false;
  }
  vtkShadowPass::Measured measured;
  if (!pass->MeasureLight(renderer, light, measured))
  {
    return false;
  }

  vtkshadows::VisibilityImages images;
  images.width = measured.Size[0];
  images.height = measured.Size[1];
  images.visibility = measured.Visibility.data();
  images.truth = measured.Truth.data();
  images.role = measured.Roles.data();
  std::vector<vtkshadows::PixelVerdict> verdicts;
  const vtkshadows::VisibilityError error = vtkshadows::MeasureVisibility(images, 2.0, &verdicts);

  this->ReceiverPixels = static_cast<vtkIdType>(error.receiverPixels);
  this->ShadowPixels = static_cast<vtkIdType>(error.shadowPixels);
  this->UncertainPixels = static_cast<vtkIdType>(error.uncertainPixels);
  this->MismatchPixels = static_cast<vtkIdType>(error.mismatchPixels);
  this->GrossFalsePixels = static_cast<vtkIdType>(error.grossFalsePixels);
  this->GrossMissedPixels = static_cast<vtkIdType>(error.grossMissedPixels);
  this->MismatchPercent = error.MismatchPercent();
  this->GrossPercent = error.GrossPercent();
  this->MeanAbsoluteDifference = error.MeanAbsoluteDifference();
  FillImage(this->Visibility, measured.Size, measured.Visibility);
  FillImage(this->Truth, measured.Size, measured.Truth);
  FillErrorMap(this->ErrorMap, measured.Size, verdicts);
  return true;
}

//------------------------------------------------------------------------------
vtkImageData* vtkShadowErrorMeasure::GetVisibility()
{
  return this->Visibility;
}

vtkImageData* vtkShadowErrorMeasure::GetTruth()
{
  return this->Truth;
}

vtkImageData* vtkShadowErrorMeasure::GetErrorMap()
{
  return this->ErrorMap;
}

//------------------------------------------------------------------------------
void vtkShadowErrorMeasure::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReceiverPixels: " << this->ReceiverPixels << "\n";
  os << indent << "ShadowPixels: " << this->ShadowPixels << "\n";
  os << indent << "UncertainPixels: " << this->UncertainPixels << "\n";
  os << indent << "MismatchPercent: " << this->MismatchPercent << "\n";
  os << indent << "GrossFalsePixels: " << this->GrossFalsePixels << "\n";
  os << indent << "GrossMissedPixels: " << this->GrossMissedPixels << "\n";
  os << indent << "MeanAbsoluteDifference: " << this->MeanAbsoluteDifference << "\n";
}
