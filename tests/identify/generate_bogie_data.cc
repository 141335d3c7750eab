// generate_bogie_data SCENARIO OUT.csv [SEED] [STEP_S]: a measured run of the examples in
// models/rigs (docs/identify_bogie.md). SCENARIO holds the hidden truth.
#include <cstdio>
#include <cstdlib>

#include "tests/identify/bogie_measurement.h"
#include "vehicle/scenario_file.h"

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "generate_bogie_data SCENARIO OUT.csv [SEED] [STEP_S]\n");
    return 2;
  }
  const auto truth = phs::vehicle::LoadScenario(argv[1]);
  if (!truth.ok()) {
    std::fprintf(stderr, "%s\n", truth.error().Line().c_str());
    return 3;
  }
  const unsigned long seed = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 1;
  const double step = argc > 4 ? std::strtod(argv[4], nullptr) : 0.02;
  const auto sensors = phs::identify::BogieSensors(true);
  return phs::identify::MeasureBogie(truth.value(), sensors, step, seed, argv[2]) ? 0 : 1;
}
