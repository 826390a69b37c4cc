#include "vtkShadowVolumeCaster.h"

#include "vtkShadowCasterMesh.h"
#include "vtkShadowOpenGL.h"

#include "vtkOpenGLRenderWindow.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

using vtkshadows::CastingFaces;

namespace
{

// Scratch of the thread that draws: kept, so that a moving light allocates nothing.
struct Scratch
{
  std::vector<vtkshadows::CastSign> Signs;
  vtkshadows::VolumeIndices Indices;
};

Scratch& SharedScratch()
{
  static thread_local Scratch scratch;
  return scratch;
}

unsigned int MakeBuffer(GLenum target, const void* data, std::size_t bytes)
{
  unsigned int buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  return buffer;
}

}

//------------------------------------------------------------------------------
vtkShadowVolumeCaster::~vtkShadowVolumeCaster()
{
  this->Release();
}

//------------------------------------------------------------------------------
bool vtkShadowVolumeCaster::Update(
  vtkOpenGLRenderWindow* window, const vtkShadowScene::Piece& piece)
{
  const bool isStale = this->Shape != piece.Shape || this->Window.GetPointer() != window;
  if (isStale)
  {
    this->Release();
    this->Window = window;
    this->Shape = piece.Shape;
    this->Rebuild(piece);
  }
  this->WorldFromCaster = piece.WorldFromModel * this->ModelFromCaster;
  const double determinant = glm::determinant(glm::dmat3(this->WorldFromCaster));
  this->Mirrored = determinant < 0.0;
  const bool isSingular = !(std::abs(determinant) > 0.0) || !std::isfinite(determinant);
  this->Fault = isSingular && !this->IsEmpty()
    ? "a matrix that flattens it or is not finite (its determinant is " +
      std::to_string(determinant) + ")"
    : this->MeshFault;
  return isStale;
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCaster::Rebuild(const vtkShadowScene::Piece& piece)
{
  vtkShadowCasterMesh caster = vtkShadowCasterMesh::Build(piece);
  this->ModelFromCaster = caster.ModelFromCaster;
  this->Skipped = caster.Skipped;
  this->MeshFault = caster.Fault;
  this->Mesh = std::move(caster.Mesh);
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (this->Mesh.points.size() > static_cast<std::size_t>(most))
  {
    this->MeshFault = std::to_string(this->Mesh.points.size()) + " points, more than the " +
      std::to_string(most) + " that this OpenGL driver takes at once";
    this->Mesh = {};
  }
  if (!this->IsEmpty())
  {
    this->UploadPoints();
  }
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCaster::UploadPoints()
{
  const std::vector<glm::vec3>& points = this->Mesh.points;
  GLint before = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &before);
  glGenTextures(1, &this->PointTexture);
  glBindTexture(GL_TEXTURE_BUFFER, this->PointTexture);
  // Three floats a texel came with OpenGL 4.0; before, a fourth is padding.
  GLint major = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  if (major >= 4)
  {
    this->PointBuffer =
      MakeBuffer(GL_TEXTURE_BUFFER, points.data(), points.size() * sizeof(glm::vec3));
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGB32F, this->PointBuffer);
  }
  else
  {
    std::vector<glm::vec4> padded;
    for (const glm::vec3& p : points)
    {
      padded.emplace_back(p, 1.0f);
    }
    this->PointBuffer =
      MakeBuffer(GL_TEXTURE_BUFFER, padded.data(), padded.size() * sizeof(glm::vec4));
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, this->PointBuffer);
  }
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
  glBindTexture(GL_TEXTURE_BUFFER, static_cast<GLuint>(before));
}

//------------------------------------------------------------------------------
glm::dvec4 vtkShadowVolumeCaster::ToCaster(const glm::dvec4& lightWC) const
{
  return glm::inverse(this->WorldFromCaster) * lightWC;
}

