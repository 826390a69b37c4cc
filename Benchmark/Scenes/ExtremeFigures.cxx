#include "ExtremeFigures.h"

namespace vtkshadows
{
namespace
{

nlohmann::ordered_json NumberOrNull(double value, bool isThere)
{
  return isThere ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

}

nlohmann::ordered_json ExtremeFigures(const ExtremeCase& extreme, const std::string& technique,
  double unlike, const ExtremeOutcome& outcome, const std::vector<std::string>& messages)
{
  nlohmann::ordered_json object;
  object["case"] = extreme.Name();
  object["kind"] = extreme.kind;
  object["value"] = extreme.value;
  object["looks_plain"] = extreme.looksPlain;
  object["heavy"] = extreme.isHeavy;
  object["beyond"] = extreme.isBeyond;
  object["technique"] = technique;
  object["drawn"] = outcome.made;
  object["frame_unlike_percent"] = NumberOrNull(unlike, unlike >= 0.0);
  object["truth_alike_percent"] =
    NumberOrNull(outcome.truthAgreement, outcome.truthAgreement >= 0.0);
  object["alike_percent"] = NumberOrNull(outcome.agreement, outcome.agreement >= 0.0);
  object["receivers"] = outcome.receivers;
  object["shadowed"] = outcome.shadowed;
  object["uncertain"] = outcome.uncertain;
  object["mismatch"] = outcome.mismatch;
  object["gross"] = outcome.gross;
  object["mismatch_percent"] = NumberOrNull(outcome.MismatchPercent(), outcome.receivers > 0);
  object["opengl_error"] = outcome.openGLError;
  object["messages"] = messages;
  return object;
}

}
