#include "hydraulics/mount_balance.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

namespace phs::hydraulics {
namespace {

/// How well a way over h is met. What friction makes of an error goes with its speed: 1e-12 m over
/// 5 ms, 0.01 Pa in a chamber.
double Enough(double h) { return std::max(1e-15, 2e-10 * h); }

/// A force that a way meets [N], and its slope [N/m].
struct Held {
  double force, slope;
};

/// What resists a piston beside its pressures.
class Resistance {
 public:
  Resistance(const MountStep& step, int cylinder)
      : sys_(step.sys),
        c_(step.sys.cylinders[cylinder]),
        h_(step.h),
        start_(step.PistonAtStart(cylinder)),
        state_(step.state),
        cylinder_(cylinder) {}

  /// End stop and friction when it moves by `way`; `at`: pressures at the end of the step.
  Held Calc(const Instant& at, double way) const {
    const EndStopForce stop = CalcEndStop(c_.stop, start_ + way, way / h_);
    const double nudge = std::max(1e-7 * std::abs(way), 1e-13);
    const double friction = Friction(at, way);
    const double slope = (Friction(at, way + nudge) - friction) / nudge;
    return {stop.force + friction, stop.slope + slope};
  }
  /// Of the mounting, its driven end at x_end, over that end.
  Held Mounting(double x_end, double way) const {
    Held held;
    held.force = c_.mount.Force(x_end - start_ - way, c_.Branches(state_), h_, &held.slope);
    return held;
  }

 private:
  double Friction(const Instant& at, double way) const {
    const FrictionPlace place = sys_.Place(at, cylinder_, state_);
    double z = 0;
    if (c_.bristle >= 0) z = c_.friction.Advance(h_, way / h_, state_[c_.bristle], place);
    return c_.friction.Calc(way / h_, z, place).force;
  }

  const CompiledPhs& sys_;
  const CompiledCylinder& c_;
  double h_, start_;
  const double* state_;
  int cylinder_;
};

/// What the ways leave unbalanced, and its slopes.
class JointBalance {
 public:
  static constexpr int kMost = kMaxCylinders + 1;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMost, 1>;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMost, kMost>;

  JointBalance(const MountStep& step, const CarriedBody* body, ChamberPressures* chambers,
               double* way)
      : step_(step), body_(body), chambers_(*chambers), way_(way) {
    const int cylinders = static_cast<int>(step.sys.cylinders.size());
    for (int i = 0; i < cylinders; ++i) {
      if (step.IsMounted(i)) Add(i, mounted_++, 1);
    }
    for (int i = 0; i < cylinders; ++i) {
      if (!step.IsMounted(i) && Arm(i) != 0) Add(i, mounted_, Arm(i));
    }
  }

  int size() const { return mounted_ + (body_ != nullptr ? 1 : 0); }
  Vector Guess(double body_way) const {
    Vector q(size());
    for (int k = 0; k < mounted_; ++k) q[k] = way_[moved_[k]];
    if (body_ != nullptr) q[mounted_] = body_way;
    return q;
  }
  /// What does not balance at the ways q.
  Vector Calc(const Vector& q) {
    Matrix* slopes = &slopes_;
    for (int k = 0; k < count_; ++k) way_[moved_[k]] = factor_[k] * q[along_[k]];
    chambers_.Solve(way_);
    double of_each[kMaxCylinders][kMaxCylinders];
    chambers_.Stiffness(moved_.data(), count_, of_each);
    Vector force = Vector::Zero(size());
    slopes->setZero(size(), size());
    falling_.setZero(size());
    for (int k = 0; k < count_; ++k) {
      for (int l = 0; l < count_; ++l) {
        (*slopes)(along_[l], along_[k]) += factor_[k] * factor_[l] * of_each[k][moved_[l]];
      }
      const int i = moved_[k];
      const Resistance resistance(step_, i);
      const Held held = resistance.Calc(chambers_.at(), way_[i]);
      force[along_[k]] +=
          factor_[k] * (CalcPressureForce(step_.sys, chambers_.at(), i) + held.force);
      (*slopes)(along_[k], along_[k]) += factor_[k] * factor_[k] * held.slope;
      falling_[along_[k]] += factor_[k] * factor_[k] * std::max(-held.slope, 0.0);
      if (k < mounted_) AddMounting(resistance, k, q, &force, slopes);
    }
    if (body_ != nullptr) {
      double slope;
      force[mounted_] += body_->Hold(q[mounted_], &slope);
      (*slopes)(mounted_, mounted_) += slope;
    }
    *slopes = 0.5 * (*slopes + slopes->transpose().eval());
    return force;
  }
  /// Newton's step from the ways last asked for. Where the sum falls with the ways, as if what
  /// falls there stayed.
  Vector Step(const Vector& force) const {
    const auto solver = slopes_.ldlt();
    if (solver.isPositive()) return solver.solve(-force);
    Matrix rising = slopes_;
    rising.diagonal() += falling_;
    return rising.ldlt().solve(-force);
  }

