// Plain tracks that no file describes: straight, or one curve, on the gauge of another track.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "base/local_folder.h"
#include "base/result.h"

namespace phs::analysis {

/// What a track is whatever its course: gauge, and what else stays the same along it.
struct TrackBase {
  double gauge_m = 1.067;
  double gauge_height_m = 0.014;
  double cant_base_m = 1.139;                                  ///< e, of the running lines
  double friction = std::numeric_limits<double>::quiet_NaN();  ///< NaN: the track says nothing
};

/// The base of a track by name or path. Errors as of reading the track.
Result<TrackBase> ReadTrackBase(const std::string& name_or_path);

/// A curve to the left: tangent, transition, arc, transition, tangent. No arc: straight.
struct PlainCurve {
  double radius_m = 0;
  double cant_m = 0;
  double transition_m = 0;
  double arc_length_m = 0;
};

/// A track file in a temporary folder of its own; removed with the object.
class TemporaryTrack {
 public:
  /// 600 m of straight, level track.
  static Result<TemporaryTrack> Straight(const TrackBase& base);
  static Result<TemporaryTrack> Curve(const TrackBase& base, const PlainCurve& curve);
  std::string path() const { return folder_.path() + "/track.yaml"; }

 private:
  TemporaryTrack() = default;
  static Result<TemporaryTrack> Write(const std::string& name, const TrackBase& base,
                                      const std::string& segments);
  LocalFolder folder_;
};

/// The straight track that a bogie is looked at on: the one asked for; else one as wide as the
/// track that the bogie's file names, which is the shipped `straight` on 1067 mm. Keep it until the
/// simulation is made.
class StraightTrack {
 public:
  /// `asked`: name or path, "" = none.
  static Result<StraightTrack> For(const std::string& bogie, const std::string& asked);
  /// As wide as the track `like`.
  static Result<StraightTrack> Like(const std::string& like);
  std::string name() const { return file_ ? file_->path() : name_; }

 private:
  std::string name_ = "straight";
  std::optional<TemporaryTrack> file_;
};

}  // namespace phs::analysis
