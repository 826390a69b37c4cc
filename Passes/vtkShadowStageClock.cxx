#include "vtkShadowStageClock.h"

#include "vtkOpenGLRenderTimer.h"
#include "vtkShadowOpenGL.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkShadowStageClock::vtkShadowStageClock() = default;
vtkShadowStageClock::~vtkShadowStageClock() = default;

//------------------------------------------------------------------------------
void vtkShadowStageClock::BeginFrame(bool timed)
{
  this->Timed = timed;
  this->Running = -1;
  if (timed)
  {
    this->Stages.clear();
  }
}

//------------------------------------------------------------------------------
void vtkShadowStageClock::Start(const std::string& name)
{
  if (!this->Timed)
  {
    return;
  }
  this->Stop();
  const auto known = std::find_if(this->Stages.begin(), this->Stages.end(),
    [&name](const Stage& stage) { return stage.Name == name; });
  this->Running = static_cast<int>(known - this->Stages.begin());
  if (known == this->Stages.end())
  {
    this->Stages.emplace_back();
    this->Stages.back().Name = name;
  }
  glFinish();
  if (vtkOpenGLRenderTimer::IsSupported())
  {
    this->Timer = std::make_unique<vtkOpenGLRenderTimer>();
    this->Timer->Start();
  }
  this->Began = Clock::now();
}

//------------------------------------------------------------------------------
void vtkShadowStageClock::EndFrame()
{
  this->Stop();
  this->Timed = false;
}

//------------------------------------------------------------------------------
void vtkShadowStageClock::Stop()
{
  if (this->Running < 0)
  {
    return;
  }
  Stage& stage = this->Stages[static_cast<std::size_t>(this->Running)];
  if (this->Timer)
  {
    this->Timer->Stop();
  }
  glFinish();
  stage.Seconds += std::chrono::duration<double>(Clock::now() - this->Began).count();
  // The driver is done, so that the answer is there; where it is not, none is told.
  if (this->Timer && this->Timer->Ready())
  {
    stage.GPUSeconds =
      std::max(stage.GPUSeconds, 0.0) + 1e-9 * this->Timer->GetElapsedNanoseconds();
  }
  this->Timer.reset();
  this->Running = -1;
}

//------------------------------------------------------------------------------
const vtkShadowStageClock::Stage* vtkShadowStageClock::Find(const std::string& name) const
{
  const auto found = std::find_if(this->Stages.begin(), this->Stages.end(),
    [&](const Stage& stage) { return stage.Name == name; });
  return found != this->Stages.end() ? &*found : nullptr;
}
