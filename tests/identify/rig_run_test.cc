// `phs rig` as a library: every rig, generated and measured motion, bad input.
#include "identify/run/rig_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "base/table.h"
#include "identify/run/steps_run.h"
#include "phs_places.h"
#include "rigs/rig_signal.h"
#include "tests/base/scratch_dir.h"

namespace phs::identify {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const char kQuarter[] = R"(
name: bench
cylinders:
  - {name: "1", bore_line: L2, rod_line: L1}
lines:
  - {name: L1, static_pressure_Pa: 2005347.5935828877, oil_volume_m3: 1.1e-3, bulk_modulus_Pa: 1.4e9,
     reservoir: {volume_m3: 0.32e-3, gas_volume_m3: 16.16e-6}}
  - {name: L2, static_pressure_Pa: 1.8e6, oil_volume_m3: 1.1e-3, bulk_modulus_Pa: 1.4e9,
     reservoir: {volume_m3: 0.32e-3, gas_volume_m3: 16.16e-6}}
)";
const char kSine[] = "{kind: sine, amplitude_m: 1.5e-3, frequency_Hz: 0.5}";

class RigRunTest : public testing::Test {
 protected:
  std::string Path(const std::string& name) const { return folder_.File(name); }
  std::string Write(const std::string& name, const std::string& text) const {
    return folder_.Write(name, text);
  }
  Result<RigOutcome> Execute(const std::string& manifest_text, const std::string& out) const {
    Result<measurement::Manifest> manifest = measurement::LoadManifest(
        Write("manifest.yaml", manifest_text), measurement::WindowNeed::kNone);
    if (!manifest.ok()) return manifest.error();
    return ExecuteManifest(manifest.value(), out);
  }
  Result<RigOutcome> ExecuteManifest(const measurement::Manifest& manifest,
                                     const std::string& out) const {
    Result<ResultDir> dir = ResultDir::Create(Path(out), true);
    if (!dir.ok()) return dir.error();
    Result<RigOutcome> outcome = RunRig(manifest, dir.value());
    if (outcome.ok()) {
      EXPECT_TRUE(dir.value().Commit().ok());
    }
    return outcome;
  }
  std::string Signal(const std::string& rig, const std::string& model, const std::string& channel,
                     const std::string& signal) const {
    return "rig: " + rig + "\nmodel: " + model + "\nsignal:\n  duration_s: 8\n  " + channel + ": " +
           signal + "\n";
  }
  void ExpectRefused(const std::string& manifest_text, const std::string& words) const {
    const Result<RigOutcome> out = Execute(manifest_text, "refused");
    ASSERT_FALSE(out.ok()) << words;
    EXPECT_THAT(out.error().Line(), HasSubstr(words));
    EXPECT_FALSE(fs::exists(Path("refused")));
  }
  /// The quarter model with one piece of text replaced.
  std::string Model(const std::string& from, const std::string& to) const {
    std::string text = kQuarter;
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return Write("model.yaml", text.replace(at, from.size(), to));
  }
  ScratchDir folder_;
};

TEST_F(RigRunTest, EveryExampleRunsAndHoldsNumbersOnly) {
  for (const char* name :
       {"cylinder_ramp", "quarter_sine", "quarter_triangle", "full_multisine", "element_seal",
        "steps_setup1", "steps_setup2", "steps_setup3", "steps_setup4"}) {
    const std::string path = std::string(PHS_TEST_DATA "/../rigs/") + name + ".yaml";
    Result<measurement::Manifest> manifest =
        measurement::LoadManifest(path, measurement::WindowNeed::kNone);
    ASSERT_TRUE(manifest.ok()) << manifest.error().Line();
    const Result<RigOutcome> out = ExecuteManifest(manifest.value(), name);
    ASSERT_TRUE(out.ok()) << out.error().Line();
    const Table predicted = ReadCsv(Path(std::string(name) + "/predicted.csv")).value();
    EXPECT_GE(predicted.num_rows(), 4) << name;  // setup 1 has four steps
    for (const auto& column : predicted.columns) {
      for (const double value : column) ASSERT_TRUE(std::isfinite(value)) << name;
    }
  }
}

