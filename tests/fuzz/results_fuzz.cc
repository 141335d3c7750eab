// Saved results, read back for their page.
#include "one_input.h"
#include "report/curving_report.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const phs::Status status = phs::report::WriteCurvingReport(
      {.results = phs::fuzz::InputFile(phs::fuzz::Text(data, size), ".json"),
       .runs = {{"phs", ""}}},
      "/dev/null");
  if (!status.ok()) phs::fuzz::ExpectOneLine(status.error());
  return 0;
}
