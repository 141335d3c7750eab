// Sweep studies.
#include "one_input.h"
#include "sweep/study_file.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  phs::fuzz::ExpectValueOrLine(
      phs::sweep::LoadStudy(phs::fuzz::InputFile(phs::fuzz::Text(data, size), ".yaml")));
  return 0;
}
