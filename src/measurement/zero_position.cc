#include "measurement/zero_position.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "measurement/series.h"

namespace phs::measurement {
namespace {

bool IsPosition(const BeginningChannel& channel) { return channel.name.ends_with("_m"); }

/// How far pressures and forces begin from what the model says, over their swings; infinite where
/// the model cannot be driven so.
double OffAtBegin(const std::vector<BeginningChannel>& outputs,
                  const Result<std::vector<std::vector<double>>>& predicted) {
  if (!predicted.ok()) return INFINITY;
  double square = 0;
  for (size_t c = 0; c < outputs.size(); ++c) {
    if (IsPosition(outputs[c]) || predicted.value()[c].empty()) continue;
    const double off = (outputs[c].at - predicted.value()[c].front()) / outputs[c].swing;
    if (std::isfinite(off)) square += off * off;
  }
  return std::sqrt(square);
}

}  // namespace

bool ZeroPositions::any() const {
  const auto set = [](double zero) { return zero != 0; };
  return std::any_of(inputs.begin(), inputs.end(), set) ||
         std::any_of(outputs.begin(), outputs.end(), set);
}

BeginningChannel BeginningOf(const std::string& name, const std::vector<double>& values) {
  std::vector<double> present;
  std::copy_if(values.begin(), values.end(), std::back_inserter(present),
               [](double y) { return std::isfinite(y); });
  if (present.empty()) return {name, 0, 0};
  return {name, present.front(), StandardDeviation(present)};
}

ZeroPositions FindZeroPositions(const std::vector<BeginningChannel>& inputs,
                                const std::vector<double>& least_m,
                                const std::vector<BeginningChannel>& outputs,
                                const PredictFrom& predict) {
  constexpr double kCloser = 3;       // times as close, to be beyond doubt
  constexpr double kSeen = 0.05;      // of the swings: more than noise
  constexpr double kSensor_m = 1e-3;  // more than an error of a sensor, or a play
  ZeroPositions out{std::vector<double>(inputs.size(), 0), std::vector<double>(outputs.size(), 0)};
  std::vector<double> begins;
  bool elsewhere = false;
  for (size_t a = 0; a < inputs.size(); ++a) {
    const bool far = IsPosition(inputs[a]) && std::abs(inputs[a].at) > least_m[a];
    begins.push_back(far ? inputs[a].at : 0), elsewhere = elsewhere || far;
  }
  const bool told = std::any_of(outputs.begin(), outputs.end(), [](const BeginningChannel& c) {
    return !IsPosition(c) && c.swing > 0;
  });
  if (elsewhere && told) {
    const double as_read = OffAtBegin(outputs, predict(out.inputs));
    const bool seen = as_read > kSeen;
    if (seen && as_read > kCloser * OffAtBegin(outputs, predict(begins))) out.inputs = begins;
  }
  const bool far = std::any_of(outputs.begin(), outputs.end(), [](const BeginningChannel& c) {
    return IsPosition(c) && std::abs(c.at) > kSensor_m;
  });
  if (!far && !out.any()) return out;
  const auto predicted = predict(out.inputs);
  for (size_t c = 0; predicted.ok() && c < outputs.size(); ++c) {
    const bool there = outputs[c].swing > 0 && !predicted.value()[c].empty();
    if (!IsPosition(outputs[c]) || !there) continue;
    const double off = outputs[c].at - predicted.value()[c].front();
    double& zero = out.outputs[c];
    for (const double driven : out.inputs) {  // the zero of its actuator is its own, too
      if (std::abs(off - driven) < std::abs(off - zero)) zero = driven;
    }
    // In another unit than its name says its noise may be more than a millimetre.
    if (std::abs(off - zero) > std::max(kSensor_m, kSeen * outputs[c].swing)) zero = off;
  }
  return out;
}

void NameZeros(const std::vector<BeginningChannel>& channels, const std::vector<double>& zeros,
               std::vector<DataFinding>* findings) {
  for (size_t c = 0; c < channels.size(); ++c) {
    if (zeros[c] == 0) continue;
    findings->push_back(
        {channels[c].name,
         fmt::format("begins at {:.4g} m, in the static state: counted from there", zeros[c])});
  }
}

}  // namespace phs::measurement
