#include "vtkShadowMergedCasters.h"

#include "vtkShadowCasterGeometry.h"
#include "vtkShadowCasterMesh.h"
#include "vtkShadowMatrix.h"
#include "vtkShadowMergedCastersFS.h"
#include "vtkShadowMergedCastersVS.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowVertexArray.h"

#include "vtkActor.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkMapper.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <utility>

namespace
{

constexpr std::size_t BytesOfTriangle = 3 * sizeof(std::uint32_t); // its indices
constexpr std::size_t FirstBytes = std::size_t(1) << 16;
// What is no longer drawn is left in the list up to this share of it.
constexpr double MostUnused = 0.5;

// Whether a prop draws its mapper's triangles and nothing else: an actor of VTK's own class. Others
// may choose among several mappers as they draw.
bool IsPlainActor(const vtkShadowScene::Prop& prop)
{
  auto* actor = vtkActor::SafeDownCast(prop.Source);
  if (!actor || std::strcmp(actor->GetClassName(), "vtkOpenGLActor") != 0 || prop.Translucent ||
    prop.Impostors || prop.Pieces.size() != 1 || actor->GetProperty()->GetVertexVisibility())
  {
    return false;
  }
  const vtkShadowScene::Piece& piece = prop.Pieces.front();
  return piece.Prop == actor && piece.DrawnSolid && !piece.Mapper->GetClippingPlanes();
}

// Whether a piece may have a place in the list, told without its triangles.
bool IsFit(const vtkShadowScene::Piece& piece, const vtkShadowCasterGeometry::Survey& survey)
{
  const auto* blocks = vtkShadowCasterGeometry::AttributesOf(piece.Mapper);
  return !(blocks && blocks->HasBlockOpacities()) && survey.NoSurface.empty() &&
    survey.NoFiniteSurface.empty() && !survey.HasSpheres &&
    survey.Triangles <= vtkShadowMergedCasters::MostTrianglesOfLarge;
}

}

//------------------------------------------------------------------------------
vtkShadowMergedCasters::~vtkShadowMergedCasters()
{
  this->Release();
}

//------------------------------------------------------------------------------
void vtkShadowMergedCasters::Release()
{
  this->MatrixTexture.Release();
  if (this->Window)
  {
    this->Window->MakeCurrent();
    for (List* list : { &this->Vertices, &this->Indices })
    {
      glDeleteBuffers(1, &list->Buffer);
    }
  }
  this->Vertices = {};
  this->Indices = {};
  this->NumberOfMatrices = 0;
  this->Casters.BeginFrame({});
  this->Window = nullptr;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowMergedCasters::Bytes() const
{
  return this->Vertices.Capacity + this->Indices.Capacity + this->MatrixTexture.Bytes();
}

//------------------------------------------------------------------------------
void vtkShadowMergedCasters::List::Append(const void* data, std::size_t bytes)
{
  if (this->Used + bytes > this->Capacity)
  {
    const std::size_t capacity = std::max({ FirstBytes, 2 * this->Capacity, this->Used + bytes });
    unsigned int larger = 0;
    glGenBuffers(1, &larger);
    glBindBuffer(GL_COPY_WRITE_BUFFER, larger);
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(capacity), nullptr, GL_STATIC_DRAW);
    if (this->Buffer)
    {
      glBindBuffer(GL_COPY_READ_BUFFER, this->Buffer);
      glCopyBufferSubData(
        GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(this->Used));
      glBindBuffer(GL_COPY_READ_BUFFER, 0);
      glDeleteBuffers(1, &this->Buffer);
    }
    this->Buffer = larger;
    this->Capacity = capacity;
  }
  glBindBuffer(GL_COPY_WRITE_BUFFER, this->Buffer);
  glBufferSubData(
    GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(this->Used), static_cast<GLsizeiptr>(bytes), data);
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
  this->Used += bytes;
}

//------------------------------------------------------------------------------
void vtkShadowMergedCasters::BeginFrame(const vtkShadowFrame& frame)
{
  ++this->FrameNumber;
  this->NumberDrawn = 0;
  this->Casters.BeginFrame(frame.Scene->GetProps());
  std::size_t listed = 0;
  this->Casters.ForEach([&listed](const Caster& caster) { listed += caster.Triangles; });
  const double used = static_cast<double>(this->Indices.Used / BytesOfTriangle);
  if (this->Window != frame.Window || used - static_cast<double>(listed) > MostUnused * used)
  {
    this->Release();
    this->Window = frame.Window;
  }
}

