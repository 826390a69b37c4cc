#include "vtkShadowTriangleMaps.h"

#include "ShadowReach.h"
#include "vtkShadowCasterGeometry.h"
#include "vtkShadowCasterMesh.h"
#include "vtkShadowDrawScope.h"
#include "vtkShadowMatrix.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowTextureBuffer.h"
#include "vtkShadowTriangleMapsFS.h"
#include "vtkShadowTriangleMapsVS.h"
#include "vtkShadowVertexArray.h"

#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

using vtkshadows::LightCorner;
using vtkshadows::LightTriangles;
using vtkshadows::LightView;

namespace
{

// From texels and depths, 0 to 1, of a map.
glm::dmat4 ClipFromMap(int width, int height)
{
  const glm::dmat4 scaled = glm::scale(glm::dmat4(1.0), glm::dvec3(2.0 / width, 2.0 / height, 2.0));
  return glm::translate(glm::dmat4(1.0), glm::dvec3(-1.0)) * scaled;
}

}

//------------------------------------------------------------------------------
vtkShadowTriangleMaps::~vtkShadowTriangleMaps()
{
  this->Release();
}

//------------------------------------------------------------------------------
bool vtkShadowTriangleMaps::Reserve(
  vtkOpenGLRenderWindow* window, int width, int height, int layers)
{
  if (this->Window.GetPointer() != window)
  {
    this->Release();
    this->Window = window;
  }
  return this->Numbers.Reserve(window, vtkShadowTextureArray::Format::R32UI, width, height, layers);
}

//------------------------------------------------------------------------------
vtkShadowTriangleMaps::Caster& vtkShadowTriangleMaps::CasterOf(const vtkShadowScene::Piece& piece)
{
  return this->Casters.Of(piece,
    [&piece]()
    {
      Caster caster;
      vtkShadowCasterMesh built = vtkShadowCasterMesh::Build(piece);
      caster.IsTriangles = built.Skipped.empty();
      if (caster.IsTriangles)
      {
        caster.Neighbours =
          vtkshadows::FindNeighbours(built.Mesh.edges, built.Mesh.triangles.size());
        caster.ModelFromCaster = built.ModelFromCaster;
        caster.Mesh = std::move(built.Mesh);
        caster.Mesh.edges = {};
      }
      return caster;
    });
}

//------------------------------------------------------------------------------
// Whole meshes are drawn as they are.
void vtkShadowTriangleMaps::ClusterIfSeenInParts(
  const vtkShadowMapSlot& slot, const vtkShadowScene::Piece& piece, Caster& caster)
{
  const vtkshadows::ShadowMesh<float>& mesh = caster.Mesh;
  const bool isSeenInParts = caster.Clusters.empty() &&
    static_cast<double>(mesh.triangles.size()) > vtkshadows::MostTrianglesInOne &&
    std::any_of(slot.Views.begin(), slot.Views.end(),
      [&piece](const vtkShadowMapView& placed)
      {
        const LightView& view = placed.View;
        return vtkshadows::ShareWithin(view.clipFromView * view.viewFromWorld, piece.CornersWC) <=
          vtkshadows::MostShareSeen;
      });
  if (isSeenInParts)
  {
    caster.Clusters = vtkshadows::ClusterTriangles(
      mesh.points, mesh.triangles, vtkshadows::TrianglesOfCluster, caster.Order);
  }
}

//------------------------------------------------------------------------------
// How many triangles a prop has, at the most, without a look at its mesh.
double vtkShadowTriangleMaps::ExpectedOf(const vtkShadowScene::Prop& prop)
{
  double triangles = 0.0;
  for (const vtkShadowScene::Piece& piece : prop.Pieces)
  {
    if (!piece.DrawnSolid)
    {
      return 0.0; // drawn by its mapper
    }
    triangles += this->Expected.Of(
      piece, [&piece]() { return vtkShadowCasterGeometry::SurveyOf(piece).Triangles; });
  }
  return triangles;
}