TEST_F(RigRunTest, ItsOwnPredictionAsMeasurementIsMatched) {
  const std::string model = Write("model.yaml", kQuarter);
  ASSERT_TRUE(Execute(Signal("quarter", model, "actuator_m", kSine), "first").ok());
  const Result<RigOutcome> again =
      Execute("rig: quarter\nmodel: " + model + "\ndata: " + Path("first/predicted.csv") +
                  "\nvalidation: [4, 8]\n",
              "second");
  ASSERT_TRUE(again.ok()) << again.error().Line();
  for (const char* channel : {"load_cell_N", "p_bore_Pa", "p_rod_Pa"}) {
    EXPECT_LT(again.value().result["channels"][channel]["nrmse"].get<double>(), 0.01) << channel;
  }
  // A model that is wrong is seen to be: twice the gas.
  const std::string soft = Model("gas_volume_m3: 16.16e-6", "gas_volume_m3: 32.32e-6");
  const Result<RigOutcome> wrong = Execute(
      "rig: quarter\nmodel: " + soft + "\ndata: " + Path("first/predicted.csv") + "\n", "third");
  ASSERT_TRUE(wrong.ok());
  EXPECT_GT(wrong.value().result["channels"]["p_rod_Pa"]["nrmse"].get<double>(), 0.2);
}

TEST_F(RigRunTest, RefusesAStrokeBeyondTheStop) {
  const std::string model = Write("model.yaml", kQuarter);
  ExpectRefused(
      Signal("quarter", model, "actuator_m", "{kind: ramp, amplitude_m: 0.031, speed_m_s: 0.01}"),
      "beyond its stop; allowed: -0.03 to 0.03 m");
  std::string csv = "t_s,actuator_m,load_cell_N\n";
  for (int i = 0; i < 100; ++i) csv += std::to_string(i * 0.01) + "," + std::to_string(i) + ",0\n";
  ExpectRefused("rig: quarter\nmodel: " + model + "\ndata: " + Write("mm.csv", csv) + "\n",
                "beyond its stop");
}

TEST_F(RigRunTest, RefusesImpossibleModels) {
  const auto refused = [&](const char* from, const char* to, const char* words) {
    ExpectRefused(Signal("quarter", Model(from, to), "actuator_m", kSine), words);
  };
  refused("static_pressure_Pa: 1.8e6", "static_pressure_Pa: 0", "static_pressure_Pa: 0");
  refused("static_pressure_Pa: 1.8e6, oil_volume_m3: 1.1e-3",
          "static_pressure_Pa: 1.8e6, oil_volume_m3: 0", "oil_volume_m3");
  refused("name: bench", "name: bench\ntemperature_K: 0", "temperature_K");
  refused("bulk_modulus_Pa: 1.4e9", "bulk_modulus_Pa: .nan", "bulk_modulus_Pa");
  refused("rod_line: L1", "rod_line: L3", "unknown line");
}

TEST_F(RigRunTest, RefusesBrokenData) {
  const std::string model = Write("model.yaml", kQuarter);
  const std::string head = "rig: quarter\nmodel: " + model + "\ndata: ";
  ExpectRefused(head + Write("a.csv", "t_s,actuator_m,load_cell_N\n0,0,0\n1,0\n") + "\n",
                "a.csv:3");
  ExpectRefused(head + Write("b.csv", "") + "\n", "b.csv");
  ExpectRefused(head + Write("c.csv", "t_s,load_cell_N\n0,1\n1,2\n") + "\n", "c.csv");
  ExpectRefused(head + Path("missing.csv") + "\n", "missing.csv");
  ExpectRefused(head + "x.csv\nsignal: {duration_s: 1}\n", "either `data:` or `signal:`");
  ExpectRefused(Signal("quarter", model, "actuator1_m", kSine), "did you mean 'actuator_m'?");
  ExpectRefused(Signal("quarter", model, "actuator_m", "{kind: sinus, amplitude_m: 1}"), "sine");
  ExpectRefused("rig: steps\nmodel: quarter_setup2\ndata: " +
                    Write("steps.csv", "row,chamber,setup\n1,2,3\n") + "\n",
                "step_actuator_mm");
}

