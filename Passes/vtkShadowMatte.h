/**
 * @class   vtkShadowMatte
 * @brief   a window's picture with straight alpha, right over any page
 *
 * The window is rendered twice, over black and over white: where the two differ the page shows
 * through. So it does not matter how the frame's passes treat alpha (VTK's own translucent pass,
 * SSAA and FXAA do not keep it), and the window needs no alpha planes.
 *
 * @par Reference
 * Smith, A. R., Blinn, J. F.: Blue screen matting, SIGGRAPH 1996 (triangulation matting).
 */
#ifndef vtkShadowMatte_h
#define vtkShadowMatte_h

#include "vtkObject.h"
#include "vtkShadowsPassesModule.h" // for export macro

class vtkImageData;
class vtkRenderWindow;

class VTKSHADOWSPASSES_EXPORT vtkShadowMatte : public vtkObject
{
public:
  static vtkShadowMatte* New();
  vtkTypeMacro(vtkShadowMatte, vtkObject);

  /**
   * Render `window` twice and fill `image` with its picture: red, green, blue and alpha as bytes,
   * the colour not multiplied by alpha, origin bottom-left, the window's size. The backgrounds of
   * its renderers (colour, gradient, texture) are left out, and are as before afterwards; what is
   * drawn as a prop, as a skybox is, stays. false, with an error, if it cannot be.
   */
  bool Grab(vtkRenderWindow* window, vtkImageData* image);

protected:
  vtkShadowMatte() = default;
  ~vtkShadowMatte() override = default;

private:
  vtkShadowMatte(const vtkShadowMatte&) = delete;
  void operator=(const vtkShadowMatte&) = delete;
};

#endif
