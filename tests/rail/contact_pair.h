// Wheel-rail pairs and states for the tests of contact.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "phs_places.h"
#include "rail/wheel_rail.h"

namespace phs::rail {

inline std::string ProfilePath(const std::string& name) {
  return std::string(PHS_SOURCE_DIR) + "/models/profiles/" + name;
}

/// S1002 on UIC60 (already inclined 1:40), 1435 mm, closed-form creep law, no damping.
inline WheelRailParams StandardPair() {
  WheelRailParams p;
  p.wheel_profile = ProfilePath("S1002.prw");
  p.rail_profile = ProfilePath("UIC60.prr");
  p.gauge = 1.435;
  p.flange_back_distance = 1.360;
  p.flange_back_position = -0.070;
  p.wheel_radius = 0.460;
  p.creep.method = "polach";
  p.damping_ratio = 0;
  return p;
}

/// Cone on a circular rail head whose axis lies at y = 0.75 m; tape circle there too.
inline WheelRailParams ConeOnArc(const std::string& cone, const std::string& arc) {
  WheelRailParams p = StandardPair();
  p.wheel_profile = "cone:" + cone;
  p.rail_profile = "arc:" + arc;
  return p;
}

inline WheelRail Create(const WheelRailParams& params) {
  auto pair = WheelRail::Create(params);
  if (!pair.ok()) ADD_FAILURE() << pair.error().Line();
  return std::move(pair).value();
}

inline WheelRailForces Calc(const WheelRail& pair, const WheelsetMotion& motion,
                            const RailSupport& support = {}, const RailOffset& rail = {},
                            Side side = Side::kRight) {
  WheelRailForces forces;
  pair.Calc(motion, side, rail, support, &forces);
  return forces;
}

/// Rolling forwards about the own axle.
inline WheelsetMotion Rolling(const WheelRail& pair, double speed, double lateral, double roll,
                              double yaw) {
  WheelsetMotion m;
  m.lateral = lateral;
  m.roll = roll;
  m.yaw = yaw;
  m.vertical = pair.touching_height();
  m.speed = speed;
  m.velocity = {speed, 0, 0};
  const double spin = -speed / pair.params().wheel_radius;
  m.rotation = {-std::sin(yaw) * std::cos(roll) * spin, std::cos(yaw) * std::cos(roll) * spin,
                std::sin(roll) * spin};
  return m;
}

/// Height at which the rail carries a vertical load; the forces there.
inline WheelRailForces Load(const WheelRail& pair, double load, WheelsetMotion* m,
                            const RailSupport& support = {}) {
  double high = -pair.params().wheel_radius - 0.05;
  double low = -pair.params().wheel_radius + 0.03;
  for (int i = 0; i < 60; ++i) {
    m->vertical = 0.5 * (low + high);
    (-Calc(pair, *m, support).force[2] > load ? low : high) = m->vertical;
  }
  return Calc(pair, *m, support);
}

}  // namespace phs::rail
