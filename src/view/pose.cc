#include "view/pose.h"

#include <algorithm>
#include <cmath>

#include "view/shapes.h"

namespace phs::view {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using rail::Side;

constexpr int kSteps = 6;
constexpr double kCompliance = 1e-13;  ///< of what was recorded [m/N]
constexpr double kSoftest = 1.0;       ///< stiffness where a freedom has none [N/m]

/// Height of the centre and roll at which a wheelset rests on both rails, T axes.
struct Rest {
  double height = 0, roll = 0;
};

Rest RestOnRails(const rail::WheelRail& wheel_rail, const rail::Track& track, double s,
                 double lateral, double yaw) {
  Rest rest{wheel_rail.params().wheel_radius, 0};
  if (wheel_rail.wheel_profile() == nullptr) return rest;
  for (int i = 0; i < 5; ++i) {
    double height[2] = {};
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const rail::RailOffset offset = track.Rail(side, s);
      const rail::Vec3 place = rail::MirrorPolar({0, lateral - offset.lateral, 0}, side);
      const rail::Vec3 attitude = rail::MirrorAxial({rest.roll, 0, yaw}, side);
      const rail::TouchPoint touch = wheel_rail.Touch(place[1], attitude[0], attitude[2]);
      const double own = touch.found ? -touch.height : wheel_rail.params().wheel_radius;
      height[static_cast<int>(side)] = own + offset.vertical;
    }
    rest.height = 0.5 * (height[0] + height[1]);
    // Rolling left up lowers the centre for the left wheel and raises it for the right one.
    rest.roll += (height[0] - height[1]) / (2 * wheel_rail.wheel_position());
  }
  return rest;
}

int TendonOf(const mjModel* m, int actuator) {
  return m->actuator_trntype[actuator] == mjTRN_TENDON ? m->actuator_trnid[2 * actuator] : -1;
}

}  // namespace

std::string PhsChannel(const plugin::Binding& binding, size_t phs, const std::string& name) {
  return binding.phs().size() > 1 ? binding.phs()[phs].name + "_" + name : name;
}

Poser::Poser(mjModel* m, const plugin::Binding& binding, const Recording& recording)
    : m_(m), binding_(binding), recording_(recording), is_spin_(static_cast<size_t>(m->nv), 0) {
  const auto find = [&](const std::string& name) { return recording.Find(name); };
  for (const plugin::WheelsetBinding& w : binding.wheelsets()) {
    wheelsets_.push_back({w.body, m->dof_jntid[w.spin_dof], w.yaw_joint, find(w.name + "_x_m"),
                          find(w.name + "_y_m"), find(w.name + "_lateral_m"),
                          find(w.name + "_angle_of_attack_rad"), find(w.name + "_yaw_rad")});
    is_spin_[static_cast<size_t>(w.spin_dof)] = 1;
  }
  for (size_t p = 0; p < binding.phs().size(); ++p) {
    const plugin::PhsBinding& phs = binding.phs()[p];
    for (size_t i = 0; i < phs.cylinder.size(); ++i) {
      const std::string name = "cylinder_" + phs.system->cylinder_names()[i] + "_force_N";
      cylinders_.push_back({TendonOf(m, phs.cylinder[i]), find(PhsChannel(binding, p, name))});
    }
  }
  speed_ = find("speed_m_s");
  curvature_ = find("curvature_1_m");
}

