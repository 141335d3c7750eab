// URDF bogies.
#include "one_input.h"
#include "vehicle/urdf_file.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  phs::fuzz::ExpectValueOrLine(
      phs::vehicle::ReadUrdf(phs::fuzz::InputFile(phs::fuzz::Text(data, size), ".urdf")));
  return 0;
}
