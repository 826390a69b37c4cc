// Shared by the tests of Passes: the window, parts of scenes, what a frame shows, and checks that
// say what they got. A test reads straight down: scene, pass, camera, compare.
#ifndef vtkshadows_ShadowTest_h
#define vtkshadows_ShadowTest_h

#include "SceneParts.h"
#include "vtkDepthShadowMapPass.h"
#include "vtkRayCastShadowPass.h"
#include "vtkShadowPass.h"
#include "vtkStencilShadowVolumePass.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace shadowtest
{

//------------------------------------------------------------------------------
// Checks: print got, expected and tolerance, and fail the test where they disagree.
bool Check(const std::string& what, double got, double expected, double tolerance = 0.0);
bool CheckAtMost(const std::string& what, double got, double limit);
bool CheckAtLeast(const std::string& what, double got, double limit);

//------------------------------------------------------------------------------
// Messages: whatever VTK warns of or calls an error is kept, and fails the test if left.
std::vector<std::string> TakeMessages();
// One message since the last call, with all of `parts` in it.
void ExpectOneMessage(const std::vector<std::string>& parts);

//------------------------------------------------------------------------------
// Pictures: rows from the bottom.
struct Frame
{
  int width = 0;
  int height = 0;
  std::vector<unsigned char> rgb;

  int Brightness(int x, int y) const; // r + g + b
};

struct Visibility
{
  int width = 0;
  int height = 0;
  std::vector<float> values; // 0 shadowed, 1 lit

  float At(int x, int y) const { return this->values[std::size_t(y) * this->width + x]; }
  std::size_t CountShadowed() const; // below 0.5
};

void WritePng(const Frame& frame, const std::string& file);

// Pixels with a component that differs by more than `tolerance`; all of them if the sizes differ.
std::size_t CountDifferent(const Frame& a, const Frame& b, int tolerance = 0);
// Pixels on different sides of 0.5; all of them if the sizes differ.
std::size_t CountDifferent(const Visibility& a, const Visibility& b);

struct Pixel
{
  int x;
  int y;
};

// Where `renderer` shows a world point, in its own viewport.
Pixel PixelOf(vtkRenderer* renderer, const glm::dvec3& pointWC);

//------------------------------------------------------------------------------
// Parts of a scene.
// Mappers of this VTK for composite data: one draws each block by a mapper of its own, another many
// blocks by one.
std::vector<vtkSmartPointer<vtkMapper>> CompositeMappers();
using vtkshadows::scenes::AddActor;
using vtkshadows::scenes::AddBox;
using vtkshadows::scenes::AddFloor;
using vtkshadows::scenes::AddLamp;
using vtkshadows::scenes::AddSphere;
using vtkshadows::scenes::AddSpot;
using vtkshadows::scenes::AddSun;
using vtkshadows::scenes::LookAt;

//------------------------------------------------------------------------------
// The test's surroundings: one window, a renderer and a pass that it has not been given yet.
class ShadowTest : public ::testing::Test
{
protected:
  ShadowTest();
  ~ShadowTest() override;
  void SetUp() override;
  // No message and no OpenGL error may be left.
  void TearDown() override;

  Frame Render();
  Frame RenderWithoutPass();
  Visibility VisibilityOf(vtkLight* light);
  // With every light by `technique`.
  Visibility VisibilityBy(const std::string& technique, vtkLight* light);
  void Resize(int width, int height);

  // Holds the light's visibility, by its technique, against the truth.
  void CheckMeasure(
    const std::string& what, vtkLight* light, double mismatchPercent, double grossPercent);

  // The one window of this process: more of them, one after the other, abort on some X servers.
  vtkRenderWindow* Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkShadowPass> Shadows;
};

// Skips the test in a build without Embree, which has no truth.
#define SHADOWTEST_NEEDS_RAY_CAST()                                                                \
  do                                                                                               \
  {                                                                                                \
    if (!this->Shadows->GetRayCastShadowPass())                                                    \
    {                                                                                              \
      GTEST_SKIP() << "this build has no Embree";                                                  \
    }                                                                                              \
  } while (false)

// The OpenGL error since the last call, 0 if there was none. The window must have rendered.
unsigned int TakeOpenGLError();

}

#endif
