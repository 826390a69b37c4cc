// Files to the triangles that are drawn.
#ifndef vtkshadows_MeshLoader_h
#define vtkshadows_MeshLoader_h

#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

class vtkPolyData;

namespace vtkshadows
{

class Progress;

struct Mesh
{
  std::string path;
  vtkSmartPointer<vtkPolyData> triangles; // points finite, at least one triangle
};

// Throw Failure unless every path is a readable file with an extension that LoadMeshes knows.
void RequireMeshFiles(const std::vector<std::string>& paths);

// Volumes are contoured at `isovalue`. Throws Failure.
std::vector<Mesh> LoadMeshes(
  const std::vector<std::string>& paths, std::optional<double> isovalue, Progress& progress);

// The extensions that are read, for messages: ".vtp .vtu ...".
std::string KnownExtensions();

}

#endif
