#include "analysis/steady_curve.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <vector>

#include "plugin/observer.h"
#include "plugin/settle.h"
#include "vehicle/summary.h"

namespace phs::analysis {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kFrameStep = 0.25;   ///< of differences along the track [m]
constexpr double kProbe = 1e-7;       ///< of position [m, rad]
constexpr double kSpeedProbe = 1e-5;  ///< of spin and forward speed [rad/s, m/s]
constexpr int kMaxIterations = 60;
constexpr double kLargestMove = 2e-3;  ///< of a Newton step [m, rad]
constexpr int kFreeIterations = 10;    ///< then steps shrink
constexpr double kShrink = 0.9;
constexpr double kGrowth = 5;         ///< of the residual in one step, early on
constexpr double kAcceptable = 1e-2;  ///< acceleration left [m/s^2, rad/s^2]
constexpr double kAcceptableOnTheWay = 0.2;
constexpr int kMaxHalvings = 5;  ///< of the way to the next place

double ThreadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Matrix3d Axes(const rail::TrackFrame& f) {
  Matrix3d axes;
  for (int i = 0; i < 3; ++i) {
    const size_t k = static_cast<size_t>(i);
    axes(i, 0) = f.forward[k];
    axes(i, 1) = f.left[k];
    axes(i, 2) = f.up[k];
  }
  return axes;
}
Vector3d Origin(const rail::TrackFrame& f) { return {f.origin[0], f.origin[1], f.origin[2]}; }

/// Rotation vector that takes one attitude to the other, world axes.
Vector3d Turn(const Matrix3d& from, const Matrix3d& to) {
  const Eigen::AngleAxisd rotation(Matrix3d(to * from.transpose()));
  return rotation.angle() * rotation.axis();
}
Matrix3d Attitude(const mjData* d, int body) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(d->xmat + 9 * body);
}

/// The vehicle's only free root, which turns with the track frame at its own place.
class TrackFollower {
 public:
  TrackFollower(const mjModel* m, const rail::Track& track, int joint)
      : m_(m), track_(track), qpos_(m->jnt_qposadr[joint]), dof_(m->jnt_dofadr[joint]) {}

  int dof() const { return dof_; }

  /// Keeps the root's place relative to the track frame while that moves to arc length s.
  void MoveTo(double s, mjData* d) const {
    const rail::TrackFrame from = track_.FrameAt(s_);
    const rail::TrackFrame to = track_.FrameAt(s);
    const Matrix3d turn = Axes(to) * Axes(from).transpose();
    Eigen::Map<Vector3d> place(d->qpos + qpos_);
    place = Origin(to) + turn * (place - Origin(from));
    const Eigen::Quaterniond q(turn);
    mjtNum delta[4] = {q.w(), q.x(), q.y(), q.z()}, old[4];
    mju_copy4(old, d->qpos + qpos_ + 3);
    mju_mulQuat(d->qpos + qpos_ + 3, delta, old);
    mju_normalize4(d->qpos + qpos_ + 3);
    Measure(s);
  }

  /// Places the follower at the root's own arc length.
  void Start(const mjData* d) {
    const mjtNum* p = d->qpos + qpos_;
    Measure(track_.Project({p[0], p[1], p[2]}));
  }

  /// Speeds of the root and expected accelerations at forward speed V. Suspension: all zero.
  void Follow(double speed, mjData* d, VectorXd* expected) const {
    const Eigen::Map<const Vector3d> place(d->qpos + qpos_);
    const Vector3d offset = axes_[1].transpose() * (place - origin_[1]);
    const Vector3d before = origin_[0] + axes_[0] * offset;
    const Vector3d after = origin_[2] + axes_[2] * offset;
    const Vector3d here = origin_[1] + axes_[1] * offset;
    const double h = kFrameStep;
    Eigen::Map<Vector3d>(d->qvel + dof_) = speed * (after - before) / (2 * h);
    expected->segment<3>(dof_) = speed * speed * (after - 2 * here + before) / (h * h);
    mjtNum body[9];
    mju_quat2Mat(body, d->qpos + qpos_ + 3);
    const Matrix3d to_body =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(body).transpose();
    Eigen::Map<Vector3d>(d->qvel + dof_ + 3) = to_body * (speed * turn_);
    expected->segment<3>(dof_ + 3) = to_body * (speed * speed * bend_);
  }

  /// The root already stands at s.
  void Stand(double s) const { Measure(s); }

  Vector3d forward() const { return axes_[1].col(0); }
  double s() const { return s_; }

 private:
  void Measure(double s) const {
    s_ = s;
    for (int i = 0; i < 3; ++i) {
      const rail::TrackFrame f = track_.FrameAt(s + (i - 1) * kFrameStep);
      axes_[i] = Axes(f);
      origin_[i] = Origin(f);
    }
    const Vector3d first = Turn(axes_[0], axes_[1]) / kFrameStep;
    const Vector3d second = Turn(axes_[1], axes_[2]) / kFrameStep;
    turn_ = 0.5 * (first + second);
    bend_ = (second - first) / kFrameStep;
  }

