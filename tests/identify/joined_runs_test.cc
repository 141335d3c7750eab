// Several runs identified as one: numbers that they share and numbers of their own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/table.h"
#include "identify/models/joined_forward.h"
#include "identify/run/element_run.h"
#include "identify/run/joined_run.h"
#include "identify/run/rig_identify.h"
#include "tests/base/scratch_dir.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {
namespace {

using hydraulics::PhsParams;
using measurement::FitData;
using testing::HasSubstr;

SearchOptions Few(int most) {
  SearchOptions options;
  options.effort.max_effects = most, options.formula = false;
  return options;
}

/// Two fillings of one rig: the gas differs, the oil and the friction are the same.
PhsParams Filled(double gas) {
  PhsParams params = OffDeclared();
  for (auto& line : params.lines) line.gas_volume_m3 = gas;
  return params;
}

PhsParams WithLeak(PhsParams params) {
  params.effects.push_back({"piston_leakage", {}, {{"conductance_m3_per_Pas", 4e-14}}});
  return params;
}

std::shared_ptr<const JoinedForward> Joined(const std::vector<FitData>& runs,
                                            const std::vector<std::string>& shared) {
  std::vector<JoinedPart> parts;
  for (const FitData& run : runs) {
    parts.push_back({RigForward::Create(run, Declared()).value(), Declared()});
  }
  auto data = std::make_shared<measurement::JoinedData>(measurement::JoinData(runs).value());
  return JoinedForward::Create(parts, shared, data).value();
}

const std::vector<std::string> kShared = {"L1.oil_volume_m3", "L2.oil_volume_m3", "friction.scale"};

TEST(JoinedRuns, EachFillingIsItsOwnAndTheLeakIsOne) {
  const double gas = Declared().lines[0].gas_volume_m3;
  const std::vector<FitData> runs = {Record(WithLeak(Filled(0.7 * gas))),
                                     Record(WithLeak(Filled(1.3 * gas)))};
  const auto forward = Joined(runs, kShared);
  auto problem = FitProblem::Create(forward, forward->declared());
  const auto found = Identify(&problem.value(), forward->declared(), {}, nullptr);
  ASSERT_TRUE(found.ok());
  const Identification& f = found.value();
  ASSERT_EQ(f.effects.size(), 1u) << Said(f);
  EXPECT_EQ(f.effects[0].candidate.effect, "piston_leakage");
  EXPECT_NEAR(ValueOf(f, "effects.piston_leakage.conductance_m3_per_Pas") / 4e-14, 1, 0.05);
  for (const char* line : {"L1", "L2"}) {
    const std::string name = std::string(line) + ".gas_volume_m3";
    EXPECT_NEAR(ValueOf(f, NameOfRun(0, name)) / gas, 0.7, 0.01) << Said(f);
    EXPECT_NEAR(ValueOf(f, NameOfRun(1, name)) / gas, 1.3, 0.02) << Said(f);
  }
  EXPECT_NEAR(ValueOf(f, "L1.oil_volume_m3") / Declared().lines[0].oil_volume_m3, 1.2, 0.02);
  EXPECT_NEAR(ValueOf(f, "friction.scale"), 0.85, 0.01);
  // What each run's model becomes.
  const PhsParams corrected = problem.value().Params(f.corrected, f.after.values);
  const PhsParams second = forward->ParamsOf(corrected, 1);
  EXPECT_EQ(second.lines[0].gas_volume_m3, ValueOf(f, "run2.L1.gas_volume_m3"));
  EXPECT_EQ(second.effects.size(), 1u);
}

std::vector<std::string> AllShared() {
  std::vector<std::string> all = kShared;
  all.insert(all.end(), {"L1.gas_volume_m3", "L2.gas_volume_m3"});
  return all;
}

TEST(JoinedRuns, OneFillingForAllDoesNotDescribeTwo) {
  const double gas = Declared().lines[0].gas_volume_m3;
  const std::vector<FitData> runs = {Record(Filled(0.7 * gas)), Record(Filled(1.3 * gas))};
  const auto score = [&](const std::vector<std::string>& shared) {
    const auto forward = Joined(runs, shared);
    auto problem = FitProblem::Create(forward, forward->declared());
    const auto found = Identify(&problem.value(), forward->declared(), Few(0), nullptr);
    return found.value().before.score;
  };
  EXPECT_GT(score(AllShared()), score(kShared) + 1000);
}

TEST(JoinedRuns, WholeRunsStandWindowByWindow) {
  std::vector<FitData> runs = {Record(Declared()), Record(Filled(1e-5))};
  runs[0].estimation = {10, 30}, runs[0].validation = {0, 0};
  runs[1].estimation = {0, 0}, runs[1].validation = {5, 12};
  const auto joined = measurement::JoinData(runs);
  ASSERT_TRUE(joined.ok());
  const FitData& data = joined.value().data;
  EXPECT_EQ(data.estimation, (std::array<double, 2>{0, 20}));
  EXPECT_NEAR(data.validation[1] - data.validation[0], 7, 1e-9);
  const auto forward = Joined(runs, AllShared());
  EXPECT_EQ(forward->Measured().size(), 4u) << "the second run is not fitted to";
  Channels whole;
  ASSERT_TRUE(forward->Run(forward->declared(), ForwardModel::Span::kWhole, &whole).ok());
  const Channels first = PredictWhole(runs[0], Declared()),
                 second = PredictWhole(runs[1], Declared());
  EXPECT_EQ(whole[1][0], first[1][1000]) << "begins at 10 s of the first";
  EXPECT_EQ(whole[1][2000], second[1][500]) << "then the second from its 5 s on";
  EXPECT_EQ(data.outputs[1].values[2000], runs[1].outputs[1].values[500]);
  EXPECT_EQ(data.run[1999], 1);
  EXPECT_EQ(data.run[2000], 2);
  EXPECT_EQ(data.run_time_s[2000], 5);
}

TEST(JoinedRuns, NumbersOfItsOwnAskForAWindowToFitThemIn) {
  std::vector<FitData> runs = {Record(Declared()), Record(Declared())};
  runs[1].estimation = {0, 0};
  std::vector<JoinedPart> parts;
  for (const FitData& run : runs) {
    parts.push_back({RigForward::Create(run, Declared()).value(), Declared()});
  }
  const auto joined = JoinedForward::Create(parts, kShared, nullptr);
  ASSERT_FALSE(joined.ok());
  EXPECT_THAT(joined.error().Line(), HasSubstr("run 2 has numbers of its own"));
}

TEST(JoinedRuns, RatesMustAgree) {
  std::vector<FitData> runs = {Record(Declared()), Record(Declared())};
  runs[1].step_s = 0.02;
  const auto joined = measurement::JoinData(runs);
  ASSERT_FALSE(joined.ok());
  EXPECT_THAT(joined.error().Line(), HasSubstr("sampled at 50 Hz"));
}

class JoinedFiles : public testing::Test {
 protected:
  std::string Csv(const std::string& name, const FitData& data) {
    std::vector<std::string> names = {"t_s", data.inputs[0].name};
    Channels columns = {data.time_s, data.inputs[0].values};
    for (const auto& channel : data.outputs) {
      names.push_back(channel.name), columns.push_back(channel.values);
    }
    EXPECT_TRUE(WriteCsv(folder_.File(name), names, columns).ok());
    return name;
  }
  Result<IdentifyOutcome> Identified(const std::string& text) {
    const auto manifest = measurement::LoadManifest(folder_.Write("manifest.yaml", text));
    if (!manifest.ok()) return manifest.error();
    auto dir = ResultDir::Create(folder_.File("out"), true);
    auto outcome = IdentifyDriven(manifest.value(), Few(1), nullptr, dir.value());
    if (outcome.ok()) {
      EXPECT_TRUE(dir.value().Commit().ok());
    }
    return outcome;
  }
  ScratchDir folder_;
};

TEST_F(JoinedFiles, FittedOnOneRunAndScoredOnAnother) {
  Csv("a.csv", Record(WithLeak(OffDeclared())));
  Csv("b.csv", Record(WithLeak(OffDeclared()), false));
  const auto done = Identified(
      "rig: quarter\nmodel: quarter_setup2\ncandidates: [piston_leakage, backlash]\n"
      "runs:\n  - {data: a.csv, estimation: [0, 40]}\n  - {data: b.csv, validation: [20, 60]}\n");
  ASSERT_TRUE(done.ok()) << done.error().Line();
  const Json& result = done.value().result;
  EXPECT_EQ(result["effects"][0]["name"], "piston_leakage");
  EXPECT_EQ(result["verdict"], "explained");
  EXPECT_TRUE(result["fitted"].contains("L1.gas_volume_m3")) << "one value for both";
  const auto table = ReadCsv(folder_.File("out/predicted.csv"));
  ASSERT_TRUE(table.ok());
  const auto& run = table.value().columns[static_cast<size_t>(table.value().Find("run"))];
  EXPECT_EQ(run.front(), 1);
  EXPECT_EQ(run.back(), 2);
}

TEST_F(JoinedFiles, AModelEachIsWrittenForEach) {
  const double gas = Declared().lines[0].gas_volume_m3;
  Csv("a.csv", Record(WithLeak(Filled(0.7 * gas))));
  Csv("b.csv", Record(WithLeak(Filled(1.3 * gas))));
  const std::string runs =
      "runs:\n"
      "  - {model: quarter_setup2, data: a.csv, estimation: [0, 40], validation: [40, 60]}\n"
      "  - {model: quarter_setup2, data: b.csv, estimation: [0, 40]}\n";
  const std::string head = "rig: quarter\ncandidates: [piston_leakage, backlash]\n";
  const auto done =
      Identified(head + "shared: [L1.oil_volume_m3, L2.oil_volume_m3, friction.scale]\n" + runs);
  ASSERT_TRUE(done.ok()) << done.error().Line();
  const Json& fitted = done.value().result["fitted"];
  EXPECT_NEAR(fitted["run1.L1.gas_volume_m3"]["value"].get<double>() / gas, 0.7, 0.01);
  EXPECT_NEAR(fitted["run2.L1.gas_volume_m3"]["value"].get<double>() / gas, 1.3, 0.02);
  const auto second = phs_model::LoadPhsParams(folder_.File("out/model_2.yaml"));
  ASSERT_TRUE(second.ok()) << second.error().Line();
  EXPECT_NEAR(second.value().lines[0].gas_volume_m3 / gas, 1.3, 0.02);
  EXPECT_EQ(second.value().effects.size(), 1u);

  const auto refused = Identified(head + "shared: [L1.oil_volume]\n" + runs);
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().Line(), HasSubstr("did you mean 'L1.oil_volume_m3'"));
}

