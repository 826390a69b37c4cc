// What was measured of the error of lights by settings, in which view, and how far the present one
// is from that.
#ifndef vtkShadowMeasuredErrors_h
#define vtkShadowMeasuredErrors_h

#include "ErrorRate.h"
#include "TechniqueChoice.h"
#include "vtkShadowSceneData.h"

#include <optional>
#include <vector>

class vtkShadowMeasuredErrors
{
public:
  // What an error depends on.
  struct Circumstances
  {
    const vtkLight* Source = nullptr;
    vtkshadows::ShadowLight Light;
    glm::dmat4 ViewFromWorld{ 1.0 };
    glm::dmat4 ClipFromView{ 1.0 };
    int Height = 0; // pixels
    double Distance =
      1.0;              // from the eye to the nearest receiver; not less than a share of their size
    double Reach = 1.0; // size of what receives and casts
    double CasterChanges = 0.0; // a count, those that belong to a motion as less
  };

  // What Elapsed counts, seconds: records are kept at the time that was set last.
  void SetTime(double seconds) { this->Time = seconds; }

  // How far apart two are: 0 not at all, 1 another picture.
  static double DriftOf(const Circumstances& then, const Circumstances& now);

  struct Record
  {
    vtkshadows::ErrorPercents Error;
    double Cost = 0.0;    // seconds that measuring took
    double Elapsed = 0.0; // since, seconds
    double Drift = 0.0;   // of the circumstances since
    double Rate = 0.0;    // at which it may have changed (ErrorRate.h)
    bool WasRefused = false;
  };
  std::optional<Record> Find(
    const vtkshadows::ShadowSetting& setting, const Circumstances& now) const;
  void Keep(const vtkshadows::ShadowSetting& setting, const Circumstances& now,
    const vtkshadows::ErrorPercents& error, double cost);
  // What was drawn by, and is not right any more.
  void Refuse(const vtkshadows::ShadowSetting& setting, const Circumstances& now);
  void ForgiveAll();
  // Forget lights that are not among these.
  void KeepOnly(const std::vector<const vtkLight*>& lights);
  void Forget() { this->Entries.clear(); }

private:
  struct Entry
  {
    vtkshadows::ShadowSetting Setting;
    Circumstances Then;
    vtkshadows::ErrorPercents Error;
    double Cost = 0.0;
    double Time = 0.0;
    vtkshadows::ErrorRate Rate;
    bool WasRefused = false;
  };
  // Index into Entries, or their number.
  std::size_t Place(const vtkshadows::ShadowSetting& setting, const Circumstances& now) const;

  std::vector<Entry> Entries;
  double Time = 0.0;
};

#endif
