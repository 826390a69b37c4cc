// Beside depth maps: which triangle each texel shows, and the triangles themselves as their light
// sees them, each with its neighbours. What filter "exact" of vtkDepthShadowMapPass looks up.
//
// Casters of which every piece is triangles are drawn from here, by their numbers. Others
// (impostors, lines, wireframes, textures with holes) are drawn by their mappers, under the number
// 0: of those only the depth is known.
#ifndef vtkShadowTriangleMaps_h
#define vtkShadowTriangleMaps_h

#include "LightTriangles.h"
#include "TriangleClusters.h"
#include "vtkShadowByPiece.h"
#include "vtkShadowMapViews.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowTrianglePlaces.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkShaderProgram;

class vtkShadowTriangleMaps
{
public:
  vtkShadowTriangleMaps() = default;
  ~vtkShadowTriangleMaps();
  vtkShadowTriangleMaps(const vtkShadowTriangleMaps&) = delete;
  void operator=(const vtkShadowTriangleMaps&) = delete;

  // Room for the numbers of `layers` maps; true if what was in them is lost. IsReady() afterwards
  // says whether there is memory for them.
  bool Reserve(vtkOpenGLRenderWindow* window, int width, int height, int layers);
  bool IsReady() const { return this->Numbers.Id() != 0; }

  // Brings the triangles of all lights up to date, once their views have layers. What the driver
  // cannot hold is drawn by the mappers; then GetFault() says so. Slots whose triangles have other
  // numbers than before: their maps must be drawn again.
  std::vector<std::size_t> Update(const vtkShadowFrame& frame, const vtkShadowMapViews& views);
  const std::string& GetFault() const { return this->Fault; }

  // Draws the casters of a view into a layer of `depths` and into its layer of the numbers.
  // The caller has drawn PlainCasters ahead of this; hasPlain: there are any.
  void Draw(const vtkShadowFrame& frame, const vtkShadowTextureArray& depths, int depthLayer,
    std::size_t slot, const vtkShadowMapView& view, bool hasPlain, int width, int height);
  // Casters of the view, among the scene's props, that are not drawn from here.
  std::vector<std::size_t> PlainCasters(const vtkShadowMapView& view) const;

  // Grows when shaders must be written anew, with Declarations() ahead of the lookup's text.
  std::string Declarations() const { return this->Places.Declarations(); }
  bool TakeShaderChange() { return this->Places.TakeShaderChange(); }
  void Activate();
  void Deactivate();
  void SetParameters(vtkShaderProgram* program) const;

  void Release();

  // Of the numbers; and of the casters' triangles, with neighbours, here and in the list.
  std::size_t TextureBytes() const { return this->Numbers.Bytes(); }
  std::size_t CasterBytes() const;

private:
  // The triangles of a piece, without edges but with neighbours.
  struct Caster
  {
    bool IsTriangles = false;
    vtkshadows::ShadowMesh<float> Mesh;
    std::vector<vtkshadows::TriangleNeighbours> Neighbours;
    glm::dmat4 ModelFromCaster{ 1.0 };
    // Once a view sees a part of a large one.
    std::vector<std::uint32_t> Order; // of the triangles
    std::vector<vtkshadows::TriangleCluster> Clusters;
  };
  // A piece of a prop in the list: triangles.
  struct Range
  {
    std::size_t Prop = 0;
    std::size_t First = 0, Count = 0;
    // Of those in the list, if it is clustered.
    std::vector<vtkshadows::TriangleCluster> Clusters;
    glm::dmat4 WorldFromCaster{ 1.0 };
  };
  // What the list has for a slot, and what that was made from.
  struct Part
  {
    bool Known = false;
    glm::dvec4 Light{ 0.0 }; // homogeneous
    glm::dmat4 LightFromWorld{ 1.0 };
    vtkMTimeType CasterStamp = 0;
    std::vector<std::size_t> Props;
    std::size_t First = 0, Room = 0; // triangles
    std::vector<Range> Ranges;
  };
  Caster& CasterOf(const vtkShadowScene::Piece& piece);
  static void ClusterIfSeenInParts(
    const vtkShadowMapSlot& slot, const vtkShadowScene::Piece& piece, Caster& caster);
  double ExpectedOf(const vtkShadowScene::Prop& prop);
  bool IsTriangles(const vtkShadowScene::Prop& prop);
  bool IsPlain(std::size_t prop) const { return this->DrawnHere[prop] == 0; }
  bool HasPlainCasters(const vtkShadowMapViews& views) const;
  void UpdatePart(const vtkShadowFrame& frame, const vtkShadowMapViews& views,
    const vtkShadowMapSlot& slot, Part& part);
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkShadowTextureArray Numbers;
  vtkShadowByPiece<Caster> Casters;
  vtkShadowByPiece<double> Expected; // triangles
  std::vector<char> DrawnHere;       // one a prop of this frame
  std::vector<Part> Parts;           // one a slot
  std::string Fault;
  vtkShadowTrianglePlaces Places;
  std::size_t Capacity = 0; // of the buffer, in triangles
  unsigned int Buffer = 0, Texture = 0;
  vtkShadowTextureUnit BoundTo;
};

#endif
