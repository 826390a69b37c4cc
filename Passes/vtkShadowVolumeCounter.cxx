#include "vtkShadowVolumeCounter.h"

#include "vtkShadowDrawScope.h"
#include "vtkShadowFullScreen.h"
#include "vtkShadowMatrix.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowOverlay.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowSumFS.h"
#include "vtkShadowedShadingPass.h"
#include "vtkStencilShadowVolumePassCountsFS.h"
#include "vtkStencilShadowVolumePassFS.h"
#include "vtkStencilShadowVolumePassResolveFS.h"
#include "vtkStencilShadowVolumePassSmoothFS.h"
#include "vtkStencilShadowVolumePassVS.h"
#include "vtkStencilShadowVolumePassViewFS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

#include <glm/matrix.hpp>

#include <array>
#include <cmath>
#include <string>

namespace
{

// Faces are pushed back by as many steps of the depth buffer: more than different matrix arithmetic
// puts between a cap and the surface that it lies on, and all of them alike, so that volumes stay
// closed.
constexpr float PushedBack = 4.0f;

// A volume is farther from a receiver than that if its bounds are, in depth.
constexpr double DepthMargin = 4.0 * PushedBack / (1 << 24);

constexpr int MostInStencil = 255;

// Steps between sample lights' shadows are smoothed if they are no higher than so many of one
// light.
constexpr float SmoothedSteps = 2.0f;

// Sides of soup are drawn by the same indices over and over, of so many triangles.
constexpr std::uint32_t SoupBatch = 512;

// Indices of one triangle's sides, by the number of its borders and whether all images are one;
// each table of a batch follows on the one before.
struct SoupTable
{
  int Borders;
  bool OneImage;
  std::size_t Size() const { return static_cast<std::size_t>(this->Borders) * (OneImage ? 3 : 6); }
};
constexpr SoupTable SoupTables[] = { { 3, false }, { 3, true }, { 2, false }, { 2, true } };

// The side from the corner at `step` of the way round to the next, as VolumeLists has sides.
void AppendSide(
  std::vector<std::uint16_t>& indices, std::uint32_t triangle, int step, bool oneImage)
{
  const auto from = static_cast<std::uint16_t>(6 * triangle + 2 * step);
  const auto to = static_cast<std::uint16_t>(6 * triangle + 2 * ((step + 1) % 3));
  indices.insert(indices.end(), { to, from, static_cast<std::uint16_t>(from + 1) });
  if (!oneImage)
  {
    indices.insert(indices.end(),
      { to, static_cast<std::uint16_t>(from + 1), static_cast<std::uint16_t>(to + 1) });
  }
}

GLuint MakeSoupIndices()
{
  std::vector<std::uint16_t> indices;
  for (const SoupTable& table : SoupTables)
  {
    for (std::uint32_t triangle = 0; triangle < SoupBatch; ++triangle)
    {
      for (int step = 0; step < table.Borders; ++step)
      {
        AppendSide(indices, triangle, step, table.OneImage);
      }
    }
  }
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
    static_cast<GLsizeiptr>(indices.size() * sizeof(indices[0])), indices.data(), GL_STREAM_DRAW);
  return buffer;
}

// Whether anything is drawn for the soup of a caster, or for all else.
bool HasFaces(const vtkShadowVolumeCaster::Volume& volume, bool soup)
{
  const std::size_t ofSoup = volume.Lists.turnedThreeSided.End();
  return soup ? ofSoup > 0 : ofSoup < volume.Lists.Count();
}

const void* OffsetOf(std::size_t first, std::size_t size)
{
  return reinterpret_cast<const void*>(first * size);
}

void EndDepthBounds()
{
#ifdef GL_EXT_depth_bounds_test
  if (VTKSHADOWS_GL_HAS(EXT_depth_bounds_test))
  {
    glDisable(GL_DEPTH_BOUNDS_TEST_EXT);
  }
#endif
}

