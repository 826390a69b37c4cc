#include "vtkShadowPass.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>

vtkInformationKeyMacro(vtkShadowPass, CASTS_SHADOWS, Integer);
vtkInformationKeyMacro(vtkShadowPass, RECEIVES_SHADOWS, Integer);
vtkInformationKeyRestrictedMacro(vtkShadowPass, SHADOW_CATCHER, DoubleVector, 5);
vtkInformationKeyRestrictedMacro(vtkShadowPass, CASTER_STAND_IN, ObjectBase, "vtkPolyData");

namespace
{

vtkInformation* KeysOf(vtkProp* prop)
{
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  return prop->GetPropertyKeys();
}

template <typename Key, typename Value>
void SetKey(vtkProp* prop, Key* key, Value value)
{
  if (prop)
  {
    KeysOf(prop)->Set(key, value);
  }
}

// What SHADOW_CATCHER holds, in its order.
enum CatcherSetting
{
  CatcherColor = 0,
  CatcherStrength = 3,
  CatcherFade = 4,
  CatcherSettings = 5
};
const double DefaultCatcher[CatcherSettings] = { 0.0, 0.0, 0.0, 1.0, 0.0 };

// Make `actor` a catcher if it is none, and give it `count` settings from `first` on.
void EditCatcher(vtkActor* actor, const char* what, int first, const double* values, int count)
{
  if (!actor || !std::all_of(values, values + count, [](double v) { return std::isfinite(v); }))
  {
    vtkGenericWarningMacro(<< what << " of actor " << actor << ": give a vtkActor and 0 to 1, not "
                           << values[0] << (count == 3 ? ", ..." : "") << ".");
    return;
  }
  vtkShadowPass::SetShadowCatcher(actor, true);
  vtkInformation* keys = actor->GetPropertyKeys();
  double settings[CatcherSettings];
  std::copy_n(keys->Get(vtkShadowPass::SHADOW_CATCHER()), int(CatcherSettings), settings);
  std::transform(values, values + count, settings + first,
    [](double v) { return std::min(std::max(v, 0.0), 1.0); });
  keys->Set(vtkShadowPass::SHADOW_CATCHER(), settings, CatcherSettings);
  actor->Modified();
}

}

//------------------------------------------------------------------------------
void vtkShadowPass::SetCastsShadows(vtkProp* prop, bool casts)
{
  SetKey(prop, vtkShadowPass::CASTS_SHADOWS(), casts ? 1 : 0);
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetReceivesShadows(vtkProp* prop, bool receives)
{
  SetKey(prop, vtkShadowPass::RECEIVES_SHADOWS(), receives ? 1 : 0);
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetStandIn(vtkProp* prop, vtkPolyData* mesh)
{
  SetKey(prop, vtkShadowPass::CASTER_STAND_IN(), mesh); // nullptr removes the key
}

//------------------------------------------------------------------------------
vtkPolyData* vtkShadowPass::GetStandIn(vtkProp* prop)
{
  vtkInformation* keys = prop ? prop->GetPropertyKeys() : nullptr;
  return keys ? vtkPolyData::SafeDownCast(keys->Get(vtkShadowPass::CASTER_STAND_IN())) : nullptr;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetShadowCatcher(vtkActor* actor, bool catches)
{
  if (!actor)
  {
    vtkGenericWarningMacro("SetShadowCatcher(nullptr, " << catches << "): give a vtkActor.");
  }
  else if (catches && !vtkShadowPass::IsShadowCatcher(actor))
  {
    KeysOf(actor)->Set(vtkShadowPass::SHADOW_CATCHER(), DefaultCatcher, CatcherSettings);
    actor->GetProperty()->SetOpacity(0.0);
    actor->Modified();
  }
  else if (!catches && vtkShadowPass::IsShadowCatcher(actor))
  {
    actor->GetPropertyKeys()->Remove(vtkShadowPass::SHADOW_CATCHER());
    actor->GetProperty()->SetOpacity(1.0);
    actor->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkShadowPass::IsShadowCatcher(vtkProp* prop)
{
  vtkInformation* keys = prop ? prop->GetPropertyKeys() : nullptr;
  return keys && keys->Has(vtkShadowPass::SHADOW_CATCHER());
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetCatcherColor(vtkActor* actor, double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  EditCatcher(actor, "SetCatcherColor", CatcherColor, color, 3);
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetCatcherStrength(vtkActor* actor, double strength)
{
  EditCatcher(actor, "SetCatcherStrength", CatcherStrength, &strength, 1);
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetCatcherFade(vtkActor* actor, double fade)
{
  EditCatcher(actor, "SetCatcherFade", CatcherFade, &fade, 1);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetCatcherSettings(
  vtkProp* prop, double color[3], double& strength, double& fade)
{
  const bool catches = vtkShadowPass::IsShadowCatcher(prop);
  const double* settings =
    catches ? prop->GetPropertyKeys()->Get(vtkShadowPass::SHADOW_CATCHER()) : DefaultCatcher;
  std::copy_n(settings + CatcherColor, 3, color);
  strength = settings[CatcherStrength];
  fade = settings[CatcherFade];
  return catches;
}
