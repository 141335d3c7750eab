// Limits of the hydraulics that a run touches, each with time and place.
//
//   end_stop        a piston beyond its free stroke (EndStopParams::clearance_m)
//   cylinder_force  beyond 60 kN, the largest working load of a cylinder (thesis, chapter 4)
//   low_pressure    a line below 0.1 MPa absolute: the oil gives off its air, seals draw air
//   blow_off_open   a line above the precharge of its accumulator: it takes up oil
//
// Every step is looked at, not only those that are recorded.
#pragma once

#include <mujoco/mujoco.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "plugin/binding.h"

namespace phs::vehicle {

inline constexpr double kRatedCylinderForce = 60e3;   ///< [N]
inline constexpr double kLowestLinePressure = 0.1e6;  ///< absolute [Pa]

/// One limit of one cylinder or line.
struct PhsWarning {
  enum class Kind { kEndStop, kCylinderForce, kLowPressure, kBlowOffOpen };
  Kind kind = Kind::kEndStop;
  std::string part = {};    ///< "1", "L2", "front_L2"
  double limit = 0;         ///< [m, N, Pa]
  double first_time_s = 0;  ///< when it was first passed
  double first_s_m = 0;     ///< where: arc length of the leading wheelset
  double worst = 0;         ///< piston [m], force [N] or pressure [Pa] farthest beyond the limit
  double worst_time_s = 0;
  double worst_s_m = 0;
  double duration_s = 0;  ///< beyond the limit, in all

  bool IsOfLine() const { return kind == Kind::kLowPressure || kind == Kind::kBlowOffOpen; }
  /// How far `value` is beyond the limit; <= 0 within.
  double Excess(double value) const;
};

/// Watches all cylinders and lines of a vehicle.
class PhsWatch {
 public:
  explicit PhsWatch(const plugin::Binding& binding);
  /// After each mj_step that began at `time` and took `h`.
  void Check(const mjData* d, double time, double h);
  /// Limits that were passed, in the order of their first time.
  std::vector<PhsWarning> Warnings() const;

 private:
  void Watch(size_t at, double value, const mjData* d, double time, double h);

  const plugin::Binding& binding_;
  /// Per PHS: two for each cylinder, two for each line.
  std::vector<PhsWarning> watched_;
};

/// `warnings` of summary.json: name, kind, cylinder or line, times and places, and a sentence.
nlohmann::ordered_json WarningsJson(const std::vector<PhsWarning>& warnings);

}  // namespace phs::vehicle
