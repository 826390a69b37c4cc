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

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkRayCastShadowPass);

namespace
{

using Clock = std::chrono::steady_clock;

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

RTCRay MakeRay(const glm::vec3& from, const glm::vec3& along, float length)
{
  RTCRay ray;
  ray.org_x = from.x;
  ray.org_y = from.y;
  ray.org_z = from.z;
  ray.tnear = 0.0f;
  ray.dir_x = along.x;
  ray.dir_y = along.y;
  ray.dir_z = along.z;
  ray.time = 0.0f;
  ray.tfar = length;
  ray.mask = ~0u;
  ray.id = 0;
  ray.flags = 0;
  return ray;
}

// From the eye's view coordinates to the tree's: relative to the casters' centre, of size about 1.
struct TraceFrame
{
  glm::dmat4 TraceFromView;
  double Scale; // trace units in a world unit

  // Where the ray of a receiver starts: off its face by `epsilonScale` times the rounding bound of
  // what was done in floats (the eye's position of it, the tree's vertices), toward the eye.
  glm::dvec3 Origin(const vtkShadowReceiverBuffer::Receiver& receiver, double epsilonScale) const
  {
    const glm::dvec3 onFace(this->TraceFromView * glm::dvec4(receiver.PositionVC, 1.0));
    const glm::dvec3 normal =
      glm::normalize(glm::dvec3(this->TraceFromView * glm::dvec4(receiver.NormalVC, 0.0)));
    const double distance = glm::length(glm::dvec3(receiver.PositionVC)) * this->Scale;
    const double rounding = std::ldexp(distance + 1.0 + glm::length(onFace), -22);
    return onFace + epsilonScale * rounding * normal;
  }
};

// A hard light in the tree's coordinates.
struct TraceLight
{
  bool Directional;
  glm::dvec3 Vector; // toward the light, unit; or its position

  RTCRay RayFrom(const glm::dvec3& origin) const
  {
    if (this->Directional)
    {
      return MakeRay(
        glm::vec3(origin), glm::vec3(this->Vector), std::numeric_limits<float>::infinity());
    }
    const glm::dvec3 to = this->Vector - origin;
    const double distance = glm::length(to);
    return MakeRay(glm::vec3(origin), glm::vec3(to / distance), static_cast<float>(distance));
  }
};

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

  ~Internals()
  {
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
    return { this->TraceFromWorld * glm::inverse(frame.ViewFromWorld), this->Scale };
  }

  TraceLight LightOf(const vtkshadows::ShadowLight& light) const
  {
    if (light.kind == vtkshadows::LightKind::Directional)
    {
      return { true, -light.direction };
    }
    return { false, glm::dvec3(this->TraceFromWorld * glm::dvec4(light.position, 1.0)) };
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
      for (const glm::dvec3& corner : piece.CornersWC)
      {
        low = prop.Casts ? glm::min(low, corner) : low;
        high = prop.Casts ? glm::max(high, corner) : high;
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
  std::copy(
    geometry.Vertices.begin(), geometry.Vertices.end(), static_cast<glm::vec3*>(vertices));
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
  this->NumberOfPrimitives = 0;
  for (const vtkShadowScene::Prop& prop : frame.Scene->GetProps())
  {
    std::string skipped;
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      if (!prop.Casts)
      {
        continue;
      }
      const vtkShadowCasterGeometry geometry =
        vtkShadowCasterGeometry::Extract(piece, my.TraceFromWorld);
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
      skipped.empty() ? std::string()
                      : std::string("The caster ") + prop.Source->GetClassName() + " has " + skipped +
          ", which no ray can hit: that part casts nothing by \"ray-cast\". Use \"depth-map\", or "
          "give it a surface (vtkTubeFilter, vtkGlyph3DMapper).");
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
  double epsilonScale, std::vector<float>& visibility)
{
  if (!this->UpdateTree(frame))
  {
    return false;
  }
  const Internals& my = *this->Internal;
  const std::size_t width = receivers.Width(), height = receivers.Height();
  visibility.assign(width * height, 1.0f);

  glm::dvec3 centreWC(glm::inverse(my.TraceFromWorld)[3]);
  std::vector<TraceLight> samples;
  for (const vtkshadows::ShadowLight& sample : vtkshadows::SampleAreaLight(
         light, light.radius > 0.0 ? this->LightSamples : 1, centreWC))
  {
    samples.push_back(my.LightOf(sample));
  }

  const TraceFrame trace = my.FrameOf(frame);
  const float share = 1.0f / static_cast<float>(samples.size());
  const auto start = Clock::now();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, height, 8),
    [&](const tbb::blocked_range<std::size_t>& rows)
    {
      vtkShadowReceiverBuffer::Receiver receiver;
      for (std::size_t i = rows.begin() * width; i < rows.end() * width; ++i)
      {
        if (!receivers.At(i, receiver))
        {
          continue;
        }
        const glm::dvec3 origin = trace.Origin(receiver, epsilonScale);
        int seen = 0;
        for (const TraceLight& sample : samples)
        {
          RTCRay ray = sample.RayFrom(origin);
          seen += IsOccluded(my.Tree, ray) ? 0 : 1;
        }
        visibility[i] = static_cast<float>(seen) * share;
      }
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

  std::vector<float> visibility;
  std::vector<unsigned char> mask;
  for (std::size_t slot = 0; slot < lights.size(); ++slot)
  {
    const vtkShadowScene::Light& light = frame.Scene->GetLights()[lights[slot]];
    if (!this->TraceVisibility(frame, *frame.Receivers, light.Ray, this->EpsilonScale, visibility))
    {
      return false;
    }
    mask.resize(visibility.size());
    std::transform(visibility.begin(), visibility.end(), mask.begin(),
      [](float v) { return static_cast<unsigned char>(v * 255.0f + 0.5f); });
    my.Masks.Upload(static_cast<int>(slot), mask.data());
    this->NumberOfRays += static_cast<vtkIdType>(frame.Receivers->CountReceivers()) *
      (light.Ray.radius > 0.0 ? this->LightSamples : 1);
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
    const TraceLight hard = my.LightOf(light.Ray);
    vtkShadowReceiverBuffer::Receiver receiver;
    for (std::size_t i = 0; !light.AtEye && i < pixels; ++i)
    {
      if (frame.Receivers->At(i, receiver))
      {
        rays.push_back(hard.RayFrom(trace.Origin(receiver, this->EpsilonScale)));
      }
    }
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
