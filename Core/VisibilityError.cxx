// The distance to the nearest edge pixel is exact and takes time linear in the pixels, whatever
// `edgeDistance` is. Reference: P. Felzenszwalb and D. Huttenlocher, "Distance Transforms of
// Sampled Functions", Theory of Computing 8, 2012.
#include "VisibilityError.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace vtkshadows
{
namespace
{

// Distance, in pixels, of what no edge is seen from. Half the range, so that adding 1 is safe.
constexpr int Unreached = std::numeric_limits<int>::max() / 2;

constexpr double Infinity = std::numeric_limits<double>::infinity();

void RequirePositive(const char* name, int value)
{
  if (value < 1)
  {
    throw std::invalid_argument(std::string("VisibilityImages: ") + name + " is " +
      std::to_string(value) + "; give the images' size in pixels, at least 1.");
  }
}

void RequireArray(const char* name, const void* array)
{
  if (!array)
  {
    throw std::invalid_argument(std::string("VisibilityImages: ") + name +
      " is a null pointer; give an array of width*height entries.");
  }
}

void RequireValid(const VisibilityImages& images, double edgeDistance)
{
  RequirePositive("width", images.width);
  RequirePositive("height", images.height);
  RequireArray("visibility", images.visibility);
  RequireArray("truth", images.truth);
  RequireArray("role", images.role);
  if (!(edgeDistance >= 0.0 && edgeDistance < Infinity))
  {
    throw std::invalid_argument("MeasureVisibility: edgeDistance is " +
      std::to_string(edgeDistance) + "; give a finite number of pixels, at least 0.");
  }
}

bool IsLit(float truth)
{
  return truth > 0.5f;
}

bool IsTrueEdge(const VisibilityImages& images, std::size_t a, std::size_t b)
{
  return images.role[a] != PixelRole::Background && images.role[b] != PixelRole::Background &&
    IsLit(images.truth[a]) != IsLit(images.truth[b]);
}

// One entry a pixel: 0 where it belongs to a true shadow edge, Unreached elsewhere.
std::vector<int> MarkEdges(const VisibilityImages& images)
{
  const std::size_t width = images.width;
  const std::size_t height = images.height;
  std::vector<int> distance(width * height, Unreached);
  const auto markIfEdge = [&](std::size_t a, std::size_t b)
  {
    if (IsTrueEdge(images, a, b))
    {
      distance[a] = distance[b] = 0;
    }
  };
  for (std::size_t y = 0; y < height; ++y)
  {
    for (std::size_t x = 0; x < width; ++x)
    {
      const std::size_t i = y * width + x;
      if (x + 1 < width)
      {
        markIfEdge(i, i + 1);
      }
      if (y + 1 < height)
      {
        markIfEdge(i, i + width);
      }
    }
  }
  return distance;
}

// First pass: distance to the nearest edge pixel of the same column. Whole rows at a time, up and
// then down, because walking the columns one by one would miss the cache at every step.
std::vector<int> ColumnDistances(const VisibilityImages& images)
{
  std::vector<int> distance = MarkEdges(images);
  const std::size_t width = images.width;
  for (std::size_t i = width; i < distance.size(); ++i)
  {
    distance[i] = std::min(distance[i], distance[i - width] + 1);
  }
  for (std::size_t i = distance.size() - width; i-- > 0;)
  {
    distance[i] = std::min(distance[i], distance[i + width] + 1);
  }
  return distance;
}

// Second pass, a row at a time: the lower envelope of one parabola a column, whose apex is that
// column's squared distance. All heights are whole numbers far below 2^53, so doubles hold them
// exactly, and a breakpoint between two pixels is never rounded across one.
class RowDistances
{
public:
  explicit RowDistances(int width)
    : apex(width)
    , begin(width)
    , squared(width)
  {
  }

  // Squared distance, in pixels, from each pixel of a row to the image's nearest edge pixel, given
  // the row's column distances. Infinite in an image without edges. Valid until the next call.
  const std::vector<double>& From(const int* columnDistance)
  {
    this->BuildEnvelope(columnDistance);
    this->ReadEnvelope(columnDistance);
    return this->squared;
  }

private:
  void BuildEnvelope(const int* columnDistance)
  {
    this->parabolas = 0;
    for (int x = 0; x < static_cast<int>(this->apex.size()); ++x)
    {
      if (columnDistance[x] < Unreached)
      {
        this->Push(x, columnDistance);
      }
    }
  }

  // Drop the parabolas that the one at `x` hides, then put it last.
  void Push(int x, const int* columnDistance)
  {
    double start = -Infinity;
    while (this->parabolas > 0)
    {
      start = Crossing(this->apex[this->parabolas - 1], x, columnDistance);
      if (start > this->begin[this->parabolas - 1])
      {
        break;
      }
      --this->parabolas;
      start = -Infinity;
    }
    this->apex[this->parabolas] = x;
    this->begin[this->parabolas] = start;
    ++this->parabolas;
  }

  // Where the parabola of column `right` comes to lie below that of `left`.
  static double Crossing(int left, int right, const int* columnDistance)
  {
    const double leftTerm = Square(columnDistance[left]) + Square(left);
    const double rightTerm = Square(columnDistance[right]) + Square(right);
    return (rightTerm - leftTerm) / (2.0 * (right - left));
  }

  void ReadEnvelope(const int* columnDistance)
  {
    if (this->parabolas == 0)
    {
      std::fill(this->squared.begin(), this->squared.end(), Infinity);
      return;
    }
    int current = 0;
    for (int x = 0; x < static_cast<int>(this->squared.size()); ++x)
    {
      while (current + 1 < this->parabolas && this->begin[current + 1] <= x)
      {
        ++current;
      }
      const int column = this->apex[current];
      this->squared[x] = Square(x - column) + Square(columnDistance[column]);
    }
  }

  static double Square(int value) { return static_cast<double>(value) * value; }

  int parabolas = 0;           // in use, of the envelope below
  std::vector<int> apex;       // column of each, left to right
  std::vector<double> begin;   // where each starts to be the lowest
  std::vector<double> squared; // the answer
};

PixelVerdict JudgeMeasured(float visibility, float truth, bool farFromEdge)
{
  const bool lit = IsLit(truth);
  if (!DifferenceOf(visibility, truth).isMismatch)
  {
    return lit ? PixelVerdict::RightLit : PixelVerdict::RightShadow;
  }
  if (farFromEdge)
  {
    return lit ? PixelVerdict::GrossFalseShadow : PixelVerdict::GrossMissedShadow;
  }
  return lit ? PixelVerdict::FalseShadow : PixelVerdict::MissedShadow;
}

PixelVerdict Judge(const VisibilityImages& images, std::size_t pixel, bool farFromEdge)
{
  switch (images.role[pixel])
  {
    case PixelRole::Background:
      return PixelVerdict::Background;
    case PixelRole::Grazing:
      return PixelVerdict::Grazing;
    case PixelRole::Uncertain:
      return PixelVerdict::Uncertain;
    case PixelRole::Measured:
      break;
  }
  return JudgeMeasured(images.visibility[pixel], images.truth[pixel], farFromEdge);
}

void CountMeasured(
  VisibilityError& error, const VisibilityImages& images, std::size_t pixel, PixelVerdict verdict)
{
  const float truth = images.truth[pixel];
  ++error.receiverPixels;
  error.shadowPixels += !IsLit(truth);
  error.mismatchPixels += verdict != PixelVerdict::RightLit && verdict != PixelVerdict::RightShadow;
  error.grossFalsePixels += verdict == PixelVerdict::GrossFalseShadow;
  error.grossMissedPixels += verdict == PixelVerdict::GrossMissedShadow;
  const PixelDifference difference = DifferenceOf(images.visibility[pixel], truth);
  error.sumAbsoluteDifference += difference.absolute;
  if (difference.isPartial)
  {
    ++error.penumbraPixels;
    error.sumPenumbraDifference += difference.absolute;
  }
}

double Share(double part, std::size_t whole)
{
  return whole > 0 ? part / static_cast<double>(whole) : 0.0;
}

}

PixelDifference DifferenceOf(float visibility, float truth)
{
  const auto isPartial = [](float value) { return value > 0.0f && value < 1.0f; };
  PixelDifference difference;
  difference.absolute = std::abs(static_cast<double>(visibility) - truth);
  difference.isMismatch = !(difference.absolute <= 0.5);
  difference.isPartial = isPartial(truth) || isPartial(visibility);
  return difference;
}

double VisibilityError::MismatchPercent() const
{
  return 100.0 * Share(static_cast<double>(this->mismatchPixels), this->receiverPixels);
}

double VisibilityError::GrossPercent() const
{
  return 100.0 * Share(static_cast<double>(this->GrossPixels()), this->receiverPixels);
}

double VisibilityError::MeanAbsoluteDifference() const
{
  return Share(this->sumAbsoluteDifference, this->receiverPixels);
}

double VisibilityError::MeanPenumbraDifference() const
{
  return Share(this->sumPenumbraDifference, this->penumbraPixels);
}

VisibilityError MeasureVisibility(
  const VisibilityImages& images, double edgeDistance, std::vector<PixelVerdict>* verdicts)
{
  RequireValid(images, edgeDistance);
  const std::size_t width = images.width;
  const std::size_t height = images.height;
  if (verdicts)
  {
    verdicts->resize(width * height);
  }

  const std::vector<int> columnDistances = ColumnDistances(images);
  // An image without edges is infinitely far from them, even where the square overflows.
  const double allowed = std::min(edgeDistance * edgeDistance, std::numeric_limits<double>::max());
  RowDistances rowDistances(images.width);
  VisibilityError error;
  for (std::size_t y = 0; y < height; ++y)
  {
    const std::vector<double>& squared = rowDistances.From(&columnDistances[y * width]);
    for (std::size_t x = 0; x < width; ++x)
    {
      const std::size_t pixel = y * width + x;
      const PixelVerdict verdict = Judge(images, pixel, squared[x] > allowed);
      if (images.role[pixel] == PixelRole::Measured)
      {
        CountMeasured(error, images, pixel, verdict);
      }
      error.uncertainPixels += images.role[pixel] == PixelRole::Uncertain;
      if (verdicts)
      {
        (*verdicts)[pixel] = verdict;
      }
    }
  }
  return error;
}

}