void SetVector(vtkShaderProgram* program, const char* name, const glm::dvec4& v)
{
  const float values[4] = { static_cast<float>(v.x), static_cast<float>(v.y),
    static_cast<float>(v.z), static_cast<float>(v.w) };
  program->SetUniform4f(name, values);
}

void DrawLines(const std::vector<std::uint32_t>& indices)
{
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
    static_cast<GLsizeiptr>(indices.size() * sizeof(indices[0])), indices.data(), GL_STREAM_DRAW);
  glDrawElements(GL_LINES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  glDeleteBuffers(1, &buffer);
}

}

//------------------------------------------------------------------------------
vtkShadowVolumeCounter::vtkShadowVolumeCounter() = default;
vtkShadowVolumeCounter::~vtkShadowVolumeCounter() = default;

//------------------------------------------------------------------------------
bool vtkShadowVolumeCounter::Reserve(const vtkShadowFrame& frame, bool sums)
{
  using Format = vtkShadowTextureArray::Format;
  const int width = frame.Size[0], height = frame.Size[1];
  this->Depth.Reserve(frame.Window, Format::Depth24Stencil8, width, height, 1);
  if (sums)
  {
    this->Sums.Reserve(frame.Window, Format::R32F, width, height, 1);
  }
  this->DepthBounds = MayUseDepthBounds();
  return this->Depth.Id() != 0 && (!sums || this->Sums.Id() != 0);
}

