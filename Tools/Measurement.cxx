#include "Measurement.h"

#include "Failure.h"
#include "Pictures.h"
#include "Stage.h"
#include "VtkMessages.h"

#include <vtkDepthShadowMapPass.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkShadowErrorMeasure.h>
#include <vtkShadowPass.h>
#include <vtkVersion.h>

namespace vtkshadows
{
namespace
{

[[noreturn]] void FailOnLight(const std::string& what, std::size_t light)
{
  const std::string error = TakeVtkError();
  throw Failure(what + " of light", std::to_string(light),
    error.empty() ? "could not be made" : error, "try another technique for this light");
}

}

bool CanMeasureErrors(Stage& stage)
{
  return stage.Shadows()->GetRayCastShadowPass() != nullptr;
}

std::string VisibilityPng(Stage& stage, std::size_t light)
{
  vtkNew<vtkImageData> visibility;
  if (!stage.Shadows()->GetVisibility(stage.Renderer(), stage.Lights()[light], visibility))
  {
    FailOnLight("visibility", light);
  }
  return PngOfVisibility(visibility);
}

MeasuredError MeasureError(Stage& stage, std::size_t light)
{
  vtkNew<vtkShadowErrorMeasure> measure;
  if (!measure->Measure(stage.Renderer(), stage.Lights()[light]))
  {
    FailOnLight("error", light);
  }
  MeasuredError measured;
  measured.error.receiverPixels = measure->GetReceiverPixels();
  measured.error.shadowPixels = measure->GetShadowPixels();
  measured.error.grossFalsePixels = measure->GetGrossFalsePixels();
  measured.error.grossMissedPixels = measure->GetGrossMissedPixels();
  measured.error.mismatchPercent = measure->GetMismatchPercent();
  measured.error.meanAbsoluteDifference = measure->GetMeanAbsoluteDifference();
  measured.errorMapPng = PngOfBytes(measure->GetErrorMap());
  return measured;
}

Report BeginReport(Stage& stage)
{
  Report report;
  vtkDepthShadowMapPass* maps = stage.Shadows()->GetDepthShadowMapPass();
  report.filter = vtkDepthShadowMapPass::GetFilterName(maps->GetFilter());
  report.depthBits = maps->GetDepthBits();
  report.triangles = stage.NumberOfTriangles();
  report.vtkVersion = vtkVersion::GetVTKVersion();
  report.openGLRenderer = stage.Window().OpenGLRenderer();
  return report;
}

}
