// What a run means by the standards: every wheelset on every section of its track after EN 14363
// and UIC 518 (en14363.h), ride of the car body, wear regime and rolling contact fatigue of every
// wheel.
//
// A wheelset is assessed on the rows at which it stands on the section itself. Quasi-static values
// belong to full arcs, instability to straight track: its frequency f0 is that of the zero
// crossings of the leading sum of Y in the band 1 … 12 Hz, and is left out where that is not above
// 2 Hz.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "analysis/en14363.h"
#include "vehicle/simulation.h"

namespace phs::analysis {

struct AssessedWheelset {
  std::string name;
  std::vector<AssessedQuantity> quantities;
  double hunting_Hz = 0;  ///< 0: not assessed for instability
};

struct AssessedSection {
  std::string kind;
  double begin_s_m = 0;
  double end_s_m = 0;
  double radius_m = 0;  ///< size; of a full arc only, else 0
  std::vector<AssessedWheelset> wheelsets = {};
  std::optional<AccelerationStatistics> ride_lateral = {};  ///< of the car body
  std::optional<AccelerationStatistics> ride_vertical = {};
};

/// The row of a quantity that comes nearest to its limit or farthest beyond.
struct WorstQuantity {
  AssessedQuantity quantity;
  std::string wheelset;
  double section_begin_s_m = 0;

  double Share() const { return quantity.value / quantity.limit; }
};

/// Wear and fatigue of one wheel.
struct AssessedWheel {
  std::string name;
  double worn_area_mm2_per_km = std::nan("");  ///< over the run
  double steady_T_gamma_N = std::nan("");      ///< not a number where the run never got there
};

struct Assessment {
  std::string reason;  ///< why nothing was assessed: recorded too seldom for 20 Hz, …
  bool limits_are_orientation = false;
  double gauge_m = 0;
  double static_wheel_load_N = 0;
  double nadal_Y_over_Q = std::nan("");  ///< not a number without a flange
  std::vector<WorstQuantity> worst;
  std::vector<AssessedSection> sections;
  std::vector<AssessedWheel> wheels;

  bool assessed() const { return reason.empty(); }
};

Assessment AssessRun(const vehicle::Simulation& simulation, const vehicle::RunOutcome& run);

}  // namespace phs::analysis
