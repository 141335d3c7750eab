#include "analysis/plain_track.h"

#include <fmt/format.h>

#include <cmath>

#include "base/data_path.h"
#include "base/disk.h"
#include "rail/track.h"
#include "vehicle/compose.h"

namespace phs::analysis {
namespace {

constexpr double kSame = 1e-9;  ///< [m]

}  // namespace

Result<TrackBase> ReadTrackBase(const std::string& name_or_path) {
  auto path = FindData("track", "models/tracks", name_or_path, {".yaml"});
  if (!path.ok()) return path.error();
  auto track = rail::Track::Load(path.value());
  if (!track.ok()) return track.error();
  const rail::Track& t = track.value();
  return TrackBase{t.gauge(), t.gauge_height(), t.cant_base(), t.friction()};
}

Result<TemporaryTrack> TemporaryTrack::Straight(const TrackBase& base) {
  return Write(fmt::format("straight on {:g} mm", 1e3 * base.gauge_m), base,
               "  - {kind: tangent, length_m: 600}\n");
}

Result<TemporaryTrack> TemporaryTrack::Curve(const TrackBase& base, const PlainCurve& c) {
  return Write(
      fmt::format("arc_r{:g}", c.radius_m), base,
      fmt::format("  - {{kind: tangent, length_m: 40}}\n  - {{kind: transition, length_m: {0}}}\n"
                  "  - {{kind: curve, hand: left, radius_m: {1}, length_m: {2}, cant_m: {3}}}\n"
                  "  - {{kind: transition, length_m: {0}}}\n  - {{kind: tangent, length_m: 20}}\n",
                  c.transition_m, c.radius_m, c.arc_length_m, c.cant_m));
}

Result<TemporaryTrack> TemporaryTrack::Write(const std::string& name, const TrackBase& base,
                                             const std::string& segments) {
  std::string text = fmt::format(
      "name: {}\ngauge_m: {}\ngauge_height_m: {}\ncant_pivot: low_rail\ncant_base_m: {}\n", name,
      base.gauge_m, base.gauge_height_m, base.cant_base_m);
  if (std::isfinite(base.friction)) text += fmt::format("friction: {}\n", base.friction);
  text += "segments:\n" + segments;
  TemporaryTrack track;
  if (Status s = track.folder_.status(); !s.ok()) return s.error();
  if (Status s = WritePassingFile(track.path(), text); !s.ok()) return s.error();
  return track;
}

Result<StraightTrack> StraightTrack::For(const std::string& bogie, const std::string& asked) {
  if (asked.empty()) return Like(vehicle::TrackOf(bogie));
  StraightTrack track;
  track.name_ = asked;
  return track;
}

Result<StraightTrack> StraightTrack::Like(const std::string& like) {
  StraightTrack track;
  const auto base = like.empty() ? Result<TrackBase>(TrackBase{}) : ReadTrackBase(like);
  if (!base.ok()) return base.error();
  const TrackBase usual;
  const bool same = std::abs(base.value().gauge_m - usual.gauge_m) < kSame &&
                    std::abs(base.value().gauge_height_m - usual.gauge_height_m) < kSame;
  if (same) return track;
  auto file = TemporaryTrack::Straight(base.value());
  if (!file.ok()) return file.error();
  track.file_.emplace(std::move(file).value());
  return track;
}

}  // namespace phs::analysis
