// Formulas of unlisted effects.
#include "effects/formula.h"
#include "one_input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text = phs::fuzz::Text(data, size);
  phs::fuzz::ExpectValueOrLine(phs::effects::Formula::Parse(text, {{"c1", 100.0}, {"c2", -3.0}}));
  return 0;
}
