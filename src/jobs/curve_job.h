// One or several bogies on one track: what `phs simulate` and `phs compare` do, and phs.run and
// phs.compare in Python. A job is a verb without its words: what was asked in, numbers and a result
// directory out.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/pair_conicity.h"
#include "analysis/running_assessment.h"
#include "base/result_dir.h"
#include "jobs/watch.h"
#include "vehicle/discretisation.h"
#include "vehicle/simulation.h"

namespace phs::jobs {

struct CurveRequest {
  vehicle::Scenario scenario;
  std::vector<std::string> bogies;  ///< BOGIE or BOGIE@PHS_MODEL; empty: the scenario's own
  bool verify = false;              ///< the half step beside every run
  /// Controls and forces of the caller's own for one of the runs; none without it.
  std::function<vehicle::OwnInputs(const vehicle::Simulation&)> own = {};
};

struct CurveRun {
  std::string bogie;
  std::optional<vehicle::Simulation> simulation;
  vehicle::RunOutcome outcome = {};
  vehicle::RunSummary summary = {};
  analysis::Assessment assessment = {};
  std::optional<vehicle::StepChanges> discretisation = {};
  analysis::PairConicity conicity = {};

  /// summary.json without scenario and track.
  nlohmann::ordered_json ToJson() const;
};

using NamedSummaries = std::vector<std::pair<std::string, nlohmann::ordered_json>>;

/// Prepared runs, then finished ones.
struct Curve {
  vehicle::Scenario scenario;  ///< with the step of the first run
  bool verify = false;
  std::function<vehicle::OwnInputs(const vehicle::Simulation&)> own = {};
  std::vector<CurveRun> runs;

  NamedSummaries Summaries() const;
  /// compare.json, with the changes of the ratios if the half step was run.
  nlohmann::ordered_json Compared() const;
  /// summary.json of the first run: its summary with scenario and track.
  nlohmann::ordered_json Single() const;
};

/// Creates all simulations, so that bad input ends before any long work.
Result<Curve> PrepareCurve(const CurveRequest& request);

/// Runs two at a time; results do not depend on it. False: it was stopped.
Result<bool> RunCurve(Curve* curve, const Watch& watch);

enum class CurveFiles {
  kSingle,   ///< summary.json, timeseries.h5
  kCompare,  ///< compare.json, BOGIE_timeseries.h5
};
/// The files of a finished job with their report; not committed.
Status WriteCurve(const Curve& curve, CurveFiles files, bool csv, ResultDir* dir);

/// "all" stands for every bogie that names a yardstick.
std::vector<std::string> ExpandBogies(const std::vector<std::string>& asked);

}  // namespace phs::jobs
