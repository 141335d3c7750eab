// Tables of creep cases.
#include "one_input.h"
#include "rail/creep_cases.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto table = phs::ParseCsv(phs::fuzz::Text(data, size), "input.csv");
  phs::fuzz::ExpectValueOrLine(table);
  if (table.ok()) phs::fuzz::ExpectValueOrLine(phs::rail::CalcCreepCases(table.value(), "linear"));
  return 0;
}
