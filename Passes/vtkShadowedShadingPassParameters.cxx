// What vtkShadowedShadingPass tells its shaders with each draw.
#include "vtkShadowedShadingPass.h"

#include "vtkShadowCatchers.h"
#include "vtkShadowLightFalloffs.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowTechniquePass.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowWideFloors.h"
#include "vtkShadowedShadingPassUniforms.h"

#include "vtkActor.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

//------------------------------------------------------------------------------
bool vtkShadowedShadingPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  if (this->DrawsCasters())
  {
    if (this->CurrentStage == TEXELS)
    {
      this->Writer->SetObjectParameters(program, mapper, prop);
    }
    // Every face casts that is not told to lie behind another, and a translucent caster writes its
    // depth, too. The lights need not be set, and must not be: this camera is not the eye.
    const auto culled = this->Culled.find(prop);
    if (culled != this->Culled.end())
    {
      this->State->vtkglEnable(GL_CULL_FACE);
      this->State->vtkglCullFace(culled->second);
    }
    else
    {
      this->State->vtkglDisable(GL_CULL_FACE);
    }
    this->State->vtkglDepthMask(this->CastersWriteDepth ? GL_TRUE : GL_FALSE);
    if (this->CurrentStage == TRANSMITTANCE)
    {
      this->State->vtkglEnable(GL_BLEND);
      this->State->vtkglBlendFunc(GL_ZERO, GL_SRC_COLOR);
    }
    program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, VTK_MTIME_MAX);
    return true;
  }
  const bool isCatcher = this->IsCatcher(prop);
  this->ClampDepth(isCatcher);
  if (isCatcher && this->CurrentStage != SHADE)
  {
    this->State->vtkglDepthMask(GL_TRUE);
  }
  if (this->WideFloors->Has(mapper, prop))
  {
    this->WideFloors->SetParameters(program, prop, this->State);
  }
  if (this->CurrentStage == DEPTHS || this->CurrentStage == COVERAGE)
  {
    program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, VTK_MTIME_MAX);
    return true;
  }

  const bool receives = this->IsReceiver(prop);
  if (this->CurrentStage == POSITIONS)
  {
    program->SetUniformf("shadowIsReceiver", receives ? 1.0f : 0.0f);
    program->SetUniformi("shadowParallelEye", this->ParallelEye);
    return true;
  }

  for (const std::size_t i : this->Lookups)
  {
    const LightPlan& light = this->Plan[i];
    const bool isTold = receives && light.Technique->HasVisibilityOf(prop);
    float matrix[16];
    std::copy_n(
      isTold ? light.Technique->GetLookupMatrix(light.Slot, prop) : light.Technique->GetLitMatrix(),
      16, matrix);
    program->SetUniformMatrix4x4(vtkShadowUniforms::Matrix(i).c_str(), matrix);
  }
  for (std::size_t i = 0; i < this->Plan.size(); ++i)
  {
    if (this->Plan[i].Technique && this->Plan[i].Strength < 1.0f)
    {
      program->SetUniformf(vtkShadowUniforms::Strength(i).c_str(), this->Plan[i].Strength);
    }
    if (this->Plan[i].Technique && this->Plan[i].MaximumDistance > 0.0f)
    {
      // A fade of nothing is a step, over a rounding.
      const float most = this->Plan[i].MaximumDistance;
      const float distance[2] = { most, 1.0f / (std::max(this->Plan[i].Fade, 1e-6f) * most) };
      program->SetUniform2f(vtkShadowUniforms::Distance(i).c_str(), distance);
    }
  }
  for (vtkShadowTechniquePass* technique : this->Techniques)
  {
    const vtkShadowTextureArray* own = isCatcher ? this->Catchers->MasksOf(technique) : nullptr;
    program->SetUniformi(
      technique->GetSamplerName().c_str(), (own ? own : technique->GetTextures())->Unit());
    technique->SetLookupParameters(program, prop);
    technique->SetObjectParameters(program, mapper, prop);
  }
  this->Falloffs->SetParameters(program);
  if (isCatcher)
  {
    this->Catchers->SetParameters(program, prop);
  }
  if (this->HasMasks)
  {
    this->SetMaskParameters(program, prop, receives);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::SetMaskParameters(
  vtkShaderProgram* program, vtkProp* prop, bool receives)
{
  // A mask knows the opaque receivers and the catchers only.
  auto* actor = vtkActor::SafeDownCast(prop);
  const bool isTranslucent = actor && actor->IsRenderingTranslucentPolygonalGeometry();
  const bool hasMask = !isTranslucent || this->IsCatcher(prop);
  for (vtkShadowTechniquePass* technique : this->Techniques)
  {
    if (technique->GetVisibilityForm() == vtkShadowTechniquePass::MASK)
    {
      const bool isTold = receives && hasMask && technique->HasVisibilityOf(prop);
      program->SetUniformf(
        vtkShadowUniforms::Receives(technique->GetSamplerName()).c_str(), isTold ? 1.0f : 0.0f);
    }
  }
  if (this->MaskIsPixels)
  {
    return;
  }
  // It covers the viewport, wherever that lies and whatever its size in the framebuffer drawn to.
  int viewport[4];
  this->State->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const float origin[2] = { static_cast<float>(viewport[0]), static_cast<float>(viewport[1]) };
  const float scale[2] = { this->MaskSize[0] / viewport[2], this->MaskSize[1] / viewport[3] };
  program->SetUniform2f("shadowMaskOrigin", origin);
  program->SetUniform2f("shadowMaskScale", scale);
}
