#include "AdaptiveTruth.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vtkshadows
{
namespace
{

// A number from 0 to 1 that looks like one by lot, of each pixel its own.
double LotOf(std::size_t pixel)
{
  std::uint64_t bits = pixel + 0x9e3779b97f4a7c15u; // SplitMix64 (Steele, Lea and Flood 2014)
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  bits ^= bits >> 31;
  return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

// Pixels of a kind, and what their sample says.
struct Stratum
{
  double all = 0.0, sampled = 0.0;
  double shadow = 0.0, mismatch = 0.0, partial = 0.0; // pixels
  double absolute = 0.0, squares = 0.0;               // of the differences
  double inPenumbra = 0.0, squaresInPenumbra = 0.0;   // the same, of partial pixels

  void Add(const PixelDifference& pixel, float truth)
  {
    const double square = pixel.absolute * pixel.absolute;
    this->sampled += 1.0;
    this->shadow += truth > 0.5f ? 0.0 : 1.0;
    this->mismatch += pixel.isMismatch ? 1.0 : 0.0;
    this->partial += pixel.isPartial ? 1.0 : 0.0;
    this->absolute += pixel.absolute;
    this->squares += square;
    this->inPenumbra += pixel.isPartial ? pixel.absolute : 0.0;
    this->squaresInPenumbra += pixel.isPartial ? square : 0.0;
  }

  // Of the sum over all pixels as the sample has it, of values with that sum and sum of squares;
  // or of that over as many more that they all stand for.
  double VarianceOfSum(double sum, double squared, bool standsForMore = false) const
  {
    const double n = std::max(this->sampled, 1.0), mean = sum / n;
    const double variance = std::max(squared / n - mean * mean, 0.0);
    const double unseen = standsForMore ? this->all : std::max(this->all - this->sampled, 0.0);
    return this->all * unseen * variance / n;
  }
};

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

  std::vector<unsigned char> which(pixels);
  std::transform(this->Roles.begin(), this->Roles.end(), which.begin(),
    [](PixelRole role) { return role != PixelRole::Background; });
  if (!this->Tracer(settings.coarse, 1.0, which, this->Truth))
  {
    return false;
  }

  this->IsPartial = MarkPartial(settings.width, settings.height, this->Truth, this->Roles);
  this->Times = 1.0;
  return this->TraceSample();
}

// The pixels of the sample that have not been traced finely yet.
bool AdaptiveTruth::TraceSample()
{
  const std::size_t pixels = this->Roles.size();
  double counts[2] = { 0.0, 0.0 };
  for (std::size_t i = 0; i < pixels; ++i)
  {
    counts[this->IsPartial[i]] += this->Roles[i] == PixelRole::Measured;
  }
  const double shares[2] = { this->Times * this->With.otherPixels / std::max(counts[0], 1.0),
    this->Times * this->With.partialPixels / std::max(counts[1], 1.0) };
  std::vector<unsigned char> which(pixels, 0);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    const bool isNew = !this->IsSample[i] && this->Roles[i] == PixelRole::Measured &&
      LotOf(i) < shares[this->IsPartial[i]];
    this->IsSample[i] |= isNew;
    which[i] = isNew && !this->IsFine[i];
  }
  return this->TraceFinely(which);
}

// Those that hang on the ray epsilon by the coarse rays are uncertain from then on.
bool AdaptiveTruth::TraceFinely(const std::vector<unsigned char>& which)
{
  std::vector<float> farther(which.size(), 1.0f);
  if (!this->Tracer(this->With.coarse, FartherEpsilonScale, which, farther))
  {
    return false;
  }
  for (std::size_t i = 0; i < which.size(); ++i)
  {
    if (which[i])
    {
      this->IsFine[i] = 1;
      this->Roles[i] =
        std::abs(this->Truth[i] - farther[i]) > 0.5f ? PixelRole::Uncertain : PixelRole::Measured;
    }
  }
  return this->Tracer(this->With.fine, 1.0, which, this->Truth);
}

std::size_t AdaptiveTruth::GetFinePixels() const
{
  return std::count(this->IsFine.begin(), this->IsFine.end(), 1);
}

VisibilityImages AdaptiveTruth::ImagesOf(const std::vector<float>& visibility) const
{
  VisibilityImages images;
  images.width = this->With.width;
  images.height = this->With.height;
  images.visibility = visibility.data();
  images.truth = this->Truth.data();
  images.role = this->Roles.data();
  return images;
}

//------------------------------------------------------------------------------
bool AdaptiveTruth::Measure(const std::vector<float>& visibility, VisibilityError& error)
{
  // What seems gross and is not known finely; of many, some that stand for them.
  const VisibilityImages images = this->ImagesOf(visibility);
  std::vector<PixelVerdict> verdicts;
  VisibilityError all = MeasureVisibility(images, this->With.edgeDistance, &verdicts);
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
    if (!this->TraceFinely(which))
    {
      return false;
    }
    all = MeasureVisibility(images, this->With.edgeDistance, &verdicts);
  }
  std::size_t checked = 0, wrong = 0, unchecked = 0;
  for (const std::size_t i : suspects)
  {
    checked += which[i];
    wrong += which[i] && IsGrossVerdict(verdicts[i]);
    unchecked += !which[i] && IsGrossVerdict(verdicts[i]);
  }
  const double wrongShare = checked > 0 ? static_cast<double>(wrong) / checked : 1.0;
  const double refuted = (1.0 - wrongShare) * static_cast<double>(unchecked);
  const double gross = static_cast<double>(all.GrossPixels());
  const double kept = gross > 0.0 ? std::max(gross - refuted, 0.0) / gross : 0.0;
  Deviations deviations;
  error = this->DifferencesOf(visibility, deviations);
  while (this->Times < this->With.mostTimes && this->HangsOnSample(error, deviations))
  {
    this->Times *= 2.0;
    if (!this->TraceSample())
    {
      return false;
    }
    error = this->DifferencesOf(visibility, deviations);
  }
  error.receiverPixels = all.receiverPixels;
  error.uncertainPixels = all.uncertainPixels;
  error.grossFalsePixels = static_cast<std::size_t>(std::lround(kept * all.grossFalsePixels));
  error.grossMissedPixels = static_cast<std::size_t>(std::lround(kept * all.grossMissedPixels));
  return true;
}

