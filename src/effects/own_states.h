// States of a law that a model brings with it: dz_k/dt = r_k(z, place), each by a formula.
//
// Advanced by the Rosenbrock method ROS2 with gamma = 1 - 1/sqrt(2) and a Jacobian by differences
// (Verwer, Spee, Blom, Hundsdorfer 1999): second order, L-stable, so that a stiff bristle neither
// rings nor limits the step. A step is cut where the states change fast, into at most 16.
#pragma once

#include <vector>

#include "effects/formula.h"

namespace phs::effects {

class OwnStates {
 public:
  static constexpr int kMost = 4;

  OwnStates() = default;
  /// At most kMost rates, in the order of the states.
  explicit OwnStates(std::vector<Formula> rates) : rates_(std::move(rates)) {}
  int size() const { return static_cast<int>(rates_.size()); }
  /// `place` with its states.
  void CalcRates(const hydraulics::ForcePlace& place, double* rate) const noexcept;
  /// `state` after h seconds; all else of `place` is held.
  void Advance(double h, hydraulics::ForcePlace place, double* state) const noexcept;

 private:
  std::vector<Formula> rates_;
};

}  // namespace phs::effects
