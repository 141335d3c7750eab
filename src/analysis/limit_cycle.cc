#include "analysis/limit_cycle.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "analysis/drives_off.h"
#include "vehicle/tangent_state.h"

namespace phs::analysis {
namespace {

constexpr double kWindow = 1.0;     ///< over which the swing is taken [s]
constexpr double kRecord = 0.1;     ///< between points of a ramp [s]
constexpr double kDerailed = 0.05;  ///< lateral [m]
constexpr long kLook = 500;         ///< steps between looks at the progress
constexpr double kSustained = 0.8;  ///< amplitude kept over the second half of a run

/// A vehicle on straight track whose forward speed is prescribed.
class GuidedRun {
 public:
  GuidedRun(vehicle::Simulation* simulation, const vehicle::Progress& progress)
      : simulation_(*simulation),
        progress_(progress),
        m_(simulation->mutable_model()),
        binding_(simulation->binding()),
        data_(mj_makeData(m_)),
        body_(binding_.wheelsets()[0].body),
        radius_(binding_.wheel_rail().params().wheel_radius),
        drives_off_(m_, binding_) {
    forward_ = m_->body_dofadr[m_->body_rootid[body_]];
  }
  GuidedRun(const GuidedRun&) = delete;
  GuidedRun& operator=(const GuidedRun&) = delete;

  Status Settle(double speed) {
    speed_ = speed;
    swing_.clear();
    return StartAtSpeed(simulation_, speed, data_.get());
  }

  /// Adds the mode with lateral amplitude `size` [m] at a wheelset.
  void Disturb(const VibrationMode& mode, double size) {
    vehicle::AddToState(m_, size * mode.state.real(), data_.get());
  }

  /// The share of the whole that is done, told from now on.
  void At(double share) { share_ = share; }
  /// True once the caller has asked for the end; no Advance goes on then.
  bool stopped() const { return stopped_; }

  /// Runs for `duration` while the speed changes at `rate` [m/s^2]; false once it has derailed or
  /// was stopped.
  bool Advance(double duration, double rate) {
    mjData* d = data_.get();
    const double h = m_->opt.timestep;
    const long steps = std::lround(duration / h);
    for (long i = 0; i < steps; ++i) {
      if (i % kLook == 0 && progress_ && !progress_(share_)) stopped_ = true;
      if (stopped_) return false;
      mj_step(m_, d);
      speed_ += rate * h;
      Guide();
      const double y = d->xpos[3 * body_ + 1];
      swing_.push_back(y);
      if (!std::isfinite(y) || std::abs(y) > kDerailed || !vehicle::EngineWarning(d).empty()) {
        return false;
      }
    }
    const size_t kept = static_cast<size_t>(std::lround(kWindow / h));
    while (swing_.size() > kept) swing_.pop_front();
    return true;
  }

  double Amplitude() const {
    if (swing_.empty()) return 0;
    const auto [least, greatest] = std::minmax_element(swing_.begin(), swing_.end());
    return 0.5 * (*greatest - *least);
  }
  double speed() const { return speed_; }

  struct Snapshot {
    std::vector<double> position, velocity, activation;
    double speed = 0;
  };
  Snapshot Save() const {
    const mjData* d = data_.get();
    return {{d->qpos, d->qpos + m_->nq},
            {d->qvel, d->qvel + m_->nv},
            {d->act, d->act + m_->na},
            speed_};
  }
  /// The motion of a snapshot at another forward speed.
  void Restore(const Snapshot& s, double speed) {
    mjData* d = data_.get();
    mj_resetData(m_, d);
    mju_copy(d->qpos, s.position.data(), m_->nq);
    mju_copy(d->qvel, s.velocity.data(), m_->nv);
    mju_copy(d->act, s.activation.data(), m_->na);
    speed_ = speed;
    Guide();
    swing_.clear();
  }

 private:
  /// Every body, spins included, gets what the root lacks of the prescribed speed.
  void Guide() {
    mjData* d = data_.get();
    const double lacking = speed_ - d->qvel[forward_];
    d->qvel[forward_] = speed_;
    for (const plugin::WheelsetBinding& w : binding_.wheelsets()) {
      d->qvel[w.spin_dof] += lacking / radius_;
    }
  }