//------------------------------------------------------------------------------
bool vtkShadowVolumeCounter::DrawReceivers(
  const vtkShadowFrame& frame, const vtkshadows::LightView& view)
{
  vtkShadowDrawScope target(frame.Window, this->Depth, 0);
  if (!target.IsComplete())
  {
    return false;
  }
  target.Clear(nullptr);
  frame.Shading->DrawDepths(frame, view);
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowVolumeCounter::Count(
  const vtkShadowFrame& frame, const Eye& eye, const std::vector<Draw>& draws, int start, Way way)
{
  if (way == Way::Stencil && start < MostInStencil && this->Begin(frame, eye, start, way))
  {
    for (const Draw& draw : draws)
    {
      this->Add(draw, Phase::Additions);
    }
    if (!this->HasOverflown())
    {
      for (const Draw& draw : draws)
      {
        this->Add(draw, Phase::Subtractions);
      }
      this->End();
      return true;
    }
    this->End();
    ++this->NumberOfOverflows;
  }
  if (!this->Begin(frame, eye, start, way == Way::WrappingStencil ? way : Way::Float))
  {
    return false;
  }
  for (const Draw& draw : draws)
  {
    this->Add(draw, Phase::Everything);
  }
  this->End();
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowVolumeCounter::Begin(const vtkShadowFrame& frame, const Eye& eye, int start, Way way)
{
  this->CurrentWay = way;
  if (!this->UsesStencil())
  {
    this->Counts.Reserve(
      frame.Window, vtkShadowTextureArray::Format::R32F, frame.Size[0], frame.Size[1], 1);
    if (!this->Counts.Id())
    {
      return false;
    }
  }
  this->Scope.reset(new vtkShadowDrawScope(
    frame.Window, this->Depth, 0, this->UsesStencil() ? nullptr : &this->Counts, 0));
  if (!this->Scope->IsComplete())
  {
    this->Scope.reset();
    return false;
  }
  this->State = frame.Window->GetState();
  this->CurrentEye = eye;
  this->State->vtkglDepthMask(GL_FALSE);
  this->State->vtkglDisable(GL_CULL_FACE);
  if (this->UsesStencil())
  {
    const GLint count = start & MostInStencil;
    this->State->vtkglStencilMask(0xff);
    glClearBufferiv(GL_STENCIL, 0, &count);
    this->State->vtkglEnable(GL_STENCIL_TEST);
    this->State->vtkglStencilFunc(GL_ALWAYS, 0, 0xff);
  }
  else
  {
    const float count[4] = { static_cast<float>(start), 0.0f, 0.0f, 0.0f };
    glClearBufferfv(GL_COLOR, 0, count);
    this->State->vtkglEnable(GL_BLEND);
    this->State->vtkglBlendEquation(GL_FUNC_ADD);
    this->State->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  }
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(0.0f, PushedBack);
  if (eye.UsesDepthClamp)
  {
    glEnable(GL_DEPTH_CLAMP);
  }
  this->StartVolumes(frame, vtkStencilShadowVolumePassFS);
  return true;
}

//------------------------------------------------------------------------------
// Between these, SetCaster readies the volume of a caster to be drawn.
void vtkShadowVolumeCounter::StartVolumes(const vtkShadowFrame& frame, const char* fragmentShader)
{
  glGenVertexArrays(1, &this->Arrays);
  glBindVertexArray(this->Arrays);
  this->Frame = &frame;
  this->FragmentShader = fragmentShader;
  this->Programs = {};
  this->PointUnit = this->State->GetTextureUnitManager()->Allocate();
  this->ListUnit = this->State->GetTextureUnitManager()->Allocate();
}

void vtkShadowVolumeCounter::EndVolumes()
{
  EndDepthBounds();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  glBindVertexArray(0);
  glDeleteVertexArrays(1, &this->Arrays);
  if (this->SoupIndices)
  {
    glDeleteBuffers(1, &this->SoupIndices);
    this->SoupIndices = 0;
  }
  glDisable(GL_DEPTH_CLAMP);
  for (int* unit : { &this->ListUnit, &this->PointUnit })
  {
    this->State->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(*unit));
    glBindTexture(GL_TEXTURE_BUFFER, 0);
    this->State->GetTextureUnitManager()->Free(*unit);
    *unit = -1;
  }
}

//------------------------------------------------------------------------------
// Whether any count stands at the stencil's end, where it may have been held up.
bool vtkShadowVolumeCounter::HasOverflown()
{
  EndDepthBounds();
  GLuint query = 0;
  GLuint any = 0;
  this->State->vtkglDisable(GL_SCISSOR_TEST);
  this->State->vtkglDisable(GL_DEPTH_TEST);
  this->State->vtkglDisable(GL_CULL_FACE);
  this->State->vtkglStencilFunc(GL_EQUAL, MostInStencil, 0xff);
  this->State->vtkglStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  vtkShadowFullScreen::Ready(this->Frame->Window, vtkStencilShadowVolumePassFS);
  glGenQueries(1, &query);
  glBeginQuery(GL_ANY_SAMPLES_PASSED, query);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEndQuery(GL_ANY_SAMPLES_PASSED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &any);
  glDeleteQueries(1, &query);
  this->State->vtkglStencilFunc(GL_ALWAYS, 0, 0xff);
  this->State->vtkglEnable(GL_DEPTH_TEST);
  return any != 0;
}

//------------------------------------------------------------------------------
// What DrawFaces draws from now on.
void vtkShadowVolumeCounter::SetCaster(const Draw& draw, const glm::dmat4& clipFromWorld, bool soup)
{
  const vtkShadowVolumeCaster& caster = *draw.Caster;
  const vtkShadowVolumeCaster::Volume& volume = *draw.Volume;
  this->Caster = &caster;
  this->Volume = &volume;
  this->Soup = soup;
  vtkOpenGLShaderCache* cache = this->Frame->Window->GetShaderCache();
  vtkShaderProgram*& program = this->Programs[soup ? 1 : 0];
  if (program)
  {
    cache->ReadyShaderProgram(program);
  }
  else
  {
    std::string vertexShader = vtkStencilShadowVolumePassVS;
    if (soup)
    {
      vtkShaderProgram::Substitute(
        vertexShader, "//VTK::System::Dec", "//VTK::System::Dec\n#define SHADOW_SOUP");
    }
    program = cache->ReadyShaderProgram(vertexShader.c_str(), this->FragmentShader.c_str(), "");
  }
  this->Program = program;
  const glm::dmat4 worldFromCaster = caster.GetWorldFromCaster();
  std::array<float, 16> clipFromCaster = vtkShadowMatrix::ToFloats(clipFromWorld * worldFromCaster);
  program->SetUniformMatrix4x4("shadowClipFromCaster", clipFromCaster.data());
  SetVector(program, "shadowLightTC", volume.LightTC);
  // A plane is a row.
  const glm::dvec4 farRow =
    glm::dvec4(glm::dvec3(draw.FarPlaneWC), -draw.FarPlaneWC.w) * worldFromCaster;
  SetVector(program, "shadowFarPlaneTC", glm::dvec4(glm::dvec3(farRow), -farRow.w));
  program->SetUniformi("shadowNearSide", 0);
  program->SetUniformi("shadowPointsTC", this->PointUnit);
  caster.Bind(this->State, volume, this->PointUnit, this->ListUnit);
  if (soup)
  {
    program->SetUniformi("shadowSoup", this->ListUnit);
    program->SetUniformi(
      "shadowSoupFirstPoint", static_cast<int>(caster.GetMesh().soup.firstPoint));
    if (!this->SoupIndices)
    {
      this->SoupIndices = MakeSoupIndices();
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->SoupIndices);
  }
}

//------------------------------------------------------------------------------
// Sides of soup with so many borders, or caps (0 borders); how many triangles.
std::size_t vtkShadowVolumeCounter::DrawSoup(
  const vtkshadows::VolumeLists::List& list, int borders, bool turned)
{
  if (list.count == 0)
  {
    return 0;
  }
  ++this->NumberOfDraws;
  this->Program->SetUniformi("shadowSoupFirst", static_cast<int>(list.first));
  this->Program->SetUniformi("shadowSoupTurned", turned ? 1 : 0);
  this->Program->SetUniformi("shadowSoupCaps", borders == 0 ? 1 : 0);
  if (borders == 0)
  {
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * list.count));
    return list.count;
  }
  std::size_t start = 0;
  const SoupTable* table = SoupTables;
  for (; table->Borders != borders || table->OneImage != this->Volume->OneImage; ++table)
  {
    start += SoupBatch * table->Size();
  }
  for (std::size_t first = 0; first < list.count; first += SoupBatch)
  {
    const std::size_t size = std::min<std::size_t>(SoupBatch, list.count - first);
    glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(size * table->Size()),
      GL_UNSIGNED_SHORT, OffsetOf(start, sizeof(std::uint16_t)), static_cast<GLint>(6 * first));
  }
  return list.count * table->Size() / 3;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowVolumeCounter::DrawFacesOfSoup(Faces faces)
{
  const vtkshadows::VolumeLists& lists = this->Volume->Lists;
  switch (faces)
  {
    case Faces::Sides:
      return this->DrawSoup(lists.threeSided, 3, false) + this->DrawSoup(lists.twoSided, 2, false) +
        this->DrawSoup(lists.turnedTwoSided, 2, true) +
        this->DrawSoup(lists.turnedThreeSided, 3, true);
    case Faces::Caps:
      return this->DrawSoup(lists.threeSided, 0, false) + this->DrawSoup(lists.twoSided, 0, false);
    case Faces::TurnedCaps:
      return this->DrawSoup(lists.turnedTwoSided, 0, false) +
        this->DrawSoup(lists.turnedThreeSided, 0, false);
    default:
      return 0;
  }
}

