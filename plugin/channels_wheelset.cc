// Channels of each wheelset.
#include "plugin/active_steering.h"
#include "plugin/channels.h"

namespace phs::plugin {
namespace {

const WheelsetState& State(const Instant& at, ChannelPlace place) {
  return at.wheelsets[static_cast<size_t>(place.index)];
}

int YawJoint(const Instant& at, ChannelPlace place) {
  return at.binding->wheelsets()[static_cast<size_t>(place.index)].yaw_joint;
}

/// Guiding force Y of a wheel, as in channels_wheel.cc.
double Y(const WheelsetState& state, rail::Side side) {
  return -state.wheel[static_cast<int>(side)].force[1];
}

/// Spin times tape circle radius over speed, less 1.
double Slip(const Instant& at, ChannelPlace place) {
  const WheelsetState& state = State(at, place);
  if (!(state.speed > 0)) return 0;
  return state.spin * at.binding->wheel_rail().params().wheel_radius / state.speed - 1;
}

/// Moment of the wheel-rail forces about the axis of the yaw joint, as the other moments are, so that their
/// sum is what turns the axle; without such a joint about the track's normal.
double WheelRailMoment(const Instant& at, ChannelPlace place) {
  const WheelsetState& state = State(at, place);
  const int joint = YawJoint(at, place);
  if (joint < 0) return state.moment_T[2];
  const mjtNum* axis = at.d->xaxis + 3 * joint;
  const mjtNum* anchor = at.d->xanchor + 3 * joint;
  mjtNum arm[3], moment[3];
  mju_sub3(arm, state.centre.data(), anchor);
  mju_cross(moment, arm, state.force.data());
  mju_addTo3(moment, state.moment.data());
  return mju_dot3(moment, axis);
}

/// Moment of springs, dampers, linkages and servos on the yaw joint.
double PrimaryMoment(const Instant& at, ChannelPlace place) {
  const int joint = YawJoint(at, place);
  if (joint < 0) return 0;
  double moment = -0.0;  // so that a single part keeps its sign at zero
  for (const auto& elements : at.binding->elements()) {
    elements->AddForceOnDof(at.m, at.d, at.binding->Joints(at.m, at.d), at.m->jnt_dofadr[joint],
                            &moment);
  }
  ForEachSteering(at.m, [&](const ActiveSteering& servo) {
    const int dof = at.m->jnt_dofadr[joint];
    moment += at.d->actuator_force[servo.actuator] *
              at.d->actuator_moment[servo.actuator * at.m->nv + dof];
  });
  return moment;
}

/// Yaw moment on the wheelset from a part of every cylinder's force.
template <typename Part>
double CylinderMoment(const Instant& at, ChannelPlace place, Part part) {
  const int joint = YawJoint(at, place);
  double moment = 0;
  if (joint < 0) return moment;
  const int dof = at.m->jnt_dofadr[joint];
  for (size_t k = 0; k < at.phs.size(); ++k) {
    const std::vector<int>& cylinder = at.binding->phs()[k].cylinder;
    double of_phs = 0;
    for (size_t i = 0; i < cylinder.size(); ++i) {
      const double arm = -at.d->actuator_moment[cylinder[i] * at.m->nv + dof];
      of_phs += arm * part(at.phs[k], i);
    }
    moment += of_phs;
  }
  return moment;
}

double FrictionMoment(const Instant& at, ChannelPlace place) {
  return CylinderMoment(at, place,
                        [](const PhsState& phs, size_t i) { return phs.friction_force[i]; });
}

double PressureMoment(const Instant& at, ChannelPlace place) {
  return CylinderMoment(at, place, [](const PhsState& phs, size_t i) {
    return phs.force[i] - phs.friction_force[i];
  });
}

constexpr ChannelRow kRows[] = {
    {"lateral_m", "m", "offset of the centre from the track centre line, > 0 left",
     [](const Instant& at, ChannelPlace of) { return State(at, of).lateral; }},
    {"angle_of_attack_rad", "rad", "yaw against the radial direction of the track",
     [](const Instant& at, ChannelPlace of) { return State(at, of).yaw; }},
    {"yaw_rad", "rad", "yaw against the bogie frame",
     [](const Instant& at, ChannelPlace of) { return at.Joint(YawJoint(at, of)); }},
    {"sum_Y_N", "N", "lateral force of both wheels on the track, > 0 right",
     [](const Instant& at, ChannelPlace of) {
       return Y(State(at, of), rail::Side::kRight) - Y(State(at, of), rail::Side::kLeft);
     }},
    {"X_N", "N", "longitudinal force of both rails on the wheelset, > 0 forward",
     [](const Instant& at, ChannelPlace of) {
       return State(at, of).wheel[0].force[0] + State(at, of).wheel[1].force[0];
     }},
    {"slip", "1", "spin times tape circle radius over speed, less 1; > 0 driving", &Slip},
    {"steering_moment_Nm", "N m", "moment of the wheel-rail forces about the axis of the yaw joint",
     &WheelRailMoment},
    {"primary_moment_Nm", "N m", "yaw moment of the primary suspension, links and servos",
     &PrimaryMoment},
    {"phs_pressure_moment_Nm", "N m", "yaw moment of the cylinder pressures", &PressureMoment},
    {"phs_friction_moment_Nm", "N m", "yaw moment of the cylinder friction", &FrictionMoment},
    {"x_m", "m", "world position of the centre",
     [](const Instant& at, ChannelPlace of) { return State(at, of).centre[0]; }},
    {"y_m", "m", "world position of the centre",
     [](const Instant& at, ChannelPlace of) { return State(at, of).centre[1]; }},
    {"heading_rad", "rad", "heading of the wheelset in the world",
     [](const Instant& at, ChannelPlace of) {
       return State(at, of).frame.heading + State(at, of).yaw;
     }},
};

}  // namespace

std::span<const ChannelRow> WheelsetChannels() { return kRows; }

}  // namespace phs::plugin
