#include "vtkObjectIDShadowPass.h"

#include "ShadowReach.h"
#include "vtkObjectIDShadowPassCasterFS.h"
#include "vtkObjectIDShadowPassLookup.h"
#include "vtkObjectIDShadowPassRanges.h"
#include "vtkObjectIDShadowPassVS.h"
#include "vtkShadowChecks.h"
#include "vtkShadowDrawScope.h"
#include "vtkShadowHiddenFaces.h"
#include "vtkShadowMapViews.h"
#include "vtkShadowObjects.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowTextureBuffer.h"
#include "vtkShadowedShadingPass.h"

#include "vtkObjectFactory.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <iterator>

vtkStandardNewMacro(vtkObjectIDShadowPass);

namespace
{

// By ObjectType.
const char* const ObjectTypeNames[] = { "prop", "block", "instance", "piece" };

// Of 16 bits.
constexpr int MostIDsEver = 65535;
constexpr int MostIDsOf24Bits = 255; // beside a depth of them

constexpr int MostTaps = 4;

}

//------------------------------------------------------------------------------
class vtkObjectIDShadowPass::Internals
{
public:
  vtkShadowTextureArray Maps;
  vtkShadowTextureArray Depth; // of the map that is drawn
  vtkShadowHiddenFaces HiddenFaces;
  vtkShadowObjects Objects;
  std::vector<float> Ranges; // of each map, by ID: as vtkShadowObjects::RangesIn has them
  vtkShadowTextureBuffer RangeTexture;
  vtkOpenGLRenderWindow* Window = nullptr;      // of the frame
  vtkShadowTextureBuffer* OfVertices = nullptr; // that is bound
  int DrawnLayer = 0;

  void SetRanges(int layer, const std::vector<glm::vec4>& ranges);
  void BindVertices(vtkShadowTextureBuffer* table);
  void Unbind();
};

//------------------------------------------------------------------------------
void vtkObjectIDShadowPass::Internals::SetRanges(int layer, const std::vector<glm::vec4>& ranges)
{
  const std::size_t first = 4 * ranges.size() * static_cast<std::size_t>(layer);
  this->Ranges.resize(std::max(this->Ranges.size(), first + 4 * ranges.size()));
  for (std::size_t i = 0; i < ranges.size(); ++i)
  {
    std::copy_n(&ranges[i].x, 4, this->Ranges.begin() + static_cast<std::ptrdiff_t>(first + 4 * i));
  }
  this->RangeTexture.Upload(this->Window, 4, this->Ranges);
}

//------------------------------------------------------------------------------
// A mesh without a table reads none, but its sampler must name a texture of the kind.
void vtkObjectIDShadowPass::Internals::BindVertices(vtkShadowTextureBuffer* table)
{
  if (table == this->OfVertices)
  {
    return;
  }
  if (this->OfVertices)
  {
    this->OfVertices->Deactivate();
  }
  this->OfVertices = table;
  if (table)
  {
    table->Activate();
  }
}

void vtkObjectIDShadowPass::Internals::Unbind()
{
  this->BindVertices(nullptr);
  this->RangeTexture.Deactivate();
}

//------------------------------------------------------------------------------
vtkObjectIDShadowPass::vtkObjectIDShadowPass()
  : Internal(new Internals)
{
}

vtkObjectIDShadowPass::~vtkObjectIDShadowPass() = default;

//------------------------------------------------------------------------------
int vtkObjectIDShadowPass::GetNumberOfObjectTypes()
{
  return static_cast<int>(std::size(ObjectTypeNames));
}

std::string vtkObjectIDShadowPass::GetObjectTypeName(int type)
{
  return type >= 0 && type < GetNumberOfObjectTypes() ? ObjectTypeNames[type] : std::string();
}

//------------------------------------------------------------------------------
void vtkObjectIDShadowPass::SetObjectType(int type)
{
  if (!vtkShadowRefusesChoice(this, "ObjectType", "vtkObjectIDShadowPass::ObjectType", type,
        GetNumberOfObjectTypes(), this->ObjectType) &&
    type != this->ObjectType)
  {
    this->ObjectType = type;
    this->ForgetMaps();
    this->Modified();
  }
}

void vtkObjectIDShadowPass::SetObjectType(const std::string& name)
{
  this->SetObjectType(vtkShadowChoiceOf(this, "ObjectType", ObjectTypeNames, name, this->ObjectType)
                        .value_or(this->ObjectType));
}

