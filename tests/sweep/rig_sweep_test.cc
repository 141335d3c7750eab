// Sweeps over rigs: the numbers are those of `phs rig`, to the bit; what ends a sweep, and resumes it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/json_path.h"
#include "base/table.h"
#include "base/words.h"
#include "tests/sweep/sweep_folder.h"

namespace phs {
namespace {

using testing::HasSubstr;

class RigSweep : public SweepFolder {
 protected:
  RigSweep() { Write("bench.yaml", Bench("0.5")); }
  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(dir_.File(name)) << text;
  }
  static std::string Bench(const std::string& duration_s, const std::string& more = "") {
    return "rig: quarter\nmodel: quarter_setup2\nsignal:\n  duration_s: " + duration_s +
           "\n  sample_s: 0.001\n  actuator_m: {kind: sine, amplitude_m: 1.5e-3, frequency_Hz: "
           "4}\n" +
           more;
  }
  void Study(const std::string& axes, const std::string& outputs = "") const {
    Write("study.yaml", "rig: bench.yaml\naxes:\n" + axes +
                            (outputs.empty() ? "" : "outputs: [" + outputs + "]\n"));
  }
  static void ExpectOneLine(const Output& out, const std::string& words, int code = 3) {
    EXPECT_EQ(out.code, code) << out.text;
    EXPECT_THAT(out.text, HasSubstr(words));
    EXPECT_EQ(std::count(out.text.begin(), out.text.end(), '\n'), 1) << out.text;
  }
  nlohmann::ordered_json Rig(const std::string& manifest) const {
    const Output out =
        Execute(PhsCommand("rig " + manifest + " --force --format json --out " + dir_.File("rig")));
    EXPECT_EQ(out.code, 0) << out.text;
    return nlohmann::ordered_json::parse(Text("rig/result.json"));
  }
};

TEST_F(RigSweep, TheNumbersAreThoseOfPhsRigToTheBit) {
  const std::vector<std::string> outputs = {
      "largest.load_cell_N", "rms.hydraulic_N", "extremes.p_bore_Pa.least",
      "hydraulic_force.against_load_cell.m_re_percent", "compared_with.load_cell_N.m_re_percent"};
  Study(
      "  - {key: model.*.oil_volume_m3, values: [0.9e-3, 1.3e-3]}\n"
      "  - {key: model.temperature_K, values: [285]}\n"
      "  - {key: rig.signal.actuator_m.amplitude_m, values: [-1e-3, 1.7e-3]}\n",
      JoinWords(outputs));
  Write("bench.yaml", Bench("0.5", "phs_parameters: {filled_at_K: 293.15}\n"));
  ASSERT_EQ(Sweep("out", "--workers 2").code, 0);
  const phs::Table table = ReadCsv(dir_.File("out/sweep.csv")).value();
  const int last = table.num_columns() - 1;  // the outputs stand between `status` and `reason`
  const int first = table.Find("status") + 1;
  ASSERT_EQ(last - first, static_cast<int>(outputs.size()));
  const char* const oil[] = {"0.9e-3", "1.3e-3"};
  const char* const amplitude[] = {"-1e-3", "1.7e-3"};
  for (int run = 0; run < 4; ++run) {
    // Written by hand, not as the sweep lays it out.
    std::string text =
        Bench("0.5", std::string("phs_parameters: {filled_at_K: 293.15, ") +
                         "temperature_K: 285, L1.oil_volume_m3: " + oil[run / 2] +
                         ", L2.oil_volume_m3: " + oil[run / 2] + "}\ncompare_with: bench.yaml\n");
    text.replace(text.find("1.5e-3"), 6, amplitude[run % 2]);
    Write("own.yaml", text);
    const auto numbers = Rig(dir_.File("own.yaml"));
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      EXPECT_EQ(table.columns[static_cast<std::size_t>(first) + k][static_cast<std::size_t>(run)],
                NumberAt(numbers, outputs[k]).value())
          << run << " " << outputs[k];
    }
  }
  // A run laid out as files is repeated by the command that is printed.
  const Output only = Execute(
      PhsCommand("sweep " + dir_.File("study.yaml") + " --only 3 --out " + dir_.File("run_3")));
  EXPECT_THAT(only.text, HasSubstr("phs rig " + dir_.File("run_3") + "/rig.yaml --out "));
  EXPECT_EQ(NumberAt(Rig(dir_.File("run_3/rig.yaml")), outputs[4]).value(),
            table.columns[static_cast<std::size_t>(first) + 4][3]);
}

