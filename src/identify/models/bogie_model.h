// What is declared of a bogie on a track, and what of it a fit may move.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/phs_params.h"
#include "identify/models/measured_ways.h"
#include "measurement/fit_data.h"
#include "vehicle/running_effects.h"
#include "vehicle/scenario.h"

namespace phs::identify::search {

/// What is declared of a bogie on a track.
struct BogieModel {
  vehicle::Scenario scenario;
  hydraulics::PhsParams phs;            ///< the scenario's, with its own changes
  std::vector<std::string> free;        ///< free numbers of the baseline
  std::vector<std::string> candidates;  ///< effects to look for; empty: all
  std::vector<std::string> observed;    ///< every channel that a run records
  std::vector<std::string> unit;        ///< of each
  double start_m = 0;                   ///< place of the leading wheelset when a run starts
  vehicle::DeclaredRunning declared;    ///< of wheel, track and suspension
  double track_length_m = 0;
  /// Step of the runs of a fit; 0: the scenario's, as of every run whose numbers are reported.
  double fit_step_s = 0;
  bool by_measured_ways = false;  ///< forces and pressures, where the record has the ways
  int threads = 1;                ///< for runs by other theories
};

/// Loads scenario and PHS and looks at one instant of the run. Errors: what the files say wrongly,
/// a bogie without PHS, free numbers that it does not have.
Result<BogieModel> LoadBogieModel(const std::string& scenario, const std::vector<std::string>& free,
                                  const std::vector<std::string>& candidates);

/// `free` with each "lines.KEY" taken apart, "L1.KEY", "L2.KEY" …, where the lines differ in it:
/// one number for all would make them alike.
std::vector<std::string> TakenApart(const hydraulics::PhsParams& params,
                                    const std::vector<std::string>& free);

/// Frees what forces and pressures at measured ways tell beside the usual numbers: the oil of the
/// lines, the stiffness of seals that have not broken away.
void FreeByWays(BogieModel* model);

/// The scenario with the numbers and effects of `params` put in: what runs, and what is written.
Result<vehicle::Scenario> ScenarioWith(const BogieModel& model,
                                       const hydraulics::PhsParams& params);

/// Channel of a run that a measured column stands for: itself, or of a rig's names "piston1_m",
/// "load1_N", "pL1_Pa". Empty: none.
std::string RunChannelOf(const BogieModel& model, const std::string& column);

/// Outputs of a record that are of its PHS.
PhsOutputsOf FindPhsOutputs(const BogieModel& model, const measurement::FitData& data);

}  // namespace phs::identify::search
