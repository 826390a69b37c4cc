// A light's view as the camera of a draw through VTK's own mappers.
#ifndef vtkShadowCasterCamera_h
#define vtkShadowCasterCamera_h

#include "LightView.h"
#include "vtkOpenGLCamera.h"

class vtkShadowCasterCamera : public vtkOpenGLCamera
{
public:
  static vtkShadowCasterCamera* New();
  vtkTypeMacro(vtkShadowCasterCamera, vtkOpenGLCamera);

  void SetView(const vtkshadows::LightView& view);

  // The matrices as mappers ask for them (VTK keeps them transposed), from doubles.
  void GetKeyMatrices(vtkRenderer* ren, vtkMatrix4x4*& wcvc, vtkMatrix3x3*& normals,
    vtkMatrix4x4*& vcdc, vtkMatrix4x4*& wcdc) override;

  // A light has no place on the screen: the scope that draws has set the viewport.
  void Render(vtkRenderer*) override {}
  void UpdateViewport(vtkRenderer*) override {}

protected:
  vtkShadowCasterCamera() = default;
  ~vtkShadowCasterCamera() override = default;

private:
  vtkShadowCasterCamera(const vtkShadowCasterCamera&) = delete;
  void operator=(const vtkShadowCasterCamera&) = delete;
};

#endif
