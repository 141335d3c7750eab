#include "sweep/slurm_batches.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "base/result_dir.h"

namespace phs::sweep {
namespace {

constexpr int kMostChunk = 100;

}  // namespace

int ChunkSize(const SlurmOptions& options, std::size_t runs) {
  if (options.chunk > 0) return options.chunk;
  const auto share = 4 * static_cast<std::size_t>(SlurmProcessors(options.partition));
  return std::clamp(static_cast<int>((runs + share - 1) / share), 1, kMostChunk);
}

std::deque<Runs> Chunks(const Runs& runs, int size) {
  std::deque<Runs> chunks;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i % static_cast<std::size_t>(size) == 0) chunks.emplace_back();
    chunks.back().push_back(runs[i]);
  }
  return chunks;
}

std::string BatchText(const std::vector<Runs>& tasks) {
  std::string text;
  for (const Runs& runs : tasks) text += fmt::format("{}\n", fmt::join(runs, " "));
  return text;
}

Result<std::vector<Runs>> ReadBatch(const std::string& path) {
  const auto text = ReadFile(path);
  if (!text.ok()) return text.error();
  std::vector<Runs> tasks;
  std::istringstream lines(text.value());
  for (std::string line; std::getline(lines, line);) {
    tasks.emplace_back();
    std::istringstream numbers(line);
    for (int run = 0; numbers >> run;) tasks.back().push_back(run);
  }
  return tasks;
}

ArrayRequest RequestFor(const Study& study, const SlurmOptions& options, const std::string& folder,
                        const std::string& batch, int tasks) {
  return {.script = folder + "/task.sh",
          .argument = folder + "/" + batch,
          .name = "phs_" + study.name,
          .log_folder = folder,
          .tasks = tasks,
          .partition = options.partition,
          .time_min = options.time_min,
          .options = options.options};
}

}  // namespace phs::sweep
