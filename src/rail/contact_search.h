// Where a rolled and yawed wheel meets its rail: all local minima of the gap that penetrate.
//
// Frame C (frames.h): right wheel, x forward, y outward, z down. The rail is a cylinder along x.
// The wheel is a surface of revolution R(s) about its axle e = (-sin yaw cos roll, cos yaw cos
// roll, sin roll). On the circle of a profile point only one lower point has its surface normal in
// the plane x = 0 and can touch the rail (contact locus; Wang Kaiwen 1984): with u the unit vector
// from the circle's centre, t = dR/ds,
//   u_x = t e_x,  (u_y, u_z) = alpha p + beta p',  p = (e_y, e_z)/q,  p' = (-e_z, e_y)/q,
//   q = sqrt(1 - e_x^2),  alpha = -t e_x^2/q,  beta = sqrt(1 - t^2 e_x^2/q^2)
// and the locus has the slope dz/dy = -n_y/n_z of the surface normal n = u - t e there. The
// vertical gap z_rail(y) - z_locus has its minima where both slopes agree.
#pragma once

#include <array>
#include <vector>

#include "rail/frames.h"
#include "rail/profile.h"

namespace phs::rail {

inline constexpr int kMaxMinima = 4;

/// Wheel placed in C.
struct WheelPlacement {
  double y = 0;  ///< wheelset centre [m]
  double z = 0;
  double roll = 0;  ///< [rad]
  double yaw = 0;
};

/// One touching point with its local geometry.
struct TouchingPoint {
  double wheel_y = 0;   ///< on the wheel profile [m]
  double y = 0, z = 0;  ///< of the wheel surface, relative to the rail profile's origin [m]
  Vec3 arm{};           ///< of the wheel surface from the wheelset centre, C axes [m]
  double slope = 0;     ///< dz/dy of both surfaces
  double depth = 0;     ///< normal penetration, > 0 [m]
  double across = 0;    ///< half the relative curvature across the rolling direction, > 0 [1/m]
  double radius = 0;    ///< rolling radius [m]
  double weight = 1;    ///< share of its own Hertz force, below 1 where patches merge
  bool at_end = false;  ///< at the end of the wheel's or the rail's profile
};

struct TouchingPoints {
  int count = 0;
  std::array<TouchingPoint, kMaxMinima> point{};
};

class ContactSearch {
 public:
  /// @param half_tape lateral distance of the wheel profile's origin from the wheelset centre [m]
  /// @param radius at the wheel profile's origin [m]
  ContactSearch(Profile wheel, Profile rail, double half_tape, double radius);

  /// `rail_y`, `rail_z`: origin of the rail profile in C. Pure; no allocation.
  TouchingPoints Find(const WheelPlacement& wheel, double rail_y, double rail_z) const noexcept;

  const Profile& wheel() const { return wheel_; }
  const Profile& rail() const { return rail_; }

 private:
  struct Axle {
    double ex, ey, ez, q;
    double y, z;  ///< wheelset centre relative to the rail's origin
  };
  struct Locus {
    double y, z, slope;
    Vec3 arm;
    double radius;
  };
  Locus LocusAt(const Axle& axle, double wheel_y) const noexcept;
  Locus LocusOf(const Axle& axle, double wheel_y, const Profile::Sample& s) const noexcept;
  double GapAt(const Axle& axle, double wheel_y) const noexcept;
  double SlopeDifference(const Axle& axle, double wheel_y) const noexcept;
  /// Where slopes agree between two wheel positions whose slope differences have opposite signs.
  double Agree(const Axle& axle, double low, double high, double f_low,
               double f_high) const noexcept;
  TouchingPoint Describe(const Axle& axle, double wheel_y) const noexcept;

  Profile wheel_;
  Profile rail_;
  double half_tape_;
  double radius_;
  double begin_;  ///< first searched wheel position [m]
  double step_;   ///< coarse step [m]
  int samples_;
  std::vector<Profile::Sample> sample_;  ///< of the wheel profile at the coarse positions
};

}  // namespace phs::rail