//------------------------------------------------------------------------------
bool vtkShadowTriangleMaps::IsTriangles(const vtkShadowScene::Prop& prop)
{
  return std::all_of(prop.Pieces.begin(), prop.Pieces.end(),
    [this](const vtkShadowScene::Piece& piece)
    {
      const double determinant = glm::determinant(glm::dmat3(piece.WorldFromModel));
      return piece.DrawnSolid && std::isfinite(determinant) && determinant != 0.0 &&
        this->CasterOf(piece).IsTriangles;
    });
}

//------------------------------------------------------------------------------
std::vector<std::size_t> vtkShadowTriangleMaps::Update(
  const vtkShadowFrame& frame, const vtkShadowMapViews& views)
{
  const std::vector<vtkShadowScene::Prop>& props = frame.Scene->GetProps();
  this->Casters.BeginFrame(props);
  this->Expected.BeginFrame(props);
  this->DrawnHere.assign(props.size(), 0);
  std::vector<std::vector<std::size_t>> propsOf(views.GetSlots().size());
  std::vector<std::size_t> rooms(views.GetSlots().size(), 0);
  std::size_t total = 0;
  double expected = 0.0;
  for (std::size_t i = 0; i < propsOf.size(); ++i)
  {
    std::vector<std::size_t>& wanted = propsOf[i];
    for (const vtkShadowMapView& view : views.GetSlots()[i].Views)
    {
      wanted.insert(wanted.end(), view.Casters.begin(), view.Casters.end());
    }
    std::sort(wanted.begin(), wanted.end());
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    for (const std::size_t prop : wanted)
    {
      expected += this->ExpectedOf(props[prop]);
    }
  }
  const auto limit = static_cast<double>(std::min<std::size_t>(
    vtkShadowTextureBuffer::LargestSize() / 3, vtkshadows::MostLightTriangles));
  this->Fault.clear();
  if (expected > limit)
  {
    // Their meshes would be gigabytes for nothing.
    this->Fault = std::to_string(static_cast<std::int64_t>(expected)) +
      " triangles of all lights, more than the " +
      std::to_string(static_cast<std::int64_t>(limit)) + " that it takes here";
    std::fill(propsOf.begin(), propsOf.end(), std::vector<std::size_t>());
    this->Casters.BeginFrame({});
  }
  for (std::size_t i = 0; i < propsOf.size(); ++i)
  {
    std::vector<std::size_t>& wanted = propsOf[i];
    wanted.erase(std::remove_if(wanted.begin(), wanted.end(),
                   [&](std::size_t prop) { return !this->IsTriangles(props[prop]); }),
      wanted.end());
    for (const std::size_t prop : wanted)
    {
      for (const vtkShadowScene::Piece& piece : props[prop].Pieces)
      {
        rooms[i] += this->CasterOf(piece).Mesh.triangles.size();
      }
    }
    total += rooms[i];
  }

  if (total > this->Capacity || total < this->Capacity / 4)
  {
    this->Capacity = total;
    this->Parts.clear();
    if (!this->Buffer)
    {
      glGenBuffers(1, &this->Buffer);
      glGenTextures(1, &this->Texture);
    }
    glBindBuffer(GL_TEXTURE_BUFFER, this->Buffer);
    glBufferData(GL_TEXTURE_BUFFER,
      static_cast<GLsizeiptr>(3 * std::max(total, std::size_t(1)) * sizeof(LightCorner)), nullptr,
      GL_DYNAMIC_DRAW);
    glBindBuffer(GL_TEXTURE_BUFFER, 0);
  }

  for (const std::vector<std::size_t>& drawn : propsOf)
  {
    for (const std::size_t prop : drawn)
    {
      this->DrawnHere[prop] = 1;
    }
  }
  this->Places.Update(props, views, propsOf, this->HasPlainCasters(views));
  this->Parts.resize(propsOf.size());
  std::vector<std::size_t> renumbered;
  std::size_t first = 0;
  for (std::size_t i = 0; i < propsOf.size(); ++i)
  {
    Part& part = this->Parts[i];
    const glm::dvec4 light = vtkshadows::HomogeneousLight(views.GetSlots()[i].Light);
    if (part.First != first || part.Room != rooms[i] || part.Props != propsOf[i] ||
      part.Light != light)
    {
      part.Known = false;
    }
    if (!part.Known)
    {
      renumbered.push_back(i);
    }
    part.Light = light;
    part.First = first;
    part.Room = rooms[i];
    part.Props = propsOf[i];
    first += rooms[i];
    this->UpdatePart(frame, views, views.GetSlots()[i], part);
  }
  return renumbered;
}

