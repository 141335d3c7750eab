#include "analysis/steady_problem.h"

#include <algorithm>
#include <cmath>

#include "plugin/active_steering.h"
#include "plugin/settle.h"

namespace phs::analysis {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kProbe = 1e-7;       ///< of position [m, rad]
constexpr double kSpeedProbe = 1e-5;  ///< of spin and forward speed [rad/s, m/s]
constexpr int kMaxIterations = 60;
constexpr double kLargestMove = 2e-3;  ///< of a Newton step [m, rad]
constexpr int kFreeIterations = 10;    ///< then steps shrink
constexpr double kShrink = 0.9;
constexpr double kGrowth = 5;    ///< of the residual in one step, early on
constexpr int kMaxHalvings = 5;  ///< of the way to the next place

Matrix3d Attitude(const mjData* d, int body) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(d->xmat + 9 * body);
}

}  // namespace

SteadyProblem::SteadyProblem(vehicle::Simulation* simulation, int joint)
    : m_(simulation->mutable_model()),
      instant_(m_),
      binding_(simulation->binding()),
      data_(mj_makeData(m_)),
      follower_(m_, binding_.track(), joint) {
  std::vector<char> solved(static_cast<size_t>(m_->nv), 1);
  for (const plugin::WheelsetBinding& w : binding_.wheelsets()) {
    solved[static_cast<size_t>(w.spin_dof)] = 0;
    spins_.push_back(w.spin_dof);
    driven_ = driven_ || w.drive_actuator >= 0;
  }
  for (int i = 0; i < m_->nv; ++i) {
    if (solved[static_cast<size_t>(i)]) positions_.push_back(i);
  }
  plugin::ResetToStart(m_, data_.get());
  follower_.Start(data_.get());
  speed_ = binding_.target_speed();
  for (const int dof : spins_) spin_speed_.push_back(data_->qvel[dof]);
  mj_forward(m_, data_.get());
  KeepStates();
}

double SteadyProblem::AdvanceTo(double s, double tolerance, double acceptable) {
  double part = 1;
  double left = 0;
  const double begin = follower_.s();
  for (double done = 0; done < 1;) {
    const Saved saved = Save();
    const double next = std::min(1.0, done + part);
    left = SolveAt(begin + next * (s - begin), tolerance);
    if (left < acceptable) {
      done = next;
      continue;
    }
    Restore(saved);
    part /= 2;
    if (part < std::pow(0.5, kMaxHalvings + 0.5)) return left;
  }
  return left;
}

double SteadyProblem::SolveAt(double s, double tolerance) {
  elapsed_ = std::max((s - follower_.s()) / speed_, 1e-3);
  MoveVehicle(s);
  base_.assign(data_->qpos, data_->qpos + m_->nq);
  const double left = Newton(tolerance);
  KeepStates();
  return left;
}

SteadyProblem::Saved SteadyProblem::Save() const {
  return {{data_->qpos, data_->qpos + m_->nq},
          states_,
          spin_speed_,
          lengths_,
          follower_.s(),
          speed_,
          coasting_};
}

void SteadyProblem::Restore(const Saved& saved) {
  mju_copy(data_->qpos, saved.position.data(), m_->nq);
  states_ = saved.states;
  spin_speed_ = saved.spin_speed;
  lengths_ = saved.lengths;
  speed_ = saved.speed;
  coasting_ = saved.coasting;
  mju_copy(data_->act, states_.data(), m_->na);
  follower_.Stand(saved.s);
  mj_kinematics(m_, data_.get());
}

