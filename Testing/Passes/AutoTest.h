// What the tests of technique "auto" share: a still life, and what was chosen for its lights.
#ifndef vtkshadows_AutoTest_h
#define vtkshadows_AutoTest_h

#include "ShadowTest.h"

#include <vtkConeSource.h>

#include <set>

namespace shadowtest
{

class AutoTest : public ShadowTest
{
protected:
  void SetUp() override
  {
    ShadowTest::SetUp();
    this->Shadows->SetTechniqueToAuto();
    this->Renderer->SetPass(this->Shadows);
  }

  // A floor, a sphere and a cone under a sun.
  void MakeStillLife()
  {
    this->Floor = AddFloor(this->Renderer, 5.0);
    this->Ball = AddSphere(this->Renderer, { 0.0, 0.0, 1.2 }, 0.8);
    vtkNew<vtkConeSource> cone;
    cone->SetCenter(1.6, 0.8, 0.8);
    cone->SetResolution(30);
    AddActor(this->Renderer, cone);
    this->Sun = AddSun(this->Renderer, { 0.4, 0.3, -1.0 });
    LookAt(this->Renderer, { 4.0, -8.0, 5.0 }, { 0.0, 0.0, 0.5 });
  }

  // Renders until the choice is made; how many frames that took.
  int Settle(int most = 60)
  {
    int frames = 0;
    do
    {
      this->Render();
      ++frames;
    } while (!this->Shadows->GetChoiceIsSettled() && frames < most);
    EXPECT_TRUE(this->Shadows->GetChoiceIsSettled()) << "in " << frames << " frames";
    return frames;
  }

  std::string Chosen(vtkLight* light) { return this->Shadows->GetChosenTechnique(light); }

  // The choice is one of these, the explanation begins with it, and all of `parts` are in it.
  void ExpectChosen(
    vtkLight* light, const std::set<std::string>& names, const std::vector<std::string>& parts = {})
  {
    const std::string explanation = this->Shadows->GetExplanation(light);
    std::printf("       %s\n", explanation.c_str());
    EXPECT_EQ(names.count(this->Chosen(light)), 1u) << explanation;
    EXPECT_EQ(explanation.find(this->Chosen(light)), 0u) << explanation;
    EXPECT_EQ(explanation.back(), '.');
    for (const std::string& part : parts)
    {
      EXPECT_NE(explanation.find(part), std::string::npos) << part << " in " << explanation;
    }
  }

  vtkIdType Builds() { return this->Shadows->GetDepthShadowMapPass()->GetNumberOfMapBuilds(); }

  vtkSmartPointer<vtkActor> Floor, Ball;
  vtkSmartPointer<vtkLight> Sun;
};

}

#endif
