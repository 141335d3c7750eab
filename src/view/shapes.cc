#include "view/shapes.h"

#include <algorithm>
#include <cmath>

namespace phs::view {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using rail::Side;

constexpr double kProfileStep = 3.0e-3;  ///< of the drawn outlines [m]

/// Points of a profile from end to end, (y outward, z down).
std::vector<Vector2d> OutlineOf(const rail::Profile& profile, double step) {
  std::vector<Vector2d> points;
  const int count =
      std::max(2, static_cast<int>(std::ceil((profile.max_y() - profile.min_y()) / step)));
  for (int i = 0; i <= count; ++i) {
    const double y = profile.min_y() + (profile.max_y() - profile.min_y()) * i / count;
    points.emplace_back(y, profile.At(y).z);
  }
  return points;
}

/// Where numbers stand for the profiles: a cone on a flat head.
std::vector<Vector2d> PlainTread() {
  return {{-0.07, 0.028}, {-0.04, 0.028}, {-0.03, 0}, {0.065, 0}};
}
std::vector<Vector2d> PlainHead() { return {{-0.036, 0.02}, {-0.03, 0}, {0.03, 0}, {0.036, 0.02}}; }

}  // namespace

double WheelPosition(const rail::WheelRail& wheel_rail) {
  return wheel_rail.wheel_profile() == nullptr ? 0.5 * wheel_rail.params().gauge + 0.033
                                               : wheel_rail.wheel_position();
}

double RailPosition(const rail::WheelRail& wheel_rail) {
  return wheel_rail.rail_profile() == nullptr ? 0.5 * wheel_rail.params().gauge + 0.036
                                              : wheel_rail.rail_position();
}

std::vector<Vector2d> WheelOutline(const rail::WheelRail& wheel_rail) {
  const rail::Profile* profile = wheel_rail.wheel_profile();
  std::vector<Vector2d> outline =
      profile == nullptr ? PlainTread() : OutlineOf(*profile, kProfileStep);
  constexpr double kRim = 0.065;  // depth of the rim below the tape circle [m]
  const double back = outline.front().x();
  const double face = outline.back().x();
  outline.emplace_back(face, -kRim);
  outline.emplace_back(back, -kRim);
  return outline;
}

Mesh WheelMesh(const rail::WheelRail& wheel_rail) {
  const double radius = wheel_rail.params().wheel_radius;
  const rail::Profile* profile = wheel_rail.wheel_profile();
  const std::vector<Vector2d> tread =
      profile == nullptr ? PlainTread() : OutlineOf(*profile, kProfileStep);
  const double back = tread.front().x();
  const double face = tread.back().x();
  // Shares of the radius, so that any wheel looks like one.
  const double rim = 0.88 * radius;
  const double hub = 0.22 * radius;
  const double bore = 0.14 * radius;
  Section section;
  section.edge_angle = 0.9;
  // Anticlockwise with y to the right and the radius up: along the tread from the outer face in.
  for (auto p = tread.rbegin(); p != tread.rend(); ++p) {
    section.point.emplace_back(p->x(), radius + p->y());
  }
  const double web = 0.5 * (back + face);
  for (const Vector2d& p : std::vector<Vector2d>{{back, rim},
                                                 {web - 0.020, rim - 0.035},
                                                 {web - 0.024, 0.62 * radius},
                                                 {web - 0.014, hub + 0.06},
                                                 {back - 0.015, hub},
                                                 {back - 0.015, bore},
                                                 {face + 0.01, bore},
                                                 {face + 0.01, hub},
                                                 {web + 0.026, hub + 0.06},
                                                 {web + 0.006, 0.62 * radius},
                                                 {web + 0.012, rim - 0.035},
                                                 {face, rim}}) {
    section.point.push_back(p);
  }
  return Revolve(section, 72);
}

Mesh Mirrored(const Mesh& mesh) {
  Mesh mirrored = mesh;
  for (auto& v : mirrored.vertex) v.y() = -v.y();
  for (auto& n : mirrored.normal) n.y() = -n.y();
  for (auto& f : mirrored.face) std::swap(f[1], f[2]);
  return mirrored;
}

Section RailSection(const rail::WheelRail& wheel_rail) {
  const rail::Profile* profile = wheel_rail.rail_profile();
  std::vector<Vector2d> head = profile == nullptr ? PlainHead() : OutlineOf(*profile, 4e-3);
  Section section;
  section.edge_angle = 0.6;
  // (y outward = to the left, z up): anticlockwise over the head from the right end to the left.
  for (const Vector2d& p : head) section.point.emplace_back(p.x(), -p.y());
  const double in = head.front().x();
  const double out = head.back().x();
  const double middle = 0.5 * (in + out);
  const double below = -std::max(0.037, std::max(head.front().y(), head.back().y()) + 0.004);
  // Half widths over the height below: head, fishing surfaces, web, foot.
  const std::vector<Vector2d> half = {{0.5 * (out - in) - 0.002, below},
                                      {0.0095, below - 0.016},
                                      {0.00825, -0.090},
                                      {0.010, -0.130},
                                      {0.030, -0.146},
                                      {0.075, -0.1605},
                                      {0.075, -kRailHeight}};
  for (const Vector2d& p : half) section.point.emplace_back(middle + p.x(), p.y());
  for (auto p = half.rbegin(); p != half.rend(); ++p) {
    section.point.emplace_back(middle - p->x(), p->y());
  }
  // From the head's inner end over the top to the outer end and down is clockwise.
  std::reverse(section.point.begin(), section.point.end());
  return section;
}

std::vector<double> TrackStations() {
  std::vector<double> places = {0};
  for (double step = 0.2, at = 0; at < 90; step = at < 6 ? 0.2 : std::min(2.0, step * 1.06)) {
    at += step;
    places.push_back(at);
    places.insert(places.begin(), -at);
  }
  return places;
}

Mesh RailMesh(const Section& section, const rail::Track& track, const rail::WheelRail& wheel_rail,
              Side side, double s, const Vector3d& origin) {
  const double hand = side == Side::kLeft ? 1 : -1;
  Section own = section;
  if (side == Side::kRight) {
    for (Vector2d& p : own.point) p.x() = -p.x();
    std::reverse(own.point.begin(), own.point.end());
  }
  std::vector<Station> stations;
  for (const double place : TrackStations()) {
    const rail::TrackFrame frame = track.FrameAt(s + place);
    const rail::RailOffset offset = track.Rail(side, s + place);
    const Vector3d left = ToEigen(frame.left);
    const Vector3d up = ToEigen(frame.up);
    const double y = hand * RailPosition(wheel_rail) + offset.lateral;
    stations.push_back(
        {ToEigen(frame.origin) - origin + left * y + up * offset.vertical, left, up});
  }
  return Sweep(own, stations);
}

Section BallastSection(const rail::Track& track) {
  const double half = 0.5 * track.gauge() + 1.05;
  Section section;
  section.point = {{-half - 0.8, -0.80}, {half + 0.8, -0.80}, {half, -0.235}, {-half, -0.235}};
  return section;
}

Mesh BallastMesh(const rail::Track& track, double s, const Vector3d& origin) {
  const Section section = BallastSection(track);
  std::vector<Station> stations;
  for (const double place : TrackStations()) {
    const rail::TrackFrame frame = track.FrameAt(s + place);
    stations.push_back({ToEigen(frame.origin) - origin, ToEigen(frame.left), ToEigen(frame.up)});
  }
  return Sweep(section, stations);
}

}  // namespace phs::view
