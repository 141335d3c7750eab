// A law of the user's own, offered to the search: the example of docs/identify.md on a record made
// here with equations of its own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "base/data_path.h"
#include "identify/models/own_candidates.h"
#include "identify/run/element_run.h"
#include "identify/run/rig_identify.h"
#include "phs_model/phs_model.h"

namespace phs::identify {

using measurement::LoadManifest;
using measurement::OwnCandidate;
using testing::HasSubstr;
namespace {

namespace fs = std::filesystem;

/// The block of YAML that follows `heading` in docs/identify.md.
std::string Example(const std::string& heading) {
  const auto page = FindData("page", "docs", "identify", {".md"});
  EXPECT_TRUE(page.ok());
  std::stringstream text;
  text << std::ifstream(page.value()).rdbuf();
  const std::string all = text.str();
  const size_t at = all.find(heading);
  const size_t begin = all.find("```yaml\n", at), end = all.find("```", begin + 8);
  EXPECT_TRUE(at != std::string::npos && end != std::string::npos) << heading;
  return all.substr(begin + 8, end - begin - 8);
}

class Folder {
 public:
  explicit Folder(const std::string& name) : path_(fs::temp_directory_path() / ("phs_" + name)) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return (path_ / name).string();
  }
  std::string File(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

/// A part of 30 N Coulomb and 60 N s/m with an eddy-current brake: F = c i² v, whose current lags
/// behind its voltage, tau di/dt = u/R - i; c = 25 N s/(m A²), R = 8 ohm, tau = 0.2 s; integrated
/// here with 50 explicit steps a sample. Noise 0.3 N. `braked`: false leaves the brake out.
void WriteBrakeRecord(const Folder& folder, bool braked = true) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::ofstream csv(folder.File("run.csv"));
  csv << "t_s,x_m,force_N,u_coil\n";
  csv.precision(12);
  double current = 0;
  for (int i = 0; i < 4000; ++i) {
    const double t = 0.01 * i;
    const auto voltage = [](double at) {
      return 12 + 12 * std::sin(1.7 * at) * std::cos(0.3 * at);
    };
    double x = 0, v = 0;
    const double amplitude[] = {0.03, 0.012, 0.004}, w[] = {0.9, 2.3, 5.9};
    for (int k = 0; k < 3; ++k) {
      x += amplitude[k] * std::sin(w[k] * t + k);
      v += amplitude[k] * w[k] * std::cos(w[k] * t + k);
    }
    const double brake = braked ? 25 * current * current * v : 0;
    csv << t << ',' << x + 2e-7 * normal(random) << ','
        << std::tanh(v / 2e-4) * 30 + 60 * v + brake + 0.3 * normal(random) << ',' << voltage(t)
        << '\n';
    for (int k = 0; k < 50; ++k) {
      current += 2e-4 * (voltage(t + 2e-4 * k) / 8 - current) / 0.2;
    }
  }
  folder.Write("part.yaml",
               "name: part\ncylinders: [{name: \"1\"}]\nfriction: {model: static, curve: coulomb, "
               "coulomb_extension_N: 25, coulomb_retraction_N: 25, breakaway_extension_N: 25, "
               "breakaway_retraction_N: 25, viscous_extension_Ns_per_m: 70, "
               "viscous_retraction_Ns_per_m: 70, ramp_speed_m_s: 4.0e-4}\nelement: {}\n");
}

/// The example with another model.
std::string WithModel(const std::string& model) {
  std::string text = Example("### A law of one's own");
  const size_t at = text.find("model: ");
  return text.replace(at, text.find('\n', at) - at, "model: " + model);
}

TEST(OwnCandidate, TheExampleOfTheDocsIsFoundByItsName) {
  const Folder folder("own_candidate");
  WriteBrakeRecord(folder);
  const std::string manifest = folder.Write("manifest.yaml", WithModel(folder.File("part.yaml")));
  const auto loaded = LoadManifest(manifest);
  ASSERT_TRUE(loaded.ok()) << loaded.error().Line();
  auto dir = ResultDir::Create(folder.File("out"), true);
  const auto run = element::RunElementIdentify(loaded.value(), {}, nullptr, dir.value());
  ASSERT_TRUE(run.ok()) << run.error().Line();
  const auto& r = run.value().result;
  ASSERT_EQ(r["effects"].size(), 1u) << r["effects"].dump(1);
  EXPECT_EQ(r["effects"][0]["name"], "eddy_brake");
  EXPECT_EQ(r["verdict"], "explained") << r["reasons"];
  EXPECT_THAT(run.value().summary, HasSubstr("eddy_brake"));
  const auto& found = r["effects"][0]["parameters"];
  EXPECT_NEAR(found["c_Ns_per_mA2"]["value"].get<double>(), 25, 0.5);
  EXPECT_NEAR(found["tau_s"]["value"].get<double>(), 0.2, 0.01);
  EXPECT_LT(r["channels"]["force_N"]["after"]["rmse"].get<double>(), 0.45);
  EXPECT_GT(r["channels"]["force_N"]["before"]["rmse"].get<double>(), 1.2);
  // The corrected model brings the law with it: the same manifest with it, run as it is.
  const auto second =
      LoadManifest(folder.Write("again.yaml", WithModel(dir.value().File("model.yaml"))));
  ASSERT_TRUE(second.ok()) << second.error().Line();
  auto other = ResultDir::Create(folder.File("rig"), true);
  const auto rig = element::RunElementRig(second.value(), other.value());
  ASSERT_TRUE(rig.ok()) << rig.error().Line();
  EXPECT_NEAR(rig.value().result["channels"]["force_N"]["rmse"].get<double>(),
              r["channels"]["force_N"]["after"]["rmse"].get<double>(), 1e-6);
}

TEST(OwnCandidate, IsNotFoundWhereItIsNot) {
  const Folder folder("own_candidate_clean");
  WriteBrakeRecord(folder, false);
  const auto loaded =
      LoadManifest(folder.Write("manifest.yaml", WithModel(folder.File("part.yaml"))));
  ASSERT_TRUE(loaded.ok()) << loaded.error().Line();
  auto dir = ResultDir::Create(folder.File("out"), true);
  const auto run = element::RunElementIdentify(loaded.value(), {}, nullptr, dir.value());
  ASSERT_TRUE(run.ok()) << run.error().Line();
  EXPECT_TRUE(run.value().result["effects"].empty()) << run.value().result["effects"].dump(1);
}

// It was missing from the list, so that nobody saw that it had not been tried.
TEST(OwnCandidate, ALawThatOverflowsIsSaidToFail) {
  const Folder folder("own_candidate_overflow");
  WriteBrakeRecord(folder);
  const std::string text = WithModel(folder.File("part.yaml")) +
                           "  burst: {where: piston, expression: \"F*exp(x^2/1e-6[m^2])\", "
                           "parameters: {F_N: [1, 100]}}\n";
  const auto loaded = LoadManifest(folder.Write("manifest.yaml", text));
  ASSERT_TRUE(loaded.ok()) << loaded.error().Line();
  auto dir = ResultDir::Create(folder.File("out"), true);
  const auto run = element::RunElementIdentify(loaded.value(), {}, nullptr, dir.value());
  ASSERT_TRUE(run.ok()) << run.error().Line();
  const auto& r = run.value().result;
  EXPECT_EQ(r["effects"][0]["name"], "eddy_brake") << r["effects"].dump(1);
  std::vector<std::string> said;
  for (const auto& c : r["candidates"]) {
    if (c["name"] == "burst") said.push_back(c["verdict"]);
  }
  ASSERT_FALSE(said.empty()) << r["candidates"].dump(1);
  EXPECT_EQ(said[0], "the model cannot be run with it");
}

/// A pad that drags along a rig's piston by a bristle, made here beside the declared rig model.
TEST(OwnCandidate, IsFoundOnARigAmongEffectsOfTheCatalogue) {
  const Folder folder("own_candidate_rig");
  const auto declared = phs_model::FindPhsParams("quarter_setup2").value();
  rigs::RigMotion motion;
  motion.step_s = 0.01, motion.position_m.resize(1);
  for (int i = 0; i < 4000; ++i) {
    const double t = 0.01 * i;
    motion.position_m[0].push_back(3e-3 * std::sin(0.8 * t) + 8e-4 * std::sin(3.1 * t));
  }
  auto rig = rigs::RigModel::Create(rigs::RigKind::kQuarter, declared).value();
  rigs::RigPrediction clean;
  ASSERT_TRUE(rig.Run(motion, &clean).ok());
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  std::ofstream csv(folder.File("run.csv"));
  csv << "t_s,actuator_m,piston_m,load_cell_N,p_bore_Pa,p_rod_Pa\n";
  csv.precision(12);
  double z = 0;  // dz/dx = 1 - z/z0 along the motion: exact over a way
  const double z0 = 6e-4, k = 1.5e6;
  for (size_t i = 0; i < 4000; ++i) {
    if (i > 0) {
      const double way = motion.position_m[0][i] - motion.position_m[0][i - 1];
      const double end = way > 0 ? z0 : -z0;
      z = end + (z - end) * std::exp(-std::abs(way) / z0);
    }
    csv << 0.01 * static_cast<double>(i) << ',' << motion.position_m[0][i] + 3e-7 * normal(random);
    const double noise[] = {1.5e-6, 30, 8e3, 8e3};
    for (size_t c = 0; c < 4; ++c) {
      csv << ',' << clean.channels[c][i] + (c == 1 ? k * z : 0) + noise[c] * normal(random);
    }
    csv << '\n';
  }
  csv.close();
  const auto loaded = LoadManifest(folder.Write("manifest.yaml", R"(rig: quarter
model: quarter_setup2
data: run.csv
estimation: [0, 27]
validation: [27, 40]
candidates:
  stribeck: {}
  sensor_offset: {}
  dragged_pad:
    where: piston
    expression: "k*z"
    parameters: {k_N_per_m: [1.0e4, 1.0e8], z0_m: [1.0e-5, 1.0e-2]}
    states: {z_m: "v - abs(v)*z/z0"}
)"));
  ASSERT_TRUE(loaded.ok()) << loaded.error().Line();
  auto dir = ResultDir::Create(folder.File("out"), true);
  const auto run = search::IdentifyDriven(loaded.value(), {}, nullptr, dir.value());
  ASSERT_TRUE(run.ok()) << run.error().Line();
  const auto& effects = run.value().result["effects"];
  ASSERT_EQ(effects.size(), 1u) << effects.dump(1);
  EXPECT_EQ(effects[0]["name"], "dragged_pad");
  EXPECT_NEAR(effects[0]["parameters"]["k_N_per_m"]["value"].get<double>(), k, 0.08 * k);
  EXPECT_NEAR(effects[0]["parameters"]["z0_m"]["value"].get<double>(), z0, 0.08 * z0);
}

TEST(OwnCandidate, StartsAreAGridOverItsRanges) {
  OwnCandidate own;
  own.effect = {"mine", {}, {{"a_N", 0}, {"l_m", 1e-3}}, "piston = a*x/l"};
  own.numbers = {{"a_N", -10, 10}, {"l_m", 1e-4, 1e-1}};
  const search::Candidate c = search::MakeOwnCandidate(own);
  EXPECT_EQ(c.starts.size(), 8u) << "two signs, four lengths";
  EXPECT_FALSE(c.free[0].logarithmic);
  EXPECT_TRUE(c.free[1].logarithmic);
  for (const auto& start : c.starts) {
    EXPECT_NEAR(std::abs(start[0]), 1, 1e-12);
    EXPECT_GT(start[1], 1e-4);
    EXPECT_LT(start[1], 1e-1);
  }
}

TEST(OwnCandidate, BadYamlIsOneLineThatNamesItsPlace) {
  const Folder folder("own_candidate_bad");
  WriteBrakeRecord(folder);
  const std::string good = WithModel(folder.File("part.yaml"));
  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    const auto loaded = LoadManifest(folder.Write("bad.yaml", text));
    if (!loaded.ok()) return loaded.error().Line();
    auto dir = ResultDir::Create(folder.File("out"), true);
    const auto run = element::RunElementIdentify(loaded.value(), {}, nullptr, dir.value());
    const std::string line = run.ok() ? "" : run.error().Line();
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    return line;
  };
  EXPECT_THAT(refused("where: piston", "where: pistn"), HasSubstr("did you mean 'piston'"));
  EXPECT_THAT(refused("c*i^2*v", "c*i*v"),
              testing::AllOf(HasSubstr("bad.yaml:"), HasSubstr("eddy_brake.expression"),
                             HasSubstr("no force [N]")));
  EXPECT_THAT(refused("c*i^2*v", "c*i^2*w"), HasSubstr("unknown name w"));
  EXPECT_THAT(refused("coil/8[V/A]", "coil/8"), HasSubstr("states.i_A"));
  EXPECT_THAT(refused("- i)/tau", "- i)/1[s]"),
              testing::AllOf(HasSubstr("parameters.tau_s"), HasSubstr("does not stand in")));
  for (const char* name : {"\"../evil\":", "\"my.law\":", "\"a: b\":", "\"\":", "1st:"}) {
    EXPECT_THAT(refused("eddy_brake:", name), HasSubstr("is no name")) << name;
  }
  EXPECT_THAT(refused("[0.5, 5.0e3]", "[5.0e3, 0.5]"), HasSubstr("is no range"));
  EXPECT_THAT(refused("tau_s:", "tau_sec:"), HasSubstr("is no unit"));
  EXPECT_THAT(refused("coil_V: u_coil", "coil_V: u_col"),
              testing::AllOf(HasSubstr("extra.coil_V"), HasSubstr("did you mean 'u_coil'")));
  EXPECT_THAT(refused("eddy_brake:", "stribeck:"), HasSubstr("of the catalogue"));
  EXPECT_THAT(refused("candidates:", "candidates:\n  backlas: {}"),
              HasSubstr("did you mean 'backlash'"));
  EXPECT_THAT(refused("states:", "stats:"), HasSubstr("did you mean 'states'"));
}

}  // namespace
}  // namespace phs::identify