//------------------------------------------------------------------------------
void vtkShadowTriangleMaps::UpdatePart(const vtkShadowFrame& frame, const vtkShadowMapViews& views,
  const vtkShadowMapSlot& slot, Part& part)
{
  if (part.Room == 0)
  {
    part.Ranges.clear();
    return;
  }
  const glm::dmat4 lightFromWorld = this->Places.LightFromWorld(views, slot);
  const vtkMTimeType stamp = frame.Scene->GetCasterStamp();
  if (part.Known && part.CasterStamp == stamp && part.LightFromWorld == lightFromWorld)
  {
    return;
  }
  part.CasterStamp = stamp;
  part.LightFromWorld = lightFromWorld;
  part.Ranges.clear();

  glBindBuffer(GL_TEXTURE_BUFFER, this->Buffer);
  const auto bytes = static_cast<GLsizeiptr>(3 * part.Room * sizeof(LightCorner));
  auto* corners = static_cast<LightCorner*>(
    glMapBufferRange(GL_TEXTURE_BUFFER, static_cast<GLintptr>(3 * part.First * sizeof(LightCorner)),
      bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_RANGE_BIT));
  std::size_t written = 0;
  for (const std::size_t prop : part.Props)
  {
    for (const vtkShadowScene::Piece& piece : frame.Scene->GetProps()[prop].Pieces)
    {
      Caster& caster = this->CasterOf(piece);
      ClusterIfSeenInParts(slot, piece, caster);
      const glm::dmat4 worldFromCaster = piece.WorldFromModel * caster.ModelFromCaster;
      const LightTriangles triangles(caster.Mesh, caster.Neighbours,
        lightFromWorld * worldFromCaster, glm::inverse(worldFromCaster) * part.Light,
        glm::determinant(glm::dmat3(worldFromCaster)) < 0.0, caster.Order);
      Range range{ prop, part.First + written, triangles.Count(), caster.Clusters,
        worldFromCaster };
      std::size_t first = range.First;
      for (vtkshadows::TriangleCluster& cluster : range.Clusters)
      {
        cluster.count = triangles.CountOf(cluster.first, cluster.count);
        cluster.first = first;
        first += cluster.count;
      }
      if (corners)
      {
        triangles.Write(
          corners + 3 * written, static_cast<std::uint32_t>(part.First + written + 1));
      }
      written += triangles.Count();
      part.Ranges.push_back(std::move(range));
    }
  }
  // Lost memory, as OpenGL allows, is written again with the next frame.
  part.Known = corners && glUnmapBuffer(GL_TEXTURE_BUFFER) == GL_TRUE;
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
}

//------------------------------------------------------------------------------
std::vector<std::size_t> vtkShadowTriangleMaps::PlainCasters(const vtkShadowMapView& view) const
{
  std::vector<std::size_t> plain;
  std::copy_if(view.Casters.begin(), view.Casters.end(), std::back_inserter(plain),
    [this](std::size_t prop) { return this->IsPlain(prop); });
  return plain;
}

