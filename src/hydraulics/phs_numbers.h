// Every number of a PHS, one row each: what it is called in parameters and in files, its unit, what
// it may be and what is plausible. Reading, writing, checking, naming, changing and the reference
// page docs/phs_models.md follow from the rows. Numbers of effects stand in the catalogue
// (extension.h, EffectParameter).
#pragma once

#include <string>
#include <vector>

#include "base/range.h"
#include "hydraulics/phs_params.h"

namespace phs::hydraulics {

/// What is said of a number, whatever part of the PHS it belongs to.
struct NumberInfo {
  std::string key;   ///< below its part's name: "gas_volume_m3", "end_stop.clearance_m"
  std::string unit;  ///< "-" for a plain number
  Range allowed;
  double low, high;  ///< plausible: where it is varied and fitted
  std::string text;
  std::string where = key;  ///< in a file, below its part; a point stands before the last level
};

/// A number of `Part`: PhsParams, CylinderParams or LineParams.
template <typename Part>
struct NumberRow {
  NumberInfo info;
  double& (*of)(Part& part);
  bool (*written)(const Part& part) = nullptr;  ///< into a file; null: always
};

/// In the order of files and pages.
template <typename Part>
const std::vector<NumberRow<Part>>& Numbers();
template <>
const std::vector<NumberRow<PhsParams>>& Numbers();  ///< temperature, friction, element
template <>
const std::vector<NumberRow<CylinderParams>>& Numbers();
template <>
const std::vector<NumberRow<LineParams>>& Numbers();

/// Calls `visit(name, info, value)` for every number; name = "L1.gas_volume_m3".
template <typename Visit>
void ForEachNumber(PhsParams* params, Visit visit) {
  for (const auto& row : Numbers<PhsParams>()) visit(row.info.key, row.info, row.of(*params));
  for (CylinderParams& c : params->cylinders) {
    for (const auto& row : Numbers<CylinderParams>()) {
      visit(c.name + "." + row.info.key, row.info, row.of(c));
    }
  }
  for (LineParams& l : params->lines) {
    for (const auto& row : Numbers<LineParams>()) {
      visit(l.name + "." + row.info.key, row.info, row.of(l));
    }
  }
}

}  // namespace phs::hydraulics
