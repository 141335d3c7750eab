// Heat of the gas after a step: pressures just after it and time constants of one setup, predicted
// from what the settled pressures say. The pressures just after the step are fitted nowhere.
//
// Two descriptions: every gas at the temperature of its surroundings, or the energy equation of a
// perfect gas (gas_law.h) with one thermal time for all gas of the setup. The thermal time is the
// one at which the mean logarithm of the table's time constants is met: the table's tau is the time
// to P_begin - 0.37 dP (every row's printed mark), and the model's is taken at the same mark.
#pragma once

#include <vector>

#include "rigs/step_table.h"

namespace phs::rigs {

/// The model with the energy equation in reservoirs and accumulators.
hydraulics::PhsParams WithThermalGas(const hydraulics::PhsParams& params, double thermal_time_s);

/// Thermal time [s] from the time constants of `rows` (those with one). Error: no row has one.
Result<double> FitThermalTime(const hydraulics::PhsParams& settled,
                              const std::vector<StepRow>& rows);

}  // namespace phs::rigs
