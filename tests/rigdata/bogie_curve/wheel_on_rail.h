// One wheel on its rail as rigid sections that overlap; every patch of overlap is one of Hertz's.
//
// Axes of one wheel: x along the rail, y to the field side, z down (right-handed for a right wheel;
// a left wheel is seen in a mirror). h(y) is the overlap square to the rail's surface. Of a patch
// with the largest overlap d only what lies above (1 - e) d counts, e = 0.55 (virtual penetration:
// W. Kik and J. Piotrowski 1996; J. Piotrowski and H. Chollet, Vehicle System Dynamics 43 (2005)
// 455): g = h - (1 - e) d > 0. With S the integral of g over the arc, the parabola of the same
// height e d and area S has the half-width 3 S/(4 e d), from which B; A = cos(angle)/(2 R). Place
// and slope of the patch are means weighted by g. Yaw does not move the contact (angles of attack
// of some mrad: under 2 um on the flange); it gives the creepage.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "creep.h"
#include "section.h"

namespace bogie_curve {

using Eigen::Vector3d;

struct WheelRailPair {
  Section wheel, rail;
  double gauge = 1.067, gauge_depth = 0.014;  // [m]
  double half_tape = 0.566;                   // tape circle from the middle of the axle [m]
  double radius = 0.625;                      // of the tape circle [m]
  double friction = 0.35;
  Material material;
  double damping = 3e5;  // of a patch's approach [N s/m]
};

// An axle over the track, in the axes of one wheel.
struct AxlePlace {
  double y = 0, z = 0;       // of its centre; z negative above the rail [m]
  double roll = 0, yaw = 0;  // [rad]
  Vector3d speed, turn;      // of the centre; angular velocity with spin
  double forward = 1;        // speed to which creepages refer [m/s]
  double rail_fall = 0;      // dz/dx of the rail (twist of a cant ramp)
};

struct Patch {
  Ellipse ellipse;
  double rail_y = 0, slope = 0;  // on the rail's section; dz/dy
  double rolling_radius = 0;
  Creepage creepage;
  Vector3d force;  // on the wheel
};

struct WheelLoad {
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();  // on the axle, about its centre
  std::vector<Patch> patches;
};

class WheelOnRail {
 public:
  explicit WheelOnRail(WheelRailPair pair);
  WheelLoad Load(const AxlePlace& axle) const;
  double rail_place() const { return rail_y_; }  // of the rail's origin from the track's middle
  const WheelRailPair& pair() const { return pair_; }

 private:
  struct Overlap {
    double depth = 0;  // d [m]
    double area = 0;   // S [m2]
    double rail_y = 0, slope = 0, radius = 0;
  };
  struct Sample {
    double rail_y, slope, radius, h;
  };
  std::vector<Overlap> Overlaps(const AxlePlace& axle) const;
  static Overlap Gather(const Sample* begin, const Sample* end);
  void AddPatch(const AxlePlace& axle, const Overlap& overlap, WheelLoad* load) const;

  WheelRailPair pair_;
  HertzEllipse hertz_;
  double rail_y_;
};

// Both wheels of an axle in the track's axes (x forward, y left, z up; angles right-handed).
struct AxleInTrack {
  double y = 0, z = 0, roll = 0, yaw = 0;
  Vector3d speed, turn;  // of the centre; angular velocity with spin
  double twist = 0;      // of the track, > 0 where the right rail rises [rad/m]
};
struct AxleLoad {
  std::array<WheelLoad, 2> wheel;  // left, right; in the axes of each wheel
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
};
AxleLoad LoadAxle(const WheelOnRail& left, const WheelOnRail& right, const AxleInTrack& axle);

}  // namespace bogie_curve
