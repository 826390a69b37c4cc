#include "vtkShadowCasterGeometry.h"

#include "vtkActor.h"
#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkCompositePolyDataMapper.h"
#if __has_include("vtkCompositePolyDataMapper2.h")
#include "vtkCompositePolyDataMapper2.h"
#endif
#include "vtkDataArray.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMath.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkQuaternion.h"
#include "vtkVersionMacros.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <set>
#include <utility>

namespace
{

using Geometry = vtkShadowCasterGeometry;

// Protected members of VTK's classes that say how a mapper draws, by name of a derived class.
struct GlyphAccess : vtkGlyph3DMapper
{
  static vtkDataArray* Mask(vtkGlyph3DMapper* m, vtkDataSet* d)
  {
    return (m->*(&GlyphAccess::GetMaskArray))(d);
  }
  static vtkDataArray* Index(vtkGlyph3DMapper* m, vtkDataSet* d)
  {
    return (m->*(&GlyphAccess::GetSourceIndexArray))(d);
  }
  static vtkDataArray* Orientation(vtkGlyph3DMapper* m, vtkDataSet* d)
  {
    return (m->*(&GlyphAccess::GetOrientationArray))(d);
  }
  static vtkDataArray* Scale(vtkGlyph3DMapper* m, vtkDataSet* d)
  {
    return (m->*(&GlyphAccess::GetScaleArray))(d);
  }
};

struct SphereAccess : vtkOpenGLSphereMapper
{
  static const char* ScaleName(vtkOpenGLSphereMapper* m) { return m->*(&SphereAccess::ScaleArray); }
};

struct StickAccess : vtkOpenGLStickMapper
{
  static const char* ScaleName(vtkOpenGLStickMapper* m) { return m->*(&StickAccess::ScaleArray); }
};

// Largest length of a tuple of the named point array; 0 if there is none.
double LargestOf(vtkPolyData* mesh, const char* name)
{
  vtkDataArray* values = mesh && name ? mesh->GetPointData()->GetArray(name) : nullptr;
  return values ? values->GetMaxNorm() : 0.0;
}

void AppendTriangle(Geometry& out, const glm::uvec3& t)
{
  const glm::vec3 &a = out.Vertices[t.x], &b = out.Vertices[t.y], &c = out.Vertices[t.z];
  if (a != b && b != c && c != a)
  {
    out.Triangles.push_back(t);
  }
}

void AppendFans(Geometry& out, vtkCellArray* cells, unsigned int base)
{
  auto it = vtk::TakeSmartPointer(cells->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    it->GetCurrentCell(size, ids);
    for (vtkIdType i = 1; i + 1 < size; ++i)
    {
      AppendTriangle(out, base + glm::uvec3(ids[0], ids[i], ids[i + 1]));
    }
  }
}

void AppendStrips(Geometry& out, vtkCellArray* cells, unsigned int base)
{
  auto it = vtk::TakeSmartPointer(cells->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    it->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      const vtkIdType odd = i % 2;
      AppendTriangle(out, base + glm::uvec3(ids[i], ids[i + 1 + odd], ids[i + 2 - odd]));
    }
  }
}

void AppendMesh(Geometry& out, vtkPolyData* mesh, const glm::dmat4& traceFromModel)
{
  vtkPoints* points = mesh ? mesh->GetPoints() : nullptr;
  if (!points)
  {
    return;
  }
  const auto base = static_cast<unsigned int>(out.Vertices.size());
  out.Vertices.reserve(base + points->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    out.Vertices.emplace_back(traceFromModel * glm::dvec4(p[0], p[1], p[2], 1.0));
  }
  AppendFans(out, mesh->GetPolys(), base);
  AppendStrips(out, mesh->GetStrips(), base);
  if (mesh->GetNumberOfLines() + mesh->GetNumberOfVerts() > 0)
  {
    out.Skipped = "lines and points";
  }
}

void AppendDataSet(Geometry& out, vtkDataObject* data, const glm::dmat4& traceFromModel)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    AppendMesh(out, mesh, traceFromModel);
  }
  else if (auto* dataset = vtkDataSet::SafeDownCast(data))
  {
    vtkNew<vtkDataSetSurfaceFilter> surface;
    surface->SetInputData(dataset);
    surface->Update();
    AppendMesh(out, surface->GetOutput(), traceFromModel);
  }
}

