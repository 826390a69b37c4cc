// The settings of technique passes that the choice varies: those that are as the passes have them
// by themselves. Others are the user's, and all are put back once nothing is chosen.
#ifndef vtkShadowChosenSettings_h
#define vtkShadowChosenSettings_h

#include "TechniqueChoice.h"

#include <functional>
#include <string>
#include <vector>

class vtkShadowTechniquePass;

class vtkShadowChosenSettings
{
public:
  using FindPass = std::function<vtkShadowTechniquePass*(const std::string& technique)>;

  // What is not as the choice left it was set by the user since. Once a frame, before the others.
  void Note(const FindPass& find);

  // Change `setting` where it is the user's to decide, or, with `fixed`, everywhere. false if the
  // pass has no such setting.
  bool Confine(vtkshadows::ShadowSetting& setting, bool fixed) const;

  void Apply(const vtkshadows::ShadowSetting& setting);
  void PutBack();

  // Of a technique, as the user has it.
  int OwnResolution(const std::string& technique) const;
  int OwnSamples(const std::string& technique) const;

private:
  // One setting of one pass.
  struct Knob
  {
    std::string Technique;
    std::string What;
    int Usual = 0;
    std::function<int()> Get;
    std::function<void(int)> Set;
    int Own = 0; // the user's
    int Applied = 0;
    bool IsApplied = false;
  };
  const Knob* Find(const std::string& technique, const char* what) const;
  void Set(const std::string& technique, const char* what, int value);

  std::vector<Knob> Knobs;
  FindPass Pass;
};

#endif
