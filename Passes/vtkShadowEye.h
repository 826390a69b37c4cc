// The eye's view with depths as tight as what is seen of some boxes, whatever the camera's clipping
// range: the steps of a depth buffer are what is held against it.
#ifndef vtkShadowEye_h
#define vtkShadowEye_h

#include "ShadowReach.h"
#include "vtkShadowSceneData.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderer.h"

inline vtkshadows::LightView vtkShadowEyeOf(
  const vtkShadowFrame& frame, const std::vector<vtkshadows::BoxCorners>& seen)
{
  vtkshadows::LightView view;
  view.parallel = frame.Renderer->GetActiveCamera()->GetParallelProjection() != 0;
  view.viewFromWorld = frame.ViewFromWorld;
  view.clipFromView = vtkshadows::WithDepthRange(
    frame.ClipFromView, vtkshadows::SeenDepths(frame.ClipFromView, view.viewFromWorld, seen));
  return view;
}

#endif
