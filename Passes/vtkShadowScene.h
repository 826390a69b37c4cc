/**
 * @class   vtkShadowScene
 * @brief   this frame's lights, casters and receivers, gathered once, in double
 *
 * Gathered by vtkShadowPass at the start of a frame. Everything is in world coordinates. Change
 * stamps grow only when something changed that a shadow depends on: a caster moved, hidden, its
 * points edited in place, its mapper's input replaced; a light moved.
 *
 * @sa vtkShadowPass
 */
#ifndef vtkShadowScene_h
#define vtkShadowScene_h

#include "vtkObject.h"
#include "vtkShadowsPassesModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <vector> // for std::vector

class vtkLight;
class vtkMapper;
class vtkProp;
class vtkProp3D;
class vtkRenderer;

class VTKSHADOWSPASSES_EXPORT vtkShadowScene : public vtkObject
{
public:
  static vtkShadowScene* New();
  vtkTypeMacro(vtkShadowScene, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Counts of the last frame: switched-on lights (headlights included), casters, receivers (props;
   * an assembly is one).
   */
  int GetNumberOfLights() const;
  int GetNumberOfCasters() const;
  int GetNumberOfReceivers() const;
  ///@}

  /**
   * Grows when any caster changed (see above); equal stamps mean equal casters.
   */
  vtkMTimeType GetCasterStamp() const;

#ifndef __VTK_WRAP__
  // Structures of plain C++ for the techniques; see vtkShadowSceneData.h.
  struct Light;
  struct Piece;
  struct Prop;

  // Lights in the order of the renderer's collection, switched-on ones only: light i is
  // lightColor<i> in VTK's shaders.
  const std::vector<Light>& GetLights() const;

  // Every visible prop with something to draw in 3D, and after it its stand-in, if that casts.
  const std::vector<Prop>& GetProps() const;

  void Gather(vtkRenderer* renderer);

  // One of vtkShadowPass::TranslucentCastingType.
  void SetTranslucentCasting(int how);
  int GetTranslucentCasting() const;

  // These are no properties of a vtkLight: vtkShadowPass knows them.
  void SetLightRadius(std::size_t light, double radius);
  void SetLightMaximumDistance(std::size_t light, double distance);
#endif

protected:
  vtkShadowScene();
  ~vtkShadowScene() override;

private:
  vtkShadowScene(const vtkShadowScene&) = delete;
  void operator=(const vtkShadowScene&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