bool vtkShadowTriangleMaps::HasPlainCasters(const vtkShadowMapViews& views) const
{
  for (const vtkShadowMapSlot& slot : views.GetSlots())
  {
    if (std::any_of(slot.Views.begin(), slot.Views.end(),
          [this](const vtkShadowMapView& view)
          {
            return std::any_of(view.Casters.begin(), view.Casters.end(),
              [this](std::size_t prop) { return this->IsPlain(prop); });
          }))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkShadowTriangleMaps::Draw(const vtkShadowFrame& frame, const vtkShadowTextureArray& depths,
  int depthLayer, std::size_t slot, const vtkShadowMapView& view, bool hasPlain, int width,
  int height)
{
  vtkShadowDrawScope target(frame.Window, depths, depthLayer, &this->Numbers, view.Layer);
  // A number is asked for where something was drawn. Where that was not from here, it must be 0;
  // else what an earlier map left there is nowhere looked up.
  if (hasPlain)
  {
    target.ClearColour(nullptr);
  }
  target.Confine(width, height, 1);
  const Part& part = this->Parts[slot];
  const glm::dmat4 clipFromWorld = view.View.clipFromView * view.View.viewFromWorld;
  vtkshadows::TriangleRanges ranges;
  for (const Range& range : part.Ranges)
  {
    if (!std::binary_search(view.Casters.begin(), view.Casters.end(), range.Prop))
    {
      continue;
    }
    if (range.Clusters.empty())
    {
      ranges.Add(range.First, range.Count);
    }
    ranges.AddSeen(range.Clusters, clipFromWorld * range.WorldFromCaster);
  }
  if (ranges.Get().empty())
  {
    return;
  }
  std::vector<GLint> firsts;
  std::vector<GLsizei> counts;
  for (const vtkshadows::TriangleRange& range : ranges.Get())
  {
    firsts.push_back(static_cast<GLint>(3 * range.first));
    counts.push_back(static_cast<GLsizei>(3 * range.count));
  }

  vtkShaderProgram* program = frame.Window->GetShaderCache()->ReadyShaderProgram(
    vtkShadowTriangleMapsVS, vtkShadowTriangleMapsFS, "");
  std::array<float, 16> clipFromLight = vtkShadowMatrix::ToFloats(this->Places.IsDirect()
      ? ClipFromMap(width, height)
      : clipFromWorld * glm::inverse(part.LightFromWorld));
  program->SetUniformMatrix4x4("shadowClipFromLight", clipFromLight.data());
  // What lies before the near plane still casts.
  glEnable(GL_DEPTH_CLAMP);
  const vtkShadowVertexArray corners(this->Buffer);
  corners.AddFloats(program, "shadowCorner", 3, sizeof(LightCorner));
  glMultiDrawArrays(
    GL_TRIANGLES, firsts.data(), counts.data(), static_cast<GLsizei>(firsts.size()));
  glDisable(GL_DEPTH_CLAMP);
}

//------------------------------------------------------------------------------
void vtkShadowTriangleMaps::Activate()
{
  this->Numbers.Activate();
  if (this->BoundTo.Bind(this->Window, GL_TEXTURE_BUFFER, this->Texture))
  {
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, this->Buffer);
  }
}

void vtkShadowTriangleMaps::Deactivate()
{
  this->Numbers.Deactivate();
  this->BoundTo.Free(this->Window, GL_TEXTURE_BUFFER);
}

//------------------------------------------------------------------------------
void vtkShadowTriangleMaps::SetParameters(vtkShaderProgram* program) const
{
  program->SetUniformi("shadowDepthMapNumbers", this->Numbers.Unit());
  program->SetUniformi("shadowDepthMapCorners", this->BoundTo.Get());
  this->Places.SetParameters(program);
}

//------------------------------------------------------------------------------
std::size_t vtkShadowTriangleMaps::CasterBytes() const
{
  std::size_t bytes = this->Buffer ? 3 * this->Capacity * sizeof(LightCorner) : 0;
  this->Casters.ForEach(
    [&bytes](const Caster& caster)
    {
      bytes += caster.Mesh.MemoryInBytes() +
        caster.Neighbours.size() * sizeof(vtkshadows::TriangleNeighbours) +
        caster.Order.size() * sizeof(std::uint32_t);
    });
  return bytes;
}

//------------------------------------------------------------------------------
void vtkShadowTriangleMaps::Release()
{
  this->Numbers.Release();
  if (this->Buffer && this->Window)
  {
    this->Window->MakeCurrent();
    glDeleteTextures(1, &this->Texture);
    glDeleteBuffers(1, &this->Buffer);
  }
  this->Buffer = 0;
  this->Texture = 0;
  this->Capacity = 0;
  this->Parts.clear();
  this->Window = nullptr;
}
