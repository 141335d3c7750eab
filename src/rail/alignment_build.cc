// Building an alignment from its segments: checks, ramps, knots, spatial index.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "rail/alignment.h"
#include "rail/alignment_index.h"

namespace phs::rail {
namespace {

using Vertices = std::vector<RoundedPolyline::Vertex>;

constexpr double kLargestTurn = 0.05;    // of the heading between knots [rad]
constexpr double kLargestSpacing = 5.0;  // of knots [m]
constexpr double kSelfApproach = 100.0;  // along the track: nearer is the same piece of track [m]

std::string Millimetres(double metres) {
  return std::to_string(std::lround(metres * 1e4) / 10.0).substr(0, 6) + " mm";
}

std::string Radius(double curvature) {
  if (curvature == 0) return "straight";
  return "R = " + std::to_string(std::lround(1 / std::abs(curvature))) + " m " +
         (curvature > 0 ? "left" : "right");
}

Status CheckJoint(const TrackSegment& before, const TrackSegment& after) {
  if (std::abs(before.curvature_end - after.curvature_begin) > 1e-12) {
    return Error{after.where,
                 "the curvature jumps from " + Radius(before.curvature_end) + " to " +
                     Radius(after.curvature_begin),
                 "segments that meet with equal curvature",
                 "put `- {kind: transition, length_m: …}` between them"};
  }
  if (std::abs(before.cant_end - after.cant_begin) > 1e-9) {
    return Error{after.where,
                 "the cant jumps from " + Millimetres(before.cant_end) + " to " +
                     Millimetres(after.cant_begin),
                 "segments that meet with equal cant",
                 "put `- {kind: transition, length_m: …}` between them"};
  }
  if (std::abs(before.widening_end - after.widening_begin) > 1e-9) {
    return Error{after.where,
                 "the gauge jumps by " + Millimetres(after.widening_begin - before.widening_end),
                 "segments that meet with equal gauge_widening_m",
                 "put `- {kind: transition, length_m: …}` between them"};
  }
  return {};
}

Status CheckSegments(const AlignmentParams& params) {
  PHS_CHECK(!params.segments.empty());
  for (const TrackSegment* end : {&params.segments.front(), &params.segments.back()}) {
    if (end->kind != SegmentKind::kTangent) {
      return Error{end->where, "the track begins or ends outside a tangent",
                   "a tangent as first and as last segment (the track goes on straight beyond)",
                   "add `- {kind: tangent, length_m: …}`"};
    }
  }
  for (size_t i = 1; i < params.segments.size(); ++i) {
    if (Status s = CheckJoint(params.segments[i - 1], params.segments[i]); !s.ok()) return s;
  }
  return {};
}

// Polyline through the values at both ends of each segment, with rounded corners. With `crossing` a
// vertex is added where the value changes sign within a segment.
Vertices RampVertices(const AlignmentParams& params, double TrackSegment::*begin,
                      double TrackSegment::*end, bool crossing) {
  Vertices vertices{{0, params.segments[0].*begin, 0}};
  double s = 0;
  for (const TrackSegment& segment : params.segments) {
    const double v0 = segment.*begin;
    const double v1 = segment.*end;
    if (crossing && v0 * v1 < 0) {
      vertices.push_back({s + segment.length * v0 / (v0 - v1), 0, 0});
    }
    s += segment.length;
    vertices.push_back({s, v1, 0});
  }
  for (size_t i = 1; i + 1 < vertices.size(); ++i) {
    const double nearest =
        std::min(vertices[i].s - vertices[i - 1].s, vertices[i + 1].s - vertices[i].s);
    vertices[i].half_length = std::min(params.ramp_rounding / 2, 0.49 * nearest);
  }
  return vertices;
}

// Rise of the centre line by cant about the low rail: half the superelevation of either hand.
RoundedPolyline RisePolyline(const AlignmentParams& params) {
  Vertices vertices =
      RampVertices(params, &TrackSegment::cant_begin, &TrackSegment::cant_end, true);
  const double share = params.pivot == CantPivot::kLowRail ? 0.5 : 0.0;
  for (auto& vertex : vertices) vertex.value = share * std::abs(vertex.value);
  return RoundedPolyline(vertices);
}

// Height from the gradients: vertices where the gradient changes, with vertical curves.
Result<RoundedPolyline> GradientPolyline(const AlignmentParams& params) {
  Vertices vertices{{0, 0, 0}};
  std::vector<const TrackSegment*> at{&params.segments[0]};
  double s = 0;
  double z = 0;
  for (size_t i = 0; i < params.segments.size(); ++i) {
    const TrackSegment& segment = params.segments[i];
    if (i > 0 && segment.gradient != params.segments[i - 1].gradient) {
      const double change = segment.gradient - params.segments[i - 1].gradient;
      vertices.push_back({s, z, params.vertical_radius * std::abs(change) / 2});
      at.push_back(&segment);
    }
    s += segment.length;
    z += segment.gradient * segment.length;
  }
  vertices.push_back({s, z, 0});
  for (size_t i = 1; i < vertices.size(); ++i) {
    const double room = vertices[i].s - vertices[i - 1].s;
    const double need = vertices[i].half_length + vertices[i - 1].half_length;
    if (need > room) {
      const TrackSegment* where = i < at.size() ? at[i] : at[i - 1];
      return Error{where->where,
                   "the vertical curve needs " + std::to_string(std::lround(need)) +
                       " m where the gradient holds for " + std::to_string(std::lround(room)) +
                       " m",
                   "vertical_radius_m times half the change of gradient within the neighbours",
                   "lengthen the segments or reduce vertical_radius_m"};
    }
  }
  return RoundedPolyline(vertices);
}

// Arc lengths of the knots: ends of segments, breaks of the ramps, and points between.
std::vector<double> KnotPositions(const AlignmentParams& params,
                                  std::initializer_list<const RoundedPolyline*> ramps) {
  std::vector<double> all{0};
  double s = 0;
  for (const TrackSegment& segment : params.segments) {
    const double sharpest =
        std::max(std::abs(segment.curvature_begin), std::abs(segment.curvature_end));
    const double spacing = std::min(kLargestSpacing, kLargestTurn / std::max(sharpest, 1e-9));
    const int count = static_cast<int>(std::ceil(segment.length / spacing));
    for (int i = 1; i < count; ++i) all.push_back(s + segment.length * i / count);
    s += segment.length;
    all.push_back(s);
  }
  for (const RoundedPolyline* ramp : ramps) {
    for (double at : ramp->Breaks()) {
      if (at > 0 && at < s) all.push_back(at);
    }
  }
  std::sort(all.begin(), all.end());
  // Of two nearly equal places the later one stays, where the later quadratic is in force.
  std::vector<double> knots{0};
  for (double at : all) {
    if (at - knots.back() < 1e-9 && knots.size() > 1) {
      knots.back() = at;
    } else if (at > 1e-9) {
      knots.push_back(at);
    }
  }
  return knots;
}

}  // namespace

Result<Alignment> Alignment::Create(const AlignmentParams& params) {
  if (Status s = CheckSegments(params); !s.ok()) return s.error();
  auto height = GradientPolyline(params);
  if (!height.ok()) return height.error();
  Alignment alignment;
  alignment.cant_base_ = params.cant_base;
  alignment.BuildKnots(params, height.value(), RisePolyline(params));
  alignment.BuildBuckets();
  if (Status s = alignment.BuildCells(params); !s.ok()) return s.error();
  return alignment;
}

void Alignment::BuildKnots(const AlignmentParams& params, const RoundedPolyline& height,
                           const RoundedPolyline& rise) {
  const RoundedPolyline cant(
      RampVertices(params, &TrackSegment::cant_begin, &TrackSegment::cant_end, false));
  const RoundedPolyline widening(
      RampVertices(params, &TrackSegment::widening_begin, &TrackSegment::widening_end, false));
  const std::vector<double> at = KnotPositions(params, {&height, &rise, &cant, &widening});
  size_t segment = 0;
  double segment_begin = 0;
  for (double s : at) {
    Knot knot;
    knot.s = s;
    if (!knots_.empty()) {
      const Knot& last = knots_.back();
      const PlanPoint p = Advance(last, s - last.s);
      knot.x = p.x;
      knot.y = p.y;
      knot.heading = last.heading + p.turn;
      knot.cos_heading = std::cos(knot.heading);
      knot.sin_heading = std::sin(knot.heading);
    }
    while (segment + 1 < params.segments.size() &&
           s >= segment_begin + params.segments[segment].length) {
      segment_begin += params.segments[segment].length;
      ++segment;
    }
    const TrackSegment& now = params.segments[segment];
    knot.curvature_rate = (now.curvature_end - now.curvature_begin) / now.length;
    knot.curvature = now.curvature_begin + knot.curvature_rate * (s - segment_begin);
    const Quadratic from_gradient = height.ExpandAt(s);
    const Quadratic from_cant = rise.ExpandAt(s);
    knot.height = {from_gradient.value + from_cant.value, from_gradient.slope + from_cant.slope,
                   from_gradient.half_second + from_cant.half_second};
    knot.cant = cant.ExpandAt(s);
    knot.widening = widening.ExpandAt(s);
    knots_.push_back(knot);
  }
}

void Alignment::BuildBuckets() {
  buckets_per_metre_ = 1 / kLargestSpacing;
  const size_t count = static_cast<size_t>(length() * buckets_per_metre_) + 1;
  bucket_.resize(count);
  std::int32_t knot = 0;
  for (size_t i = 0; i < count; ++i) {
    const double begin = static_cast<double>(i) / buckets_per_metre_;
    while (knot + 2 < static_cast<std::int32_t>(knots_.size()) &&
           knots_[static_cast<size_t>(knot) + 1].s <= begin) {
      ++knot;
    }
    // One bucket may begin a rounding error later than its index says: step back to be safe.
    bucket_[i] = std::max(0, knot - 1);
  }
}

Status Alignment::BuildCells(const AlignmentParams& params) {
  struct Entry {
    int knot;
    double distance2;
  };
  std::map<std::pair<std::int32_t, std::int32_t>, Entry> cells;
  const double near2 = kCellReach * kCellReach * kCellSize * kCellSize;
  for (size_t k = 0; k < knots_.size(); ++k) {
    std::int32_t ix = 0;
    std::int32_t iy = 0;
    CellIndex(knots_[k].x, &ix);
    CellIndex(knots_[k].y, &iy);
    for (std::int32_t i = ix - kCellReach; i <= ix + kCellReach; ++i) {
      for (std::int32_t j = iy - kCellReach; j <= iy + kCellReach; ++j) {
        const double dx = (i + 0.5) * kCellSize - knots_[k].x;
        const double dy = (j + 0.5) * kCellSize - knots_[k].y;
        const Entry entry{static_cast<int>(k), dx * dx + dy * dy};
        auto [found, is_new] = cells.try_emplace({i, j}, entry);
        if (is_new) continue;
        const double apart = knots_[k].s - knots_[static_cast<size_t>(found->second.knot)].s;
        if (apart > kSelfApproach && entry.distance2 < near2 && found->second.distance2 < near2) {
          return Error{params.segments.back().where,
                       "the track at s = " + std::to_string(std::lround(knots_[k].s)) +
                           " m comes within 32 m of itself",
                       "a track that keeps clear of itself (no crossings, no full circles)",
                       "shorten or open the curves"};
        }
        if (entry.distance2 < found->second.distance2) found->second = entry;
      }
    }
  }
  std::uint32_t size = 16;
  while (size < 2 * cells.size()) size *= 2;
  cells_.assign(size, Cell{});
  cell_mask_ = size - 1;
  for (const auto& [index, entry] : cells) {
    std::uint32_t slot = CellHash(index.first, index.second) & cell_mask_;
    while (cells_[slot].knot >= 0) slot = (slot + 1) & cell_mask_;
    cells_[slot] = {index.first, index.second, entry.knot};
  }
  return {};
}

int Alignment::NearestKnot(const Vec3& point) const noexcept {
  std::int32_t ix = 0;
  std::int32_t iy = 0;
  if (!CellIndex(point[0], &ix) || !CellIndex(point[1], &iy)) return 0;
  for (std::uint32_t slot = CellHash(ix, iy) & cell_mask_; cells_[slot].knot >= 0;
       slot = (slot + 1) & cell_mask_) {
    if (cells_[slot].ix == ix && cells_[slot].iy == iy) return cells_[slot].knot;
  }
  // Far from the track: beyond one of its ends, or thrown off.
  const int last = static_cast<int>(knots_.size()) - 1;
  for (int end : {0, last}) {
    const Knot& knot = knots_[static_cast<size_t>(end)];
    const double dx = point[0] - knot.x;
    const double dy = point[1] - knot.y;
    const double along = dx * knot.cos_heading + dy * knot.sin_heading;
    const double across = dy * knot.cos_heading - dx * knot.sin_heading;
    if ((end == 0 ? along < 0 : along > 0) && std::abs(across) < 2 * kCellSize) return end;
  }
  int best = 0;
  double best2 = 1e300;
  for (size_t k = 0; k < knots_.size(); ++k) {
    const double dx = point[0] - knots_[k].x;
    const double dy = point[1] - knots_[k].y;
    if (dx * dx + dy * dy < best2) {
      best2 = dx * dx + dy * dy;
      best = static_cast<int>(k);
    }
  }
  return best;
}

}  // namespace phs::rail
