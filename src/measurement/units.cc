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

namespace {

std::string Trimmed(const std::string& text) {
  const size_t begin = text.find_first_not_of(" _"), end = text.find_last_not_of(" _");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

/// With the signs that people write: µm for um.
std::string Plain(std::string unit) {
  for (const char* micro : {"\u00b5", "\u03bc"}) {
    if (const size_t at = unit.find(micro); at != std::string::npos) unit.replace(at, 2, "u");
  }
  return unit == "in" ? "inch" : unit;
}

}  // namespace

std::pair<std::string, std::string> SplitBracket(const std::string& column) {
  for (const auto& [open, close] : {std::pair('[', ']'), {'(', ')'}}) {
    const size_t begin = column.rfind(open);
    if (column.empty() || column.back() != close || begin == std::string::npos) continue;
    return {Trimmed(column.substr(0, begin)),
            Plain(Trimmed(column.substr(begin + 1, column.size() - begin - 2)))};
  }
  return {column, ""};
}

double FactorOf(const std::string& channel, const std::string& column) {
  const std::string bracket = SplitBracket(column).second;
  for (const Unit& unit : KnownUnits()) {
    if (!EndsWith(channel, unit.si)) continue;
    if (EndsWith(column, unit.ending) || bracket == unit.name()) return unit.factor;
  }
  return 1;
}

std::string UnknownUnit(const std::string& channel, const std::string& column) {
  const std::string bracket = SplitBracket(column).second;
  constexpr std::pair<const char*, const char*> kSi[] = {
      {"_m_s", "m/s"}, {"_Pa", "Pa"}, {"_N", "N"}, {"_s", "s"}, {"_m", "m"}, {"_K", "K"}};
  for (const auto& [ending, si] : kSi) {
    if (!EndsWith(channel, ending)) continue;
    return bracket == si || FactorOf(channel, column) != 1 ? "" : bracket;
  }
  return {};  // a further channel of the manifest: in the unit that its laws expect
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
