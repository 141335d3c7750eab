// Scenarios with running forces, changed joints and failures.
#include "one_input.h"
#include "vehicle/scenario_file.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  phs::fuzz::ExpectValueOrLine(
      phs::vehicle::LoadScenario(phs::fuzz::InputFile(phs::fuzz::Text(data, size), ".yaml")));
  return 0;
}
