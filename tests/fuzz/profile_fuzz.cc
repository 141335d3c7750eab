// Wheel and rail profiles: .prw, .prr and plain y, z tables.
#include "one_input.h"
#include "rail/profile.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text = phs::fuzz::Text(data, size);
  phs::fuzz::ExpectValueOrLine(
      phs::rail::ParseProfile(text, "input.prw", phs::rail::ProfileKind::kWheel));
  phs::fuzz::ExpectValueOrLine(
      phs::rail::ParseProfile(text, "input.txt", phs::rail::ProfileKind::kRail));
  return 0;
}