Poser::Place Poser::PlaceOf(const Wheelset& wheelset, const Moment& at) const {
  const rail::Track& track = binding_.track();
  const double radius = binding_.wheel_rail().params().wheel_radius;
  Vector3d point(recording_.Value(wheelset.x, at), recording_.Value(wheelset.y, at), radius);
  const double lateral = recording_.Value(wheelset.lateral, at);
  const double yaw = recording_.Value(wheelset.attack, at);
  rail::TrackFrame frame;
  Rest rest;
  // The height is not recorded: twice, so that the point lies where the wheelset's centre lies.
  for (int i = 0; i < 2; ++i) {
    frame = track.FrameAt(track.Project({point.x(), point.y(), point.z()}));
    if (i == 0) rest = RestOnRails(binding_.wheel_rail(), track, frame.s, lateral, yaw);
    point.z() =
        (ToEigen(frame.origin) + ToEigen(frame.left) * lateral + ToEigen(frame.up) * rest.height)
            .z();
  }
  Place place;
  place.s = frame.s;
  place.centre =
      ToEigen(frame.origin) + ToEigen(frame.left) * lateral + ToEigen(frame.up) * rest.height;
  const Vector3d level =
      ToEigen(frame.left) * std::cos(yaw) - ToEigen(frame.forward) * std::sin(yaw);
  place.axle = level * std::cos(rest.roll) + ToEigen(frame.up) * std::sin(rest.roll);
  place.forward = ToEigen(frame.forward);
  place.up = ToEigen(frame.up);
  return place;
}

void Poser::Start(const std::vector<Place>& places, mjData* d) const {
  mju_copy(d->qpos, m_->qpos0, m_->nq);
  mju_zero(d->qvel, m_->nv);
  if (m_->njnt == 0 || m_->jnt_type[0] != mjJNT_FREE) return;
  // Root: between the wheelsets, its axes along the track there.
  Vector3d middle = Vector3d::Zero();
  Vector3d axle = Vector3d::Zero();
  Vector3d up = Vector3d::Zero();
  double rest_height = 0;
  for (size_t i = 0; i < places.size(); ++i) {
    const double share = 1.0 / static_cast<double>(places.size());
    middle += share * places[i].centre;
    axle += share * places[i].axle;
    up += share * places[i].up;
    rest_height += share * binding_.wheel_rail().params().wheel_radius;
  }
  Eigen::Matrix3d turn;
  turn.col(1) = axle.normalized();
  turn.col(0) = axle.cross(up).normalized();
  turn.col(2) = turn.col(0).cross(turn.col(1));
  const Eigen::Quaterniond q(turn);
  const Vector3d root = middle + turn.col(2) * (m_->qpos0[2] - rest_height);
  for (int i = 0; i < 3; ++i) d->qpos[i] = root[i];
  d->qpos[3] = q.w();
  d->qpos[4] = q.x();
  d->qpos[5] = q.y();
  d->qpos[6] = q.z();
}

VectorXd Poser::Forces(const Moment& at, mjData* d) const {
  const int nv = m_->nv;
  VectorXd force(nv);
  for (int i = 0; i < nv; ++i) force[i] = d->qfrc_passive[i] - d->qfrc_bias[i];
  for (const Cylinder& cylinder : cylinders_) {
    if (cylinder.tendon < 0 || cylinder.force < 0) continue;
    const double tension = recording_.Value(cylinder.force, at);
    const mjtNum* slope = d->ten_J + cylinder.tendon * nv;
    for (int i = 0; i < nv; ++i) force[i] -= tension * slope[i];
  }
  return force;
}

MatrixXd Poser::Stiffness(const mjData* d) const {
  const int nv = m_->nv;
  MatrixXd k = MatrixXd::Zero(nv, nv);
  for (int i = 0; i < nv; ++i) k(i, i) = kSoftest + m_->jnt_stiffness[m_->dof_jntid[i]];
  for (int t = 0; t < m_->ntendon; ++t) {
    if (m_->tendon_stiffness[t] == 0) continue;
    const Eigen::Map<const VectorXd> slope(d->ten_J + t * nv, nv);
    k += m_->tendon_stiffness[t] * slope * slope.transpose();
  }
  return k;
}

