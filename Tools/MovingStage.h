// A stage in motion, and the time of its frames.
#ifndef vtkshadows_MovingStage_h
#define vtkshadows_MovingStage_h

#include <vtkCamera.h>
#include <vtkNew.h>

#include <glm/vec3.hpp>

#include <chrono>
#include <ctime>
#include <functional>
#include <vector>

namespace vtkshadows
{

class Stage;

// Moves the camera and the lights of a stage, frame by frame, and puts all back when it goes, the
// shadows shown.
class MovingStage
{
public:
  explicit MovingStage(Stage& stage);
  ~MovingStage();
  MovingStage(const MovingStage&) = delete;
  MovingStage& operator=(const MovingStage&) = delete;

  // To and fro by degrees.
  void SwingCamera();
  void RestCamera();
  // By a share of the scene.
  void CircleLights();
  void RestLights();

private:
  struct Placement
  {
    glm::dvec3 position{ 0.0 };
    glm::dvec3 focalPoint{ 0.0 };
  };

  Stage& stage;
  vtkNew<vtkCamera> camera;
  std::vector<Placement> lights;
  int cameraFrame = 0;
  int lightFrame = 0;
};

// Of one frame, until it is done.
double RenderMilliseconds(Stage& stage);

// What work took, by the clock; or, where that is less, the time of the processors that it had:
// what others took of the machine is left out.
class WorkClock
{
public:
  double Seconds() const;

private:
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
  std::clock_t processorBegin = std::clock();
};

// Draws frames until "auto" has chosen; `move` comes before each.
void SettleChoice(Stage& stage, const std::function<void()>& move);

}

#endif
