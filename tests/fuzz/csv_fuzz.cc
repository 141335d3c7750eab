// Tables of measured data.
#include "base/table.h"
#include "one_input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  phs::fuzz::ExpectValueOrLine(phs::ParseCsv(phs::fuzz::Text(data, size), "input"));
  return 0;
}
