#include "vtkShadowCatchers.h"

#include "ShadowReach.h"
#include "vtkShadowCasterGeometry.h"
#include "vtkShadowMatrix.h"
#include "vtkShadowPass.h"

#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp3D.h"
#include "vtkShaderProgram.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace
{

using Scene = vtkShadowScene;

// Where a homogeneous point lies of a plane n.x = d: before it, behind it, or on it.
double SideOf(const glm::dvec4& plane, const glm::dvec4& point)
{
  return glm::dot(glm::dvec3(plane), glm::dvec3(point)) - plane.w * point.w;
}

glm::dvec4 EyeOf(const vtkShadowFrame& frame)
{
  const glm::dmat4 worldFromView = glm::inverse(frame.ViewFromWorld);
  const bool isParallel = frame.Renderer->GetActiveCamera()->GetParallelProjection() != 0;
  return isParallel ? glm::dvec4(glm::dvec3(worldFromView[2]), 0.0) : worldFromView[3];
}

bool IsFlat(const Scene::Piece& piece)
{
  return glm::dvec3(piece.PlaneWC) != glm::dvec3(0.0);
}

bool IsReached(const vtkShadowFrame& frame, const std::vector<bool>& casting,
  const Scene::Piece& piece, double eyeSide)
{
  const std::vector<Scene::Light>& lights = frame.Scene->GetLights();
  for (std::size_t i = 0; i < casting.size(); ++i)
  {
    if (casting[i] &&
      (!IsFlat(piece) ||
        SideOf(piece.PlaneWC, vtkshadows::HomogeneousLight(lights[i].Ray)) * eyeSide > 0.0))
    {
      return true;
    }
  }
  return false;
}

// Whether some other receiver may be seen through the piece.
bool MayHide(const vtkShadowFrame& frame, const Scene::Piece& piece, double eyeSide)
{
  if (!IsFlat(piece))
  {
    return true;
  }
  const std::vector<vtkshadows::BoxCorners> others = vtkShadowCornersOf(*frame.Scene,
    [](const Scene::Prop& prop) { return prop.Receives && !prop.Catches && !prop.Translucent; });
  for (const vtkshadows::BoxCorners& corners : others)
  {
    for (const glm::dvec3& corner : corners)
    {
      if (SideOf(piece.PlaneWC, glm::dvec4(corner, 1.0)) * eyeSide < 0.0)
      {
        return true;
      }
    }
  }
  return false;
}

// From world to -1..1 in the piece's bounds, along the axes of its model coordinates.
glm::dmat4 BoxFromWorld(const Scene::Piece& piece)
{
  double bounds[6];
  if (!vtkShadowCasterGeometry::BoundsOf(piece.Mapper, bounds))
  {
    return glm::dmat4(0.0);
  }
  glm::dmat4 boxFromModel(0.0);
  boxFromModel[3][3] = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double half = 0.5 * (bounds[2 * axis + 1] - bounds[2 * axis]);
    if (half > 0.0)
    {
      boxFromModel[axis][axis] = 1.0 / half;
      boxFromModel[3][axis] = -(bounds[2 * axis] + half) / half;
    }
  }
  return boxFromModel * glm::inverse(piece.WorldFromModel);
}

}

//------------------------------------------------------------------------------
bool vtkShadowCatchers::Gather(const vtkShadowFrame& frame, const std::vector<bool>& casting)
{
  std::map<vtkProp*, Catcher> before;
  before.swap(this->Known);
  this->Apart = false;
  this->Drawn = Round::All;
  const glm::dvec4 eyeWC = EyeOf(frame);
  const glm::dmat4 worldFromView = glm::inverse(frame.ViewFromWorld);
  for (const Scene::Prop& prop : frame.Scene->GetProps())
  {
    for (const Scene::Piece& piece : prop.Pieces)
    {
      if (!prop.Catches)
      {
        continue;
      }
      const double eyeSide = SideOf(piece.PlaneWC, eyeWC);
      Catcher catcher;
      catcher.Reached = IsReached(frame, casting, piece, eyeSide);
      const auto matrix = vtkShadowMatrix::ToFloats(BoxFromWorld(piece) * worldFromView);
      std::copy(matrix.begin(), matrix.end(), catcher.BoxFromView);
      this->Apart = this->Apart || (catcher.Reached && MayHide(frame, piece, eyeSide));
      Catcher& top = this->Known[prop.Source];
      catcher.Reached = catcher.Reached || top.Reached;
      top = catcher;
      this->Known[piece.Prop] = catcher;
    }
  }
  return before.size() != this->Known.size() ||
    !std::equal(before.begin(), before.end(), this->Known.begin(),
      [](const auto& a, const auto& b) { return a.first == b.first; });
}

//------------------------------------------------------------------------------
bool vtkShadowCatchers::Has(vtkProp* prop) const
{
  return this->Known.count(prop) != 0;
}

bool vtkShadowCatchers::IsDrawn(const vtkShadowScene::Prop& prop) const
{
  if (!prop.Catches)
  {
    return this->Drawn != Round::Catchers;
  }
  const auto known = this->Known.find(prop.Source);
  return this->Drawn != Round::Others && known != this->Known.end() && known->second.Reached;
}

//------------------------------------------------------------------------------
void vtkShadowCatchers::KeepMasks(vtkShadowTechniquePass* technique, vtkShadowTextureArray& masks)
{
  this->Masks[technique].Swap(masks);
}

const vtkShadowTextureArray* vtkShadowCatchers::MasksOf(vtkShadowTechniquePass* technique) const
{
  const auto masks = this->Masks.find(technique);
  return this->Apart && masks != this->Masks.end() ? &masks->second : nullptr;
}

void vtkShadowCatchers::ActivateMasks()
{
  for (auto& masks : this->Masks)
  {
    if (this->Apart)
    {
      masks.second.Activate();
    }
  }
}

void vtkShadowCatchers::DeactivateMasks()
{
  for (auto& masks : this->Masks)
  {
    masks.second.Deactivate();
  }
}

void vtkShadowCatchers::ReleaseMasks()
{
  this->Masks.clear();
}

//------------------------------------------------------------------------------
void vtkShadowCatchers::SetParameters(vtkShaderProgram* program, vtkProp* prop) const
{
  double color[3], strength = 1.0, fade = 0.0;
  vtkShadowPass::GetCatcherSettings(prop, color, strength, fade);
  program->SetUniform3f("shadowCatcherColor", color);
  program->SetUniformf("shadowCatcherStrength", static_cast<float>(strength));
  program->SetUniformf("shadowCatcherFade", static_cast<float>(fade));
  // A copy that a mapper made of its actor for a block has none, and so no rim.
  const auto known = this->Known.find(prop);
  float matrix[16] = {};
  if (known != this->Known.end())
  {
    std::copy_n(known->second.BoxFromView, 16, matrix);
  }
  program->SetUniformMatrix4x4("shadowCatcherBoxFromView", matrix);
}
