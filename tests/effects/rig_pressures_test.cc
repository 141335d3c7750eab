// Pressures that follow from the motion alone are kept between runs: the same numbers to the bit.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "effects/rig_model.h"
#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

RigMotion TwoSines() {
  RigMotion motion{0, 0.005, {{}}, {}, {}, {}};
  for (int i = 0; i < 2000; ++i) {
    const double t = i * motion.step_s;
    motion.position_m[0].push_back(2e-3 * std::sin(2 * t) + 4e-4 * std::sin(9 * t));
  }
  return motion;
}

/// Every turning point is a sample.
RigMotion TurningAtSamples() {
  RigMotion motion{0, 0.005, {{}}, {}, {}, {}};
  for (int i = 0; i < 1200; ++i) {
    motion.position_m[0].push_back(2e-3 * (1 - std::cos(2 * M_PI * i / 300)));
  }
  return motion;
}

PhsParams Quarter2() { return FindPhsParams("quarter_setup2").value(); }

RigPrediction RunRig(const PhsParams& params, std::shared_ptr<const RigPressures>* pressures,
                     const RigMotion& motion = TwoSines()) {
  const auto rig = RigModel::Create(RigKind::kQuarter, params);
  EXPECT_TRUE(rig.ok());
  RigPrediction out;
  EXPECT_TRUE(rig.value().Run(motion, &out, pressures).ok());
  return out;
}

TEST(RigPressures, OfAnotherFrictionGiveTheSameRunToTheBit) {
  PhsParams first = With(Quarter2(), "entrained_air", {{"air_fraction", 0.01}});
  first = With(first, "line_inertance", {{"inertance_kg_per_m4", 1e8}});
  PhsParams second = With(first, "pressure_friction", {{"bore_N_per_Pa", 5e-5}});
  second = With(second, "presliding", {{"stiffness_N_per_m", 1e7}});
  second = With(second, "dwell_friction", {{"extra_N", 300}});
  second = With(second, "sensor_gain", {{"load", 1.1}, {"p_bore", 0.9}});
  second.friction.scale = 1.3;
  ASSERT_EQ(HydraulicsOf(first), HydraulicsOf(second));
  std::shared_ptr<const RigPressures> kept, none;
  RunRig(first, &kept);
  ASSERT_NE(kept, nullptr);
  const RigPrediction alone = RunRig(second, &none), from_kept = RunRig(second, &kept);
  EXPECT_EQ(alone.channels, from_kept.channels);
}

TEST(RigPressures, AndForcesAreThoseOfTheSystemStepByStep) {
  PhsParams params = With(Quarter2(), "entrained_air", {{"air_fraction", 0.01}});
  params = With(params, "pressure_friction", {{"bore_N_per_Pa", 5e-5}, {"rod_N_per_Pa", 2e-5}});
  params = With(params, "presliding", {{"stiffness_N_per_m", 1e7}});
  params = With(params, "line_resistance", {{"laminar_Pas_per_m3", 2e9}});
  std::shared_ptr<const RigPressures> none;
  const RigMotion motion = TurningAtSamples();
  const RigPrediction run = RunRig(params, &none, motion);
  const PhsSystem system = CreatePhsSystem(params).value();
  const std::vector<double>& x = motion.position_m[0];
  const std::vector<double> speed = DifferentiateMotion(x, motion.step_s);
  std::vector<double> state(static_cast<size_t>(system.num_states()), 0.0), rate(state);
  hydraulics::PhsOutputs at;
  double force, bore, rod;
  at.force = &force, at.p_bore = &bore, at.p_rod = &rod;
  for (size_t i = 0; i < x.size(); ++i) {
    const double t = static_cast<double>(i) * motion.step_s;
    system.Calc(t, &x[i], &speed[i], state.data(), &at);
    ASSERT_NEAR(run.channels[1][i], force, 1e-6) << i;
    ASSERT_NEAR(run.channels[2][i], bore, 1e-4) << i;
    ASSERT_NEAR(run.channels[3][i], rod, 1e-4) << i;
    if (i + 1 == x.size()) break;
    const double v = (x[i + 1] - x[i]) / motion.step_s;
    system.CalcStateRate(t, motion.step_s, &x[i], &v, state.data(), rate.data());
    for (size_t j = 0; j < state.size(); ++j) state[j] += motion.step_s * rate[j];
  }
}

// A stiff bristle (z_s some 10 um) on coarse samples: what lies beyond the samples of a reversal
// counts. Reference: the same cubic between the samples, in 40 steps to each.
TEST(RigModel, ABristleTurnsWhereTheMotionTurns) {
  const PhsParams params = With(Quarter2(), "presliding", {{"stiffness_N_per_m", 1e8}});
  RigMotion motion{0, 0.02, {{}}, {}, {}, {}};
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

TEST(RigPressures, BelongToOneHydraulics) {
  const PhsParams plain = Quarter2();
  PhsParams volume = plain;
  volume.lines[1].oil_volume_m3 *= 1.01;
  EXPECT_NE(HydraulicsOf(plain), HydraulicsOf(volume));
  EXPECT_NE(HydraulicsOf(plain), HydraulicsOf(With(plain, "piston_leakage", {})));
  EXPECT_NE(HydraulicsOf(plain), HydraulicsOf(With(plain, "temperature_drift", {})));
  PhsParams valve = plain;
  valve.effects.push_back({"unlisted", {"L2"}, {{"c1_m3_per_s", 1e-9}}, "c1*(p/1e6[Pa])"});
  EXPECT_NE(HydraulicsOf(plain), HydraulicsOf(valve));
  PhsParams force = plain;
  force.effects.push_back({"unlisted", {}, {{"c1_N", 10}}, "c1*(x/0.001[m])"});
  EXPECT_EQ(HydraulicsOf(plain), HydraulicsOf(force));
}

TEST(RigPressures, AreNotKeptWhereFrictionActsBack) {
  std::shared_ptr<const RigPressures> kept;
  RunRig(With(Quarter2(), "mount_compliance", {}), &kept);
  EXPECT_EQ(kept, nullptr);
}

}  // namespace
}  // namespace phs::effects
