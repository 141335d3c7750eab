#include "plugin/settle.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>

#include "plugin/model_text.h"

namespace phs::plugin {
namespace {

using DataPtr = std::unique_ptr<mjData, decltype(&mj_deleteData)>;

constexpr double kStep = 1e-7;       ///< of the finite differences [m, rad]
constexpr double kTolerance = 1e-7;  ///< of the accelerations left [m/s^2, rad/s^2]
constexpr int kMaxIterations = 60;
constexpr double kStands = 1e-2;  ///< acceleration left to a vehicle that stands [m/s^2, rad/s^2]
constexpr double kOnRails =
    0.05;  ///< a wheelset farther off the track's line stands beside the rails [m]
constexpr double kFirstSinking =
    1e-4;  ///< start below mere touching, so that wheels carry load [m]

/// True for the slide along x of a root: a vehicle guided along straight track.
bool IsForwardSlide(const mjModel* m, int joint) {
  return m->jnt_type[joint] == mjJNT_SLIDE && m->body_parentid[m->jnt_bodyid[joint]] == 0 &&
         m->jnt_axis[3 * joint] == 1;
}

/// Middle of both rails beside the track's own line, by its irregularity.
rail::RailOffset MiddleOfRails(const rail::Track& track, double s) {
  const rail::RailOffset left = track.Rail(rail::Side::kLeft, s),
                         right = track.Rail(rail::Side::kRight, s);
  rail::RailOffset middle;
  middle.lateral = 0.5 * (left.lateral + right.lateral);
  middle.vertical = 0.5 * (left.vertical + right.vertical);
  return middle;
}

/// Moves the free roots so that the vehicle stands on the track at its start, rolling at speed: on
/// the track's own line, or in the `middle` of its rails as they lie there.
void PlaceVehicle(const mjModel* m, const Binding& binding, bool middle, mjData* d) {
  mj_resetData(m, d);
  mj_kinematics(m, d);
  const double wheel_height = -binding.wheel_rail().touching_height();
  double rearmost = 1e300;
  double sink = 1e300;
  for (const WheelsetBinding& w : binding.wheelsets()) {
    rearmost = std::min(rearmost, d->xpos[3 * w.body]);
    sink = std::min(sink, wheel_height - d->xpos[3 * w.body + 2]);
  }
  const double speed = std::max(binding.target_speed(), 0.0);
  for (int j = 0; j < m->njnt; ++j) {
    if (IsForwardSlide(m, j)) {
      d->qpos[m->jnt_qposadr[j]] += binding.start_s() - rearmost;
      d->qvel[m->jnt_dofadr[j]] = speed;
    }
    if (m->jnt_type[j] != mjJNT_FREE) continue;
    mjtNum* q = d->qpos + m->jnt_qposadr[j];
    const rail::TrackFrame f = binding.track().FrameAt(binding.start_s() + q[0] - rearmost);
    double y = q[1];
    double z = q[2] + sink - kFirstSinking;
    if (middle) {
      const auto& wheelsets = binding.wheelsets();
      for (const WheelsetBinding& w : wheelsets) {
        const double s = binding.start_s() + d->xpos[3 * w.body] - rearmost;
        const rail::RailOffset own = MiddleOfRails(binding.track(), s);
        y += own.lateral / static_cast<double>(wheelsets.size());
        z += own.vertical / static_cast<double>(wheelsets.size());
      }
    }
    mjtNum rotation[9];
    for (int i = 0; i < 3; ++i) {
      q[i] = f.origin[i] + y * f.left[i] + z * f.up[i];
      rotation[3 * i] = f.forward[i];
      rotation[3 * i + 1] = f.left[i];
      rotation[3 * i + 2] = f.up[i];
    }
    mjtNum track_quat[4], own[4] = {q[3], q[4], q[5], q[6]};
    mju_mat2Quat(track_quat, rotation);
    mju_mulQuat(q + 3, track_quat, own);
    mju_scl3(d->qvel + m->jnt_dofadr[j], f.forward.data(), speed);
  }
  for (const WheelsetBinding& w : binding.wheelsets()) {
    d->qvel[w.spin_dof] = speed / binding.wheel_rail().params().wheel_radius;
  }
}

/// Dofs that settle: all but spins and the forward motion of free roots.
std::vector<int> SettlingDofs(const mjModel* m, const Binding& binding) {
  std::vector<char> settles(m->nv, 1);
  for (const WheelsetBinding& w : binding.wheelsets()) settles[w.spin_dof] = 0;
  for (int j = 0; j < m->njnt; ++j) {
    if (m->jnt_type[j] == mjJNT_FREE || IsForwardSlide(m, j)) settles[m->jnt_dofadr[j]] = 0;
  }
  std::vector<int> dofs;
  for (int i = 0; i < m->nv; ++i) {
    if (settles[i]) dofs.push_back(i);
  }
  return dofs;
}

/// Accelerations along `dofs` with the oil at rest, too.
Eigen::VectorXd Residual(const mjModel* m, const Binding& binding, const std::vector<int>& dofs,
                         mjData* d) {
  binding.SettleChambers(m, d);
  mj_forward(m, d);
  Eigen::VectorXd r(dofs.size());
  for (size_t i = 0; i < dofs.size(); ++i) r[i] = d->qacc[dofs[i]];
  return r;
}

/// qpos = base moved by `move` along `dofs`.
void Move(const mjModel* m, const Eigen::VectorXd& base, const std::vector<int>& dofs,
          const Eigen::VectorXd& move, mjData* d) {
  Eigen::VectorXd full = Eigen::VectorXd::Zero(m->nv);
  for (size_t i = 0; i < dofs.size(); ++i) full[dofs[i]] = move[i];
  mju_copy(d->qpos, base.data(), m->nq);
  mj_integratePos(m, d->qpos, full.data(), 1.0);
}

/// Newton with step halving. Returns the largest acceleration left.
double Settle(const mjModel* m, const Binding& binding, const std::vector<int>& dofs, mjData* d) {
  const int n = static_cast<int>(dofs.size());
  Eigen::VectorXd base = Eigen::Map<Eigen::VectorXd>(d->qpos, m->nq);
  Eigen::VectorXd r = Residual(m, binding, dofs, d);
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    if (r.lpNorm<Eigen::Infinity>() < kTolerance) break;
    Eigen::MatrixXd jacobian(n, n);
    for (int k = 0; k < n; ++k) {
      Eigen::VectorXd probe = Eigen::VectorXd::Zero(n);
      probe[k] = kStep;
      Move(m, base, dofs, probe, d);
      const Eigen::VectorXd plus = Residual(m, binding, dofs, d);
      Move(m, base, dofs, -probe, d);
      jacobian.col(k) = (plus - Residual(m, binding, dofs, d)) / (2 * kStep);
    }
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(1e-9);
    solver.compute(jacobian);
    Eigen::VectorXd step = solver.solve(-r);
    const double largest = step.lpNorm<Eigen::Infinity>();
    if (largest > 5e-3) step *= 5e-3 / largest;
    double scale = 1;
    Eigen::VectorXd next = r;
    for (int halving = 0; halving < 12; ++halving, scale /= 2) {
      Move(m, base, dofs, scale * step, d);
      next = Residual(m, binding, dofs, d);
      if (next.norm() < r.norm()) break;
    }
    if (next.norm() >= r.norm()) {
      Move(m, base, dofs, Eigen::VectorXd::Zero(n), d);
      Residual(m, binding, dofs, d);
      break;
    }
    base = Eigen::Map<Eigen::VectorXd>(d->qpos, m->nq);
    r = next;
  }
  return r.lpNorm<Eigen::Infinity>();
}

/// Spin speeds at which no wheelset is driven or braked by its creep forces (secant per wheelset).
void RollFreely(const mjModel* m, const Binding& binding, mjData* d) {
  for (int iteration = 0; iteration < 8; ++iteration) {
    for (const WheelsetBinding& w : binding.wheelsets()) {
      constexpr double kSpinStep = 1e-5;
      const double spin = d->qvel[w.spin_dof];
      mj_forward(m, d);
      const double here = d->qfrc_passive[w.spin_dof];
      d->qvel[w.spin_dof] = spin + kSpinStep;
      mj_forward(m, d);
      const double slope = (d->qfrc_passive[w.spin_dof] - here) / kSpinStep;
      d->qvel[w.spin_dof] = slope < 0 ? spin - here / slope : spin;
    }
  }
}

void StoreStart(mjModel* m, const mjData* d) {
  const int key = mj_name2id(m, mjOBJ_KEY, "test");
  if (key < 0) return;
  mju_copy(m->key_qpos + key * m->nq, d->qpos, m->nq);
  mju_copy(m->key_qvel + key * m->nv, d->qvel, m->nv);
  if (m->na > 0) mju_copy(m->key_act + key * m->na, d->act, m->na);
}

}  // namespace

