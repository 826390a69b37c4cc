// The techniques and their settings that `bench` measures, by name.
#ifndef vtkshadows_BenchSettings_h
#define vtkshadows_BenchSettings_h

#include <functional>
#include <string>
#include <vector>

class vtkShadowPass;

namespace vtkshadows
{

struct BenchSetting
{
  std::string name;                          // "depth-map/percentage-closer/2048"
  std::string technique;                     // of vtkShadowPass, or PeerTechnique
  bool soft = false;                         // lights have their radius, and the truth is soft
  bool fast = false;                         // among those of the fast bench
  bool directional = false;                  // says something of directional lights alone
  int resolution = 0;                        // of a map or texture, texels; 0: none
  int samples = 0;                           // sample lights; 0: none
  std::function<void(vtkShadowPass*)> apply; // none for the peer

  bool IsPeer() const;
};

// VTK's own vtkShadowMapPass.
extern const char* const PeerTechnique;

// All there are in this build.
std::vector<BenchSetting> BenchSettings();

// Those that sweeps time: each technique as it is by default, hard; and those with sample lights,
// with so many.
std::vector<BenchSetting> SweepSettings();
std::vector<BenchSetting> SampledSettings(int samples);

// Whether `name` is meant by `patterns`, between commas: each the whole name with * and ? for any
// text and any letter, or, without these, a part of the name. Empty: every name.
bool MatchesPatterns(const std::string& name, const std::string& patterns);

}

#endif
