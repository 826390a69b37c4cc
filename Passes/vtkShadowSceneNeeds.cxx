#include "vtkShadowSceneNeeds.h"

#include "vtkActor.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"

#include <glm/matrix.hpp>

#include <algorithm>

namespace
{

// Holes that a mapper draws and that triangles do not know: by texture, or by a user's shader.
bool MayHaveHoles(const vtkShadowScene::Piece& piece)
{
  auto* actor = vtkActor::SafeDownCast(piece.Prop);
  if (piece.DrawnSolid || !actor)
  {
    return false;
  }
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  if (shaders->HasFragmentShaderCode() || shaders->HasVertexShaderCode() ||
    shaders->HasGeometryShaderCode() || shaders->GetNumberOfShaderReplacements() > 0)
  {
    return true;
  }
  const auto isCut = [](vtkTexture* texture) { return texture && texture->IsTranslucent() != 0; };
  const auto& textures = actor->GetProperty()->GetAllTextures();
  return isCut(actor->GetTexture()) ||
    std::any_of(
      textures.begin(), textures.end(), [&](const auto& named) { return isCut(named.second); });
}

}

//------------------------------------------------------------------------------
vtkshadows::SceneNeeds vtkShadowSceneNeeds::Of(
  const vtkShadowFrame& frame, bool hasRays, int planes)
{
  const std::vector<vtkShadowScene::Prop>& props = frame.Scene->GetProps();
  vtkshadows::SceneNeeds needs;
  needs.hasRays = hasRays;
  needs.pixels = static_cast<double>(frame.Size[0]) * frame.Size[1];
  needs.receivesFlat = true;
  int receivers = 0;
  this->Surveys.BeginFrame(props);
  for (const vtkShadowScene::Prop& prop : props)
  {
    needs.castsByOpacity = needs.castsByOpacity || (prop.Casts && prop.Dithers);
    needs.hasStandIns = needs.hasStandIns || prop.StandsInFor;
    needs.receivesTranslucent =
      needs.receivesTranslucent || (prop.Receives && prop.Translucent && !prop.Catches);
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      if (prop.Receives)
      {
        needs.receivesFlat = needs.receivesFlat && piece.PlaneWC != glm::dvec4(0.0);
        ++receivers;
      }
      if (!prop.Casts && !prop.CastsRays)
      {
        continue;
      }
      const vtkShadowCasterGeometry::Survey& survey =
        this->Surveys.Of(piece, [&]() { return vtkShadowCasterGeometry::SurveyOf(piece); });
      needs.triangles += survey.Triangles;
      needs.hasHoles = needs.hasHoles || MayHaveHoles(piece);
      if (!survey.NoSurface.empty() || !survey.NoFiniteSurface.empty())
      {
        needs.notHitByRays = survey.NoSurface.empty() ? survey.NoFiniteSurface : survey.NoSurface;
        needs.notTriangles = needs.notHitByRays;
      }
      else if (survey.HasSpheres)
      {
        needs.notTriangles = "sphere impostors";
      }
      else if (glm::determinant(glm::dmat3(piece.WorldFromModel)) == 0.0)
      {
        needs.notTriangles = "props flattened by their matrix";
      }
    }
  }
  needs.receivesFlat = needs.receivesFlat && receivers <= planes;
  return needs;
}

//------------------------------------------------------------------------------
std::vector<bool> vtkShadowSceneNeeds::Reach(
  const vtkShadowFrame& frame, const std::vector<int>& lights)
{
  vtkShadowMapFit fit;
  fit.Cascades.count = 1;
  fit.Eye.viewFromWorld = frame.ViewFromWorld;
  fit.Eye.clipFromView = frame.ClipFromView;
  this->Views.Fit(frame, lights, fit);
  std::vector<bool> reach;
  for (const vtkShadowMapSlot& slot : this->Views.GetSlots())
  {
    reach.push_back(!slot.IsSkipped && !slot.Views.empty());
  }
  return reach;
}