Status PrepareStart(mjModel* m, const Binding& binding) {
  if (!binding.has_rail()) return {};
  const InstantForces instant(m);
  const DataPtr data(mj_makeData(m), &mj_deleteData);
  const std::vector<int> dofs = SettlingDofs(m, binding);
  double left = 0;
  bool stands = false;
  // Position and spin in turn. Where the nominal speed drags the wheels hard (gauge or tread far
  // from new) Newton may stop beside the way: then the wheels roll freely from the beginning.
  // Rough track may lie so far beside its line that flanges stand on the rails: then the vehicle
  // begins in the middle of them.
  for (const auto& [middle, roll_first] :
       {std::pair{false, false}, {false, true}, {true, false}, {true, true}}) {
    if (middle && !binding.track().has_irregularity()) break;
    PlaceVehicle(m, binding, middle, data.get());
    if (roll_first) RollFreely(m, binding, data.get());
    Settle(m, binding, dofs, data.get());
    RollFreely(m, binding, data.get());
    left = Settle(m, binding, dofs, data.get());
    stands = left < kStands && data->userdata[UserData::kMaxLateral] < kOnRails;
    if (stands) break;
  }
  if (!stands) {
    return Error{
        ObjectName(m, mjOBJ_BODY, m->body_rootid[binding.wheelsets()[0].body]),
        "does not come to rest on the rails of track '" + binding.track().name() +
            "' (acceleration left: " + std::to_string(left) + ")",
        "wheelsets that stand on straight, level track at the start",
        binding.track().has_irregularity()
            ? "let the irregularity begin ahead of the vehicle (begin_s_m), or check wheel "
              "radius, flange-back distance, gauge and start position"
            : "check wheel radius, flange-back distance, gauge and start position"};
  }
  StoreStart(m, data.get());
  return {};
}

void ResetToStart(const mjModel* m, mjData* d) {
  const int key = mj_name2id(m, mjOBJ_KEY, "test");
  if (key >= 0) {
    mj_resetDataKeyframe(m, d, key);
  } else {
    mj_resetData(m, d);
  }
}

}  // namespace phs::plugin
