// What can fail in a PHS on the road, as changes to its model. One row per kind:
//
//   line_burst            a hose or pipe of the line tears at `at_s`: the line empties in a moment
//                         (external_leakage with 1e-8 m3/(Pa s)); afterwards it stays open
//   line_leak             the same through a small hole: `conductance_m3_per_Pas`, default 1e-12
//                         (precharge gone within tens of seconds)
//   reservoir_gas_lost    the reservoir's nitrogen has escaped before the run: oil alone carries.
//                         With the gas the precharge of the line is gone: it is at atmospheric
//                         pressure at rest
//   accumulator_gas_lost  the same of the blow-off accumulator: its gas is at atmospheric pressure
//                         before the line presses on it, so it is a soft spring instead of a limit
//   air                   `air_m3` of air (at atmospheric pressure) in the line since its filling
//
// A burst or leak is a flow with a volume state of its own, so that it lives in mjData with all
// others; the kinds without a time are changes of parameters, present from the start.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/yaml.h"
#include "hydraulics/phs_params.h"
#include "hydraulics/phs_system.h"

namespace phs::phs_model {

struct Failure {
  std::string kind = {};
  std::string line = {};    ///< "L1"
  std::string system = {};  ///< the PHS it happens in ("front_bogie"); empty = every one
  double at_s = 0;          ///< time of a burst or leak [s]
  double conductance_m3_per_Pas = 1e-12;  ///< of a leak, 0 < G <= 1e-3
  double air_m3 = 20e-6;                  ///< at 101325 Pa, 0 … 1e-3
  /// The place that gave `at_s` [m], NaN if none did: it must lie on the track.
  double at_m = std::numeric_limits<double>::quiet_NaN();
};

/// Names of the kinds, in the order above.
const std::vector<std::string>& FailureKinds();
/// True for kinds that happen at a time.
bool HasTime(const Failure& failure);

/// Reads the list `failures:` of a scenario; `speed_m_s` and `start_s_m` turn `at_m` (arc length of
/// the rearmost wheelset) into a time.
std::vector<Failure> ReadFailures(YamlMap* map, double speed_m_s, double start_s_m);

/// Changes the model. Errors name the line or kind and what is allowed.
Status ApplyFailures(const std::vector<Failure>& failures, const std::string& system,
                     hydraulics::PhsParams* params);

}  // namespace phs::phs_model
