#include "Pictures.h"

#include "Failure.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkTexture.h>
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

vtkSmartPointer<vtkTexture> ReadTexture(const std::string& option, const std::string& file)
{
  vtkNew<vtkPNGReader> reader;
  if (!reader->CanReadFile(file.c_str()))
  {
    throw Failure(option, file, "is no PNG file that can be read", "give an image as a .png");
  }
  reader->SetFileName(file.c_str());
  reader->Update();
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(reader->GetOutput());
  texture->InterpolateOn();
  return texture;
}

}
