#include "Pictures.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace vtkshadows
{

std::string PngOfBytes(vtkImageData* image)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return bytes ? std::string(reinterpret_cast<const char*>(bytes->GetPointer(0)),
                   static_cast<std::size_t>(bytes->GetNumberOfValues()))
               : std::string();
}

std::string PngOfVisibility(vtkImageData* visibility)
{
  vtkNew<vtkImageData> grey;
  grey->SetDimensions(visibility->GetDimensions());
  grey->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  vtkDataArray* source = visibility->GetPointData()->GetScalars();
  auto* target = static_cast<unsigned char*>(grey->GetScalarPointer());
  for (vtkIdType i = 0; i < source->GetNumberOfTuples(); ++i)
  {
    const double seen = std::clamp(source->GetComponent(i, 0), 0.0, 1.0);
    target[i] = static_cast<unsigned char>(std::lround(255.0 * seen));
  }
  return PngOfBytes(grey);
}

}
