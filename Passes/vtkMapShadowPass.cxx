#include "vtkMapShadowPass.h"

#include "vtkMapShadowPassLookup.h"
#include "vtkMapShadowPassTexels.h"
#include "vtkShadowChecks.h"
#include "vtkShadowMapDebugView.h"
#include "vtkShadowMapViews.h"
#include "vtkShadowMatrix.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowText.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowTextureBuffer.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <iterator>

namespace
{

// A layer is a few columns wider than its map where the driver lets it: rows of a power of two
// would fall on the same few lines of a processor's cache.
constexpr int PaddingTexels = 16;

int LayerWidth(int resolution)
{
  return std::min(resolution + PaddingTexels, vtkShadowTextureArray::LargestSide());
}

// Of the 15 vectors that every OpenGL takes from vertices; positions and VTK need the others.
constexpr std::size_t MostFlatReaches = 2;

// By CascadeSchemeType.
const char* const SchemeNames[] = { "practical", "logarithmic", "uniform" };
const int NumberOfSchemes = static_cast<int>(std::size(SchemeNames));

vtkshadows::CascadeEye EyeOf(const vtkShadowFrame& frame, vtkCamera* camera)
{
  vtkshadows::CascadeEye eye;
  eye.viewFromWorld = frame.ViewFromWorld;
  eye.clipFromView = frame.ClipFromView;
  if (camera)
  {
    eye.viewFromWorld = vtkShadowMatrix::ViewFromWorld(camera);
    eye.clipFromView = vtkShadowMatrix::ClipFromView(camera, frame.Renderer);
  }
  return eye;
}

}

//------------------------------------------------------------------------------
vtkMapShadowPass::vtkMapShadowPass()
  : Views(new vtkShadowMapViews)
  , Rows(new vtkShadowTextureBuffer)
{
}

vtkMapShadowPass::~vtkMapShadowPass() = default;

