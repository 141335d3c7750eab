// Records as people have them: other zeros, units and notations than the program's. Each is read
// right, or said to be wrong; none is explained away.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/table.h"
#include "identify/run/rig_identify.h"
#include "tests/base/scratch_dir.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {
namespace {

using testing::HasSubstr;

/// Columns of a record by name.
using Columns = std::map<std::string, std::vector<double>>;

Columns ColumnsOf(const measurement::FitData& data) {
  Columns out = {{"t_s", data.time_s}, {"actuator_m", data.inputs[0].values}};
  for (const auto& channel : data.outputs) out[channel.name] = channel.values;
  return out;
}

void Change(std::vector<double>* column, const std::function<double(double)>& how) {
  for (double& y : *column) y = how(y);
}

class MessyRecord : public testing::Test {
 protected:
  Result<IdentifyOutcome> Identified(const Columns& columns, const std::string& more = "") const {
    std::vector<std::string> names;
    std::vector<std::vector<double>> values;
    for (const auto& [name, column] : columns) names.push_back(name), values.push_back(column);
    EXPECT_TRUE(WriteCsv(folder_.File("run.csv"), names, values).ok());
    return OfFile(more);
  }
  /// `more`: lines of the manifest, in the place of `columns:` and the like.
  Result<IdentifyOutcome> OfFile(const std::string& more = "") const {
    const std::string text =
        "rig: quarter\nmodel: quarter_setup2\ndata: run.csv\nestimation: [0, 40]\n"
        "validation: [40, 60]\ncandidates: [piston_leakage, sensor_gain, pressure_area, "
        "unlisted]\n" +
        more;
    const auto manifest = measurement::LoadManifest(folder_.Write("manifest.yaml", text));
    if (!manifest.ok()) return manifest.error();
    auto dir = ResultDir::Create(folder_.File("out"), true);
    if (!dir.ok()) return dir.error();
    return IdentifyDriven(manifest.value(), {}, nullptr, dir.value());
  }
  ScratchDir folder_;
};

std::string Verdict(const Result<IdentifyOutcome>& outcome) {
  EXPECT_TRUE(outcome.ok()) << outcome.error().Line();
  return outcome.ok() ? outcome.value().result["verdict"].get<std::string>() : "";
}

std::string Dump(const Result<IdentifyOutcome>& outcome, const char* key) {
  return outcome.ok() ? outcome.value().result[key].dump() : "";
}

TEST_F(MessyRecord, SensorsAtTheMiddleOfTheirStrokeCountFromTheStaticState) {
  const Columns sound = ColumnsOf(Record(OffDeclared()));
  for (const auto& [actuator, piston] :
       {std::pair{0.0125, 0.0125}, {0.0125, -0.0075}, {0.0, 7.5e-3}, {3e-4, 3e-4}, {0.05, 0.05}}) {
    Columns moved = sound;
    Change(&moved["actuator_m"], [by = actuator](double x) { return x + by; });
    Change(&moved["piston_m"], [by = piston](double x) { return x + by; });
    const auto outcome = Identified(moved);
    EXPECT_EQ(Verdict(outcome), "sufficient") << actuator << " " << piston;
    EXPECT_THAT(Dump(outcome, "data_findings"),
                HasSubstr("in the static state: counted from there"));
  }
}

// A record that begins where the pistons do stand elsewhere is left as it is: its pressures say so.
TEST_F(MessyRecord, APistonThatBeginsElsewhereStaysThere) {
  hydraulics::PhsParams truth = OffDeclared();
  const auto away = RecordOf(truth, [](double t) { return 2e-3 * std::cos(2 * M_PI * t / 4); });
  const auto outcome = Identified(ColumnsOf(away));
  EXPECT_THAT(Dump(outcome, "data_findings"), testing::Not(HasSubstr("counted from there")));
}

// Its noise of 1.5 um, read as 1.5 m, is no zero elsewhere; nor is a start 20 um beside the zero.
TEST_F(MessyRecord, NoiseInAnotherUnitIsNoZeroElsewhere) {
  Columns record = ColumnsOf(Record(OffDeclared()));
  Change(&record["piston_m"], [](double x) { return 1e6 * x; });
  Change(&record["actuator_m"], [](double x) { return x + 2e-5; });
  const auto outcome = Identified(record);
  EXPECT_THAT(Dump(outcome, "data_findings"), testing::Not(HasSubstr("counted from there")));
  EXPECT_THAT(Dump(outcome, "data_findings"), HasSubstr("taken in um"));
}

// A load cell in kgf had been explained by an error of the load cell on no list, and a leak beside it
// was not found.
TEST_F(MessyRecord, ALoadCellInAnotherUnitIsAskedAboutAndNotExplained) {
  hydraulics::PhsParams leaks = OffDeclared();
  leaks.effects.push_back({"piston_leakage", {}, {{"conductance_m3_per_Pas", 1e-13}}});
  struct Case {
    hydraulics::PhsParams truth;
    double factor;
    const char* unit;
  };
  for (const Case& c :
       {Case{OffDeclared(), 9.81, "another unit"}, Case{leaks, 1 / 9.80665, "kgf"}}) {
    Columns record = ColumnsOf(Record(c.truth));
    Change(&record["load_cell_N"], [&](double y) { return c.factor * y; });
    const auto outcome = Identified(record);
    EXPECT_EQ(Verdict(outcome), "not_described") << c.unit;
    EXPECT_THAT(Dump(outcome, "reasons"), HasSubstr(std::string("is it in ") + c.unit + "?"));
    EXPECT_THAT(Dump(outcome, "data_findings"), HasSubstr("load_cell_N")) << c.unit;
  }
}

// What a program has predicted itself has no noise: what is left is rounding.
TEST_F(MessyRecord, DataWithoutNoiseAreDescribedByTheirOwnModel) {
  const auto way = [](double t) {  // at rest for 3 s: repeats are no stuck sensor
    return t < 3 ? 0 : 1.2e-3 * std::pow(std::sin(2 * M_PI * (t - 3) / 7), 3);
  };
  measurement::FitData data = RecordOf(Declared(), way);
  for (size_t i = 0; i < data.time_s.size(); ++i) {
    data.inputs[0].values[i] = data.motion[0].position[i] = way(data.time_s[i]);
  }
  data.motion[0] = measurement::SmoothPosition(data.inputs[0].values, {}, data.step_s, 1e-12);
  const Channels exact = PredictWhole(data, Declared());
  Columns columns = ColumnsOf(data);
  for (size_t c = 0; c < data.outputs.size(); ++c) columns[data.outputs[c].name] = exact[c];
  const auto outcome = Identified(columns);
  EXPECT_EQ(Verdict(outcome), "sufficient") << Dump(outcome, "reasons");
  EXPECT_THAT(Dump(outcome, "data_findings"), testing::Not(HasSubstr("stuck")));
}

TEST_F(MessyRecord, UnitsMayStandInBrackets) {
  Columns record = ColumnsOf(Record(OffDeclared()));
  const auto rename = [&](const char* from, const char* to, double factor) {
    std::vector<double> column = record.at(from);
    record.erase(from);
    Change(&column, [&](double y) { return factor * y; });
    record[to] = std::move(column);
  };
  rename("load_cell_N", "Kraft [kN]", 1e-3);
  rename("p_bore_Pa", "p_bore (bar)", 1e-5);
  rename("actuator_m", "Weg (mm)", 1e3);
  rename("piston_m", "piston [\u00b5m]", 1e6);
  const auto outcome =
      Identified(record, "columns: {load_cell_N: \"Kraft [kN]\", actuator_m: \"Weg (mm)\"}\n");
  EXPECT_EQ(Verdict(outcome), "sufficient") << Dump(outcome, "data_findings");
  EXPECT_EQ(Dump(outcome, "channels").find("p_bore_Pa") != std::string::npos, true);
  rename("Kraft [kN]", "Kraft [dyn]", 1e8);
  const auto asked =
      Identified(record, "columns: {load_cell_N: \"Kraft [dyn]\", actuator_m: \"Weg (mm)\"}\n");
  EXPECT_THAT(Dump(asked, "data_findings"), HasSubstr("is not known, taken in N"));
}

TEST_F(MessyRecord, CellsThatAreNotReadAreShown) {
  const Columns record = ColumnsOf(Record(OffDeclared()));
  const auto write = [&](const char* channel, const std::function<std::string(size_t)>& cell) {
    std::string text;
    for (const auto& [name, column] : record) text += (text.empty() ? "" : ",") + name;
    text += "\n";
    for (size_t i = 0; i < record.at("t_s").size(); ++i) {
      std::string line;
      for (const auto& [name, column] : record) {
        line += (line.empty() ? "" : ",") + (name == channel ? cell(i) : std::to_string(column[i]));
      }
      text += line + "\n";
    }
    folder_.Write("run.csv", text);
  };
  write("load_cell_N", [](size_t) { return "\"13,447.5\""; });
  const auto refused = OfFile();
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().Line(),
              HasSubstr("run.csv:2: 'load_cell_N': '13,447.5' is no number"));
  write("t_s", [](size_t) { return "2026-01-05 10:00:00"; });
  EXPECT_THAT(OfFile().error().Line(), HasSubstr("run.csv:2: 't_s': '2026-01-05 10"));
  // A few are said, and those that mark what is missing are no fault.
  write("piston_m", [](size_t i) { return i == 70 ? "over" : i % 50 == 0 ? "NaN" : "0.0"; });
  EXPECT_THAT(Dump(OfFile(), "data_findings"),
              HasSubstr("1 cell holds no number, the first 'over' at"));
}

}  // namespace
}  // namespace phs::identify::search
