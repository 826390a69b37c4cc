#include "vtkShadowReceiverBuffer.h"

#include "vtkShadowDrawScope.h"
#include "vtkShadowSceneData.h"
#include "vtkShadowedShadingPass.h"

#include "vtkOpenGLRenderWindow.h"

//------------------------------------------------------------------------------
bool vtkShadowReceiverBuffer::DrawStage(
  const vtkShadowFrame& frame, int stage, const float background[4])
{
  using Format = vtkShadowTextureArray::Format;
  this->Depth.Reserve(frame.Window, Format::Depth32F, frame.Size[0], frame.Size[1], 1);
  this->Colour.Reserve(frame.Window, Format::RGBA32F, frame.Size[0], frame.Size[1], 1);
  if (!this->Depth.Id() || !this->Colour.Id())
  {
    return false;
  }
  vtkShadowDrawScope target(frame.Window, this->Depth, 0, &this->Colour, 0);
  if (!target.IsComplete())
  {
    return false;
  }
  target.Clear(background);
  frame.Shading->DrawReceivers(frame, static_cast<vtkShadowedShadingPass::Stage>(stage));
  this->Pixels.resize(std::size_t(4) * frame.Size[0] * frame.Size[1]);
  target.ReadColour(this->Pixels.data());
  this->DropPixels(frame.Size);
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowReceiverBuffer::DropPixels(const int drawn[2])
{
  for (int axis = 0; axis < 2; ++axis)
  {
    const int most = this->MostKept[axis];
    this->Kept[axis] = most > 0 ? std::min(most, drawn[axis]) : drawn[axis];
  }
  if (this->Kept[0] == drawn[0] && this->Kept[1] == drawn[1])
  {
    return;
  }
  // Each from the middle of its share, which lies at or behind the place that it moves to.
  const auto source = [&](int axis, int i)
  {
    return (static_cast<std::size_t>(2 * i + 1) * drawn[axis]) /
      (std::size_t(2) * this->Kept[axis]);
  };
  for (int y = 0; y < this->Kept[1]; ++y)
  {
    for (int x = 0; x < this->Kept[0]; ++x)
    {
      const std::size_t from = source(1, y) * drawn[0] + source(0, x);
      const std::size_t to = static_cast<std::size_t>(y) * this->Kept[0] + x;
      std::copy_n(&this->Pixels[4 * from], 4, &this->Pixels[4 * to]);
    }
  }
  this->Pixels.resize(std::size_t(4) * this->Kept[0] * this->Kept[1]);
}

//------------------------------------------------------------------------------
bool vtkShadowReceiverBuffer::Draw(const vtkShadowFrame& frame)
{
  if (!this->Drawn)
  {
    const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
    this->Drawn = this->DrawStage(frame, vtkShadowedShadingPass::POSITIONS, nothing);
  }
  return this->Drawn;
}

//------------------------------------------------------------------------------
bool vtkShadowReceiverBuffer::DrawVisibility(
  const vtkShadowFrame& frame, int light, std::vector<float>& visibility)
{
  this->Drawn = false;
  const float lit[4] = { 1.0f, 0.0f, 0.0f, 0.0f };
  frame.Shading->SetShownLight(light);
  if (!this->DrawStage(frame, vtkShadowedShadingPass::VISIBILITY, lit))
  {
    return false;
  }
  visibility.resize(this->Pixels.size() / 4);
  for (std::size_t i = 0; i < visibility.size(); ++i)
  {
    visibility[i] = this->Pixels[4 * i];
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowReceiverBuffer::At(std::size_t i, Receiver& receiver) const
{
  const float* pixel = this->PixelAt(i);
  if (!IsReceiver(pixel))
  {
    return false;
  }
  receiver.PositionVC = glm::vec3(pixel[0], pixel[1], pixel[2]);
  DecodeNormal(pixel[3], receiver.NormalVC.x, receiver.NormalVC.y, receiver.NormalVC.z);
  return true;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowReceiverBuffer::CountReceivers() const
{
  std::size_t count = 0;
  for (std::size_t i = 3; i < this->Pixels.size(); i += 4)
  {
    count += IsReceiver(&this->Pixels[i - 3]) ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
void vtkShadowReceiverBuffer::Release()
{
  this->Depth.Release();
  this->Colour.Release();
  this->Drawn = false;
}
