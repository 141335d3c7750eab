// Where a rolled and yawed wheel meets its rail: the overlap of both sections, patch by patch.
//
// Frame C (frames.h): right wheel, x forward, y outward, z down. The rail is a cylinder along x.
// The wheel is a surface of revolution R(s) about its axle e = (-sin yaw cos roll, cos yaw cos
// roll, sin roll). On the circle of a profile point only one lower point has its surface normal in
// the plane x = 0 and can touch the rail (contact locus; Wang Kaiwen 1984): with u the unit vector
// from the circle's centre, t = dR/ds,
//   u_x = t e_x,  (u_y, u_z) = alpha p + beta p',  p = (e_y, e_z)/q,  p' = (-e_z, e_y)/q,
//   q = sqrt(1 - e_x^2),  alpha = -t e_x^2/q,  beta = sqrt(1 - t^2 e_x^2/q^2)
// and the locus has the slope m = dz/dy = -n_y/n_z of the surface normal n = u - t e there.
//
// Overlap h(y) = z_locus - z_rail(y) > 0. A patch is an interval of overlap. It acts as a bed of
// springs along the rail's normal, with a modulus K(y) that belongs to the rail's surface; with c
// the cosine of the rail's slope, the arc length ds = dy/c and the normal depth g = h c
//   stored energy  U = 1/2 int K g^2 ds = 1/2 int K h^2 c dy,
//   wrench = grad U: strips K h c dy (0, -m, 1) at their own points of the locus.
// So the wrench is smooth in the wheelset's position, no cycle gives energy, more depth is more
// force, and no strip does work on the spin of the axle nor on rolling ahead (m is the wheel's own
// slope there).
//
// K(y) makes the force Hertz's (contact_bed.h). The integrals are taken over panels of the wheel's
// profile that keep their places, so that they do not jump when a hump begins or ends elsewhere.
//
// The ellipse of creep forces and pressure follows from the load and from the curvature of the
// overlap as it is: I = int g ds, J = int g^2 ds, depth = 5 J/(4 I), and B = 2 S/Q, S = int g^3
// (dg/ds)^2 ds, Q = int g^4 ds; both exact for a parabola. Of an elastic contact only the deeper
// half of the overlap bears; its load per width squared has the same spread, (b^2)/14 … (b^2)/10,
// as the curvature weighted with g^4, (b^2)/11, b the half-width of the overlap: a flat shoulder
// beside the patch does not make it flat.
//
// Patches that grow together. Two humps of depths d1, d2 with a ridge of depth r > 0 between them
// are counted as separate with weight 1 - m and as one with weight m, m = smoothstep(r/min(d1,
// d2)): from 0 where their overlaps touch to 1 where the shallower hump vanishes. So neither event
// makes a jump.
#pragma once

#include <array>
#include <vector>

#include "rail/contact_bed.h"
#include "rail/frames.h"
#include "rail/hertz.h"
#include "rail/profile.h"

namespace phs::rail {

inline constexpr int kMaxOverlaps = 6;

/// Wheel placed in C.
struct WheelPlacement {
  double y = 0;  ///< wheelset centre [m]
  double z = 0;
  double roll = 0;  ///< [rad]
  double yaw = 0;
};

/// One patch of overlap as its equivalent parabola.
struct Overlap {
  double wheel_y = 0;   ///< centroid on the wheel profile [m]
  double y = 0, z = 0;  ///< of the wheel surface there, relative to the rail's origin [m]
  Vec3 arm{};           ///< of the wheel surface from the wheelset centre, C axes [m]
  double slope = 0;     ///< dz/dy across the resultant of the surface normals
  double depth = 0;     ///< of the equivalent parabola, normal [m]
  double across = 0;    ///< B: half the relative curvature across the rolling direction [1/m]
  Vec3 push{};          ///< sum of the strips' forces into the rail [N]
  Vec3 turn{};          ///< their moment about the wheelset's centre [N m]
  double energy = 0;    ///< U [J]
  double radius = 0;    ///< of the wheel about its axle [m]
  double weight = 1;    ///< share of its own force, below 1 where patches merge
  bool at_end = false;  ///< reaches the end of the wheel's or the rail's profile
};

/// Where CONTACT puts the reference of all patches of a wheel that it takes together: the centre of
/// the undeformed overlap, weighted with its square (between the two surfaces, so with h^2.5 over
/// y); the angle is the mean of the rail's with the same weight.
struct OverlapCentre {
  double rail_y = 0, wheel_y = 0;  ///< [m]
  double angle = 0;                ///< > 0 falling to the track centre [rad]
  double radius = 0;               ///< of the wheel [m]
  bool found = false;
};

/// Patches beyond `count` hold nothing.
struct Overlaps {
  int count = 0;
  Vec3 axle{};  ///< unit vector e
  std::array<Overlap, kMaxOverlaps> patch{};
};

class ContactSearch {
 public:
  /// @param half_tape lateral distance of the wheel profile's origin from the wheelset centre [m]
  /// @param radius at the wheel profile's origin [m]
  ContactSearch(Profile wheel, Profile rail, double half_tape, double radius, const Hertz& hertz);