//------------------------------------------------------------------------------
// That of a prop which is to be drawn from the list, once it has been drawn by its mapper; else
// none. What is large is to be, once a view sees a small part of it, and if it was there in a frame
// before: else a mesh that changes its shape would be clustered for each.
vtkShadowMergedCasters::Caster* vtkShadowMergedCasters::ReadyCaster(
  const vtkShadowScene::Prop& prop, const glm::dmat4& clipFromWorld)
{
  if (!IsPlainActor(prop))
  {
    return nullptr;
  }
  const vtkShadowScene::Piece& piece = prop.Pieces.front();
  Caster& caster = this->Casters.Of(piece, []() { return Caster(); });
  if (caster.State == Caster::New)
  {
    caster.State = Caster::Drawn;
    caster.DrawnFirst = this->FrameNumber;
    return nullptr;
  }
  if (caster.State == Caster::Drawn)
  {
    const vtkShadowCasterGeometry::Survey survey = vtkShadowCasterGeometry::SurveyOf(piece);
    caster.State = IsFit(piece, survey) ? Caster::Fit : Caster::Unfit;
    caster.IsLarge = survey.Triangles > vtkshadows::MostTrianglesInOne;
  }
  const bool waits = caster.State == Caster::Fit && caster.IsLarge &&
    (caster.DrawnFirst == this->FrameNumber ||
      vtkshadows::ShareWithin(clipFromWorld, piece.CornersWC) > vtkshadows::MostShareSeen);
  return caster.State == Caster::Unfit || waits ? nullptr : &caster;
}

//------------------------------------------------------------------------------
void vtkShadowMergedCasters::Enlist(const vtkShadowScene::Piece& piece, Caster& caster)
{
  vtkShadowCasterMesh about;
  vtkShadowCasterGeometry geometry = about.Extract(piece);
  const std::size_t texels = std::size_t(4) * (this->NumberOfMatrices + 1);
  if (!about.Skipped.empty() || texels > vtkShadowTextureBuffer::LargestSize())
  {
    caster.State = Caster::Unfit;
    return;
  }
  caster.State = Caster::Listed;
  caster.ModelFromCaster = about.ModelFromCaster;
  caster.Matrix = this->NumberOfMatrices++;
  caster.Clusters = vtkshadows::ClusterTriangles(
    geometry.Vertices, geometry.Triangles, vtkshadows::TrianglesOfCluster);
  vtkshadows::OrderVertices(geometry.Vertices, geometry.Triangles);
  std::vector<Vertex> vertices;
  vertices.reserve(geometry.Vertices.size());
  for (const glm::vec3& position : geometry.Vertices)
  {
    vertices.push_back({ position, caster.Matrix });
  }
  const auto first = static_cast<std::uint32_t>(this->Vertices.Used / sizeof(Vertex));
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * geometry.Triangles.size());
  for (const glm::uvec3& triangle : geometry.Triangles)
  {
    indices.insert(indices.end(), { first + triangle.x, first + triangle.y, first + triangle.z });
  }
  caster.First = this->Indices.Used / BytesOfTriangle;
  caster.Triangles = geometry.Triangles.size();
  this->Vertices.Append(vertices.data(), vertices.size() * sizeof(Vertex));
  this->Indices.Append(indices.data(), indices.size() * sizeof(std::uint32_t));
}

