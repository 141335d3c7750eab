// MATLAB files.
#include "base/table.h"
#include "one_input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  phs::fuzz::ExpectValueOrLine(
      phs::ReadMat(phs::fuzz::InputFile(phs::fuzz::Text(data, size), ".mat")));
  return 0;
}
