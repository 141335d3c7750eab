// Pressures that follow from the motion alone are kept between runs: the same numbers to the bit.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "phs_model/phs_model.h"
#include "rigs/rig_model.h"
#include "tests/effects/driven_cylinder.h"

namespace phs::effects {

using phs_model::CreatePhsSystem;
using phs_model::FindPhsParams;
using rigs::DifferentiateMotion;
using rigs::KeptOf;
using rigs::KeptRun;
using rigs::RigKind;
using rigs::RigModel;
using rigs::RigMotion;
using rigs::RigOptions;
using rigs::RigPrediction;
namespace {

RigMotion TwoSines() {
  RigMotion motion{0, 0.005, {{}}, {}, {}, {}, {}};
  for (int i = 0; i < 2000; ++i) {
    const double t = i * motion.step_s;
    motion.position_m[0].push_back(2e-3 * std::sin(2 * t) + 4e-4 * std::sin(9 * t));
  }
  return motion;
}

/// Share of a step after which the cubic through both ends, with their speeds, turns; 1 if it does
/// not. By bisection.
double TurnOf(double x0, double x1, double v0, double v1, double h) {
  const auto speed = [&](double s) {
    return 6 * s * (1 - s) * (x1 - x0) / h + (1 - s) * (1 - 3 * s) * v0 + s * (3 * s - 2) * v1;
  };
  if (v0 * v1 >= 0) return 1;
  double low = 0, high = 1;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (speed(middle) * v0 > 0 ? low : high) = middle;
  }
  return low;
}

hydraulics::PhsParams Of(const PhsParams& params) { return KeptOf(RigKind::kQuarter, params); }

PhsParams Quarter2() { return FindPhsParams("quarter_setup2").value(); }

RigPrediction RunRig(const PhsParams& params, std::shared_ptr<const KeptRun>* pressures) {
  const auto rig = RigModel::Create(RigKind::kQuarter, params);
  EXPECT_TRUE(rig.ok());
  RigPrediction out;
  EXPECT_TRUE(rig.value().Run(TwoSines(), &out, pressures).ok());
  return out;
}

TEST(KeptRun, OfAnotherFrictionGiveTheSameRunToTheBit) {
  PhsParams first = With(Quarter2(), "entrained_air", {{"air_fraction", 0.01}});
  first = With(first, "line_inertance", {{"inertance_kg_per_m4", 1e8}});
  PhsParams second = With(first, "pressure_friction", {{"bore_N_per_Pa", 5e-5}});
  second = With(second, "presliding", {{"stiffness_N_per_m", 1e7}});
  second = With(second, "dwell_friction", {{"extra_N", 300}});
  second = With(second, "sensor_gain", {{"load", 1.1}, {"p_bore", 0.9}});
  second.friction.scale = 1.3;
  ASSERT_EQ(Of(first), Of(second));
  std::shared_ptr<const KeptRun> kept, none;
  RunRig(first, &kept);
  ASSERT_NE(kept, nullptr);
  const RigPrediction alone = RunRig(second, &none), from_kept = RunRig(second, &kept);
  EXPECT_EQ(alone.channels, from_kept.channels);
}

TEST(KeptRun, AndForcesAreThoseOfTheSystemStepByStep) {
  PhsParams params = With(Quarter2(), "entrained_air", {{"air_fraction", 0.01}});
  params = With(params, "pressure_friction", {{"bore_N_per_Pa", 5e-5}, {"rod_N_per_Pa", 2e-5}});
  params = With(params, "presliding", {{"stiffness_N_per_m", 1e7}});
  params = With(params, "line_resistance", {{"laminar_Pas_per_m3", 2e9}});
  params = With(params, "dwell_friction", {{"extra_N", 300}, {"time_s", 0.5}});
  std::shared_ptr<const KeptRun> none;
  const RigMotion motion = TwoSines();
  const RigPrediction run = RunRig(params, &none);
  const PhsSystem system = CreatePhsSystem(params).value();
  const int friction = system.num_friction_states();
  ASSERT_EQ(friction, 2);
  const std::vector<double>& x = motion.position_m[0];
  const std::vector<double> speed = DifferentiateMotion(x, motion.step_s);
  std::vector<double> state(static_cast<size_t>(system.num_states()), 0.0), rate(state);
  hydraulics::PhsOutputs at;
  double force, bore, rod;
  hydraulics::Instant instant;
  at.force = &force, at.p_bore = &bore, at.p_rod = &rod;
  for (size_t i = 0; i < x.size(); ++i) {
    const double t = static_cast<double>(i) * motion.step_s;
    system.Calc(t, &x[i], &speed[i], state.data(), &at);
    ASSERT_NEAR(run.channels[1][i], force, 1e-6) << i;
    ASSERT_NEAR(run.channels[2][i], bore, 1e-4) << i;
    ASSERT_NEAR(run.channels[3][i], rod, 1e-4) << i;
    if (i + 1 == x.size()) break;
    const double h = motion.step_s, v = (x[i + 1] - x[i]) / h;
    double before[2];
    system.CalcHydraulics(t, h, &x[i], {&v, &speed[i + 1]}, state.data(), &instant, rate.data(),
                          before, before + 1);
    for (size_t j = friction; j < state.size(); ++j) state[j] += h * rate[j];
    // Friction goes to where the motion turns, and back.
    const double s = TurnOf(x[i], x[i + 1], speed[i], speed[i + 1], h);
    const double at_turn = x[i] +
                           h * (s * (1 - s) * (1 - s) * speed[i] - s * s * (1 - s) * speed[i + 1]) +
                           s * s * (3 - 2 * s) * (x[i + 1] - x[i]);
    const double ways[2] = {at_turn - x[i], x[i + 1] - at_turn}, times[2] = {s * h, h - s * h};
    for (int part = 0; part < 2; ++part) {
      if (times[part] <= 0) continue;
      const double from = part == 0 ? x[i] : at_turn, slow = ways[part] / times[part];
      system.CalcFrictionRate(t + (part == 0 ? 0 : times[0]), times[part], &from, &slow,
                              state.data(), &bore, &rod, rate.data());
      for (int j = 0; j < friction; ++j) state[j] += times[part] * rate[j];
    }
  }
}

// A stiff bristle (z_s some 10 um) on coarse samples: what lies beyond the samples of a reversal
// counts. Reference: the same cubic between the samples, in 40 steps to each.
TEST(RigModel, ABristleTurnsWhereTheMotionTurns) {
  const PhsParams params = With(Quarter2(), "presliding", {{"stiffness_N_per_m", 1e8}});
  RigMotion motion{0, 0.02, {{}}, {}, {}, {}, {}};
  for (int i = 0; i < 500; ++i) {
    motion.position_m[0].push_back(4e-4 * std::sin(2 * M_PI * 2.3 * i * motion.step_s));
  }
  std::vector<double> force[2];
  for (const int substeps : {1, 40}) {
    RigOptions options;
    options.substeps = substeps;
    const auto rig = RigModel::Create(RigKind::kQuarter, params, options);
    RigPrediction out;
    ASSERT_TRUE(rig.value().Run(motion, &out).ok());
    force[substeps > 1] = out.channels[1];
  }
  double worst = 0;
  for (size_t i = 0; i < force[0].size(); ++i) {
    worst = std::max(worst, std::abs(force[0][i] - force[1][i]));
  }
  EXPECT_LT(worst, 60) << "of a level of 1600 N";
}

TEST(KeptRun, BelongToOneHydraulics) {
  const PhsParams plain = Quarter2();
  PhsParams volume = plain;
  volume.lines[1].oil_volume_m3 *= 1.01;
  EXPECT_NE(Of(plain), Of(volume));
  EXPECT_NE(Of(plain), Of(With(plain, "piston_leakage", {})));
  EXPECT_NE(Of(plain), Of(With(plain, "temperature_drift", {})));
  PhsParams valve = plain;
  valve.effects.push_back({"unlisted", {"L2"}, {{"c1_m3_per_s", 1e-9}}, "c1*(p/1e6[Pa])"});
  EXPECT_NE(Of(plain), Of(valve));
  PhsParams force = plain;
  force.effects.push_back({"unlisted", {}, {{"c1_N", 10}}, "c1*(x/0.001[m])"});
  EXPECT_EQ(Of(plain), Of(force));
}

/// Behind a mounting that yields friction acts back on the pressures, on the full rig through the
/// beam: what another instrument shows of such a run is the same to the bit, another friction's is
/// a run of its own.
TEST(KeptRun, OfAnotherInstrumentGivesTheSameWhereFrictionActsBack) {
  const PhsParams plain = With(Quarter2(), "mount_compliance", {});
  PhsParams shown = With(plain, "sensor_gain", {{"load", 1.1}, {"p_bore", 0.9}});
  shown = With(shown, "sensor_delay", {{"load_s", 0.02}});
  PhsParams other = plain;
  other.friction.scale = 1.3;
  EXPECT_EQ(Of(plain), Of(shown));
  EXPECT_NE(Of(plain), Of(other));
  std::shared_ptr<const KeptRun> kept, none;
  RunRig(plain, &kept);
  ASSERT_NE(kept, nullptr);
  const RigPrediction alone = RunRig(shown, &none), from_kept = RunRig(shown, &kept);
  EXPECT_EQ(alone.channels, from_kept.channels);

  const PhsParams four = FindPhsParams("bo_bo").value();
  PhsParams held = four;
  held.friction.scale = 1.3;
  EXPECT_NE(KeptOf(RigKind::kFull, four), KeptOf(RigKind::kFull, held));
  EXPECT_EQ(KeptOf(RigKind::kFull, four),
            KeptOf(RigKind::kFull, With(four, "sensor_drift", {{"load_N_per_s", 3}})));
}

}  // namespace
}  // namespace phs::effects
