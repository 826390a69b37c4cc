// What a frame's scene and lights ask of a technique, as the choice wants to know it.
#ifndef vtkShadowSceneNeeds_h
#define vtkShadowSceneNeeds_h

#include "TechniqueChoice.h"
#include "vtkShadowByPiece.h"
#include "vtkShadowCasterGeometry.h"
#include "vtkShadowMapViews.h"
#include "vtkShadowSceneData.h"

class vtkShadowSceneNeeds
{
public:
  // `planes`: that may receive, at most.
  vtkshadows::SceneNeeds Of(const vtkShadowFrame& frame, bool hasRays, int planes);

  // Whether a shadow of a light may fall on a receiver in view, for each of `lights`.
  std::vector<bool> Reach(const vtkShadowFrame& frame, const std::vector<int>& lights);

private:
  vtkShadowByPiece<vtkShadowCasterGeometry::Survey> Surveys;
  vtkShadowMapViews Views; // never drawn
};

#endif
