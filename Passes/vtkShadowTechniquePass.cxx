#include "vtkShadowTechniquePass.h"

#include "vtkShadowPass.h"
#include "vtkShadowTextureArray.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkShadowTechniquePass::vtkShadowTechniquePass() = default;
vtkShadowTechniquePass::~vtkShadowTechniquePass() = default;

//------------------------------------------------------------------------------
void vtkShadowTechniquePass::Render(const vtkRenderState* s)
{
  if (!this->Standalone)
  {
    this->Standalone = vtkSmartPointer<vtkShadowPass>::New();
    this->Standalone->UseTechnique(this);
  }
  this->Standalone->Render(s);
  this->NumberOfRenderedProps = this->Standalone->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkShadowTechniquePass::ReleaseGraphicsResources(vtkWindow* w)
{
  if (this->Standalone)
  {
    // It borrows this technique, which its subclass releases itself.
    const vtkSmartPointer<vtkShadowPass> standalone = this->Standalone;
    this->Standalone = nullptr;
    standalone->ReleaseGraphicsResources(w);
    this->Standalone = standalone;
  }
}

//------------------------------------------------------------------------------
void vtkShadowTechniquePass::ActivateTextures()
{
  this->GetTextures()->Activate();
}

void vtkShadowTechniquePass::DeactivateTextures()
{
  this->GetTextures()->Deactivate();
}

//------------------------------------------------------------------------------
vtkShadowVertexCode vtkShadowTechniquePass::GetLookupCode(bool) const
{
  return {};
}

vtkShadowVertexCode vtkShadowTechniquePass::GetObjectCode(bool) const
{
  return {};
}

vtkShadowTechniquePass::CasterCode vtkShadowTechniquePass::GetCasterCode() const
{
  return { "vec4", "", "vec4(1.0)" };
}

//------------------------------------------------------------------------------
void vtkShadowTechniquePass::WarnOnce(const void* subject, const std::string& message)
{
  const auto known = std::find_if(this->Warned.begin(), this->Warned.end(),
    [subject](const std::pair<const void*, std::string>& entry) { return entry.first == subject; });
  if (message.empty())
  {
    if (known != this->Warned.end())
    {
      this->Warned.erase(known);
    }
    return;
  }
  if (known == this->Warned.end())
  {
    this->Warned.emplace_back(subject, message);
  }
  else if (known->second == message)
  {
    return;
  }
  else
  {
    known->second = message;
  }
  vtkWarningMacro(<< message);
}

//------------------------------------------------------------------------------
int vtkShadowTechniquePass::WithinDriver(const char* setting, int side) const
{
  const int limit = vtkShadowTextureArray::LargestSide();
  if (side <= limit)
  {
    return side;
  }
  if (this->RefusedSide != side)
  {
    this->RefusedSide = side;
    vtkErrorMacro(<< setting << " " << side << " is above this OpenGL driver's limit of " << limit
                  << " texels, which is used instead. Set it to " << limit << " or less.");
  }
  return limit;
}

//------------------------------------------------------------------------------
void vtkShadowTechniquePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TechniqueName: " << this->GetTechniqueName() << "\n";
  os << indent << "VisibilityForm: " << (this->GetVisibilityForm() == MASK ? "mask" : "lookup")
     << "\n";
}