// Calls use(leaf) for the leaves of `data` that are not hidden, in the order in which VTK draws
// them. Where `inherits`, blocks have their parent's visibility unless they have one of their own.
template <typename Use>
void ForEachVisible(vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes,
  bool inherits, bool visible, const Use& use)
{
  if (attributes && attributes->HasBlockVisibility(data))
  {
    visible = attributes->GetBlockVisibility(data);
  }
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    if (visible)
    {
      use(data);
    }
    return;
  }
  auto it = vtk::TakeSmartPointer(composite->NewIterator());
  if (auto* children = vtkDataObjectTreeIterator::SafeDownCast(it))
  {
    children->VisitOnlyLeavesOff();
    children->TraverseSubTreeOff();
  }
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    ForEachVisible(it->GetCurrentDataObject(), attributes, inherits, !inherits || visible, use);
  }
}

// What lies on the cut-off side of a mapper's clipping plane (n.x < d) does not cast: triangles are
// cut by it (Sutherland and Hodgman 1974).
void ClipBy(Geometry& out, const glm::dvec4& plane)
{
  const auto height = [&plane](const glm::vec3& v)
  { return glm::dot(glm::dvec3(plane), glm::dvec3(v)) - plane.w; };
  std::vector<glm::uvec3> kept;
  for (const glm::uvec3& triangle : out.Triangles)
  {
    unsigned int corners[4];
    int count = 0;
    for (int i = 0; i < 3; ++i)
    {
      const unsigned int a = triangle[i], b = triangle[(i + 1) % 3];
      const glm::vec3 from = out.Vertices[a], to = out.Vertices[b];
      const double fromHeight = height(from), toHeight = height(to);
      if (fromHeight >= 0.0)
      {
        corners[count++] = a;
      }
      if ((fromHeight >= 0.0) != (toHeight >= 0.0))
      {
        corners[count++] = static_cast<unsigned int>(out.Vertices.size());
        out.Vertices.emplace_back(
          glm::mix(glm::dvec3(from), glm::dvec3(to), fromHeight / (fromHeight - toHeight)));
      }
    }
    for (int i = 1; i + 1 < count; ++i)
    {
      kept.emplace_back(corners[0], corners[i], corners[i + 1]);
    }
  }
  out.Triangles.swap(kept);
}

void ClipByPlanes(Geometry& out, vtkMapper* mapper, const glm::dmat4& worldFromTrace)
{
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    double normal[3], origin[3];
    planes->GetItem(i)->GetNormal(normal);
    planes->GetItem(i)->GetOrigin(origin);
    const glm::dvec3 n(normal[0], normal[1], normal[2]);
    const double d = glm::dot(n, glm::dvec3(origin[0], origin[1], origin[2]));
    // A plane is a row, (n, -d).
    const glm::dvec4 row = glm::dvec4(n, -d) * worldFromTrace;
    ClipBy(out, glm::dvec4(glm::dvec3(row), -row.w));
    if (!out.Spheres.empty())
    {
      out.Skipped = "clipping planes, which do not cut spheres here";
    }
  }
}

// Largest stretch of a matrix along its axes: what a sphere's radius is scaled by.
double ScaleOf(const glm::dmat4& m)
{
  return std::max({ glm::length(glm::dvec3(m[0])), glm::length(glm::dvec3(m[1])),
    glm::length(glm::dvec3(m[2])) });
}

void AppendSpheres(Geometry& out, vtkOpenGLSphereMapper* mapper, const glm::dmat4& traceFromModel)
{
  vtkPolyData* mesh = mapper->GetInput();
  vtkPoints* points = mesh ? mesh->GetPoints() : nullptr;
  if (!points)
  {
    return;
  }
  const char* name = SphereAccess::ScaleName(mapper);
  vtkDataArray* radii = name ? mesh->GetPointData()->GetArray(name) : nullptr;
  const double scale = ScaleOf(traceFromModel);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    const double radius = radii ? radii->GetComponent(i, 0) : mapper->GetRadius();
    out.Spheres.emplace_back(glm::vec3(traceFromModel * glm::dvec4(p[0], p[1], p[2], 1.0)),
      static_cast<float>(radius * scale));
  }
}