//------------------------------------------------------------------------------
// How many triangles were drawn: of soup a list a call, else all of them by one. An index is twice
// a point's number, and one more for its image; so caps are drawn at the far end by the indices
// that they have, with one added.
std::size_t vtkShadowVolumeCounter::DrawFaces(const Parts& parts)
{
  std::size_t triangles = 0;
  if (this->Soup)
  {
    for (const Part& part : parts)
    {
      this->Program->SetUniformi("shadowSoupImages", part.Images ? 1 : 0);
      triangles += this->DrawFacesOfSoup(part.Of);
    }
    return triangles;
  }
  const vtkshadows::VolumeLists& lists = this->Volume->Lists;
  std::vector<GLsizei> counts;
  std::vector<const void*> offsets;
  std::vector<GLint> added;
  for (const Part& part : parts)
  {
    const vtkshadows::VolumeLists::List& list = part.Of == Faces::Sides ? lists.singles
      : part.Of == Faces::DoubleSides                                   ? lists.doubles
      : part.Of == Faces::Caps                                          ? lists.caps
                                                                        : lists.turnedCaps;
    if (list.count > 0)
    {
      counts.push_back(static_cast<GLsizei>(list.count));
      offsets.push_back(OffsetOf(list.first, sizeof(std::uint32_t)));
      added.push_back(part.Images ? 1 : 0);
      triangles += list.count / 3;
    }
  }
  if (!counts.empty())
  {
    ++this->NumberOfDraws;
    glMultiDrawElementsBaseVertex(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, offsets.data(),
      static_cast<GLsizei>(counts.size()), added.data());
  }
  return triangles;
}

