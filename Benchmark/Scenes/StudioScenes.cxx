#include "StudioScenes.h"

#include "SceneList.h"

#include <vtkCellArray.h>
#include <vtkConeSource.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTubeFilter.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace vtkshadows::scenes
{

namespace
{

const double Pi = std::acos(-1.0);

vtkSmartPointer<vtkPolyData> MakeTorus(double ring, double tube, double detail)
{
  return MakeSurface(ScaledCells(96, detail), ScaledCells(48, detail),
    [=](double u, double v)
    {
      const double around = 2.0 * Pi * u, across = 2.0 * Pi * v;
      const double reach = ring + tube * std::cos(across);
      return glm::dvec3(
        reach * std::cos(around), reach * std::sin(around), tube * std::sin(across));
    });
}

double Bumps(const glm::dvec3& p)
{
  return 0.12 * std::sin(5.0 * p.x + 1.0) * std::sin(4.0 * p.y) * std::sin(6.0 * p.z + 0.5) +
    0.015 * std::sin(31.0 * p.x) * std::sin(29.0 * p.y + 0.3) * std::sin(37.0 * p.z);
}

vtkSmartPointer<vtkPolyData> ReadOff(const std::string& file)
{
  std::ifstream in(file);
  std::string magic;
  vtkIdType pointCount = 0, faceCount = 0, edgeCount = 0;
  in >> magic >> pointCount >> faceCount >> edgeCount;
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; in && i < pointCount; ++i)
  {
    double x, y, z;
    in >> x >> y >> z;
    points->InsertNextPoint(x, y, z);
  }
  vtkNew<vtkCellArray> faces;
  for (vtkIdType i = 0; in && i < faceCount; ++i)
  {
    int corners, a, b, c;
    in >> corners >> a >> b >> c;
    faces->InsertNextCell({ a, b, c });
  }
  if (!in || magic != "OFF" || faces->GetNumberOfCells() == 0)
  {
    throw std::runtime_error(file + " is no OFF file of triangles");
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(faces);
  return mesh;
}

vtkSmartPointer<vtkPolyData> ReadPly(const std::string& file)
{
  vtkNew<vtkPLYReader> reader;
  if (std::ifstream(file) && vtkPLYReader::CanReadFile(file.c_str()))
  {
    reader->SetFileName(file.c_str());
    reader->Update();
  }
  vtkSmartPointer<vtkPolyData> mesh = reader->GetOutput();
  if (mesh->GetNumberOfPolys() == 0)
  {
    throw std::runtime_error(file + " is no PLY file of triangles");
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> ReadScan(const std::string& file)
{
  const std::string extension = std::filesystem::path(file).extension().string();
  return extension == ".ply" ? ReadPly(file) : ReadOff(file);
}

vtkSmartPointer<vtkPolyData> MakeStrands(int count, int points)
{
  auto strands = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> where;
  vtkNew<vtkCellArray> lines;
  for (int strand = 0; strand < count; ++strand)
  {
    const double phase = 2.0 * Pi * strand / count;
    lines->InsertNextCell(points);
    for (int i = 0; i < points; ++i)
    {
      const double t = double(i) / (points - 1);
      // Wound so that neighbours come close and never touch, as streamlines do.
      const double angle = phase + 2.5 * Pi * t + 0.1 * std::sin(9.0 * t + 5.0 * phase);
      const double reach = 1.2 + 0.6 * std::sin(3.0 * t + 2.0 * phase);
      lines->InsertCellPoint(
        where->InsertNextPoint(reach * std::cos(angle), reach * std::sin(angle), 0.15 + 2.4 * t));
    }
  }
  strands->SetPoints(where);
  strands->SetLines(lines);
  return strands;
}

void AddGlyphs(vtkRenderer* renderer, int count, double detail)
{
  Lot any(7);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> directions;
  directions->SetName("direction");
  directions->SetNumberOfComponents(3);
  for (int i = 0; i < count; ++i)
  {
    points->InsertNextPoint(any(-2.2, 2.2), any(-2.2, 2.2), any(0.2, 2.8));
    directions->InsertNextTuple3(any(-1.0, 1.0), any(-1.0, 1.0), any(-1.0, 1.0));
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  places->GetPointData()->AddArray(directions);

  vtkNew<vtkConeSource> cone;
  cone->SetResolution(ScaledCells(60, detail));
  cone->SetHeight(1.0);
  cone->SetRadius(0.3);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceConnection(cone->GetOutputPort());
  mapper->SetOrientationArray("direction");
  mapper->SetScaleArray("direction");
  mapper->SetScaleModeToScaleByMagnitude();
  mapper->SetScaleFactor(0.12);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.6, 0.3);
  renderer->AddActor(actor);
}

}

//------------------------------------------------------------------------------
Subject AddStillLife(vtkRenderer* renderer, double detail)
{
  AddFloor(renderer, 6.0)->GetProperty()->SetColor(0.85, 0.85, 0.8);

  AddSphere(renderer, { -1.1, -0.9, 0.9 }, 0.9, ScaledCells(96, detail))
    ->GetProperty()
    ->SetColor(0.8, 0.3, 0.25);

  auto torus = AddSmooth(renderer, MakeTorus(0.9, 0.32, detail));
  torus->SetPosition(1.3, -0.9, 0.32);
  torus->GetProperty()->SetColor(0.3, 0.5, 0.8);

  vtkNew<vtkConeSource> source;
  source->SetHeight(2.4);
  source->SetRadius(0.8);
  source->SetResolution(ScaledCells(64, detail));
  source->SetDirection(0.0, 0.0, 1.0);
  auto cone = AddActor(renderer, source);
  cone->SetPosition(1.0, 1.3, 1.2);
  cone->GetProperty()->SetColor(0.9, 0.75, 0.3);

  auto box = AddBox(renderer, { -0.7, -0.6, 0.0 }, { 0.7, 0.6, 1.3 });
  box->RotateZ(25.0);
  box->SetPosition(-1.3, 1.3, 0.0);
  box->GetProperty()->SetColor(0.4, 0.7, 0.4);
  return { { 0.0, 0.0, 0.8 }, 2.6 };
}

Subject AddBumpyMesh(vtkRenderer* renderer, double detail)
{
  AddFloor(renderer, 5.0)->GetProperty()->SetColor(0.85, 0.85, 0.8);
  auto mesh = MakeSurface(ScaledCells(240, detail), ScaledCells(240, detail),
    [](double u, double v)
    {
      const double azimuth = 2.0 * Pi * u, down = Pi * v;
      const glm::dvec3 p(
        std::sin(down) * std::cos(azimuth), std::sin(down) * std::sin(azimuth), -std::cos(down));
      return glm::dvec3(0.0, 0.0, 1.15) + (1.0 + Bumps(p)) * p;
    });
  AddSmooth(renderer, mesh)->GetProperty()->SetColor(0.8, 0.65, 0.5);
  return { { 0.0, 0.0, 1.0 }, 1.5 };
}

Subject AddScannedMesh(vtkRenderer* renderer, const std::string& file)
{
  const vtkSmartPointer<vtkPolyData> mesh = ReadScan(file);
  // Turned from y up to z up, to a height of about 2.
  const double* bounds = mesh->GetBounds();
  const double scale = 2.0 / (bounds[3] - bounds[2]);
  auto actor = AddSmooth(renderer, mesh);
  actor->SetScale(scale);
  actor->RotateX(90.0);
  actor->SetPosition(-0.5 * scale * (bounds[0] + bounds[1]), 0.5 * scale * (bounds[4] + bounds[5]),
    -scale * bounds[2]);
  actor->GetProperty()->SetColor(0.8, 0.7, 0.6);
  AddFloor(renderer, 5.0)->GetProperty()->SetColor(0.85, 0.85, 0.8);
  return { { 0.0, 0.0, 0.95 }, 1.05 };
}

Subject AddTubesAndGlyphs(vtkRenderer* renderer, double detail)
{
  AddFloor(renderer, 6.0)->GetProperty()->SetColor(0.85, 0.85, 0.8);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(MakeStrands(40, ScaledCells(300, detail)));
  tubes->SetRadius(0.02);
  tubes->SetNumberOfSides(ScaledCells(8, detail));
  AddActor(renderer, tubes)->GetProperty()->SetColor(0.4, 0.6, 0.8);
  AddGlyphs(renderer, 1200, detail);
  return { { 0.0, 0.0, 1.3 }, 2.4 };
}

//------------------------------------------------------------------------------
void MakeStillLife(SceneInMaking& scene)
{
  const Subject subject = AddStillLife(scene.renderer, scene.size.detail);
  scene.facts.closedCasters = true;
  scene.facts.planes = 7;
  scene.Add(AddSun(scene.renderer, -Toward(-50.0, 45.0)), 0.05);
  scene.Show(subject, 20.0, 32.0);
}

void MakeStatue(SceneInMaking& scene)
{
  const bool made = scene.size.mesh.empty();
  const Subject subject = made ? AddBumpyMesh(scene.renderer, scene.size.detail)
                               : AddScannedMesh(scene.renderer, scene.size.mesh);
  if (made)
  {
    scene.facts.notes.push_back("no scanned mesh is given: a made bumpy mesh stands in for it");
  }
  // Of a scan nobody knows.
  scene.facts.closedCasters = made;
  scene.facts.planes = 1;
  const double distance = 4.0 * subject.radius;
  scene.Add(
    AddSpot(scene.renderer, subject.centre + distance * Toward(-60.0, 45.0), subject.centre, 50.0),
    0.1 * subject.radius);
  scene.Show({ subject.centre, 1.25 * subject.radius }, 15.0, 25.0);
}

void MakeFlow(SceneInMaking& scene)
{
  const Subject subject = AddTubesAndGlyphs(scene.renderer, scene.size.detail);
  scene.facts.planes = 1;
  vtkLight* sun = AddSun(scene.renderer, -Toward(-45.0, 50.0));
  sun->SetIntensity(0.6);
  scene.Add(sun, 0.02);
  vtkLight* spot = AddSpot(scene.renderer,
    subject.centre + 3.0 * subject.radius * Toward(70.0, 40.0), subject.centre, 50.0);
  spot->SetIntensity(0.5);
  scene.Add(spot, 0.1);
  scene.facts.facts.push_back({ "glyphs", 1200.0, "" });
  scene.Show(subject, 10.0, 30.0);
}

}
