#include "vtkRayCastShadowPass.h"

#include "LightSamples.h"
#include "vtkShadowCasterGeometry.h"
#include "vtkShadowReceiverBuffer.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowTextureArray.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#if VTKSHADOWS_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>

vtkStandardNewMacro(vtkRayCastShadowPass);

namespace
{

using Clock = std::chrono::steady_clock;

// Passes may outlive Embree's globals: pvbatch destroys its views after them when a script ends by
// sys.exit. This is destroyed before them, since this library needs theirs.
bool EmbreeIsGone = false;
struct TheEnd
{
  ~TheEnd() { EmbreeIsGone = true; }
} theEnd;

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

bool IsOccluded(RTCScene scene, RTCRay& ray)
{
#if RTC_VERSION_MAJOR >= 4
  rtcOccluded1(scene, &ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcOccluded1(scene, &context, &ray);
#endif
  return ray.tfar < 0.0f;
}

constexpr int Width = 8; // rays traced together

// Receivers side by side, for loops that compilers vectorise.
struct alignas(32) ReceiverLanes
{
  std::size_t Pixel[Width];
  float X[Width], Y[Width], Z[Width], Code[Width]; // as the receiver buffer has them
  float FromX[Width], FromY[Width], FromZ[Width];  // where their rays start, the tree's coordinates
  int Count = 0;

  void Add(std::size_t pixel, const float* value)
  {
    const int i = this->Count++;
    this->Pixel[i] = pixel;
    this->X[i] = value[0];
    this->Y[i] = value[1];
    this->Z[i] = value[2];
    this->Code[i] = value[3];
  }
};

// From the eye's view coordinates to the tree's: relative to the casters' centre, of size about 1.
class TraceFrame
{
public:
  TraceFrame(const glm::dmat4& traceFromView, double scale, double vertexReach)
    : TraceFromView(traceFromView)
    , Turn(glm::dmat3(traceFromView) / scale)
    , Scale(static_cast<float>(scale))
    , VertexReach(static_cast<float>(scale * vertexReach))
  {
  }

  // Where rays start: off the face, toward the eye, by `epsilonScale` times the rounding bound of
  // what was done in floats (the drawn vertices, the eye's position of them, this, the tree's).
  void SetOrigins(ReceiverLanes& lanes, float epsilonScale) const
  {
    constexpr float RoundingUnit = 1.0f / (1 << 22);
    const glm::dmat4& m = this->TraceFromView;
    const glm::mat3& turn = this->Turn;
    for (int i = 0; i < Width; ++i)
    {
      const double x = lanes.X[i], y = lanes.Y[i], z = lanes.Z[i];
      lanes.FromX[i] = static_cast<float>(m[0][0] * x + m[1][0] * y + m[2][0] * z + m[3][0]);
      lanes.FromY[i] = static_cast<float>(m[0][1] * x + m[1][1] * y + m[2][1] * z + m[3][1]);
      lanes.FromZ[i] = static_cast<float>(m[0][2] * x + m[1][2] * y + m[2][2] * z + m[3][2]);
    }
    for (int i = 0; i < Width; ++i)
    {
      const float x = lanes.X[i], y = lanes.Y[i], z = lanes.Z[i];
      const float distance = std::sqrt(x * x + y * y + z * z) * this->Scale;
      const float reach =
        std::abs(lanes.FromX[i]) + std::abs(lanes.FromY[i]) + std::abs(lanes.FromZ[i]);
      const float off = epsilonScale * RoundingUnit * (1.0f + this->VertexReach + distance + reach);
      float nx, ny, nz;
      vtkShadowReceiverBuffer::DecodeNormal(lanes.Code[i], nx, ny, nz);
      lanes.FromX[i] += off * (turn[0][0] * nx + turn[1][0] * ny + turn[2][0] * nz);
      lanes.FromY[i] += off * (turn[0][1] * nx + turn[1][1] * ny + turn[2][1] * nz);
      lanes.FromZ[i] += off * (turn[0][2] * nx + turn[1][2] * ny + turn[2][2] * nz);
    }
  }

private:
  glm::dmat4 TraceFromView;
  glm::mat3 Turn;    // the rotation in TraceFromView
  float Scale;       // trace units in a world unit
  float VertexReach; // of the receivers, trace units
};

// A hard light in the tree's coordinates.
struct TraceLight
{
  bool Directional;
  glm::vec3 Vector; // toward the light, unit; or its position
  // How far from a position rays end: a surface that a lamp lies on, to rounding, hides nothing of
  // it.
  float Short = 0.0f;
};

// The rays of neighbouring pixels go through the same part of the tree, eight at a time.
class RayPacket
{
public:
  explicit RayPacket(RTCScene tree)
    : Tree(tree)
  {
  }

  // Adds `share` to the visibility of every lane's pixel whose ray reaches `light`.
  void Trace(const ReceiverLanes& lanes, const TraceLight& light, float share,
    std::vector<float>& visibility)
  {
    this->Aim(lanes, light);
#if RTC_VERSION_MAJOR >= 4
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcOccluded8(this->Valid, this->Tree, &this->Rays, &arguments);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcOccluded8(this->Valid, this->Tree, &context, &this->Rays);
#endif
    for (int i = 0; i < lanes.Count; ++i)
    {
      visibility[lanes.Pixel[i]] += this->Rays.tfar[i] < 0.0f ? 0.0f : share;
    }
  }

  // Ray i of the last Aim, by itself.
  RTCRay RayOf(int i) const
  {
    RTCRay ray;
    ray.org_x = this->Rays.org_x[i];
    ray.org_y = this->Rays.org_y[i];
    ray.org_z = this->Rays.org_z[i];
    ray.tnear = this->Rays.tnear[i];
    ray.dir_x = this->Rays.dir_x[i];
    ray.dir_y = this->Rays.dir_y[i];
    ray.dir_z = this->Rays.dir_z[i];
    ray.time = this->Rays.time[i];
    ray.tfar = this->Rays.tfar[i];
    ray.mask = this->Rays.mask[i];
    ray.id = this->Rays.id[i];
    ray.flags = this->Rays.flags[i];
    return ray;
  }

  void Aim(const ReceiverLanes& lanes, const TraceLight& light)
  {
    for (int i = 0; i < Width; ++i)
    {
      this->Valid[i] = i < lanes.Count ? -1 : 0;
      this->Rays.org_x[i] = lanes.FromX[i];
      this->Rays.org_y[i] = lanes.FromY[i];
      this->Rays.org_z[i] = lanes.FromZ[i];
      this->Rays.tnear[i] = 0.0f;
      this->Rays.time[i] = 0.0f;
      this->Rays.mask[i] = ~0u;
      this->Rays.id[i] = 0;
      this->Rays.flags[i] = 0;
    }
    if (light.Directional)
    {
      for (int i = 0; i < Width; ++i)
      {
        this->Rays.dir_x[i] = light.Vector.x;
        this->Rays.dir_y[i] = light.Vector.y;
        this->Rays.dir_z[i] = light.Vector.z;
        this->Rays.tfar[i] = std::numeric_limits<float>::infinity();
      }
      return;
    }
    for (int i = 0; i < Width; ++i)
    {
      const float x = light.Vector.x - lanes.FromX[i];
      const float y = light.Vector.y - lanes.FromY[i];
      const float z = light.Vector.z - lanes.FromZ[i];
      const float length = std::sqrt(x * x + y * y + z * z);
      this->Rays.dir_x[i] = x / length;
      this->Rays.dir_y[i] = y / length;
      this->Rays.dir_z[i] = z / length;
      this->Rays.tfar[i] = std::max(length - light.Short, 0.0f);
    }
  }

private:
  RTCRay8 Rays;
  alignas(32) int Valid[Width];
  RTCScene Tree;
};

// Call `use(lanes)` for the receivers of pixels first..last, of these (all, if there are none
// named), eight at a time.
template <typename Use>
void ForEachLanes(const vtkShadowReceiverBuffer& receivers, std::size_t first, std::size_t last,
  const std::vector<unsigned char>* which, const TraceFrame& frame, float epsilonScale,
  const Use& use)
{
  ReceiverLanes lanes = {};
  for (std::size_t i = first; i < last; ++i)
  {
    const float* pixel = receivers.PixelAt(i);
    if ((!which || (*which)[i]) && vtkShadowReceiverBuffer::IsReceiver(pixel))
    {
      lanes.Add(i, pixel);
    }
    if (lanes.Count == Width || (i + 1 == last && lanes.Count > 0))
    {
      frame.SetOrigins(lanes, epsilonScale);
      use(lanes);
      lanes.Count = 0;
    }
  }
}

}

//------------------------------------------------------------------------------
class vtkRayCastShadowPass::Internals
{
public:
  RTCDevice Device = nullptr;
  RTCScene Tree = nullptr;
  bool Built = false;
  vtkMTimeType BuiltStamp = 0;
  glm::dmat4 TraceFromWorld{ 1.0 };
  double Scale = 1.0;
  vtkShadowTextureArray Masks;
  std::atomic<std::int64_t> TreeBytes{ 0 }; // as Embree tells, from all its threads

