// What the catalogue does not hold must be described by a formula, and no listed effect bent to it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>

#include "identify/next_test/next_test.h"
#include "identify/result/result_json.h"
#include "identify/run/driven_run.h"
#include "phs_model/phs_model.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {

using measurement::FitData;
namespace {

TEST(UnlistedSearchTest, DescribesAForceThatNoEffectHolds) {
  hydraulics::PhsParams truth = OffDeclared();
  hydraulics::EffectParams cogging{"unlisted", {}, {{"c1_N", 250}}};
  cogging.formula = "c1*sin(2*pi*x/0.0007[m])";
  truth.effects.push_back(cogging);
  const FitData data = Record(truth);
  const Identification found = Find(Declared(), data);
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_EQ(found.effects[0].candidate.effect, "unlisted");
  EXPECT_THAT(found.formula.text, testing::HasSubstr("sin(2*pi*x/0.000"));
  EXPECT_LT(found.after.channel_ms[1], 0.2 * found.before.channel_ms[1]);
}

TEST(UnlistedSearchTest, ASpringBesideTheCylinderIsNoGainOfTheLoadCell) {
  const FitData data = Record(WithUnlisted("c1*(x/0.001[m])", "c1_N", 300, {}));
  const Identification found = Find(Declared(), data);
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_EQ(found.effects[0].candidate.effect, "unlisted");
  EXPECT_THAT(found.formula.text, testing::StartsWith("c1*(x/0.002[m])"));
  EXPECT_NEAR(found.after.values.back(), 600, 30);
  EXPECT_TRUE(found.formula.targets.empty());
}

// A gain of the load cell with another one in compression takes most of it; a second term says the rest.
TEST(UnlistedSearchTest, ASpringThatHardensBesideTheCylinderIsNoGainOfTheLoadCell) {
  hydraulics::PhsParams truth = OffDeclared();
  hydraulics::EffectParams hoses{"unlisted", {}, {{"c1_N", 300}, {"c2_N", 130}}};
  hoses.formula = "c1*(x/0.001[m]) + c2*(x/0.001[m])^3";
  truth.effects.push_back(hoses);
  const Identification found = Find(Declared(), Record(truth));
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "unlisted") << Said(found);
  EXPECT_THAT(found.formula.text, testing::HasSubstr("*(x/0.002[m])"));
  EXPECT_THAT(found.formula.text, testing::HasSubstr("*(x/0.002[m])^3"));
}

TEST(UnlistedSearchTest, AThrustOfOneLineIsAnAreaThatTheModelDoesNotKnow) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back({"pressure_area", {"L2"}, {{"area_m2", -3e-4}}});
  const Identification found = Find(Declared(), Record(truth));
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "pressure_area");
  EXPECT_EQ(found.effects[0].candidate.params.targets, std::vector<std::string>{"L2"});
  EXPECT_NEAR(found.after.values.back(), -3e-4, 2e-5);
}

TEST(UnlistedSearchTest, ABumpStopBeginsAtItsPosition) {
  const FitData data = Record(WithUnlisted("c1*(max(x-0.0012[m],0[m])/0.001[m])", "c1_N", 900, {}));
  const Identification found = Find(Declared(), data);
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_EQ(found.effects[0].candidate.effect, "unlisted");
  const std::string text = found.formula.text;
  ASSERT_THAT(text, testing::StartsWith("c1*(max(x-"));
  EXPECT_NEAR(std::stod(text.substr(text.find("max(x-") + 6)), 1.2e-3, 3e-5);
  EXPECT_NEAR(found.after.values.back() / 0.002, 900 / 0.001, 0.05 * 900 / 0.001) << "N/m";
}

