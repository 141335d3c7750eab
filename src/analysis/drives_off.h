// Drives without gain for as long as this lives: the speed is prescribed by other means.
#pragma once

#include <utility>
#include <vector>

#include "plugin/binding.h"

namespace phs::analysis {

class DrivesOff {
 public:
  DrivesOff(mjModel* m, const plugin::Binding& binding) {
    for (const plugin::WheelsetBinding& w : binding.wheelsets()) {
      if (w.drive_actuator < 0) continue;
      mjtNum* gain = m->actuator_gainprm + mjNGAIN * w.drive_actuator;
      gains_.emplace_back(gain, *gain);
      *gain = 0;
    }
  }
  ~DrivesOff() {
    for (const auto& [gain, value] : gains_) *gain = value;
  }
  DrivesOff(const DrivesOff&) = delete;
  DrivesOff& operator=(const DrivesOff&) = delete;

 private:
  std::vector<std::pair<mjtNum*, mjtNum>> gains_;
};

}  // namespace phs::analysis
