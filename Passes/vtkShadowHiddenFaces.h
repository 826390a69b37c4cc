// Which faces of a caster a map of depths need not draw: of a closed surface a light outside of it
// first meets one that faces it, and the others lie behind. That halves the work and changes no
// texel.
//
// Whether a surface is closed takes a look at all its edges. It is taken when a shape is asked
// about in a second frame, so that one that changes with every frame costs nothing.
//
// A closed surface that passes through itself may be seen from behind. A map of depths is hardly
// the worse for that, a picture is. Whether one does takes much longer to find, so that a thread of
// its own does it, and nothing is hidden until it is done.
#ifndef vtkShadowHiddenFaces_h
#define vtkShadowHiddenFaces_h

#include "vtkShadowByPiece.h"
#include "vtkShadowSceneData.h"

#include <glm/vec4.hpp>

#include <memory>
#include <unordered_map>
#include <vector>

class vtkProp;

class vtkShadowHiddenFaces
{
public:
  ~vtkShadowHiddenFaces();

  enum class Side
  {
    None,
    Back, // as wound and drawn: clockwise, seen from the light
    Front
  };

  enum class Proof
  {
    Closed,
    Embedded // and does not pass through itself
  };
  explicit vtkShadowHiddenFaces(Proof proof = Proof::Closed)
    : Wanted(proof)
  {
  }

  // A new frame, of these props: others are forgotten.
  void BeginFrame(const std::vector<vtkShadowScene::Prop>& props);

  // A light is (position, 1), or (the unit direction toward it, 0), in world coordinates.
  Side Of(const vtkShadowScene::Piece& piece, const glm::dvec4& lightWC);

  // The same as OpenGL has it, GL_FRONT or GL_BACK by leaf, for all pieces of some props;
  // `mirrored`: drawn so that what is wound one way, seen from the light, is seen the other way.
  std::unordered_map<vtkProp*, unsigned int> CulledOf(
    const std::vector<vtkShadowScene::Prop>& props, const std::vector<std::size_t>& casters,
    const glm::dvec4& lightWC, bool mirrored = false);

  // Whether a proof is being looked for.
  bool IsSearching() const;

private:
  struct Search;
  struct Surface
  {
    Surface();
    Surface(Surface&&) noexcept;
    Surface& operator=(Surface&&) noexcept;
    ~Surface();

    std::size_t FirstFrame = 0; // that asked about this shape
    bool Surveyed = false;
    Side Hidden = Side::None;         // of a matrix that does not mirror
    std::unique_ptr<Search> Embedded; // while it goes on
  };
  Proof Wanted;
  std::size_t Frame = 0;
  vtkShadowByPiece<Surface> Known;
};

#endif