TEST(UnlistedSearchTest, CrosstalkOfAPressureSensorIsItsReadingOverTheOther) {
  const FitData data = Record(WithUnlisted("c1*(q/1e6[Pa])", "c1_Pa", 2e4, {"L2"}));
  ASSERT_EQ(Find(Declared(), data).effects.at(0).candidate.effect, "sensor_crosstalk");
  const Identification found = FindAmong({"sensor_gain", "sensor_offset", "sensor_creep"}, data);
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "unlisted");
  EXPECT_EQ(found.formula.unit, "Pa");
  EXPECT_EQ(found.formula.targets, std::vector<std::string>{"L2"});
  EXPECT_THAT(found.formula.text, testing::StartsWith("c1*(q/"));
}

/// Its axis leans: what it shows of the force changes with the stroke.
TEST(UnlistedSearchTest, ALoadCellThatStandsAskewShowsAShareOfTheForceOverThePosition) {
  const FitData data = Record(WithUnlisted("c1*(F/1e5[N])*(x/0.002[m])", "c1_N", 6e3, {}));
  const Identification found =
      FindAmong({"sensor_gain", "sensor_offset", "pressure_area", "mount_compliance"}, data);
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "unlisted");
  EXPECT_THAT(found.formula.text,
              testing::MatchesRegex("c1\\*\\(F/.*\\[N\\]\\)\\*\\(x/0.002\\[m\\]\\)"));
  EXPECT_LT(found.after.channel_ms[1], 1.1 * LeftOnACleanRecord());
}

/// The amplifier of a load cell gives way beyond a force.
TEST(UnlistedSearchTest, ALoadCellThatSaturatesIsItsReadingFromAForceOn) {
  const FitData data = Record(WithUnlisted("c1*(max(F+1.2e4[N],0[N])/1e5[N])^2", "c1_N", -6e4, {}));
  const Identification found =
      FindAmong({"sensor_gain", "sensor_offset", "pressure_area", "mount_compliance"}, data);
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  const std::string text = found.formula.text;
  ASSERT_THAT(text, testing::StartsWith("c1*(max(F+"));
  EXPECT_NEAR(std::stod(text.substr(text.find("F+") + 2)), 1.2e4, 500);
  EXPECT_EQ(found.formula.unit, "N");
  EXPECT_LT(found.after.channel_ms[1], 1.1 * LeftOnACleanRecord());
}

/// Its cable lies beside that of the drive. The load cell does not show it: it is no resistance.
TEST(UnlistedSearchTest, AGaugeThatPicksUpTheDriveIsItsReadingOverTheSpeed) {
  const FitData data = Record(WithUnlisted("c1*(v/0.005[m/s])", "c1_Pa", 8e4, {"L1"}));
  const Identification found =
      FindAmong({"line_resistance", "check_restriction", "sensor_delay", "sensor_creep"}, data);
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "unlisted");
  EXPECT_EQ(found.formula.unit, "Pa");
  EXPECT_THAT(found.formula.text, testing::StartsWith("c1*(v/"));
  EXPECT_LT(found.after.channel_ms[3], 1.1);
}

/// Its coefficient is below zero: on its way a fit passes the law that does nothing.
TEST(UnlistedSearchTest, ATapOnAThroatReadsLowByTheSquareOfTheSpeed) {
  const FitData data = Record(WithUnlisted("c1*(v/0.005[m/s])^2", "c1_Pa", -1.2e5, {"L1"}));
  const Identification found = Find(Declared(), data);
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "unlisted");
  EXPECT_EQ(found.formula.unit, "Pa");
  EXPECT_EQ(found.formula.targets, std::vector<std::string>{"L1"});
  EXPECT_EQ(found.formula.text, "c1*(abs(v)/0.005[m/s])^2");
  EXPECT_NEAR(found.after.values.back(), -1.2e5, 4e3);
}

/// A pump on the next bench squeezes the hose: oil comes and goes whatever the piston does.
TEST(UnlistedSearchTest, OilThatComesAndGoesWithTimeIsAFlowOfItsLine) {
  const FitData data = Record(WithUnlisted("c1*cos(2*pi*t/0.61[s])", "c1_m3_per_s", 3e-6, {"L2"}));
  const Identification found =
      FindAmong({"external_leakage", "piston_leakage", "temperature_drift", "entrained_air"}, data);
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "unlisted");
  EXPECT_EQ(found.formula.unit, "m3_per_s");
  EXPECT_EQ(found.formula.targets, std::vector<std::string>{"L2"});
  const std::string text = found.formula.text;
  ASSERT_THAT(text, testing::HasSubstr("sin(2*pi*t/"));
  EXPECT_NEAR(std::stod(text.substr(text.find("t/") + 2)), 0.61, 1e-3 * 0.61);
  EXPECT_LT(found.after.channel_ms[2], 1.1);
}

