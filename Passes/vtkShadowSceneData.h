// What vtkShadowScene gathers and vtkShadowPass hands to the techniques each frame. Plain C++, not
// wrapped; spaces: WC world, MC a mapper's model coordinates, VC the eye's view coordinates.
#ifndef vtkShadowSceneData_h
#define vtkShadowSceneData_h

#include "LightView.h"
#include "ShadowLight.h"
#include "ShadowReach.h"
#include "vtkShadowScene.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cstdint>
#include <unordered_set>

class vtkOpenGLRenderWindow;
class vtkOpenGLRenderer;
class vtkRenderState;
class vtkShadowReceiverBuffer;
class vtkShadowedShadingPass;

struct vtkShadowScene::Light
{
  vtkLight* Source = nullptr;
  vtkshadows::ShadowLight Ray;  // what shadows need of it, world
  bool AtEye = false;           // headlight: nothing that is seen is shadowed
  double MaximumDistance = 0.0; // from the eye, of what is in shadow, world; 0: any
};

// One mapper of a prop with its place in the world.
struct vtkShadowScene::Piece
{
  vtkProp3D* Prop = nullptr;
  vtkMapper* Mapper = nullptr;
  glm::dmat4 WorldFromModel{ 1.0 };
  vtkshadows::BoxCorners CornersWC;
  // The largest coordinate that its vertices have as OpenGL's floats, in world units: what they are
  // rounded in proportion to.
  double VertexReach = 0.0;
  // How exactly its points are known in world units: the rounding of the numbers that they are
  // kept, placed and drawn in.
  double Rounding = 0.0;
  // A flat piece's plane n.x = d, n of length 1, if every point lies on it to rounding; else n = 0.
  glm::dvec4 PlaneWC{ 0.0 };
  double PlaneRounding = 0.0; // how exactly it is known, along n
  // A floor or wall far wider than all else in the scene, but for others like it, which under none
  // of the lights casts on anything that is seen: it is no caster. What receives on it is where a
  // pixel's ray meets its plane, not where floats of its corners have it: VertexReach and Rounding
  // are those of the plane and of what stands there.
  bool WideFloor = false;
  // No texture, and no shader code of the user's, can cut holes in it.
  bool DrawnSolid = false;
  // Changes exactly when the piece's shape changes, in model coordinates.
  std::vector<std::uint64_t> Shape;
  // Shape and place: changes exactly when what the piece casts changes.
  std::vector<std::uint64_t> Signature;
};

struct vtkShadowScene::Prop
{
  vtkProp* Source = nullptr;
  bool Casts = true;
  bool CastsRays = true; // as the ray cast has it: of a prop with a stand-in, the prop
  bool Receives = true;
  // Of a stand-in, the prop in whose place it casts: it is no part of the frame.
  vtkProp* StandsInFor = nullptr;
  bool Translucent = false;
  bool Dithers = false;   // translucent, and casts by its opacity
  bool Transmits = false; // the same, without grain where a technique can
  bool Catches = false;   // a shadow catcher: translucent, receives, casts nothing
  // Draws impostors (spheres, sticks, points as spheres, lines as tubes), whose shaders ask whether
  // the camera is parallel.
  bool Impostors = false;
  std::vector<Piece> Pieces;
};

// The bounds of the pieces of those props for which wants(prop) is true.
template <typename Wants>
std::vector<vtkshadows::BoxCorners> vtkShadowCornersOf(
  const vtkShadowScene& scene, const Wants& wants)
{
  std::vector<vtkshadows::BoxCorners> corners;
  for (const vtkShadowScene::Prop& prop : scene.GetProps())
  {
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      if (wants(prop))
      {
        corners.push_back(piece.CornersWC);
      }
    }
  }
  return corners;
}

// Whether nothing that is seen can lie in the shadow of a piece, by its plane. What lies within
// `rounding` of that may lie on it.
inline bool vtkShadowCastsOnNothing(const vtkShadowScene::Piece& piece,
  const vtkshadows::ShadowLight& light, const std::vector<vtkshadows::BoxCorners>& receivers,
  double rounding)
{
  return piece.WideFloor || vtkshadows::CastsOnNothing(piece.PlaneWC, light, receivers, rounding);
}

// Of what receives, how exactly its points are known, at the worst.
inline double vtkShadowReceiverRounding(const vtkShadowScene& scene)
{
  double rounding = 0.0;
  for (const vtkShadowScene::Prop& prop : scene.GetProps())
  {
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      rounding = prop.Receives ? std::max(rounding, piece.Rounding) : rounding;
    }
  }
  return rounding;
}

// The props at `casters`, and those that they stand in for.
inline std::unordered_set<const vtkProp*> vtkShadowOwnersOf(
  const vtkShadowScene& scene, const std::vector<std::size_t>& casters)
{
  std::unordered_set<const vtkProp*> owners;
  for (const std::size_t i : casters)
  {
    owners.insert(scene.GetProps()[i].Source);
    owners.insert(scene.GetProps()[i].StandsInFor);
  }
  return owners;
}

inline std::vector<vtkshadows::BoxCorners> vtkShadowReceiverCorners(const vtkShadowScene& scene)
{
  return vtkShadowCornersOf(scene, [](const vtkShadowScene::Prop& prop) { return prop.Receives; });
}

// One frame, as a technique is given it.
struct vtkShadowFrame
{
  const vtkRenderState* State = nullptr;
  vtkOpenGLRenderer* Renderer = nullptr;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkShadowScene* Scene = nullptr;
  vtkShadowedShadingPass* Shading = nullptr;
  vtkShadowReceiverBuffer* Receivers = nullptr; // Draw() it if you need it; drawn once a frame
  int Size[2] = { 0, 0 };                       // of the viewport in pixels
  int Origin[2] = { 0, 0 };                     // of the viewport in its framebuffer
  bool HasDelegate = false;                     // who may draw into a framebuffer of another size
  glm::dmat4 ViewFromWorld{ 1.0 };              // the eye's
  glm::dmat4 ClipFromView{ 1.0 };               // the eye's, with the camera's own depth range
};

#endif
