// Images as the bytes of PNG files, top row first.
#ifndef vtkshadows_Pictures_h
#define vtkshadows_Pictures_h

#include <string>

class vtkImageData;

namespace vtkshadows
{

// `image` has bytes, one component (grey), three (RGB) or four (RGBA), origin bottom-left.
std::string PngOfBytes(vtkImageData* image);

// `visibility` has one float, 0 to 1, origin bottom-left: grey, 255 times it, rounded.
std::string PngOfVisibility(vtkImageData* visibility);

}

#endif
