// Shared by the suites of "stencil-volume": every light by volumes, in a small window, and held
// against the truth or against another way to make the same mask.
#ifndef vtkshadows_VolumeTest_h
#define vtkshadows_VolumeTest_h

#include "ShadowTest.h"

#include "ShadowMeshes.h"

#include <functional>

class vtkTransform;

namespace shadowtest
{

vtkSmartPointer<vtkPolyData> ToPolyData(const TestMesh& mesh);

class VolumeTest : public ShadowTest
{
protected:
  void SetUp() override;

  vtkStencilShadowVolumePass* Volumes() { return this->Shadows->GetStencilShadowVolumePass(); }

  // Holds the light's mask against the truth, in the view as it is. At most 0.1 % of the receiver
  // pixels may be mismatched and 5 of them gross, unless a test knows why not.
  void CheckTruth(const std::string& what, vtkLight* light, double mismatchPercent = 0.1,
    double grossPixels = 5.0);
  // The same where the view may show no receiver, or none in shadow; how many are.
  double CheckTruthIfAny(const std::string& what, vtkLight* light, double mismatchPercent = 0.1,
    double grossPixels = 5.0);
  // Of all that CheckTruth saw in this test.
  void CheckMeanMismatch(double percent);

  // Pixels that the light's mask has otherwise once `change` is made.
  std::size_t CountChanged(vtkLight* light, const std::function<void()>& change);

  // In how many volumes the receiver of each pixel lies.
  Visibility CountsOf(vtkLight* light);

private:
  double SumOfMismatches = 0.0;
  int Cases = 0;
};

// A floor, a sun and a lamp, and a view of what a test puts over the floor.
class CasterTest : public VolumeTest
{
protected:
  void SetUp() override;

  void CheckBoth(const std::string& what)
  {
    this->CheckTruth(what + ", sun", this->Sun);
    this->CheckTruth(what + ", lamp", this->Lamp);
  }
  vtkSmartPointer<vtkActor> AddThing();
  // Closed and open, like no mirror image of itself; about 3 across.
  static vtkSmartPointer<vtkPolyData> Thing();

  vtkSmartPointer<vtkActor> Floor;
  vtkSmartPointer<vtkLight> Sun, Lamp;
};

}

#endif
