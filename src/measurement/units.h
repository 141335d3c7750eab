// Units that a column may be in, by the ending of its name.
#pragma once

#include <optional>
#include <string>
#include <utility>
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

/// Factor to SI of a column whose name ends in another unit than that of `channel`, as "_kN", "[kN]"
/// or "(kN)"; else 1.
double FactorOf(const std::string& channel, const std::string& column);
/// "load_cell [kN]" -> {"load_cell", "kN"}; the second is empty where no bracket ends the name.
std::pair<std::string, std::string> SplitBracket(const std::string& column);
/// The unit in the bracket that ends the column's name, if it is none of this channel's quantity;
/// else empty.
std::string UnknownUnit(const std::string& channel, const std::string& column);

/// The unit in which a channel reads `swings` times what it does in SI: the nearest in the
/// logarithm. None where SI itself is nearer, or the nearest is off by more than 2.5 (psi and kPa
/// are 6.9 apart).
std::optional<Unit> UnitThatReads(const std::string& channel, double swings);

}  // namespace phs::measurement
