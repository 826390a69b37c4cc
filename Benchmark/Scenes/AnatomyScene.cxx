#include "SceneList.h"

#include <vtkDiscreteFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkWindowedSincPolyDataFilter.h>
#include <vtkXMLImageDataReader.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <climits>
#include <cmath>
#include <fstream>
#include <map>
#include <stdexcept>

namespace vtkshadows::scenes
{

namespace
{

const double Pi = std::acos(-1.0);

// Muted tones, in turn for organs.
const glm::dvec3 Tones[] = { { 0.92, 0.88, 0.78 }, { 0.75, 0.35, 0.33 }, { 0.85, 0.62, 0.58 },
  { 0.55, 0.38, 0.33 }, { 0.88, 0.75, 0.45 }, { 0.60, 0.65, 0.80 }, { 0.70, 0.78, 0.60 },
  { 0.80, 0.60, 0.75 } };

constexpr int Outside = 0, Body = 1, Bone = 2, Heart = 3, Lungs = 4, Liver = 5, Brain = 6;

double Ball(const glm::dvec3& p, const glm::dvec3& centre, const glm::dvec3& radii)
{
  return glm::length((p - centre) / radii);
}

// A trunk and a head with organs, about the z axis, 0 to 2.4 high: what is at a place.
int TissueAt(const glm::dvec3& p)
{
  const bool inside = Ball(p, { 0.0, 0.0, 0.85 }, { 0.62, 0.42, 0.80 }) < 1.0 ||
    Ball(p, { 0.0, 0.0, 1.95 }, { 0.32, 0.38, 0.42 }) < 1.0 ||
    (std::hypot(p.x, p.y) < 0.19 && p.z > 1.4 && p.z < 1.8);
  if (!inside)
  {
    return Outside;
  }
  const double skull = Ball(p, { 0.0, 0.0, 1.98 }, { 0.27, 0.33, 0.34 });
  if (skull < 1.0)
  {
    // Open below, and cut away before the brain, so that it is seen.
    return skull < 0.82 ? Brain : (p.y < 0.02 && p.z > 1.98 ? Body : Bone);
  }
  if (std::hypot(p.x, p.y - 0.22) < 0.055 + 0.02 * std::sin(28.0 * Pi * p.z / 2.4) && p.z > 0.25 &&
    p.z < 1.75)
  {
    return Bone;
  }
  for (int rib = 0; rib < 6; ++rib)
  {
    const double slope = 0.25 * (p.y - 0.2);
    const double height = 0.75 + 0.13 * rib + slope;
    const double reach = std::sqrt(std::max(0.0, 1.0 - std::pow((height - 0.85) / 0.80, 2.0)));
    const double ring = Ball(p, { 0.0, 0.0, p.z }, { 0.52 * reach, 0.33 * reach, 1.0 }) - 1.0;
    const double from = std::hypot(0.45 * ring, p.z - height);
    if (from < 0.03 && !(p.y < 0.0 && std::abs(p.x) < 0.1))
    {
      return Bone;
    }
  }
  if (Ball(p, { 0.05, -0.06, 1.12 }, { 0.13, 0.11, 0.15 }) < 1.0)
  {
    return Heart;
  }
  if (Ball(p, { 0.26, 0.02, 1.1 }, { 0.15, 0.18, 0.3 }) < 1.0 ||
    Ball(p, { -0.26, 0.02, 1.1 }, { 0.15, 0.18, 0.3 }) < 1.0)
  {
    return Lungs;
  }
  if (Ball(p, { -0.14, -0.05, 0.66 }, { 0.28, 0.2, 0.13 }) < 1.0)
  {
    return Liver;
  }
  return Body;
}

vtkSmartPointer<vtkImageData> MakeTissues(double detail)
{
  const double low[3] = { -0.7, -0.5, 0.0 }, high[3] = { 0.7, 0.5, 2.4 };
  const double step = 2.5 / ScaledCells(160, detail, 32);
  auto volume = vtkSmartPointer<vtkImageData>::New();
  int size[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    size[axis] = static_cast<int>(std::ceil((high[axis] - low[axis]) / step)) + 1;
  }
  volume->SetDimensions(size);
  volume->SetOrigin(low);
  volume->SetSpacing(step, step, step);
  volume->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* label = static_cast<unsigned char*>(volume->GetScalarPointer());
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const glm::dvec3 p(low[0] + i * step, low[1] + j * step, low[2] + k * step);
        *label++ = static_cast<unsigned char>(TissueAt(p));
      }
    }
  }
  return volume;
}

vtkSmartPointer<vtkImageData> ReadTissues(const std::string& file)
{
  vtkNew<vtkXMLImageDataReader> reader;
  if (std::ifstream(file) && reader->CanReadFile(file.c_str()))
  {
    reader->SetFileName(file.c_str());
    reader->Update();
  }
  vtkSmartPointer<vtkImageData> volume = reader->GetOutput();
  vtkDataArray* labels = volume->GetPointData()->GetScalars();
  if (!labels && volume->GetPointData()->GetNumberOfArrays() > 0)
  {
    labels = volume->GetPointData()->GetArray(0);
    volume->GetPointData()->SetScalars(labels);
  }
  if (!labels || labels->GetNumberOfComponents() != 1 || volume->GetDataDimension() != 3)
  {
    throw std::runtime_error(file + " is no .vti file of a volume of labels");
  }
  return volume;
}

