#include "vtkPlanarShadowPassInternals.h"

#include "vtkPlanarShadowPassLookup.h"
#include "vtkShadowChecks.h"

#include "vtkCamera.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderer.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkPlanarShadowPass);

//------------------------------------------------------------------------------
vtkPlanarShadowPass::vtkPlanarShadowPass()
  : Internal(new Internals(this))
{
}

vtkPlanarShadowPass::~vtkPlanarShadowPass() = default;

//------------------------------------------------------------------------------
bool vtkPlanarShadowPass::AddPlane(double nx, double ny, double nz, double offset)
{
  // Scaled first, so that a very short or long normal keeps its digits.
  const double largest = std::max({ std::abs(nx), std::abs(ny), std::abs(nz) });
  const glm::dvec3 normal = glm::dvec3(nx, ny, nz) / largest;
  const double length = glm::length(normal);
  const glm::dvec4 plane(normal / length, offset / largest / length);
  if (!(largest > 0.0) || !std::isfinite(length) || !std::isfinite(plane.w))
  {
    vtkErrorMacro("AddPlane(" << nx << ", " << ny << ", " << nz << ", " << offset
                              << "): the normal has no direction, or a number is not finite. Give "
                                 "a normal of any length but 0.");
    return false;
  }
  this->Internal->Named.push_back(plane);
  this->Modified();
  return true;
}

