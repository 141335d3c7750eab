// Periodic motions of a system that feeds its own vibration, by harmonic balance.
//
//   q'' = a(q, q', z; p),   z' = r(q, q', z; p),   q(t) = q_0 + sum_k=1..N c_k cos k w t + s_k sin k w t
// and z likewise. The equations are asked to hold in their first N harmonics (Galerkin); their
// non-linear parts are taken at M instants of a period and projected by the discrete Fourier sum
// (alternating frequency and time: T. M. Cameron, J. H. Griffin, J. Appl. Mech. 56 (1989) 149;
// M. Krack, J. Gross, Harmonic Balance for Nonlinear Vibration Problems, Springer 2019).
// N = 1 is the method of describing functions: of a Coulomb friction F the force 4F/pi against the
// speed, of everything else its own first harmonic.
//
// Watched is the amplitude A of one position (or a sum of positions) in its first harmonic. Given is
// A, or a line in the plane of A and the parameter p (a speed, say); w and p at which the motion keeps
// itself up are found by Newton's method. So a branch that folds back over p is followed like any
// other, the stable part and the unstable one, and along lines also one that folds back over A
// (continuation by pseudo-arclength: H. B. Keller 1977, in this plane alone). M >= 4N + 1: a cubic is
// then projected exactly.
#pragma once

#include <Eigen/Dense>
#include <functional>

#include "base/result.h"

namespace phs::analysis {

/// What vibrates. `x` = (q, q', z).
struct VibratingSystem {
  int positions = 0;      ///< of q
  int states = 0;         ///< of z
  Eigen::VectorXd steps;  ///< of central differences over x
  double parameter_step = 1e-4;
  Eigen::VectorXd watched;  ///< weights over q: whose amplitude is given
  /// (q'', z') at x and the parameter.
  std::function<Eigen::VectorXd(double parameter, const Eigen::VectorXd& x)> rates;
};

/// Columns: mean, cos 1, sin 1, cos 2, sin 2, …
struct PeriodicMotion {
  Eigen::MatrixXd coefficients;  ///< rows: q, then z
  double omega = 0;              ///< [rad/s]
  double parameter = 0;

  int harmonics() const { return static_cast<int>(coefficients.cols() - 1) / 2; }
  /// (q, q', z) at the phase w t [rad].
  Eigen::VectorXd At(double phase, int positions) const;
  /// Amplitude of harmonic k of a sum of rows.
  double Amplitude(const Eigen::VectorXd& weights, int k) const;
  /// With more harmonics (zero), or without the highest ones.
  PeriodicMotion WithHarmonics(int n) const;
};

struct BalanceOptions {
  int samples = 64;         ///< M of one period
  int iterations = 20;      ///< of Newton's method
  double tolerance = 1e-7;  ///< last step: of the amplitude, of omega, of the parameter
};

/// What is asked of the watched amplitude A (cosine of the first harmonic; its sine is zero) and the
/// parameter p: of_amplitude A + of_parameter p = value.
struct BalanceLine {
  double of_amplitude = 1;
  double of_parameter = 0;
  double value = 0;
};

/// The motion on a line, from one near by, whose number of harmonics is kept. Error where Newton's
/// method fails.
Result<PeriodicMotion> SolveBalance(const VibratingSystem& system, const PeriodicMotion& near,
                                    const BalanceLine& line, const BalanceOptions& options = {});
/// The motion of an amplitude.
Result<PeriodicMotion> SolveBalance(const VibratingSystem& system, const PeriodicMotion& near,
                                    double amplitude, const BalanceOptions& options = {});

}  // namespace phs::analysis