VectorXd SteadyProblem::Evaluate(const VectorXd& move) {
  mjData* d = data_.get();
  VectorXd tangent = VectorXd::Zero(m_->nv);
  const int np = static_cast<int>(positions_.size());
  for (int i = 0; i < np; ++i) tangent[positions_[static_cast<size_t>(i)]] = move[i];
  mju_copy(d->qpos, base_.data(), m_->nq);
  mj_integratePos(m_, d->qpos, tangent.data(), 1.0);
  mju_zero(d->qvel, m_->nv);
  for (size_t i = 0; i < spins_.size(); ++i) {
    d->qvel[spins_[i]] = spin_speed_[i] + move[np + static_cast<int>(i)];
  }
  VectorXd expected = VectorXd::Zero(m_->nv);
  const double last = move[unknowns() - 1];
  follower_.Follow(driven_ ? speed_ + last : speed_, d, &expected);
  if (!driven_) {
    const double slower = coasting_ + last;
    expected.segment<3>(follower_.dof()) += slower * follower_.forward();
    for (const int dof : spins_) expected[dof] += slower * d->qvel[dof] / speed_;
  }
  AdvanceStates();
  mj_forward(m_, d);
  ++evaluations_;
  VectorXd r(unknowns());
  r.head(m_->nv) = Eigen::Map<const VectorXd>(d->qacc, m_->nv) - expected;
  r[m_->nv] = follower_.forward().dot(tangent.segment<3>(follower_.dof()));
  return r;
}

void SteadyProblem::MoveVehicle(double s) {
  mjData* d = data_.get();
  struct Place {
    double s;
    Vector3d offset;
    Matrix3d attitude;
  };
  std::vector<Place> places;
  for (const plugin::WheelsetBinding& w : binding_.wheelsets()) {
    const Eigen::Map<const Vector3d> centre(d->xpos + 3 * w.body);
    const double at = binding_.track().Project({centre[0], centre[1], centre[2]});
    const rail::TrackFrame f = binding_.track().FrameAt(at);
    places.push_back({at, Axes(f).transpose() * (centre - Origin(f)),
                      Axes(f).transpose() * Attitude(d, w.body)});
  }
  const double moved = s - follower_.s();
  follower_.MoveTo(s, d);
  mj_kinematics(m_, d);
  mj_comPos(m_, d);
  const int rows = 4 * static_cast<int>(places.size());
  MatrixXd jacobian(rows, m_->nv);
  VectorXd missing(rows);
  Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> place(3, m_->nv), turn(3, m_->nv);
  for (size_t i = 0; i < places.size(); ++i) {
    const int body = binding_.wheelsets()[i].body;
    const rail::TrackFrame f = binding_.track().FrameAt(places[i].s + moved);
    const Matrix3d axes = Axes(f);
    const Eigen::Map<const Vector3d> centre(d->xpos + 3 * body);
    const Vector3d shift = Origin(f) + axes * places[i].offset - centre;
    const Vector3d rotation = Turn(Attitude(d, body), axes * places[i].attitude);
    mj_jacBody(m_, d, place.data(), turn.data(), body);
    const int row = 4 * static_cast<int>(i);
    jacobian.row(row) = axes.col(1).transpose() * place;
    jacobian.row(row + 1) = axes.col(2).transpose() * place;
    jacobian.row(row + 2) = axes.col(0).transpose() * turn;
    jacobian.row(row + 3) = axes.col(2).transpose() * turn;
    missing.segment<4>(row) << axes.col(1).dot(shift), axes.col(2).dot(shift),
        axes.col(0).dot(rotation), axes.col(2).dot(rotation);
  }
  for (int i = 0; i < 6; ++i) jacobian.col(follower_.dof() + i).setZero();
  for (const int dof : spins_) jacobian.col(dof).setZero();
  const VectorXd move = jacobian.completeOrthogonalDecomposition().solve(missing);
  mj_integratePos(m_, d->qpos, move.data(), 1.0);
}