  ~Internals()
  {
    if (EmbreeIsGone)
    {
      return; // with the process goes its memory
    }
    if (this->Tree)
    {
      rtcReleaseScene(this->Tree);
    }
    if (this->Device)
    {
      rtcReleaseDevice(this->Device);
    }
  }

  TraceFrame FrameOf(const vtkShadowFrame& frame) const
  {
    double reach = 0.0;
    for (const vtkShadowScene::Prop& prop : frame.Scene->GetProps())
    {
      for (const vtkShadowScene::Piece& piece : prop.Pieces)
      {
        reach = prop.Receives ? std::max(reach, piece.VertexReach) : reach;
      }
    }
    return TraceFrame(this->TraceFromWorld * glm::inverse(frame.ViewFromWorld), this->Scale, reach);
  }

  // Rays to a position end before it by `epsilonScale` times its rounding bound and the tree's.
  TraceLight LightOf(const vtkshadows::ShadowLight& light, double epsilonScale) const
  {
    if (light.kind == vtkshadows::LightKind::Directional)
    {
      return { true, glm::vec3(-light.direction) };
    }
    const glm::dvec3 place(this->TraceFromWorld * glm::dvec4(light.position, 1.0));
    const double rounding =
      std::ldexp(1.0 + std::abs(place.x) + std::abs(place.y) + std::abs(place.z), -22);
    return { false, glm::vec3(place), static_cast<float>(epsilonScale * rounding) };
  }

