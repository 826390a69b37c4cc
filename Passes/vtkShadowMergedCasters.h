// Small casters drawn from a light in one go, from one list of their triangles, and of large ones
// what the view sees. Each mapper's draw has a cost of its own, whatever it draws, which hundreds
// of props pay for every map; and draws all of its mesh, be it for a cascade that holds a
// hundredth.
//
// The list holds the very floats that mappers hand to OpenGL, and a matrix a piece takes them to
// the light's clip space, as a mapper's does: the picture is the one that mappers draw. It grows as
// casters are drawn for the second time in the same shape, so what is drawn once only, or changes
// its shape all the time, is left to its mapper.
#ifndef vtkShadowMergedCasters_h
#define vtkShadowMergedCasters_h

#include "TriangleClusters.h"
#include "vtkShadowByPiece.h"
#include "vtkShadowTextureBuffer.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

struct vtkShadowFrame;

class vtkShadowMergedCasters
{
public:
  // Small props, of at most vtkshadows::MostTrianglesInOne, are drawn with others; so few of them
  // are left to their mappers.
  static constexpr std::size_t FewestProps = 4;
  // A large one is drawn from the list once a view sees less than vtkshadows::MostShareSeen of its
  // bounds. Of each, clusters are left out that lie beside a view.
  static constexpr double MostTrianglesOfLarge = 2.0e6;

  vtkShadowMergedCasters() = default;
  ~vtkShadowMergedCasters();
  vtkShadowMergedCasters(const vtkShadowMergedCasters&) = delete;
  void operator=(const vtkShadowMergedCasters&) = delete;

  // A new frame: what is known of props that are gone is forgotten.
  void BeginFrame(const vtkShadowFrame& frame);

  // Draws those of `casters`, indices into the scene's props, that are in the list into what is
  // bound: depth, and as a colour (1, depth, 1, 1). `culled`: faces, GL_FRONT or GL_BACK, that need
  // not be drawn of a part. Returns the others, for the caller to draw.
  std::vector<std::size_t> Draw(const vtkShadowFrame& frame,
    const std::vector<std::size_t>& casters, const vtkshadows::LightView& view,
    const std::unordered_map<vtkProp*, unsigned int>& culled, bool writesDepth);

  // Of the draws of all views of this frame together.
  int GetNumberDrawn() const { return this->NumberDrawn; }

  std::size_t Bytes() const;
  void Release();

private:
  struct Vertex
  {
    glm::vec3 Position;
    std::uint32_t Matrix; // its number
  };
  // A piece, and where in the list it is.
  struct Caster
  {
    enum
    {
      New,
      Drawn, // by its mapper
      Fit,   // for the list, as far as is known without its triangles
      Listed,
      Unfit
    } State = New;
    unsigned int DrawnFirst = 0; // the frame
    bool IsLarge = false;
    std::uint32_t Matrix = 0;
    std::size_t First = 0, Triangles = 0; // in the list
    std::vector<vtkshadows::TriangleCluster> Clusters;
    glm::dmat4 ModelFromCaster{ 1.0 };
  };
  // An OpenGL buffer that grows and keeps what it holds.
  struct List
  {
    unsigned int Buffer = 0;
    std::size_t Used = 0, Capacity = 0; // bytes

    void Append(const void* data, std::size_t bytes);
  };

  Caster* ReadyCaster(const vtkShadowScene::Prop& prop, const glm::dmat4& clipFromWorld);
  void Enlist(const vtkShadowScene::Piece& piece, Caster& caster);
  void DrawRanges(const vtkShadowFrame& frame, bool writesDepth);

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkShadowByPiece<Caster> Casters;
  List Vertices, Indices;
  std::uint32_t NumberOfMatrices = 0;
  int NumberDrawn = 0;
  unsigned int FrameNumber = 0;

  // Of one draw.
  std::vector<float> Matrices;
  vtkShadowTextureBuffer MatrixTexture;
  // All faces, all but front ones, all but back ones.
  std::array<vtkshadows::TriangleRanges, 3> Drawn;
};

#endif