//------------------------------------------------------------------------------
// Glyph instances, placed as vtkOpenGLGlyph3DMapper places them.
class GlyphPlacer
{
public:
  GlyphPlacer(vtkGlyph3DMapper* mapper, vtkDataSet* points)
    : Mapper(mapper)
    , Points(points)
    , Mask(mapper->GetMasking() // VTK heeds bit arrays only
          ? vtkBitArray::SafeDownCast(GlyphAccess::Mask(mapper, points))
          : nullptr)
    , Index(GlyphAccess::Index(mapper, points))
    , Orientation(GlyphAccess::Orientation(mapper, points))
    , Scale(GlyphAccess::Scale(mapper, points))
  {
  }

  bool IsMasked(vtkIdType i) const { return this->Mask && this->Mask->GetValue(i) == 0; }

  int SourceOf(vtkIdType i, int sources) const
  {
    const int index = this->Index ? static_cast<int>(vtkMath::Norm(this->Index->GetTuple(i),
                                      this->Index->GetNumberOfComponents()))
                                  : 0;
    return vtkMath::ClampValue(index, 0, std::max(sources - 1, 0));
  }

  glm::dmat4 ModelFromGlyph(vtkIdType i) const
  {
    double p[3];
    this->Points->GetPoint(i, p);
    glm::dmat4 m = this->Orientation ? this->Rotation(i) : glm::dmat4(1.0);
    m[3] = glm::dvec4(p[0], p[1], p[2], 1.0);
    if (this->Mapper->GetScaling())
    {
      const glm::dvec3 scale = this->ScaleOf(i);
      for (int axis = 0; axis < 3; ++axis)
      {
        m[axis] *= scale[axis] == 0.0 ? 1.0e-10 : scale[axis]; // VTK's own stand-in for zero
      }
    }
    return m;
  }

private:
  glm::dvec3 ScaleOf(vtkIdType i) const
  {
    glm::dvec3 scale(1.0);
    const int mode = this->Mapper->GetScaleMode();
    if (this->Scale && mode == vtkGlyph3DMapper::SCALE_BY_MAGNITUDE)
    {
      scale =
        glm::dvec3(vtkMath::Norm(this->Scale->GetTuple(i), this->Scale->GetNumberOfComponents()));
    }
    else if (this->Scale && mode == vtkGlyph3DMapper::SCALE_BY_COMPONENTS &&
      this->Scale->GetNumberOfComponents() == 3)
    {
      const double* t = this->Scale->GetTuple3(i);
      scale = glm::dvec3(t[0], t[1], t[2]);
    }
    if (this->Scale && this->Mapper->GetClamping() && mode != vtkGlyph3DMapper::NO_DATA_SCALING)
    {
      const double* range = this->Mapper->GetRange();
      const double width = range[1] - range[0] == 0.0 ? 1.0 : range[1] - range[0];
      scale = (glm::clamp(scale, range[0], range[1]) - range[0]) / width;
    }
    return scale * this->Mapper->GetScaleFactor();
  }

  glm::dmat4 Rotation(vtkIdType i) const
  {
    double o[4] = { 0.0, 0.0, 0.0, 0.0 };
    this->Orientation->GetTuple(i, o);
    const int mode = this->Mapper->GetOrientationMode();
    if (mode == vtkGlyph3DMapper::ROTATION)
    {
      // About z, then x, then y, in degrees.
      glm::dmat4 m = glm::rotate(glm::dmat4(1.0), glm::radians(o[2]), glm::dvec3(0, 0, 1));
      m = glm::rotate(m, glm::radians(o[0]), glm::dvec3(1, 0, 0));
      return glm::rotate(m, glm::radians(o[1]), glm::dvec3(0, 1, 0));
    }
    vtkQuaterniond q;
    if (mode == vtkGlyph3DMapper::QUATERNION)
    {
      q.Set(o);
    }
    else if (o[1] != 0.0 || o[2] != 0.0)
    {
      // Half a turn about the bisector of the x axis and the direction.
      const glm::dvec3 d(o[0], o[1], o[2]);
      const glm::dvec3 half = glm::normalize(d + glm::dvec3(glm::length(d), 0.0, 0.0));
      q.Set(0.0, half.x, half.y, half.z);
    }
    else if (o[0] < 0.0)
    {
      q.Set(0.0, 0.0, 1.0, 0.0);
    }
    double rows[3][3];
    q.ToMatrix3x3(rows);
    glm::dmat4 m(1.0);
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        m[column][row] = rows[row][column];
      }
    }
    return m;
  }

  vtkGlyph3DMapper* Mapper;
  vtkDataSet* Points;
  vtkBitArray* Mask;
  vtkDataArray* Index;
  vtkDataArray* Orientation;
  vtkDataArray* Scale;
};

