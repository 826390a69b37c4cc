/**
 * @class   vtkShadowErrorMeasure
 * @brief   how far a light's visibility is from the truth, in the current view
 *
 * @code
 * vtkNew<vtkShadowErrorMeasure> error;
 * error->Measure(renderer, light);
 * error->GetMismatchPercent();
 * @endcode
 * The truth of a pixel is a ray from the receiver's own position there, so that a disagreement
 * about which surface is seen cannot pass for one about shadow. Measured are the receiver pixels
 * whose face looks toward the light (N.L above 0.02), which lie in a spot's cone, and whose truth
 * does not change between a ray epsilon and four times it; the latter are left out and counted.
 * - **mismatch**: share of pixels whose visibility differs from the truth by more than 0.5;
 * - **gross**: how many of those lie more than 2 px from any true shadow edge: false (acne, bars)
 * and missed (leaks, detached shadows).
 *
 * Needs Embree: without it Measure is an error.
 *
 * @sa vtkShadowPass vtkRayCastShadowPass
 */
#ifndef vtkShadowErrorMeasure_h
#define vtkShadowErrorMeasure_h

#include "vtkNew.h" // for the images
#include "vtkObject.h"
#include "vtkShadowsPassesModule.h" // for export macro

#include <memory> // for std::unique_ptr

class vtkImageData;
class vtkLight;
class vtkRenderer;

class VTKSHADOWSPASSES_EXPORT vtkShadowErrorMeasure : public vtkObject
{
public:
  static vtkShadowErrorMeasure* New();
  vtkTypeMacro(vtkShadowErrorMeasure, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Measure `light` in the current view of `renderer`, whose pass must be a vtkShadowPass and whose
   * window must have rendered. The light's own technique is measured. false, with an error, if it
   * cannot be.
   */
  bool Measure(vtkRenderer* renderer, vtkLight* light);

  /**
   * Hold another visibility of the same light and view, floats of the same size, 0 to 1, against
   * the truth of the last Measure, which need not be made again: by another technique, or read off
   * a picture that none of these drew. `component`: the one that is the light's, as in an image of
   * vtkShadowPass::GetVisibilities. What is not a number is left out, and counted as uncertain.
   * false, with an error, if there is no truth or the image is of another kind; then nothing
   * changed.
   */
  bool MeasureAgain(vtkImageData* visibility, int component = 0);

  ///@{
  /**
   * Pixels of the last measure. ReceiverPixels are those measured; ShadowPixels those of them in
   * true shadow.
   */
  vtkGetMacro(ReceiverPixels, vtkIdType);
  vtkGetMacro(ShadowPixels, vtkIdType);
  vtkGetMacro(UncertainPixels, vtkIdType);
  vtkGetMacro(MismatchPixels, vtkIdType);
  vtkGetMacro(GrossFalsePixels, vtkIdType);
  vtkGetMacro(GrossMissedPixels, vtkIdType);
  vtkIdType GetGrossPixels() const { return this->GrossFalsePixels + this->GrossMissedPixels; }
  ///@}

  ///@{
  /**
   * Shares of ReceiverPixels in percent, and the mean of |visibility - truth| (0 to 1) over them.
   */
  vtkGetMacro(MismatchPercent, double);
  vtkGetMacro(GrossPercent, double);
  vtkGetMacro(MeanAbsoluteDifference, double);
  ///@}

  /**
   * Mean absolute difference of visibility over the penumbra alone, 0 to 1: the receiver pixels
   * where the technique or the truth is neither lit nor in shadow. 0 if there are none.
   */
  vtkGetMacro(MeanPenumbraDifference, double);

  ///@{
  /**
   * What "auto" keeps to without a budget. Gross pixels: a share of ReceiverPixels in percent, and
   * never less than a number of them. Of a hard light MismatchPercent; of one with a radius the
   * mean differences over all pixels and over the penumbra, in percent.
   */
  static double GetMostGrossPercent();
  static int GetMostGrossPixels();
  static double GetMostMismatchPercent();
  static double GetMostSoftDifferencePercent();
  static double GetMostPenumbraDifferencePercent();
  ///@}

  ///@{
  /**
   * Images of the last measure, of the renderer's size, origin bottom-left. Visibility and truth:
   * one float, 0 to 1, background 1. Error map: RGB bytes: background white, lit light grey, shadow
   * dark grey, not measured mid grey; false shadow orange, gross red; missed shadow sky blue, gross
   * blue.
   */
  vtkImageData* GetVisibility();
  vtkImageData* GetTruth();
  vtkImageData* GetErrorMap();
  ///@}

protected:
  vtkShadowErrorMeasure();
  ~vtkShadowErrorMeasure() override;

private:
  vtkShadowErrorMeasure(const vtkShadowErrorMeasure&) = delete;
  void operator=(const vtkShadowErrorMeasure&) = delete;

  void Evaluate();

  vtkIdType ReceiverPixels = 0;
  vtkIdType ShadowPixels = 0;
  vtkIdType UncertainPixels = 0;
  vtkIdType MismatchPixels = 0;
  vtkIdType GrossFalsePixels = 0;
  vtkIdType GrossMissedPixels = 0;
  double MismatchPercent = 0.0;
  double GrossPercent = 0.0;
  double MeanAbsoluteDifference = 0.0;
  double MeanPenumbraDifference = 0.0;
  vtkNew<vtkImageData> Visibility;
  vtkNew<vtkImageData> Truth;
  vtkNew<vtkImageData> ErrorMap;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