  const mjModel* m_;
  const rail::Track& track_;
  int qpos_;
  int dof_;
  mutable double s_ = 0;
  mutable Matrix3d axes_[3];  ///< before, at and after s
  mutable Vector3d origin_[3];
  mutable Vector3d turn_;  ///< rotation per metre, world [rad/m]
  mutable Vector3d bend_;  ///< its change per metre [rad/m^2]
};

/// The quasi-static problem at one place of the track.
class SteadyProblem {
 public:
  SteadyProblem(vehicle::Simulation* simulation, int joint)
      : m_(simulation->mutable_model()),
        binding_(simulation->binding()),
        data_(mj_makeData(m_)),
        follower_(m_, binding_.track(), joint) {
    std::vector<char> solved(static_cast<size_t>(m_->nv), 1);
    for (const plugin::WheelsetBinding& w : binding_.wheelsets()) {
      solved[static_cast<size_t>(w.spin_dof)] = 0;
      spins_.push_back(w.spin_dof);
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

  /// Goes on to arc length s of the root, in shorter steps where one is too long for Newton;
  /// returns the largest acceleration left there.
  double AdvanceTo(double s, double tolerance, double acceptable) {
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

  mjData* data() { return data_.get(); }
  double s() const { return follower_.s(); }
  double speed() const { return speed_; }
  long evaluations() const { return evaluations_; }

 private:
  /// Solves at arc length s of the root in one go; returns the largest acceleration left.
  double SolveAt(double s, double tolerance) {
    elapsed_ = std::max((s - follower_.s()) / speed_, 1e-3);
    MoveVehicle(s);
    base_.assign(data_->qpos, data_->qpos + m_->nq);
    const double left = Newton(tolerance);
    KeepStates();
    return left;
  }

  /// A place that is solved, to come back to.
  struct Saved {
    std::vector<mjtNum> position, states;
    std::vector<double> spin_speed, lengths;
    double s = 0, speed = 0;
  };
  Saved Save() const {
    return {
        {data_->qpos, data_->qpos + m_->nq}, states_, spin_speed_, lengths_, follower_.s(), speed_};
  }
  void Restore(const Saved& saved) {
    mju_copy(data_->qpos, saved.position.data(), m_->nq);
    states_ = saved.states;
    spin_speed_ = saved.spin_speed;
    lengths_ = saved.lengths;
    speed_ = saved.speed;
    mju_copy(data_->act, states_.data(), m_->na);
    follower_.Stand(saved.s);
    mj_kinematics(m_, data_.get());
  }

  int unknowns() const { return static_cast<int>(positions_.size() + spins_.size()) + 1; }

  /// Sets `move` (positions, spins, speed) on top of the base and evaluates the residual: missing
  /// accelerations, and the shift along the track, which must stay zero.
  VectorXd Evaluate(const VectorXd& move) {
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
    follower_.Follow(speed_ + move[unknowns() - 1], d, &expected);
    AdvanceStates();
    mj_forward(m_, d);
    ++evaluations_;
    VectorXd r(unknowns());
    r.head(m_->nv) = Eigen::Map<const VectorXd>(d->qacc, m_->nv) - expected;
    r[m_->nv] = follower_.forward().dot(tangent.segment<3>(follower_.dof()));
    return r;
  }

  /// Takes the vehicle to arc length s with every wheelset as it lay in the track under it: wheels
  /// are so stiff on their rails that a wheelset off by a millimetre is far from any solution. The
  /// suspension takes up the rest, in the least-squares sense.
  void MoveVehicle(double s) {
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

  /// Hydraulic and friction states after the motion since the last place at its running time.
  void AdvanceStates() {
    if (binding_.phs().empty()) return;
    mjData* d = data_.get();
    mj_kinematics(m_, d);
    mj_comPos(m_, d);
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
  template <typename Number>
  Number& StateOf(const plugin::PhsBinding& p, int index, Number* act) const {
    return act[p.state_actuator[static_cast<size_t>(index)] - (m_->nu - m_->na)];
  }
  void KeepStates() {
    states_.assign(data_->act, data_->act + m_->na);
    lengths_.clear();
    for (const plugin::PhsBinding& p : binding_.phs()) {
      for (const int a : p.cylinder) lengths_.push_back(data_->actuator_length[a]);
    }
  }

  MatrixXd Jacobian(const VectorXd& r) {
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

  /// Takes over a move: base and speeds are then those of the accepted iterate.
  void Accept(const VectorXd& move) {
    base_.assign(data_->qpos, data_->qpos + m_->nq);
    const int np = static_cast<int>(positions_.size());
    for (size_t i = 0; i < spins_.size(); ++i) spin_speed_[i] += move[np + static_cast<int>(i)];
    speed_ += move[unknowns() - 1];
  }

  double Newton(double tolerance) {
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
      const double largest =
          step.head(static_cast<int>(positions_.size())).lpNorm<Eigen::Infinity>();
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

  mjModel* m_;
  const plugin::Binding& binding_;
  vehicle::DataPtr data_;
  TrackFollower follower_;
  std::vector<int> positions_;  ///< dofs whose position is solved for
  std::vector<int> spins_;      ///< dofs whose speed is solved for
  std::vector<double> spin_speed_;
  double speed_ = 0;             ///< forward [m/s]
  double elapsed_ = 1;           ///< running time since the last place [s]
  std::vector<mjtNum> base_;     ///< position that moves start from
  std::vector<mjtNum> states_;   ///< activations at the last place
  std::vector<double> lengths_;  ///< of the cylinders there [m]
  long evaluations_ = 0;
};

/// Arc lengths to solve at, on the way to the place in the first arc. Empty without an arc.
std::vector<double> Places(const rail::Track& track, double start,
                           const SteadyCurveOptions& options) {
  std::vector<double> places;
  for (const rail::TrackSection& section : track.sections()) {
    const bool arc = section.kind == "curve";
    const double begin = std::max(section.begin_s, start);
    const double end =
        arc ? section.begin_s + options.place_in_arc * (section.end_s - section.begin_s)
            : section.end_s;
    if (end <= begin) continue;
    const int count = arc                            ? options.arc_places
                      : section.kind == "transition" ? options.transition_places
                                                     : 1;
    for (int i = 1; i <= count; ++i) places.push_back(begin + (end - begin) * i / count);
    if (arc) return places;
  }
  return {};
}

/// The observed channels at the one place as a run of one row, for the summary of the steady curve.
nlohmann::ordered_json Describe(const vehicle::Simulation& simulation, const mjData* d) {
  const plugin::Observer observer(simulation.model(), simulation.binding());
  vehicle::RunOutcome run;
  run.channels = observer.channels();
  std::vector<double> row(run.channels.size());
  observer.Observe(simulation.model(), d, row.data());
  for (const double value : row) run.columns.push_back({value});
  return vehicle::Summarise(simulation, run)["steady_curve"];
}

}  // namespace

Result<SteadyCurve> SolveSteadyCurve(vehicle::Simulation* simulation,
                                     const SteadyCurveOptions& options) {
  const mjModel* m = simulation->model();
  const plugin::Binding& binding = simulation->binding();
  int root = -1;
  int roots = 0;
  for (int j = 0; j < m->njnt; ++j) {
    if (m->jnt_type[j] != mjJNT_FREE) continue;
    root = j;
    ++roots;
  }
  bool driven = binding.target_speed() > 0;
  for (const auto& w : binding.wheelsets()) driven = driven && w.drive_actuator >= 0;
  if (roots != 1 || !driven) {
    return Error{simulation->scenario().bogie, "has no steady state to solve for",
                 "one free root and a drive on every wheelset", "run it in time: phs simulate"};
  }
  const double begin = ThreadSeconds();
  SteadyProblem problem(simulation, root);
  SteadyCurve result;
  const std::vector<double> places = Places(binding.track(), problem.s(), options);
  for (const double place : places) {
    const double acceptable = place == places.back() ? kAcceptable : kAcceptableOnTheWay;
    result.residual = problem.AdvanceTo(place, options.tolerance, acceptable);
    ++result.places;
    if (result.residual < acceptable) continue;
    return Error{simulation->scenario().bogie + " on " + binding.track().name(),
                 "has no steady state that Newton's method finds (at s = " + std::to_string(place) +
                     " m accelerations of " + std::to_string(result.residual) + " are left)",
                 "", "run it in time: phs simulate"};
  }
  if (result.places == 0) {
    return Error{"track '" + binding.track().name() + "'", "has no circular arc", "a curve", ""};
  }
  result.processor_s = ThreadSeconds() - begin;
  result.speed_m_s = problem.speed();
  result.evaluations = problem.evaluations();
  result.steady = Describe(*simulation, problem.data());
  return result;
}

nlohmann::ordered_json CurveTotals(const nlohmann::ordered_json& steady) {
  double t_gamma = 0, largest_y = 0, largest_ratio = 0;
  for (const auto& wheel : steady["wheels"]) {
    t_gamma += wheel["T_gamma_N"].get<double>();
    largest_y = std::max(largest_y, std::abs(wheel["Y_N"].get<double>()));
    if (wheel["Y_over_Q"].is_number()) {
      largest_ratio = std::max(largest_ratio, std::abs(wheel["Y_over_Q"].get<double>()));
    }
  }
  return {{"T_gamma_N", t_gamma}, {"largest_Y_N", largest_y}, {"largest_Y_over_Q", largest_ratio}};
}

}  // namespace phs::analysis
