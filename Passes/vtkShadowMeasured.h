// What vtkShadowPass reads off one light for vtkShadowErrorMeasure, a pixel an entry, row by row
// from the bottom.
#ifndef vtkShadowMeasured_h
#define vtkShadowMeasured_h

#include "VisibilityError.h"
#include "vtkShadowPass.h"

#include <vector>

struct vtkShadowPass::Measured
{
  int Size[2] = { 0, 0 };
  std::vector<float> Visibility;
  std::vector<float> Truth;
  std::vector<vtkshadows::PixelRole> Roles;

  // As long as these stay as they are.
  vtkshadows::VisibilityImages Images() const
  {
    vtkshadows::VisibilityImages images;
    images.width = this->Size[0];
    images.height = this->Size[1];
    images.visibility = this->Visibility.data();
    images.truth = this->Truth.data();
    images.role = this->Roles.data();
    return images;
  }
};

#endif
