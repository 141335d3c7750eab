// Saved results of an identification or a rig run, read back for the report.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.h"
#include "report/identify_input.h"
#include "report/readable_name.h"
#include "report/report_page.h"

namespace phs::report {

/// Colours of all plots of an identification.
inline constexpr int kMeasuredColour = 6, kBeforeColour = 1, kAfterColour = 0;

/// One measured channel with what the models say about it, on the clock of the measurement.
struct ChannelData {
  std::string name;   ///< "load_cell_N"
  std::string label;  ///< "load cell [kN]"
  double factor = 1;  ///< from the file's unit to the label's
  std::vector<double> measured;
  std::vector<double> before;  ///< declared model, fitted; empty = not saved
  std::vector<double> after;   ///< corrected model; empty = not saved
  bool is_force = false;
};

/// A table of steps, row by row, one run after the other.
struct StepsData {
  std::vector<double> measured_MPa, before_MPa, after_MPa;  ///< settled; empty = not saved
};

struct IdentifyResults {
  nlohmann::ordered_json all;
  StepsData steps;
  std::vector<double> time;          ///< [s]; empty if there are no data to plot
  std::vector<double> displacement;  ///< of the (first) actuator [m]; empty if there is none
  std::vector<double> place;         ///< of a vehicle along its track [m]; empty on a rig
  std::vector<double> speed;         ///< its rate [m/s]
  std::vector<ChannelData> channels;
  std::vector<Band> windows;  ///< estimation and validation
  bool has_before = false;    ///< the result compares two models
  /// Rows of the validation window (all rows without one).
  std::vector<std::size_t> ScoredRows() const;
};

Result<IdentifyResults> ReadIdentifyResults(const IdentifyReportInput& input);

/// Number at a JSON pointer; NaN if absent.
double NumberAt(const nlohmann::ordered_json& object, const std::string& pointer);

/// Residual measured − predicted; empty if nothing was predicted.
std::vector<double> ResidualOf(const ChannelData& channel, bool after);

}  // namespace phs::report
