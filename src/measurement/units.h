// Units that a column may be in, by the ending of its name.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace phs::measurement {

struct Unit {
  const char* si;      ///< ending of the quantity's own name: "_Pa"
  const char* ending;  ///< of a column in this unit: "_bar"
  double factor;       ///< to SI

  std::string name() const;  ///< "bar"
};

const std::vector<Unit>& KnownUnits();

bool EndsWith(const std::string& text, const std::string& ending);

/// Factor to SI of a column whose name ends in another unit than that of `channel`; else 1.
double FactorOf(const std::string& channel, const std::string& column);

/// The unit in which a channel reads `swings` times what it does in SI: the nearest in the
/// logarithm. None where SI itself is nearer, or the nearest is off by more than 2.5 (psi and kPa
/// are 6.9 apart).
std::optional<Unit> UnitThatReads(const std::string& channel, double swings);

}  // namespace phs::measurement
