#include "vtkShadowObjects.h"

#include "ConnectedPieces.h"
#include "vtkShadowCasterGeometry.h"
#include "vtkShadowTextureBuffer.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#if __has_include("vtkCompositeMapperHelper2.h")
#include "vtkCompositeMapperHelper2.h"
#endif
#if __has_include("vtkOpenGLBatchedPolyDataMapper.h")
#include "vtkOpenGLBatchedPolyDataMapper.h"
#endif

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace
{

using vtkshadows::BoxCorners;
using vtkshadows::LightView;

// A protected member that says how many vertices a mapper hands to OpenGL, by name of a derived
// class.
struct MapperAccess : vtkOpenGLPolyDataMapper
{
  static vtkOpenGLVertexBufferObjectGroup* Buffers(vtkOpenGLPolyDataMapper* m)
  {
    return m->*(&MapperAccess::VBOs);
  }
};

BoxCorners CornersOf(const double bounds[6])
{
  BoxCorners corners;
  for (int i = 0; i < 8; ++i)
  {
    corners[i] = { bounds[i & 1], bounds[2 + ((i >> 1) & 1)], bounds[4 + ((i >> 2) & 1)] };
  }
  return corners;
}

BoxCorners CornersOf(vtkPolyData* mesh)
{
  double bounds[6];
  mesh->GetPoints()->GetBounds(bounds);
  return CornersOf(bounds);
}

bool HasPoints(vtkPolyData* mesh)
{
  return mesh && mesh->GetPoints() && mesh->GetPoints()->GetNumberOfPoints() > 0;
}

// The meshes that a mapper hands to OpenGL as they are: its input, or the blocks of that.
std::vector<vtkPolyData*> MeshesOf(vtkMapper* mapper)
{
  std::vector<vtkPolyData*> meshes;
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  const auto add = [&meshes](vtkDataObject* data)
  {
    auto* mesh = vtkPolyData::SafeDownCast(data);
    if (HasPoints(mesh) && std::find(meshes.begin(), meshes.end(), mesh) == meshes.end())
    {
      meshes.push_back(mesh);
    }
  };
  if (auto* tree = vtkDataObjectTree::SafeDownCast(input))
  {
    auto it = vtk::TakeSmartPointer(tree->NewTreeIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      add(it->GetCurrentDataObject());
    }
  }
  else
  {
    add(input);
  }
  return meshes;
}

// Its vertices are not the points of its input.
bool DrawsImpostors(vtkMapper* mapper)
{
  return mapper->IsA("vtkOpenGLSphereMapper") || mapper->IsA("vtkOpenGLStickMapper") ||
    mapper->IsA("vtkPointGaussianMapper");
}

// The meshes whose points are the vertices that `mapper` draws, in their order; a composite's
// blocks are drawn by mappers of its own.
std::vector<vtkPolyData*> DrawnMeshes(vtkOpenGLPolyDataMapper* mapper)
{
#if __has_include("vtkCompositeMapperHelper2.h")
  if (auto* helper = vtkCompositeMapperHelper2::SafeDownCast(mapper))
  {
    return helper->GetRenderedList();
  }
#endif
#if __has_include("vtkOpenGLBatchedPolyDataMapper.h")
  if (auto* batch = vtkOpenGLBatchedPolyDataMapper::SafeDownCast(mapper))
  {
    return batch->GetRenderedList();
  }
#endif
  return { mapper->CurrentInput };
}

// Whether a mesh is a shallow copy of another one.
bool IsCopyOf(vtkPolyData* mesh, vtkPolyData* drawn)
{
  return mesh->GetPoints() == drawn->GetPoints() && mesh->GetPolys() == drawn->GetPolys() &&
    mesh->GetStrips() == drawn->GetStrips() && mesh->GetLines() == drawn->GetLines() &&
    mesh->GetVerts() == drawn->GetVerts();
}

// Of `meshes`, the one that `drawn` is, or is a shallow copy of.
template <typename Meshes>
auto OriginalOf(const Meshes& meshes, vtkPolyData* drawn)
{
  const auto known = meshes.find(drawn);
  return known != meshes.end()
    ? known
    : std::find_if(meshes.begin(), meshes.end(),
        [drawn](const auto& entry) { return IsCopyOf(entry.first, drawn); });
}

void JoinCells(vtkshadows::ConnectedPieces& pieces, vtkCellArray* cells)
{
  auto it = vtk::TakeSmartPointer(cells->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    it->GetCurrentCell(size, ids);
    for (vtkIdType i = 1; i < size; ++i)
    {
      pieces.Join(static_cast<std::size_t>(ids[0]), static_cast<std::size_t>(ids[i]));
    }
  }
}

// Distances from the light, along its view.
struct Reach
{
  double Nearest = std::numeric_limits<double>::infinity();
  double Farthest = -std::numeric_limits<double>::infinity();
};

// Where a view begins and ends, distances before the light.
void RangeOf(const LightView& view, double& nearest, double& farthest)
{
  const glm::dmat4 viewFromClip = glm::inverse(view.clipFromView);
  const glm::dvec4 begin = viewFromClip * glm::dvec4(0.0, 0.0, -1.0, 1.0);
  const glm::dvec4 end = viewFromClip * glm::dvec4(0.0, 0.0, 1.0, 1.0);
  nearest = -begin.z / begin.w;
  farthest = -end.z / end.w;
}

// The window-space depth at `distance` before the light, 0 nearer than the view begins, 1 beyond.
double DepthAt(const LightView& view, double distance)
{
  const glm::dvec4 clip = view.clipFromView * glm::dvec4(0.0, 0.0, -distance, 1.0);
  return clip.w > 0.0 ? std::clamp(0.5 + 0.5 * clip.z / clip.w, 0.0, 1.0) : 0.0;
}

}

