/**
 * @class   vtkShadowFloor
 * @brief   a floor for a figure: a square fitted under what a renderer shows
 *
 * @code
 * vtkNew<vtkShadowFloor> floor;
 * vtkShadowPass::SetShadowCatcher(floor->GetActor(), true);  // or leave it a plain floor
 * floor->Fit(renderer);
 * renderer->AddActor(floor->GetActor());
 * @endcode
 * The scene that it is fitted to is the surfaces of the renderer's visible props (the bounds of
 * what has none), this floor and shadow catchers left out. It is measured in the floor's own axes:
 * its normal, and the two sides of the square, of which one lies along the x axis as far as it can.
 * Fit again when the scene has changed; the actor is moved by its user matrix, its mesh stays.
 *
 * @sa vtkShadowPass
 */
#ifndef vtkShadowFloor_h
#define vtkShadowFloor_h

#include "vtkNew.h" // for the actor
#include "vtkObject.h"
#include "vtkShadowsPassesModule.h" // for export macro

class vtkActor;
class vtkRenderer;

class VTKSHADOWSPASSES_EXPORT vtkShadowFloor : public vtkObject
{
public:
  static vtkShadowFloor* New();
  vtkTypeMacro(vtkShadowFloor, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * World direction that the floor faces, of any length. (0, 0, 0), the default: the axis nearest
   * to the view-up of the renderer's camera; y if it has none yet.
   */
  vtkSetVector3Macro(Normal, double);
  vtkGetVector3Macro(Normal, double);
  ///@}

  ///@{
  /**
   * Side of the square, in units of the longest side of the scene's box: above 0 (default 3, so
   * that the shadow of a light 45 degrees high ends on it).
   */
  vtkSetMacro(Size, double);
  vtkGetMacro(Size, double);
  ///@}

  /**
   * Place the floor under the scene of `renderer`, centred, touching its lowest point but for a
   * 2000th of its size, by which a flat bottom does not tie with the floor. false, with an error,
   * if the renderer shows nothing that has an extent, or Size or Normal is not finite.
   */
  bool Fit(vtkRenderer* renderer);

  /**
   * The same in the plane of the points x with n.x = offset, where n is the normal, normalised.
   */
  bool FitAt(vtkRenderer* renderer, double offset);

  /**
   * The floor: a white square of one quad, to be added to the renderer by the caller.
   */
  vtkActor* GetActor();

  /**
   * The axis nearest to a vector, as a unit vector with its sign.
   */
  static void NearestAxis(const double vector[3], double axis[3]);

protected:
  vtkShadowFloor();
  ~vtkShadowFloor() override;

private:
  vtkShadowFloor(const vtkShadowFloor&) = delete;
  void operator=(const vtkShadowFloor&) = delete;

  bool Place(vtkRenderer* renderer, const double* offset);

  double Normal[3] = { 0.0, 0.0, 0.0 };
  double Size = 3.0;
  vtkNew<vtkActor> Actor;
};

#endif