  void PlaceFrame(const vtkShadowScene& scene);
  void AddTriangles(const vtkShadowCasterGeometry& geometry);
  void AddSpheres(const vtkShadowCasterGeometry& geometry);
};

//------------------------------------------------------------------------------
void vtkRayCastShadowPass::Internals::PlaceFrame(const vtkShadowScene& scene)
{
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-low);
  for (const vtkShadowScene::Prop& prop : scene.GetProps())
  {
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      const bool casts = prop.CastsRays && !piece.WideFloor;
      for (const glm::dvec3& corner : piece.CornersWC)
      {
        low = casts ? glm::min(low, corner) : low;
        high = casts ? glm::max(high, corner) : high;
      }
    }
  }
  const double size = 0.5 * glm::length(high - low);
  this->Scale = size > 0.0 && std::isfinite(size) ? 1.0 / size : 1.0;
  const glm::dvec3 centreWC = low.x <= high.x ? 0.5 * (low + high) : glm::dvec3(0.0);
  this->TraceFromWorld =
    glm::translate(glm::scale(glm::dmat4(1.0), glm::dvec3(this->Scale)), -centreWC);
}

//------------------------------------------------------------------------------
void vtkRayCastShadowPass::Internals::AddTriangles(const vtkShadowCasterGeometry& geometry)
{
  RTCGeometry mesh = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* vertices = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
    sizeof(glm::vec3), geometry.Vertices.size());
  void* triangles = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
    sizeof(glm::uvec3), geometry.Triangles.size());
  std::copy(geometry.Vertices.begin(), geometry.Vertices.end(), static_cast<glm::vec3*>(vertices));
  std::copy(
    geometry.Triangles.begin(), geometry.Triangles.end(), static_cast<glm::uvec3*>(triangles));
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(this->Tree, mesh);
  rtcReleaseGeometry(mesh);
}

//------------------------------------------------------------------------------
void vtkRayCastShadowPass::Internals::AddSpheres(const vtkShadowCasterGeometry& geometry)
{
  RTCGeometry spheres = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  void* centres = rtcSetNewGeometryBuffer(spheres, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
    sizeof(glm::vec4), geometry.Spheres.size());
  std::copy(geometry.Spheres.begin(), geometry.Spheres.end(), static_cast<glm::vec4*>(centres));
  rtcCommitGeometry(spheres);
  rtcAttachGeometry(this->Tree, spheres);
  rtcReleaseGeometry(spheres);
}

//------------------------------------------------------------------------------
vtkRayCastShadowPass::vtkRayCastShadowPass()
  : Internal(new Internals)
{
}

vtkRayCastShadowPass::~vtkRayCastShadowPass() = default;

