// A study: one scenario or rig, the keys that are varied, and the list of runs that follows from them.
// Read from a YAML file (docs/sweep.md).
//
// Keys of axes:
//   scenario.KEY       any key of the scenario file, also nested: scenario.friction
//   track.KEY          any key of the scenario's track file; lists by number or `*` for every
//                      element that has the next key: track.segments.*.radius_m
//   model.PARAMETER    any number of the PHS model: model.friction.scale, model.L1.gas_volume_m3,
//                      `*` for every line or cylinder: model.*.gas_volume_m3
//   bogie.ELEMENT.ATTRIBUTE   a value of the bogie's file (vehicle/bogie_values.h):
//                      bogie.coupling_*.stiffness; empty in a list: as in the file
//   rig.KEY            instead of scenario, track and bogie, where the study is over a rig: any key of its
//                      manifest: rig.signal.actuator_m.amplitude_m
//   note.NAME          nothing
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "sweep/optimisation.h"
#include "sweep/sampling.h"
#include "sweep/slurm_options.h"
#include "sweep/study_case.h"

namespace phs::sweep {

enum class DesignKind { kGrid, kList, kLatinHypercube, kSobol, kSobolIndices };

struct Axis {
  std::string key;
  std::string column;               ///< its column in sweep.csv: last part of the key, made unique
  std::vector<std::string> values;  ///< grid only
  Distribution distribution;        ///< samples only
};

struct Study {
  std::string path;  ///< the file read
  std::string text;  ///< its text, kept with the results
  std::string name;  ///< file name without extension
  DesignKind design = DesignKind::kGrid;
  int samples = 0;  ///< points of a sampled design
  std::uint64_t seed = 1;
  bool vary_irregularity = false;  ///< each run its own irregularity, by its seed
  double time_limit_s = 600;       ///< a run that takes longer is ended and named
  SlurmOptions slurm;              ///< block `slurm:`
  std::vector<Axis> axes;
  std::vector<std::string> outputs;            ///< paths in summary.json (sweep/outputs.h)
  std::vector<StudyCase> cases;                ///< what a run calculates; a plain study has one
  std::vector<int> case_of_run;                ///< empty: all runs are the first case
  std::vector<std::vector<std::string>> runs;  ///< [run][axis] values as text
  /// A search: its runs are laid out as it goes on; its axes are choices, parameters, the case.
  std::optional<Optimisation> optimisation;

  int num_runs() const { return static_cast<int>(runs.size()); }
  const StudyCase& CaseOf(int run) const {
    return cases[case_of_run.empty()
                     ? 0
                     : static_cast<std::size_t>(case_of_run[static_cast<std::size_t>(run)])];
  }
};

constexpr int kMostRuns = 1'000'000;

}  // namespace phs::sweep
