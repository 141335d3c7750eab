#include "rigs/hinged_beam.h"

#include <algorithm>
#include <cmath>

namespace phs::rigs {

using hydraulics::PhsOutputs;

namespace {

constexpr double kEnough = 1e-3;  // [N m] a millionth of what friction holds

/// The beam over a step of h from `speed`.
class Beam final : public hydraulics::CarriedBody {
 public:
  Beam(const BeamParams& params, double h, double speed) : params_(params), h_(h), speed_(speed) {
    arm[2] = params.lever_m, arm[3] = -params.lever_m;
  }
  double Hold(double way, double* slope) const override {
    constexpr double kTurn = 1e-4;  // [rad/s]
    const double w = way / h_, turned = std::clamp(w / kTurn, -1.0, 1.0);
    const double hinge = std::abs(turned) < 1 ? params_.hinge_friction_Nm / kTurn : 0;
    *slope = params_.inertia_kg_m2 / (h_ * h_) + (params_.damping_Nms_per_rad + hinge) / h_;
    return params_.inertia_kg_m2 * (w - speed_) / h_ + params_.damping_Nms_per_rad * w +
           params_.hinge_friction_Nm * turned;
  }

 private:
  const BeamParams& params_;
  const double h_, speed_;
};

}  // namespace

HingedBeam::HingedBeam(const hydraulics::PhsSystem& system, const BeamParams& params, double t,
                       double x1, double x2)
    : system_(system),
      params_(params),
      x_{x1, x2, 0, 0},
      state_(system.num_states(), 0.0),
      rate_(system.num_states(), 0.0),
      next_(system.num_states(), 0.0) {
  guess_.enough = kEnough;
  system_.Solve(t, x_, state_.data(), &instants_[now_]);
}

void HingedBeam::Calc(double v1, double v2, PhsOutputs* out) const {
  const double w = params_.lever_m * speed_;
  const double v[4] = {v1, v2, w, -w};
  system_.CalcAt(instants_[now_], x_, v, state_.data(), out);
}

// Sum of moments against the move at the end of the step [N m].
double HingedBeam::Imbalance(const hydraulics::CarriedBody& beam, double h, double move,
                             double* v) {
  const hydraulics::Instant& at = instants_[now_];
  hydraulics::Instant& end = instants_[1 - now_];
  const double w = move / h;
  v[2] = params_.lever_m * w;
  v[3] = -v[2];
  system_.CalcStateRateAt(at, h, x_, v, state_.data(), rate_.data(),
                          system_.has_mounts() ? nullptr : before_, way_);
  for (size_t i = 0; i < state_.size(); ++i) next_[i] = state_[i] + h * rate_[i];
  double x[4], force[4];
  for (int i = 0; i < 4; ++i) x[i] = x_[i] + h * v[i];
  PhsOutputs out;
  out.energy = false;
  out.force = force;
  system_.Solve(at.time + h, x, next_.data(), &end);
  system_.CalcAt(end, x, v, next_.data(), &out);
  double slope;
  return beam.Hold(move, &slope) + params_.lever_m * (force[2] - force[3]);
}

void HingedBeam::Step(double h, double x1, double x2) {
  double v[4] = {(x1 - x_[0]) / h, (x2 - x_[1]) / h, 0, 0};
  const Beam beam(params_, h, speed_);
  double start = (2 * speed_ - last_speed_) * h;  // as if it went on to change as it did
  if (system_.mount(2).present() || system_.mount(3).present()) {
    // Pistons as if they went on with their driven ends.
    v[2] = params_.lever_m * start / h, v[3] = -v[2];
    for (int i = 0; i < 4; ++i) way_[i] += h * (v[i] - before_[i]);
    system_.BalanceBody(instants_[now_], h, x_, v, state_.data(), beam, way_, &start);
  }
  const double move = FindMove(start, params_.inertia_kg_m2 / (h * h), &guess_,
                               [&](double trial) { return Imbalance(beam, h, trial, v); });
  state_ = next_;
  last_speed_ = speed_;
  speed_ = move / h;
  std::copy(v, v + 4, before_);
  angle_ += move;
  for (int i = 0; i < 4; ++i) x_[i] += h * v[i];
  now_ = 1 - now_;  // the last move tried is the one taken
}

}  // namespace phs::rigs
