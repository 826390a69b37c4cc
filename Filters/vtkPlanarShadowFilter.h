/**
 * @class   vtkPlanarShadowFilter
 * @brief   the shadow of a mesh on a plane, as polygons, as its outline, and as an area
 *
 * Output, points in double, in the input's coordinates, on the plane:
 * - POLYGONS: for each casting triangle (polygons are taken as fans, strips apart) what it throws
 *   on the plane, in the input's order, counter-clockwise seen from the light's side of the plane.
 *   Where shadows overlap, so do the polygons. Those that are thinner than rounding can tell, as of
 *   a face seen edge-on, are left out.
 * - OUTLINE: where the shadow ends, as one closed polyline a loop, with the shadow to its left seen
 *   from the light's side: outer loops counter-clockwise, holes clockwise.
 *
 * What casts lies between plane and light. What is beneath the plane, or as far from it as the
 * light and farther, casts nothing: it is cut away before anything is divided by its distance. The
 * plane has two sides, and the light may stand on either.
 *
 * Cell arrays:
 * - OriginalCellIds (vtkIdType), of POLYGONS: the input's cell.
 * - LoopArea (double), of OUTLINE: what the loop holds; negative for a hole.
 *
 * Point array:
 * - OriginalPointIds (vtkIdType): the input's point that this one is the shadow of; of those that
 *   were welded the lowest. -1 where a side was cut, and on outlines where sides cross. A cut point
 *   belongs to one polygon; the others are shared.
 *
 * Field data:
 * - ShadowArea (1 double): the area of the shadow, in the input's units squared, each point of the
 *   plane counted once. With ComputeArea, or with OUTLINE.
 * - ShadowPlaneOrigin, ShadowPlaneNormal (3 doubles each): a point of the plane, beneath the middle
 *   of the mesh, and its unit normal to the light's side.
 * - ShadowLight (4 doubles): (position, 1), or (unit direction toward the light, 0).
 * - ShadowIsCut (1 int): 1 if bounds cut something away from the shadow.
 * - ShadowBounds (6 doubles): if so, these.
 *
 * Area and outline are exact but for rounding: lengths to about 1e-15 of the shadow's extent, each
 * along and across the way that it grows long. All is computed relative to the middle of the mesh.
 *
 * A light in the plane, or nearer to it than rounding can tell, throws no shadow on it: the output
 * is empty, with a warning. Errors, with an empty output and a failed request, besides those of
 * vtkShadowGeometryFilter: a normal that is 0, and a plane or bounds that are not finite.
 *
 * Other parameters, and limits: see vtkShadowGeometryFilter. CLOSED_FACES halves the polygons of
 * closed meshes; the area and the outline are the same.
 *
 * @par Reference
 * J. Blinn: Me and my (fake) shadow, IEEE CG&A 8(1), 1988; of the outline: J. Hobby: Practical
 * segment intersection with finite precision output, Computational Geometry 13(4), 1999.
 *
 * @sa vtkShadowVolumeFilter vtkShadowSilhouetteFilter
 */
#ifndef vtkPlanarShadowFilter_h
#define vtkPlanarShadowFilter_h

#include "vtkShadowGeometryFilter.h"

class VTKSHADOWSFILTERS_EXPORT vtkPlanarShadowFilter : public vtkShadowGeometryFilter
{
public:
  static vtkPlanarShadowFilter* New();
  vtkTypeMacro(vtkPlanarShadowFilter, vtkShadowGeometryFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * A point of the plane, in the input's coordinates. Default (0, 0, 0).
   */
  vtkSetVector3Macro(PlaneOrigin, double);
  vtkGetVector3Macro(PlaneOrigin, double);
  ///@}

  ///@{
  /**
   * The plane's normal, of any length but 0, to either side. Default (0, 0, 1).
   */
  vtkSetVector3Macro(PlaneNormal, double);
  vtkGetVector3Macro(PlaneNormal, double);
  ///@}

  ///@{
  /**
   * The box that the shadow is cut to, (xmin, xmax, ymin, ymax, zmin, zmax) in the input's units,
   * as the bounds of a floor. Faces of the box that are parallel to the plane cut nothing, unless
   * the plane passes it by: then there is no shadow.
   *
   * Default (1, -1, 1, -1, 1, -1), or any whose minima are all above their maxima: none. The
   * shadow is then whole, if it has an end. It has none where a caster reaches up to a light that
   * has a position, or into the last millionth of the way from the plane to it. Then, with a
   * warning, it is cut to a box round the mesh, and round what is straight beneath mesh and light
   * on the plane, grown on every side by 1000 times its diagonal: ShadowBounds has it.
   *
   * Bounds of which only some are reversed, and values that are not finite, fail the request.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  enum OutputModeType
  {
    POLYGONS = 0,
    OUTLINE = 1
  };

  ///@{
  /**
   * What the output is, as described above: POLYGONS (default) or OUTLINE. Values outside 0 to 1
   * are clamped.
   */
  vtkSetClampMacro(OutputMode, int, POLYGONS, OUTLINE);
  vtkGetMacro(OutputMode, int);
  void SetOutputModeToPolygons() { this->SetOutputMode(POLYGONS); }
  void SetOutputModeToOutline() { this->SetOutputMode(OUTLINE); }
  ///@}

  ///@{
  /**
   * Whether POLYGONS come with their ShadowArea (default on). It costs more than the polygons do;
   * see Docs/Techniques.md.
   */
  vtkSetMacro(ComputeArea, bool);
  vtkGetMacro(ComputeArea, bool);
  vtkBooleanMacro(ComputeArea, bool);
  ///@}

protected:
  vtkPlanarShadowFilter();
  ~vtkPlanarShadowFilter() override;

#ifndef __VTK_WRAP__
  bool MakeGeometry(const Caster& caster, vtkPolyData* output) override;
#endif

  double PlaneOrigin[3] = { 0.0, 0.0, 0.0 };
  double PlaneNormal[3] = { 0.0, 0.0, 1.0 };
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  int OutputMode = POLYGONS;
  bool ComputeArea = true;

private:
  vtkPlanarShadowFilter(const vtkPlanarShadowFilter&) = delete;
  void operator=(const vtkPlanarShadowFilter&) = delete;

  bool CheckPlane();
};

#endif
