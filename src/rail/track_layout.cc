#include "rail/track_layout.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "base/yaml.h"

namespace phs::rail {
namespace {

constexpr double kSmallestRadius = 50;     // [m]
constexpr double kLongestSegment = 200e3;  // [m]
constexpr double kShortestSegment = 0.1;   // [m]
constexpr double kLargestCant = 0.25;      // [m]
constexpr double kHeadWidth = 0.072;  // of a 60E1 rail: gauge + head = distance of rail centres

SegmentKind ReadKind(YamlMap& map) {
  const std::string kind = map.Word("kind", {"tangent", "transition", "curve"});
  if (kind == "transition") return SegmentKind::kTransition;
  return kind == "curve" ? SegmentKind::kCurve : SegmentKind::kTangent;
}

void ReadCurve(YamlMap& map, TrackSegment* segment) {
  const double sign = map.Word("hand", {"left", "right"}) == "left" ? 1 : -1;
  const double radius = map.Number("radius_m", {.min = kSmallestRadius, .max = 1e6});
  if (map.Has("length_m") == map.Has("angle_deg")) {
    map.Fail(map.Has("length_m") ? "angle_deg" : "kind", "a curve needs one of length_m, angle_deg",
             "exactly one of the two", "give the length of the arc or the angle it turns by");
    return;
  }
  if (map.Has("length_m")) {
    segment->length = map.Number("length_m", {.min = kShortestSegment, .max = kLongestSegment});
  } else {
    const double angle = map.Number("angle_deg", {.min = 0, .max = 360, .open_min = true});
    segment->length = radius * angle * std::numbers::pi / 180;
  }
  segment->curvature_begin = segment->curvature_end = radius > 0 ? sign / radius : 0;
  segment->cant_begin = segment->cant_end =
      sign * map.Number("cant_m", {.min = 0, .max = kLargestCant}, 0.0);
  segment->widening_begin = segment->widening_end =
      map.Number("gauge_widening_m", {.min = -0.02, .max = 0.05}, 0.0);
}

TrackSegment ReadSegment(YamlMap& map) {
  TrackSegment segment;
  segment.kind = ReadKind(map);
  segment.where = map.Where("kind");
  if (segment.kind == SegmentKind::kCurve) {
    ReadCurve(map, &segment);
  } else {
    segment.length = map.Number("length_m", {.min = kShortestSegment, .max = kLongestSegment});
  }
  segment.gradient = map.Number("gradient_per_mille", {.min = -100, .max = 100}, 0.0) / 1000;
  return segment;
}

// A transition takes the end values of its neighbours.
Status JoinTransitions(std::vector<TrackSegment>* segments) {
  for (size_t i = 0; i < segments->size(); ++i) {
    TrackSegment& now = (*segments)[i];
    if (now.kind != SegmentKind::kTransition) continue;
    const bool lonely = i == 0 || i + 1 == segments->size() ||
                        (*segments)[i - 1].kind == SegmentKind::kTransition ||
                        (*segments)[i + 1].kind == SegmentKind::kTransition;
    if (lonely) {
      return Error{now.where, "a transition without a tangent or curve on both sides",
                   "tangent or curve, transition, tangent or curve",
                   "add the missing segment or remove the transition"};
    }
    const TrackSegment& before = (*segments)[i - 1];
    const TrackSegment& after = (*segments)[i + 1];
    now.curvature_begin = before.curvature_end;
    now.curvature_end = after.curvature_begin;
    now.cant_begin = before.cant_end;
    now.cant_end = after.cant_begin;
    now.widening_begin = before.widening_end;
    now.widening_end = after.widening_begin;
  }
  return {};
}

void ReadAlignment(YamlMap& map, const TrackLayout& layout, AlignmentParams* params) {
  params->cant_base =
      map.Number("cant_base_m", {.min = 0.5, .max = 2.5}, layout.gauge + kHeadWidth);
  params->pivot = map.Word("cant_pivot", {"low_rail", "centre_line"}, "low_rail") == "low_rail"
                      ? CantPivot::kLowRail
                      : CantPivot::kCentreLine;
  params->vertical_radius = map.Number("vertical_radius_m", {.min = 100, .max = 1e6}, 5000.0);
  params->ramp_rounding = map.Number("ramp_rounding_m", {.min = 0, .max = 50}, 6.0);
  std::vector<YamlMap> segments = map.Maps("segments");
  if (segments.empty()) {
    map.Fail("segments", "no segments", "a list of tangent, transition and curve",
             "add `- {kind: tangent, length_m: 100}`");
  }
  for (YamlMap& segment : segments) params->segments.push_back(ReadSegment(segment));
}

/// A damper acts beside its spring: a rigid rail has none.
void RefuseDamperAlone(YamlMap& map, const std::string& direction, double stiffness,
                       double damping) {
  if (!(damping > 0) || stiffness > 0) return;
  map.Fail(direction + "_damping_Ns_per_m", "has no spring beside it: the rail is rigid",
           "with " + direction + "_stiffness_N_per_m > 0", "give the stiffness or remove it");
}

RailSupport ReadSupport(YamlMap& map) {
  constexpr double kStiffest = 1e11;
  constexpr double kMostDamped = 1e8;
  RailSupport support;
  support.lateral_stiffness_N_per_m =
      map.Number("lateral_stiffness_N_per_m", {.min = 0, .max = kStiffest}, 0.0);
  support.lateral_damping_Ns_per_m =
      map.Number("lateral_damping_Ns_per_m", {.min = 0, .max = kMostDamped}, 0.0);
  support.vertical_stiffness_N_per_m =
      map.Number("vertical_stiffness_N_per_m", {.min = 0, .max = kStiffest}, 0.0);
  support.vertical_damping_Ns_per_m =
      map.Number("vertical_damping_Ns_per_m", {.min = 0, .max = kMostDamped}, 0.0);
  RefuseDamperAlone(map, "lateral", support.lateral_stiffness_N_per_m,
                    support.lateral_damping_Ns_per_m);
  RefuseDamperAlone(map, "vertical", support.vertical_stiffness_N_per_m,
                    support.vertical_damping_Ns_per_m);
  return support;
}

/// Where a spectrum begins if nothing is said [m]: a vehicle at its start would stand on rails that
/// it has not come to roll on, and find no rest.
constexpr double kAheadOfVehicle = 30;

/// Samples times waves: two minutes on one core, 30 km at 80 km/h.
constexpr double kMostWork = 2.5e10;

void ReadPsd(YamlMap& map, double length, double speed_m_s, IrregularityPsdParams* psd) {
  psd->psd = map.Word("psd", PsdNames());
  psd->seed = static_cast<std::uint64_t>(map.Integer("seed", 0, 2147483647, 1));
  const double ahead = length > 4 * kAheadOfVehicle ? kAheadOfVehicle : 0;
  psd->begin_s = map.Number("begin_s_m", {.min = 0, .max = length}, ahead);
  psd->end_s = map.Number("end_s_m", {.min = 0, .max = length}, length);
  if (psd->end_s - psd->begin_s < 1) {
    map.Fail(map.Has("end_s_m") ? "end_s_m" : "begin_s_m",
             "the range of the irregularity is shorter than 1 m", "begin_s_m + 1 <= end_s_m",
             "swap or spread the two");
  }
  psd->shortest_wavelength = map.Number("shortest_wavelength_m", {.min = 0.2, .max = 100}, 3.0);
  // Nothing said: on to where the speed of the run meets 20 Hz.
  if (!map.Has("shortest_wavelength_m")) psd->finest_wavelength = FinestWavelength(speed_m_s);
  psd->longest_wavelength = map.Number("longest_wavelength_m", {.min = 0.4, .max = 500}, 100.0);
  if (psd->longest_wavelength < 1.5 * psd->shortest_wavelength) {
    map.Fail("longest_wavelength_m", "the band of wavelengths is empty or too narrow",
             "at least 1.5 times shortest_wavelength_m", "raise it");
  }
  psd->scale = map.Number("scale", {.min = 0, .max = 100}, 1.0);
  if (IrregularityWork(*psd) > kMostWork) {
    map.Fail("psd", "so long an irregularity of so short waves would take minutes to generate",
             "about 30 km with waves down to 1.1 m; the time grows with the square of the length",
             "a shorter range (begin_s_m, end_s_m), longer waves, or a record (file)");
  }
}

Result<IrregularityLayout> ReadIrregularityLayout(YamlMap& map, double length, double speed_m_s) {
  IrregularityLayout layout;
  layout.fade = map.Number("fade_m", {.min = 0, .max = 1000}, 20.0);
  if (map.Has("file") == map.Has("psd")) {
    map.Fail(map.Has("file") ? "psd" : "file", "an irregularity needs one of file, psd",
             "exactly one of the two", "name a record or a spectrum");
    return layout;
  }
  if (map.Has("psd")) {
    ReadPsd(map, length, speed_m_s, &layout.psd);
    return layout;
  }
  const std::filesystem::path file = map.Text("file");
  const auto folder = std::filesystem::path(map.path()).parent_path();
  auto read = ReadIrregularity(file.is_absolute() ? file.string() : (folder / file).string());
  if (!read.ok()) return read.error();
  layout.samples = std::move(read).value();
  return layout;
}

double Length(const TrackLayout& layout) {
  double length = 0;
  for (const TrackSegment& segment : layout.alignment.segments) length += segment.length;
  return length;
}

void Mirror(TrackLayout* layout) {
  for (TrackSegment& segment : layout->alignment.segments) {
    for (double* value : {&segment.curvature_begin, &segment.curvature_end, &segment.cant_begin,
                          &segment.cant_end}) {
      *value = -*value;
    }
  }
  layout->mirrored = !layout->mirrored;
}

Result<TrackLayout> ReadOwnLayout(YamlMap& map, double speed_m_s) {
  TrackLayout layout;
  const std::string stem = std::filesystem::path(map.path()).stem().string();
  layout.name = map.Text("name", stem);
  map.Text("description", "");
  map.Text("source", "");
  layout.gauge = map.Number("gauge_m", {.min = 0.3, .max = 2.0}, 1.067);
  layout.gauge_height = map.Number("gauge_height_m", {.min = 0, .max = 0.05}, 0.014);
  layout.friction = map.Number("friction", {.min = 0, .max = 1}, layout.friction);
  ReadAlignment(map, layout, &layout.alignment);
  if (map.Has("support")) {
    YamlMap support = map.Map("support");
    layout.support = ReadSupport(support);
  }
  const double length = Length(layout);
  if (map.Has("irregularity")) {
    YamlMap irregularity = map.Map("irregularity");
    auto read = ReadIrregularityLayout(irregularity, length, speed_m_s);
    if (!read.ok()) return read.error();
    layout.irregularity = std::move(read).value();
  }
  if (Status s = map.Finish(); !s.ok()) return s.error();
  if (Status s = JoinTransitions(&layout.alignment.segments); !s.ok()) return s.error();
  return layout;
}

}  // namespace

Status ApplyErrors(const TrackErrors& errors, TrackLayout* layout) {
  if (!errors.any()) return {};
  if (!(std::abs(errors.cant_m) <= 0.1)) {
    return Error{"cant error", "is out of range", "-0.1 … 0.1 m", ""};
  }
  if (!(errors.widening_m >= -0.02 && errors.widening_m <= 0.05)) {
    return Error{"gauge error", "is out of range", "-0.02 … 0.05 m", ""};
  }
  for (TrackSegment& segment : layout->alignment.segments) {
    segment.widening_begin += errors.widening_m;
    segment.widening_end += errors.widening_m;
    if (segment.kind != SegmentKind::kCurve) continue;
    const double outer = segment.curvature_begin > 0 ? errors.cant_m : -errors.cant_m;
    segment.cant_begin += outer;
    segment.cant_end += outer;
  }
  return JoinTransitions(&layout->alignment.segments);
}

Result<TrackLayout> ReadTrackLayout(const std::string& path, bool mirror, double speed_m_s) {
  Result<YamlMap> loaded = YamlMap::Load(path);
  if (!loaded.ok()) return loaded.error();
  YamlMap& map = loaded.value();
  const std::string stem = std::filesystem::path(path).stem().string();
  Result<TrackLayout> layout = TrackLayout{};
  if (map.Has("mirror_of")) {
    const std::string name = map.Text("name", stem);
    map.Text("description", "");
    const std::string where = map.Where("mirror_of");
    const std::filesystem::path original =
        std::filesystem::path(path).parent_path() / (map.Text("mirror_of") + ".yaml");
    if (Status s = map.Finish(); !s.ok()) return s.error();
    auto other = YamlMap::Load(original.string());
    if (!other.ok()) return Error{where, other.error().Line(), "", ""};
    if (other.value().Has("mirror_of")) {
      return Error{where, "a mirror image of a mirror image", "the name of a track with segments",
                   "name the original"};
    }
    layout = ReadOwnLayout(other.value(), speed_m_s);
    if (layout.ok()) layout.value().name = name;
    mirror = !mirror;
  } else {
    layout = ReadOwnLayout(map, speed_m_s);
  }
  if (layout.ok() && mirror) Mirror(&layout.value());
  return layout;
}

}  // namespace phs::rail
