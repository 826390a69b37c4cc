#include "vtkShadowedShadingPass.h"

#include "vtkShadowCasterCamera.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowTechniquePass.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowedShadingPassFS.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <sstream>

vtkStandardNewMacro(vtkShadowedShadingPass);

namespace
{

// Places in the fragment shader that this pass marks before VTK fills its own tags, and fills after.
const char* const DeclarationMark = "//SHADOW::Dec\n";
const char* const LightMark = "//SHADOW::Light\n";
const char* const OutputMark = "//SHADOW::Output\n";

bool Mark(std::string& source, const char* mark, const std::string& tag)
{
  return vtkShaderProgram::Substitute(source, tag, mark + tag, false);
}

std::string ColorUniform(std::size_t light)
{
  return "lightColor" + std::to_string(light);
}

std::string StrengthUniform(std::size_t light)
{
  return "shadowStrength" + std::to_string(light);
}

std::string Visibility(std::size_t light)
{
  return "shadowVisibility" + std::to_string(light);
}

bool Declares(const std::string& source, const std::string& uniform)
{
  return source.find("uniform vec3 " + uniform + ";") != std::string::npos;
}

// A shader of the user's own without VTK's tags: keep its colours out of the buffers of other stages.
void GuardForeignShader(std::string& source)
{
  const std::size_t entry = source.find("void main");
  const std::size_t end = source.rfind('}');
  if (entry == std::string::npos || end == std::string::npos || end < entry)
  {
    return;
  }
  source.insert(
    end, "  if (shadowStage >= 2) { gl_FragData[0] = vec4(shadowStage == 3 ? 1.0 : 0.0); }\n");
  source.insert(entry, "uniform int shadowStage;\n");
}

}

//------------------------------------------------------------------------------
vtkShadowedShadingPass::vtkShadowedShadingPass()
  : Placeholder(new vtkShadowTextureArray)
{
}

vtkShadowedShadingPass::~vtkShadowedShadingPass() = default;