//------------------------------------------------------------------------------
bool vtkRayCastShadowPass::UpdateTree(const vtkShadowFrame& frame)
{
  Internals& my = *this->Internal;
  if (!my.Device)
  {
    my.Device = rtcNewDevice(nullptr);
    if (!my.Device)
    {
      vtkErrorMacro("Embree could not be started (error "
        << rtcGetDeviceError(nullptr)
        << "): lights of the technique \"ray-cast\" are lit. Use \"depth-map\" on this machine.");
      return false;
    }
    rtcSetDeviceMemoryMonitorFunction(
      my.Device,
      [](void* bytes, ssize_t change, bool)
      {
        *static_cast<std::atomic<std::int64_t>*>(bytes) += change;
        return true;
      },
      &my.TreeBytes);
  }
  const vtkMTimeType stamp = frame.Scene->GetCasterStamp();
  if (my.Built && my.BuiltStamp == stamp)
  {
    return true;
  }

  if (my.Tree)
  {
    rtcReleaseScene(my.Tree);
  }
  my.Tree = rtcNewScene(my.Device);
  rtcSetSceneFlags(my.Tree, RTC_SCENE_FLAG_ROBUST);
  my.PlaceFrame(*frame.Scene);
  const glm::dmat4 worldFromTrace = glm::inverse(my.TraceFromWorld);
  this->NumberOfPrimitives = 0;
  for (const vtkShadowScene::Prop& prop : frame.Scene->GetProps())
  {
    std::string skipped;
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      if (!prop.CastsRays || piece.WideFloor)
      {
        continue;
      }
      const vtkShadowCasterGeometry geometry = vtkShadowCasterGeometry::Extract(
        piece, my.TraceFromWorld * piece.WorldFromModel, worldFromTrace);
      this->NumberOfPrimitives +=
        static_cast<vtkIdType>(geometry.Triangles.size() + geometry.Spheres.size());
      skipped = geometry.Skipped.empty() ? skipped : geometry.Skipped;
      if (!geometry.Triangles.empty())
      {
        my.AddTriangles(geometry);
      }
      if (!geometry.Spheres.empty())
      {
        my.AddSpheres(geometry);
      }
    }
    this->WarnOnce(prop.Source,
      skipped.empty()
        ? std::string()
        : std::string("The caster ") + prop.Source->GetClassName() + " has " + skipped +
          ": rays see none of that. Use \"depth-map\", or give it a surface (vtkTubeFilter, "
          "vtkGlyph3DMapper).");
  }
  rtcCommitScene(my.Tree);
  my.Built = true;
  my.BuiltStamp = stamp;
  ++this->NumberOfTreeBuilds;
  return true;
}

//------------------------------------------------------------------------------
bool vtkRayCastShadowPass::TraceVisibility(const vtkShadowFrame& frame,
  const vtkShadowReceiverBuffer& receivers, const vtkshadows::ShadowLight& light,
  double epsilonScale, int samples, std::vector<float>& visibility,
  const std::vector<unsigned char>* which)
{
  if (!this->UpdateTree(frame))
  {
    return false;
  }
  const Internals& my = *this->Internal;
  const std::size_t width = receivers.Width(), height = receivers.Height();
  if (!which)
  {
    visibility.assign(width * height, 1.0f);
  }

  glm::dvec3 centreWC(glm::inverse(my.TraceFromWorld)[3]);
  std::vector<TraceLight> lights;
  for (const vtkshadows::ShadowLight& sample :
    vtkshadows::SampleAreaLight(light, light.radius > 0.0 ? samples : 1, centreWC))
  {
    lights.push_back(my.LightOf(sample, epsilonScale));
  }

  const TraceFrame trace = my.FrameOf(frame);
  const float share = 1.0f / static_cast<float>(lights.size());
  const auto start = Clock::now();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, height, 8),
    [&](const tbb::blocked_range<std::size_t>& rows)
    {
      RayPacket packet(my.Tree);
      ForEachLanes(receivers, rows.begin() * width, rows.end() * width, which, trace,
        static_cast<float>(epsilonScale),
        [&](const ReceiverLanes& lanes)
        {
          for (int i = 0; i < lanes.Count; ++i)
          {
            visibility[lanes.Pixel[i]] = 0.0f;
          }
          for (const TraceLight& sample : lights)
          {
            packet.Trace(lanes, sample, share, visibility);
          }
        });
    });
  this->TraceSeconds += SecondsSince(start);
  return true;
}

