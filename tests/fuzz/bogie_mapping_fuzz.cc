// Mapping files beside a URDF bogie.
#include "one_input.h"
#include "vehicle/bogie_mapping.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  phs::fuzz::ExpectValueOrLine(
      phs::vehicle::LoadBogieMapping(phs::fuzz::InputFile(phs::fuzz::Text(data, size), ".yaml")));
  return 0;
}
