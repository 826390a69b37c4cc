#include "vtkShadowSceneInternals.h"

#include "vtkShadowCasterGeometry.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace
{

// When a mapper last changed in a way that changes what it casts. A mapper's own time grows with
// its colours, too; where it places or shapes things by settings of its own there is no other.
vtkMTimeType ShapeMTime(vtkMapper* mapper)
{
  const bool isPlain = (mapper->IsA("vtkPolyDataMapper") || mapper->IsA("vtkDataSetMapper")) &&
    !mapper->IsA("vtkCompositePolyDataMapper") && !mapper->IsA("vtkCompositePolyDataMapper2") &&
    !mapper->IsA("vtkOpenGLSphereMapper") && !mapper->IsA("vtkOpenGLStickMapper") &&
    !mapper->IsA("vtkPointGaussianMapper");
  if (!isPlain)
  {
    vtkCompositeDataDisplayAttributes* blocks = vtkShadowCasterGeometry::AttributesOf(mapper);
    return std::max(mapper->GetMTime(), blocks ? blocks->GetMTime() : 0);
  }
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  vtkMTimeType time = planes ? planes->GetMTime() : 0;
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    time = std::max(time, planes->GetItem(i)->GetMTime());
  }
  return time;
}

}

//------------------------------------------------------------------------------
vtkMTimeType vtkShadowScene::Internals::DeepMTime(vtkDataObject* data)
{
  vtkMTimeType time = data->GetMTime();
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      time = std::max(time, it->GetCurrentDataObject()->GetMTime());
    }
  }
  return time;
}

//------------------------------------------------------------------------------
std::vector<std::uint64_t> vtkShadowScene::Internals::ShapeOf(const Piece& piece)
{
  std::vector<std::uint64_t> shape;
  Append(shape, piece.Prop);
  Append(shape, piece.Mapper);
  Append(shape, ShapeMTime(piece.Mapper));
  for (int port = 0; port < piece.Mapper->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < piece.Mapper->GetNumberOfInputConnections(port); ++i)
    {
      vtkDataObject* data = piece.Mapper->GetInputDataObject(port, i);
      Append(shape, data);
      Append(shape, data ? DeepMTime(data) : 0);
    }
  }
  if (auto* actor = vtkActor::SafeDownCast(piece.Prop))
  {
    vtkProperty* property = actor->GetProperty();
    Append(shape, property->GetRepresentation());
    Append(shape, property->GetLineWidth());
    Append(shape, property->GetPointSize());
    Append(shape, property->GetEdgeVisibility());
    Append(shape, actor->GetShaderProperty()->GetMTime());
  }
  return shape;
}

//------------------------------------------------------------------------------
void vtkShadowScene::Internals::AppendMatrix(
  std::vector<std::uint64_t>& signature, const glm::dmat4& matrix)
{
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 4; ++row)
    {
      Append(signature, matrix[column][row]);
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowScene::Internals::StampCasters()
{
  std::vector<std::uint64_t> signature;
  for (const Prop& prop : this->Props)
  {
    if (prop.Casts || prop.CastsRays)
    {
      Append(signature, prop.Source);
      Append(signature, prop.Casts); // not, if a stand-in does
      for (const Piece& piece : prop.Pieces)
      {
        signature.insert(signature.end(), piece.Signature.begin(), piece.Signature.end());
        Append(signature, piece.WideFloor); // then it is none
      }
    }
  }
  if (signature != this->CasterSignature || this->CasterTime.GetMTime() == 0)
  {
    this->CasterSignature.swap(signature);
    this->CasterTime.Modified();
  }
}
