#include "rigs/hinged_beam.h"

#include <algorithm>

#include "rigs/implicit_move.h"

namespace phs::rigs {

using hydraulics::PhsOutputs;

HingedBeam::HingedBeam(const hydraulics::PhsSystem& system, const BeamParams& params)
    : system_(system),
      params_(params),
      state_(system.num_states(), 0.0),
      rate_(system.num_states(), 0.0),
      next_(system.num_states(), 0.0) {}

void HingedBeam::Calc(double t, double x1, double x2, double v1, double v2, PhsOutputs* out) const {
  const double y = params_.lever_m * angle_, w = params_.lever_m * speed_;
  const double x[4] = {x1, x2, y, -y}, v[4] = {v1, v2, w, -w};
  system_.Calc(t, x, v, state_.data(), out);
}

// Sum of moments against the move at the end of the step [N m].
double HingedBeam::Imbalance(double t, double h, const double* x, double move, double* v) {
  const double w = move / h;
  v[2] = params_.lever_m * w;
  v[3] = -v[2];
  system_.CalcStateRate(t, h, x, v, state_.data(), rate_.data(),
                        system_.has_mounts() ? nullptr : before_);
  for (size_t i = 0; i < state_.size(); ++i) next_[i] = state_[i] + h * rate_[i];
  double end[4], force[4];
  for (int i = 0; i < 4; ++i) end[i] = x[i] + h * v[i];
  PhsOutputs out;
  out.energy = false;
  out.force = force;
  system_.Calc(t + h, end, v, next_.data(), &out);
  const double hinge = params_.hinge_friction_Nm * std::clamp(w / 1e-4, -1.0, 1.0);
  return params_.inertia_kg_m2 * (w - speed_) / h + params_.damping_Nms_per_rad * w + hinge +
         params_.lever_m * (force[2] - force[3]);
}

void HingedBeam::Step(double t, double h, double x1, double x2, double v1, double v2) {
  const double y = params_.lever_m * angle_;
  const double x[4] = {x1, x2, y, -y};
  double v[4] = {v1, v2, 0, 0};
  const double move = FindMove(speed_ * h, params_.inertia_kg_m2 / (h * h),
                               [&](double trial) { return Imbalance(t, h, x, trial, v); });
  state_ = next_;
  speed_ = move / h;
  std::copy(v, v + 4, before_);
  angle_ += move;
}

}  // namespace phs::rigs
