// The scenes of the registry, each in a file of its name. Each adds its props, lights and camera to
// an empty renderer, and its own facts; what can be counted is counted afterwards.
#ifndef vtkshadows_SceneList_h
#define vtkshadows_SceneList_h

#include "SceneParts.h"
#include "Scenes.h"

namespace vtkshadows::scenes
{

struct SceneInMaking
{
  vtkRenderer* renderer;
  const SceneSize& size;
  SceneFacts& facts;

  // A light that the scene has, and what is soft about it.
  void Add(vtkLight* light, double radius);
  // What the camera shows, and from where.
  void Show(const Subject& subject, double azimuth, double elevation);
};

void MakeStillLife(SceneInMaking& scene);
void MakeStatue(SceneInMaking& scene);
void MakeFlow(SceneInMaking& scene);
void MakeAnatomy(SceneInMaking& scene);
void MakeTerrain(SceneInMaking& scene);
void MakeMolecule(SceneInMaking& scene);
void MakeCity(SceneInMaking& scene);
void MakeGrass(SceneInMaking& scene);
void MakeCrowd(SceneInMaking& scene);
void MakeClosedBox(SceneInMaking& scene);
void MakeFence(SceneInMaking& scene);

}

#endif