//------------------------------------------------------------------------------
std::vector<vtkShadowTechniquePass*> vtkShadowedShadingPass::TechniquesInPlan() const
{
  std::vector<vtkShadowTechniquePass*> techniques;
  for (const LightPlan& light : this->Plan)
  {
    if (light.Technique &&
      std::find(techniques.begin(), techniques.end(), light.Technique) == techniques.end())
    {
      techniques.push_back(light.Technique);
    }
  }
  return techniques;
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::SetPlan(const std::vector<LightPlan>& plan)
{
  this->Plan = plan;
  std::ostringstream shape;
  for (const LightPlan& light : plan)
  {
    shape << (light.Technique ? light.Technique->GetTechniqueName() : "-") << light.Slot << ' ';
  }
  for (vtkShadowTechniquePass* technique : this->TechniquesInPlan())
  {
    shape << technique->GetLookupDeclarations();
  }
  if (shape.str() != this->PlanShape)
  {
    this->PlanShape = shape.str();
    this->ShaderStage.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::Attach(const vtkShadowFrame& frame)
{
  this->State = frame.Window->GetState();
  this->Placeholder->Reserve(frame.Window, vtkShadowTextureArray::Format::R8, 1, 1, 1);
  this->Placeholder->Activate();
  this->MaskSize[0] = static_cast<float>(frame.Size[0]);
  this->MaskSize[1] = static_cast<float>(frame.Size[1]);
  this->ParallelEye = frame.Renderer->GetActiveCamera()->GetParallelProjection() ? 1 : 0;
  for (const vtkShadowScene::Prop& prop : frame.Scene->GetProps())
  {
    this->AttachTo(prop.Source, prop.Receives);
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      this->AttachTo(piece.Prop, prop.Receives);
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::AttachTo(vtkProp* prop, bool receives)
{
  this->Receives[prop] = receives;
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  // Parts of an assembly share its keys.
  vtkInformation* keys = prop->GetPropertyKeys();
  if (std::find(this->Attached.begin(), this->Attached.end(), keys) == this->Attached.end())
  {
    keys->Append(vtkOpenGLRenderPass::RenderPasses(), this);
    this->Attached.emplace_back(keys);
  }
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::ActivateTextures()
{
  for (vtkShadowTechniquePass* technique : this->TechniquesInPlan())
  {
    technique->GetTextures()->Activate();
  }
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::Detach()
{
  this->Placeholder->Deactivate();
  for (vtkShadowTechniquePass* technique : this->TechniquesInPlan())
  {
    technique->GetTextures()->Deactivate();
  }
  for (const vtkSmartPointer<vtkInformation>& keys : this->Attached)
  {
    keys->Remove(vtkOpenGLRenderPass::RenderPasses(), this);
    if (keys->Length(vtkOpenGLRenderPass::RenderPasses()) == 0)
    {
      keys->Remove(vtkOpenGLRenderPass::RenderPasses());
    }
  }
  this->Attached.clear();
  this->Receives.clear();
  this->State = nullptr;
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::DrawCasters(const vtkShadowFrame& frame,
  const std::vector<std::size_t>& props, const vtkshadows::LightView& view)
{
  vtkRenderer* renderer = frame.Renderer;
  const vtkSmartPointer<vtkCamera> eye = renderer->GetActiveCamera();
  this->CasterCamera->SetView(view);
  renderer->SetActiveCamera(this->CasterCamera);
  this->CurrentStage = CASTERS;
  // What lies before the near plane still casts.
  glEnable(GL_DEPTH_CLAMP);

  for (const std::size_t i : props)
  {
    const vtkShadowScene::Prop& prop = frame.Scene->GetProps()[i];
    // Only impostors look at this flag while drawing depth; for the others a change of it would mean
    // another shader.
    this->CasterCamera->SetParallelProjection(
      prop.Impostors ? view.parallel : eye->GetParallelProjection() != 0);
    if (prop.Translucent)
    {
      prop.Source->RenderTranslucentPolygonalGeometry(renderer);
    }
    else
    {
      prop.Source->RenderOpaqueGeometry(renderer);
    }
  }

  glDisable(GL_DEPTH_CLAMP);
  this->CurrentStage = SHADE;
  renderer->SetActiveCamera(eye);
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::DrawReceivers(const vtkShadowFrame& frame, Stage stage)
{
  this->CurrentStage = stage;
  for (const vtkShadowScene::Prop& prop : frame.Scene->GetProps())
  {
    prop.Source->RenderOpaqueGeometry(frame.Renderer);
  }
  this->CurrentStage = SHADE;
}

//------------------------------------------------------------------------------
std::string vtkShadowedShadingPass::Declarations() const
{
  std::ostringstream code;
  code << vtkShadowedShadingPassFS << "uniform int shadowParallelEye;\n";
  for (vtkShadowTechniquePass* technique : this->TechniquesInPlan())
  {
    if (technique->GetVisibilityForm() == vtkShadowTechniquePass::MASK)
    {
      code << "uniform sampler2DArray " << technique->GetSamplerName() << ";\n";
    }
    code << technique->GetLookupDeclarations();
  }
  for (std::size_t i = 0; i < this->Plan.size(); ++i)
  {
    if (this->Plan[i].Technique)
    {
      code << "uniform float " << StrengthUniform(i) << ";\n";
    }
  }
  return code.str();
}

//------------------------------------------------------------------------------
std::string vtkShadowedShadingPass::LightCode(const std::string& fragmentShader) const
{
  std::ostringstream code;
  for (std::size_t i = 0; i < this->Plan.size(); ++i)
  {
    const LightPlan& light = this->Plan[i];
    if (!light.Technique || !Declares(fragmentShader, ColorUniform(i)))
    {
      continue;
    }
    const bool isMask = light.Technique->GetVisibilityForm() == vtkShadowTechniquePass::MASK;
    code << "  float " << Visibility(i) << " = mix(1.0, ";
    if (isMask)
    {
      code << "shadowMaskVisibility(" << light.Technique->GetSamplerName() << ", " << light.Slot
           << "), shadowReceivesMask);\n";
    }
    else
    {
      code << light.Technique->GetLookupFunction() << "(" << light.Slot
           << ", vertexVC), shadowReceivesLookup);\n";
    }
    code << "  vec3 " << ColorUniform(i) << " = " << ColorUniform(i) << " * (1.0 - "
         << StrengthUniform(i) << " * (1.0 - " << Visibility(i) << "));\n";
  }
  return code.str();
}

//------------------------------------------------------------------------------
std::string vtkShadowedShadingPass::OutputCode(const std::string& fragmentShader) const
{
  std::ostringstream code;
  code << "  if (shadowStage == " << POSITIONS << ")\n  {\n"
       << "    gl_FragData[0] = vec4(vertexVC.xyz, shadowReceivesLookup * "
          "shadowNormalCode(shadowFaceNormal(vertexVC.xyz, shadowParallelEye)));\n  }\n"
       << "  if (shadowStage == " << VISIBILITY << ")\n  {\n"
       << "    gl_FragData[0] = vec4(1.0);\n";
  for (std::size_t i = 0; i < this->Plan.size(); ++i)
  {
    if (this->Plan[i].Technique && Declares(fragmentShader, ColorUniform(i)))
    {
      code << "    if (shadowShownLight == " << i << ") { gl_FragData[0].r = " << Visibility(i)
           << "; }\n";
    }
  }
  code << "  }\n";
  return code.str();
}

//------------------------------------------------------------------------------
bool vtkShadowedShadingPass::PreReplaceShaderValues(std::string&, std::string&,
  std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::System::Dec",
    "//VTK::System::Dec\n#extension GL_ARB_texture_gather : enable\n", false);
  const bool found = Mark(fragmentShader, DeclarationMark, "//VTK::Light::Dec") &&
    Mark(fragmentShader, LightMark, "//VTK::Light::Impl") &&
    Mark(fragmentShader, OutputMark, "//VTK::DepthPeeling::Impl");
  if (!found)
  {
    if (!this->Complained)
    {
      vtkErrorMacro("The fragment shader of "
        << prop->GetClassName() << " (" << prop
        << ") lacks the tags //VTK::Light::Dec, //VTK::Light::Impl and //VTK::DepthPeeling::Impl: it is "
           "drawn lit. Keep these tags in a fragment shader of your own to have it shadowed.");
      this->Complained = true;
    }
    for (const char* mark : { DeclarationMark, LightMark, OutputMark })
    {
      vtkShaderProgram::Substitute(fragmentShader, mark, "");
    }
    GuardForeignShader(fragmentShader);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowedShadingPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  // VTK declares a position and colours of lights only where a primitive is lit.
  const bool isLit = Declares(fragmentShader, ColorUniform(0)) &&
    fragmentShader.find("vec4 vertexVC = ") != std::string::npos;
  if (isLit)
  {
    vtkShaderProgram::Substitute(fragmentShader, LightMark, this->LightCode(fragmentShader));
    vtkShaderProgram::Substitute(fragmentShader, OutputMark, this->OutputCode(fragmentShader));
    vtkShaderProgram::Substitute(fragmentShader, DeclarationMark, this->Declarations());
  }
  else
  {
    vtkShaderProgram::Substitute(fragmentShader, LightMark, "");
    vtkShaderProgram::Substitute(fragmentShader, OutputMark,
      "  if (shadowStage >= 2) { gl_FragData[0] = vec4(shadowStage == 3 ? 1.0 : 0.0); }\n");
    vtkShaderProgram::Substitute(fragmentShader, DeclarationMark, "uniform int shadowStage;\n");
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowedShadingPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  program->SetUniformi("shadowStage", this->CurrentStage);

  // VTK sets a program's lights only when they are newer than what it set last. In other stages than the
  // frame's own they must not be set (a caster's camera is not the eye), and then they must again.
  const bool isFrame = this->CurrentStage == SHADE;
  if (!isFrame)
  {
    program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, VTK_MTIME_MAX);
  }
  else if (program->GetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup) == VTK_MTIME_MAX)
  {
    program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
  }
  // What is being drawn into must not be sampled: before the frame itself, samplers read a placeholder.
  const bool readsVisibility = isFrame || this->CurrentStage == VISIBILITY;
  for (vtkShadowTechniquePass* technique : this->TechniquesInPlan())
  {
    vtkShadowTextureArray* textures = readsVisibility ? technique->GetTextures() : nullptr;
    program->SetUniformi(technique->GetSamplerName().c_str(),
      textures && textures->Unit() >= 0 ? textures->Unit() : this->Placeholder->Unit());
    if (readsVisibility)
    {
      technique->SetLookupUniforms(program);
    }
  }

  if (this->CurrentStage == CASTERS)
  {
    // Every face casts, and a translucent caster writes its depth, too.
    this->State->vtkglDisable(GL_CULL_FACE);
    this->State->vtkglDepthMask(GL_TRUE);
    return true;
  }

  const auto known = this->Receives.find(prop);
  const bool receives = known == this->Receives.end() || known->second;
  auto* actor = vtkActor::SafeDownCast(prop);
  const bool isTranslucent = actor && actor->IsRenderingTranslucentPolygonalGeometry();
  program->SetUniformf("shadowReceivesLookup", receives ? 1.0f : 0.0f);
  program->SetUniformf("shadowReceivesMask", receives && !isTranslucent ? 1.0f : 0.0f);
  program->SetUniformi("shadowParallelEye", this->ParallelEye);
  program->SetUniformi("shadowShownLight", this->ShownLight);
  for (std::size_t i = 0; i < this->Plan.size(); ++i)
  {
    if (this->Plan[i].Technique)
    {
      program->SetUniformf(StrengthUniform(i).c_str(), this->Plan[i].Strength);
    }
  }

  // A mask covers the viewport, whatever its size in the framebuffer that is drawn to.
  int viewport[4];
  this->State->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const float origin[2] = { static_cast<float>(viewport[0]), static_cast<float>(viewport[1]) };
  const float scale[2] = { this->MaskSize[0] / viewport[2], this->MaskSize[1] / viewport[3] };
  program->SetUniform2f("shadowMaskOrigin", origin);
  program->SetUniform2f("shadowMaskScale", scale);
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkShadowedShadingPass::GetShaderStageMTime()
{
  return this->ShaderStage.GetMTime();
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::ReleaseGraphicsResources(vtkWindow*)
{
  this->Placeholder->Release();
}

//------------------------------------------------------------------------------
void vtkShadowedShadingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lights in plan: " << this->Plan.size() << "\n";
}
