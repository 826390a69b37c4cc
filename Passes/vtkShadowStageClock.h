// What the stages of a frame take: on the clock, and on the GPU where the driver tells. OpenGL
// works off what it is given later on, so while stages are timed it is emptied between them.
#ifndef vtkShadowStageClock_h
#define vtkShadowStageClock_h

#include <chrono>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderTimer;

class vtkShadowStageClock
{
public:
  vtkShadowStageClock();
  ~vtkShadowStageClock();
  vtkShadowStageClock(const vtkShadowStageClock&) = delete;
  void operator=(const vtkShadowStageClock&) = delete;

  // A new frame, of which stages are timed or not.
  void BeginFrame(bool timed);

  // Stage `name` begins, or goes on, and the one before it ends. A context must be current, here
  // and at the end. What is started after that is not timed.
  void Start(const std::string& name);
  void EndFrame();

  struct Stage
  {
    std::string Name;
    double Seconds = 0.0;
    double GPUSeconds = -1.0; // below 0: the driver does not tell
  };
  const std::vector<Stage>& GetStages() const { return this->Stages; }
  const Stage* Find(const std::string& name) const; // nullptr: there was none

private:
  using Clock = std::chrono::steady_clock;

  void Stop();

  bool Timed = false;
  std::vector<Stage> Stages; // of the last timed frame
  int Running = -1;
  Clock::time_point Began;
  std::unique_ptr<vtkOpenGLRenderTimer> Timer; // of the running stage
};

#endif