/// A spring ball drops into a notch: a bump's slope, of which the even part is nothing.
TEST(UnlistedSearchTest, ADetentIsABumpOverThePosition) {
  const FitData data = Record(WithUnlisted(
      "c1*((x-0.0004[m])/0.0005[m])*exp(-((x-0.0004[m])/0.0005[m])^2)", "c1_N", 900, {}));
  const Identification found = Find(Declared(), data);
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "unlisted");
  const std::string text = found.formula.text;
  ASSERT_THAT(text, testing::StartsWith("c1*exp(-((x-"));
  EXPECT_NEAR(std::stod(text.substr(text.find("((x-") + 4)), 4e-4, 2e-5);
  EXPECT_LT(found.after.channel_ms[1], 1.1 * LeftOnACleanRecord());
}

/// A rubber bumper is met in the last part of the stroke: no far flank, so no notch.
TEST(UnlistedSearchTest, ABumperAtTheEndOfTheStrokeIsNoNotch) {
  const FitData data =
      Record(WithUnlisted("c1*(max(x-0.0012[m],0[m])/0.001[m])^2", "c1_N", 900, {}));
  const Identification found = Find(Declared(), data);
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_THAT(found.formula.text, testing::HasSubstr("max(x-"));
  EXPECT_THAT(found.formula.text, testing::Not(testing::HasSubstr("exp(")));
}

// From bore to rod: no effect of the catalogue begins there.
TEST(UnlistedSearchTest, AReliefValveBetweenTheChambersIsAFlowBeyondAPressure) {
  const double opening = 4e6;  // above the static difference
  const FitData data =
      Record(WithUnlisted("c1*(max(p-4e6[Pa],0[Pa])/1e6[Pa])", "c1_m3_per_s", 4e-8, {"1"}));
  const Identification found = FindAmong(
      {"piston_leakage", "external_leakage", "diaphragm_stop", "accumulator_precharge"}, data);
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "unlisted") << Said(found);
  EXPECT_EQ(found.formula.unit, "m3_per_s");
  ASSERT_EQ(found.formula.targets, std::vector<std::string>{"1"});
  ASSERT_THAT(found.formula.text, testing::HasSubstr("max(p-"));
  const std::string text = found.formula.text;
  EXPECT_NEAR(std::stod(text.substr(text.find("max(p-") + 6)), opening, 0.15 * opening);
  EXPECT_LT(found.after.channel_ms[2], 1.1);
}

// To the atmosphere: a leak that opens at a pressure, high or low.
TEST(UnlistedSearchTest, AReliefValveToTheAtmosphereIsALeakThatOpens) {
  for (const double opening : {5e6, 2e6}) {
    const std::string text = "c1*(max(p-" + std::to_string(opening) + "[Pa],0[Pa])/1e6[Pa])";
    const FitData data = Record(WithUnlisted(text, "c1_m3_per_s", 4e-8, {"L2"}));
    const Identification found = FindAmong(
        {"piston_leakage", "external_leakage", "diaphragm_stop", "accumulator_precharge"}, data);
    ASSERT_EQ(found.effects.size(), 1u) << Said(found);
    EXPECT_EQ(found.effects[0].candidate.effect, "external_leakage");
    EXPECT_EQ(found.effects[0].candidate.params.targets, std::vector<std::string>{"L2"});
    const double said = ValueOf(found, "effects.external_leakage.opening_Pa");
    EXPECT_NEAR(said, opening + 1.8e6 - 101325, 0.1 * opening);
  }
}