// The data sets that are leaves of `data`.
template <typename Use>
void ForEachDataSet(vtkDataObject* data, const Use& use)
{
  ForEachVisible(data, nullptr, true, true,
    [&use](vtkDataObject* leaf)
    {
      if (auto* dataSet = vtkDataSet::SafeDownCast(leaf))
      {
        use(dataSet);
      }
    });
}

// The data sets at whose points a mapper draws glyphs, in its order.
template <typename Use>
void ForEachGlyphSet(vtkGlyph3DMapper* mapper, const Use& use)
{
  // VTK before 9.3 takes no notice of a hidden branch here.
  constexpr bool inherits = VTK_VERSION_NUMBER >= 90300000000ULL;
  ForEachVisible(mapper->GetInputDataObject(0, 0), Geometry::AttributesOf(mapper), inherits, true,
    [&use](vtkDataObject* leaf)
    {
      auto* points = vtkDataSet::SafeDownCast(leaf);
      if (points && points->GetNumberOfPoints() > 0)
      {
        use(points);
      }
    });
}

void AppendGlyphsAt(
  Geometry& out, vtkGlyph3DMapper* mapper, vtkDataSet* points, const glm::dmat4& traceFromModel)
{
  // Each source once, in its own coordinates; then a copy for every point.
  if (mapper->GetUseSourceTableTree())
  {
    out.Skipped = "glyphs of a source tree";
    return;
  }
  const int count = mapper->GetNumberOfInputConnections(1);
  std::vector<Geometry> sources(count);
  for (int i = 0; i < count; ++i)
  {
    AppendMesh(sources[i], mapper->GetSource(i), glm::dmat4(1.0));
  }
  const GlyphPlacer placer(mapper, points);
  for (vtkIdType i = 0; count > 0 && i < points->GetNumberOfPoints(); ++i)
  {
    if (placer.IsMasked(i))
    {
      continue;
    }
    const Geometry& source = sources[placer.SourceOf(i, count)];
    const glm::dmat4 traceFromGlyph = traceFromModel * placer.ModelFromGlyph(i);
    const auto base = static_cast<unsigned int>(out.Vertices.size());
    for (const glm::vec3& v : source.Vertices)
    {
      out.Vertices.emplace_back(traceFromGlyph * glm::dvec4(v, 1.0));
    }
    for (const glm::uvec3& t : source.Triangles)
    {
      out.Triangles.push_back(base + t);
    }
  }
}

void AppendGlyphs(Geometry& out, vtkGlyph3DMapper* mapper, const glm::dmat4& traceFromModel)
{
  ForEachGlyphSet(
    mapper, [&](vtkDataSet* points) { AppendGlyphsAt(out, mapper, points, traceFromModel); });
}

// How far an impostor reaches from its centre; 0 if the mapper draws none.
double ReachOfImpostors(vtkMapper* mapper)
{
  if (auto* spheres = vtkOpenGLSphereMapper::SafeDownCast(mapper))
  {
    const double largest = LargestOf(spheres->GetInput(), SphereAccess::ScaleName(spheres));
    return largest > 0.0 ? largest : spheres->GetRadius();
  }
  if (auto* sticks = vtkOpenGLStickMapper::SafeDownCast(mapper))
  {
    return LargestOf(sticks->GetInput(), StickAccess::ScaleName(sticks));
  }
  if (auto* splats = vtkPointGaussianMapper::SafeDownCast(mapper))
  {
    // A splat is drawn to three standard deviations.
    const double largest = LargestOf(splats->GetInput(), splats->GetScaleArray());
    return 3.0 * splats->GetScaleFactor() * (largest > 0.0 ? largest : 1.0);
  }
  return 0.0;
}

