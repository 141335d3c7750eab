// Air between bubbles and solution: what entrained_air and cavitation share.
//
// Free share at equilibrium by Henry's law, dissolved in proportion to pressure:
//   s_e(p) = 1 - (p - p_f)/(p_s - p_f), kept in 0 … 1
// all of it free at p_f, dissolved at the saturation pressure p_s. With a lag
//   ds/dt = (s_e(p) - s)/tau, tau of release where s rises, of dissolving where it falls
// (bubbles grow fast and dissolve slowly: J. Zhou, A. Vacca and B. Manhartsgruber, J. Fluids Eng.
// 135 (2013) 091305). Volume V = A p^(-1/n) s, A = V_a p_a^(1/n).
#pragma once

#include <string>

#include "hydraulics/extension.h"
#include "hydraulics/gas_law.h"

namespace phs::effects {

struct Solution {
  double saturation = 0;                      ///< p_s [Pa]; at or below p_f: air never dissolves
  double all_free = hydraulics::kAtmosphere;  ///< p_f [Pa]
  bool Dissolves() const { return saturation > all_free; }
  double FreeShare(double p, double* slope) const;
  double PressureOf(double free) const { return all_free + (1 - free) * (saturation - all_free); }
};

/// Volume of all the air, were it free, at p.
struct Bubble {
  double volume = 0;  ///< at atmospheric pressure [m3]
  double exponent = 1;
  double At(double p) const;
};

struct LagTimes {
  double release_s = 1, dissolving_s = 1;  ///< > 0
};

/// In solution with a lag; memory s - s_e(p0). `p0`: static pressure [Pa].
/// Stored: s A u(p) + phi(s) with u = int (1/n) p^(-1/n) dp from p0, phi' = -A h(p_e(s)), p_e the
/// pressure at which s is the equilibrium, h = p^(1-1/n) + u; lost A (h(p_e) - h(p)) ds/dt >= 0.
class LaggingAir final : public hydraulics::VolumeLaw {
 public:
  LaggingAir(Bubble bubble, Solution solution, LagTimes times, double p0);
  void Add(double pressure, double memory, double* volume, double* slope) const noexcept override;
  double Energy(double pressure, double memory) const noexcept override;
  std::string MemoryName() const override { return "free_air"; }
  hydraulics::MemoryRate Memory(double pressure, double memory) const noexcept override;
  double Loss(double pressure, double memory) const noexcept override;

 private:
  double Work(double p) const;
  double Potential(double p) const;
  Bubble bubble_;
  Solution solution_;
  LagTimes times_;
  double p0_, start_ = 1, amount_ = 0, static_volume_ = 0;
};

}  // namespace phs::effects
