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
// Overlap h(y) = z_locus - z_rail(y) > 0. With c the cosine of the rail's slope, ds = dy/c the arc
// and g = h c the depth along the normal, a patch stores
//   U = E^(5/9),   E = int kappa g^4 ds,
// kappa a modulus that belongs to the rail's surface (contact_modulus.h). For parabolas U is
// Hertz's energy, 2/5 k d^(5/2). Its gradient is the wrench:
//   grad U = 20/9 U/E int kappa g^3 c (0, -m, 1) ds,
// every strip's share at its own point of the locus. So the wrench is smooth in the wheelset's
// position, no cycle gives energy, more depth is more force, and no strip does work on the spin of
// the axle nor on rolling ahead (m is the wheel's own slope there).
//
// Why the fourth power: of an elastic contact only the deeper half of the overlap bears. Hertz's
// load per width ~ 1 - y^2/b^2 has the spread b^2/5 about its centre; strips ~ g^n have w^2/(2 n +
// 3), w half the width of the overlap, w^2 = d/B. With Hertz's b this asks for n = 3.5 for a
// circular patch, 2.8 for one that is twice as wide as long, 6 for one that is five times as long
// as wide (where b is less than a millimetre), and 1, independent springs, for none. With n = 3
// the load lies where elastic bodies have it, also where the overlap is lopsided, as between tread
// and flange root (tests/rail/half_space_test.cc).
//
// The integrals are sums over places that never move on the wheel (contact_nodes.h): g^3 ends so
// smoothly that twenty of them in a hump leave 1e-4 of its force. So the force along z is the slope
// of the stored energy to the last digit. Which humps there are is seen at samples 0.9 mm apart, and
// 0.45 mm where there is overlap. What a grid four times as fine changes: the load by less than 1e-3, the
// lateral force by less than 2e-3 of the load, the radius by less than 4 um, on the tread a hundredth
// of that (tests/rail/contact_grid_test.cc).
//
// The ellipse of creep forces and pressure follows from the load and from the curvature of the
// overlap as it is: with L = int kappa g^3 ds, S = int kappa g^3 (dg/ds)^2 ds
//   depth = 9/8 E/L,   B = 2 S/E,
// both exact for a parabola (by parts). Creepages belong to the centre of the load, with the mean
// radius over the load: the slip that a patch on a curved root has on the whole.
// A flat shoulder beside the patch does not make it flat.
//
// Patches that grow together. Two humps of overlaps h1, h2 with the overlap r between them (below 0:
// a gap) are counted as separate with weight 1 - m and as one with weight m,
//   m = (1 - a^(3/2)/3)^3,   a = (1 - r/h1)(1 - r/h2),   0 beyond a = 3^(2/3):
// 0 where one of them just touches, 1 where they have become one. So neither event makes a jump. Two
// elastic bodies feel each other before their overlaps meet (against half-spaces the load comes out
// within 8 % rms over nine positions between tread and root). One patch stores less than two, so U
// depends on m, and m on the position:
//   wrench = sum of weight grad U + sum over the neighbours of (dU/dm) grad m,
// grad r, h1, h2 = (0, -m, 1) at their places, where both surfaces have the same slope. The second
// sum is shared by the patches in the ratio of their loads; it takes at most a fifth of them.
#pragma once

#include <array>
#include <vector>

