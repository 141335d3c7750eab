// The C++ door: a run by the class that owns mj_step. cpp_door SCENARIO STEM [zero]
#include <cstdio>
#include <string>

#include "vehicle/result_files.h"
#include "vehicle/scenario_file.h"
#include "vehicle/simulation.h"

namespace {

int Fail(const phs::Error& error) {
  std::fprintf(stderr, "cpp_door: %s\n", error.Line().c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const auto scenario = phs::vehicle::LoadScenario(argv[1]);
  if (!scenario.ok()) return Fail(scenario.error());
  auto simulation = phs::vehicle::Simulation::Create(scenario.value());
  if (!simulation.ok()) return Fail(simulation.error());
  long calls = 0;
  phs::vehicle::OwnInputs own;
  if (argc > 3 && std::string(argv[3]) == "zero") {
    own = [&](const phs::vehicle::OwnView&, phs::vehicle::OwnValues* values) {
      ++calls;
      values->wrenches.push_back({.body = 1});
      return true;
    };
  }
  const auto run = simulation.value().Run({}, own);
  if (!run.ok()) return Fail(run.error());
  if (own && calls < run.value().steps) return Fail({"own inputs", "were not asked", "", ""});
  const auto written = phs::vehicle::WriteTimeSeries(run.value(), argv[2], false);
  return written.ok() ? 0 : Fail(written.error());
}