//------------------------------------------------------------------------------
const vtkShadowVolumeCaster::Volume& vtkShadowVolumeCaster::UpdateVolume(
  std::size_t slot, const glm::dvec4& lightWC, bool oneImage, CastingFaces faces, vtkIdType& built)
{
  if (this->Volumes.size() <= slot)
  {
    this->Volumes.resize(slot + 1);
  }
  Volume& volume = this->Volumes[slot];
  const glm::dvec4 lightTC = this->ToCaster(lightWC);
  if (volume.Built && volume.LightTC == lightTC && volume.OneImage == oneImage &&
    volume.Faces == faces)
  {
    return volume;
  }
  Scratch& scratch = SharedScratch();
  vtkshadows::FaceTriangles(this->Mesh, lightTC, faces, scratch.Signs);
  vtkshadows::EmitVolume(this->Mesh, scratch.Signs, oneImage, scratch.Indices);

  volume.Built = true;
  volume.LightTC = lightTC;
  volume.OneImage = oneImage;
  volume.Faces = faces;
  volume.Bytes = scratch.Indices.Count() * sizeof(std::uint32_t);
  if (!volume.Buffer)
  {
    glGenBuffers(1, &volume.Buffer);
  }
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, volume.Buffer);
  glBufferData(
    GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(volume.Bytes), nullptr, GL_DYNAMIC_DRAW);
  std::size_t first = 0;
  const auto upload = [&first](const std::vector<std::uint32_t>& indices, Section& section)
  {
    section.First = first;
    section.Count = indices.size();
    if (!indices.empty())
    {
      glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLintptr>(first * sizeof(std::uint32_t)),
        static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data());
    }
    first += indices.size();
  };
  upload(scratch.Indices.singles, volume.Singles);
  upload(scratch.Indices.doubles, volume.Doubles);
  upload(scratch.Indices.caps, volume.Caps);
  upload(scratch.Indices.turnedCaps, volume.TurnedCaps);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  ++built;
  return volume;
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCaster::FindSilhouette(const Volume& volume, std::vector<std::uint32_t>& single,
  std::vector<std::uint32_t>& several) const
{
  Scratch& scratch = SharedScratch();
  std::vector<vtkshadows::SilhouetteEdge> edges;
  vtkshadows::FaceTriangles(this->Mesh, volume.LightTC, volume.Faces, scratch.Signs);
  vtkshadows::FindSilhouette(this->Mesh, scratch.Signs, edges);
  for (const vtkshadows::SilhouetteEdge& edge : edges)
  {
    std::vector<std::uint32_t>& out = edge.multiplicity == 1 ? single : several;
    out.push_back(2 * edge.from);
    out.push_back(2 * edge.to);
  }
}

//------------------------------------------------------------------------------
int vtkShadowVolumeCaster::CountAtInfinity(
  const glm::dvec4& lightWC, const glm::dvec3& directionWC, CastingFaces faces) const
{
  Scratch& scratch = SharedScratch();
  const glm::dvec4 lightTC = this->ToCaster(lightWC);
  const glm::dvec3 directionTC(glm::inverse(this->WorldFromCaster) * glm::dvec4(directionWC, 0.0));
  vtkshadows::FaceTriangles(this->Mesh, lightTC, faces, scratch.Signs);
  return vtkshadows::CountCrossed(this->Mesh, scratch.Signs, lightTC, directionTC);
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCaster::BindPoints() const
{
  glBindTexture(GL_TEXTURE_BUFFER, this->PointTexture);
}

//------------------------------------------------------------------------------
std::size_t vtkShadowVolumeCaster::MemoryInBytes() const
{
  std::size_t bytes = this->Mesh.MemoryInBytes();
  bytes += this->PointBuffer ? this->Mesh.points.size() * sizeof(glm::vec3) : 0;
  for (const Volume& volume : this->Volumes)
  {
    bytes += volume.Bytes;
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCaster::Release()
{
  if (this->Window)
  {
    this->Window->MakeCurrent();
  }
  for (Volume& volume : this->Volumes)
  {
    if (volume.Buffer && this->Window)
    {
      glDeleteBuffers(1, &volume.Buffer);
    }
  }
  this->Volumes.clear();
  if (this->PointTexture && this->Window)
  {
    glDeleteTextures(1, &this->PointTexture);
    glDeleteBuffers(1, &this->PointBuffer);
  }
  this->PointTexture = 0;
  this->PointBuffer = 0;
  this->Shape.clear();
}
