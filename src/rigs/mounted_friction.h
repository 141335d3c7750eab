// Friction at the end of a gap and a spring, of a part on a bench.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/rising_root.h"
#include "hydraulics/friction.h"
#include "hydraulics/mount.h"

namespace phs::rigs {

/// Solved for its own move y each sample: friction rises with the move, the mount's force falls.
class MountedFriction {
 public:
  using Friction = hydraulics::Friction;
  using FrictionModel = hydraulics::FrictionModel;
  using FrictionPlace = hydraulics::FrictionPlace;
  using Mount = hydraulics::Mount;
  MountedFriction(const Friction& friction, const Mount& mount, double x, double h)
      : friction_(&friction),
        mount_(&mount),
        y_(x),
        h_(h),
        memory_(static_cast<size_t>(friction.num_memories()), 0.0) {}
  /// Force with the drive at x, v now; `place` without piston and memory.
  double Calc(double x, double v, FrictionPlace place) {
    place.memory = memory_.data();
    if (!mount_->present()) {
      place.piston = y_ = x;
      direction_ = friction_->Direction(v, z_, place);
      return friction_->Calc(v, z_, place).force;
    }
    const double move = SolveMove(x, place);
    Advance(h_, move / h_, place);
    y_ += move;
    direction_ = friction_->Direction(move / h_, z_, place);
    return MountForce(x - y_);
  }
  /// Brings it to x over `h`, ending with speed v: force there.
  double After(double h, double x, double v, const FrictionPlace& place) {
    h_ = h;
    Move((x - y_) / h, place);
    return Calc(x, v, place);
  }
  /// To the next sample, the drive at mean speed v (without a mount only: else done in Calc).
  void Move(double v, FrictionPlace place) {
    if (mount_->present()) return;
    place.piston = y_;
    place.memory = memory_.data();
    Advance(h_, v, place);
  }
  double direction() const { return direction_; }

 private:
  /// Move of y that balances friction and mount. Their difference rises with the move, with a kink
  /// where the gap closes; a stiff contact asks for the last digit of it.
  double SolveMove(double x, const FrictionPlace& place) const {
    const double reach = std::abs(x - y_) + mount_->play() + 1e-12;
    const auto excess = [&](double move) {
      return FrictionAfter(move, place) - MountForce(x - y_ - move);
    };
    const RootSearch search{.step = reach, .reach = reach, .tolerance = 1e-12 * reach};
    if (const auto move = RisingRoot(excess, search)) return *move;
    return excess(0) < 0 ? reach : -reach;
  }
  double MountForce(double u) const {
    double slope;
    return mount_->SpringForce(mount_->PlayFree(u), &slope);
  }
  double FrictionAfter(double move, FrictionPlace place) const {
    place.piston = y_ + move;
    double z = z_;
    if (friction_->model() == FrictionModel::kPresliding) {
      z = friction_->Advance(h_, move / h_, z_, place);
    }
    return friction_->Calc(move / h_, z, place).force;
  }
  void Advance(double h, double v, const FrictionPlace& place) {
    if (friction_->model() == FrictionModel::kPresliding) z_ = friction_->Advance(h, v, z_, place);
    if (memory_.empty()) return;
    FrictionPlace middle = place;
    middle.piston = y_ + 0.5 * h * v;
    friction_->AdvanceMemories(h, v, z_, middle, memory_.data());
  }

  const Friction* friction_;
  const Mount* mount_;
  double y_, h_;
  std::vector<double> memory_;
  double z_ = 0, direction_ = 0;
};

}  // namespace phs::rigs
