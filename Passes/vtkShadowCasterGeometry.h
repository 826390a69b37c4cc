// The surface of a caster as triangles and spheres, from VTK's mappers: what rays and silhouettes
// need and maps do not.
#ifndef vtkShadowCasterGeometry_h
#define vtkShadowCasterGeometry_h

#include "vtkShadowSceneData.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <vector>

class vtkCompositeDataDisplayAttributes;
class vtkDataSet;
class vtkGlyph3DMapper;
class vtkPolyData;

struct vtkShadowCasterGeometry
{
  std::vector<glm::vec3> Vertices;
  std::vector<glm::uvec3> Triangles; // polygons as fans and strips, as VTK's mappers draw them
  std::vector<glm::vec4> Spheres;    // centre, radius
  std::string Skipped;               // what of the piece has no surface here; empty: nothing

  // Bounds, in model coordinates, of what `mapper` draws, its pipeline brought up to date; false if
  // it draws nothing. Impostor mappers themselves give the bounds of their centres, and only of
  // those in cells.
  static bool BoundsOf(vtkMapper* mapper, double bounds[6]);

  // How the mapper's points become the floats that it hands to OpenGL, (p - Shift) * Scale: VTK
  // moves and scales what is far from the origin for its size, or large or small
  // (vtkOpenGLVertexBufferObject::UpdateShiftScale).
  struct VertexPlace
  {
    glm::dvec3 Shift{ 0.0 }, Scale{ 1.0 };
    bool IsMoved() const
    {
      return this->Scale != glm::dvec3(1.0) || this->Shift != glm::dvec3(0.0);
    }
  };
  static VertexPlace PlaceOfVertices(vtkMapper* mapper);

  // How blocks of a mapper's data set are drawn; nullptr: all are.
  static vtkCompositeDataDisplayAttributes* AttributesOf(vtkMapper* mapper);

  // What a glyph mapper draws at once: one of its sources, at the points of one data set.
  struct GlyphDraw
  {
    vtkDataSet* Points;
    vtkPolyData* Source;
    std::vector<glm::dmat4> ModelFromGlyph; // by instance
  };
  // In VTK's order, of a data set that is in several blocks once. Empty where sources are from a
  // tree.
  static std::vector<GlyphDraw> GlyphDrawsOf(vtkGlyph3DMapper* mapper);

  // What a piece is, without its triangles being gone through one by one.
  struct Survey
  {
    double Triangles = 0.0;      // about how many
    bool HasSpheres = false;     // of the sphere mapper
    std::string NoSurface;       // what of it has no surface, as Skipped; empty: nothing
    std::string NoFiniteSurface; // why its triangles are not all finite; empty: they are
  };
  static Survey SurveyOf(const vtkShadowScene::Piece& piece);

  // Extract `piece`, in a space of the caller's (so that floats are relative to the scene, or the
  // caster); worldFromTrace is needed only where the mapper has clipping planes.
  static vtkShadowCasterGeometry Extract(const vtkShadowScene::Piece& piece,
    const glm::dmat4& traceFromModel, const glm::dmat4& worldFromTrace);
};

#endif
