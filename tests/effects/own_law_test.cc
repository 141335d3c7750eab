// Laws that a model brings with it: what they mean, what is refused, how their states are advanced.
#include "effects/own_law.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "effects/own_states.h"
#include "phs_model/phs_model.h"
#include "rigs/rig_model.h"

namespace phs::effects {

using hydraulics::EffectParams;
using hydraulics::ExtraSeries;
using hydraulics::PhsParams;
using rigs::RigKind;
using rigs::RigModel;
using rigs::RigMotion;
using rigs::RigPrediction;
using testing::HasSubstr;
namespace {

Formula Rate(const std::string& text, const FormulaNames& names, const Dimension& whole) {
  auto formula = Formula::Parse(text, names, whole, "rate");
  EXPECT_TRUE(formula.ok()) << (formula.ok() ? "" : formula.error().Line());
  return formula.value();
}

/// A part on a bench without friction, mass or offset: what it gives is the law alone.
PhsParams Bare() {
  PhsParams params;
  params.name = "bare";
  params.cylinders.emplace_back().name = "1";
  params.friction.model = hydraulics::FrictionModel::kNone;
  return params;
}

PhsParams WithLaw(PhsParams params, const std::string& formula,
                  const std::map<std::string, double>& values,
                  const std::vector<std::string>& targets = {}) {
  params.effects.push_back({"mine", targets, values, formula});
  return params;
}

std::string LawRefusal(const PhsParams& params) {
  const auto system = phs_model::CreatePhsSystem(params);
  return system.ok() ? "" : system.error().Line();
}

RigMotion Sine(double amplitude, double w, double step, int n) {
  RigMotion motion;
  motion.step_s = step;
  motion.position_m.resize(1), motion.speed_m_s.resize(1);
  for (int i = 0; i < n; ++i) {
    motion.position_m[0].push_back(amplitude * std::sin(w * i * step));
    motion.speed_m_s[0].push_back(amplitude * w * std::cos(w * i * step));
  }
  return motion;
}

std::vector<double> BenchForce(const PhsParams& params, const RigMotion& motion,
                               const rigs::RigOptions& options = {}) {
  auto rig = RigModel::Create(RigKind::kElement, params, options);
  EXPECT_TRUE(rig.ok()) << (rig.ok() ? "" : rig.error().Line());
  if (!rig.ok()) return {};
  RigPrediction out;
  EXPECT_TRUE(rig.value().Run(motion, &out).ok());
  return out.channels[0];
}

TEST(OwnUnits, AreReadFromTheEndOfAName) {
  const Dimension per_metre = {0, 1, -2, 0, 0};
  EXPECT_EQ(DimensionOf("N_per_m").value(), per_metre);
  EXPECT_EQ(DimensionOf("Ns_per_m").value(), (Dimension{0, 1, -1, 0, 0}));
  EXPECT_EQ(DimensionOf("m_s").value(), (Dimension{1, 0, -1, 0, 0}));
  EXPECT_EQ(DimensionOf("m3_per_Pas").value(), (Dimension{4, -1, 1, 0, 0}));
  EXPECT_EQ(DimensionOf("1_per_K").value(), (Dimension{0, 0, 0, -1, 0}));
  EXPECT_EQ(DimensionOf("V").value(), (Dimension{2, 1, -3, 0, -1}));
  EXPECT_EQ(DimensionOf("").value(), Dimension{});
  EXPECT_FALSE(DimensionOf("share").ok());
}

TEST(OwnStates, AreOfSecondOrderAndStableHoweverStiff) {
  // dz/dt = -(z - 1)/tau from 0: z = 1 - exp(-t/tau).
  FormulaNames names;
  names.states = {{"z", Dimension{}}};
  names.numbers["tau"] = {1.0, DimensionOf("s").value()};
  const Dimension rate = DimensionOf("per_s").value();
  // Quadratic, so that no method is exact: dz/dt = -z^2/tau + 1/tau, z = tanh(t).
  const OwnStates states({Rate("(1 - z^2)/tau", names, rate)});
  double error[2];
  for (int k = 0; k < 2; ++k) {
    double z = 0;
    const int n = 20 << k;
    for (int i = 0; i < n; ++i) states.Advance(1.0 / n, {}, &z);
    error[k] = std::abs(z - std::tanh(1.0));
  }
  EXPECT_LT(error[0], 2e-4);
  EXPECT_NEAR(std::log2(error[0] / error[1]), 2, 0.15);
  // A step of four time constants is taken in sixteen parts.
  names.numbers["tau"].value = 0.25;
  const OwnStates slow({Rate("(1 - z)/tau", names, rate)});
  double long_step = 0;
  slow.Advance(1.0, {}, &long_step);
  EXPECT_NEAR(long_step, 1 - std::exp(-4), 2e-3);
  names.numbers["tau"].value = 1e-6;
  const OwnStates stiff({Rate("(1 - z)/tau", names, rate)});
  double z = 0;
  for (int i = 0; i < 5; ++i) {
    stiff.Advance(0.01, {}, &z);
    EXPECT_GT(z, 0.5);
    EXPECT_LT(z, 1.5);
  }
  EXPECT_NEAR(z, 1, 1e-3);
}

TEST(OwnLaw, ABristleFollowsItsClosedFormAndTwoStatesSeeEachOther) {
  // dz/dt = v - |v| z/z0 at constant v: z = z0 (1 - exp(-v t/z0)).
  RigMotion ramp;
  ramp.step_s = 1e-3;
  ramp.position_m.resize(1), ramp.speed_m_s.resize(1);
  for (int i = 0; i <= 1000; ++i) {
    ramp.position_m[0].push_back(0.01 * i * 1e-3), ramp.speed_m_s[0].push_back(0.01);
  }
  const PhsParams part = WithLaw(Bare(), "piston = k*z; dz_m/dt = v - abs(v)*z/z0",
                                 {{"k_N_per_m", 1e5}, {"z0_m", 1e-3}});
  const auto force = BenchForce(part, ramp);
  for (const int i : {0, 50, 200, 1000}) {
    EXPECT_NEAR(force[static_cast<size_t>(i)], 100 * (1 - std::exp(-0.01 * i * 1e-3 / 1e-3)), 0.05);
  }
  // A pendulum: da/dt = w b, db/dt = -w a + w; a = 1 - cos wt.
  const PhsParams swing = WithLaw(Bare(), "piston = f*a; da/dt = w*b; db/dt = w - w*a",
                                  {{"f_N", 10}, {"w_1_per_s", 2}});
  const auto swung = BenchForce(swing, ramp);
  EXPECT_NEAR(swung[1000], 10 * (1 - std::cos(2.0)), 0.02);
}

TEST(OwnLaw, ActsOnTheRigTheSameBesideThePistonAndBesideTheCylinder) {
  const auto declared = phs_model::FindPhsParams("quarter_setup2").value();
  const RigMotion motion = Sine(2e-3, 3, 0.005, 2000);
  const auto run = [&](const PhsParams& params) {
    auto rig = RigModel::Create(RigKind::kQuarter, params);
    EXPECT_TRUE(rig.ok()) << (rig.ok() ? "" : rig.error().Line());
    RigPrediction out;
    EXPECT_TRUE(rig.value().Run(motion, &out).ok());
    return out.channels;
  };
  const auto plain = run(declared);
  const std::map<std::string, double> values = {{"k_N_per_m", 2e6}, {"z0_m", 2e-4}};
  const auto piston = run(WithLaw(declared, "piston = k*z; dz_m/dt = v - abs(v)*z/z0", values));
  const auto mounting = run(WithLaw(declared, "mounting = k*z; dz_m/dt = v - abs(v)*z/z0", values));
  double most = 0;
  for (size_t i = 0; i < plain[1].size(); ++i) {
    const double beside = piston[1][i] - plain[1][i];
    most = std::max(most, std::abs(beside));
    EXPECT_NEAR(mounting[1][i] - plain[1][i], beside, 4);
    EXPECT_EQ(piston[2][i], plain[2][i]);
  }
  EXPECT_NEAR(most, 400, 5);
}

TEST(OwnLaw, AsksForAChannelOfTheRecord) {
  auto series = std::make_shared<ExtraSeries>();
  series->names = {"other_N", "coil_V"}, series->step_s = 0.5;
  series->values = {{7, 7, 7}, {0, 10, 20}};
  rigs::RigOptions options;
  options.extra = series;
  const RigMotion motion = Sine(1e-3, 3, 0.1, 12);
  for (const char* where : {"piston", "mounting", "reading_N"}) {
    const PhsParams part =
        WithLaw(Bare(), std::string(where) + " = f*coil/1[V]; given coil_V", {{"f_N", 2}});
    const auto force = BenchForce(part, motion, options);
    ASSERT_EQ(force.size(), 12u);
    EXPECT_NEAR(force[3], 2 * 6, 1e-9) << where << ": linear between samples";
    EXPECT_NEAR(force[11], 2 * 20, 1e-9) << where << ": held beyond the end";
    EXPECT_THAT(LawRefusal(part), HasSubstr("coil_V, which this run does not have"));
  }
}

TEST(OwnLaw, OfOilIsTheFormulaOfTheSameName) {
  const auto declared = phs_model::FindPhsParams("quarter_setup2").value();
  const RigMotion motion = Sine(4e-3, 3, 0.005, 1000);
  const std::string line = declared.lines.front().name;
  const auto pressures = [&](const EffectParams& effect) {
    PhsParams params = declared;
    params.effects.push_back(effect);
    auto rig = RigModel::Create(RigKind::kQuarter, params);
    EXPECT_TRUE(rig.ok()) << (rig.ok() ? "" : rig.error().Line());
    RigPrediction out;
    EXPECT_TRUE(rig.value().Run(motion, &out).ok());
    return out.channels[2];
  };
  EXPECT_EQ(pressures({"leak", {line}, {{"g_m3_per_Pas", 1e-13}}, "flow = g*p"}),
            pressures({"unlisted", {line}, {{"c1_m3_per_s", 1e-7}}, "c1*(p/1e6[Pa])"}));
  EXPECT_EQ(pressures({"hose", {line}, {{"c_m3_per_Pa", 1e-12}}, "volume = c*p"}),
            pressures({"unlisted", {line}, {{"c1_m3", 1e-6}}, "c1*(p/1e6[Pa])"}));
}

TEST(OwnLaw, GoesThroughAFileAndStaysBehindWhereItIsOfTheRig) {
  const auto declared = phs_model::FindPhsParams("quarter_setup2").value();
  const PhsParams with = WithLaw(declared, "piston = k*z; dz_m/dt = v - abs(v)*z/z0",
                                 {{"k_N_per_m", 2e6}, {"z0_m", 2e-4}});
  auto map = YamlMap::Parse(phs_model::ToYaml(with), "with.yaml");
  ASSERT_TRUE(map.ok());
  const auto again = phs_model::ReadPhsParams(map.value());
  ASSERT_TRUE(again.ok()) << again.error().Line();
  EXPECT_EQ(again.value().effects, with.effects);
  const auto states = phs_model::CreatePhsSystem(again.value()).value().state_names();
  EXPECT_THAT(states, testing::Contains(HasSubstr("mine_z")));
  EXPECT_FALSE(StaysOnRig(with.effects.back()));
  EXPECT_TRUE(StaysOnRig({"mine", {}, {}, "mounting = 1[N]"}));
  EXPECT_FALSE(StaysOnRig({"unlisted", {}, {}, "c1*s"}));
}

TEST(OwnLaw, IsRefusedInOneLineThatSaysWhy) {
  const auto refused = [](const std::string& formula, const std::map<std::string, double>& values,
                          const std::vector<std::string>& targets = {}) {
    return LawRefusal(WithLaw(Bare(), formula, values, targets));
  };
  EXPECT_THAT(refused("pistn = k*x", {{"k_N_per_m", 1}}), HasSubstr("did you mean 'piston'"));
  EXPECT_THAT(refused("piston = k*v", {{"k_N_per_m", 1}}), HasSubstr("no force [N]"));
  EXPECT_THAT(refused("piston = k*x*y", {{"k_N_per_m", 1}}), HasSubstr("unknown name y"));
  EXPECT_THAT(refused("piston = k*x", {{"k_N_per_furlong", 1}}), HasSubstr("is no unit"));
  EXPECT_THAT(refused("piston = v*x", {{"v_N_per_m", 1}}), HasSubstr("means something else"));
  EXPECT_THAT(refused("piston = k*z; dz_m/dt = x", {{"k_N_per_m", 1}}),
              HasSubstr("no rate of z_m [m/s]"));
  EXPECT_EQ(refused("reading_N = k*v", {{"k_Ns_per_m", 1}}), "");
  EXPECT_THAT(refused("reading_N = k*s", {{"k_N", 1}}), HasSubstr("s is not known at"));
  EXPECT_THAT(refused("reading_N = k*z; dz_m/dt = x/1[s]", {{"k_N_per_m", 1}}),
              HasSubstr("states at reading_N"));
  EXPECT_EQ(refused("piston = F*x/1[m]", {{"F_N", 1}}), "") << "a number of its own, no variable";
  EXPECT_EQ(refused("piston = F; dF_N/dt = k*v", {{"k_N_per_m", 1}}), "") << "a state of its own";
  EXPECT_THAT(refused("piston = k*F", {{"k", 1}}), HasSubstr("F is not known at piston"));
  EXPECT_EQ(refused("reading_N = k*F", {{"k", 1}}), "");
  EXPECT_THAT(refused("k*x", {{"k_N_per_m", 1}}), HasSubstr("is no part of a law"));
  EXPECT_THAT(refused("dz_m/dt = v", {}), HasSubstr("does not say where it acts"));
  EXPECT_THAT(refused("flow = g*p", {{"g_m3_per_Pas", 1}}), HasSubstr("without targets"));
  EXPECT_EQ(refused("piston = k*x", {{"k_N_per_m", 1}}), "");
}

}  // namespace
}  // namespace phs::effects