TEST_F(JoinedFiles, ARunWithoutAWindowIsNamed) {
  Csv("a.csv", Record(OffDeclared()));
  const auto refused = Identified(
      "rig: quarter\nmodel: quarter_setup2\nruns:\n"
      "  - {data: a.csv, estimation: [0, 40], validation: [40, 60]}\n  - {data: a.csv}\n");
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().Line(), HasSubstr("runs: run 2 has neither window"));
}

// What is left most of the last run is told by the name of its channel: it was looked up behind the
// last of the first run.
TEST_F(JoinedFiles, WhatIsLeftOfALaterRunIsToldByItsChannel) {
  Csv("a.csv", Record(OffDeclared()));
  FitData worse = Record(OffDeclared());
  auto& last = worse.outputs.back();
  const double begun = last.values.front();
  for (double& p : last.values) p += 0.3 * (p - begun);
  Csv("b.csv", worse);
  const auto done = Identified(
      "rig: quarter\nmodel: quarter_setup2\ncandidates: [piston_leakage]\nruns:\n"
      "  - {data: a.csv, estimation: [0, 40], validation: [40, 60]}\n"
      "  - {data: b.csv, estimation: [0, 40], validation: [40, 60]}\n");
  ASSERT_TRUE(done.ok()) << done.error().Line();
  const Json& result = done.value().result;
  EXPECT_EQ(result["localised"]["channel"], last.name);
  for (const auto& [name, over] : result["localised"]["residual_over_noise"].items()) {
    EXPECT_LE(over.get<double>(), result["localised"]["residual_over_noise"][last.name]) << name;
  }
  EXPECT_EQ(result["unexplained"]["channel"], last.name);
  EXPECT_GT(result["unexplained"]["estimation_over_noise"].get<double>(), 5);
}