//------------------------------------------------------------------------------
// Whether chance decides on which side of a limit a mean lies, and the other is not beyond its own.
bool AdaptiveTruth::HangsOnSample(const VisibilityError& error, const Deviations& deviations) const
{
  // Standard errors that a mean is below its limit by; surely, if nothing is uncertain.
  const auto below = [](double mean, double limit, double deviation, double tolerance)
  {
    return limit <= 0.0                        ? SureDeviations
      : SureDeviations * deviation > tolerance ? (limit - mean) / deviation
      : mean <= limit                          ? SureDeviations
                                               : -SureDeviations;
  };
  const double mean = below(error.MeanAbsoluteDifference(), this->With.meanLimit, deviations.mean,
    this->With.meanTolerance);
  const double penumbra =
    below(error.MeanPenumbraDifference(), this->With.penumbraLimit, deviations.penumbra, 0.0);
  const double worst = std::min(mean, penumbra);
  return std::abs(worst) < SureDeviations;
}

//------------------------------------------------------------------------------
// Of the sample, as of all pixels; gross ones are not counted. Standard errors are those of a
// stratified sample without replacement and of a ratio (W. Cochran: Sampling Techniques, 1977).
VisibilityError AdaptiveTruth::DifferencesOf(
  const std::vector<float>& visibility, Deviations& deviations) const
{
  Stratum strata[2];
  for (std::size_t i = 0; i < visibility.size(); ++i)
  {
    if (this->Roles[i] == PixelRole::Measured)
    {
      Stratum& stratum = strata[this->IsPartial[i]];
      stratum.all += 1.0;
      if (this->IsSample[i])
      {
        stratum.Add(DifferenceOf(visibility[i], this->Truth[i]), this->Truth[i]);
      }
    }
  }
  double shadow = 0.0, mismatch = 0.0, penumbra = 0.0, receivers = 0.0;
  VisibilityError error;
  for (const Stratum& stratum : strata)
  {
    const double weight = stratum.all / std::max(stratum.sampled, 1.0);
    receivers += stratum.all;
    shadow += weight * stratum.shadow;
    mismatch += weight * stratum.mismatch;
    penumbra += weight * stratum.partial;
    error.sumAbsoluteDifference += weight * stratum.absolute;
    error.sumPenumbraDifference += weight * stratum.inPenumbra;
  }
  const auto whole = [](double count) { return static_cast<std::size_t>(std::lround(count)); };
  error.receiverPixels = whole(receivers);
  error.shadowPixels = whole(shadow);
  error.mismatchPixels = whole(mismatch);
  error.penumbraPixels = whole(penumbra);

  const double ratio = error.MeanPenumbraDifference();
  double ofMean = 0.0, ofPenumbra = 0.0, ofMore = 0.0;
  for (const Stratum& stratum : strata)
  {
    const double residual = stratum.inPenumbra - ratio * stratum.partial;
    const double squares = stratum.squaresInPenumbra - 2.0 * ratio * stratum.inPenumbra +
      ratio * ratio * stratum.partial;
    ofMean += stratum.VarianceOfSum(stratum.absolute, stratum.squares);
    ofPenumbra += stratum.VarianceOfSum(residual, squares);
    ofMore += stratum.VarianceOfSum(residual, squares, true);
  }
  deviations.mean = std::sqrt(ofMean) / std::max(receivers, 1.0);
  deviations.penumbra = std::sqrt(ofPenumbra) / std::max(penumbra, 1.0);
  error.penumbraDeviation = std::sqrt(ofMore) / std::max(penumbra, 1.0);
  return error;
}

}
