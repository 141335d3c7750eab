// Records of the runs of a sweep: one that cannot be read is made again.
#include "one_input.h"
#include "sweep/run_case.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  namespace fs = std::filesystem;
  phs::sweep::Study study;
  study.outputs = {"run.T_gamma_total_J", "run.max_sum_Y_N"};
  // The folder of the input, and in it the place of run 0.
  const fs::path folder = fs::path(phs::fuzz::InputFile("", ".folder")).parent_path();
  fs::create_directories(folder / "runs");
  std::ofstream(phs::sweep::RecordPath(folder.string(), 0), std::ios::binary)
      << phs::fuzz::Text(data, size);
  const auto record = phs::sweep::ReadRecord(study, folder.string(), 0);
  if (record && (record->run != 0 || record->outputs.size() != 2)) std::abort();
  return 0;
}