void SteadyProblem::AdvanceStates() {
  if (m_->na == 0) return;
  mjData* d = data_.get();
  mj_kinematics(m_, d);
  mj_comPos(m_, d);
  mj_comVel(m_, d);
  plugin::SettleSteering(m_, d);
  mj_tendon(m_, d);
  mj_transmission(m_, d);
  size_t kept = 0;
  for (const plugin::PhsBinding& p : binding_.phs()) {
    const int count = p.system->num_cylinders();
    const int states = p.system->num_states();
    double x[plugin::kMaxCylinders], v[plugin::kMaxCylinders];
    double state[plugin::kMaxStates], rate[plugin::kMaxStates];
    for (int i = 0; i < count; ++i) {
      const int a = p.cylinder[static_cast<size_t>(i)];
      const double length = d->actuator_length[a];
      x[i] = lengths_[kept] - p.length0[static_cast<size_t>(i)];
      v[i] = (length - lengths_[kept]) / elapsed_;
      ++kept;
    }
    for (int i = 0; i < states; ++i) state[i] = StateOf(p, i, states_.data());
    p.system->CalcStateRate(d->time, elapsed_, x, v, state, rate);
    for (int i = 0; i < states; ++i) {
      StateOf(p, i, d->act) = state[i] + elapsed_ * rate[i];
    }
  }
}

void SteadyProblem::KeepStates() {
  states_.assign(data_->act, data_->act + m_->na);
  lengths_.clear();
  for (const plugin::PhsBinding& p : binding_.phs()) {
    for (const int a : p.cylinder) lengths_.push_back(data_->actuator_length[a]);
  }
}

MatrixXd SteadyProblem::Jacobian(const VectorXd& r) {
  const int n = unknowns();
  MatrixXd jacobian(n, n);
  for (int k = 0; k < n; ++k) {
    const double step = k < static_cast<int>(positions_.size()) ? kProbe : kSpeedProbe;
    VectorXd probe = VectorXd::Zero(n);
    probe[k] = step;
    jacobian.col(k) = (Evaluate(probe) - r) / step;
  }
  return jacobian;
}

void SteadyProblem::Accept(const VectorXd& move) {
  base_.assign(data_->qpos, data_->qpos + m_->nq);
  const int np = static_cast<int>(positions_.size());
  for (size_t i = 0; i < spins_.size(); ++i) spin_speed_[i] += move[np + static_cast<int>(i)];
  (driven_ ? speed_ : coasting_) += move[unknowns() - 1];
}

double SteadyProblem::Newton(double tolerance) {
  const int n = unknowns();
  VectorXd r = Evaluate(VectorXd::Zero(n));
  MatrixXd jacobian;
  bool fresh = false;
  for (int i = 0; i < kMaxIterations && r.lpNorm<Eigen::Infinity>() > tolerance; ++i) {
    if (jacobian.size() == 0) {
      jacobian = Jacobian(r);
      fresh = true;
    }
    VectorXd step = jacobian.partialPivLu().solve(-r);
    const double largest = step.head(static_cast<int>(positions_.size())).lpNorm<Eigen::Infinity>();
    const double limit = kLargestMove * std::pow(kShrink, std::max(0, i - kFreeIterations));
    if (largest > limit) step *= limit / largest;
    double scale = 1;
    VectorXd next = Evaluate(step);
    // Contacts come and go: a residual may have to grow before it falls.
    const double growth = i < kMaxIterations / 2 ? kGrowth : 1;
    while (!(next.norm() < growth * r.norm()) && scale > 1e-3 && fresh) {
      scale /= 2;
      next = Evaluate(scale * step);
    }
    if (!(next.norm() < growth * r.norm())) {
      if (fresh) break;  // as good as it gets
      jacobian.resize(0, 0);
      continue;
    }
    Accept(scale * step);
    // Broyden's update keeps the Jacobian while it still serves.
    const VectorXd change = next - r - scale * (jacobian * step);
    const bool serves = next.norm() < 0.2 * r.norm();
    if (serves) {
      jacobian += change * step.transpose() / (scale * step.squaredNorm());
      fresh = false;
    } else {
      jacobian.resize(0, 0);
    }
    r = next;
  }
  const VectorXd last = Evaluate(VectorXd::Zero(n));
  return last.lpNorm<Eigen::Infinity>();
}

}  // namespace phs::analysis
