// One caster of shadow volumes: its mesh, built once a shape; its points with the driver; and one
// volume a light, built again only when the light moved relative to it.
//
// All in the caster's own coordinates (see vtkShadowCasterMesh.h). The same floats by the same
// matrix give the same pixels and depths, so that a cap ties with the surface that it lies on; and
// an actor that moves changes nothing but where the light is. Only a caster whose matrix flattens
// it, so that no light can be taken back through it, is built in world coordinates, and anew when
// its matrix changes.
#ifndef vtkShadowVolumeCaster_h
#define vtkShadowVolumeCaster_h

#include "ShadowVolume.h"
#include "vtkShadowSceneData.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

class vtkOpenGLState;

class vtkShadowVolumeCaster
{
public:
  vtkShadowVolumeCaster() = default;
  ~vtkShadowVolumeCaster();
  vtkShadowVolumeCaster(const vtkShadowVolumeCaster&) = delete;
  void operator=(const vtkShadowVolumeCaster&) = delete;

  // Follow `piece`; true if its mesh was built anew. The window's context must be current.
  bool Update(vtkOpenGLRenderWindow* window, const vtkShadowScene::Piece& piece);

  // Why the whole caster is left out; a point at which it has no triangles; what of it has no
  // triangles at all. Empty: nothing.
  const std::string& GetFault() const { return this->Fault; }
  const std::string& GetNotFinite() const { return this->NotFinite; }
  const std::string& GetSkipped() const { return this->Skipped; }
  bool IsEmpty() const { return this->Mesh.NumberOfTriangles() == 0; }

  const glm::dmat4& GetWorldFromCaster() const { return this->WorldFromCaster; }
  bool IsMirrored() const { return this->Mirrored; }
  const vtkshadows::ShadowMesh<float>& GetMesh() const { return this->Mesh; }

  struct Volume
  {
    bool Built = false;
    glm::dvec4 LightTC{ 0.0 };
    bool OneImage = false;
    vtkshadows::CastingFaces Faces = vtkshadows::CastingFaces::Closed;
    vtkshadows::VolumeLists Lists; // in the buffer, which OpenGL takes as indices and as a texture
    unsigned int Buffer = 0, Texture = 0;
    std::size_t Bytes = 0;
  };

  // The light in the caster's coordinates.
  glm::dvec4 ToCaster(const glm::dvec4& lightWC) const;

  // The volume of light number `slot`; `built` counts those that had to be made.
  const Volume& UpdateVolume(std::size_t slot, const glm::dvec4& lightWC, bool oneImage,
    vtkshadows::CastingFaces faces, vtkIdType& built);

  // The silhouette that a volume stands on, as pairs of indices for lines: edges of multiplicity 1,
  // and of more.
  void FindSilhouette(const Volume& volume, std::vector<std::uint32_t>& single,
    std::vector<std::uint32_t>& several) const;

  // How many casting triangles a ray from the light in `directionWC` crosses: in how many volumes
  // the point at infinity there lies.
  int CountAtInfinity(
    const glm::dvec4& lightWC, const glm::dvec3& directionWC, vtkshadows::CastingFaces faces) const;

  // Attach the points to the texture unit `points`, which is left active, and the volume's lists to
  // `lists` and as indices.
  void Bind(vtkOpenGLState* state, const Volume& volume, int points, int lists) const;

  // On both sides: the mesh, and with the driver its points and the volumes.
  std::size_t MemoryInBytes() const;
  void Release();

  // Set by who keeps casters, to drop those that are gone.
  bool Used = false;

private:
  void Rebuild(const vtkShadowScene::Piece& piece);
  void UploadPoints();
  static bool Upload(const vtkshadows::VolumeEmitter<float>& emitter, Volume& volume);

  std::vector<std::uint64_t> BuiltFrom; // the piece's shape, or its signature if InWorld
  bool InWorld = false;
  std::string Fault, NotFinite, Skipped;
  vtkshadows::ShadowMesh<float> Mesh;
  glm::dmat4 ModelFromCaster{ 1.0 }, WorldFromCaster{ 1.0 };
  bool Mirrored = false;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  unsigned int PointBuffer = 0, PointTexture = 0;
  std::size_t PointBytes = 0;
  std::deque<Volume> Volumes; // by slot; who draws holds on to them
};

#endif