//------------------------------------------------------------------------------
bool vtkRayCastShadowPass::UpdateVisibility(
  const vtkShadowFrame& frame, const std::vector<int>& lights)
{
  Internals& my = *this->Internal;
  this->TraceSeconds = 0.0;
  this->NumberOfRays = 0;
  my.Masks.Reserve(frame.Window, vtkShadowTextureArray::Format::R8, frame.Size[0], frame.Size[1],
    static_cast<int>(lights.size()));
  if (!my.Masks.Id() || !frame.Receivers->Draw(frame))
  {
    this->WarnOnce(this,
      "The driver cannot hold a receiver buffer of " + std::to_string(frame.Size[0]) + " x " +
        std::to_string(frame.Size[1]) + " pixels and " + std::to_string(lights.size()) +
        " masks: their lights are lit. Use a smaller window or fewer lights.");
    return false;
  }
  this->WarnOnce(this, "");

  const auto receivers = static_cast<vtkIdType>(frame.Receivers->CountReceivers());
  std::vector<float> visibility;
  std::vector<unsigned char> mask;
  for (std::size_t slot = 0; slot < lights.size(); ++slot)
  {
    const vtkShadowScene::Light& light = frame.Scene->GetLights()[lights[slot]];
    if (!this->TraceVisibility(
          frame, *frame.Receivers, light.Ray, this->EpsilonScale, this->LightSamples, visibility))
    {
      return false;
    }
    mask.resize(visibility.size());
    std::transform(visibility.begin(), visibility.end(), mask.begin(),
      [](float v) { return static_cast<unsigned char>(v * 255.0f + 0.5f); });
    my.Masks.Upload(static_cast<int>(slot), mask.data());
    this->NumberOfRays += receivers * (light.Ray.radius > 0.0 ? this->LightSamples : 1);
  }
  return true;
}

//------------------------------------------------------------------------------
double vtkRayCastShadowPass::TimeBareTracing(const vtkShadowFrame& frame)
{
  Internals& my = *this->Internal;
  if (!my.Built || !frame.Receivers->Draw(frame))
  {
    return 0.0;
  }
  // The rays first, so that only their tracing is timed.
  const TraceFrame trace = my.FrameOf(frame);
  const std::size_t pixels =
    static_cast<std::size_t>(frame.Receivers->Width()) * frame.Receivers->Height();
  std::vector<RTCRay> rays;
  for (const vtkShadowScene::Light& light : frame.Scene->GetLights())
  {
    if (light.AtEye)
    {
      continue;
    }
    const TraceLight hard = my.LightOf(light.Ray, this->EpsilonScale);
    RayPacket packet(my.Tree);
    ForEachLanes(*frame.Receivers, 0, pixels, nullptr, trace,
      static_cast<float>(this->EpsilonScale),
      [&](const ReceiverLanes& lanes)
      {
        packet.Aim(lanes, hard);
        for (int i = 0; i < lanes.Count; ++i)
        {
          rays.push_back(packet.RayOf(i));
        }
      });
  }
  const auto start = Clock::now();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rays.size(), 4096),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        IsOccluded(my.Tree, rays[i]);
      }
    });
  return SecondsSince(start);
}

//------------------------------------------------------------------------------
vtkShadowTextureArray* vtkRayCastShadowPass::GetTextures()
{
  return &this->Internal->Masks;
}

//------------------------------------------------------------------------------
vtkIdType vtkRayCastShadowPass::GetTextureMemory() const
{
  return static_cast<vtkIdType>(this->Internal->Masks.Bytes());
}

vtkIdType vtkRayCastShadowPass::GetCasterMemory() const
{
  return static_cast<vtkIdType>(this->Internal->TreeBytes);
}

//------------------------------------------------------------------------------
void vtkRayCastShadowPass::ReleaseGraphicsResources(vtkWindow* w)
{
  this->Internal->Masks.Release();
  this->Superclass::ReleaseGraphicsResources(w);
}

//------------------------------------------------------------------------------
void vtkRayCastShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LightSamples: " << this->LightSamples << "\n";
  os << indent << "EpsilonScale: " << this->EpsilonScale << "\n";
  os << indent << "NumberOfRays: " << this->NumberOfRays << "\n";
  os << indent << "TraceSeconds: " << this->TraceSeconds << "\n";
  os << indent << "NumberOfPrimitives: " << this->NumberOfPrimitives << "\n";
  os << indent << "NumberOfTreeBuilds: " << this->NumberOfTreeBuilds << "\n";
}
