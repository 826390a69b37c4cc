// What the tests of object-ID maps share: errors beside the depth map's, and objects told apart.
#ifndef vtkshadows_ObjectIDTest_h
#define vtkshadows_ObjectIDTest_h

#include "ShadowTest.h"
#include "TestScenes.h"

#include "vtkObjectIDShadowPass.h"
#include "vtkShadowErrorMeasure.h"

#include <vtkLightCollection.h>

#include <cstdio>

namespace shadowtest
{

struct Error
{
  double mismatch = 0.0; // percent of the receiver pixels
  double gross = 0.0;    // pixels
  double receivers = 0.0;
  double shadow = 0.0;
};

class ObjectIDTest : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Renderer->SetPass(this->Shadows);
    this->Shadows->SetTechnique("object-id");
  }

  vtkObjectIDShadowPass* Maps() { return this->Shadows->GetObjectIDShadowPass(); }

  Error ErrorOf(const std::string& what, const std::string& technique, vtkLight* light)
  {
    this->Shadows->SetTechnique(technique);
    this->Render();
    vtkNew<vtkShadowErrorMeasure> error;
    EXPECT_TRUE(error->Measure(this->Renderer, light)) << what;
    Error found;
    found.mismatch = error->GetMismatchPercent();
    found.gross = static_cast<double>(error->GetGrossFalsePixels() + error->GetGrossMissedPixels());
    found.receivers = static_cast<double>(error->GetReceiverPixels());
    found.shadow = static_cast<double>(error->GetShadowPixels());
    std::printf("%-34s %-10s mismatch %.4f %% gross %lld false, %lld missed of %.0f, mean absolute "
                "difference %.5f\n",
      what.c_str(), technique.c_str(), found.mismatch,
      static_cast<long long>(error->GetGrossFalsePixels()),
      static_cast<long long>(error->GetGrossMissedPixels()), found.receivers,
      error->GetMeanAbsoluteDifference());
    EXPECT_GT(found.shadow, found.receivers / 100) << what << ": few shadows";
    return found;
  }

  // At the default settings no grosser than the depth map, 16 bits as good as 32; what 8 bits lose
  // is printed.
  void CheckBesideDepthMap(const std::string& what)
  {
    this->Renderer->GetLights()->InitTraversal();
    int index = 0;
    while (vtkLight* light = this->Renderer->GetLights()->GetNextItem())
    {
      const std::string row = what + ", light " + std::to_string(index++);
      const Error byDepth = this->ErrorOf(row, "depth-map", light);
      Error byBits[4];
      const int bits[] = { 8, 16, 24, 32 };
      for (int i = 0; i < 4; ++i)
      {
        this->Maps()->SetDepthBits(bits[i]);
        byBits[i] =
          this->ErrorOf(row + ", " + std::to_string(bits[i]) + " bits", "object-id", light);
      }
      if (this->Maps()->GetNumberOfObjects() > 255)
      {
        ExpectOneMessage({ "vtkObjectIDShadowPass", "255 IDs" }); // by 24 bits
      }
      this->Maps()->SetDepthBits(16);
      CheckAtMost(row + ": gross px, beside the depth map's", byBits[1].gross, byDepth.gross);
      CheckAtMost(row + ": mismatch at 16 bits, beside 1.5 times that at 32", byBits[1].mismatch,
        1.5 * byBits[3].mismatch);
      CheckAtMost(row + ": gross at 16 bits, beside 1.5 times that at 32", byBits[1].gross,
        1.5 * byBits[3].gross);
      CheckAtMost(row + ": mismatch, beside 1.1 times the depth map's", byBits[1].mismatch,
        1.1 * byDepth.mismatch);
    }
  }

  // A floor under a sun, and IDs alone.
  void AddFloorAndSun()
  {
    this->Resize(640, 480);
    AddFloor(this->Renderer, 4.0);
    this->Light = AddSun(this->Renderer, { 0.3, 0.4, -1.0 });
    LookAt(this->Renderer, { 1.0, -6.0, 4.5 }, { 0.0, 0.0, 0.9 });
    this->Maps()->CombineDepthOff();
    this->Render();
  }

  // By `type` as the truth has it, but for an edge a texel narrower; with the coarser one much is
  // missed; and with depths both are right.
  void CheckToldApart(const std::string& coarser, const std::string& type, int objects)
  {
    SHADOWTEST_NEEDS_RAY_CAST();
    this->Maps()->SetObjectType(coarser);
    const Error merged = this->ErrorOf("merged, by " + coarser, "object-id", this->Light);
    CheckAtLeast("gross px where objects are merged", merged.gross, 500.0);
    this->Maps()->SetObjectType(type);
    const Error apart = this->ErrorOf("told apart, by " + type, "object-id", this->Light);
    CheckAtMost("mismatch where objects are told apart", apart.mismatch, 0.3);
    CheckAtMost("gross px where objects are told apart", apart.gross, 0.0);
    Check("objects", this->Maps()->GetNumberOfObjects(), objects);
    this->Maps()->CombineDepthOn();
    for (const std::string& each : { coarser, type })
    {
      this->Maps()->SetObjectType(each);
      const Error deep = this->ErrorOf("with depths, by " + each, "object-id", this->Light);
      CheckAtMost("mismatch with depths", deep.mismatch, 0.1);
      CheckAtMost("gross px with depths", deep.gross, 0.0);
    }
    this->Maps()->CombineDepthOff();
  }

  vtkSmartPointer<vtkLight> Light;
};

}

#endif
