// phs sweep with a block `optimise:`: finds what a direct calculation finds, survives, is the same
// for any number of workers.
#include "sweep/optimisation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "base/json_path.h"
#include "sweep/study_file.h"
#include "tests/sweep/sweep_folder.h"

namespace phs::sweep {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

/// The softest shear stiffness whose axles stay within 4 mm under the thesis's traction load.
constexpr char kStudy[] =
    "scenario: straight\n"
    "optimise:\n"
    "  evaluations: 9\n"
    "  choices:\n"
    "    - {key: scenario.phs, values: [quarter_setup2, quarter_setup3]}\n"
    "  parameters:\n"
    "    - {key: model.*.oil_volume_m3, min: 0.9e-3, max: 1.9e-3, start: 1.1e-3}\n"
    "  cases:\n"
    "    - {name: bogie, analysis: loads}\n"
    "  objective:\n"
    "    - {case: bogie, result: cases.steering.lead_yaw_rad, weight: -1.0e+3}\n"
    "  constraints:\n"
    "    - {case: bogie, result: 'cases.traction, electric braking.largest_shift_m', "
    "at_most: 0.004}\n";

class OptimiseProgram : public SweepFolder {
 protected:
  OptimiseProgram() { std::ofstream(dir_.File("study.yaml")) << kStudy; }
};

TEST_F(OptimiseProgram, TheBestLiesOnTheConstraintAndTheSoftDesignCannotKeepIt) {
  const Output out = Sweep("best", "--workers 2");
  ASSERT_EQ(out.code, 0) << out.text;
  const Json json = Json::parse(Text("best/optimum.json"));
  EXPECT_EQ(json["best"]["design"]["scenario.phs"], "quarter_setup2");
  // Softer is always further: the optimum is where the constraint binds.
  EXPECT_NEAR(json["best"]["constraints"][0]["value"].get<double>(), 0.004, 1e-4);
  EXPECT_LE(json["best"]["constraints"][0]["value"].get<double>(), 0.004 * (1 + 1e-6));
  EXPECT_FALSE(json["combinations"][1]["best"]["keeps_constraints"].get<bool>());
  // Its files repeat the numbers by another door.
  const Output loads = ExecutePhs("loads --bogie phs --format json --phs " +
                                  dir_.File("best/best/bogie/model.yaml"));
  ASSERT_EQ(loads.code, 0) << loads.text;
  EXPECT_NEAR(-1e3 * NumberAt(Json::parse(loads.text), "cases.steering.lead_yaw_rad").value(),
              json["best"]["objective"].get<double>(), 1e-12);
}

TEST_F(OptimiseProgram, KilledAndResumedOrWithOneWorkerItIsTheSame) {
  ASSERT_EQ(Sweep("whole", "--workers 2").code, 0);
  const Output killed = SweepAndKill("killed", "--workers 1", 5);
  EXPECT_EQ(killed.code, 137) << killed.text;
  const Output resumed = Sweep("killed", "--workers 1 --resume");
  ASSERT_EQ(resumed.code, 0) << resumed.text;
  for (const char* file : {"sweep.csv", "candidates.csv", "optimum.json"}) {
    EXPECT_EQ(Text(std::string("whole/") + file), Text(std::string("killed/") + file)) << file;
  }
}

std::string Fault(const std::string& from, const std::string& to) {
  std::string text = kStudy;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  const std::string path = ScratchFile("study.yaml");
  std::ofstream(path) << text;
  const auto study = LoadStudy(path);
  return study.ok() ? "no error" : study.error().Line();
}

TEST(Optimisation, EachWrongBlockIsNamed) {
  EXPECT_THAT(Fault("case: bogie, result", "case: boggie, result"),
              HasSubstr("did you mean 'bogie'?"));
  EXPECT_THAT(Fault("at_most: 0.004", "magnitude: true"), HasSubstr("at_most, at_least or both"));
  EXPECT_THAT(Fault("model.*.oil_volume_m3", "model.*.oil_volum_m3"),
              HasSubstr("has no parameter"));
  EXPECT_THAT(Fault("  objective:", "    - {name: bogie}\n  objective:"),
              HasSubstr("is given twice"));
  EXPECT_THAT(Fault("start: 1.1e-3", "start: 3e-3"), HasSubstr("start"));
  EXPECT_THAT(Fault("optimise:\n", "axes: []\noptimise:\n"), HasSubstr("beside `optimise`"));
  EXPECT_THAT(Fault("analysis: loads", "analysis: load"), HasSubstr("did you mean 'loads'?"));
}

TEST(Optimisation, SharesAndBoundsAreThoseOfTheFormulas) {
  const DesignParameter log{"model.x", 1e-5, 1e-3, 1e-4, true};
  EXPECT_NEAR(log.AtShare(0.5), 1e-4, 1e-18);
  EXPECT_NEAR(log.ShareOf(1e-4), 0.5, 1e-12);
  DesignConstraint at_most, at_least;
  at_most.bound = 4;
  at_least.bound = -4;
  at_least.at_most = false;
  EXPECT_DOUBLE_EQ(at_most.Violation(5), 0.25);
  EXPECT_DOUBLE_EQ(at_most.Violation(3), -0.25);
  EXPECT_DOUBLE_EQ(at_least.Violation(-5), 0.25);
  EXPECT_GT(at_most.Violation(std::nan("")), 0);
  Optimisation o;
  o.choices = {{"a", {"1", "2"}}, {"b", {"x", "y", "z"}}};
  EXPECT_EQ(o.NumCombinations(), 6);
  EXPECT_EQ(o.Combination(4), (std::vector<std::string>{"2", "y"}));
}

}  // namespace
}  // namespace phs::sweep
