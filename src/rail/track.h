// The track: alignment (continuous to curvature), cant, gradient, gauge, irregularities, support.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "rail/frames.h"

namespace phs::rail {

/// The track frame T at one arc length (see frames.h). Unit vectors in world coordinates.
struct TrackFrame {
  double s = 0;          ///< arc length along the centre line in plan [m]
  Vec3 origin{};         ///< [m]
  Vec3 forward{};        ///< x_T
  Vec3 left{};           ///< y_T
  Vec3 up{};             ///< z_T
  double curvature = 0;  ///< 1/R in plan, > 0 curving left [1/m]
  double heading = 0;    ///< angle of the centre line in plan against world x [rad]
  double cant = 0;       ///< angle of y_T below the horizontal; > 0 raises the right rail [rad]
};

/// Displacement of one rail from its designed place, in T axes, and its slope against x_T. The
/// vertical slope holds the twist of the track too: on a cant ramp the rails run at -+ (e/2)
/// dcant/ds against the centre line although their displacement is zero.
struct RailOffset {
  double lateral = 0;         ///< along y_T: half of gauge widening, and irregularities [m]
  double vertical = 0;        ///< along z_T: irregularities [m]
  double lateral_slope = 0;   ///< d lateral / ds
  double vertical_slope = 0;  ///< d vertical / ds + twist (left rail: -(e/2) dcant/ds)
  double twist = 0;           ///< dcant/ds: turns the slopes across the rail head [rad/m]
  double half_base = 0;       ///< distance e/2 from the centre at which vertical_slope holds [m]
  double curvature = 0;       ///< of the centre line in plan, > 0 left [1/m]
};

/// Elastic support of each rail; absent (rigid) when stiffness is zero.
struct RailSupport {
  double lateral_stiffness_N_per_m = 0;
  double lateral_damping_Ns_per_m = 0;
  double vertical_stiffness_N_per_m = 0;
  double vertical_damping_Ns_per_m = 0;
};

/// Where the track is of one kind, for statistics and the report.
struct TrackSection {
  std::string kind;  ///< "tangent", "transition", "curve"
  double begin_s = 0;
  double end_s = 0;
  double curvature = 0;  ///< of a curve [1/m]
};

/// How the track as it lies differs from the track as designed.
struct TrackErrors {
  double cant_m = 0;      ///< more superelevation in every curve, in proportion on its transitions,
                          ///< > 0 raises the outer rail, -0.1 … 0.1
  double widening_m = 0;  ///< wider gauge everywhere, -0.02 … 0.05
  bool any() const { return cant_m != 0 || widening_m != 0; }
};

/// Immutable after loading; all queries are const, allocation-free and thread-safe.
class Track {
 public:
  /// Reads models/tracks/*.yaml (format: docs/tracks.md). Errors name file, line and key. `mirror`
  /// swaps left and right: every curve turns the other way, to the last bit. `errors` come on top
  /// of the file. `speed_m_s` of the run: a spectrum goes down to the waves that it meets at 20 Hz
  /// unless the file says otherwise; 0 = 80 km/h.
  static Result<Track> Load(const std::string& path, bool mirror = false,
                            const TrackErrors& errors = {}, double speed_m_s = 0);
  Track(Track&&) noexcept;
  Track& operator=(Track&&) noexcept;
  ~Track();

  const std::string& name() const;
  double length() const;        ///< [m]; beyond both ends the track goes on straight
  double gauge() const;         ///< nominal [m]
  double gauge_height() const;  ///< depth below rail top at which the gauge is measured [m]
  double friction() const;      ///< default friction coefficient of this track; NaN if not given
  const RailSupport& support() const;
  const std::vector<TrackSection>& sections() const;
  bool has_irregularity() const;
  double cant_base() const;  ///< distance of the running lines e, over which cant is given [m]

  TrackFrame FrameAt(double s) const noexcept;
  /// Arc length of the track frame whose y-z plane contains `point` (the wheelset centre). No
  /// history: a spatial index finds the nearest part, Newton ends at rounding. Beyond both ends the
  /// result goes on below 0 and above length().
  double Project(const Vec3& point) const noexcept;
  RailOffset Rail(Side side, double s) const noexcept;

 private:
  struct Impl;
  explicit Track(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace phs::rail