 private:
  double Arm(int cylinder) const { return body_ != nullptr ? body_->arm[cylinder] : 0; }
  void Add(int cylinder, int along, double factor) {
    moved_[count_] = cylinder, along_[count_] = along, factor_[count_++] = factor;
  }
  void AddMounting(const Resistance& resistance, int k, const Vector& q, Vector* force,
                   Matrix* slopes) const {
    const int i = moved_[k];
    const double arm = Arm(i);
    const double end = step_.x[i] + (arm != 0 ? arm * q[mounted_] : step_.v[i] * step_.h);
    const Held mounting = resistance.Mounting(end, q[k]);
    (*force)[k] -= mounting.force;
    (*slopes)(k, k) += mounting.slope;
    if (arm == 0) return;
    (*force)[mounted_] += arm * mounting.force;
    (*slopes)(mounted_, mounted_) += arm * arm * mounting.slope;
    (*slopes)(k, mounted_) -= arm * mounting.slope;
    (*slopes)(mounted_, k) -= arm * mounting.slope;
  }

  const MountStep& step_;
  const CarriedBody* body_;
  ChamberPressures& chambers_;
  double* way_;
  Matrix slopes_;
  Vector falling_;  ///< of the diagonal, what falls
  int mounted_ = 0, count_ = 0;
  // Pistons that move: the mounted ones first, then rigid ones that the body carries. Each goes
  // `factor` times the unknown way `along`; that of the body is the last.
  std::array<int, kMaxCylinders> moved_, along_;
  std::array<double, kMaxCylinders> factor_;
};

}  // namespace

void BalancePiston(const MountStep& step, int cylinder, ChamberPressures* chambers, double* way) {
  const double enough = Enough(step.h);
  const double end = step.x[cylinder] + step.v[cylinder] * step.h;
  const Resistance resistance(step, cylinder);
  double low = -INFINITY, high = INFINITY;
  double& move = way[cylinder];
  for (int i = 0;; ++i) {
    double of_each[1][kMaxCylinders];
    chambers->Solve(way);
    chambers->Stiffness(&cylinder, 1, of_each);
    const Held held = resistance.Calc(chambers->at(), move);
    const Held mounting = resistance.Mounting(end, move);
    const double force =
        CalcPressureForce(step.sys, chambers->at(), cylinder) + held.force - mounting.force;
    double slope = of_each[0][cylinder] + held.slope + mounting.slope;
    if (!(slope > 0)) slope -= held.slope;  // as if what falls stayed
    if (std::abs(force) <= enough * slope) return;
    (force > 0 ? high : low) = move;
    double next = move - force / slope;
    const bool between = std::isfinite(low) && std::isfinite(high);
    if (!(next > low && next < high)) {
      next = between ? 0.5 * (low + high) : move;
    } else if (i > 8 && between && i % 2 == 0) {
      next = 0.5 * (low + high);  // Newton that circles around a kink
    }
    if (std::abs(next - move) <= enough || i == 80) return;
    move = next;
  }
}

bool BalanceAll(const MountStep& step, const CarriedBody* body, ChamberPressures* chambers,
                double* way, double* body_way) {
  JointBalance balance(step, body, chambers, way);
  JointBalance::Vector q = balance.Guess(body != nullptr ? *body_way : 0);
  JointBalance::Vector force = balance.Calc(q);
  for (int i = 0; i < 40; ++i) {
    const JointBalance::Vector newton = balance.Step(force);
    if (!newton.allFinite()) return false;
    if (newton.lpNorm<Eigen::Infinity>() <= Enough(step.h)) {
      if (body != nullptr) *body_way = q[q.size() - 1];
      return true;
    }
    // Along the way the potential falls at first; past its lowest point it rises.
    const double falls = newton.dot(force);
    double low = 0, high = 1, at_low = falls, share = 1;
    JointBalance::Vector next = q + newton;
    JointBalance::Vector there = balance.Calc(next);
    for (int k = 0; k < 20; ++k) {
      const double rises = newton.dot(there);
      if (std::abs(rises) <= 0.5 * std::abs(falls)) break;
      if (rises < 0 && share == 1) break;  // Newton's own step, still falling
      if (rises > 0) {
        high = share;
      } else {
        low = share, at_low = rises;
      }
      const double secant = low + (share - low) * at_low / (at_low - rises);
      share = rises > 0 && secant > low && secant < high ? secant : 0.5 * (low + high);
      share = std::clamp(share, low + 0.05 * (high - low), high - 0.05 * (high - low));
      next = q + share * newton;
      there = balance.Calc(next);
    }
    q = next, force = there;
  }
  return false;
}

}  // namespace phs::hydraulics