TEST_F(RigRunTest, RefusesSeveralRunsWhereItComparesOne) {
  const std::string model = Write("model.yaml", kQuarter);
  const auto outcome = Execute(
      "rig: quarter\nmodel: " + model + "\nruns: [{data: one.csv}, {data: two.csv}]\n", "out");
  ASSERT_FALSE(outcome.ok());
  EXPECT_THAT(outcome.error().Line(), HasSubstr("runs: phs rig compares one run"));
}

TEST_F(RigRunTest, StepTablesByTheThesisNames) {
  const std::string table = Write(
      "t.csv",
      "row,chamber,mode,setup,step_schenck_mm,step_laser_mm,P_begin_MPa,P_end_MPa,tau_s,valid\n"
      "7,1,compression,2,-3.0,-1.5,9.14,8.99,4.9,1\n9,2,compression,2,3.0,1.43,9.34,9.055,3.1,1\n"
      "27,1,compression,4,-3.0,-2.63,2.55,2.34,0.4,1\n");
  const Result<RigOutcome> out =
      Execute("rig: steps\nmodel: quarter_setup2\ndata: " + table + "\n", "steps");
  ASSERT_TRUE(out.ok()) << out.error().Line();
  EXPECT_EQ(out.value().result["setup"], 2);
  EXPECT_EQ(out.value().result["rows"].size(), 2U);
}

TEST(RigSignal, ShapesAreAsDefined) {
  using rigs::SignalKind;
  rigs::SignalParams s;
  s.amplitude = 2e-3;
  s.frequency_Hz = 0.5;
  s.kind = SignalKind::kTriangle;
  const std::vector<double> triangle = rigs::GenerateSignal(s, 201, 0.01);
  EXPECT_NEAR(triangle[50], 2e-3, 1e-12);
  EXPECT_NEAR(triangle[100], 0, 1e-12);
  EXPECT_NEAR(triangle[150], -2e-3, 1e-12);
  EXPECT_NEAR(triangle[25], 1e-3, 1e-12);
  s.kind = SignalKind::kMultisine;
  s.high_frequency_Hz = 4;
  s.tones = 12;
  double peak = 0;
  const std::vector<double> multisine = rigs::GenerateSignal(s, 2001, 0.01);
  for (const double x : multisine) peak = std::max(peak, std::abs(x));
  EXPECT_DOUBLE_EQ(peak, 2e-3);
  EXPECT_EQ(multisine[0], 0);
  s.kind = SignalKind::kStep;
  s.levels = {1e-3, -2e-3};
  s.rise_s = 0.2;
  s.hold_s = 1;
  const std::vector<double> steps = rigs::GenerateSignal(s, 301, 0.01);
  EXPECT_NEAR(steps[10], 0.5e-3, 1e-12);
  EXPECT_NEAR(steps[100], 1e-3, 1e-12);
  EXPECT_NEAR(steps[130], -0.5e-3, 1e-12);
  EXPECT_NEAR(steps[300], -2e-3, 1e-12);
  s.kind = SignalKind::kRamp;
  s.rate = -1e-3;
  s.start_s = 0.5;
  const std::vector<double> ramp = rigs::GenerateSignal(s, 401, 0.01);
  EXPECT_EQ(ramp[50], 0);
  EXPECT_NEAR(ramp[150], -1e-3, 1e-12);
  EXPECT_NEAR(ramp[400], -2e-3, 1e-12);
}

}  // namespace
}  // namespace phs::identify
