// A steered two-axle bogie with half a car body on a curve: Newton's and Euler's equations of four
// rigid bodies in world axes, with the wheels' rotation as one more speed of each axle.
//
//   m dv/dt = F,   I dw/dt + w x (I w) + h w x e = M,   J dO/dt = T + M_rails . e
//
// e: the axle's direction; h = J_wheelset O, O the rotation of the wheelset about e. What belongs
// to e of the rails' moment turns the wheelset and not the boxes. Nothing is linearised in the
// bodies' motion; springs act along the frame's axes. Fourth-order Runge-Kutta of one fixed step.
//
// Bodies: frame; half body (fixed to the frame in x, pitch and yaw by stiff springs); two axles
// with their boxes (fixed in pitch alike). Numbers: those of the shipped bogie `phs`.
#pragma once

#include <Eigen/Dense>
#include <array>

#include "steering_oil.h"
#include "track_line.h"
#include "wheel_on_rail.h"

namespace bogie_curve {

using Eigen::Matrix3d;

// Along or about x, y, z.
struct SpringNumbers {
  Vector3d along{0, 0, 0}, along_damping{0, 0, 0};
  Vector3d about{0, 0, 0}, about_damping{0, 0, 0};
  double rest_z = 0;  // deflection without force [m]
};

struct BogieNumbers {
  double wheel_base = 3.1, box_arm = 0.9, cylinder = 0.4;          // [m]
  double frame_mass = 10000, body_mass = 32800, axle_mass = 4600;  // [kg]
  Vector3d frame_inertia{5000, 12000, 15000}, body_inertia{55000, 30000, 30000};
  Vector3d axle_inertia{2600, 400, 2700};        // wheelset and boxes; y: boxes alone
  double wheelset_spin = 300, rotor_spin = 200;  // [kg m2]
  SpringNumbers guidance{{2.0e6, 12.0e6, 4.0e6},
                         {2.0e4, 4.0e4, 6.0e4},
                         {3.24e6, 5.0e7, 1.62e6},
                         {4.86e4, 5.7e4, 1.62e4},
                         -0.0524835};
  SpringNumbers secondary{{1.0e8, 0.5e6, 3.5e6},
                          {1.75e5, 8.0e4, 1.0e5},
                          {3.5e6, 1.0e8, 1.0e8},
                          {1.0e5, 1.85e5, 1.85e5},
                          0.0919337};
  double box_spring = 1;    // springs of the leading left box over the others'
  double wheel_larger = 0;  // radius of the leading left wheel over the others' [m]
  double speed = 80 / 3.6;  // held by both axles' drives [m/s]
  double start = -100;      // where the middle of the bogie begins [m]
};

inline constexpr int kFrame = 0, kBody = 1, kLead = 2, kTrail = 3, kBodies = 4;

struct MotionState {
  std::array<Vector3d, kBodies> place, speed, turn;  // of the centre of mass; angular velocity
  std::array<Eigen::Quaterniond, kBodies> attitude;
  std::array<double, 2> spin{};
  SteeringOil::Four pressure{}, bristle{};
  bool leaking = true;  // as SteeringOil::PressureRate
};

// What instruments could show at one instant; wheels: left, right.
struct BogieReading {
  double lead_s = 0;
  SteeringOil::Four piston{}, tension{}, pressure{};
  std::array<double, 2> lateral{}, angle_of_attack{};
  std::array<std::array<double, 2>, 2> Y{}, Q{};  // [axle][side]
};

class BogieMotion {
 public:
  BogieMotion(BogieNumbers numbers, const TrackLine& track, WheelOnRail wheel, SteeringOil oil);
  MotionState Start() const;
  void Step(double h, MotionState* state) const;
  BogieReading Read(const MotionState& state) const;

 private:
  struct Rates {
    std::array<Vector3d, kBodies> force, moment;  // then accelerations
    std::array<double, 2> spin{};
    SteeringOil::Four pressure{}, bristle{};
  };
  struct Cylinder {
    double length, speed;
    Vector3d direction, bracket, box;
    int axle;
  };
  struct OnTrack {
    double s = 0;
    Matrix3d axes;     // of the track at s, as columns
    AxleInTrack axle;  // in these axes
    AxleLoad load;
  };
  static MotionState Moved(const MotionState& from, double h, const MotionState& slope,
                           const Rates& rates);
  Rates CalcRates(const MotionState& state) const;
  void AddSprings(const MotionState& state, Rates* rates) const;
  void AddRails(const MotionState& state, Rates* rates) const;
  void AddCylinders(const MotionState& state, Rates* rates) const;
  OnTrack RailLoads(const MotionState& state, int axle) const;
  Cylinder CylinderAt(const MotionState& state, int index) const;

  BogieNumbers numbers_;
  const TrackLine& track_;
  WheelOnRail wheel_, odd_wheel_;  // odd: the leading left one
  SteeringOil oil_;
};

}  // namespace bogie_curve