//------------------------------------------------------------------------------
void vtkMapShadowPass::SetResolution(int resolution)
{
  if (!vtkShadowRefusesSize(this, "Resolution", "a map", resolution, this->Resolution) &&
    resolution != this->Resolution)
  {
    this->Resolution = resolution;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMapShadowPass::SetNumberOfCascades(int number)
{
  if (!vtkShadowRefusesRange(
        this, "NumberOfCascades", number, 1, vtkshadows::MostCascades, this->NumberOfCascades) &&
    number != this->NumberOfCascades)
  {
    this->NumberOfCascades = number;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMapShadowPass::SetCascadeScheme(int scheme)
{
  if (!vtkShadowRefusesChoice(this, "CascadeScheme", "vtkMapShadowPass::CascadeSchemeType", scheme,
        NumberOfSchemes, this->CascadeScheme) &&
    scheme != this->CascadeScheme)
  {
    this->CascadeScheme = scheme;
    this->Modified();
  }
}

void vtkMapShadowPass::SetCascadeScheme(const std::string& name)
{
  this->SetCascadeScheme(
    vtkShadowChoiceOf(this, "CascadeScheme", SchemeNames, name, this->CascadeScheme)
      .value_or(this->CascadeScheme));
}

std::string vtkMapShadowPass::GetCascadeSchemeName(int scheme)
{
  return scheme >= 0 && scheme < NumberOfSchemes ? SchemeNames[scheme] : std::string();
}

//------------------------------------------------------------------------------
void vtkMapShadowPass::SetCascadeWeight(double weight)
{
  this->SetShare("CascadeWeight", weight, this->CascadeWeight);
}

void vtkMapShadowPass::SetCascadeBlend(double blend)
{
  this->SetShare("CascadeBlend", blend, this->CascadeBlend);
}

void vtkMapShadowPass::SetShare(const char* name, double share, double& setting)
{
  if (!vtkShadowRefusesRange(this, name, share, 0.0, 1.0, setting) && share != setting)
  {
    setting = share;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMapShadowPass::SetFitCamera(vtkCamera* camera)
{
  if (camera != this->FitCamera)
  {
    this->FitCamera = camera;
    this->Modified();
  }
}

vtkCamera* vtkMapShadowPass::GetFitCamera() const
{
  return this->FitCamera;
}

//------------------------------------------------------------------------------
int vtkMapShadowPass::GetNumberOfViews() const
{
  return this->Views->NumberOfViews();
}

int vtkMapShadowPass::GetNumberOfSkippedLights() const
{
  return this->Views->NumberOfSkippedLights();
}

int vtkMapShadowPass::GetNumberOfCastersLeftOut() const
{
  return this->Views->NumberOfCastersLeftOut();
}

//------------------------------------------------------------------------------
bool vtkMapShadowPass::UpdateVisibility(const vtkShadowFrame& frame, const std::vector<int>& lights)
{
  const int side = this->WithinDriver("Resolution", this->Resolution);
  vtkShadowMapViews& views = *this->Views;
  vtkShadowMapFit fit;
  fit.Resolution = side;
  fit.MarginTexels = this->GetMarginTexels();
  fit.Cascades = { this->NumberOfCascades,
    static_cast<vtkshadows::CascadeScheme>(this->CascadeScheme), this->CascadeWeight,
    this->CascadeBlend };
  fit.ConfineToView = this->ConfineToView;
  fit.Eye = EyeOf(frame, this->FitCamera);
  views.Fit(frame, lights, fit, this->GetRoles(frame));
  const int layers = std::max(views.NumberOfLayers(), 1);
  if (this->ReserveMaps(frame, LayerWidth(side), side, layers))
  {
    views.ForgetLayers();
  }
  if (!this->GetTextures()->Id())
  {
    this->WarnOnce(this,
      "The driver has no memory for " + std::to_string(layers) + " shadow maps of " +
        std::to_string(side) + " x " + std::to_string(side) +
        " texels: their lights are lit. Lower the resolution.");
    return false;
  }
  this->WarnOnce(this, "");

  views.Place(layers);
  this->BeginMaps(frame);
  views.DrawStale(
    [&](const vtkShadowMapSlot& slot, const vtkShadowMapView& view)
    {
      this->DrawMap(frame, slot, view, views.WidthOf(view.View), views.HeightOf(view.View));
      ++this->NumberOfMapBuilds;
    });
  if (views.UpdateLookups(this->GetLookupPrefix(), frame.ViewFromWorld, this->GetRiseTexels()))
  {
    this->LookupStamp.Modified();
  }
  this->UploadRows(frame);
  return true;
}

//------------------------------------------------------------------------------
// What pixels of one light look up by an index of their own: the faces of cubes, then cascades.
void vtkMapShadowPass::UploadRows(const vtkShadowFrame& frame)
{
  std::vector<float> rows;
  for (const std::vector<vtkShadowMapViews::Row>* part :
    { &this->Views->Faces(), &this->Views->Cascades() })
  {
    for (const vtkShadowMapViews::Row& row : *part)
    {
      rows.insert(rows.end(), row.begin(), row.end());
    }
  }
  this->Rows->Keep(frame.Window, 4, rows);
}

//------------------------------------------------------------------------------
vtkShadowMapRoles vtkMapShadowPass::GetRoles(const vtkShadowFrame&) const
{
  return {};
}

//------------------------------------------------------------------------------
void vtkMapShadowPass::ForgetMaps()
{
  this->Views->ForgetLayers();
}

void vtkMapShadowPass::ForgetMaps(std::size_t slot)
{
  this->Views->MarkStale(slot);
}

//------------------------------------------------------------------------------
std::string vtkMapShadowPass::Named(const char* text) const
{
  return vtkShadowText::Replaced(
    vtkShadowText::Replaced(text, "shadowMap", this->GetLookupPrefix()), "SHADOW_MAP",
    this->GetMacroPrefix());
}

//------------------------------------------------------------------------------
std::string vtkMapShadowPass::GetLookupDeclarations() const
{
  const int side = this->WithinDriver("Resolution", this->Resolution);
  const std::size_t cubes = this->Views->Faces().size() / 6;
  const std::size_t cascaded = this->Views->NumberOfCascadedLights();
  const std::string define = "#define " + this->GetMacroPrefix();
  return define + "_WIDTH " + std::to_string(LayerWidth(side)) + "\n" + define + "_HEIGHT " +
    std::to_string(side) + "\n" +
    (cubes > 0 ? define + "_CUBES " + std::to_string(cubes) + "\n" : "") +
    (cascaded > 0 ? define + "_CASCADED_LIGHTS " + std::to_string(cascaded) + "\n" + define +
          "_CASCADES " + std::to_string(this->NumberOfCascades) + "\n"
                  : "") +
    (cascaded > 0 && this->CascadeBlend > 0.0
        ? define + "_CASCADE_BLEND " + vtkShadowText::Float(this->CascadeBlend) + "\n"
        : "") +
    this->Named(vtkMapShadowPassTexels) + this->GetCompareDeclarations() +
    this->Named(vtkMapShadowPassLookup);
}

//------------------------------------------------------------------------------
// How far cascades reach is alike for all pixels. Of vertices that costs software OpenGL next to
// nothing, and as uniforms a fetch of each number for each pixel.
vtkShadowVertexCode vtkMapShadowPass::GetLookupCode(bool byVertex) const
{
  const std::size_t reaches = this->Views->Reaches().size();
  if (reaches == 0)
  {
    return {};
  }
  const std::string array = "[" + std::to_string(reaches) + "];\n";
  const std::string uniform = this->Named("uniform vec4 shadowMapCascadeReaches") + array;
  if (!byVertex || reaches > MostFlatReaches)
  {
    return { "", "", uniform + this->Named("#define shadowMapReaches shadowMapCascadeReaches\n") };
  }
  return { uniform + this->Named("flat out vec4 shadowMapReaches") + array,
    this->Named("  shadowMapReaches = shadowMapCascadeReaches;\n"),
    this->Named("flat in vec4 shadowMapReaches") + array };
}

std::string vtkMapShadowPass::GetLookupFunction(int slot, vtkProp*) const
{
  return this->Views->Function(slot);
}

int vtkMapShadowPass::GetLookupIndex(int slot) const
{
  return this->Views->Index(slot);
}

const float* vtkMapShadowPass::GetLookupMatrix(int slot, vtkProp*) const
{
  return this->Views->Matrix(slot);
}

const float* vtkMapShadowPass::GetLitMatrix() const
{
  return vtkShadowMapViews::LitEverywhere.data();
}

void vtkMapShadowPass::SetLookupParameters(vtkShaderProgram* program, vtkProp*)
{
  if (this->Rows->Unit() >= 0)
  {
    program->SetUniformi((this->GetLookupPrefix() + "Rows").c_str(), this->Rows->Unit());
  }
  const std::vector<vtkShadowMapViews::Row>& reaches = this->Views->Reaches();
  if (!reaches.empty())
  {
    program->SetUniform4fv((this->GetLookupPrefix() + "CascadeReaches").c_str(),
      static_cast<int>(reaches.size()), reinterpret_cast<const float(*)[4]>(reaches.data()));
  }
}

//------------------------------------------------------------------------------
void vtkMapShadowPass::ActivateTextures()
{
  this->Superclass::ActivateTextures();
  this->Rows->Activate(); // where there are any
}

void vtkMapShadowPass::DeactivateTextures()
{
  this->Rows->Deactivate();
  this->Superclass::DeactivateTextures();
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkMapShadowPass::GetDebugViews() const
{
  return vtkShadowMapDebugView::Names();
}

bool vtkMapShadowPass::DrawDebugView(const vtkShadowFrame& frame, int slot, const std::string& view)
{
  return vtkShadowMapDebugView::Draw(
    view, frame, *this->Views, slot, *this->GetTextures(), this->HasDistances());
}

//------------------------------------------------------------------------------
void vtkMapShadowPass::ReleaseGraphicsResources(vtkWindow* w)
{
  this->ForgetMaps();
  this->Rows->Release();
  this->Superclass::ReleaseGraphicsResources(w);
}

//------------------------------------------------------------------------------
void vtkMapShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "NumberOfCascades: " << this->NumberOfCascades << "\n";
  os << indent << "CascadeScheme: " << GetCascadeSchemeName(this->CascadeScheme) << "\n";
  os << indent << "CascadeWeight: " << this->CascadeWeight << "\n";
  os << indent << "CascadeBlend: " << this->CascadeBlend << "\n";
  os << indent << "ConfineToView: " << this->ConfineToView << "\n";
  os << indent << "FitCamera: " << this->FitCamera.Get() << "\n";
  os << indent << "NumberOfViews: " << this->GetNumberOfViews() << "\n";
  os << indent << "NumberOfSkippedLights: " << this->GetNumberOfSkippedLights() << "\n";
  os << indent << "NumberOfCastersLeftOut: " << this->GetNumberOfCastersLeftOut() << "\n";
  os << indent << "NumberOfMapBuilds: " << this->NumberOfMapBuilds << "\n";
}
