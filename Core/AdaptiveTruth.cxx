#include "AdaptiveTruth.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vtkshadows
{
namespace
{

// Times the ray epsilon at which a truth that hangs on it changes.
constexpr double FartherOff = 4.0;

// A number from 0 to 1 that looks like one by lot, of each pixel its own.
double LotOf(std::size_t pixel)
{
  std::uint64_t bits = pixel + 0x9e3779b97f4a7c15u; // SplitMix64 (Steele, Lea and Flood 2014)
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  bits ^= bits >> 31;
  return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

bool IsGrossVerdict(PixelVerdict verdict)
{
  return verdict == PixelVerdict::GrossFalseShadow || verdict == PixelVerdict::GrossMissedShadow;
}

// Pixels that are partly lit by themselves or with one of their eight neighbours, of receivers.
std::vector<unsigned char> MarkPartial(
  int width, int height, const std::vector<float>& truth, const std::vector<PixelRole>& roles)
{
  std::vector<unsigned char> marks(truth.size(), 0);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      float least = 1.0f, most = 0.0f;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
      {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
        {
          const std::size_t i = static_cast<std::size_t>(v) * width + u;
          if (roles[i] != PixelRole::Background)
          {
            least = std::min(least, truth[i]);
            most = std::max(most, truth[i]);
          }
        }
      }
      marks[static_cast<std::size_t>(y) * width + x] = least < 1.0f && most > 0.0f;
    }
  }
  return marks;
}

}

//------------------------------------------------------------------------------
bool AdaptiveTruth::Begin(const Settings& settings, std::vector<PixelRole> roles, Trace trace)
{
  this->With = settings;
  this->Tracer = std::move(trace);
  this->Roles = std::move(roles);
  const std::size_t pixels = this->Roles.size();
  this->Truth.assign(pixels, 1.0f);
  this->IsFine.assign(pixels, 0);
  this->IsSample.assign(pixels, 0);
  this->FinePixels = 0;

  std::vector<unsigned char> which(pixels);
  std::transform(this->Roles.begin(), this->Roles.end(), which.begin(),
    [](PixelRole role) { return role != PixelRole::Background; });
  if (!this->Tracer(settings.coarse, 1.0, which, this->Truth))
  {
    return false;
  }

  const auto measured = std::count(this->Roles.begin(), this->Roles.end(), PixelRole::Measured);
  const double share = settings.samplePixels / std::max(1.0, static_cast<double>(measured));
  for (std::size_t i = 0; i < pixels; ++i)
  {
    this->IsSample[i] = this->Roles[i] == PixelRole::Measured && LotOf(i) < share;
  }
  std::vector<float> farther(pixels, 1.0f);
  if (!this->Tracer(settings.coarse, FartherOff, this->IsSample, farther))
  {
    return false;
  }
  which = MarkPartial(settings.width, settings.height, this->Truth, this->Roles);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    if (this->IsSample[i] && std::abs(this->Truth[i] - farther[i]) > 0.5f)
    {
      this->Roles[i] = PixelRole::Uncertain;
    }
    which[i] = which[i] && this->IsSample[i];
  }
  return this->TraceFinely(which);
}

bool AdaptiveTruth::TraceFinely(const std::vector<unsigned char>& which)
{
  for (std::size_t i = 0; i < which.size(); ++i)
  {
    this->FinePixels += which[i] && !this->IsFine[i];
    this->IsFine[i] = this->IsFine[i] || which[i];
  }
  return this->Tracer(this->With.fine, 1.0, which, this->Truth);
}

VisibilityImages AdaptiveTruth::ImagesOf(
  const std::vector<float>& visibility, const std::vector<PixelRole>& roles) const
{
  VisibilityImages images;
  images.width = this->With.width;
  images.height = this->With.height;
  images.visibility = visibility.data();
  images.truth = this->Truth.data();
  images.role = roles.data();
  return images;
}

//------------------------------------------------------------------------------
bool AdaptiveTruth::Measure(const std::vector<float>& visibility, VisibilityError& error)
{
  // What seems gross and is not known finely; of many, some that stand for them.
  std::vector<PixelVerdict> verdicts;
  MeasureVisibility(this->ImagesOf(visibility, this->Roles), this->With.edgeDistance, &verdicts);
  std::vector<std::size_t> suspects;
  for (std::size_t i = 0; i < verdicts.size(); ++i)
  {
    if (IsGrossVerdict(verdicts[i]) && !this->IsFine[i])
    {
      suspects.push_back(i);
    }
  }
  const std::size_t step = suspects.size() / std::max<std::size_t>(this->With.checked, 1) + 1;
  std::vector<unsigned char> which(this->Truth.size(), 0);
  for (std::size_t k = 0; k < suspects.size(); k += step)
  {
    which[suspects[k]] = 1;
  }
  if (!suspects.empty())
  {
    std::vector<float> before = this->Truth, farther(this->Truth.size(), 1.0f);
    if (!this->Tracer(this->With.coarse, FartherOff, which, farther) || !this->TraceFinely(which))
    {
      return false;
    }
    for (std::size_t i = 0; i < which.size(); ++i)
    {
      if (which[i] && std::abs(before[i] - farther[i]) > 0.5f)
      {
        this->Roles[i] = PixelRole::Uncertain;
      }
    }
  }

  const VisibilityError all =
    MeasureVisibility(this->ImagesOf(visibility, this->Roles), this->With.edgeDistance, &verdicts);
  std::size_t checked = 0, wrong = 0, unchecked = 0;
  for (const std::size_t i : suspects)
  {
    checked += which[i];
    wrong += which[i] && IsGrossVerdict(verdicts[i]);
    unchecked += !which[i] && IsGrossVerdict(verdicts[i]);
  }
  const double wrongShare = checked > 0 ? static_cast<double>(wrong) / checked : 1.0;

  // Differences of the sample; what lies beside it is a receiver still, with its edges.
  std::vector<PixelRole> roles = this->Roles;
  for (std::size_t i = 0; i < roles.size(); ++i)
  {
    if (roles[i] == PixelRole::Measured && !this->IsSample[i])
    {
      roles[i] = PixelRole::Grazing;
    }
  }
  error = MeasureVisibility(this->ImagesOf(visibility, roles), this->With.edgeDistance);
  const std::size_t sampled = error.receiverPixels;
  const auto ofAll = [&](double count)
  { return sampled > 0 ? count * static_cast<double>(all.receiverPixels) / sampled : 0.0; };
  error.receiverPixels = all.receiverPixels;
  error.shadowPixels = static_cast<std::size_t>(std::lround(ofAll(error.shadowPixels)));
  error.mismatchPixels = static_cast<std::size_t>(std::lround(ofAll(error.mismatchPixels)));
  error.penumbraPixels = static_cast<std::size_t>(std::lround(ofAll(error.penumbraPixels)));
  error.sumAbsoluteDifference = ofAll(error.sumAbsoluteDifference);
  error.sumPenumbraDifference = ofAll(error.sumPenumbraDifference);
  error.uncertainPixels = all.uncertainPixels;
  const double refuted = (1.0 - wrongShare) * static_cast<double>(unchecked);
  const double gross = static_cast<double>(all.GrossPixels());
  const double kept = gross > 0.0 ? std::max(gross - refuted, 0.0) / gross : 0.0;
  error.grossFalsePixels = static_cast<std::size_t>(std::lround(kept * all.grossFalsePixels));
  error.grossMissedPixels = static_cast<std::size_t>(std::lround(kept * all.grossMissedPixels));
  return true;
}

}
