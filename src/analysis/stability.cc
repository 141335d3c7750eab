#include "analysis/stability.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "plugin/settle.h"

namespace phs::analysis {
namespace {

constexpr int kBisections = 40;

Status CheckTrack(const rail::Track& track) {
  bool straight = !track.has_irregularity();
  for (const rail::TrackSection& section : track.sections()) {
    straight = straight && section.kind == "tangent";
  }
  if (straight) return {};
  return Error{"track '" + track.name() + "'", "is not straight and smooth",
               "for stability: tangents only, no irregularity", "use track 'straight'"};
}

Status CheckOptions(const StabilityOptions& o) {
  if (o.min_speed_m_s >= 1 && o.max_speed_m_s > o.min_speed_m_s && o.max_speed_m_s <= 200 &&
      o.speeds >= 2 && o.speeds <= 1000) {
    return {};
  }
  return Error{"speeds of the stability analysis", "are out of range",
               "1 m/s <= least < greatest <= 200 m/s, 2 … 1000 speeds", ""};
}

/// Scaled so that the largest motion of a wheelset in the plane is one, at phase zero.
VibrationMode Shape(const vehicle::Simulation& simulation, const mjData* running, double speed,
                    const std::complex<double>& eigenvalue, const Eigen::VectorXcd& vector) {
  VibrationMode mode{speed, eigenvalue, vector, BodyMotions(simulation.model(), running, vector)};
  std::complex<double> largest = 0;
  for (const plugin::WheelsetBinding& w : simulation.binding().wheelsets()) {
    const BodyMotion& motion = mode.motion[static_cast<size_t>(w.body) - 1];
    for (const int axis : {0, 1}) {
      if (std::abs(motion.translation[axis]) > std::abs(largest)) {
        largest = motion.translation[axis];
      }
    }
  }
  if (largest == 0.0) return mode;
  mode.state /= largest;
  for (BodyMotion& motion : mode.motion) {
    for (int i = 0; i < 3; ++i) {
      motion.translation[i] /= largest;
      motion.rotation[i] /= largest;
    }
  }
  return mode;
}

Result<double> GrowthAt(vehicle::Simulation* simulation, double speed) {
  auto spectrum = SpectrumAt(simulation, speed);
  if (!spectrum.ok()) return spectrum.error();
  return spectrum.value().growth;
}

/// Speed of zero growth between two speeds at which growth has opposite signs.
Result<double> FindCrossing(vehicle::Simulation* simulation, double low, double high,
                            bool high_unstable) {
  for (int i = 0; i < kBisections && high - low > 1e-9 * high; ++i) {
    const double middle = 0.5 * (low + high);
    auto growth = GrowthAt(simulation, middle);
    if (!growth.ok()) return growth.error();
    ((growth.value() > 0) == high_unstable ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

Status StartAtSpeed(const vehicle::Simulation& simulation, double speed, mjData* d) {
  const mjModel* m = simulation.model();
  if (mj_name2id(m, mjOBJ_KEY, "test") < 0) {
    return Error{simulation.scenario().bogie, "has no key named 'test'",
                 "an empty <key name=\"test\"/>, filled with the settled start", ""};
  }
  plugin::ResetToStart(m, d);
  mju_scl(d->qvel, d->qvel, speed / simulation.binding().target_speed(), m->nv);
  mj_forward(m, d);
  return {};
}

Result<SpeedSpectrum> SpectrumAt(vehicle::Simulation* simulation, double speed,
                                 VibrationMode* least_stable) {
  mjModel* m = simulation->mutable_model();
  const vehicle::DataPtr running(mj_makeData(m));
  if (Status s = StartAtSpeed(*simulation, speed, running.get()); !s.ok()) return s.error();
  const LinearModel model = Linearise(m, simulation->binding(), running.get());
  if (!model.matrix.allFinite()) {
    return Error{
        simulation->scenario().bogie,
        "cannot be linearised at " + std::to_string(speed) + " m/s: accelerations are not finite",
        "", ""};
  }
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(model.matrix, least_stable != nullptr);
  SpeedSpectrum spectrum{speed, {}, -std::numeric_limits<double>::infinity()};
  int least = -1;
  for (int i = 0; i < solver.eigenvalues().size(); ++i) {
    const std::complex<double> value = solver.eigenvalues()[i];
    if (std::abs(value) < kNeutral) continue;
    spectrum.eigenvalues.push_back(value);
    if (value.real() <= spectrum.growth) continue;
    spectrum.growth = value.real();
    least = i;
  }
  if (least_stable != nullptr && least >= 0) {
    *least_stable = Shape(*simulation, running.get(), speed, solver.eigenvalues()[least],
                          solver.eigenvectors().col(least));
  }
  return spectrum;
}

Result<StabilityResult> AnalyseStability(vehicle::Simulation* simulation,
                                         const StabilityOptions& options,
                                         const vehicle::Progress& progress) {
  if (Status s = CheckOptions(options); !s.ok()) return s.error();
  if (Status s = CheckTrack(simulation->binding().track()); !s.ok()) return s.error();
  StabilityResult result;
  result.critical_speed = std::numeric_limits<double>::quiet_NaN();
  const double span = options.max_speed_m_s - options.min_speed_m_s;
  for (int i = 0; i < options.speeds; ++i) {
    const double speed = options.min_speed_m_s + span * i / (options.speeds - 1);
    auto spectrum = SpectrumAt(simulation, speed);
    if (!spectrum.ok()) return spectrum.error();
    result.spectra.push_back(std::move(spectrum).value());
    if (progress && !progress(static_cast<double>(i + 1) / options.speeds)) {
      return Error{"stability analysis", "was interrupted", "", ""};
    }
    if (i == 0) continue;
    const SpeedSpectrum& before = result.spectra[static_cast<size_t>(i) - 1];
    const SpeedSpectrum& here = result.spectra.back();
    if ((before.growth > 0) == (here.growth > 0)) continue;
    auto speed_there = FindCrossing(simulation, before.speed, here.speed, here.growth > 0);
    if (!speed_there.ok()) return speed_there.error();
    result.crossings.push_back({speed_there.value(), here.growth > 0});
    if (here.growth > 0 && std::isnan(result.critical_speed)) {
      result.critical_speed = speed_there.value();
    }
  }
  const double shown =
      std::isnan(result.critical_speed) ? options.max_speed_m_s : result.critical_speed;
  auto at_limit = SpectrumAt(simulation, shown, &result.mode);
  if (!at_limit.ok()) return at_limit.error();
  return result;
}

}  // namespace phs::analysis
