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
};

#endif
