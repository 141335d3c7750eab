// Mapping files beside a URDF bogie.
#include "vehicle/bogie_mapping.h"
#include "one_input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  phs::fuzz::ExpectValueOrLine(phs::vehicle::LoadBogieMapping(
      phs::fuzz::InputFile(phs::fuzz::Text(data, size), ".yaml")));
  return 0;
}
