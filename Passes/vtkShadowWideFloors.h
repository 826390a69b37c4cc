// Floors that are so much wider than all that stands on them that the floats of their corners say
// little of where a fragment of them lies: a floor of 1e6 units is drawn half a unit off its plane.
// What is asked of such a fragment is asked where the pixel's ray meets the plane, which is known
// in double (see vtkShadowScene::Piece::WideFloor).
#ifndef vtkShadowWideFloors_h
#define vtkShadowWideFloors_h

#include "vtkShadowSceneData.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

class vtkAbstractMapper;
class vtkInformation;
class vtkOpenGLState;
class vtkProp;
class vtkShaderProgram;

class vtkShadowWideFloors
{
public:
  // Takes the floors of a frame, whose props have their keys; true if mappers have others than
  // before.
  bool Gather(const vtkShadowFrame& frame);

  // The projection that is drawn by: Gather takes the eye's own.
  void SetProjection(const glm::dmat4& clipFromView) { this->ClipFromView = clipFromView; }

  // Whether the shader of a draw needs the code: a mapper has one for all that it draws, and a
  // composite's blocks are drawn by mappers of its own.
  bool Has(vtkAbstractMapper* mapper, vtkProp* prop) const
  {
    return !this->Mappers.empty() &&
      (this->Mappers.count(mapper) != 0 || this->Mappers.count(this->MapperOf(prop)) != 0);
  }
  static const char* Declarations();
  // GLSL: a fragment's place, in view coordinates, and the depth of it.
  static const char* PlaceCode() { return "shadowFloorPlace(vertexVC)"; }
  static const char* DepthCode() { return "shadowFloorDepth(gl_FragCoord.z)"; }

  // While the viewport is set that the prop is drawn into.
  void SetParameters(vtkShaderProgram* program, vtkProp* prop, vtkOpenGLState* state) const;

private:
  void GatherLeaves(const std::vector<vtkShadowScene::Prop>& props);
  const vtkProp* LeafOf(vtkProp* prop) const;
  const vtkAbstractMapper* MapperOf(vtkProp* prop) const;

  std::unordered_map<const vtkProp*, glm::dvec4> PlanesVC; // n.p = w, by leaf
  std::unordered_set<const vtkAbstractMapper*> Mappers;    // that draw any
  // While there are any, of all leaves.
  std::unordered_map<const vtkProp*, const vtkAbstractMapper*> MappersOfLeaves;
  // Of the actors that mappers and ParaView's props draw by in a leaf's place; none where parts of
  // an assembly share their keys.
  std::unordered_map<const vtkInformation*, const vtkProp*> LeavesByKeys;
  glm::dmat4 ClipFromView{ 1.0 };
  bool IsParallel = false;
};

#endif
