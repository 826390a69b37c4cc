/**
 * @class   vtkShadowSilhouetteFilter
 * @brief   the edges of a mesh at which its shadow from a light begins
 *
 * Output: one line cell an edge, in the input's coordinates and precision. Each line is directed so
 * that the shadow lies to its left, seen from the light. Borders of open meshes are among them. The
 * edges are those that the shadow volume has sides on, by signed edge multiplicity: along an edge,
 * the sides of all casting triangles are summed, and what cancels is no silhouette.
 *
 * Cell arrays:
 * - SignedMultiplicity (int, never 0): magnitude: how many sides the shadow volume has on this
 * edge, which is how many more casting triangles lie on its left than on its right, seen from the
 * light: for a closed body 2 with ALL_FACES, 1 with CLOSED_FACES. Sign: + if the line runs as the
 * cell OriginalCellId0 is wound along this edge, - if it runs against it.
 * - OriginalCellId0, OriginalCellId1 (vtkIdType): cells of the input that meet at the edge, of
 * three and more the lowest two; OriginalCellId1 is -1 at a border. Both are the same cell on a
 * diagonal of a polygon that is not plane, or inside a strip.
 * - NumberOfCells (int): how many triangles meet at the edge, 1 at a border.
 *
 * Point array:
 * - OriginalPointIds (vtkIdType): the input's point; of those that were welded the lowest.
 *
 * Parameters, errors and limits: see vtkShadowGeometryFilter.
 *
 * @par Reference
 * P. Bergeron: A general version of Crow's shadow volumes, IEEE CG&A 6(9), 1986;
 * B. Kim, K. Kim, G. Turk: A shadow-volume algorithm for opaque and transparent nonmanifold
 * casters, Journal of Graphics Tools 13(3), 2008.
 *
 * @sa vtkShadowVolumeFilter
 */
#ifndef vtkShadowSilhouetteFilter_h
#define vtkShadowSilhouetteFilter_h

#include "vtkShadowGeometryFilter.h"

class VTKSHADOWSFILTERS_EXPORT vtkShadowSilhouetteFilter : public vtkShadowGeometryFilter
{
public:
  static vtkShadowSilhouetteFilter* New();
  vtkTypeMacro(vtkShadowSilhouetteFilter, vtkShadowGeometryFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkShadowSilhouetteFilter();
  ~vtkShadowSilhouetteFilter() override;

#ifndef __VTK_WRAP__
  bool MakeGeometry(const Caster& caster, vtkPolyData* output) override;
#endif

private:
  vtkShadowSilhouetteFilter(const vtkShadowSilhouetteFilter&) = delete;
  void operator=(const vtkShadowSilhouetteFilter&) = delete;
};

#endif
