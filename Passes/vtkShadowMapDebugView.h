// Views that explain the maps of a light: "cascades", "texel-density", "map" and "lit-part", as
// vtkShadowPass::SetDebugView describes them.
#ifndef vtkShadowMapDebugView_h
#define vtkShadowMapDebugView_h

#include <string>
#include <vector>

class vtkShadowMapViews;
class vtkShadowTextureArray;
struct vtkShadowFrame;

namespace vtkShadowMapDebugView
{

const std::vector<std::string>& Names();

// Over the frame, in the bound framebuffer, with the maps bound to their unit; `linear`: what they
// hold is linear in the distance from the light. false if there is no such view, or no buffer for
// what it needs.
bool Draw(const std::string& name, const vtkShadowFrame& frame, const vtkShadowMapViews& views,
  int slot, const vtkShadowTextureArray& maps, bool linear);

}

#endif
