// Lights with a radius as the mean over sample lights on their discs, each with depth maps of its
// own. All samples of a light have the same frustum, or the same faces of a cube, from places of
// their own, so that a shader is told their places alone.
//
// Heckbert and Herf: Simulating soft shadows with graphics hardware, CMU-CS-97-104, 1997.
#ifndef vtkShadowSampledLights_h
#define vtkShadowSampledLights_h

#include "vtkShadowMapViews.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowTextureBuffer.h"

#include <functional>

class vtkShaderProgram;

class vtkShadowSampledLights
{
public:
  // A map to be drawn, of `light`, a sample.
  using Draw =
    std::function<void(const vtkshadows::ShadowLight& light, const vtkShadowMapView& view)>;

  // Fits the maps of `lights` (of the frame's scene), of `resolution` texels a side with a margin
  // of `margin` texels. What one sample needs is fitted to all.
  void Fit(const vtkShadowFrame& frame, const std::vector<int>& lights, int samples, int resolution,
    double margin);
  int NumberOfMaps() const { return static_cast<int>(this->Maps.size()); }

  // What their maps hold is lost.
  void ForgetMaps() { this->Drawn.clear(); }
  void DrawStale(const Draw& draw);

  // GLSL: `float shadowSampledParallel(int light, vec4 q)`, -View and -Cube, and their overloads
  // for impostors. `shared`: the texts that all filters share.
  std::string Declarations(const std::string& shared) const;
  // Which of them is for a light. One for all kinds would cost all of them: software OpenGL goes
  // through each side of a branch.
  std::string Function(int light) const;
  // Another one of these needs another shader.
  std::string Shape() const;
  const float* Matrix(int light) const { return this->Lights[light].Matrix.data(); }
  // What shaders look up. Before a frame's lookups.
  void UploadRows(vtkOpenGLRenderWindow* window);
  void SetParameters(vtkShaderProgram* program) const;
  void Activate();
  void Deactivate();
  void Release();
  std::size_t Bytes() const { return this->Textures.Bytes() + this->Rows.Bytes(); }

  vtkShadowTextureArray Textures;

private:
  // A face of a cube, or the one view: texels = scale * tangent + centre, depth = x + y / way.
  struct Face
  {
    std::array<float, 4> ScaleAndCentre;
    std::array<float, 4> DepthAndLayer; // z: layer of the first sample, -1: nothing casts here
  };
  struct Light
  {
    vtkShadowMapViews::ShaderMatrix Matrix;
    bool IsParallel = false;
    std::vector<Face> Faces; // one, or six
    int LayersPerSample = 0;
    std::vector<std::array<float, 4>> Places; // of the samples
  };
  struct Map
  {
    vtkshadows::ShadowLight Sample;
    vtkShadowMapView View;
  };

  void FitOne(const vtkShadowFrame& frame, const vtkShadowScene::Light& source, int samples,
    double margin, const std::vector<vtkshadows::BoxCorners>& receivers);

  int Resolution = 0;
  std::vector<Light> Lights;
  std::vector<Map> Maps;                     // one a layer
  std::vector<vtkShadowMapView> Drawn;       // the same, as they are
  std::vector<std::array<float, 4>> Headers; // of the lights, as the shader has them
  vtkShadowTextureBuffer Rows;
};

#endif
