// The track: alignment (continuous to curvature), cant, gradient, gauge, irregularities, support.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "rail/frames.h"
#include "rail/track_frame.h"

namespace phs::rail {

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
