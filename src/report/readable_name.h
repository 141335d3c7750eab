// Names of channels and parameters with a unit suffix, made readable.
#pragma once

#include <string>

namespace phs::report {

/// "load_cell_N" → "load cell force", unit "kN", factor 1e-3 from the name's unit to the shown one.
/// A name without a known suffix keeps its words and has the unit "–".
struct ReadableName {
  std::string words = {};
  std::string unit = {};
  double factor = 1;
};
ReadableName Readable(const std::string& column);

}  // namespace phs::report
