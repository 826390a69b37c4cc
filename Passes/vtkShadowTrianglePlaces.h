// The space that the triangles of each light are listed in, for vtkShadowTriangleMaps, and what
// lookups are told of each layer of the maps beside them.
#ifndef vtkShadowTrianglePlaces_h
#define vtkShadowTrianglePlaces_h

#include "vtkShadowMapViews.h"
#include "vtkShadowScene.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkShaderProgram;

class vtkShadowTrianglePlaces
{
public:
  // Once views have layers. propsOf: of each slot, those of `props` whose triangles are listed.
  // hasPlain: some casters are not.
  void Update(const std::vector<vtkShadowScene::Prop>& props, const vtkShadowMapViews& views,
    const std::vector<std::vector<std::size_t>>& propsOf, bool hasPlain);

  // If each light has one map and stands before all that casts, the space is that map's own, texels
  // and depths: then nothing more need be known in the lookup, and this is true. Else its third
  // axis is the depth before the light, from the near plane on; for a cube it is the cube's own.
  // Both in a unit of length that keeps products of coordinates floats at every scale of the scene.
  bool IsDirect() const { return this->Written.Direct; }
  glm::dmat4 LightFromWorld(const vtkShadowMapViews& views, const vtkShadowMapSlot& slot) const;

  // Ahead of the lookup's text; it must be written anew when there is a change.
  std::string Declarations() const;
  bool TakeShaderChange();
  void SetParameters(vtkShaderProgram* program) const;

private:
  // What shaders are written with.
  struct Shape
  {
    std::size_t Layers = 1; // never fewer than before
    bool Direct = true;
    bool HasPlain = false;

    bool operator==(const Shape& other) const
    {
      return this->Layers == other.Layers && this->Direct == other.Direct &&
        this->HasPlain == other.HasPlain;
    }
  };
  // A layer, as the lookup is told of it.
  struct Place
  {
    std::array<float, 4> Plane{}; // texel of the axis, and units a texel, in x and y
    std::array<float, 4> Depth{}; // where its depths begin, their range, and near and far plane
    std::array<float, 2> Other{}; // face of the cube, and the light's distance from depth 0
  };

  void UpdatePlaces(const vtkShadowMapViews& views);

  Shape Written;
  bool ShaderChanged = false;
  std::vector<Place> Places; // one a layer
};

#endif
