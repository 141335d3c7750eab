// What the instruments of a cylinder show of the truth on a rig.
//
// Several laws at one sensor: shown = scales(true') + sum of errors, where true' is the true series
// after all lags. Lags and scales do not change the sign and most are linear to either side of zero,
// so the order of the laws does not count (but where a lag crosses zero, and beside a scale that
// begins at a value or a loop).
#pragma once

#include <memory>
#include <vector>

#include "hydraulics/force_place.h"

namespace phs::hydraulics {

enum class Sensor { kPiston, kLoad, kBorePressure, kRodPressure };
inline constexpr int kSensors = 4;

class ReadingLaw {
 public:
  virtual ~ReadingLaw() = default;
  /// What comes late or smoothed: changes true values at samples `step` [s] apart, in place.
  virtual void Lag(double /*step*/, std::vector<double>* /*values*/) const {}
  virtual double Scaled(double value) const noexcept { return value; }
  /// Added to what is shown, in the unit of the channel; of `place`, the true one, time, piston, its
  /// speed, pressures and what the load cell carries are set.
  virtual double Error(const ForcePlace& /*place*/) const noexcept { return 0; }
  /// The same of a law with a memory, one number, 0 at the first sample; `before`: of the sample
  /// `step_s` [s] earlier, but for further channels, which are those of `place`.
  virtual double ErrorAfter(const ForcePlace& /*before*/, const ForcePlace& place,
                            double /*step_s*/, double* /*memory*/) const noexcept {
    return Error(place);
  }
};
using ReadingLaws = std::vector<std::unique_ptr<const ReadingLaw>>;

}  // namespace phs::hydraulics
