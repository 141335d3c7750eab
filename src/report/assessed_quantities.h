// Quantities of a run's assessment (analysis/en14363.h) as a reader knows them: their rows in the
// table of the program and on the page.
#pragma once

#include <span>

namespace phs::report {

struct AssessedName {
  const char* key;      ///< in summary.json, `assessment.worst.KEY`
  const char* label;    ///< in the table of the program, at most 29 characters
  const char* heading;  ///< on the page; a unit other than 1 in brackets behind it
  const char* unit;     ///< shown
  double scale;         ///< from the file's unit to the shown one
  int decimals;         ///< in the table of the program
};

/// In the order of the rows.
std::span<const AssessedName> AssessedNames();

}  // namespace phs::report
