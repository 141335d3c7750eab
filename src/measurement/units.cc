#include "measurement/units.h"

#include <cmath>

namespace phs::measurement {

std::string Unit::name() const {
  std::string out = std::string(ending).substr(1);
  return out == "m_s" || out == "mm_s" ? out.substr(0, out.size() - 2) + "/s" : out;
}

// Pound, inch and kilogram force as defined (NIST SP 811, appendix B).
const std::vector<Unit>& KnownUnits() {
  static const std::vector<Unit> units = {
      {"_m_s", "_mm_s", 1e-3}, {"_Pa", "_kPa", 1e3},      {"_Pa", "_MPa", 1e6},
      {"_Pa", "_bar", 1e5},    {"_Pa", "_mbar", 1e2},     {"_Pa", "_psi", 6894.757293168},
      {"_N", "_kN", 1e3},      {"_N", "_lbf", 4.4482216}, {"_N", "_kgf", 9.80665},
      {"_s", "_ms", 1e-3},     {"_s", "_min", 60},        {"_m", "_mm", 1e-3},
      {"_m", "_um", 1e-6},     {"_m", "_cm", 1e-2},       {"_m", "_inch", 0.0254},
  };
  return units;
}

bool EndsWith(const std::string& text, const std::string& ending) {
  return text.size() > ending.size() && text.ends_with(ending);
}

double FactorOf(const std::string& channel, const std::string& column) {
  for (const Unit& unit : KnownUnits()) {
    if (EndsWith(channel, unit.si) && EndsWith(column, unit.ending)) return unit.factor;
  }
  return 1;
}

std::optional<Unit> UnitThatReads(const std::string& channel, double swings) {
  constexpr double kMostOff = 2.5;
  std::optional<Unit> nearest;
  double least = std::abs(std::log(swings));  // SI itself
  for (const Unit& unit : KnownUnits()) {
    if (!EndsWith(channel, unit.si)) continue;
    const double off = std::abs(std::log(swings * unit.factor));
    if (off < least) least = off, nearest = unit;
  }
  return least <= std::log(kMostOff) ? nearest : std::nullopt;
}

}  // namespace phs::measurement
