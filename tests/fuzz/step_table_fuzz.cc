// Tables of steps.
#include "effects/step_table.h"
#include "one_input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  phs::fuzz::ExpectValueOrLine(
      phs::effects::ReadStepTable(phs::fuzz::InputFile(phs::fuzz::Text(data, size), ".csv")));
  return 0;
}
