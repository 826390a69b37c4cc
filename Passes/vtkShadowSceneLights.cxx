#include "vtkShadowSceneInternals.h"

#include "vtkShadowMatrix.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{

// A light so near the eye that it shines past an edge on less than this share of a pixel is there.
constexpr double SeenBesideEye = 1.0 / 64.0;

// How far beside a perspective eye a light may be and still be there, for the pixels of its view.
double SameAsEye(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const int* size = renderer->GetRenderWindow() ? renderer->GetSize() : nullptr;
  if (!size || size[0] < 1 || size[1] < 1 || camera->GetParallelProjection() ||
    camera->GetUseOffAxisProjection() || camera->GetUseExplicitProjectionTransformMatrix())
  {
    return 0.0;
  }
  // What is moved by e moves in the picture by at most e (1 + t) / near, with t the tangent of the
  // view's corner.
  const double side = std::tan(0.5 * glm::radians(camera->GetViewAngle()));
  const double perPixel = 2.0 * side / size[camera->GetUseHorizontalViewAngle() ? 0 : 1];
  const double corner = 0.5 * perPixel * std::hypot(size[0], size[1]);
  return SeenBesideEye * perPixel * camera->GetClippingRange()[0] / (1.0 + corner);
}

}

//------------------------------------------------------------------------------
void vtkShadowScene::Internals::GatherLights(vtkRenderer* renderer)
{
  this->Lights.clear();
  vtkCamera* camera = renderer->GetActiveCamera();
  const glm::dmat4 viewFromWorld = vtkShadowMatrix::ViewFromWorld(camera);
  const glm::dvec3 eyeWC(glm::inverse(viewFromWorld)[3]);
  const double sameAsEye =
    std::max(SameAsEye(renderer), std::ldexp(glm::length(eyeWC), -40)); // or is, to rounding

  vtkCollectionSimpleIterator it;
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal(it);
  while (vtkLight* source = lights->GetNextLight(it))
  {
    if (!source->GetSwitch())
    {
      continue;
    }
    Light light;
    light.Source = source;
    double position[3], focus[3];
    source->GetTransformedPosition(position);
    source->GetTransformedFocalPoint(focus);
    const glm::dvec3 positionWC(position[0], position[1], position[2]);
    const glm::dvec3 alongWC = glm::dvec3(focus[0], focus[1], focus[2]) - positionWC;

    const double length = glm::length(alongWC);
    light.Ray.position = positionWC;
    light.Ray.direction = length > 0.0 ? alongWC / length : glm::dvec3(0.0, 0.0, -1.0);
    light.Ray.coneAngle = source->GetConeAngle();
    light.Ray.kind = !source->GetPositional() ? vtkshadows::LightKind::Directional
      : source->GetConeAngle() < 90.0         ? vtkshadows::LightKind::Spot
                                              : vtkshadows::LightKind::Point;
    light.AtEye = source->LightTypeIsHeadlight() ||
      (source->GetPositional() && glm::length(positionWC - eyeWC) <= sameAsEye);
    this->Lights.push_back(light);
  }
}