  const vehicle::Simulation& simulation_;
  const vehicle::Progress& progress_;
  mjModel* m_;
  const plugin::Binding& binding_;
  vehicle::DataPtr data_;
  int body_;
  double radius_;
  int forward_ = 0;
  double speed_ = 0;
  double share_ = 0;
  bool stopped_ = false;
  std::deque<double> swing_;
  DrivesOff drives_off_;
};

Status CheckCycleOptions(const LimitCycleOptions& o) {
  if (o.low_speed_m_s > 0 && o.high_speed_m_s > o.low_speed_m_s && o.high_speed_m_s <= 200 &&
      o.rate_m_s2 > 0 && o.rate_m_s2 <= 5) {
    return {};
  }
  return Error{"speed ramp", "is out of range", "0 < lowest < highest <= 200 m/s, rate 0 … 5 m/s^2",
               ""};
}

using Snapshots = std::vector<GuidedRun::Snapshot>;

/// Down until the motion dies; snapshots while it lives, highest speed first.
Status RampDown(const VibrationMode& mode, const LimitCycleOptions& options, GuidedRun* run,
                LimitCycle* result, Snapshots* alive) {
  if (Status s = run->Settle(options.high_speed_m_s); !s.ok()) return s;
  run->Disturb(mode, options.disturbance_m);
  // The cycle first builds up at constant speed.
  result->derailed = !run->Advance(options.settling_s, 0);
  while (!result->derailed && run->speed() > options.low_speed_m_s) {
    result->derailed = !run->Advance(kRecord, -options.rate_m_s2);
    const double amplitude = run->Amplitude();
    result->down.push_back({run->speed(), amplitude});
    if (amplitude < options.alive_m) break;
    alive->push_back(run->Save());
    const double share =
        (options.high_speed_m_s - run->speed()) / (options.high_speed_m_s - options.low_speed_m_s);
    run->At(0.4 * share);
  }
  return {};
}

/// True if the cycle of `start` lives on at `speed`.
bool LivesAt(double speed, const GuidedRun::Snapshot& start, const LimitCycleOptions& options,
             GuidedRun* run, double* amplitude) {
  run->Restore(start, speed);
  if (!run->Advance(options.settling_s / 2, 0)) return false;
  const double middle = run->Amplitude();
  if (!run->Advance(options.settling_s / 2, 0)) return false;
  *amplitude = run->Amplitude();
  return *amplitude > options.alive_m && *amplitude > kSustained * middle;
}

/// Between the lowest speed known to keep the cycle and the speed at which the ramp lost it.
void Bisect(const LimitCycleOptions& options, const Snapshots& alive, GuidedRun* run,
            LimitCycle* result) {
  const auto start_for = [&](double speed) {
    const GuidedRun::Snapshot* nearest = &alive.front();
    for (const GuidedRun::Snapshot& s : alive) {
      if (s.speed >= speed) nearest = &s;
    }
    return nearest;
  };
  double low = result->down.back().speed;
  double high = options.high_speed_m_s;
  if (!LivesAt(high, alive.front(), options, run, &result->amplitude)) return;
  while (high - low > options.resolution_m_s) {
    const double middle = 0.5 * (low + high);
    double amplitude = 0;
    // A snapshot somewhat above still has the full cycle; the ramp's own there is dying already.
    const double from = middle + 0.25 * (options.high_speed_m_s - middle);
    if (LivesAt(middle, *start_for(from), options, run, &amplitude)) {
      high = middle;
      result->amplitude = amplitude;
    } else {
      low = middle;
    }
  }
  result->critical_speed = 0.5 * (low + high);
}

Status RampUp(const VibrationMode& mode, const LimitCycleOptions& options, GuidedRun* run,
              LimitCycle* result) {
  const double begin =
      std::max(options.low_speed_m_s,
               result->down.empty() ? options.low_speed_m_s : result->down.back().speed - 2);
  if (Status s = run->Settle(begin); !s.ok()) return s;
  run->Disturb(mode, options.small_m);
  while (run->speed() < options.high_speed_m_s) {
    if (!run->Advance(kRecord, options.rate_m_s2)) break;
    const double amplitude = run->Amplitude();
    result->up.push_back({run->speed(), amplitude});
    if (amplitude < options.small_m / 4) run->Disturb(mode, options.small_m);
    const double share = (run->speed() - begin) / (options.high_speed_m_s - begin);
    run->At(0.7 + 0.3 * share);
  }
  return {};
}

}  // namespace

Result<LimitCycle> FindLimitCycle(vehicle::Simulation* simulation, const VibrationMode& mode,
                                  const LimitCycleOptions& options,
                                  const vehicle::Progress& progress) {
  if (Status s = CheckCycleOptions(options); !s.ok()) return s.error();
  LimitCycle result;
  result.critical_speed = std::numeric_limits<double>::quiet_NaN();
  GuidedRun run(simulation, progress);
  const Error interrupted{"speed ramp", "was interrupted", "", ""};
  Snapshots alive;
  if (Status s = RampDown(mode, options, &run, &result, &alive); !s.ok()) return s.error();
  if (run.stopped()) return interrupted;
  const bool died = !result.down.empty() && result.down.back().amplitude < options.alive_m;
  if (!alive.empty() && died) Bisect(options, alive, &run, &result);
  if (Status s = RampUp(mode, options, &run, &result); !s.ok()) return s.error();
  if (run.stopped()) return interrupted;
  return result;
}

}  // namespace phs::analysis
