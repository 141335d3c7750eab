// On what a residual depends: share of its variance explained by the mean over bins of one
// variable (correlation ratio eta²), with the share that chance would give taken off.
#pragma once

#include <string>
#include <vector>

#include "measurement/fit_data.h"

namespace phs::identify::search {

struct Dependence {
  std::string variable;  ///< "actuator_m", "speed_m_s", "reversal", "t_s", a measured channel
  double share = 0;      ///< eta² beyond chance, 0 … 1
};

/// Dependences of `residual` (one value a sample of the record, NaN = none) over `window`, largest
/// first. Chance: (bins - 1)/n_eff with n_eff independent samples.
std::vector<Dependence> MapResidual(const measurement::FitData& data,
                                    const std::vector<double>& residual,
                                    const std::array<double, 2>& window);

/// Probability of as much correlation over the first 20 lags if the residual were white
/// (Ljung and Box 1978, Biometrika 65, 297; chi² by Wilson and Hilferty 1931).
double WhitenessP(const std::vector<double>& residual);

}  // namespace phs::identify::search
