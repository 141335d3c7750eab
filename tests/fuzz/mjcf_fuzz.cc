// MJCF files as documents, before MuJoCo reads them.
#include "one_input.h"
#include "vehicle/mjcf_document.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  phs::fuzz::ExpectValueOrLine(
      phs::vehicle::ReadMjcf(phs::fuzz::InputFile(phs::fuzz::Text(data, size), ".xml")));
  return 0;
}
