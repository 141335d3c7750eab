// Tracks: alignment, gauge, irregularities.
#include "one_input.h"
#include "rail/track.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  phs::fuzz::ExpectValueOrLine(
      phs::rail::Track::Load(phs::fuzz::InputFile(phs::fuzz::Text(data, size), ".yaml")));
  return 0;
}
