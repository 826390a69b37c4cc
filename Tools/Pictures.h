// Images as the bytes of PNG files, top row first; and those that lights project.
#ifndef vtkshadows_Pictures_h
#define vtkshadows_Pictures_h

#include <vtkSmartPointer.h>

#include <string>

class vtkImageData;
class vtkTexture;

namespace vtkshadows
{

// `image` has bytes, one component (grey), three (RGB) or four (RGBA), origin bottom-left.
std::string PngOfBytes(vtkImageData* image);

// `visibility` has one float, 0 to 1, origin bottom-left: grey, 255 times it, rounded.
std::string PngOfVisibility(vtkImageData* visibility);

// Of a .png file; throws Failure, naming `option`, if that cannot be read.
vtkSmartPointer<vtkTexture> ReadTexture(const std::string& option, const std::string& file);

}

#endif
