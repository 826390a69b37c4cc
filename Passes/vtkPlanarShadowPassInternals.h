// What vtkPlanarShadowPass keeps, and how its shadows are made. In files by subject:
// vtkPlanarShadowPassShadows (what throws what on which plane), vtkPlanarShadowPassMasks (drawn for
// the eye, pixel by pixel), vtkPlanarShadowPassTextures (drawn on the planes, and looked up).
#ifndef vtkPlanarShadowPassInternals_h
#define vtkPlanarShadowPassInternals_h

#include "vtkPlanarShadowPass.h"

#include "PlanarProjection.h"
#include "vtkPlanarShadowCanvas.h"
#include "vtkShadowByPiece.h"
#include "vtkShadowCasterMesh.h"
#include "vtkShadowHiddenFaces.h"
#include "vtkShadowPlanes.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowTextureArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

class vtkPlanarShadowPass::Internals
{
public:
  // Planes that the float of a pixel can tell apart.
  static constexpr std::size_t MostBits = 24;
  // Sample lights that tell how wide a penumbra is.
  static constexpr int ProbingSamples = 16;

  // The shadow of one light on one plane, before anything is drawn.
  struct Shadow
  {
    int Slot = 0;
    std::size_t Plane = 0;
    const vtkshadows::ShadowLight* Light = nullptr;
    glm::dvec4 PlaneWC{ 0.0 }; // toward the light
    std::vector<vtkshadows::PlanarThrow> Throws;
    std::vector<std::size_t> Casters;                 // props
    std::vector<const vtkShadowScene::Piece*> Pieces; // of them
    std::vector<vtkshadows::BoxCorners> CasterCorners;
    glm::dvec3 CentreWC{ 0.0 }; // of the casters
    glm::dvec3 FootWC{ 0.0 };   // of the receivers
    double Highest = 0.0;       // of them, over the plane
  };

  // What a texture was drawn from: equal states give equal textures.
  struct TextureState
  {
    bool Drawn = false;
    glm::dvec4 PlaneWC{ 0.0 };
    glm::dvec2 Low{ 0.0 }, High{ 0.0 };
    int Texels[2] = { 0, 0 };
    std::vector<vtkshadows::PlanarThrow> Throws;
    double Plateaus = 0.0; // the light's radius
    std::vector<std::size_t> Casters;
    vtkMTimeType CasterStamp = 0;

    bool operator==(const TextureState& other) const
    {
      const auto same = [](const vtkshadows::PlanarThrow& a, const vtkshadows::PlanarThrow& b)
      { return a.light == b.light && a.offset == b.offset; };
      return this->Drawn == other.Drawn && this->PlaneWC == other.PlaneWC &&
        this->Low == other.Low && this->High == other.High && this->Texels[0] == other.Texels[0] &&
        this->Texels[1] == other.Texels[1] && this->CasterStamp == other.CasterStamp &&
        this->Casters == other.Casters && this->Plateaus == other.Plateaus &&
        std::equal(
          this->Throws.begin(), this->Throws.end(), other.Throws.begin(), other.Throws.end(), same);
    }
  };

  explicit Internals(vtkPlanarShadowPass* self)
    : Self(self)
  {
  }

  vtkPlanarShadowPass* Self;
  std::vector<glm::dvec4> Named;
  vtkShadowPlanes Planes;
  vtkShadowHiddenFaces HiddenFaces;
  vtkPlanarShadowCanvas Canvas, TextureCanvas;
  vtkShadowTextureArray Masks, Depths, PlanesOfPixels, Textures;
  std::vector<Shadow> Shadows;               // of this frame, by slot and plane
  std::vector<TextureState> States;          // by slot, and within it by plane
  std::vector<vtkLight*> Lights;             // by slot, of the last frame
  std::vector<vtkshadows::ShadowLight> Rays; // the same, off vertices
  struct Place
  {
    glm::dvec3 AskedWC{ 0.0 }, MovedWC{ 0.0 };
    vtkMTimeType CasterStamp = 0;
  };
  std::vector<Place> Places;                    // the same
  vtkShadowByPiece<vtkShadowCasterMesh> Meshes; // of casters with plateaus
  int NumberOfSlots = 0;

  // From the eye's view coordinates to the texture of a slot on a plane: x and y of its sides, z
  // its layer, and w 1; or w the height over the plane, where a prop lies on several.
  std::vector<glm::dmat4> TextureFromView, AnyTextureFromView;
  std::array<float, 16> LookupMatrix; // as it was last asked for
  std::size_t MostPlanesOfProp = 1;

  vtkshadows::LightView Eye;
  glm::dmat4 ClipFromWorld{ 1.0 };
  glm::dvec4 EyeWC{ 0.0 }; // homogeneous: a parallel eye is a direction
  int Marked = -1;         // the plane whose pixels the canvas keeps to

  // Whether a light's visibility is the mean of several shadows.
  bool IsSum(const vtkshadows::ShadowLight& light) const
  {
    return light.radius > 0.0 && this->Self->SoftMethod != PLATEAUS;
  }
  // A power of two for a plane, exact with others in the sum of a float.
  static float BitOf(std::size_t plane)
  {
    return std::ldexp(1.0f, static_cast<int>(plane % MostBits));
  }
  std::size_t LayerOf(int slot, std::size_t plane) const
  {
    return static_cast<std::size_t>(slot) * this->Planes.Get().size() + plane;
  }
  void SetEye(const vtkShadowFrame& frame);
  std::size_t FindShadows(const vtkShadowFrame& frame, const std::vector<int>& lights);
  void FindCasters(const vtkShadowFrame& frame, Shadow& shadow);
  static std::vector<vtkshadows::PlanarThrow> ThrowsOf(const Shadow& shadow, int count, int method);
  void ChooseThrows(Shadow& shadow, const glm::dmat4& clipFromWorld, int width, int height);
  bool UpdateMasks(const vtkShadowFrame& frame, bool anySoft);
  void MarkPlane(const vtkShadowFrame& frame, std::size_t plane, bool isOnlyOne);
  bool UpdateTextures(const vtkShadowFrame& frame, int side, bool anySoft);
  void UpdateTexture(const vtkShadowFrame& frame, Shadow& shadow);
  void Draw(const vtkShadowFrame& frame, vtkPlanarShadowCanvas& canvas, const Shadow& shadow,
    const glm::dmat4& clipFromWorld, bool isMirrored, const std::function<void()>& mark);
  void DrawPlateaus(const vtkShadowFrame& frame, vtkPlanarShadowCanvas& canvas,
    const Shadow& shadow, const glm::dmat4& clipFromWorld);
};

#endif
