// Records of measured irregularity.
#include "one_input.h"
#include "rail/irregularity.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto read =
      phs::rail::ReadIrregularity(phs::fuzz::InputFile(phs::fuzz::Text(data, size), ".csv"));
  phs::fuzz::ExpectValueOrLine(read);
  if (read.ok()) (void)phs::rail::Irregularity(read.value(), 5.0);
  return 0;
}