// What labels there are, and how far each reaches: the volume of its bounds, in samples.
std::map<int, double> LabelsOf(vtkImageData* volume)
{
  struct Box
  {
    glm::ivec3 low{ INT_MAX };
    glm::ivec3 high{ INT_MIN };
  };
  constexpr std::size_t MostLabels = 64;
  std::map<int, Box> boxes;
  const int* size = volume->GetDimensions();
  vtkDataArray* labels = volume->GetPointData()->GetScalars();
  vtkIdType at = 0;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const int label = static_cast<int>(labels->GetComponent(at++, 0));
        if (label == Outside)
        {
          continue;
        }
        Box& box = boxes[label];
        box.low = glm::min(box.low, glm::ivec3(i, j, k));
        box.high = glm::max(box.high, glm::ivec3(i, j, k));
        if (boxes.size() > MostLabels)
        {
          throw std::runtime_error("a volume of more than 64 labels is no segmentation");
        }
      }
    }
  }
  std::map<int, double> reach;
  for (const auto& [label, box] : boxes)
  {
    const glm::dvec3 extent(box.high - box.low);
    reach[label] = (extent.x + 1.0) * (extent.y + 1.0) * (extent.z + 1.0);
  }
  return reach;
}

// 1 where there is any tissue.
vtkSmartPointer<vtkImageData> AnyTissue(vtkImageData* volume)
{
  auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->CopyStructure(volume);
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  vtkDataArray* labels = volume->GetPointData()->GetScalars();
  auto* target = static_cast<unsigned char*>(mask->GetScalarPointer());
  for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
  {
    target[i] = labels->GetComponent(i, 0) != Outside ? 1 : 0;
  }
  return mask;
}

// The steps of the samples are smoothed away (Taubin, Zhang and Golub 1996).
vtkSmartPointer<vtkActor> AddTissue(vtkRenderer* renderer, vtkImageData* volume, int label)
{
  vtkNew<vtkDiscreteFlyingEdges3D> contour;
  contour->SetInputData(volume);
  contour->SetValue(0, label);
  vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  smooth->SetInputConnection(contour->GetOutputPort());
  smooth->SetNumberOfIterations(15);
  smooth->SetPassBand(0.05);
  smooth->BoundarySmoothingOff();
  smooth->NonManifoldSmoothingOn();
  smooth->NormalizeCoordinatesOn();
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(smooth->GetOutputPort());
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  if (normals->GetOutput()->GetNumberOfPolys() == 0)
  {
    return nullptr;
  }
  auto actor = AddActor(renderer, normals->GetOutput());
  actor->GetMapper()->ScalarVisibilityOff();
  return actor;
}

}

// The tissue that reaches farthest is the body: its outside is drawn translucent about the others.
void MakeAnatomy(SceneInMaking& scene)
{
  const bool made = scene.size.volume.empty();
  const vtkSmartPointer<vtkImageData> volume =
    made ? MakeTissues(scene.size.detail) : ReadTissues(scene.size.volume);
  if (made)
  {
    scene.facts.notes.push_back("no volume is given: a made one stands in for it");
  }
  const std::map<int, double> labels = LabelsOf(volume);
  if (labels.empty())
  {
    throw std::runtime_error(scene.size.volume + " holds no label but 0");
  }
  int outermost = labels.begin()->first;
  for (const auto& [label, reach] : labels)
  {
    outermost = reach > labels.at(outermost) ? label : outermost;
  }
  int organs = 0;
  for (const auto& [label, reach] : labels)
  {
    if (label == outermost && labels.size() > 1)
    {
      continue;
    }
    if (auto organ = AddTissue(scene.renderer, volume, label))
    {
      const glm::dvec3 tone = Tones[organs++ % (sizeof(Tones) / sizeof(Tones[0]))];
      organ->GetProperty()->SetColor(tone.x, tone.y, tone.z);
    }
  }
  if (auto skin = AddTissue(scene.renderer, AnyTissue(volume), 1))
  {
    skin->GetProperty()->SetColor(0.9, 0.75, 0.65);
    skin->GetProperty()->SetOpacity(0.2);
  }
  double bounds[6];
  scene.renderer->ComputeVisiblePropBounds(bounds);
  const glm::dvec3 low(bounds[0], bounds[2], bounds[4]), high(bounds[1], bounds[3], bounds[5]);
  const Subject subject{ 0.5 * (low + high), 0.5 * glm::length(high - low) };
  auto floor = AddFloor(scene.renderer, 2.2 * subject.radius, low.z);
  floor->SetPosition(subject.centre.x, subject.centre.y, 0.0);
  floor->GetProperty()->SetColor(0.85, 0.85, 0.8);

  scene.facts.closedCasters = made;
  scene.facts.planes = 1;
  scene.facts.facts.push_back({ "organs", double(organs), "" });
  scene.Add(AddSpot(scene.renderer, subject.centre + 4.0 * subject.radius * Toward(-50.0, 45.0),
              subject.centre, 50.0),
    0.06 * subject.radius);
  scene.Show({ subject.centre, 0.85 * subject.radius }, 15.0, 18.0);
}

}
