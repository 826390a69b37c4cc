#include "vtkShadowMapDebugView.h"

#include "vtkMapShadowPassViewFS.h"
#include "vtkShadowFullScreen.h"
#include "vtkShadowMapViews.h"
#include "vtkShadowMatrix.h"
#include "vtkShadowOverlay.h"
#include "vtkShadowReceiverBuffer.h"
#include "vtkShadowTextureArray.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{

// As the shader has them.
constexpr std::size_t MostMaps = 8;
std::string At(const char* uniform, std::size_t i)
{
  return std::string(uniform) + "[" + std::to_string(i) + "]";
}

void SetMaps(vtkShaderProgram* program, const vtkShadowFrame& frame, const vtkShadowMapViews& views,
  const vtkShadowMapSlot& slot, bool linear)
{
  const std::size_t count = std::min(slot.Views.size(), MostMaps);
  program->SetUniformi("shadowNumberOfMaps", static_cast<int>(count));
  const double viewPerWorld = glm::length(glm::dvec3(frame.ViewFromWorld[0]));
  for (std::size_t i = 0; i < count; ++i)
  {
    const vtkShadowMapView& placed = slot.Views[i];
    std::array<float, 16> matrix =
      vtkShadowMatrix::ToFloats(views.MapFromView(placed.View, frame.ViewFromWorld));
    program->SetUniformMatrix4x4(At("shadowMapFromView", i).c_str(), matrix.data());
    const bool isCascade = placed.Cascade != vtkShadowMapView::NoCascade;
    const int color = isCascade           ? placed.Cascade
      : placed.Face != vtkshadows::NoFace ? placed.Face
                                          : 0;
    const float size[4] = { static_cast<float>(views.WidthOf(placed.View)),
      static_cast<float>(views.HeightOf(placed.View)), static_cast<float>(placed.Layer),
      static_cast<float>(color) };
    program->SetUniform4f(At("shadowMapSize", i).c_str(), size);
    const double end =
      isCascade ? slot.Cascades.cascades[placed.Cascade].reach * viewPerWorld : HUGE_VAL;
    const bool isInverse = !placed.View.parallel && !linear;
    const float reach[3] = { static_cast<float>(1.0 / (end * end)),
      isInverse ? static_cast<float>(placed.View.clipFromView[2][2]) : 0.0f,
      isInverse ? static_cast<float>(placed.View.clipFromView[3][2]) : 0.0f };
    program->SetUniform3f(At("shadowMapReach", i).c_str(), reach);
  }
  const glm::dvec3 eyeVC(frame.ViewFromWorld * glm::dvec4(slot.Cascades.eyeWC, 1.0));
  const float eye[3] = { static_cast<float>(eyeVC.x), static_cast<float>(eyeVC.y),
    static_cast<float>(eyeVC.z) };
  program->SetUniform3f("shadowEye", eye);
  program->SetUniformf("shadowBlend", static_cast<float>(views.GetFit().Cascades.blend));
}

}

namespace vtkShadowMapDebugView
{

//------------------------------------------------------------------------------
const std::vector<std::string>& Names()
{
  static const std::vector<std::string> names = { "cascades", "texel-density", "map", "lit-part" };
  return names;
}

//------------------------------------------------------------------------------
bool Draw(const std::string& name, const vtkShadowFrame& frame, const vtkShadowMapViews& views,
  int slot, const vtkShadowTextureArray& maps, bool linear)
{
  const auto found = std::find(Names().begin(), Names().end(), name);
  if (found == Names().end() || !frame.Receivers->Draw(frame))
  {
    return false;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  const vtkShadowOverlay::State overlay(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  vtkShaderProgram* program = vtkShadowFullScreen::Ready(frame.Window, vtkMapShadowPassViewFS);
  vtkShadowTextureArray& receivers = frame.Receivers->Texture();
  receivers.Activate();
  program->SetUniformi("shadowReceivers", receivers.Unit());
  program->SetUniformi("shadowMaps", maps.Unit());
  program->SetUniformi("shadowView", static_cast<int>(found - Names().begin()));
  const float size[2] = { static_cast<float>(frame.Size[0]), static_cast<float>(frame.Size[1]) };
  program->SetUniform2f("shadowViewSize", size);
  vtkShadowOverlay::PlaceViewport(frame, program);
  SetMaps(program, frame, views, views.GetSlots()[slot], linear);
  vtkShadowFullScreen::Draw();
  receivers.Deactivate();
  return true;
}

}
