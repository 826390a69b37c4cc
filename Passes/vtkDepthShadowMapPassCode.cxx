#include "vtkDepthShadowMapPassInternals.h"

#include "vtkDepthShadowMapPassDisc.h"
#include "vtkDepthShadowMapPassExact.h"
#include "vtkDepthShadowMapPassGather.h"
#include "vtkDepthShadowMapPassHardware.h"
#include "vtkDepthShadowMapPassKernel.h"
#include "vtkDepthShadowMapPassLookup.h"
#include "vtkDepthShadowMapPassMoments.h"
#include "vtkDepthShadowMapPassNone.h"
#include "vtkDepthShadowMapPassReceiver.h"
#include "vtkDepthShadowMapPassSoft.h"
#include "vtkMapShadowPassTexels.h"
#include "vtkShadowText.h"

#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
// Settings as macros, and then the texts that the filter consists of.
std::string vtkDepthShadowMapPass::GetCompareDeclarations() const
{
  return this->Internal->Transmits
    ? vtkShadowTransmittance::Declarations(this->GetOpaqueDeclarations())
    : this->GetOpaqueDeclarations();
}

std::string vtkDepthShadowMapPass::GetOpaqueDeclarations() const
{
  using vtkShadowText::Define;
  using vtkShadowText::Float;
  std::string text = this->GetSharedDeclarations(this->HasDistances());
  if (this->Beyond != LIT_BEYOND)
  {
    text = Define(this->Beyond == REPEAT_BEYOND ? "SHADOW_DEPTH_MAP_REPEATS"
                                                : "SHADOW_DEPTH_MAP_CLAMPS") +
      text;
  }
  text += Define("SHADOW_DEPTH_MAP_TAPS", std::to_string(this->FilterTaps)) +
    Define("SHADOW_DEPTH_MAP_RADIUS", Float(this->FilterRadius));
  switch (this->Filter)
  {
    case NONE:
      return text + vtkDepthShadowMapPassGather + vtkDepthShadowMapPassNone;
    case HARDWARE:
      return text + vtkDepthShadowMapPassHardware;
    case DISC:
      return text + vtkDepthShadowMapPassGather + vtkDepthShadowMapPassKernel +
        vtkDepthShadowMapPassDisc;
    case SOFT:
      return text + vtkDepthShadowMapPassGather + vtkDepthShadowMapPassKernel +
        vtkDepthShadowMapPassSoft;
    case VARIANCE:
      return text + Define("SHADOW_DEPTH_MAP_BLEEDING", Float(this->LightBleedingReduction)) +
        vtkDepthShadowMapPassGather + vtkDepthShadowMapPassMoments;
    case EXPONENTIAL:
      return text + Define("SHADOW_DEPTH_MAP_EXPONENT", Float(this->ExponentialConstant)) +
        vtkDepthShadowMapPassGather + vtkDepthShadowMapPassMoments;
    case EXACT:
      return text + this->Internal->Triangles.Declarations() + vtkDepthShadowMapPassGather +
        vtkDepthShadowMapPassExact;
    default:
      return text + vtkDepthShadowMapPassGather + vtkDepthShadowMapPassLookup;
  }
}

// What every kind of depth map is compared by.
std::string vtkDepthShadowMapPass::GetSharedDeclarations(bool distances) const
{
  using vtkShadowText::Define;
  using vtkShadowText::Float;
  const double step = Internals::StepOf(this->DepthBits);
  // A float's rounding is bounded by the lookup's matrix, but for that of the way from distances
  // back to depths. A driver's formats round to either side, a colour to the nearest.
  const bool isFixed = this->DepthBits == 16 || this->DepthBits == 24;
  const double quantum = !isFixed ? 0.0 : distances ? 2.0 * Internals::StepOf(24) : step;
  std::string text = Define("SHADOW_DEPTH_MAP_LAYERS", std::to_string(this->Internal->Room)) +
    Define("SHADOW_DEPTH_MAP_QUANTUM", Float(quantum));
  if (distances)
  {
    const double reach = !isFixed ? 0.5 * step : this->BiasMode == MANUAL_BIAS ? 0.0 : step;
    text += Define("SHADOW_DEPTH_MAP_STEP", Float(reach));
  }
  if (this->BiasMode == MANUAL_BIAS)
  {
    text += Define("SHADOW_DEPTH_MAP_CONSTANT_BIAS", Float(this->ConstantBias * step)) +
      Define("SHADOW_DEPTH_MAP_SLOPE_BIAS", Float(this->SlopeBias));
  }
  return text + vtkDepthShadowMapPassReceiver;
}

