// How runs become tasks: chunks of runs, one line of a batch file each, one array per batch file.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "base/result.h"
#include "sweep/slurm_client.h"
#include "sweep/slurm_options.h"
#include "sweep/study.h"

namespace phs::sweep {

using Runs = std::vector<int>;

/// Runs per task: what was asked for, else four tasks per processor of the partition, 1 … 100 runs.
int ChunkSize(const SlurmOptions& options, std::size_t runs);
std::deque<Runs> Chunks(const Runs& runs, int size);

/// The runs of every task of a batch file: one line each, numbers separated by blanks.
std::string BatchText(const std::vector<Runs>& tasks);
Result<std::vector<Runs>> ReadBatch(const std::string& path);

/// The array that makes the `tasks` lines of `batch`; its script and logs lie in `folder`.
ArrayRequest RequestFor(const Study& study, const SlurmOptions& options, const std::string& folder,
                        const std::string& batch, int tasks);

}  // namespace phs::sweep