//------------------------------------------------------------------------------
struct vtkShadowObjects::VertexTable
{
  std::vector<float> IDs; // empty: its draws are one object
  vtkShadowTextureBuffer Texture;
  vtkMTimeType Checked = 0; // the caster stamp that it was last checked for
  std::vector<vtkPolyData*> Meshes;
};

vtkShadowObjects::vtkShadowObjects() = default;
vtkShadowObjects::~vtkShadowObjects() = default;

//------------------------------------------------------------------------------
int vtkShadowObjects::GetNumberOfIDs() const
{
  return 1 + std::min(this->Count, this->MostIDs);
}

//------------------------------------------------------------------------------
bool vtkShadowObjects::Update(const vtkShadowScene& scene, Kind kind, int mostIDs)
{
  if (this->Known && this->Stamp == scene.GetCasterStamp() && this->Of == kind &&
    this->MostIDs == mostIDs)
  {
    return false;
  }
  const bool isOther = !this->Known || this->Of != kind || this->MostIDs != mostIDs;
  this->Known = true;
  this->Stamp = scene.GetCasterStamp();
  this->Of = kind;
  this->MostIDs = mostIDs;
  this->Count = 0;
  this->Boxes.clear();
  this->Entries.clear();
  this->OwnersByKeys.clear();
  if (isOther)
  {
    this->Tables.clear();
  }
  this->Split.BeginFrame(scene.GetProps());
  for (const vtkShadowScene::Prop& prop : scene.GetProps())
  {
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      if (prop.Casts)
      {
        this->AddPiece(prop, piece);
      }
    }
  }
  for (auto table = this->Tables.begin(); table != this->Tables.end();)
  {
    table =
      this->Entries.count(table->first.second) != 0 ? std::next(table) : this->Tables.erase(table);
  }
  // What casts by a stand-in is one object with it.
  for (const vtkShadowScene::Prop& prop : scene.GetProps())
  {
    if (!prop.StandsInFor || prop.Pieces.empty())
    {
      continue;
    }
    const int whole = this->Entries[prop.Pieces.front().Prop].Whole;
    for (const vtkShadowScene::Prop& other : scene.GetProps())
    {
      for (const vtkShadowScene::Piece& piece : other.Pieces)
      {
        if (other.Source == prop.StandsInFor)
        {
          this->Entries[piece.Prop].Whole = whole;
          this->OwnersByKeys.emplace(piece.Prop->GetPropertyKeys(), piece.Prop);
        }
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowObjects::AddPiece(
  const vtkShadowScene::Prop& prop, const vtkShadowScene::Piece& piece)
{
  // Lines and points reach beyond the bounds of their points by their width.
  auto* actor = vtkActor::SafeDownCast(piece.Prop);
  const double beyond = 1.0 +
    (actor ? std::max(actor->GetProperty()->GetLineWidth(), actor->GetProperty()->GetPointSize())
           : 0.0f);
  Entry& entry = this->Entries[piece.Prop];
  const bool isFirst = entry.Whole < 0;
  if (isFirst)
  {
    entry.Whole = this->Count++;
  }
  this->Boxes.push_back({ entry.Whole, piece.CornersWC, beyond });
  this->OwnersByKeys.emplace(piece.Prop->GetPropertyKeys(), piece.Prop);
  if (!isFirst)
  {
    // The same prop in several places is drawn without a word of which.
    entry.Meshes.clear();
    entry.GlyphDraws.clear();
    return;
  }
  if (piece.Mapper->IsA("vtkGlyph3DMapper"))
  {
    if (this->Of >= Blocks)
    {
      this->AddGlyphs(entry, piece, beyond);
    }
  }
  else if (this->Of >= Blocks && !prop.Impostors && !DrawsImpostors(piece.Mapper))
  {
    this->AddMeshes(entry, piece, beyond);
  }
}

//------------------------------------------------------------------------------
void vtkShadowObjects::AddMeshes(Entry& entry, const vtkShadowScene::Piece& piece, double beyond)
{
  const std::vector<vtkPolyData*> meshes = MeshesOf(piece.Mapper);
  const bool isComposite =
    vtkDataObjectTree::SafeDownCast(piece.Mapper->GetInputDataObject(0, 0)) != nullptr;
  if (this->Of < Pieces)
  {
    for (vtkPolyData* mesh : meshes)
    {
      if (isComposite)
      {
        entry.Meshes[mesh].First = this->Count;
        this->AddBox(this->Count++, piece.WorldFromModel, CornersOf(mesh), beyond);
      }
    }
    return;
  }
  const PiecesByMesh& split = this->Split.Of(piece,
    [&meshes]()
    {
      PiecesByMesh pieces;
      for (vtkPolyData* mesh : meshes)
      {
        std::vector<glm::dvec3> points(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
        for (std::size_t i = 0; i < points.size(); ++i)
        {
          mesh->GetPoints()->GetPoint(static_cast<vtkIdType>(i), &points[i].x);
        }
        vtkshadows::ConnectedPieces connected(points);
        for (vtkCellArray* cells :
          { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
        {
          JoinCells(connected, cells);
        }
        std::size_t count = 0;
        MeshPieces& found = pieces[mesh];
        found.OfPoint = connected.Number(count);
        const double infinity = std::numeric_limits<double>::infinity();
        std::vector<glm::dvec3> low(count, glm::dvec3(infinity)),
          high(count, -glm::dvec3(infinity));
        for (std::size_t i = 0; i < points.size(); ++i)
        {
          const std::uint32_t at = found.OfPoint[i];
          low[at] = glm::min(low[at], points[i]);
          high[at] = glm::max(high[at], points[i]);
        }
        for (std::size_t i = 0; i < count; ++i)
        {
          const double bounds[6] = { low[i].x, high[i].x, low[i].y, high[i].y, low[i].z,
            high[i].z };
          found.CornersMC.push_back(CornersOf(bounds));
        }
      }
      return pieces;
    });
  for (const auto& known : split)
  {
    Mesh& mesh = entry.Meshes[known.first];
    mesh.First = this->Count;
    mesh.Pieces = &known.second;
    for (const BoxCorners& corners : known.second.CornersMC)
    {
      this->AddBox(this->Count++, piece.WorldFromModel, corners, beyond);
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowObjects::AddGlyphs(Entry& entry, const vtkShadowScene::Piece& piece, double beyond)
{
  auto* mapper = vtkGlyph3DMapper::SafeDownCast(piece.Mapper);
  const bool areApart = this->Of >= Instances;
  const bool isComposite = !vtkDataSet::SafeDownCast(piece.Mapper->GetInputDataObject(0, 0));
  // With level of detail, instances are drawn in an order that the GPU finds.
  if (!mapper || mapper->GetCullingAndLOD() || (!areApart && !isComposite))
  {
    return;
  }
  vtkDataSet* block = nullptr;
  int object = 0;
  for (const vtkShadowCasterGeometry::GlyphDraw& draw :
    vtkShadowCasterGeometry::GlyphDrawsOf(mapper))
  {
    if (!HasPoints(draw.Source))
    {
      continue;
    }
    if (areApart || draw.Points != block)
    {
      object = this->Count++;
      block = draw.Points;
    }
    entry.GlyphDraws.push_back({ draw.Source, object });
    const BoxCorners corners = CornersOf(draw.Source);
    for (std::size_t i = 0; i < draw.ModelFromGlyph.size(); ++i)
    {
      object = areApart && i > 0 ? this->Count++ : object;
      this->AddBox(object, piece.WorldFromModel * draw.ModelFromGlyph[i], corners, beyond);
    }
  }
}

//------------------------------------------------------------------------------
// VTK has a mapper for each source at each block, and says nothing of which is whose: it is told by
// the order in which they are met. The blocks of a frame are drawn by an actor that lives no longer
// than their drawing, so that another one means that it begins.
const vtkShadowObjects::GlyphDraw* vtkShadowObjects::GlyphDrawOf(
  Entry& entry, vtkOpenGLPolyDataMapper* mapper, vtkProp* drawer)
{
  const std::vector<GlyphDraw>& draws = entry.GlyphDraws;
  const auto isOf = [mapper](const GlyphDraw& draw)
  { return IsCopyOf(draw.Source, mapper->CurrentInput); };
  if (entry.Drawer != drawer)
  {
    entry.Drawer = drawer;
    entry.Met.clear();
    entry.Next = 0;
  }
  const auto met = entry.Met.find(mapper);
  if (met != entry.Met.end() && isOf(draws[met->second]))
  {
    return &draws[met->second];
  }
  auto found = std::find_if(std::next(draws.begin(), entry.Next), draws.end(), isOf);
  if (found == draws.end())
  {
    entry.Met.clear();
    found = std::find_if(draws.begin(), draws.end(), isOf);
  }
  if (found == draws.end())
  {
    return nullptr;
  }
  const auto index = std::distance(draws.begin(), found);
  entry.Met[mapper] = static_cast<std::size_t>(index);
  entry.Next = index + 1;
  return &*found;
}

//------------------------------------------------------------------------------
void vtkShadowObjects::AddBox(
  int object, const glm::dmat4& worldFromModel, const BoxCorners& cornersMC, double beyond)
{
  Box box{ object, cornersMC, beyond };
  for (glm::dvec3& corner : box.CornersWC)
  {
    corner = glm::dvec3(worldFromModel * glm::dvec4(corner, 1.0));
  }
  this->Boxes.push_back(box);
}

//------------------------------------------------------------------------------
std::vector<glm::vec4> vtkShadowObjects::RangesIn(const LightView& view, int texels) const
{
  // A texel's width, or in perspective its share of the distance.
  const double width = 2.0 / (view.clipFromView[0][0] * std::max(texels, 1));
  std::vector<Reach> reaches(static_cast<std::size_t>(this->GetNumberOfIDs()));
  for (const Box& box : this->Boxes)
  {
    Reach& reach = reaches[static_cast<std::size_t>(this->IDOf(box.Object))];
    for (const glm::dvec3& corner : box.CornersWC)
    {
      const double distance = -(view.viewFromWorld * glm::dvec4(corner, 1.0)).z;
      const double beyond = box.Beyond * width * (view.parallel ? 1.0 : std::abs(distance));
      reach.Nearest = std::min(reach.Nearest, distance - beyond);
      reach.Farthest = std::max(reach.Farthest, distance + beyond);
    }
  }
  double begin = 0.0, end = 0.0;
  RangeOf(view, begin, end);
  std::vector<glm::vec4> ranges(reaches.size(), glm::vec4(1.0f, 0.0f, 1.0f, 0.0f));
  for (std::size_t i = 1; i < reaches.size(); ++i)
  {
    if (reaches[i].Nearest <= reaches[i].Farthest)
    {
      const double nearest = DepthAt(view, reaches[i].Nearest);
      const double share =
        std::clamp(reaches[i].Nearest, begin, end) / std::clamp(reaches[i].Farthest, begin, end);
      ranges[i] = glm::vec4(
        nearest, DepthAt(view, reaches[i].Farthest) - nearest, view.parallel ? 1.0 : share, 0.0);
    }
  }
  return ranges;
}

//------------------------------------------------------------------------------
vtkShadowObjects::Draw vtkShadowObjects::DrawOf(
  vtkOpenGLRenderWindow* window, vtkAbstractMapper* mapper, vtkProp* prop)
{
  Draw draw;
  auto known = this->Entries.find(prop);
  if (known == this->Entries.end())
  {
    const auto owner = this->OwnersByKeys.find(prop->GetPropertyKeys());
    known =
      owner != this->OwnersByKeys.end() ? this->Entries.find(owner->second) : this->Entries.end();
  }
  if (known == this->Entries.end())
  {
    return draw;
  }
  Entry& entry = known->second;
  draw.First = entry.Whole;
  draw.Whole = this->IDOf(entry.Whole);
  auto* drawing = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  if (!drawing)
  {
    return draw;
  }
  if (!entry.GlyphDraws.empty() && drawing->CurrentInput)
  {
    if (const GlyphDraw* glyphs = GlyphDrawOf(entry, drawing, prop))
    {
      draw.First = glyphs->First;
      draw.PerInstance = this->Of >= Instances ? 1 : 0;
    }
  }
  else if (!entry.Meshes.empty())
  {
    draw.OfVertices = this->TableOf(window, mapper, known->first, entry);
  }
  return draw;
}

//------------------------------------------------------------------------------
vtkShadowTextureBuffer* vtkShadowObjects::TableOf(
  vtkOpenGLRenderWindow* window, vtkAbstractMapper* mapper, vtkProp* prop, const Entry& entry)
{
  auto* drawing = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  const std::vector<vtkPolyData*> meshes = DrawnMeshes(drawing);
  std::unique_ptr<VertexTable>& table = this->Tables[{ mapper, prop }];
  if (!table)
  {
    table.reset(new VertexTable);
  }
  if (table->Checked == this->Stamp && table->Meshes == meshes &&
    (table->IDs.empty() || table->Texture.IsOf(window)))
  {
    return table->IDs.empty() ? nullptr : &table->Texture;
  }

  std::vector<float> ids;
  for (vtkPolyData* mesh : meshes)
  {
    if (!HasPoints(mesh))
    {
      continue;
    }
    const auto known = OriginalOf(entry.Meshes, mesh);
    const auto points = static_cast<std::size_t>(mesh->GetNumberOfPoints());
    for (std::size_t i = 0; i < points; ++i)
    {
      const bool isWhole = known == entry.Meshes.end();
      const MeshPieces* pieces = isWhole ? nullptr : known->second.Pieces;
      const int object = isWhole
        ? entry.Whole
        : known->second.First + (pieces ? static_cast<int>(pieces->OfPoint[i]) : 0);
      ids.push_back(static_cast<float>(this->IDOf(object)));
    }
  }
  // Vertices that are not these points, or more than a table holds, are one object.
  const auto vertices =
    static_cast<std::size_t>(MapperAccess::Buffers(drawing)->GetNumberOfTuples("vertexMC"));
  if (ids.size() != vertices || ids.size() > vtkShadowTextureBuffer::LargestSize())
  {
    ids.clear();
  }
  if (!ids.empty() && (ids != table->IDs || !table->Texture.IsOf(window)))
  {
    table->Texture.Upload(window, 1, ids);
  }
  table->Checked = this->Stamp;
  table->Meshes = meshes;
  table->IDs = std::move(ids);
  return table->IDs.empty() ? nullptr : &table->Texture;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowObjects::Bytes() const
{
  std::size_t bytes = this->Boxes.size() * sizeof(Box);
  for (const auto& table : this->Tables)
  {
    bytes += table.second->IDs.size() * sizeof(float) + table.second->Texture.Bytes();
  }
  this->Split.ForEach(
    [&bytes](const PiecesByMesh& meshes)
    {
      for (const auto& mesh : meshes)
      {
        bytes += mesh.second.OfPoint.size() * sizeof(std::uint32_t) +
          mesh.second.CornersMC.size() * sizeof(vtkshadows::BoxCorners);
      }
    });
  return bytes;
}

//------------------------------------------------------------------------------
void vtkShadowObjects::Release()
{
  this->Tables.clear();
}
