#include "hydraulics/bwr_nitrogen.h"

#include <algorithm>
#include <cmath>

namespace phs::hydraulics {
namespace {

// Coefficients of the ideal heat capacity.
constexpr double kN1 = -735.21, kN2 = 34.224, kN3 = -0.557648, kN4 = 3.504, kN5 = -1.7339e-5;
constexpr double kN6 = 1.7465e-8, kN7 = -3.5689e-12, kN8 = 1.0054, kN9 = 3353.4061;

// Integral of rho (1 + gamma rho²) exp(-gamma rho²) from 0 to rho.
double ExponentialIntegral(double rho, double decay, const BwrConstants& k) {
  return 1.0 / k.gamma - (1.0 / k.gamma + 0.5 * rho * rho) * decay;
}

}  // namespace

BwrPressure CalcBwrPressure(double rho, double T, const BwrConstants& k) {
  const double RT = k.R * T, inv_T2 = 1.0 / (T * T);
  const double rho2 = rho * rho, rho3 = rho2 * rho;
  const double g = k.gamma * rho2;
  const double decay = std::exp(-g);
  const double second = k.B0 * RT - k.A0 - k.C0 * inv_T2;
  const double third = k.b * RT - k.a;
  const double tail = k.c * inv_T2 * decay;
  BwrPressure out;
  out.decay = decay;
  out.p =
      RT * rho + second * rho2 + third * rho3 + k.a * k.alpha * rho3 * rho3 + tail * rho3 * (1 + g);
  out.dp_drho = RT + 2 * second * rho + 3 * third * rho2 + 6 * k.a * k.alpha * rho3 * rho2 +
                tail * rho2 * (3 + 3 * g - 2 * g * g);
  out.dp_dT = k.R * rho + (k.B0 * k.R + 2 * k.C0 * inv_T2 / T) * rho2 + k.b * k.R * rho3 -
              2 * tail / T * rho3 * (1 + g);
  return out;
}

double CalcBwrDensity(double p, double T, const BwrConstants& k) {
  // Above the critical temperature p rises with rho; 2000 kg/m3 is far above any use.
  double low = 0, high = 2000;
  double rho = std::min(p / (k.R * T), 600.0);
  for (int i = 0; i < 60; ++i) {
    const BwrPressure at = CalcBwrPressure(rho, T, k);
    const double error = at.p - p;
    if (error == 0) break;
    (error > 0 ? high : low) = rho;
    double next = at.dp_drho > 0 ? rho - error / at.dp_drho : -1;
    // The ends belong to it: at the root a step of one rounding must not begin a bisection.
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double move = std::abs(next - rho);
    rho = next;
    if (move <= 1e-9 * rho) break;  // quadratic: the error left is at rounding
  }
  return rho;
}

double CalcNitrogenCv0(double T) {
  const double y = kN9 / T, e = std::exp(-y);
  const double vibration = kN8 * y * y * e / ((1 - e) * (1 - e));
  return BwrConstants{}.R * (((kN1 / T + kN2) / T + kN3) / T + (kN4 - 1) +
                             ((kN7 * T + kN6) * T + kN5) * T + vibration);
}

double CalcBwrResidualCv(double rho, double T, double decay, const BwrConstants& k) {
  return (6 * (k.C0 * rho - k.c / k.gamma) + 3 * k.c * (2 / k.gamma + rho * rho) * decay) /
         (T * T * T);
}

double CalcBwrCv(double rho, double T, const BwrConstants& k) {
  return CalcNitrogenCv0(T) + CalcBwrResidualCv(rho, T, std::exp(-k.gamma * rho * rho), k);
}

double CalcBwrEnergy(double rho, double T, const BwrConstants& k) {
  const double e = std::exp(-kN9 / T);
  const double ideal =
      k.R * (-kN1 / (2 * T * T) - kN2 / T + kN3 * std::log(T) + (kN4 - 1) * T + kN5 * T * T / 2 +
             kN6 * T * T * T / 3 + kN7 * T * T * T * T / 4 + kN8 * kN9 * e / (1 - e));
  const double decay = std::exp(-k.gamma * rho * rho);
  return ideal - (k.A0 + 3 * k.C0 / (T * T)) * rho - k.a * rho * rho / 2 +
         k.a * k.alpha * std::pow(rho, 5) / 5 +
         3 * k.c / (T * T) * ExponentialIntegral(rho, decay, k);
}

double CalcBwrEntropy(double rho, double T, const BwrConstants& k) {
  const double y = kN9 / T, e = std::exp(-y);
  const double ideal = k.R * (-kN1 / (3 * T * T * T) - kN2 / (2 * T * T) - kN3 / T +
                              (kN4 - 1) * std::log(T) + kN5 * T + kN6 * T * T / 2 +
                              kN7 * T * T * T / 3 + kN8 * (y * e / (1 - e) - std::log1p(-e)));
  const double T3 = T * T * T, decay = std::exp(-k.gamma * rho * rho);
  return ideal - k.R * std::log(rho) - (k.B0 * k.R + 2 * k.C0 / T3) * rho -
         k.b * k.R * rho * rho / 2 + 2 * k.c / T3 * ExponentialIntegral(rho, decay, k);
}

}  // namespace phs::hydraulics