TEST_F(RigSweep, ARecordIsComparedAndHashed) {
  Rig(dir_.File("bench.yaml"));
  std::filesystem::create_directory(dir_.File("records"));
  std::filesystem::rename(dir_.File("rig/predicted.csv"), dir_.File("records/run.csv"));
  Write("bench.yaml",
        "rig: quarter\nmodel: quarter_setup2\ndata: ${RUNS}/run.csv\nsubsteps: 400\n");
  environment_ = "RUNS=" + dir_.File("records") + " ";
  Study("  - {key: model.friction.scale, from: 0.5, to: 1.5, count: 21}\n",
        "channels.load_cell_N.m_re_percent, hydraulic_force.against_pressures.rmse");
  const Output killed = Execute("export " + environment_ + "; " + Command("killed", "--workers 1") +
                                " & P=$!; " + UntilRecords("killed", 2) + "kill -KILL $P; wait $P");
  EXPECT_EQ(killed.code, 137) << killed.text;
  const std::string plan = Text("killed.unfinished/plan.txt");
  for (const char* name : {"/bench.yaml\n", "/study.yaml\n", "/records/run.csv\n",
                           "/models/phs/quarter_setup2.yaml\n"}) {
    EXPECT_THAT(plan, HasSubstr(name));
  }
  const std::string record = Text("records/run.csv");
  Write("records/run.csv", record + "# another word\n");
  ExpectOneLine(Sweep("killed", "--resume"), "/records/run.csv: has changed since the sweep");
  Write("records/run.csv", record);
  ASSERT_EQ(Sweep("killed", "--resume --workers 2").code, 0);
  ASSERT_EQ(Sweep("whole", "--workers 2").code, 0);
  EXPECT_EQ(Table("killed"), Table("whole"));
  const phs::Table table = ReadCsv(dir_.File("whole/sweep.csv")).value();
  const auto error = table.Column("load_cell_N_m_re_percent").value();
  const auto pressures = table.Column("against_pressures_rmse").value();
  EXPECT_LT(error[10], 0.05) << "the very model that made the record; its motion is smoothed";
  EXPECT_GT(error[0], 5 * error[10]);
  EXPECT_LT(*std::max_element(pressures.begin(), pressures.end()), 30.0)
      << "N, of 50 kN: seal friction does not act on rigid pressures";
}

TEST_F(RigSweep, WrongStudiesEndInOneLineWithTheNearestName) {
  const auto with = [&](const std::string& axis, const std::string& words,
                        const std::string& outputs = "") {
    Study("  - " + axis + "\n", outputs);
    ExpectOneLine(Sweep("none"), words);
    EXPECT_FALSE(std::filesystem::exists(dir_.File("none.unfinished")));
  };
  with("{key: model.L1.gas_volum_m3, values: [1e-5]}", "did you mean 'L1.gas_volume_m3'?");
  with("{key: rig.signal.actuator_m.amplitud_m, values: [1e-3]}", "did you mean 'amplitude_m'?");
  with("{key: rig.signl.actuator_m.amplitude_m, values: [1e-3]}", "did you mean 'signal'?");
  with("{key: rigs.substeps, values: [1]}",
       "'rigs.substeps' is no key of a run; allowed: rig.KEY, model.PARAMETER, note.NAME; did you "
       "mean 'rig'?");
  with("{key: scenario.speed_km_h, values: [60]}", "allowed: rig.KEY, model.PARAMETER");
  with("{key: model.friction.scale, values: [1]}",
       "outputs: largest.load1_N: is no number of the result; allowed: paths of numbers in "
       "result.json; did you mean 'largest.load_cell_N'?",
       "largest.load1_N");
  const std::string axis = "axes: [{key: model.friction.scale, values: [1]}]\n";
  Write("study.yaml", "rig: bench.yaml\nanalysis: modes\n" + axis);
  ExpectOneLine(Sweep("none"), "'modes' is none of a rig; allowed: rig");
  Write("study.yaml", "scenario: curve_r550\nanalysis: rig\n" + axis);
  ExpectOneLine(Sweep("none"), "'rig' is none of a scenario; allowed: simulate, curving");
  Write("study.yaml", "scenario: curve_r550\nrig: bench.yaml\n" + axis);
  ExpectOneLine(Sweep("none"), "rig: is given beside `scenario`");
  Write("study.yaml", "rig: lowe/fig_6_1\n" + axis);
  ExpectOneLine(Sweep("none"), "did you mean 'lowe/fig_6_10'?");
  Write("study.yaml", "rig: steps_setup2\n" + axis);
  ExpectOneLine(Sweep("none"), "rig.rig: 'steps' is no rig driven over time");
  Write("study.yaml", "rig: bench.yaml\nvary_irregularity: true\n" + axis);
  ExpectOneLine(Sweep("none"), "vary_irregularity: a rig has no track");
}

TEST_F(RigSweep, AWrongRunIsAnErrorInItsRow) {
  Study("  - {key: rig.signal.actuator_m.amplitude_m, values: [1e-3, 0.2]}\n");
  const Output out = Sweep("errors");
  EXPECT_EQ(out.code, 1) << out.text;
  EXPECT_THAT(Table("errors"), HasSubstr("0,1e-3,ok,"));
  EXPECT_THAT(Table("errors"), HasSubstr("1,0.2,error,"));
  EXPECT_THAT(Table("errors"), HasSubstr("beyond its stop"));
}

TEST_F(RigSweep, ChecksAndReportAsForScenarios) {
  Write("study.yaml",
        "rig: bench.yaml\ndesign: sobol_indices\nsamples: 4\naxes:\n"
        "  - {key: model.*.oil_volume_m3, min: 1e-3, max: 2e-3}\n"
        "  - {key: model.L1.accumulator_precharge_Pa, min: 14e6, max: 15e6}\n"
        "outputs: [largest.hydraulic_N]\n");
  Write("limits.yaml", "limits: [{quantity: largest.largest.hydraulic_N, at_most: 1}]\n");
  const Output out =
      Sweep("out", "--check " + dir_.File("limits.yaml") + " --junit " + dir_.File("junit.xml"));
  EXPECT_EQ(out.code, 1) << out.text;
  EXPECT_THAT(Text("junit.xml"), HasSubstr("largest.hydraulic_N"));
  const auto kept = nlohmann::ordered_json::parse(Text("out/sweep_report.json"));
  EXPECT_GT(kept["indices"][0]["total"][0].get<double>(), 0.2) << kept.dump(1);
  EXPECT_EQ(kept["indices"][0]["total"][1].get<double>(), 0) << "1.5 mm do not open the blow-off";
  EXPECT_THAT(Text("out/report.html"), HasSubstr("Sobol indices"));
}

}  // namespace
}  // namespace phs
