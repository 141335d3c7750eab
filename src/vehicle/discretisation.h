// How much of a result is the step's: the same run with half the step beside it.
//
// `relative` = value / half_step - 1. Numbers that change sign (angle, yaw, lateral, bending,
// shear, piston, cylinder force, moment) are judged by `of_scale` instead: (value - half_step) over
// the largest magnitude that the quantity has in the run on that bogie. T-gamma, Y, Q, sums and
// ratios have no such scale. What moves by more than kMovingShare is named under `moving`. With a
// scheme of second order the value itself is off by about 4/3 of its change, of first order twice.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "vehicle/simulation.h"

namespace phs::vehicle {

inline constexpr double kMovingShare = 0.02;
inline constexpr double kEnergyErrorShare = 1e-3;  ///< an energy error beyond this is marked

/// `discretisation` of summary.json: {"timestep_s", "half_step_s", "half_step_status", "changes":
/// {NAME: {"value", "half_step", "relative", "of_scale", "scale"}}, "moving": [NAME, …]}. A NAME is
/// the number's path in summary.json. `run` belongs to `summary`; `half` is the summary at half
/// step.
nlohmann::ordered_json Discretisation(const RunOutcome& run, const nlohmann::ordered_json& summary,
                                      const nlohmann::ordered_json& half);

/// The same of the headline ratios of compare.json, from the bogies' own; a NAME is the path of the
/// ratio without `ratios.`.
nlohmann::ordered_json RatioChanges(
    const std::vector<std::pair<std::string, nlohmann::ordered_json>>& summaries);

/// By what a change is judged: of_scale if it has one, else relative; NaN if it has neither.
double JudgedChange(const nlohmann::ordered_json& change);

}  // namespace phs::vehicle