std::string vtkDepthShadowMapPass::GetLookupDeclarations() const
{
  const std::string shared = this->Named(vtkMapShadowPassTexels) +
    this->GetSharedDeclarations(false) + vtkDepthShadowMapPassGather;
  return Superclass::GetLookupDeclarations() + this->Internal->Sampled.Declarations(shared);
}

//------------------------------------------------------------------------------
std::string vtkDepthShadowMapPass::GetLookupFunction(int slot, vtkProp* prop) const
{
  const Internals::Slot& own = this->Internal->Slots[slot];
  return own.IsSampled ? this->Internal->Sampled.Function(own.Index)
                       : Superclass::GetLookupFunction(own.Index, prop);
}

int vtkDepthShadowMapPass::GetLookupIndex(int slot) const
{
  const Internals::Slot& own = this->Internal->Slots[slot];
  return own.IsSampled ? own.Index : Superclass::GetLookupIndex(own.Index);
}

const float* vtkDepthShadowMapPass::GetLookupMatrix(int slot, vtkProp* prop) const
{
  const Internals::Slot& own = this->Internal->Slots[slot];
  return own.IsSampled ? this->Internal->Sampled.Matrix(own.Index)
                       : Superclass::GetLookupMatrix(own.Index, prop);
}

vtkMTimeType vtkDepthShadowMapPass::GetReceiverStamp() const
{
  return std::max(Superclass::GetReceiverStamp(), this->Internal->Stamp.GetMTime());
}

//------------------------------------------------------------------------------
void vtkDepthShadowMapPass::SetLookupParameters(vtkShaderProgram* program, vtkProp* prop)
{
  Superclass::SetLookupParameters(program, prop);
  const Internals& my = *this->Internal;
  const auto set = [program](const char* name, const std::vector<Internals::Vector>& values)
  {
    if (program->IsUniformUsed(name))
    {
      program->SetUniform4fv(
        name, static_cast<int>(values.size()), reinterpret_cast<const float(*)[4]>(values.data()));
    }
  };
  set("shadowDepthMapViews", my.Views);
  set("shadowDepthMapSides", my.Sides);
  my.Sampled.SetParameters(program);
  my.Transmittance.SetParameters(program);
  if (this->Filter == EXACT)
  {
    my.Triangles.SetParameters(program);
  }
}

//------------------------------------------------------------------------------
vtkShadowTextureArray* vtkDepthShadowMapPass::GetTextures()
{
  return &this->Internal->Maps;
}

void vtkDepthShadowMapPass::ActivateTextures()
{
  Internals& my = *this->Internal;
  if (this->Filter == HARDWARE && my.Maps.Id())
  {
    my.Maps.CompareDepths(true);
  }
  this->Superclass::ActivateTextures();
  my.Sampled.Activate();
  my.Transmittance.Activate();
  if (this->Filter == EXACT)
  {
    my.Triangles.Activate();
  }
}

void vtkDepthShadowMapPass::DeactivateTextures()
{
  Internals& my = *this->Internal;
  this->Superclass::DeactivateTextures();
  my.Sampled.Deactivate();
  my.Transmittance.Deactivate();
  my.Triangles.Deactivate();
  if (this->Filter == HARDWARE && my.Maps.Id())
  {
    my.Maps.CompareDepths(false);
  }
}
