/**
 * @class   vtkShadowVolumeFilter
 * @brief   the space that a mesh hides from a light, as closed polydata
 *
 * Output: triangles, wound counter-clockwise seen from outside of the volume, and points in double,
 * in the input's coordinates. Each casting triangle is a near cap; behind it a prism reaches away
 * from the light to a far cap; sides stand where the prisms of neighbours do not cancel
 * (vtkShadowSilhouetteFilter's edges, as often as their multiplicity). The volume is the sum of
 * these prisms, and is closed for any input: along each edge as many triangles run one way as the
 * other. The number of times that it winds round a point is the number of casting triangles between
 * the point and the light. Where prisms overlap it is not split: boolean filters want simple
 * casters.
 *
 * Cell arrays:
 * - ShadowVolumePart (unsigned char): NEAR_CAP 0, SIDE 1, FAR_CAP 2. Cells come in this order.
 * - OriginalCellIds (vtkIdType): the input's cell that casts this cap; of a side, of the cells that
 *   cast it the lowest.
 *
 * Point arrays:
 * - OriginalPointIds (vtkIdType): the input's point that this one is, or is the image of; of those
 *   that were welded the lowest. -1 for the one far point of INFINITE_EXTENT.
 * - HomogeneousW (double): 1 for a point, 0 for a direction. With INFINITE_EXTENT only.
 *
 * Other parameters, errors and limits: see vtkShadowGeometryFilter.
 *
 * @par Reference
 * F. Crow: Shadow algorithms for computer graphics, SIGGRAPH 1977; P. Bergeron 1986;
 * B. Kim, K. Kim, G. Turk 2008.
 *
 * @sa vtkShadowSilhouetteFilter
 */
#ifndef vtkShadowVolumeFilter_h
#define vtkShadowVolumeFilter_h

#include "vtkShadowGeometryFilter.h"

class VTKSHADOWSFILTERS_EXPORT vtkShadowVolumeFilter : public vtkShadowGeometryFilter
{
public:
  static vtkShadowVolumeFilter* New();
  vtkTypeMacro(vtkShadowVolumeFilter, vtkShadowGeometryFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ShadowVolumePartType
  {
    NEAR_CAP = 0,
    SIDE = 1,
    FAR_CAP = 2
  };

  enum ExtentModeType
  {
    LENGTH_EXTENT = 0,
    BOUNDS_EXTENT = 1,
    INFINITE_EXTENT = 2
  };

  ///@{
  /**
   * How far the volume reaches.
   * - LENGTH_EXTENT: each point moves by Length along its ray, away from the light.
   * - BOUNDS_EXTENT (default): so far that everything in Bounds which is in shadow is in the
   * volume. A directional light's points move to one plane across the light, past Bounds and the
   * mesh. A position's points move to a sphere round it, so large that the flat far caps between
   * them are past Bounds and the mesh, too: no plane would do for a light among its casters.
   * - INFINITE_EXTENT: without end. A far point is a direction, as HomogeneousW says: p minus the
   *   light's position for the point p. All of a directional light's are one, the unit direction in
   *   which it travels; each side is then one triangle, and there are no far caps.
   *
   * A point exactly at the light's position has no direction and stays where it is, its direction
   * 0. A far cap is flat: for a triangle that a near light sees at a wide angle, it is nearer than
   * the far points. Bounds that would need a sphere more than a million times their size, for a
   * triangle that all but holds the light, are not reached everywhere. Values outside 0 to 2 are
   * clamped.
   */
  vtkSetClampMacro(ExtentMode, int, LENGTH_EXTENT, INFINITE_EXTENT);
  vtkGetMacro(ExtentMode, int);
  void SetExtentModeToLength() { this->SetExtentMode(LENGTH_EXTENT); }
  void SetExtentModeToBounds() { this->SetExtentMode(BOUNDS_EXTENT); }
  void SetExtentModeToInfinite() { this->SetExtentMode(INFINITE_EXTENT); }
  ///@}

  ///@{
  /**
   * For LENGTH_EXTENT: how far each point moves, in the input's units (default 1). 0 and less, and
   * what is not finite, fails the request.
   */
  vtkSetMacro(Length, double);
  vtkGetMacro(Length, double);
  ///@}

  ///@{
  /**
   * For BOUNDS_EXTENT: the box to reach past, (xmin, xmax, ymin, ymax, zmin, zmax) in the input's
   * units. Default (1, -1, 1, -1, 1, -1), or any whose minima are all above their maxima: the
   * bounds of the mesh's faces, grown on every side by their diagonal. Bounds of which only some
   * are reversed, and values that are not finite, fail the request.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

protected:
  vtkShadowVolumeFilter();
  ~vtkShadowVolumeFilter() override;

#ifndef __VTK_WRAP__
  bool MakeGeometry(const Caster& caster, vtkPolyData* output) override;
#endif

  int ExtentMode = BOUNDS_EXTENT;
  double Length = 1.0;
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };

private:
  vtkShadowVolumeFilter(const vtkShadowVolumeFilter&) = delete;
  void operator=(const vtkShadowVolumeFilter&) = delete;

  bool CheckExtent();
};

#endif