// Why nothing of a piece has a surface; empty: it has.
std::string SkippedWhole(const vtkShadowScene::Piece& piece)
{
  auto* actor = vtkActor::SafeDownCast(piece.Prop);
  return piece.Mapper->IsA("vtkOpenGLSphereMapper") ? ""
    : piece.Mapper->IsA("vtkOpenGLStickMapper") || piece.Mapper->IsA("vtkPointGaussianMapper")
    ? piece.Mapper->GetClassName()
    : actor && actor->GetProperty()->GetRepresentation() != VTK_SURFACE
    ? "a wireframe or points representation"
    : "";
}

bool IsFinite(vtkDataSet* data)
{
  auto* points = vtkPointSet::SafeDownCast(data);
  vtkDataArray* values = points && points->GetPoints() ? points->GetPoints()->GetData() : nullptr;
  for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
  {
    double p[3];
    values->GetTuple(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      return false;
    }
  }
  return true;
}

void SurveyMesh(Geometry::Survey& survey, vtkDataSet* data, double instances)
{
  auto* mesh = vtkPolyData::SafeDownCast(data);
  if (mesh && mesh->GetNumberOfLines() + mesh->GetNumberOfVerts() > 0)
  {
    survey.NoSurface = "lines and points";
  }
  // A polygon of n corners is drawn as n - 2 triangles, and so is a strip.
  const auto trianglesOf = [](vtkCellArray* cells)
  {
    return static_cast<double>(cells->GetNumberOfConnectivityIds() - 2 * cells->GetNumberOfCells());
  };
  survey.Triangles += instances *
    (mesh ? trianglesOf(mesh->GetPolys()) + trianglesOf(mesh->GetStrips())
          : static_cast<double>(data->GetNumberOfCells()));
  if (!IsFinite(data))
  {
    survey.NoFiniteSurface = "points that are not finite";
  }
}

}

//------------------------------------------------------------------------------
vtkShadowCasterGeometry::Survey vtkShadowCasterGeometry::SurveyOf(
  const vtkShadowScene::Piece& piece)
{
  Survey survey;
  survey.HasSpheres = piece.Mapper->IsA("vtkOpenGLSphereMapper") != 0;
  survey.NoSurface = SkippedWhole(piece);
  vtkDataObject* input = piece.Mapper->GetInputDataObject(0, 0);
  if (survey.HasSpheres)
  {
    survey.NoSurface = piece.Mapper->GetClippingPlanes() ? "clipped spheres" : "";
  }
  else if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(piece.Mapper))
  {
    double points = 0.0;
    ForEachGlyphSet(
      glyphs, [&](vtkDataSet* data) { points += static_cast<double>(data->GetNumberOfPoints()); });
    const int sources = glyphs->GetNumberOfInputConnections(1);
    for (int i = 0; i < sources; ++i)
    {
      ForEachDataSet(glyphs->GetInputDataObject(1, i),
        [&](vtkDataSet* data) { SurveyMesh(survey, data, points / sources); });
    }
    if (glyphs->GetUseSourceTableTree())
    {
      survey.NoSurface = "glyphs of a source tree";
    }
  }
  else if (survey.NoSurface.empty())
  {
    ForEachDataSet(input, [&](vtkDataSet* data) { SurveyMesh(survey, data, 1.0); });
  }
  return survey;
}

//------------------------------------------------------------------------------
bool vtkShadowCasterGeometry::BoundsOf(vtkMapper* mapper, double bounds[6])
{
  mapper->GetBounds(bounds);
  const double reach = ReachOfImpostors(mapper);
  auto* centres = vtkPointSet::SafeDownCast(mapper->GetInputDataObject(0, 0));
  if (reach > 0.0 && centres && centres->GetPoints())
  {
    centres->GetPoints()->GetBounds(bounds);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] -= reach;
    bounds[2 * axis + 1] += reach;
  }
  return bounds[0] <= bounds[1] && bounds[2] <= bounds[3] && bounds[4] <= bounds[5];
}

