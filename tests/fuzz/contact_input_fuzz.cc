// CONTACT input files and tables of wheelset positions.
#include "one_input.h"
#include "rail/wheelset_cases.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text = phs::fuzz::Text(data, size);
  phs::fuzz::ExpectValueOrLine(phs::rail::ReadContactInput(phs::fuzz::InputFile(text, ".inp")));
  return 0;
}