//------------------------------------------------------------------------------
// Adds `front` for a face toward the eye, and `back` for one away from it, where it lies behind the
// receiver or before it.
void vtkShadowVolumeCounter::CountFaces(
  const Parts& parts, int front, int back, bool behind, Phase phase)
{
  // A tie counts as behind, so that a lit surface is not in the volume that starts on it.
  this->State->vtkglDepthFunc(behind && !this->UsesStencil() ? GL_GEQUAL : GL_LESS);
  if (this->UsesStencil())
  {
    const bool wraps = this->CurrentWay == Way::WrappingStencil;
    const GLenum sides[2] = { GL_FRONT, GL_BACK };
    const int weights[2] = { front, back };
    for (int i = 0; i < 2; ++i)
    {
      const GLenum change =
        weights[i] > 0 ? (wraps ? GL_INCR_WRAP : GL_INCR) : (wraps ? GL_DECR_WRAP : GL_DECR);
      this->State->vtkglStencilOpSeparate(
        sides[i], GL_KEEP, behind ? change : GL_KEEP, behind ? GL_KEEP : change);
    }
    if (phase != Phase::Everything)
    {
      const bool wantsFront = (front > 0) == (phase == Phase::Additions);
      const bool wantsBack = (back > 0) == (phase == Phase::Additions);
      if (!wantsFront && !wantsBack)
      {
        return;
      }
      if (wantsFront && wantsBack)
      {
        this->State->vtkglDisable(GL_CULL_FACE);
      }
      else
      {
        this->State->vtkglEnable(GL_CULL_FACE);
        this->State->vtkglCullFace(wantsFront ? GL_BACK : GL_FRONT);
      }
    }
  }
  else
  {
    const float weights[2] = { static_cast<float>(front), static_cast<float>(back) };
    this->Program->SetUniform2f("shadowWeights", weights);
  }
  const std::size_t triangles = this->DrawFaces(parts);
  this->NumberOfTriangles += phase == Phase::Subtractions ? 0 : triangles;
}

//------------------------------------------------------------------------------
bool vtkShadowVolumeCounter::MayUseDepthBounds()
{
#ifdef GL_EXT_depth_bounds_test
  // Mesa 26.1's llvmpipe has them, and with them most counts come out wrong; a single pixel that is
  // tried comes out right. Mesa's softpipe has them, and counts rightly.
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return VTKSHADOWS_GL_HAS(EXT_depth_bounds_test) && glDepthBoundsEXT && renderer &&
    std::string(renderer).find("llvmpipe") == std::string::npos;
#else
  return false;
#endif
}

