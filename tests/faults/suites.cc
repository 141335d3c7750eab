#include "tests/faults/suites.h"

#include <cmath>
#include <sstream>

#include "base/result_dir.h"
#include "phs_places.h"

namespace phs::faults {
namespace {

constexpr char kStraight[] =
    "track: straight\nbogie: rigid_link\nspeed_km_h: 60\nduration_s: 0.02\n";

std::string Shipped(const std::string& name) {
  return ReadFile(std::string(PHS_SOURCE_DIR) + "/models/rigs/" + name).value();
}

/// A bench record: friction that turns with the motion, and something like noise.
std::string SealRecord() {
  std::ostringstream text;
  text << "t_s,x_m,force_N\n";
  for (int i = 0; i < 400; ++i) {
    const double t = 0.01 * i, phase = std::fmod(0.5 * t, 1);
    const double x = 5e-3 * (phase < 0.5 ? 4 * phase - 1 : 3 - 4 * phase);
    text << t << ',' << x << ',' << (phase < 0.5 ? 100 : -100) + 3 * std::sin(12.9898 * i) << '\n';
  }
  return text.str();
}

Suite Simulate() {
  return {.name = "simulate",
          .files = {{"run.yaml", kStraight}},
          .arguments = {"simulate", "run.yaml", "--quiet", "--csv", "--out", "out"},
          .again = {"simulate", "run.yaml", "--quiet", "--csv", "--out", "out"}};
}

Suite SimulateForce() {
  Suite suite = Simulate();
  suite.name = "simulate_force";
  suite.files.emplace_back("old.yaml", std::string(kStraight) + "friction: 0.2\n");
  suite.old_arguments = {"simulate", "old.yaml", "--quiet", "--out", "out"};
  suite.arguments.emplace_back("--force");
  suite.again.emplace_back("--force");
  return suite;
}

Suite Sweep() {
  const std::string axes = "scenario: run.yaml\naxes:\n  - {key: scenario.speed_km_h, values: ";
  return {.name = "sweep",
          .files = {{"run.yaml", kStraight},
                    {"study.yaml", axes + "[40, 50]}\n"},
                    {"old.yaml", axes + "[70]}\n"}},
          .arguments = {"sweep", "study.yaml", "--quiet", "--workers", "1", "--out", "out"},
          .again = {"sweep", "study.yaml", "--quiet", "--workers", "1", "--out", "out", "--resume"},
          .resumes = true};
}

Suite SweepForce() {
  Suite suite = Sweep();
  suite.name = "sweep_force";
  suite.old_arguments = {"sweep", "old.yaml", "--quiet", "--workers", "1", "--out", "out"};
  suite.arguments.emplace_back("--force");
  suite.again.emplace_back("--force");
  return suite;
}

/// The table of steps up to its row 8, with one number free: two steps of setup 2 say enough for every
/// file of a result, and are identified in a sixth of the time of four.
std::string ShortStepTable() {
  const std::string text = Shipped("lowe_table_b1.csv");
  return text.substr(0, text.find("\n9,") + 1);
}

Suite IdentifySteps() {
  return {.name = "identify_steps",
          .files = {{"steps.yaml", Shipped("steps_setup2.yaml") + "free: [L2.gas_volume_m3]\n"},
                    {"lowe_table_b1.csv", ShortStepTable()}},
          .arguments = {"identify", "steps.yaml", "--quiet", "--out", "out"},
          .again = {"identify", "steps.yaml", "--quiet", "--out", "out"}};
}

Suite Identify() {
  return {.name = "identify",
          .files = {{"seal.csv", SealRecord()},
                    {"seal.yaml",
                     "rig: element\nmodel: seal_bench\ndata: seal.csv\n"
                     "estimation: [0, 2.5]\nvalidation: [2.5, 4]\n"
                     "candidates: [viscous_friction]\n"}},  // a search is not what is tried here
          .arguments = {"identify", "seal.yaml", "--quiet", "--threads", "1", "--out", "out"},
          .again = {"identify", "seal.yaml", "--quiet", "--threads", "1", "--out", "out"}};
}

}  // namespace

std::vector<Suite> AllSuites() {
  return {Simulate(), SimulateForce(), Sweep(), SweepForce(), IdentifySteps(), Identify()};
}

}  // namespace phs::faults
