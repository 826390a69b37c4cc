// Reads Geomview's OFF (VTK 9.2 has no reader for it): points and polygons of an ASCII file.
//
// Taken: OFF with any of the prefixes ST, C and N (what they add to a vertex is skipped), a file
// without the keyword, counts on the keyword's line, comments, colours behind a face, CRLF.
// Refused, with the line's number: 4OFF, nOFF, BINARY, and whatever is not what the counts promise.
// Faces of one or two vertices are no surface and are left out.
#ifndef vtkshadows_OffReader_h
#define vtkshadows_OffReader_h

#include <vtkSmartPointer.h>

#include <functional>
#include <string>

class vtkPolyData;

namespace vtkshadows
{

// `progress` is told the share of the file that is read, 0 to 1. Throws Failure.
vtkSmartPointer<vtkPolyData> ReadOff(
  const std::string& path, const std::function<void(double)>& progress);

}

#endif
