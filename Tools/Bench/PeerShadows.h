// VTK's own vtkShadowMapPass, and the visibility that a pass's pictures show: it cannot be read
// back.
#ifndef vtkshadows_PeerShadows_h
#define vtkshadows_PeerShadows_h

#include <vtkSmartPointer.h>

#include <cstddef>

class vtkImageData;
class vtkRenderPass;

namespace vtkshadows
{

class Stage;

// The camera, the map baker and the shadow pass, as VTK's own example wires them. `resolution`:
// texels of a side.
vtkSmartPointer<vtkRenderPass> MakePeerPass(int resolution);

// The visibility of a light as a float a pixel, from three frames in which it shines alone and
// opaque props are drawn alone: with no shadows, with the light's intensity 0, and by `pass`. What
// light adds is linear in visibility, so that of a pixel is (by pass - dark) / (lit - dark), of the
// sum of red, green and blue. It is not a number where the light adds less than 24 of the 765 steps
// there are: three roundings would decide. Afterwards everything is as it was.
vtkSmartPointer<vtkImageData> VisibilityOffPictures(
  Stage& stage, std::size_t light, vtkRenderPass* pass);

}

#endif