/// A gauge of two ranges: another gain above the static pressure. It is its gain that errs, not a
/// load cell over the force.
TEST(UnlistedSearchTest, AGaugeThatErrsFromAPressureOnIsItsGain) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back({"sensor_gain", {}, {{"p_bore", 1.06}, {"from_Pa", 1.8e6}}});
  const Identification found =
      FindAmong({"sensor_gain", "sensor_offset", "sensor_creep", "pressure_area"}, Record(truth));
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "sensor_gain");
  EXPECT_NEAR(ValueOf(found, "effects.sensor_gain.p_bore"), 1.06, 0.003);
  EXPECT_NEAR(ValueOf(found, "effects.sensor_gain.from_Pa"), 1.8e6, 1e5);
}

/// One that bows from a pressure on, which no gain does: sought over its own pressure.
TEST(UnlistedSearchTest, AGaugeThatBowsIsItsReadingOverItsOwnPressure) {
  const FitData data =
      Record(WithUnlisted("c1*(max(p-2e6[Pa],0[Pa])/1e7[Pa])^2", "c1_Pa", 8e5, {"L2"}));
  const Identification found = FindAmong({"sensor_offset", "sensor_creep", "pressure_area"}, data);
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "unlisted");
  EXPECT_EQ(found.formula.unit, "Pa");
  EXPECT_THAT(found.formula.text, testing::HasSubstr("max(p")) << Said(found);
  EXPECT_LT(found.after.channel_ms[2], 1.1) << Said(found);
}

/// A thrust that grows with the square of its line's pressure, above the static one and below: the
/// catalogue's changes sign. A formula alone says more, and is the thrust's form all the same.
TEST(UnlistedSearchTest, AThrustOfAnotherShapeKeepsItsName) {
  const FitData data = Record(WithUnlisted("c1*(p/5e6[Pa])^2", "c1_N", 2500, {}));
  const Identification found = FindAmong({"pressure_area", "sensor_offset", "sensor_gain"}, data);
  ASSERT_FALSE(found.effects.empty());
  EXPECT_EQ(found.effects[0].candidate.effect, "pressure_area") << Said(found);
  EXPECT_LT(found.after.channel_ms[1], 1.1 * LeftOnACleanRecord());
  SearchOptions one;  // the formula beside it would be the second
  one.effort.max_effects = 1;
  const Identification alone =
      FindAmong({"pressure_area", "sensor_offset", "sensor_gain"}, data, one);
  EXPECT_EQ(alone.effects.size(), 1u) << Said(alone);
}

TEST(UnlistedSearchTest, AGradualStopIsTheFormOfAListedEffect) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back(
      {"diaphragm_stop", {"L2"}, {{"min_gas_volume_m3", 4.5e-6}, {"spread", 0.12}}});
  const Identification found = FindAmong(
      {"diaphragm_stop", "entrained_air", "hose_expansion", "gas_thermal"}, Record(truth));
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_EQ(found.effects[0].candidate.effect, "diaphragm_stop") << Said(found);
  EXPECT_EQ(found.effects[0].candidate.params.targets, std::vector<std::string>{"L2"});
  EXPECT_NEAR(ValueOf(found, "effects.diaphragm_stop.min_gas_volume_m3"), 4.5e-6, 0.1e-6);
  EXPECT_NEAR(ValueOf(found, "effects.diaphragm_stop.spread"), 0.12, 0.03);
  const double share = ValueOf(found, "effects.diaphragm_stop.share");
  EXPECT_TRUE(std::isnan(share) || share > 0.98) << "it does not give way: " << share;
}

TEST(UnlistedSearchTest, AStopIsHeardWithinARunOfTheModel) {
  const FitData data = Record(OffDeclared());
  auto problem = ProblemOf(data, Declared());
  std::atomic<bool> stop{false};
  std::atomic<int> asked{0}, after{0};
  const auto found = Identify(&problem.value(), Declared(), {}, [&](double) {
    if (++asked == 40) stop = true;
    if (stop) ++after;
    return !stop;
  });
  ASSERT_TRUE(found.ok());
  EXPECT_TRUE(found.value().cancelled);
  EXPECT_LE(after, 4) << "once by each thread, and no run of the model after that";
}

