// What phs simulate and phs compare are asked for, and the run over several curves.
#pragma once

#include <string>
#include <vector>

#include "cli/result_checks.h"
#include "cli/verbs.h"
#include "vehicle/scenario.h"

namespace phs::cli {

/// Options of phs simulate and phs compare.
struct CurveOptions {
  CommonOptions common;
  std::string scenario;
  std::vector<std::string> bogies;  ///< BOGIE or BOGIE@PHS_MODEL
  std::string phs;                  ///< PHS model of every bogie that names none itself
  bool csv = false;
  std::string track;  ///< instead of the scenario's
  double timestep_s = 0;
  rail::FrictionSettings friction;  ///< instead of the scenario's
  bool verify = false;              ///< the half step beside every run
  std::vector<int> radii_m;         ///< several curves instead of the scenario's own
  bool stability = false;           ///< with radii: critical speeds on straight track too
  ResultChecks checks;              ///< limits to hold the result against
};

/// The scenario with the step and the PHS model asked for.
Result<vehicle::Scenario> LoadCurve(const CurveOptions& options);

/// Several bogies in several curves: a table and bogies.json. Returns the exit code.
int RunOverRadii(const CurveOptions& options);

}  // namespace phs::cli
