// Friction, mounting, rig and sensors of the generator against closed formulas and a finer step.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "set_writer.h"

namespace rigdata {
namespace {

// Loop of a triangle of half amplitude a at constant speed: ∮F dx = 2a (F(v) − F(−v)); the
// hydraulics gives its work back.
TEST(Friction, LoopAreaOfATriangle) {
  const double a = 2e-3, v = 0.004, period = 4 * a / v;
  const auto triangle = [&](double t) {
    const double u = t / period - std::floor(t / period);
    return a * (u < 0.25 ? 4 * u : (u < 0.75 ? 2 - 4 * u : 4 * u - 4));
  };
  RigParams rig = NominalRig();
  rig.friction.scale = 1.2;
  const RigSignals s = Simulate(rig, {triangle, {}}, {1e-4, 1000, 2 * period + 1e-3});
  double work = 0;
  for (size_t i = s.size() - 1; s.t[i] > period; --i) {
    work += 0.5 * (s.load[i] + s.load[i - 1]) * (s.actuator[i] - s.actuator[i - 1]);
  }
  const double expected = 2 * a * 1.2 * (FrictionTruth::Table(v) - FrictionTruth::Table(-v));
  EXPECT_NEAR(work, expected, 0.005 * expected);
}

double ForceAfter(const FrictionParams& params, double distance, double v) {
  const FrictionTruth friction(params);
  FrictionState state, next;
  const double h = 1e-5;
  double force = 0;
  for (double x = 0; x < distance; x += v * h) {
    force = friction.Force(state, {x, v, 0, 2e6, 2e6}, h, &next);
    state = next;
  }
  return force;
}

// Closed forms from rest at the constant level F_c: LuGre F_c (1 − e^(−x/z)); Dahl with exponent 2
// F_c (1 − 1/(1 + x/z)); Maxwell slip: sum of elastic and sliding elements.
TEST(Friction, PreslidingCurvesFollowTheirClosedForms) {
  FrictionParams params;
  params.presliding_distance = 40e-6;
  const double v = 0.00019, level = 1700;  // within the table's first segment: constant level
  for (const double x : {10e-6, 40e-6, 120e-6}) {
    params.presliding = PreslidingForm::kLuGre;
    EXPECT_NEAR(ForceAfter(params, x, v), level * (1 - std::exp(-x / 40e-6)), 2) << x;
    params.presliding = PreslidingForm::kDahl;
    EXPECT_NEAR(ForceAfter(params, x, v), level * (1 - 1 / (1 + x / 40e-6)), 2) << x;
  }
  params.presliding = PreslidingForm::kMaxwellSlip;
  EXPECT_NEAR(ForceAfter(params, 125e-6, v), level, 2);
  EXPECT_LT(ForceAfter(params, 20e-6, v), 0.8 * level);
}

TEST(Friction, StuckPresslidingHoldsItsForceAtRest) {
  FrictionParams params;
  params.presliding = PreslidingForm::kLuGre;
  const FrictionTruth friction(params);
  FrictionState state, next;
  state.strain[0] = 10e-6;
  const double before = friction.Force(state, {}, 1e-4, &next);
  for (int i = 0; i < 10000; ++i) {
    state = next;
    friction.Force(state, {}, 1e-4, &next);
  }
  EXPECT_DOUBLE_EQ(friction.Force(next, {}, 1e-4, &state), before);
  EXPECT_GT(before, 100);
}

TEST(Mount, ZenerRelaxesByItsBranch) {
  MountParams params;
  params.stiffness = 1e8;
  params.branches = {{0.5, 0.4}};
  const MountTruth mount(params);
  MountState state, next;
  double force = 0;
  for (int i = 0; i <= 8000; ++i) {
    force = mount.Force(state, 1e-4, 1e-4, &next);
    state = next;
  }
  EXPECT_NEAR(force, 1e8 * 1e-4 * (1 + 0.5 * std::exp(-0.8 / 0.4)), 3);
}

TEST(Mount, SpringAndGapSeparateActuatorAndPiston) {
  RigParams rig = NominalRig();
  rig.mount.rigid = false;
  rig.mount.stiffness = 5e8;
  rig.mount.gap = 60e-6;
  const auto move = [](double t) { return 2e-3 * std::sin(kTwoPi * 0.5 * t); };
  const RigSignals s = Simulate(rig, {move, {}}, {1e-4, 200, 4});
  int pulled = 0, pushed = 0;
  for (size_t i = 1; i < s.size(); ++i) {
    if (std::abs(s.load[i]) < 1) continue;
    const double gap = s.load[i] > 0 ? 30e-6 : -30e-6;
    EXPECT_NEAR(s.actuator[i] - s.piston[i], gap + s.load[i] / 5e8, 1e-10);
    (s.load[i] > 0 ? pulled : pushed)++;
  }
  EXPECT_GT(pulled, 100);
  EXPECT_GT(pushed, 100);
}

// Every effect in the rig at once: halving the step halves the error (first order).
TEST(Rig, ErrorHalvesWithTheStep) {
  TrueRig rig{NominalRig(), {}};
  for (const std::string name : {"gas_thermal", "hose_expansion", "external_leakage", "presliding",
                                 "mount_compliance", "line_resistance"}) {
    RandomSource random(5, name);
    DrawEffect(name, random).apply(1.0, &rig);
  }
  const auto move = [](double t) {
    return SmoothStep(t / 0.5) *
           (1.5e-3 * std::sin(kTwoPi * 0.7 * t) + 0.3e-3 * std::sin(kTwoPi * 2.3 * t));
  };
  const auto run = [&](double h) { return Simulate(rig.rig, {move, {}}, {h, 200, 3}); };
  const RigSignals coarse = run(4e-4), middle = run(2e-4), fine = run(1e-4);
  double first = 0, second = 0, load_first = 0, load_second = 0;
  for (size_t i = 0; i < fine.size(); ++i) {
    first += std::abs(coarse.p_rod[i] - middle.p_rod[i]);
    second += std::abs(middle.p_rod[i] - fine.p_rod[i]);
    load_first += std::abs(coarse.load[i] - middle.load[i]);
    load_second += std::abs(middle.load[i] - fine.load[i]);
  }
  EXPECT_NEAR(first / second, 2.0, 0.3);
  EXPECT_NEAR(load_first / load_second, 2.0, 0.4);
}

// With the step of the data sets, what the step leaves is well below the sensors' noise.
TEST(Rig, StepErrorIsFarBelowTheNoiseForEveryEffect) {
  const auto move = [](double t) {
    return SmoothStep(t / 0.3) *
           (1.2e-3 * std::sin(kTwoPi * 1.1 * t) + 0.5e-3 * std::sin(kTwoPi * 3.7 * t));
  };
  for (const std::string& name : ListedNames()) {
    if (name.rfind("sensor", 0) == 0) continue;
    TrueRig rig{NominalRig(), {}};
    const HiddenEffect effect = DrawEffect(name, RandomSource(11, name));
    effect.apply(std::min(1.0, effect.largest), &rig);
    const RigSignals a = Simulate(rig.rig, {move, {}}, {5e-5, 200, 1.2});
    const RigSignals b = Simulate(rig.rig, {move, {}}, {2.5e-5, 200, 1.2});
    double pressure = 0, load = 0;
    for (size_t i = 0; i < a.size(); ++i) {
      pressure += std::pow(a.p_rod[i] - b.p_rod[i], 2) + std::pow(a.p_bore[i] - b.p_bore[i], 2);
      load += std::pow(a.load[i] - b.load[i], 2);
    }
    EXPECT_LT(std::sqrt(0.5 * pressure / a.size()), 0.3 * 5.5e3) << name;
    EXPECT_LT(std::sqrt(load / a.size()), 0.3 * 32) << name;
  }
}

// Over a closed cycle, once periodic, the rig never gives work back.
TEST(Rig, EveryPassiveEffectDissipates) {
  const double period = 2.0;
  const auto move = [&](double t) { return 2e-3 * std::sin(kTwoPi * t / period); };
  for (const std::string& name : ListedNames()) {
    if (name.rfind("sensor", 0) == 0 || name == "temperature_drift") continue;
    TrueRig rig{NominalRig(), {}};
    rig.rig.friction.scale = 1e-6;  // leave the effect alone with the lines
    const HiddenEffect effect = DrawEffect(name, RandomSource(3, name));
    effect.apply(std::min(1.0, effect.largest), &rig);
    const RigSignals s = Simulate(rig.rig, {move, {}}, {5e-4, 200, 4 * period + 0.005});
    double work = 0, turnover = 0;
    for (size_t i = s.size() - 1; s.t[i] > 3 * period; --i) {
      const double w = 0.5 * (s.load[i] + s.load[i - 1]) * (s.actuator[i] - s.actuator[i - 1]);
      work += w;
      turnover += std::abs(w);
    }
    EXPECT_GT(work, -2e-3 * turnover) << name;
  }
}

// A motion from a file reverses where its sine does, not at the sample beside: between samples the
// speed is within 0.3 % of its peak (central differences: (ω h)²/6 = 0.15 % at 3 Hz and 200 Hz).
TEST(Motion, OfAFileIsAsSmoothAsTheSineThatItSamples) {
  const double h = 0.005, w = 2 * M_PI * 3, peak = w * 2e-3;
  SampledMotion motion{h, {}};
  for (int i = 0; i < 400; ++i) motion.position.push_back(2e-3 * std::sin(w * i * h));
  for (double t = 0.1; t < 1.8; t += 0.0007) {
    const double speed = (motion.Position(t + 1e-6) - motion.Position(t - 1e-6)) / 2e-6;
    EXPECT_NEAR(speed, peak * std::cos(w * t), 3e-3 * peak) << t;
  }
  EXPECT_NEAR(motion.Position(50 * h), motion.position[50], 1e-15);
}

TEST(Refit, RecoversTheFactorsOfACleanRecord) {
  const DeclaredFactors truth = {0.8, 1.25, 1.2, 0.75, 1.15};
  const auto move = [](double t) {
    return 0.3e-3 + 2.4e-3 * std::sin(kTwoPi * 0.23 * t) * std::cos(kTwoPi * 0.031 * t);
  };
  const RigSignals s = Simulate(DeclaredRig(truth), {move, {}}, {1e-3, 200, 20});
  const Record record = Read(s, {}, 200);
  MotionEstimate motion;
  motion.x = s.actuator;
  motion.v = s.speed;
  const DeclaredFactors found = FitDeclared(record, motion, {1, 20}, {1e-6, 1e-6, 50, 5e3, 5e3});
  EXPECT_NEAR(found.oil_bore, truth.oil_bore, 1e-4);
  EXPECT_NEAR(found.gas_bore, truth.gas_bore, 1e-4);
  EXPECT_NEAR(found.oil_rod, truth.oil_rod, 1e-4);
  EXPECT_NEAR(found.gas_rod, truth.gas_rod, 1e-4);
  EXPECT_NEAR(found.friction, truth.friction, 1e-4);
}

TEST(Sensors, NoiseHasItsLevelItsColourAndItsQuantum) {
  const NoiseSet noise = DrawNoise(RandomSource(4));
  Record still;
  for (int i = 0; i < 40000; ++i) still.t.push_back(i / 200.0);
  for (auto& channel : still.channel) channel.assign(still.t.size(), 0.0);
  const Record noisy = AddNoise(still, noise, RandomSource(9));
  for (int c = 0; c < kChannels; ++c) {
    const std::vector<double>& y = noisy.channel[c];
    double square = 0, lagged = 0;
    for (size_t i = 4; i < y.size(); ++i) {
      square += y[i] * y[i];
      lagged += y[i] * y[i - 4];
      const double steps = y[i] / noise[c].quantum;
      ASSERT_NEAR(steps, std::round(steps), 1e-6);
    }
    EXPECT_NEAR(std::sqrt(square / (y.size() - 4)), NoiseLevel(noise[c]),
                0.05 * NoiseLevel(noise[c]));
    EXPECT_GT(lagged, 0.02 * square) << "coloured, channel " << c;
  }
}

TEST(Sensors, DelayGainOffsetAndPlayDoWhatTheySay) {
  RigSignals s;
  for (int i = 0; i < 4000; ++i) {
    s.t.push_back(i / 2000.0);
    const double ramp = 1000.0 * s.t.back();
    for (auto* y : {&s.actuator, &s.piston, &s.load, &s.p_bore, &s.p_rod}) y->push_back(ramp);
  }
  SensorSet sensors;
  sensors[kLoad].delay = 0.02;
  sensors[kPBore].gain = 0.05;
  sensors[kPBore].offset = 7;
  sensors[kPRod].hysteresis = 30;
  sensors[kPRod].hysteresis_span = 200;
  const Record r = Read(s, sensors, 2000);
  ASSERT_EQ(r.size(), 400u);
  EXPECT_NEAR(r.channel[kLoad].back(), r.channel[kActuator].back() - 20, 1e-9);
  EXPECT_NEAR(r.channel[kPBore].back(), 1.05 * r.channel[kActuator].back() + 7, 1e-9);
  EXPECT_NEAR(r.channel[kPRod].back(), r.channel[kActuator].back() - 30, 1e-9);
}

}  // namespace
}  // namespace rigdata
