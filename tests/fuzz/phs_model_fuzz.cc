// PHS models with their effects.
#include "effects/catalogue.h"
#include "one_input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  phs::fuzz::ExpectValueOrLine(
      phs::effects::LoadPhsSystem(phs::fuzz::InputFile(phs::fuzz::Text(data, size), ".yaml")));
  return 0;
}
