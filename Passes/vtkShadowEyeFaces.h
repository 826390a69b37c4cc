// What the eye cannot see of closed receivers: the faces that are turned away from it. While they
// are left out, VTK's own culling of faces does it, by the flags of the actors' properties.
//
// A frame's picture does not change. That takes a surface that is proven not to pass through itself
// (Core/EmbeddedSurface.h), all of it beyond the near plane, opaque and without holes.
#ifndef vtkShadowEyeFaces_h
#define vtkShadowEyeFaces_h

#include "vtkShadowHiddenFaces.h"
#include "vtkShadowSceneData.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkProperty;

class vtkShadowEyeFaces
{
public:
  // Leave out what is known to be hidden, from now on and until Restore.
  void LeaveOut(const vtkShadowFrame& frame);
  // Properties as they were.
  void Restore();

  // Whether more may be left out soon: a proof is being looked for.
  bool IsUndecided() const { return this->Faces.IsSearching(); }

  // Actors whose hidden faces were left out at last.
  int NumberOfActors() const { return this->Count; }

private:
  vtkShadowHiddenFaces Faces{ vtkShadowHiddenFaces::Proof::Embedded };
  std::vector<vtkSmartPointer<vtkProperty>> Properties; // that cull now
  int Count = 0;
};

#endif