//------------------------------------------------------------------------------
// A receiver before all of a volume, or behind all of it, has as many ways in as out to count: none
// of them need be drawn there (McGuire et al. 2003). Not of the classical ways, whose faults are to
// be seen.
void vtkShadowVolumeCounter::ConfineDepths(const Draw& draw) const
{
#ifdef GL_EXT_depth_bounds_test
  if (this->CurrentEye.UsesDepthClamp && this->HasDepthBounds())
  {
    const double low = 0.5 * draw.Bounds.minimum.z + 0.5, high = 0.5 * draw.Bounds.maximum.z + 0.5;
    glEnable(GL_DEPTH_BOUNDS_TEST_EXT);
    glDepthBoundsEXT(std::max(low - DepthMargin, 0.0), std::min(high + DepthMargin, 1.0));
  }
#else
  (void)draw;
#endif
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::Add(const Draw& draw, Phase phase)
{
  const int width = this->Frame->Size[0], height = this->Frame->Size[1];
  const glm::dvec3 low = 0.5 * draw.Bounds.minimum + 0.5, high = 0.5 * draw.Bounds.maximum + 0.5;
  const int left = std::max(static_cast<int>(std::floor(low.x * width)) - 1, 0);
  const int bottom = std::max(static_cast<int>(std::floor(low.y * height)) - 1, 0);
  const int right = std::min(static_cast<int>(std::ceil(high.x * width)) + 1, width);
  const int top = std::min(static_cast<int>(std::ceil(high.y * height)) + 1, height);
  if (right <= left || top <= bottom)
  {
    return;
  }
  this->State->vtkglEnable(GL_SCISSOR_TEST);
  this->State->vtkglScissor(left, bottom, right - left, top - bottom);
  this->ConfineDepths(draw);
  for (const bool soup : { false, true })
  {
    if (HasFaces(*draw.Volume, soup))
    {
      this->SetCaster(draw, this->CurrentEye.ClipFromWorld, soup);
      this->AddFaces(draw, phase);
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::AddFaces(const Draw& draw, Phase phase)
{
  // Behind a receiver a face away from the eye is where the way out of a volume is; before it, one
  // toward the eye is the way in. A mirrored caster shows its faces the other way round.
  const bool behind = draw.Faces == Rule::Fail;
  const int way = (behind ? -1 : 1) * (this->Caster->IsMirrored() ? -1 : 1);
  Parts outward = { { Faces::Sides }, { Faces::DoubleSides }, { Faces::DoubleSides } };
  Parts inward;
  if (behind)
  {
    // A face that the near plane cuts is cut into other triangles, and seen edge-on those have
    // other depths: a cap must be cut as the receiver is that it lies on. What it loses lies before
    // every receiver and would not be counted.
    if (draw.ClipsCaps && this->CurrentEye.UsesDepthClamp)
    {
      glDisable(GL_DEPTH_CLAMP);
      this->CountFaces({ { Faces::Caps } }, way, -way, behind, phase);
      this->CountFaces({ { Faces::TurnedCaps } }, -way, way, behind, phase);
      glEnable(GL_DEPTH_CLAMP);
    }
    else
    {
      outward.push_back({ Faces::Caps });
      inward.push_back({ Faces::TurnedCaps });
    }
    if (draw.FarCaps)
    {
      outward.push_back({ Faces::TurnedCaps, true });
      inward.push_back({ Faces::Caps, true });
    }
  }
  this->CountFaces(outward, way, -way, behind, phase);
  this->CountFaces(inward, -way, way, behind, phase);
  if (draw.Faces == Rule::PassCapped)
  {
    // Every triangle between the light and the near plane shadows that, whichever way it is seen.
    const glm::dvec4& plane = this->CurrentEye.NearPlaneWC;
    this->Program->SetUniformi("shadowNearSide", glm::dot(plane, draw.LightWC) > 0.0 ? 1 : -1);
    SetVector(this->Program, "shadowNearPlaneTC", plane * this->Caster->GetWorldFromCaster());
    glEnable(GL_CLIP_DISTANCE0);
    this->CountFaces({ { Faces::Caps }, { Faces::TurnedCaps } }, 1, 1, behind, phase);
    glDisable(GL_CLIP_DISTANCE0);
  }
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::End()
{
  this->EndVolumes();
  glPolygonOffset(0.0f, 0.0f);
  glDisable(GL_POLYGON_OFFSET_FILL);
  if (this->UsesStencil())
  {
    this->State->vtkglStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  }
  this->Scope.reset();
}

//------------------------------------------------------------------------------
// Draws over the frame, without a trace in its depths; calls use(draw) for each.
template <typename Use>
void vtkShadowVolumeCounter::Show(
  const vtkShadowFrame& frame, const std::vector<Draw>& draws, const Use& use)
{
  this->State = frame.Window->GetState();
  const vtkShadowOverlay::State overlay(this->State);
  glEnable(GL_DEPTH_CLAMP);
  this->StartVolumes(frame, vtkStencilShadowVolumePassViewFS);
  for (const Draw& draw : draws)
  {
    use(draw);
  }
  this->EndVolumes();
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::ShowVolumes(
  const vtkShadowFrame& frame, const glm::dmat4& clipFromWorld, const std::vector<Draw>& draws)
{
  this->Show(frame, draws,
    [&](const Draw& draw)
    {
      const float behind[4] = { 0.9f, 0.6f, 0.0f, 0.12f }, before[4] = { 0.0f, 0.45f, 0.7f, 0.12f };
      for (const bool soup : { false, true })
      {
        if (HasFaces(*draw.Volume, soup))
        {
          this->SetCaster(draw, clipFromWorld, soup);
          this->Program->SetUniform4f(
            "shadowViewColor", draw.Faces == Rule::Fail ? behind : before);
          this->Program->SetUniformf("shadowPulledForward", 0.0f);
          this->DrawFaces({ { Faces::Sides }, { Faces::DoubleSides } });
        }
      }
    });
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::ShowSilhouettes(
  const vtkShadowFrame& frame, const glm::dmat4& clipFromWorld, const std::vector<Draw>& draws)
{
  float widest[2] = { 1.0f, 1.0f };
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, widest);
  this->Show(frame, draws,
    [&](const Draw& draw)
    {
      std::vector<std::uint32_t> single, several;
      draw.Caster->FindSilhouette(*draw.Volume, single, several);
      this->SetCaster(draw, clipFromWorld, false);
      const float one[4] = { 0.95f, 0.9f, 0.25f, 1.0f }, more[4] = { 0.9f, 0.2f, 0.6f, 1.0f };
      this->State->vtkglLineWidth(std::min(2.0f, widest[1]));
      this->Program->SetUniformf("shadowPulledForward", 1.0e-4f);
      this->Program->SetUniform4f("shadowViewColor", one);
      DrawLines(single);
      this->Program->SetUniform4f("shadowViewColor", more);
      DrawLines(several);
      this->State->vtkglLineWidth(1.0f);
    });
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::ShowCounts(const vtkShadowFrame& frame)
{
  vtkOpenGLState* state = frame.Window->GetState();
  const vtkShadowOverlay::State overlay(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  vtkShaderProgram* program =
    vtkShadowFullScreen::Ready(frame.Window, vtkStencilShadowVolumePassCountsFS);
  this->Counts.Activate();
  this->Depth.Activate();
  program->SetUniformi("shadowCounts", this->Counts.Unit());
  program->SetUniformi("shadowDepths", this->Depth.Unit());
  vtkShadowOverlay::PlaceViewport(frame, program);
  vtkShadowFullScreen::Draw();
  this->Depth.Deactivate();
  this->Counts.Deactivate();
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::ResolveFloats(const vtkShadowFrame& frame, float share, bool parity)
{
  vtkShaderProgram* program =
    vtkShadowFullScreen::Ready(frame.Window, vtkStencilShadowVolumePassResolveFS);
  this->Counts.Activate();
  program->SetUniformi("shadowCounts", this->Counts.Unit());
  program->SetUniformi("shadowParity", parity ? 1 : 0);
  program->SetUniformf("shadowShare", share);
  vtkShadowFullScreen::Draw();
  this->Counts.Deactivate();
}

//------------------------------------------------------------------------------
// By the stencil itself: lit where the count is 0, or below it if it wrapped.
void vtkShadowVolumeCounter::ResolveStencil(const vtkShadowFrame& frame, float share, bool parity)
{
  vtkOpenGLState* state = frame.Window->GetState();
  vtkShaderProgram* program =
    vtkShadowFullScreen::Ready(frame.Window, vtkStencilShadowVolumePassFS);
  const float value[2] = { share, share };
  program->SetUniform2f("shadowWeights", value);
  state->vtkglEnable(GL_STENCIL_TEST);
  state->vtkglStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  state->vtkglStencilFunc(GL_EQUAL, 0, parity ? 0x01 : 0xff);
  vtkShadowFullScreen::Draw();
  if (!parity && this->CurrentWay == Way::WrappingStencil)
  {
    state->vtkglStencilFunc(GL_EQUAL, 0x80, 0x80);
    vtkShadowFullScreen::Draw();
  }
  state->vtkglDisable(GL_STENCIL_TEST);
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::Resolve(
  const vtkShadowFrame& frame, vtkShadowTextureArray& masks, int layer, bool parity)
{
  vtkShadowDrawScope target(frame.Window, this->Depth, 0, &masks, layer);
  frame.Window->GetState()->vtkglDisable(GL_DEPTH_TEST);
  if (this->UsesStencil())
  {
    const float shadow[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
    glClearBufferfv(GL_COLOR, 0, shadow);
    this->ResolveStencil(frame, 1.0f, parity);
    return;
  }
  this->ResolveFloats(frame, 1.0f, parity);
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::ClearSum(const vtkShadowFrame& frame)
{
  vtkShadowDrawScope target(frame.Window, this->Depth, 0, &this->Sums, 0);
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 0, nothing);
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::AddToSum(const vtkShadowFrame& frame, float share, bool parity)
{
  vtkShadowDrawScope target(frame.Window, this->Depth, 0, &this->Sums, 0);
  vtkOpenGLState* state = frame.Window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  if (this->UsesStencil())
  {
    this->ResolveStencil(frame, share, parity);
    return;
  }
  this->ResolveFloats(frame, share, parity);
}

//------------------------------------------------------------------------------
bool vtkShadowVolumeCounter::SmoothSum(const vtkShadowFrame& frame, float step)
{
  this->Counts.Reserve(
    frame.Window, vtkShadowTextureArray::Format::R32F, frame.Size[0], frame.Size[1], 1);
  if (!this->Counts.Id())
  {
    return false;
  }
  vtkShadowDrawScope target(frame.Window, this->Depth, 0, &this->Counts, 0);
  frame.Window->GetState()->vtkglDisable(GL_DEPTH_TEST);
  vtkShaderProgram* program =
    vtkShadowFullScreen::Ready(frame.Window, vtkStencilShadowVolumePassSmoothFS);
  this->Sums.Activate();
  program->SetUniformi("shadowSums", this->Sums.Unit());
  program->SetUniformf("shadowLargest", SmoothedSteps * step);
  vtkShadowFullScreen::Draw();
  this->Sums.Deactivate();
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::ResolveSum(
  const vtkShadowFrame& frame, vtkShadowTextureArray& masks, int layer, bool smoothed)
{
  vtkShadowDrawScope target(frame.Window, this->Depth, 0, &masks, layer);
  frame.Window->GetState()->vtkglDisable(GL_DEPTH_TEST);
  vtkShadowTextureArray& sums = smoothed ? this->Counts : this->Sums;
  vtkShaderProgram* program = vtkShadowFullScreen::Ready(frame.Window, vtkShadowSumFS);
  sums.Activate();
  program->SetUniformi("shadowSums", sums.Unit());
  vtkShadowFullScreen::Draw();
  sums.Deactivate();
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::ReadCounts(const vtkShadowFrame& frame, std::vector<float>& counts)
{
  counts.resize(static_cast<std::size_t>(frame.Size[0]) * frame.Size[1]);
  vtkShadowDrawScope target(frame.Window, this->Depth, 0, &this->Counts, 0);
  glReadPixels(0, 0, frame.Size[0], frame.Size[1], GL_RED, GL_FLOAT, counts.data());
}

//------------------------------------------------------------------------------
void vtkShadowVolumeCounter::Release()
{
  this->Depth.Release();
  this->Counts.Release();
  this->Sums.Release();
}
