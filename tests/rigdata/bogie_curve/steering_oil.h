// The hydraulic steering: four cylinders, four lines.
//
//   cylinder        1 lead left   2 lead right   3 trail right   4 trail left
//   bore chamber    L2            L3             L2              L3
//   rod chamber     L1            L1             L4              L4
//
// x extension, F tension: F = p_rod A_rod - p_bore A_bore + seal. A line takes up volume in its oil,
// V/beta, and in its gas, p V_g = p0 V_g0 (and, above the precharge, in its blow-off accumulator,
// p V_a = p_a V_a0); from the balance of flow
//   dp/dt = (q - leak (p - p_atm))/C,   C = V/beta + V_g0 p0/p^2 (+ V_a p_a/p^2 above p_a)
// with q what the pistons press out: A_bore dx/dt inverse, A_rod dx/dt with its sign.
// Seal (P. Dupont, V. Hayward, B. Armstrong, F. Altpeter, IEEE Trans. Automatic Control 47 (2002)
// 787): bristle w, F = sigma0 w + sigma1 dw/dt, dw/dt = v (1 - alpha w/w_s), w_s = level(v)/sigma0,
// alpha from 0 at 0.7 w_s to 1 at w_s along half a sine.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace bogie_curve {

struct LineNumbers {
  double oil = 1.1e-3, bulk_modulus = 1.4e9;  // [m3], [Pa]
  double rest = 1.8e6, gas = 16.16e-6;        // p0 [Pa], V_g0 [m3]
  double accumulator = 0, precharge = 15e6;   // [m3], [Pa]
  double leak = 0;                            // [m3/(Pa s)] to the atmosphere
};

struct SealNumbers {
  std::vector<double> speed = {-0.05, -0.01, -0.001, -0.0002, 0, 0.0002, 0.001, 0.01, 0.05};
  std::vector<double> force = {-1900, -1700, -1600, -1500, 0, 1700, 1850, 1950, 2150};  // [N]
  std::array<double, 4> scale = {1, 1, 1, 1};  // of each cylinder
  double viscous = 0;                          // beside the table [N s/m]
  double stiffness = 3.6e7, damping = 2e3, elastic_share = 0.7;
};

struct SteeringNumbers {
  double bore = 0.100, rod = 0.032;  // diameters [m]
  std::array<LineNumbers, 4> line;   // L1 … L4
  SealNumbers seal;
  // As the shipped PHS model `bo_bo`, and as `bo_bo_measured`.
  static SteeringNumbers Declared();
  static SteeringNumbers Measured();
};

class SteeringOil {
 public:
  explicit SteeringOil(SteeringNumbers numbers);
  using Four = std::array<double, 4>;

  Four Rest() const;  // static pressures
  // Tension of each cylinder [N] at pressures, piston speeds and bristles.
  Four Tension(const Four& pressure, const Four& speed, const Four& bristle) const;
  // `leaking`: the lines lose what their leaks say.
  Four PressureRate(const Four& pressure, const Four& speed, bool leaking = true) const;
  Four BristleRate(const Four& speed, const Four& bristle) const;
  const SteeringNumbers& numbers() const { return numbers_; }

 private:
  double Level(size_t cylinder, double speed) const;  // > 0 [N]
  double OneBristleRate(size_t cylinder, double speed, double bristle) const;

  SteeringNumbers numbers_;
  double bore_area_, rod_area_;
};

}  // namespace bogie_curve