//------------------------------------------------------------------------------
void vtkObjectIDShadowPass::SetCombineDepth(bool combine)
{
  if (combine != this->CombineDepth)
  {
    this->CombineDepth = combine;
    this->ForgetMaps();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkObjectIDShadowPass::SetDepthBits(int bits)
{
  if (!vtkShadowRefusesDepthBits(this, bits, this->DepthBits) && bits != this->DepthBits)
  {
    this->DepthBits = bits;
    this->ForgetMaps();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkObjectIDShadowPass::SetTaps(int taps)
{
  if (taps < 1 || taps > MostTaps)
  {
    vtkErrorMacro("Taps " << taps << " is no number of texels on a side: give 1 to " << MostTaps
                          << ". It stays " << this->Taps << ".");
    return;
  }
  if (taps != this->Taps)
  {
    this->Taps = taps;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkObjectIDShadowPass::GetNumberOfObjects() const
{
  return this->Internal->Objects.GetNumberOfObjects();
}

//------------------------------------------------------------------------------
// N x N texels reach N / 2 from the receiver; one more, since it lies somewhere in one.
double vtkObjectIDShadowPass::GetMarginTexels() const
{
  return 1.0 + std::max(0.5 * this->Taps, 1.0);
}

// The table of ranges has a row of all IDs, NoID included, for each map: six a light.
int vtkObjectIDShadowPass::MostIDs(std::size_t lights) const
{
  const std::size_t maps = std::max<std::size_t>(6 * lights, 1);
  const std::size_t row = vtkShadowTextureBuffer::LargestSize() / maps;
  const int most = this->StoredBits() == 24 ? MostIDsOf24Bits : MostIDsEver;
  return static_cast<int>(std::clamp<std::size_t>(row, 2, most + 1)) - 1;
}

//------------------------------------------------------------------------------
bool vtkObjectIDShadowPass::UpdateVisibility(
  const vtkShadowFrame& frame, const std::vector<int>& lights)
{
  Internals& my = *this->Internal;
  my.Window = frame.Window;
  const int most = this->MostIDs(lights.size());
  if (my.Objects.Update(*frame.Scene, static_cast<vtkShadowObjects::Kind>(this->ObjectType), most))
  {
    my.Ranges.clear(); // their rows have another length; all maps are stale
    this->ForgetMaps();
  }
  const int objects = my.Objects.GetNumberOfObjects();
  this->WarnOnce(&my.Objects,
    objects > most ? std::to_string(objects) + " objects share " + std::to_string(most) +
        " IDs: those that share one are as one object. Set fewer DepthBits than " +
        std::to_string(this->DepthBits) + ", or an ObjectType of fewer objects than \"" +
        GetObjectTypeName(this->ObjectType) + "\"."
                   : std::string());
  return this->Superclass::UpdateVisibility(frame, lights);
}

//------------------------------------------------------------------------------
bool vtkObjectIDShadowPass::ReserveMaps(
  const vtkShadowFrame& frame, int width, int height, int layers)
{
  Internals& my = *this->Internal;
  const bool isNew = my.Maps.Reserve(frame.Window,
    this->StoredBits() == 32 ? vtkShadowTextureArray::Format::RG32F
                             : vtkShadowTextureArray::Format::R32UI,
    width, height, layers);
  my.Depth.Reserve(frame.Window, vtkShadowTextureArray::Format::Depth32F, width, height, 1);
  if (!my.Depth.Id())
  {
    my.Maps.Release();
  }
  return isNew;
}

//------------------------------------------------------------------------------
void vtkObjectIDShadowPass::BeginMaps(const vtkShadowFrame& frame)
{
  Internals& my = *this->Internal;
  my.HiddenFaces.BeginFrame(frame.Scene->GetProps());
  if (my.Ranges.empty() || !my.RangeTexture.IsOf(my.Window))
  {
    my.Ranges.clear();
    my.SetRanges(0, { { 1.0f, 0.0f, 1.0f, 0.0f } }); // of NoID, so that there is a texture
  }
}

//------------------------------------------------------------------------------
void vtkObjectIDShadowPass::DrawMap(const vtkShadowFrame& frame, const vtkShadowMapSlot& slot,
  const vtkShadowMapView& view, int width, int height)
{
  Internals& my = *this->Internal;
  my.SetRanges(view.Layer, my.Objects.RangesIn(view.View, width));
  my.DrawnLayer = view.Layer;
  vtkShadowDrawScope target(frame.Window, my.Depth, 0, &my.Maps, view.Layer);
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  target.Clear(nothing);
  target.Confine(width, height, 1);
  my.RangeTexture.Activate();
  frame.Shading->DrawCasters(frame, view.Casters, view.View,
    my.HiddenFaces.CulledOf(
      frame.Scene->GetProps(), view.Casters, vtkshadows::HomogeneousLight(slot.Light)),
    true, this);
  my.Unbind();
}

//------------------------------------------------------------------------------
std::string vtkObjectIDShadowPass::Defines() const
{
  const int bits = this->StoredBits();
  const auto define = [](const char* name, int value)
  { return "#define SHADOW_OBJECT_" + std::string(name) + " " + std::to_string(value) + "\n"; };
  return define("BITS", bits) + define("STEPS", bits < 32 ? (1 << bits) - 1 : 0) +
    define("TAPS", this->Taps) + define("TYPE", this->ObjectType);
}

std::string vtkObjectIDShadowPass::GetCompareDeclarations() const
{
  return this->Defines() + vtkObjectIDShadowPassRanges + vtkObjectIDShadowPassLookup;
}

//------------------------------------------------------------------------------
vtkShadowVertexCode vtkObjectIDShadowPass::GetObjectCode(bool byVertex) const
{
  if (!byVertex || this->ObjectType == PROP)
  {
    return { "", "", "uniform int shadowObjectWhole;\n#define SHADOW_OBJECT shadowObjectWhole\n" };
  }
  return { vtkObjectIDShadowPassVS, "  shadowObjectVSOutput = shadowObjectID();\n",
    "flat in int shadowObjectVSOutput;\n#define SHADOW_OBJECT shadowObjectVSOutput\n" };
}

vtkShadowTechniquePass::CasterCode vtkObjectIDShadowPass::GetCasterCode() const
{
  return { this->StoredBits() == 32 ? "vec4" : "uvec4",
    this->Defines() + vtkObjectIDShadowPassRanges + vtkObjectIDShadowPassCasterFS,
    "shadowObjectTexel(depth)" };
}

//------------------------------------------------------------------------------
void vtkObjectIDShadowPass::SetObjectParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop)
{
  Internals& my = *this->Internal;
  const vtkShadowObjects::Draw draw = my.Objects.DrawOf(my.Window, mapper, prop);
  my.BindVertices(draw.OfVertices);
  const int ranges = my.RangeTexture.Unit();
  program->SetUniformi("shadowObjectRanges", ranges);
  program->SetUniformi("shadowObjectRow", my.Objects.GetNumberOfIDs());
  program->SetUniformi("shadowObjectLayer", my.DrawnLayer);
  program->SetUniformi("shadowObjectWhole", draw.Whole);
  program->SetUniformi("shadowObjectFirst", draw.First);
  program->SetUniformi("shadowObjectPerInstance", draw.PerInstance);
  program->SetUniformi("shadowObjectMost", my.Objects.GetMostIDs());
  program->SetUniformi("shadowObjectByVertex", draw.OfVertices ? 1 : 0);
  program->SetUniformi(
    "shadowObjectsOfVertices", draw.OfVertices ? draw.OfVertices->Unit() : ranges);
}

//------------------------------------------------------------------------------
vtkShadowTextureArray* vtkObjectIDShadowPass::GetTextures()
{
  return &this->Internal->Maps;
}

//------------------------------------------------------------------------------
void vtkObjectIDShadowPass::ActivateTextures()
{
  this->Superclass::ActivateTextures();
  this->Internal->RangeTexture.Activate();
}

void vtkObjectIDShadowPass::DeactivateTextures()
{
  this->Internal->Unbind();
  this->Superclass::DeactivateTextures();
}

//------------------------------------------------------------------------------
vtkIdType vtkObjectIDShadowPass::GetTextureMemory() const
{
  const Internals& my = *this->Internal;
  return static_cast<vtkIdType>(my.Maps.Bytes() + my.Depth.Bytes() + my.RangeTexture.Bytes());
}

vtkIdType vtkObjectIDShadowPass::GetCasterMemory() const
{
  return static_cast<vtkIdType>(this->Internal->Objects.Bytes());
}

//------------------------------------------------------------------------------
void vtkObjectIDShadowPass::ReleaseGraphicsResources(vtkWindow* w)
{
  Internals& my = *this->Internal;
  my.Maps.Release();
  my.Depth.Release();
  my.RangeTexture.Release();
  my.Ranges.clear();
  my.Objects.Release();
  this->Superclass::ReleaseGraphicsResources(w);
}

//------------------------------------------------------------------------------
void vtkObjectIDShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ObjectType: " << GetObjectTypeName(this->ObjectType) << "\n";
  os << indent << "CombineDepth: " << (this->CombineDepth ? "On" : "Off") << "\n";
  os << indent << "SelfShadows: " << (this->GetSelfShadows() ? "yes" : "no") << "\n";
  os << indent << "DepthBits: " << this->DepthBits << "\n";
  os << indent << "Taps: " << this->Taps << "\n";
  os << indent << "NumberOfObjects: " << this->GetNumberOfObjects() << "\n";
}
