/**
 * @class   vtkShadowGeometryFilter
 * @brief   what filters of shadow geometry share: a caster, a light, which faces cast
 *
 * Input: polydata. Its polygons are taken as fans of triangles and its strips as VTK draws them;
 * lines and vertices cast nothing. Any mesh will do: open, non-manifold, of mixed winding, with
 * duplicated faces. Points that agree in every coordinate are one point.
 *
 * The mesh is made ready (welded, its edges found) when the input changes. While it does not, a
 * light that moves costs only the facing of triangles and the sum over edges.
 *
 * Nothing is rendered; no display is needed.
 *
 * Errors, with an empty output and a failed request: a light that is none; a point of a face that
 * is NaN or infinite; a face that names a point that is not there; more than 715 827 882 triangles.
 * An input without faces gives an empty output without an error.
 *
 * The blocks of a composite data set cast one by one: each gets geometry of its own, and its mesh
 * is made ready in every update.
 *
 * @sa vtkShadowSilhouetteFilter vtkShadowVolumeFilter vtkPlanarShadowFilter
 */
#ifndef vtkShadowGeometryFilter_h
#define vtkShadowGeometryFilter_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkShadowsFiltersModule.h" // for export macro

#include <memory> // for std::unique_ptr

class VTKSHADOWSFILTERS_EXPORT vtkShadowGeometryFilter : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkShadowGeometryFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The light as a homogeneous vector in the input's coordinates: (x, y, z, 1) is a position,
   * (x, y, z, 0) the direction toward the light, of any length. Any w above 0 is a scaled position
   * (x/w, y/w, z/w). Default (0, 0, 1, 0): far above, shining down z. A w below 0, a value that is
   * not finite, and four zeros fail the request.
   */
  vtkSetVector4Macro(Light, double);
  vtkGetVector4Macro(Light, double);
  ///@}

  ///@{
  /**
   * The light at a position, in the input's coordinates.
   */
  void SetLightPosition(double x, double y, double z) { this->SetLight(x, y, z, 1.0); }
  void SetLightPosition(const double position[3]);
  ///@}

  ///@{
  /**
   * A light far away, by the direction in which it TRAVELS, as from a vtkLight's position to its
   * focal point. Light becomes the negated vector, with w = 0.
   */
  void SetLightDirection(double dx, double dy, double dz);
  void SetLightDirection(const double direction[3]);
  ///@}

  enum CastingFacesType
  {
    ALL_FACES = 0,
    CLOSED_FACES = 1
  };

  ///@{
  /**
   * Which faces cast.
   * - ALL_FACES: every one, whichever way it faces. A ray that passes through a closed body is
   *   counted twice: where it enters and where it leaves.
   * - CLOSED_FACES (default): of a closed, consistently wound piece of the mesh whose bounds do not
   *   hold the light only the faces toward it, so that a body is counted once; of all the rest
   * every face. What is in shadow is the same.
   *
   * A light that moves into the bounds of a piece makes all of its faces cast: counts and volumes
   * jump. ALL_FACES has no such jump. Values outside 0 to 1 are clamped.
   */
  vtkSetClampMacro(CastingFaces, int, ALL_FACES, CLOSED_FACES);
  vtkGetMacro(CastingFaces, int);
  void SetCastingFacesToAll() { this->SetCastingFaces(ALL_FACES); }
  void SetCastingFacesToClosed() { this->SetCastingFaces(CLOSED_FACES); }
  ///@}

  /**
   * How often the mesh was made ready since this filter was made: once per change of the input.
   */
  vtkGetMacro(NumberOfMeshBuilds, vtkIdType);

#ifndef __VTK_WRAP__
  // Structure of plain C++ for the filters; see vtkShadowCaster.h.
  struct Caster;
#endif

protected:
  vtkShadowGeometryFilter();
  ~vtkShadowGeometryFilter() override;

#ifndef __VTK_WRAP__
  // Fill the output, which is empty. false, after an error, if it cannot be.
  virtual bool MakeGeometry(const Caster& caster, vtkPolyData* output) = 0;
#endif

  // Whether these are six finite numbers, none of the minima above its maximum, or all; with an
  // error if not. `meaning`: what the latter stands for.
  bool CheckBounds(const double bounds[6], const char* meaning);

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Light[4] = { 0.0, 0.0, 1.0, 0.0 };
  int CastingFaces = CLOSED_FACES;
  vtkIdType NumberOfMeshBuilds = 0;

private:
  vtkShadowGeometryFilter(const vtkShadowGeometryFilter&) = delete;
  void operator=(const vtkShadowGeometryFilter&) = delete;

  bool UpdateMesh(vtkPolyData* input);
  bool UpdateLight();

  std::unique_ptr<Caster> Prepared;
};

#endif