//------------------------------------------------------------------------------
vtkShadowCasterGeometry::VertexPlace vtkShadowCasterGeometry::PlaceOfVertices(vtkMapper* mapper)
{
  double bounds[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  auto* mesh = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  if (mesh && mesh->GetPoints() && mapper->IsA("vtkPolyDataMapper"))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      mesh->GetPoints()->GetData()->GetRange(bounds + 2 * axis, axis);
    }
  }
  else if (!BoundsOf(mapper, bounds))
  {
    return {};
  }
  const glm::dvec3 low(bounds[0], bounds[2], bounds[4]), high(bounds[1], bounds[3], bounds[5]);
  const glm::dvec3 size = high - low, shift = 0.5 * (high + low);
  const double size2 = glm::dot(size, size), shift2 = glm::dot(shift, shift);
  const bool isMoved =
    (size2 > 0.0 && (shift2 / size2 > 1.0e6 || std::abs(std::log10(size2)) > 3.0)) ||
    (size2 == 0.0 && shift2 > 1.0e6);
  if (!isMoved || !std::isfinite(size2) || !std::isfinite(shift2))
  {
    return {};
  }
  VertexPlace place;
  place.Shift = shift;
  for (int axis = 0; axis < 3; ++axis)
  {
    place.Scale[axis] = size[axis] > 0.0 ? 1.0 / size[axis] : 1.0;
  }
  return place;
}

//------------------------------------------------------------------------------
vtkCompositeDataDisplayAttributes* vtkShadowCasterGeometry::AttributesOf(vtkMapper* mapper)
{
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    return glyphs->GetBlockAttributes();
  }
#if __has_include("vtkCompositePolyDataMapper2.h")
  if (auto* composite2 = vtkCompositePolyDataMapper2::SafeDownCast(mapper))
  {
    return composite2->GetCompositeDataDisplayAttributes();
  }
#endif
#if VTK_VERSION_NUMBER >= 90300000000ULL
  if (auto* composite = vtkCompositePolyDataMapper::SafeDownCast(mapper))
  {
    return composite->GetCompositeDataDisplayAttributes();
  }
#endif
  return nullptr;
}

//------------------------------------------------------------------------------
std::vector<vtkShadowCasterGeometry::GlyphDraw> vtkShadowCasterGeometry::GlyphDrawsOf(
  vtkGlyph3DMapper* mapper)
{
  std::vector<GlyphDraw> draws;
  if (mapper->GetUseSourceTableTree())
  {
    return draws;
  }
  const int count = mapper->GetNumberOfInputConnections(1);
  std::set<vtkDataSet*> known;
  ForEachGlyphSet(mapper,
    [&](vtkDataSet* points)
    {
      if (!known.insert(points).second)
      {
        return;
      }
      std::vector<std::vector<glm::dmat4>> instances(count);
      const GlyphPlacer placer(mapper, points);
      for (vtkIdType i = 0; count > 0 && i < points->GetNumberOfPoints(); ++i)
      {
        if (!placer.IsMasked(i))
        {
          instances[placer.SourceOf(i, count)].push_back(placer.ModelFromGlyph(i));
        }
      }
      for (int i = 0; i < count; ++i)
      {
        if (!instances[i].empty())
        {
          draws.push_back({ points, mapper->GetSource(i), std::move(instances[i]) });
        }
      }
    });
  return draws;
}

//------------------------------------------------------------------------------
vtkShadowCasterGeometry vtkShadowCasterGeometry::Extract(const vtkShadowScene::Piece& piece,
  const glm::dmat4& traceFromModel, const glm::dmat4& worldFromTrace)
{
  Geometry out;
  out.Skipped = SkippedWhole(piece);
  if (auto* spheres = vtkOpenGLSphereMapper::SafeDownCast(piece.Mapper))
  {
    AppendSpheres(out, spheres, traceFromModel);
  }
  else if (!out.Skipped.empty())
  {
  }
  else if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(piece.Mapper))
  {
    AppendGlyphs(out, glyphs, traceFromModel);
  }
  else
  {
    ForEachVisible(piece.Mapper->GetInputDataObject(0, 0), AttributesOf(piece.Mapper), true, true,
      [&](vtkDataObject* leaf) { AppendDataSet(out, leaf, traceFromModel); });
  }
  ClipByPlanes(out, piece.Mapper, worldFromTrace);
  return out;
}
