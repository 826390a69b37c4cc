// This frame's shadow catchers: what their shaders are told, and which masks they read. A mask has
// one answer a pixel, so where a catcher may lie before another receiver it has masks of its own.
#ifndef vtkShadowCatchers_h
#define vtkShadowCatchers_h

#include "vtkShadowSceneData.h"
#include "vtkShadowTextureArray.h"

#include <map>
#include <vector>

class vtkShaderProgram;
class vtkShadowTechniquePass;

class vtkShadowCatchers
{
public:
  // Which receivers are drawn, where a technique or a read-back asks for them.
  enum class Round
  {
    All,
    Catchers,
    Others
  };
  Round Drawn = Round::All;

  // `casting`: which of the scene's lights have a technique. true if other props catch than in the
  // last frame.
  bool Gather(const vtkShadowFrame& frame, const std::vector<bool>& casting);

  bool Has(vtkProp* prop) const;
  bool IsDrawn(const vtkShadowScene::Prop& prop) const;

  // Whether masks must be made twice: for the catchers alone, and for the others alone.
  bool NeedMasks() const { return this->Apart; }
  // Take the masks that a technique has made of the catchers; it makes new ones for the others.
  void KeepMasks(vtkShadowTechniquePass* technique, vtkShadowTextureArray& masks);
  // The masks that catchers read; nullptr: those of the others.
  const vtkShadowTextureArray* MasksOf(vtkShadowTechniquePass* technique) const;
  void ActivateMasks();
  void DeactivateMasks();
  void ReleaseMasks();

  void SetParameters(vtkShaderProgram* program, vtkProp* prop) const;

private:
  struct Catcher
  {
    bool Reached = false; // some light that casts shines on the side that is seen
    float BoxFromView[16] = {};
  };
  std::map<vtkProp*, Catcher> Known; // leaves and tops
  bool Apart = false;
  std::map<vtkShadowTechniquePass*, vtkShadowTextureArray> Masks;
};

#endif
