#include "SceneList.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkOpenGLStickMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vtkshadows::scenes
{

namespace
{

const double Pi = std::acos(-1.0);

// Angstrom.
constexpr double BondLength = 1.45, StickRadius = 0.14;

// As chemists colour them.
struct Element
{
  double radius;
  unsigned char color[4];
};
const Element Elements[] = { { 0.42, { 120, 120, 125, 255 } }, // carbon
  { 0.40, { 70, 100, 220, 255 } },                             // nitrogen
  { 0.38, { 215, 60, 50, 255 } },                              // oxygen
  { 0.28, { 235, 235, 235, 255 } } };                          // hydrogen

struct Molecule
{
  std::vector<glm::dvec3> atoms;
  std::vector<int> elements;
  std::vector<std::pair<int, int>> bonds;
};

glm::dvec3 Direction(Lot& any)
{
  const double z = any(-1.0, 1.0), turn = any(0.0, 2.0 * Pi), r = std::sqrt(1.0 - z * z);
  return { r * std::cos(turn), r * std::sin(turn), z };
}

// A chain wound into a helix, with side chains by lot.
Molecule MakeChain(int residues)
{
  Lot any(17);
  Molecule molecule;
  const auto add = [&molecule](const glm::dvec3& at, int element, int to)
  {
    molecule.atoms.push_back(at);
    molecule.elements.push_back(element);
    const int atom = static_cast<int>(molecule.atoms.size()) - 1;
    if (to >= 0)
    {
      molecule.bonds.emplace_back(to, atom);
    }
    return atom;
  };
  int last = -1;
  const double ring = BondLength * 3.0 * residues / (3.0 * 2.0 * Pi) * 0.45 + 4.0;
  for (int i = 0; i < 3 * residues; ++i)
  {
    const double t = double(i) / (3 * residues);
    const double around = 3.0 * 2.0 * Pi * t, wind = 2.0 * Pi * i / 10.8;
    const double reach = ring * (0.45 + 0.55 * t) + 2.3 * std::cos(wind);
    const glm::dvec3 at(reach * std::cos(around), reach * std::sin(around),
      2.3 * std::sin(wind) + 6.0 * std::sin(2.0 * around) * t);
    last = add(at, i % 3 == 0 ? 1 : 0, last);
    glm::dvec3 branch = at;
    int from = last;
    const int atoms = i % 3 == 1 ? 3 : 1;
    for (int k = 0; k < atoms; ++k)
    {
      branch += BondLength * glm::normalize(Direction(any) + glm::dvec3(0.0, 0.0, 0.4));
      from = add(branch, k + 1 < atoms ? 0 : (i % 3 == 2 ? 2 : 3), from);
    }
  }
  double lowest = 0.0;
  for (const glm::dvec3& atom : molecule.atoms)
  {
    lowest = std::min(lowest, atom.z);
  }
  for (glm::dvec3& atom : molecule.atoms)
  {
    atom.z += 2.0 - lowest;
  }
  return molecule;
}

// One cell of all points: VTK asks cells for a mapper's bounds, and does not draw what has none.
void SetPoints(vtkPolyData* mesh, vtkPoints* points)
{
  vtkNew<vtkCellArray> all;
  all->InsertNextCell(static_cast<int>(points->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    all->InsertCellPoint(i);
  }
  mesh->SetPoints(points);
  mesh->SetVerts(all);
}

void AddBalls(vtkRenderer* renderer, const Molecule& molecule)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> radii;
  radii->SetName("radius");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (std::size_t i = 0; i < molecule.atoms.size(); ++i)
  {
    const Element& element = Elements[molecule.elements[i]];
    points->InsertNextPoint(&molecule.atoms[i].x);
    radii->InsertNextValue(static_cast<float>(element.radius));
    colors->InsertNextTypedTuple(element.color);
  }
  vtkNew<vtkPolyData> balls;
  SetPoints(balls, points);
  balls->GetPointData()->AddArray(radii);
  balls->GetPointData()->SetScalars(colors);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(balls);
  mapper->SetScaleArray("radius");
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

void AddSticks(vtkRenderer* renderer, const Molecule& molecule)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> scales;
  scales->SetName("length and radius");
  scales->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> directions;
  directions->SetName("direction");
  directions->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (const auto& bond : molecule.bonds)
  {
    const glm::dvec3 a = molecule.atoms[bond.first], b = molecule.atoms[bond.second];
    const glm::dvec3 middle = 0.5 * (a + b), along = glm::normalize(b - a);
    points->InsertNextPoint(&middle.x);
    scales->InsertNextTuple3(glm::length(b - a), StickRadius, StickRadius);
    directions->InsertNextTuple(&along.x);
    colors->InsertNextTuple4(190, 185, 170, 255);
  }
  vtkNew<vtkPolyData> sticks;
  SetPoints(sticks, points);
  sticks->GetPointData()->AddArray(scales);
  sticks->GetPointData()->AddArray(directions);
  sticks->GetPointData()->SetScalars(colors);
  vtkNew<vtkOpenGLStickMapper> mapper;
  mapper->SetInputData(sticks);
  mapper->SetScaleArray("length and radius");
  mapper->SetOrientationArray("direction");
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

// Rays cannot hit a stick. A tube of triangles inside each, a little thinner and so never seen, has
// the ray-cast truth know of its shadow.
void AddCores(vtkRenderer* renderer, const Molecule& molecule)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const auto& bond : molecule.bonds)
  {
    lines->InsertNextCell(2);
    lines->InsertCellPoint(points->InsertNextPoint(&molecule.atoms[bond.first].x));
    lines->InsertCellPoint(points->InsertNextPoint(&molecule.atoms[bond.second].x));
  }
  vtkNew<vtkPolyData> axes;
  axes->SetPoints(points);
  axes->SetLines(lines);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(axes);
  tubes->SetRadius(0.97 * StickRadius);
  tubes->SetNumberOfSides(16);
  AddActor(renderer, tubes);
}

}

void MakeMolecule(SceneInMaking& scene)
{
  const Molecule molecule = MakeChain(ScaledCells(90, scene.size.detail * scene.size.detail, 3));
  AddBalls(scene.renderer, molecule);
  AddSticks(scene.renderer, molecule);
  AddCores(scene.renderer, molecule);
  glm::dvec3 low(0.0), high(0.0);
  for (const glm::dvec3& atom : molecule.atoms)
  {
    low = glm::min(low, atom);
    high = glm::max(high, atom);
  }
  const double reach = std::max(high.x - low.x, high.y - low.y);
  AddFloor(scene.renderer, 0.8 * reach)->GetProperty()->SetColor(0.9, 0.9, 0.88);

  scene.facts.planes = 1;
  scene.facts.facts.push_back({ "atoms", double(molecule.atoms.size()), "" });
  scene.facts.facts.push_back({ "bonds", double(molecule.bonds.size()), "" });
  scene.facts.notes.push_back("a thin tube of triangles inside each stick has the truth, which "
                              "cannot see sticks, know of its shadow");
  const glm::dvec3 centre(0.5 * (low.x + high.x), 0.5 * (low.y + high.y), 0.5 * high.z);
  scene.Add(AddSun(scene.renderer, -Toward(-50.0, 50.0)), 0.03);
  scene.Show({ centre, 0.5 * reach }, 15.0, 38.0);
}

}
