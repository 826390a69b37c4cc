#include "vtkShadowErrorMeasure.h"

#include "TechniqueChoice.h"
#include "vtkShadowMeasured.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
class vtkShadowErrorMeasure::Internals
{
public:
  vtkShadowPass::Measured Measured;
};

vtkShadowErrorMeasure::vtkShadowErrorMeasure()
  : Internal(new Internals)
{
}

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
  this->Internal->Measured = std::move(measured);
  FillImage(this->Truth, this->Internal->Measured.Size, this->Internal->Measured.Truth);
  this->Evaluate();
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowErrorMeasure::MeasureAgain(vtkImageData* visibility, int component)
{
  vtkShadowPass::Measured& measured = this->Internal->Measured;
  if (measured.Truth.empty())
  {
    vtkErrorMacro("There is no truth that the visibility could be held against: call Measure.");
    return false;
  }
  const int* size = visibility ? visibility->GetDimensions() : nullptr;
  if (!size || size[0] != measured.Size[0] || size[1] != measured.Size[1] || size[2] != 1 ||
    visibility->GetScalarType() != VTK_FLOAT || component < 0 ||
    component >= visibility->GetNumberOfScalarComponents())
  {
    vtkErrorMacro("The visibility " << visibility << " is no image of " << measured.Size[0] << " x "
                                    << measured.Size[1] << " pixels with a float component "
                                    << component << ": give one as GetVisibility has it.");
    return false;
  }
  const auto* values = static_cast<const float*>(visibility->GetScalarPointer()) + component;
  const int components = visibility->GetNumberOfScalarComponents();
  measured.Visibility.resize(measured.Truth.size());
  for (std::size_t i = 0; i < measured.Visibility.size(); ++i)
  {
    measured.Visibility[i] = values[i * components];
  }
  this->Evaluate();
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowErrorMeasure::Evaluate()
{
  const vtkShadowPass::Measured& measured = this->Internal->Measured;
  std::vector<vtkshadows::PixelRole> roles = measured.Roles;
  for (std::size_t i = 0; i < roles.size(); ++i)
  {
    if (std::isnan(measured.Visibility[i]) && roles[i] == vtkshadows::PixelRole::Measured)
    {
      roles[i] = vtkshadows::PixelRole::Uncertain;
    }
  }
  vtkshadows::VisibilityImages images = measured.Images();
  images.role = roles.data();
  std::vector<vtkshadows::PixelVerdict> verdicts;
  const vtkshadows::VisibilityError error =
    vtkshadows::MeasureVisibility(images, vtkshadows::GrossDistance, &verdicts);

  this->ReceiverPixels = static_cast<vtkIdType>(error.receiverPixels);
  this->ShadowPixels = static_cast<vtkIdType>(error.shadowPixels);
  this->UncertainPixels = static_cast<vtkIdType>(error.uncertainPixels);
  this->MismatchPixels = static_cast<vtkIdType>(error.mismatchPixels);
  this->GrossFalsePixels = static_cast<vtkIdType>(error.grossFalsePixels);
  this->GrossMissedPixels = static_cast<vtkIdType>(error.grossMissedPixels);
  this->MismatchPercent = error.MismatchPercent();
  this->GrossPercent = error.GrossPercent();
  this->MeanAbsoluteDifference = error.MeanAbsoluteDifference();
  this->MeanPenumbraDifference = error.MeanPenumbraDifference();
  FillImage(this->Visibility, measured.Size, measured.Visibility);
  FillErrorMap(this->ErrorMap, measured.Size, verdicts);
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
double vtkShadowErrorMeasure::GetMostGrossPercent()
{
  return vtkshadows::MostGrossPercent;
}

int vtkShadowErrorMeasure::GetMostGrossPixels()
{
  return vtkshadows::MostGrossPixels;
}

double vtkShadowErrorMeasure::GetMostMismatchPercent()
{
  return vtkshadows::MostMismatchPercent;
}

double vtkShadowErrorMeasure::GetMostSoftDifferencePercent()
{
  return vtkshadows::MostSoftDifferencePercent;
}

double vtkShadowErrorMeasure::GetMostPenumbraDifferencePercent()
{
  return vtkshadows::MostPenumbraDifferencePercent;
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
  os << indent << "MeanPenumbraDifference: " << this->MeanPenumbraDifference << "\n";
}
