#include "vtkShadowCasterCamera.h"

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkShadowMatrix.h"

#include <glm/matrix.hpp>

vtkStandardNewMacro(vtkShadowCasterCamera);

//------------------------------------------------------------------------------
void vtkShadowCasterCamera::SetView(const vtkshadows::LightView& view)
{
  vtkShadowMatrix::ToVtk(glm::transpose(view.viewFromWorld), this->WCVCMatrix);
  vtkShadowMatrix::ToVtk(glm::transpose(view.clipFromView), this->VCDCMatrix);
  vtkShadowMatrix::ToVtk(glm::transpose(view.clipFromView * view.viewFromWorld), this->WCDCMatrix);
  const glm::dmat4 worldFromView = glm::inverse(view.viewFromWorld);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      this->NormalMatrix->SetElement(row, column, worldFromView[column][row]);
    }
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkShadowCasterCamera::GetKeyMatrices(vtkRenderer*, vtkMatrix4x4*& wcvc,
  vtkMatrix3x3*& normals, vtkMatrix4x4*& vcdc, vtkMatrix4x4*& wcdc)
{
  wcvc = this->WCVCMatrix;
  normals = this->NormalMatrix;
  vcdc = this->VCDCMatrix;
  wcdc = this->WCDCMatrix;
}