// One seal at two pressures that nobody recorded: its level is each record's own, its viscous part
// and the mass are one.
TEST(JoinedBench, OneSealAtTwoPressures) {
  const ScratchDir folder;
  const std::string part =
      "name: part\ncylinders: [{name: \"1\"}]\nfriction: {model: static, curve: coulomb, "
      "coulomb_extension_N: 25, coulomb_retraction_N: 25, breakaway_extension_N: 25, "
      "breakaway_retraction_N: 25, viscous_extension_Ns_per_m: 80, "
      "viscous_retraction_Ns_per_m: 80, ramp_speed_m_s: 5.0e-4}\nelement: {mass_kg: 5}\n";
  folder.Write("part.yaml", part);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (const double level : {20.0, 35.0}) {
    Channels columns(3);
    for (int i = 0; i < 2500; ++i) {
      const double t = 0.01 * i, x = 0.02 * std::sin(2 * t) + 0.006 * std::sin(5 * t);
      const double v = 0.04 * std::cos(2 * t) + 0.03 * std::cos(5 * t);
      const double a = -0.08 * std::sin(2 * t) - 0.15 * std::sin(5 * t);
      columns[0].push_back(t), columns[1].push_back(x);
      columns[2].push_back(4 * a + level * std::tanh(v / 2e-4) + 60 * v + 0.1 * normal(random));
    }
    const std::string file = level == 20 ? "a.csv" : "b.csv";
    ASSERT_TRUE(WriteCsv(folder.File(file), {"t_s", "x_m", "force_N"}, columns).ok());
  }
  const auto manifest = measurement::LoadManifest(folder.Write(
      "manifest.yaml",
      "rig: element\nshared: [element.mass_kg, friction.viscous_Ns_per_m]\n"
      "free: [element.mass_kg, friction.coulomb_N, friction.viscous_Ns_per_m, "
      "friction.ramp_speed_m_s]\nruns:\n"
      "  - {model: part.yaml, data: a.csv, estimation: [0, 15], validation: [15, 25]}\n"
      "  - {model: part.yaml, data: b.csv, estimation: [0, 15], validation: [15, 25]}\n"));
  ASSERT_TRUE(manifest.ok()) << manifest.error().Line();
  auto dir = ResultDir::Create(folder.File("out"), true);
  const auto done = element::RunElementIdentify(manifest.value(), Few(1), nullptr, dir.value());
  ASSERT_TRUE(done.ok()) << done.error().Line();
  const Json& result = done.value().result;
  EXPECT_TRUE(result["effects"].empty()) << result["effects"].dump(1);
  const auto value = [&](const char* name) {
    return result["fitted"].value(name, Json::object()).value("value", std::nan(""));
  };
  EXPECT_NEAR(value("run1.friction.coulomb_N"), 20, 0.2);
  EXPECT_NEAR(value("run2.friction.coulomb_N"), 35, 0.2);
  EXPECT_NEAR(value("friction.viscous_Ns_per_m"), 60, 2);
  EXPECT_NEAR(value("element.mass_kg"), 4, 0.1);
  const auto second = phs_model::LoadPhsParams(dir.value().File("model_2.yaml"));
  ASSERT_TRUE(second.ok());
  EXPECT_NEAR(second.value().friction.coulomb_extension_N, 35, 0.2);
}

}  // namespace
}  // namespace phs::identify::search
