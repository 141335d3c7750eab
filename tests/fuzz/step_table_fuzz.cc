// Tables of steps.
#include "one_input.h"
#include "rigs/step_table.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  phs::fuzz::ExpectValueOrLine(
      phs::rigs::ReadStepTable(phs::fuzz::InputFile(phs::fuzz::Text(data, size), ".csv")));
  return 0;
}