void vtkPlanarShadowPass::RemoveAllPlanes()
{
  this->Internal->Named.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::SetSoftMethod(int method)
{
  if (!vtkShadowRefusesChoice(this, "SoftMethod", "vtkPlanarShadowPass::SoftMethodType", method,
        PLATEAUS + 1, this->SoftMethod) &&
    method != this->SoftMethod)
  {
    this->SoftMethod = method;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::SetTextureResolution(int resolution)
{
  if (!vtkShadowRefusesSize(
        this, "TextureResolution", "a texture", resolution, this->TextureResolution) &&
    resolution != this->TextureResolution)
  {
    this->TextureResolution = resolution;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowPass::UpdateVisibility(
  const vtkShadowFrame& frame, const std::vector<int>& lights)
{
  Internals& my = *this->Internal;
  this->NumberOfThrows = 0;
  this->NumberOfDrawnCasters = 0;
  this->NumberOfCulledCasters = 0;
  const vtkShadowScene& scene = *frame.Scene;
  const glm::dmat4 worldFromView = glm::inverse(frame.ViewFromWorld);
  const bool isParallel = frame.Renderer->GetActiveCamera()->GetParallelProjection() != 0;
  my.EyeWC = isParallel ? worldFromView[2] : worldFromView[3];
  my.Planes.Find(scene, my.Named, this->AutomaticPlanes, my.EyeWC);
  const std::vector<vtkShadowPlanes::Plane>& planes = my.Planes.Get();
  const bool anyReceiver = std::any_of(planes.begin(), planes.end(),
    [](const vtkShadowPlanes::Plane& plane) { return !plane.Props.empty(); });
  my.SetEye(frame);
  my.HiddenFaces.BeginFrame(scene.GetProps());
  my.Meshes.BeginFrame(scene.GetProps());
  const std::size_t leftOut = my.FindShadows(frame, lights);
  this->WarnOnce(&my.Planes,
    !anyReceiver
      ? "No receiver lies in a plane: nothing takes a planar shadow. Add a floor, name a plane "
        "(AddPlane) that a receiver has a face on, or use another technique."
      : leftOut > 0 ? "Shadows fall on " + std::to_string(leftOut) + " more planes than the " +
        std::to_string(this->MaximumNumberOfPlanes) +
        " with the largest receivers, and are left out. Raise MaximumNumberOfPlanes, or use "
        "another technique."
                    : "");

  const bool anySoft = std::any_of(my.Shadows.begin(), my.Shadows.end(),
    [&my](const Internals::Shadow& shadow) { return my.IsSum(*shadow.Light); });
  const bool done = this->PlaneTextures
    ? my.UpdateTextures(
        frame, this->WithinDriver("TextureResolution", this->TextureResolution), anySoft)
    : my.UpdateMasks(frame, anySoft);
  this->WarnOnce(this,
    done ? ""
         : "The driver cannot hold masks of " + std::to_string(frame.Size[0]) + " x " +
        std::to_string(frame.Size[1]) + " pixels for " + std::to_string(lights.size()) +
        " lights, or the planes' textures: they are lit. Use a smaller window, fewer lights, or a "
        "lower TextureResolution.");
  return done;
}

//------------------------------------------------------------------------------
std::string vtkPlanarShadowPass::GetLookupDeclarations() const
{
  const Internals& my = *this->Internal;
  return !this->PlaneTextures ? std::string()
                              : "#define SHADOW_PLANE_MATRICES " +
      std::to_string(my.MostPlanesOfProp * static_cast<std::size_t>(my.NumberOfSlots)) + "\n" +
      vtkPlanarShadowPassLookup;
}

std::string vtkPlanarShadowPass::GetLookupFunction(int, vtkProp*) const
{
  return this->Internal->MostPlanesOfProp > 1 ? "shadowPlaneTextures" : "shadowPlaneTexture";
}

//------------------------------------------------------------------------------
int vtkPlanarShadowPass::GetNumberOfPlanes() const
{
  return static_cast<int>(this->Internal->Planes.Get().size());
}

bool vtkPlanarShadowPass::GetPlane(int plane, double normalAndOffset[4]) const
{
  if (plane < 0 || plane >= this->GetNumberOfPlanes())
  {
    return false;
  }
  const glm::dvec4& planeWC = this->Internal->Planes.Get()[static_cast<std::size_t>(plane)].PlaneWC;
  for (int i = 0; i < 4; ++i)
  {
    normalAndOffset[i] = planeWC[i];
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowPass::HasVisibilityOf(vtkProp* prop) const
{
  return this->Internal->Planes.ShadowedPlanesOf(prop) != nullptr;
}

vtkMTimeType vtkPlanarShadowPass::GetReceiverStamp() const
{
  return this->Internal->Planes.ShadowedStamp();
}

vtkShadowTextureArray* vtkPlanarShadowPass::GetTextures()
{
  return this->PlaneTextures ? &this->Internal->Textures : &this->Internal->Masks;
}

//------------------------------------------------------------------------------
vtkIdType vtkPlanarShadowPass::GetTextureMemory() const
{
  const Internals& my = *this->Internal;
  return static_cast<vtkIdType>(my.Masks.Bytes() + my.Depths.Bytes() + my.PlanesOfPixels.Bytes() +
    my.Textures.Bytes() + my.Canvas.Bytes() + my.TextureCanvas.Bytes());
}

vtkIdType vtkPlanarShadowPass::GetCasterMemory() const
{
  std::size_t bytes = 0;
  this->Internal->Meshes.ForEach(
    [&bytes](const vtkShadowCasterMesh& caster) { bytes += caster.Mesh.MemoryInBytes(); });
  return static_cast<vtkIdType>(bytes);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::ReleaseGraphicsResources(vtkWindow* w)
{
  Internals& my = *this->Internal;
  my.Canvas.Release();
  my.TextureCanvas.Release();
  my.Masks.Release();
  my.Depths.Release();
  my.PlanesOfPixels.Release();
  my.Textures.Release();
  my.States.clear();
  this->Superclass::ReleaseGraphicsResources(w);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Named planes: " << this->Internal->Named.size() << "\n";
  os << indent << "AutomaticPlanes: " << this->AutomaticPlanes << "\n";
  os << indent << "MaximumNumberOfPlanes: " << this->MaximumNumberOfPlanes << "\n";
  os << indent << "SoftMethod: " << this->SoftMethod << "\n";
  os << indent << "LightSamples: " << this->LightSamples << "\n";
  os << indent << "PlaneTextures: " << this->PlaneTextures << "\n";
  os << indent << "TextureResolution: " << this->TextureResolution << "\n";
  os << indent << "NumberOfPlanes: " << this->GetNumberOfPlanes() << "\n";
  os << indent << "NumberOfThrows: " << this->NumberOfThrows << "\n";
  os << indent << "NumberOfDrawnCasters: " << this->NumberOfDrawnCasters << "\n";
  os << indent << "NumberOfCulledCasters: " << this->NumberOfCulledCasters << "\n";
  os << indent << "NumberOfTextureBuilds: " << this->NumberOfTextureBuilds << "\n";
}