void Poser::Step(const std::vector<Place>& places, const Moment& at, mjData* d) const {
  const int nv = m_->nv;
  std::vector<VectorXd> rows;
  std::vector<double> rests;
  const auto hold = [&](const VectorXd& row, double rest) {
    rows.push_back(row);
    rests.push_back(rest);
  };
  using RowMatrix = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;
  for (size_t w = 0; w < places.size(); ++w) {
    const Place& place = places[w];
    const int body = wheelsets_[w].body;
    RowMatrix moved(3, nv), turned(3, nv);
    mj_jacBody(m_, d, moved.data(), turned.data(), body);
    const mjtNum* r = d->xmat + 9 * body;
    const Vector3d off = place.centre - Eigen::Map<const Vector3d>(d->xpos + 3 * body);
    const Vector3d turn = Vector3d(r[1], r[4], r[7]).cross(place.axle);
    for (int k = 0; k < 3; ++k) hold(moved.row(k).transpose(), off[k]);
    for (const Vector3d& axis : {place.up, place.forward}) {
      hold(turned.transpose() * axis, turn.dot(axis));
    }
    if (wheelsets_[w].yaw_joint >= 0 && wheelsets_[w].yaw >= 0) {
      const int joint = wheelsets_[w].yaw_joint;
      hold(VectorXd::Unit(nv, m_->jnt_dofadr[joint]),
           recording_.Value(wheelsets_[w].yaw, at) - d->qpos[m_->jnt_qposadr[joint]]);
    }
  }
  for (int i = 0; i < nv; ++i) {
    if (is_spin_[static_cast<size_t>(i)] != 0) hold(VectorXd::Unit(nv, i), 0);
  }
  // Multipliers in units in which both blocks weigh alike.
  constexpr double kUnit = 1e7;
  const int held = static_cast<int>(rows.size());
  MatrixXd system = MatrixXd::Zero(nv + held, nv + held);
  VectorXd right(nv + held);
  system.topLeftCorner(nv, nv) = Stiffness(d);
  right.head(nv) = Forces(at, d);
  for (int i = 0; i < held; ++i) {
    system.block(nv + i, 0, 1, nv) = kUnit * rows[static_cast<size_t>(i)].transpose();
    system.block(0, nv + i, nv, 1) = kUnit * rows[static_cast<size_t>(i)];
    system(nv + i, nv + i) = -kCompliance * kUnit * kUnit;
    right[nv + i] = kUnit * rests[static_cast<size_t>(i)];
  }
  const VectorXd step = system.partialPivLu().solve(right);
  mj_integratePos(m_, d->qpos, step.data(), 1);
}

void Poser::Pose(const Moment& at, mjData* d) const {
  std::vector<Place> places;
  for (const Wheelset& wheelset : wheelsets_) places.push_back(PlaceOf(wheelset, at));
  Start(places, d);
  // Weight and centrifugal force, which points out of the curve.
  const double speed = recording_.Value(speed_, at);
  const Vector3d left = Vector3d::UnitZ().cross(places[0].forward).normalized();
  const Vector3d outward = -left * speed * speed * recording_.Value(curvature_, at);
  const mjtNum usual[3] = {m_->opt.gravity[0], m_->opt.gravity[1], m_->opt.gravity[2]};
  for (int i = 0; i < 3; ++i) m_->opt.gravity[i] = usual[i] + outward[i];
  for (int i = 0; i < kSteps; ++i) {
    mj_fwdPosition(m_, d);
    mj_fwdVelocity(m_, d);
    Step(places, at, d);
  }
  for (int i = 0; i < 3; ++i) m_->opt.gravity[i] = usual[i];
  const double radius = binding_.wheel_rail().params().wheel_radius;
  for (size_t w = 0; w < places.size(); ++w) {
    d->qpos[m_->jnt_qposadr[wheelsets_[w].spin_joint]] =
        std::remainder(places[w].s / radius, 2 * M_PI);
  }
  mj_fwdPosition(m_, d);
}

void Poser::StopWheels(mjData* d) const {
  for (const Wheelset& wheelset : wheelsets_) d->qpos[m_->jnt_qposadr[wheelset.spin_joint]] = 0;
  mj_kinematics(m_, d);
}

double Poser::MiddleOfVehicle(const Moment& at) const {
  double sum = 0;
  for (const Wheelset& wheelset : wheelsets_) {
    const double radius = binding_.wheel_rail().params().wheel_radius;
    sum += binding_.track().Project(
        {recording_.Value(wheelset.x, at), recording_.Value(wheelset.y, at), radius});
  }
  return sum / static_cast<double>(wheelsets_.size());
}

}  // namespace phs::view
