#include "vtkShadowWideFloors.h"

#include "PlanarProjection.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowWideFloorFS.h"

#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkProp3D.h"
#include "vtkShaderProgram.h"

#include <glm/matrix.hpp>

//------------------------------------------------------------------------------
bool vtkShadowWideFloors::Gather(const vtkShadowFrame& frame)
{
  this->ClipFromView = frame.ClipFromView;
  this->IsParallel = frame.Renderer->GetActiveCamera()->GetParallelProjection() != 0;
  this->PlanesVC.clear();
  std::unordered_set<const vtkAbstractMapper*> mappers;
  const glm::dmat4 worldFromView = glm::inverse(frame.ViewFromWorld);
  const glm::dvec3 eyeWC = glm::dvec3(worldFromView[3]) / worldFromView[3].w;
  for (const vtkShadowScene::Prop& prop : frame.Scene->GetProps())
  {
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      if (piece.WideFloor)
      {
        const glm::dvec4 seen = vtkshadows::PlaneSeenFrom(piece.PlaneWC, eyeWC);
        this->PlanesVC[piece.Prop] =
          glm::dvec4(glm::dmat3(frame.ViewFromWorld) * glm::dvec3(seen), seen.w);
        mappers.insert(piece.Mapper);
      }
    }
  }
  const bool changed = mappers != this->Mappers;
  this->Mappers.swap(mappers);
  this->GatherLeaves(frame.Scene->GetProps());
  return changed;
}

//------------------------------------------------------------------------------
void vtkShadowWideFloors::GatherLeaves(const std::vector<vtkShadowScene::Prop>& props)
{
  this->MappersOfLeaves.clear();
  this->LeavesByKeys.clear();
  if (this->Mappers.empty())
  {
    return;
  }
  for (const vtkShadowScene::Prop& prop : props)
  {
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      this->MappersOfLeaves[piece.Prop] = piece.Mapper;
      const auto known = this->LeavesByKeys.emplace(piece.Prop->GetPropertyKeys(), piece.Prop);
      if (known.first->second != piece.Prop)
      {
        known.first->second = nullptr;
      }
    }
  }
}

//------------------------------------------------------------------------------
const vtkProp* vtkShadowWideFloors::LeafOf(vtkProp* prop) const
{
  if (this->MappersOfLeaves.count(prop) != 0)
  {
    return prop;
  }
  const auto known = this->LeavesByKeys.find(prop->GetPropertyKeys());
  return known != this->LeavesByKeys.end() ? known->second : nullptr;
}

const vtkAbstractMapper* vtkShadowWideFloors::MapperOf(vtkProp* prop) const
{
  const auto known = this->MappersOfLeaves.find(this->LeafOf(prop));
  return known != this->MappersOfLeaves.end() ? known->second : nullptr;
}

//------------------------------------------------------------------------------
const char* vtkShadowWideFloors::Declarations()
{
  return vtkShadowWideFloorFS;
}

//------------------------------------------------------------------------------
void vtkShadowWideFloors::SetParameters(
  vtkShaderProgram* program, vtkProp* prop, vtkOpenGLState* state) const
{
  const auto known = this->PlanesVC.find(this->LeafOf(prop));
  float plane[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  for (int i = 0; known != this->PlanesVC.end() && i < 4; ++i)
  {
    plane[i] = static_cast<float>(known->second[i]);
  }
  program->SetUniform4f("shadowFloorPlane", plane);

  int viewport[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const glm::dmat4& clip = this->ClipFromView;
  float ray[4];
  for (int axis = 0; axis < 2; ++axis)
  {
    // -1 to 1 over the viewport, less what the projection adds.
    const double perPixel = 2.0 / viewport[2 + axis];
    const double added = this->IsParallel ? clip[3][axis] : -clip[2][axis];
    ray[axis] = static_cast<float>(perPixel / clip[axis][axis]);
    ray[2 + axis] =
      static_cast<float>((-1.0 - perPixel * viewport[axis] - added) / clip[axis][axis]);
  }
  program->SetUniform4f("shadowFloorRay", ray);

  const double ofZ = this->IsParallel ? clip[2][2] : -clip[3][2];
  const double offset = this->IsParallel ? clip[3][2] : -clip[2][2];
  const float eye[3] = { this->IsParallel ? 1.0f : 0.0f, static_cast<float>(0.5 + 0.5 * offset),
    static_cast<float>(0.5 * ofZ) };
  program->SetUniform3f("shadowFloorEye", eye);
}