#include "rail/contact_modulus.h"
#include "rail/contact_nodes.h"
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
  double wheel_y = 0;   ///< centre of the load on the wheel profile [m]
  double y = 0, z = 0;  ///< the same, relative to the rail's origin [m]
  Vec3 arm{};           ///< the same, from the wheelset centre, C axes [m]
  double slope = 0;     ///< dz/dy across the resultant of the surface normals
  double depth = 0;     ///< of the equivalent parabola, normal [m]
  double across = 0;    ///< B: half the relative curvature across the rolling direction [1/m]
  Vec3 push{};          ///< force into the rail [N]
  Vec3 turn{};          ///< its moment about the wheelset's centre [N m]
  double energy = 0;    ///< U [J]
  double radius = 0;    ///< of the wheel, mean over the load [m]
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
  /// @param fineness 1 … 4: so many times more samples and nodes, to see what they change
  ContactSearch(Profile wheel, Profile rail, double half_tape, double radius, const Hertz& hertz,
                int fineness = 1);

  /// `rail_y`, `rail_z`: origin of the rail profile in C. Pure; no allocation.
  void Find(const WheelPlacement& wheel, double rail_y, double rail_z,
            Overlaps* found) const noexcept;

  /// Measured between the surfaces, or along z.
  enum class Depth { kNormal, kVertical };
  /// The single points where the overlap is locally deepest, however deep, as overlaps of a usual
  /// curvature: where rigid bodies touch (vertical), where to begin with a rail on an elastic
  /// support (normal).
  void FindPoints(const WheelPlacement& wheel, double rail_y, double rail_z, Depth measure,
                  Overlaps* found) const noexcept;

  /// Slow: over the whole wheel.
  OverlapCentre Centre(const WheelPlacement& wheel, double rail_y, double rail_z) const noexcept;

  const Profile& wheel() const { return wheel_; }
  const Profile& rail() const { return rail_; }
  double half_tape() const { return half_tape_; }

 private:
  static constexpr int kMaxSamples = 1024;
  static constexpr int kMaxHumps = 3;
  static constexpr int kMaxNodes = 1024;

  struct Axle {
    double ex, ey, ez;
    double side;              ///< e_x/q
    double alpha_y, alpha_z;  ///< alpha = -t (alpha_y, alpha_z) in y and z
    double beta_y, beta_z;
    double y, z;  ///< wheelset centre relative to the rail's origin
  };
  /// A point of the locus with the overlap there.
  struct Locus {
    double x, y, z;
    double slope;  ///< of the wheel
    double rail_slope;
    double overlap;                ///< h
    double stretch;                ///< dy / d wheel_y
    double wheel_bend, rail_bend;  ///< change of both slopes over wheel_y, the wheel upright [1/m]
  };
  /// How far a hump has grown together with the next, and how that follows from the overlap between
  /// them, of this hump and of the next.
  struct Merge {
    double m;
    Locus locus[3];   ///< their places
    double slope[3];  ///< dm/dh [1/m]
  };
  /// Hump of overlap: between two ends on the wheel profile, which lie where it meets the next hump or beyond
  /// its edge [m].
  struct Hump {
    double begin, end;
    double top;    ///< deepest place: of a sample, or itself where `sample` is -1
    double depth;  ///< overlap there [m]
    int sample;
    int beside;          ///< the last coarse sample before `top` where it is none
    bool joined, after;  ///< to the next one without a gap, to the one before
    bool at_end;
    Merge next;  ///< with the next hump
  };
  struct Humps {
    int count = 0;
    Hump hump[kMaxHumps];
  };
  /// Integrals over a hump, additive; pushes and turns: grad E/4.
  struct Moments {
    double energy = 0, load = 0, bend = 0;              ///< E, L, S
    double wheel = 0, arm_x = 0, arm_y = 0, arm_z = 0;  ///< weighted as L
    double push_y = 0, push_z = 0, turn_x = 0, turn_y = 0, turn_z = 0;
    void Add(const Moments& m);
  };
  /// What the humps [from] … [to] store if they are one patch [J].
  struct Readings {
    double stored[kMaxHumps][kMaxHumps];
  };
  /// Normal depth, h times the cosine of the wheel's slope, at equal distances: coarse ones over the
  /// rail, and those in the middle between where overlap is looked at. Together they count as 0, 1, 2, …
  /// from the first coarse one; sample 2 i is coarse[i], sample 2 i + 1 middle[i].
  struct Samples {
    int first, last;  ///< of the coarse ones
    double coarse[kMaxSamples], middle[kMaxSamples];
    double At(int sample) const {
      return sample % 2 == 0 ? coarse[sample / 2] : middle[sample / 2];
    }
  };
  struct RailPiece {
    double z, rise;
  };
  /// [sample] of the wheel: y beyond the first, R, R t, R t^2/2, cosine of the slope and its inverse.
  struct Row {
    std::vector<double> along, down, slope, square, cosine, stretch;
    void Add(const Profile& wheel, double begin, double at, double radius);
  };

  void PlaceSamples(double step);
  void MeasureMargins();
  Axle PlaceAxle(const WheelPlacement& wheel, double rail_y, double rail_z) const noexcept;
  Locus LocusAt(const Axle& axle, double wheel_y) const noexcept;
  /// The coarse ones.
  void Sample(const Axle& axle, Samples* samples) const noexcept;
  /// Those after the coarse ones `from` … `end` - 1.
  void SampleMiddles(const Axle& axle, int from, int end, Samples* samples) const noexcept;
  void SampleRow(const Axle& axle, const Row& row, int first, int end,
                 double* depth) const noexcept;
  /// Where wheel and rail have the same slope beside a sample: the deepest place, or with `sign` -1
  /// the ridge. `place`: on the wheel [m].
  Locus StationaryNear(const Axle& axle, const Samples& samples, int sample, double sign,
                       double* place) const noexcept;
  /// The same between two places. The middle where there is none.
  double StationaryBetween(const Axle& axle, double low, double high,
                           double sign = 1) const noexcept;
  /// Sets `next` of a hump, and where both meet.
  void Link(const Axle& axle, Samples* samples, Hump* hump, Hump* next) const noexcept;
  void FindHumps(const Axle& axle, Samples* samples, Humps* humps) const noexcept;
  /// A hump that lies between a coarse sample and the next, if there is one.
  void AddBetween(const Axle& axle, int coarse, Humps* humps) const noexcept;
  /// The humps among the coarse samples `begin` … `end` that overlap, and beside them.
  void AddRun(const Axle& axle, int begin, int end, Samples* samples, Humps* humps) const noexcept;
  /// The humps of the samples `begin` … `end`, which all overlap.
  void SplitRun(const Samples& samples, int begin, int end, Humps* humps) const noexcept;
  Moments Integrate(const Axle& axle, const Hump& hump) const noexcept;
  static Readings ReadEnergies(const Moments* moments, int first, int last) noexcept;
  /// Every way of reading hump `from` and its followers as one patch, with its weight.
  void AddReadings(const Axle& axle, const Humps& humps, int from, const Moments* moments,
                   const Readings& readings, Overlaps* found) const noexcept;
  /// dU/dm of the ridge after hump `ridge` among the humps `first` … `last` of a run.
  static double EnergyOfMerging(const Humps& humps, int first, int last, int ridge,
                                const Readings& readings) noexcept;
  /// The wrench of the merging of humps `first` … `last`, added to their patches from `begin` on.
  void AddMerging(const Axle& axle, const Humps& humps, int first, int last,
                  const Readings& readings, int begin, Overlaps* found) const noexcept;
  /// U of E [J].
  static double StoredEnergy(double e) noexcept;
  void Describe(const Axle& axle, const Moments& moments, double stored,
                Overlap* patch) const noexcept;
  double WheelY(int sample) const { return begin_ + half_step_ * sample; }
  double Vertical(const Samples& samples, int i) const {
    const Row& row = i % 2 == 0 ? coarse_ : middle_;
    return samples.At(i) * row.stretch[static_cast<size_t>(i / 2)];
  }

  Profile wheel_;
  Profile rail_;
  double half_tape_;
  double radius_;
  ContactModulus modulus_;
  ContactNodes nodes_;
  double begin_;      ///< first sampled wheel position [m]
  double half_step_;  ///< between samples [m]
  int samples_;       ///< coarse ones
  Row coarse_, middle_;
  std::vector<double> margin_;  ///< [coarse] what a hump before the next may rise above both [m]
  double most_margin_;
  double rail_begin_, rail_per_step_;
  std::vector<RailPiece> rail_pieces_;  ///< fine equidistant chords for the samples
};

}  // namespace phs::rail
