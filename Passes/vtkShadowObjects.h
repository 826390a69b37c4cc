// The objects of a scene's casters, their IDs, and how each draw of a mapper tells what it draws.
// An object is a prop, a block of a composite, a glyph's instance or a connected piece of a mesh.
#ifndef vtkShadowObjects_h
#define vtkShadowObjects_h

#include "vtkShadowByPiece.h"
#include "vtkShadowSceneData.h"

#include "vtkProp.h"
#include "vtkWeakPointer.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

class vtkAbstractMapper;
class vtkInformation;
class vtkOpenGLPolyDataMapper;
class vtkOpenGLRenderWindow;
class vtkPolyData;
class vtkShadowTextureBuffer;

class vtkShadowObjects
{
public:
  // Each kind has those before it, too.
  enum Kind
  {
    Props,
    Blocks,    // of composite data sets
    Instances, // of glyphs
    Pieces     // of meshes and blocks, connected by points
  };

  // Nothing has an ID, and what is empty in a map.
  static constexpr int NoID = 0;

  vtkShadowObjects();
  ~vtkShadowObjects();

  // Number the objects of the casters, from 1 to at most `mostIDs`, which further ones share. The
  // same casters (by their stamp) have the same IDs. True if the IDs changed.
  bool Update(const vtkShadowScene& scene, Kind kind, int mostIDs);

  int GetNumberOfObjects() const { return this->Count; }
  // IDs that there are, NoID included.
  int GetNumberOfIDs() const;

  // By ID: the nearest depth, window space, that anything of it has in a view; how far the farthest
  // lies from it; and the nearest distance over the farthest, 1 in a parallel view. The fourth is
  // not used. `texels`: of the map's width. NoID lies at 1.
  std::vector<glm::vec4> RangesIn(const vtkshadows::LightView& view, int texels) const;

  // What a draw of `prop` by `mapper` is told.
  struct Draw
  {
    int Whole = NoID;    // the ID of all of it
    int First = -1;      // object of instance 0; below 0: none
    int PerInstance = 0; // 1: instance i is object First + i
    // By vertex, if there is one: its ID.
    vtkShadowTextureBuffer* OfVertices = nullptr;
  };
  Draw DrawOf(vtkOpenGLRenderWindow* window, vtkAbstractMapper* mapper, vtkProp* prop);
  int GetMostIDs() const { return this->MostIDs; }

  // Forget the tables of vertices.
  void Release();

  // What it has of the casters: tables of vertices, and boxes.
  std::size_t Bytes() const;

private:
  // A box of an object; several may have the same.
  struct Box
  {
    int Object;
    vtkshadows::BoxCorners CornersWC;
    double Beyond; // texels that it may reach farther: lines and points
  };
  // The connected pieces of a mesh, in its own coordinates.
  struct MeshPieces
  {
    std::vector<std::uint32_t> OfPoint;
    std::vector<vtkshadows::BoxCorners> CornersMC;
  };
  using PiecesByMesh = std::map<vtkPolyData*, MeshPieces>;
  // The objects of a mesh: one, or one for each piece.
  struct Mesh
  {
    int First = 0;
    const MeshPieces* Pieces = nullptr;
  };
  // What a glyph mapper draws at once: a source at the points of a block.
  struct GlyphDraw
  {
    vtkPolyData* Source;
    int First; // object of instance 0, or of them all
  };
  // A prop that casts.
  struct Entry
  {
    int Whole = -1;
    std::map<vtkPolyData*, Mesh> Meshes;
    std::vector<GlyphDraw> GlyphDraws; // in VTK's order
    // Which of these are of which mapper, as far as they were met since `Drawer` began.
    std::map<vtkAbstractMapper*, std::size_t> Met;
    vtkWeakPointer<vtkProp> Drawer;
    std::ptrdiff_t Next = 0; // the first that was not met
  };
  struct VertexTable;

  int IDOf(int object) const { return 1 + object % this->MostIDs; }
  void AddPiece(const vtkShadowScene::Prop& prop, const vtkShadowScene::Piece& piece);
  void AddMeshes(Entry& entry, const vtkShadowScene::Piece& piece, double beyond);
  void AddGlyphs(Entry& entry, const vtkShadowScene::Piece& piece, double beyond);
  static const GlyphDraw* GlyphDrawOf(
    Entry& entry, vtkOpenGLPolyDataMapper* mapper, vtkProp* drawer);
  void AddBox(int object, const glm::dmat4& worldFromModel, const vtkshadows::BoxCorners& cornersMC,
    double beyond);
  vtkShadowTextureBuffer* TableOf(
    vtkOpenGLRenderWindow* window, vtkAbstractMapper* mapper, vtkProp* prop, const Entry& entry);

  bool Known = false;
  vtkMTimeType Stamp = 0; // of the casters
  Kind Of = Props;
  int MostIDs = 1;
  int Count = 0;
  std::vector<Box> Boxes;
  std::unordered_map<vtkProp*, Entry> Entries;
  // Of the actors that mappers and ParaView's props draw by in a prop's place.
  std::unordered_map<vtkInformation*, vtkProp*> OwnersByKeys;
  vtkShadowByPiece<PiecesByMesh> Split;
  std::map<std::pair<vtkAbstractMapper*, vtkProp*>, std::unique_ptr<VertexTable>> Tables;
};

#endif
