// How much of a result is the step's: the same run with half the step beside it.
//
// `relative` = value / half_step - 1. Numbers that change sign (angle, yaw, lateral, bending,
// shear, piston, cylinder force, moment) are judged by `of_scale` instead: (value - half_step) over
// the largest magnitude that the quantity has in the run on that bogie. T-gamma, Y, Q, sums and
// ratios have no such scale. What moves by more than kMovingShare is named under `moving`, unless it
// is as good as nothing at both steps (run_summary.h). With a scheme of second order the value itself is off by about 4/3 of its change, of first order twice.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "vehicle/run_summary.h"

namespace phs::vehicle {

inline constexpr double kMovingShare = 0.02;
inline constexpr double kEnergyErrorShare = 1e-3;  ///< an energy error beyond this is marked

/// One number at the step and at half of it. Not a number: there is none.
struct StepChange {
  std::string name;  ///< path in summary.json; of a ratio in compare.json without `ratios.`
  double value = 0;
  double half_step = 0;
  double relative = std::nan("");
  double of_scale = std::nan("");
  double scale = std::nan("");
  bool nothing = false;  ///< so small at both steps that no change of it matters

  /// By what it is judged: of_scale if it has one, else relative; NaN if it has neither.
  double Judged() const { return std::isfinite(of_scale) ? of_scale : relative; }
  bool Moves() const { return !nothing && std::abs(Judged()) > kMovingShare; }
};

struct StepChanges {
  double timestep_s = 0;
  double half_step_s = 0;
  std::string half_step_status;
  std::vector<StepChange> changes;  ///< none where one of the runs has no results
};

/// `run` belongs to `summary`; `half` is the summary at half the step.
StepChanges ChangesAtHalfStep(const RunOutcome& run, const RunSummary& summary,
                              const RunSummary& half);

/// The changes of the headline ratios between bogies, from the bogies' own.
StepChanges RatioChanges(const std::vector<std::pair<std::string, StepChanges>>& bogies);

/// `discretisation` of summary.json: {"timestep_s", "half_step_s", "half_step_status", "changes":
/// {NAME: {"value", "half_step", "relative", "of_scale", "scale"}}, "moving": [NAME, …]}. Of
/// ratios, without the half step.
nlohmann::ordered_json DiscretisationJson(const StepChanges& changes);

/// StepChange::Judged of an entry of `changes`.
double JudgedChange(const nlohmann::ordered_json& change);

}  // namespace phs::vehicle