  /// `rail_y`, `rail_z`: origin of the rail profile in C. Pure; no allocation.
  void Find(const WheelPlacement& wheel, double rail_y, double rail_z,
            Overlaps* found) const noexcept;

  /// The single points where the overlap is locally deepest, however deep, as overlaps of a usual
  /// curvature: where to begin with a rail on an elastic support.
  void FindPoints(const WheelPlacement& wheel, double rail_y, double rail_z,
                  Overlaps* found) const noexcept;

  /// Slow: over the whole wheel.
  OverlapCentre Centre(const WheelPlacement& wheel, double rail_y, double rail_z) const noexcept;

  const Profile& wheel() const { return wheel_; }
  const Profile& rail() const { return rail_; }
  double half_tape() const { return half_tape_; }

 private:
  static constexpr int kMaxSamples = 256;
  static constexpr int kMaxHumps = 3;
  static constexpr int kPanelNodes = 4;
  static constexpr int kMaxNodes = (kMaxSamples / 2 + 2) * kPanelNodes;

  struct Axle {
    double ex, ey, ez;
    double side;              ///< e_x/q
    double alpha_y, alpha_z;  ///< alpha = -t (alpha_y, alpha_z) in y and z
    double beta_y, beta_z;
    double y, z;  ///< wheelset centre relative to the rail's origin
  };
  /// A point of the locus with the overlap there.
  struct Locus {
    double y, z;
    double slope;  ///< of the wheel
    double rail_slope;
    double overlap;  ///< h
    double stretch;  ///< dy / d wheel_y
  };
  /// Hump of overlap between two ends [m on the wheel profile].
  struct Hump {
    double begin, end;
    double merge_next;  ///< m with the next hump
    bool at_end;
  };
  struct Humps {
    int count = 0;
    Hump hump[kMaxHumps];
  };
  /// Integrals over a hump, additive.
  struct Moments {
    double i = 0, square = 0, fourth = 0, bend = 0;  ///< I, J, Q, S
    double load = 0, wheel = 0, energy = 0;
    double push_y = 0, push_z = 0, turn_x = 0, turn_y = 0, turn_z = 0;
    void Add(const Moments& m);
  };
  /// Where overlap is evaluated for the integrals.
  struct Nodes {
    int count = 0;
    double at[kMaxNodes];  ///< wheel y [m]
    double radius[kMaxNodes], slope[kMaxNodes], second[kMaxNodes];
    double weight[kMaxNodes];  ///< [m]
  };
  struct Samples {
    int first, last;
    double depth[kMaxSamples];  ///< h times the cosine of the wheel's slope: normal depth
  };

  void MeasureMargins();
  Axle PlaceAxle(const WheelPlacement& wheel, double rail_y, double rail_z) const noexcept;
  Locus LocusAt(const Axle& axle, double wheel_y) const noexcept;
  void Sample(const Axle& axle, Samples* samples) const noexcept;
  /// Where the overlap ends between `inside` (h >= 0) and `outside` (h <= 0).
  /// starting from `at`.
  double EdgeBetween(const Axle& axle, double inside, double outside, double at) const noexcept;
  /// Edge of a run next to `sample` on the side of `next` = sample +- 1.
  double EdgeOfRun(const Axle& axle, const Samples& samples, int sample, int next) const noexcept;
  double DeepestNear(const Axle& axle, double low, double high) const noexcept;
  void FindHumps(const Axle& axle, const Samples& samples, Humps* humps) const noexcept;
  /// A hump that lies between two places, if there is one.
  void AddBetween(const Axle& axle, double low, double high, Humps* humps) const noexcept;
  void SplitRun(const Axle& axle, const Samples& samples, int begin, int end,
                Humps* humps) const noexcept;
  /// The nodes of one panel.
  void AddNodes(double from, double to, Nodes* nodes) const noexcept;
  void FindNodes(const Hump& hump, Nodes* nodes) const noexcept;
  Moments Integrate(const Axle& axle, const Hump& hump) const noexcept;
  void Describe(const Axle& axle, const Moments& moments, Overlap* patch) const noexcept;
  double WheelY(int sample) const { return begin_ + step_ * sample; }

  Profile wheel_;
  Profile rail_;
  double half_tape_;
  double radius_;
  ContactBed bed_;
  double begin_;  ///< first sampled wheel position [m]
  double step_;
  double panel_;  ///< width of a panel [m]
  Nodes whole_;   ///< of all panels
  int samples_;
  /// [sample] of the wheel: R, R t, R t^2/2, cosine of the slope.
  std::vector<double> radius_at_, radius_slope_, radius_square_, cosine_at_;
  std::vector<double> margin_;  ///< [sample] what a hump before the next may rise above both [m]
  double rail_begin_, rail_per_step_;
  std::vector<double> rail_z_;  ///< fine equidistant table for the samples
};

}  // namespace phs::rail
