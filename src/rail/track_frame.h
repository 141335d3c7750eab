// What is known of a track at one place, and what is said of it as a whole: frame, offsets of the
// rails, support, sections, errors.
#pragma once

#include <string>

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

}  // namespace phs::rail
