// Objects on a floor, as figures have them. Each stands on the plane z = 0, about the z axis.
#ifndef vtkshadows_StudioScenes_h
#define vtkshadows_StudioScenes_h

#include "SceneParts.h"

#include <string>

namespace vtkshadows::scenes
{

// `detail`: times the triangles, about.

// A sphere, a torus, a cone and a box, in four colours. No light.
Subject AddStillLife(vtkRenderer* renderer, double detail = 1.0);

// A closed mesh of 115 000 triangles with large and fine bumps: a made stand-in for a scan.
Subject AddBumpyMesh(vtkRenderer* renderer, double detail = 1.0);

// A scanned mesh, y up, set on the floor; from an OFF or PLY file. Throws std::runtime_error if it
// cannot be read; then nothing was added.
Subject AddScannedMesh(vtkRenderer* renderer, const std::string& file);

// Thin tubes among small glyphs: 330 000 triangles.
Subject AddTubesAndGlyphs(vtkRenderer* renderer, double detail = 1.0);

}

#endif
