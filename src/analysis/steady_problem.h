// The quasi-static problem at one place of the track (steady_curve.h): unknowns, equations, Newton.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "analysis/track_follower.h"
#include "vehicle/simulation.h"

namespace phs::analysis {

/// The quasi-static problem at one place of the track.
class SteadyProblem {
 public:
  /// At the start of the track; `joint`: the vehicle's only free joint. The last unknown is the
  /// forward speed that the drives hold or, without any drive, the acceleration at the start's
  /// speed (d'Alembert: all bodies share it, spins turn with it).
  SteadyProblem(vehicle::Simulation* simulation, int joint);

  /// Goes on to arc length s of the root, in shorter steps where one is too long for Newton;
  /// returns the largest acceleration left there.
  double AdvanceTo(double s, double tolerance, double acceptable);

  mjData* data() { return data_.get(); }
  double s() const { return follower_.s(); }
  double speed() const { return speed_; }
  /// Along the track where nothing drives the vehicle, < 0: it slows down [m/s^2]; 0 if driven.
  double coasting() const { return coasting_; }
  long evaluations() const { return evaluations_; }

 private:
  /// Solves at arc length s of the root in one go; returns the largest acceleration left.
  double SolveAt(double s, double tolerance);

  /// A place that is solved, to come back to.
  struct Saved {
    std::vector<mjtNum> position, states;
    std::vector<double> spin_speed, lengths;
    double s = 0, speed = 0, coasting = 0;
  };
  Saved Save() const;
  void Restore(const Saved& saved);

  int unknowns() const { return static_cast<int>(positions_.size() + spins_.size()) + 1; }

  /// Sets `move` (positions, spins, speed) on top of the base and evaluates the residual: missing
  /// accelerations, and the shift along the track, which must stay zero.
  Eigen::VectorXd Evaluate(const Eigen::VectorXd& move);

  /// Takes the vehicle to arc length s with every wheelset as it lay in the track under it: wheels
  /// are so stiff on their rails that a wheelset off by a millimetre is far from any solution. The
  /// suspension takes up the rest, in the least-squares sense.
  void MoveVehicle(double s);

  /// Hydraulic and friction states after the motion since the last place at its running time.
  void AdvanceStates();
  template <typename Number>
  Number& StateOf(const plugin::PhsBinding& p, int index, Number* act) const {
    return act[p.state_actuator[static_cast<size_t>(index)] - (m_->nu - m_->na)];
  }
  void KeepStates();

  Eigen::MatrixXd Jacobian(const Eigen::VectorXd& r);

  /// Takes over a move: base and speeds are then those of the accepted iterate.
  void Accept(const Eigen::VectorXd& move);

  double Newton(double tolerance);

  mjModel* m_;
  plugin::InstantForces instant_;
  const plugin::Binding& binding_;
  vehicle::DataPtr data_;
  TrackFollower follower_;
  std::vector<int> positions_;  ///< dofs whose position is solved for
  std::vector<int> spins_;      ///< dofs whose speed is solved for
  std::vector<double> spin_speed_;
  bool driven_ = false;          ///< some axle has a drive
  double speed_ = 0;             ///< forward [m/s]
  double coasting_ = 0;          ///< [m/s^2]
  double elapsed_ = 1;           ///< running time since the last place [s]
  std::vector<mjtNum> base_;     ///< position that moves start from
  std::vector<mjtNum> states_;   ///< activations at the last place
  std::vector<double> lengths_;  ///< of the cylinders there [m]
  long evaluations_ = 0;
};

}  // namespace phs::analysis
