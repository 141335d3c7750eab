#include "hydraulics/oil_compression.h"

#include <cmath>

namespace phs::hydraulics {

double OilStiffness::At(double rise) const {
  if (rise_Pa == 0) return modulus + slope * rise;
  return modulus - rise_Pa * std::expm1(-rise / over_Pa);
}

double OilStiffness::Volume(double rise, double* compliance) const {
  if (IsConstant()) {
    *compliance = 1 / modulus;
    return *compliance * rise;
  }
  const double beta = At(rise), log_ratio = std::log(beta / modulus);
  *compliance = 1 / beta;
  if (rise_Pa == 0) return log_ratio / slope;
  return (rise + over_Pa * log_ratio) / (modulus + rise_Pa);
}

double OilStiffness::Energy(double p0, double rise) const {
  if (IsConstant()) return 0.5 / modulus * rise * (rise + 2 * p0);
  if (rise_Pa == 0) {
    const double log_ratio = std::log(At(rise) / modulus);
    return rise / slope + (slope * p0 - modulus) / (slope * slope) * log_ratio;
  }
  constexpr int kPanels = 64;  // Simpson: beta is smooth over P
  const double step = rise / kPanels;
  double sum = 0;
  for (int i = 0; i <= 2 * kPanels; ++i) {
    const double u = 0.5 * i * step;
    sum += (i == 0 || i == 2 * kPanels ? 1 : (i % 2 == 1 ? 4 : 2)) * (p0 + u) / At(u);
  }
  return sum * step / 6;
}

}  // namespace phs::hydraulics
