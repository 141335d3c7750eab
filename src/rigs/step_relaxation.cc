#include "rigs/step_relaxation.h"

#include <algorithm>
#include <cmath>

namespace phs::rigs {

hydraulics::PhsParams WithThermalGas(const hydraulics::PhsParams& params, double thermal_time_s) {
  hydraulics::PhsParams out = params;
  for (hydraulics::LineParams& l : out.lines) {
    for (hydraulics::GasChargeParams* gas : {&l.reservoir, &l.accumulator}) {
      gas->law = hydraulics::FindGasLaw("ideal");
      gas->thermal_time_s = thermal_time_s;
    }
  }
  return out;
}

// The model's time constants are all but proportional to its thermal time: each round multiplies it
// by the mean ratio.
Result<double> FitThermalTime(const hydraulics::PhsParams& settled,
                              const std::vector<StepRow>& rows) {
  std::vector<StepRow> timed;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(timed),
               [](const StepRow& row) { return row.valid && row.tau_s > 0; });
  if (timed.empty()) {
    return Error{settled.name, "no row has a time constant", "at least one valid row with tau_s"};
  }
  double time = 2;
  for (int round = 0; round < 12; ++round) {
    Result<std::vector<StepRelaxation>> model =
        PredictRelaxations(WithThermalGas(settled, time), timed);
    if (!model.ok()) return model.error();
    double sum = 0;
    int n = 0;
    for (size_t i = 0; i < timed.size(); ++i) {
      if (!(model.value()[i].tau_37_s > 0)) continue;
      sum += std::log(timed[i].tau_s / model.value()[i].tau_37_s), ++n;
    }
    if (n == 0) return Error{settled.name, "the model's pressures do not relax", "gas in a line"};
    time *= std::exp(std::clamp(sum / n, -1.0, 1.0));
    if (std::abs(sum / n) < 1e-6) break;
  }
  return time;
}

}  // namespace phs::rigs
