// Linear stability over speed: eigenvalues, critical speed, mode at the stability limit.
//
// At each speed the vehicle runs settled on straight track, is linearised (linear_model.h) and
// solved. Where it stands does not depend on speed there: creepages are ratios of speeds, and
// without curvature, slip and sliding seals nothing else moves. Growth = largest real part.
// Eigenvalues of size below kNeutral are neutral and do not count: the place along the track, the
// spin angles, seals that stick (a bristle moves with its piston: one zero each) and the forward
// speed, which no driver holds here.
#pragma once

#include <complex>
#include <functional>
#include <vector>

#include "analysis/linear_model.h"
#include "base/result.h"
#include "vehicle/simulation.h"

namespace phs::analysis {

inline constexpr double kNeutral = 0.2;  ///< |lambda| below is neutral [rad/s]

struct StabilityOptions {
  double min_speed_m_s = 5;    ///< [1, max)
  double max_speed_m_s = 120;  ///< (min, 200]
  int speeds = 47;             ///< scanned, both ends included, 2 … 1000
};

struct SpeedSpectrum {
  double speed = 0;                               ///< [m/s]
  std::vector<std::complex<double>> eigenvalues;  ///< [1/s], without neutral ones
  double growth = 0;                              ///< largest real part [1/s]
};

struct Crossing {
  double speed = 0;         ///< growth = 0 there [m/s]
  bool to_unstable = true;  ///< with rising speed
};

struct VibrationMode {
  double speed = 0;
  std::complex<double> eigenvalue;
  Eigen::VectorXcd state;          ///< of the linear model; largest motion of a wheelset = 1 m
  std::vector<BodyMotion> motion;  ///< the same as motion of the bodies
};

struct StabilityResult {
  std::vector<SpeedSpectrum> spectra;
  std::vector<Crossing> crossings;
  double critical_speed = 0;  ///< lowest crossing to unstable; NaN if there is none [m/s]
  VibrationMode mode;         ///< least stable mode at the critical speed, or else at the highest
};

/// The settled start of the simulation with all speeds in proportion to `speed` [m/s] > 0.
/// Error if the model keeps no settled start (a key named "test").
Status StartAtSpeed(const vehicle::Simulation& simulation, double speed, mjData* d);

/// Eigenvalues at one speed. `simulation` is on straight, smooth track.
Result<SpeedSpectrum> SpectrumAt(vehicle::Simulation* simulation, double speed,
                                 VibrationMode* least_stable = nullptr);

/// Scan and bisection (to 1e-9 of the speed). Errors: options out of range, track not straight.
Result<StabilityResult> AnalyseStability(vehicle::Simulation* simulation,
                                         const StabilityOptions& options,
                                         const vehicle::Progress& progress = {});

}  // namespace phs::analysis
