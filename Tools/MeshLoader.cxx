#include "MeshLoader.h"

#include "Failure.h"
#include "MeshSurface.h"
#include "OffReader.h"
#include "Progress.h"
#include "VtkMessages.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDataObject.h>
#include <vtkGLTFReader.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkVersionMacros.h>
#include <vtkXMLGenericDataObjectReader.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <new>

namespace fs = std::filesystem;

namespace vtkshadows
{
namespace
{

// How VTK's XML readers begin the error for what VTK's XML writers make of an empty mesh.
const std::string EmptyXml = "No Points element";

using ReaderPointer = vtkSmartPointer<vtkAlgorithm>;

template <class Reader>
ReaderPointer MakeReader(const std::string& path)
{
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

const std::map<std::string, ReaderPointer (*)(const std::string&)>& Readers()
{
  static const std::map<std::string, ReaderPointer (*)(const std::string&)> readers = {
    { ".vtp", MakeReader<vtkXMLGenericDataObjectReader> },
    { ".vtu", MakeReader<vtkXMLGenericDataObjectReader> },
    { ".vti", MakeReader<vtkXMLGenericDataObjectReader> },
    { ".vtr", MakeReader<vtkXMLGenericDataObjectReader> },
    { ".vts", MakeReader<vtkXMLGenericDataObjectReader> },
    { ".vtm", MakeReader<vtkXMLGenericDataObjectReader> },
    { ".vtk", MakeReader<vtkGenericDataObjectReader> }, { ".ply", MakeReader<vtkPLYReader> },
    { ".stl", MakeReader<vtkSTLReader> }, { ".obj", MakeReader<vtkOBJReader> },
    { ".gltf", MakeReader<vtkGLTFReader> }, { ".glb", MakeReader<vtkGLTFReader> },
    { ".off", nullptr }, // ReadOff
  };
  return readers;
}

std::string ExtensionOf(const std::string& path)
{
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void RequireMeshFile(const std::string& path)
{
  std::error_code error;
  if (!fs::exists(path, error))
  {
    throw Failure(
      "input", path.empty() ? "''" : path, "there is no such file", "check its name and folder");
  }
  if (fs::is_directory(path, error))
  {
    throw Failure("input", path, "is a folder", "name the mesh files in it");
  }
  if (!Readers().count(ExtensionOf(path)))
  {
    throw Failure(
      "input", path, "is of no kind that is read", "convert it to one of " + KnownExtensions());
  }
  if (!std::ifstream(path))
  {
    throw Failure("input", path, "cannot be opened", "check that you may read it");
  }
  if (fs::is_regular_file(path, error) && fs::file_size(path, error) == 0)
  {
    throw Failure("input", path, "is an empty file", "write it again, or leave it out");
  }
}

void ReportProgress(vtkObject* caller, unsigned long, void* progress, void*)
{
  static_cast<Progress*>(progress)->Update(static_cast<vtkAlgorithm*>(caller)->GetProgress());
}

vtkSmartPointer<vtkDataObject> ReadDataObject(const std::string& path, Progress& progress)
{
  const auto makeReader = Readers().at(ExtensionOf(path));
  if (!makeReader)
  {
    return ReadOff(path, [&progress](double fraction) { progress.Update(fraction); });
  }

  const ReaderPointer reader = makeReader(path);
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(ReportProgress);
  observer->SetClientData(&progress);
  reader->AddObserver(vtkCommand::ProgressEvent, observer);
  reader->Update();
  return reader->GetOutputDataObject(0);
}

// VTK gave expat what follows the document's end, which expat takes no longer (VTK issue 19258).
std::string AppendedDataRemedy(const std::string& path)
{
  if (Readers().at(ExtensionOf(path)) != MakeReader<vtkXMLGenericDataObjectReader>)
  {
    return "";
  }
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
  {
    if (line.find("<AppendedData") != std::string::npos)
    {
      return "; VTK before 9.4 cannot read appended data by a recent expat: then write the file "
             "with another data mode, ascii or binary";
    }
  }
#endif
  return "";
}

Mesh LoadMesh(const std::string& path, std::optional<double> isovalue, Progress& progress)
{
  const std::string extension = ExtensionOf(path);
  progress.Begin("reading " + path);
  TakeVtkError();
  const vtkSmartPointer<vtkDataObject> data = ReadDataObject(path, progress);
  const std::string error = TakeVtkError();
  if (error.compare(0, EmptyXml.size(), EmptyXml) == 0)
  {
    throw Failure("input", path, "is an empty mesh: it has no points", "leave it out");
  }
  if (!error.empty() || !data)
  {
    throw Failure("input", path,
      "is no mesh that can be read as " + extension + (error.empty() ? "" : " (" + error + ")"),
      "check that the file is whole and what its extension says" + AppendedDataRemedy(path));
  }

  progress.Begin("making the surface of " + path);
  Mesh mesh{ path, SurfaceOf(data, path, isovalue) };
  progress.End();
  return mesh;
}

}

std::string KnownExtensions()
{
  std::string list;
  for (const auto& reader : Readers())
  {
    list += (list.empty() ? "" : " ") + reader.first;
  }
  return list;
}

void RequireMeshFiles(const std::vector<std::string>& paths)
{
  for (const std::string& path : paths)
  {
    RequireMeshFile(path);
  }
}

std::vector<Mesh> LoadMeshes(
  const std::vector<std::string>& paths, std::optional<double> isovalue, Progress& progress)
{
  std::vector<Mesh> meshes;
  for (const std::string& path : paths)
  {
    try
    {
      meshes.push_back(LoadMesh(path, isovalue, progress));
    }
    catch (const std::bad_alloc&)
    {
      throw Failure("input", path, "is larger than the memory, or damaged",
        "check the file, or take a machine with more memory");
    }
  }
  return meshes;
}

}