//------------------------------------------------------------------------------
std::vector<std::size_t> vtkShadowMergedCasters::Draw(const vtkShadowFrame& frame,
  const std::vector<std::size_t>& casters, const vtkshadows::LightView& view,
  const std::unordered_map<vtkProp*, unsigned int>& culled, bool writesDepth)
{
  const std::vector<vtkShadowScene::Prop>& props = frame.Scene->GetProps();
  std::vector<std::size_t> others;
  std::vector<std::pair<std::size_t, Caster*>> merged;
  const glm::dmat4 clipFromWorld = view.clipFromView * view.viewFromWorld;
  std::size_t numberOfSmall = 0;
  for (const std::size_t i : casters)
  {
    if (Caster* caster = this->ReadyCaster(props[i], clipFromWorld))
    {
      merged.emplace_back(i, caster);
      numberOfSmall += caster->IsLarge ? 0 : 1;
    }
    else
    {
      others.push_back(i);
    }
  }
  if (numberOfSmall < FewestProps)
  {
    const auto small = std::stable_partition(
      merged.begin(), merged.end(), [](const auto& entry) { return entry.second->IsLarge; });
    std::transform(small, merged.end(), std::back_inserter(others),
      [](const auto& entry) { return entry.first; });
    merged.erase(small, merged.end());
  }

  this->Drawn = {};
  int drawn = 0;
  for (const auto& [i, known] : merged)
  {
    const vtkShadowScene::Piece& piece = props[i].Pieces.front();
    Caster& caster = *known;
    if (caster.State == Caster::Fit)
    {
      this->Enlist(piece, caster);
    }
    if (caster.State == Caster::Unfit)
    {
      others.push_back(i);
      continue;
    }
    this->Matrices.resize(std::size_t(16) * this->NumberOfMatrices);
    const glm::dmat4 clipFromCaster =
      clipFromWorld * (piece.WorldFromModel * caster.ModelFromCaster);
    const std::array<float, 16> matrix = vtkShadowMatrix::ToFloats(clipFromCaster);
    std::copy(
      matrix.begin(), matrix.end(), this->Matrices.begin() + std::size_t(16) * caster.Matrix);
    const auto hidden = culled.find(piece.Prop);
    const std::size_t faces = hidden == culled.end() ? 0 : hidden->second == GL_FRONT ? 1 : 2;
    this->Drawn[faces].AddSeen(caster.Clusters, clipFromCaster, caster.First);
    ++drawn;
  }
  if (drawn == 0)
  {
    return casters;
  }
  this->MatrixTexture.Upload(frame.Window, 4, this->Matrices);
  this->MatrixTexture.Activate();
  if (this->MatrixTexture.Unit() < 0)
  {
    return casters; // the driver has no unit left
  }
  this->DrawRanges(frame, writesDepth);
  this->MatrixTexture.Deactivate();
  this->NumberDrawn += drawn;
  return others;
}

//------------------------------------------------------------------------------
void vtkShadowMergedCasters::DrawRanges(const vtkShadowFrame& frame, bool writesDepth)
{
  vtkShaderProgram* program = frame.Window->GetShaderCache()->ReadyShaderProgram(
    vtkShadowMergedCastersVS, vtkShadowMergedCastersFS, "");
  vtkOpenGLState* state = frame.Window->GetState();
  program->SetUniformi("shadowMatrices", this->MatrixTexture.Unit());
  state->vtkglDepthMask(writesDepth ? GL_TRUE : GL_FALSE);

  const vtkShadowVertexArray vertices(this->Vertices.Buffer, this->Indices.Buffer);
  vertices.AddFloats(program, "shadowVertex", 3, sizeof(Vertex));
  vertices.AddNumber(program, "shadowMatrix", sizeof(Vertex), offsetof(Vertex, Matrix));
  const GLenum hidden[] = { GL_NONE, GL_FRONT, GL_BACK };
  for (std::size_t i = 0; i < this->Drawn.size(); ++i)
  {
    const std::vector<vtkshadows::TriangleRange>& ranges = this->Drawn[i].Get();
    if (ranges.empty())
    {
      continue;
    }
    if (hidden[i] == GL_NONE)
    {
      state->vtkglDisable(GL_CULL_FACE);
    }
    else
    {
      state->vtkglEnable(GL_CULL_FACE);
      state->vtkglCullFace(hidden[i]);
    }
    std::vector<GLsizei> counts;
    std::vector<const void*> offsets;
    for (const vtkshadows::TriangleRange& range : ranges)
    {
      counts.push_back(static_cast<GLsizei>(3 * range.count));
      offsets.push_back(reinterpret_cast<const void*>(range.first * BytesOfTriangle));
    }
    glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, offsets.data(),
      static_cast<GLsizei>(counts.size()));
  }
}