TEST(CandidatesTest, OnlyThoseAskedForAreTried) {
  FitData data = Record(OffDeclared());
  data.candidates = {"backlash", "sensor_offset"};
  const auto problem = ProblemOf(data, Declared());
  for (const Candidate& c : problem.value().forward().Candidates(Declared())) {
    EXPECT_TRUE(c.effect == "backlash" || c.effect == "sensor_offset") << c.effect;
  }
  EXPECT_THAT(CandidateNames(), testing::IsSupersetOf({"backlash", "gas_thermal", "unlisted"}));
}

TEST(CandidatesTest, NoNumberIsFreedTwiceWhateverOptionsAreTaken) {
  for (Candidate c : ListCandidates(Declared(), rigs::RigKind::kQuarter)) {
    while (!c.options.empty()) c = WithOption(c, 0);
    std::set<std::string> names;
    for (const FreeParameter& p : c.free) {
      EXPECT_TRUE(names.insert(p.name).second) << c.effect << " " << p.name;
    }
  }
}

/// The zero of a gauge that wanders for seconds has no period.
TEST(UnlistedSearchTest, ASensorThatWandersIsNoWaveOverTime) {
  for (const unsigned seed : {4u, 5u}) {
    FitData data = Record(OffDeclared());
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    constexpr double kWander_s = 3, kWander_Pa = 3e4;
    const double share = data.step_s / kWander_s;
    double at = 0;
    for (double& p : data.outputs[3].values) {
      at += -share * at + std::sqrt(2 * share) * normal(random);
      p += kWander_Pa * at;
    }
    data.candidates = {"unlisted"};
    const Identification found = Find(Declared(), data);
    EXPECT_EQ(found.formula.text.find("2*pi*t"), std::string::npos) << found.formula.text;
  }
}

TEST(CandidatesTest, ALeakMayBeInOneCylinderOfFour) {
  const auto four = phs_model::FindPhsParams("bo_bo").value();
  std::vector<std::vector<std::string>> places;
  for (const Candidate& c : ListCandidates(four, rigs::RigKind::kFull)) {
    if (c.effect == "piston_leakage") places.push_back(c.params.targets);
  }
  EXPECT_THAT(places, testing::IsSupersetOf<std::vector<std::string>>({{}, {"1"}, {"4"}}));
  int alone = 0;
  for (const Candidate& c : ListCandidates(Declared(), rigs::RigKind::kQuarter)) {
    alone += c.effect == "piston_leakage" && !c.params.targets.empty();
  }
  EXPECT_EQ(alone, 0) << "one cylinder is all of them";
}

TEST(Unexplained, SaysWhatTheValidationWindowAloneExcites) {
  FitData data = Record(OffDeclared());
  for (size_t i = 0; i < data.time_s.size(); ++i) {
    if (!data.InEstimation(i)) data.outputs[3].values[i] += 1e5;  // ten times the noise of p_rod
  }
  Identification found;
  found.after.channel_ms = {1, 1, 1, 1};
  const Channels truth = PredictWhole(data, OffDeclared());
  const auto rig = RigForward::Create(data, Declared());
  const Result<Channels> uncertain = KnownErrors(*rig.value(), OffDeclared());
  ASSERT_TRUE(uncertain.ok());
  const auto over = OverNoise(data, uncertain.value(), truth, data.validation);
  EXPECT_NEAR(over[2].over_noise, 1, 0.1);
  EXPECT_NEAR(over[3].following, 99, 10) << "an offset is no noise";
  const Unexplained left = FindUnexplained(data, truth, over, found.after.channel_ms, found);
  EXPECT_EQ(left.channel, "p_rod_Pa");
  EXPECT_NEAR(left.over_noise, 10, 1);
  EXPECT_THAT(OtherMotion(left), testing::HasSubstr("validation window excites"));
}

}  // namespace
}  // namespace phs::identify::search
