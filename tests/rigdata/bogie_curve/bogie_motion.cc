#include "bogie_motion.h"

#include <cmath>
#include <utility>

namespace bogie_curve {
namespace {

using Eigen::Quaterniond;

constexpr double kGravity = 9.81;
// Centres of mass above the frame's reference point, which lies at the axles' height.
constexpr double kFrameCentre = 0.1, kSpringPlane = 0.475, kBodyCentre = 0.9;  // [m]

Vector3d Rolls(const Matrix3d& relative) {
  return {std::atan2(relative(2, 1), relative(2, 2)), -std::asin(relative(2, 0)),
          std::atan2(relative(1, 0), relative(0, 0))};
}

Quaterniond Turned(const Quaterniond& from, const Vector3d& turn, double h) {
  const Quaterniond rate(0, turn.x(), turn.y(), turn.z());
  Quaterniond q = from;
  q.coeffs() += 0.5 * h * (rate * from).coeffs();
  return q;
}

// Spring between body a (whose axes it follows, at `on_a`) and body b (at `on_b`); both from the
// centres of mass in the bodies' axes.
struct SpringPlace {
  int a, b;
  Vector3d on_a, on_b;
};

void AddSpring(const SpringNumbers& n, const SpringPlace& at, const MotionState& s,
               std::array<Vector3d, kBodies>* force, std::array<Vector3d, kBodies>* moment) {
  const Matrix3d A = s.attitude[at.a].toRotationMatrix(), B = s.attitude[at.b].toRotationMatrix();
  const Vector3d arm_b = B * at.on_b;
  const Vector3d arm_a = s.place[at.b] + arm_b - s.place[at.a];  // both forces act at b's point
  const Vector3d speed =
      s.speed[at.b] + s.turn[at.b].cross(arm_b) - s.speed[at.a] - s.turn[at.a].cross(arm_a);
  Vector3d stretch = A.transpose() * arm_a - at.on_a;
  stretch.z() -= n.rest_z;
  const Vector3d f =
      A * (-n.along.cwiseProduct(stretch) - n.along_damping.cwiseProduct(A.transpose() * speed));
  const Vector3d rate = A.transpose() * (s.turn[at.b] - s.turn[at.a]);
  const Vector3d m =
      A * (-n.about.cwiseProduct(Rolls(A.transpose() * B)) - n.about_damping.cwiseProduct(rate));
  (*force)[at.b] += f;
  (*force)[at.a] -= f;
  (*moment)[at.b] += m + arm_b.cross(f);
  (*moment)[at.a] -= m + arm_a.cross(f);
}

WheelOnRail Larger(const WheelOnRail& wheel, double by) {
  WheelRailPair pair = wheel.pair();
  pair.radius += by;
  return WheelOnRail(std::move(pair));
}

// What one box's springs have beyond those of the guidance: half of it sits in either box.
SpringNumbers BeyondGuidance(const SpringNumbers& guidance, double factor) {
  SpringNumbers out;
  out.along = 0.5 * (factor - 1) * guidance.along;
  out.rest_z = guidance.rest_z;
  return out;
}

}  // namespace

BogieMotion::BogieMotion(BogieNumbers numbers, const TrackLine& track, WheelOnRail wheel,
                         SteeringOil oil)
    : numbers_(std::move(numbers)),
      track_(track),
      wheel_(std::move(wheel)),
      odd_wheel_(Larger(wheel_, numbers_.wheel_larger)),
      oil_(std::move(oil)) {}

MotionState BogieMotion::Start() const {
  const double r = wheel_.pair().radius, half = numbers_.wheel_base / 2;
  MotionState s;
  const Vector3d middle(numbers_.start, 0, r);
  s.place[kFrame] = middle + Vector3d(0, 0, kFrameCentre);
  s.place[kBody] = middle + Vector3d(0, 0, kSpringPlane + kBodyCentre);
  s.place[kLead] = middle + Vector3d(half, 0, 0);
  s.place[kTrail] = middle - Vector3d(half, 0, 0);
  for (int b = 0; b < kBodies; ++b) {
    s.attitude[b] = Quaterniond::Identity();
    s.speed[b] = {numbers_.speed, 0, 0};
    s.turn[b].setZero();
  }
  s.spin = {numbers_.speed / r, numbers_.speed / r};
  s.pressure = oil_.Rest();
  return s;
}

void BogieMotion::AddSprings(const MotionState& state, Rates* rates) const {
  const double half = numbers_.wheel_base / 2;
  for (const int axle : {kLead, kTrail}) {
    const double x = axle == kLead ? half : -half;
    AddSpring(numbers_.guidance, {kFrame, axle, {x, 0, -kFrameCentre}, Vector3d::Zero()}, state,
              &rates->force, &rates->moment);
  }
  if (numbers_.box_spring != 1) {
    const double b = numbers_.box_arm;
    AddSpring(BeyondGuidance(numbers_.guidance, numbers_.box_spring),
              {kFrame, kLead, {half, b, -kFrameCentre}, {0, b, 0}}, state, &rates->force,
              &rates->moment);
  }
  AddSpring(numbers_.secondary,
            {kFrame, kBody, {0, 0, kSpringPlane - kFrameCentre}, {0, 0, -kBodyCentre}}, state,
            &rates->force, &rates->moment);
}

BogieMotion::Cylinder BogieMotion::CylinderAt(const MotionState& state, int index) const {
  // 1, 2 = leading left, right; 3, 4 = trailing right, left.
  const bool lead = index < 2, left = index == 0 || index == 3;
  const double half = numbers_.wheel_base / 2, side = left ? numbers_.box_arm : -numbers_.box_arm;
  const double bracket = (lead ? 1 : -1) * (half - numbers_.cylinder);
  Cylinder c;
  c.axle = lead ? kLead : kTrail;
  c.bracket = state.attitude[kFrame] * Vector3d(bracket, side, -kFrameCentre);
  c.box = state.attitude[c.axle] * Vector3d(0, side, 0);
  const Vector3d between = state.place[c.axle] + c.box - state.place[kFrame] - c.bracket;
  const Vector3d speed = state.speed[c.axle] + state.turn[c.axle].cross(c.box) -
                         state.speed[kFrame] - state.turn[kFrame].cross(c.bracket);
  c.length = between.norm();
  c.direction = between / c.length;
  c.speed = speed.dot(c.direction);
  return c;
}

void BogieMotion::AddCylinders(const MotionState& state, Rates* rates) const {
  std::array<Cylinder, 4> cylinder;
  SteeringOil::Four speed;
  for (int i = 0; i < 4; ++i) {
    cylinder[i] = CylinderAt(state, i);
    speed[i] = cylinder[i].speed;
  }
  const SteeringOil::Four tension = oil_.Tension(state.pressure, speed, state.bristle);
  for (int i = 0; i < 4; ++i) {
    const Cylinder& c = cylinder[i];
    const Vector3d on_frame = tension[i] * c.direction;
    rates->force[kFrame] += on_frame;
    rates->moment[kFrame] += c.bracket.cross(on_frame);
    rates->force[c.axle] -= on_frame;
    rates->moment[c.axle] -= c.box.cross(on_frame);
  }
  rates->pressure = oil_.PressureRate(state.pressure, speed, state.leaking);
  rates->bristle = oil_.BristleRate(speed, state.bristle);
}

BogieMotion::OnTrack BogieMotion::RailLoads(const MotionState& state, int axle) const {
  const Vector3d& p = state.place[axle];
  OnTrack out;
  out.s = track_.Project(p, p.x());
  const LinePose pose = track_.At(out.s);
  out.axes << pose.forward, pose.left, pose.up;
  const Vector3d at = out.axes.transpose() * (p - pose.origin);
  const Matrix3d R = out.axes.transpose() * state.attitude[axle].toRotationMatrix();
  const Vector3d angle = Rolls(R), e = R.col(1);
  Vector3d turn = out.axes.transpose() * state.turn[axle];
  turn += (state.spin[static_cast<size_t>(axle - kLead)] - turn.dot(e)) * e;
  out.axle = {at.y(), at.z(),    angle.x(), angle.z(), out.axes.transpose() * state.speed[axle],
              turn,   pose.twist};
  out.load = LoadAxle(axle == kLead ? odd_wheel_ : wheel_, wheel_, out.axle);
  return out;
}

void BogieMotion::AddRails(const MotionState& state, Rates* rates) const {
  const double total = numbers_.frame_mass + numbers_.body_mass + 2 * numbers_.axle_mass;
  const double gain = total * wheel_.pair().radius / (2 * 0.5);  // half a second, two drives
  for (const int axle : {kLead, kTrail}) {
    const OnTrack rail = RailLoads(state, axle);
    const Vector3d e = state.attitude[axle] * Vector3d::UnitY();
    const Vector3d moment = rail.axes * rail.load.moment;
    const double drive = gain * (numbers_.speed - rail.axle.speed.x()), own = moment.dot(e);
    const double h = numbers_.wheelset_spin * state.spin[axle - kLead];
    rates->force[axle] += rail.axes * rail.load.force;
    rates->moment[axle] += moment - (own + drive) * e - h * state.turn[axle].cross(e);
    rates->spin[axle - kLead] = (drive + own) / (numbers_.wheelset_spin + numbers_.rotor_spin);
  }
}

BogieMotion::Rates BogieMotion::CalcRates(const MotionState& state) const {
  Rates rates;
  for (int b = 0; b < kBodies; ++b) rates.force[b].setZero(), rates.moment[b].setZero();
  AddSprings(state, &rates);
  AddCylinders(state, &rates);
  AddRails(state, &rates);
  const double mass[kBodies] = {numbers_.frame_mass, numbers_.body_mass, numbers_.axle_mass,
                                numbers_.axle_mass};
  const Vector3d* inertia[kBodies] = {&numbers_.frame_inertia, &numbers_.body_inertia,
                                      &numbers_.axle_inertia, &numbers_.axle_inertia};
  for (int b = 0; b < kBodies; ++b) {
    const Matrix3d R = state.attitude[b].toRotationMatrix();
    const Vector3d w = R.transpose() * state.turn[b];
    const Vector3d left = R.transpose() * rates.moment[b] - w.cross(inertia[b]->cwiseProduct(w));
    rates.force[b] = rates.force[b] / mass[b] - Vector3d(0, 0, kGravity);
    rates.moment[b] = R * left.cwiseQuotient(*inertia[b]);
  }
  return rates;
}

// `from` moved for h with the speeds of `slope` and the accelerations of `rates`.
MotionState BogieMotion::Moved(const MotionState& from, double h, const MotionState& slope,
                               const Rates& rates) {
  MotionState to = from;
  for (int b = 0; b < kBodies; ++b) {
    to.place[b] += h * slope.speed[b];
    to.speed[b] += h * rates.force[b];
    to.turn[b] += h * rates.moment[b];
    // The quaternion's rate is that of the stage's own attitude.
    to.attitude[b].coeffs() = from.attitude[b].coeffs() +
                              Turned(slope.attitude[b], slope.turn[b], h).coeffs() -
                              slope.attitude[b].coeffs();
  }
  for (size_t i = 0; i < 2; ++i) to.spin[i] += h * rates.spin[i];
  for (size_t i = 0; i < 4; ++i) {
    to.pressure[i] += h * rates.pressure[i];
    to.bristle[i] += h * rates.bristle[i];
  }
  return to;
}

void BogieMotion::Step(double h, MotionState* state) const {
  const MotionState start = *state;
  const Rates k1 = CalcRates(start);
  const MotionState s2 = Moved(start, h / 2, start, k1);
  const Rates k2 = CalcRates(s2);
  const MotionState s3 = Moved(start, h / 2, s2, k2);
  const Rates k3 = CalcRates(s3);
  const MotionState s4 = Moved(start, h, s3, k3);
  const Rates k4 = CalcRates(s4);
  *state = Moved(*state, h / 6, start, k1);
  *state = Moved(*state, h / 3, s2, k2);
  *state = Moved(*state, h / 3, s3, k3);
  *state = Moved(*state, h / 6, s4, k4);
  for (auto& q : state->attitude) q.normalize();
}

BogieReading BogieMotion::Read(const MotionState& state) const {
  BogieReading out;
  SteeringOil::Four speed;
  for (int i = 0; i < 4; ++i) {
    const Cylinder c = CylinderAt(state, i);
    out.piston[i] = c.length - numbers_.cylinder;
    speed[i] = c.speed;
  }
  out.tension = oil_.Tension(state.pressure, speed, state.bristle);
  out.pressure = state.pressure;
  for (const int axle : {kLead, kTrail}) {
    const OnTrack rail = RailLoads(state, axle);
    const auto k = static_cast<size_t>(axle - kLead);
    if (axle == kLead) out.lead_s = rail.s;
    out.lateral[k] = rail.axle.y, out.angle_of_attack[k] = rail.axle.yaw;
    for (size_t side = 0; side < 2; ++side) {
      // On the rail, in the axes of the wheel: to the field side, and down.
      out.Y[k][side] = -rail.load.wheel[side].force.y();
      out.Q[k][side] = -rail.load.wheel[side].force.z();
    }
  }
  return out;
}

}  // namespace bogie_curve
