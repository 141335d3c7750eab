// Pipes between a chamber and its line: pressure drop and inertia of the oil in them.
//   drop(q) = R q + K q |q|,   inertance I dq/dt = dp - drop(q)
//   R = 128 mu l/(pi d⁴) (Hagen-Poiseuille), I = rho l/A,
//   K = lambda rho l/(2 d A²) with lambda = 0.0316 at Re = 1e4 (Blasius 0.3164 Re^-1/4), d bore, l
//   length, A = pi d²/4. Units: R [Pa s/m3], K [Pa s2/m6], I [kg/m4].
// R follows the viscosity of the instant (FlowPlace), K and I do not.
//
// Laminar flow that changes rubs more at the wall than its mean tells (Zielke, J. Basic Eng. 90
// (1968) 109): dp += R/2 int W(tau - tau') dq, tau = nu t/r², nu/r² = R/(8 I), r the radius. With W
// as a sum of m_k exp(-n_k tau) (Trikha, J. Fluids Eng. 97 (1975) 97; numbers of Kagawa et al.,
// Trans. JSME B 49 (1983) 2638) each term is a lag of the flow,
//   dq_k/dt = n_k R/(8 I) (q - q_k),   dp += m_k R/2 (q - q_k),
// a resistance with an inertia beside it: passive, with the energy (4 m_k/n_k) I q_k²/2. Slowly the
// oil seems a third heavier, sum of 4 m_k/n_k, as a parabola of speeds carries 4/3 of the momentum.
#pragma once

#include <algorithm>
#include <memory>

#include "hydraulics/oil_laws.h"

namespace phs::hydraulics {

double CalcLaminarResistance(double viscosity_Pas, double length_m, double bore_m);
double CalcTurbulentResistance(double density_kg_m3, double length_m, double bore_m);
double CalcInertance(double density_kg_m3, double length_m, double bore_m);

/// Resistance that may differ by flow direction, with inertance.
class PipeFlow final : public FlowLaw {
 public:
  struct Resistance {
    double laminar = 0;    ///< R > 0 [Pa s/m3]
    double turbulent = 0;  ///< K >= 0 [Pa s2/m6]
  };
  /// `unsteady`: friction of the changing flow over Zielke's; it needs an inertance.
  PipeFlow(Resistance forward, Resistance backward, double inertance, double unsteady = 0);
  double Flow(const FlowPlace& at, double dp, double* slope) const noexcept override;
  double Drop(const FlowPlace& at, double flow, double* slope) const noexcept override;
  double Inertance() const noexcept override { return inertance_; }
  int num_lags() const noexcept override;
  FlowLag Lag(const FlowPlace& at, int lag) const noexcept override;
  bool SolvedByDrop() const noexcept override { return true; }

 private:
  Resistance forward_, backward_;
  double oil_inertance_, inertance_, unsteady_;  ///< second: with the fastest of the friction
};

/// Leak through a narrow opening: q = G d (|d|/5 MPa)^(n-1), n = 1 a laminar gap, 1/2 an orifice
/// (Bernoulli), above 1 a gap that the pressure widens; d = dp, or of what opens at a pressure p_o
/// (a lip that lifts, a crack that gapes) d = dp - p_o, nothing below. Smooth below 2 kPa. Opens
/// from `start` on, over kOpening.
class GapFlow final : public FlowLaw {
 public:
  /// [s], assumed: a crack runs through a hose or a seal within milliseconds. A leak that opened at
  /// once would empty a torn line in less than a step: an error of the order of the step in the
  /// impulse on the axles.
  static constexpr double kOpening = 5e-3;
  static constexpr double kReference = 5e6;  ///< [Pa]
  /// How far a gap of exponent n follows the viscosity, G ~ mu^-share: a viscous flow (n >= 1)
  /// wholly, an orifice (1/2) not at all.
  static double ViscousShare(double exponent) { return std::clamp(2 * exponent - 1, 0.0, 1.0); }
  /// `conductance` G > 0 [m3/(Pa s)] at the reference, exponent n > 0; `return_ratio` > 0: G at
  /// dp < 0 over that at dp > 0; `opening_Pa` p_o >= 0: 0, and it is open at any.
  GapFlow(double conductance, double exponent, double start_s = -1e300, double return_ratio = 1,
          double opening_Pa = 0)
      : conductance_(conductance),
        exponent_(exponent),
        start_(start_s),
        return_ratio_(return_ratio),
        opening_Pa_(opening_Pa) {}
  double Flow(const FlowPlace& at, double dp, double* slope) const noexcept override;
  double Drop(const FlowPlace& at, double flow, double* slope) const noexcept override;

 private:
  double Conductance(const FlowPlace& at, double dp) const;
  double Opening(double time) const;                                       ///< 0 … 1
  double FlowBeyond(const FlowPlace& at, double dp, double* slope) const;  ///< of d [Pa]
  double conductance_, exponent_, start_, return_ratio_, opening_Pa_;
};

/// A valve or flap that a spring holds shut: once lifted it takes a steady pressure P, whatever the
/// flow, dp = P q/sqrt(q² + q0²), by direction. Only behind another law, as its flow has no limit.
class PoppetFlow final : public FlowLaw {
 public:
  /// P >= 0 [Pa] for flow from and to the high side; q0 > 0 [m3/s].
  PoppetFlow(double forward, double backward, double lifted)
      : forward_(forward), backward_(backward), lifted_(lifted) {}
  double Flow(const FlowPlace& at, double dp, double* slope) const noexcept override;
  double Drop(const FlowPlace& at, double flow, double* slope) const noexcept override;
  bool SolvedByDrop() const noexcept override { return true; }

 private:
  double forward_, backward_, lifted_;
};

/// Two laws one behind the other: drops and inertances add.
std::unique_ptr<FlowLaw> InSeries(std::unique_ptr<FlowLaw> first, std::unique_ptr<FlowLaw> second);

}  // namespace phs::hydraulics
