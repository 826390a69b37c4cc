#include "vtkShadowVolumeCaster.h"

#include "vtkShadowCasterMesh.h"
#include "vtkShadowOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

using vtkshadows::CastingFaces;

namespace
{

unsigned int MakeBuffer(GLenum target, const void* data, std::size_t bytes)
{
  unsigned int buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  return buffer;
}

// Binds a texture of a buffer, and what was bound before again.
class ScopedBufferTexture
{
public:
  explicit ScopedBufferTexture(GLuint texture)
  {
    glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &this->Before);
    glBindTexture(GL_TEXTURE_BUFFER, texture);
  }
  ~ScopedBufferTexture() { glBindTexture(GL_TEXTURE_BUFFER, static_cast<GLuint>(this->Before)); }

private:
  GLint Before = 0;
};

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
  const bool inWorld = vtkShadowCasterMesh::FloatsCannotInvert(piece.WorldFromModel);
  const std::vector<std::uint64_t>& from = inWorld ? piece.Signature : piece.Shape;
  const bool isStale =
    this->InWorld != inWorld || this->BuiltFrom != from || this->Window.GetPointer() != window;
  if (isStale)
  {
    this->Release();
    this->Window = window;
    this->InWorld = inWorld;
    this->BuiltFrom = from;
    this->Rebuild(piece);
  }
  if (!inWorld)
  {
    this->WorldFromCaster = piece.WorldFromModel * this->ModelFromCaster;
  }
  this->Mirrored = glm::determinant(glm::dmat3(this->WorldFromCaster)) < 0.0;
  return isStale;
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCaster::Rebuild(const vtkShadowScene::Piece& piece)
{
  vtkShadowCasterMesh caster = this->InWorld
    ? vtkShadowCasterMesh::BuildInWorld(piece, this->WorldFromCaster)
    : vtkShadowCasterMesh::Build(piece);
  this->ModelFromCaster = caster.ModelFromCaster;
  this->Skipped = caster.Skipped;
  this->NotFinite = caster.NotFinite;
  this->Fault.clear();
  this->Mesh = std::move(caster.Mesh);
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (this->Mesh.points.size() > static_cast<std::size_t>(most))
  {
    this->Fault = std::to_string(this->Mesh.points.size()) + " points, more than the " +
      std::to_string(most) + " that this OpenGL driver takes at once";
    this->Mesh = {};
  }
  vtkshadows::SetSoupApart(this->Mesh, static_cast<std::size_t>(most));
  if (!this->IsEmpty())
  {
    this->UploadPoints();
  }
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCaster::UploadPoints()
{
  const std::vector<glm::vec3>& points = this->Mesh.points;
  glGenTextures(1, &this->PointTexture);
  const ScopedBufferTexture bound(this->PointTexture);
  // Three floats a texel came with OpenGL 4.0; before, a fourth is padding.
  GLint major = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  if (major >= 4)
  {
    this->PointBytes = points.size() * sizeof(glm::vec3);
    this->PointBuffer = MakeBuffer(GL_TEXTURE_BUFFER, points.data(), this->PointBytes);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGB32F, this->PointBuffer);
  }
  else
  {
    std::vector<glm::vec4> padded;
    padded.reserve(points.size());
    for (const glm::vec3& p : points)
    {
      padded.emplace_back(p, 1.0f);
    }
    this->PointBytes = padded.size() * sizeof(glm::vec4);
    this->PointBuffer = MakeBuffer(GL_TEXTURE_BUFFER, padded.data(), this->PointBytes);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, this->PointBuffer);
  }
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
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
  std::vector<vtkshadows::CastSign> signs;
  vtkshadows::FaceTriangles(this->Mesh, lightTC, faces, signs, vtkshadows::TouchedFaces::CastNot);
  const vtkshadows::VolumeEmitter<float> emitter(this->Mesh, signs, oneImage);
  volume.LightTC = lightTC;
  volume.OneImage = oneImage;
  volume.Faces = faces;
  volume.Built = Upload(emitter, volume);
  ++built;
  return volume;
}

//------------------------------------------------------------------------------
// Written straight into the driver's memory: nothing of it is kept on this side. false if that got
// lost meanwhile, as OpenGL allows; then it is done again with the next frame.
bool vtkShadowVolumeCaster::Upload(const vtkshadows::VolumeEmitter<float>& emitter, Volume& volume)
{
  volume.Lists = emitter.Lists();
  volume.Bytes = volume.Lists.Count() * sizeof(std::uint32_t);
  if (!volume.Buffer)
  {
    glGenBuffers(1, &volume.Buffer);
    glGenTextures(1, &volume.Texture);
  }
  const auto bytes = static_cast<GLsizeiptr>(volume.Bytes);
  glBindBuffer(GL_TEXTURE_BUFFER, volume.Buffer);
  glBufferData(GL_TEXTURE_BUFFER, bytes, nullptr, GL_DYNAMIC_DRAW);
  bool isWritten = true;
  if (bytes > 0)
  {
    void* numbers = glMapBufferRange(
      GL_TEXTURE_BUFFER, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
    if (numbers)
    {
      emitter.Write(static_cast<std::uint32_t*>(numbers));
    }
    isWritten = numbers && glUnmapBuffer(GL_TEXTURE_BUFFER) == GL_TRUE;
    // Soup comes first, and has fewer triangles than points: it is within what a texture may have.
    const ScopedBufferTexture bound(volume.Texture);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_R32UI, volume.Buffer);
  }
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
  volume.Lists = isWritten ? volume.Lists : vtkshadows::VolumeLists();
  return isWritten;
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCaster::FindSilhouette(const Volume& volume, std::vector<std::uint32_t>& single,
  std::vector<std::uint32_t>& several) const
{
  std::vector<vtkshadows::CastSign> signs;
  std::vector<vtkshadows::SilhouetteEdge> edges;
  vtkshadows::FaceTriangles(
    this->Mesh, volume.LightTC, volume.Faces, signs, vtkshadows::TouchedFaces::CastNot);
  vtkshadows::FindSilhouette(this->Mesh, signs, edges);
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
  std::vector<vtkshadows::CastSign> signs;
  const glm::dvec4 lightTC = this->ToCaster(lightWC);
  const glm::dvec3 directionTC(glm::inverse(this->WorldFromCaster) * glm::dvec4(directionWC, 0.0));
  vtkshadows::FaceTriangles(this->Mesh, lightTC, faces, signs, vtkshadows::TouchedFaces::CastNot);
  return vtkshadows::CountCrossed(this->Mesh, signs, lightTC, directionTC);
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCaster::Bind(
  vtkOpenGLState* state, const Volume& volume, int points, int lists) const
{
  state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(lists));
  glBindTexture(GL_TEXTURE_BUFFER, volume.Texture);
  state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(points));
  glBindTexture(GL_TEXTURE_BUFFER, this->PointTexture);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, volume.Buffer);
}

//------------------------------------------------------------------------------
std::size_t vtkShadowVolumeCaster::MemoryInBytes() const
{
  std::size_t bytes = this->Mesh.MemoryInBytes() + this->PointBytes;
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
      glDeleteTextures(1, &volume.Texture);
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
  this->PointBytes = 0;
  this->BuiltFrom.clear();
}
