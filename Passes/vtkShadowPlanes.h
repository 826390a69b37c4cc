// The planes of a scene that receive shadows, and the props with a receiver on them: flat pieces,
// flat parts of others, and the planes that a user names.
#ifndef vtkShadowPlanes_h
#define vtkShadowPlanes_h

#include "ShadowReach.h"
#include "vtkShadowByPiece.h"
#include "vtkShadowSceneData.h"

#include "vtkTimeStamp.h"

#include <unordered_map>
#include <vector>

class vtkShadowPlanes
{
public:
  struct Plane
  {
    glm::dvec4 PlaneWC{ 0.0 };                   // n.x = d as (n, d)
    double Area = 0.0;                           // of what lies on it, from its bounds
    std::vector<std::size_t> Props;              // that have a receiver on it
    std::vector<vtkshadows::BoxCorners> Corners; // of these receivers
    vtkshadows::Box Bounds;
    bool AllFlat = true;   // all that these props show lies on it
    bool OneSided = false; // sides of closed bodies: seen from where the normal points alone
  };

  // Look at the scene of a frame, seen from `eyeWC` (homogeneous). `named` planes come first; with
  // `automatic` those of flat receivers follow, the largest first.
  void Find(const vtkShadowScene& scene, const std::vector<glm::dvec4>& named, bool automatic,
    const glm::dvec4& eyeWC);

  const std::vector<Plane>& Get() const { return this->Planes; }

  // Points nearer to a plane than this lie on it, to the rounding of the floats that are drawn.
  double Tolerance() const { return this->Rounding; }

  // Whether a flat piece lies on a plane.
  bool LiesOn(const vtkShadowScene::Piece& piece, const glm::dvec4& planeWC) const;

  // Say on which planes any shadow falls. Props with a receiver on them, each once; and whether a
  // prop (a leaf, a top, or a mapper's copy of one) is such, and by which planes.
  void SetShadowed(const vtkShadowScene& scene, const std::vector<bool>& planes);
  const std::vector<std::size_t>& ShadowedProps() const { return this->Shadowed; }
  const std::vector<std::size_t>* ShadowedPlanesOf(vtkProp* prop) const;

  // Grows when the answers of ShadowedPlanesOf change.
  vtkMTimeType ShadowedStamp() const { return this->Stamp.GetMTime(); }

private:
  // The plane of one of a piece's larger flat parts, in model coordinates.
  struct FlatPart
  {
    glm::dvec4 PlaneMC{ 0.0 };
    double Share = 0.0;   // of the piece's area
    bool Outward = false; // the piece is closed, and the normal points out of it
  };
  static std::vector<FlatPart> FindParts(const vtkShadowScene::Piece& piece);
  bool AreOne(const glm::dvec4& planeWC, const glm::dvec4& otherWC,
    const vtkshadows::BoxCorners& corners) const;
  Plane* FindPlane(const glm::dvec4& planeWC, bool oneSided, const vtkshadows::BoxCorners& corners);
  void Add(Plane& plane, std::size_t prop, const vtkShadowScene::Piece& piece, double share);

  std::vector<Plane> Planes;
  double Rounding = 0.0;
  vtkShadowByPiece<std::vector<FlatPart>> Parts;
  std::vector<std::size_t> Shadowed;
  std::unordered_map<const void*, std::vector<std::size_t>> PlanesOf; // by prop, and by its keys
  vtkTimeStamp Stamp;
};

#endif
