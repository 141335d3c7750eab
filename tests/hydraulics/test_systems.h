// Systems used by several tests, built from parameters alone.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hydraulics/phs_system.h"

namespace phs::hydraulics {

/// Four cylinders, cross lines on the rods, diagonal lines on the bores; setup 2.
inline PhsParams BoBo() {
  PhsParams p;
  p.name = "bo_bo";
  const char* bore[] = {"L2", "L3", "L2", "L3"};
  const char* rod[] = {"L1", "L1", "L4", "L4"};
  for (int i = 0; i < 4; ++i) {
    CylinderParams c;
    c.name = std::to_string(i + 1);
    c.bore_line = bore[i];
    c.rod_line = rod[i];
    p.cylinders.push_back(c);
  }
  const double ratio = p.cylinders[0].BoreArea() / p.cylinders[0].RodArea();
  for (int i = 0; i < 4; ++i) {
    LineParams l;
    l.name = "L" + std::to_string(i + 1);
    const bool cross = i == 0 || i == 3;
    l.static_pressure_Pa = cross ? 1.8e6 * ratio : 1.8e6;
    l.gas_volume_m3 = 16.16e-6;
    l.reservoir.volume_m3 = 0.32e-3;
    if (cross) l.accumulator.volume_m3 = 0.75e-3;
    p.lines.push_back(l);
  }
  return p;
}

/// One cylinder with its two lines.
inline PhsParams Quarter() {
  PhsParams p = BoBo();
  p.name = "quarter";
  p.cylinders.resize(1);
  p.lines.resize(2);
  return p;
}

inline PhsSystem Make(const PhsParams& params, const EffectTable* effects = nullptr) {
  Result<PhsSystem> system = PhsSystem::Create(params, effects);
  EXPECT_TRUE(system.ok()) << (system.ok() ? "" : system.error().Line());
  return std::move(system.value());
}

/// Outputs with their own storage.
struct Evaluation {
  std::vector<double> force, pressure_force, friction, piston, p_bore, p_rod, pressure;
  PhsOutputs out;
  explicit Evaluation(const PhsSystem& s)
      : force(s.num_cylinders()),
        pressure_force(force),
        friction(force),
        piston(force),
        p_bore(force),
        p_rod(force),
        pressure(s.num_lines()) {
    out.force = force.data();
    out.pressure_force = pressure_force.data();
    out.friction_force = friction.data();
    out.piston = piston.data();
    out.p_bore = p_bore.data();
    out.p_rod = p_rod.data();
    out.pressure = pressure.data();
  }
  Evaluation(const Evaluation&) = delete;
};

}  // namespace phs::hydraulics
